"""Rows of who stands: as long as was said, round who stands in one, and once."""

from __future__ import annotations

import re
from typing import Any

import pytest

from chatscene.build.build import Built, build
from chatscene.errors import NotBuilt
from chatscene.situations.form import from_plain
from chatscene.situations.words import told

STANDS = [{"act": "stand"}]


def parked(**other: Any) -> dict[str, Any]:
    return {
        "id": "B",
        "kind": "car",
        "role": "supporting",
        "starts": {"where": "kerb", "side": "right"},
        "does": STANDS,
    } | other


def made(*others: dict[str, Any], has: tuple[str, ...] = ("parked-cars",), **more: Any) -> Built:
    return build(from_plain({"road": {"has": list(has)}, "others": list(others), **more}))


def labels(built: Built) -> list[str]:
    return re.findall(r"with label '([^']+)'", built.program.source)


ONCOMING = {"id": "A", "kind": "van", "starts": {"where": "oncoming"}, "does": [{"act": "go-along"}]}


@pytest.mark.parametrize(("stretch", "many"), [("55 m", 8), ("20 m", 3), ("at least 100 m", 14)])
def test_as_many_are_parked_as_stand_in_the_length_that_was_said(stretch: str, many: int) -> None:
    one = made(ONCOMING, parked(count=0, stretch=stretch))
    assert labels(one).count("B") == many
    assert f"there are {many} of B, as many as stand in {stretch}" in one.assumed
    assert not one.left_out


def test_a_queue_has_a_length_too() -> None:
    one = build(from_plain({"others": [parked(count=0, stretch="100 m", starts={"where": "ahead"}, role="adversary")]}))
    assert labels(one).count("B") == 13


@pytest.mark.parametrize(
    ("other", "why"),
    [
        ({"count": 3, "stretch": "100 m"}, "3 of B make a row of 20 to 27 m"),
        ({"count": 0, "stretch": "1 km"}, "1000 m is more than a row of 20: 146 m"),
        (
            {"count": 0, "stretch": "50 m", "starts": {"where": "ahead"}, "does": [{"act": "brake"}]},
            "only a row of those",
        ),
    ],
)
def test_what_makes_no_row_of_that_length_is_refused(other: dict[str, Any], why: str) -> None:
    with pytest.raises(NotBuilt, match=why):
        made(ONCOMING, parked(**other))


def test_two_parked_cars_are_the_row_and_no_other_is_built() -> None:
    child = {"id": "A", "kind": "child", "hidden_by": "B", "starts": {"where": "roadside", "side": "right"}}
    one = made(child | {"does": [{"act": "cross"}]}, parked(count=2, role="hides"))
    assert sorted(labels(one)) == ["A", "B", "B"]


def test_who_opens_a_door_stands_within_the_row() -> None:
    van = parked(id="A", kind="van", role="adversary", does=[*STANDS, {"act": "open-door"}])
    source = made(van).program.source
    assert len(re.findall(r"OPT_A_Y - [\d.]+, \"right\"", source)) == 4
    assert len(re.findall(r"OPT_A_Y \+ [\d.]+, \"right\"", source)) == 4


def test_who_pulls_out_of_a_row_has_room_before_it() -> None:
    car = parked(id="A", role="adversary", does=[*STANDS, {"act": "pull-out"}])
    ahead = re.findall(r"new Car at besideRoad\(egoRoute, \S+ \+ ([\d.]+)", made(car).program.source)
    assert min(map(float, ahead)) == 12.0


def test_the_length_of_a_row_is_told() -> None:
    said = from_plain({"others": [ONCOMING, parked(count=0, stretch="55 m")]})
    assert "in a row 55 m long" in told(said)
