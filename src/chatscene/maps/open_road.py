"""Where on a run of lanes a route without a junction may lie, and the line that it is there."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chatscene.maps.kept import kept
from chatscene.maps.lane_changes import neighbour, shifted, wide_at
from chatscene.maps.lane_runs import LaneRun, centre_line
from chatscene.maps.neighbours import opposes
from chatscene.maps.off_lane import LEFT_BACKWARDS, begun, ended, has_kerb, lanes_across, turned_back
from chatscene.maps.sites import BEFORE_SWERVE, PASSED, along, windows_past
from chatscene.terms.polyline import Polyline
from chatscene.terms.route import Beside, Equipment, RouteQuery
from chatscene.terms.scenario import Maneuver, Place, Site, includes

OPEN_ROAD, SHORT_ROAD = 100.0, 85.0  # [m] of a route without a junction; the shorter where nothing longer fits
MOTORWAYS = (250.0, 150.0)  # [m] the same on a motorway
MOTORWAY_CHANGE = 60.0  # [m] for a change of lanes there
# [m] into the lane, where a route without a junction may start; closer in bends, which are short
FIRST_ONSET, ONSET_STEP, BEND_STEP, FINE_STEP = 10.0, 35.0, 15.0, 2.0
CHANGE_AT, CHANGE_OVER = 30.0, 25.0  # [m], where a lane change begins and how long it takes
# [m], a bypass: the blocker, swinging out and in, passing beside
BLOCKER_AT, SWING, PASSING = 50.0, 22.0, 10.0
FROM_BEHIND = 70.0  # [m] of road behind where a route comes into its lane from beside it, for traffic there
BEHIND_BACK, BEYOND_BACK = 130.0, 20.0  # [m] of road behind, and beyond, where one that is driven backwards begins

_LATERAL = 1.2  # [m] a straight road may move aside: where a lane shifts by more, the ego seems to change lanes
_STRAIGHT_ROAD = math.radians(5)
CURVED_ROAD = math.radians(30)
BENT_BEFORE = math.radians(15)  # by which a bend turns that is driven before something happens
_BENT_FROM_THE_START = 1 / 16  # of the turn in the first eighth of the way: whoever is met early is met in the bend


def turned(line: Polyline, start: float, end: float) -> float:
    """Difference of heading [rad, positive = left] between two arc lengths [m]."""
    return math.remainder(line.heading_at(end) - line.heading_at(start), 2 * math.pi)


_Sought = tuple[LaneRun, Place, float, float, float]


def windows(
    network: Any, run: LaneRun, wanted: Place, query: RouteQuery
) -> Iterator[tuple[float, float, float | None]]:
    """Where a route may start and end on a run [m], and what it leads past lies.

    Only if no long one fits, short ones are looked for closely; but none that is shorter than was asked for.
    """
    site = query.site
    if site is not None and site in PASSED:
        for start, end, past in windows_past(network, run, site, query.approach):
            if site is Site.PAST_BEND:
                straight_at = past - BEFORE_SWERVE * (past - start)
                bent = includes(wanted, _bend_before(run.line, start, straight_at))
                if bent and _shape(run.line, straight_at, end) is Place.ROAD:
                    yield start, end, past
            elif (shape := _shape(run.line, start, end)) is not None and includes(wanted, shape):
                yield start, end, past
        return
    if site is not None and not along(network, run, site):
        return
    apart = BEND_STEP if includes(Place.CURVE, wanted) else ONSET_STEP
    long, short = _lengths(query)
    fitting = kept(network, "_fitting", lambda _: dict[_Sought, tuple[float, ...]]())
    for sought in ((run, wanted, long, FIRST_ONSET, apart), (run, wanted, short, FINE_STEP, FINE_STEP)):
        if sought not in fitting:
            fitting[sought] = tuple(_onsets(*sought))
        if onsets := fitting[sought]:
            yield from ((onset, onset + sought[2], None) for onset in onsets)
            return


def _onsets(run: LaneRun, wanted: Place, length: float, first: float, step: float) -> Iterator[float]:
    """From where on [m] so much of a run [m] is as wanted, and wide enough at both ends."""
    onsets = np.arange(first, run.line.length - length - FINE_STEP, step)
    for onset, shape in zip(onsets.tolist(), _shapes(run.line, onsets, onsets + length), strict=True):
        if shape is not None and includes(wanted, shape) and wide_at(run, onset) and wide_at(run, onset + length):
            yield onset


def _lengths(query: RouteQuery) -> tuple[float, float]:
    """How much of a run a route takes [m], and how much it may take where nothing longer fits."""
    long, short = MOTORWAYS if query.site is Site.MOTORWAY else (OPEN_ROAD, SHORT_ROAD)
    if query.approach is not None:
        long = short = max(query.approach + _beyond(query.maneuver, query.approach), SHORT_ROAD)
    if query.begins in LEFT_BACKWARDS:
        return BEHIND_BACK + BEYOND_BACK, FROM_BEHIND + BEYOND_BACK
    return (long, short) if query.begins is None else (long + FROM_BEHIND, short + FROM_BEHIND)


def _beyond(maneuver: Maneuver, approach: float) -> float:
    """How much road [m] lies beyond where a manoeuvre on open road begins: as much as before it, or in proportion."""
    if maneuver is Maneuver.STRAIGHT:
        return approach
    usual = BLOCKER_AT if maneuver is Maneuver.BYPASS else CHANGE_AT
    return (OPEN_ROAD - usual) * max(1.0, approach / usual)


def _bend_before(line: Polyline, start: float, past: float) -> Place:
    """The side of the bend that lies on the way from one place of a line to another just beyond it; else ROAD."""
    turn = turned(line, start, past)
    bent = abs(turn) > BENT_BEFORE
    return (Place.LEFT_CURVE if turn > 0 else Place.RIGHT_CURVE) if bent else Place.ROAD


def _shape(line: Polyline, start: float, end: float) -> Place | None:
    """ROAD for a straight part of a line, a bend's side for one that bends from its start, None for what is neither."""
    return next(_shapes(line, np.array([start]), np.array([end])))


def _shapes(line: Polyline, starts: NDArray[np.float64], ends: NDArray[np.float64]) -> Iterator[Place | None]:
    """The same, of each of many parts of a line."""
    headings = line.headings_at(np.linspace(starts, ends, 9, axis=-1))
    turns = headings - headings[:, :1]
    turns -= 2 * math.pi * np.rint(turns / (2 * math.pi))
    straight = np.abs(turns).max(axis=-1, initial=0.0) < _STRAIGHT_ROAD
    curved = np.abs(turns[:, -1]) > CURVED_ROAD
    bends = np.divide(turns[:, 1], turns[:, -1], out=np.zeros(len(starts)), where=curved) >= _BENT_FROM_THE_START
    for start, end, turn, is_straight, is_bend in zip(starts, ends, turns[:, -1], straight, bends, strict=True):
        if is_straight:
            # An even bend by `turned` over a length moves a line aside by half their product; what is left is a shift.
            shift = _aside(line, float(start), float(end)) - 0.5 * float(turn) * float(end - start)
            yield Place.ROAD if abs(shift) < _LATERAL else None
        else:
            yield (Place.LEFT_CURVE if turn > 0 else Place.RIGHT_CURVE) if is_bend else None


def _aside(line: Polyline, start: float, end: float) -> float:
    """How far [m] a line has moved to the left of its first direction between two arc lengths."""
    (x0, y0), (x1, y1) = line.point_at(start), line.point_at(end)
    heading = line.heading_at(start)
    return (y1 - y0) * math.cos(heading) - (x1 - x0) * math.sin(heading)


def on_road(
    network: Any, run: LaneRun, onset: float, end: float, past: float | None, query: RouteQuery
) -> tuple[Polyline, tuple[str, ...], float] | None:
    """Line, lanes and event of a route that starts in a run of lanes and does the query's manoeuvre."""
    own = run.line.between(onset, end)
    if query.begins is not None or query.ends is not None:
        return _beside_lane(network, run, onset, end, query)
    if query.maneuver is Maneuver.STRAIGHT:
        return own, run.ids_between(onset, end), own.length / 2 if past is None else past - onset
    bypass = query.maneuver is Maneuver.BYPASS
    into = query.maneuver is Maneuver.LANE_CHANGE_LEFT and query.opposite_lane is True  # the lane of oncoming traffic
    against = into or (bypass and query.opposite_lane is not False)
    usual = BLOCKER_AT if bypass else CHANGE_AT
    event = query.approach or usual
    more = max(1.0, event / usual)  # as fast as an ego is that needs so much road
    swing, passing = SWING * more, PASSING * more
    leaves, returns = (event - passing - swing, event + passing) if bypass else (event, None)
    side = -1 if query.maneuver is Maneuver.LANE_CHANGE_RIGHT else 1
    used = np.linspace(onset + leaves, onset + returns + swing if returns else end, 5).tolist()
    beside = [neighbour(run, s, side) for s in used]
    if any(lane is None or opposes(run.lane_at(s), lane) != against for s, lane in zip(used, beside, strict=True)):
        return None
    if against and len(run.lane_at(onset).group.lanes) > 1:
        return None  # with a second lane of its own a driver need not use the opposite one
    shift = side * abs(centre_line(beside[0]).project(*own.point_at(leaves))[1])
    over = swing if bypass else max(MOTORWAY_CHANGE * (query.site is Site.MOTORWAY), CHANGE_OVER * more)
    lanes = (*run.ids_between(onset, used[0] + over), *dict.fromkeys(lane.uid for lane in beside))
    return shifted(own, shift, leaves, returns, over), lanes, event


def _beside_lane(
    network: Any, run: LaneRun, onset: float, end: float, query: RouteQuery
) -> tuple[Polyline, tuple[str, ...], float] | None:
    """The same of a route that begins or ends beside its lane."""
    own, event = run.line.between(onset, end), query.approach or OPEN_ROAD / 2
    if query.ends is Beside.BACK:
        found = turned_back(network, run, onset, onset + event)
        if found is None:
            return None
        line, lane = found
        return line, (*run.ids_between(onset, onset + event), lane.uid), event
    across = lanes_across(run, onset + event) if query.ends is Beside.DRIVEWAY_ACROSS else 0.0
    if across is None or (not across and not (has_kerb(run, onset) and has_kerb(run, onset + event))):
        return None
    if query.ends is not None:
        return ended(own, query.ends, event, across), run.ids_between(onset, onset + event), event
    starts = end - BEYOND_BACK if query.begins in LEFT_BACKWARDS else onset + FROM_BEHIND
    aisle = Equipment.BAYS in query.has
    line, event = begun(run.line.between(starts, end), query.begins or Beside.KERB, aisle=aisle)
    return line, run.ids_between(starts, end), event
