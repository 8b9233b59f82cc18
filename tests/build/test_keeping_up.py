"""Who goes on beside the ego, over whose way the ego goes, is there when the ego is; else nothing could come of it."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from test_building import drive

from chatscene.build.build import Built, build
from chatscene.situations.form import from_plain
from chatscene.terms.episode import Episode


def beside(kind: str, where: str, side: str, route: str, **ego: Any) -> Built:
    one = {"id": "A", "kind": kind, "starts": {"where": where, "side": side}, "does": [{"act": "go-along"}]}
    return build(from_plain({"ego": {"route": route, **ego}, "others": [one]}))


def nearest(built: Built, seed: int) -> float:
    """How near [m] the two come to each other."""
    episode = drive(built, seed=seed)
    assert isinstance(episode, Episode), episode
    ego, other = episode.ego_track, next(track for track in episode.tracks if track.actor == "A")
    return float(np.hypot(other.x - ego.x, other.y - ego.y).min())


@pytest.mark.parametrize(
    ("kind", "where", "side", "route"),
    [
        ("bicycle", "behind-beside", "right", "right-turn"),
        ("bicycle", "beside", "right", "right-turn"),
        ("car", "behind-beside", "left", "lane-change-left"),
        ("motorcycle", "behind-beside", "left", "lane-change-left"),
    ],
)
def test_they_come_near_each_other(kind: str, where: str, side: str, route: str) -> None:
    built = beside(kind, where, side, route)
    assert all(nearest(built, seed) < 6.0 for seed in range(3))


def test_the_ego_is_slower_for_who_cannot_keep_up_and_that_is_told() -> None:
    built = beside("bicycle", "behind-beside", "right", "right-turn")
    assert built.program.wanted_speed is not None
    assert built.program.wanted_speed < 6.0
    assert any("the ego drives at" in one for one in built.assumed)


def test_a_speed_that_was_said_of_the_ego_stays() -> None:
    built = beside("bicycle", "behind-beside", "right", "right-turn", speed="20 km/h")
    assert built.program.wanted_speed == pytest.approx(20 / 3.6, abs=0.01)


def test_the_ego_comes_as_fast_as_who_slows_down_to_a_speed_ahead_of_it() -> None:
    one = {"id": "A", "kind": "car", "starts": {"where": "ahead"}}
    built = build(from_plain({"others": [one | {"does": [{"act": "brake", "manner": "hard", "speed": "100 km/h"}]}]}))
    assert built.program.wanted_speed is not None
    assert built.program.wanted_speed > 110 / 3.6
    episode = drive(built)
    assert isinstance(episode, Episode), episode
    assert next(one for one in episode.tracks if one.actor == "A").speed.min() == pytest.approx(100 / 3.6, rel=0.1)


@pytest.mark.parametrize(("does", "told"), [(("stand",), False), (("stand", "set-off"), True)])
def test_of_an_ego_that_only_stands_no_speed_is_told(does: tuple[str, ...], told: bool) -> None:
    built = beside("bicycle", "behind-beside", "right", "straight", does=[{"act": act} for act in does])
    assert any("the ego drives at" in one for one in built.assumed) is told
