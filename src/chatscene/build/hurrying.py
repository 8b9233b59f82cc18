"""Who is to be in the ego's way soon after its deed is due: it begins as near, and goes as fast, as is usual at all."""

from __future__ import annotations

from typing import TYPE_CHECKING

from chatscene.build.arriving import AT_LINE
from chatscene.build.asked import Meets
from chatscene.situations.phrases import one_of
from chatscene.terms.vocabulary import Manner

if TYPE_CHECKING:
    from chatscene.build.actor import Actor

AT_EDGE = 0.3, 0.6  # [m] outside the lanes, from and to, that somebody stands who is about to cross


def begins_nearer(actor: Actor) -> None:
    """Let somebody begin at the edge of the road, or at the line of the junction, if nothing else was said."""
    numbers, start = actor.numbers, actor.one.starts
    if actor.stand.meets is Meets.ACROSS and "$X" in actor.stand.point and not numbers.is_said("X"):
        low, high, *_ = numbers.range_of("X")
        if actor.deeds[0].speed is None:  # else it needs its way to be as fast
            numbers.narrow("X", min(low, AT_EDGE[0]), min(high, AT_EDGE[1]))
    if actor.stand.meets is Meets.THROUGH and start.distance is None and actor.first is None:
        nose = 0.5 * actor.limits.length
        low, high, unit, meaning = numbers.range_of("Y")
        numbers.measure("Y", min(low, nose + AT_LINE[0]), min(high, nose + AT_LINE[1]), unit, meaning)


def goes_faster(actor: Actor) -> None:
    """Let somebody go as fast as one of its kind is said to go that is fast, if it was not said to be slow."""
    numbers = actor.numbers
    slow = any(deed.manner is Manner.SLOW for deed in actor.deeds)
    if numbers.is_said("SPEED") or slow or any(deed.speed is not None for deed in actor.deeds):
        return
    low, high, *_ = numbers.range_of("FAST")
    if high <= numbers.range_of("SPEED")[0]:
        return
    numbers.narrow("SPEED", low, high)
    actor.ledger.assume(f"{actor.one.id} goes as fast as {one_of(actor.one.kind)} in a hurry, to be there in time")
