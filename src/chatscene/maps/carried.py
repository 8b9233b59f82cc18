"""A map that travels as text, to where its file may not lie."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass
from pathlib import Path

from chatscene.errors import MapError
from chatscene.files.caches import cache_folder, keep


@dataclass(frozen=True, slots=True)
class CarriedMap:
    """A map, with its text."""

    path: Path
    content: bytes

    @classmethod
    def of(cls, path: Path) -> CarriedMap:
        """The map of a file.

        Raises:
            MapError: It cannot be read.
        """
        try:
            return cls(path, path.read_bytes())
        except OSError as error:
            raise MapError(f"map {path.name!r} cannot be read: {error.strerror} ({path})") from error

    def file(self) -> Path:
        """A file of this map on this machine: its own where that lies here, else a copy among what is kept here.

        Raises:
            MapError: No copy can be kept.
        """
        if _holds(self.path, self.content):
            return self.path
        digest = hashlib.blake2b(self.content, digest_size=12).hexdigest()
        copy = cache_folder("maps") / digest / self.path.name  # routes are named by the name of the file
        if not _holds(copy, self.content):
            keep(copy, self.content)
        if not _holds(copy, self.content):
            raise MapError(f"map {self.path.name!r} is not on this machine, and no copy can be kept in {copy.parent}")
        return copy


def _holds(path: Path, content: bytes) -> bool:
    try:
        return path.read_bytes() == content
    except OSError:
        return False
