"""Other vehicles' ways into and round a roundabout that meet the ego's route."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np

from chatscene.maps.crossings import MEETING, CrossingPath, from_side_of
from chatscene.maps.kept import kept_with_network
from chatscene.maps.lane_runs import centre_line, lane_runs
from chatscene.maps.layout import Ring, roundabouts
from chatscene.maps.neighbours import neighbour_line, opposes, section_beside
from chatscene.terms.polyline import Polyline
from chatscene.terms.route import Route
from chatscene.terms.scenario import Maneuver

ROUND = "round"
"""From where somebody comes who goes round in the roundabout already."""
_ENTERS = 10.0  # [m] before the ego is in the ring, where others may meet it
_STEP = 1.0  # [m] between the points of a way that is compared with the ego's
_OPPOSITE = math.radians(45)  # from right opposite an entry, up to which an exit is that by which one goes straight on
_RUN_UP = 75.0  # [m] in the ring, at least, before who goes round in it meets the ego
_LAP = 0.3  # of the ring, behind which it leads back to the ego's entry


@kept_with_network(256)
def ring_ways(network: Any, route: Route) -> tuple[CrossingPath, ...]:
    """The ways of others in the roundabout that a route leads through, that meet it.

    Returns:
        By where they come from: ``round``, who is in the ring when it begins and comes to the ego's entry; then who
        enters from the arms to the ``left``, ``right`` and ``oncoming``, as the ego sees them from its entry. Who
        enters goes straight on: it leaves by the exit opposite its entry. Where it would be out before it meets the
        ego, it goes round, and its turn is to the left.
    """
    ring, into = _entered(network, route)
    if ring is None:
        return ()
    inside = route.line.project(*centre_line(into.endLane).point_at(0.0))[0]
    own = ring.track(into.endLane.uid)
    tracks = sorted((ring.track(_level(network, track, into)) for track in ring.tracks), key=lambda one: one != own)
    laps = [_line(network, track) for track in tracks]
    found = [_goes_round(lap, route, inside) for lap in laps]
    for entry in sorted(ring.entries(network), key=lambda entry: entry.endLane.uid not in own):
        if entry.startLane.group is into.startLane.group:
            continue
        before = lane_runs(network)[entry.startLane.uid].line
        side = from_side_of(before.heading_at(before.length - 1.0) - route.line.heading_at(route.event_at - 1.0))
        if side is None:
            continue
        comes = Polyline.join(before, centre_line(entry.connectingLane))
        laps = _line(network, ring.track(entry.endLane.uid))
        circles = _met(Polyline.join(comes, laps), before.length, side, route, inside, before.length)
        if circles is None:
            continue
        out = _out(network, ring, entry)
        leaves = (
            None if out is None else _met(Polyline.join(comes, out), before.length, side, route, inside, before.length)
        )
        straight = leaves is not None and abs(leaves.meets_at - circles.meets_at) <= _STEP
        found.append(leaves if straight else replace(circles, turn=Maneuver.LEFT_TURN))
    order = (ROUND, "left", "right", "oncoming")
    return tuple(sorted((one for one in found if one is not None), key=lambda one: order.index(one.from_side)))


def _goes_round(lap: Polyline, route: Route, inside: float) -> CrossingPath | None:
    """The way of who goes round in the ring already: so often in a small one that there is way enough to come along."""
    before = math.ceil(_RUN_UP / lap.length)
    line = Polyline.join(*(lap for _ in range(before + 1)))
    return _met(line, 0.0, ROUND, route, inside, lap.length * (before - 1 + _LAP))


def line_beside(network: Any, route: Route, side: str) -> Polyline:
    """The way of somebody in the lane beside the ego's, as `neighbour_line` gives it, but round in a roundabout.

    There who is to the left leaves by the ego's exit, if one can, and who is to the right goes on round: the ego, in
    the inner lane, crosses its way.

    Raises:
        MapError: No lane of cars lies directly on that side.
    """
    line = neighbour_line(network, route, side)
    ring, into = _entered(network, route)
    there = None if ring is None else section_beside(into.startLane.sections[-1], 1 if side == "left" else -1)
    if ring is None or there is None or opposes(into.startLane, there.lane):
        return line
    entry = next((m for m in there.lane.maneuvers if m.endLane.uid in ring.lanes), None)
    if entry is None:
        return line
    exits = {network.elements[uid].group.uid for uid in route.lane_ids[-1:]} if side == "left" else set[str]()
    parts = [line, centre_line(entry.connectingLane)]
    for lane in (network.elements[uid] for uid in ring.track(entry.endLane.uid)):
        parts.append(centre_line(lane))
        out = next((m for m in lane.maneuvers if m.endLane.group.uid in exits), None)
        if out is not None:
            return Polyline.join(*parts, centre_line(out.connectingLane), lane_runs(network)[out.endLane.uid].line)
    return Polyline.join(*parts)


def _entered(network: Any, route: Route) -> tuple[Ring | None, Any]:
    """The roundabout that a route leads through, and the manoeuvre by which it enters it."""
    ring = next((one for one in roundabouts(network) if route.junction in one.junctions), None)
    if ring is None:
        return None, None
    maneuvers = network.elements[route.junction].maneuvers
    on = set(ring.lanes)
    return ring, next(m for m in maneuvers if m.connectingLane.uid in route.lane_ids and m.endLane.uid in on)


def _level(network: Any, track: tuple[str, ...], into: Any) -> str:
    """The lane of a track that begins next to where the ego gets into the ring."""
    x, y, *_ = into.endLane.centerline.points[0]
    return min(track, key=lambda uid: math.dist(network.elements[uid].centerline.points[0][:2], (x, y)))


def _out(network: Any, ring: Ring, entry: Any) -> Polyline | None:
    """The line of who gets into a ring by a manoeuvre, from there on, and leaves it by the exit opposite, if it can."""
    track = ring.track(entry.endLane.uid)
    lanes = [network.elements[uid] for uid in track]
    middle = np.mean([lane.centerline.points[0][:2] for lane in lanes], axis=0)

    def angle(point: Any) -> float:
        x, y = point[:2] - middle
        return math.atan2(y, x)

    begins, on = angle(entry.startLane.centerline.points[-1]), set(ring.lanes)
    exits = [
        (abs(math.remainder(angle(maneuver.endLane.centerline.points[0]) - begins - math.pi, math.tau)), k, maneuver)
        for k, lane in enumerate(lanes)
        for maneuver in lane.maneuvers
        if maneuver.endLane.uid not in on
    ]
    off, k, out = min(exits, key=lambda one: one[:2], default=(math.inf, 0, None))
    if out is None or off > _OPPOSITE:
        return None
    leads = lane_runs(network)[out.endLane.uid].line
    return Polyline.join(_line(network, track[: k + 1]), centre_line(out.connectingLane), leads)


def _line(network: Any, lanes: tuple[str, ...]) -> Polyline:
    """The line of lanes that follow one another."""
    return Polyline.join(*(centre_line(network.elements[uid]) for uid in lanes))


def _met(line: Polyline, entry: float, side: str, route: Route, inside: float, after: float) -> CrossingPath | None:
    """A way as far as it meets the ego's, which is in the ring from `inside` [m] on; nothing before `after` [m]."""
    line = line.resampled(_STEP)
    own_from = max(int(inside - _ENTERS), 0)
    own_to = int(inside + 1.0) if side == ROUND else len(route.line.points)
    other, own = line.points[int(after) :], route.line.points[own_from:own_to]
    distance = np.hypot(other[:, None, 0] - own[None, :, 0], other[:, None, 1] - own[None, :, 1])
    near = np.flatnonzero(distance.min(axis=1) < MEETING)
    if near.size == 0:
        return None
    first = int(near[0])
    return CrossingPath(
        line=line,
        turn=Maneuver.STRAIGHT,
        from_side=side,
        entry=entry,
        meets_at=float(int(after) + first),
        ego_meets_at=float(own_from + distance[first].argmin()),
    )
