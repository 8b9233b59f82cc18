"""Who leaves the lane shows who is slow there; what is due though the ego is held; for whom somebody brakes."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from test_building import drive, simulator
from test_starting import track

from chatscene.build.build import build
from chatscene.errors import NotBuilt
from chatscene.program.judge import failures, judge
from chatscene.situations.form import from_plain
from chatscene.terms.episode import Episode
from chatscene.terms.situation import Situation


def other(name: str, where: str, *does: dict[str, Any], kind: str = "car", **start: Any) -> dict[str, Any]:
    role = "adversary" if name == "A" else "supporting"
    return {"id": name, "kind": kind, "role": role, "starts": {"where": where, **start}, "does": list(does)}


def said(*others: dict[str, Any], **more: Any) -> Situation:
    return from_plain({"others": list(others), **more})


def driven(situation: Situation, seed: int = 0) -> tuple[Episode, tuple[str, ...]]:
    built = build(situation)
    episode = drive(built, seed=seed, ego="idm")
    assert isinstance(episode, Episode), episode
    return episode, failures(judge(situation, episode, simulator(built.map, "native").route(built.program, 0)))


LEAVES = other("B", "ahead", {"act": "cut-out", "to": "left"}, kind="truck")


@pytest.mark.parametrize(
    "slow",
    [
        other("A", "ahead", {"act": "stand"}),
        other("A", "ahead", {"act": "go-along", "manner": "slow"}, kind="truck"),
        other("A", "ahead", {"act": "go-along"}, kind="bicycle"),
    ],
    ids=["stands", "slow", "bicycle"],
)
def test_who_leaves_the_lane_is_before_who_is_slow_and_shows_it_late(slow: dict[str, Any]) -> None:
    situation = said(slow, LEAVES, ego={"speed": "80 km/h"})
    episode, unseen = driven(situation)
    slow_one, leaves, ego = track(episode, "A"), track(episode, "B"), episode.ego_track
    aside = np.hypot(leaves.x - ego.x, leaves.y - ego.y), np.hypot(slow_one.x - ego.x, slow_one.y - ego.y)
    assert unseen == ()
    assert aside[0][0] < aside[1][0]
    apart = np.hypot(leaves.x - slow_one.x, leaves.y - slow_one.y)
    turned = int(np.argmax(np.abs(leaves.heading - leaves.heading[0]) > 0.03))
    assert 20.0 < apart[turned] < 110.0


def test_who_is_ahead_of_another_that_holds_the_ego_does_what_was_said_all_the_same() -> None:
    situation = said(
        other("A", "ahead", {"act": "stop"}, kind="van"), other("B", "ahead", {"act": "brake"}, kind="truck")
    )
    for seed in range(3):
        assert not [one for one in driven(situation, seed)[1] if "never does" in one]


def test_who_brakes_for_who_stops_far_ahead_or_comes_over_behind_somebody_brakes_for_somebody() -> None:
    behind = said(
        other("A", "oncoming", {"act": "drift"}),
        other("B", "behind", {"act": "go-along"}, kind="truck"),
        ego={"speed": "100 km/h"},
    )
    over = said(
        other("A", "roadside", {"act": "enter"}, {"act": "stop"}, kind="child", side="right"),
        other("B", "behind-beside", {"act": "overtake"}, kind="motorcycle", side="left"),
    )
    for situation in (behind, over):
        for seed in range(3):
            assert not [one for one in driven(situation, seed)[1] if one.startswith("unasked.B.brakes")]


def test_a_way_too_short_to_back_up_at_a_speed_is_refused_with_one_that_is_built() -> None:
    def backs(metres: str) -> Situation:
        return said(other("A", "ahead", {"act": "reverse", "speed": "6 km/h", "distance": metres}, kind="van"))

    with pytest.raises(NotBuilt, match=r"A\.does\.0\.distance: 0\.5 m is too short .* say 0\.\d m at least"):
        build(backs("0.5 m"))
    assert not [one for one in driven(backs("1 m"))[1] if ".speed" in one or ".distance" in one]


@pytest.mark.parametrize("kind", ["car", "truck", "bus"])
@pytest.mark.parametrize("numbers", [{}, {"speed": "10 km/h"}])
def test_who_backs_up_covers_the_way_that_was_said_whatever_its_pedals(kind: str, numbers: dict[str, str]) -> None:
    backs = {"act": "reverse", "distance": "6 m", **numbers}
    episode = driven(said(other("A", "ahead", {"act": "stand"}, backs, kind=kind, distance="60 m")))[0]
    speed = track(episode, "A").speed
    assert -float(speed[speed < 0.0].sum()) * episode.dt == pytest.approx(6.0, abs=0.4)


def test_who_comes_the_other_way_in_our_lane_and_is_not_met_gets_out_of_the_way_without_a_word() -> None:
    situation = said(
        other("A", "oncoming", {"act": "go-straight"}, kind="tractor"),
        other("B", "oncoming-in-our-lane", {"act": "go-along"}, kind="van"),
    )
    for seed in range(2):
        assert not [one for one in driven(situation, seed)[1] if one.startswith("unasked.B.lane")]


def test_who_is_not_met_and_crosses_before_a_fast_ego_has_the_road_that_it_takes() -> None:
    situation = said(
        other("A", "arm", {"act": "go-straight"}, kind="truck", side="left"),
        other("B", "roadside", {"act": "cross"}, kind="child", side="left"),
        ego={"speed": "90 km/h"},
    )
    for seed in range(3):
        assert not [one for one in driven(situation, seed)[1] if one.startswith("unasked.contact")]


def test_who_backs_up_ahead_is_beyond_who_leaves_the_lane_for_it() -> None:
    situation = said(
        other("A", "ahead", {"act": "reverse"}),
        other("B", "ahead", {"act": "cut-out", "to": "left"}, kind="truck"),
        ego={"speed": "60 mph"},
        road={"kind": "motorway"},
    )
    assert "A is ahead of B, which hides it until it moves out" in build(situation).assumed
    episode, _ = driven(situation)
    ego, backs, leaves = episode.ego_track, track(episode, "A"), track(episode, "B")
    away = [np.hypot(one.x[0] - ego.x[0], one.y[0] - ego.y[0]) for one in (leaves, backs)]
    assert away[0] < away[1] - 10.0
