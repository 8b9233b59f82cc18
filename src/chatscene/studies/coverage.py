"""What of a catalogue of traffic situations is served, entry by entry.

An entry is served if its sentence is read and a program is chosen for it; where it is driven as well, if that program
climbs the validation ladder. Its scenes are drawn at random from the program's ranges, over as many routes as there
are, and each is driven by every ego.
"""

from __future__ import annotations

import hashlib
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass, field, replace
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from chatscene import pipeline, runs
from chatscene.ego.policy import EgoPolicy, load_ego
from chatscene.errors import (
    EgoError,
    MapError,
    MeansSomethingElse,
    NothingFits,
    ProgramError,
    SandboxError,
    ServerError,
    SettingsError,
    SimulationError,
    SnippetError,
)
from chatscene.maps.drawing import drawing_around
from chatscene.maps.loading import load_roads
from chatscene.maps.network import map_with, resolve_map
from chatscene.measure.drive import Ran
from chatscene.report.animation import if_drawn, still
from chatscene.report.coverage import coverage_page
from chatscene.report.filled import explain_text
from chatscene.report.stated import Stated
from chatscene.report.understood import Understood
from chatscene.report.viewer import best as best_of
from chatscene.runs.atomic import write_bytes, write_json
from chatscene.runs.executor import ONE, Workers
from chatscene.runs.parallel import spread
from chatscene.runs.progress import Progress
from chatscene.search.climb import climb, simulator_of
from chatscene.search.generator import Generator, load_generator
from chatscene.settings import Settings
from chatscene.simulate.simulator import Simulator, check_jobs, routes_of
from chatscene.studies.catalogue import slug
from chatscene.studies.collection import Driver, Driving
from chatscene.studies.imported_entries import asked_of, covered
from chatscene.terms.coverage import Answer, Catalogue, Covered, Entry, Fared, Searched, Tally
from chatscene.terms.episode import Episode
from chatscene.terms.scenario import Said, Scenario, grouped
from chatscene.terms.scene import ScenicProgram
from chatscene.terms.snippet import Retrieval

SCENES = 10  # of each entry, if nobody says how many
EGOS = ("sac", "idm")  # the paper's surrogate, and a driver by rule that sees everybody

Task = tuple[int, str, Entry]


@dataclass(frozen=True, slots=True, kw_only=True)
class Asked:
    """What is asked of every entry.

    Attributes:
        settings: How sentences are read; how scenes are searched in a run, and the seed of those that are drawn.
        map_name: Where scenes are driven; None for the packaged map that has the site of each sentence.
        egos: Who drives; the first of them in runs, too.
        scenes: How many scenes of each entry are drawn and driven; 0 for none.
        folder: Where runs are, and what is written; None for nowhere.
        fill: Whether an entry without a run gets one.
    """

    settings: Settings = field(default_factory=Settings)
    map_name: str | None = None
    egos: tuple[str, ...] = EGOS
    scenes: int = 0
    folder: Path | None = None
    fill: bool = False


def cover(
    catalogues: Sequence[Catalogue], asked: Asked, *, workers: Workers = ONE, progress: Progress
) -> tuple[Covered, ...]:
    """Ask for every entry of catalogues; runs that are missing can be killed at any time, and are gone on with.

    Returns:
        A row for each entry, in their order.

    Raises:
        SettingsError: Two catalogues have the same name, or there is no such map or simulator.
        EgoError: An ego cannot be loaded, or the first of them, which drives in runs, fails in one.
        RunError: A run in the folder is another than is asked for, or damaged.
    """
    names = [catalogue.name for catalogue in catalogues]
    for name in names:
        if names.count(name) > 1:
            raise SettingsError(f"two catalogues are called {name!r}; give one file another name")
    if asked.fill and asked.folder is None:
        raise SettingsError("runs need a folder: say where with --out")
    check_jobs(asked.settings.simulation, workers.jobs)
    resolve_map(asked.map_name or map_with(None))  # what is not there is told here, and once
    for ego in asked.egos:
        load_ego(ego)
    every = [(catalogue.name, entry) for catalogue in catalogues for entry in catalogue.entries]
    tasks = [(number, name, entry) for number, (name, entry) in enumerate(every)]
    rows: dict[int, Covered] = {}
    workers = workers.here() if asked.folder else workers
    for number, row in spread(_Desk, asked, tasks, workers=workers):
        rows[number] = row
        progress("entries", len(rows), len(tasks))
    return tuple(rows[number] for number in range(len(tasks)))


class _Desk:
    """Answers for one entry after another."""

    def __init__(self, asked: Asked) -> None:
        self._asked = asked
        self._simulators: dict[Path, Simulator] = {}
        self._egos: dict[str, EgoPolicy] = {}
        self._driver: Driver | None = None
        if asked.scenes:
            self._egos = {name: load_ego(name) for name in asked.egos}
            self._driver = Driver(Driving(egos=tuple(asked.egos), scenes=asked.scenes, seed=asked.settings.search.seed))

    def __call__(self, task: Task) -> tuple[int, Covered]:
        number, catalogue, entry = task
        return number, self._covered(catalogue, entry)

    def _covered(self, catalogue: str, entry: Entry) -> Covered:
        row = Covered(catalogue=catalogue, entry=entry, answer=Answer.OUT_OF_REACH, reasons=(entry.reason,), slots={})
        if not (entry.program or entry.sentence):
            return row
        try:
            if entry.program:
                return self._imported(row)
            understood = explain_text(entry.sentence, self._asked.settings, map_name=self._asked.map_name)
            scenario = understood.scenario
            row = replace(row, slots=_in_words(scenario), answer=Answer.SERVED, reasons=(), **_chosen(understood))
            if self._asked.scenes:
                row = self._driven(row, understood)
            if self._asked.folder:
                row = self._searched(row, understood, self._asked.folder)
        except (NothingFits, MeansSomethingElse) as refusal:
            reasons = refusal.reasons if isinstance(refusal, NothingFits) else (str(refusal),)
            return replace(row, answer=Answer.REFUSED, reasons=reasons, **_NO_CHOICE)
        except (ServerError, SandboxError):
            raise  # which say nothing of the program
        except (MapError, ProgramError, SnippetError, SimulationError) as error:
            return replace(row, answer=Answer.FAILED, reasons=(f"{type(error).__name__}: {error}",), **_NO_CHOICE)
        return row

    def _imported(self, row: Covered) -> Covered:
        """The row of a program that was imported, with its run."""
        row = covered(row, self._driver, self._asked.egos)
        if row.answer is Answer.SERVED and self._asked.folder:
            asked = partial(asked_of, row.entry, self._asked.settings, self._asked.egos[0])
            row = self._run_of(row, asked, self._asked.folder)
        return row

    def _driven(self, row: Covered, understood: Understood | Stated) -> Covered:
        """What drawn scenes show, once the program, or the next best, stands on the ladder."""
        settings, map_path = self._asked.settings, self._map_of(understood)
        scenario, generator = understood.scenario, load_generator(understood.generator)
        first = generator.write(scenario, settings.retrieval)
        if map_path not in self._simulators:
            self._simulators[map_path] = simulator_of(generator, map_path, settings)
        simulator = self._simulators[map_path]
        failures: dict[str, str] = {}
        for name, ego in self._egos.items():  # the first that does not fail climbs
            try:
                written, _ = climb(
                    generator, scenario, first, settings=settings.retrieval, simulator=simulator, ego=ego
                )
                break
            except EgoError as error:
                failures[name] = str(error)
        else:
            return replace(row, failures=failures)
        routes = list(routes_of(simulator, written.program, self._asked.scenes))
        drives: dict[str, list[Ran]] = {}
        for name, ego in self._egos.items():
            if name in failures:
                continue
            try:
                drives[name] = list(self._drives_of(ego, written.program, scenario.said, routes, generator, simulator))
            except EgoError as error:
                failures[name] = str(error)
        every = [ran for own in drives.values() for ran in own]
        best = max(every, key=lambda ran: (not ran.meaning, ran.episode.collision is not None), default=None)
        missed = Counter(failure for ran in every for failure in ran.meaning)
        return replace(
            row,
            fared=tuple(_fared(name, own) for name, own in drives.items()),
            failures=failures,
            missed=tuple(missed.most_common()),
            picture=_still(best.episode, map_path) if best and self._asked.folder else b"",
        )

    def _drives_of(
        self,
        ego: EgoPolicy,
        program: ScenicProgram,
        said: Said,
        routes: Sequence[int],
        generator: Generator,
        simulator: Simulator,
    ) -> Iterator[Ran]:
        """The drives of an ego, in turn on the routes of a program."""
        for place, route in enumerate(routes):
            count = len(range(place, self._asked.scenes, len(routes)))
            looking = replace(self._asked.settings.search, scenes=count, block=count, sampler="random")
            for block in generator.explore(
                program, said, route, simulator=simulator, ego=ego, settings=looking, done=()
            ):
                yield from block.ran

    def _map_of(self, understood: Understood | Stated) -> Path:
        built_on = understood.built.map if isinstance(understood, Stated) else map_with(understood.scenario.slots.site)
        return resolve_map(self._asked.map_name or built_on)

    def _searched(self, row: Covered, understood: Understood | Stated, folder: Path) -> Covered:
        """The row with its run, which is made or gone on with if that is asked for."""
        situation = understood.record if isinstance(understood, Stated) else None
        asked = partial(
            runs.asked_run,
            row.entry.sentence,
            situation=situation,
            generator=understood.generator,
            settings=self._asked.settings,
            map_name=understood.built.map if isinstance(understood, Stated) else self._asked.map_name,
            ego=self._asked.egos[0],
        )
        return self._run_of(row, asked, folder)

    def _run_of(self, row: Covered, asked: Callable[[], runs.RunRecord], folder: Path) -> Covered:
        """The row with the run in its folder, which is made or gone on with if that is asked for."""
        name = folder_of(row)
        run = runs.Workspace(folder / name)
        if self._asked.fill:
            record = asked()
            if run.file("run.json").is_file() and runs.is_drawn_up(run):
                runs.take_up(run.path, record)  # or it is another's
            else:
                pipeline.run(record, run.path)
        if not run.file("run.json").is_file():
            return row
        found = runs.read_record(run)
        searched = Searched(folder=name, status=found.status.value, counts=found.counts)
        wanted = not row.picture and found.status is runs.Status.DONE
        best = best_of(run) if wanted else None
        if best is None:
            return replace(row, searched=searched)
        episode, drawing = runs.read_episode(run, best["scene_id"]), runs.read_drawing(run)
        picture = if_drawn(f"the picture of {run.path}", lambda: still(episode, drawing)) or b""
        return replace(row, searched=searched, picture=picture)


def _still(episode: Episode, map_path: Path) -> bytes:
    actors = (episode.ego_track, *episode.adversaries)
    points = np.concatenate([np.column_stack((track.x, track.y)) for track in actors])
    what = f"the picture of {episode.scene_id}"
    return if_drawn(what, lambda: still(episode, drawing_around(load_roads(map_path), points))) or b""


_NO_CHOICE: dict[str, Any] = {"snippet_ids": (), "confidence": None}


def folder_of(row: Covered) -> str:
    """Where the run of an entry is; another sentence, or another program, has another one."""
    entry = row.entry
    said = hashlib.blake2b((entry.name if entry.program else entry.sentence).encode(), digest_size=3).hexdigest()
    return f"runs/{row.catalogue}/{slug(entry.name)}-{said}"


def _in_words(scenario: Scenario) -> dict[str, str]:
    """What was read, by slot."""
    return {
        name: ", then ".join(map(str, value)) if isinstance(value, tuple) else str(value)
        for name, value in scenario.slots.said().items()
    }


def _chosen(understood: Understood | Stated) -> dict[str, Any]:
    """What of a sentence is not shown, and the snippets that serve it, if any are chosen."""
    if isinstance(understood, Stated):
        return {"unused": understood.told_first}
    scenario, retrieval = understood.scenario, understood.retrieval
    assert isinstance(retrieval, Retrieval)  # whoever retrieves says so
    return {
        "snippet_ids": tuple(snippet.id for snippet in retrieval.snippets),
        "confidence": retrieval.confidence,
        "unused": tuple(grouped((*scenario.unused, *retrieval.unused)).values()),
    }


def _fared(ego: str, drives: Sequence[Ran]) -> Fared:
    return Fared(
        ego=ego,
        scenes=len(drives),
        shown=sum(not ran.meaning for ran in drives),
        collisions=sum(ran.episode.collision is not None for ran in drives),
        avoidable=sum(ran.avoidable is True for ran in drives),
    )


# What is told


def write(folder: Path, catalogues: Sequence[Catalogue], asked: Asked, rows: Sequence[Covered]) -> Path:
    """Leave ``coverage.json`` and ``coverage.html`` in a folder.

    Returns:
        The page.

    Raises:
        RunError: The folder cannot be written.
    """
    write_json(folder / "coverage.json", as_json(catalogues, asked, rows))
    page = folder / "coverage.html"
    write_bytes(page, coverage_page([(one, of_catalogue(one, rows)) for one in catalogues]).encode())
    return page


def as_json(catalogues: Sequence[Catalogue], asked: Asked, rows: Sequence[Covered]) -> dict[str, Any]:
    """Every entry with what became of it, for a script.

    Returns:
        `map`, `seed`, `scenes`, `egos`, and `catalogues`: each with `name`, `title`, the counts `entries`, `in_reach`,
        `served` and `shown` (in at least 90 % of the drives; null if nothing was driven), and `rows`, which have the
        fields of `Covered`, with `name` and `sentence` in place of the entry.
    """
    return {
        "map": asked.map_name,
        "seed": asked.settings.search.seed,
        "scenes": asked.scenes,
        "egos": list(asked.egos) if asked.scenes else [],
        "catalogues": [_told(catalogue, of_catalogue(catalogue, rows)) for catalogue in catalogues],
    }


def of_catalogue(catalogue: Catalogue, rows: Sequence[Covered]) -> list[Covered]:
    """The rows of one catalogue."""
    return [row for row in rows if row.catalogue == catalogue.name]


def _told(catalogue: Catalogue, rows: Sequence[Covered]) -> Mapping[str, Any]:
    told: list[dict[str, Any]] = []
    for row in rows:
        content = asdict(row)
        entry: dict[str, str] = content.pop("entry")
        del content["catalogue"], content["picture"]
        told.append({"name": entry["name"], "sentence": entry["sentence"], **content})
    return {"name": catalogue.name, "title": catalogue.title, **asdict(Tally.of(rows)), "rows": told}
