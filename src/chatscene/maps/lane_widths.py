"""Lanes told by their outer borders, told by their widths instead.

A <border> tells how far [m] a lane's outer edge lies from the reference line; a lane's width is what lies between its
own border and that of the next lane inwards. Both are cubics of the distance from the start of their section.
Source: ASAM OpenDRIVE 1.8.1, sections 11.7.1 (width) and 11.7.2 (border).
"""

from __future__ import annotations

import math
from xml.etree import ElementTree as Xml

Cubic = tuple[float, float, float, float]
Steps = list[tuple[float, Cubic]]  # from which distance [m] on, which cubic of the distance from there


def told_by_widths(road: Xml.Element) -> None:
    """Give each lane of a road that is told by its border a width; those without numbers stay as they are."""
    for section in road.iterfind("lanes/laneSection"):
        for side in ("left", "right"):
            lanes = section.findall(f"{side}/lane")
            if any(lane.find("border") is not None and lane.find("width") is None for lane in lanes):
                _side(lanes)


def _side(lanes: list[Xml.Element]) -> None:
    try:
        outwards = sorted(lanes, key=lambda lane: abs(int(lane.get("id", ""))))
        inner: Steps = [(0.0, (0.0, 0.0, 0.0, 0.0))]
        for lane in outwards:
            if lane.find("width") is not None:
                inner = _combined(inner, _steps(lane, "width"), 1.0)
                continue
            borders = _steps(lane, "border")
            sign = _side_of(borders)  # to the right, some count distances, others negative ones
            outer = [(s, _scaled(cubic, sign)) for s, cubic in borders]
            widths = _combined(outer, inner, -1.0)
            for border in lane.findall("border"):
                lane.remove(border)
            for s, cubic in widths:
                numbers = {name: repr(value) for name, value in zip("abcd", cubic, strict=True)}
                Xml.SubElement(lane, "width", {"sOffset": repr(s), **numbers})
            inner = outer
    except ValueError:  # what is no number is told where it stands
        return


def _side_of(borders: Steps) -> float:
    """The sign of a border where it is farthest from the reference line: a lane may begin or end with no width."""
    ends = [*(s for s, _ in borders[1:]), borders[-1][0] + 1.0]
    places = [cubic_from([(s, cubic)], at)[0] for (s, cubic), end in zip(borders, ends, strict=True) for at in (s, end)]
    return math.copysign(1.0, max(places, key=abs))


def _steps(lane: Xml.Element, tag: str) -> Steps:
    found = [
        (float(one.get("sOffset", "")), tuple(float(one.get(name, "")) for name in "abcd")) for one in lane.iter(tag)
    ]
    if not found:
        raise ValueError(tag)
    return [(s, (a, b, c, d)) for s, (a, b, c, d) in sorted(found)]


def _combined(one: Steps, other: Steps, times: float) -> Steps:
    """One plus so many times another."""
    cuts = sorted({s for s, _ in (*one, *other)})
    return [(s, _sum(cubic_from(one, s), _scaled(cubic_from(other, s), times))) for s in cuts]


def cubic_from(steps: Steps, s: float) -> Cubic:
    """The cubic that holds at a distance, as one of the distance from there."""
    start, (a, b, c, d) = next((step for step in reversed(steps) if step[0] <= s), steps[0])
    x = s - start
    return a + b * x + c * x**2 + d * x**3, b + 2 * c * x + 3 * d * x**2, c + 3 * d * x, d


def _sum(one: Cubic, other: Cubic) -> Cubic:
    return one[0] + other[0], one[1] + other[1], one[2] + other[2], one[3] + other[3]


def _scaled(cubic: Cubic, times: float) -> Cubic:
    a, b, c, d = cubic
    return a * times, b * times, c * times, d * times
