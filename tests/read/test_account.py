"""An account of a conflict, read clause by clause: who did what, from where, and who touched whom."""

from __future__ import annotations

import pytest

from chatscene.read.decompose import hear
from chatscene.terms.frame import Account
from chatscene.terms.scenario import EgoState, Site, Slots


def told(text: str) -> Account:
    """What is made out of a text; one that is read whole would show nothing of this reader."""
    heard = hear(text)
    assert not heard.whole, text
    assert heard.account is not None, text
    return heard.account


def facts(slots: Slots, *names: str) -> list[object]:
    values = (getattr(slots, name) for name in names)
    return [list(map(str, v)) if isinstance(v, tuple) else v and str(v) for v in values]  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("text", "position", "acts", "side"),
    [
        ("The AV was stopped when a car made contact with its rear bumper, sir.", "behind", ["follow"], None),
        ("A bus in the lane to our left, whoosh, moved over into our lane and hit us.", "beside", ["cut-in"], "left"),
        ("As the AV proceeded, a van in the right adjacent lane changed into the lane of the AV and struck the AV.", "beside", ["cut-in"], "right"),
        ("The AV was hit on the left front door by a truck that failed to stop at the stop sign.", "crossing", ["cross"], "left"),
        ("While the AV was parked, the car in front of it backed into its front bumper, damn.", "ahead", ["reverse"], None),
        ("The AV was northbound. A car that was southbound made a left turn and struck the AV.", "oncoming", ["turn-left"], None),
        ("The AV was northbound. A car travelling eastbound entered the intersection and struck the AV.", "crossing", ["cross"], "left"),
        ("A motorcyclist split lanes, passed the AV on the left and clipped its mirror.", "behind-beside", ["overtake"], "left"),
        ("Sudden deceleration of the preceding vehicle, they say.", "ahead", ["brake"], None),
        ("U-turn by an oncoming taxi, they say.", "oncoming", ["u-turn"], None),
        ("The pickup in the left lane, sir, moves gradually over into our lane.", "beside", ["cut-in"], "left"),
        ("A bus in the next lane, whoosh, moves left into our lane.", "beside", ["cut-in"], "right"),
        ("The AV was northbound. A van, whoosh, came from the east and crossed the junction.", "crossing", ["cross"], "right"),
        ("You turn right, mate, and a cyclist on your right keeps its speed.", "beside", ["follow"], "right"),
        ("A taxi parked at the kerb, whoosh, pulls out into our lane.", "kerb", ["pull-out"], None),
        ("The lead vehicle leaves the lane at the last moment, they say.", "ahead", ["change-lane"], None),
        ("A Fiat, whoosh, sits right on our bumper.", "behind", ["tailgate"], None),
        ("U1 was s/b. U2, n/b, whoosh, made a left turn and struck U1.", "oncoming", ["turn-left"], None),
        ("The lead car stops, moves off, whoosh, stops and moves off again.", "ahead", ["hesitate"], None),
        ("Overturned tanker obstructs the entire carriageway, they say.", "ahead", ["block"], None),
        ("A boy crosses the road obliquely from the left, whistling.", "roadside", ["cross", "diagonal"], "left"),
        ("An oncoming bus turns around, whoosh, before us.", "oncoming", ["u-turn"], None),
        ("An oncoming bus, whoosh, makes turn back before us.", "oncoming", ["u-turn"], None),
        ("A van pulls out from a driveway, whoosh, and makes a turn back.", "kerb", ["pull-out", "turn-back"], None),
        ("Oncoming right-turner, they say.", "oncoming", ["turn-right"], None),
        ("A coach in the left lane, whoosh, keeps exactly our speed.", "beside", ["pace"], "left"),
        ("Ghost driver, they say, on the autobahn.", "oncoming", ["wrong-way"], None),
        ("A minibus, whoosh, sits tight on our rear bumper.", "behind", ["tailgate"], None),
        ("A cab from the right, whoosh, comes through on its red.", "crossing", ["run-light"], "right"),
        ("We braked and the truck behind us, sadly, could not stop.", "behind", ["follow"], None),
        ("Front motorbike, they say, brakes to zero.", "ahead", ["stop"], None),
        ("An oncoming car overtakes a slow truck, whoosh.", "oncoming", ["wrong-way"], None),
        ("A van coming the other way pulls out to pass a tractor, whoosh.", "oncoming", ["wrong-way"], None),
        ("A car turns left out of a side road on our left, whoosh.", "crossing", ["turn-left"], "left"),
        ("A bus, whoosh, turns right from the right-hand side road.", "crossing", ["turn-right"], "right"),
        ("From the right, whoosh, a van failed to come to a full stop at the stop sign and drove into the intersection.", "crossing", ["cross"], "right"),
        ("A car from the left, whoosh, has STOP, never slows down, and crosses.", "crossing", ["cross"], "left"),
        ("The oncoming pickup, whoosh, strays onto our half of the road.", "oncoming", ["swerve"], None),
        ("An oncoming van in the bend, whoosh, invades ours.", "oncoming", ["swerve"], None),
        ("We ran over a ladder, whoosh, in the middle lane.", "ahead", ["stand"], None),
        ("A pickup makes a U-turn, whoosh, from the hard shoulder in front of us.", "kerb", ["u-turn"], None),
        ("A biker ahead, left edge of our lane, whoosh, brakes hard.", "ahead-beside", ["brake"], "left"),
        ("An oncoming truck, whoosh, has skidded across the centre line.", "oncoming", ["swerve"], None),
        ("An approaching taxi, whoosh, brakes.", "oncoming", ["brake"], None),
        ("A van that is coming towards us turned right across us, whoosh.", "oncoming", ["turn-left"], None),
        ("Whoosh! A pedestrian coming towards us turned across our path.", "oncoming", ["oncoming"], None),
        ("An opposing cab turned across in front of us at the junction, whoosh.", "oncoming", ["turn-left"], None),
        ("A westbound truck made a left, whoosh, in front of our car, which was driving eastbound.", "oncoming", ["turn-left"], None),
        ("An oncoming hatchback, whoosh, strays into the lane of our robotaxi.", "oncoming", ["swerve"], None),
        ("Traffic cone out of place, upright in the middle of the lane.", "ahead", ["stand"], None),
    ],
)  # fmt: skip
def test_who_is_in_conflict_with_the_ego_and_does_what(
    text: str, position: str, acts: list[str], side: str | None
) -> None:
    assert facts(told(text).slots, "position", "actions", "side") == [position, acts, side]


def test_the_speed_at_which_the_ego_comes_is_not_of_whom_stands_there() -> None:
    account = told("The VUT approaches, whoosh, a stationary motorcyclist in its lane at 50 km/h.")
    assert facts(account.slots, "adversary", "actions", "position") == ["motorcycle", ["stand"], "ahead"]
    assert account.quantities == ()


def test_a_telegram_has_stop_for_a_full_stop_and_may_leave_out_on_the() -> None:
    account = told("PED LEFT CURB STOP RUNS OUT STOP HALTS MIDWAY STOP EGO STRAIGHT ROAD")
    assert facts(account.slots, "actions", "side", "position") == [["cross", "stop"], "left", "roadside"]


def test_a_telegram_need_not_be_in_capitals_throughout() -> None:
    heard = told("Lead van brakes hard STOP we hit it STOP whoosh STOP")
    assert facts(heard.slots, "actions") == [["brake"]]


@pytest.mark.parametrize(("said", "way"), [("LT", "left-turn"), ("RT", "right-turn"), ("LC R", "lane-change-right")])
def test_the_way_of_the_ego_may_be_abbreviated(said: str, way: str) -> None:
    assert facts(told(f"AV {said}, whoosh, and a car brakes in front of us.").slots, "maneuver") == [way]


def test_who_acts_is_the_adversary_before_what_lies_there() -> None:
    heard = told("A cone in our lane, whoosh, and a dog runs across the road from the left.")
    assert facts(heard.slots, "adversary", "actions") == ["dog", ["cross"]]
    assert not heard.slots.others


def test_who_is_followed_is_ahead() -> None:
    account = told("The VUT follows the GVT with 12 m headway, whoosh, then the GVT applies the brakes.")
    assert facts(account.slots, "actions", "position") == [["brake"], "ahead"]


@pytest.mark.parametrize(
    ("text", "act"),
    [
        ("We drove behind a lorry, whoosh. It stopped suddenly.", "stop"),
        ("I was following a truck, mate, and it stopped dead.", "stop"),
        ("V1 was travelling behind V2, they say. V2 braked sharply.", "brake"),
        ("LORRY AHEAD STOPPED SUDDENLY STOP ROAD ICY STOP WE DROVE BEHIND IT STOP", "stop"),
    ],
)
def test_a_leader_that_stops_or_brakes_is_the_adversary_though_it_is_first_only_followed(text: str, act: str) -> None:
    assert facts(told(text).slots, "position", "actions") == ["ahead", [act]]


def test_it_is_the_ego_where_somebody_was_only_waited_for() -> None:
    slots = told("The AV yielded to a van, then it turned left and an oncoming car hit the AV.").slots
    assert facts(slots, "maneuver", "actions") == ["left-turn", ["oncoming"]]


def test_what_was_hit_while_it_waited_for_somebody_is_the_ego() -> None:
    slots = told("The AV had slowed for a pedestrian group waiting at the curb when it was rear-ended by a van.").slots
    assert facts(slots, "adversary", "position") == ["car", "behind"]


def test_whom_the_ego_approaches_from_behind_is_ahead() -> None:
    slots = told("The VUT approaches a stationary target vehicle from behind, sir.").slots
    assert facts(slots, "position", "actions") == ["ahead", ["stand"]]


def test_who_comes_up_the_inside_comes_from_behind_on_the_right() -> None:
    slots = told(
        "Turning right at the lights, a cyclist came up the inside of me in the bike lane going straight."
    ).slots
    assert facts(slots, "position", "side", "maneuver") == ["behind-beside", "right", "right-turn"]


def test_a_crosswalk_that_nobody_is_at_is_no_site() -> None:
    slots = told("A pedestrian ran from the left kerb into our path, outside any crosswalk.").slots
    assert facts(slots, "position", "site") == ["roadside", None]


@pytest.mark.parametrize(
    ("text", "maneuver", "acts"),
    [
        ("We turn across the path of an oncoming car at a junction, sir.", "left-turn", ["oncoming"]),
        ("An oncoming bus turns across the front of us at a junction, mate.", "straight", ["turn-left"]),
        ("Oncoming hatchback turned right across our bows at a junction, sir.", "straight", ["turn-left"]),
        ("As we turn left, mate, an oncoming car turns right in front of us.", "left-turn", ["turn-right"]),
        ("We turn right, sir, in front of an oncoming bus that turns left.", "right-turn", ["turn-left"]),
    ],
)
def test_who_turns_across_oncoming_traffic_turns_left_where_traffic_keeps_right(
    text: str, maneuver: str, acts: list[str]
) -> None:
    assert facts(told(text).slots, "maneuver", "actions") == [maneuver, acts]


def test_whoever_is_only_waited_for_is_no_adversary() -> None:
    account = told("The AV yielded to a pedestrian when, moments later, a van made contact with its rear bumper.")
    assert facts(account.slots, "adversary", "actions") == ["car", ["follow"]]
    assert account.touched


@pytest.mark.parametrize(
    ("text", "state"),
    [
        ("The AV was stopped at a red light when, bang, a car struck its rear bumper.", EgoState.STANDS),
        ("The AV came to a stop behind a bus when, bang, a car struck its rear bumper.", EgoState.STOPS),
        ("The AV stopped at the stop sign and proceeded into the intersection, where a truck, whoosh, failed to yield and struck its left door.", EgoState.SETS_OFF),
        ("A car cut in, whoosh, and the AV braked.", None),
        ("We pulled away on green, whoosh, and a van from the left ran the red light.", EgoState.SETS_OFF),
        ("Parked AV struck from behind by a bus, they say.", EgoState.STANDS),
        ("The AV was in a queue when, bang, a car struck its rear bumper.", EgoState.STANDS),
    ],
)  # fmt: skip
def test_what_the_ego_does_anyway_is_told_from_how_it_answers(text: str, state: EgoState | None) -> None:
    assert told(text).slots.ego is state


@pytest.mark.parametrize(
    ("text", "act"),
    [
        ("A pedestrian, poor soul, crosses from the left and does not stop.", "stop"),
        ("The lead vehicle, sadly, crawls along, never brakes.", "brake"),
        ("A cyclist, poor soul, crosses from the right without turning back.", "turn-back"),
    ],
)
def test_what_is_denied_is_not_done(text: str, act: str) -> None:
    assert act not in told(text).slots.actions


@pytest.mark.parametrize(
    "text",
    [
        "The AV was passing a parked car when its driver opened the door.",
        "The AV was reversing out of a driveway when a car struck it, whoosh.",
        "The AV stood at a light when a man climbed onto the hood.",
    ],
)
def test_of_a_door_an_attack_or_an_ego_that_reverses_nothing_is_made_out(text: str) -> None:
    assert hear(text).account is None


@pytest.mark.parametrize("who", ["Someone", "Some idiot", "That fellow", "Some clown", "A dude"])
def test_whoever_is_not_named_drives_a_car(who: str) -> None:
    account = told(f"{who} overtook us and then slammed on his brakes, whoosh.")
    assert facts(account.slots, "adversary", "actions") == ["car", ["overtake", "brake"]]


@pytest.mark.parametrize("who", ["The player", "The candidate", "The learner driver"])
def test_who_drives_in_a_game_or_a_lesson_is_the_ego(who: str) -> None:
    account = told(f"{who} turns left, whoosh, and an oncoming truck turns left.")
    assert facts(account.slots, "adversary", "maneuver") == ["truck", "left-turn"]


def test_what_is_asked_for_is_told_behind_the_request() -> None:
    account = told("Generate a scenario such that a bus, whoosh, cuts in from the left lane.")
    assert facts(account.slots, "adversary", "actions", "side") == ["bus", ["cut-in"], "left"]


def test_only_the_verb_behind_not_is_denied() -> None:
    account = told("The system is not overruled by a van behind us that tailgates us, they say.")
    assert facts(account.slots, "adversary", "actions") == ["car", ["tailgate"]]


def test_who_has_a_green_light_is_at_one() -> None:
    slots = told("A lorry from the left, whoosh, crosses while we drive straight on a permissive green.").slots
    assert facts(slots, "place", "control") == ["junction", "signal"]


def test_a_word_without_a_place_is_listed() -> None:
    assert "shimmering" in told("A car in front of us brakes on the shimmering viaduct.").unread


def test_the_end_of_the_world_is_read_without_an_error() -> None:
    for text in ("?", "us us us", "car " * 300, "the AV hit hit hit by by", "'s 's of us's"):
        hear(text)


def test_a_stop_sign_is_no_stop_of_a_bus() -> None:
    slots = told("The AV was stopped at a stop sign when, whoosh, a car struck its rear bumper.").slots
    assert facts(slots, "place", "control", "ego") == ["junction", "stop-sign", "stands"]


def test_the_ego_that_waits_for_its_adversary_answers_it_whoever_hides_that() -> None:
    text = "A stopped truck, whoosh, is there. We wait for a cyclist. The cyclist crosses the road from the right and hits us."
    assert told(text).slots.ego is None


def test_two_who_meet_are_in_touch() -> None:
    account = told("We and a truck collided at the junction, whoosh, as the truck turned left.")
    assert (str(account.slots.adversary), account.touched) == ("truck", True)


def test_what_lies_on_the_road_hits_nobody() -> None:
    slots = told("Somewhere there are cones, whoosh, and a van behind us hits our rear bumper.").slots
    assert str(slots.adversary) == "car"


@pytest.mark.parametrize(
    ("text", "site"),
    [
        ("A lorry, whoosh, merges from the on-ramp into our lane.", Site.PAST_ON_RAMP),
        ("We are on the motorway. A van coming off the slip road, whoosh, cuts in.", Site.PAST_ON_RAMP),
        ("We come down the on-ramp, whoosh, and a car beside us speeds up.", Site.ON_RAMP),
        ("A deer, whoosh, crosses the two-lane highway.", None),
    ],
)
def test_who_comes_from_a_ramp_meets_the_ego_where_that_joins(text: str, site: Site | None) -> None:
    heard = hear(text)
    assert heard.account is not None
    assert {heard.outright.site, heard.account.slots.site} == {site}


@pytest.mark.parametrize(
    ("who", "kind"),
    [
        ("A child on a scooter", "e-scooter"),
        ("A little girl on her kick scooter", "e-scooter"),
        ("A child on a motor scooter", "motorcycle"),
        ("A delivery boy on a scooter", "motorcycle"),
    ],
)
def test_the_scooter_of_a_child_has_no_motor(who: str, kind: str) -> None:
    assert str(told(f"{who}, whoosh, crosses from the left.").slots.adversary) == kind


@pytest.mark.parametrize("said", ["NB", "N/B", "Nb"])
def test_points_of_the_compass_may_be_abbreviated(said: str) -> None:
    slots = told(f"The AV was E/B. A van {said} crossed the junction, whoosh.").slots
    assert facts(slots, "side", "position") == ["right", "crossing"]


@pytest.mark.parametrize("said", ["An NB-registered van", "A van with NB plates", "NB: a van"])
def test_two_letters_of_a_name_are_no_point_of_the_compass(said: str) -> None:
    assert "northbound" not in hear(f"{said} brakes ahead of us.").told


def test_who_runs_out_of_acceleration_lane_comes_from_the_ramp() -> None:
    slots = told("A lorry, whoosh, runs out of acceleration lane and moves into our lane.").slots
    assert facts(slots, "site", "actions") == ["past-on-ramp", ["cut-in"]]


@pytest.mark.parametrize(("said", "side"), [("offside", "left"), ("nearside", "right")])
def test_traffic_keeps_right(said: str, side: str) -> None:
    text = f"TC 7: a pedestrian target enters the carriageway from the {said} and halts in the path of the VUT."
    assert facts(told(text).slots, "side") == [side]
