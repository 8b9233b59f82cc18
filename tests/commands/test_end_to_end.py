"""The command: as a user starts it where a process is what matters, else in this one, which has loaded everything."""

import json
import os
import signal
import subprocess
import sys
import time
from functools import partial
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from chatscene import pipeline, runs
from chatscene.commands.main import main
from chatscene.errors import NothingFits
from chatscene.simulate.confined.landlock import landlock_version
from fake_run import resealed
from places import ROOT

SENTENCE = "A cyclist rides out from the left and stops in front of us."
SURE = ("--ego", "sac")  # which does not see the cyclist, so that there are collisions
SAME = ("scenes.parquet", "events.parquet", "signals.parquet", "ranges.parquet", "map.json", "explanation.json")


def chatscene(*arguments: str) -> Result:
    """The command in this process."""
    return CliRunner().invoke(main, arguments, catch_exceptions=False)


def started(*arguments: str) -> "subprocess.Popen[str]":
    """The command as a user starts it."""
    command = [sys.executable, "-m", "chatscene", *arguments]
    return subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)


@pytest.fixture(scope="module")
def finished(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """An uninterrupted run of one process."""
    folder = tmp_path_factory.mktemp("whole run") / "one job"
    run = started("run", SENTENCE, *SURE, "--out", str(folder), "--routes", "2", "--scenes", "20", "--jobs", "1")
    errors = run.communicate()[1]
    assert run.returncode == 0, errors
    return folder


def content(folder: Path) -> dict[str, bytes]:
    """Everything in a run folder that two equal runs must share."""
    paths = (
        [folder / name for name in SAME] + sorted((folder / "episodes").iterdir()) + sorted(folder.glob("programs/*"))
    )
    return {str(path.relative_to(folder)): path.read_bytes() for path in paths}


def test_a_sentence_becomes_scenes_and_a_report(finished: Path) -> None:
    record = json.loads((finished / "run.json").read_text())
    assert record["status"] == "done"
    assert record["counts"]["ran"] == 40
    assert record["counts"]["selected"] == 4
    scenes = runs.read_scenes(runs.open_run(finished))
    assert record["counts"]["selected_shown"] == 4
    assert all(row["meaning_ok"] for row in scenes if row["selected"])
    assert sum(row["meaning_ok"] for row in scenes) > 20
    assert any(row["collision"] for row in scenes)
    assert SENTENCE in (finished / "report.html").read_text()
    assert list(finished.glob("*.gif"))


def test_a_run_of_two_processes_that_is_killed_twice_ends_like_one_of_one_that_was_not(
    finished: Path, tmp_path: Path
) -> None:
    folder = tmp_path / "killed"
    arguments = ["run", SENTENCE, *SURE, "--out", str(folder), "--routes", "2", "--scenes", "20", "--jobs", "2"]
    for blocks in (0, 2):
        process = started(*arguments)
        while not (folder / "run.json").exists() or len(list(folder.glob("parts/*.json"))) < blocks:
            assert process.poll() is None, "the run did not come that far"
            time.sleep(0.002)
        os.kill(process.pid, signal.SIGKILL)
        process.communicate()
        arguments = ["resume", str(folder)]
    assert not (folder / "scenes.parquet").exists()
    resumed = started("resume", str(folder))
    errors = resumed.communicate()[1]
    assert resumed.returncode == 0, errors
    assert content(folder) == content(finished)


@pytest.mark.skipif(sys.platform == "win32", reason="a group of processes is one of Unix")
def test_an_interrupted_run_names_its_folder_and_no_worker_complains(tmp_path: Path) -> None:
    folder = tmp_path / "interrupted run"
    command = [sys.executable, "-m", "chatscene", "run", SENTENCE, *SURE, "--out", str(folder)]
    heard = partial(signal.signal, signal.SIGINT, signal.SIG_DFL)  # whoever starts the tests may ignore it
    process = subprocess.Popen(
        [*command, "--scenes", "200", "--routes", "2", "--jobs", "2"],
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
        preexec_fn=heard,  # noqa: PLW1509 - nothing here holds a lock
    )
    while not (folder / "map.json").exists():  # written just before the workers begin
        assert process.poll() is None, "the run did not come that far"
        time.sleep(0.002)
    time.sleep(0.5)
    os.killpg(process.pid, signal.SIGINT)
    errors = process.communicate(timeout=60)[1]
    assert process.returncode == 130
    assert "Traceback" not in errors
    last = errors.strip().splitlines()[-1]
    assert last == f"interrupted; what was finished is kept; continue with: chatscene resume '{folder}'"


def test_an_interrupted_command_that_left_nothing_promises_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupted(*_: object, **__: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("chatscene.explain", interrupted)
    answer = chatscene("explain", SENTENCE)
    assert answer.exit_code == 130
    assert answer.stderr.strip() == "interrupted"


def test_a_finished_run_is_not_run_again(finished: Path) -> None:
    before = {path: (path.stat().st_mtime_ns, path.read_bytes()) for path in finished.rglob("*") if path.is_file()}
    first, second = (chatscene("resume", str(finished)) for _ in range(2))
    assert first.exit_code == second.exit_code == 0
    assert first.stdout == second.stdout  # the time that the run took, too
    assert {path: (path.stat().st_mtime_ns, path.read_bytes()) for path in before} == before
    (drawn,) = finished.glob("*.gif")
    drawn.unlink()
    assert chatscene("resume", str(finished)).exit_code == 0
    assert drawn.read_bytes() == before[drawn][1]


def test_a_scene_replays_bit_for_bit(finished: Path) -> None:
    kept = next(row for row in runs.read_scenes(runs.open_run(finished)) if row["selected"])
    answer = chatscene("replay", str(finished), kept["scene_id"], "--json")
    told = {"scene_id": kept["scene_id"], "identical": True, "difference": "", "versions": {}}
    assert json.loads(answer.stdout) == {**told, "within": 0.0, "apart": 0.0}


def test_a_replay_of_changed_tracks_says_where_they_differ(finished: Path, tmp_path: Path) -> None:
    import shutil

    import pyarrow as pa
    import pyarrow.parquet as pq

    folder = tmp_path / "changed"
    shutil.copytree(finished, folder)
    path = min((folder / "episodes").iterdir())
    table = pq.read_table(path)
    x = table.column("x").to_numpy().copy()
    x[7] += 1e-9
    pq.write_table(table.set_column(table.column_names.index("x"), "x", pa.array(x)), path)
    resealed(runs.Workspace(folder))
    scene = table.column("scene_id")[0].as_py()
    answer = chatscene("replay", str(folder), scene)
    assert answer.exit_code == 1
    assert "x from step 7 on" in answer.stdout


def test_what_is_not_understood_is_refused_with_status_3_and_leaves_no_folder(tmp_path: Path) -> None:
    folder = tmp_path / "refused"
    answer = chatscene("run", "A helicopter lands on the roof of our car.", "--out", str(folder))
    assert answer.exit_code == 3
    told = " ".join(answer.stderr.split())
    assert "the offline reader says that it tells " in told
    assert "This one works: chatscene explain " in told
    assert not folder.exists()


def test_what_the_library_cannot_do_is_refused_by_whoever_chooses_of_it(tmp_path: Path) -> None:
    folder = tmp_path / "refused"
    with pytest.raises(NothingFits, match="in the library does this"):
        pipeline.run(runs.asked_run("A helicopter lands on the roof of our car."), folder)
    assert json.loads((folder / "run.json").read_text())["status"] == "refused"


BAD = {
    "empty text": (["run", ""], "the text is empty"),
    "noise": (["run", "x7 " * 3500], "at most"),
    "unknown map": (["run", SENTENCE, "--map", "twon"], "did you mean 'town'"),
    "not a run": (["resume", "."], "not a run folder"),
    "unknown snippet": (["library", "show", "behavior/cros"], "did you mean"),
}


@pytest.mark.parametrize("case", BAD)
def test_bad_input_ends_in_one_clear_message(case: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    arguments, words = BAD[case]
    answer = chatscene(*arguments)
    assert answer.exit_code == 1
    assert words in answer.stderr
    assert len(answer.stderr.strip().splitlines()) == 1


@pytest.mark.skipif(sys.platform == "win32", reason="the limit is one of Unix")
def test_where_a_process_may_take_too_little_memory_no_command_begins(monkeypatch: pytest.MonkeyPatch) -> None:
    import resource

    def little(_: int) -> tuple[int, int]:
        return 300 * 2**20, resource.RLIM_INFINITY

    monkeypatch.setattr(resource, "getrlimit", little)
    answer = chatscene("explain", "a car ahead brakes hard")
    assert answer.exit_code == 1
    assert answer.stderr.startswith("SettingsError: a process may take 300 MiB here (ulimit -v), and at least 512 are")


def test_the_status_of_a_command_is_that_of_its_process(tmp_path: Path) -> None:
    command = started("resume", str(tmp_path))
    errors = command.communicate()[1]
    assert command.returncode == 1
    assert "not a run folder" in errors
    assert len(errors.strip().splitlines()) == 1


def test_a_truncated_map_is_named(tmp_path: Path) -> None:
    whole = (ROOT / "src" / "chatscene" / "maps" / "town.xodr").read_text()
    broken = tmp_path / "half.xodr"
    broken.write_text(whole[: len(whole) // 2])
    answer = chatscene("run", SENTENCE, "--map", str(broken), "--out", str(tmp_path / "run"))
    assert answer.exit_code == 1
    assert "half.xodr" in answer.stderr


def test_an_output_folder_that_cannot_be_written_is_named(tmp_path: Path) -> None:
    taken = tmp_path / "taken"
    taken.write_text("a file, not a folder")
    answer = chatscene("run", SENTENCE, "--out", str(taken / "run"))
    assert answer.exit_code == 1
    assert "taken" in answer.stderr


def test_usage_errors_have_status_2() -> None:
    assert chatscene("run").exit_code == 2
    assert chatscene("fly").exit_code == 2


@pytest.mark.parametrize(
    "command",
    ["", "run", "resume", "replay", "check", "explain", "library", "library lint", "map", "map info", "doctor"],
)
def test_every_command_has_a_help_with_an_example(command: str) -> None:
    answer = chatscene(*command.split(), "--help")
    assert answer.exit_code == 0
    examples = [line for line in answer.stdout.splitlines() if line.startswith("  chatscene ")]
    assert examples or command in ("library", "map")


def test_explain_speaks_to_people_and_to_scripts() -> None:
    told = " ".join(chatscene("explain", SENTENCE).stdout.split())
    assert "A cyclist is at the roadside on our left. The cyclist crosses our path, then stops." in told
    assert "(others.A.does.0.act: rides out)" in told
    assert "act: stop" in told
    answer = json.loads(chatscene("explain", SENTENCE, "--json").stdout)
    assert "model chatscene.world.model" in answer["program"]


def test_doctor_finds_nothing_wrong() -> None:
    checks = json.loads(chatscene("doctor", "--json").stdout)
    assert all(check["ok"] for check in checks), checks
    walls = next(check["found"] for check in checks if check["what"] == "walls around strangers' code")
    assert walls.startswith("allow-list, limits, ")
    assert ("landlock" in walls.partition("; missing: ")[0]) == (landlock_version() > 0)


@pytest.mark.parametrize(
    "words", [("run", "a car ahead brakes hard", "--out", "a\0b"), ("open", "a\0b"), ("explain", "a\0b")]
)
def test_what_holds_a_nul_is_refused_as_wrong_usage(words: tuple[str, ...]) -> None:
    done = CliRunner().invoke(main, words)
    assert done.exit_code == 2
    assert "holds a NUL character" in done.output
