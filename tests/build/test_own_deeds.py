"""What the ego does with its wheel and beyond what it wants by itself, and the rules that it breaks."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from test_building import drive, simulator
from test_starting import driven, someone, track

from chatscene.build.build import build
from chatscene.program.judge import failures, judge
from chatscene.program.watching import watch
from chatscene.situations.form import from_plain
from chatscene.terms.arrays import Array
from chatscene.terms.episode import Episode


def ego(*deeds: dict[str, Any], **more: Any) -> dict[str, Any]:
    return {"does": list(deeds), **more}


def aside(said: dict[str, Any], seed: int = 1) -> Array:
    """How far to the left of its route [m] the ego is."""
    episode = driven(said, seed=seed)
    built = build(from_plain(said))
    route = simulator(built.map, "native").route(built.program, 0)
    return watch(episode, route, episode.ego_track).offset


STANDS = someone("ahead", "stand")
COMES = someone("oncoming", "go-along")


def test_an_ego_that_swerves_passes_who_stands_before_it_and_comes_back() -> None:
    said = STANDS | {"ego": ego({"act": "swerve", "to": "left"}, speed="48 km/h"), "road": {"two_way": True}}
    episode = driven(said)
    left = aside(said)
    assert episode.collision is None
    assert left.max() > 2.0
    assert abs(left[-1]) < 0.5
    assert np.argmax(left > 1.0) > 20  # only once it is near


@pytest.mark.parametrize(("act", "least"), [("drift", 0.9), ("swerve", 1.0), ("lane-change", 2.5)])
@pytest.mark.parametrize("side", ["left", "right"])
def test_an_ego_leaves_its_line_to_the_side_that_was_said(act: str, least: float, side: str) -> None:
    road = {"kind": "motorway", "lanes": 3, "ego_lane": 2}
    far = someone("ahead", "stand", distance="120 m")
    left = aside(far | {"ego": ego({"act": act, "to": side}), "road": road})
    assert (left.max() if side == "left" else -left.min()) > least


def test_deeds_of_the_wheel_follow_each_other() -> None:
    deeds = {"act": "drift", "to": "right"}, {"act": "swerve", "to": "left"}
    left = aside(COMES | {"ego": ego(*deeds, speed="80 km/h"), "road": {"two_way": True}})
    assert left.min() < -0.8
    assert left.max() > 1.2
    assert left.argmin() < left.argmax()


def test_an_ego_that_parks_stands_at_the_edge() -> None:
    said = someone("behind", "go-along") | {"ego": ego({"act": "park"}, speed="40 km/h")}
    episode = driven(said)
    assert episode.ego_track.speed[0] > 10.0
    assert episode.ego_track.speed.min() < 0.05
    assert aside(said)[episode.ego_track.speed < 0.05].max() < -1.5


@pytest.mark.parametrize("speed", ["at most 20 km/h", "20 km/h"])
def test_an_ego_that_parks_keeps_the_speed_that_was_said_of_it(speed: str) -> None:
    parks = ego({"act": "park", "speed": speed}, speed="50 km/h")
    assert "at_least=5.556" in build(from_plain(someone("behind", "go-along") | {"ego": parks})).program.source


def test_an_ego_that_gains_speed_had_less_before() -> None:
    said = someone("roadside", "cross", kind="child", side="right") | {
        "ego": ego({"act": "accelerate"}, speed="40 km/h")
    }
    speed = driven(said).ego_track.speed
    assert speed[15] < 8.0
    assert speed.max() > 10.0


@pytest.mark.parametrize("rule", ["red-light", "stop-sign"])
def test_an_ego_breaks_the_rule_that_it_is_said_to_break(rule: str) -> None:
    said = someone("arm", "go-straight", side="left") | {"ego": ego({"act": "go-along", "breaks": rule})}
    situation = from_plain(said)
    built = build(situation)
    shown = 0
    for seed in range(4):
        episode = drive(built, seed=seed)
        assert isinstance(episode, Episode)
        findings = judge(situation, episode, simulator(built.map, "native").route(built.program, 0))
        shown += any(one.path == "ego.does.0.breaks" and one.shown for one in findings) and not failures(findings)
    assert shown


@pytest.mark.parametrize("said", [STANDS | {"ego": ego({"act": "swerve"})}, COMES | {"ego": ego({"act": "park"})}])
@pytest.mark.parametrize("driver", ["idm", "planner"])
def test_an_ego_is_held_to_its_wheel_the_same_in_the_engine_to_the_last_bit(said: dict[str, Any], driver: str) -> None:
    built = build(from_plain(said))
    drives = [drive(built, name, seed=2, ego=driver) for name in ("native", "embedded")]
    assert all(isinstance(one, Episode) for one in drives)
    one, other = (episode.ego_track for episode in drives if isinstance(episode, Episode))
    for name in ("x", "y", "heading", "speed"):
        np.testing.assert_array_equal(getattr(one, name), getattr(other, name))


def test_who_is_not_met_goes_by_an_ego_that_waits_before_who_is() -> None:
    said = someone("arm", "go-straight", side="right", ego=ego({"act": "stand"}, {"act": "set-off"}))
    said["others"].append(said["others"][0] | {"id": "B", "kind": "motorcycle", "role": "supporting"})
    episode = driven(said)
    first, then = (track(episode, name) for name in "BA")
    assert abs(first.x[0] - episode.ego_track.x[0]) + abs(first.y[0] - episode.ego_track.y[0]) < abs(
        then.x[0] - episode.ego_track.x[0]
    ) + abs(then.y[0] - episode.ego_track.y[0])


def test_an_ego_stops_across_the_lane_that_it_turns_over() -> None:
    deeds = {"act": "stand"}, {"act": "set-off"}, {"act": "stop"}
    said = someone("oncoming", "go-straight", kind="motorcycle", ego=ego(*deeds, route="left-turn"))
    for seed in range(3):
        own = driven(said, seed=seed).ego_track
        if own.speed[-1] < 0.1:
            assert np.hypot(own.x[-1] - own.x[0], own.y[-1] - own.y[0]) > 6.0
