"""The map of a scenario that names no road network: open ground, with one straight road under its ego.

The standard lets a scenario go without roads; its places are coordinates then, and everybody goes straight on. A drive
needs a map with a lane, so one is drawn through where the ego begins, along the way that it faces.
"""

from __future__ import annotations

import hashlib
import math
from pathlib import Path

from chatscene.errors import ScenarioError
from chatscene.files.caches import cache_folder, keep, only_mine
from chatscene.imports.entities import Entities
from chatscene.imports.given import Given, Refused
from chatscene.imports.stranger_xml import Element

_BEHIND, _AHEAD = 300.0, 2_000.0  # [m] of road
_WIDTH = 3.5  # [m] of a lane
_BY_ROADS = frozenset(
    ("LanePosition", "RoadPosition", "RelativeLanePosition", "RelativeRoadPosition", "RoutePosition", "GeoPosition")
)


def open_ground(root: Element, given: Given, path: Path) -> Path:
    """The map, kept in the user's cache folder by its content.

    Raises:
        ScenarioError: Its places are told by roads, its ego is not placed, or there is no cache folder.
    """
    told = next((one for one in root.walk() if one.tag in _BY_ROADS), None)
    if told is not None:
        raise ScenarioError(f"{path} names no map, and {told.where} tells a <{told.tag}>; name the map with --map")
    try:
        x, y, heading = _begins(root, given)
    except Refused as reason:
        raise ScenarioError(
            f"{path} names no map, and its ego begins nowhere: {reason}; name a map with --map"
        ) from None
    folder = only_mine(cache_folder("maps"))
    if folder is None:
        raise ScenarioError(f"{path} names no map, and there is no folder to keep one in; name one with --map")
    text = _text(x, y, heading)
    found = folder / f"open-ground-{hashlib.blake2b(text.encode(), digest_size=6).hexdigest()}.xodr"
    if not found.is_file():
        keep(found, text.encode())
    return found


def is_open_ground(path: Path) -> bool:
    """Whether a map is one that was made here."""
    return path.parent == cache_folder("maps") and path.name.startswith("open-ground-")


def _begins(root: Element, given: Given) -> tuple[float, float, float]:
    """X [m], y [m] and heading [rad] at which the ego begins."""
    ego = Entities(root, given).ego()
    actions = root.find("Storyboard", "Init", "Actions")
    own = [one for one in (actions.inside if actions else []) if one.attributes.get("entityRef") == ego]
    own += [one for one in root.walk() if one.tag == "EntityAction" and one.attributes.get("entityRef") == ego]
    place = next((place for one in own for place in one.walk() if place.tag == "WorldPosition"), None)
    if place is None:
        raise Refused(root, "it is put at no WorldPosition")
    return given.number(place, "x"), given.number(place, "y"), given.number(place, "h", "0")


def _text(x: float, y: float, heading: float) -> str:
    """OpenDRIVE of a road with a lane each way, of which the right one leads through a pose."""
    left, c, s = _WIDTH / 2, math.cos(heading), math.sin(heading)
    x0, y0 = x - _BEHIND * c - left * s, y - _BEHIND * s + left * c
    length = _BEHIND + _AHEAD
    lane = '<lane id="{0}" type="driving" level="false"><link/><width sOffset="0" a="{1}" b="0" c="0" d="0"/></lane>'
    return f"""<?xml version="1.0" encoding="UTF-8"?>
<OpenDRIVE>
<header revMajor="1" revMinor="4" name="open ground" version="1"/>
<road name="" length="{length:.3f}" id="0" junction="-1">
<link/>
<planView>
<geometry s="0" x="{x0:.4f}" y="{y0:.4f}" hdg="{heading:.6f}" length="{length:.3f}"><line/></geometry>
</planView>
<lanes><laneSection s="0">
<left>{lane.format(1, _WIDTH)}</left>
<center><lane id="0" type="none" level="false"/></center>
<right>{lane.format(-1, _WIDTH)}</right>
</laneSection></lanes>
</road>
</OpenDRIVE>
"""
