"""What the ego does with its wheel and beyond what it wants by itself, and the rules that it breaks."""

from __future__ import annotations

import re
from typing import Any

import numpy as np
import pytest
from test_building import drive, simulator
from test_starting import driven, someone, track

from chatscene.build.build import build
from chatscene.errors import NotBuilt
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


@pytest.mark.parametrize(
    ("numbers", "takes"),
    [
        ({"time": "5 s"}, 5.0),
        ({"acceleration": "1 m/s²"}, 20 / 3.6),
        ({"time": "5 s", "acceleration": "1.1 m/s²"}, 5.0),
    ],
)
def test_an_ego_gains_speed_in_the_time_and_as_fast_as_was_said(numbers: dict[str, str], takes: float) -> None:
    gains = ego({"act": "accelerate", "speed": "60 km/h", **numbers}, speed="40 km/h")
    speed = 3.6 * driven(COMES | {"ego": gains}).ego_track.speed
    began, done = np.argmax(speed > 41.0), np.argmax(speed > 58.0)
    assert speed[: int(began)].max() < 42.0
    assert 0.1 * (done - began) == pytest.approx(0.85 * takes, abs=0.5)


@pytest.mark.parametrize(
    "numbers",
    [
        {"time": "1 s", "speed": "80 km/h"},
        {"acceleration": "9 m/s²"},
        {"time": "20 s", "acceleration": "2 m/s²"},
        {"time": "9 s", "acceleration": "2 m/s²", "speed": "60 km/h"},
    ],
)
def test_what_a_refused_gain_names_builds_when_it_is_said(numbers: dict[str, str]) -> None:
    said = {"act": "accelerate", **numbers}
    with pytest.raises(NotBuilt, match=r"ego\.does\.0\.") as refused:
        build(from_plain(COMES | {"ego": ego(said, speed="50 km/h")}))
    name = str(refused.value).partition("ego.does.0.")[2].partition(":")[0]
    found = re.search(r"([\d.]+ (?:s|m/s²))(?: at (?:least|most))?[;,.]? ?(?:say that.*)?$", str(refused.value))
    assert found is not None
    build(from_plain(COMES | {"ego": ego(said | {name: found[1]}, speed="50 km/h")}))


def test_an_ego_that_slows_down_and_then_gains_speed_does_so_in_that_order() -> None:
    deeds = {"act": "slow-down", "speed": "20 km/h"}, {"act": "accelerate"}
    speed = 3.6 * driven(COMES | {"ego": ego(*deeds, speed="50 km/h")}).ego_track.speed
    slow = int(speed.argmin())
    assert speed[0] > 48.0
    assert speed[slow] < 22.0
    assert speed[slow:].max() > 45.0


def test_an_ego_that_brakes_and_then_swerves_has_lost_speed_when_it_swerves() -> None:
    said = STANDS | {"ego": ego({"act": "brake"}, {"act": "swerve", "to": "left"}, speed="60 km/h")}
    speed, left = driven(said).ego_track.speed, aside(said)
    assert left.max() > 2.0
    assert speed[int(np.argmax(left > 1.0))] < 9.0


@pytest.mark.parametrize("act", ["swerve", "park"])
def test_an_ego_is_slowed_to_the_speed_that_was_said_of_what_it_does_with_its_wheel(act: str) -> None:
    one = STANDS if act == "swerve" else someone("behind", "go-along")
    said = one | {"ego": ego({"act": act, "speed": "30 km/h"}, speed="60 km/h")}
    speed, left = 3.6 * driven(said).ego_track.speed, np.abs(aside(said))
    assert speed[0] > 58.0
    assert speed[int(np.argmax(left > 0.5))] == pytest.approx(30.0, abs=3.0)


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
