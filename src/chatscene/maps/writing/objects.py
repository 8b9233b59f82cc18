"""What stands and is marked on the streets of a written OpenDRIVE file: crosswalks, rails, bus stops, lights, signs.

Source: ASAM OpenDRIVE 1.7.0, sections 11 (objects) and 12 (signals).
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from enum import Enum
from typing import TYPE_CHECKING
from xml.etree import ElementTree as Xml

from chatscene.maps.furniture import DRIVEWAY, RAIL, TRAFFIC_LIGHT

if TYPE_CHECKING:
    from chatscene.maps.writing.streets import Street

STOP_SIGN = "206"  # signal types of the German catalogue, which Scenic and CARLA know
GIVE_WAY_SIGN = "205"
BUS_STOP = "224"
LEADS_ON = 15.0  # [m] on either side of a road to which rails across it are seen
GAUGE = 1.435  # [m], the standard one
MARKED = 4.0  # [m] from a junction to the middle of a crosswalk at it


class Use(Enum):
    """What a bay is for, and how long it takes to narrow at its ends [m]."""

    PARKING = 8.0
    BUS = 16.0


@dataclass(frozen=True, slots=True, kw_only=True)
class Bay:
    """A part of a street's shoulder where vehicles stand beside the traffic.

    Attributes:
        use: What for.
        right: On which side of the street, seen from its start.
        start: Where it begins to widen [m along the street].
        end: Where it has narrowed again [m along the street].
        width: [m].
    """

    use: Use
    right: bool
    start: float
    end: float
    width: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Crosswalk:
    """A marked way for pedestrians straight across a street.

    Attributes:
        at: Its middle [m along the street].
        width: [m], along the street.
    """

    at: float
    width: float = 4.0


@dataclass(frozen=True, slots=True, kw_only=True)
class Driveway:
    """A way off a street to a house, a yard or a field, which is no junction: a paved area beside the lanes.

    Attributes:
        right: On which side of the street, seen from its start.
        at: Its middle [m along the street].
        width: [m], along the street.
        depth: [m] from the lanes.
    """

    right: bool
    at: float
    width: float = 5.0
    depth: float = 15.0


def furnish(road: Xml.Element, street: Street, length: float) -> None:
    """Put on the road of a street what lies across and along it, and the signs of its bus stops.

    Args:
        road: Of the street.
        street: Which.
        length: Of the street [m].
    """
    crosswalks = (*street.crosswalks, *_at_junctions(street, length))
    if crosswalks or street.rails or street.tram or street.driveways:
        objects = Xml.SubElement(road, "objects")
        for count, crosswalk in enumerate(crosswalks):
            _crosswalk(objects, f"{street.id}{count:02d}", street, crosswalk)
        for count, (at, left, span, turned) in enumerate(_tracks(street, length)):
            _track(objects, f"{street.id}{50 + count}", at, left, span, turned)
        for count, driveway in enumerate(street.driveways):
            _driveway(objects, f"{street.id}{70 + count}", street, driveway)
    stops = [bay for bay in street.bays if bay.use is Use.BUS]
    if stops:
        signals = Xml.SubElement(road, "signals")
        for count, bay in enumerate(stops):
            _bus_stop(signals, f"{street.id}{count:02d}", street, bay)


def _at_junctions(street: Street, length: float) -> Iterator[Crosswalk]:
    """The crosswalks at the ends of a street that lie at junctions which have some."""
    for end, at in ((street.start, MARKED), (street.end, length - MARKED)):
        if end is not None and not isinstance(end, int) and end.marked:
            yield Crosswalk(at=at)


def _across(street: Street) -> tuple[float, float]:
    """How far the lanes and shoulders of a street lie to the left and the right of its reference line [m]."""
    left, right = (
        street.edge(right=on_right) + street.shoulder if lanes or street.kerbs else 0.0
        for lanes, on_right in ((street.lanes_back, False), (street.lanes, True))
    )
    return left, right


def _tracks(street: Street, length: float) -> Iterator[tuple[float, float, float, bool]]:
    """Of each track its middle along and beside the reference line, how long it is [m], and whether it lies across."""
    left, right = _across(street)
    for at in street.rails:
        yield at, (left - right) / 2, left + right + 2 * LEADS_ON, True
    if street.tram:
        yield from ((length / 2, side * street.lane / 2, length, False) for side in (1, -1))


def _track(objects: Xml.Element, object_id: str, at: float, left: float, span: float, across: bool) -> None:
    turned = math.pi / 2 if across else 0.0
    _box(objects, object_id, "track", subtype=RAIL, s=at, t=left, hdg=turned, length=span, width=GAUGE)


def _box(
    objects: Xml.Element,
    object_id: str,
    name: str,
    *,
    subtype: str,
    s: float,
    t: float,
    hdg: float,
    length: float,
    width: float,
) -> None:
    """An area on the ground that OpenDRIVE has no type for."""
    Xml.SubElement(
        objects,
        "object",
        id=object_id,
        name=name,
        type="none",
        subtype=subtype,
        s=decimal(s),
        t=decimal(t),
        zOffset="0",
        hdg=decimal(hdg),
        pitch="0",
        roll="0",
        orientation="none",
        length=decimal(length),
        width=decimal(width),
        height="0",
    )


def _crosswalk(objects: Xml.Element, object_id: str, street: Street, crosswalk: Crosswalk) -> None:
    left, right = _across(street)
    half, along = (left + right) / 2, crosswalk.width / 2
    element = Xml.SubElement(
        objects,
        "object",
        id=object_id,
        name="crosswalk",
        type="crosswalk",
        s=decimal(crosswalk.at),
        t=decimal((left - right) / 2),
        zOffset="0",
        hdg="0",
        pitch="0",
        roll="0",
        orientation="none",
        length=decimal(crosswalk.width),
        width=decimal(2 * half),
        height="0",
    )
    outline = Xml.SubElement(element, "outline")
    for u, v in ((-along, -half), (along, -half), (along, half), (-along, half), (-along, -half)):
        Xml.SubElement(outline, "cornerLocal", u=decimal(u), v=decimal(v), z="0", height="0")


def _driveway(objects: Xml.Element, object_id: str, street: Street, driveway: Driveway) -> None:
    middle = street.edge(right=driveway.right) + driveway.depth / 2
    _box(
        objects,
        object_id,
        "driveway",
        subtype=DRIVEWAY,
        s=driveway.at,
        t=-middle if driveway.right else middle,
        hdg=0.0,
        length=driveway.width,
        width=driveway.depth,
    )


def _bus_stop(signals: Xml.Element, signal_id: str, street: Street, bay: Bay) -> None:
    out = street.edge(right=bay.right) + bay.width + 0.5
    signal_on(
        signals,
        signal_id,
        "bus stop",
        BUS_STOP,
        s=(bay.start + bay.end) / 2,
        t=-out if bay.right else out,
        orientation="+" if bay.right else "-",
    )


def signal_on(
    signals: Xml.Element, signal_id: str, name: str, kind: str, *, s: float, t: float, orientation: str
) -> None:
    """Put a light or a sign on a road, `s` [m] along it and `t` [m] to its left."""
    light = kind == TRAFFIC_LIGHT
    Xml.SubElement(
        signals,
        "signal",
        s=decimal(s),
        t=decimal(t),
        id=signal_id,
        name=name,
        dynamic="yes" if light else "no",
        orientation=orientation,
        zOffset="3" if light else "2",
        country="OpenDRIVE" if light else "DE",
        type=kind,
        subtype="-1",
        value="-1",
        height="0.9",
        width="0.5",
    )


def decimal(value: float, digits: int = 9) -> str:
    """A value as it stands in a file, without zeros at its end."""
    text = f"{value:.{digits}f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text
