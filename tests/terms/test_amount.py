"""Amounts as people say them."""

import math
import re

import pytest
from hypothesis import given
from hypothesis import strategies as st

from chatscene.terms.amount import Acceleration, Amount, Duration, Length, Speed


@pytest.mark.parametrize(
    ("said", "low", "high"),
    [
        ("50 km/h", 50 / 3.6, 50 / 3.6),
        ("20 to 30 km/h", 20 / 3.6, 30 / 3.6),
        ("20-30 km/h", 20 / 3.6, 30 / 3.6),
        ("at most 30 mph", -math.inf, 30 * 0.44704),
        (">= 10 m/s", 10.0, math.inf),
        ("less than 10 m/s", -math.inf, 10.0),
        ("over 10 m/s", 10.0, math.inf),
        ("5 km/h more than the ego", 5 / 3.6, 5 / 3.6),
        ("5 km/h slower than the ego", -5 / 3.6, -5 / 3.6),
        (12, 12.0, 12.0),
        ("12", 12.0, 12.0),
    ],
)
def test_a_speed_is_read_as_people_write_it(said: object, low: float, high: float) -> None:
    speed = Speed.of(said)
    assert (speed.low, speed.high) == pytest.approx((low, high))
    assert speed.than_ego == ("ego" in str(said))


def test_squares_and_feet_and_miles_and_gravity_have_units() -> None:
    assert (Length.of("2 miles").low, str(Length.of("1 mile"))) == (pytest.approx(3218.688), "1 mile")
    assert Acceleration.of("3 m/s2") == Acceleration.of("3 m/s²") == Acceleration.of(3)
    assert Acceleration.of("0.5 g").low == pytest.approx(4.905)
    assert Length.of("100 ft").low == pytest.approx(30.48)
    assert Duration.of("500 ms").low == pytest.approx(0.5)


@pytest.mark.parametrize(
    ("kind", "said", "told"),
    [
        (Speed, "fast", "'fast' is not a speed; write it as in '50 km/h'"),
        (Speed, "50 kmh/h", "did you mean km/h?"),
        (Speed, "50 m", "'m' is not a unit of a speed"),
        (Length, "20 to 10 m", "the least length is more than the most"),
        (Duration, "at most 2 to 3 s", "has a bound and another number"),
        (Speed, True, "True is not a speed"),
        (Speed, None, "None is not a speed"),
        (Speed, float("nan"), "it is not a number"),
        (Speed, "-5 km/h", "speed is never below 0"),
        (Duration, "2 s more than the ego", "only a speed is measured against the ego's"),
    ],
)
def test_what_is_no_amount_is_refused_with_what_one_looks_like(kind: type[Amount], said: object, told: str) -> None:
    with pytest.raises(ValueError, match=re.escape(told)):
        kind.of(said)


def test_a_number_is_written_in_the_unit_in_which_it_was_said() -> None:
    said = ("50 km/h", "30 mph", "3 m/s", "10 to 20 km/h", "at least 5 km/h", "20 km/h less than the ego")
    assert [str(Speed.of(one)) for one in said] == list(said)


@given(st.sampled_from((Speed, Length, Duration, Acceleration)), st.floats(1e-3, 1e308), st.floats(0, 7e307))
def test_what_is_written_of_an_amount_is_read_as_the_same_to_the_bit(
    kind: type[Amount], low: float, more: float
) -> None:
    relative = (kind(-low, -low, than_ego=True),) if kind.RELATIVE else ()
    for amount in (kind(low, low + more), kind(-math.inf, low), kind(low, math.inf), *relative):
        assert kind.of(str(amount)) == amount
