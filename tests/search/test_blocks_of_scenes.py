"""Scenes are driven and judged in blocks, and what comes of each is what came of it alone."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import pytest

from chatscene.ego.policy import load_ego
from chatscene.ego.rule_based import RuleBased
from chatscene.maps.network import resolve_map
from chatscene.measure import drive as judging
from chatscene.measure.drive import Ran, drive, drive_all
from chatscene.program.sample import draw
from chatscene.search import explore
from chatscene.settings import SearchSettings, SimulationSettings
from chatscene.simulate.simulator import load_simulator
from chatscene.terms.scenario import Slots
from chatscene.terms.scene import Rejected, Scene, ScenicProgram
from chatscene.terms.snippet import ParameterRange

SOURCE = """model chatscene.world.model
param OPT_DISTANCE = Range(12, 30)
egoRoute = selectRoute(maneuver="straight")
behavior AdvBehavior():
    do BrakeOnPath(egoRoute, 6)
ego = new Car at startOf(egoRoute), facing directionOn(egoRoute, 0), with route egoRoute, with speed 9
AdvAgent = new Car at pointOn(egoRoute, globalParameters.OPT_DISTANCE), facing directionOn(egoRoute, 30),
    with behavior AdvBehavior(), with speed 6
"""
PROGRAM = ScenicProgram(
    scenario_id="own",
    source=SOURCE,
    parameters=(ParameterRange(name="OPT_DISTANCE", low=12.0, high=30.0, unit="m"),),
    snippet_ids=(),
)


def _scene(number: int) -> Scene:
    values = draw(PROGRAM.parameters, seed=number)
    return Scene(id=f"own/{number}", scenario_id="own", route=0, block=0, seed=number, values=values)


def _told(ran: Ran | Rejected) -> list[Any]:
    """All that came of a scene, arrays by their bytes."""
    assert isinstance(ran, Ran)
    tracks = [(one.actor, one.x.tobytes(), one.y.tobytes(), one.speed.tobytes()) for one in ran.episode.tracks]
    return [tracks, ran.episode.events, ran.episode.ending, *(repr(getattr(ran, name)) for name in _NUMBERS)]


_NUMBERS = (
    *("scene", "measurements", "metrics", "meaning", "criticality", "speeds", "happened", "fault", "avoidable"),
    *("crash_type", "waits", "unplayed", "cut", "touch"),
)


@pytest.mark.parametrize("size", [3, 16])
def test_what_comes_of_a_scene_does_not_depend_on_the_block_it_is_in(
    size: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    simulator = load_simulator(resolve_map("town"), SimulationSettings(simulator="native"))
    ego, scenes = load_ego("sac"), [_scene(number) for number in range(8)]
    alone = [_told(drive(PROGRAM, Slots(), one, simulator=simulator, ego=ego)) for one in scenes]
    monkeypatch.setattr(judging, "BLOCK", size)
    together = drive_all(PROGRAM, Slots(), scenes, simulator=simulator, ego=ego)
    assert [_told(ran) for ran in together] == alone
    assert len({str(one) for one in alone}) == len(alone)


def test_a_scene_that_cannot_be_placed_is_drawn_again_in_its_place(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[list[str]] = []
    template = _ran()

    def placed(_: object, __: object, scenes: Sequence[Scene], **___: object) -> list[Ran | Rejected]:
        asked.append([scene.id for scene in scenes])
        bad = ("scene-000", "scene-002", "scene-002.1")  # and 003 never
        return [
            Rejected(scene=one, reason="no place")
            if one.id.endswith(bad) or "scene-003" in one.id
            else replace(template, scene=one)
            for one in scenes
        ]

    monkeypatch.setattr(explore, "drive_all", placed)
    settings = SearchSettings(scenes=4, block=4, keep=1, tries=3, sampler="random")
    (block,) = explore.explore(PROGRAM, Slots(), 0, simulator=_NOWHERE, ego=RuleBased(), settings=settings)
    stem = "own/route-00/scene-"
    assert [ran.scene.id for ran in block.ran] == [f"{stem}000.1", f"{stem}001", f"{stem}002.2"]
    assert [one.scene.id for one in block.rejected] == [
        *(f"{stem}000", f"{stem}002", f"{stem}002.1"),
        *(f"{stem}003", f"{stem}003.1", f"{stem}003.2"),
    ]
    assert [len(scenes) for scenes in asked] == [4, 3, 2, 0]


_NOWHERE: Any = None


def _ran() -> Ran:
    simulator = load_simulator(resolve_map("town"), SimulationSettings(simulator="embedded", max_steps=5))
    ran = drive(PROGRAM, Slots(), _scene(0), simulator=simulator, ego=RuleBased())
    assert isinstance(ran, Ran)
    return ran
