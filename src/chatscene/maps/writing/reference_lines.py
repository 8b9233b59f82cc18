"""Reference lines of roads: poses, and the lines and arcs that lead from one to another."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

Corner = tuple[float, float, float]  # x, y, radius [m]: where two straight parts would meet, and how they are rounded


@dataclass(frozen=True, slots=True)
class Pose:
    """A point [m] and a direction [rad, 0 = +x, counter-clockwise]."""

    x: float
    y: float
    heading: float

    def moved(self, ahead: float, left: float) -> Pose:
        """The pose so far [m] ahead and to the left, with the same direction."""
        c, s = math.cos(self.heading), math.sin(self.heading)
        return Pose(self.x + ahead * c - left * s, self.y + ahead * s + left * c, self.heading)

    def turned(self, angle: float) -> Pose:
        """The pose turned left by an angle [rad]."""
        return Pose(self.x, self.y, self.heading + angle)

    def left_of(self, x: float, y: float) -> float:
        """How far [m] the pose lies to the left of a point, seen in its own direction."""
        return (self.y - y) * math.cos(self.heading) - (self.x - x) * math.sin(self.heading)


@dataclass(frozen=True, slots=True)
class Piece:
    """A line (curvature 0) or an arc of a reference line.

    Attributes:
        length: [m].
        curvature: [1/m], positive to the left.
    """

    length: float
    curvature: float


def rounded_line(
    a: tuple[float, float], b: tuple[float, float], via: Sequence[Corner], spared: tuple[float, float]
) -> tuple[Pose, list[Piece]]:
    """From one point to another by straight lines with rounded corners.

    Args:
        a: Where it comes from [m].
        b: Where it leads to [m].
        via: Its corners.
        spared: How much [m] is left out at its start and at its end.

    Returns:
        The pose at its start, and its pieces.
    """
    points = [a, *((x, y) for x, y, _ in via), b]
    headings = [math.atan2(q[1] - p[1], q[0] - p[0]) for p, q in pairwise(points)]
    turns = [wrapped(second - first) for first, second in pairwise(headings)]
    tangents = [radius * math.tan(abs(turn) / 2) for (_, _, radius), turn in zip(via, turns, strict=True)]
    pieces: list[Piece] = []
    for i in range(len(headings)):
        before = tangents[i - 1] if i else spared[0]
        after = tangents[i] if i < len(tangents) else spared[1]
        pieces.append(Piece(math.dist(points[i], points[i + 1]) - before - after, 0.0))
        if i < len(turns):
            radius = via[i][2]
            pieces.append(Piece(radius * abs(turns[i]), math.copysign(1 / radius, turns[i])))
    if (shortest := min(piece.length for piece in pieces)) < -1e-6:
        raise ValueError(f"the corners {via} between {a} and {b} overlap by {-shortest} m; round them less")
    return Pose(*a, headings[0]).moved(spared[0], 0.0), [piece for piece in pieces if piece.length > 1e-6]


def line_arc_line(start: Pose, goal: Pose) -> list[Piece]:
    """A line, an arc and a line that lead from one pose to another."""
    turn = wrapped(goal.heading - start.heading)
    dx, dy = goal.x - start.x, goal.y - start.y
    if abs(turn) < 1e-6:
        return [Piece(math.hypot(dx, dy), 0.0)]
    # Both tangents meet `first` ahead of the start and `second` before the goal.
    second = (dy * math.cos(start.heading) - dx * math.sin(start.heading)) / math.sin(turn)
    first = dx * math.cos(start.heading) + dy * math.sin(start.heading) - second * math.cos(turn)
    tangent = min(first, second)
    radius = tangent / math.tan(abs(turn) / 2)
    pieces = [
        Piece(first - tangent, 0.0),
        Piece(radius * abs(turn), math.copysign(1 / radius, turn)),
        Piece(second - tangent, 0.0),
    ]
    return [piece for piece in pieces if piece.length > 1e-6]


def after(pose: Pose, piece: Piece) -> Pose:
    """Where a piece that starts at a pose ends."""
    if not piece.curvature:
        return pose.moved(piece.length, 0.0)
    radius, angle = 1 / piece.curvature, piece.length * piece.curvature
    moved = pose.moved(radius * math.sin(angle), radius * (1 - math.cos(angle)))
    return moved.turned(angle)


def end_of(start: Pose, pieces: Sequence[Piece]) -> Pose:
    """Where a reference line ends."""
    for piece in pieces:
        start = after(start, piece)
    return start


def wrapped(angle: float) -> float:
    """An angle [rad] between -pi and pi."""
    return (angle + math.pi) % (2 * math.pi) - math.pi
