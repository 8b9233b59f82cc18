"""Links of roads and lanes that lead to nothing, which are left out, and ends of roads at junctions, which are added.

A link to a road or a lane that is not there is left out and told. One to a lane that nobody drives on, such as a
shoulder, is left out and not told, since nothing is wrong with it. A road that a junction says comes into it, or that
a connecting road of it leads to, ends at that junction, whether or not the road says so.
Source: ASAM OpenDRIVE 1.8.1, sections 10.3 (links of roads), 11.6 (of lanes), 12.2 to 12.4 (junctions).
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from xml.etree import ElementTree as Xml

DRIVEN = frozenset({"driving", "entry", "exit", "offRamp", "onRamp", "connectingRamp"})
"""The types of lanes that are driven on."""

_ENDS = {"predecessor": ("start", 0), "successor": ("end", -1)}


def unlink(root: Xml.Element, *, again: bool) -> list[str]:
    """Leave out what leads to nothing, in all roads and junctions of a map; those without numbers stay.

    Args:
        root: The map, which is changed.
        again: Whether lanes that lead away from a junction are taken for none that come into it, whatever its
            connections say, and lanes of connecting roads that say nothing lead on to those with their numbers.

    Returns:
        What is wrong in the file, left out or added.
    """
    try:
        return list(_Links(root, again=again).mended())
    except ValueError:  # what is no number is told where it stands
        return []


class _Links:
    """The roads of a map by number, and what its links lead to."""

    def __init__(self, root: Xml.Element, *, again: bool) -> None:
        self.root, self.again = root, again
        self.roads = {road.get("id", ""): road for road in root.iterfind("road")}
        self.junctions = {junction.get("id", ""): junction for junction in root.iterfind("junction")}

    def mended(self) -> Iterator[str]:
        for road in self.roads.values():
            for lane in road.iter("lane"):
                _without_width(lane)
        for junction in list(self.junctions.values()):
            yield from self._junction(junction)
        for road in self.roads.values():
            yield from self._road(road)
        self._signals()

    def _junction(self, junction: Xml.Element) -> Iterator[str]:
        told = f"junction {_name(junction)!r}"
        for connection in junction.findall("connection"):
            incoming = self.roads.get(connection.get("incomingRoad", ""))
            through = self.roads.get(connection.get("connectingRoad", ""))
            if connection.get("connectingRoad") is None:
                continue
            if incoming is None or through is None:
                missing = connection.get("incomingRoad" if incoming is None else "connectingRoad")
                if through is None:  # else its road belongs to the junction's area all the same
                    junction.remove(connection)
                yield f"{told}: connection {connection.get('id')!r} is of road {missing!r}, which is missing; left out"
                continue
            at_start = connection.get("contactPoint") == "start"
            if not self._ends_at(incoming, junction, through, at_start=at_start):
                junction.remove(connection)
                yield (
                    f"{told}: connection {connection.get('id')!r} comes from road {_name(incoming)!r}, of which "
                    "neither end is there; left out"
                )
                continue
            onward = self._beyond(through, "successor" if at_start else "predecessor")
            if onward is not None and onward[0].get("junction", "-1") == "-1":
                self._say_end(onward[0], junction, onward[1])
            yield from self._lane_links(junction, connection, incoming, through, at_start=at_start)
        if not junction.findall("connection"):
            self.root.remove(junction)
            self.junctions.pop(junction.get("id", ""))

    def _lane_links(
        self,
        junction: Xml.Element,
        connection: Xml.Element,
        incoming: Xml.Element,
        through: Xml.Element,
        *,
        at_start: bool,
    ) -> Iterator[str]:
        """Leave out links to lanes of the connecting road that are not there; all that link none are of no use."""
        end = self._end_at(incoming, junction)
        lanes_in, lanes = _lanes(incoming, 0 if end == "predecessor" else -1), _lanes(through, 0 if at_start else -1)
        if not connection.findall("laneLink"):  # then each lane leads to that of its own number
            for number in (one for one in lanes_in if one in lanes):
                Xml.SubElement(connection, "laneLink", {"from": number, "to": number})
        for link in connection.findall("laneLink"):
            one, other = link.get("from", ""), link.get("to", "")
            if one not in lanes_in or (lanes_in[one] in DRIVEN and other not in lanes):
                yield (
                    f"junction {_name(junction)!r}: connection {connection.get('id')!r} links lane {one!r} of road "
                    f"{_name(incoming)!r} to lane {other!r} of road {_name(through)!r}, and one is not there; left out"
                )
            leaves = self.again and (int(one) < 0) == (end == "predecessor")
            if one not in lanes_in or leaves or (lanes_in[one] in DRIVEN and lanes.get(other) not in DRIVEN):
                connection.remove(link)
        if not connection.findall("laneLink"):
            junction.remove(connection)

    def _ends_at(self, road: Xml.Element, junction: Xml.Element, through: Xml.Element, *, at_start: bool) -> bool:
        """Whether a road ends at a junction, as itself or its connecting road says; then it says so itself."""
        if self._end_at(road, junction) is not None:
            return True
        back = self._beyond(through, "predecessor" if at_start else "successor")
        return back is not None and back[0] is road and self._say_end(road, junction, back[1])

    def _end_at(self, road: Xml.Element, junction: Xml.Element) -> str | None:
        for end in _ENDS:
            link = road.find(f"link/{end}")
            if link is not None and (link.get("elementType"), link.get("elementId")) == (
                "junction",
                junction.get("id"),
            ):
                return end
        return None

    def _say_end(self, road: Xml.Element, junction: Xml.Element, contact: str) -> bool:
        """Let a road say that it ends at a junction, if nothing is said of that end."""
        end = "predecessor" if contact == "start" else "successor"
        if self._end_at(road, junction) is not None:
            return True
        link = road.find("link")
        if link is None:
            link = Xml.Element("link")
            road.insert(0, link)
        if link.find(end) is not None:
            return False
        Xml.SubElement(link, end, elementType="junction", elementId=junction.get("id", ""))
        return True

    def _beyond(self, road: Xml.Element, end: str) -> tuple[Xml.Element, str] | None:
        """The road beyond an end of a road, and which end of that one is there."""
        link = road.find(f"link/{end}")
        if link is None or link.get("elementType") != "road":
            return None
        other = self.roads.get(link.get("elementId", ""))
        if other is None:
            return None
        contact = link.get("contactPoint") or self._contact(other, road)
        return None if contact is None else (other, contact)

    def _contact(self, other: Xml.Element, road: Xml.Element) -> str | None:
        """The end of another road at which a road lies, as the other one says."""
        for end, (contact, _) in _ENDS.items():
            link = other.find(f"link/{end}")
            if link is not None and _leads_to(link, "road", road):
                return contact
        return None

    def _road(self, road: Xml.Element) -> Iterator[str]:
        for end, (_, number) in _ENDS.items():
            link = road.find(f"link/{end}")
            if link is None:
                self._no_lanes_beyond(road, end, number)
                continue
            if link.get("elementType") == "junction":
                if link.get("elementId") not in self.junctions:
                    road.find("link").remove(link)  # pyright: ignore[reportOptionalMemberAccess] - it is in there
                continue
            beyond = self._beyond(road, end)
            if beyond is None:
                road.find("link").remove(link)  # pyright: ignore[reportOptionalMemberAccess]
                yield (
                    f"road {_name(road)!r}: its {end} is road {link.get('elementId')!r}, which is missing, or of "
                    "which no end is named; left out"
                )
                continue
            other, contact = beyond
            link.set("contactPoint", contact)
            lanes = _lanes(other, 0 if contact == "start" else -1)
            yield from self._lead_on(road, end, _section(road, number), other, contact)
            for lane in _section(road, number).iter("lane"):
                yield from _drop(lane, end, lanes, f"road {_name(road)!r}", f"road {_name(other)!r}")
        sections = road.findall("lanes/laneSection")
        for one, after in pairwise(sections):
            here, there = _of(one), _of(after)
            for lane in one.iter("lane"):
                yield from _drop(lane, "successor", there, _at(road, one), f"the section at s={after.get('s')}")
            for lane in after.iter("lane"):
                yield from _drop(lane, "predecessor", here, _at(road, after), f"the section at s={one.get('s')}")

    def _lead_on(
        self, road: Xml.Element, end: str, section: Xml.Element, other: Xml.Element, contact: str
    ) -> Iterator[str]:
        """Tell lanes of a connecting road none of which says where it leads; let them lead on to those of their number.

        That is done in a map only that cannot be read otherwise.
        """
        driven = [lane for lane in section.iter("lane") if lane.get("type") in DRIVEN]
        if road.get("junction", "-1") == "-1" or any(lane.find(f"link/{end}") is not None for lane in driven):
            return
        lanes = _lanes(other, 0 if contact == "start" else -1)
        turned = contact == ("end" if end == "successor" else "start")  # then numbers grow the other way
        for lane in driven:
            number = int(lane.get("id", "0"))
            beyond = str(-number if turned else number)
            if not number or lanes.get(beyond) not in DRIVEN:
                continue
            if self.again:
                links = lane.find("link")
                Xml.SubElement(Xml.SubElement(lane, "link") if links is None else links, end, {"id": beyond})
            yield f"road {_name(road)!r}: lane {lane.get('id')!r} names no {end} in road {_name(other)!r}"

    def _no_lanes_beyond(self, road: Xml.Element, end: str, number: int) -> None:
        """Of an end of a road beyond which nothing is, no lane leads on."""
        if road.get("junction", "-1") != "-1":
            return
        for lane in _section(road, number).iter("lane"):
            for link in lane.findall(f"link/{end}"):
                lane.find("link").remove(link)  # pyright: ignore[reportOptionalMemberAccess]

    def _signals(self) -> None:
        known = {signal.get("id") for signal in self.root.iterfind("road/signals/signal")}
        for signals in self.root.iterfind("road/signals"):
            for reference in signals.findall("signalReference"):
                if reference.get("id") not in known:
                    signals.remove(reference)


def _leads_to(link: Xml.Element, kind: str, element: Xml.Element) -> bool:
    return (link.get("elementType"), link.get("elementId")) == (kind, element.get("id"))


def _without_width(lane: Xml.Element) -> None:
    """Of a lane that is nowhere wide, say that nobody drives there: it has no place."""
    widths = lane.findall("width")
    if widths and lane.get("type") != "none" and all(not float(w.get(name, "")) for w in widths for name in "abcd"):
        lane.set("type", "none")


def _drop(lane: Xml.Element, end: str, lanes: dict[str, str], where: str, there: str) -> Iterator[str]:
    links = lane.find("link")
    link = None if links is None else links.find(end)
    if links is None or link is None or lanes.get(link.get("id", "")) in DRIVEN:
        return
    if lane.get("type") in DRIVEN or link.get("id") not in lanes:
        links.remove(link)
    if lane.get("type") in DRIVEN and link.get("id") not in lanes:
        to = f"lane {link.get('id')!r} of {there}"
        yield f"{where}: lane {lane.get('id')!r} leads to {to}, which has none such; left out"


def _lanes(road: Xml.Element, number: int) -> dict[str, str]:
    """The lanes of a section of a road by number, with their types."""
    return _of(_section(road, number))


def _section(road: Xml.Element, number: int) -> Xml.Element:
    sections = road.findall("lanes/laneSection")
    return sections[number] if sections else Xml.Element("laneSection")


def _of(section: Xml.Element) -> dict[str, str]:
    return {lane.get("id", ""): lane.get("type", "") for lane in section.iter("lane")}


def _at(road: Xml.Element, section: Xml.Element) -> str:
    return f"road {_name(road)!r}, section at s={section.get('s')}"


def _name(element: Xml.Element) -> str:
    return element.get("writtenId", element.get("id", ""))
