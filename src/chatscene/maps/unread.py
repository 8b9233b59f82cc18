"""What about a map cannot be made into lanes: the road, the section and the lane, where Scenic's parser gives up."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from traceback import walk_tb
from xml.etree import ElementTree as Xml

from chatscene.maps.plain_form import name_of

NEGATIVE = 0.05  # [m], a width that is less negative is taken for none

SHAPES = ("line", "arc", "spiral", "paramPoly3")
_NUMBERS = {
    "road": ("length",),
    "geometry": ("s", "x", "y", "hdg", "length"),
    "laneSection": ("s",),
    "width": ("sOffset", "a", "b", "c", "d"),
    "arc": ("curvature",),
    "spiral": ("curvStart", "curvEnd"),
}

_ORDER = "cyclicOrder"
"""The parser's function that puts the lanes about a junction in order, and needs one that comes in and one that leads
out."""

_RANGES = ("normalized", "arcLength")


def why_unread(root: Xml.Element, error: Exception) -> str:
    """Why the parser gave up on a map."""
    for road in root.iter("road"):
        if (fault := next(_of_road(road), None)) is not None:
            return f"road {name_of(road)!r} {fault}"
    for junction in root.iter("junction"):
        if (fault := next(_of_junction(junction), None)) is not None:
            return f"junction {name_of(junction)!r} {fault}"
    if any(frame.f_code.co_name == _ORDER for frame, _ in walk_tb(error.__traceback__)):
        return f"{_where(error)}no lane leads into it and out of it again; link the lanes of its connecting roads"
    said = "" if isinstance(error, LookupError) else str(error).partition("\n")[0]  # a key is the parser's own
    return f"{_where(error)}{said or 'what is drawn there does not fit together'}"


def _of_road(road: Xml.Element) -> Iterator[str]:
    yield from _identified(road)
    yield from _numbers(road)
    yield from _line(road)
    sections = list(road.iterfind("lanes/laneSection"))
    if not sections:
        yield "has no <laneSection>, so no lane"
    for number, section in enumerate(sections):
        where = f"section {number} (s={section.get('s')!r})"
        yield from (f"has the {where} that {fault}" for fault in _numbers(section))
        after = sections[number + 1].get("s") if number + 1 < len(sections) else road.get("length")
        for lane in section.iter("lane"):
            faults = (*_of_lane(lane), *_negative(lane, section.get("s"), after))
            yield from (f"{where}: lane {lane.get('id', '')!r} {fault}" for fault in faults)
    for one, after in pairwise(sections):
        if float(after.get("s", 0)) <= float(one.get("s", 0)):
            yield f"has sections out of order: one at s={after.get('s')} follows one at s={one.get('s')}"


def _line(road: Xml.Element) -> Iterator[str]:
    shapes = list(road.iterfind("planView/geometry"))
    if not shapes:
        yield "has no <geometry>, so no place"
    for one in shapes:
        at = f"has a <geometry> at s={one.get('s')!r}"
        yield from (f"{at} that {fault}" for fault in _numbers(one))
        shape = next((inner for inner in one if inner.tag != "userData"), None)
        if shape is None or shape.tag not in SHAPES:
            what = "without a shape" if shape is None else f"of the shape <{shape.tag}>"
            yield f"{at} {what}; {', '.join(SHAPES)} are read"
        elif shape.tag in _NUMBERS:
            yield from (f"{at} whose <{shape.tag}> {fault}" for fault in _numbers(shape))
        elif shape.tag == "paramPoly3" and shape.get("pRange", "normalized") not in _RANGES:
            yield f"{at} with pRange={shape.get('pRange')!r}; {' and '.join(_RANGES)} are read"


def _of_lane(lane: Xml.Element) -> Iterator[str]:
    yield from _identified(lane)
    if lane.get("id") == "0" or lane.get("type") == "none":
        return
    widths = lane.findall("width")
    if not widths:
        yield "has a <border> and no <width>" if lane.find("border") is not None else "has no <width>"
    for width in widths:
        yield from (f"has a <width> that {fault}" for fault in _numbers(width))


def _negative(lane: Xml.Element, start: str | None, end: str | None) -> Iterator[str]:
    """Where the width of a lane is negative, at the ends of its pieces."""
    try:
        pieces = [[float(one.get(name, "")) for name in ("sOffset", *"abcd")] for one in lane.iter("width")]
        stops = [*(piece[0] for piece in pieces[1:]), float(end or "") - float(start or "")]
    except ValueError:  # which is told by the attribute
        return
    for (offset, a, b, c, d), stop in zip(pieces, stops, strict=False):
        for x in (0.0, stop - offset):
            if (width := a + x * (b + x * (c + x * d))) < -NEGATIVE:
                yield f"is {width:.2f} m wide {offset + x:g} m into the section"


def _of_junction(junction: Xml.Element) -> Iterator[str]:
    yield from _identified(junction)
    if any(connection.get("connectingRoad") is None for connection in junction.iter("connection")):
        yield "has a connection that names no connecting road, and it is not direct"


def _identified(element: Xml.Element) -> Iterator[str]:
    written = element.get("id")
    if written is None:
        yield "has no id"
    elif not written.removeprefix("-").isdecimal():
        yield f"has the id {written[:40]!r}; only whole numbers are read"


def _numbers(element: Xml.Element) -> Iterator[str]:
    for name in _NUMBERS[element.tag]:
        written = element.get(name)
        try:
            float(written or "")
        except ValueError:
            yield f"has no {name}" if written is None else f"has {name}={written[:40]!r}, which is not a number"


def road_unread(error: Exception) -> str | None:
    """The id of the road at which the parser gave up, if it was at one."""
    return _at(error).get("road")


def _where(error: Exception) -> str:
    at = _at(error)
    return f"{', '.join(f'{kind} {id_}' for kind, id_ in at.items())}: " if at else ""


def _at(error: Exception) -> dict[str, str]:
    """The road, lane and junction at which the parser was."""
    at: dict[str, str] = {}
    for frame, _ in walk_tb(error.__traceback__):
        for name, kind in (("road", "road"), ("lane", "lane"), ("junction", "junction")):
            if (id_ := getattr(frame.f_locals.get(name), "id_", None)) is not None:
                at[kind] = str(id_)
    return at
