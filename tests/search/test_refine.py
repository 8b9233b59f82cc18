import math
from collections.abc import Mapping

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from chatscene.program.sample import draw
from chatscene.search.samplers.paper import refine
from chatscene.terms.snippet import ParameterRange

SPEED = ParameterRange(name="OPT_ADV_SPEED", low=0.0, high=5.0, unit="m/s", meaning="How fast it walks.")
GAP = ParameterRange(name="OPT_ADV_DISTANCE", low=0.0, high=15.0, unit="m")

few = settings(max_examples=60)


@st.composite
def declared_and_collided(draw: st.DrawFn) -> tuple[ParameterRange, list[Mapping[str, float]]]:
    """A range with bounds of any number of decimals, and values inside it."""
    low = draw(st.floats(-50, 50))
    declared = ParameterRange(name="OPT_X", low=low, high=low + draw(st.floats(0, 30)), unit="m")
    values = draw(st.lists(st.floats(declared.low, declared.high), max_size=12))
    return declared, [{"OPT_X": value} for value in values]


def test_a_range_moves_to_mean_and_population_deviation_rounded_to_two_places() -> None:
    collided = [{"OPT_ADV_SPEED": 1.0}, {"OPT_ADV_SPEED": 2.0}, {"OPT_ADV_SPEED": 4.0}]
    (moved,) = refine([SPEED], collided)
    # mean 7/3, deviation sqrt(14/9) = 1.2472; of a sample it would be 1.5275.
    assert (moved.low, moved.high) == (1.09, 3.58)


def test_a_range_is_clipped_to_the_declared_one() -> None:
    (moved,) = refine([SPEED], [{"OPT_ADV_SPEED": 0.5}, {"OPT_ADV_SPEED": 4.9}, {"OPT_ADV_SPEED": 5.0}])
    # mean 3.4667, deviation 2.0982
    assert (moved.low, moved.high) == (1.37, 5.0)


def test_only_the_bounds_of_a_parameter_change() -> None:
    (moved,) = refine([SPEED], [{"OPT_ADV_SPEED": 1.0}, {"OPT_ADV_SPEED": 3.0}])
    assert (moved.name, moved.unit, moved.meaning) == (SPEED.name, SPEED.unit, SPEED.meaning)
    assert (moved.low, moved.high) == (1.0, 3.0)


@pytest.mark.parametrize("collided", [[], [{"OPT_ADV_SPEED": 1.0, "OPT_ADV_DISTANCE": 3.0}]])
def test_fewer_than_two_collisions_leave_the_declared_ranges(collided: list[dict[str, float]]) -> None:
    assert refine([SPEED, GAP], collided) == (SPEED, GAP)


def test_a_program_without_parameters_has_nothing_to_refine() -> None:
    assert refine([], [{}, {}]) == ()


def test_parameters_move_independently_of_each_other() -> None:
    speeds = [{"OPT_ADV_SPEED": value, "OPT_ADV_DISTANCE": 7.0} for value in (1.0, 2.0, 3.0)]
    speed, gap = refine([SPEED, GAP], speeds)
    assert speed == refine([SPEED], speeds)[0]
    assert (gap.low, gap.high) == (7.0, 7.0)


def test_rounding_never_steps_over_a_declared_bound() -> None:
    declared = ParameterRange(name="OPT_X", low=0.126, high=0.134, unit="rad")
    (moved,) = refine([declared], [{"OPT_X": 0.126}, {"OPT_X": 0.134}])
    assert (moved.low, moved.high) == (0.13, 0.13)
    wider = ParameterRange(name="OPT_X", low=0.122, high=0.138, unit="rad")
    (moved,) = refine([wider], [{"OPT_X": 0.122}, {"OPT_X": 0.138}])
    assert (moved.low, moved.high) == (0.122, 0.138)  # rounded alone: 0.12 and 0.14


@few
@given(declared_and_collided())
def test_a_refined_range_never_leaves_the_declared_one(
    case: tuple[ParameterRange, list[Mapping[str, float]]],
) -> None:
    declared, collided = case
    (moved,) = refine([declared], collided)
    assert declared.low <= moved.low <= moved.high <= declared.high


@few
@given(declared_and_collided())
def test_a_refined_range_holds_the_mean_of_what_collided_but_for_rounding(
    case: tuple[ParameterRange, list[Mapping[str, float]]],
) -> None:
    declared, collided = case
    if len(collided) < 2:
        return
    (moved,) = refine([declared], collided)
    values = np.array([each["OPT_X"] for each in collided])
    assert moved.low - 0.006 <= values.mean() <= moved.high + 0.006
    assert moved.high - moved.low <= 2 * values.std() + 0.011


@few
@given(declared_and_collided())
def test_the_order_of_collisions_does_not_matter(
    case: tuple[ParameterRange, list[Mapping[str, float]]],
) -> None:
    declared, collided = case
    assert refine([declared], collided) == refine([declared], collided[::-1])


def test_five_blocks_of_a_dangerous_corner_close_in_on_it() -> None:
    """A scene collides below 1.5 m/s; the range ends around that corner and never leaves what was declared."""
    collided: list[Mapping[str, float]] = []
    widths: list[float] = []
    for block in range(5):
        ranges = refine([SPEED], collided)
        widths.append(ranges[0].high - ranges[0].low)
        scenes = [draw(ranges, seed=10 * block + index) for index in range(10)]
        collided += [values for values in scenes if values["OPT_ADV_SPEED"] < 1.5]
    assert widths[0] == 5.0
    assert math.isfinite(widths[-1])
    assert widths[-1] < 1.5
