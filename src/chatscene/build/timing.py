"""How long phases take, and how far somebody gets in them, by what its body can do: so that deeds begin in time.

Computed with the middle of each range and with the pedals that a tracker presses, on a straight line or on the way to
where somebody meets the ego.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from functools import cache

from chatscene.build.numbers import Numbers
from chatscene.terms.actors import AIR_DRAG, Limits
from chatscene.world.control import pedals

_STEP = 0.1  # [s]
_MOST = 60.0  # [s] that a phase is followed
HELD = 0.975  # of a speed: who holds no more of it wants more
PATIENCE = 8.0  # [s] that somebody is waited for to be as fast as it wants
_NUMBER = r"[^,()]+"
_TOWARD = re.compile(rf"(?:MoveAhead\(|(?:DrivePath|FollowTraffic|SwerveOnPath|WeaveOnPath)\([^,]+, )({_NUMBER})")
_THROTTLE = re.compile(rf"ThrottleOnPath\([^,]+, ({_NUMBER}), 0, ({_NUMBER})\)")
_BRAKE = re.compile(rf"BrakeOnPath\([^,]+, ({_NUMBER})(?:, {_NUMBER})?\)")
_SLIDE = re.compile(rf"Slide\([^,]+, ({_NUMBER})\)")
_TURN = re.compile(rf"TurnOff\((-?[\d.]+), ({_NUMBER}), ([\d.]+)\)")
_BACKWARDS = re.compile(rf"ReverseStraight\(({_NUMBER})\)")
_FOR = re.compile(r" for (\S+) seconds")
_SPEED_IS = re.compile(r" until self\.pose\[3\] ([<>]) (.+)$")
_ASIDE_IS = re.compile(r" until abs\(offsetFrom\(egoRoute, self\)\) ([<>]) ([\d.]+)$")
_RESTS = re.compile(r" until restsWithin\(egoRoute, self, ([\d.]+)\)$")
_CAN_STOP = re.compile(r" until distanceLeft\(.+\) < brakingDistance\(self\)(?: / ([$\w.]+))? \+ ([\d.]+)$")


@dataclass(frozen=True, slots=True)
class Course:
    """Where somebody is in a plan.

    Attributes:
        seconds: Since it began [s].
        metres: How far it got [m].
        speed: How fast it is [m/s].
        way: 1 where it goes as it first did, -1 after it turned back.
        met: When it last came to where it meets the ego [s]; below 0 before it ever did.
    """

    seconds: float = 0.0
    metres: float = 0.0
    speed: float = 0.0
    way: float = 1.0
    met: float = -1.0


def _no_limit(_metres: float) -> float:
    return math.inf


@dataclass(frozen=True, slots=True, kw_only=True)
class Meeting:
    """Where somebody meets the ego, seen from where its plan begins.

    Attributes:
        metres: How far it has to there [m].
        beyond: How far it is from there on to the ego's line [m].
        allowed: The speed [m/s] that its way lets it have, so many metres from where its plan begins.
    """

    metres: float
    beyond: float
    allowed: Callable[[float], float] = _no_limit


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
        return max(0.0, speed + _STEP * (gain - (limits.drag + AIR_DRAG * speed * speed if speed > 0.0 else 0.0)))

    def holds(self, wish: float, seconds: float = PATIENCE) -> float:
        """The speed [m/s] that it has some time after it wanted one: what the engine gives and drag leaves."""
        speed = 0.0
        for _ in range(round(seconds / _STEP)):
            speed = self.after(speed, wish)
        return speed

    def holds_pressed(self, throttle: float) -> float:
        """The speed [m/s] that it comes to hold with a throttle that is pressed so far."""
        speed = 0.0
        for _ in range(round(_MOST / _STEP)):
            speed = self.after(speed, self.limits.top_speed, throttle)
        return speed

    @property
    def fastest(self) -> float:
        """The most [m/s] that it holds for long, by what the engine gives and drag leaves."""
        return _fastest(self)

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
            before, speed = speed, self.after(speed, self.limits.top_speed)
            at += _STEP * max(0.5 * (before + speed), _STEP)
        return speed

    def covers(self, metres: float, wish: float) -> float:
        """How long [s] it needs for a distance from a stand, if it wants a speed."""
        at = time = speed = 0.0
        while at < metres and time < _MOST:
            before, speed = speed, self.after(speed, wish)
            at, time = at + _STEP * 0.5 * (before + speed), time + _STEP
        return time


@cache
def _fastest(body: Body) -> float:
    return body.holds(body.limits.top_speed, _MOST) if body.limits.top_speed else 0.0  # what only lies there


def course(
    phases: Iterable[str], numbers: Numbers, body: Body, start: Course = Course(), meeting: Meeting | None = None
) -> Course:
    """Where somebody is after phases; one that ends by what is seen of others takes no time.

    Args:
        phases: Texts with ``$NAME`` for parameters.
        numbers: The parameters.
        body: Who.
        start: Where it was.
        meeting: Where it meets the ego; without it, a phase that ends by where somebody is takes no time either.
    """
    here = start
    for text in phases:
        here = _phase(text, numbers, body, here, meeting)
    return here


def _phase(text: str, numbers: Numbers, body: Body, here: Course, meeting: Meeting | None) -> Course:
    if turn := _TURN.match(text):
        wish = _value(turn[2], numbers)
        metres = abs(float(turn[1])) * float(turn[3])
        way = -here.way if abs(float(turn[1])) > 2.0 else here.way
        return replace(here, seconds=here.seconds + metres / max(wish, 0.5), speed=wish, way=way)
    wish, throttle, brake = _pressed(text, numbers, here)
    lasts = _value(found[1], numbers) if (found := _FOR.search(text)) else _MOST
    ends = _ends(text, numbers, body, meeting)
    goes_on = " until " not in text and meeting is not None and wish > 0.0
    if ends is None and lasts == _MOST and not goes_on:
        return here  # its end is seen on the road
    seconds, metres, speed, met = here.seconds, here.metres, here.speed, here.met
    way = -here.way if ", 3.14159)" in text or (_BACKWARDS.match(text) and " until " not in text) else here.way
    end = seconds + lasts
    while seconds < end and not (ends is not None and ends(metres, speed)):
        if goes_on and lasts == _MOST and meeting is not None and metres >= meeting.metres:
            break
        was = speed
        if wish == 0.0 and throttle is None:
            speed = max(0.0, speed - brake * body.limits.brake * _STEP)
        else:
            allowed = wish if meeting is None else min(wish, meeting.allowed(metres))
            speed = body.after(speed, allowed, throttle)
        before, seconds, metres = metres, seconds + _STEP, metres + way * _STEP * 0.5 * (was + speed)
        if meeting is not None and before < meeting.metres <= metres:
            met = seconds - (metres - meeting.metres) / max(speed, _STEP)
    if seconds >= end and lasts == _MOST:
        return replace(here, met=met)  # it never ends so
    return Course(seconds, metres, speed, here.way if _BACKWARDS.match(text) else way, met)


def _pressed(text: str, numbers: Numbers, here: Course) -> tuple[float, float | None, float]:
    """The speed [m/s] that is wanted in a phase, the throttle if it is held, and the share of the brake."""
    if found := _THROTTLE.match(text):
        return _value(found[2], numbers), _value(found[1], numbers), 1.0
    if found := _BRAKE.match(text):
        return 0.0, None, _value(found[1], numbers)
    if found := _TOWARD.match(text) or _BACKWARDS.match(text):
        return _value(found[1], numbers), None, 1.0
    if found := _SLIDE.match(text):
        return 0.0, None, _value(found[1], numbers)
    return 0.0 if text.startswith(("Halt", "Park")) else here.speed, None, 1.0


def _ends(text: str, numbers: Numbers, body: Body, meeting: Meeting | None) -> Callable[[float, float], bool] | None:
    """Whether a phase is over so many metres on and at a speed; None where that is not known beforehand."""
    if found := _SPEED_IS.search(text):
        bound, below = _value(found[2], numbers), found[1] == "<"
        return lambda _metres, speed: speed < bound if below else speed > bound
    if meeting is None:
        return None
    there, line, brakes = meeting.metres, meeting.metres + meeting.beyond, 2.0 * body.limits.brake
    if found := _ASIDE_IS.search(text):
        near, inside = float(found[2]), found[1] == "<"
        return lambda metres, _speed: abs(line - metres) < near if inside else abs(line - metres) > near
    if found := _RESTS.search(text):
        rests = float(found[1])
        return lambda metres, speed: abs(line - metres) - speed**2 / brakes < rests
    if found := _CAN_STOP.search(text):
        share, room = _value(found[1] or "1", numbers), float(found[2])
        return lambda metres, speed: there - metres < speed**2 / (share * brakes) + room
    return None


def _value(text: str, numbers: Numbers) -> float:
    """A number, a parameter, or a product of such."""
    value = 1.0
    for factor in text.split("*"):
        one = factor.strip()
        value *= numbers.middle(one[1:]) if one.startswith("$") else float(one)
    return value
