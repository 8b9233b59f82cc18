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
from chatscene.read.reader import is_english
from chatscene.report.filled import explain_text
from chatscene.report.stated import Stated
from chatscene.settings import Settings, SimulationSettings
from chatscene.simulate.simulator import load_simulator
from places import ROOT

UNSURE = "A car surprises us."
_SHOWN = re.compile(r"chatscene (?:run|explain) \"([^\"…]+)\"([^\n]*)")


def helps(command: click.Command, name: str = "") -> dict[str, str]:
    """The help of every command, by its name."""
    found = {name: command.help or ""}
    for child in command.commands.values() if isinstance(command, click.Group) else ():
        found |= helps(child, f"{name} {child.name}")
    return found


def shown() -> dict[str, bool]:
    """Every sentence that a page or a help gives to run or explain, and whether the page says that it is refused.

    Those with a library or a language model of the user's own are for these.
    """
    pages = [
        page.read_text() for page in (ROOT / "README.md", *(ROOT / "docs").rglob("*.md")) if page.parent.name != "lab"
    ]
    found: dict[str, bool] = {}
    for text in (*pages, *helps(main).values()):
        for sentence, rest in _SHOWN.findall(text):
            if "--library" not in rest and "--language-model" not in rest:
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
    check(understood.program, understood.situation, simulator, load_ego("planner"))  # with whom programs are rehearsed


@pytest.mark.parametrize(
    ("text", "behavior"),
    [
        ("the car ahead brakes hard", "lane-brake"),
        ("The car in front of us brakes hard.", "lane-brake"),
        ("an oncoming car turns left across our path at a traffic light", "junction-turn-left"),
        ("a cyclist rides out from the left", "cross"),
    ],
)
def test_an_act_that_nobody_said_is_not_added_where_a_plain_one_exists(text: str, behavior: str) -> None:
    retrieval = pipeline.understand(text).retrieval
    assert retrieval is not None
    assert retrieval.behavior.snippet.id == f"behavior/{behavior}"


@pytest.mark.parametrize(
    ("text", "not_read"),
    [
        ("The car ahead brakes hard in fog and rain.", "fog"),
        ("A cyclist cuts across from the left in strong winds.", "strong winds"),
        ("A pedestrian steps onto the slippery road from the right.", "slippery road"),
        ("A truck of 40 tons runs the red light from the left.", "40"),
    ],
)
def test_what_no_fact_holds_is_listed_by_explain_and_in_its_json(text: str, not_read: str) -> None:
    answer = CliRunner().invoke(main, ["explain", text, "--json"])
    assert answer.exit_code == 0, answer.output
    assert not_read in json.loads(answer.stdout)["not_read"]
    assert f"{not_read!r}" in CliRunner().invoke(main, ["explain", text]).stdout.splitlines()[0]


@pytest.mark.parametrize(
    "text",
    [
        "The car ahead brakes hard.",
        "The white car ahead brakes hard.",
        "A taxi in front of our car makes a U-turn.",
    ],
)
def test_what_facts_hold_is_not_listed(text: str) -> None:
    assert json.loads(CliRunner().invoke(main, ["explain", text, "--json"]).stdout)["not_read"] == []


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
        answer = CliRunner().invoke(main, [*command, UNSURE, "--json"])
        told = json.loads(answer.stdout)
        assert answer.exit_code == 3
        assert told["refused"] == "NothingFits"
        assert 0.0 <= told["confidence"] < Settings().retrieval.refuse_below
        assert any(
            "read as" in reason or reason.startswith(("the reading is too uncertain", "no fact was read"))
            for reason in told["reasons"]
        )
        assert [one["text"] for one in told["words"]] == UNSURE.rstrip(".").split()
        assert told["understood"]  # what it would have been
        assert {one["reading"] for one in told["readings"]} <= {1, 2, 3}


def test_a_text_that_tells_no_situation_is_refused_with_a_sentence_that_works() -> None:
    answer = CliRunner().invoke(main, ["explain", "A helicopter lands on our roof.", "--json"])
    told = json.loads(answer.stdout)
    assert answer.exit_code == 3
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
