"""Left-hand traffic from a sentence to files: everybody keeps to the left, and left is left."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path
from typing import Any
from xml.etree import ElementTree as Xml

import numpy as np
import pytest

import chatscene
from chatscene.api.results import Run
from chatscene.build.build import build
from chatscene.ego.policy import load_ego
from chatscene.errors import NotBuilt, SettingsError
from chatscene.maps.network import PACKAGED
from chatscene.program.finding import failures
from chatscene.program.judge import judge
from chatscene.program.sample import scene_at
from chatscene.settings import SimulationSettings
from chatscene.simulate.simulator import load_simulator, simulate
from chatscene.situations.form import from_plain, to_plain
from chatscene.terms.episode import Episode
from chatscene.terms.mirrored_scenario import mirrored_attributes
from chatscene.terms.mirroring import as_said_on, mirrored_situation, mirrored_words
from chatscene.terms.situation import Evidence
from chatscene.terms.vocabulary import Side
from left_town import left_town

OF_TOWN = "A pedestrian crosses the street from the right."
OF_LEFT = "A pedestrian crosses the street from the left."


@pytest.fixture(scope="module")
def left(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return left_town(tmp_path_factory.mktemp("left"))


@pytest.fixture(scope="module")
def runs(left: Path, tmp_path_factory: pytest.TempPathFactory) -> tuple[Run, Run]:
    """The same sentence with sides swapped, on the left-hand town and on the packaged one."""
    folder = tmp_path_factory.mktemp("runs")
    one = chatscene.run(OF_LEFT, folder / "left", map=left, scenes=4)
    return one, chatscene.run(OF_TOWN, folder / "town", map="town", scenes=4)


@pytest.mark.parametrize(
    ("name", "kind", "where", "act"),
    [("outskirts", "car", "on-ramp", "merge"), ("region", "bus", "bus-bay", "pull-out")],
)
def test_what_lies_on_the_right_lies_on_the_left_of_a_left_hand_map(
    name: str, kind: str, where: str, act: str, tmp_path: Path
) -> None:
    def on(named: str, side: str) -> str:
        other = {"id": "A", "kind": kind, "starts": {"where": where, "side": side}, "does": [{"act": act}]}
        return build(from_plain({"others": [other], "map": named}), name="one").program.source

    left = str(left_town(tmp_path, name))
    ways = [on(left, "left"), on(name, "right")]
    assert [line for line in ways[0].splitlines() if "param" in line and "map" not in line] == [
        line for line in ways[1].splitlines() if "param" in line and "map" not in line
    ]
    for named, wrong, right in ((left, "right", "left"), (name, "left", "right")):
        with pytest.raises(NotBuilt, match=f"{where} lies on the {right}"):
            on(named, wrong)


@pytest.mark.parametrize("simulator", ["native", "embedded", "confined"])
def test_a_left_hand_town_is_driven_as_its_mirror_image_to_the_last_bit(left: Path, simulator: str) -> None:
    cuts_in: dict[str, Any] = {"id": "A", "kind": "car", "starts": {"where": "ahead-beside", "side": "left"}}
    said = {"others": [{**cuts_in, "does": [{"act": "cut-in", "to": "right"}]}]}
    on_left = from_plain({**said, "map": str(left)})
    image = replace(mirrored_situation(on_left), map="town")
    drives = list[Episode]()
    for one, where in ((on_left, left), (image, PACKAGED["town"])):
        program = build(one, name="one").program
        made = load_simulator(where, SimulationSettings(simulator=simulator))
        episode = simulate(made, program, scene_at(program, 0, 0.5, name="one/0"), load_ego("planner"))
        assert isinstance(episode, Episode)
        drives.append(episode)
        route = made.route(program, 0)
        assert not failures(judge(one, episode, route))
        assert math.dist(route.line.points[0], (episode.ego_track.x[0], episode.ego_track.y[0])) < 1.0
    for mine, theirs in zip(*(one.tracks for one in drives), strict=True):
        assert np.array_equal(mine.x, theirs.x)
        assert np.array_equal(mine.y, 0.0 - theirs.y)
        assert np.array_equal(mine.heading, 0.0 - theirs.heading)


def test_a_scene_of_a_left_hand_map_is_replayed_to_the_last_bit(runs: tuple[Run, Run]) -> None:
    assert chatscene.replay(runs[0].folder, runs[0].kept[0].id).identical


def test_what_was_said_of_a_left_hand_map_is_kept_told_and_shown_with_its_own_sides(runs: tuple[Run, Run]) -> None:
    kept = (runs[0].folder / "situation.yaml").read_text()
    assert "side: left" in kept
    verdict = chatscene.verify(runs[0].folder, OF_LEFT)
    assert verdict.status == 0
    assert chatscene.verify(runs[0].folder, OF_TOWN).status == 1
    told = str(chatscene.story(runs[0].folder))
    assert "to its left" in told
    assert "to its right" not in told.partition("\n  0.")[0]


def test_who_comes_from_the_nearside_comes_from_the_left_there(runs: tuple[Run, Run]) -> None:
    assert chatscene.verify(runs[0].folder, "A pedestrian crosses the street from the nearside.").status == 0
    assert chatscene.verify(runs[0].folder, "A pedestrian crosses the street from the offside.").status == 1


def test_the_nearside_of_a_text_is_the_left_of_a_left_hand_map(left: Path) -> None:
    read = chatscene.explain("A cyclist crosses from the nearside.", map=left).situation
    assert read["A"].starts.side is Side.LEFT
    assert chatscene.explain("A cyclist crosses from the nearside.").situation["A"].starts.side is Side.RIGHT


def test_a_side_of_a_text_that_a_reader_swapped_is_as_the_text_has_it() -> None:
    said = from_plain({"others": [{"id": "A", "kind": "car", "starts": {"where": "beside", "side": "left"}}]})
    swapped = replace(mirrored_situation(said), evidence=Evidence(mirrored=True))
    assert swapped["A"].starts.side is Side.RIGHT
    assert as_said_on(swapped, keeps_left=True) == said
    assert not as_said_on(swapped, keeps_left=True).evidence.mirrored
    assert as_said_on(swapped, keeps_left=False) is swapped


def test_what_is_as_a_left_hand_map_has_it_stays_if_it_is_asked_for_again(left: Path) -> None:
    for text in ("A cyclist crosses from the nearside.", "A car pulls out from the kerb and stops."):
        read = chatscene.explain(text, map=left).situation
        assert chatscene.explain(read, map=left).situation == read
        assert from_plain(to_plain(read)) == read
        assert as_said_on(read, keeps_left=True) is read


def test_a_reference_to_a_deed_by_its_act_is_mirrored_with_the_act() -> None:
    turns = {"id": "A", "kind": "car", "starts": {"where": "ahead"}, "does": [{"act": "turn-left"}]}
    after = {"act": "brake", "when": {"after": "A.turn-left"}}
    said = from_plain({"others": [turns, {"id": "B", "kind": "car", "starts": {"where": "behind"}, "does": [after]}]})
    when = mirrored_situation(said)["B"].does[0].when
    assert when is not None
    assert when.after == "A.turn-right"
    assert mirrored_situation(mirrored_situation(said)) == said


@pytest.mark.parametrize(
    ("told", "other"),
    [
        ("3.0 m to its left", "3.0 m to its right"),
        ("Left-front, right", "Right-front, left"),
        ("left out: the right of way", "left out: the right of way"),
        ("turn-left (turns left)", "turn-right (turns right)"),
        ("its way is left-turn", "its way is right-turn"),
        ("what is left of the bus is left", "what is right of the bus is left"),
    ],
)
def test_words_are_mirrored_but_for_what_is_no_side(told: str, other: str) -> None:
    assert mirrored_words(told) == other


def test_what_cannot_be_built_on_a_left_hand_map_is_refused_with_its_own_sides(left: Path) -> None:
    said = {"ego": {"route": "left-turn"}, "road": {"has": ["tram-track"], "lanes": 3}, "map": str(left)}
    others = [{"id": "A", "kind": "car", "starts": {"where": "oncoming"}}]
    with pytest.raises(NotBuilt, match="left-turn"):
        chatscene.explain(from_plain({**said, "others": others}))


def test_snippets_are_not_chosen_for_a_left_hand_map(left: Path, tmp_path: Path) -> None:
    with pytest.raises(SettingsError, match="keeps to the left"):
        chatscene.run(OF_LEFT, tmp_path / "run", map=left, reader="paper", scenes=1)


@pytest.mark.parametrize("to", ["openscenario", "openscenario-logical"])
def test_exports_of_a_left_hand_map_lie_as_the_map_does_and_come_back(
    runs: tuple[Run, Run], left: Path, tmp_path: Path, to: str
) -> None:
    kept = runs[0].kept[0]
    done = chatscene.export(runs[0].folder, kept.id, to=to, out=tmp_path / "out")
    assert (tmp_path / "out" / left.name).read_bytes() == left.read_bytes()
    xosc = tmp_path / "out" / done.files[kept.id][0]
    ego = kept.episode.ego_track
    first = next(one for one in Xml.parse(xosc).getroot().iter() if one.tag == "WorldPosition")
    assert math.dist((float(first.get("x", "")), float(first.get("y", ""))), (ego.x[0], ego.y[0])) < 2.0
    back = chatscene.import_scenario(xosc)
    assert "here left is right" in back.program.read_text()
    for told in (
        chatscene.story(back.program, map=back.map_path),
        chatscene.story(xosc),
        chatscene.story(runs[0].folder),
    ):
        assert "to its left" in str(told)


def test_sided_attributes_of_a_scenario_change_their_sign_and_others_do_not() -> None:
    lane = {"roadId": "-7", "laneId": "-1", "s": "20", "offset": "$o"}
    assert mirrored_attributes("LanePosition", lane) == {**lane, "laneId": "1", "offset": "${-($o)}"}
    assert mirrored_attributes("Orientation", {"h": "${$a + 1}"}) == {"h": "${-($a + 1)}"}
    assert mirrored_attributes("WorldPosition", {"x": "1", "y": "+2.50", "h": "0.0"}) == {
        "x": "1",
        "y": "-2.50",
        "h": "0.0",
    }
    beside = {"displacement": "leftToReferencedEntity"}
    assert mirrored_attributes("LateralDistanceAction", beside) == {"displacement": "rightToReferencedEntity"}
