"""Programs that are built from situations leave as logical scenarios, and come back as the same plans."""

from __future__ import annotations

import os
from functools import cache
from pathlib import Path
from typing import Any
from xml.etree import ElementTree as Xml

import pytest

from asam_checker import assert_nothing_wrong
from chatscene.build.build import build
from chatscene.errors import RunError
from chatscene.exports.exporter import KeptScene, MapFile
from chatscene.exports.openscenario_logical import OpenScenarioLogical
from chatscene.exports.retold import retold
from chatscene.imports.openscenario import read_openscenario
from chatscene.maps.network import resolve_map
from chatscene.program.sample import scene_at
from chatscene.settings import SimulationSettings
from chatscene.simulate.simulator import load_simulator
from chatscene.situations.form import from_plain
from chatscene.terms.scene import Rejected
from chatscene.terms.storyboard import Storyboard
from places import TESTS

GOLDEN = TESTS / "golden" / "logical"


def one(kind: str, where: str, *does: dict[str, Any], **start: Any) -> dict[str, Any]:
    # At the road's speed most starts lie beyond a bend, and change with no parameter in proportion.
    return {
        "ego": {"speed": "28 km/h"},
        "others": [{"id": "A", "kind": kind, "starts": {"where": where, **start}, "does": list(does)}],
    }


SAID: dict[str, dict[str, Any]] = {
    "waits-until-the-ego-is-near": one("car", "kerb", {"act": "stand"}, {"act": "pull-out"}, side="right"),
    "goes-ahead-and-brakes": one("car", "ahead", {"act": "brake"}),
    "steps-out": one("pedestrian", "roadside", {"act": "cross"}, side="right"),
    "comes-driving-and-turns": one("car", "oncoming", {"act": "turn-left"})
    | {"ego": {"route": "straight", "speed": "28 km/h"}, "road": {"kind": "four-way"}},
    "tailgates": one("car", "behind", {"act": "tailgate"}),
    "cuts-in": one("car", "beside", {"act": "cut-in"}, side="left", distance="6 m"),
}


@cache
def kept(said: str) -> KeptScene:
    made = build(from_plain(SAID[said]))
    path = resolve_map(made.map)
    scene = scene_at(made.program, 0, 0.5, name="scene-000")
    session = load_simulator(path, SimulationSettings()).open(made.program, scene)
    assert not isinstance(session, Rejected)
    episode = session.episode(scene.id, "idm")
    session.close()
    return KeptScene(
        episode=episode,
        text=said,
        program=made.program.source,
        values=scene.values,
        route=0,
        map=MapFile(name=path.name, content=path.read_bytes()),
        joined=lambda: made.program,
    )


def written(said: str, folder: Path) -> Path:
    scene = kept(said)
    for name, content in OpenScenarioLogical().files(scene).items():
        (folder / name).write_bytes(content)
    return folder / f"{scene.stem}.xosc"


@pytest.mark.parametrize("said", SAID)
def test_what_is_built_is_read_back_as_the_same_plans_from_the_same_starts(said: str, tmp_path: Path) -> None:
    board = retold(kept(said))
    back = read_openscenario(written(said, tmp_path), board_map(said)).board
    assert isinstance(back, Storyboard)
    assert [actor.plan for actor in back.actors] == [actor.plan for actor in board.actors]
    assert [actor.start for actor in back.actors[1:]] == [actor.start for actor in board.actors[1:]]


def board_map(said: str) -> str:
    return kept(said).map.name.removesuffix(".xodr")


@pytest.mark.parametrize("said", SAID)
def test_the_story_is_the_one_that_is_kept_and_the_standard_has_nothing_against_it(
    said: str, tmp_path: Path, caplog: pytest.LogCaptureFixture
) -> None:
    path = written(said, tmp_path)
    story = Xml.parse(path).getroot().find("Storyboard/Story")
    assert story is not None
    for line in story.iter("Polyline"):  # the map's, which is kept elsewhere
        for vertex in list(line)[1:-1]:
            line.remove(vertex)
    Xml.indent(story)
    text = Xml.tostring(story, encoding="unicode") + "\n"
    golden = GOLDEN / f"{said}.xml"
    if os.environ.get("UPDATE_GOLDEN"):
        golden.write_text(text, encoding="utf-8")
    assert text == golden.read_text(encoding="utf-8")
    assert_nothing_wrong(path, caplog, "openscenario")


def test_a_time_to_a_place_is_asked_of_the_ego_and_a_distance_is_kept_to_it(tmp_path: Path) -> None:
    waits = written("waits-until-the-ego-is-near", tmp_path).read_text(encoding="utf-8")
    assert "<TimeToCollisionCondition " in waits
    keeps = written("tailgates", tmp_path).read_text(encoding="utf-8")
    assert 'displacement="trailingReferencedEntity"' in keeps
    assert "; not said: A drives at " in written("cuts-in", tmp_path).read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("deed", "why"), [({"act": "weave"}, "no action that does this"), ({"act": "reverse"}, "no action that does this")]
)
def test_what_the_format_has_no_word_for_is_refused_by_its_phase(deed: dict[str, Any], why: str) -> None:
    SAID["refused"] = one("car", "ahead", deed)
    kept.cache_clear()
    with pytest.raises(RunError, match=rf"A, phase \d.*{why}"):
        retold(kept("refused"))
    del SAID["refused"]
