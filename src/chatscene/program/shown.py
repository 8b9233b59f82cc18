"""What a drive does not show of what was said, whether that is a situation or what a sentence gave."""

from __future__ import annotations

from dataclasses import dataclass

from chatscene.program.judge import failures, judge
from chatscene.program.meaning import check_meaning
from chatscene.terms.episode import Episode
from chatscene.terms.mirroring import mirrored_drive, mirrored_route
from chatscene.terms.route import Route
from chatscene.terms.scenario import Said
from chatscene.terms.situation import Situation


@dataclass(frozen=True, slots=True, kw_only=True)
class Shown:
    """How far a drive shows what was said.

    Attributes:
        missing: What it does not show, a sentence each; empty if it means what was said.
        cut: How many facts a contact cut short that were to be seen to their end.
        touch: Whether it was said that there is a contact; None where nothing was said of one.
    """

    missing: tuple[str, ...]
    cut: int = 0
    touch: bool | None = None


def not_shown(
    said: Said, episode: Episode, route: Route, *, through: bool = False, met: bool = True
) -> tuple[str, ...]:
    """What a drive does not show, a sentence each, as `shown` finds it; empty if it means what was said."""
    return shown(said, episode, route, through=through, met=met).missing


def shown(said: Said, episode: Episode, route: Route, *, through: bool = False, met: bool = True) -> Shown:
    """How far a drive shows what was said.

    Args:
        said: What was said.
        episode: What happened.
        route: The ego's route.
        through: Judge to the end a drive that went on through a collision.
        met: Whether encounters count, and what nobody said: a search is still to find drives that are right in both.
    """
    if not isinstance(said, Situation):
        if route.mirrored:  # what snippets say is of right-hand traffic
            episode, route = mirrored_drive(episode), mirrored_route(route)
        return Shown(missing=check_meaning(said, episode, route, through=through))
    found = judge(said, episode, route, through=through)
    touch = None if said.contact is None else said.contact.happens
    return Shown(missing=failures(found, met=met), cut=sum(one.cut for one in found), touch=touch)
