"""Light, weather and road are heard, taken out of the text, or named where no scene has them."""

from __future__ import annotations

import pytest

from chatscene.read.decompose import hear
from chatscene.terms.scenario import Why
from chatscene.terms.surroundings import Light, Surroundings

BRAKES = "the car ahead brakes."


def around(light: str = "day", weather: str = "clear", surface: str = "dry") -> Surroundings:
    return Surroundings.named({"light": light, "weather": weather, "surface": surface})


@pytest.mark.parametrize(
    ("text", "heard"),
    [
        ("The car ahead brakes at night.", around("night")),
        ("It is dark and the car ahead brakes.", around("night")),
        ("At dusk, the car ahead brakes.", around("dusk")),
        ("In the rain the car ahead brakes.", around(weather="rain", surface="wet")),
        ("The road is dry; the car ahead brakes in the rain.", around(weather="rain")),
        ("After the rain the car ahead brakes.", around(surface="wet")),
        ("Road wet. The car ahead brakes.", around(surface="wet")),
        ("Road icy: the car ahead brakes.", around(surface="ice")),
        ("The car ahead brakes while it is foggy.", around(weather="fog")),
        ("On a foggy night the car ahead brakes.", around("night", "fog")),
        ("The road is icy and the car ahead brakes.", around(surface="ice")),
        ("Black ice: the car ahead brakes.", around(surface="ice")),
        ("There was ice on the road. The car ahead brakes.", around(surface="ice")),
        ("Snow on our street; the car ahead brakes.", around(surface="snow")),
        ("The car ahead brakes because the road is covered in snow.", around(surface="snow")),
        ("It is snowing. The car ahead brakes.", around(weather="snow", surface="snow")),
        ("The car ahead brakes in broad daylight.", around()),
    ],
)
def test_what_surrounds_a_scene_is_heard_and_the_rest_is_read_as_without_it(text: str, heard: Surroundings) -> None:
    frame = hear(text)
    assert frame.surroundings == heard
    assert frame.unused == ()
    assert frame.whole
    assert frame.told.removeprefix("the road is dry; ") == BRAKES or "road" in frame.told


@pytest.mark.parametrize(
    "text",
    [
        "The car ahead brakes and there is no fog.",
        "It is not raining and the road is not icy; the car ahead brakes.",
        "The night bus ahead brakes.",
        "The car ahead brakes on a dry road in daylight.",
        "A boy stands in our lane frozen.",
        "A man steps from the pavement wet, and stops.",
    ],
)
def test_what_is_denied_or_usual_changes_nothing(text: str) -> None:
    frame = hear(text)
    assert frame.surroundings == Surroundings()
    assert not {Why.WEATHER, Why.LIGHT} & {one.why for one in frame.unused}


@pytest.mark.parametrize(
    ("text", "said", "why"),
    [
        ("Gusts: the car ahead brakes.", "gusts", Why.WEATHER),
        ("Puddles: the car ahead brakes.", "puddles", Why.WEATHER),
        ("On a flooded street the car ahead brakes.", "flooded street", Why.WEATHER),
        ("In the low sun the car ahead brakes.", "low sun", Why.LIGHT),
        ("The car ahead brakes in poor visibility.", "poor visibility", Why.WEATHER),
        ("The car ahead brakes on a slippery road.", "slippery road", Why.WEATHER),
        ("In snow and rain the car ahead brakes.", "rain", Why.WEATHER),
        ("In heavy rain the car ahead brakes.", "heavy", Why.DEGREE),
    ],
)
def test_what_no_scene_has_is_named(text: str, said: str, why: Why) -> None:
    assert [(one.said, one.why) for one in hear(text).unused] == [(said, why)]


@pytest.mark.parametrize("text", ["On a slippery road in the rain the car ahead brakes.", "Poor visibility in fog."])
def test_what_follows_from_what_was_said_needs_no_name_of_its_own(text: str) -> None:
    assert Why.WEATHER not in {one.why for one in hear(text).unused}


def test_the_colour_of_a_light_is_no_degree_of_the_night() -> None:
    frame = hear("The car from the left does not stop at the red light at night.")
    assert frame.surroundings.light is Light.NIGHT
    assert "red light." in frame.told
    assert frame.unused == ()
