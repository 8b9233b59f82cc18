"""Lanes that are no lanes for a stretch: sections of a road divided where a lane is too thin to be one.

Where a lane opens or tapers out, makers write it into the whole section, with no width or next to none at first. No
area can be drawn of such a stretch. So the section is divided there, and in the thin part nobody drives on the lane.
"""

from __future__ import annotations

import copy
from itertools import pairwise
from xml.etree import ElementTree as Xml

THIN = 0.1  # [m] of width, less than which is no lane: twice the tolerance to which areas are drawn
SHORT = 0.5  # [m], a thin stretch that is shorter stays as it is: an edge may run so far outside its area
STEP = 0.25  # [m] at which widths are looked at, and sections divided


def divide_thin(road: Xml.Element) -> None:
    """Divide the sections of a road where a lane becomes too thin or wide enough; those without numbers stay."""
    lanes = road.find("lanes")
    if lanes is None:
        return
    try:
        sections = lanes.findall("laneSection")
        starts = [float(section.get("s", "")) for section in sections]
        for section, start, end in zip(sections, starts, [*starts[1:], float(road.get("length", ""))], strict=True):
            parts = _divided(section, start, end)
            at = list(lanes).index(section)
            lanes.remove(section)
            for part in reversed(parts):
                lanes.insert(at, part)
    except ValueError:  # what is no number is told where it stands
        return


def _divided(section: Xml.Element, start: float, end: float) -> list[Xml.Element]:
    thin = {
        lane.get("id", ""): spans
        for lane in section.iter("lane")
        if lane.get("type") != "none" and lane.find("width") is not None and (spans := _thin(lane, end - start))
    }
    cuts = sorted({at for spans in thin.values() for span in spans for at in span} - {0.0, end - start})
    if not thin:
        return [section]
    parts: list[Xml.Element] = []
    bounds = [0.0, *cuts, end - start]
    for number, (begin, stop) in enumerate(pairwise(bounds)):
        part = copy.deepcopy(section)
        part.set("s", repr(start + begin))
        for lane in part.iter("lane"):
            _shift(lane, begin)
            _link(lane, "predecessor", first=number == 0)
            _link(lane, "successor", first=number == len(bounds) - 2)
            if any(low <= begin and stop <= high for low, high in thin.get(lane.get("id", ""), ())):
                lane.set("type", "none")
        parts.append(part)
    return parts


def _thin(lane: Xml.Element, length: float) -> list[tuple[float, float]]:
    """Where [m] from the start of its section a lane is thin for longer than is short."""
    widths = [[float(one.get(name, "")) for name in ("sOffset", "a", "b", "c", "d")] for one in lane.iter("width")]
    count = max(int(length / STEP), 1)
    places = [*(i * STEP for i in range(count)), length]
    spans: list[tuple[float, float]] = []
    since: float | None = None
    for s in places:
        offset, a, b, c, d = next((one for one in reversed(widths) if one[0] <= s), widths[0])
        x = s - offset
        narrow = a + x * (b + x * (c + x * d)) < THIN
        if narrow and since is None:
            since = s
        if since is not None and (not narrow or s == length):
            if s - since > SHORT:
                spans.append((since, s))
            since = None
    return spans


def _shift(lane: Xml.Element, by: float) -> None:
    """Let what a lane says count from so much further on [m]."""
    for tag in {one.tag for one in lane if one.get("sOffset") is not None}:
        records = sorted(lane.findall(tag), key=lambda one: float(one.get("sOffset", "")))
        for record, after in zip(records, [*records[1:], None], strict=True):
            offset = float(record.get("sOffset", "")) - by
            if after is not None and float(after.get("sOffset", "")) <= by:
                lane.remove(record)
            elif offset >= 0:
                record.set("sOffset", repr(offset))
            else:
                if tag == "width":
                    a, b, c, d = (float(record.get(name, "")) for name in "abcd")
                    x = -offset
                    moved = (a + x * (b + x * (c + x * d)), b + x * (2 * c + 3 * d * x), c + 3 * d * x, d)
                    for name, value in zip("abcd", moved, strict=True):
                        record.set(name, repr(value))
                record.set("sOffset", "0.0")


def _link(lane: Xml.Element, end: str, *, first: bool) -> None:
    """Link a lane of a part to its own number in the next part, where that is not an end of the section."""
    if first or lane.get("id") == "0":
        return
    link = lane.find("link")
    if link is None:
        link = Xml.Element("link")
        lane.insert(0, link)
    for one in link.findall(end):
        link.remove(one)
    Xml.SubElement(link, end, id=lane.get("id", ""))
