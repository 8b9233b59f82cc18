from __future__ import annotations

import pytest

from chatscene.errors import EditRefused
from chatscene.read.decompose import hear
from chatscene.read.edit import hear_edit
from chatscene.terms.conclusions import concluded
from chatscene.terms.edit import Facts, changes

WALKS = "A pedestrian crosses the road from the right."
BRAKES = "The car ahead of us brakes hard."
CUTS_IN = "A car in the left lane cuts in front of us."
HIDDEN = "A pedestrian steps out from behind a parked car on the right."
TURNING = "We turn right at a junction and a cyclist crosses from the left."
TWO = "A car brakes ahead of us and a truck drives behind us."
RAIN = "A motorcycle cuts in from the left in rain at night."
BIKE = "A cyclist crosses the street from the right."
TURNS = "An oncoming car turns left across our path at a junction."
RUNS_LIGHT = "A car from the left runs the red light."


def facts_of(text: str) -> Facts:
    frame = hear(text)
    return Facts.of(frame, concluded(frame.outright))


def after(text: str, edit: str) -> dict[str, str]:
    facts = facts_of(text)
    return {one.fact: str(one).partition(" → ")[2] for one in changes(facts, hear_edit(edit, facts).facts)}


@pytest.mark.parametrize(
    ("text", "edit", "changed"),
    [
        (WALKS, "make it a truck", {"adversary": "truck"}),
        (WALKS, "a cyclist instead", {"adversary": "bicycle"}),
        (BRAKES, "use a bus rather than the car", {"adversary": "bus"}),
        (BRAKES, "replace the car with a motorcycle", {"adversary": "motorcycle"}),
        (WALKS, "from the left", {"side": "left"}),
        (WALKS, "from the other side, please", {"side": "left"}),
        (CUTS_IN, "mirror it", {"side": "right"}),
        (WALKS, "let him stop halfway", {"actions": "cross then stop"}),
        (WALKS, "it should wait for a moment halfway", {"actions": "cross then hesitate"}),
        (BRAKES, "then it reverses", {"actions": "brake then reverse"}),
        (BRAKES, "it should stop instead of braking", {"actions": "stop"}),
        (CUTS_IN, "it should brake after that", {"actions": "cut-in then brake"}),
        (BRAKES, "start behind us", {"position": "behind"}),
        (WALKS, "hidden by a hedge", {"occluder": "hedge"}),
        (HIDDEN, "a bus stop instead of the parked car", {"occluder": "bus-stop"}),
        (HIDDEN, "make the parked car a parked truck", {"occluder": "parked-truck"}),
        (HIDDEN, "visible from the start", {"occluder": "not said"}),
        (TURNING, "turn left instead of right", {"maneuver": "left-turn"}),
        (TURNING, "at a crossroads", {"place": "four-way"}),
        (TURNING, "with traffic lights", {"control": "signal"}),
        (BRAKES, "we are standing", {"ego": "stands"}),
        (WALKS, "at night", {"light": "night"}),
        (WALKS, "on an icy road", {"surface": "ice"}),
        (RAIN, "by day", {"light": "day"}),
        (WALKS, "20 m ahead", {"distance": "20 m ahead"}),
        (BRAKES, "at 50 km/h", {"speed": "at 50 km/h"}),
        (BRAKES, "it brakes with 6 m/s²", {"deceleration": "with 6 m/s²"}),
        (BRAKES, "brake harder", {"deceleration": "harder"}),
        (WALKS, "twice as fast", {"speed": "twice as fast"}),
        (WALKS, "a bit closer", {"distance": "a bit closer"}),
        (WALKS, "make it a group", {"group": "yes"}),
        (WALKS, "add a truck that stands ahead of us", {"others": "truck stand (ahead)"}),
        (TWO, "without the truck", {"others": "not said"}),
        (TWO, "the truck tailgates us", {"others": "truck tailgate (behind)"}),
        (TWO, "swap the truck for a motorcycle", {"others": "motorcycle follow (behind)"}),
        (TWO, "nobody behind us", {"others": "not said"}),
        (TWO, "the front car should be a police car", {"adversary": "emergency-vehicle"}),
        (WALKS, "there should be a truck behind us", {"others": "truck follow (behind)"}),
        (WALKS, "walking from left to right", {"side": "left"}),
        (WALKS, "increase the speed by 20%", {"speed": "increase the speed by 20%"}),
        (WALKS, "pedestrian -> e-scooter", {"adversary": "e-scooter"}),
        (CUTS_IN, "make it cut in a bit later", {"trigger": "a bit later"}),
        (CUTS_IN, "the car cuts in from the right instead", {"side": "right"}),
        (BRAKES, "emergency braking at 8 m/s²", {"deceleration": "at 8 m/s²"}),
        (BRAKES, "don't brake, just go slowly", {"actions": "slow"}),
        (BRAKES, "change lanes before it brakes", {"actions": "change-lane then brake"}),
        (BIKE, "let the kid hesitate in the middle of the street", {"actions": "cross then hesitate"}),
        (BIKE, "let a car drive behind us", {"others": "car follow (behind)"}),
        (BIKE, "hidden between parked cars", {"occluder": "parked-car"}),
        (BRAKES, "make it a lorry with a trailer", {"adversary": "truck"}),
        (BRAKES, "from behind a second car tailgates us", {"others": "car tailgate (behind)"}),
        (BRAKES, "make the gap smaller", {"distance": "smaller"}),
        (CUTS_IN, "it should start 15 m behind us", {"position": "behind-beside", "distance": "15 m behind us"}),
        (WALKS, "I'd rather have a cyclist", {"adversary": "bicycle"}),
        (WALKS, "opposite direction please", {"side": "left"}),
        (WALKS, "let her walk slower", {"speed": "slower"}),
        (WALKS, "reduce its speed by 1 m/s", {"speed": "reduce its speed by 1 m/s"}),
        (WALKS, "there are three pedestrians", {"group": "yes"}),
        (BIKE, "let the cyclist slow down while crossing", {"actions": "cross then brake"}),
        (BRAKES, "instead of braking it stays put", {"actions": "stand"}),
        (WALKS, "pedestrian should be a cyclist", {"adversary": "bicycle"}),
        (BRAKES, "car becomes a truck", {"adversary": "truck"}),
        (TURNS, "make it a truck that turns", {"adversary": "truck"}),
        (TURNS, "the car should turn earlier", {"trigger": "earlier"}),
        (TURNS, "turn right instead", {"actions": "turn-right"}),
        ("An oncoming cyclist comes towards us.", "he brakes", {"actions": "oncoming then brake"}),
        (WALKS, "I'd be grateful if she could come from the left-hand side.", {"side": "left"}),
        (WALKS, "nah, I think a dog would be scarier", {"adversary": "dog"}),
        (WALKS, "An e-scooter would be more dangerous than somebody on foot.", {"adversary": "e-scooter"}),
        (WALKS, "sorry, I meant left", {"side": "left"}),
        (WALKS, "right -> left", {"side": "left"}),
        (WALKS, "couldn't it be a cyclist?", {"adversary": "bicycle"}),
        (WALKS, "set adversary=cyclist", {"adversary": "bicycle"}),
        (WALKS, "it is too slow", {"speed": "it is too slow"}),
        (WALKS, "more fast", {"speed": "faster"}),
        (BRAKES, "make it a van, no, a bus", {"adversary": "bus"}),
        (BRAKES, "a truck is following us", {"others": "truck follow (behind)"}),
        (HIDDEN, "could the parked car be a bus?", {"occluder": "parked-bus"}),
        (TURNS, "it turns right, not left", {"actions": "turn-right"}),
        (TURNING, "we are stationary, then set off", {"ego": "sets-off"}),
        (CUTS_IN, "it cuts in on us and slows down", {"actions": "cut-in then brake"}),
    ],
)
def test_an_edit_changes_just_the_fact_that_it_names(text: str, edit: str, changed: dict[str, str]) -> None:
    assert after(text, edit) == changed


@pytest.mark.parametrize(
    ("text", "edit", "changed"),
    [
        (BRAKES, "make it a truck that cuts in from the left instead", {"adversary", "actions", "side", "position"}),
        (BRAKES, "make it a truck, from the left, and faster", {"adversary", "side", "position", "speed"}),
        (HIDDEN, "a cyclist from the left at dusk, hidden by a kiosk", {"adversary", "side", "light", "occluder"}),
    ],
)
def test_several_facts_can_be_named_at_once(text: str, edit: str, changed: set[str]) -> None:
    assert set(after(text, edit)) == changed


def test_what_follows_from_a_named_fact_follows() -> None:
    assert after(WALKS, "we turn left") == {"maneuver": "left-turn", "place": "junction"}
    assert after(RAIN, "in snow instead") == {"weather": "snow", "surface": "snow"}
    assert after(RAIN, "no rain") == {"weather": "clear", "surface": "dry"}
    assert after(WALKS, "at a roundabout")["site"] == "roundabout"


@pytest.mark.parametrize(
    ("text", "edit", "reason"),
    [
        (WALKS, "make it a purple dragon", "not understood: 'purple dragon'"),
        (WALKS, "make it a truck and play some jazz", "not understood: 'play'"),
        (WALKS, "from the left and from the right", "cannot be both 'from the left' and 'from the right'"),
        (WALKS, "from the right", "nothing to change"),
        (WALKS, "no hedge", "it is not so"),
        (WALKS, "without the truck", "there is none"),
        (BRAKES, "from the other side", "say left or right"),
        (BRAKES, "without the braking", "nothing is left"),
        (RUNS_LIGHT, "no traffic lights", "cannot be with the rest"),
        (TURNING, "on a straight road", "at junctions only"),
        (BRAKES, "we wait for 3 s", "of it a speed can be said"),
        (BRAKES, "it swerves to the left", "is no edit"),
        (WALKS, "cyclist -> e-scooter", "there is none"),
        (WALKS, "hidden", "say by what"),
        (WALKS, "he explodes, so make it purple", "not understood: 'explodes,', 'purple'"),
        (WALKS, "from the left, with an umbrella", "not understood: 'umbrella'"),
        (WALKS, "make it more realistic", "not understood"),
        (WALKS, "we are a truck", "what the ego is"),
    ],
)
def test_what_cannot_be_done_is_refused_by_its_words(text: str, edit: str, reason: str) -> None:
    with pytest.raises(EditRefused) as refused:
        after(text, edit)
    assert reason in str(refused.value)


def test_a_number_that_was_said_is_what_faster_is_faster_than() -> None:
    facts = facts_of("A cyclist crosses from the left at 20 km/h.")
    number = hear_edit("faster", facts).facts.numbers
    (quantity,) = next(iter(number.values()))
    assert quantity.said == "faster (before: at 20 km/h)"
    assert getattr(quantity, "value", 0.0) == pytest.approx(25 / 3.6, abs=0.01)


def test_how_heavy_a_rain_is_that_is_not_in_a_scene_is_listed_as_not_used() -> None:
    edit = hear_edit("in heavy rain", facts_of(WALKS))
    assert [one.said for one in edit.unused] == ["heavy"]


@pytest.mark.parametrize(
    ("edit", "changed", "comment"),
    [
        ("She is too easy to see; put her behind a hedge.", {"occluder"}, "she is too easy to see"),
        ("The driver can't judge our speed, so add fog.", {"weather", "surface"}, "the driver can not judge our speed"),
        ("make it a dog because cats are not supported", {"adversary"}, "because cats are not supported"),
    ],
)
def test_why_something_is_wanted_is_listed_as_not_used(edit: str, changed: set[str], comment: str) -> None:
    facts = facts_of(WALKS)
    read = hear_edit(edit, facts)
    assert {one.fact for one in changes(facts, read.facts)} <= changed
    assert [one.said for one in read.unused] == [comment]


def test_who_is_left_when_the_adversary_goes_is_the_adversary() -> None:
    told = after(TWO, "remove the car")
    assert (told["adversary"], told["actions"], told["position"], told["others"]) == (
        "truck",
        "follow",
        "behind",
        "not said",
    )
