"""What becomes of other people's OpenSCENARIO XML: how many files import, how many run, and why the others are refused.

    python benchmarks/imports.py DIR... [--maps DIR] [--run 1] [--only WORD] [--each]

Each DIR is a collection, laid out as its makers publish it: `vectorgrp/OSC-NCAP-scenarios`, `esmini/esmini`,
`asam-oss/OSC-ALKS-scenarios`, `carla-simulator/scenario_runner`. None of it is part of the project. A file that is no
scenario (a catalog) is left out. A file of parameter values counts as one file, and each of its variants as a scenario.
A map that a file names and that is not where it says is looked for by its name, in DIR and in the folders of --maps.

With --run N, the programs of every file that imports are driven, the first N variants of each, with `idm` in the place
of the ego, in the sandbox, to an end; parameters stand in the middle of their ranges.

A refused file counts once for each different reason; names and numbers in it are left out to tell which are alike.
"""

from __future__ import annotations

import re
import signal
import sys
import tempfile
import time
from collections import Counter, defaultdict
from dataclasses import dataclass, field, replace
from pathlib import Path

import click

from chatscene.ego.policy import load_ego, observation_of, pedals_of
from chatscene.errors import ChatSceneError
from chatscene.imports.import_file import ImportedScenario, import_scenario
from chatscene.program.sample import scene_at
from chatscene.search.generators.foreign import read_foreign
from chatscene.settings import SimulationSettings
from chatscene.simulate.confined.simulator import ConfinedSimulator
from chatscene.terms.scene import Rejected

LONGEST = 120  # [s] for one import
_KIND = re.compile(rb"<(Storyboard|ParameterValueDistribution|Catalog)[\s>/]")
_MAP = re.compile(rb"<LogicFile\s+filepath\s*=\s*\"([^\"]*)\"")


@dataclass(slots=True)
class Collection:
    """What was counted of a folder: files, imported, run, of scenarios and of parameter values; and reasons."""

    count: Counter[str] = field(default_factory=Counter[str])
    reasons: defaultdict[str, list[str]] = field(default_factory=lambda: defaultdict[str, list[str]](list))


def alike(reason: str) -> str:
    """A reason without what is of one file: numbers, names, lines."""
    reason = re.sub(r"^.*?line \d+: ", "", reason.strip())
    reason = re.sub(r"'[^']*'|\"[^\"]*\"|\$\w+", "…", reason)
    return re.sub(r"/\S+", "…", re.sub(r"[-+]?\d+(\.\d+)?", "N", reason))[:110]


def reasons_of(error: BaseException) -> list[str]:
    """The different reasons of a refusal."""
    text = str(error)
    lines = text.splitlines()[1:] if "cannot be said here:" in text else [text.partition(": ")[2] or text]
    return sorted(
        {f"{'' if isinstance(error, ChatSceneError) else type(error).__name__ + ': '}{alike(one)}" for one in lines}
    )


class Maps:
    """Finds maps by their names."""

    def __init__(self, folders: list[Path]) -> None:
        self._found = {p.name.lower(): p for folder in reversed(folders) for p in sorted(folder.rglob("*.xodr"))}

    def of(self, path: Path) -> str | None:
        """The map of a file by its name, where it is not where the file says; None where it is, or is nowhere."""
        named = _MAP.search(path.read_bytes())
        text = named[1].decode(errors="replace").replace("\\", "/") if named else ""
        if not text or (path.parent / text).is_file():
            return None
        name = Path(text).name.lower()
        found = self._found.get(name) or self._found.get(f"{name}.xodr")
        return str(found) if found else None


def imported(path: Path, out: Path, map_name: str | None) -> ImportedScenario:
    """What an import wrote, in bounded time."""

    def late(*_: object) -> None:
        raise TimeoutError(f"the import took more than {LONGEST} s")

    signal.signal(signal.SIGALRM, late)
    signal.alarm(LONGEST)
    try:
        return import_scenario(path, out=out, map_name=map_name)
    finally:
        signal.alarm(0)


def ends(program: Path, map_path: Path, simulators: dict[Path, ConfinedSimulator]) -> str:
    """How a drive of a program ended.

    Raises:
        ChatSceneError: It does not run.
    """
    ego = load_ego("idm")
    if map_path not in simulators:
        for one in simulators.values():
            one.close()
        simulators.clear()
        simulators[map_path] = ConfinedSimulator(map_path, SimulationSettings())
    own = read_foreign(program)
    scene = replace(scene_at(own.program, 0, 0.5, name="seed-0"), seed=0)
    drive = simulators[map_path].open(own.program, scene, observation=observation_of(ego), pedals=pedals_of(ego))
    if isinstance(drive, Rejected):
        raise ChatSceneError(f"rejected: {drive.reason}")
    try:
        while drive.ending is None and not drive.rejection:
            drive.step(ego.act(drive.observation))
        if drive.rejection:
            raise ChatSceneError(f"rejected: {drive.rejection}")
        episode = drive.episode(scene.id, "ego")
    finally:
        drive.close()
    return f"{episode.ending} after {drive.step_number * episode.dt:.1f} s"


@click.command()
@click.argument("folders", metavar="DIR...", nargs=-1, required=True, type=click.Path(path_type=Path, exists=True))
@click.option("--maps", "elsewhere", multiple=True, type=click.Path(path_type=Path, exists=True), help="Maps by name.")
@click.option("--run", "driven", default=0, show_default=True, help="Variants of each file that are driven.")
@click.option("--only", default="", help="Only files whose path holds this.")
@click.option("--each", is_flag=True, help="A line for each file.")
@click.option("--most", default=25, show_default=True, help="Reasons listed.")
def main(folders: tuple[Path, ...], elsewhere: tuple[Path, ...], driven: int, only: str, each: bool, most: int) -> None:
    """Print the tables."""
    found: dict[str, Collection] = {}
    simulators: dict[Path, ConfinedSimulator] = {}
    began = time.process_time()
    with tempfile.TemporaryDirectory() as kept:
        for folder in folders:
            one = found[folder.name] = Collection()
            maps = Maps([folder, *elsewhere])
            files = sorted(p for p in folder.rglob("*.xosc") if only in str(p) and p.is_file())
            for number, path in enumerate(files):
                _count(one, path, Path(kept) / f"{len(found)}-{number}.scenic", maps.of(path), driven, simulators, each)
    print("\n| collection | scenarios | imported | run | parameter files | imported | variants | run |")
    print("|---|---:|---:|---:|---:|---:|---:|---:|")
    cells = [f"{kind} {what}" for kind in ("scenario", "values") for what in ("files", "imported", "run")]
    cells.insert(5, "variants")
    for name, one in found.items():
        print(f"| {name} | {' | '.join(str(one.count[cell]) for cell in cells)} |")
    for name, one in found.items():
        print(f"\n{name}:")
        for reason, paths in sorted(one.reasons.items(), key=lambda pair: -len(pair[1]))[:most]:
            print(f"  {len(paths):4} {reason}   ({', '.join(Path(p).stem for p in paths[:3])})")
    for simulator in simulators.values():
        simulator.close()
    print(f"\n{time.process_time() - began:.0f} s of processor time", file=sys.stderr)


def _count(
    one: Collection,
    path: Path,
    out: Path,
    map_name: str | None,
    driven: int,
    simulators: dict[Path, ConfinedSimulator],
    each: bool,
) -> None:
    kind = _KIND.search(path.read_bytes())
    if kind is not None and kind[1] == b"Catalog":
        return
    values = "values" if kind is not None and kind[1] == b"ParameterValueDistribution" else "scenario"
    one.count[f"{values} files"] += 1
    try:
        done = imported(path, out, map_name)
        one.count[f"{values} imported"] += 1
        one.count["variants"] += len(done.programs) if values == "values" else 0
        told = "imported"
        for program, map_path in list(zip(done.programs, done.maps, strict=True))[:driven]:
            told = ends(program, map_path, simulators)
        if driven:
            one.count[f"{values} run"] += 1
    except Exception as error:  # noqa: BLE001 - whatever comes is counted
        told = "; ".join(reasons_of(error))
        for reason in reasons_of(error):
            one.reasons[reason].append(str(path))
    if each:
        print(f"{path.name}: {told}", flush=True)


if __name__ == "__main__":
    main()
