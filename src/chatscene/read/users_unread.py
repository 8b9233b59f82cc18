"""The road users that a text names and that nobody is for in what was read of it."""

from __future__ import annotations

import re

from chatscene.read.clause_words import Token, tokens_of
from chatscene.read.ego_named import owned_kind
from chatscene.read.kinds import is_named, named_in, names_another
from chatscene.read.quotes import Span, spans_of, unread_spans
from chatscene.terms.actors import Manner as Moves
from chatscene.terms.situation import Situation
from chatscene.terms.vocabulary import UserKind

_WHO = re.compile(r"ego\.kind|others\.\w+(?:\.kind)?")
"""Paths of facts whose words name somebody."""
_PLACES = re.compile(r"road\..*|others\.\w+\.starts\.where")
# The closed class of English words that deny the noun behind them.
_DENIED = re.compile(
    r"(?i)\b(?:no|without|neither|nor|not (?:an?|any))(?: (?!(?:an?|the|his|her|our|my)\b)[\w'-]+){0,2} $"
)
_THINGS = tuple(kind for kind in UserKind if kind.moves is Moves.LIES)


def users_unread(situation: Situation, text: str) -> tuple[str, ...]:
    """The words that name a road user whom a situation that was read in a text has not, in their order.

    It is nobody where it is part of the name of a place or a thing ("bus lane", "bus stop") or of somebody who is there
    ("pickup truck"), is the ego's ("our truck"), or is denied ("no cyclists"). Nor is it if somebody of its kind, or of
    a general one, is there: nobody says how many are meant.
    """
    kinds = {one.kind for one in situation.others} | {situation.ego.kind or UserKind.CAR}
    over = unread_spans(situation, text)
    tokens = tokens_of(text)
    owned = owned_kind(text)
    who, places = _quoted(situation, text, _WHO), _quoted(situation, text, _PLACES)
    found: dict[str, None] = {}
    for at, token in enumerate(tokens):
        if not _among(token, over) or not _moves(token.word) or not names_another(token.word, kinds):
            continue
        before = _next_to(tokens, at, -1, text)
        after = _next_to(tokens, at, 1, text)
        of_somebody = any(_among(one, who) for one in (*before, *after))
        of_place = any(
            (one.may_be_verb and _among(one, places)) or _is_thing(f"{token.word} {one.word}") for one in after
        )
        of_ego = token.ego or (owned is not None and is_named(owned[0], token.word))
        if not (of_somebody or of_place or of_ego or _DENIED.search(text[: token.span[0]])):
            found.setdefault(token.word)
    return tuple(found)


def _next_to(tokens: tuple[Token, ...], at: int, way: int, text: str) -> tuple[Token, ...]:
    """The word before or behind another, if no mark is between them; else none."""
    if not 0 <= at + way < len(tokens):
        return ()
    first, last = sorted((tokens[at].span, tokens[at + way].span))
    return () if text[first[1] : last[0]].strip(" -") else (tokens[at + way],)


def _quoted(situation: Situation, text: str, paths: re.Pattern[str]) -> list[Span]:
    """Where the words of facts stand."""
    quoted = situation.evidence.quoted.items()
    return [span for path, words in quoted if paths.fullmatch(path) for span in spans_of(words, text)]


def _among(token: Token, spans: list[Span]) -> bool:
    return any(low < token.span[1] and token.span[0] < high for low, high in spans)


def _moves(word: str) -> bool:
    """Whether a word names a road user, and neither a thing nor whoever may be of several kinds."""
    general = any(is_named(kind, word) for kind in UserKind if kind.row.general)
    return not general and any(kind not in _THINGS for kind in named_in(word))


def _is_thing(words: str) -> bool:
    return any(is_named(kind, words) for kind in _THINGS)
