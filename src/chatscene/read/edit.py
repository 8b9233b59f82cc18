"""An edit in words, read against the facts at hand: "make it a truck, from the left, and faster".

An edit is scanned from its first word to its last, the longest words that mean something at a time
(`chatscene.read.edit_words`); words that mean nothing refuse it. What the rest names is collected, each fact once, and
then put into the facts (`chatscene.read.edited_facts`).
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from chatscene.errors import EditRefused
from chatscene.read import lexicon
from chatscene.read.asides import without_comments
from chatscene.read.canonical import canonical
from chatscene.read.edit_words import Mark, Named, Word, plainer, scanned
from chatscene.read.edited_facts import ActWish, Wishes, edited
from chatscene.read.parse import parse, start_of
from chatscene.read.phrases import Sort, Where
from chatscene.terms.actors import AdversaryKind, Manner
from chatscene.terms.acts import Action
from chatscene.terms.edit import Edit, Facts
from chatscene.terms.scenario import (
    Control,
    EgoState,
    Maneuver,
    Measure,
    Occluder,
    Position,
    Quantity,
    Shift,
    Side,
    Slots,
    Unused,
    Why,
    includes,
)

LONGEST = 500  # characters

_HALFWAY = re.compile(r"half|midway|middle|in mid|moment|briefly|on its way")
_NOT = re.compile(r"\bnot\b|n't\b|\bwithout\b|\bfails?\b")
_IT = re.compile(r"\b(?:it|him|her|them|this|that)\b")
_GOES_ON = ("and", "or", "that", "which", "who")  # what is named to go may be followed by more of it
_ANOTHER = ("another", "a second", "a third")
_DEFINITE = "the"
_PARKED = "parked-"  # what hides somebody where it is parked: of a car, a truck, a bus


def hear_edit(text: str, facts: Facts, *, may_stay: bool = False) -> Edit:
    """What an edit makes of facts.

    Args:
        text: English.
        facts: Those at hand.
        may_stay: Whether they may be what they are, for one who holds more than they say.

    Raises:
        EditRefused: It has words that mean nothing here, contradicts itself or what stays, or changes nothing.
    """
    plain = canonical(plainer(text)).removesuffix(".")
    if not plain or len(plain) > LONGEST:
        raise EditRefused(f"say what is to be changed, in at most {LONGEST} characters, such as 'make it a truck'")
    try:
        return _heard(text, plain, (), facts, may_stay)
    except EditRefused:
        rest, comments = without_comments(plain)
        if not comments or not rest:
            raise
        try:
            return _heard(text, rest, comments, facts, may_stay)
        except EditRefused:
            pass  # what is told of all of it is to be known
        raise


def _heard(text: str, plain: str, comments: tuple[str, ...], facts: Facts, may_stay: bool) -> Edit:
    """What an edit makes of facts, read in plain words beside which there are comments."""
    words, unread = scanned(plain, facts.slots)
    if unread:
        mended = re.sub(r"[a-z]+", lambda m: lexicon.mended(m[0]), plain)
        again, still = scanned(mended, facts.slots)
        if len(still) < len(unread):
            plain, words, unread = mended, again, still
    if unread:
        said = ", ".join(repr(one) for one in unread)
        raise EditRefused(f"not understood: {said}; say it otherwise, nothing was changed", words=tuple(unread))
    wishes = _Hearing(plain, words, facts.slots).wishes()
    wishes.unused.extend(Unused(said=one, why=Why.BESIDES) for one in comments)
    after = edited(facts, wishes)
    if after == facts and not (may_stay and wishes.named()):
        raise EditRefused(f"nothing to change: this is so already ({', '.join(wishes.named()) or 'no fact is named'})")
    return Edit(text=" ".join(text.split()), facts=after, named=wishes.named(), unused=tuple(wishes.unused))


@dataclass
class _Hearing:
    """The words of an edit, taken in one after the other.

    Attributes:
        text: All of it.
        words: Its words.
        slots: The facts at hand.
        found: What was named so far.
        old: Whether what is named is what was, and is to go.
        told: The kind of what was named as old last; what follows only describes it.
        changing: Whether a word such as "replace" still waits for its "with".
        whose: Of whom is spoken: 0 for the adversary, 1 for the other, None for the ego.
        order: Where acts go beside those that stay.
        described: The words that only say which of several is spoken of.
    """

    text: str
    words: Sequence[Word]
    slots: Slots
    found: Wishes = field(default_factory=Wishes)
    old: bool = False
    told: Mark | None = None
    changing: bool = False
    whose: int | None = 0
    order: Mark | None = None
    described: Word | None = None

    def wishes(self) -> Wishes:
        """Everything that is named."""
        at = 0
        while at < len(self.words):
            at = self._take(at)
        return self.found

    def _take(self, at: int) -> int:
        """Take in the words at an index; the index of the next."""
        word = self.words[at]
        if word.mark is Mark.FILLER:
            return at + 1
        if word.mark is Mark.DEGREE:
            self.found.unused.append(Unused(said=word.said, why=Why.DEGREE))
            return at + 1
        if word.mark in _MODES:
            self._mode(word, at)
            return at + 1
        if word.mark is Mark.USER and (end := self._adds(word, at)):
            return end
        if self.old and self.told is not None and not self._of_the_same(word, at):
            self.old, self.told = self.changing, None
        self._content(word, at)
        if self.old and not (word.mark is Mark.USER and self._acts_next(at) and not self._went()):
            self.told = word.mark
        return at + 1

    def _went(self) -> bool:
        """Whether somebody was named to go."""
        return bool(self.found.dropped) or any(name == "adversary" for name, _, _ in self.found.olds)

    def _of_the_same(self, word: Word, at: int) -> bool:
        """Whether words go on to describe what is to go, or name another that is."""
        if self.told in (Mark.USER, Mark.ACT) and word.mark in (Mark.ACT, Mark.SIDED, Mark.WHERE):
            return True
        return at > 0 and self.words[at - 1].said in ("and", "or", "nor")

    def _mode(self, word: Word, at: int) -> None:
        """Take in words that name no fact, but say what is to be done with one."""
        mark = word.mark
        if mark in (Mark.OLD, Mark.DROP, Mark.CHANGE):
            self.old, self.told, self.changing = True, None, mark is Mark.CHANGE
        elif mark in (Mark.NEW, Mark.SET):
            self._new(word)
        elif mark is Mark.JOINT and word.said not in _GOES_ON and not self.changing:
            self.old, self.told = False, None
        elif mark in (Mark.THEN, Mark.FIRST, Mark.BEFORE, Mark.AFTER):
            self.order, self.old = mark, False
        elif mark is Mark.EGO:
            self.whose, self.old = None, self.old and self.changing
        elif mark is Mark.IT:
            self.whose = self.whose or 0
            self.old = self.old and (self.told is None or self.changing)
        elif mark is Mark.OTHER:
            self._of_the_other(word)
        elif mark is Mark.ONLY:
            self._only(at)
        elif mark is Mark.REPAIR:
            self.old, self.told, self.changing, self.found.repaired = False, None, False, True

    def _new(self, word: Word) -> None:
        """What follows is new."""
        denied = self.old and self.told is None and not self.changing  # "do not let it"
        if (word.mark is Mark.SET and not denied) or self.changing:
            self.old, self.changing, self.told = False, False, None
        if word.mark is Mark.SET and _IT.search(word.said):
            self.whose = self.whose or 0

    def _of_the_other(self, word: Word) -> None:
        if self.slots.others:
            self.whose = 1
            if self.old:
                self.found.drop_other(word.said)
                self.whose = 0
        elif self.old or "other" not in word.said:
            raise EditRefused(f"{word.said!r}: there is nobody but the {_called(self.slots)}")
        else:
            self.whose = 0

    def _only(self, at: int) -> None:
        """One where several were, or nobody beside the adversary."""
        if self.slots.group:
            self.found.wish("group", None, self.words[at].said)
        elif self.slots.others:
            self.found.drop_other(self.words[at].said)
        elif any(word.mark not in (*_MODES, Mark.FILLER, Mark.USER) for word in self.words):
            return
        else:
            raise EditRefused(f"{self.words[at].said!r}: there is nobody but the {_called(self.slots)}")

    def _clause(self, at: int) -> list[Word]:
        """The words about an index, between commas and the like."""
        first, last = at, at
        while first > 0 and self.words[first - 1].mark is not Mark.JOINT:
            first -= 1
        while last < len(self.words) and self.words[last].mark is not Mark.JOINT:
            last += 1
        return list(self.words[first:last])

    # Road users

    def _adds(self, word: Word, at: int) -> int:
        """Take in somebody who joins the others, if that is what is said; the index of what follows, else 0."""
        named: Named = word.value
        marks = [one.mark for one in self._clause(at)]
        hides = self._hides(word)
        joins = named.article in _ANOTHER or Mark.ADD in marks[: marks.index(Mark.USER)] or Mark.ALSO in marks
        joins |= self._comes_with(at) or self._is_let_in(word, at) or self._is_behind(word, at)
        replaces = any(one.mark in (Mark.OLD, Mark.INSTEAD, Mark.CHANGE) for one in self.words)
        known = named.several and named.kind is self.slots.adversary  # they are a group
        if self.old or hides or not joins or replaces or known or named.article == _DEFINITE:
            return 0
        if self.slots.others:
            raise EditRefused(
                f"{word.said!r}: two road users besides the ego are the most; remove the second one first"
            )
        end = next((i for i in range(at, len(self.words)) if self.words[i].said in (".", ";")), len(self.words))
        until = self.words[end].at if end < len(self.words) else len(self.text)
        rest = re.sub(r"\b(?:also|too|as well|in addition|additionally)\b ?", "", self.text[word.at : until]).strip(
            " ,"
        )
        rest = rest if named.article else f"a {rest}"
        for before in self._clause(at)[: self._clause(at).index(word)]:
            if before.mark is Mark.WHERE and self.found.take_back(before.value):
                rest = f"{rest} {before.said}"  # "from behind, another car …"
        one = _parsed(rest) or self._made_out(rest, named)
        if one is None:
            raise EditRefused(
                f"not understood: {rest!r}; say who is added, where and what it does, such as 'add a truck that "
                "stands ahead of us'",
                words=(rest,),
            )
        self.found.add_other(one, rest)
        return end

    def _comes_with(self, at: int) -> bool:
        """Whether somebody comes "with" all else; a lorry with a trailer is one."""
        before = [word.mark for word in self.words[max(at - 2, 0) : at]]
        after = {word.mark for word in self.words[at + 1 :]} & {Mark.ACT, Mark.WHERE, Mark.SIDED, Mark.SIDE}
        after |= {sort for sort, _ in self.words[at].value.traits if sort in (Sort.WHERE, Sort.ACT)}
        comes = at > 0 and self.words[at - 1].said == "with" and not self.changing
        return comes and before[0] is not Mark.USER and bool(after)

    def _is_let_in(self, word: Word, at: int) -> bool:
        """Whether somebody is to do something that the adversary does not: "let a car drive behind us"."""
        let = at > 0 and self.words[at - 1].mark is Mark.SET and not _IT.search(self.words[at - 1].said)
        other = word.value.kind is not self.slots.adversary and bool(word.value.article)
        does = next((one for one in self.words[at + 1 :] if one.mark is not Mark.FILLER), None)
        drives = does is not None and does.mark is Mark.WHERE and self.words[at + 1].mark is Mark.FILLER
        acts = does is not None and does.mark is Mark.ACT and does.value not in self.slots.actions
        return let and other and (acts or drives)

    def _is_behind(self, word: Word, at: int) -> bool:
        """Whether somebody new is told to be behind the ego while the adversary, of another kind, is ahead."""
        new = word.value.kind is not self.slots.adversary and word.value.article in ("a", "an")
        opens = all(one.mark in (Mark.FILLER, Mark.JOINT, Mark.WHERE) for one in self.words[:at])
        behind = {(Mark.WHERE, Where.BEHIND), (Mark.ACT, Action.TAILGATE)}
        told = any((one.mark, one.value) in behind for one in self._clause(at))
        return new and opens and told and self.slots.position in _SEEN_AT[Where.AHEAD]

    def _made_out(self, text: str, named: Named) -> Slots | None:
        """Somebody who joins, by the words of edits; if no act is said, who is ahead or parked stands."""
        words, unread = scanned(text, Slots())
        marks = {Mark.FILLER, Mark.USER, Mark.ACT, Mark.WHERE, Mark.SIDED, Mark.SIDE, Mark.JOINT, Mark.IT}
        if unread or any(word.mark not in marks for word in words):
            return None
        where = {word.value for word in words if word.mark is Mark.WHERE}
        where |= {word.value[1] for word in words if word.mark is Mark.SIDED and word.value[1]}
        where |= {Where(str(value)) for sort, value in named.traits if sort is Sort.WHERE}
        sides = {str(word.value if word.mark is Mark.SIDE else word.value[0]) for word in words if word.mark in _SIDES}
        acts = [word.value for word in words if word.mark is Mark.ACT]
        if len(sides) > 1 or len([word for word in words if word.mark is Mark.USER]) > 1:
            return None
        drives = where & {Where.BEHIND, Where.BESIDE, Where.NEXT_LANE, Where.OPPOSITE}
        acts = acts or [Action.FOLLOW if drives else Action.STAND]
        side = Side(sides.pop()) if sides else None
        one = Slots(adversary=named.kind, actions=tuple(dict.fromkeys(acts)), side=side)
        position = start_of(replace(one, place=self.slots.place), frozenset(where))
        return None if position is None else replace(one, position=position)

    def _hides(self, word: Word) -> Occluder | None:
        """What a road user is that only stands in the way of sight; None if it does more."""
        named: Named = word.value
        occluder = self.slots.occluder
        standing = next((one for one in Occluder if one == f"{_PARKED}{named.kind}"), None)
        parked = (Sort.WHERE, Where.EDGE) in named.traits and occluder is not None
        marks = [one.mark for one in self._clause(self.words.index(word)) if one.mark is not Mark.OCCLUDER]
        marks += [Mark.HIDDEN for one in self.words if one.mark is Mark.OCCLUDER and one.value is None]
        marks += [Mark.HIDDEN for one in self._before(word) if self._is_in_the_way(one)]
        at_hand = standing is occluder and named.kind is not self.slots.adversary
        return standing if Mark.HIDDEN in marks or parked or at_hand else None

    def _before(self, word: Word) -> list[Word]:
        """The words before one, of its clause."""
        return [one for one in self._clause(self.words.index(word)) if one.at < word.at]

    def _is_in_the_way(self, word: Word) -> bool:
        """Whether what hides somebody is spoken of: "the parked car" that is to be a bus."""
        occluder = self._hides(word) if word.mark is Mark.USER else word.value if word.mark is Mark.OCCLUDER else None
        return occluder is not None and occluder is self.slots.occluder and word.said.startswith("the ")

    def _named(self, word: Word, at: int) -> None:
        """Somebody is named: the adversary, the other, or somebody in the adversary's place."""
        named: Named = word.value
        if occluder := self._hides(word):
            self._occluder(occluder, word)
            return
        if self.old and not (named.kind is self.slots.adversary and self._acts_next(at)):
            self._goes(named, word)
            return
        if self._is_known(named, word, at):
            return
        if [one.mark for one in self.words[max(at - 2, 0) : at]] == [Mark.EGO, Mark.FILLER] and self.words[
            at - 1
        ].said in _ARE:
            raise EditRefused(f"{word.said!r}: what the ego is comes with the model of it")
        fact = "other adversary" if self.whose == 1 else "adversary"
        self.whose = self.whose or 0
        self.found.wish(fact, named.kind, word.said)
        if self.whose == 0 and (named.several or (named.article == "one" and self.slots.group)):
            self.found.wish("group", named.several or None, word.said)
        for sort, value in named.traits:
            if sort is Sort.WHERE:
                self.found.place(Where(str(value)), word.said)
            elif sort is Sort.ACT and isinstance(value, Action):
                self.found.acts.append(ActWish(action=value, said=word.said, order=Mark.ALSO))

    def _is_spoken_of(self, at: int) -> bool:
        """Whether of somebody without an article more is said: "pedestrian stops", "van becomes a truck"."""
        after = self.words[at + 1 :]
        becomes = any(one.mark is Mark.USER and one.value.article for one in after)
        parted = any(one.mark in (Mark.OLD, Mark.DROP, Mark.JOINT) for one in after)
        return self._acts_next(at) or (becomes and not parted)

    def _is_the_rider(self, kind: AdversaryKind) -> bool:
        """Whether somebody is called by what sits on the wheels: "the kid" on a bike."""
        row = None if self.slots.adversary is None else self.slots.adversary.row
        return kind.row.manner is Manner.WALKS and row is not None and row.manner in (Manner.RIDES, Manner.WALKS)

    def _which(self, kind: AdversaryKind, at: int) -> int:
        """Who of a kind is spoken of: the one that is where the next words say, if they do."""
        everybody = (self.slots, *self.slots.others)
        of_kind = [i for i, one in enumerate(everybody) if one.adversary is kind]
        after = self.words[at + 1] if at + 1 < len(self.words) else None
        if after is not None and after.mark is Mark.WHERE and after.value in _SEEN_AT:
            there = [i for i in of_kind if everybody[i].position in _SEEN_AT[after.value]]
            self.described = after if there else None
            return there[0] if there else of_kind[0]
        return of_kind[0]

    def _acts_next(self, at: int) -> bool:
        """Whether an act is named next, so that whoever is named is only the one who does it or not."""
        rest = (word.mark for word in self.words[at + 1 :] if word.mark not in (Mark.FILLER, Mark.SET, Mark.DROP))
        return next(rest, None) is Mark.ACT

    def _is_known(self, named: Named, word: Word, at: int) -> bool:
        """Whether somebody is named who is there already, and so only spoken of."""
        known = [self.slots.adversary, *(one.adversary for one in self.slots.others)]
        definite = named.article == _DEFINITE
        if named.kind in known and (definite or (not named.article and self._is_spoken_of(at))):
            self.whose = self._which(named.kind, at)
            return True
        if definite and named.kind not in known and self._is_the_rider(named.kind):
            self.whose = 0
            return True
        if definite and (self._acts_next(at) or not self._stated(at)):
            raise self._nobody(word)
        return False

    def _goes(self, named: Named, word: Word) -> None:
        """Somebody is to go."""
        others = [one.adversary for one in self.slots.others]
        if named.kind is self.slots.adversary and not (named.kind in others and named.article != _DEFINITE):
            self.found.old("adversary", named.kind, word.said)
        elif named.kind in others and (self.changing or "adversary" in self.found.facts):
            self._replaces_other(named.kind, word.said)
        elif named.kind in others:
            self.found.drop_other(word.said)
        elif self.slots.leader and (Sort.ACT, Action.SLOW) in named.traits:
            self.found.old("leader", True, word.said)
        else:
            raise self._nobody(word)

    def _replaces_other(self, kind: AdversaryKind, said: str) -> None:
        """Whoever is named in somebody's place takes the place of the other: it was or will be named."""
        self.whose = 1
        self.found.old("other adversary", kind, said)
        if (known := self.found.facts.pop("adversary", None)) is not None:
            self.found.wish("other adversary", *known)

    def _nobody(self, word: Word) -> EditRefused:
        return EditRefused(f"{word.said!r}: there is none; the adversary is a {_called(self.slots)}")

    def _stated(self, at: int) -> bool:
        """Whether words before or after say that somebody is in another's place."""
        return any(
            one.mark in (Mark.SET, Mark.NEW, Mark.INSTEAD, Mark.OLD, Mark.CHANGE) for one in self.words[:at]
        ) or any(one.mark in (Mark.INSTEAD, Mark.OLD) for one in self.words[at:])

    # Everything else

    def _content(self, word: Word, at: int) -> None:
        """Take in words that name a fact."""
        value, said = word.value, word.said
        if word.mark in _FACTS:
            self._fact(_FACTS[word.mark], value, word)
        elif word.mark in _NONE:
            self.found.wish(_NONE[word.mark], None, said)
        elif word.mark in (Mark.PLACE, Mark.SITE):
            self._site(word)
        elif word.mark in (Mark.SIDED, Mark.SIDE, Mark.OTHER_SIDE):
            self._sided(word, at)
        elif word.mark in (Mark.NUMBER, Mark.SHIFT):
            self._number(value, said)
        elif word.mark is Mark.ANY:
            self.found.number(value, None, said)
        elif word.mark is Mark.MIRROR:
            self.found.mirror(said)
        else:
            self._of_somebody(word, at)

    def _of_somebody(self, word: Word, at: int) -> None:
        if word.mark is Mark.USER:
            self._named(word, at)
        elif word.mark is Mark.ACT:
            self._act(word, at)
        elif word.mark is Mark.WHERE:
            self._where(word.value, word)
        elif word.mark is Mark.HIDDEN:
            self._hidden(word, at)
        elif word.value is None:
            self._some_occluder(word)
        else:
            self._occluder(word.value, word)

    def _site(self, word: Word) -> None:
        """A place with how it is controlled, or a site with what the ego does there."""
        value, besides = word.value if isinstance(word.value, tuple) else (word.value, None)
        if value is self.slots.site and not self.old and len(self.words) > 1:
            return  # "in the middle of the crosswalk"
        self._fact(str(word.mark), value, word)
        if besides is not None:
            self._fact("control" if word.mark is Mark.PLACE else "maneuver", besides, word)

    def _sided(self, word: Word, at: int) -> None:
        before = [one.value for one in self._clause(at) if one.mark is Mark.ACT and one.at < word.at]
        if before and before[-1] in _TO_A_SIDE and "from" not in word.said and "lane" not in word.said:
            raise EditRefused(
                f"{word.said!r}: to which side somebody turns or swerves is no edit; say it in the sentence"
            )
        if word.mark is Mark.SIDE:
            self._bare_side(Side(word.value), word)
        elif self.whose is None and word.mark is Mark.SIDED and word.said.startswith("to "):
            self._bare_side(Side(word.value[0]), word)
        elif word.mark is Mark.OTHER_SIDE:
            self._other_side(word)
        else:
            side, where = word.value
            self._side(Side(side), word.said)
            if where is not None and not self.old:
                self.found.place(where, word.said)

    def _fact(self, name: str, value: Any, word: Word) -> None:
        if self.old and name == "control" and self.slots.control in (None, value):
            self.found.wish(name, Control.NONE, word.said)
        elif self.old:
            self.found.old(name, self.slots.ego if name == "ego" else value, word.said)
        elif name == "leader" and self.slots.leader is None and self.slots.position is Position.AHEAD:
            self.whose = 0  # it is the adversary that leads
        elif (
            name != "place"
            or self.slots.place is None
            or value is self.slots.place
            or not includes(value, self.slots.place)
        ):
            self.found.wish(name, value, word.said)

    def _act(self, word: Word, at: int) -> None:
        if self.whose is None:
            raise EditRefused(f"not understood of the ego: {word.said!r}", words=(word.said,))
        clause, order, action = self._clause(at), self.order, word.value
        marks = {one.mark for one in clause}
        if self._is_no_act(word, marks):
            return
        if self.whose == 0 and action in _TURNS and self._ego_turns(at):
            self._fact("maneuver", _TURNS[action], word)
            return
        if self._is_reference(word, at):
            return
        halfway = Mark.ON_THE_WAY in marks or _HALFWAY.search(word.said) is not None
        if action is Action.STAND and halfway:
            action = Action.HESITATE
        if self.old:
            order = Mark.OLD
        elif order is None:
            order = self._order(marks, halfway=halfway)
        self.found.acts.append(ActWish(action=action, said=word.said, order=order, of=self.whose))
        if order in (Mark.BEFORE, Mark.AFTER):
            self.order = None

    def _is_no_act(self, word: Word, marks: set[Mark]) -> bool:
        """Whether words that may name an act say something else, which is then taken in."""
        if word.value is Action.ONCOMING and self._is_from_across(word):
            self._other_side(word)
        elif word.value is Action.FOLLOW and _NOT.search(word.said) is not None:
            self.found.dont(self.slots, word.said, of=self.whose or 0)
        else:  # "let her walk slower": whatever she does
            return word.value is Action.FOLLOW and bool(marks & {Mark.SHIFT, Mark.NUMBER}) and not self.old
        return True

    def _order(self, marks: set[Mark], *, halfway: bool) -> Mark | None:
        """Where an act goes, by the other words of its clause."""
        if marks & {Mark.ALSO, Mark.ADD, Mark.THEN, Mark.FIRST}:
            return Mark.FIRST if Mark.FIRST in marks else Mark.ALSO
        if any(one.mark is Mark.INSTEAD for one in self.words):
            return Mark.INSTEAD
        return Mark.ON_THE_WAY if halfway else None

    def _is_reference(self, word: Word, at: int) -> bool:
        """Whether an act that somebody does already is only named to say something else of it: "cut in later"."""
        acts = (self.slots if self.whose == 0 else self.slots.others[0]).actions
        if self.old or self.order is not None or word.value not in acts:
            return False
        others = [one for one in self._clause(at) if one.mark is Mark.ACT and one.value not in acts]
        besides = any(one.mark in _BESIDES_ACTS for one in self._clause(at)) or len(self.found.facts) > 0
        named = any(one.mark is Mark.USER and one.value.article != _DEFINITE for one in self._clause(at))
        return not others and (besides or named)

    def _ego_turns(self, at: int) -> bool:
        """Whether a turn of which nobody is said to make it is the ego's: it turns, and the adversary does not."""
        named = any(one.mark in (Mark.IT, Mark.USER, Mark.OTHER) for one in self.words)
        its = {Action.TURN_LEFT, Action.TURN_RIGHT}.intersection(self.slots.actions)
        walks = self.slots.adversary is not None and self.slots.adversary.row.manner is Manner.WALKS
        of_us = re.search(r"\b(?:of|for|by) (?:us|we|ego)\b", self.text[self.words[at].at :]) is not None
        return of_us or (not named and not its and (walks or self.slots.maneuver in _TURNS.values()))

    def _where(self, where: Where, word: Word) -> None:
        if self.whose is None:
            raise EditRefused(f"not understood of the ego: {word.said!r}", words=(word.said,))
        if word is self.described:
            return
        if where is Where.OPPOSITE and self._is_from_across(word):
            self._other_side(word)
            return
        if not self.old:
            self.found.place(where, word.said, of=self.whose)
        elif self.told is None and self.slots.others and not self.changing:
            self.found.drop_other(word.said)

    def _is_from_across(self, word: Word) -> bool:
        """Whether the opposite direction is the other side: of one who crosses from a side."""
        crosses = Action.CROSS in self.slots.actions and self.slots.side is not None and self.whose == 0
        return crosses and "opposite direction" in word.said

    def _side(self, side: Side, said: str) -> None:
        if self.whose is None:
            raise EditRefused(f"not understood of the ego: {said!r}", words=(said,))
        name = "other side" if self.whose == 1 else "side"
        if self.old:
            self.found.old(name, side, said)
        else:
            self.found.wish(name, side, said)

    def _bare_side(self, side: Side, word: Word) -> None:
        """A side alone is that of whoever is spoken of, or the one to which the ego turns."""
        turn = self.slots.maneuver is not None and ("left" in self.slots.maneuver or "right" in self.slots.maneuver)
        if self.old and self.found.acts and self.found.acts[-1].action.row.turn:
            return  # "it turns right, not left"
        if self.whose is None and not turn:
            self._fact("maneuver", Maneuver.LEFT_TURN if side is Side.LEFT else Maneuver.RIGHT_TURN, word)
        elif turn and (self.whose is None or self.slots.side is None or "maneuver" in self.found.facts):
            assert self.slots.maneuver is not None  # or it is no turn
            other = {"left": "right", "right": "left"}[side]
            self._fact("maneuver", type(self.slots.maneuver)(self.slots.maneuver.replace(other, side)), word)
        else:
            self._side(side, word.said)

    def _other_side(self, word: Word) -> None:
        whose = self.slots if self.whose != 1 else self.slots.others[0]
        if whose.side is None:
            raise EditRefused(f"{word.said!r}: no side was said so far; say left or right")
        self._side(Side.LEFT if whose.side is Side.RIGHT else Side.RIGHT, word.said)

    def _hidden(self, word: Word, at: int) -> None:
        """What hides somebody is named beside it, or it is none any more."""
        if self.old:
            self.found.wish("occluder", None, word.said)
            self.told = Mark.HIDDEN
            return
        rest = self._clause(at)
        if "see" in word.said and {"light", "weather"} & self.found.facts.keys():
            return  # in the dark or in fog
        if not any(one.mark is Mark.OCCLUDER or (one.mark is Mark.USER and self._hides(one)) for one in rest):
            known = ", ".join(str(one).replace("-", " ") for one in Occluder)
            raise EditRefused(f"{word.said!r}: say by what: {known}")

    def _occluder(self, occluder: Occluder, word: Word) -> None:
        """What hides somebody; "the bus stop" may be the one at hand, of which something is to be said."""
        if self.old or occluder is not self.slots.occluder or not word.said.startswith("the "):
            self._fact("occluder", occluder, word)

    def _some_occluder(self, word: Word) -> None:
        if not self.old:
            return  # what it is to be is named as well
        if self.slots.occluder is None:
            raise EditRefused(f"{word.said!r}: nothing hides anybody")
        self.found.old("occluder", self.slots.occluder, word.said)

    def _number(self, number: Quantity | Shift, said: str) -> None:
        if self.whose is None and number.measure not in (Measure.TRIGGER, Measure.DISTANCE):
            if isinstance(number, Shift) and number.measure is Measure.SPEED and not number.more:
                self.found.wish("ego", EgoState.SLOW, said)
                return
            if number.measure is Measure.SPEED:
                ego = replace(number, measure=Measure.EGO_SPEED)
                self.found.number(Measure.EGO_SPEED, None if self.old else ego, said)
                return
            raise EditRefused(f"not understood of the ego: {said!r}; of it a speed can be said", words=(said,))
        if self.whose == 1:
            raise EditRefused(f"{said!r}: numbers can be set of the adversary alone")
        self.found.number(number.measure, None if self.old else number, said)
        behind = self.slots.position in _SEEN_AT[Where.BEHIND]
        if isinstance(number, Quantity) and number.measure is Measure.DISTANCE:
            if "behind" in said and not behind:
                self.found.place(Where.BEHIND, said)
            elif behind and ("ahead" in said or "front" in said):
                self.found.place(Where.AHEAD, said)


_ARE = ("are", "be", "should be", "could be", "were")
_TO_A_SIDE = (Action.SWERVE, Action.CHANGE_LANE, Action.U_TURN)
_SEEN_AT = {
    Where.AHEAD: (Position.AHEAD, Position.AHEAD_BESIDE),
    Where.BEHIND: (Position.BEHIND, Position.BEHIND_BESIDE),
    Where.BESIDE: (Position.BESIDE,),
}
_BESIDES_ACTS = (
    Mark.SHIFT,
    Mark.NUMBER,
    Mark.SIDE,
    Mark.SIDED,
    Mark.OTHER_SIDE,
    Mark.WHERE,
    Mark.OCCLUDER,
    Mark.PLACE,
    Mark.SITE,
    Mark.LIGHT,
    Mark.WEATHER,
    Mark.SURFACE,
    Mark.FAR,
    Mark.GROUP,
)
_TURNS = {Action.TURN_LEFT: Maneuver.LEFT_TURN, Action.TURN_RIGHT: Maneuver.RIGHT_TURN}


def _parsed(text: str) -> Slots | None:
    """Somebody as a whole sentence tells it; None if it is none."""
    parsed = parse(f"{text}.")
    if parsed is None or parsed.slots.others or parsed.quantities:
        return None
    one = parsed.slots
    return Slots(adversary=one.adversary, actions=one.actions, side=one.side, position=one.position)


def _called(slots: Slots) -> str:
    return str(slots.adversary).replace("-", " ")


_MODES = (
    Mark.SET,
    Mark.OLD,
    Mark.CHANGE,
    Mark.NEW,
    Mark.INSTEAD,
    Mark.DROP,
    Mark.ADD,
    Mark.ALSO,
    Mark.THEN,
    Mark.FIRST,
    Mark.BEFORE,
    Mark.AFTER,
    Mark.ON_THE_WAY,
    Mark.ONLY,
    Mark.JOINT,
    Mark.EGO,
    Mark.IT,
    Mark.OTHER,
    Mark.REPAIR,
)
_SIDES = (Mark.SIDED, Mark.SIDE)
_NONE = {Mark.MOVES: "ego", Mark.SEEN: "occluder"}
_FACTS = {
    Mark.CONTROL: "control",
    Mark.MANEUVER: "maneuver",
    Mark.STATE: "ego",
    Mark.LEADER: "leader",
    Mark.LANES: "lanes",
    Mark.TWO_WAY: "two_way",
    Mark.GROUP: "group",
    Mark.FAR: "distance",
    Mark.LIGHT: "light",
    Mark.WEATHER: "weather",
    Mark.SURFACE: "surface",
}
