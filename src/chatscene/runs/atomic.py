"""Files that are either whole or not there, and operating-system errors in words."""

from __future__ import annotations

import errno
import re
from collections.abc import Generator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, cast

from chatscene.errors import RunError
from chatscene.files.atomic import write_whole
from chatscene.files.bounded import check_file, parse_json
from chatscene.files.indented import indented

_LEFTOVER = re.compile(r"\..+\.\d+\.tmp")  # how `write_whole` calls its temporary files

_REMEDIES = {
    errno.ENOSPC: "the disk is full; free some space and continue with: chatscene resume DIR",
    errno.EDQUOT: "the disk quota is used up; free some space and continue with: chatscene resume DIR",
    errno.EACCES: "permission denied; choose a folder you may write to with --out",
    errno.EPERM: "permission denied; choose a folder you may write to with --out",
    errno.EROFS: "the file system is read-only; choose another folder with --out",
    errno.ENOTDIR: "a part of the path is a file, not a folder; choose another with --out",
    errno.EEXIST: "a file of that name is in the way; choose another folder with --out",
    errno.ENAMETOOLONG: "the path is too long for this file system; choose a shorter one with --out",
}


@contextmanager
def writing(path: Path) -> Generator[None]:
    """Turn an `OSError` raised inside into a `RunError` that names `path` and says what to do."""
    if "\0" in str(path):
        raise RunError(f"cannot write {str(path)!r}: no path may hold a NUL character; choose another with --out")
    try:
        yield
    except OSError as error:
        remedy = _REMEDIES.get(error.errno or 0, f"{error.strerror or error}; choose another folder with --out")
        raise RunError(f"cannot write {path}: {remedy}") from error


def write_bytes(path: Path, content: bytes, *, lasting: bool = True) -> None:
    """Write a whole file of a run or nothing, with `write_whole`.

    Raises:
        RunError: The file system refuses.
    """
    with writing(path):
        write_whole(path, content, lasting=lasting)


def write_json(path: Path, content: object) -> None:
    """Write JSON with `write_bytes`: readable, keys in the order given."""
    write_bytes(path, (indented(content) + "\n").encode())


def read_json(path: Path) -> dict[str, Any]:
    """Read a JSON file of a run.

    Raises:
        RunError: It cannot be read, or is no JSON object.
    """
    return json_of(path, read_bytes(path))


def read_bytes(path: Path) -> bytes:
    """Read a file of a run.

    Raises:
        RunError: It cannot be read.
    """
    try:
        check_file(path)
        return path.read_bytes()
    except OSError as error:
        raise RunError(f"cannot read {path}: {error.strerror or error}") from error
    except ValueError as error:
        raise RunError(f"cannot read {path}: {error}") from error


def json_of(path: Path, content: bytes) -> dict[str, Any]:
    """What a JSON file of a run says.

    Raises:
        RunError: It is no JSON object.
    """
    try:
        told = parse_json(content.decode())
    except ValueError as error:
        raise RunError(f"{path} is not valid JSON ({error}); it was changed or damaged after it was written") from error
    if not isinstance(told, dict):
        raise RunError(f"{path} holds no JSON object; it was changed or damaged after it was written")
    return cast(dict[str, Any], told)


def sweep(folder: Path) -> None:
    """Remove what killed writers left half-written below `folder`."""
    with writing(folder):
        for leftover in sorted(filter(is_leftover, folder.rglob(".*.tmp"))):
            leftover.unlink(missing_ok=True)


def is_leftover(path: Path) -> bool:
    """Whether a file is what a killed writer left half-written."""
    return _LEFTOVER.fullmatch(path.name) is not None and path.is_file()
