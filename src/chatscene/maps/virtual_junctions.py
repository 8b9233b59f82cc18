"""Virtual junctions: what branches off somewhere along a road that goes on, such as a way to a house.

They are not read. The road goes on, and what branches off is left out with the junction.
Source: ASAM OpenDRIVE 1.8.1, section 12.5 (virtual junctions).
"""

from __future__ import annotations

from xml.etree import ElementTree as Xml


def set_virtual_aside(root: Xml.Element) -> list[str]:
    """Leave out virtual junctions, their roads, and the links to those.

    Returns:
        Which were left out.
    """
    found: list[str] = []
    for junction in [one for one in root.iterfind("junction") if one.get("type") == "virtual"]:
        number = junction.get("id", "")
        roads = [road for road in root.iterfind("road") if road.get("junction") == number]
        for element in (junction, *roads):
            root.remove(element)
        gone = {("road", road.get("id", "")) for road in roads} | {("junction", number)}
        for link in root.iterfind("road/link"):
            for end in [one for one in link if (one.get("elementType", ""), one.get("elementId", "")) in gone]:
                link.remove(end)
        named = ", ".join(repr(_name(road)) for road in roads) or "none"
        found.append(
            f"junction {_name(junction)!r} is virtual, which is not supported; it is left out with its roads: {named}"
        )
    return found


def _name(element: Xml.Element) -> str:
    return element.get("writtenId", element.get("id", ""))
