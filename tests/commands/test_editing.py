"""Edits and conversations, through the command."""

from __future__ import annotations

import json
import math
from pathlib import Path

import pytest
from click.testing import CliRunner, Result
from PIL import Image

import chatscene
from chatscene import runs
from chatscene.commands.main import main
from chatscene.errors import EditRefused, RunError, SettingsError
from chatscene.report import animation
from chatscene.report.animation import write_gif
from chatscene.runs.progress import silent
from chatscene.talk import Talk
from chatscene.terms.situation import Start
from chatscene.terms.vocabulary import Side, Where
from fake_run import finished

WALKS = "A pedestrian crosses the road from the right."
FEW = ("--scenes", "4", "--ego", "rule-based")


def said(*arguments: str, lines: str = "") -> Result:
    return CliRunner().invoke(main, arguments, input=lines, catch_exceptions=False)


@pytest.fixture(scope="module")
def walks(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("runs") / "walks"
    assert said("run", WALKS, "--out", str(folder), *FEW, "--seed", "3").exit_code == 0
    return folder


@pytest.fixture(scope="module")
def edited(walks: Path) -> tuple[Path, str]:
    """A run that is an edit, and what the command said."""
    done = said("edit", str(walks), "from the left, and faster")
    assert done.exit_code == 0, done.output
    return walks.parent / "from-the-left-and-faster", done.output


def test_an_edit_shows_the_difference_and_makes_a_run_beside_the_first(walks: Path, edited: tuple[Path, str]) -> None:
    folder, output = edited
    assert "now: A pedestrian is at the roadside on our left. The pedestrian crosses our path fast." in output
    assert "others.A.starts.side: right → left" in output
    assert "others.A.does.0.manner: not said → fast" in output
    assert "-param OPT_A_SPEED = Range(1.65, 2.46)" in output
    assert "+param OPT_A_SPEED = Range(3.0, 3.75)" in output
    before, after = (runs.read_record(runs.open_run(one)) for one in (walks, folder))
    assert after.edits == ["from the left, and faster"]
    assert after.edited_from == str(walks.resolve())
    assert after.title == f"{before.title} (edited: from the left, and faster)"
    assert (after.settings, after.egos) == (before.settings, before.egos)


def starts_on_the_left(scene: chatscene.DrivenScene) -> bool:
    """Whether the adversary stands to the left of the line that the ego drives first."""
    ego, other = scene.episode.ego_track, scene.episode.adversaries[0]
    dx, dy = float(other.x[0] - ego.x[0]), float(other.y[0] - ego.y[0])
    return math.cos(ego.heading[0]) * dy - math.sin(ego.heading[0]) * dx > 0.0


def test_an_edited_run_shows_what_was_asked_for(walks: Path, edited: tuple[Path, str]) -> None:
    before, run = chatscene.Run(walks), chatscene.Run(edited[0])
    assert not any(starts_on_the_left(scene) for scene in before.kept)
    assert all(starts_on_the_left(scene) for scene in run.kept)
    assert all(max(scene.episode.adversaries[0].speed) >= 3.0 for scene in run.kept)
    assert all(max(scene.episode.adversaries[0].speed) < 3.0 for scene in before.kept)
    assert "(edited: from the left, and faster)" in run.report.read_text()


def test_what_leaves_an_edited_run_says_its_edits(
    edited: tuple[Path, str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    chatscene.export(edited[0], to="openscenario", out=tmp_path)
    headers = [file.read_text() for file in tmp_path.glob("*.xosc")]
    assert headers
    assert all("(edited: from the left, and faster)" in one for one in headers)
    captions, drawn = list[str](), animation.above

    def above(said: str) -> Image.Image:
        captions.append(said)
        return drawn(said)

    monkeypatch.setattr("chatscene.report.animation.above", above)
    write_gif(edited[0])
    assert captions == [f"{WALKS} (edited: from the left, and faster)"]


def test_an_edited_run_replays_bit_for_bit(edited: tuple[Path, str]) -> None:
    assert chatscene.Run(edited[0]).best.replay().identical


def test_an_edited_run_can_be_edited_and_undone(walks: Path, edited: tuple[Path, str]) -> None:
    again = said("edit", str(edited[0]), "at night", "--dry-run", "--json")
    told = json.loads(again.stdout)
    assert [one["fact"] for one in told["changes"]] == ["around.light"]
    assert told["folder"] is None
    assert said("edit", str(edited[0]), "--undo").stdout.strip() == str(walks.resolve())
    assert said("edit", str(walks), "--undo").exit_code == 1


@pytest.mark.parametrize("words", ["make it a dragon", "from the right", "thank you"])
def test_what_is_refused_leaves_everything_as_it_was(words: str, walks: Path) -> None:
    folders = sorted(walks.parent.iterdir())
    assert said("edit", str(walks), words).exit_code == 3
    assert sorted(walks.parent.iterdir()) == folders


def test_an_edit_or_undo_has_to_be_said(walks: Path) -> None:
    assert said("edit", str(walks)).exit_code == 2
    assert said("edit", str(walks), "at night", "--undo").exit_code == 2


def test_the_same_run_is_had_from_the_sentence_and_its_edits(tmp_path: Path, edited: tuple[Path, str]) -> None:
    folder = tmp_path / "again"
    assert (
        said("run", WALKS, "--edit", "from the left, and faster", "--out", str(folder), *FEW, "--seed", "3").exit_code
        == 0
    )
    assert (folder / "scenes.parquet").read_bytes() == (edited[0] / "scenes.parquet").read_bytes()


def test_a_folder_is_not_gone_on_with_after_another_edit(edited: tuple[Path, str]) -> None:
    other = said("run", WALKS, "--edit", "at night", "--out", str(edited[0]), *FEW, "--seed", "3")
    assert other.exit_code == 1
    told = " ".join(other.output.split())
    assert "edits was ['from the left, and faster'] and is now ['at night']" in told
    assert len(told) < 500  # and not both situations, line by line


def test_what_is_asked_back_is_answered_in_a_conversation() -> None:
    lines = ["the car ahead brakes hard", "set adversary=truck", "make it a bus", "reading 99", "show", "quit"]
    done = said("chat", *FEW, lines="\n".join(lines))
    assert done.exit_code == 0
    assert "A truck" in done.stdout
    assert "from 0 to 3, not 99" in done.stdout
    assert "A bus" in done.stdout[done.stdout.index("not 99") :]  # what is refused changes nothing


def test_what_is_answered_adds_up_and_what_is_refused_leaves_the_situation() -> None:
    lines = ["the car ahead brakes hard", "new a truck is suddenly there", "set adversary=bicycle", "show"]
    facts = ["set actions=cross", "set position=roadside", "set side=left", "set maneuver=straight", "show", "quit"]
    done = said("chat", *FEW, lines="\n".join([*lines, *facts]))
    assert done.exit_code == 0
    refused = done.stdout.rindex("NothingFits")
    assert "now: A car is ahead of us in our lane. It brakes hard." in done.stdout[:refused]
    assert done.stdout.count("now: A car is ahead") == 2  # shown again after the new one was refused
    assert "now: A cyclist is at the roadside on our left. The cyclist crosses our path." in done.stdout[refused:]


def test_a_conversation_goes_line_by_line(tmp_path: Path) -> None:
    lines = ["the car ahead brakes hard", "make it a truck", "undo", "undo", "make it a dragon", "at night", "show"]
    done = said("chat", *FEW, lines="\n".join([*lines, f"run {tmp_path / 'night'}", "quit", "never read"]))
    assert done.exit_code == 0
    for told in (
        "others.A.kind: car → truck",
        "undone: make it a truck",
        "nothing to undo",
        "'make it a dragon' was not understood, so no fact changes",
    ):
        assert told in done.stdout
    record = runs.read_record(runs.open_run(tmp_path / "night"))
    assert record.edits == ["at night"]


def test_python_edits_what_was_understood() -> None:
    edited = chatscene.explain(WALKS).edit("from the left").edit("hidden by a hedge")
    hider = edited.situation["A"].hidden_by
    assert hider is not None
    assert edited.situation[hider].starts == Start(where=Where.ROADSIDE, side=Side.LEFT)
    assert any("new Hedge at" in line and "with role 'occluder'" in line for line in edited.difference)
    assert chatscene.explain(WALKS, edit=("from the left", "hidden by a hedge")).program == edited.program


def test_a_run_of_a_program_of_ones_own_cannot_be_edited(tmp_path: Path) -> None:
    program = tmp_path / "mine.scenic"
    program.write_text(chatscene.explain(WALKS).program.source)
    run = chatscene.run(program=program, folder=tmp_path / "own", scenes=1, routes=1, ego="rule-based")
    with pytest.raises(EditRefused, match="only texts and situations"):
        run.edit("at night")


def test_a_run_that_was_made_of_no_other_has_nothing_to_undo(tmp_path: Path) -> None:
    run = chatscene.Run(finished(tmp_path / "by hand", count=1).path)
    with pytest.raises(RunError, match="not an edit of another"):
        _ = run.edited_from


def test_a_command_that_has_too_little_memory_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    def explain(*_: object, **__: object) -> None:
        raise MemoryError

    monkeypatch.setattr("chatscene.explain", explain)
    done = CliRunner().invoke(main, ["explain", "a car ahead brakes hard"])
    assert (done.exit_code, "too little memory" in done.output) == (1, True)


@pytest.mark.parametrize("line", ["undo", "show", "run", "run somewhere", "reading 1", "set side=left"])
def test_a_command_before_anything_is_said_is_no_situation(line: str, tmp_path: Path) -> None:
    with pytest.raises(SettingsError, match=r"nothing is said yet .*; describe a situation first"):
        Talk({}, {}, tmp_path).hear(line, silent)


def test_where_nothing_can_be_found_is_told_and_not_counted(tmp_path: Path) -> None:
    missing = CliRunner().invoke(main, ["library", "pending", "--library", str(tmp_path / "nowhere")])
    assert missing.exit_code == 1
    assert "there is no folder" in missing.output
    empty = CliRunner().invoke(main, ["library", "search", " "])
    assert empty.exit_code == 2
    assert "nothing to search for" in empty.output
