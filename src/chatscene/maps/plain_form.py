"""Other makers' OpenDRIVE, told in the one form that is read: whole numbers as names, widths, cubics from 0 to 1.

What can be told in another way without loss is told so, and nothing is said of it: an XML namespace, names of roads and
junctions that are no numbers, borders of lanes, <poly3>. What is wrong in a file, and whose meaning is plain all the
same, is put right within stated bounds, and each such place is told. What is neither stays as it is, for
`chatscene.maps.unread` to name.

Source: ASAM OpenDRIVE 1.8.1, sections 9 (geometry), 10 (roads), 11 (lanes), 12 (junctions); 1.4H for <poly3>.
"""

from __future__ import annotations

from xml.etree import ElementTree as Xml

from chatscene.maps.curves import normalise
from chatscene.maps.direct_junctions import set_aside
from chatscene.maps.lane_links import unlink
from chatscene.maps.lane_sections import told_for_both_sides
from chatscene.maps.lane_types import as_driven
from chatscene.maps.lane_widths import told_by_widths
from chatscene.maps.left_hand import mirror
from chatscene.maps.line_pieces import begin_offsets, join_pieces
from chatscene.maps.thin_lanes import divide_thin
from chatscene.maps.virtual_junctions import set_virtual_aside

FORM = 2
"""A number for this form; where the form changes, another, so that no network of an older one is taken."""

WRITTEN = "writtenId"
"""The attribute with the name of a road or junction as its file has it, where that is no number."""

_NAMES = (
    ("road", "road", ("id",)),
    ("road", "junction", ("junction",)),
    ("connection", "road", ("incomingRoad", "connectingRoad", "linkedRoad")),
    ("junction", "junction", ("id",)),
)


def without_namespace(root: Xml.Element) -> None:
    """Take the XML namespace of OpenDRIVE away from the names of all elements."""
    if root.tag.endswith("}OpenDRIVE"):
        space = root.tag[: -len("OpenDRIVE")]
        for element in root.iter():
            if isinstance(element.tag, str):  # pyright: ignore[reportUnnecessaryIsInstance] - a comment has none
                element.tag = element.tag.removeprefix(space)


def in_plain_form(root: Xml.Element, *, again: bool = False) -> tuple[str, ...]:
    """Tell a map in the form that is read.

    Args:
        root: The map, whose numbers have been checked; it is changed.
        again: Whether it could not be read so. Then lanes that are too thin for a stretch are none there, only lanes
            that lead into a junction come into it, and roads in a junction may lead on into the next one.

    Returns:
        What was wrong and has been put right, by road, section and lane.
    """
    without_namespace(root)
    mirror(root)
    _number_names(root)
    notes = set_virtual_aside(root)
    for road in root.iter("road"):
        notes += join_pieces(road)
        for geometry in road.iterfind("planView/geometry"):
            normalise(geometry)
        begin_offsets(road)
        told_for_both_sides(road)
        notes += as_driven(road)
        told_by_widths(road)
        if again:
            divide_thin(road)
    set_aside(root, again=again)
    return (*notes, *unlink(root, again=again))


def name_of(element: Xml.Element) -> str:
    """A road's or junction's name as its file has it."""
    return element.get(WRITTEN, element.get("id", ""))


def _number_names(root: Xml.Element) -> None:
    """Give roads and junctions whose names are no numbers the lowest free ones, in the order of the file."""
    for kind in ("road", "junction"):
        named = [element for element in root.iterfind(kind) if element.get("id")]
        odd = [element for element in named if not _is_number(element.get("id", ""))]
        if not odd:
            continue
        taken = {int(element.get("id", "")) for element in named if _is_number(element.get("id", ""))}
        free = (number for number in range(1, len(named) + len(taken) + 2) if number not in taken)
        number_of = {element.get("id", ""): str(next(free)) for element in odd}
        for element in odd:
            element.set(WRITTEN, element.get("id", ""))
        for tag, what, attributes in _NAMES:
            for element in root.iter(tag) if what == kind else ():
                _rename(element, attributes, number_of)
        for end in ("predecessor", "successor"):
            for element in root.iterfind(f"road/link/{end}"):
                if element.get("elementType") == kind:
                    _rename(element, ("elementId",), number_of)


def _rename(element: Xml.Element, attributes: tuple[str, ...], number_of: dict[str, str]) -> None:
    for attribute in attributes:
        if (new := number_of.get(element.get(attribute, ""))) is not None:
            element.set(attribute, new)


def _is_number(written: str) -> bool:
    return written.removeprefix("-").isdecimal()
