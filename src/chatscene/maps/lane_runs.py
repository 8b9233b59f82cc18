"""Runs of lanes: what a driver sees as one lane between two junctions, however many roads the map cuts it into."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import accumulate
from typing import Any

from chatscene.maps.kept import kept, kept_with_network
from chatscene.terms.polyline import Polyline

_SEAM = 0.5  # [m]; roads of a map that follow one another do not quite touch


@dataclass(frozen=True, slots=True, eq=False)
class LaneRun:
    """Lanes that follow one another without a choice.

    Attributes:
        line: Their centre line [m], map frame.
        ends: Arc length on `line` at which each lane ends [m].
    """

    lanes: tuple[Any, ...]
    line: Polyline
    ends: tuple[float, ...]

    def lane_at(self, s: float) -> Any:
        """The lane at arc length `s` [m]."""
        return next((lane for lane, end in zip(self.lanes, self.ends, strict=True) if s < end), self.lanes[-1])

    def ids_between(self, start: float, end: float) -> tuple[str, ...]:
        """Scenic's ids of the lanes from arc length `start` to `end` [m]."""
        begins = (0.0, *self.ends[:-1])
        spans = zip(self.lanes, begins, self.ends, strict=True)
        return tuple(lane.uid for lane, begin, stop in spans if begin < end and stop > start)


@kept_with_network()
def lane_runs(network: Any) -> dict[str, LaneRun]:
    """The run that each lane outside junctions belongs to, by Scenic's lane id; sorted by id."""
    lanes = {lane.uid: lane for road in network.roads for lane in road.lanes}
    after = {uid: following for uid, lane in lanes.items() if (following := _next(lane)) and following in lanes}
    entries = Counter(after.values())
    after = {uid: following for uid, following in after.items() if entries[following] == 1}
    linked = set(after.values())
    runs: dict[str, LaneRun] = {}
    for first in sorted(lanes, key=lambda uid: (uid in linked, uid)):  # where runs begin; a ring begins anywhere
        if first not in runs:
            chain = _chain(first, after)
            runs |= dict.fromkeys(chain, _run([lanes[uid] for uid in chain]))
    return dict(sorted(runs.items()))


def _chain(first: str, after: dict[str, str]) -> list[str]:
    chain = [first]
    while (following := after.get(chain[-1])) is not None and following != first:
        chain.append(following)
    return chain


def _next(lane: Any) -> str | None:
    """Where a lane leads without a junction and without a choice; a lane that merges into another ends there."""
    if len(lane.maneuvers) != 1 or lane.maneuvers[0].connectingLane is not None:
        return None
    following = lane.maneuvers[0].endLane
    joined = math.dist(lane.centerline.points[-1][:2], following.centerline.points[0][:2]) < _SEAM
    return str(following.uid) if joined else None


def centre_line(lane: Any) -> Polyline:
    """The centre line of a lane [m], map frame, in driving order.

    Without the points at which Scenic's own line steps back by some centimetres, which it does where pieces of a
    reference line or sections of a lane join: a heading taken there would be reversed.
    """
    return kept(lane, "centre_line", _centre_line)


def _centre_line(lane: Any) -> Polyline:
    return Polyline(forward(lane.centerline.points))


def _run(lanes: list[Any]) -> LaneRun:
    lines = [centre_line(lane) for lane in lanes]
    ends = tuple(accumulate(line.length for line in lines))
    return LaneRun(tuple(lanes), Polyline(forward(Polyline.join(*lines).points.tolist())), ends)


def forward(points: Sequence[Sequence[float]]) -> list[tuple[float, float]]:
    """The points [m] of a line without those that step back; see `centre_line`."""
    onward = [(float(x), float(y)) for x, y, *_ in points[:2]]
    for x, y, *_ in points[2:]:
        (x0, y0), (x1, y1) = onward[-2:]
        if (x - x1) * (x1 - x0) + (y - y1) * (y1 - y0) > 0:
            onward.append((float(x), float(y)))
    return onward
