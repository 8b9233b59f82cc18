"""Which programs of others run here unchanged: each is compiled, drawn and driven once, or it is said why not.

    python benchmarks/foreign_programs.py FOLDER [--map town] [--map Town04.xodr] [--ego idm] [--as-written] [--seed 0]

Every `.scenic` file below FOLDER is read as `chatscene run --program` reads it and runs in the sandbox. It runs on the
map that it names where that is there, else on the first of the maps given on which it can be drawn; the table says
which. A program that compiles and can be drawn is driven to its end by the ego, or by its own with `--as-written`;
parameters that are searched stand in the middle of their ranges.

The lines are a table in Markdown: program, map, parameters that are searched, draws until the requirements held,
seconds driven and how it ended, or what stopped it.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import click

from chatscene.ego.policy import EgoPolicy, load_ego, observation_of, pedals_of
from chatscene.errors import ChatSceneError
from chatscene.maps.network import resolve_map
from chatscene.program.sample import scene_at
from chatscene.search.generators.foreign import ForeignProgram, foreign_files, read_foreign
from chatscene.settings import SimulationSettings
from chatscene.simulate.confined.simulator import ConfinedSimulator
from chatscene.terms.scene import Rejected

LONGEST = 160  # characters of a reason in the table


@dataclass(frozen=True, slots=True)
class Tried:
    """What came of a program.

    Attributes:
        simulates: Whether it was driven to an end.
        cells: Map, draws, and how it ended or what stopped it.
    """

    simulates: bool
    cells: tuple[str, str, str]


def tried(own: ForeignProgram, maps: list[Path], ego: EgoPolicy, seed: int, simulators: dict[Path, Any]) -> Tried:
    """What comes of a program on the first of some maps that it can be drawn on; else on the first of all."""
    failures: list[Tried] = []
    for map_path in maps:
        if map_path not in simulators:
            simulators[map_path] = ConfinedSimulator(map_path, SimulationSettings())
        try:
            result = on_map(own, simulators[map_path], ego, seed)
        except ChatSceneError as error:
            result = Tried(False, ("", "", f"{type(error).__name__}: {short(error)}"))
        result = Tried(result.simulates, (map_path.stem, *result.cells[1:]))
        if result.simulates:
            return result
        failures.append(result)
    return failures[0]


def on_map(own: ForeignProgram, simulator: ConfinedSimulator, ego: EgoPolicy, seed: int) -> Tried:
    """What comes of a program on one map."""
    program = own.program
    scene = replace(scene_at(program, 0, 0.5, name=f"seed-{seed}"), seed=seed)
    drive = simulator.open(program, scene, observation=observation_of(ego), pedals=pedals_of(ego))
    if isinstance(drive, Rejected):
        return Tried(False, ("", "", f"rejected: {short(drive.reason)}"))
    draws = str(drive.draws)
    try:
        while drive.ending is None and not drive.rejection:
            drive.step(ego.act(drive.observation))
        if drive.rejection:
            return Tried(False, ("", draws, short(drive.rejection)))
        episode = drive.episode(scene.id, "ego")
    finally:
        drive.close()
    crash = f" with {episode.collision.other}" if episode.collision else ""
    return Tried(True, ("", draws, f"{episode.ending} after {drive.step_number * episode.dt:.1f} s{crash}"))


def short(reason: object) -> str:
    """A reason that fits into a table."""
    words = " ".join(str(reason).replace("|", "/").split())
    return words if len(words) <= LONGEST else f"{words[:LONGEST]} …"


@click.command()
@click.argument("folder", type=click.Path(path_type=Path, exists=True))
@click.option("--map", "names", multiple=True, default=("town",), show_default=True, help="In order; repeat.")
@click.option("--ego", "driver", default="idm", show_default=True, help="Who drives.")
@click.option("--as-written", is_flag=True, help="Let the programs' own egos drive.")
@click.option("--seed", default=0, show_default=True, help="What the programs draw with.")
def main(folder: Path, names: tuple[str, ...], driver: str, as_written: bool, seed: int) -> None:
    """Print the table."""
    others = [resolve_map(name) for name in names]
    ego = load_ego(driver)
    simulators: dict[Path, Any] = {}
    count = Counter[bool]()
    print("| program | map | searched | draws | drive |\n|---|---|---:|---:|---|")
    for file in foreign_files(folder):
        name = file.relative_to(folder) if folder.is_dir() else Path(file.name)
        try:
            own = read_foreign(file, as_written=as_written)
        except ChatSceneError as error:
            result, searched = Tried(False, ("", "", short(error))), ""
        else:
            maps = [own.map_path] if own.map_path and own.map_path.is_file() else []
            result, searched = tried(own, maps + others, ego, seed, simulators), str(len(own.program.parameters))
        count[result.simulates] += 1
        where, draws, end = result.cells
        print(f"| `{name.with_suffix('')}` | {where} | {searched} | {draws} | {end} |", flush=True)
    for simulator in simulators.values():
        simulator.close()
    print(f"\n{count[True]} of {count.total()} programs simulate")


if __name__ == "__main__":
    main()
