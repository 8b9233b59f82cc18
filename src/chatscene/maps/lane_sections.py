"""Sections of lanes that are told for one side of a road, told for both.

With ``singleSide="true"`` a section holds for the side whose lanes it has; the lanes of the other side go on as in the
section before. Source: ASAM OpenDRIVE 1.8.1, section 11.3 (lane sections).
"""

from __future__ import annotations

from copy import deepcopy
from xml.etree import ElementTree as Xml

from chatscene.maps.lane_widths import cubic_from

_SIDES = ("left", "right")
_CUBIC = frozenset(("width", "border"))


def told_for_both_sides(road: Xml.Element) -> None:
    """Tell each section of a road for both sides; one without numbers stays as it is."""
    lanes = road.find("lanes")
    sections = road.findall("lanes/laneSection")
    if lanes is None or not any(_is_single(one) for one in sections):
        return
    try:
        begun = [(float(one.get("s", "")), one) for one in sections]
        starts = sorted({s for s, _ in begun})
        sides = {side: _parts(begun, starts, side) for side in _SIDES}
    except ValueError:  # what is no number is told where it stands
        return
    at = list(lanes).index(sections[0])
    for one in sections:
        lanes.remove(one)
    for number, start in enumerate(starts):
        whole = Xml.Element("laneSection", {"s": repr(start)})
        middle = next((c for s, one in reversed(begun) if s <= start and (c := one.find("center")) is not None), None)
        parts = (sides["left"][number], None if middle is None else deepcopy(middle), sides["right"][number])
        whole.extend(part for part in parts if part is not None)
        lanes.insert(at + number, whole)


def _is_single(section: Xml.Element) -> bool:
    return section.get("singleSide", "false").strip().lower() in ("true", "1")


def _parts(begun: list[tuple[float, Xml.Element]], starts: list[float], side: str) -> list[Xml.Element | None]:
    """What a side is in the section that begins at each start."""
    found: list[Xml.Element | None] = []
    own = [(s, one.find(side)) for s, one in begun if not _is_single(one) or one.find(side) is not None]
    last: tuple[float, Xml.Element] | None = None
    for start in starts:
        told = [lanes for s, lanes in own if s == start]
        if told:
            last = None if told[-1] is None else (start, told[-1])
            found.append(None if last is None else last[1])
            continue
        found.append(None if last is None or not found or found[-1] is None else _goes_on(last, found[-1], start))
    return found


def _goes_on(first: tuple[float, Xml.Element], before: Xml.Element, start: float) -> Xml.Element:
    """The lanes of a side from a place on, which lead on those before it there."""
    begun, lanes = first
    on = deepcopy(lanes)
    for lane, earlier in zip(on.iter("lane"), before.iter("lane"), strict=True):
        _from_place(lane, start - begun)
        number, links, back = lane.get("id", ""), _links(lane), _links(earlier)
        onward = back.find("successor")
        for link in links.findall("predecessor") + links.findall("successor"):
            links.remove(link)
        Xml.SubElement(links, "predecessor", {"id": number})
        if onward is not None:
            back.remove(onward)
            links.append(onward)
        Xml.SubElement(back, "successor", {"id": number})
    return on


def _links(lane: Xml.Element) -> Xml.Element:
    found = lane.find("link")
    if found is None:
        found = Xml.Element("link")
        lane.insert(0, found)
    return found


def _from_place(lane: Xml.Element, since: float) -> None:
    """Tell what a lane is from a place on, so far [m] into its section."""
    for tag in {inner.tag for inner in lane if "sOffset" in inner.attrib}:
        steps = [(float(inner.get("sOffset", "")), inner) for inner in lane.findall(tag)]
        held = [inner for s, inner in steps if s <= since][-1:]
        for s, inner in steps:
            if s > since:
                inner.set("sOffset", repr(s - since))
            elif inner not in held:
                lane.remove(inner)
        for inner in held:
            if tag in _CUBIC:
                a, b, c, d = (float(inner.get(name, "")) for name in "abcd")
                moved = cubic_from([(float(inner.get("sOffset", "")), (a, b, c, d))], since)
                inner.attrib.update({name: repr(value) for name, value in zip("abcd", moved, strict=True)})
            inner.set("sOffset", "0.0")
