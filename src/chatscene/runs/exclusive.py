"""One process at a time works on a folder."""

from __future__ import annotations

import os
import warnings
from collections.abc import Generator
from contextlib import contextmanager
from pathlib import Path

from chatscene.errors import RunError
from chatscene.runs.atomic import writing


@contextmanager
def alone(folder: Path) -> Generator[None]:
    """Hold a folder while working on it; it is made if it is not there.

    It is the folder itself that is locked, so nothing is left in it, and the lock ends with the process however that
    ends. Processes that it starts do not inherit it. Only POSIX can.

    Raises:
        RunError: Another process works on it, or it cannot be made.
    """
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


def _lock(handle: int, folder: Path) -> None:
    from fcntl import LOCK_EX, LOCK_NB, flock

    try:
        flock(handle, LOCK_EX | LOCK_NB)
    except BlockingIOError:
        raise RunError(
            f"another chatscene is at work on {folder}; wait until it is done, or choose another folder with --out"
        ) from None
    except OSError as error:
        warnings.warn(f"{folder} cannot be locked ({error.strerror}); do not work on it twice at once", stacklevel=4)
