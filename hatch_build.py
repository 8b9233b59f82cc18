"""Puts the compiled engine into a wheel, where there is a C compiler; without one the wheel is as good, but slower."""

from __future__ import annotations

import runpy
import sysconfig
from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface

FOLDER = Path("src", "chatscene", "simulate", "native")


class EngineHook(BuildHookInterface):
    """Compiles `engine.c` beside itself; a checkout that is installed in place compiles it at its first use."""

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Called by hatchling before it collects files."""
        if self.target_name != "wheel" or version != "standard":
            return
        building = runpy.run_path(str(Path(self.root) / FOLDER / "building.py"))
        engine = FOLDER / "libengine.so"
        try:
            building["compile_engine"](Path(self.root) / engine)
        except building["NoEngine"] as error:
            self.app.display_warning(f"the wheel has no native engine: {error}")
            return
        build_data["artifacts"].append(engine.as_posix())
        build_data["pure_python"] = False
        build_data["tag"] = f"py3-none-{sysconfig.get_platform().replace('-', '_').replace('.', '_')}"
