"""Who is to be braked for, passed, or met later is there when that happens; what could not follow is refused."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from test_building import drive, simulator
from test_passing import ahead_of, aside_of, driven, one

from chatscene.build.build import build
from chatscene.errors import NotBuilt
from chatscene.program.judge import failures, judge
from chatscene.situations.form import from_plain
from chatscene.terms.episode import Episode


def shown(seed: int, others: list[dict[str, Any]], **facts: Any) -> tuple[str, ...]:
    """What a drive does not show."""
    situation = from_plain({"others": others, **facts})
    made = build(situation)
    episode = drive(made, seed=seed)
    assert isinstance(episode, Episode)
    return failures(judge(situation, episode, simulator(made.map, "native").route(made.program, 0)))


@pytest.mark.parametrize("seed", [0, 1])
def test_who_runs_into_an_ego_that_brakes_for_another_is_close_behind_it_then(seed: int):
    others = [
        one("A", "car", "behind", {"act": "go-along"}),
        one("B", "bicycle", "roadside", {"act": "cross"}, side="right", role="supporting"),
    ]
    ego = {"does": [{"act": "brake", "when": {"during": "B.cross"}}]}
    contact = {"whom": "A", "ego": "rear", "other": "front", "striker": "other"}
    episode, tracks = driven(others, seed=seed, ego=ego, contact=contact)
    speed = episode.ego_track.speed
    assert speed.min() < 0.75 * speed[0]
    behind = -ahead_of(episode.ego_track, tracks["A"]) - 0.5 * (episode.ego_track.length + tracks["A"].length)
    assert behind[0] < 26.0
    assert behind.min() < 5.0


@pytest.mark.parametrize("seed", [0, 2, 4])
def test_who_passes_is_back_before_who_comes_against_it(seed: int):
    others = [
        one("A", "car", "behind", {"act": "overtake"}, {"act": "cut-in"}),
        one("B", "tractor", "oncoming", {"act": "go-along"}, role="supporting"),
    ]
    assert not shown(seed, others)


@pytest.mark.parametrize("kind", ["animal", "pedestrian"])
def test_who_stands_ahead_on_foot_and_then_crosses_is_seen_to(kind: str):
    assert shown(0, [one("A", kind, "ahead", {"act": "stand"}, {"act": "cross"})]) == ()


def test_who_drifts_slowly_goes_on_as_fast_as_it_was():
    drifts = one("A", "truck", "beside", {"act": "drift", "to": "left", "manner": "slow"}, side="right")
    road = {"kind": "motorway", "lanes": 3, "ego_lane": 2}
    _, tracks = driven([drifts], ego={"speed": "90 km/h"}, road=road)
    assert tracks["A"].speed.min() * 3.6 > 75.0


def test_who_swings_out_before_a_car_that_stands_does_not_brake_for_it():
    others = [
        one("A", "van", "ahead", {"act": "stand"}, hidden_by="B"),
        one("B", "car", "ahead", {"act": "cut-out", "to": "left"}, role="supporting"),
    ]
    _, tracks = driven(others, ego={"speed": "80 km/h"}, road={"kind": "motorway", "lanes": 2, "ego_lane": 1})
    assert tracks["B"].speed.min() * 3.6 > 65.0


def test_who_only_goes_along_has_passed_what_lies_in_the_lane():
    others = [
        one("A", "debris", "ahead"),
        one("B", "car", "ahead", {"act": "go-along"}, role="supporting"),
    ]
    episode, tracks = driven(others)
    ego = episode.ego_track
    assert ahead_of(ego, tracks["B"])[0] > ahead_of(ego, tracks["A"])[0]
    assert tracks["B"].speed.min() > 0.8 * tracks["B"].speed[0]


def test_who_stands_in_the_lane_that_the_ego_leaves_is_passed():
    ego = {"route": "lane-change-left", "does": [{"act": "lane-change", "to": "left"}]}
    episode, tracks = driven([one("A", "truck", "ahead", {"act": "stand"})], ego=ego)
    passes = int(np.argmin(np.abs(ahead_of(episode.ego_track, tracks["A"]))))
    assert passes < len(tracks["A"].x) - 1
    assert aside_of(episode.ego_track, tracks["A"])[passes] == pytest.approx(-3.5, abs=0.7)


def test_who_comes_too_fast_to_be_braked_for_gains_speed_in_time():
    goes = {"act": "go-straight"}
    gains = {"act": "accelerate", "acceleration": "1.9 m/s²", "when": {"during": "A.0"}}
    others = [one("A", "car", "arm", goes, gains, side="right")]
    facts = {"ego": {"speed": "56 km/h"}, "road": {"kind": "junction", "control": "none"}}
    assert all(not shown(seed, others, **facts) for seed in (0, 1))


@pytest.mark.parametrize(
    ("facts", "told"),
    [
        (
            {
                "ego": {"speed": "50 km/h"},
                "road": {"kind": "junction"},
                "others": [
                    one("A", "car", "arm", {"act": "go-straight", "when": {"ego_within": "15 m"}}, side="right")
                ],
            },
            "others.A.does.0.when.ego_within: 15 m: A needs",
        ),
        (
            {"others": [one("A", "truck", "ahead", {"act": "brake"}, speed="130 km/h")], "ego": {"speed": "110 km/h"}},
            "others.A.starts.speed: 130 km/h is more than a truck can do: at most 120 km/h",
        ),
        (
            {
                "ego": {"does": [{"act": "stand"}, {"act": "swerve", "to": "right"}]},
                "others": [one("A", "car", "behind", {"act": "go-along"})],
            },
            "ego.does.1.act: a standing ego must set off before it can swerve",
        ),
    ],
)
def test_what_could_not_follow_is_refused_by_its_fact(facts: dict[str, Any], told: str):
    with pytest.raises(NotBuilt) as refusal:
        build(from_plain(facts))
    assert told in str(refusal.value)
