"""A folder that was imported: egos drive its programs, and it is a catalogue of its own."""

from __future__ import annotations

import json
import re
import shutil
from dataclasses import replace
from pathlib import Path
from typing import Any, cast

import pytest
from click.testing import CliRunner

import chatscene
from chatscene import runs
from chatscene.commands.main import main
from chatscene.errors import DoesNotCompile, ProgramError, ProgramStopped, RunError, SettingsError, StuckBehavior
from chatscene.imports.collection import RECORD, map_beside, read_collection
from chatscene.imports.import_folder import import_folder
from chatscene.maps.network import resolve_map
from chatscene.measure.drive import Ran, drive
from chatscene.runs.executor import ONE
from chatscene.runs.progress import silent
from chatscene.studies.catalogue import load_catalogue
from chatscene.studies.collection import Compared, Driver, Driving, evaluate_collection
from chatscene.studies.imported_entries import covered
from chatscene.terms.coverage import Answer, Covered, Entry, Tally
from chatscene.terms.scenario import Slots
from chatscene.terms.scene import Rejected, Scene, ScenicProgram
from chatscene.view.looking import listed
from red_team.scenario_files import scenario

EGO = "idm"


@pytest.fixture(scope="module")
def imported(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Two programs, one of them in a folder and without parameters, and a file that was refused."""
    folder = tmp_path_factory.mktemp("theirs")
    (folder / "deep").mkdir()
    shutil.copy(resolve_map("town"), folder / "town.xodr")
    (folder / "a.xosc").write_text(scenario())
    plain = re.sub(r"(?s)<ConstraintGroup>.*?</ConstraintGroup>", "", scenario(map_name="../town.xodr"))
    (folder / "deep" / "b.xosc").write_text(plain)
    (folder / "gone.xosc").write_text(scenario(map_name="gone.xodr"))
    import_folder(folder, out := folder / "mine")
    return out


def test_a_folder_that_was_imported_tells_its_programs_and_their_maps(imported: Path) -> None:
    found = read_collection(imported)
    assert [one.name for one in found.programs] == ["a.scenic", "deep/b.scenic"]
    assert {one.map_path.resolve() for one in found.programs} == {(imported.parent / "town.xodr").resolve()}
    assert list(found.refused) == ["gone.xosc"]
    assert map_beside(imported / "deep" / "b.scenic") is not None
    assert map_beside(imported.parent / "a.xosc") is None


def test_each_ego_drives_each_program_and_other_settings_need_another_folder(imported: Path, tmp_path: Path) -> None:
    driving = Driving(egos=(EGO,), scenes=2)
    done = evaluate_collection(imported, tmp_path / "out", driving, workers=ONE, progress=silent)
    (fared,) = done.fared
    rows = json.loads((done.folder / "evaluation.json").read_text())["drives"]
    assert [row["program"] for row in rows] == ["a.scenic", "a.scenic", "deep/b.scenic"]
    assert fared["drives"] == 3
    assert all(row["status"] == "ran" for row in rows)
    page = done.page.read_text()
    assert "deep/b.scenic" in page
    assert "gone.xosc" in page
    with pytest.raises(
        RunError, match=r"an evaluation of an imported folder with other settings: settings\.seed was 0"
    ):
        evaluate_collection(imported, done.folder, replace(driving, seed=1), workers=ONE, progress=silent)


class _Killed(BaseException):
    pass


def _kill_when_driving(what: str, *_: object) -> None:
    if what.startswith("driving"):
        raise _Killed


def test_an_evaluation_that_was_killed_is_gone_on_with_by_resume(imported: Path, tmp_path: Path) -> None:
    theirs = shutil.copytree(imported.parent, tmp_path / "theirs") / imported.name
    driving, out = Driving(egos=(EGO,), scenes=2), tmp_path / "out"
    whole = evaluate_collection(theirs, tmp_path / "whole", driving, workers=ONE, progress=silent)
    with pytest.raises(_Killed):
        evaluate_collection(theirs, out, driving, workers=ONE, progress=_kill_when_driving)
    kept = (out / "drives.jsonl").read_text()
    assert kept.count("\n") == 1
    (out / "drives.jsonl").write_text(kept + '{"digest": "')  # as a kill leaves it
    assert runs.read_record(runs.Workspace(out), runs.ComparisonRecord).status is runs.Status.RUNNING
    done = CliRunner().invoke(main, ["resume", str(out)])
    assert done.exit_code == 0, done.output
    for name in ("drives.jsonl", "evaluation.json", "tables/collisions.csv"):
        assert (out / name).read_text() == (tmp_path / "whole" / name).read_text()
    assert runs.check(out).whole
    assert [one["kind"] for one in listed(tmp_path)["pages"]] == ["evaluation", "evaluation"]
    assert f"{EGO} on 2 imported programs" in {one["title"] for one in listed(tmp_path)["pages"]}
    moved = shutil.copytree(tmp_path, tmp_path.parent / f"{tmp_path.name}-moved")
    resumed = chatscene.resume(moved / "out")
    assert isinstance(resumed, Compared)
    assert resumed.fared == whole.fared
    with (theirs / "a.scenic").open("a") as program:
        program.write("# changed\n")
    with pytest.raises(RunError, match="a program or a map was changed, added or removed"):
        chatscene.resume(out)


def test_what_was_kept_and_is_damaged_is_told(imported: Path, tmp_path: Path) -> None:
    driving, out = Driving(egos=(EGO,), scenes=1), tmp_path / "out"
    with pytest.raises(_Killed):
        evaluate_collection(imported, out, driving, workers=ONE, progress=_kill_when_driving)
    kept = out / "drives.jsonl"
    kept.write_text(kept.read_text().replace('"status": "ran"', '"status": "run"'))
    with pytest.raises(RunError, match="line 1, is not what was written"):
        chatscene.resume(out)


@pytest.mark.parametrize(
    ("error", "others"),
    [
        (StuckBehavior("it does not come to its end"), True),
        (ProgramError("its code fails"), True),
        (ProgramStopped("it used up its memory"), True),
        (DoesNotCompile("it is no Scenic"), False),
    ],
)
def test_a_drive_that_fails_is_told_and_the_other_drives_of_the_program_are_kept(
    error: Exception, others: bool, imported: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    made = drive

    def fail(program: ScenicProgram, said: Slots, scene: Scene, **how: Any) -> Ran | Rejected:
        if scene.id == "a/route-00/draw-001":
            raise error
        return made(program, said, scene, **how)

    monkeypatch.setattr("chatscene.studies.collection.drive", fail)
    words = ["evaluate", str(imported), "--ego", EGO, "--out", str(tmp_path / "out")]
    done = CliRunner().invoke(main, words)
    drives = json.loads((tmp_path / "out" / "evaluation.json").read_text())["drives"]
    ran = [row["status"] == "ran" for row in drives if row["program"] == "a.scenic"]
    assert ran == ([True, False] + 8 * [others])
    assert f"driven in part: a.scenic: without {ran.count(False)} of 10 drives: {error}" in done.output
    assert "not driven" not in done.output
    assert done.exit_code == 0
    page = (tmp_path / "out" / "report.html").read_text()
    assert "; 1 could not be driven in each scene" in page


def test_a_program_that_does_not_run_is_named_and_ends_with_status_1(imported: Path, tmp_path: Path) -> None:
    changed = tmp_path / "mine"
    changed.mkdir()
    record = json.loads((imported / RECORD).read_text())
    one = record["files"][0]
    name = one["maps"][0]
    one["maps"], record["map_digests"] = ["town"], {"town": record["map_digests"][name]}
    (changed / RECORD).write_text(json.dumps({**record, "files": [one]}))
    (changed / "a.scenic").write_text((imported / "a.scenic").read_text() + "import os\n")
    done = CliRunner().invoke(main, ["evaluate", str(changed), "--ego", EGO, "--out", str(tmp_path / "out")])
    assert done.exit_code == 1
    assert "not driven: a.scenic: your program" in done.output
    catalogue = load_catalogue(str(changed))
    assert [entry.name for entry in catalogue.entries] == ["a.scenic"]


@pytest.mark.parametrize(
    ("change", "why"),
    [
        ({"programs": ["../a.scenic"]}, "which is not in"),
        ({"programs": ["gone.scenic"]}, "which is not in"),
        ({"maps": ["../gone.xodr"]}, "is not there any more"),
        ({"programs": 3}, "is not the record of an import"),
    ],
)
def test_a_record_that_was_changed_is_refused(
    change: dict[str, object], why: str, imported: Path, tmp_path: Path
) -> None:
    record = json.loads((imported / RECORD).read_text())
    (tmp_path / RECORD).write_text(json.dumps({**record, "files": [{**record["files"][0], "maps": [], **change}]}))
    (tmp_path.parent / "a.scenic").write_text("")
    if change.get("programs") != 3 and "maps" not in change:
        change = {**change, "maps": ["town"]}
        digests = {"town": next(iter(record["map_digests"].values()))}
        (tmp_path / RECORD).write_text(
            json.dumps({"files": [{**record["files"][0], **change}], "map_digests": digests})
        )
    with pytest.raises(RunError, match=why):
        read_collection(tmp_path)


def test_what_is_asked_of_runs_is_not_asked_of_an_imported_folder(imported: Path, tmp_path: Path) -> None:
    with pytest.raises(SettingsError, match="is evaluated alone, in the sandbox"):
        chatscene.evaluate([imported], tmp_path / "out", simulator="native")
    with pytest.raises(SettingsError, match="name each ego once"):
        chatscene.evaluate(imported, tmp_path / "out", ego=[EGO, EGO])


def test_a_catalogue_of_an_imported_folder_has_its_programs_and_what_was_refused(imported: Path) -> None:
    done = CliRunner().invoke(
        main, ["coverage", "--catalogue", str(imported), "--drive", "--scenes", "1", "--ego", EGO, "--json"]
    )
    (told,) = json.loads(done.stdout)["catalogues"]
    assert [row["answer"] for row in told["rows"]] == [Answer.SERVED, Answer.SERVED, Answer.OUT_OF_REACH]
    assert [one["scenes"] for row in told["rows"] for one in row["fared"]] == [1, 1]
    assert "does not lie there" in told["rows"][2]["reasons"][0]


def test_a_program_that_fails_in_most_of_its_drives_is_not_shown() -> None:
    ran: dict[str, Any] = {"status": "ran", "ego": EGO, "unplayed": [], "collision": False, "avoidable": None}
    failed, rejected = ({"status": status, "ego": EGO, "reason": "why"} for status in ("failed", "rejected"))
    entry = Entry(name="a", sentence="a", program="a.scenic", map_name="town")
    asked = Covered(catalogue="mine", entry=entry, answer=Answer.SERVED, slots={})

    def drives(_: object) -> list[dict[str, Any]]:
        return [ran, *[failed] * 8, rejected]

    row = covered(asked, cast(Driver, drives), [EGO])
    assert (row.shown, row.scenes) == (1, 9)
    assert Tally.of([row]).shown == 0


def test_a_file_of_that_name_above_a_program_that_is_no_record_says_nothing_of_it(tmp_path: Path) -> None:
    (tmp_path / RECORD).write_text('{"mine": true}')
    assert map_beside(tmp_path / "deep" / "a.scenic") is None
