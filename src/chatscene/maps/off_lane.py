"""Routes that begin or end beside their lane: at the kerb, in a driveway, or in the lanes of the other direction."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from chatscene.maps.lane_changes import neighbour, shifted, wide_at
from chatscene.maps.lane_runs import LaneRun, lane_runs
from chatscene.maps.neighbours import opposes
from chatscene.terms.polyline import Polyline
from chatscene.terms.route import Beside

KERB = 3.05  # [m] beside the middle of a lane somebody is parked: 1.3 m outside a lane of 3.5 m
OVER = 14.0  # [m] along the road within which a car is at the kerb or gone from there
STRAIGHT = 2.0  # [m] along the kerb at first
CURB_RADIUS = 6.0  # [m] of the bend into a driveway, as the design manuals of streets have for passenger cars
DRIVEWAY = 7.0  # [m] of it that is driven
BAY = 4.0  # [m] that a car backs out of a bay before it turns
AISLE_BAY, AISLE_RADIUS = 0.6, 3.6  # [m] that a car backs out of a bay beside an aisle, and turns then
BACKED = 8.0  # [m] that it backs along its lane then
BACKING = 24.0  # [m] that one backs along its lane that is in it
TIGHTEST = 4.0  # [m] of radius at least, on which a car turns round
BACK = 45.0  # [m] driven after that
LEFT_BACKWARDS = frozenset((Beside.BACKWARDS, Beside.BACK_FROM_DRIVEWAY, Beside.BACK_FROM_BAY))
"""Beginnings of routes that are driven backwards."""
_ARC = 12  # points of a quarter of a circle


def begun(line: Polyline, begins: Beside, *, aisle: bool = False) -> tuple[Polyline, float]:
    """A line along a lane with another beginning, and where it is in the lane [m].

    Args:
        line: Along the lane.
        begins: How it begins.
        aisle: Whether the lane leads between the bays of a car park.
    """
    if begins is Beside.KERB:
        fine = line.resampled(1.0)
        return shifted(fine.offset(-KERB), KERB, STRAIGHT, None, OVER), STRAIGHT + OVER / 2
    if begins is Beside.BACKWARDS:
        along = np.linspace(0.0, -BACKING, 1 + round(BACKING))
        return _beside(line, 0.0, along, np.zeros_like(along)), BACKING / 2
    angle = np.linspace(0.0, math.pi / 2, _ARC)
    if begins in (Beside.BACK_FROM_DRIVEWAY, Beside.BACK_FROM_BAY):
        straight = DRIVEWAY if begins is Beside.BACK_FROM_DRIVEWAY else AISLE_BAY if aisle else BAY
        radius = AISLE_RADIUS if aisle else CURB_RADIUS
        along = np.concatenate(([0.0], radius * (np.cos(angle) - 1.0), [-radius - BACKED]))
        left = np.concatenate(([-radius - straight], radius * (np.sin(angle) - 1.0), [0.0]))
        return _beside(line, 0.0, along, left), straight + radius * (1.0 if aisle else 0.5)  # where others go by
    along = np.concatenate(([0.0], CURB_RADIUS * (1.0 - np.cos(angle))))
    left = np.concatenate(([-CURB_RADIUS - DRIVEWAY], CURB_RADIUS * (np.sin(angle) - 1.0)))
    bend = _beside(line, 0.0, along, left)
    return Polyline.join(bend, line.between(CURB_RADIUS, line.length)), DRIVEWAY + CURB_RADIUS / 2


def ended(line: Polyline, ends: Beside, at: float, across: float = 0.0) -> Polyline:
    """A line along a lane that leaves it at an arc length [m] for the kerb or a driveway on its right, or across.

    Args:
        line: Along the lane.
        ends: What it leaves it for.
        at: Where.
        across: How far [m] the lanes reach to the left of its middle.
    """
    if ends is Beside.KERB:
        return shifted(line.between(0.0, at + OVER + 4.0), -KERB, at, None, OVER)
    to_left = ends is Beside.DRIVEWAY_ACROSS
    radius = max(CURB_RADIUS, across) if to_left else CURB_RADIUS
    angle = np.linspace(0.0, math.pi / 2, _ARC)
    along = np.concatenate((radius * np.sin(angle), [radius]))
    left = np.concatenate((radius * (1.0 - np.cos(angle)), [radius + DRIVEWAY])) * (1.0 if to_left else -1.0)
    return Polyline.join(line.between(0.0, at), _beside(line, at, along, left))


def lanes_across(run: LaneRun, at: float) -> float | None:
    """How far [m] the lanes of the other direction reach to the left of a run's innermost lane; None where none lie."""
    lane = run.lane_at(at)
    there = neighbour(run, at, 1)
    if there is None or not opposes(lane, there):
        return None
    x, y = run.line.point_at(at)
    return abs(Polyline(np.array(there.group.rightEdge.points)[:, :2]).project(x, y)[1])


def turned_back(network: Any, run: LaneRun, start: float, at: float) -> tuple[Polyline, Any] | None:
    """A way along a run that turns round to the left, into the outermost lane of the other direction.

    Args:
        network: Scenic's road network.
        run: The lanes that it goes along.
        start: Where it begins on them [m].
        at: Where it turns [m].

    Returns:
        The way and that lane; None if there is none, or it lies too near to turn into.
    """
    group = run.lane_at(at).group._opposite
    if group is None:
        return None
    runs = lane_runs(network)
    point, found = run.line.point_at(at), None
    for lane in group.lanes:
        other = runs[lane.uid]
        aside = abs(other.line.project(*point)[1])
        if wide_at(other, other.line.project(*point)[0]) and (found is None or aside > found[0]):
            found = aside, other
    if found is None or (radius := found[0] / 2) < TIGHTEST:
        return None
    other = found[1]
    angle = np.linspace(0.0, math.pi, 2 * _ARC)
    half = _beside(run.line, at, radius * np.sin(angle), radius * (1.0 - np.cos(angle)))
    level = other.line.project(*half.points[-1].tolist())[0]
    end = min(level + BACK, other.line.length)
    if end - level < BACK / 2:
        return None
    line = Polyline.join(run.line.between(start, at), half, other.line.between(level, end))
    return line, other.lane_at(level)


def has_kerb(run: LaneRun, at: float) -> bool:
    """Whether a run is the outermost of its direction at an arc length [m]."""
    return neighbour(run, at, -1) is None


def _beside(line: Polyline, at: float, along: Any, left: Any) -> Polyline:
    """Points so far along a line from one on it, and beside it, where the line goes straight on."""
    (x, y), heading = line.point_at(at), line.heading_at(at)
    ahead, aside = np.array((math.cos(heading), math.sin(heading))), np.array((-math.sin(heading), math.cos(heading)))
    return Polyline(np.array((x, y)) + np.outer(along, ahead) + np.outer(left, aside))
