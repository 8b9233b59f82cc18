"""The injury-risk curves say what their sources say of them, and nothing where they do not hold."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from chatscene.measure.severity import CURVES, HALF, KMH, By, Curve, Found, Hurt, Outcome, curves_for
from chatscene.measure.severity import told as in_clauses
from chatscene.terms.actors import AdversaryKind

CAR, WALKER = AdversaryKind.CAR, AdversaryKind.PEDESTRIAN


def curve(who: str, source: str, part: str = "") -> Curve:
    (found,) = (c for c in CURVES if c.who == who and source in c.source and (part in c.parts or not part))
    return found


def risk(of: Curve, kmh: float) -> float:
    found = of.at(kmh / KMH)
    assert found is not None
    return found


# Rosén and Sander 2009, of their equation 2, as the paper's abstract and those who quote it round it.
@pytest.mark.parametrize(("kmh", "share"), [(30, 0.015), (40, 0.036), (50, 0.083), (60, 0.182), (70, 0.354)])
def test_pedestrians_die_at_a_speed_as_rosen_and_sander_say(kmh: float, share: float) -> None:
    assert risk(curve("pedestrians", "Rosén"), kmh) == pytest.approx(share, abs=0.001)


def test_at_50_kmh_more_than_twice_as_many_die_as_at_40_and_five_times_as_many_as_at_30() -> None:
    of = curve("pedestrians", "Rosén")
    assert risk(of, 50) > 2 * risk(of, 40)
    assert risk(of, 50) > 5 * risk(of, 30)


# The abstract of Lubbe, Wu and Jeppsson 2022; it rounds to whole km/h, its tables to three decimals.
@pytest.mark.parametrize(("who", "kmh"), [("pedestrians", 29), ("cyclists", 44), ("motorcyclists", 48)])
def test_one_in_ten_is_seriously_injured_at_the_closing_speed_that_lubbe_says(who: str, kmh: float) -> None:
    of = curve(who, "Lubbe")
    tenth = (math.log(0.1 / 0.9) - of.intercept) / of.slope * KMH
    assert tenth == pytest.approx(kmh, abs=0.6)


# Kusano et al., "TARGET" (Traffic Safety Research), 10 % MAIS 3+ of other data, between cars of one mass.
@pytest.mark.parametrize(("part", "closing"), [("front", 99), ("left", 73), ("rear", 126)])
def test_the_curve_of_car_occupants_is_near_that_of_other_data(part: str, closing: float) -> None:
    of = curve("people in a car", "Geisslinger", part)
    assert 0.1 / 1.6 < risk(of, closing / 2) < 0.1 * 1.6


@pytest.mark.parametrize("of", CURVES, ids=lambda of: f"{of.who} {of.outcome} {' '.join(sorted(of.parts))}")
def test_a_curve_rises_up_to_its_middle_and_is_followed_no_further(of: Curve) -> None:
    speeds = [of.least + share * (of.middle - of.least) for share in (0.0, 0.3, 0.6, 0.99)]
    risks = [of.at(speed) for speed in speeds]
    assert risks == sorted(r for r in risks if r is not None)
    assert 0.0 < (risks[0] or 0.0) < (risks[-1] or 1.0) < HALF
    assert of.at(of.middle) == of.at(3 * of.middle) == HALF
    assert of.at(of.least - 0.01) is None or of.least == 0.0


def pair(kind: AdversaryKind | None, part: str, speed: float = 10.0, delta_v: float | None = 10.0) -> Hurt:
    return Hurt(kind=kind, part=part, speed=speed, delta_v=delta_v)


def told(one: Hurt, other: Hurt, impact: float = 10.0, closing: float = 10.0) -> list[tuple[str, str]]:
    found = curves_for(one, other, impact_speed=impact, closing_speed=closing)
    return [(each.curve.who, each.curve.outcome.name) for each in found]


def test_who_is_struck_by_the_front_of_a_car_has_curves_and_who_walks_into_its_side_has_none() -> None:
    walker = pair(WALKER, "")
    assert told(walker, pair(CAR, "front")) == [("pedestrians", "DEATH"), ("pedestrians", "INJURY")]
    assert told(walker, pair(CAR, "left")) == []
    assert told(pair(AdversaryKind.BICYCLE, "left"), pair(CAR, "front")) == [("cyclists", "INJURY")]


@pytest.mark.parametrize("striker", ["TRUCK", "BUS", "VAN", "BICYCLE", "TRAM"])
def test_the_front_of_anything_but_a_car_has_no_curve(striker: str) -> None:
    assert told(pair(WALKER, ""), pair(AdversaryKind[striker], "front")) == []


@pytest.mark.parametrize("kind", ["CHILD", "WHEELCHAIR", "E_SCOOTER", "DOG", "DEER", "TRUCK", "BUS", "TRAM", "BOX"])
def test_whom_nobody_has_published_a_curve_of_has_none(kind: str) -> None:
    assert told(pair(AdversaryKind[kind], "front"), pair(CAR, "front")) == []


def test_people_in_a_car_have_one_where_it_meets_a_vehicle_and_not_where_it_meets_a_walker_or_a_wall() -> None:
    car = pair(CAR, "front")
    assert told(car, pair(CAR, "rear")) == [("people in a car", "INJURY")]
    assert told(car, pair(AdversaryKind.TRUCK, "front")) == [("people in a car", "INJURY")]
    assert told(car, pair(WALKER, "")) == []
    assert told(car, pair(None, "")) == []
    assert told(pair(CAR, "front", delta_v=1.0), pair(CAR, "rear")) == []  # a tap


def test_a_side_is_worse_than_a_front_and_a_rear_is_milder() -> None:
    front, side, rear = (risk(curve("people in a car", "Geiss", part), 40) for part in ("front", "right", "rear"))
    assert rear < front < side


def test_a_graze_has_none() -> None:
    walker, car = pair(WALKER, ""), pair(CAR, "front")
    assert told(walker, car, impact=30.0, closing=14.0) == []
    assert told(walker, car, impact=30.0, closing=16.0) == [("pedestrians", "DEATH"), ("pedestrians", "INJURY")]


@given(st.floats(1.0, 60.0), st.floats(0.0, 60.0))
def test_each_curve_takes_its_own_speed(closing: float, speed: float) -> None:
    found = curves_for(pair(WALKER, ""), pair(CAR, "front", speed=speed), impact_speed=closing, closing_speed=closing)
    for each in found:
        of = each.curve
        assert each.speed == (speed if of.by is By.STRIKER else closing)
        assert each.risk == of.at(each.speed)
        assert (of.outcome is Outcome.DEATH) == (of.by is By.STRIKER)


@pytest.mark.parametrize(
    ("kmh", "said"),
    [
        (34, "2 in 100 pedestrians die when struck at 34 km/h (Rosén and Sander 2009)"),
        (10, "fewer than 1 in 100 pedestrians die when struck at 10 km/h (Rosén and Sander 2009)"),
        (110, "half or more of pedestrians die when struck at 110 km/h (Rosén and Sander 2009)"),
    ],
)
def test_what_a_curve_says_is_said_of_a_hundred_people_with_its_source(kmh: float, said: str) -> None:
    speed = kmh / KMH
    found = curves_for(pair(WALKER, ""), pair(CAR, "front", speed=speed), impact_speed=speed, closing_speed=speed)
    assert next(each.in_words() for each in found if each.curve.outcome is Outcome.DEATH) == said


def test_people_in_two_cars_are_told_of_in_one_clause() -> None:
    of = curve("people in a car", "Geisslinger", "front")
    slow, fast = (Found(curve=of, risk=of.at(v) or 0.0, speed=v) for v in (8.0, 12.0))
    by = "are seriously injured or die at a change of velocity of"
    assert in_clauses([slow], [slow]) == (f"5 in 100 people in either car {by} 29 km/h (Geisslinger et al. 2023)",)
    assert in_clauses([slow], [fast]) == (
        f"5 in 100 people in the ego and 9 in 100 people in the other {by} 29 km/h and 43 km/h "
        "(Geisslinger et al. 2023)",
    )
    assert in_clauses([], [slow]) == (slow.in_words(),)
