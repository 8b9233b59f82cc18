"""Which roads of a map lead from one place on a road to another, and where one is after so many metres of them."""

from __future__ import annotations

import heapq
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from chatscene.maps.lane_curves import DrawnRoad

_OTHER = {"start": "end", "end": "start"}
OnRoad = tuple[str, float]  # a road and an arc length on its reference line [m]


@dataclass(frozen=True, slots=True)
class Stretch:
    """A part of a road that is gone along.

    Attributes:
        first: Where it begins on the road's reference line [m].
        last: Where it ends there [m].
        way: 1 where it is gone along the line, -1 where it is gone against it.
    """

    road: str
    first: float
    last: float
    way: int

    @property
    def length(self) -> float:
        """[m]."""
        return abs(self.last - self.first)


def reached(way: Sequence[Stretch], along: float) -> tuple[Stretch, float]:
    """The stretch of a way in which one is after so many metres, and how far along it; the last holds what is beyond.

    Args:
        way: One stretch at least.
        along: From its beginning [m].
    """
    *before, last = way
    for part in before:
        if along <= part.length:
            return part, along
        along -= part.length
    return last, along


def roads_between(roads: Mapping[str, DrawnRoad], begin: OnRoad, goal: OnRoad) -> list[Stretch] | None:
    """The shortest way by roads, whichever way they run, from one place to another; None where there is none."""
    (name, s), (last, to) = begin, goal
    if name == last:
        return [Stretch(name, s, to, 1 if to >= s else -1)]
    waiting: list[tuple[float, int, str, list[Stretch]]] = []
    for at in ("start", "end"):
        part = _left_at(roads, name, s, at)
        waiting.append((part.length, len(waiting), at, [part]))
    heapq.heapify(waiting)
    seen, count = set[tuple[str, str]](), len(waiting)
    while waiting:
        gone, _, at, way = heapq.heappop(waiting)
        if way[-1].road == last and len(way) > 1:
            return way
        for following, entered in _after(roads, way[-1].road, at):
            if (following, entered) in seen:
                continue
            seen.add((following, entered))
            enters = 0.0 if entered == "start" else roads[following].length
            leaves = _OTHER[entered]
            part = _left_at(roads, following, enters, leaves)
            part = replace(part, last=to) if following == last else part
            heapq.heappush(waiting, (gone + part.length, count, leaves, [*way, part]))
            count += 1
    return None


def _left_at(roads: Mapping[str, DrawnRoad], name: str, s: float, at: str) -> Stretch:
    return Stretch(name, s, 0.0, -1) if at == "start" else Stretch(name, s, roads[name].length, 1)


def _after(roads: Mapping[str, DrawnRoad], name: str, at: str) -> Iterator[tuple[str, str]]:
    """The roads to which one leads at its start or end, each with the end at which it is entered."""
    end = roads[name].ends.get(at)
    if end is not None and end.kind == "road" and end.number in roads:
        yield end.number, end.contact
    elif end is not None and end.kind == "junction":
        for number, road in roads.items():
            if road.junction == end.number:
                for side, led in road.ends.items():
                    if led.kind == "road" and led.number == name and led.contact == at:
                        yield number, side
