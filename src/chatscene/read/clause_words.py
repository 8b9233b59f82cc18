"""What a clause of English has: its words, which of them name the ego, and whether the ego is its subject."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache

from chatscene.read.ego_named import Span, ego_named


def _class(words: str) -> frozenset[str]:
    return frozenset(words.split())


# Closed classes of English words. What is in none of them is a noun, a verb or an adjective.
BE = _class("am is are was were be been being get gets got gotten getting")
AUXILIARIES = BE | _class("do does did has have had will would can could may might must shall should")
_ADVERBS = _class("not never then also almost just still even again once first soon n't")
_JOINS = _class("and but or so")
RELATIVES = _class("that which who whom")
_BEGINS = RELATIVES | _class("when while whilst as because since after before until if where")
PRONOUNS = _class("it he she they")
DETERMINERS = _class("a an the another some this that its his her their whose")
TOUCH = _class("into with of to on onto against in at")
_PLACES = _class("""
    behind ahead near beside past toward towards front above below opposite alongside next off from by
""")
PREPOSITIONS = TOUCH | _PLACES | _class("for through over under across along between")
_PARTS = _class("""
    front rear back left right side nose tail bumper door wing corner mirror hood bonnet trunk boot fender quarter panel
    end wheel driver driver's passenger
""")
_TOKEN = re.compile(r"[^\W_]+(?:[-'\u2019.][^\W_]+)*|[.,;:!?()\n]")
_ENDS = frozenset(".;:!?\n")


@dataclass(frozen=True, slots=True)
class Token:
    """A word or a mark of a text."""

    word: str
    span: Span
    ego: bool

    @property
    def is_adverb(self) -> bool:
        """Whether it is an adverb, as far as its form says so."""
        return self.word in _ADVERBS or self.word.endswith("ly")

    @property
    def is_part(self) -> bool:
        """Whether it is a part of a vehicle."""
        return self.word in _PARTS or self.word.removesuffix("s") in _PARTS

    @property
    def may_be_verb(self) -> bool:
        """Whether it may tell a deed: it names neither the ego nor a part, and is of no closed class."""
        closed = AUXILIARIES | PREPOSITIONS | DETERMINERS | PRONOUNS
        return not self.ego and not self.is_part and self.word not in closed

    @property
    def is_bound(self) -> bool:
        """Whether a clause ends with it, or begins behind it."""
        return self.word in _ENDS or self.word == "," or self.word in _JOINS or self.word in _BEGINS


@lru_cache(maxsize=32)
def tokens_of(text: str) -> tuple[Token, ...]:
    """The words and marks of a text, in their order."""
    names = ego_named(text).spans

    def of_ego(span: Span) -> bool:
        return any(low < span[1] and span[0] < high for low, high in names)

    return tuple(
        Token(one[0].lower().replace("\u2019", "'"), one.span(), of_ego(one.span())) for one in _TOKEN.finditer(text)
    )


def in_spans(tokens: Sequence[Token], spans: Sequence[Span]) -> Iterator[int]:
    """The words of a text that lie in some spans, wholly or in part."""
    for at, token in enumerate(tokens):
        if any(low < token.span[1] and token.span[0] < high for low, high in spans):
            yield at


def word_before(tokens: Sequence[Token], at: int) -> int:
    """The last word before another that is no adverb; -1 if there is none."""
    return next((i for i in range(at - 1, -1, -1) if not tokens[i].is_adverb), -1)


def clause_after(tokens: Sequence[Token], at: int) -> Iterator[int]:
    """The words of a clause behind one."""
    for i in range(at + 1, len(tokens)):
        if tokens[i].is_bound:
            return
        if tokens[i].word not in "()":
            yield i


def noun_after(tokens: Sequence[Token], at: int) -> Iterator[int]:
    """The words of a noun and of what it is a part of."""
    for i in clause_after(tokens, at):
        if tokens[i].word in PREPOSITIONS - {"of"}:
            return
        yield i


def subject_is_ego(tokens: Sequence[Token], verb: int) -> bool:
    """Whether the ego is the subject of a verb, or of the clause before that shares its subject."""
    words, i, deep = list[int](), verb - 1, 0
    while i >= 0 and (deep or not tokens[i].is_bound):
        deep += {")": 1, "(": -1}.get(tokens[i].word, 0)
        if not deep and tokens[i].word != "(" and not tokens[i].is_adverb and tokens[i].word not in AUXILIARIES:
            words.insert(0, i)
        i -= 1
    if not words or (len(words) == 1 and tokens[words[0]].word in PRONOUNS):
        return _shared_is_ego(tokens, i)
    at = next((k for k, word in enumerate(words) if tokens[word].ego and not _is_placed(tokens, word)), None)
    if at is None:
        return False
    rest = [word for word in words[at + 1 :] if not tokens[word].ego]
    return not any(
        tokens[word].word in DETERMINERS | PRONOUNS and tokens[word - 1].word not in PREPOSITIONS for word in rest
    )


def _is_placed(tokens: Sequence[Token], at: int) -> bool:
    """Whether somebody is named only to say where another is."""
    before = [token for token in tokens[max(at - 4, 0) : at] if not token.ego and token.word not in DETERMINERS]
    if not before:
        return False
    last = before[-1].word
    return last in PREPOSITIONS - {"of"} or (last == "of" and len(before) > 1 and before[-2].word in _PLACES)


def _shared_is_ego(tokens: Sequence[Token], bound: int) -> bool:
    """Whether the ego is whom a clause without a subject of its own is about, which begins behind a bound."""
    if bound < 0 or tokens[bound].word in _ENDS - {";", ":"}:
        return False
    if tokens[bound].word in RELATIVES:
        said = next((i for i in range(bound - 1, -1, -1) if tokens[i].word not in (",", ")", "(")), -1)
        return said >= 0 and tokens[said].ego
    begins = bound
    while begins > 0 and not tokens[begins - 1].is_bound:
        begins -= 1
    if begins == bound:  # ", and"
        return _shared_is_ego(tokens, bound - 1) if bound else False
    first = next((i for i in range(begins, bound) if tokens[i].word not in DETERMINERS), bound)
    return tokens[begins].ego or tokens[first].ego
