# ruff: noqa: E501 - elements stand in one line each
"""Scenarios of OpenSCENARIO as they are read, and as they are driven."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from chatscene.ego.policy import load_ego, observation_of, pedals_of
from chatscene.imports.openscenario import Imported, read_openscenario
from chatscene.imports.written_story import StoryProgram, written_story
from chatscene.maps.network import resolve_map
from chatscene.program.sample import scene_at
from chatscene.search.generators.foreign import foreign_program
from chatscene.settings import SimulationSettings
from chatscene.simulate.embedded.physics import make_simulator
from chatscene.terms.episode import Episode
from chatscene.terms.scene import Rejected

TIME = '<ByValueCondition><SimulationTimeCondition value="{}" rule="greaterThan"/></ByValueCondition>'
STATE = '<ByValueCondition><StoryboardElementStateCondition storyboardElementType="{}" storyboardElementRef="{}" state="{}"/></ByValueCondition>'
SPEED = '<LongitudinalAction><SpeedAction><SpeedActionDynamics dynamicsShape="{shape}" dynamicsDimension="time" value="{time}"/><SpeedActionTarget><AbsoluteTargetSpeed value="{speed}"/></SpeedActionTarget></SpeedAction></LongitudinalAction>'
DISTANCE = '<LongitudinalAction><LongitudinalDistanceAction entityRef="ego" distance="8" freespace="true" continuous="true"/></LongitudinalAction>'


def read(folder: Path, text: str, **told: str) -> Imported:
    path = folder / "theirs.xosc"
    path.write_text(text)
    return read_openscenario(path, **told)  # type: ignore[arg-type]


def story(folder: Path, text: str) -> StoryProgram:
    board = read(folder, text).board
    assert isinstance(board, StoryProgram)
    return board


def driven(folder: Path, text: str, steps: int = 80) -> Episode:
    """A scenario as it is driven, by `idm` in the place of the ego."""
    program = foreign_program("theirs", written_story(story(folder, text), "theirs.xosc"))
    scene = replace(scene_at(program, 0, 0.5, name="seed-0"), seed=0)
    ego = load_ego("idm")
    drive = make_simulator(resolve_map("town"), SimulationSettings()).open(
        program, scene, observation=observation_of(ego), pedals=pedals_of(ego)
    )
    assert not isinstance(drive, Rejected), drive.reason
    try:
        while drive.ending is None and not drive.rejection and drive.step_number < steps:
            drive.step(ego.act(drive.observation))
        assert not drive.rejection
        return drive.episode(scene.id, "idm")
    finally:
        drive.close()


def speed(value: float, time: float = 2.0, shape: str = "linear") -> str:
    return SPEED.format(speed=value, time=time, shape=shape)
