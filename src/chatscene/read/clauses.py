"""Whose clause is it? A sentence cut into clauses, sorted by whom they speak of."""

from __future__ import annotations

import re

from chatscene.read import lexicon as words
from chatscene.terms.frame import Clauses

_SENTENCE = re.compile(
    r"(?!(?<=\d)[.,:]\d)[;.!?:,]+|\b(?:when|while|whilst|but|because|until)\b|\bas\b(?! if)"  # "1.5" is one number
    r"|\band (?=(?:an?|another|some|someone|we|i|the (?!ego\b))\b)"  # somebody else enters
)
_OPENING = re.compile(r"(?:from|on|to|at|in|behind|ahead|beside)\b")


def cut(text: str) -> Clauses:
    """Cut a text, lower case and mended, into clauses; one without a subject belongs to whoever came before."""
    text = words.REACTION.sub("", text)
    ego: list[str] = []
    adversary: list[str] = []
    subject, opening = "ego", ""
    for clause in (part.strip() for part in _SENTENCE.split(text)):
        if _OPENING.match(clause) and _subject(clause) is None and not _does_something(clause):
            opening = f"{opening} {clause}".strip()  # "On the left, …" speaks of whoever comes next
        elif clause:
            subject = _subject(clause) or subject
            (ego if subject == "ego" else adversary).append(f"{opening} {clause}".strip())
            opening = ""
    if opening:
        (ego if subject == "ego" else adversary).append(opening)
    spoken = ", ".join(adversary)
    if words.ADVERSARIAL.search(spoken):  # whoever is called so is meant, whoever else may drive about
        spoken = spoken[words.ADVERSARIAL.search(spoken).start() :]  # type: ignore[union-attr]
    return Clauses(whole=text, ego=", ".join(ego), adversary=spoken)


def _subject(clause: str) -> str | None:
    """Who does something in a clause: the first of the two that is mentioned as more than an object."""
    bare = without_things(words.EGO_AS_OBJECT.sub(" ", clause))
    if words.ADVERSARIAL.search(clause):
        return "adversary"
    ego = words.EGO.search(bare)
    other = min((m.start() for p in words.KINDS.values() if (m := p.search(bare))), default=None)
    if ego and other is not None and words.ENCOUNTER.search(bare[:other]):
        return "ego" if words.BLOCKING.search(clause) else "adversary"
    if ego is None:
        return None if other is None else "adversary"
    return "ego" if other is None or ego.start() < other else "adversary"


def _does_something(clause: str) -> bool:
    return any(pattern.search(clause) for pattern in (*words.ACTIONS.values(), words.LEFT_TURN, words.RIGHT_TURN))


def without_things(text: str) -> str:
    """A text without what stands about or drives in the background."""
    for pattern in (*words.OCCLUDERS.values(), words.BACKGROUND):
        text = pattern.sub(" ", text)
    # Who is called a leader is one only for somebody else; as the subject of a clause he is the adversary.
    return words.LEADER.sub(lambda m: m[0] if text[: m.start()].strip() in ("", "a", "the") else " ", text)
