"""Files that are either whole or not there."""

from __future__ import annotations

import os
import threading
from pathlib import Path


def write_whole(path: Path, content: bytes, *, mode: int = 0o666) -> None:
    """Write a whole file or nothing, whatever kills the process or the machine meanwhile.

    The content goes to a temporary neighbour, to the disk, and only then under its name. Folders are made as
    needed.

    Args:
        path: Name of the file.
        content: All of it.
        mode: Permissions before the user's mask.

    Raises:
        OSError: The file system refuses.
    """
    temporary = path.with_name(f".{path.name}.{threading.get_native_id()}.tmp")  # two threads may write one file
    path.parent.mkdir(parents=True, exist_ok=True)
    try:
        with os.fdopen(os.open(temporary, os.O_WRONLY | os.O_CREAT | os.O_TRUNC, mode), "wb") as stream:
            stream.write(content)
            stream.flush()
            os.fsync(stream.fileno())
        temporary.replace(path)
    finally:
        temporary.unlink(missing_ok=True)
    _sync_folder(path.parent)


def _sync_folder(folder: Path) -> None:
    """Make a rename last through a power cut; only POSIX can, and needs it."""
    if os.name == "posix":
        handle = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(handle)
        finally:
            os.close(handle)
