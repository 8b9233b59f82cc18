"""What is said in another form than it is built in is built as what it says."""

from __future__ import annotations

import re
from typing import Any

import pytest

from chatscene.build.build import Built, build
from chatscene.build.restated import restated
from chatscene.errors import NotBuilt
from chatscene.search.rehearsal import unseen_at_first
from chatscene.situations.form import from_plain
from chatscene.terms.vocabulary import EgoRoute, Where


def one(kind: str, start: dict[str, Any] | str, *does: dict[str, Any] | str, **more: Any) -> dict[str, Any]:
    starts = {"where": start} if isinstance(start, str) else start
    deeds = [{"act": deed} if isinstance(deed, str) else deed for deed in does]
    return {"id": "A", "kind": kind, "starts": starts, "does": deeds} | more


def built(*others: dict[str, Any], **more: Any) -> Built:
    return build(from_plain({"others": list(others)} | more))


def test_a_speed_at_the_start_is_that_of_the_first_deed_which_keeps_it() -> None:
    walks = one("pedestrian", {"where": "ahead", "speed": "5 km/h"}, {"act": "go-along", "speed": "5 km/h"})
    rides = one("bicycle", {"where": "arm", "speed": "16 km/h"}, {"act": "go-straight", "speed": "16 km/h"})
    for said in (walks, rides):
        assert built(said).left_out == ()


def test_who_swerves_round_somebody_named_does_so_once_that_one_is_near() -> None:
    stands = one("debris", "ahead", "stand", id="B")
    swerves = one("car", "ahead", {"act": "swerve", "whom": "B"})
    assert "headway(egoRoute, self, B) <" in built(swerves, stands).program.source
    beside = one("car", {"where": "ahead-beside", "side": "left"}, {"act": "swerve", "whom": "B"})
    assert "until gap(self, B) <" in built(beside, stands | {"role": "supporting"}).program.source


def test_who_brakes_for_somebody_does_so_while_that_one_crosses() -> None:
    crosses = one("child", {"where": "roadside", "side": "right"}, "cross", id="B", role="supporting")
    brakes = one("car", "ahead", {"act": "brake", "whom": "B"})
    assert "until abs(offsetFrom(egoRoute, B)) < 2.4" in built(brakes, crosses).program.source


def test_for_whom_the_ego_brakes_is_left_to_its_driver_which_is_told() -> None:
    stands = one("car", "ahead", "stand")
    made = built(stands, ego={"does": [{"act": "brake", "whom": "A"}]})
    assert "the ego's brake for A is left to its driver" in made.assumed


@pytest.mark.parametrize("where", ["oncoming", "oncoming-in-our-lane"])
def test_who_comes_the_other_way_on_foot_walks_toward_the_ego(where: str) -> None:
    made = built(one("animal", where, "go-along", count=0))
    assert "directionOn(egoRoute, levelA, 3.14159)" in made.program.source


def test_an_ego_that_overtakes_goes_that_way_or_is_faster_than_who_is_beside_it() -> None:
    said = {"act": "overtake", "whom": "A"}
    ahead = from_plain({"ego": {"does": [said]}, "others": [one("tractor", "ahead", "go-along")]})
    assert restated(ahead).situation.ego.route is EgoRoute.OVERTAKE
    slow = one("bicycle", {"where": "ahead-beside", "side": "right", "speed": "18 km/h"}, "go-straight")
    ego = {"route": "right-turn", "does": [said]}
    assert built(slow, ego=ego).left_out == ()
    fast = one("car", {"where": "ahead-beside", "side": "left", "speed": "60 km/h"}, "go-along")
    with pytest.raises(NotBuilt, match="A is as fast as the ego"):
        built(fast, ego={"speed": "50 km/h", "does": [said]})


def test_what_is_chosen_for_who_was_said_in_another_form_is_told() -> None:
    walks = built(one("pedestrian", "oncoming", "go-along"))
    assert "A is beside the road, on the left" in walks.assumed
    crosses = built(one("pedestrian", {"where": "arm", "side": "left"}, "cross"))
    assert "A is at our road before the junction, which it crosses to meet us" in crosses.assumed
    slow = one("bicycle", "ahead", "go-along", id="B", role="supporting")
    assert "B is ahead of A, which hides it until it moves out" in built(one("car", "ahead", "cut-out"), slow).assumed


@pytest.mark.parametrize("act", ["swerve", "brake"])
def test_for_whom_a_deed_is_that_has_its_own_time_is_told_to_be_left_out(act: str) -> None:
    stands = one("car", "ahead", "stand", id="B", role="supporting")
    said = {"act": act, "whom": "B", "when": {"ego_within": "30 m"}}
    made = built(one("car", {"where": "ahead-beside", "side": "left"}, said), stands)
    assert f"A's {act} comes when it was said to and does not wait for B" in made.assumed


def test_who_crosses_at_a_side_road_that_the_ego_turns_into_is_at_its_crosswalk() -> None:
    said = from_plain(
        {"ego": {"route": "left-turn"}, "others": [one("child", {"where": "arm", "side": "left"}, "cross")]}
    )
    assert restated(said).situation["A"].starts.where is Where.EXIT_CROSSING


def test_who_goes_straight_on_is_so_long_before_where_it_meets_an_ego_at_the_junction() -> None:
    said = one("car", {"where": "oncoming", "speed": "60 km/h"}, {"act": "go-straight", "time": "2.2 s"})
    source = built(said, ego={"route": "left-turn", "speed": "20 km/h"}).program.source
    assert "OPT_A_OFFSET" not in source


def test_who_waits_until_another_has_gone_straight_on_waits_until_it_is_through() -> None:
    goes = one("car", {"where": "arm", "side": "right"}, "go-straight")
    turns = one("van", "oncoming", {"act": "turn-left", "when": {"after": "A.0"}}, id="B", role="supporting")
    source = built(goes, turns).program.source
    assert "until abs(offsetFrom(egoRoute, A)) < 2.4" in source
    assert "until abs(offsetFrom(egoRoute, A)) > 2.4" in source


def test_an_ego_that_stopped_goes_back_as_far_as_was_said() -> None:
    ego = {"speed": "25 km/h", "does": [{"act": "stop"}, {"act": "reverse", "distance": "15 m"}]}
    van = one("van", "oncoming-in-our-lane", "go-along")
    source = built(van, ego=ego).program.source
    assert "back=1.5" in source


@pytest.mark.parametrize(
    ("more", "told"),
    [
        ({"speed": "30 km/h"}, "ego.does.1.speed: 30 km/h: the ego cannot back up so fast; say 21 km/h at most"),
        ({"speed": "18 km/h", "distance": "2 m"}, "2 m is too short to back up at 18 km/h; say 5 m at least"),
    ],
)
def test_an_ego_that_cannot_go_back_so_is_refused(more: dict[str, str], told: str) -> None:
    van = one("van", "oncoming-in-our-lane", "go-along")
    with pytest.raises(NotBuilt, match=re.escape(told)):
        built(van, ego={"does": [{"act": "stop"}, {"act": "reverse", **more}]})


@pytest.mark.parametrize(("side", "aside"), [("left", "aside=1.7"), ("right", "aside=-1.7")])
def test_an_ego_drifts_to_the_side_of_its_lane_that_was_said(side: str, aside: str) -> None:
    drifts = {"act": "drift", "lateral": {"side": side}}
    assert aside in built(one("car", "oncoming", "go-along"), ego={"does": [drifts]}).program.source
    with pytest.raises(NotBuilt, match=r"ego\.does\.0\.lateral\.side"):
        other = {"left": "right", "right": "left"}[side]
        built(one("car", "oncoming", "go-along"), ego={"does": [drifts | {"to": other}]})


def test_who_is_to_be_in_the_way_soon_begins_at_the_edge_of_the_road() -> None:
    crosses = {"act": "cross", "when": {"ego_within": "40 m"}}
    said = one("pedestrian", {"where": "roadside", "side": "left"}, crosses)
    assert built(said, ego={"speed": "50 km/h"}).left_out == ()
    with pytest.raises(NotBuilt, match="by then we have passed"):
        soon = crosses | {"when": {"ego_within": "5 m"}}
        built(one("pedestrian", {"where": "roadside", "side": "left"}, soon), ego={"speed": "50 km/h"})


def test_who_stops_in_the_lane_that_the_ego_leaves_hides_who_crosses_before_it() -> None:
    hidden = one("pedestrian", "crossing", "cross", hidden_by="B")
    stops = one("car", "ahead", "slow-down", "stop", id="B", role="supporting")
    made = built(hidden, stops, ego={"route": "lane-change-left"}, road={"has": ["crosswalk"]})
    assert "wayB = ownLane(egoRoute)" in made.program.source


def test_who_comes_the_other_way_hides_who_comes_from_the_left_until_it_has_gone_by() -> None:
    start = {"where": "arm", "side": "left"}
    hidden = one("bicycle", start, {"act": "go-straight", "when": {"ego_within": "10 m"}}, hidden_by="B")
    bus = one("bus", "oncoming", "go-straight", id="B", role="hides")
    made = built(hidden, bus, ego={"speed": "45 km/h"})
    assert "A drives from the start, and B hides it until late" in made.assumed


def test_an_ego_that_drifts_leaves_its_line_by_what_an_overlap_with_who_comes_there_asks_for() -> None:
    drifts = {"act": "drift", "to": "left", "speed": "0.3 m/s", "lateral": {"overlap": "50 %"}}
    source = built(one("car", "oncoming", "go-along"), ego={"does": [drifts]}, road={"two_way": True}).program.source
    assert "aside=2.43" in source


def test_who_stands_ahead_and_is_met_at_a_point_of_the_front_stands_so_far_aside() -> None:
    stands = one("motorcycle", {"where": "ahead", "lateral": {"side": "left"}}, "stand")
    made = built(stands, contact={"ego": "front", "other": "rear", "striker": "ego", "at": "25 %"})
    assert ".offset(0.53" in made.program.source


def test_the_ego_can_be_level_with_who_pulls_out_of_a_bay_but_not_with_who_crosses() -> None:
    near = {"when": {"ego_within": "0 m"}}
    assert built(one("bus", "bus-bay", {"act": "pull-out"} | near)).left_out == ()
    with pytest.raises(NotBuilt, match="then it is too late"):
        built(one("child", {"where": "roadside", "side": "right"}, {"act": "cross"} | near))


def test_an_ego_that_sets_off_as_hard_as_was_said_gains_speed_so() -> None:
    does = [{"act": "stand"}, {"act": "set-off", "acceleration": "1.5 m/s²"}]
    assert built(one("car", {"where": "arm", "side": "left"}, "go-straight"), ego={"does": does}).left_out == ()


def test_who_is_beside_an_ego_that_is_to_overtake_it_is_slower_if_no_speed_was_said() -> None:
    said = {"ego": {"speed": "80 km/h", "does": [{"act": "overtake", "whom": "A"}]}}
    assert built(one("truck", {"where": "ahead-beside", "side": "right"}, "go-along"), **said).left_out == ()


def test_who_does_the_same_after_another_from_the_same_place_comes_right_behind_it() -> None:
    first = {
        "id": "B",
        "kind": "bicycle",
        "role": "hides",
        "starts": {"where": "arm"},
        "does": [{"act": "go-straight"}],
    }
    after = {"act": "go-straight", "when": {"after": "B.go-straight"}}
    second = {"id": "A", "kind": "bicycle", "starts": {"where": "arm"}, "does": [after, {"act": "stop"}]}
    said = from_plain({"ego": {"speed": "15 km/h"}, "road": {"kind": "junction"}, "others": [second, first]})
    made = build(said)
    assert "A comes right behind B" in made.assumed
    assert not unseen_at_first(made, said)


def test_who_waits_for_another_act_of_another_waits() -> None:
    first = {"id": "B", "kind": "car", "role": "supporting", "starts": {"where": "arm"}, "does": [{"act": "turn-left"}]}
    after = {"act": "go-straight", "when": {"after": "B.turn-left"}}
    second = {"id": "A", "kind": "bicycle", "starts": {"where": "arm"}, "does": [after]}
    said = from_plain({"road": {"kind": "junction"}, "others": [second, first]})
    assert restated(said).situation.others[0].does[0].when is not None
