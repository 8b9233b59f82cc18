"""Who stands before an ego that stops stands right there; who backs into it does so then, and as far as to it."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from test_contacts import STRUCK, driven, track
from test_towards import car, deed, others

from chatscene.build.build import build
from chatscene.simulate.boxes import gaps

SEEDS = (0, 1)
BACKED = {"whom": "A", "ego": "front", "other": "rear", "striker": "other"}
QUIET: dict[str, Any] = {"role": "supporting"}


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("does", [(), (deed("stand"),)])
@pytest.mark.parametrize("act", ["stop", "stand"])
def test_an_ego_that_stops_and_is_struck_stands_right_behind_who_is_ahead(
    act: str, does: tuple[dict[str, Any], ...], seed: int
) -> None:
    before = car("B", "ahead", *does) | QUIET
    said = others(car("A", "behind", deed("go-along")), before, ego={"does": [deed(act)]}, contact=STRUCK)
    episode = driven(said, seed)
    assert episode.collision is not None
    assert episode.collision.other == "A"
    assert abs(track(episode, "B").speed).max() < 0.1
    assert 1.0 < gaps(episode.ego_track, track(episode, "B"))[episode.collision.step - 1] < 6.0


def test_that_somebody_ahead_stands_is_told_if_it_was_not_said() -> None:
    before = car("B", "ahead") | QUIET
    said = others(car("A", "behind", deed("go-along")), before, ego={"does": [deed("stop")]}, contact=STRUCK)
    assert "B stands, since the ego stops behind it" in build(said).assumed


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("after", [None, "ego.stop"])
def test_who_backs_into_an_ego_that_stops_behind_it_does_so_once_it_stands(after: str | None, seed: int) -> None:
    backs = deed("reverse") | ({} if after is None else {"when": {"after": after}})
    said = others(car("A", "ahead", deed("stand"), backs), ego={"does": [deed("stop")]}, contact=BACKED)
    episode = driven(said, seed)
    assert episode.collision is not None
    assert (episode.collision.other, episode.collision.side) == ("A", "front")
    assert episode.ego_track.speed[episode.collision.step - 1] < 0.1
    assert track(episode, "A").speed[episode.collision.step - 1] < -0.5


@pytest.mark.parametrize("seed", SEEDS)
def test_an_ego_that_has_begun_to_swing_out_is_backed_into_as_it_stands(seed: int) -> None:
    backs = car("A", "ahead", deed("stand"), deed("reverse"))
    said = others(backs, ego={"route": "bypass", "does": [deed("stop")]}, contact=BACKED)
    episode = driven(said, seed)
    assert episode.collision is not None
    assert episode.collision.other == "A"
    assert episode.ego_track.heading[-1] - episode.ego_track.heading[0] > 0.02


@pytest.mark.parametrize("seed", SEEDS)
def test_an_ego_that_has_gone_round_one_stops_behind_another_beyond_it(seed: int) -> None:
    backs, stands = car("A", "ahead", deed("stand"), deed("reverse")), car("B", "ahead", deed("stand")) | QUIET
    said = others(backs, stands, ego={"route": "bypass", "does": [deed("stop")]}, contact=BACKED)
    episode = driven(said, seed)
    assert episode.collision is not None
    assert episode.collision.other == "A"
    ego, passed = episode.ego_track, track(episode, "B")
    ahead = (passed.x - ego.x) * np.cos(ego.heading) + (passed.y - ego.y) * np.sin(ego.heading)
    assert ahead[0] > 20.0
    assert ahead[-1] < -20.0
