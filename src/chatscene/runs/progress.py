"""Telling somebody how far a command is."""

from __future__ import annotations

from collections.abc import Callable

Progress = Callable[[str, int, int], None]
"""What is done, how much of it, and of how much; 0 of 0 where that is not known."""


def silent(_what: str, _done: int, _total: int) -> None:
    """Tell nobody what is done."""
