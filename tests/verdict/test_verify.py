"""Anybody's scene is held against what was said, fact by fact, and told what it lacks."""

from __future__ import annotations

import json
import math
import re
from pathlib import Path

import pytest
from click.testing import CliRunner

import chatscene
from chatscene.commands.main import main
from chatscene.errors import ChatSceneError, SettingsError
from chatscene.situations.file import read_text
from chatscene.terms.situation import Situation
from chatscene.verdict.sources import KINDS
from plainly import NONE

CROSSES = "A pedestrian crosses the street from the right."
BRAKES = """
model scenic.domains.driving.model
behavior Brakes():
    do FollowLaneBehavior(target_speed=10) for 3 seconds
    while True:
        take SetThrottleAction(0), SetBrakeAction(1)
lane = Uniform(*network.lanes)
spot = new OrientedPoint on lane.centerline
ego = new Car at spot{ego}
ahead = new Car following roadDirection from spot for Range(12, 15), with behavior Brakes()
require distance from ego to intersection > 60
"""
DRIVES = ", with behavior FollowLaneBehavior(target_speed=10)"


def table(
    path: Path, *, side: float = -1.0, kind: str = "pedestrian", sets_off: float = 1.5, until: float = 14.9
) -> Path:
    """An ego at 10 m/s, and somebody 45 m ahead who crosses its way; both until a time [s]."""
    rows = ["time,id,kind,x,y,heading,speed,ego"]
    for step in range(150):
        now = step / 10
        moves = now > sets_off
        y = side * (6.0 - 1.5 * max(0.0, now - sets_off))
        rows.append(f"{now},car1,car,{10 * now},0,0,10,1")
        if now <= until:
            rows.append(f"{now},walker,{kind},45,{y},{-side * math.pi / 2},{1.5 if moves else 0},0")
    path.write_text("\n".join(rows))
    return path


def say(*words: object) -> tuple[int, str]:
    done = CliRunner().invoke(main, ["verify", *map(str, words)], catch_exceptions=False)
    return done.exit_code, done.output


def one_who(text: str) -> Situation:
    return read_text(f"others: [{{id: A, {text}}}]")


@pytest.fixture
def drive(tmp_path: Path) -> Path:
    return table(tmp_path / "drive.csv")


def test_a_table_that_shows_all_that_was_said_gives_status_0(drive: Path) -> None:
    verdict = chatscene.verify(drive, CROSSES)
    assert verdict.status == 0
    assert {one.path: one.shown for one in verdict.facts}["others.A.starts.side"] == 1
    assert verdict.who == {"A": "walker"}


@pytest.mark.parametrize(
    ("said", "lacks"),
    [
        ("A pedestrian crosses the street from the left.", "others.A.starts.side"),
        ("A cyclist crosses the street from the right.", "others.A.kind"),
        ("A pedestrian crosses the street from the right and turns back.", "others.A.does.1.act"),
    ],
)
def test_what_a_table_does_not_show_is_named_and_gives_status_1(drive: Path, said: str, lacks: str) -> None:
    verdict = chatscene.verify(drive, said)
    assert verdict.status == 1
    assert lacks in {one.path for one in verdict.failing}


def test_a_deed_that_is_not_seen_is_told_with_what_is_seen_in_its_place(drive: Path) -> None:
    said = one_who("kind: pedestrian, starts: {where: roadside, side: right}, does: [{act: turn-back}]")
    (fact,) = (one for one in chatscene.verify(drive, said).failing if one.path == "others.A.does.0.act")
    assert "it is seen to" in fact.instead
    assert "cross at 1.5 s" in fact.instead


def test_an_encounter_that_comes_too_late_is_none(tmp_path: Path) -> None:
    verdict = chatscene.verify(table(tmp_path / "late.csv", sets_off=8.0), CROSSES)
    assert verdict.status == 1
    assert [one.path for one in verdict.encounters if not one.shown] == ["encounter.A"]


def test_of_a_recording_without_a_map_the_road_is_not_judged(drive: Path) -> None:
    said = read_text(
        "road: {kind: four-way, control: signal}\n"
        "others: [{id: A, kind: pedestrian, starts: {where: roadside}, does: [{act: cross}]}]"
    )
    verdict = chatscene.verify(drive, said)
    assert {one.path: one.answer for one in verdict.facts if one.path.startswith("road")} == {
        "road.kind": "not seen",
        "road.control": "not seen",
    }
    assert verdict.status == 0


def test_who_is_gone_is_told_and_the_drive_is_judged_until_then(tmp_path: Path) -> None:
    verdict = chatscene.verify(table(tmp_path / "gone.csv", until=3.5), CROSSES)
    assert "judged from 0.0 to 3.5 s, while walker and the ego are there" in verdict.notes


def test_a_contact_that_was_said_and_is_none_is_not_shown_by_a_recording(tmp_path: Path) -> None:
    said = read_text(
        "others: [{id: A, kind: pedestrian, starts: {where: roadside}, does: [{act: cross}]}]\ncontact: {striker: ego}"
    )
    verdict = chatscene.verify(table(tmp_path / "late.csv", sets_off=8.0), said)
    assert "contact.happens" in {one.path for one in verdict.failing}
    (striker,) = [one for one in verdict.facts if one.path == "contact.striker"]
    assert striker.answer == "not reached", "how two touch is not come to where they do not"


def test_who_has_another_name_is_found_by_what_is_shown(tmp_path: Path) -> None:
    rows = table(tmp_path / "two.csv").read_text().splitlines()
    parked = [f"{step / 10},other,pedestrian,80,-6,0,0,0" for step in range(150)]
    (tmp_path / "two.csv").write_text("\n".join([rows[0], *parked, *rows[1:]]))
    assert chatscene.verify(tmp_path / "two.csv", CROSSES).who == {"A": "walker"}


def test_json_has_every_fact_with_what_each_drive_shows(drive: Path) -> None:
    status, told = say(drive, CROSSES, "--json")
    read = json.loads(told)
    assert status == read["status"] == 0
    (deed,) = (one for one in read["facts"] if one["fact"] == "others.A.does.0.act")
    assert deed["draws"] == [{"draw": 0, "shown": True, "at": 1.5, "told": "said cross"}]


def test_the_page_has_a_picture_of_each_moment_and_asks_nobody_for_anything(drive: Path, tmp_path: Path) -> None:
    assert say(drive, CROSSES, "--page", tmp_path / "verdict.html")[0] == 0
    page = (tmp_path / "verdict.html").read_text()
    assert page.count('<img src="data:image/webp;base64,') == 3
    assert "http" not in page.split("</head>")[1]


def test_a_report_and_the_file_of_a_situation_are_taken_as_a_sentence_is(drive: Path, tmp_path: Path) -> None:
    (tmp_path / "report.txt").write_text(CROSSES)
    (tmp_path / "said.yaml").write_text("others: [{id: A, kind: bicycle, starts: {where: roadside}}]")
    assert say(drive, tmp_path / "report.txt")[0] == 0
    assert say(drive, tmp_path / "said.yaml")[0] == 1


@pytest.mark.parametrize(
    ("words", "status", "told"),
    [
        (["nowhere.scenic", CROSSES], 2, "no file or run folder 'nowhere.scenic'"),
        (["a" * 5000, CROSSES], 2, "no file or run folder 'aaa"),
        (["drive.csv"], 2, "say what drive.csv should show"),
        (["drive.csv", "nowhere.yaml"], 2, "nowhere.yaml"),
        (["drive.csv", "bad.json"], 2, "bad.json"),
        (["drive.csv", NONE], 3, "tells no dangerous traffic situation"),
        (["drive.csv", CROSSES, "--ego-id", "nobody"], 2, "there are: car1, walker"),
        (["page.html", CROSSES], 2, "ends in '.html', which is not a kind that can be read"),
        ([".", CROSSES], 2, "no run.json"),
        (["empty.scenic", CROSSES], 2, "is empty"),
        (["import.scenic", CROSSES], 2, "import"),
        (["binary.csv", CROSSES], 2, "is not UTF-8 text"),
        (["bomb.xosc", CROSSES], 2, "bomb.xosc"),
        (["drive.csv", CROSSES, "--page", "."], 2, "cannot write"),
    ],
)
def test_what_cannot_be_judged_is_told_in_one_error_with_its_status(
    words: list[str], status: int, told: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    table(tmp_path / "drive.csv")
    for name, content in {
        "page.html": "x",
        "empty.scenic": "",
        "import.scenic": "import os\nmodel chatscene.world.model\nego = new Car",
        "bad.json": '{"others": [[[',
        "bomb.xosc": '<!DOCTYPE a [<!ENTITY b "bbb">]><a>&b;</a>',
    }.items():
        (tmp_path / name).write_text(content)
    (tmp_path / "binary.csv").write_bytes(b"\xff\xfe\x00time")
    found, output = say(*words)
    assert found == status, output
    assert told in output
    assert "Traceback" not in output


def test_snippets_of_ones_own_have_no_facts_to_be_judged_by(drive: Path, tmp_path: Path) -> None:
    with pytest.raises(SettingsError, match="read into facts"):
        chatscene.verify(drive, CROSSES, library=tmp_path)


# Programs


@pytest.fixture(scope="module")
def theirs(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("theirs")
    (folder / "brakes.scenic").write_text(BRAKES.format(ego=DRIVES))
    (folder / "still.scenic").write_text(BRAKES.format(ego=""))
    (folder / "never.scenic").write_text("model scenic.domains.driving.model\nego = new Car\nterminate when True\n")
    (folder / "wrong.scenic").write_text(BRAKES.format(ego=", with behaviour Brakes()"))
    return folder


def test_a_strangers_program_drives_as_it_is_written(theirs: Path) -> None:
    verdict = chatscene.verify(theirs / "brakes.scenic", "The car ahead brakes hard.", draws=2)
    assert verdict.status == 0
    assert "its own ego drives" in verdict.notes
    assert verdict.crashes
    assert all(one.avoidable is None for one in verdict.crashes)  # no careful driver takes its ego's place


def test_a_program_shows_nothing_else_than_it_does(theirs: Path) -> None:
    verdict = chatscene.verify(theirs / "brakes.scenic", "The car ahead of us reverses.", draws=2)
    assert verdict.status == 1


def test_an_ego_that_never_moves_is_told_as_such(theirs: Path) -> None:
    verdict = chatscene.verify(theirs / "still.scenic", "The car ahead brakes hard.", draws=2)
    assert verdict.status == 1
    assert verdict.dead == ("the ego never moves in 2 of 2 drives, which the text does not say",)


def test_a_program_that_ends_without_a_step_shows_nothing(theirs: Path) -> None:
    verdict = chatscene.verify(theirs / "never.scenic", "The car ahead brakes hard.", draws=2)
    assert verdict.status == 2
    assert verdict.dead == ("2 of 2 drives end without a step",)


def test_a_program_that_does_not_compile_is_bad_input(theirs: Path) -> None:
    status, told = say(theirs / "wrong.scenic", "The car ahead brakes hard.", "--draws", 1)
    assert status == 2
    assert "wrong.scenic" in told


def test_a_parameter_that_a_program_reads_is_given_to_each_command_that_drives_it(tmp_path: Path) -> None:
    path = tmp_path / "reads.scenic"
    path.write_text(BRAKES.format(ego=DRIVES).replace("Range(12, 15)", "globalParameters.gap"))
    status, told = say(path, "The car ahead brakes hard.", "--draws", 1)
    assert status == 2
    assert "reads parameters that it does not state: gap; give each, as in --param gap=VALUE" in told
    assert say(path, "The car ahead brakes hard.", "--draws", 1, "--param", "gap=13")[0] == 0
    for gap in (13, 30):
        done = CliRunner().invoke(main, ["story", str(path), "--param", f"gap={gap}"], catch_exceptions=False)
        far = re.search(r"the car is (\d+) m ahead", done.output)
        assert far is not None, done.output
        assert gap - 6 <= float(far[1]) <= gap + 1


@pytest.mark.parametrize(("option", "why"), [("--param", "parameters are given to"), ("--variant", "variants are of")])
@pytest.mark.parametrize("command", ["verify", "story"])
def test_what_a_recording_has_none_of_is_refused_and_not_dropped(
    command: str, option: str, why: str, drive: Path
) -> None:
    words = [command, str(drive), *(["A car brakes."] if command == "verify" else []), option]
    done = CliRunner().invoke(main, [*words, "near=3" if option == "--param" else "3"])
    assert done.exit_code != 0
    assert why in done.output


def test_scenes_that_cannot_be_placed_cost_no_more_than_a_budget_that_is_told(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("chatscene.simulate.staging.DRAWING", 0.3)  # [s] for each scene
    path = tmp_path / "hardly.scenic"
    path.write_text(BRAKES.format(ego=DRIVES) + "require distance from ego to ahead > 100\n")
    verdict = chatscene.verify(path, "The car ahead brakes hard.", trust=True, draws=9, budget=0.5)
    assert verdict.status == 2
    assert len(verdict.rejected) == 2
    counted, stopped = verdict.notes[-2:]
    assert re.fullmatch(r"(\d+) draws for 0 drives: \1 met no requirement or had no place", counted)
    assert stopped.startswith("stopped after 2 of 9 drives: scenes that could not be driven took 1 s of processor time")
    assert stopped.endswith("--budget allows 0.5 s")


FAILS = BRAKES.replace("    do FollowLaneBehavior(target_speed=10) for 3 seconds", "    do Once()") + (
    "\nbehavior Once():\n    if globalParameters.unlucky:\n        {wrong}\n"
    "    do FollowLaneBehavior(target_speed=10) for 3 seconds\nparam unlucky = DiscreteRange(0, {most})\n"
)


@pytest.mark.parametrize(("wrong", "why"), [("x = 1 / 0", "division by zero"), ("while True: pass", "did not come")])
def test_a_drive_in_which_a_program_fails_is_told_and_its_others_are_judged(
    wrong: str, why: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("chatscene.simulate.watchdog.PATIENCE", 2.0)  # [s]
    path = tmp_path / "sometimes.scenic"
    path.write_text(FAILS.format(ego=DRIVES, wrong=wrong, most=1))
    verdict = chatscene.verify(path, "The car ahead brakes hard.", trust=True, draws=2, seed=2)
    assert len(verdict.draws) == len(verdict.rejected) == 1
    assert why in verdict.rejected[0]
    assert verdict.dead == ("the program fails, or does not come to its end, in 1 of 2 drives",)
    assert verdict.status == 1
    path.write_text(FAILS.format(ego=DRIVES, wrong=wrong, most=0).replace("if globalParameters.unlucky", "if True"))
    with pytest.raises(ChatSceneError, match=why):
        chatscene.verify(path, "The car ahead brakes hard.", trust=True, draws=1)


def test_a_program_of_ours_with_two_who_act_is_judged_on_a_map_that_has_its_place(tmp_path: Path) -> None:
    situation = read_text(
        "road: {kind: motorway}\n"
        "others:\n"
        "- {id: A, kind: car, starts: {where: ahead}, does: [{act: brake}]}\n"
        "- {id: B, kind: van, role: supporting, starts: {where: behind}, does: [{act: go-along}]}\n"
    )
    (tmp_path / "two.scenic").write_text(chatscene.explain(situation).program.source)
    verdict = chatscene.verify(tmp_path / "two.scenic", situation, draws=2)
    assert verdict.status == 0, str(verdict)
    assert "on map outskirts" in verdict.notes


def test_a_file_of_openscenario_is_judged_as_the_program_that_it_is_here(tmp_path: Path) -> None:
    export = chatscene.run("The car ahead brakes hard.", tmp_path / "run", scenes=4)
    told = chatscene.export(export.folder, to="openscenario-logical", out=tmp_path / "out")
    file, *_ = sorted(tmp_path.glob("out/*.xosc"))
    assert told.folder == tmp_path / "out"
    verdict = chatscene.verify(file, "The car ahead brakes hard.", draws=2)
    assert verdict.kind == "OpenSCENARIO file"
    assert verdict.status == 0, str(verdict)
    assert chatscene.verify(export, draws=2).status == 0
    assert chatscene.verify(export, "The car ahead of us reverses.", draws=2).status == 1


def test_every_kind_that_is_judged_is_named_wherever_kinds_are_told() -> None:
    told = [CliRunner().invoke(main, [command, "--help"]).output for command in ("verify", "story")]
    for text in (*told, chatscene.verify.__doc__ or ""):
        assert [kind for kind in KINDS if f"({kind})" not in text.replace("``", "")] == []


def test_what_is_no_program_is_not_driven_as_written(tmp_path: Path) -> None:
    for what in (tmp_path, table(tmp_path / "drive.csv")):
        with pytest.raises(SettingsError, match="--as-written is for a program"):
            chatscene.verify(what, CROSSES, as_written=True)
