"""Who takes part in a story, as its conditions and actions see them."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import shapely

from chatscene.maps.lane_curves import middle_line
from chatscene.maps.neighbours import numbered_beside
from chatscene.terms.polyline import Polyline
from chatscene.world.places import laneLine

STANDS = 0.1  # [m/s] below which somebody stands
_ENDS = 0.5  # [m] of lane before the end of a road, that are none to go on
_NEAR = 20.0  # [m] from a lane within which somebody beside it goes along it
_FAR = 10_000.0  # [m] straight ahead, which nobody comes to the end of
_ONWARD = 400.0  # [m] of a lane and of those it leads to that are followed at once
Motion = tuple[tuple[float, float], tuple[float, float]]  # x, y [m]; velocity along both [m/s]
_ACROSS = math.pi / 4  # [rad] from a lane's direction, beyond which somebody follows no lane


@dataclass(frozen=True, slots=True)
class Bounds:
    """How fast somebody is at most, as the file says of the body.

    Attributes:
        top: Speed [m/s].
        up: Acceleration [m/s²].
        down: Deceleration [m/s²].
    """

    top: float = math.inf
    up: float = math.inf
    down: float = math.inf

    @property
    def each(self) -> tuple[float, float, float]:
        """All of them."""
        return self.top, self.up, self.down


class Entity:
    """A road user or a thing of a story.

    Args:
        agent: The object of the scene.
        name: As the story calls it.
        ahead: How far its centre lies before its origin [m].
        network: Scenic's road network.
        led: Whether the story says where it is; else something else drives it, and the story looks on.
        bounds: What its body can do.

    Attributes:
        line: The line that it follows, in the order in which it goes along it.
        pose: X [m], y [m], heading [rad], speed [m/s] of its centre now.
        speed: [m/s].
        travelled: How far it has gone since the beginning [m].
        rests: How long it has stood [s].
        lost: How long it has been on no road [s]; counted once `is_watched`.
        gained: Its acceleration [m/s²].
    """

    def __init__(
        self, agent: Any, name: str, ahead: float, network: Any, *, led: bool = False, bounds: Bounds | None = None
    ) -> None:
        self.agent, self.name, self.ahead, self._network = agent, name, ahead, network
        self.led, self.bounds, self.is_watched = led, bounds or Bounds(), False
        self.pose: tuple[float, float, float, float] = agent.pose
        self.speed = self.pose[3]
        route = None if led else getattr(agent, "route", None)
        self.line: Polyline = self.own_line() if route is None else route.line
        self.travelled = self.rests = self.lost = self.gained = 0.0
        self._before = self.pose

    @property
    def origin(self) -> tuple[float, float, float]:
        """X [m], y [m], heading [rad] of its origin."""
        x, y, heading, _ = self.pose
        return x - self.ahead * math.cos(heading), y - self.ahead * math.sin(heading), heading

    @property
    def velocity(self) -> tuple[float, float]:
        """Along x and y [m/s]."""
        heading = self.pose[2]
        return self.speed * math.cos(heading), self.speed * math.sin(heading)

    def put(self, x: float, y: float, heading: float, speed: float) -> None:
        """Have its origin at a place, at a speed [m/s]."""
        self.pose = x + self.ahead * math.cos(heading), y + self.ahead * math.sin(heading), heading, speed
        self.speed = speed

    def sees(self) -> None:
        """Take over where whatever drives it has brought it."""
        self.pose = self.agent.pose
        self.speed = self.pose[3]

    def passes(self, dt: float) -> None:
        """Count a step of time."""
        x, y, _, speed = pose = self.pose
        bx, by, _, before = self._before
        if (gone := math.hypot(x - bx, y - by)) < 2.0 * max(abs(speed), abs(before), 1.0) * dt:  # it may have jumped
            self.travelled += gone
        self.rests = self.rests + dt if abs(speed) < STANDS else 0.0
        if self.is_watched:
            self.lost = self.lost + dt if self._network.elementAt((x, y)) is None else 0.0
        self.gained = (speed - before) / dt
        self._before = pose

    def own_line(self) -> Polyline:
        """The line of its lane, or of the nearest one beside it, and of those it leads to; else straight ahead.

        Straight ahead is where no lane is near, or none runs nearly the way that it faces.
        """
        x, y, heading = self.origin
        section = self._network.laneSectionAt((x, y))
        if section is None:
            nearest = self.section()
            section = nearest if nearest.distanceTo((x, y)) < _NEAR else None
        if section is not None:
            line = laneLine(section.lane, 0.0, middle_line)
            along = line.project(x, y)[0]
            turn = math.remainder(heading - line.heading_at(along), math.tau)
            if abs(turn) < _ACROSS:
                return laneLine(section.lane, along + _ONWARD, middle_line)
            if abs(turn) > math.pi - _ACROSS:
                return Polyline(line.points[::-1])
        return Polyline([(x + d * math.cos(heading), y + d * math.sin(heading)) for d in (-1.0, _FAR)])

    def onward_line(self, line: Polyline) -> Polyline | None:
        """The line of the lane at the end of a line, and of those it leads to; None where that leads nowhere."""
        (x, y), heading = line.point_at(line.length), line.heading_at(line.length)
        onward = self._lane_on(x, y, heading)
        if onward is None:  # at the seam of two roads
            onward = self._lane_on(x + _ENDS * math.cos(heading), y + _ENDS * math.sin(heading), heading, since=_ENDS)
        return onward

    def _lane_on(self, x: float, y: float, heading: float, since: float = 0.0) -> Polyline | None:
        """What is left of the lane at a place, and of those it leads to, the way it is gone; None where nothing is.

        It begins so far [m] before the place.
        """
        section = self._network.laneSectionAt((x, y))
        if section is None:
            return None
        lane = laneLine(section.lane, 0.0, middle_line)
        at = lane.project(x, y)[0]
        along = math.cos(heading - lane.heading_at(at))
        if abs(along) < math.cos(_ACROSS):
            return None
        if along < 0.0:
            at, found = lane.length - at, Polyline(lane.points[::-1])
        else:
            found = laneLine(section.lane, at + _ONWARD, middle_line)
        return found.between(max(at - since, 0.0), found.length) if found.length - at > _ENDS else None

    def lane_line(self, number: int) -> Polyline:
        """The line of a lane of its road, by its number in OpenDRIVE, in the order in which it goes along it.

        Raises:
            ValueError: There is no such lane beside its own.
        """
        x, y, heading = self.origin
        section = self.section()
        found = numbered_beside(section, number)
        if found is None:
            raise ValueError(
                f"{self.name} is to change to lane {number}, and beside lane {section.openDriveID} is none"
            )
        line = laneLine(found.lane, 0.0, middle_line)
        along = line.project(x, y)[0]
        with_it = math.cos(heading - line.heading_at(along)) >= 0.0
        return laneLine(found.lane, along + _ONWARD, middle_line) if with_it else Polyline(line.points[::-1])

    def section(self) -> Any:
        """Scenic's lane section that it is on, or the nearest one."""
        x, y, _ = self.origin
        found = self._network.laneSectionAt((x, y))
        return found if found is not None else min(self._network.laneSections, key=lambda s: s.distanceTo((x, y)))

    def bearing(self, frame: str) -> float:
        """The direction [rad] of its lane as it is driven, or with ``road`` that of its road's line."""
        section = self.section()
        line = laneLine(section.lane, 0.0, middle_line)
        heading = line.heading_at(line.project(*self.origin[:2])[0])
        return heading + math.pi if frame == "road" and int(section.openDriveID) > 0 else heading

    def sides(self) -> tuple[int, int]:
        """The number of its lane, and 1 where its left is that of the road's line; -1 where it faces against that."""
        section = self.section()
        number = int(section.openDriveID)
        x, y, heading = self.origin
        line = laneLine(section.lane, 0.0, middle_line)
        along = math.cos(heading - line.heading_at(line.project(x, y)[0])) >= 0.0
        return number, 1 if along == (number < 0) else -1

    def box(self) -> Any:
        """Its outline."""
        agent = self.agent
        x, y, heading, _ = self.pose
        c, s, a, b = math.cos(heading), math.sin(heading), agent.length / 2, agent.width / 2
        return shapely.Polygon(
            [(x + u * c - v * s, y + u * s + v * c) for u, v in ((a, b), (-a, b), (-a, -b), (a, -b))]
        )


def apart(one: Entity, other: Entity, how: str, frame: str, *, freespace: bool) -> float:
    """How far two are from each other [m], never negative.

    Args:
        one: From whom.
        other: To whom.
        how: ``longitudinal``, ``lateral``, or else straight.
        frame: ``entity`` for along and across the heading of `one`; else along and across the line that it follows.
        freespace: Whether it is the room between their outlines; else it is the distance of their origins.
    """
    if how not in ("longitudinal", "lateral"):
        return one.box().distance(other.box()) if freespace else math.dist(one.origin[:2], other.origin[:2])
    far = offset(one, other, frame, of_centres=freespace)[0 if how == "longitudinal" else 1]
    return max(abs(far) - (room(one, other, how, frame) if freespace else 0.0), 0.0)


def room(one: Entity, other: Entity, how: str, frame: str) -> float:
    """How much of a distance between centres [m] is taken by two bodies, as they are turned; see `apart`."""
    axis = _axis(one, how, frame)
    return sum(_half(who, who.pose[2] - axis) for who in (one, other))


def away(one: Entity, place: tuple[float, float], how: str, frame: str, *, freespace: bool) -> float:
    """How far somebody is from a place [m], never negative; arguments are those of `apart`."""
    if how not in ("longitudinal", "lateral"):
        return one.box().distance(shapely.Point(place)) if freespace else math.dist(one.origin[:2], place)
    here = one.pose[:3] if freespace else one.origin
    far = abs(seen(here, one.line, place, frame)[0 if how == "longitudinal" else 1])
    return max(far - (_half(one, one.pose[2] - _axis(one, how, frame)) if freespace else 0.0), 0.0)


def _axis(one: Entity, how: str, frame: str) -> float:
    """The direction [rad] along which it is measured how far something is from somebody; see `apart`."""
    axis = one.pose[2] if frame == "entity" else one.line.heading_at(one.line.project(*one.pose[:2])[0])
    return axis + (0.0 if how == "longitudinal" else math.pi / 2)


def _half(who: Entity, turn: float) -> float:
    """Half of what a body takes up along an axis [m] that it is turned from."""
    return (abs(math.cos(turn)) * who.agent.length + abs(math.sin(turn)) * who.agent.width) / 2


def offset(one: Entity, other: Entity, frame: str, *, of_centres: bool = False) -> tuple[float, float]:
    """How far another is ahead of somebody and to the left [m]."""
    here, there = (e.pose[:3] if of_centres else e.origin for e in (one, other))
    return seen(here, one.line, there[:2], frame)


def seen(
    pose: tuple[float, float, float], line: Polyline, place: tuple[float, float], frame: str
) -> tuple[float, float]:
    """How far a place is ahead of a pose and to the left [m]: along its heading, or else along a line."""
    x, y, heading = pose
    if frame == "entity":
        return _turned(place[0] - x, place[1] - y, heading)
    (s, t), (os, ot) = along(line, x, y), along(line, *place)
    return os - s, ot - t


def closing(one: Entity, other: Motion, how: str, frame: str) -> float:
    """How fast somebody and another come nearer to each other [m/s]; negative where they part.

    Args:
        one: Somebody.
        other: Where the other is, and how it moves.
        how: ``longitudinal``, ``lateral``, or else straight.
        frame: ``entity`` for along and across the heading of `one`; else along and across the line that it follows.
    """
    (x, y, heading), (ox, oy), (vx, vy), (ux, uy) = one.origin, other[0], one.velocity, other[1]
    if how not in ("longitudinal", "lateral"):
        far = math.dist((x, y), (ox, oy))
        return ((vx - ux) * (ox - x) + (vy - uy) * (oy - y)) / far if far else 0.0
    own = theirs = heading
    if frame != "entity":
        own, theirs = (one.line.heading_at(one.line.project(*at)[0]) for at in ((x, y), (ox, oy)))
    ahead, aside = seen(one.origin, one.line, (ox, oy), frame)
    axis, far = (0, ahead) if how == "longitudinal" else (1, aside)
    return (_turned(vx, vy, own)[axis] - _turned(ux, uy, theirs)[axis]) * math.copysign(1.0, far)


def faster(one: Entity, than: Entity, axis: str) -> float:
    """How much faster somebody is than another [m/s]: along the other's heading or to its left, or whichever way."""
    if not axis:
        return one.speed - than.speed
    ahead, left = _turned(*one.velocity, than.pose[2])
    return ahead - than.speed if axis == "longitudinal" else left


def _turned(x: float, y: float, heading: float) -> tuple[float, float]:
    """How much of a vector is along a heading, and how much to its left."""
    c, s = math.cos(heading), math.sin(heading)
    return x * c + y * s, y * c - x * s


def along(line: Polyline, x: float, y: float) -> tuple[float, float]:
    """How far along a line and to the left of it a place is [m], also before its beginning and beyond its end."""
    s, left, _ = line.project(x, y)
    if 0.0 < s < line.length:
        return s, left
    (px, py), heading = line.point_at(s), line.heading_at(s)
    return s + (x - px) * math.cos(heading) + (y - py) * math.sin(heading), left
