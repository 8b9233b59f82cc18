"""One process at a time works on a folder."""

from __future__ import annotations

import os
import time
import warnings
from collections.abc import Generator
from contextlib import contextmanager
from pathlib import Path

from chatscene.errors import RunError
from chatscene.memory import FOR_WORK, require_memory
from chatscene.runs.atomic import writing

_LOOK = 0.1  # [s]


@contextmanager
def alone(folder: Path) -> Generator[None]:
    """Hold a folder while working on it; it is made if it is not there.

    It is the folder itself that is locked, so nothing is left in it, and the lock ends with the process however that
    ends. Processes that it starts do not inherit it. Only POSIX can.

    Raises:
        RunError: Another process works on it, or it cannot be made.
        SettingsError: A process may take too little memory here to work on one.
    """
    require_memory(FOR_WORK)
    with writing(folder):
        folder.mkdir(parents=True, exist_ok=True)
    if os.name != "posix":
        yield
        return
    handle = os.open(folder, os.O_RDONLY)
    try:
        _lock(handle, folder)
        yield
    finally:
        os.close(handle)


def at_work(folder: Path) -> bool | None:
    """Whether a process works on a folder, as far as this machine can tell; None if it cannot.

    A process that was killed holds no lock any more, whatever `run.json` says. One on another machine may not be
    seen here.
    """
    if os.name != "posix":
        return None
    from fcntl import LOCK_NB, LOCK_SH, flock

    try:
        handle = os.open(folder, os.O_RDONLY)
    except OSError:
        return None
    try:
        flock(handle, LOCK_SH | LOCK_NB)
    except BlockingIOError:
        return True
    except OSError:
        return None
    else:
        return False
    finally:
        os.close(handle)


def _lock(handle: int, folder: Path) -> None:
    from fcntl import LOCK_EX, LOCK_NB, flock

    try:
        try:
            flock(handle, LOCK_EX | LOCK_NB)
        except BlockingIOError:
            time.sleep(_LOOK)  # who lists runs holds the lock for a moment, see `at_work`
            flock(handle, LOCK_EX | LOCK_NB)
    except BlockingIOError:
        raise RunError(
            f"another chatscene is at work on {folder}; wait until it is done, or choose another folder with --out"
        ) from None
    except OSError as error:
        warnings.warn(f"{folder} cannot be locked ({error.strerror}); do not work on it twice at once", stacklevel=4)
