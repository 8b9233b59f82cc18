"""Who tells a text that is not the ego: somebody on foot, or another of those whom the text is read to tell of.

No list of verbs says that somebody walks. What a narrator does is read by the same reader with "Somebody" in the place
of "I": who jogs, steps off a kerb or pushes a pram is then read as a pedestrian, and who turns or brakes is not.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from chatscene.read.clause_words import AUXILIARIES, BE, DETERMINERS, PREPOSITIONS, Token, in_spans, tokens_of
from chatscene.read.ego_named import Span
from chatscene.terms.situation import Situation
from chatscene.terms.vocabulary import Moves, UserKind

SOMEBODY = "Somebody"
_THIRD_PERSON = {"am": "is", "are": "is", "were": "was", "have": "has", "do": "does"}
MOST = 4
"""Clauses of a text that are read so."""
DRIVES = ("ego.kind", "ego.route", "ego.speed")
"""Facts of who drives or rides: whoever tells them of the first person is not on foot."""
SUBJECTS = frozenset(("i", "we"))
"""Words of the first person that are the subject of a clause."""
SURE = 0.97
"""From here on who tells is on foot. Of 331 texts in the first person one was taken so wrongly, and two rightly."""
ON_FOOT = frozenset(kind for kind in UserKind if kind.moves is Moves.WALKS and not (kind.row.prop or kind.is_animal))
"""What somebody is who tells a text and neither drives nor rides."""


def clauses(text: str) -> Iterator[Span]:
    """Where it is said what the narrator does, without the pronoun: each clause, and its part before another noun."""
    tokens = tokens_of(text)
    for at, token in enumerate(tokens):
        if token.word not in SUBJECTS:
            continue
        rest = range(at + 1, len(tokens))
        end = next((i for i in rest if tokens[i].is_bound or tokens[i].word in SUBJECTS), len(tokens))
        noun = next((i for i in range(at + 3, end) if _begins_a_noun(tokens, i)), end)
        yield from ((tokens[at + 1].span[0], tokens[last - 1].span[1]) for last in sorted({end, noun}) if last > at + 1)


def _begins_a_noun(tokens: Sequence[Token], at: int) -> bool:
    return tokens[at].word in DETERMINERS and tokens[at - 1].word not in PREPOSITIONS


def of_somebody(said: str) -> str:
    """What is said of the narrator as a sentence about somebody else."""
    first, _, rest = said.partition(" ")
    return " ".join(filter(None, (SOMEBODY, _THIRD_PERSON.get(first.lower(), first), rest))) + "."


def told_by(situation: Situation, text: str, marked: Mapping[str, Sequence[Span]], *, on_foot: bool) -> dict[str, str]:
    """Whom of the others the narrator is: its path, with the word of the first person; empty if that is the ego.

    It is whose deed has the first person as its subject; else, of a narrator on foot, the first who is on foot.
    """
    for other in situation.others:
        for number in range(len(other.does)):
            if word := _subject_of(text, marked.get(f"others.{other.id}.does.{number}.act", ())):
                return {f"others.{other.id}": word}
    walker = next((other for other in situation.others if other.kind in ON_FOOT), None)
    word = next((one for one in tokens_of(text) if one.word in SUBJECTS), None)
    if walker is None or word is None or not on_foot:
        return {}
    return {f"others.{walker.id}": text[slice(*word.span)]}


def _subject_of(text: str, spans: Sequence[Span]) -> str:
    """The word of the first person that is the subject of an active verb among some words; empty if none is."""
    tokens = tokens_of(text)
    for at in in_spans(tokens, spans):
        token, before = tokens[at], [one for one in tokens[:at] if not one.is_adverb]
        if not token.may_be_verb:
            continue
        passive = bool(before) and before[-1].word in BE and not token.word.endswith("ing")
        subject = next((one for one in reversed(before) if one.word not in AUXILIARIES), None)
        if subject is not None and subject.word in SUBJECTS and not passive and not token.word.endswith("n't"):
            return text[slice(*subject.span)]
    return ""
