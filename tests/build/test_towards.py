"""Deeds begun during another, done to somebody named, from behind, at a slant, or with room that is left."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from test_building import drive, simulator
from test_in_time import deed, somebody, unseen

from chatscene.build.build import build
from chatscene.build.possible import impossible
from chatscene.errors import NotBuilt
from chatscene.measure.tyres import beyond_tyres
from chatscene.program.judge import failures, judge
from chatscene.situations.form import from_plain
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.episode import Episode, Track
from chatscene.terms.situation import Situation

SEEDS = range(3)


def others(*all_of_them: dict[str, Any], **more: Any) -> Situation:
    first, *rest = all_of_them
    return from_plain({"others": [first, *({"role": "supporting"} | one for one in rest)], **more})


def car(name: str, where: str, *does: dict[str, Any], kind: str = "car", **start: Any) -> dict[str, Any]:
    return {"id": name, "kind": kind, "starts": {"where": where, **start}, "does": list(does)}


def driven(said: Situation, seed: int = 1) -> Episode:
    episode = drive(build(said), seed=seed)
    assert isinstance(episode, Episode), episode
    return episode


def track(episode: Episode, name: str = "A") -> Track:
    return next(one for one in episode.tracks if one.actor == name)


DURING = {
    "a deed of its own": somebody(
        "pedestrian", "roadside", deed("cross"), deed("hesitate") | {"when": {"during": "A.0"}}
    ),
    "the ego slows down": others(
        car("A", "behind", deed("accelerate") | {"when": {"during": "ego.0"}}), ego={"does": [{"act": "slow-down"}]}
    ),
    "another overtakes": others(
        car("A", "ahead", deed("brake") | {"when": {"during": "B.0"}}), car("B", "behind", deed("overtake"))
    ),
    "another leaves the lane": others(
        car("A", "ahead", deed("brake") | {"when": {"after": "B.0"}}), car("B", "ahead", deed("cut-out", to="left"))
    ),
    "another tailgates": others(
        car("A", "ahead", deed("brake") | {"when": {"during": "B.0"}}), car("B", "behind", deed("tailgate"))
    ),
}


@pytest.mark.parametrize("what", DURING)
def test_a_deed_is_begun_while_another_is_under_way(what: str) -> None:
    assert unseen(DURING[what]) == ()


def test_a_deed_that_waits_for_what_nobody_sees_is_refused() -> None:
    waits = car("A", "ahead", deed("brake") | {"when": {"after": "B.1"}})
    with pytest.raises(NotBuilt, match=r"does\.0\.when\.after: B\.1: it cannot be seen when turn-back happens"):
        build(others(waits, car("B", "driveway", deed("enter"), deed("turn-back"), side="right")))


WHOM = {
    "follows": others(
        car("A", "ahead", deed("follow", whom="B", distance="10 m")),
        car("B", "ahead", deed("brake")),
    ),
    "tailgates": others(car("A", "ahead", deed("tailgate", whom="B")), car("B", "ahead", deed("go-along"))),
    "overtakes": others(
        car("A", "ahead", deed("overtake", whom="B")), car("B", "ahead", deed("go-along"), kind="bicycle")
    ),
    "overtakes, coming toward us": others(
        car("A", "oncoming", deed("overtake", whom="B")), car("B", "oncoming", deed("go-along"), kind="truck")
    ),
    "cuts in before": others(car("A", "ahead-beside", deed("cut-in", whom="B")), car("B", "ahead", deed("brake"))),
    "yields to": others(
        car("A", "arm", deed("yield", whom="B"), deed("go-straight"), side="right"),
        car("B", "arm", deed("go-straight"), side="left"),
        road={"kind": "junction"},
    ),
}


@pytest.mark.parametrize("what", WHOM)
def test_a_deed_is_done_to_somebody_else_than_the_ego(what: str) -> None:
    said = WHOM[what]
    assert all(unseen(said, seed) == () for seed in SEEDS)


def test_who_follows_another_stands_behind_it_in_whatever_order_they_are_named() -> None:
    leader, follower = car("B", "ahead", deed("brake")), car("A", "ahead", deed("follow", whom="B"))
    for order in ((leader, follower), (follower, leader)):
        episode = driven(others(*order))
        ego = episode.ego_track
        ahead = {one.actor: np.hypot(one.x[0] - ego.x[0], one.y[0] - ego.y[0]) for one in episode.tracks}
        assert ahead["A"] < ahead["B"]


def test_whom_the_ego_follows_is_as_far_ahead_as_was_said() -> None:
    said = others(car("A", "ahead", deed("brake")), ego={"does": [{"act": "follow", "whom": "A", "distance": "21 m"}]})
    episode = driven(said)
    there, ego = track(episode), episode.ego_track
    assert np.hypot(there.x[0] - ego.x[0], there.y[0] - ego.y[0]) == pytest.approx(21.0 + LONG, abs=0.5)


LONG = AdversaryKind.CAR.row.limits.length  # [m], of two cars from the middle of one to that of the other, at no gap

FROM_BEHIND = {
    "lane-change, overtake": somebody("car", "behind", deed("lane-change", to="left"), deed("overtake")),
    "lane-change, cut-in": somebody("car", "behind", deed("lane-change", to="left"), deed("cut-in")),
    "lane-change, turn": from_plain(
        {
            "road": {"kind": "junction"},
            "others": [car("A", "behind", deed("lane-change", to="left"), deed("turn-right"))],
        }
    ),
    "turn ahead": from_plain({"road": {"kind": "junction"}, "others": [car("A", "ahead", deed("turn-left"))]}),
    "turn off the road": from_plain({"road": {"kind": "road"}, "others": [car("A", "ahead", deed("turn-right"))]}),
    "on the right of who turns": somebody("motorcycle", "behind-beside", deed("overtake"), ego={"route": "right-turn"}),
    "past who stands": somebody("car", "behind", deed("overtake"), ego={"does": [{"act": "stand"}]}),
    "past who is slow": somebody(
        "car", "behind", deed("overtake"), ego={"does": [{"act": "go-along", "manner": "slow"}]}
    ),
    "from beside": somebody("car", "beside", deed("overtake")),
    "back to who stands": somebody("car", "ahead", deed("stand"), deed("reverse"), ego={"does": [{"act": "stand"}]}),
    "out of a driveway": somebody("car", "driveway", deed("reverse")),
}


@pytest.mark.parametrize("what", FROM_BEHIND)
def test_who_comes_from_behind_or_turns_off_ahead_is_seen_to(what: str) -> None:
    assert all(unseen(FROM_BEHIND[what], seed) == () for seed in SEEDS)


@pytest.mark.parametrize(("said", "metres"), [("distance", "8 m"), ("time", "1 s")])
def test_who_cuts_in_leaves_the_room_that_was_said(said: str, metres: str) -> None:
    one = somebody("car", "ahead-beside", deed("cut-in") | {said: metres}, ego={"speed": "28.8 km/h"})
    for seed in SEEDS:
        episode = driven(one, seed)
        seen = track(episode)
        ego = episode.ego_track
        aside = np.abs(np.sin(ego.heading[0]) * (seen.x - ego.x) - np.cos(ego.heading[0]) * (seen.y - ego.y))
        there = int(np.argmax(aside < 1.3))
        gap = np.hypot(seen.x[there] - ego.x[there], seen.y[there] - ego.y[there]) - (seen.length + ego.length) / 2
        assert gap == pytest.approx(8.0, abs=2.0)


@pytest.mark.parametrize("way", ["1 m", "4 m"])
def test_who_backs_up_covers_the_way_that_was_said(way: str) -> None:
    speed = track(driven(somebody("car", "ahead", deed("reverse", distance=way)))).speed
    assert -speed[speed < 0].sum() * 0.1 == pytest.approx(float(way.split(maxsplit=1)[0]), abs=0.6)


@pytest.mark.parametrize("where", ["driveway", "kerb", "ahead"])
@pytest.mark.parametrize("act", ["stop", "brake"])
def test_who_backs_and_then_stops_does_not_set_off_forwards_for_that(where: str, act: str) -> None:
    said = somebody("car", where, deed("stand"), deed("reverse"), deed(act))
    assert unseen(said) == ()
    assert track(driven(said)).speed.max() < 0.1


def test_who_brakes_to_a_speed_goes_on_at_it() -> None:
    speed = track(driven(somebody("car", "ahead", deed("brake", speed="10 km/h")))).speed
    assert speed[-1] == pytest.approx(10 / 3.6, abs=0.3)
    assert np.diff(speed).min() < -0.25


def test_the_ego_brakes_after_the_time_that_it_goes_along() -> None:
    does = [{"act": "go-along", "time": "3 s"}, {"act": "brake", "acceleration": "4 m/s²"}]
    speed = driven(somebody("car", "behind", deed("tailgate"), ego={"does": does})).ego_track.speed
    assert speed[:28].min() > 0.9 * speed[0]
    assert speed[:50].min() < 0.6 * speed[0]


@pytest.mark.parametrize("kind", ["pedestrian", "bicycle"])
@pytest.mark.parametrize("side", ["left", "right"])
def test_who_crosses_at_a_slant_goes_forward_as_well_as_across(kind: str, side: str) -> None:
    start = {"where": "driveway", "side": side}
    said = from_plain(
        {"others": [{"id": "A", "kind": kind, "starts": start, "does": [deed("cross", manner="slanting")]}]}
    )
    assert build(said).left_out == ()
    episode = driven(said)
    ego, there = episode.ego_track, track(episode)
    forward = np.cos(ego.heading[0]) * (there.x[-1] - there.x[0]) + np.sin(ego.heading[0]) * (there.y[-1] - there.y[0])
    assert forward > 0.4 * np.hypot(there.x[-1] - there.x[0], there.y[-1] - there.y[0])


def test_who_was_said_to_cross_at_a_slant_and_goes_straight_over_is_not_as_said() -> None:
    straight, slanting = (
        somebody("pedestrian", "roadside", deed("cross", **more)) for more in ({}, {"manner": "slanting"})
    )
    made = build(straight)
    episode = drive(made)
    assert isinstance(episode, Episode)
    route = simulator(made.map, "native").route(made.program, 0)
    assert "others.A.does.0.manner: said slanting, it goes straight over" in failures(judge(slanting, episode, route))


@pytest.mark.parametrize("count", [0, 2])
def test_several_who_hide_somebody_stand_before_and_behind_it(count: int) -> None:
    child = car("A", "roadside", deed("cross"), kind="child", side="right") | {"hidden_by": "B"}
    row = car("B", "kerb", deed("stand"), side="right") | {"count": count, "role": "hides"}
    said = others(child, row)
    assert unseen(said) == ()
    episode = driven(said)
    ego = episode.ego_track.heading[0]
    along = {one.actor: one.x[0] * np.cos(ego) + one.y[0] * np.sin(ego) for one in episode.tracks}
    assert len(along) == (count or 3) + 2
    assert along["B"] < along["A"] < along["B-2"]


def behind_a_leader(leader: str, stands: str) -> Situation:
    van = car(
        "L",
        "ahead",
        deed("go-along"),
        deed("cut-out", to="left"),
        kind="van",
        **({"distance": leader} if leader else {}),
    )
    still = car("S", "ahead", deed("stand"), **({"distance": stands} if stands else {})) | {"hidden_by": "L"}
    return others(still, van, ego={"speed": "60 km/h"}, road={"kind": "motorway"})


@pytest.mark.parametrize(("leader", "stands"), [("25 m", "100 m"), ("25 m", ""), ("70 m", ""), ("", "")])
def test_a_leader_hides_who_stands_ahead_of_it(leader: str, stands: str) -> None:
    said = behind_a_leader(leader, stands)
    episode = driven(said)
    route = simulator(build(said).map, "native").route(build(said).program, 0)
    assert not [one for one in failures(judge(said, episode, route)) if "hidden_by" in one or "starts" in one]
    away = {
        one.actor: np.hypot(one.x[0] - episode.ego_track.x[0], one.y[0] - episode.ego_track.y[0])
        for one in episode.tracks
    }
    assert away["L"] + 5 < away["S"]


def test_a_leader_farther_away_than_whom_it_hides_is_refused_with_what_can_be() -> None:
    with pytest.raises(
        NotBuilt, match=r"others\.S\.hidden_by: L is not nearer than S, which would have to be \d+ m ahead"
    ):
        build(behind_a_leader("60 m", "40 m"))


@pytest.mark.parametrize(("lanes", "told"), [(2, "the road has 3 lanes in the ego's direction, since"), (3, "")])
def test_a_motorway_has_as_many_lanes_as_were_said_or_more_which_is_told(lanes: int, told: str) -> None:
    road = {"kind": "motorway", "lanes": lanes, "ego_lane": 1}
    made = build(others(car("A", "ahead", deed("cut-out", to="left")), ego={"speed": "80 km/h"}, road=road))
    assert [one for one in made.assumed if "lanes" in one][:1] == [one for one in made.assumed if told and told in one]
    assert not made.left_out


@pytest.mark.parametrize(
    ("where", "facing", "turned"), [("ahead", "across", 90), ("kerb", "against", 180), ("kerb", "along", 0)]
)
def test_who_stands_faces_as_was_said(where: str, facing: str, turned: float) -> None:
    side = {"side": "right"} if where == "kerb" else {}
    episode = driven(others(car("A", where, deed("stand"), facing=facing, **side)))
    away = abs(np.degrees(track(episode).heading[0] - episode.ego_track.heading[0]) + 180) % 360 - 180
    assert abs(away) == pytest.approx(turned, abs=8)


def test_a_door_that_does_not_reach_our_lane_is_refused() -> None:
    for side, to in (("left", "right"), ("right", "right")):
        said = others(car("A", "kerb", deed("stand"), deed("open-door", to=to), side=side))
        assert not tuple(impossible(said))
        with pytest.raises(NotBuilt, match=r"open-door, except by|opens away from our lane"):
            build(said)


def test_a_bus_nearer_than_any_bay_is_refused() -> None:
    with pytest.raises(NotBuilt, match="in the bay it is"):
        build(others(car("A", "bus-bay", deed("stand"), deed("pull-out"), kind="bus", distance="5 m")))


@pytest.mark.parametrize("facing", ["along", "against"])
@pytest.mark.parametrize("does", [("cross",), ("go-along", "cross")])
def test_who_faces_along_the_road_turns_to_cross_it(facing: str, does: tuple[str, ...]) -> None:
    start = {"where": "roadside", "side": "left", "facing": facing}
    one = {"id": "A", "kind": "pedestrian", "starts": start, "does": [deed(act) for act in does]}
    assert unseen(others(one)) == ()


@pytest.mark.parametrize("striker", ["ego", "other"])
def test_who_comes_over_from_beside_strikes_or_is_struck_as_was_said(striker: str) -> None:
    said = others(car("A", "beside", deed("lane-change"), side="left"), contact={"striker": striker})
    assert all(unseen(said, seed) == () for seed in SEEDS)


def test_who_goes_over_goes_where_others_come_if_there_is_no_other_lane() -> None:
    said = others(car("A", "behind", deed("overtake")), car("B", "oncoming", deed("go-along")), road={"two_way": True})
    assert build(said).program.source


def test_somebody_on_foot_where_only_vehicles_come_from_is_refused_with_where_people_are() -> None:
    for where in ("behind", "on-ramp"):
        with pytest.raises(NotBuilt, match="for a pedestrian; the nearest is"):
            build(others(car("A", where, deed("go-along"), kind="pedestrian")))


def test_who_waits_for_the_second_of_two_equal_deeds_waits_for_that_one() -> None:
    lost = car("P", "ahead", deed("drop-load"), deed("drop-load"), kind="truck", distance="45 m", speed="30 km/h")
    said = others(car("A", "ahead", deed("swerve", to="left") | {"when": {"after": "P.1"}}, kind="bicycle"), lost)
    assert "until P_load_1.pose[3] <" in build(said).program.source


def test_each_of_several_loses_a_load_and_nobody_drives_into_that() -> None:
    several = others(car("A", "ahead", deed("drop-load"), kind="truck") | {"count": 2})
    episode = driven(several, 0)
    loads = [one for one in episode.tracks if one.actor.startswith("A-load")]
    assert [one.actor for one in loads] == ["A-load", "A-load-2"]
    assert all(one.speed.min() < 0.5 * one.speed[0] for one in loads)
    assert unseen(several) == ()


@pytest.mark.parametrize("seed", [0, 2])
def test_who_makes_somebody_ahead_brake_crosses_just_before_that_one(seed: int) -> None:
    brakes = car("A", "ahead", deed("brake", manner="hard") | {"when": {"after": "B.0"}})
    dog = car("B", "roadside", deed("cross"), kind="dog", side="right") | {"role": "supporting"}
    episode = driven(others(brakes, dog), seed)
    braking, crossing = track(episode, "A"), track(episode, "B")
    brakes_hard = braking.acceleration(episode.dt) < -2.0
    assert brakes_hard.any()
    begins = int(np.argmax(brakes_hard))
    along = np.array([np.cos(braking.heading[begins]), np.sin(braking.heading[begins])])
    apart = np.array([crossing.x[begins] - braking.x[begins], crossing.y[begins] - braking.y[begins]])
    assert 0.0 < apart @ along < 35.0  # it was 60 m ahead, and nothing showed what the braking was for


@pytest.mark.parametrize("kind", ["truck", "motorcycle"])
def test_who_turns_off_across_us_has_slowed_down_to_what_it_turns_with(kind: str) -> None:
    said = others(car("A", "oncoming", deed("turn-left"), kind=kind), ego={"speed": "110 km/h"}, road={"kind": "road"})
    episode = driven(said, 0)
    across = track(episode)
    turned = np.abs(np.unwrap(across.heading) - across.heading[0])
    assert turned.max() > np.radians(60.0)
    assert across.speed[turned > np.radians(10.0)].max() < 6.0
    assert beyond_tyres(episode) == ()


def test_who_stopped_on_foot_turns_back_where_it_stands() -> None:
    runs = deed("cross") | {"manner": "fast"}
    episode = driven(somebody("dog", "roadside", runs, deed("stop"), deed("turn-back")))
    dog = track(episode)
    stands = np.flatnonzero((dog.speed < 0.1) & (np.hypot(dog.x - dog.x[0], dog.y - dog.y[0]) > 1.0))
    before, after = dog.heading[stands[0]], dog.heading[stands[-1] + 1 :]
    on = (dog.x[stands[-1] :] - dog.x[stands[-1]]) * np.cos(before)
    on += (dog.y[stands[-1] :] - dog.y[stands[-1]]) * np.sin(before)
    assert on.max() < 0.3  # and goes no farther first
    assert np.abs(after[-1] - before) > 3.0


def test_a_bus_that_stands_against_us_stands_behind_who_crosses_before_it() -> None:
    child = {"id": "A", "kind": "child", "starts": {"where": "roadside", "side": "left"}, "does": [deed("cross")]}
    for seed in range(4):
        episode = driven(others(child, car("B", "oncoming", deed("stand"), kind="bus")), seed)
        bus, walks = track(episode, "B"), track(episode)
        ahead = (walks.x[0] - bus.x[0]) * np.cos(bus.heading[0]) + (walks.y[0] - bus.y[0]) * np.sin(bus.heading[0])
        assert 0.5 * bus.length + 1.0 < ahead < 0.5 * bus.length + 3.0
