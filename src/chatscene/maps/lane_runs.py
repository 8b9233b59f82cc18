"""Runs of lanes: what a driver sees as one lane between two junctions, however many roads the map cuts it into."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

from chatscene.terms.polyline import Polyline


@dataclass(frozen=True, slots=True, eq=False)
class LaneRun:
    """Lanes that follow one another without a choice.

    Attributes:
        lanes: Scenic's lanes, in driving order.
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


@lru_cache(maxsize=8)
def lane_runs(network: Any) -> dict[str, LaneRun]:
    """The run that each lane outside junctions belongs to, by Scenic's lane id; sorted by id."""
    lanes = {lane.uid: lane for road in network.roads for lane in road.lanes}
    after = {uid: following for uid, lane in lanes.items() if (following := _next(lane)) in lanes}
    entries = Counter(after.values())
    after = {uid: following for uid, following in after.items() if entries[following] == 1}
    linked = set(after.values())
    runs: dict[str, LaneRun] = {}
    for uid in sorted(lanes, key=lambda u: (u in linked, u)):  # the first of each run first; a ring starts anywhere
        chain: list[str] = []
        while uid not in runs and uid not in chain:
            chain.append(uid)
            uid = after.get(uid, uid)  # noqa: PLW2901 - walks along the run
        if chain:
            runs |= dict.fromkeys(chain, _run([lanes[name] for name in chain]))
    return dict(sorted(runs.items()))


def _next(lane: Any) -> str | None:
    """Where a lane leads without a junction and without a choice."""
    if len(lane.maneuvers) != 1 or lane.maneuvers[0].connectingLane is not None:
        return None
    return str(lane.maneuvers[0].endLane.uid)


def _run(lanes: list[Any]) -> LaneRun:
    lines = [Polyline(lane.centerline.points) for lane in lanes]
    return LaneRun(
        tuple(lanes),
        Polyline.join(*lines),
        tuple(sum(line.length for line in lines[: i + 1]) for i in range(len(lines))),
    )
