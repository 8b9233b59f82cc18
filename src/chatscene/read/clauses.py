"""Whose clause is it? A text cut into clauses, sorted by whose facts their words gave."""

from __future__ import annotations

import re
from collections.abc import Sequence

from chatscene.terms.frame import Clauses, Word

_ENDS = re.compile(
    r"(?!(?<=\d)[.,:]\d)[;.!?:,]+|\b(?:when|while|whilst|but|because|until)\b|\bas\b(?! if)"  # "1.5" is one number
    r"|\band (?=(?:an?|another|some|someone|we|i|the (?!ego\b))\b)",  # somebody else enters
    re.IGNORECASE,
)


def cut(text: str, words: Sequence[Word]) -> Clauses:
    """Cut a text into clauses; one whose words gave no fact belongs to whoever came before, the first to the ego."""
    ego: list[str] = []
    others: list[str] = []
    whose = ego
    begins = 0
    for ends, goes_on in (*(found.span() for found in _ENDS.finditer(text)), (len(text), len(text))):
        facts = [word.fact for word in words if word.fact and begins <= word.start < ends]
        of_others = sum(fact.startswith("others.") for fact in facts)
        if facts:
            whose = others if 2 * of_others >= len(facts) else ego
        if clause := text[begins:ends].strip():
            whose.append(clause)
        begins = goes_on
    return Clauses(whole=text, ego=", ".join(ego), adversary=", ".join(others))
