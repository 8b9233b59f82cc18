"""A folder that one process at a time writes to, and in which it shows that it has not come to its end."""

from __future__ import annotations

from collections.abc import Generator
from contextlib import contextmanager, suppress
from pathlib import Path

from chatscene.errors import SettingsError

UNFINISHED = "unfinished"
"""The file that lies in the folder meanwhile, and stays there if the work is interrupted."""


@contextmanager
def alone_in(folder: Path) -> Generator[None]:
    """Keep others out of a folder until what is done in it is over.

    Raises:
        SettingsError: Another one is there, or the folder cannot be made.
    """
    mark, made = folder / UNFINISHED, not folder.exists()
    try:
        folder.mkdir(parents=True, exist_ok=True)
        mark.touch(exist_ok=False)
    except FileExistsError:
        raise SettingsError(
            f"something else writes to {folder}, or was interrupted there; wait for it, or name another folder"
        ) from None
    except OSError as error:
        raise SettingsError(f"cannot write to {folder}: {error.strerror}") from error
    try:
        yield
    except Exception:
        mark.unlink(missing_ok=True)
        if made:
            with suppress(OSError):  # what was written before it failed
                folder.rmdir()
        raise
    mark.unlink(missing_ok=True)
