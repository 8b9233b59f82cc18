"""Files that somebody else may have made, read within bounds: of what they unpack to, and of brackets in brackets."""

from __future__ import annotations

import json
import stat
import zipfile
from collections.abc import Callable
from pathlib import Path
from typing import IO, Any

MOST_BYTES = 256 * 2**20  # of a file, and of all that an archive unpacks to; our own egos have 1 MB


def parse_json(text: str | bytes, *, parse_constant: Callable[[str], Any] | None = None) -> Any:
    """JSON; brackets too deep for the parser are a fault of the text like any other.

    Args:
        text: What to parse.
        parse_constant: What to make of NaN and the infinities; None for floats.

    Raises:
        ValueError: It is none.
    """
    try:
        return json.loads(text, parse_constant=parse_constant)
    except RecursionError:
        raise ValueError("its brackets are nested too deeply") from None


def is_there(path: Path) -> bool:
    """Whether a path, whoever named it, is a file; what no path can be is none."""
    try:
        return path.is_file()
    except (OSError, ValueError):  # too long for a name, or with a NUL
        return False


def check_file(path: Path) -> None:
    """Refuse a file that is too large to be read, or never ends.

    Raises:
        ValueError: It is.
        OSError: It cannot be looked at.
    """
    if not stat.S_ISREG(path.stat().st_mode):
        raise ValueError("it is no file but a pipe or a device")
    if (size := path.stat().st_size) > MOST_BYTES:
        raise ValueError(f"it has {size / 2**20:.0f} MB, and at most {MOST_BYTES // 2**20} MB are read")


def check_archive(source: Path | IO[bytes]) -> tuple[str, ...]:
    """The names in a zip archive, which must not unpack to more than is read.

    The sizes that its directory names are believed: nothing reads on beyond them.

    Raises:
        ValueError: It would unpack to too much.
        zipfile.BadZipFile: It is no archive.
        OSError: It cannot be read.
    """
    if isinstance(source, Path):
        check_file(source)
    with zipfile.ZipFile(source) as archive:
        infos = archive.infolist()
    if (size := sum(info.file_size for info in infos)) > MOST_BYTES:
        raise ValueError(f"it would unpack to {size / 2**20:.0f} MB, and at most {MOST_BYTES // 2**20} MB are read")
    return tuple(info.filename for info in infos)
