"""Several in order and in place: abreast, about the road, before an ego that stands or stops, before who answers."""

from __future__ import annotations

import itertools
from functools import cache
from typing import Any

import numpy as np

from chatscene.build.build import Built, build
from chatscene.ego.policy import load_ego
from chatscene.maps.network import resolve_map
from chatscene.program.judge import judge
from chatscene.program.sample import scene_at
from chatscene.settings import SimulationSettings
from chatscene.simulate.simulator import Simulator, load_simulator, simulate
from chatscene.situations.form import from_plain
from chatscene.terms.episode import Episode, Track


@cache
def simulator(map_name: str) -> Simulator:
    return load_simulator(resolve_map(map_name), SimulationSettings(simulator="native"))


def drive(one: Built) -> Episode:
    episode = simulate(
        simulator(one.map), one.program, scene_at(one.program, 0, 0.5, name="middle"), load_ego("planner")
    )
    assert isinstance(episode, Episode), episode
    return episode


def driven(**said: Any) -> tuple[Built, dict[str, Track], Episode]:
    one = build(from_plain(said))
    episode = drive(one)
    return one, {track.actor: track for track in episode.tracks}, episode


def other(name: str, kind: str, where: str, *does: dict[str, Any], **more: Any) -> dict[str, Any]:
    return {"id": name, "kind": kind, "starts": {"where": where} | more.pop("starts", {}), "does": list(does), **more}


def test_two_who_ride_abreast_are_level_and_apart() -> None:
    rides = {"act": "go-along", "manner": "slow"}
    left, right = ({"lateral": {"side": side}} for side in ("left", "right"))
    pair = [
        other("A", "horse-rider", "ahead", rides, starts=left),
        other("B", "horse-rider", "ahead", rides, starts=right),
    ]
    _, tracks, _ = driven(others=pair)
    a, b = tracks["A"], tracks["B"]
    assert 1.0 < np.hypot(a.x[0] - b.x[0], a.y[0] - b.y[0]) < 2.5
    c, s = np.cos(a.heading[0]), np.sin(a.heading[0])
    assert abs((a.x[0] - b.x[0]) * c + (a.y[0] - b.y[0]) * s) < 0.5


def test_a_herd_stands_about_the_road_and_nobody_in_another() -> None:
    one, tracks, _ = driven(road={"kind": "curve"}, others=[other("A", "cow", "ahead", {"act": "stand"}, count=5)])
    line = simulator(one.map).route(one.program, 0).line
    cows = [track for name, track in tracks.items() if name.startswith("A")]
    assert len(cows) == 5
    left = [line.project(float(cow.x[0]), float(cow.y[0]))[1] for cow in cows]
    assert max(left) - min(left) > 3.0
    assert min(np.hypot(a.x[0] - b.x[0], a.y[0] - b.y[0]) for a, b in itertools.combinations(cows, 2)) > 2.4


def test_who_crosses_before_an_ego_that_stands_is_before_its_nose_and_passed_meanwhile() -> None:
    said = {
        "ego": {"kind": "bus", "does": [{"act": "stand"}]},
        "others": [
            other(
                "A",
                "pickup",
                "behind-beside",
                {"act": "overtake", "when": {"during": "B.cross"}},
                starts={"side": "left"},
            ),
            other("B", "child", "roadside", {"act": "cross"}, count=2, role="supporting"),
        ],
    }
    one, tracks, episode = driven(**said)
    ego, child = tracks["ego"], tracks["B"]
    ahead = np.hypot(child.x[0] - ego.x[0], child.y[0] - ego.y[0]) - 0.5 * ego.length
    assert ahead < 8.0
    assert np.abs(ego.speed).max() == 0.0
    found = {each.path: each for each in judge(from_plain(said), episode, simulator(one.map).route(one.program, 0))}
    assert found["others.A.does.0.act"].shown
    assert all(each.shown is not False for path, each in found.items() if path.startswith("encounter."))


def test_an_ego_stops_in_its_lane_and_stays_where_others_act_once_it_has() -> None:
    said = {
        "ego": {"does": [{"act": "stop", "when": {"during": "B.cross"}}]},
        "road": {"has": ["crosswalk"]},
        "others": [
            other("A", "car", "behind", {"act": "overtake", "when": {"after": "ego.stop"}}),
            other("B", "child", "crossing", {"act": "cross"}, count=2, role="supporting"),
        ],
    }
    one, tracks, _ = driven(**said)
    ego, car = tracks["ego"], tracks["A"]
    assert any("keeps its lane until it has stopped" in told for told in one.assumed)
    assert abs(ego.speed[-1]) < 0.1
    line = simulator(one.map).route(one.program, 0).line
    assert abs(line.project(float(ego.x[-1]), float(ego.y[-1]))[1]) < 0.5
    stood = int(np.flatnonzero(np.abs(ego.speed) < 0.1)[0])
    aside = np.array([line.project(float(x), float(y))[1] for x, y in zip(car.x, car.y, strict=True)])
    assert np.abs(aside[: stood + 1]).max() < 1.0  # it waits behind until the ego stands
    assert np.abs(aside).max() > 2.0


def test_who_turns_round_before_others_ahead_does_so_before_those_and_they_answer_it() -> None:
    rides = {"act": "go-along"}
    said = {
        "ego": {"kind": "motorcycle", "speed": "90 km/h"},
        "road": {"lanes": 1, "two_way": True},
        "others": [
            other("A", "car", "kerb", {"act": "stand"}, {"act": "u-turn"}, role="supporting"),
            other(
                "B", "motorcycle", "ahead", rides, {"act": "swerve", "when": {"during": "A.u-turn"}}, role="supporting"
            ),
            other("C", "motorcycle", "ahead", rides, {"act": "brake", "when": {"during": "A.u-turn"}}),
        ],
    }
    one, tracks, episode = driven(**said)
    line = simulator(one.map).route(one.program, 0).line
    along = {name: line.project(float(track.x[0]), float(track.y[0]))[0] for name, track in tracks.items()}
    assert along["ego"] < along["C"] < along["B"] < along["A"]  # who is met is nearest to the ego
    found = {each.path: each for each in judge(from_plain(said), episode, simulator(one.map).route(one.program, 0))}
    for path in ("others.B.does.1.act", "others.C.does.1.act", "others.C.does.1.when.during"):
        assert found[path].shown, found[path]


def test_who_comes_out_of_a_slow_row_goes_as_slowly_before() -> None:
    slow = {"act": "go-along", "speed": "8 km/h"}
    one, tracks, _ = driven(
        ego={"kind": "motorcycle", "speed": "50 km/h"},
        road={"lanes": 3, "ego_lane": 2},
        others=[
            other("A", "car", "ahead-beside", {"act": "cut-in"}, starts={"side": "right"}),
            other("E", "car", "ahead-beside", slow, count=3, role="supporting", starts={"side": "right"}),
        ],
    )
    assert any("as slowly as E" in told for told in one.assumed)
    assert tracks["A"].speed[0] * 3.6 < 9.0
    row = [track for name, track in tracks.items() if name.startswith("E")]
    assert max(np.hypot(a.x[0] - b.x[0], a.y[0] - b.y[0]) for a, b in itertools.combinations(row, 2)) < 25.0


def test_who_waits_behind_an_ego_that_stops_for_another_stays_behind_until_it_does_and_a_third_comes_out_then() -> None:
    said = {
        "ego": {"speed": "30 km/h", "does": [{"act": "stop", "when": {"after": "A.cross"}}]},
        "others": [
            other("A", "ball", "roadside", {"act": "cross"}, role="supporting"),
            other("B", "car", "behind", {"act": "overtake", "when": {"after": "ego.stop"}}),
            other("C", "child", "roadside", {"act": "cross", "when": {"during": "B.overtake"}}, {"act": "stop"}),
        ],
    }
    one, _, episode = driven(**said)
    found = {each.path: each for each in judge(from_plain(said), episode, simulator(one.map).route(one.program, 0))}
    for path in ("others.B.does.0.act", "others.C.does.0.act", "others.C.does.0.when.during"):
        assert found[path].shown, found[path]
    assert episode.collision is None
