"""Two bodies on two lines: whether they touch, where, and who runs into whom, by how much sooner one of them is."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from chatscene.terms.polyline import Polyline
from chatscene.terms.vocabulary import NOSE

_AROUND = 6.0  # [s] before and after the ego is where the ways meet
_STEP = 0.05  # [s]
_NEAR = 0.75  # [m] before and behind a place, between which a line bends there
_PARTS = 25  # into which the step of a first touch is cut

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, kw_only=True)
class Moving:
    """Somebody on a line.

    Attributes:
        line: Its way.
        meets_at: How far along it [m] it meets the other.
        speed: How fast it then is [m/s].
        length: [m].
        width: [m].
        ends_at: How far along it [m] it comes at most.
        wheelbase: [m]; in a bend a body on wheels, whose middle is on the line, looks so much out of it as that asks.
    """

    line: Polyline
    meets_at: float
    speed: float
    length: float
    width: float
    ends_at: float = np.inf
    wheelbase: float = 0.0

    def poses(self, seconds: Array) -> tuple[Array, Array, Array]:
        """Where it is [m] and which way it faces [rad], so many seconds after it is where the ways meet."""
        along = np.minimum(self.meets_at + self.speed * seconds, self.ends_at)
        x, y, s, hx, hy = (np.asarray(one, np.float64) for one in self.line.columns)
        at = np.clip(np.searchsorted(s, along, side="right") - 1, 0, len(hx) - 1)
        on = along - s[at]
        headings: Array = np.arctan2(hy[at], hx[at])
        if self.wheelbase:
            headings = headings - np.arctan(0.5 * self.wheelbase * self._bend(along))
        return x[at] + on * hx[at], y[at] + on * hy[at], headings

    def _bend(self, along: Array) -> Array:
        """How much its line bends to the left [1/m], so far along it [m]."""
        _, _, s, hx, hy = (np.asarray(one, np.float64) for one in self.line.columns)
        turned: Array = np.interp([along - _NEAR, along + _NEAR], s[: len(hx)], np.unwrap(np.arctan2(hy, hx)))
        return (turned[1] - turned[0]) / (2 * _NEAR)


@dataclass(frozen=True, slots=True)
class Touch:
    """How two first touch.

    Attributes:
        ego: Which side of the ego: ``front``, ``rear``, ``left`` or ``right``.
        ego_along: How far ahead of its middle [share of half its length].
        other: Which side of the other.
        other_along: How far ahead of its middle.
        by_ego: Whether the ego runs into the other.
        across: How far to the left of the ego's line the middle of the other then is [m].
        turned: Which way the other faces, seen from the ego [rad].
        left: Whether the ego's middle is on the left of the other.
    """

    ego: str
    ego_along: float
    other: str
    other_along: float
    by_ego: bool
    across: float = 0.0
    turned: float = 0.0
    left: bool = False


@dataclass(frozen=True, slots=True, eq=False)
class _Lying:
    """How two bodies lie to each other; arrays of one shape [m].

    Attributes:
        along: How far ahead of the ego's middle the other's is.
        across: How far to its left.
        own_along: How far ahead of the other's middle the ego's is.
        own_across: How far to its left.
        turned: Which way the other faces, seen from the ego [rad].
        deep: How far they overlap along and across the ego, and along and across the other.
    """

    along: Array
    across: Array
    own_along: Array
    own_across: Array
    turned: Array
    deep: tuple[Array, Array, Array, Array]

    @property
    def touching(self) -> NDArray[np.bool_]:
        """Whether they touch."""
        return np.asarray(np.minimum.reduce(self.deep) >= 0.0)


def _lying(ego: Moving, other: Moving, seconds: Array, sooner: Array) -> _Lying:
    """At moments (N or 1, T) [s], the other being where the ways meet by so many seconds (N) sooner."""
    ex, ey, eh = ego.poses(seconds)
    ox, oy, oh = other.poses(seconds + sooner[:, None])
    dx, dy, turned = ox - ex, oy - ey, oh - eh
    c, s = np.abs(np.cos(turned)), np.abs(np.sin(turned))
    along, across = dx * np.cos(eh) + dy * np.sin(eh), dy * np.cos(eh) - dx * np.sin(eh)
    own_along, own_across = -(dx * np.cos(oh) + dy * np.sin(oh)), -(dy * np.cos(oh) - dx * np.sin(oh))
    deep = (
        0.5 * (ego.length + other.length * c + other.width * s) - np.abs(along),
        0.5 * (ego.width + other.length * s + other.width * c) - np.abs(across),
        0.5 * (other.length + ego.length * c + ego.width * s) - np.abs(own_along),
        0.5 * (other.width + ego.length * s + ego.width * c) - np.abs(own_across),
    )
    return _Lying(along, across, own_along, own_across, turned, deep)


def touches(ego: Moving, other: Moving, sooner: Array) -> list[Touch | None]:
    """How they first touch, for each of so many seconds by which the other is sooner where the ways meet."""
    seconds = np.arange(-_AROUND, _AROUND, _STEP)
    inside = _lying(ego, other, seconds[None, :], sooner).touching
    begins = seconds[inside.argmax(axis=1)]
    lying = _lying(ego, other, begins[:, None] + np.linspace(-_STEP, 0.0, _PARTS + 1), sooner)
    along, across, own_along, own_across, deep = (
        lying.along,
        lying.across,
        lying.own_along,
        lying.own_across,
        lying.deep,
    )
    inside = lying.touching & inside.any(axis=1)[:, None]
    found: list[Touch | None] = []
    for row, first in zip(range(len(sooner)), inside.argmax(axis=1).tolist(), strict=True):
        if not inside[row, first]:
            found.append(None)
            continue
        e, o = (along[row, first], across[row, first]), (own_along[row, first], own_across[row, first])
        deeper = [bool(deep[k][row, first] < deep[k + 1][row, first]) for k in (0, 2)]
        sides = _side(deeper[0], *e), _side(deeper[1], *o)
        noses = sides[0] == "front", o[0] > 0.5 * other.length - NOSE or sides[1] == "front"
        going = ego.speed * np.cos(np.arctan2(e[1], e[0])), other.speed * np.cos(np.arctan2(o[1], o[0]))
        by_ego = noses[0] if noses[0] != noses[1] else bool(going[0] >= going[1])
        shares = _share(e[0], ego.length), _share(o[0], other.length)
        turned = float(lying.turned[row, first])
        found.append(Touch(sides[0], shares[0], sides[1], shares[1], by_ego, float(e[1]), turned, bool(o[1] > 0.0)))
    return found


def _side(lengthwise: bool, along: float, across: float) -> str:
    if lengthwise:
        return "front" if along > 0.0 else "rear"
    return "left" if across > 0.0 else "right"


def _share(along: float, length: float) -> float:
    return float(np.clip(along / (0.5 * length), -1.0, 1.0))
