"""What is kept between runs to save time: where it lies, and how it is written."""

from __future__ import annotations

import hashlib
import os
import sys
from contextlib import suppress
from pathlib import Path
from typing import Literal

from platformdirs import user_cache_path

from chatscene.files.atomic import write_whole

_SEAL = 16  # [bytes]

Kind = Literal["builds", "code", "engines", "maps", "programs", "replies", "vectors", "weights", "words"]


def cache_folder(kind: Kind) -> Path:
    """The folder of one kind of kept files, where this operating system has such; it need not exist."""
    return user_cache_path("chatscene", appauthor=False) / kind


def installed(package: str) -> str:
    """The version of an installed package, by the name of the folder in which its installer left what it says of it.

    Python's own look-up, which is asked where that does not tell it, imports as much as a small command.

    Raises:
        PackageNotFoundError: It is not installed.
    """
    begins, ends = f"{package}-", ".dist-info"
    for place in map(Path, sys.path):
        names = [path.name for path in place.glob(f"{begins}*{ends}")]
        if len(names) == 1:
            return names[0].removeprefix(begins).removesuffix(ends)
    from importlib.metadata import version

    return version(package)


def only_mine(folder: Path) -> Path | None:
    """A folder, made if need be, that nobody but this user can write to; None where there can be none.

    What is executed when it is read, as code is, may come from such a folder alone.
    """
    try:
        folder.mkdir(parents=True, exist_ok=True, mode=0o700)
        state = folder.stat()
    except OSError:
        return None  # a cache saves a second; a run must not fail for want of one
    return folder if state.st_uid == os.getuid() and not state.st_mode & 0o022 else None


def keep(path: Path, content: bytes, *, lasting: bool = True) -> None:
    """Write a whole file of a cache for this user alone, or none: a read-only or full disk must not stop a run.

    Nobody need wait for the disk (`lasting`) where the content is `sealed`: what a power cut damages is made anew.
    """
    with suppress(OSError):
        write_whole(path, content, mode=0o600, lasting=lasting)


def sealed(content: bytes) -> bytes:
    """Content behind its digest, by which one sees that it is not as it was written."""
    return hashlib.blake2b(content, digest_size=_SEAL).digest() + content


def unsealed(whole: bytes) -> bytes | None:
    """What was sealed; None where it is damaged, or never was."""
    content = whole[_SEAL:]
    return content if hashlib.blake2b(content, digest_size=_SEAL).digest() == whole[:_SEAL] else None


def kept(path: Path) -> bytes | None:
    """The content of a sealed file of a cache; None where there is none, or it is damaged."""
    try:
        return unsealed(path.read_bytes())
    except OSError:
        return None


def keep_latest(folder: Path, most: int, ending: str = "") -> None:
    """Keep so many files of a cache with an ending, those that were written last."""
    with suppress(OSError):  # another process may do the same
        files = sorted(folder.glob(f"*{ending}"), key=lambda file: file.stat().st_mtime_ns)
        for old in files[:-most]:
            old.unlink()
