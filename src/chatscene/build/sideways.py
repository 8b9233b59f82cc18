"""How long somebody takes to change lanes: its way over in as many pieces as the time asks for."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import TYPE_CHECKING

from chatscene.build.asked import Meets, stands_first
from chatscene.build.deeds import OWN, Steps
from chatscene.build.over_lanes import lane_after, side_beside
from chatscene.build.place import LANE
from chatscene.errors import NotBuilt
from chatscene.terms.amount import Speed
from chatscene.terms.vocabulary import COMES_OVER, GLIDES, OVER_A_LINE, Manner, Side

if TYPE_CHECKING:
    from chatscene.build.actor import Actor

LAGS = 0.35  # [s] that whoever steers for a line is behind it
PIECE = 0.35  # [s] of one piece of the way, about
QUICKEST, USUAL = 1.7, 2.4  # [s] in which somebody changes lanes at least, and in which it does without delay
GENTLY = 4.0  # [m/s²] sideways, up to which cars answer to the wheel in proportion (ISO 4138)
SLOWEST_ASIDE = 0.2  # [m/s] at which somebody comes over to another lane at least
FROM = 40 / 3.6  # [m/s], from which on nobody comes over as fast as its wheel would turn it
AT_SPEED = math.sqrt(2.0 * math.pi * LANE / GENTLY)
"""[s] that somebody takes to change lanes along a sine of the acceleration sideways, with no more than `GENTLY`."""
SLOWLY = 2.0 * AT_SPEED
GENTLE = (4.0, 6.0)
"""[s] in which somebody changes lanes who was said to do it slowly, from and to."""
PEAK = 1.15  # times as long as by its speed aside, which is between its mean then and its most
CLEARS = 2.4  # [s] that who takes so long needs more than who turns at once, until it is out of a lane, at most
"""[s]: drivers take 4.6 s in the mean (T. Toledo and D. Zohar, "Modeling duration of lane changes", 2007)."""
CLEARS_AT_ONCE, OUT = 0.6, 0.65  # [s] of who turns at once; of the time that it takes, of who glides over
OVER_LINE, ALONG_LINE = 1.0, 5.0  # [s], [m] at least from when somebody turns the wheel until it crosses the line


def takes_long(actor: Actor, k: int, steps: Steps) -> Steps:
    """The row of somebody who changes lanes in a time that was said, or as is usual at its speed; else the same.

    Raises:
        NotBuilt: Nobody does it so fast.
    """
    line = next((line for line in (OWN, "{beside}") if f"DrivePath({line}" in steps.does[0]), "") if steps.does else ""
    if not line or (takes := _takes(actor, k)) is None:
        return steps
    at, said = f"{actor.path}.does.{k}", _said(actor, k)
    if said == "time" and takes[0] <= USUAL:
        actor.ledger.take(f"{at}.time")
        return steps
    if said == "manner":
        actor.ledger.take(f"{at}.manner")
    return _over(actor, k, steps, line, takes, f"{at}.{said}" if said else "")


def speed_aside(actor: Actor, k: int) -> Speed | None:
    """How fast somebody comes aside by its k-th deed, if that was said."""
    told = actor.ledger.told
    one = actor.one if told is None else told[actor.one.id]
    there = k < len(one.does) and one.does[k].act is actor.deeds[k].act
    return one.speed_aside(k) if there else None


def glides_for(actor: Actor, k: int) -> tuple[float, float] | None:
    """The least and the most time [s] in which somebody changes lanes of whom it was said how fast it comes aside."""
    return _takes(actor, k) if _said(actor, k) in ("speed", "manner") else None


def clears_in(actor: Actor, k: int) -> float:
    """How long [s] somebody needs at most until it is out of its lane by its k-th deed, after who turns at once is."""
    if (takes := glides_for(actor, k)) is not None:
        return OUT * takes[1]
    return CLEARS if over_at_speed(actor, k) else CLEARS_AT_ONCE


def _said(actor: Actor, k: int) -> str:
    """By which amount it was said how long somebody takes to change lanes; empty if it was not."""
    deed = actor.deeds[k]
    if deed.act in OVER_A_LINE and deed.time is not None:
        return "time"
    if deed.act not in GLIDES or actor.stand.meets is not Meets.ALONG:
        return ""
    if speed_aside(actor, k) is not None:
        return "speed"
    return "manner" if deed.manner is Manner.SLOW and deed.time is None and deed.distance is None else ""


def _takes(actor: Actor, k: int) -> tuple[float, float] | None:
    """The least and the most time [s] in which somebody changes lanes; None of who does it as fast as it can.

    Raises:
        NotBuilt: Nobody does it so fast.
    """
    deed, said = actor.deeds[k], _said(actor, k)
    if said == "speed" and (aside := speed_aside(actor, k)) is not None:
        slowest, fastest = aside.drawn(SLOWEST_ASIDE, LANE / QUICKEST)
        return max(QUICKEST, PEAK * LANE / fastest), PEAK * LANE / max(slowest, SLOWEST_ASIDE)
    if said == "manner":
        return GENTLE
    if deed.time is None:
        return (AT_SPEED, SLOWLY) if over_at_speed(actor, k) else None
    if deed.act not in OVER_A_LINE:
        return None
    if deed.time.high < QUICKEST:
        at = f"{actor.path}.does.{k}.time"
        raise NotBuilt(f"{at}: {deed.time} is too short to change lanes: at least {QUICKEST:g} s")
    low, high = deed.time.drawn(QUICKEST, 2.0 * QUICKEST)
    return max(QUICKEST, low), high


def seconds_over(actor: Actor, k: int) -> tuple[str, float]:
    """How long [s] somebody who comes over to the ego's lane takes until it is in the ego's way there.

    Returns:
        As a program says it, and the middle of that.
    """
    takes = _takes(actor, k)
    if takes is None or (_said(actor, k) == "time" and takes[0] <= USUAL):
        seconds = max(OVER_LINE, ALONG_LINE / actor.numbers.middle("SPEED"))
        return f"{seconds:.3g}", seconds
    outside = 0.5 * (actor.limits.width + actor.ego_limits.width) / LANE
    along = next(n / 50 for n in range(51) if 1.0 - _share(n / 50) <= outside)
    if f"PIECE_{k}" not in actor.numbers.ranges:  # whose row goes over by its wheel alone takes as long
        _measure_piece(actor, k, takes)
    return f"{along * _pieces(takes[0]):.3g} * $PIECE_{k}", along * (0.5 * sum(takes) - LAGS)


def over_at_speed(actor: Actor, k: int) -> bool:
    """Whether somebody comes over to another lane at a speed at which tyres ask for more time than a wheel takes."""
    deed = actor.deeds[k]
    once = sum(one.act in COMES_OVER for one in actor.deeds) == 1
    free = deed.distance is None and deed.lateral is None and deed.manner is not Manner.SUDDEN
    slow = stands_first(actor.one) and actor.moves_first(k)  # it turns out from a stand
    return deed.act in COMES_OVER and once and free and not slow and actor.numbers.middle("SPEED") > FROM


def _over(actor: Actor, k: int, steps: Steps, line: str, takes: tuple[float, float], path: str = "") -> Steps:
    """The row of somebody who comes over to another line in some time.

    Args:
        actor: Who.
        k: The number of the deed.
        steps: How it comes over by the wheel alone.
        line: Where to.
        takes: The least and the most time [s].
        path: Of the fact that says so.
    """
    pieces = _measure_piece(actor, k, takes, path)
    from_left = _goes_right(actor, k, line)
    sign = 1.0 if from_left else -1.0
    over = tuple(
        f"DrivePath({line}, $SPEED, {sign * LANE * (1.0 - _share((n + 1) / pieces)):.3g}) for $PIECE_{k} seconds"
        for n in range(pieces)
    )
    return replace(steps, does=(*over, *steps.does), last=(*over, *steps.last) if steps.last else ())


def _measure_piece(actor: Actor, k: int, takes: tuple[float, float], path: str = "") -> int:
    """Let a piece of somebody's way over take its share of some time [s], and return in how many it goes."""
    pieces = _pieces(takes[0])
    short, long = (max(0.1, one - LAGS) / pieces for one in takes)
    actor.numbers.measure(f"PIECE_{k}", short, long, "s", "how long a piece of its way over takes", path)
    return pieces


def _pieces(least: float) -> int:
    """In how many pieces somebody goes over that takes so long [s] at least."""
    return max(2, round(max(least - LAGS, PIECE) / PIECE))


def _share(along: float) -> float:
    """How much of its way over somebody has behind it: slowly at first, and slowly at last."""
    return along * (0.4 + 0.6 * along * (3.0 - 2.0 * along))


def _goes_right(actor: Actor, k: int, line: str) -> bool:
    """Whether somebody is to the left of the line that it goes over to."""
    if line == OWN:
        return lane_after(actor.one, actor.deeds, k - 1) > 0
    return side_beside(actor, actor.deeds[k].to)[0] is Side.RIGHT
