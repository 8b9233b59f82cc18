"""Telling somebody how far a command is."""

from __future__ import annotations

import time
from collections.abc import Callable

SLOW = 1.0  # [s]

Progress = Callable[[str, int, int], None]
"""What is done, how much of it, and of how much; 0 of 0 where that is not known."""


def silent(_what: str, _done: int, _total: int) -> None:
    """Tell nobody what is done."""


class Slowly:
    """Counts what is done one by one, and tells of it no more often than once a second."""

    def __init__(self, tell: Callable[[int], None]) -> None:
        self._tell = tell
        self.begin()

    def begin(self) -> None:
        """Count from nothing again."""
        self._done, self._told = 0, time.monotonic()

    def __call__(self) -> None:
        """One more is done."""
        self._done += 1
        if time.monotonic() - self._told >= SLOW:
            self._told = time.monotonic()
            self._tell(self._done)
