"""What a kind of road user is called: the nouns of its meaning and of how it is told, held against words of a text."""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import lru_cache

from chatscene.situations.phrases import KINDS
from chatscene.terms.vocabulary import WHEELS, UserKind

_PARTED = re.compile(r", not said.*|, (?:with|electric) .*| or |, |\|")
_BEFORE = re.compile(r"^(?:somebody (?:on|in|who stands on) )?(?:(?:another|an?|the|with) )?")
_BEHIND = re.compile(r" (?:of any|on|in|with) .*")
_ANYBODY = frozenset(("somebody", "people", "person", "child", "boy", "man", "woman", "rider"))
"""What those are called who may be of several kinds."""


def is_named(kind: UserKind, words: str) -> bool:
    """Whether words have a noun of a kind in them."""
    return any(_has(words, noun) for noun in nouns_of(kind))


@lru_cache(maxsize=64)
def nouns_of(kind: UserKind) -> frozenset[str]:
    """What a kind is called: as it is told, and, if it is no more general than its body, what that is called."""
    told = KINDS[kind]
    listed = [told.one, told.many, kind.value.replace("-", " "), *_PARTED.split(kind.meaning)]
    if not (kind.row.general or kind.row.prop):
        listed += _PARTED.split(kind.row.body.row.nouns.replace("\n", "|"))
    bare = (_BEFORE.sub("", one.strip().lower()) for one in listed)
    if not kind.row.body.row.tows:  # of which what it has behind it says what it is
        bare = (_BEHIND.sub("", one) for one in bare)
    return frozenset(one for one in bare if one) - (_ANYBODY if kind is not UserKind.CHILD else frozenset())


@lru_cache(maxsize=4096)
def named_in(words: str) -> frozenset[UserKind]:
    """The road users of which words have a noun, but for what stands for several kinds and for things."""
    exact = (kind for kind in UserKind if not (kind.row.general or kind.row.prop))
    return frozenset(kind for kind in exact if is_named(kind, words))


def names_another(words: str, there: Iterable[UserKind]) -> bool:
    """Whether words name a road user or a thing of a kind that nobody of some is or may be."""
    kinds = frozenset(there)
    if any(kind.row.general for kind in kinds):
        return False
    named = named_in(words)
    return bool(named) and not {kind.row.body for kind in named} & {kind.row.body for kind in kinds}


def finer(kind: UserKind, place: tuple[int, int], text: str, kinds: Iterable[UserKind]) -> UserKind:
    """What the noun at a place in a text says that somebody is: one of some kinds, or what it was taken for.

    Args:
        kind: What it was taken for. It moves as the other does, or was left open.
        place: Where the words for it begin and end; they are in the noun, or the noun is in them.
        text: The text.
        kinds: What it may be instead.
    """
    low, high = place
    for one in kinds:
        on_foot = one.moves is kind.moves and one.is_animal == kind.is_animal
        alike = on_foot or {one.moves, kind.moves} <= WHEELS or kind is UserKind.ROAD_USER
        for noun in nouns_of(one) if alike else ():
            for start, end in (found.span() for found in re.finditer(_pattern(noun), text, re.IGNORECASE)):
                if start <= low < end or low <= start < high:
                    return one
    return kind


def _has(words: str, noun: str) -> bool:
    # A pattern takes longer to compile than its first word to look for.
    if words.isascii() and noun.partition(" ")[0] not in words.lower():
        return False
    return re.search(_pattern(noun), words.replace("_", " "), re.IGNORECASE) is not None


def _pattern(noun: str) -> str:
    named = re.escape(noun).replace(r"\ ", r"[\s-]+")
    return rf"(?<!\w){named}(?:s|es)?(?!\w)"
