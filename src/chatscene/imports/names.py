"""What a program calls what a file names."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Mapping
from itertools import count

ODD = re.compile(r"[^A-Za-z0-9 ,.:!?_-]")
_LABEL = 40  # characters
_LONGEST = 100  # characters of a name


def plain(text: str) -> str:
    """A name of a file as a text that may stand in a program."""
    return ODD.sub("_", text)[:_LONGEST]


class Names:
    """What a program calls what a file names: texts that may stand in it, no two names of the file by the same.

    Args:
        used: What some names of the file are called.
    """

    def __init__(self, used: Mapping[str, str]) -> None:
        self._used = dict(used)
        self._taken = set(used.values())

    def of(self, name: str) -> str:
        """What something is called that has a name in the file; with a number where that is taken."""
        if name not in self._used:
            self._used[name] = numbered(plain(name), self._taken, "_")
            self._taken.add(self._used[name])
        return self._used[name]


def numbered(text: str, taken: Collection[str], before: str) -> str:
    """A text that is not taken: itself, else with the first number behind that makes it one."""
    return next(one for n in count(1) if (one := text if n == 1 and text else f"{text}{before}{n}") not in taken)


def labels(names: Iterable[str]) -> list[str]:
    """What tells each of several apart from the others in a scene: letters and digits, no two alike."""
    found: list[str] = []
    for name in names:
        text = "".join(c if c.isascii() and c.isalnum() else "-" for c in name)[:_LABEL]
        found.append(numbered(text, found, "-"))
    return found
