"""What a text says, before anything of the library is chosen for it: words, facts, and how sure each fact is.

Paper: section 3.3, step ii. A reader makes a frame once; whoever interprets it is handed the value.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping
from dataclasses import dataclass, field, replace
from enum import StrEnum
from typing import Any

from chatscene.terms.actors import AdversaryKind
from chatscene.terms.acts import Action
from chatscene.terms.scenario import Maneuver, Quantity, Shift, Slots, Unused
from chatscene.terms.slots import SLOTS
from chatscene.terms.surroundings import Surroundings


@dataclass(frozen=True, slots=True, kw_only=True)
class Clauses:
    """A text, sorted by whom it speaks of.

    Attributes:
        whole: All of it, mended, without what the ego then has to do.
        ego: What is said of the ego.
        adversary: What is said of the adversary.
    """

    whole: str = ""
    ego: str = ""
    adversary: str = ""


_FAINT = 1e-3  # likelihood


def _alike(name: str, value: object) -> tuple[object, ...]:
    """A value, and those that mean the same: who is said to drive straight on may be said to drive."""
    return (Maneuver.STRAIGHT, None) if name == "maneuver" and value in (Maneuver.STRAIGHT, None) else (value,)


@dataclass(frozen=True, slots=True, kw_only=True)
class Beliefs:
    """How sure a reader is of what a text says. What it was not asked for is absent.

    Attributes:
        slots: For each slot with one value, the probability of each value; ``None`` is that it was not said.
        actions: For each action, the probability that the adversary does it.
        behaviors: For each behavior that the reader knows, the probability that it is meant.
        others: For each further behavior, such as a user's own, how likely its wordings make it.
        in_scope: The probability that it is a driving scenario, of the kind that the library has.
    """

    slots: Mapping[str, Mapping[object, float]] = field(default_factory=dict[str, Mapping[object, float]])
    actions: Mapping[Action, float] = field(default_factory=dict[Action, float])
    behaviors: Mapping[str, float] = field(default_factory=dict[str, float])
    others: Mapping[str, float] = field(default_factory=dict[str, float])
    in_scope: float = 1.0

    def likeliest(self, slot: str) -> Any:
        """The likeliest value of a slot that has one; None if it was likely not said, or nobody was asked."""
        classes = self.slots.get(slot, {})
        return max(classes, key=lambda value: classes[value], default=None)

    def of(self, slot: str, value: object) -> float:
        """The probability that a slot has a value."""
        return self.slots.get(slot, {}).get(value, 0.0)

    def meant(self, behavior: str) -> float:
        """How likely a behavior is to be meant."""
        return self.behaviors.get(behavior, self.others.get(behavior, 0.0))

    def heard(self, action: Action) -> float:
        """The probability that the adversary does something."""
        return self.actions.get(action, 0.0)

    def facts(self, slots: Slots) -> float:
        """Log-likelihood of the facts of a reading, but for what is done: what each slot has, or that it has none.

        Lanes, groups and distances are left out: few of those who labelled texts wrote them down.
        """
        return sum(
            math.log(sum(likely.get(value, 0.0) for value in _alike(name, getattr(slots, name))) + _FAINT)
            for name, likely in self.slots.items()
            if SLOTS[name].labelled
        )

    def acts(self, actions: Collection[Action]) -> float:
        """Log-likelihood that these are done and no others."""
        return sum(math.log((p if action in actions else 1.0 - p) + _FAINT) for action, p in self.actions.items())


def certain(slots: Slots, beliefs: Beliefs | None = None) -> Beliefs:
    """Beliefs in which facts are sure: each value and each action has probability one or zero.

    Args:
        slots: The facts.
        beliefs: How sure the rest is, which behavior is meant and whether any is.
    """
    single = {name: {getattr(slots, name): 1.0} for name in SLOTS}
    return replace(
        beliefs or Beliefs(), slots=single, actions={action: float(action in slots.actions) for action in Action}
    )


LIKELY = 0.5  # an action is said if it is as likely as this


class About(StrEnum):
    """What a reader was unsure about; the values are its words for it."""

    MENDED = "read {} as {}"
    WHO = "who the adversary is was not said"
    STRANGER = "who the adversary is was not said; no scene has such a road user: {}"
    WHAT = "what the adversary does was not understood"
    SIDE = "to which side the ego changes lanes was not said; the left is assumed"
    FOREIGN = "no scene has this: {}"
    DIFFERENT = "{}: {} read {}, {} {}"
    READER = "read by {}"
    OFFLINE = "read offline: {}"
    STATED = "stated by the user: {}"
    TAKEN = "the user took reading {}: {}"


@dataclass(frozen=True, slots=True, kw_only=True)
class Note:
    """Something that a reader was unsure about.

    Attributes:
        about: The kind of doubt.
        said: What stands in the places of its words.
    """

    about: About
    said: tuple[str, ...] = ()

    def __str__(self) -> str:
        """The note in words for the user."""
        return self.about.format(*self.said)


@dataclass(frozen=True, slots=True, kw_only=True)
class Mention:
    """A road user that a text names.

    Attributes:
        said: The words, with the article; empty for one that is spoken of as known, such as "the cyclist".
        kinds: What it may be.
        another: Whether the words part it from one of the same kind.
        hides: Whether it is named as what hides somebody.
        leads: Whether it is named as what drives slowly ahead.
    """

    said: str
    kinds: frozenset[AdversaryKind]
    another: bool = False
    hides: bool = False
    leads: bool = False


@dataclass(frozen=True, slots=True, kw_only=True)
class Word:
    """A word of a text, with what became of it; one of which neither a fact nor a reason is known was not read.

    Attributes:
        text: As it was written.
        start: Where it begins.
        end: Where it ends.
        fact: The fact that it gave: a slot, ``light``, ``weather`` or ``surface``, a measure, ``the ego``, ``contact``.
        besides: Why it is without effect, if that is known.
    """

    text: str
    start: int
    end: int
    fact: str = ""
    besides: str = ""

    @property
    def unread(self) -> bool:
        """Whether it was not read."""
        return not self.fact and not self.besides

    def as_dict(self) -> dict[str, Any]:
        """For a script: with its fact, with why it is without effect, or as not read."""
        became = {"fact": self.fact} if self.fact else {"besides": self.besides} if self.besides else {"unread": True}
        return {"text": self.text, "start": self.start, "end": self.end, **became}


@dataclass(frozen=True, slots=True, kw_only=True)
class Account:
    """What was made out of an account of a conflict, read clause by clause.

    Attributes:
        slots: The facts.
        quantities: The numbers said of the adversary.
        unread: Words that have no place, in the text's order.
        touched: Whether a contact with the ego is told, by which the adversary is known.
    """

    slots: Slots
    quantities: tuple[Quantity, ...] = ()
    unread: tuple[str, ...] = ()
    touched: bool = False


@dataclass(frozen=True, slots=True, kw_only=True)
class Frame:
    """What a text says.

    Attributes:
        text: The text as it was written, printable and with single spaces.
        canonical: The text in the one form in which it is read, without what it says of the surroundings.
        told: `canonical`, mended and put into the words that patterns know.
        clauses: `told`, sorted by whom it speaks of.
        outright: The facts that words say outright.
        beliefs: How sure every fact is.
        quantities: The numbers that can be set.
        ego_speed: How fast the ego drives, which no snippet says and a situation does.
        shifts: The numbers that are other than they were, as edits say it, in their order.
        unused: What is in no slot and no quantity, whatever the slots are.
        mentions: The road users that it names.
        notes: What was unsure.
        reader: The language model that read it; empty for our own reader.
        whole: Whether nothing is guessed: then this is what was said, and nothing beyond it.
        sure: The probability that this is right, where nothing is guessed.
        account: What was made out clause by clause, of a text of which not every phrase has its place.
        surroundings: Light, weather and the state of the road.
        stated: The slots that the user filled beside the text, which are sure.
    """

    text: str = ""
    canonical: str = ""
    told: str = ""
    clauses: Clauses = field(default_factory=Clauses)
    outright: Slots = field(default_factory=Slots)
    beliefs: Beliefs = field(default_factory=Beliefs)
    quantities: tuple[Quantity, ...] = ()
    ego_speed: Quantity | None = None
    shifts: tuple[Shift, ...] = ()
    unused: tuple[Unused, ...] = ()
    mentions: tuple[Mention, ...] = ()
    notes: tuple[Note, ...] = ()
    reader: str = ""
    whole: bool = False
    sure: float = 0.0
    account: Account | None = None
    surroundings: Surroundings = field(default_factory=Surroundings)
    stated: tuple[str, ...] = ()
