"""Scenes that are placed by what was learned of one before stand where Scenic places them."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest

from benchmarks.differing import differences
from chatscene.build.build import build
from chatscene.ego.policy import load_ego, observation_of, pedals_of
from chatscene.maps.network import resolve_map
from chatscene.program.sample import scene_at
from chatscene.search.generator import load_generator
from chatscene.settings import RetrievalSettings, SimulationSettings
from chatscene.simulate.native.simulator import NativeSimulator
from chatscene.simulate.session import SteppedSession
from chatscene.simulate.simulator import Simulator, load_simulator, simulate
from chatscene.simulate.stepped import SteppedSimulator
from chatscene.situations.form import from_plain
from chatscene.terms.episode import Episode
from chatscene.terms.scenario import BaseScenario
from chatscene.terms.scene import Rejected, Scene, ScenicProgram
from chatscene.terms.snippet import ParameterRange

HEAD = """model chatscene.world.model
param OPT_AHEAD = Range(10, 90)
egoRoute = selectRoute(maneuver="straight", place="road")
ego = new Car at startOf(egoRoute), facing directionOn(egoRoute, 0), with route egoRoute
behavior AdvBehavior():
    do DrivePath(egoRoute, 5)
"""
PLACED = "other = new Car at pointOn(egoRoute, {at}), facing directionOn(egoRoute, {at}), with behavior AdvBehavior()\n"
PARAMETER = ParameterRange(name="OPT_AHEAD", low=10.0, high=90.0, unit="m")
AHEAD = "globalParameters.OPT_AHEAD"
SHARES = (0.2, 0.5, 0.9)
SITUATIONS: dict[str, list[dict[str, Any]]] = {
    "a child from behind a van": [
        {"id": "A", "kind": "child", "starts": {"where": "roadside", "side": "right"}, "hidden_by": "B"}
        | {"does": [{"act": "cross", "speed": "8 km/h"}]},
        {"id": "B", "kind": "van", "role": "hides", "starts": {"where": "kerb", "side": "right"}}
        | {"does": [{"act": "stand"}]},
    ],
    "a car cuts in": [
        {"id": "A", "kind": "car", "starts": {"where": "ahead-beside"}, "does": [{"act": "cut-in"}, {"act": "brake"}]}
    ],
    "two people step out": [
        {"id": "A", "kind": "pedestrian", "count": 2, "starts": {"where": "roadside", "side": "left"}}
        | {"does": [{"act": "enter"}]}
    ],
}


@pytest.fixture
def native() -> NativeSimulator:
    simulator = NativeSimulator(resolve_map("town"), SimulationSettings())
    if simulator.missing:
        pytest.skip(simulator.missing)
    return simulator


def _program(*lines: str) -> ScenicProgram:
    source = HEAD + "".join(lines)
    return ScenicProgram(scenario_id="placed", source=source, parameters=(PARAMETER,), snippet_ids=())


def _placed(native: NativeSimulator, program: ScenicProgram, scene: Scene) -> SteppedSession | Rejected | None:
    """The scene as it is placed without Scenic; None where it is not."""
    embedded = native._embedded  # pyright: ignore[reportPrivateUsage]
    assert isinstance(embedded, SteppedSimulator)
    return embedded.place(program, scene, observation="actors", pedals="safebench", through_collisions=False)


def _agree(native: NativeSimulator, program: ScenicProgram, where: str = "town") -> None:
    """Hold that drives of scenes that are placed by what was learned are those of scenes that Scenic places."""
    ego = load_ego("idm")
    reference: Simulator = load_simulator(resolve_map(where), SimulationSettings())
    for number, share in enumerate(SHARES):
        scene = scene_at(program, 0, share, name=str(number))
        if number:
            assert isinstance(_placed(native, program, scene), SteppedSession)
        ours, theirs = (simulate(one, program, scene, ego) for one in (native, reference))
        assert isinstance(ours, Episode)
        assert isinstance(theirs, Episode)
        assert ours.stepped.by == "native"
        assert differences(ours, theirs) == []
        assert (ours.reached, ours.surroundings) == (theirs.reached, theirs.surroundings)


@pytest.mark.parametrize("base", BaseScenario)
def test_a_program_of_snippets_is_placed_as_scenic_places_it(native: NativeSimulator, base: BaseScenario) -> None:
    generator, settings = load_generator("chatscene"), RetrievalSettings()
    _agree(native, generator.write(generator.read(generator.texts(base)[1], settings), settings).program)


@pytest.mark.parametrize("name", SITUATIONS)
def test_a_program_of_a_situation_is_placed_as_scenic_places_it(name: str) -> None:
    built = build(from_plain({"others": SITUATIONS[name]}))
    _agree(NativeSimulator(resolve_map(built.map), SimulationSettings()), built.program, built.map)


def test_what_may_not_stand_there_is_rejected_for_the_same_reason(native: NativeSimulator) -> None:
    program = _program(PLACED.format(at=AHEAD), PLACED.format(at=50))
    scenes = [scene_at(program, 0, share, name=str(share)) for share in (0.1, 0.5)]
    for scene in scenes:
        opened = native.open(program, scene)
        expected = load_simulator(resolve_map("town"), SimulationSettings()).open(program, scene)
        assert isinstance(opened, Rejected) == isinstance(expected, Rejected)
        assert isinstance(opened, Rejected) is (scene is scenes[1])
        assert not isinstance(opened, Rejected) or opened == expected


@pytest.mark.parametrize(
    "line",
    [
        "require (distance from ego to other) > 5\n",
        "terminate when (distance from ego to other) > 500\n",
        "prop = new Cone at pointOn(egoRoute, 30, Range(2, 3))\n",
    ],
)
def test_a_program_that_is_more_than_a_function_is_left_to_scenic(native: NativeSimulator, line: str) -> None:
    program = _program(PLACED.format(at=AHEAD), line)
    for share in SHARES:
        scene = scene_at(program, 0, share, name=str(share))
        assert not isinstance(native.open(program, scene), Rejected)
        assert _placed(native, program, scene) is None


def test_values_that_a_program_does_not_tune_are_told_as_before(native: NativeSimulator) -> None:
    program = _program(PLACED.format(at=AHEAD))
    scene = scene_at(program, 0, 0.5, name="0")
    ego = load_ego("idm")
    native.open(program, scene, observation=observation_of(ego), pedals=pedals_of(ego))
    with pytest.raises(Exception, match="has values for"):
        native.open(program, replace(scene, values={"OPT_OTHER": 1.0}))
