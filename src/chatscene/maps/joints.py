"""Joints of streets that no car could drive, cut out of a map that was made of an extract of OpenStreetMap.

Where the number of lanes changes, netconvert leads lanes over into others within a few metres, however far aside those
are. A lane that bends so sharply covers itself, and no reader makes an area of it.
"""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple
from xml.etree import ElementTree as Xml

from chatscene.errors import MapError, UnreadRoad
from chatscene.files.atomic import write_whole
from chatscene.maps.network import load_network


class Cut(NamedTuple):
    """A joint that was cut out: the node of OpenStreetMap at which it was, and why."""

    node: str
    why: str


def write_loadable(path: Path, xodr: bytes, extract: Path) -> tuple[Cut, ...]:
    """Write a map without the joints that cannot be made into lanes.

    Returns:
        What was cut out; a street ends there.

    Raises:
        MapError: A street itself cannot be made into lanes, or nothing is left to drive on.
    """
    cuts: list[Cut] = []
    while True:
        write_whole(path, xodr)
        try:
            load_network(path)
            return tuple(cuts)
        except MapError as error:
            path.unlink()
            why = str(error).removeprefix(f"map {path.name!r} ").removesuffix(f" ({path})")
            joint = _without(xodr, error.road) if isinstance(error, UnreadRoad) else None
            if joint is None:
                raise MapError(f"{extract} becomes a map that {why}; leave that part out of the extract") from error
            node, xodr = joint
            cuts.append(Cut(node, why.rpartition("made into lanes: ")[2]))


def _without(xodr: bytes, number: str) -> tuple[str, bytes] | None:
    """The node of a joint and the map without it, or None if the road is a street and no joint."""
    head, opening, _ = xodr.partition(b"<OpenDRIVE")  # with whose streets they are
    assert opening
    root = Xml.fromstring(xodr)
    road = next((one for one in root.iterfind("road") if one.get("id") == number), None)
    if road is None or road.get("junction", "-1") == "-1":
        return None
    root.remove(road)
    for junction in root.findall("junction"):
        for connection in junction.findall(f"connection[@connectingRoad='{number}']"):
            junction.remove(connection)
        if junction.get("id") == road.get("junction") and junction.find("connection") is None:
            root.remove(junction)
            _unlink(root, junction.get("id", ""))
    # netconvert calls it by a colon, the node, and the number of the joint there
    return road.get("name", "").removeprefix(":").rpartition("_")[0], head + Xml.tostring(root) + b"\n"


def _unlink(root: Xml.Element, junction: str) -> None:
    for link in root.iterfind("road/link"):
        for end in list(link):
            if end.get("elementType") == "junction" and end.get("elementId") == junction:
                link.remove(end)
