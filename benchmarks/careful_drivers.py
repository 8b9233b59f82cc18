"""Reference drivers beside the careful one: who else would have avoided a crash, and whether anybody could have.

`REFERENCE_DRIVERS` has them by name. All are asked in the same way: the scene is driven again, the ego does as it does,
and the reference driver brakes beside it, harder where it asks for more. Two of them are rules that R157's literature
holds against the careful driver, and brake as it does after 0.75 s, with 12.65 m/s³, at most 0.774 g:

- Responsibility-Sensitive Safety: Shalev-Shwartz, Shammah, Shashua, "On a formal model of safe and scalable
  self-driving cars", arXiv 1708.06374 (2017), definitions 1 and 2 and the lateral distance;
- the fuzzy safety model: Mattas and others, "Driver models for the definition of safety requirements of automated
  vehicles in international regulations", Accident Analysis and Prevention 174 (2022), in the 01 series of R157.

Both are about lanes of a motorway. What is in front of the ego, and who comes into its way, is taken along its route
here, as for the careful driver (decision 0089).
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol

from chatscene.ego.asking import begin
from chatscene.ego.observation import Observation
from chatscene.ego.policy import PEDALS, EgoPolicy, pedals_of
from chatscene.measure.avoidability import BRAKING_DELAY, FULL_BRAKE, HORIZON, RAMP, WANDERING, avoidable
from chatscene.measure.instead import drive_instead
from chatscene.simulate.simulator import Session, Simulator
from chatscene.simulate.watchdog import time_limit
from chatscene.terms.actors import Limits
from chatscene.terms.episode import Episode, Track
from chatscene.terms.polyline import Polyline
from chatscene.terms.scene import Scene, ScenicProgram

JERK = FULL_BRAKE / RAMP  # [m/s³], 12.65 (UN R157, annex 3)
FARTHEST_ASIDE = 3.0  # [m] beside its route that whoever swerves may get: a lane


@dataclass(frozen=True, slots=True)
class Ahead:
    """Somebody as the ego meets them on its route.

    Attributes:
        gap: From the ego's front to their nearest part along the route [m].
        beside: Between both bodies across the route [m]; 0 where they overlap.
        along: Their speed the ego's way [m/s].
        inward: Their speed across, toward the ego's way [m/s].
    """

    gap: float
    beside: float
    along: float
    inward: float


class Rule(Protocol):
    """What a reference driver does about somebody ahead."""

    def braking(self, speed: float, acceleration: float, ahead: Ahead) -> float:
        """Deceleration [m/s²] that it wants at a speed [m/s] and an acceleration [m/s²]; 0 where all is safe."""
        ...


class ResponsibilitySensitive:
    """Brakes as hard as it may while both the longitudinal and the lateral distance are too small."""

    acceleration = 3.0  # [m/s²] that the ego may gain while it responds
    across = 1.0  # [m/s²], lateral
    margin = 0.3  # [m], lateral

    def braking(self, speed: float, acceleration: float, ahead: Ahead) -> float:  # noqa: ARG002 - of the Protocol
        """All of it or none."""
        time, faster = BRAKING_DELAY, speed + BRAKING_DELAY * self.acceleration
        own = (speed + faster) / 2.0 * time + faster**2 / (2.0 * FULL_BRAKE)
        if ahead.along >= 0.0:
            least = own - ahead.along**2 / (2.0 * FULL_BRAKE)
        else:  # who comes the other way brakes as well, after as long
            least = own - ahead.along * time + ahead.along**2 / (2.0 * FULL_BRAKE)
        inward = max(ahead.inward, 0.0)
        gained = inward + time * self.across
        aside = self.margin + (inward + gained) / 2.0 * time + gained**2 / (2.0 * self.across)
        return FULL_BRAKE if ahead.gap < least and ahead.beside < aside else 0.0


class Fuzzy:
    """Brakes the more, the nearer a distance is to an unsafe one: comfortably ahead of time, harder where it must."""

    comfortable, hard, lead = 4.0, 6.0, 7.0  # [m/s²] of the ego, and of whoever is ahead
    margin = 2.0  # [m], kept to a standing one, and as much again that is safe
    sooner = 0.1  # [s] by which who comes in must be before the ego

    def braking(self, speed: float, acceleration: float, ahead: Ahead) -> float:
        """As far as the distance is unsafe."""
        closing = speed - ahead.along
        if closing <= 0.0 or not self._comes_in(closing, ahead):
            return 0.0
        critical = self._critical(speed, acceleration, ahead)
        if critical > 0.0:
            return self.comfortable + critical * (self.hard - self.comfortable)
        return self.comfortable * self._proactive(speed, ahead)

    def _comes_in(self, closing: float, ahead: Ahead) -> bool:
        if ahead.beside <= 0.0:
            return True
        return ahead.inward > 0.0 and ahead.beside / ahead.inward <= max(ahead.gap, 0.0) / closing + self.sooner

    def _proactive(self, speed: float, ahead: Ahead) -> float:
        theirs = ahead.along * abs(ahead.along) / (2.0 * self.lead)
        react = speed * BRAKING_DELAY - theirs
        safe = react + speed**2 / (2.0 * self.comfortable) + self.margin
        return _unsafe(ahead.gap - self.margin, safe, react + speed**2 / (2.0 * self.hard))

    def _critical(self, speed: float, acceleration: float, ahead: Ahead) -> float:
        pressed = max(acceleration, -self.comfortable)
        closing = speed - ahead.along
        later = closing + pressed * BRAKING_DELAY
        if later < 0.0:
            return float(ahead.gap < closing**2 / (2.0 * abs(pressed)))
        react = (closing + pressed * BRAKING_DELAY / 2.0) * BRAKING_DELAY
        return _unsafe(ahead.gap, react + later**2 / (2.0 * self.comfortable), react + later**2 / (2.0 * self.hard))


def _unsafe(gap: float, safe: float, unsafe: float) -> float:
    """0 where a gap is safe, 1 where it is unsafe, between them in proportion."""
    if gap > safe:
        return 0.0
    return 1.0 if gap < unsafe or safe <= unsafe else (safe - gap) / (safe - unsafe)


Judge = Callable[[Episode, ScenicProgram, Scene, EgoPolicy, Simulator], bool | None]
"""Whether a driver in the ego's place does not crash; None where the ego did not."""


def by_rule(rule: Rule) -> Judge:
    """A driver that brakes by a rule, from the beginning of the scene on, for the one that the ego crashed with."""

    def judge(
        episode: Episode, program: ScenicProgram, scene: Scene, ego: EgoPolicy, simulator: Simulator
    ) -> bool | None:
        if episode.collision is None:
            return None
        line = simulator.route_in(program, scene).line
        driver = _ByRule(ego, rule, line, episode.collision.other, episode.dt, program.ego_limits)
        return _avoids(driver, driver.watch, episode, program, scene, ego, simulator)

    return judge


def at_all(episode: Episode, program: ScenicProgram, scene: Scene, ego: EgoPolicy, simulator: Simulator) -> bool | None:
    """Whether anything that begins within `HORIZON` of the contact avoids it, done by somebody who knows the future.

    Tried are the whole brake, half of it and the whole throttle, each straight on and with a swerve to either side, at
    every half second. It is a bound from below on what can be avoided: what was not tried may do it as well.
    """
    crash = episode.collision
    if crash is None:
        return None
    for before in range(1, round(HORIZON / 0.5) + 1):
        step = max(crash.step - round(before * 0.5 / episode.dt), 0)
        for pedal in (-1.0, -0.5, 1.0):
            for swerve in (0.0, 0.3, -0.3):
                driver = _Profile(ego, step, pedal, swerve, episode.dt)
                if _avoids(driver, driver.watch, episode, program, scene, ego, simulator) and not driver.aside:
                    return True
    return False


REFERENCE_DRIVERS: dict[str, Judge] = {
    "careful": avoidable,
    "rss": by_rule(ResponsibilitySensitive()),
    "fuzzy": by_rule(Fuzzy()),
    "anybody": at_all,
}
"""Who is asked whether a crash could be avoided; the careful driver where nobody is named."""


def _avoids(
    driver: _ByRule | _Profile,
    watch: Callable[[Session], None],
    episode: Episode,
    program: ScenicProgram,
    scene: Scene,
    ego: EgoPolicy,
    simulator: Simulator,
) -> bool:
    assert episode.collision is not None
    with time_limit(f"scene {scene.id!r}, driven again"):
        return not drive_instead(
            driver,
            ego,
            program,
            scene,
            simulator,
            pedals="full-brake",
            not_over_before=episode.collision.step,
            dt=episode.dt,
            opened=watch,
        ).crashed


class _InPlace:
    """Another ego, of which only the pedals are touched."""

    begins = 0

    def __init__(self, ego: EgoPolicy, dt: float) -> None:
        self._ego, self._dt = ego, dt
        self._scale = PEDALS[pedals_of(ego)]
        self._session: Session | None = None
        begin(ego)

    def watch(self, session: Session) -> None:
        """Take in what is driven."""
        self._session = session

    def skip(self) -> None:
        """Nothing is driven without it."""

    def _own(self, observation: Observation) -> tuple[float, float]:
        acceleration, steering = self._ego.act(observation)
        return (acceleration * self._scale if acceleration < 0.0 else acceleration), steering


class _ByRule(_InPlace):
    """Brakes as a rule wants, `BRAKING_DELAY` after it first does, and with no more than `JERK`."""

    def __init__(self, ego: EgoPolicy, rule: Rule, line: Polyline, other: str, dt: float, body: Limits) -> None:
        super().__init__(ego, dt)
        self._body = body
        self._rule, self._line, self._other = rule, line, other
        self._left = BRAKING_DELAY
        self._pressed = 0.0

    def act(self, observation: Observation) -> tuple[float, float]:
        acceleration, steering = self._own(observation)
        wish = min(self._wish(), FULL_BRAKE)
        self._left = BRAKING_DELAY if wish <= 0.0 else self._left - self._dt
        braked = self._left <= 1e-9
        self._pressed = min(wish, self._pressed + JERK * self._dt) if braked else 0.0
        if wish > 0.0:
            acceleration = min(acceleration, 0.0)  # the foot leaves the throttle at once
        if self._pressed > 0.0:
            acceleration = min(acceleration, -max(0.0, self._pressed - self._body.drag) / self._body.brake)
        return acceleration, steering

    def _wish(self) -> float:
        assert self._session is not None
        so_far = self._session.episode("", "")
        ego = so_far.ego_track
        other = next((track for track in so_far.tracks if track.actor == self._other), None)
        if other is None:
            return 0.0
        ahead = meet(ego, other, self._line)
        if ahead.gap < -ego.length:
            return 0.0
        return self._rule.braking(float(ego.speed[-1]), float(ego.acceleration(self._dt)[-1]), ahead)


class _Profile(_InPlace):
    """From a step on, a pedal that is held and a swerve there and back; the ego's own steering beside it."""

    def __init__(self, ego: EgoPolicy, step: int, pedal: float, swerve: float, dt: float) -> None:
        super().__init__(ego, dt)
        self._left, self._pedal, self._swerve = step, pedal, swerve
        self.aside = False

    def act(self, observation: Observation) -> tuple[float, float]:
        assert self._session is not None
        acceleration, steering = self._own(observation)
        self._left -= 1
        if self._left >= 0:
            return acceleration, steering
        self.aside |= abs(self._session.offset) > FARTHEST_ASIDE
        time = -self._left * self._dt
        turned = self._swerve if time < 1.0 else -self._swerve if time < 2.0 else 0.0
        return self._pedal, max(-1.0, min(1.0, steering + turned))


def meet(ego: Track, other: Track, line: Polyline) -> Ahead:
    """How the ego meets somebody on its route, at the last step of both tracks."""
    at, _, _ = line.project(float(ego.x[-1]), float(ego.y[-1]))
    where, offset, _ = line.project(float(other.x[-1]), float(other.y[-1]))
    turned = float(other.heading[-1]) - line.heading_at(where)
    cos, sin = abs(math.cos(turned)), abs(math.sin(turned))
    length, width = other.length / 2 * cos + other.width / 2 * sin, other.length / 2 * sin + other.width / 2 * cos
    across = float(other.speed[-1]) * math.sin(turned)
    return Ahead(
        gap=where - at - ego.length / 2 - length,
        beside=max(abs(offset) - ego.width / 2 - width - WANDERING, 0.0),
        along=float(other.speed[-1]) * math.cos(turned),
        inward=-math.copysign(across, across * offset),
    )
