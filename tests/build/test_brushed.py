"""What the ego is to brush with its side stands where its way leads past it."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from test_building import drive, simulator
from test_towards import others

from chatscene.build.build import build
from chatscene.program.judge import judge
from chatscene.terms.episode import Episode, Track
from chatscene.terms.situation import Situation

BRUSHED = {"whom": "A", "ego": "right-rear", "striker": "ego"}


def standing(kind: str, where: str, route: str | None, **contact: str) -> Situation:
    one: dict[str, Any] = {"id": "A", "kind": kind, "starts": {"where": where, "side": "right"}}
    ego = {} if route is None else {"route": route}
    road = {"kind": "junction"} if route == "right-turn" else {}
    return others(one | {"does": [{"act": "stand"}]}, ego=ego, road=road, contact=BRUSHED | contact)


def driven(said: Situation) -> tuple[Episode, Track, bool | None]:
    """A drive, who stands there, and whether our judge finds that the ego's way leads past it."""
    made = build(said)
    assert not made.left_out
    episode = drive(made, ego="planner")
    assert isinstance(episode, Episode), episode
    findings = judge(said, episode, simulator(made.map, "native").route(made.program, 0))
    shown = next(one.shown for one in findings if one.path == "encounter.A")
    return episode, next(one for one in episode.tracks if one.actor == "A"), shown


@pytest.mark.parametrize(
    ("kind", "where", "route"),
    [("hedge", "roadside", "right-turn"), ("car", "kerb", "leave-driveway"), ("pickup", "kerb", None)],
)
def test_the_way_of_the_ego_leads_close_past_what_it_is_to_brush(kind: str, where: str, route: str | None) -> None:
    episode, stands, shown = driven(standing(kind, where, route))
    assert shown
    ego = episode.ego_track
    k = int(np.argmin(np.hypot(stands.x[0] - ego.x, stands.y[0] - ego.y)))
    right = (stands.x[0] - ego.x[k]) * np.sin(ego.heading[k]) - (stands.y[0] - ego.y[k]) * np.cos(ego.heading[k])
    assert 1.0 < right < 4.5
    if route is not None:  # while it turns
        assert abs(ego.heading[k] - ego.heading[0]) > 0.4


def test_what_the_ego_only_passes_is_not_brushed_to_our_judge() -> None:
    said = standing("car", "kerb", None)
    made = build(others({"id": "A", "kind": "car", "starts": {"where": "kerb", "side": "right"}}))
    episode = drive(made, ego="planner")
    assert isinstance(episode, Episode)
    findings = judge(said, episode, simulator(made.map, "native").route(made.program, 0))
    assert not next(one.shown for one in findings if one.path == "encounter.A")
