"""What an edit made of a situation: both, and each fact that is another one."""

from __future__ import annotations

from dataclasses import dataclass

from chatscene.situations.facts import said_in
from chatscene.terms.situation import Situation


@dataclass(frozen=True, slots=True, kw_only=True)
class Edited:
    """A situation after an edit."""

    text: str
    before: Situation
    after: Situation

    @property
    def changes(self) -> tuple[tuple[str, object, object], ...]:
        """Each fact that is another one: its path, what it was and what it is; None for what is not said."""
        was, now = dict(said_in(self.before)), dict(said_in(self.after))
        paths = dict.fromkeys((*was, *now))
        return tuple((path, was.get(path), now.get(path)) for path in paths if was.get(path) != now.get(path))

    def in_words(self) -> list[str]:
        """The changes, a line for each."""
        return [f"{path}: {_told(was)} \u2192 {_told(now)}" for path, was, now in self.changes]


def _told(value: object) -> str:
    if value is None:
        return "not said"
    return ("yes" if value else "no") if isinstance(value, bool) else str(value)
