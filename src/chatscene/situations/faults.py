"""What is wrong with a written situation, and how a message tells it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Any, cast

Path = tuple[str | int, ...]
MOST_TOLD = 10  # faults of one situation that a message lists


@dataclass(frozen=True, slots=True)
class Fault:
    """What is wrong with a written situation."""

    path: Path
    said: str


class Malformed(Exception):  # noqa: N818 - it never leaves this room
    """A written situation has faults."""

    def __init__(self, faults: Iterable[Fault]) -> None:
        self.faults = tuple(faults)
        super().__init__("; ".join(f"{dotted(one.path)}: {one.said}" for one in self.faults))


def by_name(written: object, faults: Iterable[Fault]) -> Iterator[tuple[str, str]]:
    """Each fault with its path in dots, in which others go by their ids."""
    for one in faults:
        yield dotted(_named(written, one.path)), one.said


def dotted(path: Path) -> str:
    """A path as users write it."""
    return ".".join(map(str, path))


def listed(what: str, faults: Iterable[str]) -> str:
    """One message about all faults of something."""
    several = list(faults)
    shown = several[:MOST_TOLD]
    more = [f"and {len(several) - MOST_TOLD} more"] if len(several) > MOST_TOLD else []
    if len(several) == 1:
        return f"{what}: {several[0]}"
    return "\n".join((f"{what} has {len(several)} faults:", *(f"  {one}" for one in (*shown, *more))))


def _named(written: object, path: Path) -> Path:
    if len(path) < 2 or path[0] != "others" or not isinstance(path[1], int):
        return path
    try:
        name = cast("Any", written)["others"][path[1]]["id"]
    except (KeyError, TypeError, IndexError):
        return path
    return ("others", name, *path[2:]) if isinstance(name, str) and name else path
