"""How long phases take, and how far somebody gets in them, by what its body can do: so that deeds begin in time.

Computed with the middle of each range, on a straight line and with the pedals that a tracker presses.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterable
from dataclasses import dataclass

from chatscene.build.numbers import Numbers
from chatscene.terms.actors import Limits
from chatscene.world.control import pedals

_STEP = 0.1  # [s]
_MOST = 60.0  # [s] that a phase is followed
HELD = 0.92  # of a speed: who holds no more of it wants more
PATIENCE = 8.0  # [s] that somebody is waited for to be as fast as it wants
_NUMBER = r"[^,()]+"
_TOWARD = re.compile(rf"(?:MoveAhead\(|(?:DrivePath|FollowTraffic|SwerveOnPath|WeaveOnPath)\([^,]+, )({_NUMBER})")
_THROTTLE = re.compile(rf"ThrottleOnPath\([^,]+, ({_NUMBER}), 0, ({_NUMBER})\)")
_BRAKE = re.compile(rf"BrakeOnPath\([^,]+, ({_NUMBER})\)")
_TURN = re.compile(rf"TurnOff\((-?[\d.]+), ({_NUMBER}), ([\d.]+)\)")
_FOR = re.compile(r" for (\S+) seconds")
_SPEED_IS = re.compile(r" until self\.pose\[3\] ([<>]) (.+)$")


@dataclass(frozen=True, slots=True)
class Course:
    """Where somebody is in a plan.

    Attributes:
        seconds: Since it began [s].
        metres: How far it got [m].
        speed: How fast it is [m/s].
        way: 1 where it goes as it first did, -1 after it turned back.
    """

    seconds: float = 0.0
    metres: float = 0.0
    speed: float = 0.0
    way: float = 1.0


@dataclass(frozen=True, slots=True)
class Body:
    """What a body can do.

    Attributes:
        limits: Of its kind.
        walks: Whether it is on foot.
    """

    limits: Limits
    walks: bool

    def after(self, speed: float, wish: float, throttle: float | None = None) -> float:
        """The speed a step later of who wants a speed, by the pedals or with one that is held."""
        limits = self.limits
        if self.walks:
            return (
                min(wish, speed + limits.throttle * _STEP) if wish > speed else max(wish, speed - limits.brake * _STEP)
            )
        press, brake = pedals(speed, wish) if throttle is None else (throttle if speed < wish else 0.0, 0.0)
        gain = press * limits.throttle * (1.0 - speed / limits.top_speed) - brake * limits.brake
        return max(0.0, speed + _STEP * (gain - (limits.drag if speed > 0.0 else 0.0)))

    def holds(self, wish: float, seconds: float = PATIENCE) -> float:
        """The speed [m/s] that it has some time after it wanted one: what the engine gives and drag leaves."""
        speed = 0.0
        for _ in range(round(seconds / _STEP)):
            speed = self.after(speed, wish)
        return speed

    def wish_for(self, speed: float) -> float:
        """The speed [m/s] that it must want to hold one; as much as it can at most."""
        low, high = speed, self.limits.top_speed
        for _ in range(20):
            middle = 0.5 * (low + high)
            low, high = (middle, high) if self.holds(middle, _MOST) < speed else (low, middle)
        return high

    def falls_short(self, speed: float) -> bool:
        """Whether it holds much less than a speed if it wants that."""
        return self.holds(speed, _MOST) < HELD * speed

    def reaches(self, metres: float) -> float:
        """The speed [m/s] that it has after a distance from a stand."""
        at = speed = 0.0
        while at < metres:
            speed = self.after(speed, self.limits.top_speed)
            at += _STEP * max(speed, _STEP)
        return speed

    def covers(self, metres: float, wish: float) -> float:
        """How long [s] it needs for a distance from a stand, if it wants a speed."""
        at = time = speed = 0.0
        while at < metres and time < _MOST:
            speed = self.after(speed, wish)
            at, time = at + _STEP * speed, time + _STEP
        return time


def course(phases: Iterable[str], numbers: Numbers, body: Body, start: Course = Course()) -> Course:
    """Where somebody is after phases; one that ends by what is seen of others takes no time.

    Args:
        phases: Texts with ``$NAME`` for parameters.
        numbers: The parameters.
        body: Who.
        start: Where it was.
    """
    here = start
    for text in phases:
        here = _phase(text, numbers, body, here)
    return here


def _phase(text: str, numbers: Numbers, body: Body, here: Course) -> Course:
    if turn := _TURN.match(text):
        wish = _value(turn[2], numbers)
        metres = abs(float(turn[1])) * float(turn[3])
        way = -here.way if abs(float(turn[1])) > 2.0 else here.way
        return Course(here.seconds + metres / max(wish, 0.5), here.metres, wish, way)
    wish, throttle, brake = 0.0, None, 1.0
    if found := _THROTTLE.match(text):
        throttle, wish = _value(found[1], numbers), _value(found[2], numbers)
    elif found := _BRAKE.match(text):
        brake = _value(found[1], numbers)
    elif found := _TOWARD.match(text):
        wish = _value(found[1], numbers)
    elif not text.startswith(("Halt", "Park")):
        wish = here.speed
    lasts = _value(found[1], numbers) if (found := _FOR.search(text)) else _MOST
    until = _SPEED_IS.search(text)
    if until is None and lasts == _MOST:
        return here  # its end is seen on the road
    bound = _value(until[2], numbers) if until is not None else math.nan
    seconds, metres, speed = here.seconds, here.metres, here.speed
    way = -here.way if ", 3.14159)" in text else here.way
    end = seconds + lasts
    while seconds < end:
        if until is not None and (speed < bound if until[1] == "<" else speed > bound):
            break
        if wish == 0.0 and throttle is None:
            speed = max(0.0, speed - brake * body.limits.brake * _STEP)
        else:
            speed = body.after(speed, wish, throttle)
        seconds, metres = seconds + _STEP, metres + way * _STEP * speed
    return Course(seconds, metres, speed, way)


def _value(text: str, numbers: Numbers) -> float:
    """A number, a parameter, or a product of such."""
    value = 1.0
    for factor in text.split("*"):
        one = factor.strip()
        value *= numbers.middle(one[1:]) if one.startswith("$") else float(one)
    return value
