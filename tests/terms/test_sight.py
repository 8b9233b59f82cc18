"""Who hides whom: lines of sight over and past boxes, in toy worlds with known answers."""

from __future__ import annotations

import math
from dataclasses import dataclass

import pytest
from hypothesis import given
from hypothesis import strategies as st

from chatscene.terms.actors import BY_CLASS
from chatscene.terms.sight import eye_of, is_hidden


@dataclass
class Box:
    x: float
    y: float
    length: float
    width: float
    heading: float = 0.0

    def __post_init__(self) -> None:
        self.half_length, self.half_width = self.length / 2, self.width / 2
        self.cos, self.sin = math.cos(self.heading), math.sin(self.heading)


def high(kind: str) -> float:
    return BY_CLASS[kind].row.height


def one(kind: str, x: float, y: float = 0.0) -> Box:
    limits = BY_CLASS[kind].row.limits
    return Box(x, y, limits.length, limits.width)


def hidden(kind: str, x: float, y: float, *between: tuple[str, float, float], ego: str = "Car") -> bool:
    eye = eye_of(one(ego, 0.0), high(ego))
    return is_hidden(eye, one(kind, x, y), high(kind), [(one(k, a, b), high(k)) for k, a, b in between])


def test_nobody_is_hidden_where_nothing_stands_between() -> None:
    assert not hidden("Car", 30.0, 0.0)
    assert not hidden("Car", 30.0, 0.0, ("Van", 10.0, 6.0), ("Van", 40.0, 0.0))


def test_a_lorry_ahead_hides_the_car_that_stands_before_it_until_it_leaves_the_lane() -> None:
    assert hidden("Car", 50.0, 0.0, ("Truck", 20.0, 0.0))
    assert not hidden("Car", 50.0, 0.0, ("Truck", 20.0, 3.5))


def test_a_parked_car_hides_a_child_and_not_the_head_of_an_adult_close_behind_it() -> None:
    assert hidden("Child", 22.0, -2.5, ("Car", 18.0, -2.3))
    assert not hidden("Pedestrian", 22.0, -2.5, ("Car", 18.0, -2.3))
    assert hidden("Pedestrian", 22.0, -2.5, ("Van", 18.0, -2.3))


def test_who_sits_high_sees_over_a_car() -> None:
    assert hidden("Child", 22.0, 0.0, ("Car", 12.0, 0.0))
    assert not hidden("Child", 22.0, 0.0, ("Car", 12.0, 0.0), ego="Bus")


def test_who_looks_out_on_one_side_is_seen() -> None:
    assert not hidden("Car", 50.0, 2.5, ("Van", 20.0, 0.0))


def test_two_that_each_hide_a_part_hide_the_whole() -> None:
    sides = (("Van", 20.0, 1.1), ("Van", 20.0, -0.7))
    assert hidden("Car", 50.0, 0.0, *sides)
    assert not any(hidden("Car", 50.0, 0.0, side) for side in sides)


@given(
    angle=st.floats(-math.pi, math.pi),
    x=st.floats(8.0, 60.0),
    y=st.floats(-8.0, 8.0),
    bx=st.floats(6.0, 60.0),
    by=st.floats(-8.0, 8.0),
)
def test_it_does_not_matter_which_way_the_world_is_turned(
    angle: float, x: float, y: float, bx: float, by: float
) -> None:
    def turned(box: Box) -> Box:
        c, s = math.cos(angle), math.sin(angle)
        return Box(c * box.x - s * box.y, s * box.x + c * box.y, box.length, box.width, box.heading + angle)

    def is_it(ego: Box, of: Box, between: Box, grown: float) -> bool:
        wide = Box(between.x, between.y, between.length + grown, between.width + grown, between.heading)
        return is_hidden(eye_of(ego, 1.5), of, 1.3, [(wide, 2.5)])

    boxes = one("Car", 0.0), one("Child", x, y), one("Van", bx, by)
    surely, perhaps = is_it(*boxes, -1e-6), is_it(*boxes, 1e-6)
    if surely == perhaps:  # else it is a matter of rounding
        ego, of, between = map(turned, boxes)
        assert is_it(ego, of, between, 0.0) == surely


@pytest.mark.parametrize("kind", sorted(BY_CLASS))
def test_nobody_hides_himself(kind: str) -> None:
    assert not hidden(kind, 30.0, 1.0)
