"""The sentence that says how fast who was."""

from typing import Any

import pytest

from chatscene.report.how_fast import harm, harm_in_words, how_fast, scene_in_words
from chatscene.terms.speeds import Speeds

KMH = 1 / 3.6
NONE = dict.fromkeys(Speeds.__dataclass_fields__) | {"impact_speed": None}


def row(ego: float = 50.0, other: float = 40.0, **besides: Any) -> dict[str, Any]:
    """A drive behind a car, without a collision; speeds in km/h."""
    return {
        **NONE,
        "status": "ran",
        "collision": False,
        "ego_kind": "Car",
        "other_kind": "Car",
        "ego_speed_before": ego * KMH,
        "other_speed_most": other * KMH,
        "time_to_collision": 1.2,
        "distance": 3.4,
        **besides,
    }


def crashed(kind: str, kmh: float, **risks: Any) -> dict[str, Any]:
    """A drive that ended with the ego's front in somebody who stood."""
    return row(
        other=0.0,
        collision=True,
        other_kind=kind,
        impact_speed=kmh * KMH,
        closing_speed=kmh * KMH,
        ego_speed_at_impact=kmh * KMH,
        other_speed_at_impact=0.0,
        ego_delta_v=0.5 * kmh * KMH,
        other_delta_v=0.5 * kmh * KMH,
        **risks,
    )


def test_it_says_how_fast_who_drove_and_how_near_they_came() -> None:
    assert how_fast([row()]) == (
        "The ego drove at 50 km/h, the car at up to 40 km/h. "
        "In the closest near miss they came within 3.4 m, and within 1.2 s of a collision."
    )


def test_speeds_that_differ_are_told_with_their_range_and_kinds_with_their_count() -> None:
    rows = [row(48), row(50), row(80, other_kind="Truck", other_speed_most=0.0)]
    assert how_fast(rows).startswith(
        "The ego drove at 50 km/h (48 to 80), the car in 2 at up to 40 km/h, the truck in 1 stood."
    )


def test_the_hardest_crash_has_its_speed_and_what_a_curve_says_of_it() -> None:
    rows = [row(), crashed("Pedestrian", 20, other_death_risk=0.006), crashed("Pedestrian", 34, other_death_risk=0.021)]
    assert how_fast(rows).endswith(
        "The hardest crash had an impact speed of 34 km/h: "
        "2 in 100 pedestrians die when struck at 34 km/h (Rosén and Sander 2009)."
    )


def test_a_crash_that_is_faster_than_the_hardest_is_told() -> None:
    straight = crashed("Pedestrian", 34, other_death_risk=0.021)
    grazing = crashed("Pedestrian", 45) | {"closing_speed": 20 * KMH}
    assert (
        how_fast([straight, grazing])
        .split(". ")[-1]
        .startswith("The hardest crash had an impact speed of 34 km/h (the fastest, less straight, one of 45 km/h): ")
    )


def test_a_crash_of_which_no_curve_is_says_so() -> None:
    assert how_fast([crashed("Dog", 30)]).endswith(
        "The crash had an impact speed of 30 km/h: no published injury-risk curve is of such a crash."
    )
    assert harm_in_words(row()) == ""


def test_a_crash_of_two_cars_that_is_milder_than_a_curve_goes_says_that() -> None:
    assert how_fast([crashed("Car", 10)]).endswith(
        "The crash had an impact speed of 10 km/h: milder than those of which there are injury-risk curves."
    )


def test_both_who_are_hurt_are_told() -> None:
    scene = crashed("Car", 80, ego_injury_risk=0.08, other_injury_risk=0.1)
    assert [[(one.risk, round(3.6 * one.speed)) for one in of] for of in harm(scene)] == [[(0.08, 40)], [(0.1, 40)]]
    assert harm_in_words(scene) == (
        "8 in 100 people in the ego and 10 in 100 people in the other are seriously injured or die at a change of "
        "velocity of 40 km/h (Geisslinger et al. 2023)"
    )


def test_a_scene_says_how_fast_both_were_as_it_began_and_how_near_they_came() -> None:
    before: dict[str, Any] = {"encounter_time": 3.6, "other_speed_before": 15 * KMH, "other_kind": "Bicycle"}
    assert scene_in_words(row(**before)) == (
        "As the encounter began, at 3.6 s: ego at 50 km/h, cyclist at 15 km/h. "
        "They came within 3.4 m, and within 1.2 s of a collision."
    )
    assert scene_in_words(crashed("Dog", 30) | before).endswith("cyclist at 15 km/h.")
    assert scene_in_words(row()) == ""


def test_where_they_never_came_on_a_collision_course_no_time_is_said() -> None:
    assert "they came within 3.4 m." in how_fast([row(time_to_collision=None)])
    assert "they came within 3.4 m." in how_fast([row(time_to_collision=620.6)])


@pytest.mark.parametrize("rows", [[], [{"status": "rejected"}], [{"status": "ran", "ego_speed_before": None}]])
def test_of_folders_of_before_and_of_nothing_it_says_nothing(rows: list[dict[str, Any]]) -> None:
    assert how_fast(rows) == ""


def test_an_ego_alone_has_its_own_speed() -> None:
    alone = row(other_kind=None, other_speed_most=None, time_to_collision=None, distance=None)
    assert how_fast([alone]) == "The ego drove at 50 km/h."


def test_a_graze_has_its_impact_speed_and_how_fast_the_two_closed() -> None:
    told = how_fast([crashed("Car", 82) | {"closing_speed": 8 * KMH}])
    assert (
        "The crash had an impact speed of 82 km/h and a closing speed, straight against each other, of 8 km/h" in told
    )


def test_who_came_near_and_did_not_touch_was_not_at_no_distance() -> None:
    assert "they came within less than 0.1 m" in how_fast([row(distance=0.02)])
