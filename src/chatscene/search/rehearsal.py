"""Drives of a program that was built, before anybody runs it: where they do not show what was said, it is shifted.

A builder computes by rule when somebody is due, on a road that nobody else is on. What that comes to is seen when
everybody drives. So a few drives are judged; where too few show all that was said, the ranges of what was not said are
shifted or halved, one after the other, until most do, and first those of whom something is missed. Before that and
after it who is too early or too late for the meeting that it belongs to, with the ego or with others, is shifted alone.
What was said stays, and so does a program that shows it.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from functools import lru_cache
from statistics import median

from chatscene.build.build import Built, build
from chatscene.build.coming import speeds_to_try
from chatscene.ego.policy import EgoPolicy, load_ego
from chatscene.errors import ChatSceneError, NotBuilt
from chatscene.interpret.scenario_names import STATED
from chatscene.maps.network import MapContent, map_digest, resolve_map
from chatscene.program.finding import UNTOLD, Late, failures
from chatscene.program.judge import judge
from chatscene.program.sample import drawn_scene, scene_at
from chatscene.program.together import apart
from chatscene.settings import EGO, SimulationSettings
from chatscene.simulate.simulator import Simulator, load_simulator, simulate
from chatscene.terms.route import Route
from chatscene.terms.scene import Rejected, Scene, ScenicProgram
from chatscene.terms.situation import Situation
from chatscene.terms.snippet import ParameterRange

EGOS = (EGO, "idm")
"""Who drives: where none is named, and one that plans nothing. What only one of them shows depends on who drives."""
DRAWN = 7  # drives of each besides that in the middle of all ranges
FRESH = 4  # more of each, of a shift whose drives all show everything: they were what it was found by
SEED = 1  # what their values are drawn by
GLANCED = 2  # drives of each besides that in the middle, which tell whether a program is worth a rehearsal
FIRST = 4  # of these drives, by which a program that helps is told from others
ONE_OFF = 1  # of these drives that may miss something: the program stays as it is
ENOUGH = 0.75  # of these drives that show all that was said
DRIVES = 320, 160  # at most, that are driven of a program and its shifts, and of it with a slow ego
PARTS = (0.0, 0.75), (0.25, 1.0), (0.0, 0.5), (0.5, 1.0)
"""From and to which share of a range a part of it is."""
STEPS: dict[str, tuple[float, ...]] = {"s": (0.5, 1.0, 2.0, 3.0, 4.0), "m": (2.0, 5.0, 10.0, 20.0)}
"""By how much more or less ranges are shifted, by their units: when somebody acts first, then where it is."""
MOMENTS = ("OFFSET", "LEAD_TIME")
"""How the names of parameters end that are by how much somebody is sooner, and no sizes."""
ALONG = "_Y"
"""How the names of parameters end that are where somebody is along the road."""
NEARER = (0.5, 0.25, 2.0)
"""By which factors places are moved, too: a road may be long."""
CUT = 4  # drives, in one of which a fact more may not be come to, since it is over before
HELPS = 0.8  # of what somebody misses its meeting by, that is left at most of a shift that helps
SHARES = (0.15, 0.3)
"""By which share of its middle a range of another unit is shifted: how somebody does it."""


def rehearsed(built: Built, situation: Situation) -> Built:
    """A program whose drives show what was said, as far as what was not said lets them.

    It is driven in the native simulator, by egos that are always the same; so what it comes to depends on the
    situation alone.

    Args:
        built: The program as a builder computes it.
        situation: What was said.

    Returns:
        It itself if all drives but one show all that was said, if it cannot be driven, or if nothing helps; else one
        with other ranges, which are told among what was assumed, or with a slower ego, where its speed was not said.
        What none of its drives shows is told of it.
    """
    try:
        best = _best(built, situation, DRIVES[0])
    except ChatSceneError:  # that it does not run is told by whoever runs it
        return built
    if not best.is_enough and (slowly := _with_slow_ego(built, situation)) is not None:
        with suppress(ChatSceneError):
            slow = _best(slowly, situation, DRIVES[1])
            if slow.share > best.share:
                built, best = slowly, slow
    with suppress(ChatSceneError):
        best = _together(_Stage.of(built, situation, DRIVES[1]), best, built.bound)
    unseen = tuple(best.unseen())
    if best.program is built.program:
        return replace(built, unseen=unseen) if unseen else built
    told = tuple(_told(built.program.parameters, best.program.parameters, best.met))
    return replace(built, program=best.program, assumed=(*built.assumed, *told), unseen=unseen)


def rehearsed_once(built: Built, situation: Situation) -> Built:
    """The same as `rehearsed`; what was driven lately is not driven again."""
    return _rehearsed_there(built, situation, map_digest(resolve_map(built.map)))


@lru_cache(maxsize=8)
def _rehearsed_there(built: Built, situation: Situation, ground: str) -> Built:  # noqa: ARG001 - a map may change
    return rehearsed(built, situation)


def unseen_at_first(built: Built, situation: Situation) -> tuple[str, ...]:
    """What none of a few drives of a program shows, as `rehearsed` tells it; nothing is shifted.

    Raises:
        ChatSceneError: It cannot be driven.
    """
    stage = _Stage.of(built, situation, DRIVES[0])
    stage.drawn = GLANCED
    return tuple(stage.driven(built.program).unseen(few=True))


def _with_slow_ego(built: Built, situation: Situation) -> Built | None:
    """The program with the slowest ego that it may be built with; None if it has that, or cannot be built so."""
    slowest = speeds_to_try(situation)[-1]
    try:
        made = build(replace(situation, map=built.map), name=built.program.scenario_id, at_most=slowest)
    except NotBuilt:
        return None
    return made if made.program.source != built.program.source else None


def _best(built: Built, situation: Situation, drives: int) -> _Tried:
    """Of a program and its shifts, that which misses fewest facts, by so many drives; it itself if none shows more."""
    stage = _Stage.of(built, situation, drives)
    first = stage.driven(built.program)
    best = first
    if first.missed > ONE_OFF:
        best = _shifted_best(stage, _together(stage, first, built.bound), built.bound)
    if best.program is not first.program and not best.count and stage.left > 0:  # by chance, it may be
        stage.drawn += FRESH
        again = replace(stage.driven(best.program), met=best.met)
        best = _shifted_best(stage, again, built.bound) if again.count else again
    return best if best.share > first.share else first


def _shifted_best(stage: _Stage, best: _Tried, bound: Iterable[str]) -> _Tried:
    """The same of a program's shifts, as long as one of them misses less."""
    while best.count:
        start = best
        best = _narrowed(stage, best, bound)
        whose = best.whose()
        for name in sorted(_free(best.program, bound), key=lambda name: not any(f"_{who}_" in name for who in whose)):
            base = best
            for program in _shifted(base.program, name):
                best = stage.better(program, best) or best
        if best is start:
            break
    return best


def _together(stage: _Stage, best: _Tried, bound: Iterable[str]) -> _Tried:
    """A program with those shifted who miss the meeting that they belong to in most drives, as far as that helps."""
    stage.drawn = len(best.missing) // len(EGOS) - 1
    for who in best.apart():
        start = None
        while start is not best and stage.left > 0 and who in best.apart():
            start = best
            for one in _its_own(best.program, bound, who):
                if who not in best.apart():  # since the one before was shifted
                    break
                for by in best.shifts(who, one.unit):
                    program = with_range(best.program, replace(one, low=one.low + by, high=one.high + by))
                    if (nearer := stage.nearer(program, best, who)) is not None:
                        best = replace(nearer, met=best.met | {one.name})
                        break
    return best


def _its_own(program: ScenicProgram, bound: Iterable[str], who: str) -> Iterator[ParameterRange]:
    """The free ranges of somebody's time and place, places first."""
    own = [_named(program, name) for name in _free(program, bound) if f"_{who}_" in name]
    yield from sorted((one for one in own if one.name.endswith((ALONG, *MOMENTS))), key=lambda one: one.unit)


def _narrowed(stage: _Stage, best: _Tried, bound: Iterable[str]) -> _Tried:
    """The program with parts of ranges in which fewer drives miss something, as long as that helps."""
    helps = True
    while best.count and helps:
        found = (stage.better(program, best) for program in _promising(best, bound))
        better = next((one for one in found if one is not None), None)
        helps, best = better is not None, better or best
    return best


def _promising(tried: _Tried, bound: Iterable[str]) -> Iterator[ScenicProgram]:
    """The program with a part of a range in which drives miss less: what misses least is first, then what is wider."""
    parts = list[tuple[float, float, ParameterRange]]()
    for name in _free(tried.program, bound):
        one = _named(tried.program, name)
        for begins, ends in PARTS:
            low, high = (one.low + share * (one.high - one.low) for share in (begins, ends))
            there = [k for k, values in enumerate(tried.values) if low <= values[name] <= high]
            missed = sum(bool(tried.missing[k]) for k in there) / max(len(there), 1)
            if missed < tried.missed / len(tried.missing):
                parts.append((missed, begins - ends, replace(one, low=low, high=high)))
    for *_, part in sorted(parts, key=lambda part: part[:2]):
        yield with_range(tried.program, part)


Missing = tuple[tuple[str, ...], ...]
"""What each drive does not show, a sentence each."""


@dataclass(frozen=True, slots=True, kw_only=True)
class _Drive:
    """What comes of a drive.

    Attributes:
        missing: What it does not show.
        late: Who is too late or too early for the meeting that it belongs to.
        cut: How many facts it did not come to, since it was over before.
    """

    missing: tuple[str, ...] = ()
    late: Mapping[str, Late] = field(default_factory=dict[str, Late])
    cut: int = 0


@dataclass(frozen=True, slots=True, kw_only=True)
class _Tried:
    """A program that was driven.

    Attributes:
        missing: What each drive does not show.
        late: Who is too late or too early for the meeting that it belongs to, in each.
        cut: How many facts each did not come to.
        met: The names of the ranges that were shifted for a meeting.
    """

    program: ScenicProgram
    missing: Missing
    values: tuple[Mapping[str, float], ...]
    late: tuple[Mapping[str, Late], ...] = ()
    cut: tuple[int, ...] = ()
    met: frozenset[str] = frozenset()

    def apart(self) -> list[str]:
        """Those who miss the meeting that they belong to in more than half of the drives."""
        names = sorted({name for late in self.late for name in late})
        return [name for name in names if 2 * sum(name in late for late in self.late) > len(self.late)]

    def shifts(self, who: str, unit: str) -> tuple[float, float]:
        """By how much its time [s] or its place [m] is shifted, and the other way: as much as it is late."""
        found = [late[who] for late in self.late if who in late]
        by = median(one.seconds if unit == "s" else -one.metres for one in found)
        return by, -by

    @property
    def count(self) -> int:
        """How many facts are not shown, of all drives together."""
        return sum(map(len, self.missing))

    @property
    def missed(self) -> int:
        """How many drives do not show something."""
        return sum(map(bool, self.missing))

    @property
    def shown(self) -> int:
        """How many drives show all."""
        return len(self.missing) - self.missed

    def whose(self) -> set[str]:
        """Those of whom something is missed, by ids; their own ranges are shifted first."""
        facts = (told.partition(": ")[0].split(".") for missing in self.missing for told in missing)
        return {fact[1] for fact in facts if len(fact) > 1}

    def unseen(self, *, few: bool = False) -> Iterator[str]:
        """Each fact that no drive shows, or none of the ego that drives where none is named, with what is seen.

        What nobody said that all show is told as well. A drive that does not begin shows nothing, and hides nothing
        that others do not show.

        Args:
            few: Whether the drives of one ego are too few to tell that it is never shown something.
        """
        begun = [missing for missing in self.missing if not any(map(_is_reason, missing))]
        if not begun:
            yield f"none of {len(self.missing)} drives begins: {self.missing[0][0]}"
            return
        never = _in_each(begun)
        for fact, instead in never.items():
            if fact.startswith("unasked."):
                yield f"all {len(begun)} drives show something that was not said: {instead}"
            else:
                yield f"none of {len(begun)} drives shows {fact}: {instead}"
        own = [] if few else [missing for missing in self.missing[:: len(EGOS)] if not any(map(_is_reason, missing))]
        for fact, instead in _in_each(own).items():
            if fact not in never and not fact.startswith("unasked."):
                yield f"none of {len(own)} drives by {EGO} shows {fact}: {instead}"

    @property
    def share(self) -> float:
        """The share of the drives that show all."""
        return self.shown / len(self.missing)

    @property
    def is_enough(self) -> bool:
        """Whether enough drives show all."""
        return self.share >= ENOUGH


@dataclass(slots=True, kw_only=True)
class _Stage:
    """Where and by whom a program is driven, what it is to show, how many drives are left, and how many are drawn."""

    situation: Situation
    simulator: Simulator
    route: Route
    left: int
    drawn: int = DRAWN

    @classmethod
    def of(cls, built: Built, situation: Situation, drives: int) -> _Stage:
        simulator = _simulator(MapContent.of(resolve_map(built.map)))
        route = simulator.route(built.program, 0)
        return cls(situation=situation, simulator=simulator, route=route, left=drives)

    def driven(self, program: ScenicProgram) -> _Tried:
        """What all drives of a program show.

        Raises:
            ChatSceneError: It cannot be driven.
        """
        drives = self._drives(program)
        return self._tried(program, drives, [self._missing(program, *one) for one in drives], frozenset())

    def nearer(self, program: ScenicProgram, than: _Tried, who: str) -> _Tried | None:
        """What drives show of a program in which somebody is nearer to its meeting; None of one that shows less.

        The first drives tell whether it helps.
        """
        drives, found = self._drives(program), list[_Drive]()
        for k, one in enumerate(drives):
            if not self.left:
                return None
            try:
                found.append(self._missing(program, *one))
            except ChatSceneError:
                return None
            missed = sum(bool(drive.missing) for drive in found)
            late, before = (_seconds(who, row) for row in ([drive.late for drive in found], than.late[: k + 1]))
            if missed > max(than.missed, ONE_OFF) or (len(found) == FIRST and late >= before):
                return None
        tried = self._tried(program, drives, found, than.met)
        helps = _seconds(who, tried.late) < HELPS * _seconds(who, than.late)
        return tried if helps else None

    def _tried(
        self,
        program: ScenicProgram,
        drives: Sequence[tuple[Scene, EgoPolicy]],
        found: Sequence[_Drive],
        met: frozenset[str],
    ) -> _Tried:
        return _Tried(
            program=program,
            missing=tuple(one.missing for one in found),
            values=tuple(scene.values for scene, _ in drives),
            late=tuple(one.late for one in found),
            cut=tuple(one.cut for one in found),
            met=met,
        )

    def better(self, program: ScenicProgram, than: _Tried) -> _Tried | None:
        """What drives of a program show; None if it does not run, misses as much as another, or none are left.

        The drives that miss something of the other come first: what does not help there is not driven any further.
        """
        drives = self._drives(program)
        order = sorted(range(len(drives)), key=lambda k: not than.missing[k])
        found, before = dict[int, _Drive](), 0
        for k in order if than.count else ():
            if not self.left:
                return None
            try:
                found[k] = self._missing(program, *drives[k])
            except ChatSceneError:
                return None
            before += len(than.missing[k])
            now = sum(len(drive.missing) for drive in found.values())
            cut = sum(drive.cut - than.cut[n] for n, drive in found.items())
            if CUT * cut > len(drives) or now >= than.count or (len(found) == FIRST and now >= before):
                return None
        if not found:
            return None
        return self._tried(program, drives, [found[k] for k in range(len(drives))], than.met)

    def _drives(self, program: ScenicProgram) -> list[tuple[Scene, EgoPolicy]]:
        called = replace(program, scenario_id=STATED)  # values are drawn by the name, which is not to count
        drawn = (drawn_scene(called, number, seed=SEED) for number in range(self.drawn))
        scenes = (scene_at(called, 0, 0.5, name="middle"), *drawn)
        return [(scene, load_ego(ego)) for scene in scenes for ego in EGOS]

    def _missing(self, program: ScenicProgram, scene: Scene, ego: EgoPolicy) -> _Drive:
        self.left -= 1
        episode = simulate(self.simulator, program, scene, ego)
        if isinstance(episode, Rejected):
            return _Drive(missing=(episode.reason,))
        findings = judge(self.situation, episode, self.route)
        ends = self.situation.contact is not None and self.situation.contact.happens  # by what was said
        cut = 0 if ends else sum(one.shown is None and one.told != UNTOLD for one in findings)
        passed = {one.path.rpartition(".")[2]: one.late for one in findings if one.late is not None}
        return _Drive(missing=failures(findings), late=passed | apart(self.situation, episode), cut=cut)


def _seconds(who: str, drives: Iterable[Mapping[str, Late]]) -> float:
    """By how many seconds [s] somebody misses the meeting that it belongs to, in all of some drives together."""
    return sum(abs(late[who].seconds) for late in drives if who in late)


def _in_each(drives: Sequence[tuple[str, ...]]) -> dict[str, str]:
    """What each of some drives misses, by its path, with what is seen in the first."""
    first, *others = drives or [()]
    told = (one.partition(": ") for one in first)
    return {
        fact: instead
        for fact, _, instead in told
        if all(any(one.startswith(f"{fact}: ") for one in missing) for missing in others)
    }


def _is_reason(missed: str) -> bool:
    """Whether it is why a drive does not begin, and no fact, which begins with its path."""
    path, colon, _ = missed.partition(": ")
    return not colon or " " in path


@lru_cache(maxsize=4)
def _simulator(of: MapContent) -> Simulator:
    return load_simulator(of.path, SimulationSettings(simulator="native"))


def _free(program: ScenicProgram, bound: Iterable[str]) -> list[str]:
    """The ranges of what was not said, times first, then places, then the rest."""
    free = [one for one in program.parameters if one.name not in bound and one.high > one.low]
    order = [*STEPS]
    free.sort(key=lambda one: (order.index(one.unit) if one.unit in order else len(order), "OFFSET" not in one.name))
    return [one.name for one in free]


def _named(program: ScenicProgram, name: str) -> ParameterRange:
    return next(one for one in program.parameters if one.name == name)


def _shifted(program: ScenicProgram, name: str) -> Iterator[ScenicProgram]:
    """The program with one range shifted or halved."""
    one = _named(program, name)
    for low, high in _moved(one):
        yield with_range(program, replace(one, low=low, high=high))


def _moved(one: ParameterRange) -> Iterator[tuple[float, float]]:
    """Other bounds of a range: more and less by steps, its lower and its upper half."""
    middle = 0.5 * (one.low + one.high)
    steps = STEPS.get(one.unit) or tuple(share * abs(middle) for share in SHARES)
    for by in (way * step for step in steps for way in (1.0, -1.0)):
        low, high = one.low + by, one.high + by
        if low > 0.0 or one.low <= 0.0 or one.name.endswith(MOMENTS):  # what is a size stays one
            yield low, high
    if one.unit == "m" and one.low > 0.0:
        yield from ((factor * one.low, factor * one.high) for factor in NEARER)
    yield one.low, middle
    yield middle, one.high


def with_range(program: ScenicProgram, changed: ParameterRange) -> ScenicProgram:
    """A program in which a parameter has another range, in its text as well."""
    was = _named(program, changed.name)
    now = replace(changed, low=float(f"{changed.low:.6g}"), high=float(f"{changed.high:.6g}"))
    source = program.source.replace(declared(was), declared(now), 1)
    return replace(program, source=source, parameters=tuple(now if one is was else one for one in program.parameters))


def declared(one: ParameterRange) -> str:
    """The line of a program that declares a parameter."""
    return f"param {one.name} = Range({one.low}, {one.high})"


def _told(before: Iterable[ParameterRange], after: Iterable[ParameterRange], met: frozenset[str]) -> Iterator[str]:
    """Which ranges are others, and why, for a person."""
    for was, now in zip(before, after, strict=True):
        if was != now:
            unit = "" if was.unit == "1" else f" {was.unit}"
            name = f"{was.name} ({was.meaning})" if was.meaning else was.name
            why = (
                "so that it is there when others meet"
                if now.name in met
                else "since drives show what was said only then"
            )
            yield (f"{name} is {now.low:.3g} to {now.high:.3g}{unit}, not {was.low:.3g} to {was.high:.3g}{unit}, {why}")
