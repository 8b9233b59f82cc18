"""A text with its words marked by the facts that they gave, in parts that a page or a terminal shows."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import groupby
from typing import TYPE_CHECKING, Any

from chatscene.situations.facts import NAMED

if TYPE_CHECKING:
    from chatscene.runs import RunRecord

_COLOURS = 8  # that the style sheet has for facts


@dataclass(frozen=True, slots=True, kw_only=True)
class Part:
    """A part of a text: words that one fact was read from, that are without effect, or that were not read.

    Attributes:
        text: As it was written, with what stands between its words.
        before: What stands before it, between words.
    """

    text: str
    before: str = ""
    fact: str = ""
    besides: str = ""
    colour: int = 0

    @property
    def unread(self) -> bool:
        """Whether it was not read."""
        return bool(self.text) and not self.fact and not self.besides


def parts_of(text: str, words: Sequence[Mapping[str, Any]]) -> list[Part]:
    """A text in parts, of which the last may only hold what stands behind all words."""
    found: list[Part] = []
    facts: dict[str, int] = {}
    at = 0
    for (fact, besides), group in groupby(words, key=lambda word: (word.get("fact", ""), bool(word.get("besides")))):
        together = list(group)
        start, end = together[0]["start"], together[-1]["end"]
        why = ", ".join(dict.fromkeys(word["besides"] for word in together)) if besides else ""
        colour = facts.setdefault(fact, len(facts) % _COLOURS) if fact else 0
        found.append(Part(text=text[start:end], before=text[at:start], fact=fact, besides=why, colour=colour))
        at = end
    return [*found, Part(text="", before=text[at:])]


def in_words(parts: Sequence[Part]) -> str:
    """A text with its parts marked in words: ``(side: from the left)``, ``{not read: phone}``.

    Words of facts that were changed since are shown as they stand.
    """
    told: list[str] = []
    for part in parts:
        fact = part.fact if "." in part.fact else part.fact.replace("_", " ")  # a path stands as it is set
        shown = f"({fact}: {part.text})" if fact and fact != NAMED else part.text
        told += [part.before, f"{{not read: {part.text}}}" if part.unread else shown]
    return "".join(told)


def unread_in_words(text: str, words: Sequence[Mapping[str, Any]]) -> str:
    """One line: which words of a text were not read; empty if every one was."""
    unread = [repr(part.text) for part in parts_of(text, words) if part.unread]
    return f"not understood, so possibly missing from the scenes: {', '.join(unread)}" if unread else ""


def told_first(explanation: Mapping[str, Any], record: RunRecord | None = None) -> list[str]:
    """What stands before any number: what was not read, was built otherwise than it was read, or did not take place."""
    told: list[str] = []
    for one in explanation.get("scenarios", []):
        unread = (
            unread_in_words(one["text"], one.get("words", [])) if "said" not in one else ""
        )  # else told in otherwise
        told += [*([unread] if unread else []), *one.get("otherwise", [])]
    if record is None:
        return told
    ran = record.counts.get("ran", 0)
    if ran and not record.counts.get("collided") and _says_a_contact(record):
        told.append(f"in none of {ran} scenes: the contact that was said; another ego may not avoid it (--ego)")
    return told + [f"in {len(scenes)} of {ran} scenes: {what}" for what, scenes in record.unplayed.items()]


def _says_a_contact(record: RunRecord) -> bool:
    from chatscene.situations.file import read_text

    said = None if record.situation is None else read_text(record.situation.text).contact
    return said is not None and said.happens
