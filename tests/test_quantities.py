"""Numbers in sentences are found, and narrow the ranges they speak of."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from chatscene.agent.decompose import decompose
from chatscene.errors import NothingFits
from chatscene.snippets.bind import bound, out_of_reach
from chatscene.snippets.library import load_library, names_of
from chatscene.terms.scenario import Measure, Quantity

LIBRARY = load_library()
TRIPLE = (
    LIBRARY.get("behavior/cross-and-stop"),
    LIBRARY.get("geometry/straight-road"),
    LIBRARY.get("spawn/roadside-right"),
)


@pytest.mark.parametrize(
    ("text", "measure", "value"),
    [
        ("A pedestrian about ten metres ahead crosses.", Measure.DISTANCE, 10.0),
        ("The cyclist is 30m in front of us and swerves.", Measure.DISTANCE, 30.0),
        ("An oncoming truck doing 50 mph drifts over the line.", Measure.SPEED, 22.352),
        ("A kid runs across at 10 km/h.", Measure.SPEED, 2.778),
        ("The car ahead stops for three seconds and drives on.", Measure.TIME, 3.0),
        ("The car ahead brakes when we are fifteen metres away.", Measure.TRIGGER, 15.0),
        ("A woman steps out at a distance of 25 meters from the right.", Measure.DISTANCE, 25.0),
        ("A cyclist 60 feet ahead swerves.", Measure.DISTANCE, 18.288),
    ],
)
def test_a_number_with_its_unit_is_a_quantity(text: str, measure: Measure, value: float) -> None:
    found = {q.measure: q.value for q in decompose(text).quantities}
    assert found == {measure: pytest.approx(value)}


@pytest.mark.parametrize("text", ["Two kids run across.", "We drive at 50 km/h; a car ahead brakes.", "V2 brakes."])
def test_other_numbers_are_no_quantity_of_the_adversary(text: str) -> None:
    assert decompose(text).quantities == ()


def said(measure: Measure, value: float) -> Quantity:
    return Quantity(measure=measure, value=value, said="so much")


def test_a_speed_narrows_header_and_code_alike() -> None:
    (behavior, *_), notes = bound(TRIPLE, [said(Measure.SPEED, 2.0)])
    (speed,) = [p for p in behavior.parameters if p.name == "OPT_ADV_SPEED"]
    assert (speed.low, speed.high) == (1.8, 2.2)
    assert names_of(behavior.source, ()).parameters["OPT_ADV_SPEED"] == (1.8, 2.2)
    assert notes == ()


def test_a_speed_nobody_on_foot_can_reach_is_refused() -> None:
    with pytest.raises(NothingFits, match="cannot do 'so much'"):
        bound(TRIPLE, [said(Measure.SPEED, 14.0)])


def test_a_quantity_that_nothing_can_be_set_to_is_told() -> None:
    triple, (note,) = bound(TRIPLE, [said(Measure.TIME, 3.0)])
    assert triple == TRIPLE
    assert "so much" in note


@given(st.floats(0.1, 60.0), st.sampled_from(list(Measure)))
def test_what_is_in_reach_stays_within_the_declared_ranges(value: float, measure: Measure) -> None:
    quantity = said(measure, value)
    if any(out_of_reach(part, [quantity]) for part in TRIPLE):
        with pytest.raises(NothingFits):
            bound(TRIPLE, [quantity])
        return
    triple, _ = bound(TRIPLE, [quantity])
    for before, after in zip(TRIPLE, triple, strict=True):
        for old, new in zip(before.parameters, after.parameters, strict=True):
            assert old.low <= new.low <= new.high <= old.high
