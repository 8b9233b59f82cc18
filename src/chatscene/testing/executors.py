"""What every executor owes; see `chatscene.runs.executor.Executor`."""

from __future__ import annotations

import os
import signal
import tempfile
from pathlib import Path

from chatscene.errors import SettingsError
from chatscene.runs.executor import Workers, load_executor
from chatscene.runs.parallel import spread
from chatscene.testing.contract import require

TASKS = 4


def check_executor(name: str) -> None:
    """Hold an executor to the contract of all.

    Args:
        name: Its name, or ``package.module:factory``.

    Raises:
        ContractBroken: It breaks a rule; the message says which.
        SettingsError: There is none of that name, or it cannot be reached.
        MissingExtra: Its package is missing.
    """
    pool = load_executor(name, 2, _begin, 40)
    try:
        futures = [pool.submit(_add, number) for number in range(TASKS)]
        found = [future.result() for future in futures]
        require(found == [40, 41, 42, 43], "workers begin with the initializer and do what is submitted", found)
        error = pool.submit(_refuse, "no such thing").exception()
        alike = isinstance(error, SettingsError) and str(error) == "no such thing"
        require(alike, "what a task raises is raised by its future, as it was", repr(error))
        found = pool.submit(_add, 2).result()
        require(found == 42, "a worker goes on after a task that raised", found)
    finally:
        pool.shutdown(cancel_futures=True)
    with tempfile.TemporaryDirectory() as folder:
        done = sorted(spread(_Mortal, folder, range(TASKS), workers=Workers(2, name)))
        require(done == [0, 1, 4, 9], "what a lost worker had to do is done by another", done)
        require((Path(folder) / "killed").exists(), "the worker that was to be killed was")


_begun: list[int] = []


def _begin(number: int) -> None:
    _begun[:] = [number]


def _add(number: int) -> int:
    return _begun[0] + number


def _refuse(why: str) -> None:
    raise SettingsError(why)


class _Mortal:
    """Squares numbers, and is killed over the first 2 that it is given."""

    def __init__(self, folder: str) -> None:
        self._killed = Path(folder) / "killed"

    def __call__(self, number: int) -> int:
        if number == 2 and not self._killed.exists():
            self._killed.touch()
            os.kill(os.getpid(), signal.SIGKILL)
        return number * number
