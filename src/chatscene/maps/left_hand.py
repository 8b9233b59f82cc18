"""Maps of left-hand traffic: each is read as its mirror image, in which everybody keeps to the right.

All that finds ways, drives and judges keeps to the right. The image of a map in its x axis is a map of right-hand
traffic: y, t, headings, curvatures and the numbers of lanes change their sign, and lengths along roads stay. What comes
from such a map is mirrored once more where it leaves (`chatscene.terms.mirroring`).

Source: ASAM OpenDRIVE 1.8.1, sections 7 (header), 9 (geometry), 10.4 (rule), 11 (lanes), 12 (junctions), 13 (objects),
14 (signals); t counts to the left of s in both kinds of traffic.
"""

from __future__ import annotations

import hashlib
import re
from collections.abc import Iterator
from functools import lru_cache
from pathlib import Path
from xml.etree import ElementTree as Xml

from chatscene.errors import MapError

LEFT, RIGHT = "LHT", "RHT"
"""The rules of a road; one without a rule is of right-hand traffic."""

_CUBIC = ("a", "b", "c", "d")
_SIDED: dict[str, tuple[str, ...]] = {
    "offset": ("y", "hdg"),
    "geometry": ("y", "hdg"),
    "arc": ("curvature",),
    "spiral": ("curvStart", "curvEnd"),
    "poly3": _CUBIC,
    "paramPoly3": ("aV", "bV", "cV", "dV"),
    "laneOffset": _CUBIC,
    "lane": ("id",),
    "border": _CUBIC,
    "laneLink": ("from", "to"),
    "startLaneLink": ("from", "to"),
    "endLaneLink": ("from", "to"),
    "object": ("t", "hdg"),
    "objectReference": ("t",),
    "repeat": ("tStart", "tEnd"),
    "cornerRoad": ("t",),
    "cornerLocal": ("v",),
    "signal": ("t", "hOffset"),
    "signalReference": ("t",),
    "positionRoad": ("t", "hOffset"),
    "positionInertial": ("y", "hdg"),
}
"""The attributes of an element that change their sign. Heights across a road stay as they are: nothing reads them."""
_SWAPPED = {"header": ("north", "south"), "validity": ("fromLane", "toLane")}
"""Pairs of such attributes that are the ends of a span."""
_NUMBER = re.compile(r"-?\b([1-9]\d*)")
_LANES = re.compile(r"\blanes? '?-?[1-9]\d*'?(?:,? and '?-?[1-9]\d*|(?: there)?, but \[[-\d, ]*\])?")
_OPPOSITE = {"left": "right", "right": "left"}


def keeps_left(path: Path) -> bool:
    """Whether a map is of left-hand traffic, so that it is read as its mirror image.

    Raises:
        MapError: It cannot be read.
    """
    try:
        content = path.read_bytes()
    except OSError as error:
        raise MapError(f"map {path.name!r} cannot be read: {error.strerror} ({path})") from error
    return _says_left(hashlib.blake2b(content, digest_size=12).hexdigest(), content) if _says(content) else False


def left_handed(root: Xml.Element) -> str | None:
    """The id of a road of left-hand traffic; None where there is none."""
    return next((road.get("id", "") for road in _roads(root) if road.get("rule") == LEFT), None)


def lanes_on_map(told: str) -> str:
    """Words of the mirror image with the numbers of its lanes as the map has them, as in "lane '-1'"."""

    def turned(found: re.Match[str]) -> str:
        return _NUMBER.sub(lambda one: one[1] if one[0].startswith("-") else f"-{one[1]}", found[0])

    return _LANES.sub(turned, told)


def check_right_hand(root: Xml.Element, name: str) -> None:
    """Refuse a map of left-hand traffic, for those who drive on the map itself.

    Raises:
        MapError: It is one.
    """
    if (road := left_handed(root)) is not None:
        raise MapError(
            f"map {name!r} is of left-hand traffic: road {road[:40]!r} keeps to the left (rule {LEFT}), and CARLA's "
            "drivers and ours there keep to the right; drive on it without CARLA"
        )


def check_one_rule(root: Xml.Element, path: Path) -> None:
    """Hold a map to keeping to one side.

    Raises:
        MapError: It keeps to the left on one road and to the right on another.
    """
    left = left_handed(root)
    right = next((road.get("id", "") for road in _roads(root) if road.get("rule") != LEFT), None)
    if left is not None and right is not None:
        raise MapError(
            f"map {path.name!r} keeps to the left on road {left[:40]!r} (rule {LEFT}) and to the right on road "
            f"{right[:40]!r}; give all of its roads one rule ({path})"
        )


def mirror(root: Xml.Element) -> None:
    """Change a map of left-hand traffic into its image in the x axis, which is of right-hand traffic; others stay."""
    if left_handed(root) is None:
        return
    theirs = {inner for own in root.iter("userData") for inner in own.iter()}  # which only its maker understands
    for element in [one for one in root.iter() if one not in theirs]:
        for name in _SIDED.get(str(element.tag), ()):
            _negate(element, name)
        if (span := _SWAPPED.get(str(element.tag))) is not None:
            _turn_span(element, *span)
        if element.tag == "marking" and (side := _OPPOSITE.get(element.get("side", ""))):
            element.set("side", side)
    for road in _roads(root):
        road.set("rule", RIGHT)
        for link in road.iterfind("lanes/laneSection/*/lane/link/*"):
            _negate(link, "id")
        for section in road.iterfind("lanes/laneSection"):
            _swap_sides(section)


def _says(content: bytes) -> bool:
    """Whether a file may say so: letters may also be written by their numbers."""
    return any(one in content for one in (b"&#", LEFT.encode(), LEFT.encode("utf-16-le"), LEFT.encode("utf-16-be")))


@lru_cache(maxsize=8)
def _says_left(_digest: str, content: bytes) -> bool:
    try:
        return left_handed(Xml.fromstring(content)) is not None
    except Xml.ParseError:  # which is told by whoever reads the map
        return False


def _roads(root: Xml.Element) -> Iterator[Xml.Element]:
    """The roads, whatever the namespace."""
    return (one for one in root if isinstance(one.tag, str) and one.tag.rpartition("}")[2] == "road")  # pyright: ignore[reportUnnecessaryIsInstance] - a comment has none


def _negate(element: Xml.Element, name: str) -> None:
    """Change the sign of a number as it is written, so that no digit is lost."""
    written = element.get(name, "").strip()
    if written.strip("+-0.eE"):
        element.set(name, written[1:] if written.startswith("-") else f"-{written.removeprefix('+')}")


def _turn_span(element: Xml.Element, low: str, high: str) -> None:
    _negate(element, low)
    _negate(element, high)
    ends = element.get(low), element.get(high)
    for name, value in zip((high, low), ends, strict=True):
        if value is not None:
            element.set(name, value)


def _swap_sides(section: Xml.Element) -> None:
    """Put the lanes of each side on the other, from the reference line outwards as they were."""
    sides = {side: section.find(side) for side in _OPPOSITE}
    for side, lanes in sides.items():
        if lanes is not None:
            lanes.tag = _OPPOSITE[side]
            lanes[:] = reversed(lanes)
    order = {"left": 0, "center": 1, "right": 2}
    section[:] = sorted(section, key=lambda one: order.get(str(one.tag), 3))
