"""Curves of OpenDRIVE that Scenic's parser leaves out, told as those that it reads: cubics from 0 to 1.

With ``pRange="arcLength"`` the parameter of a <paramPoly3> runs from 0 to the length of its geometry, with
``normalized``, which the parser reads, from 0 to 1: the same curve, its coefficients times powers of the length. A
<poly3>, of OpenDRIVE 1.4, is a cubic of the distance along the direction at its start, to where it is as long as its
geometry.
"""

from __future__ import annotations

import math
import xml.etree.ElementTree as Xml
from itertools import pairwise

_STEPS = 64  # of the arc length of a <poly3>, each by Gauss's rule of three points
_GAUSS = ((-math.sqrt(0.6), 5 / 9), (0.0, 8 / 9), (math.sqrt(0.6), 5 / 9))


def normalise(geometry: Xml.Element) -> None:
    """Tell the cubic curve of a piece of a reference line, if it is one, by a parameter from 0 to 1."""
    try:
        length = float(geometry.get("length", ""))
        for curve in geometry.findall("poly3"):
            _parametric(curve, length)
        for curve in geometry.findall("paramPoly3"):
            if curve.get("pRange") == "arcLength":
                for power, letter in enumerate("abcd"):
                    for axis in "UV":
                        name = f"{letter}{axis}"
                        curve.set(name, repr(float(curve.get(name, 0)) * length**power))
                curve.set("pRange", "normalized")
    except ValueError:  # what is no number is told where it stands
        return


def _parametric(curve: Xml.Element, length: float) -> None:
    a, b, c, d = (float(curve.get(name, "")) for name in "abcd")
    reach = _reach(b, c, d, length)
    curve.attrib.clear()
    curve.tag = "paramPoly3"
    across = (a, b * reach, c * reach**2, d * reach**3)
    for letter, along, aside in zip("abcd", (0.0, reach, 0.0, 0.0), across, strict=True):
        curve.set(f"{letter}U", repr(along))
        curve.set(f"{letter}V", repr(aside))
    curve.set("pRange", "normalized")


def _reach(b: float, c: float, d: float, length: float) -> float:
    """How far [m] along its first direction a cubic leads until it is so long; at most its length."""

    def long(u: float) -> float:
        ends = [u * i / _STEPS for i in range(_STEPS + 1)]
        return sum(
            weight * (end - start) / 2 * math.hypot(1.0, b + 2 * c * x + 3 * d * x * x)
            for start, end in pairwise(ends)
            for at, weight in _GAUSS
            for x in [(start + end) / 2 + at * (end - start) / 2]
        )

    low, high = 0.0, length
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if long(middle) < length else (low, middle)
    return (low + high) / 2
