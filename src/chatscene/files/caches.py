"""What is kept between runs to save time: where it lies, and how it is written."""

from __future__ import annotations

from contextlib import suppress
from pathlib import Path
from typing import Literal

from platformdirs import user_cache_path

from chatscene.files.atomic import write_whole


def cache_folder(kind: Literal["maps", "replies", "vectors"]) -> Path:
    """The folder of one kind of kept files, where this operating system has such; it need not exist."""
    return user_cache_path("chatscene", appauthor=False) / kind


def keep(path: Path, content: bytes) -> None:
    """Write a whole file of a cache for this user alone, or none: a read-only or full disk must not stop a run."""
    with suppress(OSError):
        write_whole(path, content, mode=0o600)
