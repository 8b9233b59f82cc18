"""Which part of a drive is worth looking at: from shortly before what happened in it to shortly after."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from chatscene.measure.happening import happened
from chatscene.terms.episode import Episode

LEAD = 4.0  # [s] before it
AFTER = 1.5  # [s] after it, at least
WITHIN = 10.0  # [m] farther apart than at their nearest, ego and adversary are still at it
STILL = 0.2  # [m/s] of drawing near or apart, at most, at which they have come to terms; slower than which one stands
STANDS = 0.5  # [s] for which who stands is shown


@dataclass(frozen=True, slots=True, kw_only=True)
class Span:
    """The part of a drive that is shown first; all are steps.

    Attributes:
        moment: When it happened; when the ego was nearest to somebody, if nothing did.
    """

    first: int
    moment: int
    last: int


def span(episode: Episode) -> Span:
    """The part of a drive that is shown first; the whole of one in which nobody is to be met.

    Two that drive side by side are nearest before one cuts in: so it is not over as long as they are about as near and
    still draw nearer or apart. From where all stand a picture would be a still, so that it ends soon after that.
    """
    end, dt = len(episode.ego_track.x) - 1, episode.dt
    if not episode.adversaries and episode.collision is None:
        return Span(first=0, moment=end, last=end)
    moment = happened(episode).step
    after = moment + round(AFTER / dt)
    if episode.collision is not None:
        return Span(first=max(moment - round(LEAD / dt), 0), moment=moment, last=min(after, end))
    ego = episode.ego_track
    apart = np.min([np.hypot(one.x - ego.x, one.y - ego.y) for one in episode.adversaries], axis=0)
    moving = np.abs(np.diff(apart, prepend=apart[0])) > STILL * dt
    still_open = np.flatnonzero(moving & (apart < apart[moment] + WITHIN))
    speeds = np.max([np.abs(one.speed) for one in (ego, *episode.adversaries)], axis=0)
    stand = int(np.flatnonzero(speeds > STILL).max(initial=0)) + round(STANDS / dt)
    last = min(max(after, int(still_open.max(initial=0))), stand, end)
    moment = min(moment, last)  # all have come to stand before, and stay as near as they are
    return Span(first=max(moment - round(LEAD / dt), 0), moment=moment, last=last)
