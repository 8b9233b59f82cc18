"""Which part is met, whom somebody shows or hides, and where a lane beside the ego's is needed."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from test_starting import driven, someone, track

from chatscene.build.build import build
from chatscene.build.sweep import Moving, touches
from chatscene.situations.form import from_plain
from chatscene.terms.polyline import Polyline

LONG = 100.0  # [m]
SOONER = np.linspace(-1.0, 1.5, 51)  # [s] than the ego
EGO = Moving(line=Polyline([(-LONG, 0), (LONG, 0)]), meets_at=LONG, speed=10.0, length=4.5, width=2.0)
FROM_LEFT = Moving(line=Polyline([(0, LONG), (0, -LONG)]), meets_at=LONG, speed=10.0, length=4.5, width=2.0)


def test_who_comes_later_runs_into_the_flank_of_the_other() -> None:
    found = touches(EGO, FROM_LEFT, SOONER)
    met = [(sooner, one) for sooner, one in zip(SOONER.tolist(), found, strict=True) if one is not None]
    assert {one.ego for sooner, one in met if sooner < -0.1} == {"left"}
    assert {one.other for sooner, one in met if sooner > 0.1} == {"right"}
    assert all(one.by_ego is (sooner > 0.0) for sooner, one in met if abs(sooner) > 0.1)
    reach = (4.5 + 2.0) / 10.0
    assert met[0][0] == pytest.approx(-reach, abs=0.1)
    assert met[-1][0] == pytest.approx(reach, abs=0.1)


def offset(**contact: Any) -> tuple[float, float, tuple[str, ...]]:
    """From when to when [s] before the ego somebody from the left is there, and what is not aimed at."""
    said = someone("arm", "go-straight", side="left", speed="40 km/h") | {"contact": contact}
    built = build(from_plain(said))
    (one,) = (one for one in built.program.parameters if one.name == "OPT_A_OFFSET")
    return one.low, one.high, built.left_out


def test_the_part_that_was_said_narrows_when_somebody_is_there() -> None:
    low, high, _ = offset()
    later, sooner = offset(striker="other"), offset(striker="ego")
    assert low == later[0] < later[1] < sooner[0] < sooner[1] == high
    flank, tail = offset(ego="left", striker="other"), offset(ego="front", other="right-rear")
    assert low <= flank[0] < flank[1] < tail[0] < tail[1] <= high
    assert offset(ego="right")[2] == ("contact.ego: right",)  # who comes from the left meets no right side
    assert offset(happens=False)[0] >= high


@pytest.mark.parametrize("seed", range(3))
def test_an_aim_at_the_tail_lets_the_ego_pass_first_and_a_near_miss_lets_the_other(seed: int) -> None:
    def there_at(contact: dict[str, Any]) -> float:
        said = someone("arm", "go-straight", side="left", speed="40 km/h") | {"contact": contact}
        episode = driven(said, seed=seed)
        one, ego = track(episode), episode.ego_track
        aside = (one.x - ego.x[0]) * np.sin(ego.heading[0]) - (one.y - ego.y[0]) * np.cos(ego.heading[0])
        return float(np.abs(aside).argmin() * episode.dt)

    assert there_at({"ego": "rear"}) > there_at({"ego": "front"}) > there_at({"happens": False})


def test_who_leaves_the_lane_does_so_before_who_stands_in_it() -> None:
    said = someone("ahead", "cut-out")
    said["others"][0]["role"] = "supporting"
    said["others"].append({"id": "B", "kind": "car", "starts": {"where": "ahead"}, "does": [{"act": "stand"}]})
    for seed in range(3):
        episode = driven(said, seed=seed)
        a, b = track(episode), track(episode, "B")
        assert np.hypot(a.x - b.x, a.y - b.y).min() > 2.4


@pytest.mark.parametrize(
    ("where", "act", "to", "beside"),
    [
        ("ahead", "cut-out", None, "left"),
        ("ahead", "cut-out", "right", "right"),
        ("ahead", "lane-change", "left", "left"),
        ("behind", "overtake", None, "left"),
    ],
)
def test_who_goes_over_beside_the_ego_has_a_lane_there(where: str, act: str, to: str | None, beside: str) -> None:
    said = someone(where, act)
    if to is not None:
        said["others"][0]["does"][0]["to"] = to
    assert f"beside='{beside}'" in build(from_plain(said)).program.source
    one_lane = build(from_plain(said | {"road": {"lanes": 1}})) if beside == "left" else None
    assert one_lane is None or "beside" not in one_lane.program.source.split("egoRoute =")[1].split("\n")[0]


def test_who_is_in_a_bus_bay_stands_beside_the_lane_and_pulls_out() -> None:
    episode = driven(someone("bus-bay", "stand", "pull-out", kind="bus"))
    bus, ego = track(episode), episode.ego_track
    aside = (bus.x - ego.x[0]) * np.sin(ego.heading[0]) - (bus.y - ego.y[0]) * np.cos(ego.heading[0])
    assert aside[0] > 2.5
    assert abs(aside[-1]) < 1.0


def test_who_stands_in_the_way_may_hide_somebody_though_it_is_there_for_more() -> None:
    said = someone("roadside", "cross", kind="pedestrian", side="right")
    said["others"][0]["hidden_by"] = "B"
    kerb = {"where": "kerb", "side": "right"}
    said["others"].append(
        {"id": "B", "kind": "truck", "role": "supporting", "starts": kerb, "does": [{"act": "stand"}]}
    )
    assert build(from_plain(said)).left_out == ()
