"""A text that is read from its first word to its last, and one that is not."""

from __future__ import annotations

import pytest

from chatscene.read.canonical import canonical
from chatscene.read.parse import Parsed, parse
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.acts import Action
from chatscene.terms.scenario import Control, EgoState, Maneuver, Occluder, Place, Position, Side, Site


def read(text: str) -> Parsed:
    found = parse(canonical(text))
    assert found is not None, text
    return found


@pytest.mark.parametrize(
    ("text", "position", "actions"),
    [
        ("A car stands still in our lane ahead.", "ahead", ["stand"]),
        ("A broken-down truck stands in our lane.", "ahead", ["stand"]),
        ("A bus ahead of us brakes hard and stops.", "ahead", ["brake", "stop"]),
        ("The cyclist in front of us rides on at a constant speed.", "ahead", ["follow"]),
        ("A pedestrian walks along the lane ahead of us.", "ahead", ["follow"]),
        ("A pedestrian waits at the kerb on the right and does not cross.", "roadside", ["stand"]),
        ("A pedestrian waits at the kerb, then crosses the road.", "roadside", ["cross"]),
        ("A taxi from the next lane cuts in in front of us.", "ahead-beside", ["cut-in"]),
        ("A car ahead of us changes lanes.", "ahead", ["change-lane"]),
        ("An oncoming van drives straight towards us in our lane.", "oncoming", ["wrong-way"]),
        ("A motorcycle overtakes us and brakes.", "behind", ["overtake", "brake"]),
        ("A car in the left lane behind us accelerates.", "behind-beside", ["accelerate"]),
        ("A car ahead of us turns around.", "ahead", ["u-turn"]),
        ("An oncoming car turns back.", "oncoming", ["u-turn"]),
        ("A cyclist crosses the road and turns back.", "roadside", ["cross", "turn-back"]),
        ("A parked car pulls out and turns back.", "kerb", ["pull-out", "turn-back"]),
        ("An oncoming car swerves and goes back.", "oncoming", ["swerve", "turn-back"]),
        ("A parked car pulls out in front of us.", "kerb", ["pull-out"]),
        ("A lorry from the left runs the red light.", "crossing", ["run-light"]),
        ("An ambulance crosses the junction from the right.", "crossing", ["cross"]),
        ("A cyclist crosses from the right while we turn right.", "roadside", ["cross"]),
        ("A cyclist rides along the right edge of the road.", "ahead", ["follow"]),
        ("A parked car blocks our lane ahead.", "ahead", ["block"]),
        ("A stopped car ahead blocks a part of our lane.", "ahead", ["narrow"]),
        ("A parked van on the right sticks out into our lane.", "ahead", ["narrow"]),
        ("We turn right at a junction, and a car stands in our lane behind the corner.", "beyond", ["stand"]),
        ("A box lies on the road in our lane ahead.", "ahead", ["stand"]),
        ("We turn right, and a cyclist beside us on the right rides straight on.", "beside", ["follow"]),
        ("We turn right, and a cyclist rides alongside us on the right.", "beside", ["follow"]),
        ("A car from the left drives straight across a junction in front of us.", "crossing", ["follow"]),
        ("At a junction, a car in the lane to our left turns right across our lane.", "ahead-beside", ["turn-right"]),
        ("We change lanes to the left to pass a slow car.", "ahead", ["slow"]),
        ("We drive behind a slow truck.", "ahead", ["slow"]),
        (
            "We change lanes to the left, and the car ahead of us in that lane leaves it.",
            "ahead-beside",
            ["change-lane"],
        ),
        ("We change lanes to the left, and a car cuts into that lane ahead of us.", "ahead-beside", ["cut-in"]),
    ],
)
def test_who_does_what_from_where(text: str, position: str, actions: list[str]) -> None:
    slots = read(text).slots
    assert (slots.position, list(slots.actions)) == (position, actions)


@pytest.mark.parametrize(
    ("text", "facts"),
    [
        ("We turn left at a signalised junction.", (Maneuver.LEFT_TURN, Place.JUNCTION, Control.SIGNAL, None)),
        ("We go straight on at a T-junction.", (Maneuver.STRAIGHT, Place.THREE_WAY, None, None)),
        ("We wait at a red light.", (Maneuver.STRAIGHT, Place.JUNCTION, Control.SIGNAL, EgoState.STANDS)),
        ("We change lanes to the left.", (Maneuver.LANE_CHANGE_LEFT, Place.ROAD, None, None)),
        ("The ego drives slowly in a left-hand bend.", (Maneuver.STRAIGHT, Place.LEFT_CURVE, None, EgoState.SLOW)),
        ("We drive along.", (None, None, None, None)),
    ],
)
def test_what_the_ego_does_is_told_before_or_after(text: str, facts: tuple[object, ...]) -> None:
    for told in (f"{text[:-1]}, and a bus behind us accelerates.", f"A bus behind us accelerates. {text}"):
        slots = read(told).slots
        assert (slots.maneuver, slots.place, slots.control, slots.ego) == facts
        assert (slots.adversary, slots.actions) == (AdversaryKind.BUS, (Action.ACCELERATE,))


def test_the_way_to_an_exit_leaves_the_motorway() -> None:
    slots = read("We change lanes to the right toward the motorway exit while a car drives in that lane.").slots
    assert (slots.site, slots.maneuver) == (Site.OFF_RAMP, Maneuver.LANE_CHANGE_RIGHT)
    assert (slots.position, slots.actions) == (Position.AHEAD_BESIDE, (Action.FOLLOW,))


def test_who_takes_the_exit_changes_lanes_where_there_is_one() -> None:
    slots = read("On the motorway, the car ahead of us takes the exit.").slots
    assert (slots.site, slots.actions, slots.maneuver) == (Site.PAST_OFF_RAMP, (Action.CHANGE_LANE,), Maneuver.STRAIGHT)


def test_a_slow_vehicle_is_the_adversary_where_nobody_else_is_there() -> None:
    slots = read("We merge from the on-ramp behind a slow truck.").slots
    assert (slots.adversary, slots.actions, slots.leader) == (AdversaryKind.TRUCK, (Action.SLOW,), None)


def test_what_hides_somebody_and_on_which_side_is_read() -> None:
    slots = read("A cyclist rides out from behind a parked truck on the left.").slots
    assert (slots.occluder, slots.side, slots.position) == (Occluder.PARKED_TRUCK, Side.LEFT, Position.ROADSIDE)


def test_numbers_belong_to_whom_they_are_said_of() -> None:
    found = read("A car ahead drives at a constant 36 km/h, then brakes with 4 m/s².")
    assert [(q.measure.value, q.value) for q in found.quantities] == [("speed", 10.0), ("deceleration", 4.0)]


def test_two_road_users_are_two_in_the_order_of_telling() -> None:
    found = read("A car stands in our lane ahead, and then a pedestrian crosses the road from the right.")
    assert found.slots.adversary is AdversaryKind.PEDESTRIAN  # who does something is the adversary
    assert [(one.adversary, one.actions) for one in found.slots.others] == [(AdversaryKind.CAR, (Action.STAND,))]
    assert found.order == ((1, Action.STAND), (0, Action.CROSS))


def test_one_who_is_spoken_of_again_is_the_same() -> None:
    found = read("A car ahead of us brakes. Then the car stops, and it reverses.")
    assert (found.slots.actions, found.slots.others) == ((Action.BRAKE, Action.STOP, Action.REVERSE), ())


@pytest.mark.parametrize(
    ("text", "kind", "group"),
    [
        ("A box lies in our lane.", AdversaryKind.BOX, None),
        ("Traffic cones block our lane ahead.", AdversaryKind.CONE, True),
        ("The lost cargo lies in our lane ahead.", AdversaryKind.DEBRIS, None),
        ("Debris lies on the road in our lane.", AdversaryKind.DEBRIS, None),
        ("Two cars stand one behind the other in our lane ahead.", AdversaryKind.CAR, True),
    ],
)
def test_things_lie_on_the_road_and_several_are_a_group(text: str, kind: AdversaryKind, group: bool | None) -> None:
    slots = read(text).slots
    assert (slots.adversary, slots.group, slots.position) == (kind, group, Position.AHEAD)


@pytest.mark.parametrize(
    "text",
    [
        "A box crosses the road.",  # it only lies
        "A car ahead of us stands one behind the other.",  # it is one
        "A car stands in our lane behind the corner.",  # of which there is none
        "A car ahead of us hums and brakes.",  # a word without a place
        "A car ahead of us changes lanes to the left.",  # where it goes to is in no slot
        "A cyclist brakes a pedestrian.",  # nobody is done anything to
        "We drive along.",  # nobody but the ego
        "A car, a bus and a truck ahead of us brake.",  # three are too many
        "A car ahead of us brakes and stands still.",  # it stands all the time, or it brakes
        "We turn left in a bend while a car ahead brakes.",  # no junction
        "A car ahead drives on with 4 m/s².",  # a deceleration of nobody who brakes
        "At a junction a car on a straight road brakes ahead.",  # two places
        "A car ahead of us brakes from the left, from the right.",  # two sides
        "brakes",
        "...",
    ],
)
def test_what_has_no_place_leaves_the_whole_text_to_others(text: str) -> None:
    assert parse(canonical(text)) is None


@pytest.mark.parametrize(
    ("one", "other"),
    [
        ("A car ahead of us brakes hard.", "a car ahead of the ego brakes hard"),
        ("While we turn left, an oncoming car accelerates.", "An oncoming car accelerates while the ego turns left."),
        ("A pedestrian from the left crosses the road.", "A pedestrian crosses the road from the left."),
    ],
)
def test_who_says_the_same_in_another_order_is_read_the_same(one: str, other: str) -> None:
    assert read(one) == read(other)


def test_a_flipped_side_changes_the_side_alone() -> None:
    left, right = (read(f"A pedestrian from the {side} crosses, then goes back.").slots for side in Side)
    assert {name for name in left.said() if getattr(left, name) != getattr(right, name)} == {"side"}


@pytest.mark.parametrize(
    ("text", "site", "maneuver"),
    [
        ("On a motorway, the car ahead of us brakes hard.", Site.MOTORWAY, Maneuver.STRAIGHT),
        ("On a highway, we change lanes to the left, and a bus brakes.", Site.MOTORWAY, Maneuver.LANE_CHANGE_LEFT),
        ("Where an on-ramp joins the motorway, a car from the ramp cuts in.", Site.PAST_ON_RAMP, Maneuver.STRAIGHT),
        ("We merge onto a motorway from the on-ramp, and a bus brakes.", Site.ON_RAMP, Maneuver.LANE_CHANGE_LEFT),
        ("Where an off-ramp leaves the motorway, the car ahead of us brakes.", Site.PAST_OFF_RAMP, Maneuver.STRAIGHT),
        ("We leave the motorway by the exit lane, and a car cuts in.", Site.OFF_RAMP, Maneuver.LANE_CHANGE_RIGHT),
        ("On a country road, an oncoming car drives in our lane.", Site.RURAL, Maneuver.STRAIGHT),
        ("A pedestrian crosses at a crosswalk from the right.", Site.CROSSWALK, Maneuver.STRAIGHT),
        ("We approach a roundabout, and the car ahead of us stops.", Site.ROUNDABOUT, Maneuver.STRAIGHT),
        ("A deer crosses the motorway from the right.", Site.MOTORWAY, Maneuver.STRAIGHT),
    ],
)  # fmt: skip
def test_where_the_way_leads(text: str, site: Site, maneuver: Maneuver) -> None:
    slots = read(text).slots
    assert (slots.site, slots.maneuver) == (site, maneuver)


def test_who_is_on_the_motorway_while_we_merge_is_in_the_lane_beside_ours() -> None:
    slots = read("We merge onto a motorway from the on-ramp, and a car behind us on the motorway accelerates.").slots
    assert slots.position is Position.BEHIND_BESIDE


def test_a_motorway_at_a_junction_is_read_by_nobody_whole() -> None:
    assert parse(canonical("On a motorway, we turn left at a junction, and a bus behind us brakes.")) is None
