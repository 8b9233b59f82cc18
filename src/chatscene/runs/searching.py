"""Search with scenarios into their run folders: prepare each, search its routes block by block, fold the blocks.

A block needs what came of the blocks before it on the same route, and nothing else; so routes run side by side, and
any number of workers gives the same blocks.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial
from itertools import groupby
from typing import Any

from chatscene.ego.policy import EgoPolicy, load_ego
from chatscene.errors import MapError, MeansSomethingElse, NothingFits
from chatscene.maps.carried import CarriedMap
from chatscene.maps.drawing import routes_drawing
from chatscene.maps.loading import load_roads
from chatscene.program.check import PROBED
from chatscene.runs.asked import scenario_of
from chatscene.runs.blocks import finish, write_block
from chatscene.runs.drawing import write_drawing
from chatscene.runs.executor import Workers
from chatscene.runs.explanation import write_choice
from chatscene.runs.parallel import spread
from chatscene.runs.progress import Progress, Slowly, silent
from chatscene.runs.rebuild import map_of
from chatscene.runs.record import RunRecord, Status, settings_of
from chatscene.runs.rows import Part, SceneRow
from chatscene.runs.tables import route_id
from chatscene.runs.workspace import Workspace, update
from chatscene.search.climb import climb, simulator_of
from chatscene.search.explore import Block, outcomes
from chatscene.search.generator import Generator, Written, load_generator
from chatscene.search.sampler import looks_back
from chatscene.search.select import Candidate, select
from chatscene.settings import SearchSettings, Settings
from chatscene.simulate.simulator import Simulator, routes_of, telling
from chatscene.terms.criticality import Happening
from chatscene.terms.outcome import Outcome
from chatscene.terms.scenario import Said, Scenario
from chatscene.terms.scene import ScenicProgram

Done = list[list[Outcome]]  # of a route, what came of each of its blocks
Keep = Callable[[Scenario, Written | None], None]  # what was read and, if it came that far, chosen


@dataclass(frozen=True, slots=True, kw_only=True)
class Common:
    """What searches have in common, and every worker needs to know."""

    generator: str
    map: CarriedMap
    ego: str
    settings: Settings

    @classmethod
    def of(cls, record: RunRecord) -> Common:
        """That of a run and all that are like it but for what is said."""
        return cls(
            generator=record.generator,
            map=CarriedMap.of(map_of(record)),
            ego=record.ego,
            settings=settings_of(record),
        )


@dataclass(frozen=True, slots=True, kw_only=True)
class Prepared:
    """What is searched with."""

    scenario: Scenario
    written: Written
    routes: tuple[int, ...]
    drawing: dict[str, Any]


@dataclass(slots=True, kw_only=True)
class Search:
    """One scenario to search with, into its run folder.

    Attributes:
        done: For each scenario and route, what came of each block that is done (`chatscene.runs.resume`).
        prepared: What is searched with; None until somebody prepared it.
    """

    run: Workspace
    record: RunRecord
    settings: SearchSettings
    done: Mapping[tuple[str, int], Done]
    prepared: Prepared | None = None
    refused: str = ""
    _history: dict[int, Done] = field(default_factory=dict[int, Done])

    def tasks(self, number: int) -> list[_Task]:
        """What comes next, of this search as number so and so of several; the blocks are folded if nothing does."""
        if self.prepared is None:
            return [_Prepare(number, self.record)]
        id_ = self.prepared.scenario.id
        self._history = {route: list(self.done.get((id_, route), ())) for route in self.prepared.routes}
        left = [task for route in sorted(self._history) for task in self._next(number, route)]
        if not left:
            self._fold()
        return left

    def begin(self, came: _Came) -> list[_Task]:
        """Take in how its preparation ended; what comes next."""
        for choice in came.choices:
            write_choice(self.run, *choice)
        if came.prepared is None:
            self.refused = came.refused
            update(self.run, status=Status.REFUSED, reason=came.refused)
            return []
        self.prepare(came.prepared)
        return self.tasks(came.number)

    def prepare(self, prepared: Prepared) -> None:
        """Take in what is searched with."""
        self.prepared = prepared
        write_drawing(self.run, prepared.drawing)

    def keep(self, number: int, block: Block) -> list[_Task]:
        """Keep a block; what comes next."""
        write_block(self.run, block)
        self._history[block.route].append(outcomes(block) if looks_back(self.settings.sampler) else [])
        if self.is_over:
            self._fold()
        return self._next(number, block.route)

    @property
    def is_over(self) -> bool:
        """Whether nothing is left to do."""
        return bool(self.refused) or (self.prepared is not None and self.kept == self.expected)

    @property
    def kept(self) -> int:
        """How many blocks are kept."""
        return sum(map(len, self._history.values()))

    @property
    def scenes_kept(self) -> int:
        """How many scenes they hold."""
        return sum(min(len(done) * self.settings.block, self.settings.scenes) for done in self._history.values())

    @property
    def expected(self) -> int:
        """How many there have to be."""
        return len(self._history) * self._per_route

    @property
    def _per_route(self) -> int:
        return -(-self.settings.scenes // self.settings.block)

    def _next(self, number: int, route: int) -> list[_Task]:
        assert self.prepared is not None
        done = self._history[route]
        if len(done) == self._per_route:
            return []
        return [_Explore(number, self.prepared.written.program, self.prepared.scenario.said, route, done)]

    def _fold(self) -> None:
        assert self.prepared is not None
        expected = [(self.prepared.scenario.id, route, n) for route in self._history for n in range(self._per_route)]
        finish(self.run, selected=partial(selected, settings=self.settings), expected=expected)


@dataclass(frozen=True, slots=True)
class _Prepare:
    number: int
    record: RunRecord


@dataclass(frozen=True, slots=True)
class _Explore:
    number: int
    program: ScenicProgram
    said: Said
    route: int
    done: Done


@dataclass(frozen=True, slots=True)
class _Came:
    """How a preparation ended: what was read and chosen, and what is searched with, or why nothing is."""

    number: int
    choices: list[tuple[Scenario, Written | None]]
    prepared: Prepared | None
    refused: str


_Task = _Prepare | _Explore
_Result = _Came | tuple[int, Block]


class Desk:
    """Prepares scenarios and searches blocks, one after another, and keeps what was compiled and loaded."""

    def __init__(self, common: Common) -> None:
        self._common = common
        self._ego: EgoPolicy = load_ego(common.ego)
        self._generator: Generator = load_generator(common.generator)
        self._map = common.map.file()
        self._simulator: Simulator = simulator_of(self._generator, self._map, common.settings)

    def prepare(self, record: RunRecord, keep: Keep, progress: Progress = silent) -> Prepared:
        """Steps 2 to 4 for what a run asks.

        Raises:
            NothingFits: The library cannot serve the sentence.
            MeansSomethingElse: Its scenes do not show what was read.
            MapError: The map has no such place.
        """
        settings, generator, simulator = self._common.settings, self._generator, self._simulator
        progress("understanding what was said", 0, 0)
        scenario = scenario_of(record, generator)
        keep(scenario, None)
        written = generator.write(scenario, settings.retrieval)
        keep(scenario, written)

        if scenario.slots.site is not None:
            progress(f"using the map {self._map.stem!r}, which has: {scenario.slots.site}", 0, 0)
        checking = "checking that drives show what was read"
        progress(checking, 0, 0)
        with telling(Slowly(lambda driven: progress(checking, driven, -(-driven // PROBED) * PROBED))):
            written, _ = climb(
                generator, scenario, written, settings=settings.retrieval, simulator=simulator, ego=self._ego
            )
        keep(scenario, written)

        routes = routes_of(simulator, written.program, settings.search.routes)
        if len(routes) < settings.search.routes:
            asked = settings.search.routes
            progress(f"map {record.map_name!r} has {len(routes)} of the {asked} routes asked for", 0, 0)
        named = {f"{scenario.id}/{route_id(number)}": route for number, route in routes.items() if route}
        drawing = routes_drawing(load_roads(self._map), named)
        return Prepared(scenario=scenario, written=written, routes=tuple(routes), drawing=drawing)

    def block(self, program: ScenicProgram, said: Said, route: int, done: Done) -> Block:
        """Steps 5 and 6: the next block of a route."""
        explored = self._generator.explore(
            program,
            said,
            route,
            simulator=self._simulator,
            ego=self._ego,
            settings=self._common.settings.search,
            done=done,
        )
        return next(explored)

    def __call__(self, task: _Task) -> _Result:
        """A task of one of several searches."""
        if isinstance(task, _Explore):
            return task.number, self.block(task.program, task.said, task.route, task.done)
        choices: list[tuple[Scenario, Written | None]] = []

        def keep(scenario: Scenario, written: Written | None) -> None:
            choices.append((scenario, written))

        try:
            prepared = self.prepare(task.record, keep)
        except (NothingFits, MeansSomethingElse, MapError) as error:
            return _Came(task.number, choices[-1:], None, str(error))
        return _Came(task.number, choices[-1:], prepared, "")


def search_all(searches: Sequence[Search], *, workers: Workers) -> Iterator[Search]:
    """Search with scenarios, each as far as it is not done yet, and fold what is done.

    Yields:
        A search, after each step of it: it is prepared or refused, or a block is kept.

    Raises:
        RunError: Workers are lost again and again, or a folder cannot be written.
        ChatSceneError: Whatever a block raised.
    """

    def take_in(result: _Result) -> list[_Task]:
        if isinstance(result, _Came):
            return searches[result.number].begin(result)
        return searches[result[0]].keep(*result)

    tasks = [task for number, one in enumerate(searches) for task in one.tasks(number)]
    if not tasks:
        return
    common = Common.of(searches[0].record)
    for result in spread(Desk, common, tasks, workers=workers, then=take_in):
        yield searches[result.number if isinstance(result, _Came) else result[0]]


# Step 7 of 9 on what lies in a run folder


def selected(parts: Iterable[Part], settings: SearchSettings) -> dict[str, bool]:
    """Step 7 for every scenario and route of blocks in order: scene id to whether it is a fill-in."""
    return {
        s.scene_id: s.fill_in
        for _, of_route in groupby(parts, key=lambda part: (part.scenario_id, part.route))
        for s in select(
            (_candidate(scene) for part in of_route for scene in part.scenes if scene.reason is None),
            count=settings.keep,
            selection=settings.selection,
            avoidable_only=settings.avoidable_only,
        )
    }


def _candidate(scene: SceneRow) -> Candidate:
    return Candidate(
        scene_id=scene.scene_id,
        collided=bool(scene.collision),
        shown=not scene.meaning_failures,
        avoidable=scene.avoidable,
        overall_score=scene.metrics["overall_score"],
        crash_type=scene.crash_type,
        waits=scene.waits,
        happened=scene.happened != Happening.NOTHING,
        near=scene.gap_in_time,
        cut=scene.cut,
        touch=scene.touch,
        distance=scene.criticality.get("distance"),
    )
