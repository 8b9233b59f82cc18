"""The whole method on one screen: one call per step.

Paper: figure 1. Steps 1 (describe), 8 (evaluate) and 9 (finetune) are commands of their own.
"""

from __future__ import annotations

import re
import time
from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from chatscene import runs
from chatscene.ego.policy import load_ego, senses_of
from chatscene.errors import (
    ChatSceneError,
    Diverged,
    MapError,
    MeansSomethingElse,
    NothingFits,
    RunError,
    SnippetError,
)
from chatscene.maps.drawing import map_drawing
from chatscene.maps.network import load_network, resolve_map
from chatscene.measure.score import wilson
from chatscene.report.animation import write_gif
from chatscene.report.egos import egos_in_words
from chatscene.report.viewer import write_report
from chatscene.runs.digests import digest_of
from chatscene.runs.parallel import Work, run_blocks
from chatscene.runs.trust import Repeated, follow
from chatscene.search.generator import climb, load_generator, simulator_of
from chatscene.search.generators.retrieved import Retrieved
from chatscene.search.sampler import load_sampler
from chatscene.search.select import Candidate, select
from chatscene.settings import SearchSettings, Settings
from chatscene.simulate.simulator import Simulator, simulate
from chatscene.terms.episode import Episode, Track
from chatscene.terms.route import Route
from chatscene.terms.scenario import Scenario
from chatscene.terms.scene import Rejected, ScenicProgram
from chatscene.terms.snippet import Retrieval

Progress = Callable[[str, int, int], None]
MARGIN = 60.0  # [m] of map drawn around the routes


@dataclass(frozen=True, slots=True, kw_only=True)
class Understood:
    """What became of a sentence before anything was run (steps 2 to 4)."""

    scenario: Scenario
    retrieval: Retrieval | None
    program: ScenicProgram

    def as_dict(self) -> dict[str, Any]:
        """For a script: the explanation, and the program's text."""
        explanation = runs.explain(self.scenario.text, [(self.scenario, self.retrieval)])
        return {**explanation, "program": self.program.source}

    def __str__(self) -> str:
        """For a person, as the command line prints it."""
        from chatscene.report.terminal import understanding_text

        return understanding_text(self)

    def _repr_html_(self) -> str:
        """For a notebook, as the report shows it."""
        from chatscene.report.notebook import understanding_frame

        return understanding_frame(self.scenario, self.as_dict())


@dataclass(frozen=True, slots=True, kw_only=True)
class Summary:
    """What a run came to.

    Attributes:
        counts: As in `run.json`.
        seconds: Wall time, of every call that worked on the folder.
        ego: Who drove, and what it sees: no collision rate means anything without it.
    """

    counts: Mapping[str, int]
    seconds: float
    ego: str

    @classmethod
    def of(cls, record: runs.RunRecord) -> Summary:
        """The summary of a run by its record."""
        return cls(counts=record.counts, seconds=record.timings["total"], ego=egos_in_words(record)[0])

    def in_words(self) -> str:
        """Two lines for a person: what came of it, and what the ego could see."""
        ran, collided = self.counts["ran"], self.counts["collided"]
        low, high = wilson(collided, ran)
        rejected = f", {self.counts['rejected']} draws rejected" if self.counts["rejected"] else ""
        kept, fill_in = self.counts["selected"], self.counts["fill_in"]
        unlike = kept - self.counts.get("selected_shown", kept)  # folders of before it was counted
        but = [f"{fill_in} without a collision"] * bool(fill_in)
        but += [f"{unlike} that {'does' if unlike == 1 else 'do'} not show all that was read"] * bool(unlike)
        return (
            f"{ran} scenes in {self.seconds:.1f} s{rejected}: the ego collided in {collided} "
            f"({collided / max(ran, 1):.0%}, 95 % interval {low:.0%} to {high:.0%}); "
            f"{kept} kept" + (f" ({', '.join(but)})" if but else "") + f"\n{self.ego}"
        )


@dataclass(frozen=True, slots=True, kw_only=True)
class Replayed:
    """A scene simulated again.

    Attributes:
        scene_id: Which.
        difference: Where the tracks first differ, in words; empty if every number is the same.
        versions: What the run was made with and is otherwise now: by name, the version then and now.
    """

    scene_id: str
    difference: str
    versions: Mapping[str, tuple[str, str]]

    @property
    def identical(self) -> bool:
        """Whether the tracks are the same, bit for bit."""
        return not self.difference

    def as_dict(self) -> dict[str, Any]:
        """For a script."""
        return {
            "scene_id": self.scene_id,
            "identical": self.identical,
            "difference": self.difference,
            "versions": {name: {"then": then, "now": now} for name, (then, now) in self.versions.items()},
        }

    def in_words(self) -> str:
        """One line for a person."""
        if self.identical:
            return f"{self.scene_id}: identical"
        return f"{self.scene_id}: differs: {self.difference}{_since(self.versions)}"


def understand(text: str, settings: Settings | None = None) -> Understood:
    """Steps 2 to 4: a sentence to the program that expresses it.

    Raises:
        SettingsError: The text is empty or too long.
        NothingFits: The library cannot serve it.
    """
    settings = settings or Settings()
    generator = Retrieved()
    scenario = generator.read(text, settings.retrieval)
    written = generator.write(scenario, settings.retrieval)
    return Understood(scenario=scenario, retrieval=written.retrieval, program=written.program)


def run(
    text: str,
    folder: Path,
    *,
    settings: Settings | None = None,
    map_name: str = "town",
    ego_name: str = "sac",
    jobs: int = 1,
    generator: str = "chatscene",
    progress: Progress | None = None,
) -> Summary:
    """Steps 2 to 7 and the report, into a new run folder.

    Raises:
        NothingFits: The library cannot serve the sentence; the folder says why.
        ChatSceneError: Anything else that went wrong; the folder can be resumed.
    """
    settings = settings or Settings()
    maker = load_generator(generator)
    maker.read(text, settings.retrieval)  # an empty text leaves no folder behind
    map_path = resolve_map(map_name)
    simulator = simulator_of(maker, map_path, settings)
    senses = {ego_name: senses_of(load_ego(ego_name))}
    load_sampler(settings.search.sampler)
    with runs.alone(folder):
        kept = runs.create(
            folder,
            text=text,
            settings=settings,
            map_name=map_name,
            map_path=map_path,
            ego=ego_name,
            generator=generator,
            senses=senses,
            simulator=simulator.identity,
        )
        return _carry_on(kept, jobs, progress or silent)


def resume(
    folder: Path, *, jobs: int = 1, progress: Progress | None = None, repeated: Repeated | None = None
) -> Summary:
    """Go on with a run that was killed or failed; the result is that of an uninterrupted one.

    Raises:
        RunError: There is no run in the folder, it is damaged, another process is at work on it, or it names what must
            be repeated (`chatscene.runs.trust.follow`).
    """
    run = runs.open_run(folder, holds="run")
    follow(repeated or Repeated(), egos_of=[run], simulators_of=[run], reading_of=[run])
    with runs.alone(folder):
        return _carry_on(run, jobs, progress or silent)


def _carry_on(run: runs.Workspace, jobs: int, progress: Progress) -> Summary:
    since = time.monotonic()

    def clock() -> runs.RunRecord:
        """Add the time since it was last called: block by block, so that a kill costs no more than a block of it."""
        nonlocal since
        before, since = since, time.monotonic()
        return runs.update(run, timings={"total": since - before})

    def tell(what: str, done: int, total: int) -> None:
        clock()
        progress(what, done, total)

    try:
        search(run, jobs, tell)
        _report(run, tell)
    except (NothingFits, MeansSomethingElse) as error:
        runs.update(run, status=runs.Status.REFUSED, reason=str(error))
        raise
    except ChatSceneError as error:
        runs.update(run, status=runs.Status.FAILED, reason=str(error))
        raise
    return Summary.of(clock())


def search(run: runs.Workspace, jobs: int, progress: Progress) -> None:
    """Steps 2 to 7 for a run folder, from where it stands."""
    settings = runs.settings_of(runs.read_record(run))
    done = runs.resume(run, told=lambda said: progress(said, 0, 0))
    record = runs.read_record(run)
    if record.status is runs.Status.DONE:
        return
    map_path, ego = map_of(record), load_ego(record.ego)

    def explain(scenario: Scenario, retrieval: Retrieval | None) -> None:
        runs.write_explanation(run, runs.explain(record.text, [(scenario, retrieval)]))

    progress("understanding the sentence", 0, 0)
    generator = load_generator(record.generator)
    scenario = generator.read(record.text, settings.retrieval)
    explain(scenario, None)
    written = generator.write(scenario, settings.retrieval)
    explain(scenario, written.retrieval)
    runs.write_program(run, scenario.id, written.program.source)

    progress("checking that drives show what was read", 0, 0)
    simulator = simulator_of(generator, map_path, settings)
    written, _ = climb(generator, scenario, written, settings=settings.retrieval, simulator=simulator, ego=ego)
    program = written.program
    explain(scenario, written.retrieval)
    runs.write_program(run, scenario.id, program.source)
    routes = routes_of(simulator, program, settings.search.routes)
    if len(routes) < settings.search.routes:
        progress(f"map {record.map_name!r} has {len(routes)} of the {settings.search.routes} routes asked for", 0, 0)
    runs.write_drawing(run, _drawing(map_path, routes, scenario.id))

    work = Work(
        folder=run.path,
        generator=record.generator,
        program=program,
        slots=scenario.slots,
        map_path=map_path,
        ego=record.ego,
        settings=settings,
    )
    before = {route: done.get((scenario.id, route), []) for route in routes}
    already = sum(map(len, before.values()))
    total = len(routes) * work.blocks()
    run_blocks(work, before, jobs=jobs, on_block=lambda n: progress("searching, blocks", already + n, total))
    every = [(scenario.id, route, number) for route in routes for number in range(work.blocks())]
    runs.finish(run, selected=_selected(run, settings.search), expected=every)


def _selected(run: runs.Workspace, settings: SearchSettings) -> dict[str, bool]:
    """Step 7 for every scenario and route: scene id to whether it is a fill-in."""
    jobs: dict[tuple[str, str], list[Candidate]] = {}
    for row in runs.read_scenes(run):
        if row["status"] == "ran":
            candidate = Candidate(
                scene_id=row["scene_id"],
                collided=row["collision"],
                shown=row["meaning_ok"],
                avoidable=row["avoidable"],
                overall_score=row["overall_score"],
            )
            jobs.setdefault((row["scenario_id"], row["route_id"]), []).append(candidate)
    return {
        s.scene_id: s.fill_in
        for candidates in jobs.values()
        for s in select(
            candidates, count=settings.keep, selection=settings.selection, avoidable_only=settings.avoidable_only
        )
    }


def routes_of(simulator: Simulator, program: ScenicProgram, wanted: int) -> dict[int, Route]:
    """The first routes of a program's geometry on which its adversary has a way, by number; as many as there are."""
    found: dict[int, Route] = {}
    for index in range(simulator.routes(program)):
        if len(found) < wanted:
            with suppress(MapError):
                found[index] = simulator.route(program, index)
    return found


def _drawing(map_path: Path, routes: Mapping[int, Route], scenario_id: str) -> dict[str, Any]:
    """The map around the routes, and the routes."""
    points = np.concatenate([route.line.points for route in routes.values()])
    (x0, y0), (x1, y1) = points.min(axis=0) - MARGIN, points.max(axis=0) + MARGIN
    drawing = map_drawing(load_network(map_path), (float(x0), float(y0), float(x1), float(y1)))
    lines = {f"{scenario_id}/route-{k:02d}": route.line.points.round(2).tolist() for k, route in routes.items()}
    return {**drawing, "routes": lines}


def _report(run: runs.Workspace, progress: Progress) -> None:
    progress("writing the report", 0, 0)
    write_report(run.path)
    write_gif(run.path)


def replay(folder: Path, scene_id: str, *, repeated: Repeated | None = None) -> Replayed:
    """Simulate a scene of a run again from its stored values, and compare every number of every track.

    Raises:
        RunError: The run has no such scene, or it was never driven; or it names what must be repeated
            (`chatscene.runs.trust.follow`).
    """
    run = runs.open_run(folder, holds="run")
    follow(repeated or Repeated(), egos_of=[run], simulators_of=[run], joining_of=[run])
    record = runs.read_record(run)
    stored = runs.read_episode(run, scene_id)
    row = next(row for row in runs.read_scenes(run) if row["scene_id"] == scene_id)
    settings = runs.settings_of(record)
    _, program = rebuild(run)
    scene = runs.scene_of(row, program)
    simulator = simulator_of(load_generator(record.generator), map_of(record), settings)
    again = simulate(simulator, program, scene, load_ego(record.ego))
    return Replayed(scene_id=scene_id, difference=_difference(stored, again), versions=runs.changed_versions(record))


def map_of(record: runs.RunRecord) -> Path:
    """The map that a run was made on.

    Raises:
        MapError: There is none of that name.
        RunError: It is another file by now.
    """
    path = resolve_map(record.map_name)
    if record.map_digest and digest_of(path) != record.map_digest:
        raise RunError(
            f"the map {record.map_name} is not the file that the run was made on (its SHA-256 differs); put that one "
            f"back, or {_remedy(record)}"
        )
    return path


def rebuild(run: runs.Workspace) -> tuple[Scenario, ScenicProgram]:
    """The scenario and the program of a run, from what was understood and chosen then; the text is not read again.

    The program that lies in the folder is never executed: it is joined again, of snippets of the library, and compared.

    Raises:
        RunError: The run did not come that far, or what it tells was changed.
        Diverged: This version makes another program than the one that was kept.
    """
    record = runs.read_record(run)
    generator = load_generator(record.generator)
    settings = runs.settings_of(record).retrieval
    scenario, choice = runs.read_choice(run)
    try:
        if not isinstance(generator, Retrieved):
            program = generator.write(scenario, settings).program
        elif choice is None:
            raise RunError(f"nothing was chosen in {run.path}: its explanation.json names no snippets")
        else:
            ranges = {row["parameter"]: (row["low"], row["high"]) for row in runs.read_ranges(run) if row["block"] == 0}
            program = generator.join(scenario, choice.snippet_ids, choice.adversary, ranges, settings)
    except SnippetError as error:
        raise Diverged(f"the library has changed since {run.path} was made: {error}; {_remedy(record)}") from error
    if runs.read_programs(run).get(scenario.id) != program.source:
        raise Diverged(
            f"the library has changed since {run.path} was made: the same snippets now make another program; "
            f"{_remedy(record)}"
        )
    return scenario, program


def _remedy(record: runs.RunRecord) -> str:
    return f"install the version of chatscene that run.json names{_since(runs.changed_versions(record))}"


def _since(versions: Mapping[str, tuple[str, str]]) -> str:
    """The versions that changed, to end a sentence with; empty if none did."""
    changed = ", ".join(f"{name} {then} then, {now} now" for name, (then, now) in versions.items())
    return f" ({changed})" if changed else ""


def _difference(stored: Episode, again: Episode | Rejected) -> str:
    """Where two episodes first differ, in words; empty if nowhere."""
    if isinstance(again, Rejected):
        return f"it is now rejected: {again.reason}"
    for old, new in zip(stored.tracks, again.tracks, strict=False):
        if (problem := _track_difference(old, new)) is not None:
            return f"{old.actor}: {problem}"
    if len(stored.tracks) != len(again.tracks):
        return f"{len(stored.tracks)} actors then, {len(again.tracks)} now"
    return "" if stored.events == again.events else "the events differ"


def _track_difference(old: Track, new: Track) -> str | None:
    if (old.actor, old.kind, len(old.x)) != (new.actor, new.kind, len(new.x)):
        return f"{old.kind} for {len(old.x)} steps then, {new.actor}, {new.kind} for {len(new.x)} steps now"
    for name in ("x", "y", "heading", "speed"):
        changed = np.flatnonzero(getattr(old, name) != getattr(new, name))
        if changed.size:
            return f"{name} from step {int(changed[0])} on"
    return None


def free_folder(parent: Path, text: str) -> Path:
    """A folder name made from a sentence that is not taken yet."""
    stem = "-".join(re.findall(r"[a-z0-9]+", text.lower())[:6]) or "run"
    taken = (parent / f"{stem}-{n}" if n > 1 else parent / stem for n in range(1, 10_000))
    return next(folder for folder in taken if not folder.exists())


def silent(_what: str, _done: int, _total: int) -> None:
    """Tell nobody what is done."""
