"""Contacts of two side by side, of whom one comes over to the other, and of who is in line on foot or comes on."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from test_contacts import driven, track
from test_towards import car, deed, others

from chatscene.build.build import build
from chatscene.terms.situation import Situation

SEEDS = (0, 1)
LANES = {"lanes": 3, "ego_lane": 2}
OVER = {
    "changes lanes": (car("A", "beside", deed("lane-change", to="left"), side="right"), LANES),
    "cuts in": (car("A", "beside", deed("cut-in"), side="left"), {"lanes": 2, "ego_lane": 1}),
    "drifts": (car("A", "beside", deed("drift", to="right"), side="left", kind="bus"), LANES),
    "turns off over our lane": (car("A", "beside", deed("turn-right"), side="left"), {"kind": "junction"}),
}


def struck(name: str, ego: str, **more: str) -> Situation:
    one, road = OVER[name]
    side = one["starts"]["side"]
    contact = {"whom": "A", "ego": ego.replace("near", side), "striker": "other", **more}
    return others(one, road=road, contact=contact)


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("name", OVER)
def test_who_comes_over_from_beside_strikes_that_side_of_the_ego(name: str, seed: int) -> None:
    said = struck(name, "near")
    assert not any(path.startswith("contact") for path in build(said).left_out)
    assert driven(said, seed).collision is not None


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize(("ego", "least", "most"), [("near-front", 1.0, 6.0), ("near-rear", -6.0, -1.0)])
def test_it_is_ahead_whose_tail_is_at_the_egos_front_corner_and_behind_at_the_rear_one(
    ego: str, least: float, most: float, seed: int
) -> None:
    episode = driven(struck("changes lanes", ego), seed)
    assert episode.collision is not None
    step, ego_track, other = episode.collision.step, episode.ego_track, track(episode, "A")
    dx, dy = other.x[step] - ego_track.x[step], other.y[step] - ego_track.y[step]
    heading = ego_track.heading[step]
    assert least < dx * np.cos(heading) + dy * np.sin(heading) < most


@pytest.mark.parametrize("seed", SEEDS)
def test_an_ego_that_changes_lanes_touches_who_is_beside_it_side_by_side(seed: int) -> None:
    said = others(
        car("A", "beside", deed("go-along"), side="right"),
        ego={"route": "lane-change-right"},
        road=LANES,
        contact={"ego": "right", "other": "left", "striker": "ego"},
    )
    assert not build(said).left_out
    episode = driven(said, seed)
    assert episode.collision is not None and episode.collision.side == "right"


@pytest.mark.parametrize("seed", SEEDS)
def test_a_cyclist_runs_into_the_side_of_an_ego_that_turns_off_before_it(seed: int) -> None:
    said = others(
        car("A", "behind-beside", deed("go-along"), side="right", kind="bicycle"),
        ego={"route": "enter-driveway"},
        contact={"ego": "right", "other": "front"},
    )
    assert not build(said).left_out
    episode = driven(said, seed)
    assert episode.collision is not None and episode.collision.side == "right"


IN_LINE: dict[str, Any] = {
    "who stands in our lane on foot is struck by a corner": (
        car("A", "ahead", deed("stand"), kind="pedestrian"),
        {"ego": "right-front", "striker": "ego"},
    ),
    "who walks along in our lane is struck": (
        car("A", "ahead", deed("go-along"), kind="pedestrian", facing="along"),
        {"ego": "front", "striker": "ego"},
    ),
    "who comes against us in our lane strikes us": (
        car("A", "oncoming-in-our-lane", deed("go-along")),
        {"ego": "front", "striker": "other"},
    ),
    "who backs in our lane strikes us": (
        car("A", "ahead", deed("stop"), deed("reverse")),
        {"ego": "front", "other": "rear", "striker": "other"},
    ),
}


@pytest.mark.parametrize("name", IN_LINE)
def test_contacts_in_line_are_built(name: str) -> None:
    one, contact = IN_LINE[name]
    assert not build(others(one, contact=contact)).left_out


def test_who_is_beside_is_not_said_to_be_touched_at_the_other_side() -> None:
    one, road = OVER["changes lanes"]
    assert build(others(one, road=road, contact={"ego": "left"})).left_out == ("contact.ego: left",)
