"""Is this installation sound? Each part is tried for real, and what was found is said."""

from __future__ import annotations

import json
import platform
import sys
import tempfile
import warnings
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import click

from chatscene.commands.options import JSON, MAP
from chatscene.commands.output import say
from chatscene.errors import ChatSceneError, SandboxError
from chatscene.settings import SearchSettings, Settings


@dataclass(frozen=True, slots=True, kw_only=True)
class Check:
    """One thing that was tried.

    Attributes:
        found: What was found, or what is wrong and what to do.
    """

    what: str
    ok: bool
    found: str


@click.command()
@click.option("--simulator", default="", help="Check this simulator against the default one, such as carla:HOST:PORT.")
@MAP
@JSON
def doctor(simulator: str, map: str, as_json: bool) -> None:  # noqa: A002 - the name of the option
    """Check this installation: versions, encoder, library, map, one simulated scene. Or check a simulator.

    A simulator must report its version, drive one scene twice, and drive ten scenes, compared with the default one.

    \b
    chatscene doctor
    chatscene doctor --simulator carla --map Town04.xodr
    """
    if simulator:
        from chatscene.commands.simulator_check import examine_simulator

        trying = examine_simulator(simulator, map)
    else:
        trying = iter(examine())
    checks: list[Check] = []
    for check in trying:
        checks.append(check)
        if not as_json:
            say(f"{'ok  ' if check.ok else 'FAIL'}  {check.what:<28} {check.found}")
    if as_json:
        say(json.dumps([{"what": c.what, "ok": c.ok, "found": c.found} for c in checks], indent=1))
    if not all(check.ok for check in checks):
        sys.exit(1)


def examine() -> tuple[Check, ...]:
    """Try every part, from Python's version to one simulated scene."""
    return tuple(
        attempt(what, part)
        for what, part in (
            ("python", _python),
            ("packages", _packages),
            ("map", _map),
            ("snippet library", _library),
            ("sentence encoder", _encoder),
            ("one scene, end to end", _scene),
            ("native engine", _engine),
            ("walls around strangers' code", _walls),
        )
    )


def attempt(what: str, part: Callable[[], str]) -> Check:
    """Try one thing, which says what it found, or raises an error that says what is wrong."""
    try:
        return Check(what=what, ok=True, found=part())
    except (ChatSceneError, ImportError, OSError) as error:
        return Check(what=what, ok=False, found=f"{type(error).__name__}: {error}")


def _python() -> str:
    if not (3, 11) <= sys.version_info[:2] < (3, 14):
        raise ChatSceneError(f"Python {platform.python_version()} is not supported; use 3.11, 3.12 or 3.13")
    return f"{platform.python_version()} on {platform.system()} {platform.machine()}"


def _packages() -> str:
    from importlib.metadata import version

    names = ("chatscene", "scenic", "numpy", "pyarrow", "onnxruntime")
    return ", ".join(f"{name} {version(name)}" for name in names)


def _map() -> str:
    from chatscene.maps.network import load_network, resolve_map

    network = load_network(resolve_map("town"))
    return f"town: {len(network.roads)} roads, {len(network.intersections)} junctions"


def _library() -> str:
    from chatscene.library.load import load_library

    return f"{len(load_library())} snippets"


def _encoder() -> str:
    from chatscene.models.encoders.embedding import load_embedder

    embedder = load_embedder()
    rows, columns = embedder.encode(["the car ahead brakes"]).shape
    return f"{embedder.name}: {rows} text, {columns} numbers"


def _engine() -> str:
    from chatscene.simulate.native.engine import NoEngine, load_engine

    try:
        load_engine()
    except NoEngine as error:  # all else works without
        return f"none, so the embedded simulator runs what asks for it: {error}"
    return "there, and its arithmetic is Python's"


def _walls() -> str:
    from chatscene.maps.network import resolve_map
    from chatscene.settings import SimulationSettings
    from chatscene.simulate.confined.confinement import LAYERS
    from chatscene.simulate.confined.nursery import Nursery

    with warnings.catch_warnings(), Nursery(resolve_map("town"), SimulationSettings()) as nursery:
        warnings.simplefilter("ignore", RuntimeWarning)  # what is missing is said below
        try:
            there = nursery.layers()
        except SandboxError as error:  # all else works without
            return f"strangers' programs are not run here: {error}"
    missing = [layer for layer in LAYERS if layer not in there]
    return f"allow-list, {', '.join(there)}; missing: {', '.join(missing) or 'none'}"


def _scene() -> str:
    from chatscene import pipeline, runs

    few = Settings(search=SearchSettings(scenes=1, keep=1))
    asked = runs.asked_run("A pedestrian suddenly crosses the road from the right.", settings=few)
    with tempfile.TemporaryDirectory() as folder:
        report = pipeline.run(asked, Path(folder) / "run")
    return report.in_words()
