"""Programs that are built from situations leave as logical scenarios, and come back as the same plans."""

from __future__ import annotations

import os
import re
from functools import cache
from pathlib import Path
from typing import Any
from xml.etree import ElementTree as Xml

import pytest

from asam_checker import assert_nothing_wrong
from chatscene.build.build import build
from chatscene.errors import MapError
from chatscene.exports.exporter import KeptScene, MapFile
from chatscene.exports.openscenario_logical import OpenScenarioLogical
from chatscene.exports.retold import retold
from chatscene.imports.import_file import CARRIED, LEFT_OUT, import_scenario
from chatscene.imports.openscenario import read_openscenario
from chatscene.maps.network import load_network, resolve_map
from chatscene.program.sample import scene_at
from chatscene.settings import SimulationSettings
from chatscene.simulate.simulator import load_simulator
from chatscene.situations.form import from_plain
from chatscene.terms.carried import program_in, properties_of, with_values
from chatscene.terms.scene import Rejected
from chatscene.terms.storyboard import Storyboard
from chatscene.world.ego_route import choose_route
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


STEPS = {"led": 10}


@cache
def kept(said: str) -> KeptScene:
    made = build(from_plain(SAID[said]))
    path = resolve_map(made.map)
    scene = scene_at(made.program, 0, 0.5, name="scene-000")
    session = load_simulator(path, SimulationSettings()).open(made.program, scene)
    assert not isinstance(session, Rejected)
    for _ in range(STEPS.get(said, 0)):
        session.step((0.0, 0.0))
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


@pytest.mark.parametrize("act", ["weave", "reverse"])
def test_who_does_what_the_format_has_no_word_for_is_led_along_its_track_and_that_is_told(
    act: str, tmp_path: Path, caplog: pytest.LogCaptureFixture
) -> None:
    SAID["led"] = one("car", "ahead", {"act": act})
    kept.cache_clear()
    path = written("led", tmp_path)
    text = path.read_text(encoding="utf-8")
    assert re.search(r"; not said: A goes as it was driven, as phase \d, .*no action that does this", text)
    assert '<Trajectory name="A as driven"' in text
    assert_nothing_wrong(path, caplog, "openscenario")
    del SAID["led"]


def test_a_door_that_opens_is_led_along_its_track(tmp_path: Path) -> None:
    SAID["led"] = one("car", "kerb", {"act": "stand"}, {"act": "open-door"}, side="right")
    kept.cache_clear()
    text = written("led", tmp_path).read_text(encoding="utf-8")
    assert re.search(r"; not said: A-door goes as it was driven, as it is not a road user", text)
    del SAID["led"]


@pytest.mark.parametrize("said", SAID)
def test_a_program_comes_back_as_it_was_with_the_ends_that_the_file_declares(said: str, tmp_path: Path) -> None:
    back = import_scenario(written(said, tmp_path)).program.read_text(encoding="utf-8")
    program = kept(said).joined()
    numbers = {one.name: (float(one.low), float(one.high)) for one in program.parameters}
    assert back.partition("\n")[2] == with_values(program.source, numbers).rstrip("\n") + "\n"


def test_a_parameter_that_was_changed_in_a_file_is_changed_in_its_program(tmp_path: Path) -> None:
    path = written("steps-out", tmp_path)
    text = path.read_text(encoding="utf-8")
    name, high = re.findall(r'ParameterDeclaration name="(\w+)".*?lessOrEqual" value="([^"]+)"', text, re.DOTALL)[0]
    path.write_text(text.replace(f'lessOrEqual" value="{high}"', f'lessOrEqual" value="{float(high) + 1.0!r}"', 1))
    back = import_scenario(path).program.read_text(encoding="utf-8")
    assert re.search(rf"param {name} = Range\(.*, {re.escape(repr(float(high) + 1.0))}\)", back)
    one = import_scenario(path, out=tmp_path / "one.scenic", given={name: float(high)})
    assert f"({float(high)!r})" in one.program.read_text(encoding="utf-8")


def test_a_file_of_which_an_event_or_the_map_was_changed_says_what_its_events_say(tmp_path: Path) -> None:
    path = written("steps-out", tmp_path)
    as_it_was = path.read_text(encoding="utf-8")
    carried = import_scenario(path).program.read_text(encoding="utf-8")
    path.write_text(as_it_was.replace('Dimensions width="2.13"', 'Dimensions width="2.0"', 1), encoding="utf-8")
    changed = import_scenario(path, out=tmp_path / "changed.scenic").program.read_text(encoding="utf-8")
    path.write_text(as_it_was, encoding="utf-8")
    town = tmp_path / kept("steps-out").map.name
    town.write_bytes(town.read_bytes() + b"<!-- another -->")
    elsewhere = import_scenario(path, out=tmp_path / "elsewhere.scenic").program.read_text(encoding="utf-8")
    assert "selectRoute" in carried
    assert "selectRoute" not in changed
    assert "selectRoute" not in elsewhere


def test_a_program_that_was_changed_in_its_file_is_left_out_and_what_was_taken_is_told(tmp_path: Path) -> None:
    path = written("steps-out", tmp_path)
    taken = import_scenario(path)
    assert CARRIED in taken.notes
    as_it_was = path.read_text(encoding="utf-8")
    assert "startOf(egoRoute)" in as_it_was
    path.write_text(as_it_was.replace("startOf(egoRoute)", "startOf( egoRoute)", 1), encoding="utf-8")
    changed = import_scenario(path, out=tmp_path / "changed.scenic")
    assert LEFT_OUT in changed.notes
    assert "selectRoute" not in changed.program.read_text(encoding="utf-8")


def test_a_program_of_another_route_than_the_first_comes_back_with_that_one() -> None:
    source = "model chatscene.world.model\negoRoute = selectRoute(maneuver='straight')\n"
    properties = dict(properties_of(source, 3, b"map", []))
    assert program_in(properties, b"map", []) == source.replace("(maneuver", "(only=3, maneuver")
    assert program_in(properties, b"another map", []) is None
    assert program_in(properties, b"map", [("Entities", {}, [])]) is None
    assert program_in(properties, b"map", [("ParameterDeclarations", {"any": "1"}, [])]) is not None
    assert program_in({}, b"map", []) is None
    network = load_network(resolve_map("town"))
    third = choose_route(network, "town.xodr", 3, maneuver="straight").route
    alone = choose_route(network, "town.xodr", 0, only=3, maneuver="straight")
    assert (alone.route.id, alone.count) == (third.id, 1)
    with pytest.raises(MapError, match="has 1 routes"):
        choose_route(network, "town.xodr", 1, only=3, maneuver="straight")
