"""Who strikes whom, and whose part is struck: settled by grammar, where the voice of the verb says so.

The learned reader takes "a van was hit by us" for a blow of the van, and "we hit the rear of a van" for one on our
rear, since its texts tell of blows that the ego takes. English says who strikes by few constructions: the subject and
the object of an active verb, the ``by`` of a passive one; and whose part it is by its owner or its preposition. Where a
text has none of these, what was read stays.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import lru_cache

from chatscene.read.clause_words import (
    AUXILIARIES,
    BE,
    DETERMINERS,
    RELATIVES,
    TOUCH,
    Token,
    clause_after,
    in_spans,
    noun_after,
    subject_is_ego,
    tokens_of,
    word_before,
)
from chatscene.read.ego_named import Span
from chatscene.terms.situation import Contact, Situation
from chatscene.terms.vocabulary import Act, Striker, Where


def settled(situation: Situation, text: str, marked: Mapping[str, Sequence[Span]]) -> Situation:
    """A situation whose contact is as the grammar of its text has it."""
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
    """Who strikes, if the grammar of a text says so."""
    tokens = tokens_of(text)
    told = (at for at in in_spans(tokens, verbs) if tokens[at].may_be_verb)
    strikers = (_by_passive(tokens, at) or _by_active(tokens, at) for at in told)
    return next((striker for striker in strikers if striker is not None), None)


def _by_passive(tokens: Sequence[Token], verb: int) -> Striker | None:
    """Who strikes by a passive verb, or by a noun with ``by``."""
    before = word_before(tokens, verb)
    finite = before >= 0 and tokens[before].word in BE
    by = next((i for i in clause_after(tokens, verb) if tokens[i].word == "by"), None)
    if by is None:
        return Striker.OTHER if finite and subject_is_ego(tokens, before) else None
    agent = list(noun_after(tokens, by))
    if any(tokens[i].ego for i in agent):
        return Striker.EGO
    struck = subject_is_ego(tokens, before if finite else verb)
    if struck or (not finite and agent and _touches_ego(tokens, agent[-1])):
        return Striker.OTHER
    return None


def _by_active(tokens: Sequence[Token], verb: int) -> Striker | None:
    """Who strikes by the subject or the object of an active verb."""
    before = word_before(tokens, verb)
    if before >= 0 and (
        tokens[before].word in BE | DETERMINERS or (tokens[before].ego and not _is_whole(tokens, before))
    ):
        return None  # it is a passive verb or a noun
    after = next(iter(clause_after(tokens, verb)), None)
    bound = next((i for i in range(verb - 1, -1, -1) if tokens[i].is_bound), -1)
    struck_before = bound >= 0 and tokens[bound].word in RELATIVES  # as in "which we hit"
    if (after is None and not struck_before) or (after is not None and tokens[after].word in AUXILIARIES):
        return None
    if _touches_ego(tokens, verb):
        return Striker.OTHER
    return Striker.EGO if subject_is_ego(tokens, verb) else None


def _is_whole(tokens: Sequence[Token], at: int) -> bool:
    """Whether a word names the ego by itself, as "we" does, and "our" does not."""
    return tokens[at].word not in ("my", "our")


def _touches_ego(tokens: Sequence[Token], at: int) -> bool:
    """Whether what is behind a word touches the ego: it is its object, or a part of it is."""
    words, named = list(clause_after(tokens, at)), False
    for k, i in enumerate(words):
        token, after = tokens[i], tokens[words[k + 1]].word if k + 1 < len(words) else ""
        if token.ego:
            return True
        if token.word == "with" and named:
            return False  # by what it is touched
        named = named or token.word in DETERMINERS
        known = token.word in TOUCH or token.word in DETERMINERS or token.is_part or token.is_adverb
        if not known and after not in TOUCH and not _names(tokens, i):
            return False
        if not known and k and tokens[words[k - 1]].word == "of":
            return False
    return False


def _names(tokens: Sequence[Token], at: int) -> bool:
    """Whether a word is the first part of a name of the ego, as whose vehicle it is."""
    return at + 1 < len(tokens) and tokens[at + 1].ego and tokens[at - 1].word in DETERMINERS


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
    tokens = tokens_of(text)
    strikes, struck = ("ego", "other") if striker is Striker.EGO else ("other", "ego")
    for at in in_spans(tokens, spans):
        token, before = tokens[at], tokens[at - 1].word if at else ""
        if token.word.startswith("rear-end") or (token.word == "behind" and before == "from"):
            return struck
        if token.is_part and not (token.word == "front" and before == "in"):
            of = _owned(tokens, at)
            return {"strikes": strikes, "struck": struck}.get(of, of) or None
    return None


def _owned(tokens: Sequence[Token], at: int) -> str:
    """Whose a part is by its words: ``ego``, ``other``, ``strikes`` or ``struck``; empty if they do not say."""
    i = next((i for i in range(at - 1, -1, -1) if not tokens[i].is_part and not tokens[i].is_adverb), -1)
    determined = i > 0 and tokens[i].word in DETERMINERS
    by = tokens[i - determined].word if i >= 0 else ""
    if by == "with":
        return "strikes"
    behind = next((i for i in range(at + 1, len(tokens)) if not tokens[i].is_part), len(tokens))
    if behind < len(tokens) and tokens[behind].word == "of":
        return "ego" if any(tokens[i].ego for i in noun_after(tokens, behind)) else "other"
    if i >= 0 and tokens[i].ego:
        return "ego"
    if i >= 0 and tokens[i].word.endswith(("'s", "s'")):
        return "other"
    return "struck" if by in TOUCH | {"from"} else ""


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
