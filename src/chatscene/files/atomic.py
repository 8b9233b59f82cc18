"""Files that are either whole or not there."""

from __future__ import annotations

import os
import threading
from collections.abc import Iterable
from pathlib import Path


def write_whole(path: Path, content: bytes, *, mode: int = 0o666, lasting: bool = True) -> None:
    """Write a whole file or nothing, whatever kills the process or the machine meanwhile.

    The content goes to a temporary neighbour, to the disk, and only then under its name. Folders are made as
    needed.

    Args:
        path: Name of the file.
        content: All of it.
        mode: Permissions before the user's mask.
        lasting: Whether to wait for the disk. Without, whatever kills the process leaves the file whole or not there;
            a power cut may damage it until `make_lasting`, so that readers have to check it.

    Raises:
        OSError: The file system refuses.
    """
    temporary = temporary_of(path)
    try:
        with os.fdopen(os.open(temporary, os.O_WRONLY | os.O_CREAT | os.O_TRUNC, mode), "wb") as stream:
            stream.write(content)
            if lasting:
                stream.flush()
                os.fsync(stream.fileno())
        temporary.replace(path)
    except BaseException:
        temporary.unlink(missing_ok=True)
        raise
    if lasting:
        _sync_folder(path.parent)


def temporary_of(path: Path) -> Path:
    """What a file is called beside its place until it is whole; its folder is made as needed."""
    path.parent.mkdir(parents=True, exist_ok=True)
    return path.with_name(f".{path.name}.{threading.get_native_id()}.tmp")  # two threads may write one file


def make_lasting(paths: Iterable[Path]) -> None:
    """Make files last through a power cut that were written without waiting for the disk.

    Raises:
        OSError: The file system refuses, or there is no such file.
    """
    folders: set[Path] = set()
    for path in paths:
        _sync(path, os.O_RDWR)  # Windows syncs only what may be written to
        folders.add(path.parent)
    for folder in folders:
        _sync_folder(folder)


def _sync_folder(folder: Path) -> None:
    """Make a rename last through a power cut; only POSIX can, and needs it."""
    if os.name == "posix":
        _sync(folder, os.O_RDONLY)


def _sync(path: Path, how: int) -> None:
    handle = os.open(path, how)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)
