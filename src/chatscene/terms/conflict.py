"""What is found in a report: the conflicts that it tells, and what is in none of them."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True, kw_only=True)
class Conflict:
    """A conflict that a report tells, to be read as a text of its own.

    Attributes:
        text: The passages that tell it.
        report: The name of the report.
        number: Its place in the report, from 1.
        of: How many the report tells.
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
