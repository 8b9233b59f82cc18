"""Who strikes whom, and whose part is struck: settled by grammar, where the voice of the verb says so.

The learned reader takes "a van was hit by us" for a blow of the van, and "we hit the rear of a van" for one on our
rear, since its texts tell of blows that the ego takes. English says who strikes by few constructions: the subject and
the object of an active verb, the ``by`` of a passive one; and whose part it is by its owner or its preposition. Where a
text has none of these, what was read stays.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache

from chatscene.read.ego_named import Span, ego_named
from chatscene.terms.situation import Contact, Situation
from chatscene.terms.vocabulary import Act, Striker, Where


def _class(words: str) -> frozenset[str]:
    return frozenset(words.split())


# Closed classes of English words. What is in none of them is a noun, a verb or an adjective.
_BE = _class("am is are was were be been being get gets got gotten getting")
_AUXILIARIES = _BE | _class("do does did has have had will would can could may might must shall should")
_ADVERBS = _class("not never then also almost just still even again once first soon n't")
_JOINS = _class("and but or so")
_RELATIVES = _class("that which who whom")
_BEGINS = _RELATIVES | _class("when while whilst as because since after before until if where")
_PRONOUNS = _class("it he she they")
_DETERMINERS = _class("a an the another some this that its his her their whose")
_TOUCH = _class("into with of to on onto against in at")
_PLACES = _class("""
    behind ahead near beside past toward towards front above below opposite alongside next off from by
""")
_PREPOSITIONS = _TOUCH | _PLACES | _class("for through over under across along between")
_PARTS = _class("""
    front rear back left right side nose tail bumper door wing corner mirror hood bonnet trunk boot fender quarter panel
    end wheel driver driver's passenger
""")
_TOKEN = re.compile(r"[^\W_]+(?:[-'\u2019.][^\W_]+)*|[.,;:!?()\n]")
_ENDS = frozenset(".;:!?\n")


@dataclass(frozen=True, slots=True)
class _Token:
    """A word or a mark of a text.

    Attributes:
        word: In small letters.
        span: Where it begins and ends.
        ego: Whether it names the ego.
    """

    word: str
    span: Span
    ego: bool

    @property
    def is_adverb(self) -> bool:
        return self.word in _ADVERBS or self.word.endswith("ly")

    @property
    def is_part(self) -> bool:
        return self.word in _PARTS or self.word.removesuffix("s") in _PARTS

    @property
    def is_bound(self) -> bool:
        return self.word in _ENDS or self.word == "," or self.word in _JOINS or self.word in _BEGINS


def settled(situation: Situation, text: str, marked: Mapping[str, Sequence[Span]]) -> Situation:
    """A situation whose contact is as the grammar of its text has it.

    Args:
        situation: As it was read.
        text: The text.
        marked: Where the words of each fact stand, by its path.
    """
    contact = situation.contact
    if contact is None or contact.striker is None:
        return situation
    verbs = tuple(span for path in ("contact", "contact.striker", "contact.happens") for span in marked.get(path, ()))
    striker = striker_in(text, verbs) or contact.striker
    turned = striker is not contact.striker
    made = replace(contact, striker=striker)
    if turned:
        made = replace(made, ego=contact.other, other=contact.ego)
    striking = made.ego if striker is Striker.EGO else made.other
    if turned or striking is not None:  # a part that is named is, as a rule, that of who is struck
        made = _with_owners(made, contact, text, marked)
    return _placed(replace(situation, contact=made), marked, verbs) if made != contact else situation


@lru_cache(maxsize=256)
def striker_in(text: str, verbs: Sequence[Span]) -> Striker | None:
    """Who strikes, if the grammar of a text says so.

    Args:
        text: The text.
        verbs: Where the words stand that tell of the contact.
    """
    tokens = _tokens(text)
    for at, token in enumerate(tokens):
        if not any(low < token.span[1] and token.span[0] < high for low, high in verbs):
            continue
        if token.ego or token.is_part or token.word in _AUXILIARIES | _PREPOSITIONS | _DETERMINERS | _PRONOUNS:
            continue
        if (striker := _by_passive(tokens, at) or _by_active(tokens, at)) is not None:
            return striker
    return None


@lru_cache(maxsize=32)
def _tokens(text: str) -> tuple[_Token, ...]:
    names = ego_named(text).spans

    def of_ego(span: Span) -> bool:
        return any(low < span[1] and span[0] < high for low, high in names)

    return tuple(
        _Token(one[0].lower().replace("\u2019", "'"), one.span(), of_ego(one.span())) for one in _TOKEN.finditer(text)
    )


def _by_passive(tokens: Sequence[_Token], verb: int) -> Striker | None:
    """Who strikes by a passive verb, or by a noun with ``by``."""
    before = _before(tokens, verb)
    finite = before >= 0 and tokens[before].word in _BE
    by = next((i for i in _clause_after(tokens, verb) if tokens[i].word == "by"), None)
    if by is None:
        return Striker.OTHER if finite and _subject_is_ego(tokens, before) else None
    agent = list(_noun_after(tokens, by))
    if any(tokens[i].ego for i in agent):
        return Striker.EGO
    struck = _subject_is_ego(tokens, before if finite else verb)
    if struck or (not finite and agent and _touches_ego(tokens, agent[-1])):
        return Striker.OTHER
    return None


def _by_active(tokens: Sequence[_Token], verb: int) -> Striker | None:
    """Who strikes by the subject or the object of an active verb."""
    before = _before(tokens, verb)
    if before >= 0 and (
        tokens[before].word in _BE | _DETERMINERS or (tokens[before].ego and not _is_whole(tokens, before))
    ):
        return None  # it is a passive verb or a noun
    after = next(iter(_clause_after(tokens, verb)), None)
    bound = next((i for i in range(verb - 1, -1, -1) if tokens[i].is_bound), -1)
    struck_before = bound >= 0 and tokens[bound].word in _RELATIVES  # as in "which we hit"
    if (after is None and not struck_before) or (after is not None and tokens[after].word in _AUXILIARIES):
        return None
    if _touches_ego(tokens, verb):
        return Striker.OTHER
    return Striker.EGO if _subject_is_ego(tokens, verb) else None


def _is_whole(tokens: Sequence[_Token], at: int) -> bool:
    """Whether a word names the ego by itself, as "we" does, and "our" does not."""
    return tokens[at].word not in ("my", "our")


def _before(tokens: Sequence[_Token], at: int) -> int:
    """The last word before another that is no adverb; -1 if there is none."""
    return next((i for i in range(at - 1, -1, -1) if not tokens[i].is_adverb), -1)


def _clause_after(tokens: Sequence[_Token], at: int) -> Iterator[int]:
    """The words of a clause behind one."""
    for i in range(at + 1, len(tokens)):
        if tokens[i].is_bound:
            return
        if tokens[i].word not in "()":
            yield i


def _noun_after(tokens: Sequence[_Token], at: int) -> Iterator[int]:
    """The words of a noun and of what it is a part of."""
    for i in _clause_after(tokens, at):
        if tokens[i].word in _PREPOSITIONS - {"of"}:
            return
        yield i


def _touches_ego(tokens: Sequence[_Token], at: int) -> bool:
    """Whether what is behind a word touches the ego: it is its object, or a part of it is."""
    words, named = list(_clause_after(tokens, at)), False
    for k, i in enumerate(words):
        token, after = tokens[i], tokens[words[k + 1]].word if k + 1 < len(words) else ""
        if token.ego:
            return True
        if token.word == "with" and named:
            return False  # by what it is touched
        named = named or token.word in _DETERMINERS
        known = token.word in _TOUCH or token.word in _DETERMINERS or token.is_part or token.is_adverb
        if not known and after not in _TOUCH and not _names(tokens, i):
            return False
        if not known and k and tokens[words[k - 1]].word == "of":
            return False
    return False


def _names(tokens: Sequence[_Token], at: int) -> bool:
    """Whether a word is the first part of a name of the ego, as whose vehicle it is."""
    return at + 1 < len(tokens) and tokens[at + 1].ego and tokens[at - 1].word in _DETERMINERS


def _subject_is_ego(tokens: Sequence[_Token], verb: int) -> bool:
    """Whether the ego is the subject of a verb, or of the clause before that shares its subject."""
    words, i, deep = list[int](), verb - 1, 0
    while i >= 0 and (deep or not tokens[i].is_bound):
        deep += {")": 1, "(": -1}.get(tokens[i].word, 0)
        if not deep and tokens[i].word != "(" and not tokens[i].is_adverb and tokens[i].word not in _AUXILIARIES:
            words.insert(0, i)
        i -= 1
    if not words or (len(words) == 1 and tokens[words[0]].word in _PRONOUNS):
        return _shared_is_ego(tokens, i)
    at = next((k for k, word in enumerate(words) if tokens[word].ego and not _is_placed(tokens, word)), None)
    if at is None:
        return False
    rest = [word for word in words[at + 1 :] if not tokens[word].ego]
    return not any(
        tokens[word].word in _DETERMINERS | _PRONOUNS and tokens[word - 1].word not in _PREPOSITIONS for word in rest
    )


def _is_placed(tokens: Sequence[_Token], at: int) -> bool:
    """Whether somebody is named only to say where another is."""
    before = [token for token in tokens[max(at - 4, 0) : at] if not token.ego and token.word not in _DETERMINERS]
    if not before:
        return False
    last = before[-1].word
    return last in _PREPOSITIONS - {"of"} or (last == "of" and len(before) > 1 and before[-2].word in _PLACES)


def _shared_is_ego(tokens: Sequence[_Token], bound: int) -> bool:
    """Whether the ego is whom a clause without a subject of its own is about, which begins behind a bound."""
    if bound < 0 or tokens[bound].word in _ENDS - {";", ":"}:
        return False
    if tokens[bound].word in _RELATIVES:
        said = next((i for i in range(bound - 1, -1, -1) if tokens[i].word not in (",", ")", "(")), -1)
        return said >= 0 and tokens[said].ego
    begins = bound
    while begins > 0 and not tokens[begins - 1].is_bound:
        begins -= 1
    if begins == bound:  # ", and"
        return _shared_is_ego(tokens, bound - 1) if bound else False
    first = next((i for i in range(begins, bound) if tokens[i].word not in _DETERMINERS), bound)
    return tokens[begins].ego or tokens[first].ego


def _with_owners(made: Contact, was: Contact, text: str, marked: Mapping[str, Sequence[Span]]) -> Contact:
    """A contact whose parts are of those who own them by the words of a text."""
    of: dict[str, object] = {}
    for field in ("ego", "other"):
        part = getattr(was, field)
        if part is None:
            continue
        owner = _owner(text, marked.get(f"contact.{field}", ()), made.striker)
        if owner is None or owner in of:
            return made
        of[owner] = part
    return replace(made, ego=of.get("ego"), other=of.get("other")) if of else made


def _owner(text: str, spans: Sequence[Span], striker: Striker | None) -> str | None:
    """Whose a part is: ``ego`` or ``other``; None if the words do not say."""
    tokens = _tokens(text)
    strikes, struck = ("ego", "other") if striker is Striker.EGO else ("other", "ego")
    for at, token in enumerate(tokens):
        if not any(low < token.span[1] and token.span[0] < high for low, high in spans):
            continue
        before = tokens[at - 1].word if at else ""
        if token.word.startswith("rear-end") or (token.word == "behind" and before == "from"):
            return struck
        if token.is_part and not (token.word == "front" and before == "in"):
            of = _owned(tokens, at)
            return {"strikes": strikes, "struck": struck}.get(of, of) or None
    return None


def _owned(tokens: Sequence[_Token], at: int) -> str:
    """Whose a part is by its words: ``ego``, ``other``, ``strikes`` or ``struck``; empty if they do not say."""
    i = next((i for i in range(at - 1, -1, -1) if not tokens[i].is_part and not tokens[i].is_adverb), -1)
    determined = i > 0 and tokens[i].word in _DETERMINERS
    by = tokens[i - determined].word if i >= 0 else ""
    if by == "with":
        return "strikes"
    behind = next((i for i in range(at + 1, len(tokens)) if not tokens[i].is_part), len(tokens))
    if behind < len(tokens) and tokens[behind].word == "of":
        return "ego" if any(tokens[i].ego for i in _noun_after(tokens, behind)) else "other"
    if i >= 0 and tokens[i].ego:
        return "ego"
    if i >= 0 and tokens[i].word.endswith(("'s", "s'")):
        return "other"
    return "struck" if by in _TOUCH | {"from"} else ""


def _placed(situation: Situation, marked: Mapping[str, Sequence[Span]], verbs: Sequence[Span]) -> Situation:
    """A situation in which whoever is struck in the rear is ahead of who strikes, where only the contact said where."""
    contact = situation.contact
    others = situation.adversaries
    if contact is None or len(others) != 1:
        return situation
    other = others[0]
    backs = any(deed.act is Act.REVERSE for deed in (*situation.ego.does, *other.does))
    parts = [span for field in ("ego", "other") for span in marked.get(f"contact.{field}", ())]
    kind = marked.get(f"others.{other.id}.kind", ())

    def says_more(path: str) -> bool:
        said = marked.get(path, ())
        return any(
            not any(low <= start and end <= high for low, high in (*parts, *verbs, *kind)) for start, end in said
        )

    path = f"others.{other.id}.starts"
    start = other.starts
    if start.where is Where.BEHIND and contact.striker is Striker.EGO and not backs and not says_more(f"{path}.where"):
        start = replace(start, where=Where.AHEAD)
    if start.side is not None and contact.other is not None and not says_more(f"{path}.side"):
        start = replace(start, side=None)
    if start == other.starts:
        return situation
    changed = tuple(replace(one, starts=start) if one is other else one for one in situation.others)
    return replace(situation, others=changed)
