"""Who is hidden by somebody on the road: in a queue against us, in the next lane, opposite us, at the kerb."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from test_building import drive

from chatscene.build.build import build
from chatscene.errors import NotBuilt
from chatscene.program.meaning import in_between
from chatscene.situations.form import from_plain
from chatscene.terms.episode import Episode, Track

WALKS = {"id": "A", "kind": "pedestrian", "starts": {"where": "roadside"}, "hidden_by": "B", "does": [{"act": "cross"}]}
COMES = {"id": "A", "kind": "car", "starts": {"where": "oncoming"}, "hidden_by": "B", "does": [{"act": "go-straight"}]}


def said(hidden: dict[str, Any], where: str, act: str, *, kind: str = "car", **more: Any) -> dict[str, Any]:
    one = {"id": "B", "kind": kind, "role": "hides", "starts": {"where": where}, "does": [{"act": act}]}
    return {"others": [hidden, one | more.pop("of_b", {})], **more}


def driven(plain: dict[str, Any]) -> tuple[Episode, Track, Track]:
    episode = drive(build(from_plain(plain)), seed=1, ego="idm")
    assert isinstance(episode, Episode), episode
    tracks = {one.actor: one for one in episode.tracks}
    return episode, tracks["A"], tracks["B"]


def begins(track: Track) -> int:
    """The first step in which somebody has moved."""
    return int(np.argmax(np.hypot(track.x - track.x[0], track.y - track.y[0]) > 0.5))


def to_left(episode: Episode, track: Track) -> float:
    """How far [m] somebody is to the left of the ego at first, as it faces."""
    ego, cos, sin = episode.ego_track, np.cos(episode.ego_track.heading[0]), np.sin(episode.ego_track.heading[0])
    return float(-(track.x[0] - ego.x[0]) * sin + (track.y[0] - ego.y[0]) * cos)


QUEUE = said(WALKS, "oncoming", "stand", of_b={"count": 2})
STOPS = said(WALKS, "ahead-beside", "stop")
PASSES = said(WALKS, "oncoming", "go-along")


@pytest.mark.parametrize("plain", [QUEUE, STOPS], ids=["in a queue against us", "by who stops in the next lane"])
def test_who_is_hidden_on_the_road_comes_out_behind_whoever_hides_it(plain: dict[str, Any]) -> None:
    episode, walks, by = driven(plain)
    assert in_between(by, episode.ego_track, walks, begins(walks))


def test_a_queue_against_us_stands_in_the_lane_to_our_left_and_faces_us() -> None:
    episode, _, by = driven(QUEUE)
    assert 2.5 < to_left(episode, by) < 4.5
    assert abs(np.cos(by.heading[0] - episode.ego_track.heading[0]) + 1.0) < 0.01


def test_who_stops_in_the_next_lane_comes_driving_and_stands_before_who_is_hidden_comes_out() -> None:
    _, walks, by = driven(STOPS)
    assert by.speed[0] > 4.0
    assert by.speed[begins(walks)] < 0.2


def test_who_passes_us_hides_whoever_crosses_behind_it_and_touches_nobody() -> None:
    episode, walks, by = driven(PASSES)
    shared = min(len(by.x), len(walks.x))
    assert np.hypot(by.x[:shared] - walks.x[:shared], by.y[:shared] - walks.y[:shared]).min() > 2.0
    assert in_between(by, episode.ego_track, walks, begins(walks) - 2)


@pytest.mark.parametrize(("act", "speed"), [("stand", 0.0), ("stop", 4.0)])
def test_who_waits_opposite_is_in_another_lane_than_whom_it_hides(act: str, speed: float) -> None:
    plain = said(COMES, "oncoming", act, kind="van", ego={"route": "left-turn"}, road={"kind": "junction"})
    episode, comes, waits = driven(plain)
    assert waits.speed[0] >= speed
    assert waits.speed.min() < 0.2
    assert to_left(episode, comes) - to_left(episode, waits) > 3.0
    assert any(in_between(waits, episode.ego_track, comes, step) for step in range(len(comes.x)))


def test_who_pulls_out_is_hidden_by_who_stands_before_it_at_the_kerb() -> None:
    does = [{"act": "stand"}, {"act": "pull-out"}]
    parked = {"id": "A", "kind": "car", "starts": {"where": "kerb", "side": "right"}, "hidden_by": "B", "does": does}
    episode, pulls, by = driven(said(parked, "kerb", "stand", kind="truck", of_b={"starts": {"where": "kerb"}}))
    assert in_between(by, episode.ego_track, pulls, begins(pulls))


def test_who_goes_on_through_whom_it_would_hide_is_refused_with_what_could_be() -> None:
    with pytest.raises(NotBuilt, match=r"others\.B hiding A: say that it stands or stops"):
        build(from_plain(said(WALKS, "ahead-beside", "go-along")))


def test_who_waits_opposite_does_not_come_over_our_way() -> None:
    other = {
        "id": "B",
        "kind": "car",
        "role": "supporting",
        "starts": {"where": "oncoming"},
        "does": [{"act": "stand"}],
    }
    arm = {"id": "A", "kind": "car", "starts": {"where": "arm", "side": "left"}, "does": [{"act": "go-straight"}]}
    episode, _, waits = driven({"road": {"kind": "four-way"}, "others": [arm, other]})
    ego = episode.ego_track
    ahead = (waits.x[0] - ego.x[0]) * np.cos(ego.heading[0]) + (waits.y[0] - ego.y[0]) * np.sin(ego.heading[0])
    assert ahead > 40.0
    assert to_left(episode, waits) > 2.5


def test_who_comes_too_fast_for_one_road_is_looked_for_on_another() -> None:
    fast = COMES | {"does": [{"act": "go-straight", "speed": "60 km/h"}]}
    plain = said(fast, "oncoming", "stand", kind="truck", ego={"route": "left-turn", "speed": "15 km/h"})
    _, comes, _ = driven(plain | {"road": {"kind": "junction"}})
    assert comes.speed[0] == pytest.approx(60 / 3.6, rel=0.02)


def test_who_goes_on_ahead_of_the_ego_does_not_stand_beside_the_road_to_hide_somebody() -> None:
    with pytest.raises(NotBuilt, match=r"does: \w+ hides A, so it only stands there"):
        build(from_plain(said(WALKS, "ahead", "go-along")))


@pytest.mark.parametrize("side", ["left", "right"])
@pytest.mark.parametrize("of", ["A", "B"], ids=["of who is hidden", "of who hides"])
def test_who_is_hidden_from_beside_the_road_and_who_hides_it_are_on_the_side_that_is_said_of_one(
    side: str, of: str
) -> None:
    plain = said(WALKS, "kerb", "stand", kind="bus")
    sided = {"starts": {"where": "roadside" if of == "A" else "kerb", "side": side}}
    plain["others"] = [one | sided if one["id"] == of else one for one in plain["others"]]
    episode, hidden, hides = driven(plain)
    assert np.sign(to_left(episode, hidden)) == np.sign(to_left(episode, hides)) == (1.0 if side == "left" else -1.0)
