"""Who runs into the rear of an ego does so after what the ego was said to do, at a speed that fits."""

from __future__ import annotations

from typing import Any

import pytest
from test_contacts import STRUCK, driven, track
from test_towards import car, deed, others

from chatscene.build.build import build
from chatscene.build.struck import slows_turning
from chatscene.terms.episode import Episode

SEEDS = (0, 1)


def struck(*does: dict[str, Any], seed: int, follows: dict[str, Any] | None = None, **said: Any) -> Episode:
    """A drive in which somebody runs into the rear of an ego that does something."""
    ego = {"does": list(does), **said.pop("ego", {})}
    episode = driven(others(car("A", "behind", follows or deed("go-along")), ego=ego, contact=STRUCK, **said), seed)
    assert episode.collision is not None
    assert episode.collision.other == "A"
    return episode


def at_contact(episode: Episode, name: str) -> float:
    """The speed [m/s] of somebody just before the contact."""
    assert episode.collision is not None
    return float(track(episode, name).speed[episode.collision.step - 1])


@pytest.mark.parametrize("seed", SEEDS)
def test_an_ego_that_gives_way_before_a_turn_comes_to_a_stand_and_is_struck_at_the_speed_that_was_said(
    seed: int,
) -> None:
    slow = {**deed("go-along"), "speed": "7 mph"}
    turns: dict[str, Any] = {"ego": {"route": "right-turn"}, "road": {"kind": "junction"}}
    episode = struck(deed("yield"), seed=seed, follows=slow, **turns)
    assert episode.ego_track.speed[0] > 8.0
    assert at_contact(episode, "ego") < 0.3
    assert at_contact(episode, "A") == pytest.approx(3.13, abs=0.4)


@pytest.mark.parametrize("seed", SEEDS)
def test_an_ego_that_sets_off_is_struck_as_it_has_begun_to_move(seed: int) -> None:
    episode = struck(deed("stand"), deed("set-off"), seed=seed)
    assert episode.ego_track.speed[0] < 0.1
    assert 0.5 < at_contact(episode, "ego") < at_contact(episode, "A")


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("act", ["stand", "stop"])
def test_who_fails_to_see_a_standing_ego_is_slower_than_the_traffic(act: str, seed: int) -> None:
    episode = struck(deed(act), seed=seed)
    assert at_contact(episode, "ego") < 0.3
    assert 3.0 < at_contact(episode, "A") < 9.0


@pytest.mark.parametrize("seed", SEEDS)
def test_an_ego_that_slows_down_in_a_turn_has_begun_to_turn_when_it_is_struck(seed: int) -> None:
    turns: dict[str, Any] = {"ego": {"route": "left-turn"}, "road": {"kind": "junction"}}
    episode = struck(deed("slow-down"), seed=seed, **turns)
    assert at_contact(episode, "ego") < 0.5 * episode.ego_track.speed[0]
    assert episode.ego_track.heading[-1] - episode.ego_track.heading[0] > 0.02


def test_how_an_ego_sets_off_that_is_struck_then_is_told() -> None:
    said = others(car("A", "behind", deed("go-along")), ego={"does": [deed("set-off")]}, contact=STRUCK)
    assert any("the ego sets off slowly, at" in one for one in build(said).assumed)


def test_an_ego_that_is_struck_as_it_turns_to_a_side_that_was_not_said_slows_in_the_turn() -> None:
    slows = {"does": [deed("slow-down")]}
    for route in ("left-turn", "turn"):
        ego = {"route": route, **slows}
        assert slows_turning(others(car("A", "behind", deed("go-along")), ego=ego, contact=STRUCK))
