"""What kind of place a junction is, whatever it is called: crossing, merge, diverge, part of a roundabout.

Geometry and topology decide, so that one finds on any map what one finds on ours. A *group* is Scenic's: the lanes of
one road in one direction.
"""

from __future__ import annotations

import heapq
import math
from collections.abc import Iterator, Set
from dataclasses import dataclass
from enum import StrEnum
from functools import partial
from operator import attrgetter
from typing import Any

import numpy as np
import shapely

from chatscene.maps.kept import kept, kept_with_network
from chatscene.maps.lane_runs import centre_line, lane_runs
from chatscene.maps.limits import is_called
from chatscene.maps.neighbours import opposes, section_beside
from chatscene.terms.route import Shape

_SAME_WAY = math.radians(30)  # between the directions of two roads of one arm
_SAME_PLACE = 30.0  # [m] between them: the widest median, and some
_RAMP = math.radians(60)  # a way through a junction that turns by more is no merging or leaving
_ASIDE, _HALF, _BACK = (math.radians(angle) for angle in (45, 75, 150))
"""From where on an arm lies to a side and no more ahead; fully so, and not half; and where one has come from."""
_RING = 500.0  # [m] round the largest roundabout
_ROUND = 0.84  # area by that of a circle of the same circumference; a square has 0.785
_MOTORWAY = 400.0  # [m] of a shortest motorway


class JunctionKind(StrEnum):
    """What happens at a junction."""

    CROSSING = "crossing"  # ways cross, or a road goes on
    MERGE = "merge"  # roads become one
    DIVERGE = "diverge"  # one road becomes several
    ROUNDABOUT = "roundabout"  # one enters or leaves a ring


@dataclass(frozen=True, slots=True)
class Ring:
    """A roundabout.

    Attributes:
        tracks: Scenic's ids of the lanes that go round, in driving order, those inside junctions among them: of each
            lane that drivers see, the innermost first.
        junctions: Scenic's ids of the junctions at which it is entered and left.
    """

    tracks: tuple[tuple[str, ...], ...]
    junctions: frozenset[str]

    @property
    def lanes(self) -> tuple[str, ...]:
        """The lanes of all tracks."""
        return tuple(lane for track in self.tracks for lane in track)

    def track(self, lane: str) -> tuple[str, ...]:
        """The track that a lane belongs to, from that lane on."""
        found = next(track for track in self.tracks if lane in track)
        at = found.index(lane)
        return (*found[at:], *found[:at])

    def entries(self, network: Any) -> list[Any]:
        """Scenic's maneuvers by which it is entered."""
        on = set(self.lanes)
        return [
            maneuver
            for junction in sorted(self.junctions)
            for maneuver in network.elements[junction].maneuvers
            if maneuver.startLane.uid not in on and maneuver.endLane.uid in on
        ]


@dataclass(frozen=True, slots=True)
class Weave:
    """A part of a road between an on-ramp and an off-ramp that share a lane.

    Attributes:
        first: Scenic's id of the lane that comes from the on-ramp, and leads into the off-ramp.
        last: The same where the map cuts it into several; that before the off-ramp.
        merge: Scenic's id of the junction where it begins.
        diverge: Scenic's id of the junction where it ends.
    """

    first: str
    last: str
    merge: str
    diverge: str


def arms(junction: Any) -> int:
    """How many arms one of Scenic's intersections has; a road for each direction makes one arm of two."""
    return kept(junction, "arms", _arms)


def _arms(junction: Any) -> int:
    return len(arm_poses([junction]))


def arm_poses(junctions: list[Any], without: Set[str] = frozenset()) -> list[tuple[float, float, float]]:
    """Where each arm of junctions that make one place meets it [m], and its direction [rad] out of it.

    Args:
        junctions: Scenic's intersections.
        without: Scenic's ids of roads that are no arms, as those of a ring.
    """
    ways = [one for junction in junctions for one in _approaches(junction) if one[0] not in without]
    of_road: dict[str, list[tuple[float, float, float]]] = {}
    for road, pose in ways:
        of_road.setdefault(road, []).append(pose)
    found = [poses[0] for poses in of_road.values() if len(poses) > 1]  # two-way roads
    for (pose,) in (poses for poses in of_road.values() if len(poses) == 1):
        if not any(_one_arm(pose, other) for other in found):
            found.append(pose)
    return found


def shape_from(junction: Any, lane: Any) -> Shape | None:
    """What shape a junction of three arms has, as one comes to it in a lane; None of any other, and where none fits."""
    comes = _heading(lane, last=True)
    turns = [math.remainder(heading - comes, 2 * math.pi) for _, _, heading in arm_poses([junction])]
    others = sorted(turn for turn in turns if abs(turn) < _BACK)
    if len(turns) != 3 or len(others) != 2:
        return None
    left, right = [turn > _ASIDE for turn in others], [turn < -_ASIDE for turn in others]
    if any(left) and any(right):
        return Shape.FORK if max(map(abs, others)) < _HALF else Shape.STEM
    if any(left) is any(right):
        return None
    return Shape.SIDE_LEFT if any(left) else Shape.SIDE_RIGHT


def _approaches(junction: Any) -> list[tuple[str, tuple[float, float, float]]]:
    """By the road it belongs to, where each group meets a junction [m], and its direction [rad] out of it."""
    into = {m.startLane.group.uid: m.startLane for m in junction.maneuvers}
    out = {m.endLane.group.uid: m.endLane for m in junction.maneuvers}
    found = [(lane.road.uid, (*_end(lane), _heading(lane, last=True) + math.pi)) for lane in into.values()]
    found += [(lane.road.uid, (*_start(lane), _heading(lane, last=False))) for lane in out.values()]
    return found


def _one_arm(a: tuple[float, float, float], b: tuple[float, float, float]) -> bool:
    return math.dist(a[:2], b[:2]) < _SAME_PLACE and abs(math.remainder(a[2] - b[2], 2 * math.pi)) < _SAME_WAY


def _start(lane: Any) -> tuple[float, float]:
    x, y, *_ = lane.centerline.points[0]
    return float(x), float(y)


def _end(lane: Any) -> tuple[float, float]:
    x, y, *_ = lane.centerline.points[-1]
    return float(x), float(y)


def _heading(lane: Any, *, last: bool) -> float:
    line = centre_line(lane)
    return line.heading_at(line.length if last else 0.0)


@kept_with_network()
def junction_kinds(network: Any) -> dict[str, JunctionKind]:
    """The kind of each junction of a network, by Scenic's id."""
    on_ring = {junction for ring in roundabouts(network) for junction in ring.junctions}
    return {
        junction.uid: JunctionKind.ROUNDABOUT if junction.uid in on_ring else _ramp_kind(junction)
        for junction in network.intersections
    }


def _ramp_kind(junction: Any) -> JunctionKind:
    """Whether ways only meet or only part at a junction, all of them in about one direction."""
    turns = [
        math.remainder(_heading(m.endLane, last=False) - _heading(m.startLane, last=True), 2 * math.pi)
        for m in junction.maneuvers
    ]
    if any(abs(turn) > _RAMP for turn in turns):
        return JunctionKind.CROSSING
    streams = list(_streams(junction))
    if any(len(into) > 1 < len(out) for into, out in streams):
        return JunctionKind.CROSSING
    if any(len(into) > 1 for into, _ in streams):
        return JunctionKind.MERGE
    return JunctionKind.DIVERGE if any(len(out) > 1 for _, out in streams) else JunctionKind.CROSSING


def _streams(junction: Any) -> Iterator[tuple[set[str], set[str]]]:
    """Groups that lead into a junction, with those that one can get into from them; no group is in two streams."""
    left = sorted({(m.startLane.group.uid, m.endLane.group.uid) for m in junction.maneuvers})
    while left:
        into, out, size = {left[0][0]}, {left[0][1]}, 0
        while size < len(into) + len(out):
            size = len(into) + len(out)
            joined = [way for way in left if way[0] in into or way[1] in out]
            left = [way for way in left if way not in joined]
            into |= {way[0] for way in joined}
            out |= {way[1] for way in joined}
        yield into, out


# Roundabouts


@kept_with_network()
def roundabouts(network: Any) -> tuple[Ring, ...]:
    """The roundabouts of a network: short round rings of one-way roads that are entered and left at junctions."""
    beyond = _one_way_steps(network)
    found: dict[frozenset[str], list[tuple[str, ...]]] = {}
    for uid in sorted(beyond):
        if any(uid in track for tracks in found.values() for track in tracks):
            continue
        lanes = _shortest_ring(beyond, uid)
        if lanes is None or not _is_round([network.elements[lane] for lane in lanes]):
            continue
        junctions = frozenset(
            m.intersection.uid
            for lane in lanes
            for m in network.elements[lane].maneuvers
            if m.intersection is not None and len(_approaches(m.intersection)) > 2
        )
        tracks = found.get(junctions, [])
        apart = not any(junctions & other for other in found) or (
            junctions in found and not any(set(lanes) & set(track) for track in tracks)
        )
        if junctions and apart:
            found[junctions] = [*tracks, lanes]
    return tuple(Ring(tuple(sorted(tracks, key=partial(_length, network))), at) for at, tracks in found.items())


def _length(network: Any, lanes: tuple[str, ...]) -> float:
    return sum(network.elements[lane].centerline.length for lane in lanes)


def _one_way_steps(network: Any) -> dict[str, list[tuple[float, str]]]:
    """From each lane of a one-way road, and each way through a junction between such, to the next and its length."""
    one_way = {
        lane.uid: lane
        for road in network.roads
        if road.forwardLanes is None or road.backwardLanes is None
        for lane in road.lanes
        if lane.centerline.length < _RING
    }
    steps: dict[str, list[tuple[float, str]]] = {uid: [] for uid in one_way}
    for uid, lane in one_way.items():
        for maneuver in lane.maneuvers:
            end, way = maneuver.endLane, maneuver.connectingLane
            if end is None or end.uid not in one_way:
                continue
            if way is None:
                steps[uid].append((end.centerline.length, end.uid))
            else:
                steps[uid].append((way.centerline.length, way.uid))
                steps.setdefault(way.uid, []).append((end.centerline.length, end.uid))
    return steps


def _shortest_ring(beyond: dict[str, list[tuple[float, str]]], start: str) -> tuple[str, ...] | None:
    """The lanes of the shortest way from a lane back to itself, or None if there is none that is short enough."""
    done: set[str] = set()
    ahead: list[tuple[float, str, tuple[str, ...]]] = [(0.0, start, ())]
    while ahead:
        length, uid, way = heapq.heappop(ahead)
        if uid == start and way:
            return way
        if uid in done:
            continue
        done |= {uid} if way else set()
        for further, following in beyond[uid]:
            if length + further < _RING:
                heapq.heappush(ahead, (length + further, following, (*way, uid)))
    return None


def _is_round(lanes: list[Any]) -> bool:
    points = np.concatenate([centre_line(lane).points for lane in lanes])
    area = shapely.Polygon(points)
    return area.is_valid and 4 * math.pi * area.area > _ROUND * area.exterior.length**2


# Motorways


@kept_with_network()
def motorway_groups(network: Any) -> tuple[Any, ...]:
    """The carriageways of a network's motorways.

    Those are groups of two lanes or more with no oncoming lane directly beside, which lead to or from a merge or a
    diverge, themselves or by others, without a crossing, or are called motorways; and are long enough together.
    """
    kinds = junction_kinds(network)
    wide = {
        group.uid: group
        for road in network.roads
        for group in (road.forwardLanes, road.backwardLanes)
        if group is not None and len(group.lanes) > 1 and _divided(group)
    }
    ramps = {uid for uid, kind in kinds.items() if kind in (JunctionKind.MERGE, JunctionKind.DIVERGE)}
    beside: dict[str, set[str]] = {uid: set() for uid in wide}
    at_ramp: set[str] = set()
    for uid, group in wide.items():
        for maneuver in (m for lane in group.lanes for m in lane.maneuvers):
            following = maneuver.endLane.group.uid
            junction = None if maneuver.intersection is None else maneuver.intersection.uid
            if junction in ramps:
                at_ramp |= {uid, following}
            if following in wide and (junction is None or junction in ramps or arms(maneuver.intersection) == 2):
                beside[uid].add(following)
                beside[following].add(uid)
    found: list[Any] = []
    left = sorted(wide)
    while left:
        chain, ahead = set[str](), [left[0]]
        while ahead:
            uid = ahead.pop()
            if uid not in chain:
                chain.add(uid)
                ahead += beside[uid]
        left = [uid for uid in left if uid not in chain]
        groups = [wide[uid] for uid in sorted(chain)]
        said = all(is_called(network, group.road.id, "motorway") for group in groups)
        if (chain & at_ramp or said) and sum(group.centerline.length for group in groups) > _MOTORWAY:
            found += groups
    return tuple(found)


def _divided(group: Any) -> bool:
    sections = (section for lane in group.lanes for section in lane.sections)
    lefts = ((section, section_beside(section, 1)) for section in sections)
    return not any(left is not None and opposes(section.lane, left.lane) for section, left in lefts)


def ramp_ways(network: Any, kind: JunctionKind) -> tuple[Any, ...]:
    """The manoeuvres by which one comes from a ramp at a merge, or leaves by a ramp at a diverge.

    Where roads merge or part, all but the widest are ramps; of equally wide ones, those that turn more.
    """
    kinds, found = junction_kinds(network), list[Any]()
    ramp_end = attrgetter("startLane" if kind is JunctionKind.MERGE else "endLane")
    for junction in network.intersections:
        if kinds[junction.uid] is not kind:
            continue
        for into, out in _streams(junction):
            lanes: dict[str, list[Any]] = {uid: [] for uid in (into if kind is JunctionKind.MERGE else out)}
            for maneuver in junction.maneuvers:
                if (lane := ramp_end(maneuver)).group.uid in lanes:
                    lanes[lane.group.uid].append(lane)
            if len(lanes) > 1:
                main = max(lanes, key=lambda uid, lanes=lanes: (_prominence(lanes[uid][0]), uid))
                found += [m for m in junction.maneuvers if ramp_end(m).group.uid in lanes.keys() - {main}]
    return tuple(sorted(found, key=lambda m: (m.startLane.uid, m.endLane.uid)))


def _prominence(lane: Any) -> tuple[int, float]:
    """How many lanes lie beside each other there, and how little the first and the last of a lane bend."""
    line = centre_line(lane)
    span = min(60.0, line.length)
    ends = ((0.0, span), (line.length - span, line.length))
    bent = max(abs(math.remainder(line.heading_at(b) - line.heading_at(a), 2 * math.pi)) for a, b in ends)
    return len(lane.group.lanes), -bent


@kept_with_network()
def weaving_sections(network: Any) -> tuple[Weave, ...]:
    """Where traffic from an on-ramp and traffic to an off-ramp change places."""
    on = {m.endLane.uid: m.intersection.uid for m in ramp_ways(network, JunctionKind.MERGE)}
    off = {m.startLane.uid: m.intersection.uid for m in ramp_ways(network, JunctionKind.DIVERGE)}
    runs = lane_runs(network)
    return tuple(
        Weave(first=uid, last=last, merge=on[uid], diverge=off[last])
        for uid in sorted(on)
        if (last := runs[uid].lanes[-1].uid) in off and len(network.elements[uid].group.lanes) > 1
    )
