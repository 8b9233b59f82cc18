"""Speeds that were said against the ego's, as speeds of their own."""

from __future__ import annotations

from dataclasses import replace

from chatscene.errors import NotBuilt
from chatscene.terms.amount import Speed
from chatscene.terms.situation import Other, Situation

LEAST = 0.1  # [m/s] below which a road user counts as standing


def at_own_speeds(situation: Situation, ego: float) -> Situation:
    """The same situation, with every speed that was said against the ego's as an absolute one.

    Args:
        situation: What was said.
        ego: What the ego drives at [m/s].

    Raises:
        NotBuilt: The difference leaves no speed; the message names the fact.
    """
    return replace(situation, others=tuple(_own(one, ego) for one in situation.others))


def _own(one: Other, ego: float) -> Other:
    at = f"others.{one.id}"
    starts = replace(one.starts, speed=_beside(one.starts.speed, ego, f"{at}.starts"))
    deeds = enumerate(one.does)
    does = tuple(replace(deed, speed=_beside(deed.speed, ego, f"{at}.does.{k}")) for k, deed in deeds)
    return replace(one, starts=starts, does=does)


def _beside(said: Speed | None, ego: float, at: str) -> Speed | None:
    if said is None or not said.than_ego:
        return said
    if (own := said.beside(ego)).high < LEAST:
        raise NotBuilt(
            f"{at}.speed: {said}, but the ego drives at {3.6 * ego:.0f} km/h; give a smaller difference, or act: stand"
        )
    return own
