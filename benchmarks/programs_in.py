"""What becomes of other people's Scenic programs: rewritten, compiled, drawn, driven, and judged by what they say.

    python benchmarks/programs_in.py FOLDER --of "javyduck/ChatScene at 0854cd6" [--given given.json] [--map Town05]

FOLDER is one that you have laid out: nothing of it is part of this project, and without it there is nothing to print.
Every `.scenic` file below it is read as `chatscene run --program` reads it, and runs in the sandbox, on the map that it
names where that is at hand, else on the first of those given; the table says which. The given ego drives, or the
program's own with `--as-written`. `--given` is a file of JSON that gives the parameters that a program is to be told,
by a pattern of its path: {"scenario_1/*": {"town": "Town05", "spawnPt": [96.5, -188.0]}}.

`--on MAP` runs every program on one map in place of its own. `--said` is a file of JSON with what programs are to show,
as situations: [{"programs": ["scenario_1/b_1"], "situation": {...}}]; without it, their own docstrings are read.

Columns: how many changes make it Scenic 3; whether it compiles, can be drawn and is driven to an end; and, with
`--judge`, what of its own description (the docstring at its beginning) the judge sees in that many drives.
"""

from __future__ import annotations

import fnmatch
import json
from collections import Counter
from collections.abc import Mapping, Sequence
from contextlib import closing
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import click

from chatscene.ego.asking import fitted
from chatscene.ego.policy import EgoPolicy, load_ego, name_of, observation_of, pedals_of
from chatscene.errors import ChatSceneError, NothingFits
from chatscene.maps.carla_towns import file_or_town
from chatscene.maps.network import resolve_map
from chatscene.program.sample import draw, scene_seed
from chatscene.search.generators.foreign import ForeignProgram, foreign_files, read_foreign
from chatscene.settings import EGO, RetrievalSettings, SimulationSettings, VerifySettings
from chatscene.simulate.confined.simulator import ConfinedSimulator
from chatscene.simulate.simulator import drive
from chatscene.situations.form import parsed
from chatscene.terms.scene import Rejected, Scene
from chatscene.terms.situation import Situation
from chatscene.verdict.said import asked
from chatscene.verdict.verdict import Answer
from chatscene.verdict.verify import weighed
from chatscene.verdict.watched import Watched, Watching

LONGEST = 150  # characters of a reason in the table


@dataclass(slots=True)
class Row:
    """What became of a program.

    Attributes:
        name: Its path in the folder.
        changes: How many make it Scenic 3; None if it was not read.
        compiles: Whether Scenic compiles it.
        samples: In how many tries of how many it can be drawn.
        runs: How many drives came to an end.
        tries: Of how many.
        where: The map.
        end: How the last one ended, or what stopped it.
        judged: What the judge says.
    """

    name: str
    changes: int | None = None
    compiles: bool = False
    samples: int = 0
    runs: int = 0
    tries: int = 0
    where: str = ""
    end: str = ""
    judged: str = ""

    def __str__(self) -> str:
        changes = "" if self.changes is None else str(self.changes)
        done = [f"{part}/{self.tries}" if self.tries else "" for part in (self.samples, self.runs)]
        compiles = "yes" if self.compiles else "no"
        return " | ".join(
            ("", f"`{self.name}`", self.where, changes, compiles, *done, self.end, self.judged, "")
        ).strip()


def row_of(file: Path, name: str, given: Mapping[str, object], run: Running) -> Row:
    """What becomes of one program on the first of its maps that it can be drawn on."""
    row = Row(name)
    try:
        own = read_foreign(file, as_written=run.as_written, searched_with=False, given=given)
    except ChatSceneError as error:
        row.end = short(str(error).rpartition(f"{file.name}: ")[2])
        return row
    row.changes = len(own.rewritten.changes)
    for where in [run.on] if run.on else maps_of(own, run.maps):
        row = replace(row, where=where.stem)
        drives = driven(own, where, row, run)
        if row.runs:
            row.judged = judged(own, drives, run.said.get(name)) if run.judge else ""
            break
    return row


@dataclass(frozen=True, slots=True)
class Running:
    """How programs are run.

    Attributes:
        maps: For those whose own is not there, in order.
        ego: Who drives.
        as_written: Whether their own egos do.
        draws: How many drives.
        tries: How many scenes at most, each with values of its own, until there are so many drives.
        seed: Of what is drawn.
        judge: Whether they are judged by their descriptions.
        on: The map that all run on; None for the one of each.
        said: What programs are to show, by their paths; of others their own descriptions are read.
        simulators: Those that are open, by map.
    """

    maps: Sequence[Path]
    ego: EgoPolicy
    as_written: bool
    draws: int
    tries: int
    seed: int
    judge: bool
    on: Path | None
    said: Mapping[str, Situation]
    simulators: dict[Path, Any]


def maps_of(own: ForeignProgram, others: Sequence[Path]) -> list[Path]:
    """The map of a program if it is at hand; else the others."""
    named = None if own.map_path is None else file_or_town(own.map_path)
    return list(others) if named is None else [resolve_map(named)]


def driven(own: ForeignProgram, where: Path, row: Row, run: Running) -> list[Watched]:
    """The drives of a program; what came of them is written into its row."""
    drives: list[Watched] = []
    program, row.samples, ego = own.program, 0, fitted(run.ego, own.program)
    for number in range(run.tries):
        if len(drives) == run.draws:
            break
        row.tries = number + 1
        name = f"{program.scenario_id}/route-00/draw-{number:03d}"
        seed = scene_seed(run.seed, name)
        values = draw(program.parameters, seed=seed)
        scene = Scene(id=name, scenario_id=program.scenario_id, route=0, block=0, seed=seed, values=values)
        try:
            if where not in run.simulators:
                run.simulators[where] = ConfinedSimulator(where, SimulationSettings())
            simulator = run.simulators[where]
            simulator.routes(program)
            row.compiles = True
            session = simulator.open(program, scene, observation=observation_of(ego), pedals=pedals_of(ego))
            if isinstance(session, Rejected):
                row.end = short(f"not drawn: {session.reason}")
                continue
            row.samples += 1
            with closing(session):
                drive(session, ego, scene.id)
                if session.rejection:
                    row.end = short(f"rejected in the drive: {session.rejection}")
                    continue
                episode = session.episode(scene.id, name_of(ego))
            route = simulator.route_in(program, scene)
        except ChatSceneError as error:
            row.end = short(f"{type(error).__name__}: {error}")
            continue
        row.runs += 1
        crash = f" with {episode.collision.other}" if episode.collision else ""
        row.end = f"{episode.ending} after {episode.duration:.1f} s{crash}"
        drives.append(Watched(episode=episode, route=route, tested=not run.as_written))
    return drives


def judged(own: ForeignProgram, drives: Sequence[Watched], told: Situation | None) -> str:
    """What its drives show of what is told of a program, else of its own description."""
    said = told or description(own.program.source)
    if not said:
        return "says nothing"
    try:
        what = asked(said, RetrievalSettings())
    except NothingFits:
        return "not read"
    except ChatSceneError as error:
        return short(f"not read: {error}")
    found = weighed(Watching(kind="Scenic program", drives=tuple(drives)), own.path.name, what, VerifySettings())
    facts = [one for one in found.facts if not one.assumed and one.judged]
    shown = sum(one.answer in {Answer.SHOWN, Answer.IN_PART} for one in facts)
    missing = ", ".join(one.path for one in facts if one.answer is Answer.NOT_SHOWN)
    return f"{shown} of {len(facts)} facts" + (f"; not {missing}" if missing else "")


def description(source: str) -> str:
    """The text at the beginning of a program; empty if there is none."""
    quotes = source.lstrip()[:3]
    if quotes not in {'"""', "'''"}:
        return ""
    text = source.lstrip()[3:].partition(quotes)[0]
    return " ".join(text.split())


def told_in(file: Path) -> dict[str, Situation]:
    """What programs are to show, by their paths."""
    rows = json.loads(file.read_text(encoding="utf-8"))
    return {name: parsed(row["situation"]) for row in rows for name in row["programs"]}


def short(reason: object) -> str:
    """A reason that fits into a table."""
    words = " ".join(str(reason).replace("|", "/").split())
    return words if len(words) <= LONGEST else f"{words[:LONGEST]} …"


@click.command()
@click.argument("folder", type=click.Path(path_type=Path))
@click.option("--of", "collection", required=True, help="Repository and version, for the table's title.")
@click.option("--given", "given_file", type=click.Path(path_type=Path, exists=True), help="Parameters, by path.")
@click.option("--map", "names", multiple=True, default=("town",), show_default=True, help="In order; repeat.")
@click.option("--ego", "driver", default=EGO, show_default=True, help="Who drives.")
@click.option("--as-written", is_flag=True, help="Let the programs' own egos drive.")
@click.option("--draws", default=1, show_default=True, help="Drives of each program.")
@click.option("--tries", default=1, show_default=True, help="Scenes that are tried for them, at most.")
@click.option("--judge", is_flag=True, help="Judge the drives by the program's own description.")
@click.option("--on", default=None, help="Run every program on this map in place of its own.")
@click.option("--said", "said_file", type=click.Path(path_type=Path, exists=True), help="What programs are to show.")
@click.option("--only", multiple=True, default=("*",), help="A pattern of the paths of programs; repeat.")
@click.option("--seed", default=0, show_default=True, help="What everything is drawn by.")
def main(
    folder: Path,
    collection: str,
    given_file: Path | None,
    names: tuple[str, ...],
    driver: str,
    as_written: bool,
    draws: int,
    tries: int,
    judge: bool,
    on: str | None,
    said_file: Path | None,
    only: tuple[str, ...],
    seed: int,
) -> None:
    """Print the table."""
    if not folder.is_dir():
        print(f"{folder} is not laid out: nothing to do")
        return
    given: dict[str, dict[str, object]] = json.loads(given_file.read_text()) if given_file else {}
    run = Running(
        [resolve_map(one) for one in names],
        load_ego(driver),
        as_written,
        draws,
        max(draws, tries),
        seed,
        judge,
        resolve_map(on) if on else None,
        told_in(said_file) if said_file else {},
        {},
    )
    count = Counter[str]()
    print(f"{collection}\n\n| program | map | changes | compiles | drawn | runs | end | judged |")
    print("|---|---|---:|---|---:|---:|---|---|")
    for file in (one for one in foreign_files(folder) if not any(part.startswith(".") for part in one.parts)):
        name = str(file.relative_to(folder).with_suffix(""))
        if not any(fnmatch.fnmatch(name, pattern) for pattern in only):
            continue
        told = {k: v for pattern, values in given.items() if fnmatch.fnmatch(name, pattern) for k, v in values.items()}
        row = row_of(file, name, told, run)
        print(row, flush=True)
        changed, ran = bool(row.changes), bool(row.runs)
        count.update(all=1, rewritten=changed, compile=row.compiles, drawn=bool(row.samples), run=ran)
    for simulator in run.simulators.values():
        simulator.close()
    done = ", ".join(f"{count[what]} {what}" for what in ("rewritten", "compile", "drawn", "run"))
    print(f"\nof {count['all']} programs: {done}")


if __name__ == "__main__":
    main()
