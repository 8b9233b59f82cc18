"""Nothing that a run wrote changes in silence: what is damaged, missing or added has a name, and is not used."""

from __future__ import annotations

import errno
import json
import os
import random
import shutil
import signal
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pyarrow as pa
import pyarrow.parquet as pq
import pytest
from click.testing import CliRunner, Result

from chatscene import pipeline
from chatscene.commands.main import main
from chatscene.errors import ChatSceneError, RunError, SettingsError
from chatscene.learn.finetune.scenes import kept_scenes
from chatscene.learn.train import TrainSettings, train
from chatscene.report.animation import write_gif
from chatscene.report.viewer import write_report
from chatscene.runs import (
    Status,
    Workspace,
    alone,
    check,
    create,
    finish,
    note,
    open_run,
    read_choice,
    read_episode,
    read_explanation,
    read_programs,
    read_ranges,
    read_record,
    read_scenes,
    resume,
    settings_of,
    take_up,
    update,
    write_block,
)
from chatscene.runs.blocks import damaged_parts
from chatscene.runs.digests import write_sealed
from chatscene.runs.replay import replay
from chatscene.runs.tables import scene_of
from chatscene.settings import RetrievalSettings, SearchSettings, SimulationSettings
from chatscene.studies.benchmark import benchmark
from chatscene.studies.evaluation import evaluate
from chatscene.terms.scene import ScenicProgram
from chatscene.terms.snippet import ParameterRange
from fake_run import SCENARIO, asked, blocks, finished, resealed, selection, started


def command(*arguments: str) -> Result:
    return CliRunner().invoke(main, arguments)


def _flip(path: Path, bit: int) -> None:
    content = bytearray(path.read_bytes())
    content[bit // 8] ^= 1 << bit % 8
    path.write_bytes(content)


def _files(folder: Path) -> list[Path]:
    return sorted(path for path in folder.rglob("*") if path.is_file())


@pytest.fixture(scope="module")
def drawn(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A finished run with everything that is drawn from it."""
    run = finished(tmp_path_factory.mktemp("damage") / "run", count=2)
    write_report(run.path)
    write_gif(run.path)
    return run.path


@pytest.fixture
def folder(drawn: Path, tmp_path: Path) -> Path:
    return shutil.copytree(drawn, tmp_path / "run")


# Names of folders


@pytest.mark.parametrize("name", ["seed=1", "ego=x", "lr=0.1", "scene_id=nobody"])
def test_a_folder_named_like_a_partition_changes_no_column(drawn: Path, tmp_path: Path, name: str) -> None:
    run = Workspace(shutil.copytree(drawn, tmp_path / name / "run"))
    plain = Workspace(drawn)
    assert read_scenes(run) == read_scenes(plain)
    assert read_ranges(run) == read_ranges(plain)
    driven = next(row["scene_id"] for row in read_scenes(run) if row["status"] == "ran")
    assert read_episode(run, driven).ego == read_episode(plain, driven).ego


# Digests


def test_a_finished_folder_is_whole_and_so_it_is_after_its_report_is_drawn_again(folder: Path) -> None:
    assert check(folder).whole
    assert not check(folder).added
    folder.joinpath("report.html").write_text("something else")
    assert "report.html" in check(folder).damaged
    write_report(folder)
    assert check(folder).whole


def test_every_flipped_bit_of_every_file_is_found(folder: Path) -> None:
    chance = random.Random(5)
    for path in _files(folder):
        name, size = path.relative_to(folder).as_posix(), 8 * path.stat().st_size
        for bit in {0, size - 1, *(chance.randrange(size) for _ in range(12))}:
            _flip(path, bit)
            assert name in check(folder).damaged, (name, bit)
            _flip(path, bit)
    assert check(folder).whole


def test_every_bit_of_the_record_is_guarded(folder: Path) -> None:
    path = folder / "run.json"
    for bit in range(0, 8 * path.stat().st_size, 41):
        _flip(path, bit)
        assert "run.json" in check(folder).damaged, bit
        _flip(path, bit)


def test_a_bit_that_would_change_values_in_silence_is_noticed_even_where_no_digest_is_kept(folder: Path) -> None:
    run, path = Workspace(folder), folder / "scenes.parquet"
    file = pq.ParquetFile(path)
    before = file.read()
    columns = [file.metadata.row_group(0).column(n) for n in range(before.num_columns)]
    column = next(column for column in columns if column.path_in_schema == "OPT_GEO_Y")
    start = column.dictionary_page_offset or column.data_page_offset
    silent = 0
    for bit in range(8 * start, 8 * (start + column.total_compressed_size), 23):
        _flip(path, bit)
        try:
            unguarded = pq.read_table(path)
        except (OSError, pa.ArrowException):
            unguarded = before
        if unguarded != before:
            silent += 1
            with pytest.raises(RunError, match=r"scenes\.parquet.*damaged"):
                read_scenes(run)
        _flip(path, bit)
    assert silent > 3


def test_missing_and_added_files_are_named(folder: Path) -> None:
    folder.joinpath("events.parquet").unlink()
    folder.joinpath("notes.txt").write_text("my own")
    condition = check(folder)
    assert condition.missing == ("events.parquet",)
    assert condition.added == ("notes.txt",)
    assert not condition.whole


def test_an_added_file_is_no_damage(folder: Path) -> None:
    folder.joinpath("notes.txt").write_text("my own")
    assert check(folder).whole
    assert open_run(folder)


def test_the_command_says_what_is_wrong_to_people_and_to_scripts(folder: Path) -> None:
    well = command("check", str(folder))
    assert (well.exit_code, well.output) == (0, f"{folder}: whole\n")
    _flip(folder / "map.json", 80)
    ill = command("check", str(folder))
    assert ill.exit_code == 1
    assert "damaged  map.json" in ill.output
    answer = command("check", str(folder), "--json")
    (told,) = json.loads(answer.output)
    assert answer.exit_code == 1
    assert (told["whole"], list(told["damaged"]), told["missing"], told["added"]) == (False, ["map.json"], [], [])


def test_the_name_of_an_added_file_tells_the_terminal_nothing(folder: Path) -> None:
    folder.joinpath("\x1b[2Jgone").write_text("")
    answer = command("check", str(folder))
    assert "added    \\x1b[2Jgone" in answer.output
    assert "\x1b" not in answer.output


def test_a_folder_of_before_the_first_release_is_refused_with_what_made_it(folder: Path) -> None:
    resealed(Workspace(folder), schema_version=1, versions={"chatscene": "0.0.9"})
    with pytest.raises(RunError, match=r"before 0\.1\.0 \(schema 1, .* chatscene that made it, 0\.0\.9"):
        open_run(folder)
    assert "before 0.1.0" in command("check", str(folder)).output


def test_a_sentence_longer_than_any_is_damage(folder: Path) -> None:
    resealed(Workspace(folder), text="a car " * 500_000)
    with pytest.raises(RunError, match=r"run\.json is not the record of a run: text: .* at most 20,000 are read"):
        open_run(folder)
    answer = command("resume", str(folder))
    assert answer.exit_code == 1
    assert "at most 20,000 are read" in answer.output


def test_a_folder_without_a_run_cannot_be_checked(tmp_path: Path) -> None:
    with pytest.raises(RunError, match="not a run folder"):
        check(tmp_path)


def test_a_newer_run_is_not_called_damaged(folder: Path) -> None:
    path = folder / "run.json"
    path.write_text(json.dumps(json.loads(path.read_text()) | {"schema_version": 99}))
    assert "newer chatscene" in check(folder).damaged["run.json"]


def _silent(_what: str, _done: int, _total: int) -> None:
    pass


USES: dict[str, Callable[[Path, Path], object]] = {
    "resume": lambda folder, _: pipeline.resume(folder),
    "replay": lambda folder, _: replay(folder, "any"),
    "report": lambda folder, _: write_report(folder),
    "evaluate": lambda folder, out: evaluate([folder], out, egos=["rule-based"], progress=_silent),
    "finetune": lambda folder, _: kept_scenes([folder]),
}


@pytest.mark.parametrize("use", USES)
@pytest.mark.parametrize("name", ["scenes.parquet", "run.json"])
def test_no_command_uses_a_damaged_folder(folder: Path, tmp_path: Path, use: str, name: str) -> None:
    path = folder / name
    if name == "run.json":  # still a record, of another seed
        path.write_text(path.read_text().replace('"seed": 7', '"seed": 8'))
    else:
        _flip(path, 4000)
    with pytest.raises(RunError, match=rf"{name} (is|was changed or) damaged"):
        USES[use](folder, tmp_path / "out")


def test_a_damaged_drawing_keeps_no_run_from_being_used(folder: Path) -> None:
    _flip(folder / "report.html", 400)
    assert open_run(folder)
    assert "chatscene resume" in check(folder).damaged["report.html"]
    pipeline.resume(folder)
    assert check(folder).whole


def test_several_damaged_files_are_counted_and_the_first_is_named(folder: Path) -> None:
    folder.joinpath("events.parquet").unlink()
    folder.joinpath("map.json").unlink()
    with pytest.raises(RunError, match=r"is missing \(the first of 2; chatscene check"):
        open_run(folder)


def test_tables_of_an_evaluation_are_under_the_digests(folder: Path) -> None:
    folder.joinpath("tables").mkdir()
    folder.joinpath("tables", "fault.txt").write_text("0.5")
    note(Workspace(folder), folder / "tables" / "fault.txt")
    assert check(folder).whole
    _flip(folder / "tables" / "fault.txt", 3)
    assert "tables/fault.txt" in check(folder).damaged


# Runs that go on


def _ongoing(path: Path) -> Workspace:
    run = started(path)
    for block in blocks(3):
        write_block(run, block)
    return run


@pytest.mark.parametrize("which", ["part", "episodes"])
def test_a_damaged_block_of_a_running_run_is_run_again_and_not_used(tmp_path: Path, which: str) -> None:
    run = _ongoing(tmp_path / "run")
    path = getattr(run, which)(SCENARIO, 0, 1)
    chance = random.Random(7)
    size = 8 * path.stat().st_size
    for bit in [0, size - 1, *(chance.randrange(size) for _ in range(20))]:
        _flip(path, bit)
        assert [(one.part, one.file) for one in damaged_parts(run)] == [(run.part(SCENARIO, 0, 1), path)], bit
        assert {row["block"] for row in read_scenes(run)} == {0, 2}
        assert not check(run.path).whole
        _flip(path, bit)
    assert check(run.path).whole
    _flip(path, size // 2)
    told: list[str] = []
    assert len(resume(run, told=told.append)[SCENARIO, 0]) == 1
    assert len(told) == 1
    assert "block-01" in told[0]
    assert "run again" in told[0]
    assert not run.part(SCENARIO, 0, 1).exists()


def test_a_part_that_is_no_part_is_run_again(tmp_path: Path) -> None:
    run = _ongoing(tmp_path / "run")
    run.part(SCENARIO, 0, 0).write_text('{"scenario_id": 3}')
    assert resume(run) == {(SCENARIO, 0): []}


def test_a_run_whose_tracks_were_removed_meanwhile_is_not_done(tmp_path: Path) -> None:
    run, done = _ongoing(tmp_path / "run"), blocks(3)
    expected = [(SCENARIO, 0, block.number) for block in done]
    shutil.rmtree(run.file("episodes"))
    with pytest.raises(RunError, match=r"lacks 3 of its 3 blocks.*chatscene resume"):
        finish(run, selected={}, expected=expected)
    assert read_record(run).status is Status.RUNNING
    assert resume(run) == {}
    for block in done:
        write_block(run, block)
    assert finish(run, selected=selection(done), expected=expected).status is Status.DONE
    assert check(run.path).whole


def test_the_record_of_a_running_run_that_was_changed_is_refused(tmp_path: Path) -> None:
    run = _ongoing(tmp_path / "run")
    path = run.file("run.json")
    path.write_text(path.read_text().replace('"seed": 7', '"seed": 8'))
    with pytest.raises(RunError, match=r"run\.json was changed"):
        pipeline.resume(run.path)


# Two at once


def test_a_second_process_is_refused_until_the_first_is_gone_even_if_it_was_killed(tmp_path: Path) -> None:
    run = _ongoing(tmp_path / "run")
    hold = "import sys, time; from pathlib import Path; from chatscene.runs import alone\n"
    hold += "with alone(Path(sys.argv[1])):\n    print('held', flush=True)\n    time.sleep(600)"
    first = subprocess.Popen([sys.executable, "-c", hold, str(run.path)], stdout=subprocess.PIPE, text=True)
    assert first.stdout is not None
    assert first.stdout.readline() == "held\n"
    try:
        with pytest.raises(RunError, match="another chatscene is at work on"):
            pipeline.resume(run.path)
        assert read_record(run).status is Status.RUNNING
        with pytest.raises(RunError, match="another chatscene"):
            pipeline.run(asked(), run.path)
    finally:
        os.kill(first.pid, signal.SIGKILL)
        first.wait()
        first.stdout.close()
    with alone(run.path):
        assert _files(run.path) == _files(run.path)


def test_a_held_folder_holds_no_more_files_than_one_that_is_not(tmp_path: Path) -> None:
    with alone(tmp_path / "run"):
        assert list((tmp_path / "run").iterdir()) == []
        with pytest.raises(RunError, match="another chatscene"), alone(tmp_path / "run"):
            pass
    with alone(tmp_path / "run"):
        pass


HELD: dict[str, Callable[[Path, Path], object]] = {
    "run": lambda _, held: pipeline.run(asked(), held),
    "evaluate": lambda folder, held: evaluate([folder], held, egos=["rule-based"], progress=_silent),
    "benchmark": lambda _, held: benchmark(held, progress=_silent),
    "train": lambda _, held: train(held, TrainSettings(), progress=_silent),
}


@pytest.mark.parametrize("what", HELD)
def test_no_command_works_on_a_folder_that_another_is_at_work_on(folder: Path, tmp_path: Path, what: str) -> None:
    with alone(tmp_path / "held"), pytest.raises(RunError, match="another chatscene is at work"):
        HELD[what](folder, tmp_path / "held")


def test_a_folder_that_cannot_be_locked_is_said_to_be_so(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    import fcntl

    def refuse(*_: object) -> None:
        raise OSError(errno.ENOLCK, os.strerror(errno.ENOLCK))

    monkeypatch.setattr(fcntl, "flock", refuse)
    with pytest.warns(UserWarning, match="cannot be locked"), alone(tmp_path):
        pass


# Values that no run has


@pytest.mark.parametrize(
    ("part", "name", "value"),
    [
        ("simulation", "dt", 0),
        ("simulation", "dt", -0.1),
        ("simulation", "dt", float("nan")),
        ("simulation", "dt", float("inf")),
        ("simulation", "dt", "0.1"),
        ("simulation", "max_steps", 10**9),
        ("simulation", "max_steps", 2.5),
        ("retrieval", "candidates", -3),
        ("retrieval", "refuse_below", float("nan")),
        ("retrieval", "library", ["a"]),
        ("retrieval", "library", "a\0b"),
        ("search", "scenes", 0),
        ("search", "routes", 10**8),
        ("search", "tries", True),
        ("search", "seed", -1),
        ("search", "avoidable_only", "no"),
    ],
)
def test_a_setting_out_of_range_is_named_with_its_range(tmp_path: Path, part: str, name: str, value: object) -> None:
    run = started(tmp_path / "run")
    settings = read_record(run).settings
    settings[part][name] = value
    resealed(run, settings=settings)
    with pytest.raises(SettingsError, match=rf"{name} must be .*, not "):
        settings_of(read_record(run))
    answer = command("resume", str(run.path))
    assert answer.exit_code == 1
    assert f"SettingsError: {name} must be" in answer.output


def test_every_number_of_the_settings_has_a_range() -> None:
    no_number: Any = float("nan")
    for kind in (SearchSettings, SimulationSettings, RetrievalSettings):
        for name, value in ((name, getattr(kind(), name)) for name in kind.__slots__):
            if type(value) in (int, float):
                with pytest.raises(SettingsError, match=rf"{name} must be .* from .* to .*, not "):
                    kind(**{name: no_number})


def test_a_program_that_is_no_text_is_named(folder: Path) -> None:
    path = next(folder.glob("programs/*.scenic"))
    path.write_bytes(b"ego = \xff\xfe")
    with pytest.raises(RunError, match=r"\.scenic is not UTF-8 text"):
        read_programs(Workspace(folder))


def test_a_letter_flipped_in_the_explanation_is_one_message_of_our_own(folder: Path) -> None:
    run, path = Workspace(folder), folder / "explanation.json"
    chance = random.Random(11)
    refused = 0
    for _ in range(150):
        bit = chance.randrange(8 * path.stat().st_size)
        _flip(path, bit)
        try:
            read_explanation(run)
            read_choice(run)
        except ChatSceneError as error:
            refused += 1
            assert "explanation.json" in str(error)
        _flip(path, bit)
    assert refused > 30


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"slots": {"adversry": "car"}}, "there is no slot adversry"),
        ({"slots": {"adversary": "dragon"}}, "slots.adversary"),
        ({"chosen": {"behavior": "behavior/cross"}}, "does not say what was chosen"),
        ({"base": "sideways"}, "base"),
        ({"parts": 3}, "parts"),
        ({"tried": [{"snippet_ids": "x"}]}, "tried"),
    ],
)
def test_an_explanation_is_checked_against_its_types(folder: Path, change: dict[str, object], words: str) -> None:
    path = folder / "explanation.json"
    content = json.loads(path.read_text())
    content["scenarios"][0] |= change
    path.write_text(json.dumps(content))
    with pytest.raises(RunError, match=rf"explanation\.json .*{words}"):
        read_choice(Workspace(folder))


def test_a_path_with_a_nul_is_one_message_of_our_own(tmp_path: Path) -> None:
    bad = tmp_path / "a\0b"
    with pytest.raises(RunError, match="NUL"):
        pipeline.run(asked(), bad)
    with pytest.raises(RunError, match="NUL"):
        create(bad, asked())


def test_a_text_that_is_no_text_is_one_message_of_our_own(tmp_path: Path) -> None:
    with pytest.raises(RunError, match="not a character; write it in UTF-8"):
        started(tmp_path / "run", text="A cyclist\udcff")


def test_what_is_sealed_is_sealed_to_the_byte(tmp_path: Path) -> None:
    from chatscene.runs.digests import is_sealed

    path = tmp_path / "x.json"
    write_sealed(path, {"text": 'a "digest": "" ü', "n": 1})
    written = path.read_bytes()
    digest = json.loads(written)["digest"]
    assert is_sealed(written, digest)
    assert not is_sealed(written.replace(b" ", b"  ", 1), digest)
    assert not is_sealed(written, "")
    assert not is_sealed(written, None)


def test_a_record_that_is_written_anew_meanwhile_is_not_called_damaged(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    run, read = Workspace(folder), Path.read_bytes

    def read_and_let_another_write(path: Path) -> bytes:
        content = read(path)
        if path.name == "run.json":
            monkeypatch.setattr(Path, "read_bytes", read)
            update(run, timings={"total": 1.0})
        return content

    monkeypatch.setattr(Path, "read_bytes", read_and_let_another_write)
    assert open_run(folder) == run


def _columns(path: Path, change: Callable[[Any], Any]) -> None:
    pq.write_table(change(pq.read_table(path)), path)


FORGED: dict[str, tuple[str, Callable[[Any], Any], str]] = {
    "a column is missing": ("scenes.parquet", lambda t: t.drop_columns(["ending"]), "no column 'ending'"),
    "another type": ("events.parquet", lambda t: _with(t, "step", ["zz"] * t.num_rows), "'step' holds string"),
    "a lack of values": ("scenes.parquet", lambda t: _with(t, "dt", [None] * t.num_rows), "'dt' lacks values"),
    "no route": ("scenes.parquet", lambda t: _with(t, "route_id", ["x"] * t.num_rows), "'x' is not a route"),
    "no time": ("scenes.parquet", lambda t: _with(t, "dt", [-0.05] * t.num_rows), "do not hold a drive.*dt is -0.05 s"),
    "no ending": ("scenes.parquet", lambda t: _with(t, "ending", ["x"] * t.num_rows), "do not hold a drive"),
    "no rows": ("episodes", lambda t: t.slice(0, 0), "do not hold a drive"),
}


def _with(table: Any, name: str, values: list[Any]) -> Any:
    column = table.column_names.index(name)
    kind = table.schema.field(column).type if values[0] != "zz" else pa.string()
    return table.set_column(column, name, pa.array(values, kind))


@pytest.mark.parametrize("case", FORGED)
def test_tables_that_hold_something_else_are_one_message(tmp_path: Path, case: str) -> None:
    run = finished(tmp_path / "run")
    name, change, message = FORGED[case]
    for path in sorted(run.path.glob(f"{name}/*.parquet")) or [run.file(name)]:
        _columns(path, change)
    resealed(run)  # somebody who forges a table can forge its digest, too
    with pytest.raises(RunError, match=message):
        write_report(run.path)


@pytest.mark.parametrize("points", [[[0.0, 1e308], [1.0, 2.0]], [[0.0, 0.0]], ["xy"], None])
def test_a_drawing_that_nobody_can_draw_is_one_message(tmp_path: Path, points: object) -> None:
    run = finished(tmp_path / "run")
    run.file("map.json").write_text(json.dumps({"lane_boundaries": [{"kind": "solid", "points": points}]}))
    resealed(run)
    with pytest.raises(RunError, match=r"map\.json is not the drawing of a map"):
        write_report(run.path)


def test_a_scene_that_lacks_a_value_of_its_program_is_one_message(tmp_path: Path) -> None:
    run = finished(tmp_path / "run")
    scene = read_scenes(run)[0]
    program = ScenicProgram(
        scenario_id=SCENARIO,
        source="",
        parameters=(ParameterRange(name="OPT_LOST", low=0.0, high=1.0, unit="m"),),
        snippet_ids=(),
    )
    with pytest.raises(RunError, match=r"has no OPT_LOST in scenes\.parquet"):
        scene_of(scene, program)


def test_a_folder_that_cannot_be_checked_leaves_the_others_to_be_checked(folder: Path, tmp_path: Path) -> None:
    done = CliRunner().invoke(main, ["check", str(tmp_path / "none"), str(folder)])
    assert done.exit_code == 1
    assert "none" in done.output
    assert f"{folder}: whole" in done.output


def test_a_run_of_a_situation_that_was_refused_makes_way_for_another(tmp_path: Path) -> None:
    run = started(tmp_path / "run")
    run.file("situation.yaml").write_text("others: []")
    update(run, status=Status.REFUSED, reason="no drive shows it")
    assert take_up(run.path, asked(text="the car ahead brakes")).path == run.path
    assert [path.name for path in run.path.rglob("*") if path.is_file()] == ["run.json"]
