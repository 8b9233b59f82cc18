"""Who passes, cuts in, keeps level, stops behind or lets others by is where it must be, whatever the ego does."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from test_building import drive, simulator

from chatscene.build.build import build
from chatscene.program.judge import failures, judge
from chatscene.situations.form import from_plain
from chatscene.terms.episode import Episode, Track


def driven(others: list[dict[str, Any]], seed: int = 0, **facts: Any) -> tuple[Episode, dict[str, Track]]:
    """A drive, and the track of everybody by the name."""
    episode = drive(build(from_plain({"others": others, **facts})), seed=seed)
    assert isinstance(episode, Episode), episode
    return episode, {track.actor: track for track in episode.tracks}


def one(name: str, kind: str, where: str, *does: dict[str, Any], **more: Any) -> dict[str, Any]:
    """Somebody, with what else is said of it or of its start."""
    starts = {"where": where} | {key: more.pop(key) for key in ("side", "distance", "speed") if key in more}
    return {"id": name, "kind": kind, "starts": starts, "does": list(does), **more}


def ahead_of(ego: Track, other: Track) -> NDArray[np.float64]:
    """How far [m] the middle of another is ahead of the ego's."""
    return (other.x - ego.x) * np.cos(ego.heading) + (other.y - ego.y) * np.sin(ego.heading)


def aside_of(ego: Track, other: Track) -> NDArray[np.float64]:
    """How far [m] it is to the left of the ego."""
    return (other.y - ego.y) * np.cos(ego.heading) - (other.x - ego.x) * np.sin(ego.heading)


def test_who_is_slower_and_cuts_in_at_a_gap_keeps_its_speed_until_then():
    cuts_in = {"act": "cut-in", "to": "left", "distance": "12 m"}
    other = one("A", "car", "ahead-beside", cuts_in, side="right", speed="80 km/h")
    episode, tracks = driven([other], ego={"speed": "100 km/h"}, road={"lanes": 3, "ego_lane": 2})
    ego, a = episode.ego_track, tracks["A"]
    crosses = int(np.argmax(aside_of(ego, a) > -1.75))
    assert crosses > 0
    assert a.speed[:crosses].max() * 3.6 < 83.0
    assert ahead_of(ego, a)[crosses] - 0.5 * (ego.length + a.length) == pytest.approx(12.0, abs=3.0)


def test_who_cuts_in_behind_a_leader_that_brakes_does_not_drive_through_it():
    others = [
        one("A", "car", "ahead-beside", {"act": "cut-in", "time": "less than 1.0 s"}),
        one("B", "car", "ahead", {"act": "brake", "when": {"after": "A.cut-in"}}, role="supporting"),
    ]
    episode, tracks = driven(others, ego={"does": [{"act": "follow", "whom": "B"}]})
    apart = ahead_of(episode.ego_track, tracks["B"]) - ahead_of(episode.ego_track, tracks["A"])
    assert apart[-1] > 4.0


def test_who_is_passed_by_somebody_at_a_distance_that_was_said_is_beside_that():
    others = [
        one("A", "car", "oncoming-in-our-lane", {"act": "overtake", "whom": "B"}, distance="180 m", speed="110 km/h"),
        one("B", "truck", "oncoming", {"act": "go-along"}, role="supporting"),
    ]
    road = {"setting": "rural", "two_way": True}
    episode, tracks = driven(others, ego={"speed": "90 km/h"}, road=road)
    ahead = {name: ahead_of(episode.ego_track, tracks[name]) for name in "AB"}
    assert 0.0 < ahead["A"][0] - ahead["B"][0] < 16.0
    passed = int(np.argmax(ahead["A"] < ahead["B"] - 6.0))
    assert passed > 0
    assert ahead["A"][passed] > 30.0


def test_two_who_race_come_level_with_each_other():
    others = [
        one("A", "car", "oncoming-in-our-lane", {"act": "keep-level", "whom": "B"}, speed="at least 80 mph"),
        one("B", "car", "oncoming", {"act": "keep-level", "whom": "A"}, role="supporting"),
    ]
    episode, tracks = driven(others, road={"two_way": True})
    apart = ahead_of(episode.ego_track, tracks["A"]) - ahead_of(episode.ego_track, tracks["B"])
    assert np.abs(apart).max() < 5.0


def test_who_lets_somebody_across_stands_before_where_that_crosses():
    others = [
        one("A", "car", "driveway", {"act": "cross"}, side="right"),
        one("B", "truck", "ahead-beside", {"act": "stand"}, side="right", role="supporting"),
    ]
    episode, tracks = driven(others, road={"lanes": 2, "ego_lane": 2})
    ego, a, b = episode.ego_track, tracks["A"], tracks["B"]
    assert 4.0 < ahead_of(ego, a)[0] - ahead_of(ego, b)[0] < 8.0


def test_who_stops_behind_an_ego_that_stands_stops_close_behind_it():
    others = [
        one("A", "truck", "ahead", {"act": "stand"}),
        one("B", "car", "behind", {"act": "stop"}, role="supporting"),
    ]
    episode, tracks = driven(others, ego={"does": [{"act": "stand"}]})
    ego = episode.ego_track
    assert 0.5 < -ahead_of(ego, tracks["B"])[-1] - 0.5 * (ego.length + tracks["B"].length) < 5.0
    assert ahead_of(ego, tracks["A"])[0] - 0.5 * (ego.length + tracks["A"].length) < 4.5


def test_who_goes_beside_an_ego_that_a_slow_leader_holds_is_beside_it_when_it_comes_over():
    others = [
        one("A", "car", "beside", {"act": "go-along"}, side="left"),
        one("B", "car", "ahead", {"act": "go-along", "manner": "slow"}),
    ]
    for seed in range(2):
        episode, tracks = driven(others, seed, ego={"route": "lane-change-left"})
        ego, a = episode.ego_track, tracks["A"]
        comes = int(np.argmax(aside_of(ego, a) < 3.1))
        assert abs(ahead_of(ego, a)[comes]) < 6.0


def test_a_cyclist_beside_an_ego_that_turns_in_falls_beside_it():
    other = one("A", "bicycle", "behind-beside", {"act": "go-along"}, {"act": "fall"}, side="right")
    ego = {"route": "enter-driveway", "does": [{"act": "slow-down"}]}
    for seed in range(2):
        episode, tracks = driven([other], seed, ego=ego)
        ego_track, a = episode.ego_track, tracks["A"]
        assert float(np.hypot(a.x - ego_track.x, a.y - ego_track.y).min()) < 4.5


def test_a_slight_bend_is_no_bypass():
    other = one("A", "car", "ahead", {"act": "brake"})
    situation = from_plain({"ego": {"route": "straight", "speed": "100 km/h"}, "others": [other], "road": {"lanes": 3}})
    made = build(situation)
    episode = drive(made, seed=0)
    assert isinstance(episode, Episode)
    route = simulator(made.map, "native").route(made.program, 0)
    assert not [one for one in failures(judge(situation, episode, route)) if "route" in str(one)]


def test_a_motorcycle_that_passes_in_a_lane_of_others_goes_between_the_lanes():
    others = [
        one("A", "motorcycle", "behind-beside", {"act": "overtake"}, side="left"),
        one("B", "car", "ahead-beside", {"act": "go-along", "manner": "slow"}, side="left", role="supporting"),
    ]
    episode, tracks = driven(others)
    ego, a = episode.ego_track, tracks["A"]
    past = int(np.argmax(ahead_of(ego, a) > 0.0))
    assert past > 0
    assert 1.5 < aside_of(ego, a)[past] < 2.0
    assert np.hypot(a.x - tracks["B"].x, a.y - tracks["B"].y).min() > 1.5


def test_who_is_on_the_side_from_which_the_ego_changes_lanes_is_in_a_lane_there():
    other = one("A", "car", "beside", {"act": "go-along"}, side="left")
    episode, tracks = driven([other], ego={"route": "lane-change-right"})
    assert abs(ahead_of(episode.ego_track, tracks["A"])[0]) < 6.0
    assert aside_of(episode.ego_track, tracks["A"])[0] == pytest.approx(3.5, abs=0.3)


def test_who_yields_to_somebody_before_the_ego_stops_when_that_is_near():
    others = [
        one("A", "car", "oncoming", {"act": "yield", "whom": "B"}, {"act": "turn-left"}),
        one("B", "van", "ahead", {"act": "go-along"}, role="supporting"),
    ]
    _, tracks = driven(others, road={"kind": "road", "two_way": True})
    a, b = tracks["A"], tracks["B"]
    stands = int(np.argmax(a.speed < 0.1))
    assert stands > 0
    assert np.hypot(a.x - b.x, a.y - b.y)[stands] < 30.0


def test_who_goes_slowly_and_cuts_in_lets_the_ego_come_up_to_it():
    deeds = ({"act": "go-along", "manner": "slow"}, {"act": "cut-in", "manner": "sudden"})
    episode, tracks = driven([one("A", "car", "ahead-beside", *deeds, side="right")])
    ego, a = episode.ego_track, tracks["A"]
    before = int(np.argmax(aside_of(ego, a) > -3.2))
    assert before > 0
    assert a.speed[:before].max() < 4.0
    assert 2.0 < ahead_of(ego, a)[before] < 20.0


def test_who_goes_along_behind_an_ego_that_has_to_stop_stops_behind_it():
    others = [
        one("A", "van", "ahead", {"act": "go-along"}, {"act": "brake", "manner": "sudden"}, distance="5 m"),
        one("B", "truck", "behind", {"act": "go-along"}),
    ]
    for seed in range(3):
        episode, _ = driven(others, seed, ego={"does": [{"act": "follow", "whom": "A"}]})
        assert episode.collision is None


def test_who_stands_behind_an_ego_that_stands_sets_off_and_goes_round_it() -> None:
    does = [{"act": "stand"}, {"act": "set-off"}, {"act": "overtake"}]
    one = {"id": "A", "kind": "pickup", "starts": {"where": "behind", "distance": "7 m"}, "does": does}
    said = from_plain({"ego": {"does": [{"act": "stand"}]}, "others": [one]})
    built = build(said)
    episode = drive(built, seed=1)
    assert isinstance(episode, Episode), episode
    ego, other = episode.tracks
    assert float(ego.speed.max()) < 0.1
    assert float(other.speed[5]) < 0.1
    assert float(np.hypot(other.x[-1] - other.x[0], other.y[-1] - other.y[0])) > 20.0
    assert not episode.events
