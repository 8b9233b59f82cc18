"""Pieces of reference lines whose lengths do not fit their places, put right within bounds; and their offsets."""

from __future__ import annotations

from itertools import pairwise
from xml.etree import ElementTree as Xml

MISFIT = 0.1  # [m] by which the length of a piece may differ from where the next one begins
NOTHING = 1e-6  # [m], a piece that is no longer is left out


def join_pieces(road: Xml.Element) -> list[str]:
    """Leave out pieces without length, and end each piece where the next one begins.

    Returns:
        What was put right.
    """
    plan = road.find("planView")
    if plan is None:
        return []
    try:
        pieces = [(float(one.get("s", "")), float(one.get("length", "")), one) for one in plan.findall("geometry")]
    except ValueError:  # what is no number is told where it stands
        return []
    whole = [piece for piece in pieces if piece[1] > NOTHING]
    if whole and len(whole) < len(pieces):
        for _, _, one in [piece for piece in pieces if piece[1] <= NOTHING]:
            plan.remove(one)
        if 0.0 < whole[0][0] <= len(pieces) * NOTHING:
            whole[0][2].set("s", "0.0")
    notes: list[str] = []
    for (s, length, one), (after, _, _) in pairwise(whole):
        misfit = abs(after - s - length)
        if 1e-4 < misfit <= MISFIT and after > s:
            one.set("length", repr(after - s))
            notes.append(
                f"road {road.get('writtenId', road.get('id', ''))!r}: the piece at s={s:g} is {length:g} m long, and "
                f"the next one begins after {after - s:g} m; it is taken to end there"
            )
    if whole and (end := float(whole[-1][2].get("s", "")) + float(whole[-1][2].get("length", ""))) > NOTHING:
        notes += _as_long_as(road, end)
    return notes


def _as_long_as(road: Xml.Element, end: float) -> list[str]:
    """Take a road for as long as its pieces are together [m], if it says otherwise."""
    try:
        length = float(road.get("length", ""))
    except ValueError:  # what is no number is told where it stands
        return []
    if abs(length - end) <= MISFIT:
        return []
    road.set("length", repr(end))
    return [
        f"road {road.get('writtenId', road.get('id', ''))!r}: it says that it is {length:g} m long, and its pieces end "
        f"after {end:g} m; its pieces count"
    ]


def begin_offsets(road: Xml.Element) -> None:
    """Tell from the start of a road that its lanes are not offset, where they are so only later."""
    lanes = road.find("lanes")
    first = None if lanes is None else lanes.find("laneOffset")
    if lanes is None or first is None:
        return
    try:
        begins = float(first.get("s", ""))
    except ValueError:  # what is no number is told where it stands
        return
    if begins > 0.0:
        none = Xml.Element("laneOffset", {"s": "0.0", "a": "0.0", "b": "0.0", "c": "0.0", "d": "0.0"})
        lanes.insert(list(lanes).index(first), none)
