"""Who leaves the road comes to stand outside its lanes, over the edge that was said, and is seen to on tracks."""

from __future__ import annotations

from functools import cache
from typing import Any

import pytest

from benchmarks.differing import differences
from chatscene.build.build import Built, build
from chatscene.ego.policy import load_ego
from chatscene.errors import NotBuilt
from chatscene.maps.network import resolve_map
from chatscene.program.judge import judge
from chatscene.program.sample import draw
from chatscene.settings import SimulationSettings
from chatscene.simulate.simulator import Simulator, load_simulator, simulate
from chatscene.situations.form import from_plain
from chatscene.terms.episode import Episode
from chatscene.terms.scene import Scene
from chatscene.terms.situation import Situation

LEAVES = {"act": "leave-road"}


@cache
def simulator(map_name: str, by: str) -> Simulator:
    return load_simulator(resolve_map(map_name), SimulationSettings(simulator=by))


def drive(one: Built, by: str = "native") -> Episode:
    values = draw(one.program.parameters, seed=1)
    scene = Scene(id="off/0", scenario_id="off", route=0, block=0, seed=1, values=values)
    episode = simulate(simulator(one.map, by), one.program, scene, load_ego("idm"))
    assert isinstance(episode, Episode), episode
    return episode


def one_who(kind: str, where: str, *does: dict[str, Any], **more: Any) -> Situation:
    others = [{"id": "A", "kind": kind, "starts": {"where": where} | more.pop("starts", {}), "does": list(does)}]
    return from_plain({"ego": {"speed": "50 km/h"} | more.pop("ego", {}), "others": others, **more})


CASES = [
    one_who("car", "behind", LEAVES),
    one_who("truck", "ahead", LEAVES | {"to": "right"}, starts={"distance": "30 m"}),
    one_who("car", "oncoming", LEAVES | {"to": "left"}),
    one_who("van", "beside", LEAVES | {"to": "left"}, starts={"side": "left"}, road={"lanes": 2, "ego_lane": 1}),
]


@pytest.mark.parametrize("said", CASES)
def test_all_of_it_stands_outside_the_lanes(said: Situation) -> None:
    one = build(said)
    episode = drive(one)
    assert episode.stepped.by == "native"
    assert differences(episode, drive(one, "embedded")) == []
    found = {
        finding.path: finding for finding in judge(said, episode, simulator(one.map, "native").route(one.program, 0))
    }
    assert found["others.A.does.0.act"].shown, found
    track = episode.tracks[1]
    assert abs(track.speed[-1]) < 0.3
    lanes = simulator(one.map, "native").route(one.program, 0)
    aside = abs(lanes.line.project(float(track.x[-1]), float(track.y[-1]))[1])
    assert aside > 2.6  # half a lane, and half of its own width beyond the edge


def test_who_only_swerves_and_comes_back_has_not_left_the_road() -> None:
    said = one_who("car", "ahead", {"act": "swerve", "to": "right"}, starts={"distance": "30 m"})
    one = build(said)
    leaves = one_who("car", "ahead", LEAVES | {"to": "right"}, starts={"distance": "30 m"})
    route = simulator(one.map, "native").route(one.program, 0)
    found = {finding.path: finding for finding in judge(leaves, drive(one), route)}
    assert found["others.A.does.0.act"].shown is False


def test_the_other_side_than_was_said_is_told() -> None:
    one = build(one_who("car", "ahead", LEAVES | {"to": "right"}, starts={"distance": "30 m"}))
    said = one_who("car", "ahead", LEAVES | {"to": "left"}, starts={"distance": "30 m"})
    route = simulator(one.map, "native").route(one.program, 0)
    found = {finding.path: finding for finding in judge(said, drive(one), route)}
    assert found["others.A.does.0.to"].shown is False


def test_who_comes_out_of_a_side_road_does_not_leave_the_road_yet() -> None:
    with pytest.raises(NotBuilt, match="leave-road"):
        build(one_who("car", "arm", LEAVES, road={"kind": "four-way"}, starts={"side": "left"}))


def test_an_ego_that_leaves_the_road_stands_beside_it() -> None:
    drifts = {"act": "drift", "to": "right"}
    said = one_who("car", "oncoming", drifts, ego={"does": [LEAVES | {"when": {"during": "A.drift"}}]})
    one = build(said)
    episode = drive(one)
    route = simulator(one.map, "native").route(one.program, 0)
    found = {finding.path: finding for finding in judge(said, episode, route)}
    assert found["ego.does.0.act"].shown
    assert abs(route.line.project(float(episode.ego_track.x[-1]), float(episode.ego_track.y[-1]))[1]) > 2.6
