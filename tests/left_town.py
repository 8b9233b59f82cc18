"""A packaged map where everybody keeps to the left: its mirror image, with the rule that says so."""

from __future__ import annotations

from pathlib import Path
from xml.etree import ElementTree as Xml

from chatscene.maps.left_hand import LEFT, mirror
from chatscene.maps.network import PACKAGED


def left_town(folder: Path, name: str = "town") -> Path:
    """That map as a file in a folder."""
    tree = Xml.parse(PACKAGED[name])
    root = tree.getroot()
    for road in root.iter("road"):
        road.set("rule", LEFT)
    mirror(root)
    for road in root.iter("road"):
        road.set("rule", LEFT)
    path = folder / f"left-{name}.xodr"
    tree.write(path, encoding="UTF-8", xml_declaration=True)
    return path
