"""How long somebody takes to change lanes: its way over in as many pieces as the time asks for."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from chatscene.build.deeds import OWN, Steps
from chatscene.build.place import LANE
from chatscene.errors import NotBuilt
from chatscene.terms.vocabulary import Act, Side
from chatscene.world.places import lanes_beside

if TYPE_CHECKING:
    from chatscene.build.actor import Actor

LAGS = 0.35  # [s] that whoever steers for a line is behind it
PIECE = 0.35  # [s] of one piece of the way, about
QUICKEST, USUAL = 1.7, 2.4  # [s] in which somebody changes lanes at least, and in which it does without delay
_CHANGES = frozenset((Act.LANE_CHANGE, Act.CUT_OUT))


def takes_long(actor: Actor, k: int, steps: Steps) -> Steps:
    """The row of somebody who changes lanes in a time that was said; else the same.

    Raises:
        NotBuilt: Nobody does it so fast.
    """
    deed = actor.deeds[k]
    line = next((line for line in (OWN, "{beside}") if f"DrivePath({line}" in steps.does[0]), "") if steps.does else ""
    if deed.act not in _CHANGES or deed.time is None or not line:
        return steps
    least = max(QUICKEST, deed.time.low)
    low, high = deed.time.within(QUICKEST, max(least, 2.0 * least))
    at = f"{actor.path}.does.{k}.time"
    if deed.time.high < QUICKEST:
        raise NotBuilt(f"{at}: {deed.time} is less than anybody takes to change lanes: {QUICKEST:g} s at least")
    if low <= USUAL:
        actor.ledger.take(at)
        return steps
    pieces = max(2, round(max(low - LAGS, PIECE) / PIECE))
    short, long = (max(0.1, one - LAGS) / pieces for one in (low, high))
    actor.numbers.measure(f"PIECE_{k}", short, long, "s", "how long a piece of its way over takes", at)
    from_left = _goes_right(actor, k, line)
    sign = 1.0 if from_left else -1.0
    over = tuple(
        f"DrivePath({line}, $SPEED, {sign * LANE * (1.0 - _share((n + 1) / pieces)):.3g}) for $PIECE_{k} seconds"
        for n in range(pieces)
    )
    return replace(steps, does=(*over, *steps.does), last=(*over, *steps.last) if steps.last else ())


def _share(along: float) -> float:
    """How much of its way over somebody has behind it: slowly at first, and slowly at last."""
    return along * (0.4 + 0.6 * along * (3.0 - 2.0 * along))


def _goes_right(actor: Actor, k: int, line: str) -> bool:
    """Whether somebody is to the left of the line that it goes over to."""
    start, deed = actor.one.starts, actor.deeds[k]
    if line == OWN:
        return start.side is Side.LEFT
    beside = lanes_beside(actor.found.route)
    there = (side for side in (Side.LEFT, Side.RIGHT) if beside.get(side) is False)
    return (deed.to or next(there, Side.LEFT)) is Side.RIGHT
