"""Work that is spread over workers."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from collections.abc import Callable
from concurrent.futures import BrokenExecutor
from pathlib import Path

import pytest

from chatscene.errors import RunError, SettingsError
from chatscene.maps.carried import CarriedMap
from chatscene.maps.network import PACKAGED
from chatscene.runs.executor import ONE, Workers, load_executor
from chatscene.runs.parallel import LOST, spread
from chatscene.runs.processes import _interrupted_after  # pyright: ignore[reportPrivateUsage]


def _halving(_: None) -> Callable[[int], int]:
    return lambda number: number // 2


@pytest.mark.parametrize("workers", [ONE, Workers(2)])
def test_what_follows_from_a_result_is_done_too(workers: Workers) -> None:
    halves = spread(_halving, None, [9, 4], workers=workers, then=lambda half: [half] if half else [])
    assert sorted(halves) == [0, 0, 1, 1, 2, 2, 4]


def _counted(folder: str) -> Callable[[int], int]:
    def die(number: int) -> int:
        (Path(folder) / f"{os.getpid()}").touch()
        os.kill(os.getpid(), signal.SIGKILL)
        return number

    return die


def test_a_task_that_kills_every_worker_is_given_up_in_the_end(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("chatscene.runs.parallel.LOST", 1)
    with pytest.raises(RunError, match=r"workers ended 2 times in a row, .* chatscene resume DIR"):
        list(spread(_counted, str(tmp_path), [1, 2], workers=Workers(2)))
    assert LOST > 1
    assert len(list(tmp_path.iterdir())) >= 2


def test_a_script_that_lacks_its_guard_ends_with_what_to_do(tmp_path: Path) -> None:
    script = tmp_path / "script.py"
    script.write_text(
        "from chatscene.runs.executor import Workers\n"
        "from chatscene.runs.parallel import spread\n"
        "print(list(spread(bytes.strip, b' ' * 200_000, [1, 2], workers=Workers(2))))\n"  # more than a pipe holds
    )
    ended = subprocess.run([sys.executable, script], capture_output=True, text=True, timeout=120, check=False)
    assert ended.returncode == 1
    assert 'lacks if __name__ == "__main__"' in ended.stderr


def _environment(_: None) -> Callable[[str], str | None]:
    return os.environ.get


def test_workers_have_the_environment_of_when_they_began_and_not_of_the_first_pool(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setenv("FIRST", "1")
    assert set(spread(_environment, None, ["FIRST", "FIRST"], workers=Workers(2))) == {"1"}
    monkeypatch.delenv("FIRST")
    monkeypatch.setenv("SECOND", "2")
    assert set(spread(_environment, None, ["FIRST", "SECOND"], workers=Workers(2))) == {None, "2"}


def test_an_executor_that_is_not_there_is_told_of() -> None:
    with pytest.raises(SettingsError, match="executor"):
        load_executor("process", 1, print)
    with pytest.raises(SettingsError, match="jobs is 0; use at least one"):
        Workers(0)


def test_a_map_that_travelled_is_the_same_file_under_the_same_name(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    mine = tmp_path / "mine.xodr"
    mine.write_bytes(PACKAGED["town"].read_bytes())
    carried = CarriedMap.of(mine)
    assert carried.file() == mine
    mine.write_text("another")
    copy = carried.file()
    assert copy.name == "mine.xodr"
    assert copy != mine
    assert copy.read_bytes() == carried.content
    mine.unlink()
    assert carried.file() == copy


def test_an_interrupt_that_waits_is_heard_by_who_handles_it(request: pytest.FixtureRequest) -> None:
    heard: list[int] = []
    before = signal.signal(signal.SIGINT, lambda number, _: heard.append(number))
    request.addfinalizer(lambda: signal.signal(signal.SIGINT, before))
    with _interrupted_after():
        signal.raise_signal(signal.SIGINT)
        assert not heard
    assert heard == [signal.SIGINT]
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    with _interrupted_after():
        signal.raise_signal(signal.SIGINT)
    assert len(heard) == 1


def test_an_interrupt_is_heard_though_what_it_waits_for_fails(request: pytest.FixtureRequest) -> None:
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    request.addfinalizer(lambda: signal.signal(signal.SIGINT, before))
    with pytest.raises(KeyboardInterrupt), _interrupted_after():
        signal.raise_signal(signal.SIGINT)
        raise BrokenExecutor
