"""The first half of step 3: the facts of a sentence, decided together with what the library has."""

from __future__ import annotations

import hashlib
import math
import re
from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import lru_cache

from chatscene.errors import NothingFits
from chatscene.interpret.nearest import likely_by_wording
from chatscene.interpret.retrieve import left_by_unread, retrieve, settle
from chatscene.interpret.trust import account_is_right, log_odds
from chatscene.interpret.wording import parts_of
from chatscene.library.compatibility import agree, compatibility
from chatscene.library.load import library_with
from chatscene.models.encoders.embedding import load_embedder
from chatscene.read.ego_speed import not_of_ego
from chatscene.read.reading import read
from chatscene.read.without_effect import without_effect
from chatscene.settings import RetrievalSettings
from chatscene.terms.acts import Action
from chatscene.terms.conclusions import base_of, concluded
from chatscene.terms.frame import LIKELY, About, Account, Beliefs, Frame, Mention, Note, certain
from chatscene.terms.scenario import Component, Measure, Scenario, Slots, Unused, Why
from chatscene.terms.situation import Situation
from chatscene.terms.slots import SLOTS, slots_of
from chatscene.terms.snippet import Snippet

TOGETHER = 0.6  # weight of a behavior's log-likelihood beside those of its acts
FAINTEST = 1e-3  # likelihood
_ORDER = {why: place for place, why in enumerate(Why)}


def scenario_of(text: str, settings: RetrievalSettings | None = None) -> Scenario:
    """Read a sentence without a language model, and decide its facts.

    Raises:
        SettingsError: The text is empty or too long.
    """
    settings = settings or RetrievalSettings()
    return decide(as_worded(read(text, settings), settings), settings)


def as_worded(frame: Frame, settings: RetrievalSettings) -> Frame:
    """The frame, and of a text that is to the word a wording of a user's own behavior, one that says what that does.

    Where it is done is what the text was read to say, as far as there is a place for it that the behavior can be
    joined with; what there is none for is a note.

    Args:
        frame: What the text says.
        settings: Which library, and what the user stated beside the text.
    """
    own = _worded(frame, _own_behaviors(frame, settings))
    if frame.reader or not own or {"actions", "adversary"} & set(frame.stated):
        return frame
    behavior, library = own[0], library_with(settings.library)
    read_so = concluded(frame.outright) if frame.whole else likeliest_together(frame, settings)
    kind = read_so.adversary
    if kind is None or kind.acts_as not in behavior.adversaries:
        kind = behavior.adversaries[0]
    slots = replace(read_so, **behavior.slots.said(), adversary=kind, others=())
    joint = compatibility(library)
    fits = joint.places(joint.behaviors.index(behavior))
    partners = (
        (Component.GEOMETRY, joint.geometries, fits.any(axis=1)),
        (Component.SPAWN, joint.spawns, fits.any(axis=0)),
    )
    there = {
        name: [getattr(s.slots, name) for s, fit in zip(snippets, fitting, strict=True) if fit]
        for component, snippets, fitting in partners
        for name in slots_of(component)
    }
    nowhere = {
        name: value
        for name, value in slots.said().items()
        if name not in frame.stated and not any(agree(value, one) for one in there.get(name, (None,)))
    }
    slots = replace(slots, **{name: getattr(Slots(), name) for name in nowhere})
    without = (
        Note(about=About.DIFFERENT, said=(name, "the words", str(value), behavior.id, "joins no such place"))
        for name, value in nowhere.items()
    )
    return replace(
        frame,
        outright=slots,
        beliefs=certain(slots, frame.beliefs),
        whole=True,
        sure=1.0,
        account=None,
        unused=(),
        mentions=(),
        notes=(*(note for note in frame.notes if note.about is About.MENDED), *without),
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class Weighed:
    """The two readings of a text of which not every phrase has its place, with how far each is trusted.

    Attributes:
        frame: What the text says.
        guessed: What patterns and classifier make of it.
        guess_is_right: The probability that every fact of that is right.
        account_is_right: The same of what was made out clause by clause; 0 where nothing was.
    """

    frame: Frame
    guessed: Slots
    guess_is_right: float
    account_is_right: float

    @property
    def right(self) -> float:
        """The probability that every fact of the likelier one is right."""
        return max(self.guess_is_right, self.account_is_right)


def decide(frame: Frame, settings: RetrievalSettings) -> Scenario:
    """Every reader's belief weighed slot by slot, then settled together with what the library has.

    Where every phrase has its place, what was read stands, and nothing else was said; so does what a language model
    read.
    """
    if frame.reader:
        return understood(frame, frame.outright, frame.notes)
    if frame.whole:
        return understood(_with_own_behaviors(frame, settings), concluded(frame.outright), frame.notes)
    return decided(weigh(frame, settings))


def weigh(frame: Frame, settings: RetrievalSettings) -> Weighed:
    """The two readings of a text of which not every phrase has its place."""
    frame = _with_own_behaviors(frame, settings)
    slots = likeliest_together(frame, settings)
    told = 0.0
    if frame.account is not None:
        unread = left_by_unread(understood(frame, concluded(frame.account.slots), ()))
        told = account_is_right(frame, slots) * unread
    return Weighed(
        frame=frame,
        guessed=slots,
        guess_is_right=trusted(understood(frame, slots, _still_open(frame, slots)), settings),
        account_is_right=told,
    )


def decided(weighed: Weighed) -> Scenario:
    """The scenario of the reading that stands; each slot that ends otherwise than the patterns read it is a note."""
    frame, slots = weighed.frame, weighed.guessed
    if frame.account is not None and weighed.account_is_right >= weighed.guess_is_right:
        return _told(frame, weighed.account_is_right)
    differ = [
        Note(about=About.DIFFERENT, said=(name, "the patterns", str(was), "the classifier", str(now)))
        for name in frame.beliefs.slots
        if (was := getattr(frame.outright, name)) is not None and (now := getattr(slots, name)) != was
    ]
    return understood(frame, slots, (*_still_open(frame, slots), *differ))


def likeliest_together(frame: Frame, settings: RetrievalSettings) -> Slots:
    """What a text is likeliest to say, by patterns and classifier, settled together with what the library has."""
    library = library_with(settings.library)
    told = frame.account.slots.actions if frame.account else ()
    slots = likeliest(frame.beliefs, {s.id: s.slots.actions for s in library.of(Component.BEHAVIOR)}, told)
    unheard = {name: getattr(frame.outright, name) for name in SLOTS if name not in frame.beliefs.slots}
    slots = settle(frame, replace(slots, **unheard), library)
    if any(one.measure is Measure.DISTANCE for one in frame.quantities):
        slots = replace(slots, distance=None)  # the number says it
    return concluded(replace(slots, **{name: getattr(frame.outright, name) for name in frame.stated}))


def _still_open(frame: Frame, slots: Slots) -> tuple[Note, ...]:
    """What the patterns were unsure about and is not known by now."""
    found = {About.WHO, About.STRANGER} if slots.adversary else set[About]()
    found |= {About.WHAT} if slots.actions else set[About]()
    return tuple(note for note in frame.notes if note.about not in found)


def trusted(scenario: Scenario, settings: RetrievalSettings) -> float:
    """How likely it is that what was read is right, as far as nothing contradicts it."""
    library, embedder = library_with(settings.library), load_embedder(settings.embedder)
    try:
        return retrieve(scenario, library, embedder, replace(settings, refuse_below=0.0)).confidence
    except NothingFits:
        return 0.0


def _told(frame: Frame, sure: float) -> Scenario:
    """The scenario of a text whose account stands: it says just this, and the words without a place are listed."""
    account = frame.account
    assert account is not None  # or it were not sure
    frame = replace(
        as_told(frame, account),
        outright=account.slots,
        beliefs=certain(account.slots, frame.beliefs),
        whole=True,
        sure=sure,
    )
    return understood(frame, concluded(account.slots), _still_open(frame, account.slots))


def as_told(frame: Frame, account: Account) -> Frame:
    """A frame with the numbers of its account, and without a use for the words that have no place in that."""
    unread = (Unused(said=word, why=Why.WORDS) for word in account.unread)
    unlike = (one for one in frame.unused if one.why not in (Why.WORDS, Why.SITE))
    aside = (one for one in frame.quantities if one.measure is Measure.ASIDE)  # of which accounts know nothing
    told = not_of_ego(account.quantities, frame.ego_speed)
    return replace(frame, quantities=(*told, *aside), unused=(*unlike, *unread))


def understood(frame: Frame, slots: Slots, notes: tuple[Note, ...]) -> Scenario:
    """The scenario of a sentence, once its facts are decided.

    Args:
        frame: What the sentence says.
        slots: The facts that were decided on.
        notes: What was unsure.
    """
    if Action.SWERVE not in slots.actions:  # who does not swerve does it to no side
        quantities = tuple(one for one in frame.quantities if one.measure is not Measure.ASIDE)
        frame = replace(frame, quantities=quantities)
    return Scenario(
        id=named(frame.text),
        text=frame.text,
        base=base_of(slots),
        parts=parts_of(frame, slots),
        slots=slots,
        notes=notes,
        unused=_unused(frame, slots),
        frame=frame,
        surroundings=frame.surroundings,
    )


def likeliest(beliefs: Beliefs, behaviors: Mapping[str, tuple[Action, ...]], told: tuple[Action, ...] = ()) -> Slots:
    """The likeliest value of each slot, and what is likeliest done.

    Acts come together, as in the behaviors that people speak of, and one by one: the likeliest are those of which both
    are likely, the acts as they were heard and the behaviors that do just these.

    Args:
        beliefs: How sure everything is.
        behaviors: What each behavior of the library does.
        told: What is done according to the account.
    """
    values = {name: beliefs.likeliest(name) for name in beliefs.slots}
    heard = frozenset(action for action in Action if beliefs.heard(action) >= LIKELY)
    together: dict[tuple[Action, ...], float] = {_in_order(heard, beliefs, behaviors): 0.0, told: 0.0}
    for name, p in beliefs.behaviors.items():
        if name in behaviors:
            together[behaviors[name]] = together.get(behaviors[name], 0.0) + p
    odds = {action: log_odds(beliefs.heard(action), FAINTEST) for action in Action}

    def likelihood(acts: tuple[Action, ...]) -> float:
        return sum(odds[act] for act in set(acts)) + TOGETHER * math.log(together[acts] + FAINTEST)

    return Slots(**values, actions=max(together, key=likelihood))


def _in_order(
    acts: frozenset[Action], beliefs: Beliefs, behaviors: Mapping[str, tuple[Action, ...]]
) -> tuple[Action, ...]:
    """Acts of which nobody said the order, in that of the likeliest behavior that does them all."""
    likely = {name: p for name, p in beliefs.behaviors.items() if name in behaviors and acts <= set(behaviors[name])}
    order = behaviors[max(likely, key=lambda name: likely[name])] if likely else tuple(Action)
    return tuple(action for action in dict.fromkeys(order) if action in acts)


def _with_own_behaviors(frame: Frame, settings: RetrievalSettings) -> Frame:
    """How likely those behaviors are that the classifier has not heard of, such as a user's own, by their wordings."""
    unknown = _own_behaviors(frame, settings)
    if not unknown:
        return frame
    if own := _worded(frame, unknown):
        beliefs = replace(frame.beliefs, behaviors=dict.fromkeys(frame.beliefs.behaviors, 0.0))
        return replace(frame, beliefs=replace(beliefs, others={s.id: float(s in own) for s in unknown}))
    said = frame.clauses.adversary or frame.clauses.whole
    others = likely_by_wording(said, unknown, load_embedder(settings.embedder))
    return replace(frame, beliefs=replace(frame.beliefs, others=others))


def _own_behaviors(frame: Frame, settings: RetrievalSettings) -> tuple[Snippet, ...]:
    """The behaviors that the classifier has not heard of."""
    behaviors = library_with(settings.library).of(Component.BEHAVIOR)
    return tuple(s for s in behaviors if s.id not in frame.beliefs.behaviors)


def _worded(frame: Frame, snippets: tuple[Snippet, ...]) -> tuple[Snippet, ...]:
    """Those of which the text is a wording, to the word."""
    said = _words(frame.text)
    return tuple(s for s in snippets if any(_words(text) == said for text in (s.description, *s.rephrasings)))


@lru_cache(maxsize=65536)
def _words(text: str) -> str:
    """A text without case and punctuation."""
    return " ".join(re.findall(r"\w+", text.casefold()))


def _unused(frame: Frame, slots: Slots) -> tuple[Unused, ...]:
    """What of a text is in no slot and no quantity, and the road users beside those that the slots have."""
    if any(one.why is Why.LANGUAGE for one in frame.unused):
        return frame.unused
    beside = (Unused(said=one.said, why=Why.ROAD_USER) for one in _others(frame.mentions, slots))
    told = (_without_effect(one, frame.text) for one in frame.unused if slots.site is None or one.why is not Why.SITE)
    return tuple(sorted(dict.fromkeys((*told, *beside)), key=lambda one: _ORDER[one.why]))


def _without_effect(one: Unused, text: str) -> Unused:
    """The same, listed for what it is if all its words are known to be without effect."""
    at = text.lower().find(one.said)
    if one.why not in (Why.WORDS, Why.NUMBER) or at < 0:
        return one
    words = re.finditer(r"[^\W_]+(?:['.:][^\W_]+)*", text[: at + len(one.said)])
    spans = [word.span() for word in words if word.start() >= at]
    return replace(one, why=Why.BESIDES) if spans and all(without_effect(text, span) for span in spans) else one


def _others(mentions: tuple[Mention, ...], slots: Slots) -> list[Mention]:
    """The road users that are spoken of beside the adversary and what the slots have: "a cyclist", "another car"."""
    found: list[Mention] = []
    read = [other.adversary for other in slots.others]
    seen = False  # of the adversary
    for one in mentions:
        if (one.hides and (slots.occluder is not None or slots.blocker)) or (one.leads and slots.leader):
            continue
        own = slots.adversary in one.kinds or slots.adversary is None
        if one.said and ((not own) or (seen and one.another)):
            known = next((kind for kind in read if kind in one.kinds), None)
            if known is None:
                found.append(one)
            else:
                read.remove(known)
        seen = seen or own
    return found


STATED = "situation"
"""What the scenario of a situation is called that was read in no text."""


def scenario_id(situation: Situation) -> str:
    """What the scenario of a situation is called: after the text that it was read in, or what it is."""
    return named(situation.about) if situation.evidence.quoted else STATED


def named(text: str) -> str:
    """What the scenario of a text is called: readable, and the same whenever it is read."""
    stem = "-".join(re.findall(r"[a-z0-9]+", text.lower())[:4]) or "scenario"
    return f"{stem[:40]}-{hashlib.blake2b(text.encode(), digest_size=3).hexdigest()}"
