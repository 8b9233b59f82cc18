"""The tokens of a situation and which may follow which, made from its nouns and the tables of its words.

A situation is written as one sequence: the facts that were said, in the order of the fields of their nouns, others and
deeds one after the other. What was not said has no token. A new word or field has its tokens by itself.
"""

from __future__ import annotations

import types
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import MISSING, dataclass, fields, is_dataclass
from enum import Enum, StrEnum
from functools import cache
from typing import Any, Union, get_args, get_origin, get_type_hints

from chatscene.situations.check import MOST
from chatscene.situations.facts import NO_FACTS
from chatscene.terms.amount import Amount
from chatscene.terms.reading import Verdict
from chatscene.terms.situation import EGO, Situation

Place = str
"""Where in a situation a token stands: the path of a fact without numbers, as ``others.does.act``."""
Token = tuple[str, str]
"""The field, as ``Deed.act``, and the word; the same wherever such a noun stands."""

END: Place = ""
BEGIN: Token = ("", "")
BEGUN = "begin"
"""The place before the first token."""
VERDICT, REFUSED = "verdict", "verdict.not"
COPIED, NUMBERED = "@", "#"
"""What is added to a place for the amount of the text that stands there, and for the number of a deed."""
NAMES = "ABCDEFGH"
"""What others are called, in their order; more are not written."""
DEEDS = 8
"""Deeds of one who can be waited for."""
_OF_DEEDS = frozenset(("after", "during"))
_NO_TOKENS = NO_FACTS | {"id"}


class Sort(Enum):
    """What a node of the tree of fields is."""

    WORDS = "one of some words"
    LIST = "some words"
    AMOUNT = "an amount, copied from the text"
    DEED = "somebody, and the number of one of the deeds"
    NOUN = "a noun that is always there"
    OPEN = "a noun that may be there, which has a token of its own"
    NOUNS = "some nouns, each of which begins with its first field"


@dataclass(frozen=True, slots=True, kw_only=True)
class Node:
    """A field of a noun.

    Attributes:
        words: What it may be, of words, names and small numbers.
        default: What it is if it is not said.
    """

    name: str
    place: Place
    key: str
    sort: Sort
    words: tuple[Any, ...] = ()
    amounts: tuple[type[Amount], ...] = ()
    required: bool = False
    default: Any = None
    nodes: tuple[Node, ...] = ()


def _stripped(hint: Any) -> tuple[tuple[Any, ...], bool]:
    """The types of a field without None, and whether None was among them."""
    if get_origin(hint) in (Union, types.UnionType):
        kinds = get_args(hint)
        return tuple(one for one in kinds if one is not type(None)), type(None) in kinds
    return (hint,), False


def _is_noun(kind: Any) -> bool:
    return is_dataclass(kind)


def _node(noun: type[Any], one: Any, hint: Any, above: Place) -> Node:
    kinds, optional = _stripped(hint)
    kind: Any = kinds[0]
    place = f"{above}.{one.name}".lstrip(".")
    default = one.default if one.default is not MISSING else None
    required = one.default is MISSING and one.default_factory is MISSING
    common: dict[str, Any] = {
        "name": one.name, "place": place, "key": f"{noun.__name__}.{one.name}",
        "required": required, "default": default,
    }  # fmt: skip
    if get_origin(kind) is tuple:
        (item, *_) = get_args(kind)
        if _is_noun(item):
            return Node(**common, sort=Sort.NOUNS, nodes=_nodes(item, place))
        return Node(**common, sort=Sort.LIST, words=tuple(item))
    if _is_noun(kind) and issubclass(kind, Amount):
        return Node(**common, sort=Sort.AMOUNT, amounts=kinds)
    if _is_noun(kind):
        return Node(**common, sort=Sort.OPEN if optional else Sort.NOUN, nodes=_nodes(kind, place))
    if issubclass(kind, StrEnum):
        words: tuple[Any, ...] = tuple(kind)
    elif kind is bool:
        words = (True, False)
    elif kind is int:
        words = tuple(range(MOST + 1))
    elif one.name in _OF_DEEDS:
        return Node(**common, sort=Sort.DEED, words=(EGO, *NAMES))
    else:
        words = tuple(NAMES)
    return Node(**common, sort=Sort.WORDS, words=tuple(word for word in words if required or word != default))


def _nodes(noun: type[Any], above: Place = "") -> tuple[Node, ...]:
    hints = get_type_hints(noun)
    return tuple(_node(noun, one, hints[one.name], above) for one in fields(noun) if one.name not in _NO_TOKENS)


@dataclass(frozen=True, slots=True)
class Grammar:
    """Which tokens there are, and which may follow which.

    Attributes:
        tokens: All that can be written but amounts, which are copied from the text.
        follow: Of each place, the places that may come next.
        of: Of each place, the numbers of the tokens that may stand there.
        amounts: Of each place of a copied amount, what it may be.
        next: The place to which a token leads, by the place before it and the number of the token.
    """

    nodes: tuple[Node, ...]
    tokens: tuple[Token, ...]
    follow: Mapping[Place, tuple[Place, ...]]
    of: Mapping[Place, tuple[int, ...]]
    amounts: Mapping[Place, tuple[type[Amount], ...]]
    number: Mapping[Token, int]
    next: Mapping[tuple[Place, int], Place]

    @property
    def kinds(self) -> tuple[type[Amount], ...]:
        """The kinds of amounts, by name."""
        return tuple(sorted({one for some in self.amounts.values() for one in some}, key=lambda one: one.__name__))


class _Linking:
    """Finds what may follow each place."""

    def __init__(self) -> None:
        self.follow: dict[Place, tuple[Place, ...]] = {END: ()}
        self.written: dict[Place, tuple[Token, ...]] = {END: ((END, END),)}
        self.amounts: dict[Place, tuple[type[Amount], ...]] = {}

    def sequence(self, nodes: Sequence[Node], after: tuple[Place, ...]) -> tuple[Place, ...]:
        """Where a row of fields may begin, by what may follow it."""
        for node in reversed(nodes):
            after = self._link(node, after)
        return after

    def _link(self, node: Node, after: tuple[Place, ...]) -> tuple[Place, ...]:
        place = node.place
        if node.sort is Sort.NOUN:
            return self.sequence(node.nodes, after)
        if node.sort is Sort.NOUNS:
            first = node.nodes[0]
            if not first.required:
                raise TypeError(f"{first.key} must be a field that is always said, as it begins a noun of several")
            self.sequence(node.nodes, (first.place, *after))
            return (first.place, *after)
        self.written[place] = tuple((node.key, str(word)) for word in node.words) or ((node.key, ""),)
        self.follow[place] = (place, *after) if node.sort is Sort.LIST else after
        if node.sort is Sort.OPEN:
            self.follow[place] = self.sequence(node.nodes, after)
        elif node.sort is Sort.AMOUNT:
            self.follow[place], self.follow[place + COPIED] = (place + COPIED,), after
            self.written[place + COPIED], self.amounts[place + COPIED] = (), node.amounts
        elif node.sort is Sort.DEED:
            self.follow[place], self.follow[place + NUMBERED] = (place + NUMBERED,), after
            self.written[place + NUMBERED] = tuple((NUMBERED, str(i)) for i in range(DEEDS))
        return (place,) if node.required else (place, *after)


@cache
def grammar() -> Grammar:
    """The grammar of situations."""
    nodes = _nodes(Situation)
    linking = _Linking()
    begin = linking.sequence(nodes, (END,))
    linking.written[VERDICT] = ((VERDICT, Verdict.SITUATION.value),)
    linking.written[REFUSED] = tuple((VERDICT, one.value) for one in Verdict if one is not Verdict.SITUATION)
    linking.follow |= {VERDICT: begin, REFUSED: (END,), BEGUN: (VERDICT, REFUSED)}
    tokens = tuple(dict.fromkeys((BEGIN, *(token for some in linking.written.values() for token in some))))
    number = {token: i for i, token in enumerate(tokens)}
    of = {place: tuple(number[token] for token in some) for place, some in linking.written.items()}
    return Grammar(nodes, tokens, linking.follow, of, linking.amounts, number, _led(linking.follow, of))


def _led(
    follow: Mapping[Place, tuple[Place, ...]], of: Mapping[Place, tuple[int, ...]]
) -> dict[tuple[Place, int], Place]:
    """The place to which each token leads."""
    made: dict[tuple[Place, int], Place] = {}
    for place, leads in follow.items():
        for there in leads:
            for token in of[there]:
                if made.setdefault((place, token), there) != there:
                    raise TypeError(f"token {token} after {place!r} may stand at {made[place, token]} and at {there}")
    return made


def places(nodes: Sequence[Node]) -> Iterator[Node]:
    """All fields, from the top."""
    for node in nodes:
        yield node
        yield from places(node.nodes)
