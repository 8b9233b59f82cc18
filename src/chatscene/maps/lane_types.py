"""Lanes that are driven on under another name, or in another direction than their side of the road tells.

Source: ASAM OpenDRIVE 1.8.1, section 11.5 (types of lanes) and 11.1 (their direction).
"""

from __future__ import annotations

from xml.etree import ElementTree as Xml

_ALIKE = {"slipLane": "exit"}  # types that are driven on as another one is


def as_driven(road: Xml.Element) -> list[str]:
    """Tell lanes of a road by the types and directions that are read.

    Returns:
        What cannot be told so: who drives against the direction of its side.
    """
    found: list[str] = []
    for section in road.iterfind("lanes/laneSection"):
        for lane in section.iter("lane"):
            lane.set("type", _ALIKE.get(lane.get("type", ""), lane.get("type", "")))
            way = lane.get("direction", "standard")
            where = f"road {_name(road)!r}, section at s={section.get('s')}: lane {lane.get('id')!r}"
            if way == "reversed":
                lane.set("type", "none")
                found.append(f"{where} is driven against its side of the road, which is not read; it is left out")
            elif way == "both":
                found.append(f"{where} is driven both ways; here it is driven along its side of the road")
    return found


def _name(element: Xml.Element) -> str:
    return element.get("writtenId", element.get("id", ""))
