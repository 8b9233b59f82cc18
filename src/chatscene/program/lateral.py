"""Where across the road somebody is seen: beside the middle of its lane, or of the ego's width."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from chatscene.program.deeds import Act
from chatscene.program.finding import Finding
from chatscene.program.watching import Seen, moved_over
from chatscene.terms.amount import Amount
from chatscene.terms.arrays import Array
from chatscene.terms.lateral import seen_of_ego
from chatscene.terms.situation import LATERALS, Deed, Lateral, Other, Start
from chatscene.terms.vocabulary import ASIDE, Heads, Side, Where, acts_of
from chatscene.terms.vocabulary import Act as Said

SLACK, LEAST_ASIDE = 0.15, 0.2  # of a number that was said; [m], the least of it
LEAST_SHARE = 0.1  # of the ego's width
LANE = 3.5  # [m], a lane's width
STEADY = 5  # [steps] over which somebody keeps its line that goes on there
KEEPS = 0.15  # [m] to a side in these, at most
_BESIDE = frozenset((Where.AHEAD_BESIDE, Where.BESIDE, Where.BEHIND_BESIDE, Where.ONCOMING))
_IN_ITS_OWN = ASIDE | acts_of(Heads.ALONG)
_ALONG = frozenset((Where.AHEAD, Where.KERB))
_OF_EGO = frozenset(("overlap", "clearance"))
"""What is said of the ego's width, or of the room beside it: on which side of the ego, and not of a lane."""


def is_aside(start: Start, seen: Seen) -> bool:
    """Whether somebody is ahead whose place across the road was said, which has a finding of its own."""
    return start.lateral is not None and start.where in _ALONG and bool(seen.lead[0] > 0.0)


def of_lateral(
    said: Lateral, one: Other, path: str, seen: Seen, deed: Deed | None = None, once: Act | None = None
) -> Iterator[Finding]:
    """Whether somebody starts, or goes on after a deed, where it was said to be across the road."""
    told = ((name, said_so) for name in LATERALS if (said_so := getattr(said, name)) is not None)
    name, amount = next(told, ("", None))
    if amount is None:
        left = (seen.offset[:1] if once is None else _kept(seen, once)) - _lane(one, deed)
        right = bool((left > 0.0 if said.side is Side.LEFT else left < 0.0).any())
        yield Finding(path=f"{path}.side", shown=right, told=f"said {said.side}, it is {left[-1]:.1f} m left")
        return
    if name == "beyond":
        yield _finding(f"{path}.{name}", amount, _beside_lanes(float(seen.offset[0])), share=False)
        return
    passes = name == "clearance" and (deed is None or deed.act is Said.OVERTAKE)
    left = _where_it_passes(seen) if passes else None
    if (
        passes
        and left is None
        and deed is None
        and seen.line.length
        and bool(np.ptp(moved_over(seen.route)) > LANE / 2)
    ):
        yield Finding(path=f"{path}.{name}", shown=None, told=f"said {amount}, the ego does not get by it")
        return
    if left is None:
        left = seen.offset[:1] if once is None else _kept(seen, once)
    sides = _values(name, left, one, seen, deed, said.side)
    yield _finding(f"{path}.{name}", amount, sides, share=name == "overlap")
    if said.side is not None:
        middle = 0.0 if name in _OF_EGO else _lane(one, deed)
        right = bool(((left - middle > 0.0) == (said.side is Side.LEFT)).any()) or bool(
            (np.abs(left - middle) < LEAST_ASIDE).any()
        )
        yield Finding(path=f"{path}.side", shown=right, told=f"said {said.side}, it is {left[-1] - middle:.1f} m left")


def _beside_lanes(offset: float) -> Array:
    """How far [m] beside the lanes somebody is, with none or some of them between its side and the ego's lane."""
    aside = abs(offset) - 0.5 * LANE
    return aside - LANE * np.arange(max(1, int(aside // LANE) + 1))


def _lane(one: Other, deed: Deed | None) -> float:
    """How far [m] to the left of the ego's line the middle of the lane is that somebody is in."""
    if one.starts.where not in _BESIDE or (deed is not None and deed.act not in _IN_ITS_OWN):
        return 0.0
    return LANE if one.starts.where is Where.ONCOMING or one.starts.side is not Side.RIGHT else -LANE


def _values(name: str, left: Array, one: Other, seen: Seen, deed: Deed | None, side: Side | None) -> Array:
    ego, other = seen.ego.width, seen.track.width
    if name in _OF_EGO:
        sign = np.sign(left) if side is None else np.full_like(left, 1.0 if side is Side.LEFT else -1.0)
        if name == "clearance":
            sign = np.sign(left)
        return np.array([seen_of_ego(name, float(at), ego, other) for at in left * sign])
    aside: Array = np.abs(left - _lane(one, deed))
    return aside if name == "offset" else 0.5 * LANE - aside


def _where_it_passes(seen: Seen) -> Array | None:
    """How far [m] to the left of the ego somebody is while the two are side by side; None if they never are."""
    ego, track = seen.ego, seen.track
    cos, sin = np.cos(ego.heading), np.sin(ego.heading)
    dx, dy = track.x - ego.x, track.y - ego.y
    along, left = dx * cos + dy * sin, dy * cos - dx * sin
    beside = np.abs(along) < 0.5 * (ego.length + track.length)
    beside &= np.abs(left) > 0.5 * (ego.width + track.width)
    if not beside.any():
        return None
    return left[[int(np.flatnonzero(beside)[np.abs(left[beside]).argmin()])]]


def _kept(seen: Seen, once: Act) -> Array:
    """(N,) [m], the lines to the left of the ego's that somebody keeps for some steps since a deed began."""
    offset = seen.offset[once.began :]
    if len(offset) <= STEADY:
        return offset[-1:]
    windows = np.lib.stride_tricks.sliding_window_view(offset, STEADY)
    steady = windows.mean(axis=1)[np.ptp(windows, axis=1) < KEEPS]
    return steady if steady.size else offset[-1:]


def _finding(path: str, said: Amount, values: Array, *, share: bool) -> Finding:
    aim = said.low if np.isfinite(said.low) else said.high
    slack = max(LEAST_SHARE if share else LEAST_ASIDE, SLACK * aim)
    right = bool(((values >= said.low - slack) & (values <= said.high + slack)).any())
    nearest = float(values[np.abs(values - aim).argmin()])
    told = f"{100 * nearest:.0f} %" if share else f"{nearest:.2f} m"
    return Finding(path=path, shown=right, told=f"said {said}, it is at {told}")
