"""A speed that was said is held, if a body of the kind can; nobody else is faster for it."""

from __future__ import annotations

from functools import cache
from typing import Any

import pytest

from benchmarks.differing import differences
from chatscene.build.build import build
from chatscene.ego.policy import load_ego
from chatscene.errors import NotBuilt
from chatscene.maps.network import resolve_map
from chatscene.program.sample import draw
from chatscene.settings import SimulationSettings
from chatscene.simulate.simulator import Simulator, load_simulator, simulate
from chatscene.situations.form import from_plain
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.episode import Episode
from chatscene.terms.scene import Scene, ScenicProgram


@cache
def simulator(map_name: str, by: str) -> Simulator:
    return load_simulator(resolve_map(map_name), SimulationSettings(simulator=by))


def drive(program: ScenicProgram, map_name: str, ego: str, by: str = "native") -> Episode:
    scene = Scene(id="fast/0", scenario_id="fast", route=0, block=0, seed=1, values=draw(program.parameters, seed=1))
    episode = simulate(simulator(map_name, by), program, scene, load_ego(ego))
    assert isinstance(episode, Episode), episode
    return episode


def beside(**ego: Any) -> dict[str, Any]:
    starts = {"where": "ahead-beside", "side": "right", "speed": "120 km/h"}
    others = [{"id": "A", "kind": "car", "starts": starts, "does": [{"act": "go-along"}]}]
    return {"ego": ego, "road": {"kind": "motorway"}, "others": others}


@pytest.mark.parametrize("ego", ["idm", "planner"])
@pytest.mark.parametrize("speed", [160, 200, 250])
def test_an_ego_holds_the_speed_that_was_said_in_both_simulators(ego: str, speed: int) -> None:
    one = build(from_plain(beside(speed=f"{speed} km/h")))
    episode = drive(one.program, one.map, ego)
    assert episode.stepped.by == "native"
    assert 3.6 * episode.ego_track.speed[:30] == pytest.approx([speed] * 30, abs=2.5)
    assert differences(episode, drive(one.program, one.map, ego, "embedded")) == []
    assert "the ego is a car that is faster than most, which hold 130 km/h" in one.assumed


def test_who_is_not_said_to_be_faster_than_most_is_as_strong_as_before() -> None:
    assert "topSpeed" not in build(from_plain(beside(speed="130 km/h"))).program.source
    assert build(from_plain(beside(speed="160 km/h"))).program.source.count("topSpeed") == 1


def test_who_passes_a_fast_ego_can() -> None:
    does = [{"act": "overtake"}, {"act": "cut-in"}]
    others = [{"id": "A", "kind": "car", "starts": {"where": "behind-beside", "side": "left"}, "does": does}]
    one = build(from_plain({"ego": {"speed": "180 km/h"}, "road": {"kind": "motorway"}, "others": others}))
    ego, other = drive(one.program, one.map, "idm").tracks
    assert 3.6 * ego.speed[:30] == pytest.approx([180] * 30, abs=2.5)
    assert (other.speed[:30] > ego.speed[:30] + 1.0).all()


def test_who_follows_a_fast_ego_keeps_up() -> None:
    others = [{"id": "A", "kind": "car", "starts": {"where": "behind"}, "does": [{"act": "follow"}]}]
    one = build(from_plain({"ego": {"speed": "200 km/h"}, "road": {"kind": "motorway"}, "others": others}))
    ego, other = drive(one.program, one.map, "idm").tracks
    assert float(abs(other.speed - ego.speed).max()) < 3.0


@pytest.mark.parametrize(
    ("kind", "speed", "most"),
    [("e-scooter", 40, 45), ("bicycle", 55, 70), ("pedestrian", 25, 27), ("motorcycle", 200, 250)],
)
def test_others_are_as_fast_as_was_said_up_to_what_their_kind_can(kind: str, speed: int, most: int) -> None:
    def crosses(at: int) -> dict[str, Any]:
        does = [{"act": "cross", "speed": f"{at} km/h"}]
        return {"others": [{"id": "A", "kind": kind, "starts": {"where": "roadside", "side": "right"}, "does": does}]}

    one = build(from_plain(crosses(speed)))
    other = drive(one.program, one.map, "idm").tracks[1]
    assert 3.6 * float(other.speed.max()) == pytest.approx(speed, abs=1.0)
    with pytest.raises(NotBuilt, match=rf"{most + 20} km/h is more than .* can do: at most {most} km/h"):
        build(from_plain(crosses(most + 20)))


def test_a_stronger_one_holds_what_it_is_made_for_and_no_other_body_changes() -> None:
    for kind in AdversaryKind:
        row = kind.row
        assert row.at(row.limits.holds) is row
        if row.most:
            assert row.at(row.most).limits.holds >= row.most
            assert row.at(2 * row.most).limits.fastest == row.most
