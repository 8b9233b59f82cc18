"""What was made out so far of an account: the parties, who touched whom, and what the ego does.

The state of a reader on its way through a text, clause by clause (`chatscene.read.account`).
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from typing import Any

from chatscene.read.account_rules import Rule
from chatscene.read.phrases import Where
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.acts import Action
from chatscene.terms.scenario import EgoState, Occluder, Quantity, Side

NAMED_NEXT = -1
"""In place of a party's number: of whoever is named next."""


@dataclass(eq=False)
class Party:
    """A road user as far as it was made out.

    Attributes:
        kind: What it is.
        noun: The word that it was named with.
        acts: What it does, in the order of telling, each once.
        where: All that is said of where it is.
        side: On which side of the ego.
        heading: Where it drives to, in degrees clockwise from north.
        occluder: What hides it.
        group: Whether it is several.
        quantities: The numbers said of it.
        aside: Whether it is only met on the way: waited for, driven around.
        other: Whether it is called "the other".
        drives: Whether that is said, as by "drives into us".
        wayward: Whether it goes on where it ought to wait: "failed to yield".
    """

    kind: AdversaryKind
    noun: str = ""
    acts: list[Action] = field(default_factory=list[Action])
    where: set[Where] = field(default_factory=set[Where])
    side: Side | None = None
    heading: int | None = None
    occluder: Occluder | None = None
    group: bool = False
    quantities: list[Quantity] = field(default_factory=list[Quantity])
    aside: bool = False
    other: bool = False
    drives: bool = False
    wayward: bool = False

    def does(self, action: Action) -> None:
        """Add an act, unless it was told before."""
        if action not in self.acts:
            self.acts.append(action)


@dataclass
class Contact:
    """Somebody and the ego touch each other.

    Attributes:
        party: The number of whoever it is.
        part: The words for where on the ego; empty if that is not said.
        ego_hits: Whether it is the ego that drives into the other.
        sentence: The number of the sentence that tells it.
    """

    party: int
    part: str
    ego_hits: bool = False
    sentence: int = 0


@dataclass
class AtPedals:
    """What the ego does at the pedals, where it is told.

    Attributes:
        state: What it does.
        after: Whether somebody else is there by then, so that it may be an answer.
        because_of: The number of the party that it waits for, or `NAMED_NEXT`; None if that is not said.
    """

    state: EgoState
    after: bool
    because_of: int | None = None


@dataclass
class Telling:
    """What was made out so far, and what is expected next.

    Attributes:
        parties: All who were named, in that order.
        subject: The number of the party that the next words are of; None for the ego.
        main: The subject of the clause.
        opens: Whether the reader is at the beginning of a clause.
        sentence: The number of the sentence.
        denied: Whether what comes next is said not to be.
        facts: Slots of the ego and the place.
        heading: The ego's first, in degrees clockwise from north.
        own_lane: On which side the ego's lane is, of several.
        turning: Whether the ego turns to a side that the compass has to tell.
        reverses: Whether the ego does.
        pedals: What the ego does at the pedals, in the order of telling.
        contacts: Who touched the ego, in the order of telling.
        awaited: The words for where on the ego whoever is named next touches it; None if nobody is awaited.
        hits: Whether the ego touches whoever is named next.
        meets: Whether whoever is named next is only met.
        passes: Whether it is driven around as well.
        follows: Whether whoever is named next is ahead of the ego, which comes up to it or drives behind it.
        passed: The number of the last one that was.
        pending: Rules on where whoever is named next is.
        deeds: Acts that were told as nouns, of whoever is named next.
        bare: Whether an act of nobody in particular was told.
        struck_behind: Whether the ego was, by whomever.
        foreign: Whether something happens that no act says: a door, an attack.
        unread: Words that have no place.
    """

    parties: list[Party] = field(default_factory=list[Party])
    subject: int | None = None
    main: int | None = None
    opens: bool = True
    sentence: int = 0
    denied: bool = False
    facts: dict[str, Any] = field(default_factory=dict[str, Any])
    heading: int | None = None
    own_lane: Side | None = None
    turning: bool = False
    reverses: bool = False
    pedals: list[AtPedals] = field(default_factory=list[AtPedals])
    contacts: list[Contact] = field(default_factory=list[Contact])
    awaited: str | None = None
    hits: bool = False
    meets: bool = False
    passes: bool = False
    follows: bool = False
    passed: int | None = None
    pending: list[tuple[Rule, re.Match[str]]] = field(default_factory=list[tuple[Rule, re.Match[str]]])
    deeds: list[Action] = field(default_factory=list[Action])
    bare: bool = False
    struck_behind: bool = False
    foreign: bool = False
    unread: list[str] = field(default_factory=list[str])

    @property
    def party(self) -> Party | None:
        """Whom the next words are of; None for the ego."""
        return None if self.subject is None else self.parties[self.subject]

    @property
    def somebody_is_there(self) -> bool:
        """Whether anybody was named who is not only met."""
        return any(not one.aside for one in self.parties)

    def of_ego(self) -> None:
        """What follows is told of the ego."""
        self.main = self.subject = None

    def touched_before(self, party: Party) -> bool:
        """Whether a party touched the ego in an earlier sentence: what it does now is no part of the conflict."""
        of_it = [one for one in self.contacts if self.parties[one.party] is party]
        return bool(of_it) and of_it[0].sentence < self.sentence
