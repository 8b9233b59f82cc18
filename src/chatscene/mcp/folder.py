"""The one folder in which an agent works: no name leads out of it, whether to read or to write."""

from __future__ import annotations

import os
from collections.abc import Iterator
from itertools import islice
from pathlib import Path

from chatscene.errors import SettingsError, no_such
from chatscene.files.atomic import write_whole
from chatscene.files.bounded import is_there

RECORD = "run.json"
LONGEST = 500  # characters of a path
MOST_RUNS = 10  # that a message names
SIMULATORS = ("native", "embedded", "confined")


class Folder:
    """Paths below a folder, by names that somebody else gives.

    Raises:
        SettingsError: There is none.
    """

    def __init__(self, root: Path) -> None:
        if not root.is_dir():
            raise SettingsError(f"there is no folder {root}; make it first")
        self.root = root.resolve()

    def there(self, name: str) -> Path:
        """What is there under a name, as a path that begins at the folder.

        Raises:
            SettingsError: Nothing is, or it lies outside.
        """
        path = self._inside(name)
        if not (self.root / path).exists():
            raise SettingsError(f"there is no {name!r} in the folder; it has {self._nearby()}")
        return path

    def file(self, name: str, *suffixes: str) -> Path:
        """A file that is there.

        Raises:
            SettingsError: None is, or its name ends otherwise.
        """
        path = self.there(name)
        if not is_there(self.root / path):
            raise SettingsError(f"{name!r} is a folder; name a file in it")
        if suffixes and path.suffix.lower() not in suffixes:
            raise SettingsError(f"{name!r} is of another kind; name a file that ends in {', '.join(suffixes)}")
        return path

    def run(self, name: str) -> Path:
        """The folder of a run, which names nothing outside that would be read with it.

        Raises:
            SettingsError: There is none, or it does.
            RunError: Its record cannot be read.
        """
        from chatscene import runs

        path = self.there(name)
        record = self.root / path / RECORD
        if not is_there(record) or record.is_symlink():
            first = [*islice(self.runs(), MOST_RUNS + 1)]
            known = ", ".join(map(repr, first[:MOST_RUNS])) or "none yet; make one with run"
            known += " and more" * (len(first) > MOST_RUNS)
            raise SettingsError(f"{name!r} is not the folder of a run; runs here: {known}")
        made = runs.read_record(runs.Workspace(self.root / path), runs.RunRecord)
        self.map(made.map_name)
        for ego in made.egos:
            self.ego(ego)
        simulator = runs.settings_of(made).simulation.simulator
        if simulator not in SIMULATORS:
            raise SettingsError(f"{name!r} was made in the simulator {simulator!r}; use it on the command line")
        return path

    def free(self, name: str, *suffixes: str) -> Path:
        """A path at which something new is to be made.

        Raises:
            SettingsError: There is something, it lies outside, or its name ends otherwise.
        """
        path = self._inside(name)
        if suffixes and path.suffix.lower() not in suffixes:
            raise SettingsError(f"{name!r} would be of another kind; give a name that ends in {' or '.join(suffixes)}")
        if (self.root / path).exists() or path == Path():
            raise SettingsError(f"{name!r} is there already; give another name")
        return path

    def map(self, name: str | None) -> str | None:
        """A map by its name: a packaged one, a laid road, a town of CARLA's that is installed, or a file of the folder.

        Raises:
            SettingsError: It is none of these.
        """
        from chatscene.maps.carla_towns import carla_town
        from chatscene.maps.network import PACKAGED, is_named

        if name is None or is_named(name) or (carla_town(name) is not None and not (self.root / name).exists()):
            return name
        try:
            return str(self.file(name, ".xodr"))
        except SettingsError as error:
            raise SettingsError(f"{error}, or a packaged map: {', '.join(PACKAGED)}") from error

    def ego(self, name: str | None) -> str | None:
        """A packaged ego by its name: others may run code, and are a matter of the terminal.

        Raises:
            SettingsError: It is none.
        """
        from chatscene.ego.policy import EGOS

        if name is not None and name not in EGOS.built_in:
            raise SettingsError(f"{no_such('ego', name[:60], EGOS.built_in)}; others are for the command line")
        return name

    def make_above(self, path: Path) -> None:
        """Make the folders above a path that `free` gave.

        Raises:
            SettingsError: They cannot be made.
        """
        try:
            (self.root / path).parent.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise SettingsError(f"cannot make {path.parent}: {error.strerror}") from error

    def write(self, path: Path, content: str | bytes) -> None:
        """Write a new file at a path that `free` gave, with the folders above it.

        Raises:
            SettingsError: It cannot be written.
        """
        self.make_above(path)
        try:
            write_whole(self.root / path, content.encode() if isinstance(content, str) else content)
        except OSError as error:
            raise SettingsError(f"cannot write {path}: {error.strerror}") from error

    def runs(self) -> Iterator[str]:
        """The runs in the folder, in order of their paths; ``.`` if it is one itself."""
        return (str(path.parent) for path in self.files() if path.name == RECORD)

    def files(self) -> Iterator[Path]:
        """The files below the folder, in order of their paths; no link is followed, what is closed to us is none."""
        waiting = _entries(self.root)
        while waiting:
            one = waiting.pop()
            if one.is_dir(follow_symlinks=False):
                waiting += _entries(one)
            elif one.is_file(follow_symlinks=False):
                yield Path(one.path).relative_to(self.root)

    def _inside(self, name: str) -> Path:
        """A path below the folder, relative to it, with all links followed."""
        if not name.strip() or len(name) > LONGEST or not name.isprintable() or name.startswith("~"):
            raise SettingsError(f"{name[:60]!r} is not a path;  give one below the folder, such as 'runs/left'")
        try:
            path = Path(os.path.realpath(self.root / name))
        except (OSError, ValueError) as error:
            raise SettingsError(f"{name[:60]!r} is not a path: {error}") from error
        if not path.is_relative_to(self.root):
            raise SettingsError(f"{name!r} lies outside the folder; give a path below it, such as 'runs/left'")
        return path.relative_to(self.root)

    def _nearby(self) -> str:
        names = sorted(one.name + "/" * one.is_dir() for one in self.root.iterdir())
        return ", ".join(names[:20]) + f" and {len(names) - 20} more" * (len(names) > 20) or "nothing yet"


def _entries(folder: Path | os.DirEntry[str]) -> list[os.DirEntry[str]]:
    """What lies in a folder, the last first; nothing, if it is not open to us or gone."""
    try:
        with os.scandir(folder) as found:
            return sorted(found, key=lambda one: one.name, reverse=True)
    except OSError:
        return []
