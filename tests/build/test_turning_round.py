"""Who turns round over the ego's way is in it while the ego comes, and not behind it."""

from __future__ import annotations

import numpy as np
import pytest
from test_building import drive
from test_towards import car, deed, others, track

from chatscene.build.build import build
from chatscene.terms.episode import Episode


@pytest.mark.parametrize("speed", ["30 km/h", "45 km/h", "70 km/h"])
def test_who_turns_round_from_the_next_lane_comes_into_the_lane_ahead_of_the_ego(speed: str) -> None:
    made = build(others(car("A", "ahead-beside", deed("u-turn"), side="right"), ego={"speed": speed}))
    for seed in range(3):
        episode = drive(made, seed=seed)
        assert isinstance(episode, Episode), episode
        one, own = track(episode), episode.ego_track
        dx, dy = one.x - own.x, one.y - own.y
        ahead = dx * np.cos(own.heading) + dy * np.sin(own.heading)
        aside = dy * np.cos(own.heading) - dx * np.sin(own.heading)
        into = int(np.argmax(aside > -2.0))
        assert aside[into] > -2.0
        assert 0.0 < ahead[into] < 40.0
