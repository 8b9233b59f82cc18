"""Where a process may take too little memory, that is what is said, whatever lacks it first."""

from __future__ import annotations

import errno
import sys
from collections.abc import Callable
from pathlib import Path

import pytest
from click.testing import CliRunner

from chatscene import runs
from chatscene.commands.main import main
from chatscene.errors import RunError, SettingsError
from chatscene.runs.progress import silent
from chatscene.runs.working import working
from fake_run import finished

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="the limit is one of Unix")


@pytest.fixture
def limited(monkeypatch: pytest.MonkeyPatch) -> Callable[[int], None]:
    import resource

    def limit(megabytes: int) -> None:
        def of(_: int) -> tuple[int, int]:
            return megabytes * 2**20, resource.RLIM_INFINITY

        monkeypatch.setattr(resource, "getrlimit", of)

    return limit


def explained(error: Exception, monkeypatch: pytest.MonkeyPatch) -> str:
    def explain(*_: object, **__: object) -> None:
        raise error

    monkeypatch.setattr("chatscene.explain", explain)
    done = CliRunner().invoke(main, ["explain", "a car ahead brakes hard"])
    if done.exception is not None and not isinstance(done.exception, SystemExit):
        raise done.exception
    assert done.exit_code == 1
    return done.output


@pytest.mark.parametrize(
    "error",
    [
        ImportError("libopenblas.so: failed to map segment from shared object"),
        RuntimeError("can't start new thread"),
        OSError(errno.ENOMEM, "Cannot allocate memory"),
        MemoryError(),
    ],
)
def test_whatever_lacks_memory_first_ends_in_one_sentence_with_the_limit_and_the_reason(
    error: Exception, limited: Callable[[int], None], monkeypatch: pytest.MonkeyPatch
) -> None:
    limited(800)
    (line,) = explained(error, monkeypatch).splitlines()
    assert line.startswith("SettingsError: there is too little memory: a process may take 800 MiB here (ulimit -v)")
    assert f"({type(error).__name__}" in line


def test_an_error_that_comes_of_too_little_memory_is_told_as_that(
    limited: Callable[[int], None], monkeypatch: pytest.MonkeyPatch
) -> None:
    limited(1600)
    error = RunError("cannot read scenes.parquet; it is damaged")
    error.__cause__ = MemoryError("malloc of size 64 failed")
    said = explained(error, monkeypatch)
    assert "damaged" not in said
    assert "(MemoryError: malloc of size 64 failed)" in said


def test_an_error_that_nobody_foresaw_is_no_lack_of_memory_where_there_is_enough(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    with pytest.raises(RuntimeError, match="a fault of ours"):
        explained(RuntimeError("a fault of ours"), monkeypatch)


def test_an_error_of_ours_is_told_as_it_is_under_a_limit(
    limited: Callable[[int], None], monkeypatch: pytest.MonkeyPatch
) -> None:
    limited(800)
    assert explained(RunError("it is damaged"), monkeypatch) == "RunError: it is damaged\n"


def test_no_work_on_a_run_begins_where_libraries_would_abort(limited: Callable[[int], None], tmp_path: Path) -> None:
    limited(1000)
    with (
        pytest.raises(SettingsError, match=r"may take 1000 MiB here .*at least 1536 are needed to work on a run"),
        runs.alone(tmp_path / "run"),
    ):
        pass
    assert not (tmp_path / "run").exists()


def test_a_run_that_ends_for_want_of_memory_says_so(tmp_path: Path) -> None:
    run = finished(tmp_path / "run", count=1)
    with pytest.raises(MemoryError), working(run, silent):
        raise MemoryError("no more")
    record = runs.read_record(run)
    assert (record.status, record.reason) == (runs.Status.FAILED, "MemoryError: no more")
