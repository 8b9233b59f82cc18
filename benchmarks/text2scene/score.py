"""How many scenes of any system show what the texts say.

    python benchmarks/text2scene/score.py FOLDER

FOLDER has a file for each task, ``ID.scenic``, ``ID.xosc``, ``ID.yaml`` or ``ID.json``: a Scenic program, an
OpenSCENARIO file or a situation. Each is driven and checked against the facts of its task as ``chatscene verify`` does.
Programs run confined; a situation is built by chatscene's own builder. What is judged is kept in a file of rows
(``--out``), so that a second call judges only what is new or changed, the maps and
catalogs that it refers to included. No row depends on when, where or beside what it was judged.

*right*: verify ends with status 0. *part*: everybody is there, begins where they should, does what was said, and there
is an encounter; something else is not shown, such as a speed, a contact or a weather, or something happens that nobody
said. *wrong*: any other. *refused*: it cannot be read, compiled, built or driven. *missing*: there is no file. The
score is the share that is right.
"""

from __future__ import annotations

import hashlib
import json
import multiprocessing
from collections import Counter, defaultdict
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor, as_completed
from contextlib import closing
from dataclasses import asdict, dataclass, replace
from enum import StrEnum
from functools import cache
from pathlib import Path
from typing import Any

import click
from referred import digest
from tasks import TASKS, Task, tasks

from chatscene import __version__
from chatscene.build.build import build
from chatscene.ego.asking import fitted
from chatscene.ego.policy import load_ego
from chatscene.errors import ChatSceneError, SettingsError
from chatscene.maps.network import PACKAGED, resolve_map
from chatscene.program.sample import draw, scene_seed
from chatscene.settings import EGO, SimulationSettings, VerifySettings
from chatscene.simulate.confined.plain_text import TRUST
from chatscene.simulate.simulator import Simulator, load_simulator, simulate
from chatscene.situations.file import read_file
from chatscene.terms.scene import Rejected, Scene
from chatscene.terms.situation import Situation
from chatscene.verdict.said import Asked
from chatscene.verdict.sources import watching
from chatscene.verdict.verdict import Verdict
from chatscene.verdict.verify import weighed
from chatscene.verdict.watched import Watched, Watching

DRAWS = 5
PROGRAMS, SITUATIONS = (".scenic", ".xosc"), (".yaml", ".yml", ".json")
MAIN = ("kind", "where", "side", "act", "route", "hidden_by")
"""The last steps of the paths of facts by which a scene is another one."""


class Outcome(StrEnum):
    """What an answer comes to."""

    RIGHT = "right"
    PART = "part"
    WRONG = "wrong"
    REFUSED = "refused"
    MISSING = "missing"


@dataclass(frozen=True, slots=True, kw_only=True)
class Row:
    """What an answer to a task comes to.

    Attributes:
        id: Of the task.
        split: Of the task.
        by: Who wrote its text.
        outcome: What it comes to.
        why: What is not shown, with what is seen instead; or why there is nothing to be seen.
        key: What was judged how; another key is judged again.
    """

    id: str
    split: str
    by: str
    outcome: Outcome
    why: tuple[str, ...] = ()
    key: str = ""


def judged(task: Task, answer: Path | None, settings: VerifySettings) -> Row:
    """What an answer comes to; None is none."""
    row = Row(id=task.id, split=task.split, by=task.by, outcome=Outcome.MISSING, key=key_of(task, answer, settings))
    if answer is None:
        return replace(row, why=(f"there is no {task.id}{', '.join(PROGRAMS)}, {' or '.join(SITUATIONS)}",))
    asked = Asked(situation=task.facts)
    try:
        if answer.suffix.lower() in SITUATIONS:
            found = weighed(watched(read_file(answer), task.id, settings), answer.name, asked, settings)
        else:
            found = weighed(watching(answer, settings), str(answer), asked, settings)
    except ChatSceneError as error:
        return replace(row, outcome=Outcome.REFUSED, why=(_line(error, answer.parent),))
    return replace(row, outcome=outcome(found), why=tuple(reasons(found)))


def outcome(found: Verdict) -> Outcome:
    """What a verdict comes to."""
    if not found.draws:
        return Outcome.REFUSED
    if found.status == 0:
        return Outcome.RIGHT
    lacks = [one for one in (*found.facts, *found.encounters) if one.fails(found.least)]
    main = any(one.path.startswith("encounter.") or one.path.rpartition(".")[2] in MAIN for one in lacks)
    return Outcome.WRONG if main or found.dead or not found.judged else Outcome.PART


def reasons(found: Verdict) -> Iterator[str]:
    """What is wrong, a line each."""
    yield from found.dead
    for one in found.failing:
        said = f"{one.said} in " if one.said else "as it should be in "
        beside = f" ({one.instead})" if one.instead else ""
        yield f"{one.path}: {said}{one.shown} of {len(one.judged)}{beside}"
    if not found.draws:
        yield from dict.fromkeys(found.rejected)


def watched(situation: Situation, name: str, settings: VerifySettings) -> Watching:
    """Drives of a situation as our builder builds it, with the values that its program would be judged with.

    Raises:
        ChatSceneError: It cannot be built or driven.
    """
    if situation.map is not None and situation.map not in PACKAGED:
        raise SettingsError(
            f"map {situation.map!r} is none of {', '.join(PACKAGED)}, on which situations are driven here"
        )
    program = build(situation, name=name)
    simulator, ego = _simulator(program.map), fitted(load_ego(settings.ego or EGO), program.program)
    route = simulator.route(program.program, 0)
    drives, rejected = list[Watched](), list[str]()
    for number in range(settings.draws):
        at = f"{name}/route-00/draw-{number:03d}"
        seed = scene_seed(settings.seed, at)
        values = draw(program.program.parameters, seed=seed)
        scene = Scene(id=at, scenario_id=name, route=0, block=0, seed=seed, values=values)
        episode = simulate(simulator, program.program, scene, ego)
        if isinstance(episode, Rejected):
            rejected.append(episode.reason)
        else:
            drives.append(Watched(episode=episode, route=route))
    return Watching(kind="situation", drives=tuple(drives), rejected=tuple(rejected))


@cache
def _simulator(map_name: str) -> Simulator:
    return load_simulator(resolve_map(map_name), SimulationSettings(simulator="native"))


def answers(folder: Path) -> dict[str, Path]:
    """The answers in a folder, by the ids of their tasks.

    Raises:
        click.UsageError: There are two for one task.
    """
    found = dict[str, Path]()
    for path in sorted(folder.iterdir()):
        if path.suffix.lower() in (*PROGRAMS, *SITUATIONS):
            if path.stem in found:
                raise click.UsageError(f"{found[path.stem]} and {path} are for one task; leave one")
            found[path.stem] = path
    return found


def key_of(task: Task, answer: Path | None, settings: VerifySettings) -> str:
    """What is judged how, in short: another once the answer, or a map or catalog that it refers to, is another."""
    read = answer.read_bytes() + digest(answer) if answer is not None else b""
    name = answer.suffix if answer is not None else ""
    how = {"draws": settings.draws, "seed": settings.seed, "least": settings.least, "version": __version__}
    said = json.dumps([task.id, dict(task.situation), name, how], sort_keys=True)
    return hashlib.sha256(said.encode() + b"\0" + read).hexdigest()[:16]


def kept_rows(path: Path) -> dict[str, Row]:
    """The rows of a former call by their keys; a line that was cut off is none."""
    found = dict[str, Row]()
    for line in path.read_text(encoding="utf-8").splitlines() if path.exists() else ():
        try:
            written = json.loads(line)
        except json.JSONDecodeError:
            continue
        row = Row(**(written | {"outcome": Outcome(written["outcome"]), "why": tuple(written["why"])}))
        found[row.key] = row
    return found


def scored(
    asked: Sequence[Task], folder: Path, settings: VerifySettings, out: Path, jobs: int, told: Callable[[str], None]
) -> list[Row]:
    """A row for each task, in their order; rows that are known are not judged again.

    Raises:
        click.UsageError: There are two answers for one task.
    """
    given, before = answers(folder), kept_rows(out)
    keys = {task.id: key_of(task, given.get(task.id), settings) for task in asked}
    rows = {task.id: before[keys[task.id]] for task in asked if keys[task.id] in before}
    new = [(task, given.get(task.id), settings) for task in asked if task.id not in rows]
    with out.open("a", encoding="utf-8") as file:
        for number, row in enumerate(_in_parallel(new, jobs), 1):
            rows[row.id] = row
            file.write(json.dumps(asdict(row), ensure_ascii=False) + "\n")
            file.flush()
            told(f"{number} of {len(new)}: {row.id} {row.outcome}")
    ordered = [rows[task.id] for task in asked]
    whole = "".join(json.dumps(asdict(row), ensure_ascii=False) + "\n" for row in ordered)
    beside = out.with_suffix(".part")
    beside.write_text(whole, encoding="utf-8")
    beside.replace(out)
    return ordered


def _in_parallel(new: Sequence[tuple[Task, Path | None, VerifySettings]], jobs: int) -> Iterator[Row]:
    if jobs == 1 or len(new) < 2:
        yield from (judged(*one) for one in new)
        return
    spawn = multiprocessing.get_context("spawn")  # a fork would share the sandbox of the parent
    with closing(_Pool(ProcessPoolExecutor(jobs, mp_context=spawn))) as pool:
        yield from (one.result() for one in as_completed([pool.executor.submit(judged, *one) for one in new]))


@dataclass(frozen=True, slots=True)
class _Pool:
    """Processes that do not begin what waits once somebody stops."""

    executor: ProcessPoolExecutor

    def close(self) -> None:
        self.executor.shutdown(cancel_futures=True)


def table(rows: Iterable[Row]) -> dict[str, dict[str, Any]]:
    """How many of each split came to what, and the shares that are right; then those by persons, and all."""
    counts = defaultdict[str, Counter[Outcome]](Counter)
    for row in rows:
        for name in (row.split, f"by {'persons' if row.by == 'person' else 'language models'}", "all"):
            counts[name][row.outcome] += 1
    last = ("by persons", "by language models", "all")
    names = (*(name for name in counts if name not in last), *(name for name in last if name in counts))
    return {name: _counted(counts[name]) for name in names}


def _counted(found: Counter[Outcome]) -> dict[str, Any]:
    total, share = found.total(), found[Outcome.RIGHT] / found.total()
    return {"tasks": total, **{one.value: found[one] for one in Outcome}, "score": round(share, 4)}


def in_words(counts: dict[str, dict[str, Any]]) -> Iterator[str]:
    """The table for a person."""
    names = ("tasks", *(one.value for one in Outcome), "score")
    yield f"| split | {' | '.join(names)} |"
    yield "|---|" + "---:|" * len(names)
    for split, one in counts.items():
        cells = [f"{one[name]:.1%}" if name == "score" else str(one[name]) for name in names]
        yield f"| {split} | {' | '.join(cells)} |"


def _line(error: Exception, folder: Path) -> str:
    """An error in a line that does not say where the answers lie; that one may trust it is no advice here."""
    said = str(error).removesuffix(TRUST).rstrip()
    for at in (folder, folder.resolve()):
        said = said.replace(f"{at}/", "")
    return " ".join(said.split())[:300]


@click.command()
@click.argument("folder", type=click.Path(exists=True, file_okay=False, path_type=Path))
@click.option("--tasks", "path", type=click.Path(exists=True, dir_okay=False, path_type=Path), default=TASKS)
@click.option("--split", "splits", multiple=True, help="Only tasks of this source; may be given several times.")
@click.option(
    "--texts",
    type=click.Path(exists=True, dir_okay=False, path_type=Path),
    help="Only tasks of this file, which tasks.py printed: those whose text your system saw.",
)
@click.option("--task", "names", multiple=True, help="Only the task of this id; may be given several times.")
@click.option("--limit", type=click.IntRange(1), help="Only that many tasks of each source, the first.")
@click.option("--draws", default=DRAWS, show_default=True, help="Drives of each answer.")
@click.option("--seed", default=0, show_default=True)
@click.option("--jobs", type=click.IntRange(1), default=2, show_default=True, help="Processes.")
@click.option("--out", type=click.Path(dir_okay=False, path_type=Path), help="The rows; else FOLDER/../NAME.rows.jsonl")
@click.option("--json", "as_json", is_flag=True, help="The table as JSON.")
@click.option("--why", is_flag=True, help="A line for each that is not right.")
@click.option("--at-least", type=click.FloatRange(0, 1), help="Leave with status 1 if the score is below.")
def main(
    folder: Path,
    path: Path,
    splits: tuple[str, ...],
    texts: Path | None,
    names: tuple[str, ...],
    limit: int | None,
    draws: int,
    seed: int,
    jobs: int,
    out: Path | None,
    as_json: bool,
    why: bool,
    at_least: float | None,
) -> None:
    """Score the answers in FOLDER."""
    every = tasks(path)
    if unknown := set(names) - {task.id for task in every}:
        raise click.UsageError(f"there is no task {min(unknown)}; tasks.py prints the ids")
    asked = [task for task in every if (not splits or task.split in splits) and (not names or task.id in names)]
    if texts is not None:
        seen = {json.loads(line)["id"] for line in texts.read_text(encoding="utf-8").splitlines()}
        asked = [task for task in asked if task.id in seen]
    if limit is not None:
        asked = first_of_each(asked, limit)
    if not asked:
        raise click.UsageError("there is no such task; leave out --split, or see tasks.py for the splits")
    if strangers := sorted(answers(folder).keys() - {task.id for task in every}):
        click.echo(f"{len(strangers)} files answer no task: their names are no ids, such as {strangers[0]}", err=True)
    within = folder.resolve()
    settings = VerifySettings(draws=draws, seed=seed, within=str(within))
    rows = scored(
        asked,
        folder,
        settings,
        out or within.with_name(f"{within.name}.rows.jsonl"),
        jobs,
        lambda line: click.echo(line, err=True),
    )
    counts = table(rows)
    click.echo(json.dumps(counts, indent=2) if as_json else "\n".join(in_words(counts)))
    for row in rows if why else ():
        if row.outcome is not Outcome.RIGHT:
            click.echo(f"{row.outcome} {row.id}: {'; '.join(row.why)}", err=as_json)
    if at_least is not None and counts["all"]["score"] < at_least:
        raise SystemExit(1)


def first_of_each(asked: Iterable[Task], limit: int) -> list[Task]:
    """The first tasks of each split."""
    seen = Counter[str]()
    found = list[Task]()
    for task in asked:
        seen[task.split] += 1
        if seen[task.split] <= limit:
            found.append(task)
    return found


if __name__ == "__main__":
    main()
