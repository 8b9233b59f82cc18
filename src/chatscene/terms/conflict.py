"""What is found in a report: the conflicts that it tells, and what is in none of them."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True, kw_only=True)
class Conflict:
    """A conflict that a report tells, to be read as a text of its own.

    Attributes:
        number: Its place in the report, from 1.
        left_out: The passages of the report that are in no conflict, in order.
    """

    text: str
    report: str = ""
    number: int = 1
    of: int = 1
    left_out: tuple[str, ...] = ()

    def __str__(self) -> str:
        """The passages that tell it."""
        return self.text
