"""An ego that backs: along the road, out of a driveway or a bay; and who comes by behind it."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from test_building import drive, simulator
from test_starting import driven, someone, track

from chatscene.build.build import build
from chatscene.errors import NotBuilt
from chatscene.program.judge import failures, judge
from chatscene.simulate.simulator import simulate
from chatscene.situations.form import from_plain
from chatscene.terms.episode import Episode
from chatscene.terms.scene import Scene

OUT = {"route": "leave-driveway", "does": [{"act": "reverse"}]}
BAY = {"route": "leave-parking", "does": [{"act": "reverse"}]}
VANS = {
    "id": "B",
    "kind": "van",
    "count": 2,
    "role": "hides",
    "starts": {"where": "beside"},
    "does": [{"act": "stand"}],
}


def hidden(said: dict[str, Any]) -> dict[str, Any]:
    said["others"][0]["hidden_by"] = "B"
    return {**said, "others": [*said["others"], VANS]}


BACKS: dict[str, dict[str, Any]] = {
    "along the road": someone("roadside", "cross", kind="child", side="left", ego={"route": "reverse"}),
    "against who stands": someone("behind", "stand", ego={"route": "reverse"}),
    "against who comes": someone("behind", "go-along", ego={"route": "reverse"}),
    "out of a driveway": someone("roadside", "cross", kind="bicycle", side="left", ego=OUT),
    "before who walks": someone("roadside", "cross", kind="pedestrian", side="right", ego=OUT),
    "out between vans": hidden(someone("roadside", "cross", kind="bicycle", side="left", ego=BAY)),
    "into traffic": someone("arm", "go-straight", ego=BAY),
}


@pytest.mark.parametrize("how", BACKS)
def test_an_ego_that_backs_goes_where_its_tail_is_and_meets_who_comes_by(how: str) -> None:
    said = from_plain(BACKS[how])
    built = build(said)
    shown = 0
    for seed in range(6):
        episode = drive(built, seed=seed)
        if not isinstance(episode, Episode):
            continue
        ego = episode.ego_track
        assert ego.speed.max() <= 0.0 <= -ego.speed.min() <= 2.0
        gone = np.column_stack((np.diff(ego.x), np.diff(ego.y)))
        ahead = gone[:, 0] * np.cos(ego.heading[1:]) + gone[:, 1] * np.sin(ego.heading[1:])
        assert ahead.max() < 1e-3
        shown += not failures(judge(said, episode, simulator(built.map, "native").route(built.program, 0)))
    assert shown > 1


@pytest.mark.parametrize("side", ["left", "right"])
def test_sides_are_those_of_the_seat(side: str) -> None:
    episode = driven(someone("roadside", "cross", kind="bicycle", side=side, ego=OUT))
    ego, other = episode.ego_track, track(episode)
    dx, dy, heading = other.x[0] - ego.x[0], other.y[0] - ego.y[0], ego.heading[0]
    left = dy * math.cos(heading) - dx * math.sin(heading)
    assert (left > 0) == (side == "left")
    assert dx * math.cos(heading) + dy * math.sin(heading) < 0.0  # it comes by behind


def test_a_car_that_backs_out_turns_its_nose_along_the_lane() -> None:
    episode = driven(someone("roadside", "stand", kind="pedestrian", side="right", distance="30 m", ego=OUT))
    ego = episode.ego_track
    turned = math.degrees(ego.heading[-1] - ego.heading[0])
    assert turned == pytest.approx(90, abs=20)


@pytest.mark.parametrize("ego", ["idm", "planner", "rule-based"])
def test_a_car_that_backs_goes_the_same_in_the_engine_to_the_last_bit(ego: str) -> None:
    built = build(from_plain(BACKS["out of a driveway"]))
    drives: list[Episode] = []
    for name in ("native", "embedded"):
        episode = drive(built, name, seed=2, ego=ego)
        assert isinstance(episode, Episode)
        assert episode.stepped.by == name
        drives.append(episode)
    for one, other in zip(drives[0].tracks, drives[1].tracks, strict=True):
        for name in ("x", "y", "heading", "speed"):
            np.testing.assert_array_equal(getattr(one, name), getattr(other, name))


def test_who_runs_into_what_is_behind_touches_it_with_its_rear() -> None:
    class Blind:
        observation = "safebench"

        def act(self, observation: object) -> tuple[float, float]:
            return 0.5, 0.0

    built = build(from_plain(BACKS["against who stands"]))
    values = {one.name: one.low for one in built.program.parameters}
    scene = Scene(id="s", scenario_id="s", route=0, block=0, seed=1, values=values)
    episode = simulate(simulator(built.map, "native"), built.program, scene, Blind())
    assert isinstance(episode, Episode)
    assert episode.collision is not None
    assert episode.collision.side == "rear"


@pytest.mark.parametrize(
    ("ego", "where", "told"),
    [
        (OUT, {"where": "kerb", "side": "right"}, "starts.where: kerb, with a reversing ego"),
        ({"route": "reverse"}, {"where": "beside", "side": "left"}, "starts.where: beside, with a reversing ego"),
    ],
)
def test_whom_an_ego_that_backs_cannot_meet_is_refused(ego: dict[str, Any], where: dict[str, str], told: str) -> None:
    with pytest.raises(NotBuilt, match=told):
        build(from_plain({"ego": ego, "others": [{"id": "A", "kind": "car", "starts": where}]}))
