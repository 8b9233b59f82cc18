"""Where routes lie that a `Site` asks for: through roundabouts, on and off ramps, past crosswalks and bays."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping
from typing import Any

import numpy as np
import shapely

from chatscene.maps.car_parks import car_parks
from chatscene.maps.furniture import Stand, furniture_of
from chatscene.maps.junctions import junction_control
from chatscene.maps.lane_changes import changed, neighbour, wide_at
from chatscene.maps.lane_runs import LaneRun, centre_line, lane_runs
from chatscene.maps.layout import JunctionKind, motorway_groups, ramp_ways, weaving_sections
from chatscene.maps.limits import is_called
from chatscene.maps.neighbours import opposes, section_beside
from chatscene.maps.ring_routes import ENTRIES, Way, ways_round
from chatscene.terms.polyline import Polyline
from chatscene.terms.route import Route, RouteQuery
from chatscene.terms.scenario import Control, Maneuver, Place, Site

AT_JUNCTIONS = (
    Site.ROUNDABOUT,
    Site.ON_RAMP,
    Site.OFF_RAMP,
    Site.PAST_ON_RAMP,
    Site.PAST_OFF_RAMP,
    Site.WEAVING,
    Site.LANE_DROP,
)

RAMP = 60.0  # [m] of a ramp that is driven
MAIN = 100.0  # [m] of the road beside it
CHANGES = (20.0, 35.0, 50.0, 5.0)  # [m] from a ramp's nose to where a change of lanes begins, or is over
OVER, AFTER = 50.0, 40.0  # [m] for a change of lanes, and in the other lane afterwards
BEFORE = 40.0  # [m] in a lane before it is left
JOINED = 2.0  # [m] behind the nose of an on-ramp
BEYOND = (5.0, 20.0, 35.0, 50.0)  # [m] from the nose of an on-ramp to where a route past it begins
AHEAD = (75.0, 65.0, 85.0, 55.0)  # [m] from where a route past an off-ramp begins to its nose
PAST = (55.0, 45.0, 65.0, 35.0)  # [m] from a route's start to what it leads past
ROAD = 100.0  # [m] of such a route
BEND_STEP, STRAIGHT = 5.0, 1 / 1500  # [m], [1/m]: a road that turns less within a step is straight
BEFORE_SWERVE = 0.64  # of the way up to whom an ego swings out round, on which it does so: that is beyond the bend
PASSED = frozenset(
    (
        *(Site.CROSSWALK, Site.PARKING, Site.BUS_BAY, Site.RAIL_CROSSING),
        *(Site.DRIVEWAY, Site.DRIVEWAY_LEFT, Site.PAST_LANE_DROP, Site.PAST_LANE_DROP_LEFT, Site.PAST_BEND),
    )
)
"""What a route on open road leads past."""
APPROACHED: Mapping[Site, float] = {
    Site.ROUNDABOUT: ENTRIES[0],
    Site.ON_RAMP: RAMP,
    Site.OFF_RAMP: MAIN,
    Site.WEAVING: RAMP,
    Site.PAST_ON_RAMP: (MAIN + OVER) / 2,
    Site.PAST_OFF_RAMP: AHEAD[0],
    Site.LANE_DROP: BEFORE,
}
"""How far [m] a route usually leads up to what it leads to. If it is to be longer, all of it is, in proportion."""

Found = tuple[str, Route]  # what to spread over, and the route, without an id


def routes_at(network: Any, map_name: str, query: RouteQuery, variant: int) -> Iterator[Found]:
    """The routes of a map at a site that is one of `AT_JUNCTIONS`; later variants begin elsewhere."""
    site = query.site
    further = 1.0 if query.approach is None or site is None else query.approach / APPROACHED[site]
    if site is Site.ROUNDABOUT:
        ways = ways_round(network, query, ENTRIES[variant] * further)
    elif site is Site.LANE_DROP:
        ways = _out_of_ending_lanes(network, query.maneuver, variant, further)
    elif site is Site.PAST_ON_RAMP or site is Site.PAST_OFF_RAMP:
        ways = _past_ramps(network, query, variant, further)
    else:
        ways = _at_ramps(network, query, variant, further)
    for group, maneuver, line, lanes, event_at, junction in ways:
        if maneuver is query.maneuver:
            control = Control.NONE if junction is None else junction_control(junction)
            yield (
                group,
                Route(
                    id="",
                    map_name=map_name,
                    maneuver=maneuver,
                    place=Place.ROAD if junction is None else Place.JUNCTION,
                    control=control,
                    line=line.resampled(1.0),
                    lane_ids=tuple(dict.fromkeys(lanes)),
                    event_at=event_at,
                    junction=None if junction is None else str(junction.uid),
                ),
            )


def _at_ramps(network: Any, query: RouteQuery, variant: int, further: float) -> Iterator[Way]:
    weaves = weaving_sections(network)
    weaving = query.site is Site.WEAVING
    on = Site.ON_RAMP if not weaving else Site.WEAVING
    off = Site.OFF_RAMP if not weaving else Site.WEAVING
    merges, diverges = {weave.merge for weave in weaves}, {weave.diverge for weave in weaves}
    if query.site is on and query.maneuver in (Maneuver.STRAIGHT, Maneuver.LANE_CHANGE_LEFT):
        for way in ramp_ways(network, JunctionKind.MERGE):
            if not weaving or way.intersection.uid in merges:
                yield from _on(network, way, query, variant, further)
    if query.site is off and query.maneuver in (Maneuver.STRAIGHT, Maneuver.LANE_CHANGE_RIGHT):
        for way in ramp_ways(network, JunctionKind.DIVERGE):
            if query.site is Site.OFF_RAMP or way.intersection.uid in diverges:
                yield from _off(network, way, query, variant, further)


def _on(network: Any, way: Any, query: RouteQuery, variant: int, further: float) -> Iterator[Way]:
    """Down a ramp onto another road, and, for a lane change, into the lane to the left.

    If there must be a second lane where it begins, it begins where the ramp has joined the road.
    """
    maneuver = query.maneuver
    runs = lane_runs(network)
    before, after = runs[way.startLane.uid], runs[way.endLane.uid]
    changes, over = CHANGES[variant] * further, OVER * further
    start = max(before.line.length - RAMP * further, 0.0)
    if start <= 0.0 and further > 1.0:
        return  # the ramp is too short to come by it so fast
    ramp = Polyline.join(before.line.between(start, before.line.length), centre_line(way.connectingLane))
    ids = (*before.ids_between(start, before.line.length), way.connectingLane.uid)
    if maneuver is Maneuver.STRAIGHT:
        end = min(MAIN * further + changes, after.line.length)
        while further > 1.0 and end > 0.0 and not wide_at(after, end):
            end -= 5.0
        if end >= MAIN * further / 2 and wide_at(after, end):
            line = Polyline.join(ramp, after.line.between(0.0, end))
            yield way.startLane.uid, maneuver, line, (*ids, *after.ids_between(0.0, end)), ramp.length, None
        return
    at = changes
    beside = _beside(after, at, at + over)
    if beside is not None:
        target = runs[beside.uid]
        if query.lanes_same_way > 1:
            line = changed(after.line.between(JOINED, after.line.length), target.line, at, over, AFTER * further)
            lanes = (*after.ids_between(JOINED, JOINED + at), *_ids_to(target, line, further))
            yield way.startLane.uid, maneuver, line, lanes, at, None
            return
        line = changed(Polyline.join(ramp, after.line), target.line, ramp.length + at, over, AFTER * further)
        lanes = (*ids, *after.ids_between(0.0, at), *_ids_to(target, line, further))
        yield way.startLane.uid, maneuver, line, lanes, ramp.length + at, None


def _off(network: Any, way: Any, query: RouteQuery, variant: int, further: float) -> Iterator[Way]:
    """Off a road by a ramp, for a lane change from the lane to the left of the one that leads there.

    If a lane must lie to the right of where it begins, that is as wide there, and some way before, as others.
    """
    maneuver = query.maneuver
    runs = lane_runs(network)
    before, after = runs[way.startLane.uid], runs[way.endLane.uid]
    changes, over = CHANGES[variant] * further, OVER * further
    nose, end = before.line.length, min(RAMP * further, after.line.length)
    ramp = (centre_line(way.connectingLane), after.line.between(0.0, end))
    ids = (way.connectingLane.uid, *after.ids_between(0.0, end))
    if maneuver is Maneuver.STRAIGHT:
        start = max(nose - MAIN * further - changes, 2.0)
        while start < nose and not wide_at(before, start):
            start += 5.0
        if nose - start >= MAIN * further / 2:
            line = Polyline.join(before.line.between(start, nose), *ramp)
            yield way.startLane.uid, maneuver, line, (*before.ids_between(start, nose), *ids), nose - start, None
        return
    at = nose - changes - over
    beside = _beside(before, at, at + over) if at > 0 else None
    if query.lane_beside == "right" and not wide_at(before, max(at - 2 * BEFORE * further, 0.0)):
        return
    if beside is not None:
        source = runs[beside.uid]
        level = source.line.project(*before.line.point_at(at))[0]
        start = max(level - BEFORE * further, 2.0)
        if start == 2.0 and further > 1.0:
            return  # there is too little road to come by so fast
        line = changed(
            source.line.between(start, source.line.length),
            Polyline.join(before.line.between(max(at - 5.0, 0.0), nose), *ramp),
            level - start,
            over,
            further=math.inf,
        )
        lanes = (*source.ids_between(start, level), *before.ids_between(at, nose), *ids)
        yield way.startLane.uid, maneuver, line, lanes, level - start, None


def _past_ramps(network: Any, query: RouteQuery, variant: int, further: float) -> Iterator[Way]:
    """Straight on in the lane beside the one that comes from a ramp or leads into one, or in one that is asked for."""
    runs = lane_runs(network)
    over = 1 if query.lane is None or query.lane < 0 else query.lane - 1
    if query.site is Site.PAST_ON_RAMP:
        for way in ramp_ways(network, JunctionKind.MERGE):
            start = BEYOND[variant]
            beside = _lanes_over(network, runs[way.endLane.uid], start, over)
            if beside is None:
                continue
            run = runs[beside.uid]
            end = min(start + (MAIN + OVER) * further, run.line.length)
            if end - start >= MAIN * further:
                line, lanes = run.line.between(start, end), run.ids_between(start, end)
                yield way.startLane.uid, Maneuver.STRAIGHT, line, lanes, line.length / 2, None
        return
    for way in ramp_ways(network, JunctionKind.DIVERGE):
        leading = runs[way.startLane.uid]
        beside = _lanes_over(network, leading, leading.line.length - 1.0, over)
        if beside is None:
            continue
        on = [m for m in way.intersection.maneuvers if m.startLane.uid == beside.uid]
        if not on:
            continue
        before, after = runs[beside.uid], runs[on[0].endLane.uid]
        ahead = AHEAD[variant] * further
        start, end = before.line.length - ahead, min(MAIN * further, after.line.length)
        if start >= 2.0 and end >= MAIN * further / 2:
            line = Polyline.join(
                before.line.between(start, before.line.length),
                centre_line(on[0].connectingLane),
                after.line.between(0.0, end),
            )
            lanes = (*before.ids_between(start, before.line.length), on[0].connectingLane.uid)
            yield (
                way.endLane.uid,
                Maneuver.STRAIGHT,
                line,
                (*lanes, *after.ids_between(0.0, end)),
                ahead,
                None,
            )


def _lanes_over(network: Any, run: LaneRun, at: float, over: int) -> Any:
    """The lane of the same direction so many lanes to the left of a run at an arc length [m]; None if there is none."""
    lane, point = None, run.line.point_at(at)
    for _ in range(over):
        lane = neighbour(run, at, 1)
        if lane is None or opposes(run.lane_at(at), lane):
            return None
        run = lane_runs(network)[lane.uid]
        at = run.line.project(*point)[0]
    return lane


def _out_of_ending_lanes(network: Any, maneuver: Maneuver, variant: int, further: float) -> Iterator[Way]:
    """Out of each lane that tapers out, into the lane beside it."""
    side = {Maneuver.LANE_CHANGE_LEFT: 1, Maneuver.LANE_CHANGE_RIGHT: -1}.get(maneuver)
    runs = lane_runs(network)
    for run in dict.fromkeys(runs.values()):
        last = _tapers_at(run)
        if side is None or last is None:
            continue
        before, over = BEFORE * further, OVER * further
        at = last - CHANGES[variant] * further - over
        beside = _beside(run, at, at + over, side) if at > before else None
        if beside is not None:
            target = runs[beside.uid]
            line = changed(run.line.between(at - before, run.line.length), target.line, before, over, AFTER * further)
            lanes = (*run.ids_between(at - before, at), *_ids_to(target, line, further))
            yield run.lanes[-1].uid, maneuver, line, lanes, before, None


def _beside(run: LaneRun, start: float, end: float, side: int = 1) -> Any:
    """The lane of the same direction beside a run from one arc length to another [m], at the second; else None."""
    lanes = [neighbour(run, s, side) if s < run.line.length else None for s in (start, (start + end) / 2, end)]
    if any(lane is None or opposes(run.lane_at(s), lane) for lane, s in zip(lanes, (start, start, end), strict=True)):
        return None
    return lanes[-1]


def _ids_to(run: LaneRun, line: Polyline, further: float) -> tuple[str, ...]:
    """The lanes of a run level with the last part of a line that ends on it."""
    ends = [run.line.project(*line.point_at(s))[0] for s in (line.length - (AFTER + OVER) * further, line.length)]
    return run.ids_between(*ends)


# Along roads


def windows_past(
    network: Any, run: LaneRun, site: Site, approach: float | None = None
) -> list[tuple[float, float, float]]:
    """Where a route along a run may start and end, and what it leads past lies, all in arc lengths of the run [m]."""
    if site is Site.CROSSWALK:
        marks = _begins(run, furniture_of(network).crosswalks)
    elif site is Site.RAIL_CROSSING:
        marks = _begins(run, ((road, area) for road, area, across in furniture_of(network).tracks if across))
    elif site in _DROPS:
        marks = list(_lanes_end_beside(network, run, _DROPS[site]))
    elif site is Site.PAST_BEND:
        marks = [at + BEFORE_SWERVE * (approach or PAST[0]) for at in bends_end(run)]
    elif site in _DRIVEWAYS:
        marks = _driveways_beside(network, run, right=_DRIVEWAYS[site])
    else:
        marks = _bays_beside(network, run, Stand.PARKING if site is Site.PARKING else Stand.BUS)
    further = 1.0 if approach is None else approach / PAST[0]
    road = ROAD * max(further, 1.0)
    return [
        (at - before, at - before + road, at)
        for before in (further * one for one in (PAST[:1] if site in _AS_ASKED else PAST))
        for at in marks
        if at - before >= 2.0 and at - before + road < run.line.length
    ]


def _begins(run: LaneRun, areas: Iterable[tuple[int, shapely.Polygon]]) -> list[float]:
    """Where on a run [m] those areas begin that lie across it, of areas by the OpenDRIVE id of their road."""
    roads = {lane.road.id for lane in run.lanes}
    on = [area for road, area in areas if road in roads and any(lane.polygons.intersects(area) for lane in run.lanes)]
    return [min(run.line.project(x, y)[0] for x, y, *_ in area.exterior.coords) for area in on]


_DRIVEWAYS = {Site.DRIVEWAY: True, Site.DRIVEWAY_LEFT: False}
"""On which side of a route the driveway lies: the right or not."""
_DROPS = {Site.PAST_LANE_DROP: -1, Site.PAST_LANE_DROP_LEFT: 1}
"""On which side of a route a lane ends: 1 is its left."""
_AS_ASKED = frozenset((*_DRIVEWAYS, *_DROPS, Site.PAST_BEND))
"""What is as far ahead on each route."""


def _lanes_end_beside(network: Any, run: LaneRun, side: int) -> Iterator[float]:
    """Where on a run [m] a lane beside it is no longer one to drive on, since it tapers out."""
    for other in dict.fromkeys(lane_runs(network).values()):
        if other is run or (last := _tapers_at(other)) is None:
            continue
        at = run.line.project(*other.line.point_at(last - 1.0))[0]
        beside = neighbour(run, at, side) if 0.0 < at < run.line.length else None
        if beside is not None and not opposes(run.lane_at(at), beside) and beside in other.lanes:
            yield at


def _tapers_at(run: LaneRun) -> float | None:
    """Where [m] a run becomes too narrow to drive on, as it ends; None if it does not end so."""
    last = run.line.length
    if run.lanes[-1].maneuvers or wide_at(run, last):
        return None
    while last > 0 and not wide_at(run, last):
        last -= 2.0
    return last


def bends_end(run: LaneRun) -> list[float]:
    """Where on a run [m] it is straight again after a bend."""
    at = np.arange(0.0, run.line.length, BEND_STEP)
    turns = np.diff(np.unwrap(run.line.headings_at(at))) / BEND_STEP
    straight = np.abs(turns) < STRAIGHT
    return [float(at[i + 1]) for i in np.flatnonzero(~straight[:-1] & straight[1:])]


def _driveways_beside(network: Any, run: LaneRun, *, right: bool) -> list[float]:
    """Where driveways begin beside a run, on its right or its left."""
    roads = {lane.road.id for lane in run.lanes}
    found: list[float] = []
    for _, area in (one for one in furniture_of(network).driveways if one[0] in roads):
        if (run.line.project(area.centroid.x, area.centroid.y)[1] < 0.0) is right:
            found.append(min(run.line.project(x, y)[0] for x, y, *_ in area.exterior.coords))
    return found


def _bays_beside(network: Any, run: LaneRun, use: Stand) -> list[float]:
    """Where bays begin beside a run's outermost lane."""
    marks: list[float] = []
    for lane in run.lanes:
        if any(section._laneToRight is not None for section in lane.sections):
            continue
        forward = lane.group is lane.road.forwardLanes
        reference = Polyline([p[:2] for p in lane.road.centerline.points])
        marks += [
            run.line.project(*reference.point_at(place.start if forward else place.end))[0]
            for place in furniture_of(network).standing
            if (place.road, place.forward, place.use) == (lane.road.id, forward, use)
        ]
    return marks


def along(network: Any, run: LaneRun, site: Site) -> bool:
    """Whether a run lies on a motorway or on a rural road."""
    if site is Site.MOTORWAY:
        groups = {group.uid for group in motorway_groups(network)}
        return all(lane.group.uid in groups for lane in run.lanes)
    both = [(lane.group, _opposite(lane)) for lane in run.lanes]
    if not car_parks(network).isdisjoint(lane.road.id for lane in run.lanes):
        return False
    narrow = all(g is None or (len(g.lanes) == 1 and g._sidewalk is None) for groups in both for g in groups)
    return narrow and all(there is not None or is_called(network, own.road.id, "rural") for own, there in both)


def _opposite(lane: Any) -> Any:
    """The lanes of the other direction of a lane's street, in its own road or in another; None if there are none."""
    if lane.group._opposite is not None:
        return lane.group._opposite
    there = section_beside(lane.sections[0], 1)
    return None if there is None else there.lane.group
