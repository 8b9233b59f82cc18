"""One thing that happened in a drive, in words."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True, slots=True, kw_only=True)
class Told:
    """One thing that happened.

    Attributes:
        at: When it began [s].
        until: When it was done [s]; None of what has no length.
        who: Who did it; empty of what befell several.
        what: What, in words.
    """

    at: float
    who: str
    what: str
    until: float | None = None

    def as_dict(self) -> dict[str, Any]:
        """For a script."""
        return {"at": self.at, "until": self.until, "who": self.who, "what": self.what}

    def __str__(self) -> str:
        """A line for a person."""
        span = "" if self.until is None or self.until <= self.at else f", until {self.until:.1f} s"
        return f"{self.at:5.1f} s  {self.who}{' ' * bool(self.who)}{self.what}{span}"
