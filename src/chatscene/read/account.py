"""What an account of a conflict tells: read clause by clause, words that say nothing of it left out and listed.

Where `chatscene.read.parse` wants a place for every word, this reader looks for who did what: the parties, the acts of
each in their order, where each came from, and who touched whom with what. The one who touches the ego, or is touched by
it, is the adversary; who is only waited for, let pass or driven around is not.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import lru_cache

from chatscene.read.account_meaning import apply_phrase, apply_rule, ends, joins, of_party
from chatscene.read.account_rules import (
    APPOSED,
    DENIED_VERB,
    NOT,
    NUMBER,
    PARTICIPLE,
    PLAIN,
    RETURNS,
    SOMEBODY,
    STOP_SIGN,
    WORD,
    Kind,
    Rule,
    rules,
)
from chatscene.read.account_slots import account_of
from chatscene.read.account_wordings import prepared
from chatscene.read.parse import SEVERAL
from chatscene.read.phrases import Phrase, Sort, Where, kind_in, phrases_at, road_user, traits_in
from chatscene.read.quantities import quantity_or_speed_at
from chatscene.read.telling import NAMED_NEXT, Contact, Party, Telling
from chatscene.terms.actors import AdversaryKind, Manner
from chatscene.terms.acts import Action
from chatscene.terms.frame import Account
from chatscene.terms.scenario import Maneuver, Measure, Slots

_NEW = ("another", "a second", "a third", "a", "an", "one", "some", "two", "three", "several")
_DENIABLE_RULES = frozenset(
    (
        Kind.ACT,
        Kind.RESUMES,
        Kind.NOUN,
        Kind.BARE,
        Kind.ENTERS,
        Kind.HIT,
        Kind.EGO_HITS,
        Kind.STRUCK,
        Kind.DOOR,
        Kind.BYPASSES,
        Kind.MEETS,
        Kind.SITE,
        Kind.STATE,
    )
)
_DENIABLE_PHRASES = frozenset((Sort.ACT, Sort.STATE, Sort.PLACE, Sort.SITE, Sort.MANEUVER))
_PLACED = (("ahead", Where.AHEAD), ("in front", Where.AHEAD), ("behind", Where.BEHIND))  # by "20 m ahead"
_COMES_FROM = re.compile(r"from|on|at|in|to|behind")


@dataclass(frozen=True, slots=True)
class _Found:
    """The most telling words at a place of the text: a rule or a phrase, and what it matches."""

    says: Rule | Phrase
    match: re.Match[str]


def hear_account(text: str, known: Slots | None = None) -> Account | None:
    """Read an account; None if nobody is made out who does something with the ego.

    Args:
        text: Canonical, mended, with plain names (`chatscene.read.naming`).
        known: What patterns say of the place, its control, what hides somebody and the lanes.
    """
    text = " ".join(prepared(text).split())
    telling = _telling(text)
    if not telling.parties and (somebody := SOMEBODY.search(text)):
        text = f"{text[: somebody.start()]}a car{text[somebody.end() :]}"
        telling = _telling(text)
    return account_of(telling, text, known or Slots())


def _telling(text: str) -> Telling:
    """What is made out of a text on the way from its first word to its last."""
    telling = Telling()
    at = 0
    while at < len(text):
        at = _step(telling, text, at)
        while at < len(text) and text[at] == " ":
            at += 1
    return telling


def _step(telling: Telling, text: str, at: int) -> int:
    """Read what stands at a place; where the rest begins."""
    if (no := NOT.match(text, at)) and not _is_wayward(telling, text, at):
        telling.denied = True
        return no.end()
    if telling.party is not None and telling.party.aside and RETURNS.match(text, at):
        telling.subject = telling.main
    found = _most_telling(telling, text, at)
    if end := _name_at(telling, text, at, found) or _number_at(telling, text, at, found):
        return end
    if found is None:
        return _word_at(telling, text, at)
    _understand(telling, found)
    return found.match.end()


def _is_wayward(telling: Telling, text: str, at: int) -> bool:
    """Whether "not" is a part of what somebody does: "does not yield"."""
    wayward = (rule for rule in rules() if rule.kind is Kind.WAYWARD)
    return telling.subject is not None and any(rule.pattern.match(text, at) for rule in wayward)


def _most_telling(telling: Telling, text: str, at: int) -> _Found | None:
    """What matches most at a place: of phrases the first, of rules the last, and a rule rather than a phrase."""
    if at and (text[at - 1].isalnum() or text[at - 1] in "-'"):
        return None
    best, end = None, at
    party = telling.party
    for phrase in _phrases_of(party.kind.row.manner if party else None, text[at]):
        if (match := phrase.pattern.match(text, at)) and match.end() > end and not _is_of_a_sign(match, text):
            best, end = _Found(phrase, match), match.end()
    for rule in rules():
        match = rule.pattern.match(text, at)  # first, since most do not match
        if match is None or not _rule_fits(telling, rule) or _is_of_a_sign(match, text):
            continue
        if match.end() >= max(end, at + 1):
            before_who = rule.opens and telling.subject is None
            weaker = rule.kind is Kind.FROM_SIDE and best and isinstance(best.says, Rule) and match.end() == end
            if not weaker and not (before_who and not _COMES_FROM.match(match[0])):
                best, end = _Found(rule, match), match.end()
    return best


def _is_of_a_sign(match: re.Match[str], text: str) -> bool:
    """Whether the word at the end of a match is the first of "stop sign"."""
    return STOP_SIGN.match(text, match.end() - len("stop")) is not None


@lru_cache(maxsize=256)
def _phrases_of(manner: Manner | None, letter: str) -> tuple[Phrase, ...]:
    """What may be said of somebody who moves in a manner, or of the ego if it is None, beginning with a letter."""
    of_ego = manner is None
    said = (phrase for phrase in phrases_at(letter) if phrase.ego in (None, of_ego))
    return tuple(phrase for phrase in said if of_ego or phrase.manner in (None, manner))


def _rule_fits(telling: Telling, rule: Rule) -> bool:
    of_ego = telling.subject is None
    return rule.ego in (None, of_ego) or (of_ego and telling.opens and rule.opens)


def _understand(telling: Telling, found: _Found) -> None:
    """Take what was found for said, unless it is said not to be."""
    says = found.says
    if isinstance(says, Rule):
        if telling.denied and says.kind in _DENIABLE_RULES:
            telling.denied = False
        else:
            apply_rule(telling, says, found.match)
    elif telling.denied and says.sort in _DENIABLE_PHRASES:
        telling.denied = False
    else:
        apply_phrase(telling, says, found.match)


def _number_at(telling: Telling, text: str, at: int, found: _Found | None) -> int | None:
    number = quantity_or_speed_at(text, at)
    if number is None or number[1] <= (found.match.end() if found else at):
        return None
    party = telling.party
    if party is not None and not (number[0].measure is Measure.SPEED and Action.STAND in party.acts):
        party.quantities.append(number[0])
        party.where.update(where for word, where in _PLACED if word in number[0].said)
    return number[1]


def _word_at(telling: Telling, text: str, at: int) -> int:
    """Pass over what no rule or phrase knows: a number, a mark or a word, which is listed if it might say something."""
    if number := NUMBER.match(text, at):
        return number.end()
    word = WORD.match(text, at)
    assert word is not None  # whatever is no space is a word or a mark
    if word[0][0] in ".;!?":
        ends(telling)
    elif word[0][0] in ",:":
        if telling.subject is None or not PARTICIPLE.match(text, word.end()):
            joins(telling)
    elif not PLAIN.fullmatch(word[0]):
        telling.unread.append(word[0])
        if DENIED_VERB.search(text, 0, at) and not text.startswith(" to ", word.end()):
            telling.denied = False
    return word.end()


# Who is named


def _name_at(telling: Telling, text: str, at: int, found: _Found | None) -> int | None:
    named = road_user().match(text, at)
    if named is None or named.end() <= (found.match.end() if found else at):
        return None
    if found and isinstance(found.says, Rule) and found.says.kind in (Kind.OWN_DRIVER, Kind.DRIVER):
        return None
    if telling.denied:
        telling.denied = False
    else:
        _name(telling, named)
    return named.end()


def _name(telling: Telling, match: re.Match[str]) -> None:
    """Somebody is named: as the subject of a clause, as who is touched, or as who is met."""
    number = _who(telling, match)
    party = telling.parties[number]
    _describe(party, match)
    if telling.follows:
        party.where.add(Where.AHEAD)
        telling.follows = False
    for deed in telling.deeds:
        party.does(deed)
    if telling.deeds:
        party.aside = False
        telling.main = number
    telling.deeds.clear()
    for rule, where in telling.pending:
        of_party(telling, party, rule, where)
    telling.pending.clear()
    if telling.awaited is not None or telling.hits:
        part = telling.awaited if telling.awaited is not None else "front"
        telling.contacts.append(Contact(number, part, ego_hits=telling.hits, sentence=telling.sentence))
        telling.awaited, telling.hits = None, False
    elif telling.meets:
        _meet(telling, number)
    telling.subject = number
    if telling.opens:
        telling.main = number
    telling.opens = False


def _who(telling: Telling, match: re.Match[str]) -> int:
    """The number of whoever is named: one who was already, or a new one."""
    kind, noun = kind_in(match), match[0].split()[-1]
    number = _known(telling, kind, noun, match)
    apposed = APPOSED.match(match.string, match.end()) and match.string[: match.start()].endswith(", ")
    if apposed and telling.main is not None and telling.parties[telling.main].kind is kind:
        number = telling.main  # "somebody …, a pedestrian who …"
    if number is None:
        telling.parties.append(Party(kind=kind, noun=noun, acts=[Action.STAND] if kind.lies else []))
        number = len(telling.parties) - 1
    return number


def _known(telling: Telling, kind: AdversaryKind, noun: str, match: re.Match[str]) -> int | None:
    """The number of whoever was named already and is meant, or None."""
    article, parties = match["article"] or "", telling.parties
    if article in _NEW:
        return None
    same = [i for i, one in enumerate(parties) if one.noun == noun]
    if "other" in match[0].split():
        called = [i for i in same if parties[i].other]
        free = [i for i in same if not parties[i].aside and Where.AHEAD not in parties[i].where]
        same = called or free
        if not same and telling.somebody_is_there:
            return None
    if same:
        return same[-1]
    alike = [i for i, one in enumerate(parties) if one.kind is kind]
    if "other" in match[0] and not alike:
        return len(parties) - 1 if parties and not parties[-1].aside else None
    return alike[-1] if alike and article else None


def _describe(party: Party, match: re.Match[str]) -> None:
    """What is said of somebody before and with its name."""
    party.other = party.other or "other" in match[0].split()
    for sort, value in traits_in(match):
        if sort is Sort.WHERE and isinstance(value, Where):
            party.where.add(value)
        elif sort is Sort.ACT and isinstance(value, Action):
            party.does(value)
    if match["article"] in SEVERAL:
        party.group = True


def _meet(telling: Telling, number: int) -> None:
    """Somebody is only met on the way, and perhaps driven around."""
    party = telling.parties[number]
    party.aside = True
    for told in telling.pedals:
        if told.because_of == NAMED_NEXT:
            told.because_of = number
    if telling.passes and (Action.STAND in party.acts or Where.EDGE in party.where):
        telling.facts.setdefault("maneuver", Maneuver.BYPASS)
    telling.passed = number if telling.passes else None
    telling.meets = telling.passes = False
