"""What a crash needed, and what would have avoided it: found by driving the scene otherwise, again and again.

Nothing here is a formula. A thing is left out, a parameter is set back, or the ego drives otherwise, the scene is
simulated, and what comes of it is compared with the crash. Decision 0074 says what was chosen, and why.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace

from chatscene.ego.asking import begin, decide
from chatscene.ego.observation import SPEED_AT, Observation
from chatscene.ego.policy import PEDALS, EgoPolicy, observation_of, pedals_of
from chatscene.errors import ProgramError
from chatscene.measure.avoidability import crashes_braking_from, risk_step
from chatscene.measure.instead import Driver, drive_instead
from chatscene.measure.minimal import minimal
from chatscene.program.without import Placing, placings, without
from chatscene.simulate.boxes import least_gap
from chatscene.simulate.simulator import Simulator, simulate
from chatscene.simulate.watchdog import time_limit
from chatscene.terms.actors import LIMITS, Limits, named
from chatscene.terms.braking import STANDING
from chatscene.terms.braking import Braking as Foot
from chatscene.terms.episode import Episode, Event, Track
from chatscene.terms.polyline import Polyline
from chatscene.terms.scene import CAR, Rejected, Scene, ScenicProgram

FINENESS = 0.1  # [m/s], of how much slower the ego is tried
LEAST_SHARE = 0.5  # of its highest speed; to go at less than half is no small change
BEYOND = 5  # how many larger changes have to avoid it as well, since nobody keeps to a moment or a speed so exactly
COMFORTABLE = 2.5  # [m/s²] with which an ego that is too fast is slowed down to a speed it keeps to
BRAKES = 0.5  # [m/s²] of deceleration from which an ego is said to brake; it coasts with less
NEAR = 0.1  # [m], below which a gap is said to be less than that
MOVED = 1e-6  # [m], of where somebody stands at first


@dataclass(slots=True, kw_only=True)
class Trial:
    """A scene that crashed, to be driven otherwise.

    Attributes:
        program: What is driven.
        scene: Its scene.
        ego: Who drove.
        simulator: Where.
        episode: How it crashed.
        route: The ego's.
        drives: How often it was driven otherwise so far.
    """

    program: ScenicProgram
    scene: Scene
    ego: EgoPolicy
    simulator: Simulator
    episode: Episode
    route: Polyline
    drives: int = field(default=0)

    @property
    def crash(self) -> Event:
        """The collision that is asked about."""
        assert self.episode.collision is not None
        return self.episode.collision

    @property
    def struck(self) -> Track:
        """Whom the ego collided with."""
        return next(track for track in self.episode.tracks if track.actor == self.crash.other)

    @property
    def risk(self) -> int | None:
        """The step at which whom the ego collided with became a risk; None if it never was one that could be seen."""
        return risk_step(self.episode, self.route, occlusion=self.simulator.identity.occlusion)

    def drive(self, program: ScenicProgram | None = None, values: Mapping[str, float] | None = None) -> Came:
        """Drive it with another program or other values."""
        self.drives += 1
        scene = self.scene if values is None else replace(self.scene, values=dict(values))
        try:
            return _came(self, simulate(self.simulator, program or self.program, scene, self.ego))
        except ProgramError as error:
            return Came(crashed=False, rejected=str(error))

    def instead(self, driver: Driver, pedals: str, not_over_before: int, brakes: Foot | None = None) -> bool:
        """Whether another driver avoids every collision: neither crashes nor is still on the way there at the end.

        Args:
            driver: Who drives.
            pedals: Those of the driver.
            not_over_before: The step until which standing does not end the drive.
            brakes: All that the driver does, if that is to brake.
        """
        self.drives += 1
        with time_limit(f"scene {self.scene.id!r}, driven otherwise"):
            ended = drive_instead(
                driver,
                self.ego,
                self.program,
                self.scene,
                self.simulator,
                pedals=pedals,
                not_over_before=not_over_before,
                dt=self.episode.dt,
                braking=brakes,
            )
        ego = self.episode.ego_track
        where, *_ = self.route.project(float(ego.x[self.crash.step]), float(ego.y[self.crash.step]))
        return not ended.crashed and (ended.along > where or ended.speed < 0.5)


@dataclass(frozen=True, slots=True, kw_only=True)
class Came:
    """What came of a drive.

    Attributes:
        crashed: Whether the ego collided with the same one first.
        other: With whom else it collided first; empty if with nobody else.
        rejected: Why the scene could not be driven; empty if it could.
        gap: How near the ego came to the one it had collided with [m]; None if that one was not there.
        episode: The drive; None if it was rejected.
    """

    crashed: bool
    other: str = ""
    rejected: str = ""
    gap: float | None = None
    episode: Episode | None = None

    @property
    def harmless(self) -> bool:
        """Whether it was driven and nobody was hit."""
        return not (self.crashed or self.other or self.rejected)


@dataclass(frozen=True, slots=True, kw_only=True)
class Thing:
    """Whom or what the program places in one statement, beside the ego and the one that it collided with.

    Attributes:
        actors: Their names.
        kinds: Their kinds, in the same order.
        needed: Whether the crash needs them; None if nobody can tell.
        why: What came without them where they are needed, and why nobody can tell where not.
    """

    actors: tuple[str, ...]
    kinds: tuple[str, ...]
    needed: bool | None
    why: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class NeededValue:
    """A parameter that the crash needs.

    Attributes:
        name: Which.
        value: Its value in the scene, in its unit.
        back: What it is set back to.
        came: What comes if it is set back as well, beside those that are not needed.
    """

    name: str
    value: float
    back: float
    came: Came


@dataclass(frozen=True, slots=True, kw_only=True)
class Braking:
    """The latest braking that avoids the crash.

    Attributes:
        step: When it begins.
        own: When the ego itself began to brake last; None if it did not once the crash could be seen coming.
        let_go: When it ceased to; None if it braked until the contact, or did not.
        deceleration: With how much [m/s²].
    """

    step: int
    own: int | None
    deceleration: float
    let_go: int | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Slower:
    """The highest speed to keep to that avoids the crash.

    Attributes:
        limit: The speed [m/s].
        highest: The highest that the ego drove before the contact [m/s].
    """

    limit: float
    highest: float


def last_moment(trial: Trial) -> int | None:
    """The last step at which a careful driver's braking, begun there, avoids the crash; None if at none it does."""

    def avoided(step: int) -> bool:
        trial.drives += 1
        with time_limit(f"scene {trial.scene.id!r}, driven otherwise"):
            return not crashes_braking_from(
                step,
                trial.ego,
                trial.program,
                trial.scene,
                trial.simulator,
                trial.episode.dt,
                not_over_before=trial.crash.step,
            )

    return next((step for step in range(trial.crash.step - 1, -1, -1) if avoided(step)), None)


def things_needed(trial: Trial) -> tuple[Thing, ...]:
    """Which of the things beside the ego and the one it collided with the crash needs, in the program's order.

    Of those that can be left out, the needed ones together with nobody else still crash; without any single one of
    them the ego does not collide with that one.
    """
    free: dict[Placing, tuple[Track, ...]] = {}
    doubts: list[str] = []
    for placing in placings(trial.program):
        if placing.asked_for:
            continue
        gone, doubt = _gone(trial, trial.drive(without(trial.program, [placing])))
        if doubt:
            doubts.append(doubt)
        elif gone and trial.struck not in gone:
            free[placing] = gone
    known: dict[frozenset[Placing], Came] = {}

    def came(kept: frozenset[Placing]) -> Came:
        if kept not in known:
            known[kept] = trial.drive(without(trial.program, [one for one in free if one not in kept]))
        return known[kept]

    needed = frozenset(minimal(list(free), lambda kept: came(kept).crashed))
    things = [
        Thing(
            actors=tuple(track.actor for track in gone),
            kinds=tuple(track.kind for track in gone),
            needed=placing in needed,
            why=in_words(came(needed - {placing})) if placing in needed else "",
        )
        for placing, gone in free.items()
    ]
    listed = {trial.struck.actor, *(actor for thing in things for actor in thing.actors)}
    why = "; ".join(doubts) or "the rest of the program asks for it"
    things += [
        Thing(actors=(track.actor,), kinds=(track.kind,), needed=None, why=why)
        for track in trial.episode.tracks[1:]
        if track.actor not in listed
    ]
    return tuple(things)


def values_needed(trial: Trial, back: Mapping[str, float]) -> tuple[NeededValue, ...]:
    """Which values the crash needs, out of those that are others in a scene without a crash.

    With those values, and every other parameter set back, the ego still collides with the same one; with any single
    one of them set back as well, it does not.

    Args:
        trial: The scene.
        back: What each parameter is set back to; with all set back there is no such crash.
    """
    mine = trial.scene.values
    known: dict[frozenset[str], Came] = {}

    def came(kept: frozenset[str]) -> Came:
        if kept not in known:
            known[kept] = trial.drive(values={name: mine[name] if name in kept else back[name] for name in mine})
        return known[kept]

    differing = [name for name in mine if mine[name] != back[name]]
    needed = frozenset(minimal(differing, lambda kept: came(kept).crashed))
    return tuple(
        NeededValue(name=name, value=mine[name], back=back[name], came=came(needed - {name}))
        for name in differing
        if name in needed
    )


def latest_braking(trial: Trial) -> Braking | None:
    """The latest step from which the ego, braking as hard as it can, collides with nobody; None if there is none.

    So it must if it begins up to `BEYOND` steps earlier.
    """

    def avoided(step: int) -> bool:
        over, dt = max(step, trial.crash.step), trial.episode.dt
        brakes = Foot(begins=step, full=math.inf, ramp=dt, over=over)  # the pedals let through what they do
        return trial.instead(_Braking(trial.ego, step), pedals_of(trial.ego), over, brakes)

    latest = _first_of_run(range(trial.crash.step - 1, -1, -1), avoided)
    if latest is None:
        return None
    own, let_go = _own_braking(trial.episode, trial.crash.step, trial.risk or 0)
    return Braking(
        step=latest,
        own=own,
        let_go=let_go,
        deceleration=PEDALS[pedals_of(trial.ego)] * trial.program.ego_limits.brake,
    )


def highest_speed(trial: Trial) -> Slower | None:
    """The highest speed that the ego may keep to and collides with nobody; None if there is none.

    It is tried in steps of `FINENESS` below its highest speed before the contact, down to `LEAST_SHARE` of that; up to
    `BEYOND` steps below the one that is found it must avoid it as well.
    """
    highest = float(trial.episode.ego_track.speed[: trial.crash.step + 1].max())
    count = int(highest * (1.0 - LEAST_SHARE) / FINENESS + 1e-9)

    def avoided(less: int) -> bool:
        driver = _Limited(trial.ego, highest - less * FINENESS, trial.episode.dt, trial.program.ego_limits)
        return trial.instead(driver, pedals_of(trial.ego), trial.crash.step)

    least = _first_of_run(range(1, count + 1), avoided)
    return None if least is None else Slower(limit=highest - least * FINENESS, highest=highest)


def _first_of_run(tried: Sequence[int], holds: Callable[[int], bool]) -> int | None:
    """The first for which something holds, and for the next `BEYOND` too, as far as there are so many."""
    held = 0
    for place, one in enumerate(tried):
        held = held + 1 if holds(one) else 0
        if held > BEYOND:
            return tried[place - BEYOND]
    return tried[len(tried) - held] if held else None


def with_whom(came: Came) -> str:
    """With whom a drive ended that crashed with somebody else, by what that is."""
    kinds = came.episode.kinds if came.episode is not None else {}
    return named(came.other, kinds[came.other], kinds) if came.other in kinds else came.other


def in_words(came: Came) -> str:
    """What came of a drive, to stand after a colon."""
    if came.rejected:
        return f"the scene cannot be driven, {came.rejected}"
    if came.crashed:
        return "the same crash"
    if came.other:
        return f"not this crash, but one with {with_whom(came)}"
    if came.gap is None:
        return "no crash"
    return f"no crash, {f'{came.gap:.1f}' if came.gap >= NEAR else f'less than {NEAR:g}'} m apart at the closest"


class _Braking:
    """Another ego until a step, then its whole brake; its steering throughout."""

    def __init__(self, ego: EgoPolicy, step: int) -> None:
        self._ego, self._left, self.begins = ego, step, step
        begin(ego)

    def skip(self) -> None:
        """Everything before it brakes was driven without it."""
        self._left = 0

    def act(self, observation: Observation) -> tuple[float, float]:
        acceleration, steering = decide(self._ego, observation)
        self._left -= 1
        return (acceleration if self._left >= 0 else -1.0), steering


class _Limited:
    """Another ego that keeps to a speed [m/s]."""

    begins = 0

    def __init__(self, ego: EgoPolicy, limit: float, dt: float, body: Limits = LIMITS[CAR]) -> None:
        self._ego, self._limit, self._dt, self._body = ego, limit, dt, body
        self._speed_at = SPEED_AT[observation_of(ego)]
        self._brake = PEDALS[pedals_of(ego)] * body.brake
        begin(ego)

    def skip(self) -> None:
        """Nothing is driven without it."""

    def act(self, observation: Observation) -> tuple[float, float]:
        acceleration, steering = decide(self._ego, observation)
        most = (self._limit - float(observation[self._speed_at])) / self._dt  # [m/s²]
        allowed = most / self._body.throttle if most > 0.0 else max(most, -COMFORTABLE) / self._brake
        return min(acceleration, allowed), steering


def _own_braking(episode: Episode, crash: int, risk: int) -> tuple[int | None, int | None]:
    """The steps at which the last braking before the contact began and ended; None for an end by the contact.

    Both are None if the ego did not brake, or was done with it before the step at which the crash could be seen coming.
    """
    decelerating = -episode.ego_track.acceleration(episode.dt)[: crash + 1]
    step = crash
    while step > 0 and abs(episode.ego_track.speed[step]) < STANDING:
        step -= 1
    lasts = step
    while step > 0 and decelerating[step] < BRAKES:
        step -= 1
    let_go = step
    while step > 0 and decelerating[step] >= BRAKES:
        step -= 1
    if step == let_go or let_go <= risk:
        return None, None
    return step, None if let_go == lasts else let_go


def _came(trial: Trial, driven: Episode | Rejected) -> Came:
    if isinstance(driven, Rejected):
        return Came(crashed=False, rejected=driven.reason)
    struck, crash = _same(trial, driven), driven.collision
    gap = None if struck is None else least_gap(driven.ego_track, struck)
    if crash is None:
        return Came(crashed=False, gap=gap, episode=driven)
    same = struck is not None and crash.other == struck.actor
    return Came(crashed=same, other="" if same else crash.other, gap=gap, episode=driven)


def _same(trial: Trial, driven: Episode) -> Track | None:
    """The one of another drive that the ego collided with in the crash.

    With all others there it has the same name; with some left out it stands where it stood, whatever it is called.
    """
    struck, tracks = trial.struck, driven.tracks
    if len(tracks) == len(trial.episode.tracks):
        return next((track for track in tracks if track.actor == struck.actor), None)
    return next((track for track in tracks if _stands_alike(track, struck)), None)


def _stands_alike(a: Track, b: Track) -> bool:
    return (a.kind, a.role) == (b.kind, b.role) and max(abs(a.x[0] - b.x[0]), abs(a.y[0] - b.y[0])) < MOVED


def _gone(trial: Trial, came: Came) -> tuple[tuple[Track, ...], str]:
    """Who is not there any more in a drive, and why that tells nothing, if it does not."""
    if came.episode is None:
        return (), f"without it {in_words(came)}"
    left: Sequence[Track] = came.episode.tracks
    if any(not any(_stands_alike(track, one) for one in trial.episode.tracks) for track in left):
        return (), "without it others stand elsewhere"
    return tuple(t for t in trial.episode.tracks if not any(_stands_alike(t, one) for one in left)), ""
