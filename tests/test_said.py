"""Nothing that was said vanishes: it is used, listed as not used, or the sentence is refused and says why."""

from __future__ import annotations

import json
import re
from pathlib import Path

import click
import pytest
from click.testing import CliRunner

from chatscene import pipeline, runs
from chatscene.commands.main import main
from chatscene.ego.policy import load_ego
from chatscene.errors import NothingFits
from chatscene.interpret.suggest import SERVED
from chatscene.maps.network import resolve_map
from chatscene.program.check import check
from chatscene.read.lexicon import is_english
from chatscene.report.filled import explain_text
from chatscene.report.stated import Stated
from chatscene.settings import Settings, SimulationSettings
from chatscene.simulate.simulator import load_simulator
from chatscene.terms.acts import Action
from chatscene.terms.scenario import Why
from outright import decompose
from places import ROOT

_SHOWN = re.compile(r"chatscene (?:run|explain) \"([^\"…]+)\"([^\n]*)")


def helps(command: click.Command, name: str = "") -> dict[str, str]:
    """The help of every command, by its name."""
    found = {name: command.help or ""}
    for child in command.commands.values() if isinstance(command, click.Group) else ():
        found |= helps(child, f"{name} {child.name}")
    return found


def shown() -> dict[str, bool]:
    """Every sentence that a page or a help gives to run or explain, and whether the page says that it is refused.

    Those with a library of the user's own are for that library.
    """
    pages = [page.read_text() for page in (ROOT / "README.md", *(ROOT / "docs").rglob("*.md"))]
    found: dict[str, bool] = {}
    for text in (*pages, *helps(main).values()):
        for sentence, rest in _SHOWN.findall(text):
            if "--library" not in rest:
                found[sentence] = "status 3" in rest
    return found


def test_the_pages_and_the_help_show_sentences() -> None:
    assert {"the car ahead brakes hard", "a motorbike cuts us off from the right"} <= set(shown())
    assert any(shown().values())


@pytest.mark.parametrize("text", sorted({*shown(), *SERVED}))
def test_a_sentence_that_the_tool_shows_is_read_and_climbs_the_ladder_unless_the_page_says_otherwise(text: str) -> None:
    if shown().get(text, False):
        with pytest.raises(NothingFits):
            explain_text(text)
        return
    understood = explain_text(text)
    assert isinstance(understood, Stated)
    simulator = load_simulator(resolve_map(understood.built.map), SimulationSettings())
    check(understood.program, understood.situation, simulator, load_ego("rule-based"))


@pytest.mark.parametrize(
    ("text", "behavior"),
    [
        ("the car ahead brakes hard", "lane-brake"),
        ("The car in front of us brakes hard.", "lane-brake"),
        ("a motorbike cuts us off from the right", "cut-in"),
        ("an oncoming car turns left across our path at a traffic light", "junction-turn-left"),
        ("a cyclist cuts across from the left while we turn right", "cross"),
    ],
)
def test_an_act_that_nobody_said_is_not_added_where_a_plain_one_exists(text: str, behavior: str) -> None:
    retrieval = pipeline.understand(text).retrieval
    assert retrieval is not None
    assert retrieval.behavior.snippet.id == f"behavior/{behavior}"


def test_an_act_that_the_patterns_took_for_the_ego_s_is_not_lost() -> None:
    text = "We turn right at a junction as somebody walks over from the left, a pedestrian who then stops."
    assert Action.CROSS in pipeline.understand(text).scenario.slots.actions


@pytest.mark.parametrize(
    ("text", "said", "why"),
    [
        ("The car ahead brakes hard and we are blinded by the low sun.", "blinded by the low sun", Why.LIGHT),
        ("The car ahead brakes hard in fog and rain.", "rain", Why.WEATHER),
        (
            "A cyclist cuts across from the left in strong winds.",
            "strong winds",
            Why.WEATHER,
        ),
        ("A pedestrian steps onto the slippery road from the right.", "slippery road", Why.WEATHER),
        ("We make a quick U-turn and a moped comes the other way.", "make a quick u-turn", Why.MANEUVER),
        ("Un coche frena de golpe delante de nosotros", "un coche frena de golpe delante de nosotros.", Why.LANGUAGE),
    ],
)
def test_what_no_scene_has_is_refused_with_that_as_the_reason(text: str, said: str, why: Why) -> None:
    with pytest.raises(NothingFits) as refusal:
        pipeline.understand(text)
    assert refusal.value.reasons[0].startswith(f"{said!r}")
    assert why in refusal.value.reasons[0]


@pytest.mark.parametrize(
    "text",
    [
        "A taxi in front of our car makes a U-turn.",
        "The taxi just before the AV does a U-turn in the road.",
        "We did not U-turn; a car brakes ahead of us, mate.",
    ],
)
def test_a_u_turn_of_somebody_else_or_of_nobody_is_no_reason_to_refuse(text: str) -> None:
    assert pipeline.understand(text).scenario.slots.adversary == "car"


@pytest.mark.parametrize(
    "text", ["The car ahead brakes on a dry road in daylight.", "A night bus... no: a bus brakes."]
)
def test_what_is_always_so_needs_no_word(text: str) -> None:
    assert not {Why.WEATHER, Why.LIGHT} & {one.why for one in decompose(text).unused} or "night" in text


@pytest.mark.parametrize(
    ("text", "said", "why"),
    [
        ("A pedestrian crosses from the left and a cyclist hurries across from the right.", "a cyclist", Why.ROAD_USER),
        ("A car cuts in from the left and then another car jams on its anchors.", "another car", Why.ROAD_USER),
        ("The car ahead brakes hard, forcing us to swerve.", "forcing us to swerve", Why.REACTION),
        ("The white car ahead brakes hard.", "white", Why.BESIDES),
    ],
)
def test_what_is_not_used_is_listed(text: str, said: str, why: Why) -> None:
    assert [one.said for one in decompose(text).unused if one.why is why] == [said]


@pytest.mark.parametrize(
    "text",
    [
        "The car ahead brakes hard.",
        "A man on a bicycle crosses from between two parked cars.",
        "We go around a parked car and an oncoming truck accelerates.",
        "A slow car leads us and a car behind us overtakes.",
        "A group of pedestrians crosses a road with 2 lanes in each direction.",
    ],
)
def test_what_the_slots_hold_is_not_listed(text: str) -> None:
    assert not [one for one in decompose(text).unused if one.why in (Why.ROAD_USER, Why.NUMBER)]


def test_a_number_that_no_fact_holds_is_listed_by_explain_and_in_its_json() -> None:
    text = "A truck of 40 tons runs the red light from the left."
    answer = CliRunner().invoke(main, ["explain", text, "--json"])
    assert answer.exit_code == 0, answer.output
    assert any("40" in said for said in json.loads(answer.stdout)["not_read"])
    assert "not read: '40 tons'" in CliRunner().invoke(main, ["explain", text]).stdout


@pytest.mark.parametrize(
    ("text", "english"),
    [
        ("Ein Fußgänger läuft plötzlich von rechts auf die Straße und bleibt stehen.", False),
        ("Un peatón cruza la calle desde la derecha y se para.", False),
        ("Une voiture nous coupe la route par la droite.", False),
        ("Un ciclista attraversa la strada da destra davanti a noi.", False),
        ("一辆车突然从右边切入我们的车道。", False),
        ("Машина впереди резко тормозит.", False),
        ("ped crosses R->L, occl by parked van, ego 50 km/h", True),
        ("A Citroën brakes in front of the café de la Paix as we turn left.", True),
        ("bike left", True),
    ],
)
def test_another_language_is_told_from_english(text: str, english: bool) -> None:
    assert is_english(text.lower()) is english


def test_a_refusal_in_json_says_why_how_sure_and_what_would_work(tmp_path: Path) -> None:
    for command in (["explain"], ["run", "--out", str(tmp_path / "refused")]):
        answer = CliRunner().invoke(main, [*command, "A helicopter lands on our roof.", "--json"])
        told = json.loads(answer.stdout)
        assert answer.exit_code == 3
        assert told["refused"] == "NothingFits"
        assert 0.0 <= told["confidence"] < Settings().retrieval.refuse_below
        assert any("helicopter" in reason for reason in told["reasons"])
        assert {"text": "helicopter", "start": 2, "end": 12, "unread": True} in told["words"]
        assert told["understood"]  # what it would have been
        assert told["suggestion"] in SERVED


def test_a_refused_folder_takes_a_better_sentence(tmp_path: Path) -> None:
    folder = tmp_path / "first"
    with pytest.raises(NothingFits):
        pipeline.run(runs.asked_run("A helicopter lands on our roof."), folder)
    assert runs.read_record(runs.open_run(folder)).status is runs.Status.REFUSED
    (folder / "programs").mkdir(exist_ok=True)
    (folder / "programs" / "old.scenic").write_text("")
    kept = runs.create(folder, runs.asked_run("better"))
    assert runs.read_record(kept).status is runs.Status.RUNNING
    assert not runs.read_programs(kept)


def test_a_refused_folder_with_a_user_s_file_in_it_is_left_alone(tmp_path: Path) -> None:
    folder = tmp_path / "first"
    with pytest.raises(NothingFits):
        pipeline.run(runs.asked_run("A helicopter lands on our roof."), folder)
    (folder / "notes.txt").write_text("mine")
    with pytest.raises(Exception, match="not empty"):
        runs.create(folder, runs.asked_run("better"))
    assert (folder / "notes.txt").read_text() == "mine"
    assert runs.read_record(runs.Workspace(folder)).status is runs.Status.REFUSED


@pytest.mark.parametrize(
    ("text", "acts"),
    [
        ("The car ahead brakes hard and then accelerates.", ["brake", "accelerate"]),
        ("The car ahead accelerates and then brakes hard.", ["accelerate", "brake"]),
    ],
)
def test_acts_are_served_in_the_order_in_which_they_are_said(text: str, acts: list[str]) -> None:
    retrieval = pipeline.understand(text).retrieval
    assert retrieval is not None
    assert list(retrieval.behavior.snippet.slots.actions) == acts


def test_a_number_that_nothing_can_be_set_to_is_why_a_sentence_is_refused() -> None:
    with pytest.raises(NothingFits) as refusal:
        pipeline.understand("The car ahead brakes hard at 80 km/h.")
    assert any("80 km/h" in reason for reason in refusal.value.reasons)
