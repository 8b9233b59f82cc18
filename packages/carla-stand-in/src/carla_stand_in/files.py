"""Files that clients name: below one folder, whatever the name says.

A name is followed folder by folder, and no link is followed: so it leads nowhere else, also while others change what
lies there.
"""

from __future__ import annotations

import os
import stat
import tempfile
from collections.abc import Generator
from contextlib import contextmanager
from pathlib import Path, PurePath
from typing import BinaryIO

from carla_stand_in.wire import Refused

_LONGEST = 100  # characters of a name that are told


class Files:
    """A folder below which files of clients are.

    Args:
        folder: Which; without one, a private one is made for the first file that is written.
    """

    def __init__(self, folder: Path | None = None) -> None:
        self._folder = folder and folder.absolute()

    def path(self, name: str) -> Path:
        """Where the file of a name is: a name below the folder, or an absolute one that begins with the folder's.

        Raises:
            Refused: It is elsewhere.
        """
        if self._folder is None:
            self._folder = Path(tempfile.mkdtemp(prefix="chatscene-carla-"))
        return self._folder / self._below(self._folder, name)

    def _below(self, folder: Path, name: str) -> PurePath:
        path = PurePath(name)
        if path.is_absolute():
            start = next((one for one in (folder, folder.resolve()) if path.is_relative_to(one)), None)
            path = path.relative_to(start) if start else path
        if path.is_absolute() or ".." in path.parts or not path.parts or "\0" in name:
            raise Refused(
                f"files of clients are below {folder}, and {name[:_LONGEST]!r} is not; chatscene serve-carla --files "
                "names another folder"
            )
        return path

    def write(self, name: str, begins: bytes) -> BinaryIO:
        """Begin a file, in place of an older one of its kind.

        Args:
            name: Of the file.
            begins: What files of its kind begin with.

        Raises:
            Refused: It cannot be written, or something else is in its place.
        """
        path = self.path(name)
        with self._in_its_folder(path) as folder:
            try:
                number = os.open(path.name, os.O_RDWR | os.O_CREAT | os.O_EXCL | os.O_CLOEXEC, 0o666, dir_fd=folder)
            except FileExistsError:
                number = _opened(path.name, os.O_RDWR, folder)
                if not _holds(number, begins):
                    os.close(number)
                    raise Refused(f"{path} exists and is not a recording; another name is needed") from None
                os.ftruncate(number, 0)
            return os.fdopen(number, "wb")

    def read(self, name: str, begins: bytes, most: int) -> bytes:
        """What is in a file.

        Args:
            name: Of the file.
            begins: What files of its kind begin with.
            most: Bytes.

        Raises:
            Refused: It cannot be read, is of another kind, or has more.
        """
        path = self.path(name)
        with self._in_its_folder(path) as folder, os.fdopen(_opened(path.name, os.O_RDONLY, folder), "rb") as file:
            if not _holds(file.fileno(), begins):
                raise Refused(f"{path} is not a recording of this stand-in")
            content = file.read(most + 1)
        if len(content) > most:
            raise Refused(f"{path} has more than {most // 2**20} MiB; it is text that can be read as it is")
        return content

    @contextmanager
    def _in_its_folder(self, path: Path) -> Generator[int]:
        """A handle of the folder that a file is in, to which no link leads; faults of the system are refusals."""
        assert self._folder is not None
        handle = -1
        try:
            handle = os.open(self._folder, os.O_RDONLY | os.O_DIRECTORY)
            for part in path.relative_to(self._folder).parts[:-1]:
                inner = os.open(part, os.O_RDONLY | os.O_DIRECTORY | os.O_NOFOLLOW, dir_fd=handle)
                os.close(handle)
                handle = inner
            yield handle
        except (OSError, ValueError) as error:
            why = error.strerror if isinstance(error, OSError) else error
            raise Refused(f"it cannot be opened ({why}; no links are followed): {path}") from error
        finally:
            if handle >= 0:
                os.close(handle)


def _opened(name: str, how: int, folder: int) -> int:
    # what is no file, such as a pipe without a writer, is opened at once and then refused
    return os.open(name, how | os.O_NOFOLLOW | os.O_NONBLOCK | os.O_CLOEXEC, dir_fd=folder)


def _holds(number: int, begins: bytes) -> bool:
    """Whether this is a file that begins so."""
    return stat.S_ISREG(os.fstat(number).st_mode) and os.pread(number, len(begins), 0) == begins
