"""An ego that does something once somebody else does, whatever its plan is."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from test_starting import driven, track

from chatscene.build.build import build
from chatscene.errors import NotBuilt
from chatscene.situations.form import from_plain

MET: dict[str, Any] = {"id": "A", "kind": "car", "starts": {"where": "ahead"}, "does": [{"act": "slow-down"}]}


def said(ego: list[dict[str, Any]], *others: dict[str, Any]) -> dict[str, Any]:
    return {"ego": {"speed": "50 km/h", "does": ego}, "others": list(others)}


@pytest.mark.parametrize("name", ("after", "during"))
def test_the_ego_changes_lanes_no_sooner_than_who_is_beside_it_brakes(name: str) -> None:
    beside = {"id": "B", "kind": "truck", "role": "supporting", "starts": {"where": "beside", "side": "right"}}
    brakes = beside | {"does": [{"act": "go-along", "time": "3 s"}, {"act": "brake"}]}
    change = {"act": "lane-change", "to": "right", "when": {name: "B.brake"}}
    episode = driven(said([change], MET | {"does": [{"act": "go-along"}]}, brakes))
    braked = np.flatnonzero(track(episode, "B").speed < 0.98 * track(episode, "B").speed[10])[0]
    moved = np.flatnonzero(episode.distance_to_route > 0.3)[0]
    assert moved >= braked


def test_the_ego_sets_off_once_who_is_ahead_does() -> None:
    ahead = MET | {"does": [{"act": "stand", "time": "3 s"}, {"act": "set-off"}, {"act": "stop"}]}
    episode = driven(said([{"act": "stand"}, {"act": "set-off", "when": {"after": "A.set-off"}}], ahead))
    ego, other = (np.flatnonzero(one.speed > 0.3) for one in (episode.ego_track, track(episode)))
    assert other[0] < ego[0]


def test_for_what_somebody_ahead_does_from_the_first_the_ego_waits_until_it_is_near() -> None:
    change = {"act": "lane-change", "to": "left", "when": {"during": "A.stand"}}
    episode = driven(said([change], MET | {"does": [{"act": "stand"}]}))
    moved = np.flatnonzero(episode.distance_to_route > 0.3)[0]
    ego, other = (np.array([one.x[moved], one.y[moved]]) for one in (episode.ego_track, track(episode)))
    assert 10.0 < np.linalg.norm(ego - other) < 80.0


def test_waiting_for_what_somebody_behind_does_from_the_first_is_refused() -> None:
    change = {"act": "lane-change", "to": "left", "when": {"during": "B.go-along"}}
    behind = {
        "id": "B",
        "kind": "car",
        "role": "supporting",
        "starts": {"where": "behind"},
        "does": [{"act": "go-along"}],
    }
    with pytest.raises(NotBuilt, match="which B does from the start"):
        build(from_plain(said([change], MET | {"does": [{"act": "stand"}]}, behind)))
