"""A bound, a range or a speed against the ego's that was said is built as such, in whatever it is said of."""

from __future__ import annotations

import math
import re
from typing import Any

import pytest

from chatscene.build.build import Built, build
from chatscene.errors import NotBuilt
from chatscene.situations.form import from_plain
from chatscene.terms.actors import LIMITS
from chatscene.terms.amount import Length, Speed
from chatscene.terms.scene import CAR

LEAD: dict[str, Any] = {"id": "A", "kind": "car", "starts": {"where": "ahead"}, "does": [{"act": "brake"}]}
KMH = 1 / 3.6


def built(*others: dict[str, Any], ego: dict[str, Any] | None = None, **more: Any) -> Built:
    made = build(from_plain({"ego": {"speed": "50 km/h"} | (ego or {}), "others": list(others), **more}))
    assert not re.search(r"\b(?:nan|inf)\b", made.program.source)
    return made


def drawn(made: Built, name: str) -> tuple[float, float]:
    """From where to where a parameter is drawn."""
    one = next(one for one in made.program.parameters if one.name == f"OPT_A_{name}")
    return one.low, one.high


def does(act: str, start: dict[str, Any] | None = None, **amounts: Any) -> dict[str, Any]:
    return LEAD | {"starts": start or LEAD["starts"], "does": [{"act": act, **amounts}]}


@pytest.mark.parametrize(
    ("said", "usual", "range_"),
    [
        ("8 m", (10.0, 20.0), (8.0, 8.0)),
        ("5 to 8 m", (10.0, 20.0), (5.0, 8.0)),
        ("5 to 15 m", (10.0, 20.0), (10.0, 15.0)),
        ("at most 8 m", (10.0, 20.0), (8.0, 8.0)),
        ("at most 15 m", (10.0, 20.0), (10.0, 15.0)),
        ("at least 15 m", (10.0, 20.0), (15.0, 20.0)),
        ("at least 30 m", (10.0, 20.0), (30.0, 30.0)),
    ],
)
def test_a_number_is_drawn_of_what_is_usual_and_was_said_or_else_of_what_was_said(
    said: str, usual: tuple[float, float], range_: tuple[float, float]
) -> None:
    amount = Length.of(said)
    assert amount.drawn(*usual) == range_
    assert amount.low <= amount.near(sum(usual) / 2) <= amount.high


def test_a_speed_against_the_egos_is_one_of_its_own_beside_it() -> None:
    assert Speed.of("10 km/h less than the ego").beside(50 * KMH) == Speed.of("40 km/h")
    assert Speed.of("40 km/h").beside(50 * KMH) == Speed.of("40 km/h")


@pytest.mark.parametrize(
    ("start", "act"),
    [
        ({"where": "ahead", "distance": "5 to 8 m"}, "brake"),
        ({"where": "ahead", "distance": "at most 8 m"}, "brake"),
        ({"where": "behind", "distance": "2 to 3 m"}, "go-along"),
        ({"where": "kerb", "side": "right", "distance": "10 to 15 m"}, "stand"),
        ({"where": "oncoming", "distance": "40 to 60 m"}, "enter"),
        ({"where": "roadside", "side": "right", "distance": "15 to 20 m"}, "enter"),
    ],
)
def test_who_begins_nearer_than_is_usual_begins_as_near_as_was_said(start: dict[str, Any], act: str) -> None:
    source = built(does(act, start)).program.source
    nose = LIMITS[CAR].length if start["where"] in ("ahead", "behind") else 0.0
    said = Length.of(start["distance"])
    found = re.search(r"param OPT_A_Y = Range\(([\d.]+), ([\d.]+)\)", source)
    if found is None:
        assert f"{said.most + nose:g}" in source
        return
    assert said.low - 1e-6 <= float(found[1]) - nose and float(found[2]) - nose <= said.high + 1e-6


def test_who_begins_so_much_slower_than_the_ego_drives() -> None:
    start = {"where": "ahead-beside", "side": "left", "speed": "10 km/h less than the ego"}
    source = built(does("cut-in", start), ego={"speed": "60 km/h"}).program.source
    assert "with speed 13.8889" in source and "Park()" not in source


@pytest.mark.parametrize("said", ["60 km/h less than the ego", "50 km/h less than the ego"])
@pytest.mark.parametrize("kind", ["car", "bicycle"])
def test_a_speed_that_is_none_beside_the_ego_is_refused_by_its_path(said: str, kind: str) -> None:
    with pytest.raises(
        NotBuilt, match=r"others\.A\.does\.0\.speed: .* less than the ego, but the ego drives at 50 km/h"
    ):
        built(does("go-along", speed=said) | {"kind": kind})


@pytest.mark.parametrize(
    ("act", "amounts", "name"),
    [
        ("brake", {"time": "at most 3 s"}, "BRAKE_0"),
        ("slow-down", {"speed": "30 km/h", "time": "at most 4 s"}, "BRAKE_0"),
        ("stop", {"distance": "at most 40 m"}, "BRAKE_0"),
        ("accelerate", {"speed": "50 km/h", "time": "at most 6 s"}, "THROTTLE_0"),
        ("reverse", {"distance": "at most 10 m"}, "BACK_TIME_0"),
    ],
)
def test_a_bound_is_built_as_hard_as_is_usual(act: str, amounts: dict[str, str], name: str) -> None:
    start = {"where": "ahead", "speed": "40 km/h"} if act == "accelerate" else {"where": "ahead"}
    low, high = drawn(built(does(act, start, **amounts)), name)
    assert 0.0 < low <= high < math.inf


@pytest.mark.parametrize(
    ("deed", "order"),
    [
        ({"act": "swerve", "when": {"ego_within": "at least 20 m", "of": "A"}}, r"within=\d"),
        ({"act": "brake", "acceleration": "at most 5 m/s²"}, r"braking=5\b"),
        ({"act": "drift", "distance": "at most 1 m"}, r"aside=1\b"),
        ({"act": "slow-down", "speed": "at least 20 km/h"}, r"at_most=5\.556"),
        ({"act": "go-along", "speed": "at least 20 km/h", "time": "at most 2 s"}, r"at_most=13\.89, till=2\b"),
    ],
)
def test_the_ego_does_as_is_usual_within_a_bound(deed: dict[str, Any], order: str) -> None:
    assert re.search(order, built(LEAD, ego={"does": [deed]}).program.source)


def test_the_ego_acts_as_near_to_who_is_slower_than_it_as_to_who_has_that_speed() -> None:
    def near(speed: str) -> str:
        ego = {"does": [{"act": "swerve", "to": "left"}]}
        source = built(does("go-along", speed=speed), ego=ego).program.source
        return re.findall(r"within=([\d.]+)", source)[0]

    assert near("10 km/h less than the ego") == near("40 km/h")
