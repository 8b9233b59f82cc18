"""How hard somebody gains or loses speed: as was said, or as the time or the way asks for in which it does."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from chatscene.build.asked import Meets
from chatscene.build.deeds import BRAKES_TO, GO, OWN, Steps
from chatscene.errors import NotBuilt
from chatscene.situations.phrases import one_of
from chatscene.terms.actors import AIR_DRAG
from chatscene.terms.amount import Amount, Duration, Length
from chatscene.terms.vocabulary import Act, Heads, Tempo, acts_of

if TYPE_CHECKING:
    from chatscene.build.actor import Actor
    from chatscene.build.paces import Speed
    from chatscene.build.timing import Body

ALMOST = 0.93  # of a rate that was said: nobody sees the difference
GENTLEST = 0.1  # [m/s²] of the brakes alone
ENOUGH = 0.8  # of the speed that is lost in the time for which somebody brakes
GETS = 0.9  # of what it gains: the mean is up to there
NEARLY_ALL = 0.98  # of a speed that is gained with a pedal that is held
SLOWEST = 0.1  # [m/s²] at which speed is gained, the least that is taken for usual
LEAST_GAINED = 1.5  # [m/s] over which a pedal is measured
_STEP, _MOST = 0.1, 60.0  # [s] in which a pedal is followed, and for how long
_LOSES = acts_of(Tempo.BRAKES, Tempo.SLOWS)
_OFF = acts_of(Tempo.SETS_OFF, Heads.FROM_EDGE)
_THROUGH = acts_of(Heads.THROUGH, Heads.TURNS)
_FLOORS = "ThrottleOnPath({p}, $THROTTLE, 0, $SPEED) until self.pose[3] > {held} * $SPEED"
AT_A_RATE: dict[Act, Steps] = {
    Act.SET_OFF: Steps(
        does=(_FLOORS, GO + " for 3 seconds"), last=(_FLOORS, GO), binds={"speed": "SPEED", "acceleration": "THROTTLE"}
    ),
    Act.PULL_OUT: Steps(
        does=(_FLOORS.replace("{p}", OWN),), way=OWN, binds={"speed": "SPEED", "acceleration": "THROTTLE"}
    ),
    **dict.fromkeys(
        _THROUGH,
        Steps(
            does=("ThrottleOnPath({p}, $THROTTLE, 0, $SPEED) for $GO_TIME seconds",),
            last=(_FLOORS, GO),
            binds={"speed": "SPEED", "acceleration": "THROTTLE"},
            lasting=True,
        ),
    ),
}
"""Of somebody who sets off as hard as was said; through a junction, from a stand before that."""


def at_a_rate(actor: Actor, k: int, steps: Steps, *, across: bool) -> Steps:
    """The row of a deed whose acceleration, time or way says how hard it is done; else the same."""
    deed = actor.deeds[k]
    if across:
        if deed.act in _LOSES and deed.time is not None:  # in which nobody on foot slows down
            return replace(steps, binds={one: name for one, name in steps.binds.items() if one != "time"})
        return steps
    through = deed.act in _THROUGH and actor.stand.meets is Meets.THROUGH
    if (deed.act in _OFF or through) and rate_of(actor, k) is not None and not actor.walks:
        return AT_A_RATE[deed.act]
    if deed.act is Act.SLOW_DOWN and (deed.acceleration is not None or deed.time is not None):
        return BRAKES_TO
    if deed.act is Act.ACCELERATE and any(one is not None for one in (deed.time, deed.acceleration, deed.distance)):
        gains = f"{steps.last[0]} until self.pose[3] > {NEARLY_ALL:g} * $FAST"
        return replace(steps, does=(gains,), binds={**steps.binds, "time": "THROTTLE", "distance": "THROTTLE"})
    return steps


def rate_of(actor: Actor, k: int) -> tuple[Amount, str] | None:
    """The acceleration that was said of how somebody gets under way, or of what it gains then; and its path."""
    deed, at = actor.deeds[k], f"{actor.path}.does"
    if deed.acceleration is not None:
        return deed.acceleration, f"{at}.{k}.acceleration"
    if deed.act in _OFF and deed.speed is None and k + 1 < len(actor.deeds):
        then = actor.deeds[k + 1]
        if then.act is Act.ACCELERATE and then.acceleration is not None and then.when is None:
            return then.acceleration, f"{at}.{k + 1}.acceleration"
    return None


def brakes_by(actor: Actor, k: int, before: Speed, after: Speed, *, loses: bool) -> bool:
    """Let somebody lose speed as hard as the time or the way asks for that was said; whether it was.

    Raises:
        NotBuilt: It cannot brake so hard.
    """
    deed = actor.deeds[k]
    was, then = (0.5 * (one.low + one.high) for one in (before, after))
    timed = deed.act in _LOSES and deed.time is not None and loses
    if timed or (deed.act is Act.STOP and deed.distance is not None):
        _settle(actor, before, after)
    air = AIR_DRAG * (was * was + was * then + then * then) / 3.0
    usual = [end * actor.limits.brake + actor.limits.drag + air for end in actor.numbers.range_of("BRAKE")[:2]]
    if timed and deed.time is not None:
        low, high = _rates(deed.time, was - then, usual)
        path = "time"
    elif deed.act is Act.STOP and deed.distance is not None:
        low, high = _rates(deed.distance, 0.5 * was * was, usual)
        path = "distance"
    elif deed.act is Act.BRAKE and deed.time is not None and deed.acceleration is None:
        _, longest = deed.time.drawn(*actor.numbers.range_of("BRAKE_TIME")[:2])
        most = ENOUGH * was / longest / actor.limits.brake  # so that it is long in coming to a stand
        low, high, *_ = actor.numbers.range_of("BRAKE")
        actor.numbers.narrow(f"BRAKE_{k}", min(low, 0.8 * most), min(high, most))
        return True
    else:
        return False
    _bind(actor, k, "BRAKE", (low - air, high - air), path)
    return True


def throttles_by(actor: Actor, k: int, body: Body, before: Speed, after: Speed, held: float) -> None:
    """Let somebody gain speed as hard as was said on the average, or in the time that was said.

    Raises:
        NotBuilt: It cannot.
    """
    deed = actor.deeds[k]
    off = deed.act in _OFF | _THROUGH
    was = 0.0 if off else 0.5 * (before.low + before.high)
    _settle(actor, before, after)
    then = max((held if off else 1.0) * 0.5 * (after.low + after.high), was + LEAST_GAINED)
    usual = [max(_mean(body, was, then, pedal), SLOWEST) for pedal in actor.numbers.range_of("THROTTLE")[:2]]
    changes = GETS * (then - was), 0.5 * (then * then - was * was)
    if deed.time is not None and deed.acceleration is None:
        said, path = deed.time, f"{actor.path}.does.{k}.time"
        rates = _rates(deed.time, changes[0], usual)
    elif deed.distance is not None and deed.acceleration is None:
        said, path = deed.distance, f"{actor.path}.does.{k}.distance"
        rates = _rates(deed.distance, changes[1], usual)
    else:
        rate = rate_of(actor, k)
        assert rate is not None
        said, path = rate
        rates = said.drawn(usual[0], usual[1])
    if not after.said and after.name and deed.act is Act.ACCELERATE:  # to a speed at which it still can
        while then > was + LEAST_GAINED and _mean(body, was, then, 1.0) < rates[0]:
            then = max(was + LEAST_GAINED, then - 1.0)
        actor.numbers.narrow(after.name, then, then)
    pedals = [_pedal(body, was, then, rate) for rate in rates]
    if pedals[0] > 1.0:
        most = _mean(body, was, then, 1.0)
        say = f"{most:.2g} m/s² at most"
        if isinstance(said, Duration):
            say = f"{math.ceil(10 * changes[0] / most) / 10:g} s at least"
        elif isinstance(said, Length):
            say = f"{math.ceil(changes[1] / most)} m at least"
        raise NotBuilt(
            f"{path}: {said} is more than {one_of(actor.one.kind)} can do from {3.6 * was:.0f} to {3.6 * then:.0f} "
            f"km/h; say {say}"
        )
    name = f"THROTTLE_{k}"
    actor.numbers.measure(name, pedals[0], min(pedals[1], 1.0), "1", "how far the pedal is pressed", path)


def goes_so_far(actor: Actor, k: int, speed: Speed) -> str:
    """The parameter that is how long somebody goes on at a speed so that it covers the way that was said."""
    deed = actor.deeds[k]
    assert deed.distance is not None
    _settle(actor, speed)
    goes = 0.5 * (speed.low + speed.high) or actor.ego_speed
    usual = (goes * end for end in actor.numbers.range_of("GO_TIME")[:2])
    low, high = (end / goes for end in deed.distance.drawn(*usual))
    name = f"GO_TIME_{k}"
    actor.numbers.measure(name, low, high, "s", "for how long it goes on so", f"{actor.path}.does.{k}.distance")
    return name


def _settle(actor: Actor, *speeds: Speed) -> None:
    """Let speeds that were not said be one number each, of which the time or the way follows."""
    for speed in speeds:
        if speed.name and not speed.said:
            middle = 0.5 * (speed.low + speed.high)
            actor.numbers.narrow(speed.name, middle, middle)


def _rates(said: Duration | Length, change: float, usual: Sequence[float]) -> tuple[float, float]:
    """From which acceleration [m/s²] to which a change of speed takes the time, or the half of its square the way.

    Args:
        said: The time [s] or the way [m].
        change: The change of speed [m/s], or the half of its square.
        usual: The least and the most acceleration that is usual.
    """
    low, high = said.drawn(change / usual[1], change / usual[0])
    return change / high, change / low if low > 0.0 else math.inf


def _bind(actor: Actor, k: int, name: str, rates: tuple[float, float], path: str) -> None:
    most, drag = actor.limits.brake, actor.limits.drag
    low, high = (max(GENTLEST, rate - drag) / most for rate in rates)
    at = f"{actor.path}.does.{k}.{path}"
    if rates[1] < drag:
        raise NotBuilt(f"{at}: {getattr(actor.deeds[k], path)}: it slows down faster even without braking")
    if low > 1.0:
        said = getattr(actor.deeds[k], path)
        raise NotBuilt(f"{at}: {said} needs {rates[0]:.3g} m/s²; {one_of(actor.one.kind)} brakes at up to {most:.3g}")
    actor.numbers.measure(f"{name}_{k}", low, min(high, 1.0), "1", "how hard it brakes", at)


def _pedal(body: Body, was: float, then: float, rate: float) -> float:
    """How far the pedal is pressed so that speed is gained at a rate on the average; above 1 where that cannot be."""
    if (most := _mean(body, was, then, 1.0)) < rate:
        return 1.0 if most > ALMOST * rate else 2.0
    low, high = 0.0, 1.0
    for _ in range(20):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if _mean(body, was, then, middle) < rate else (low, middle)
    return high


def _mean(body: Body, was: float, then: float, pedal: float) -> float:
    """The mean [m/s²] of gaining most of what is gained with a pedal that is held; 0 if it is never gained."""
    speed, seconds, ends = was, 0.0, was + GETS * (then - was)
    while speed < ends:
        speed, seconds = body.after(speed, then + 1.0, pedal), seconds + _STEP
        if seconds > _MOST:
            return 0.0
    return (speed - was) / seconds if seconds else 0.0
