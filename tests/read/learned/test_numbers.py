"""Amounts are found wherever they stand in a text."""

from __future__ import annotations

import pytest

from chatscene.read.learned.numbers import amounts_in, same
from chatscene.terms.amount import Acceleration, Amount, Duration, Length, Share, Speed


@pytest.mark.parametrize(
    ("text", "amount"),
    [
        ("we drive at 50 km/h", Speed.of("50 km/h")),
        ("VUT 50km/h, dry", Speed.of("50 km/h")),
        ("at thirty miles an hour", Speed.of("30 mph")),
        ("between 30 and 40 mph", Speed.of("30 to 40 mph")),
        ("10-20 m ahead", Length.of("10 to 20 m")),
        ("a gap of at most 12.5 metres", Length.of("at most 12.5 m")),
        ("no more than 3 seconds later", Duration.of("at most 3 s")),
        ("30 km/h or more", Speed.of("at least 30 km/h")),
        ("20 km/h faster than us", Speed.of("20 km/h more than the ego")),
        ("10 km/h slower than the VUT", Speed.of("10 km/h less than the ego")),
        ("brakes with 4 m/s² to 50 km/h", Acceleration.of("4 m/s²")),
        ("brakes with 4 m/s² to 50 km/h", Speed.of("50 km/h")),
        ("brakes at 0.5 g", Acceleration.of("0.5 g")),
        ("time gap 1,5 s", Duration.of("1.5 s")),
        ("50 % overlap", Share.of("50 %")),
        ("two car lengths behind", Length.of("2 car lengths")),
        ("1,200 m on", Length.of("1200 m")),
        ("doing 85 on the slip road", Speed.of("85 km/h")),
        ("we were doing forty", Speed.of("40 mph")),
        ("at walking pace", Speed(1.4, 1.4)),
        ("f\u0131ve metre\u017f", Length.of("5 m")),
        ("60 M\u0130LES PER HOUR", Speed.of("60 mph")),
        ("at mo\u017ft 12 m", Length.of("at most 12 m")),
    ],
)
def test_an_amount_is_found(text: str, amount: Amount) -> None:
    assert any(same(one.amount, amount) for one in amounts_in(text))


def test_the_words_of_an_amount_are_told() -> None:
    text = "the van, 20 m ahead, brakes"
    (one,) = amounts_in(text)
    assert text[one.low : one.high] == "20 m"


@pytest.mark.parametrize("text", ["", "a car ahead brakes", "the A9 near km"])
def test_where_there_is_no_amount_none_is_found(text: str) -> None:
    assert not amounts_in(text)


def test_a_bound_is_the_same_as_no_other_amount() -> None:
    bound = Length.of("at most 12 m")
    assert same(bound, Length.of("at most 12.1 m"))
    assert not any(same(bound, Length.of(other)) for other in ("12 m", "at least 12 m", "5 to 12 m", "at most 20 m"))


def test_a_range_that_goes_down_is_none() -> None:
    assert not any(one.amount == Length.of("5 to 10 m") for one in amounts_in("10 to 5 m"))


@pytest.mark.parametrize(
    ("text", "amount"),
    [
        ("A truck ahead is 20 km/h slower.", "20 km/h less than the ego"),
        ("A car cuts in 10 to 15 km/h faster and brakes.", "10 to 15 km/h more than the ego"),
        ("It drives 10 mph below our speed.", "10 mph less than the ego"),
        ("It enters 20 km/h below ego, then brakes.", "20 km/h less than the ego"),
    ],
)
def test_a_speed_that_is_so_much_faster_or_slower_is_never_a_speed_by_itself(text: str, amount: str) -> None:
    (one,) = amounts_in(text)
    assert same(one.amount, Speed.of(amount))


def test_a_speed_that_is_so_much_faster_than_another_is_no_amount_of_ours() -> None:
    assert not amounts_in("We are 20 km/h faster than the truck.")


def test_what_an_edit_makes_faster_is_so_than_it_was() -> None:
    text = "A car is ahead. Change: 10 km/h faster"
    assert [str(one.amount) for one in amounts_in(text, text.index("Change"))] == ["10 km/h"]
