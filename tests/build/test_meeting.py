"""Who crosses meets an ego that reacts to nobody: timed by the whole chain of its deeds, to where the ways meet."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from test_building import simulator

from chatscene.build.build import Built, build
from chatscene.ego.observation import OWN, ROAD, Observation
from chatscene.ego.traffic_driver import TrafficDriver
from chatscene.program.sample import draw
from chatscene.simulate.simulator import simulate
from chatscene.situations.form import from_plain
from chatscene.terms.episode import Episode
from chatscene.terms.scene import Scene


class Blind(TrafficDriver):
    """A driver that sees nobody."""

    def wanting(self, speed: float) -> Any:
        return Blind(speed)

    def act(self, observation: Observation) -> tuple[float, float]:
        empty = np.array(observation)
        empty[OWN:ROAD] = 0.0
        return super().act(empty)


def somebody(kind: str, where: str, *does: dict[str, Any] | str, side: str | None = None, **more: Any) -> Built:
    start = {"where": where, **({"side": side} if side else {})}
    deeds = [{"act": deed} if isinstance(deed, str) else deed for deed in does]
    return build(from_plain({"others": [{"id": "A", "kind": kind, "starts": start, "does": deeds}], **more}))


def met(built: Built, seed: int, **given: float) -> Episode:
    values = draw(built.program.parameters, seed=seed) | {f"OPT_A_{name}": value for name, value in given.items()}
    scene = Scene(id=f"s/route-00/{seed}", scenario_id="s", route=0, block=0, seed=seed, values=values)
    speed = built.program.wanted_speed
    assert speed is not None
    episode = simulate(simulator(built.map, "native"), built.program, scene, Blind(speed))
    assert isinstance(episode, Episode), episode
    return episode


@pytest.mark.parametrize(
    "built",
    [
        somebody("pedestrian", "roadside", {"act": "cross", "speed": "8 km/h"}, side="left", ego={"speed": "50 km/h"}),
        somebody("bicycle", "driveway", "cross", side="right"),
        somebody("car", "arm", "stop", "set-off", side="left", road={"control": "stop-sign"}),
        somebody("car", "arm", "go-straight", side="right"),
        somebody("car", "arm", "enter", side="left", ego={"speed": "50 km/h"}),
        somebody("car", "oncoming", "turn-left"),
        somebody(
            "motorcycle", "oncoming", "turn-left", ego={"speed": "80 km/h"}, road={"kind": "junction"}
        ),  # slower then
        somebody("bus", "oncoming", "go-straight", ego={"route": "left-turn"}),  # which does not hold the road's speed
        somebody("bicycle", "behind-beside", "go-straight", side="right", ego={"route": "right-turn"}),
        somebody("deer", "ahead"),
        somebody("pedestrian", "ahead-beside", "enter", side="left"),
    ],
)
def test_the_two_meet_if_neither_reacts(built: Built) -> None:
    assert sum(met(built, seed).collision is not None for seed in range(6)) >= 3


@pytest.mark.parametrize("speed", ["30 km/h", "80 km/h"])
@pytest.mark.parametrize(
    ("kind", "where", "does", "side", "late"),
    [
        ("car", "arm", "go-straight", "left", True),
        ("truck", "arm", "go-straight", "right", True),
        ("motorcycle", "oncoming", "turn-left", None, True),
        ("child", "roadside", "cross", "right", False),  # nobody says that it crosses who does so behind the ego
    ],
)
def test_who_crosses_is_struck_or_just_missed(
    kind: str, where: str, does: str, side: str | None, late: bool, speed: str
) -> None:
    built = somebody(kind, where, does, side=side, ego={"speed": speed}, road={"kind": "junction"} if late else {})
    (offset,) = (one for one in built.program.parameters if one.name == "OPT_A_OFFSET")
    ends = (offset.low, offset.high) if late else (offset.high,)
    assert [met(built, 0, OFFSET=end).collision for end in ends] == [None] * len(ends)
    assert met(built, 0, OFFSET=0.5 * (offset.low + offset.high)).collision is not None


def test_who_stops_at_a_junction_does_so_before_it_and_then_comes_before_the_ego() -> None:
    episode = met(somebody("car", "arm", "stop", "set-off", side="left", road={"control": "stop-sign"}), 0)
    ego, other = episode.ego_track, next(track for track in episode.tracks if track.actor == "A")
    stood = int(np.flatnonzero((other.speed < 0.1) & (np.arange(len(other.x)) > 20))[0])
    assert np.hypot(other.x[stood] - ego.x[-1], other.y[stood] - ego.y[-1]) > 8.0


def test_an_animal_on_the_road_runs_over_it_which_is_told() -> None:
    assert "A crosses our lane" in somebody("animal", "ahead").assumed


def test_who_is_on_foot_at_a_side_road_that_the_ego_goes_past_walks_over_its_mouth() -> None:
    car = {"id": "B", "kind": "car", "starts": {"where": "oncoming"}, "does": [{"act": "turn-left"}]}
    walker = {"id": "A", "kind": "pedestrian", "role": "supporting", "starts": {"where": "arm", "side": "left"}}
    built = build(from_plain({"others": [car, walker | {"does": [{"act": "cross"}]}]}))
    assert "A crosses the side road along ours" in built.assumed
    assert "facing directionOn(egoRoute, levelA)" in built.program.source


def test_the_speed_of_who_backs_onto_the_road_is_what_was_said() -> None:
    built = somebody("car", "driveway", {"act": "reverse", "speed": "15 km/h"}, side="right")
    assert "ReverseStraight(4.16667)" in built.program.source


def test_that_the_ego_has_a_stop_sign_too_is_told() -> None:
    sign, breaks = {"control": "stop-sign"}, {"act": "go-straight", "breaks": "stop-sign"}
    built = somebody("car", "arm", breaks, side="right", road=sign, map="town")
    assert any("the ego has a stop sign too" in one for one in built.assumed)
    built = somebody("car", "arm", breaks, side="right", road=sign)
    assert not any("stop sign" in one for one in built.assumed)
    assert "signs=side-stop" in built.map


def test_who_hides_somebody_beside_the_road_stands_there_and_that_is_told() -> None:
    child = {"id": "A", "kind": "child", "starts": {"where": "roadside", "side": "right"}, "hidden_by": "B"}
    bus = {"id": "B", "kind": "bus", "role": "hides", "starts": {"where": "ahead"}, "does": [{"act": "stand"}]}
    made = build(from_plain({"others": [child | {"does": [{"act": "cross"}]}, bus]}))
    assert "B stands beside the road instead of ahead, so that it hides A" in made.assumed


def test_who_comes_in_our_lane_without_a_deed_goes_by_where_the_two_do_not_touch() -> None:
    comes = {"id": "A", "kind": "bicycle", "starts": {"where": "oncoming-in-our-lane"}}
    assert build(from_plain({"others": [comes], "contact": {"happens": False}})).left_out == ()
