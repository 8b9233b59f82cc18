"""Drives of a program that was built, before anybody runs it: where they do not show what was said, it is shifted.

A builder computes by rule when somebody is due, on a road that nobody else is on. What that comes to is seen when
everybody drives. So a few drives are judged; where too few show all that was said, the ranges of what was not said are
shifted or halved, one after the other, until most do. What was said stays, and so does a program that shows it.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import lru_cache
from itertools import islice

from chatscene.build.build import Built, build
from chatscene.build.coming import speeds_to_try
from chatscene.ego.policy import EgoPolicy, load_ego
from chatscene.errors import ChatSceneError, NotBuilt
from chatscene.maps.network import MapContent, resolve_map
from chatscene.program.judge import failures, judge
from chatscene.program.sample import drawn_scene, scene_at
from chatscene.settings import EGO, SimulationSettings
from chatscene.simulate.simulator import Simulator, load_simulator, simulate
from chatscene.terms.route import Route
from chatscene.terms.scene import Rejected, ScenicProgram
from chatscene.terms.situation import Situation
from chatscene.terms.snippet import ParameterRange

DRAWN = 8  # drives besides that in the middle of all ranges
SEED = 1  # what their values are drawn by
FIRST = 3  # of these drives, by which a program that helps is told from others
ENOUGH = 7  # of these drives that show all that was said
ROUNDS = 2  # in which every range is tried
MOST = 100  # of programs that are tried
STEPS: dict[str, tuple[float, ...]] = {"s": (0.5, 1.0, 2.0, 3.0, 4.0), "m": (2.0, 5.0, 10.0, 20.0)}
"""By how much more or less ranges are shifted, by their units: when somebody acts first, then where it is."""
NEARER = (0.5, 0.25, 2.0)
"""By which factors places are moved, too: a road may be long."""
SHARES = (0.15, 0.3)
"""By which share of its middle a range of another unit is shifted: how somebody does it."""


def rehearsed(built: Built, situation: Situation) -> Built:
    """A program whose drives show what was said, as far as what was not said lets them.

    It is driven by the ego that drives where none is named, in the native simulator; so what it comes to depends on
    the situation alone.

    Args:
        built: The program as a builder computes it.
        situation: What was said.

    Returns:
        It itself if most drives show all that was said, if it cannot be driven, or if nothing helps; else one with
        other ranges, which are told among what was assumed, or with a slower ego, where its speed was not said.
    """
    try:
        shown = _shown(built, situation)
    except ChatSceneError:  # that it does not run is told by whoever runs it
        return built
    if shown is None and (slowly := _with_slow_ego(built, situation)) is not None:
        with suppress(ChatSceneError):
            shown = _shown(slowly, situation)
    return shown or built


def _with_slow_ego(built: Built, situation: Situation) -> Built | None:
    """The program with the slowest ego that it may be built with; None if it has that, or cannot be built so."""
    slowest = speeds_to_try(situation)[-1]
    try:
        made = build(replace(situation, map=built.map), name=built.program.scenario_id, at_most=slowest)
    except NotBuilt:
        return None
    return made if made.program.source != built.program.source else None


def _shown(built: Built, situation: Situation) -> Built | None:
    """A program of whose drives enough show all, with other ranges if need be; None if none does.

    Raises:
        ChatSceneError: It cannot be driven.
    """
    stage = _Stage.of(built, situation)
    first = stage.missing(built.program)
    if _is_enough(first):
        return built
    best = _Tried(program=built.program, missing=first)
    left = MOST
    for _ in range(ROUNDS):
        start = best
        for program in islice(_shifted(start.program, built.bound), left):
            left -= 1
            best = stage.better(program, best) or best
            if not best.count:
                break
        if best is start or not best.count:
            break
    if not _is_enough(best.missing):
        return None
    told = tuple(_told(built.program.parameters, best.program.parameters))
    return replace(built, program=best.program, assumed=(*built.assumed, *told))


Missing = tuple[tuple[str, ...], ...]
"""What each drive does not show, a sentence each."""


def _is_enough(missing: Missing) -> bool:
    return sum(not one for one in missing) >= ENOUGH


@dataclass(frozen=True, slots=True, kw_only=True)
class _Tried:
    program: ScenicProgram
    missing: Missing

    @property
    def count(self) -> int:
        """How many facts are not shown, of all drives together."""
        return self.first(len(self.missing))

    def first(self, drives: int) -> int:
        """How many are not shown in the first drives; one more than none, where all are."""
        return max(sum(map(len, self.missing[:drives])), drives < len(self.missing))


@dataclass(frozen=True, slots=True, kw_only=True)
class _Stage:
    """Where and by whom a program is driven, and what it is to show."""

    situation: Situation
    simulator: Simulator
    route: Route
    ego: EgoPolicy

    @classmethod
    def of(cls, built: Built, situation: Situation) -> _Stage:
        simulator = _simulator(MapContent.of(resolve_map(built.map)))
        return cls(situation=situation, simulator=simulator, route=simulator.route(built.program, 0), ego=load_ego(EGO))

    def missing(self, program: ScenicProgram) -> Missing:
        return tuple(self._missing(program))

    def better(self, program: ScenicProgram, than: _Tried) -> _Tried | None:
        """What drives of a program show; None if it does not run, or misses as much as another, or more.

        After the first drives as well: what does not help there is not driven any further.
        """
        found = list[tuple[str, ...]]()
        try:
            for one in self._missing(program):
                found.append(one)
                tried = _Tried(program=program, missing=tuple(found))
                if tried.count >= than.count or (len(found) == FIRST and tried.count >= than.first(FIRST)):
                    return None
        except ChatSceneError:
            return None
        return _Tried(program=program, missing=tuple(found))

    def _missing(self, program: ScenicProgram) -> Iterator[tuple[str, ...]]:
        drawn = (drawn_scene(program, number, seed=SEED) for number in range(DRAWN))
        for scene in (scene_at(program, 0, 0.5, name="middle"), *drawn):
            episode = simulate(self.simulator, program, scene, self.ego)
            if isinstance(episode, Rejected):
                yield (episode.reason,)
            else:
                yield failures(judge(self.situation, episode, self.route))


@lru_cache(maxsize=4)
def _simulator(of: MapContent) -> Simulator:
    return load_simulator(of.path, SimulationSettings(simulator="native"))


def _shifted(program: ScenicProgram, bound: Iterable[str]) -> Iterator[ScenicProgram]:
    """The program with one range of what was not said shifted or halved, times first, then places, then the rest."""
    free = [one for one in program.parameters if one.name not in bound and one.high > one.low]
    order = [*STEPS]
    free.sort(key=lambda one: (order.index(one.unit) if one.unit in order else len(order), "OFFSET" not in one.name))
    for one in free:
        for low, high in _moved(one):
            yield with_range(program, replace(one, low=low, high=high))


def _moved(one: ParameterRange) -> Iterator[tuple[float, float]]:
    """Other bounds of a range: more and less by steps, its lower and its upper half."""
    middle = 0.5 * (one.low + one.high)
    steps = STEPS.get(one.unit) or tuple(share * abs(middle) for share in SHARES)
    for by in (way * step for step in steps for way in (1.0, -1.0)):
        low, high = one.low + by, one.high + by
        if low > 0.0 or one.low <= 0.0:  # what is a size stays one
            yield low, high
    if one.unit == "m" and one.low > 0.0:
        yield from ((factor * one.low, factor * one.high) for factor in NEARER)
    yield one.low, middle
    yield middle, one.high


def with_range(program: ScenicProgram, changed: ParameterRange) -> ScenicProgram:
    """A program in which a parameter has another range, in its text as well."""
    was = next(one for one in program.parameters if one.name == changed.name)
    now = replace(changed, low=float(f"{changed.low:.6g}"), high=float(f"{changed.high:.6g}"))
    source = program.source.replace(declared(was), declared(now), 1)
    return replace(program, source=source, parameters=tuple(now if one is was else one for one in program.parameters))


def declared(one: ParameterRange) -> str:
    """The line of a program that declares a parameter."""
    return f"param {one.name} = Range({one.low}, {one.high})"


def _told(before: Iterable[ParameterRange], after: Iterable[ParameterRange]) -> Iterator[str]:
    """Which ranges are others, for a person."""
    for was, now in zip(before, after, strict=True):
        if was != now:
            unit = "" if was.unit == "1" else f" {was.unit}"
            yield (
                f"{was.name} is {now.low:g} to {now.high:g}{unit}, not {was.low:g} to {was.high:g}{unit}, since drives"
                " show what was said only then"
            )
