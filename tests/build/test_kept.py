"""Room that the ego was said to keep, rights of way without a junction, turning round in three, and manners."""

from __future__ import annotations

import numpy as np
import pytest
from test_building import drive
from test_contacts import driven
from test_towards import car, deed, others, track

from chatscene.build.build import build
from chatscene.errors import NotBuilt
from chatscene.situations.form import from_plain
from chatscene.terms.episode import Episode

SEEDS = (0, 1)


def test_whom_the_ego_follows_begins_as_far_ahead_as_it_was_said_to_keep() -> None:
    for said, least, most in (({"distance": "20 m"}, 19.5, 20.5), ({"time": "1.2 s"}, 16.1, 17.2)):
        ego = {"speed": "50 km/h", "does": [{"act": "follow", "whom": "A", **said}]}
        made = others(car("A", "ahead", deed("brake")), ego=ego)
        assert not build(made).left_out
        episode = driven(made, 0)
        leader = track(episode, "A")
        gap = np.hypot(leader.x[0] - episode.ego_track.x[0], leader.y[0] - episode.ego_track.y[0])
        assert least < gap - 0.5 * (leader.length + episode.ego_track.length) < most


def test_who_is_passed_is_as_far_aside_as_it_was_said_that_the_ego_passes() -> None:
    parked = car("B", "kerb", deed("stand"), kind="truck", side="right") | {"role": "hides"}
    walks = {"id": "A", "kind": "pedestrian", "starts": {"where": "roadside", "side": "right"}, "hidden_by": "B"}
    ego = {"speed": "30 km/h", "does": [{"act": "go-along", "lateral": {"clearance": "1 m"}}]}
    said = from_plain({"ego": ego, "others": [walks | {"does": [deed("cross")]}, parked]})
    assert not build(said).left_out
    driven(said, 0)


@pytest.mark.parametrize("where", ["oncoming-in-our-lane", "behind"])
def test_right_of_way_is_not_given_where_no_junction_is(where: str) -> None:
    passes = deed("overtake", to="left") if where == "behind" else deed("go-along")
    goes = deed("go-along") | {"breaks": "right-of-way"}
    assert not build(others(car("A", where, passes, goes))).left_out


@pytest.mark.parametrize(("kind", "backs"), [("car", False), ("van", True)])
def test_who_finds_too_little_road_to_turn_round_in_one_go_backs_in_between(kind: str, backs: bool) -> None:
    said = others(car("A", "ahead", deed("u-turn"), kind=kind), road={"two_way": True, "lanes": 1}, map="town")
    made = build(said)
    assert ("ReverseStraight" in made.program.source) is backs
    episode = drive(made, seed=1)
    assert isinstance(episode, Episode)
    assert np.ptp(track(episode, "A").heading) > 1.2


def test_there_is_as_much_road_to_turn_round_before_an_ego_that_swings_out() -> None:
    one = car("A", "ahead", deed("stand"), deed("u-turn"))
    assert build(others(one, ego={"route": "bypass"}, road={"two_way": True}))


def test_a_little_is_less_than_is_usual() -> None:
    def ends(**manner: str) -> dict[str, tuple[float, float]]:
        made = build(others(car("A", "ahead-beside", deed("drift", **manner), side="left")))
        return {one.name: (one.low, one.high) for one in made.program.parameters if "DRIFT" in one.name}

    (usual,), (slight,) = ends().values(), ends(manner="slight").values()
    assert usual[0] == slight[0] and slight[1] < usual[1]


@pytest.mark.parametrize("manner", ["hard", "sudden"])
def test_an_ego_that_brakes_hard_has_the_firm_brake(manner: str) -> None:
    said = others(car("A", "behind", deed("go-along")), ego={"does": [{"act": "stop", "manner": manner}]})
    made = build(said)
    assert not made.left_out
    assert "braking=6" in made.program.source or "braking=7" in made.program.source


def test_nobody_comes_up_where_there_is_no_lane_on_that_side_of_the_ego() -> None:
    passes = car("A", "behind-beside", deed("go-along"), deed("keep-level"), side="right")
    with pytest.raises(NotBuilt, match="needs a lane to the right of ours"):
        build(others(passes, ego={"route": "enter-driveway", "does": [{"act": "lane-change", "to": "left"}]}))
