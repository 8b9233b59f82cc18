"""What a drive does not show of what was said, whether that is a situation or what a sentence gave."""

from __future__ import annotations

from chatscene.program.judge import failures, judge
from chatscene.program.meaning import check_meaning
from chatscene.terms.episode import Episode
from chatscene.terms.route import Route
from chatscene.terms.scenario import Said
from chatscene.terms.situation import Situation


def not_shown(
    said: Said, episode: Episode, route: Route, *, through: bool = False, met: bool = True
) -> tuple[str, ...]:
    """What a drive does not show, a sentence each; empty if it means what was said.

    Args:
        said: What was said.
        episode: What happened.
        route: The ego's route.
        through: Judge to the end a drive that went on through a collision.
        met: Whether encounters count, and what nobody said: a search is still to find drives that are right in both.
    """
    if isinstance(said, Situation):
        return failures(judge(said, episode, route, through=through), met=met)
    return check_meaning(said, episode, route, through=through)
