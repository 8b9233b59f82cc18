"""Who hides whom: lines of sight from a driver's eye over and past the boxes that stand between.

A box is as high as its kind (`chatscene.terms.actors.RoadUser.height`) and lets nothing through. So a parked car hides
a child and a dog, and not an adult's head close behind it; a van hides all of them from a car, and little from a bus.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Protocol

EYE = 0.75
"""Of its height, at which a driver's eye is: 1.1 m of a car and 2.3 m of a lorry (AASHTO, *A Policy on Geometric Design
of Highways and Streets*, 2018, section 3.2.6.1: 1.08 and 2.33 m)."""
BEHIND_NOSE = 2.2
"""[m] behind the front of a vehicle at which its driver sits, if that is not behind its middle."""


class Box(Protocol):
    """A box with a pose: its centre [m], the cosine and sine of its heading, and half of its sides [m]."""

    x: float
    y: float
    cos: float
    sin: float
    half_length: float
    half_width: float


def eye_of(box: Box, height: float) -> tuple[float, float, float]:
    """Where the eye of a driver is: x, y and height [m].

    Args:
        box: What it drives.
        height: Of that [m].
    """
    ahead = box.half_length - BEHIND_NOSE
    ahead = ahead if ahead > 0.0 else 0.0
    return box.x + ahead * box.cos, box.y + ahead * box.sin, EYE * height


def is_hidden(eye: tuple[float, float, float], of: Box, height: float, between: Iterable[tuple[Box, float]]) -> bool:
    """Whether none of five points of a box is seen: its middle and its corners, at its full height.

    Args:
        eye: x, y and height [m].
        of: The box that is looked at.
        height: Of it [m].
        between: All other boxes but that of whose eye it is, and their heights [m].
    """
    boxes = tuple(between)
    if not boxes:
        return False
    along = of.half_length * of.cos, of.half_length * of.sin
    aside = -of.half_width * of.sin, of.half_width * of.cos
    points = [(of.x, of.y)]
    for a, b in ((1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)):
        points.append((of.x + (a * along[0] + b * aside[0]), of.y + (a * along[1] + b * aside[1])))
    return all(any(_stops(box, high, eye, (x, y, height)) for box, high in boxes) for x, y in points)


def _stops(box: Box, height: float, eye: tuple[float, float, float], point: tuple[float, float, float]) -> bool:
    """Whether the line from an eye to a point goes through a box: the part of it within, slab by slab."""
    dx, dy = eye[0] - box.x, eye[1] - box.y
    ax, ay = dx * box.cos + dy * box.sin, dy * box.cos - dx * box.sin
    dx, dy = point[0] - eye[0], point[1] - eye[1]
    enter, leave = 0.0, 1.0
    for at, way, half in (
        (ax, dx * box.cos + dy * box.sin, box.half_length),
        (ay, dy * box.cos - dx * box.sin, box.half_width),
    ):
        if way == 0.0:
            if at <= -half or at >= half:
                return False
            continue
        first, second = (-half - at) / way, (half - at) / way
        near, far = (first, second) if first < second else (second, first)
        enter = near if near > enter else enter
        leave = far if far < leave else leave
    if not enter < leave:
        return False
    rise = point[2] - eye[2]
    lowest = eye[2] + rise * (leave if rise < 0.0 else enter)
    return lowest < height
