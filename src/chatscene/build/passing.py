"""Who overtakes the ego: how fast it must be for that, and how long it takes."""

from __future__ import annotations

from typing import TYPE_CHECKING

from chatscene.build.numbers import MOST
from chatscene.errors import NotBuilt

if TYPE_CHECKING:
    from chatscene.build.actor import Actor

PASSES = 1.2  # times as fast as the ego is who gets by it before the road ends


def choose_passing_speed(actor: Actor, k: int) -> None:
    """Let it be so much faster than the ego that it gets by.

    Raises:
        NotBuilt: It is not, or no such body is.
    """
    deed = actor.deeds[k]
    least, name = PASSES * actor.ego_speed, f"FAST_{k}"
    if deed.speed is not None:
        actor.numbers.bind(name, deed.speed, actor.ego_speed, f"{actor.path}.does.{k}.speed")
    low, high, *_ = actor.numbers.range_of(name)
    most = high if deed.speed is not None else MOST * actor.limits.top_speed
    if most < least:
        raise NotBuilt(
            f"{actor.path}.does.{k}: a {actor.one.kind} at {3.6 * most:.0f} km/h does not overtake an ego at "
            f"{3.6 * actor.ego_speed:.0f} km/h; say {3.6 * least:.0f} km/h at least, or a slower ego"
        )
    actor.numbers.narrow(name, max(low, least), max(high, least))


def seconds_to_pass(actor: Actor, k: int) -> float:
    """How long [s] it takes to get by the ego."""
    faster = actor.numbers.middle(f"FAST_{k}") - actor.ego_speed
    behind = actor.numbers.middle("Y") if "$Y" in actor.stand.at and actor.stand.behind else 0.0
    metres = behind + actor.limits.length
    return (metres + actor.numbers.middle("AHEAD")) / max(faster, 0.5)
