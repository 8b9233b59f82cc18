"""What a judge tells: a fact of a situation, whether a drive shows it, and in words what is seen of it."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

UNTOLD = "not judged from tracks"
"""What is told of a fact that no track shows, so that nobody takes it for seen."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Late:
    """How much too late somebody is.

    Attributes:
        seconds: That [s]; less than 0 of who is too early.
        metres: How far [m] it drives in that.
    """

    seconds: float
    metres: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Finding:
    """What a drive shows of a fact.

    Attributes:
        path: The fact; ``encounter.A`` is that the ego could meet A, ``unasked.…`` what nobody said.
        shown: Whether it is seen; None where the drive did not come to it, or no track tells.
        told: What was said, and what is seen, in words.
        at: When it is seen [s]; None for what has no moment.
        cut: Whether a contact cut it short, although it was to be seen to its end.
        late: How much too late somebody is to meet the ego; None of whatever else is told.
        unmet: Whether it is not shown only since two do not meet of whose meeting it was to come.
    """

    path: str
    shown: bool | None
    told: str = ""
    at: float | None = None
    cut: bool = False
    late: Late | None = None
    unmet: bool = False


def not_judged(path: str) -> Finding:
    """A fact that no track tells."""
    return Finding(path=path, shown=None, told=UNTOLD)


def failures(findings: Iterable[Finding], *, met: bool = True) -> tuple[str, ...]:
    """What is not shown, a sentence each; empty if the drive means what was said.

    Args:
        findings: What the drive shows.
        met: Whether encounters count, that the ego avoids a contact, and what nobody said: a search is still to find
            drives that are right in all three.
    """
    searched = ("encounter.", "unasked.", "contact.happens")
    counted = (one for one in findings if met or not (one.unmet or one.path.startswith(searched)))
    return tuple(f"{one.path}: {one.told}" for one in counted if one.shown is False)
