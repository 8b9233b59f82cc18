"""A map's text as the wheel needs it, and as a server gives it back.

Two things that OpenDRIVE allows break or worry the wheel; so a map that went through a server is not the same text.
"""

from __future__ import annotations

from collections.abc import Iterator
from xml.etree import ElementTree as Xml

from chatscene.errors import MapError
from chatscene.maps.left_hand import check_right_hand

# Those of the wheel where a map says nothing, written out so that it need not warn.
_REFERENCE = "+proj=tmerc +lat_0=42 +lon_0=2 +k=1 +x_0=0 +y_0=0 +datum=WGS84"

_SHAPE = frozenset(
    {"geometry", "arc", "spiral", "poly3", "paramPoly3", "elevation", "laneOffset", "laneSection", "lane", "width"}
)
_SAYS_NO_PLACE = frozenset({"level", "singleSide"})


def as_served(text: str, name: str) -> str:
    """The map with a place on Earth, and with junctions that are not called like roads.

    OpenDRIVE counts roads and junctions apart; the wheel looks for a road first and then finds no way into a junction
    of the same id.

    Args:
        text: OpenDRIVE.
        name: What messages call the map.

    Raises:
        MapError: It is not XML, or has a road of left-hand traffic.
    """
    try:
        root = Xml.fromstring(text.encode())
    except (Xml.ParseError, ValueError, LookupError) as error:  # or an encoding that it names is none
        raise MapError(f"the map is not XML: {error}") from error
    check_right_hand(root, name)
    clashing = _clashing(root)
    header = root.find("header")
    missing = header is not None and header.find("geoReference") is None
    if not clashing and not missing:
        return text
    if header is not None and missing:
        Xml.SubElement(header, "geoReference").text = _REFERENCE
    for element in root.iter():
        if element.tag == "junction" and element.get("id") in clashing:
            element.set("id", clashing[element.get("id", "")])
        elif element.tag == "road" and element.get("junction") in clashing:
            element.set("junction", clashing[element.get("junction", "")])
        elif element.get("elementType") == "junction" and element.get("elementId") in clashing:
            element.set("elementId", clashing[element.get("elementId", "")])
    return Xml.tostring(root, encoding="unicode", xml_declaration=True)


def _clashing(root: Xml.Element) -> dict[str, str]:
    """New ids, above all others, for the junctions whose id a road has, too."""
    roads = {road.get("id", "") for road in root.iter("road")}
    junctions = [junction.get("id", "") for junction in root.iter("junction")]
    above = 1 + max((int(name) for name in (*roads, *junctions) if name.isdigit()), default=0)
    return {name: str(above + i) for i, name in enumerate(name for name in junctions if name in roads)}


def same_roads(one: str, other: str) -> bool:
    """Whether two maps have the same lanes in the same places, to a millimetre, whatever else they say.

    Raises:
        MapError: One is not XML.
    """
    return _roads(one) == _roads(other)


def _roads(text: str) -> dict[str, list[object]]:
    """Of each road by its id, the elements that say where its lanes are."""
    try:
        root = Xml.fromstring(text.encode())
    except (Xml.ParseError, ValueError, LookupError) as error:  # or an encoding that it names is none
        raise MapError(f"the map is not XML: {error}") from error
    return {road.get("id", ""): [_rounded(element) for element in _shape(road)] for road in root.iter("road")}


def _shape(road: Xml.Element) -> Iterator[Xml.Element]:
    for place in ("planView", "elevationProfile", "lanes"):
        for part in road.iterfind(place):
            yield from (element for element in part.iter() if element.tag in _SHAPE)


def _rounded(element: Xml.Element) -> tuple[object, ...]:
    kept = sorted((name, value) for name, value in element.attrib.items() if name not in _SAYS_NO_PLACE)
    return element.tag, *((name, _number(value)) for name, value in kept)


def _number(value: str) -> float | str:
    try:
        return round(float(value), 3) + 0.0  # no negative zero
    except ValueError:
        return value
