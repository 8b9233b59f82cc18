"""What a finished folder holds, file by file: a digest of each, so that a changed bit is noticed and has a name.

Two kinds of files: *kept* ones hold what was measured, and a folder of which one is damaged is not used; *drawn* ones,
the report, the animation and the tables, are made of them and can be made again.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any

from chatscene.errors import RunError
from chatscene.files.indented import indented
from chatscene.runs.atomic import write_bytes

_TABLES = tuple(f"{name}.parquet" for name in ("scenes", "events", "signals", "ranges"))
KEPT = ("explanation.json", "map.json", "situation.yaml", *_TABLES, "episodes/*.parquet", "programs/*.scenic")
DRAWN = ("report.html", "*.gif", "tables/*", "figures/*")

CHANGED, MISSING = "it is not what was written", "it is missing"

_BLANK = '"digest": "{}"'


def digest_of(path: Path) -> str:
    """SHA-256 of a file, hexadecimal.

    Raises:
        RunError: It cannot be read.
    """
    try:
        with path.open("rb") as file:
            return hashlib.file_digest(file, "sha256").hexdigest()
    except OSError as error:
        raise RunError(f"cannot read {path}: {error.strerror or error}") from error


def digests(folder: Path, patterns: Iterable[str]) -> dict[str, str]:
    """The digest of every file of some patterns, by its path in the folder, sorted."""
    paths = sorted(path for pattern in patterns for path in folder.glob(pattern) if path.is_file())
    return {path.relative_to(folder).as_posix(): digest_of(path) for path in paths}


def damage(folder: Path, told: Mapping[str, str]) -> Iterator[tuple[str, str]]:
    """Each file that is not as it was told, and what is wrong with it: ``missing`` or ``damaged``."""
    for name, digest in told.items():
        path = folder / name
        if not path.is_file():
            yield name, "missing"
        elif digest_of(path) != digest:
            yield name, "damaged"


def is_drawn(name: str) -> bool:
    """Whether a file of a folder, by its path in it, is made of the others."""
    return any(Path(name).match(pattern) for pattern in DRAWN)


def write_sealed(path: Path, content: Mapping[str, Any], *, for_a_person: bool = True, lasting: bool = True) -> None:
    """Write a JSON object that ends with a digest of itself.

    Args:
        path: Where.
        content: The object.
        for_a_person: Whether somebody may read it, a member a line, which takes ten times as long to write.
        lasting: Whether to wait for the disk (`chatscene.files.atomic.write_whole`).

    Raises:
        RunError: It holds what is no text, or the file system refuses.
    """
    whole = {**content, "digest": ""}
    blank = (indented(whole) if for_a_person else json.dumps(whole, ensure_ascii=False)) + "\n"
    try:
        digest = hashlib.sha256(blank.encode()).hexdigest()
    except UnicodeEncodeError as error:
        wrong = error.object[max(0, error.start - 20) : error.end]
        raise RunError(f"cannot write {path}: {wrong!r} ends in what is not a character; write it in UTF-8") from error
    before, _, after = blank.rpartition(_BLANK.format(""))
    write_bytes(path, f"{before}{_BLANK.format(digest)}{after}".encode(), lasting=lasting)


def is_sealed(content: bytes, digest: object) -> bool:
    """Whether a JSON file is, to the byte, as `write_sealed` wrote it."""
    told, blank = _BLANK.format(digest).encode(), _BLANK.format("").encode()
    return hashlib.sha256(content.replace(told, blank)).hexdigest() == digest
