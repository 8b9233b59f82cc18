"""Curves of OpenDRIVE that Scenic's parser leaves out: cubic ones whose parameter is the arc length.

With ``pRange="arcLength"`` the parameter of a <paramPoly3> runs from 0 to the length of its geometry, with
``normalized``, which the parser reads, from 0 to 1: the same curve, its coefficients times powers of the length.
"""

from __future__ import annotations

import xml.etree.ElementTree as Xml
from typing import Any


def normalised(tree: Xml.ElementTree[Any]) -> Xml.ElementTree[Any]:
    """A map in which the parameter of every cubic curve runs from 0 to 1; the tree itself is changed."""
    for geometry in tree.iter("geometry"):
        length = float(geometry.get("length", 0))
        for curve in geometry.findall("paramPoly3"):
            if curve.get("pRange") == "arcLength":
                for power, letter in enumerate("abcd"):
                    for axis in "UV":
                        name = f"{letter}{axis}"
                        curve.set(name, repr(float(curve.get(name, 0)) * length**power))
                curve.set("pRange", "normalized")
    return tree


class _Etree:
    """The parser of XML as Scenic's parser of maps asks it."""

    @staticmethod
    def parse(path: Any) -> Xml.ElementTree[Any]:
        """The tree of a file."""
        return normalised(Xml.parse(path))


def read_all_curves() -> None:
    """Have Scenic's parser of maps read these curves too."""
    from scenic.formats.opendrive import xodr_parser

    if xodr_parser.ET is _Etree:
        return
    setattr(xodr_parser, "ET", _Etree)  # noqa: B010 - a module of somebody else's
    ends = xodr_parser.ParamCubic.point_at

    def point_at(self: Any, s: float) -> Any:
        """The point at an arc length; the last one for what lies a little beyond it."""
        whole = getattr(self, "_whole", None)
        if whole is None:
            whole = self._whole = self.arclength(self.p_range)
        return ends(self, min(s, whole * (1.0 - 1e-9)))

    xodr_parser.ParamCubic.point_at = point_at
