"""What a program calls what a file names."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping

ODD = re.compile(r"[^A-Za-z0-9 ,.:!?_-]")
_LABEL = 40  # characters
_LONGEST = 100  # characters of a name


def plain(text: str) -> str:
    """A name of a file as a text that may stand in a program."""
    return ODD.sub("_", text)[:_LONGEST]


class Names:
    """What a program calls what a file names: texts that may stand in it, no two names of the file by the same."""

    def __init__(self, used: Mapping[str, str]) -> None:
        self._used = dict(used)
        self._apart = Apart("_", used.values())

    def of(self, name: str) -> str:
        """What something is called that has a name in the file; with a number where that is taken."""
        if name not in self._used:
            self._used[name] = self._apart.of(plain(name))
        return self._used[name]


class Apart:
    """Tells texts apart: one that is taken gets the first number behind that makes it another."""

    def __init__(self, before: str, taken: Iterable[str] = ()) -> None:
        self._before, self._taken, self._next = before, set(taken), dict[str, int]()

    def of(self, text: str) -> str:
        """A text that was not taken, and is now."""
        number = self._next.get(text, 1)
        while (one := text if number == 1 and text else f"{text}{self._before}{number}") in self._taken:
            number += 1
        self._next[text] = number + 1
        self._taken.add(one)
        return one


def labels(names: Iterable[str]) -> list[str]:
    """What tells each of several apart from the others in a scene: letters and digits, no two alike."""
    apart = Apart("-")
    return [apart.of("".join(c if c.isascii() and c.isalnum() else "-" for c in name)[:_LABEL]) for name in names]
