"""Puts the compiled engine into a wheel, where there is a C compiler; without one the wheel is as good, but slower."""

from __future__ import annotations

import runpy
import sysconfig
from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface

FOLDER = Path("src", "chatscene", "simulate", "native")


class EngineHook(BuildHookInterface):
    """Compiles `engine.c` for the wheel; a checkout that is installed in place compiles it at its first use."""

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Called by hatchling before it collects files."""
        if self.target_name != "wheel" or version != "standard":
            return
        building = runpy.run_path(str(Path(self.root) / FOLDER / "building.py"))
        # Not beside its source: a checkout would take it for a packaged engine, also of later source.
        engine = Path(self.directory) / "libengine.so"
        engine.parent.mkdir(parents=True, exist_ok=True)
        try:
            building["compile_engine"](engine)
        except building["NoEngine"] as error:
            self.app.display_warning(f"the wheel has no native engine: {error}")
            return
        build_data["force_include"][str(engine)] = "chatscene/simulate/native/libengine.so"
        build_data["pure_python"] = False
        build_data["tag"] = f"py3-none-{sysconfig.get_platform().replace('-', '_').replace('.', '_')}"

    def finalize(self, version: str, *_: object) -> None:
        """Called by hatchling when the wheel holds the engine."""
        if self.target_name == "wheel" and version == "standard":
            Path(self.directory, "libengine.so").unlink(missing_ok=True)
