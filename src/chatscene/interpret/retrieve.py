"""Step 3 of 9: sub-descriptions and slots to the best compatible triple of snippets, with the reasons.

Paper: section 3.3, step iii. The reference takes the nearest snippet per component, each on its own; here the three
are chosen together, so that what cannot be joined cannot be chosen, and typed facts weigh beside wording, because
an embedding hardly tells left from right (decisions 0006 and 0017).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chatscene.errors import NothingFits
from chatscene.interpret.joint_choice import highest
from chatscene.interpret.trust import FEW, log_odds, with_stated_sure
from chatscene.interpret.wording import parts_of
from chatscene.interpret.wording_index import WordingIndex
from chatscene.library.bind import distances, out_of_reach, settable
from chatscene.library.compatibility import compatibility, incompatibility
from chatscene.library.load import Library
from chatscene.models.encoders.embedding import Embedder
from chatscene.settings import RetrievalSettings
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.acts import BRINGS, Action, reordered
from chatscene.terms.acts import TURNS as TURNING
from chatscene.terms.conclusions import CURVES, JUNCTIONS, LANE_CHANGES, TURNS, concluded
from chatscene.terms.frame import About, Beliefs, Frame, Note
from chatscene.terms.scenario import (
    REFUSED,
    Component,
    Distance,
    Maneuver,
    Place,
    Position,
    Scenario,
    Side,
    Site,
    Slots,
    SubDescriptions,
    Why,
    grouped,
    includes,
)
from chatscene.terms.slots import SLOTS, slots_of
from chatscene.terms.snippet import Match, Retrieval, RuledOut, Snippet, Tried

CONFLICT = 5.0  # what one contradicted action or quantity costs, in nats
UNASKED = 0.5  # likelihood of a thing nobody asked for: an occluder, a leader, a control, a group …
UNASKED_SURELY = 0.02  # … where every phrase of the text has its place, so that it was not said
UNASKED_VALUE = 0.8  # … and of a value nobody asked for, such as a side
UNLIKELY = 1e-3  # least likelihood of a fact, so that one surprise does not decide everything
UNREAD_ACTOR = 0.5  # confidence left where another road user was not read: of such texts of others, 5 of 12 were right
CONTRADICTED = 0.2  # confidence left by a fact that the triple contradicts: its program would not mean what was said
# Log-odds that every fact read by patterns and classifier is right: fitted on texts that the classifier had not seen,
# by several people, each of whom weighs the same (benchmarks/confidence.py).
CONFIDENCE = {
    "base": 0.64, "scope": 0.10, "beyond": -0.42, "outright": 0.18, "wording": 0.42, "meant": 0.20, "same acts": 0.67,
    "same kind": 0.16, "same place": 0.33, "no account": 0.71, "touched": 0.12, "unused": -0.61, "words": -0.40,
    "facts": 0.83, "acts": 0.31,
}  # fmt: skip
ENOUGH = 4  # facts that words say outright; more make nothing surer
FAR_WORDING, NEAR_WORDING = 0.2, 0.7  # cosines of a description below and above which it says nothing more
UNSAID = 0.5  # agreement of a fact that the snippet leaves open, or does less exactly than it was said …
OPEN = 0.02  # … and of a side or a distance: who leaves that open starts anywhere
NARROWER = 0.85  # agreement of a place that is one kind of what was said, of a distance that can be told
CROSSROADS = 0.97  # … and of a crossroads, which is what a junction mostly is
AGREEMENT = 0.5  # weight of the actions that a behavior shares with what was read
PARAMETER = 0.01  # what a parameter costs: of equals, the simpler one
PLACE_WORDING = 0.1  # weight of wording for geometry and spawn: it decides among equals
MEANT = 1.4  # weight of a behavior's log-likelihood beside the words that it shares, fitted by likelihood on sentences
# of behaviors of which the classifier had seen none (decision 0017)
FAINTEST = 1e-4  # least likelihood of a behavior

SURE, POSSIBLE = 0.9, 0.05  # a fact as likely as this stands; one as likely as this may be what was meant
AS_A_WHOLE = 0.3  # a behavior as likely as this is meant, with all that it does
HEARD = 0.25  # an action less likely than this was not heard

IN_LANE = (Position.AHEAD, Position.BEHIND)
OFFENCES = (Action.RUN_LIGHT,)  # nobody is shown to commit them who is not said to
NO_SIDE = "neither"  # of a spawn in the ego's lane, which contradicts a side; one that leaves it open has either
NOT_RIGHT = "oncoming traffic, which keeps left of us"  # of a spawn there, which contradicts the right side

Scores = NDArray[np.float64]


def retrieve(
    scenario: Scenario,
    library: Library,
    embedder: Embedder,
    settings: RetrievalSettings | None = None,
    tried: Sequence[Tried] = (),
    composed: Snippet | None = None,
) -> Retrieval:
    """Choose the compatible triple that serves a scenario best.

    Args:
        scenario: What was understood.
        library: What can be chosen.
        embedder: Who says how near the behavior's description is, which the confidence asks for.
        settings: How many candidates are named, and the confidence below which nothing is chosen.
        tried: Choices that did not show what was said; they are not made again.
        composed: The behavior, where none of the library's does just what was said.

    Raises:
        NothingFits: No triple serves it well enough; the message names the nearest.
    """
    settings = settings or RetrievalSettings()
    frame = scenario.frame or Frame(outright=scenario.slots)
    asked = _Asked(frame, scenario.slots, scenario.parts)
    shelves = library if composed is None else library.with_behavior(composed)
    ranked = _ranked(asked, shelves)
    triple = _best(ranked, shelves, scenario.slots.adversary, tried)
    confidence = _confidence(scenario, frame, triple, library, embedder)
    if confidence < settings.refuse_below:
        reasons = _reasons(scenario, frame, triple)
        known = frame.sure >= settings.refuse_below or any(match.conflicts for match in triple) or confidence == 0.0
        what = "nothing" if known else "it is not sure enough that anything"
        raise NothingFits(
            f"{what} in the library does this (confidence {confidence:.0%}): {'; '.join(reasons)}",
            reasons=reasons,
            confidence=confidence,
            nearest={match.snippet.id: match.snippet.description for match in triple},
        )
    return Retrieval(
        behavior=triple[0],
        geometry=triple[1],
        spawn=triple[2],
        adversary=_adversary(scenario, triple),
        confidence=confidence,
        candidates={component: ranking.best(settings.candidates) for component, ranking in ranked.items()},
        ruled_out=_ruled_out(ranked, triple, scenario.slots.adversary, tried),
        tried=tuple(tried),
    )


def settle(frame: Frame, slots: Slots, library: Library) -> Slots:
    """What was read, made whole with the library in mind: facts that only together are likely are read together.

    A fact that the best triple contradicts is taken to be what the triple does, if words say that outright or if it may
    as well be. What follows from the facts is added before and after.

    Args:
        frame: What the text says.
        slots: What was read, fact by fact.
        library: What can be chosen.
    """
    slots = concluded(slots)
    found = _likeliest(frame, slots, library)
    if found is None:
        return concluded(slots)
    kind, triple = found
    slots, beliefs, outright = replace(slots, adversary=kind), frame.beliefs, frame.outright
    for component, snippet in zip(Component, triple, strict=True):
        for name in slots_of(component):
            said, value = getattr(slots, name), getattr(snippet.slots, name)
            if name == "actions":
                known = beliefs.behaviors.get(snippet.id, 1.0)  # the classifier has not heard of a user's own
                sure = tuple(a for a in said if a in outright.actions or beliefs.heard(a) >= HEARD)
                slots = replace(slots, actions=value if known >= AS_A_WHOLE or not said else sure)
            elif name == "side" and value is None and outright.side is None:
                slots = replace(slots, side=None)  # no word says it, and where the triple starts there is none
            elif said is not None and _agreement(said, _does(snippet, name)) == 0.0:
                unsure = beliefs.of(name, said) < SURE
                read = getattr(outright, name) == value  # then words and library are two against one
                if read or (unsure and beliefs.of(name, value) >= POSSIBLE):
                    slots = replace(slots, **{name: value})
    return concluded(slots)


def _likeliest(frame: Frame, slots: Slots, library: Library) -> tuple[AdversaryKind | None, tuple[Snippet, ...]] | None:
    """The likeliest triple, for every kind of adversary that it may be, with that kind; None if nobody can act any."""
    joint = compatibility(library)
    heard = replace(slots, actions=())  # what is done is part of the doubt
    ranked = _ranked(_Asked(frame, heard, parts_of(frame, frame.outright)), library)
    scores = [ranked[component].score for component in Component]
    who = slots.adversary
    kinds = [kind for kind in AdversaryKind if kind is who or frame.beliefs.of("adversary", kind) >= POSSIBLE]
    best, found = -math.inf, None
    for kind in kinds if who else [None]:
        at = highest(joint, scores, joint.able(kind))
        if at is not None:
            chosen = [(ranked[component], i) for component, i in zip(Component, at, strict=True)]
            doubt = math.log(frame.beliefs.of("adversary", kind) + UNLIKELY)
            score = doubt + sum(float(ranking.score[i]) for ranking, i in chosen)
            if score > best:
                best, found = score, (kind, tuple(ranking.snippets[i] for ranking, i in chosen))
    return found


def _best(
    ranked: dict[Component, _Ranking], library: Library, kind: AdversaryKind | None, tried: Sequence[Tried]
) -> tuple[Match, ...]:
    """The compatible triple that scores highest of those that were not tried.

    It contradicts nothing that was read, if there is such a one: any other would be refused.

    Raises:
        NothingFits: There is none at all.
    """
    joint = compatibility(library)
    allowed = joint.able(kind)
    scores = [ranked[component].score for component in Component]
    free = tuple(ok & (ranked[component].conflicts == 0) for ok, component in zip(allowed, Component, strict=True))
    found = highest(joint, scores, free, tried) or highest(joint, scores, allowed, tried)
    if found is None:
        raise NothingFits(f"nothing {'else ' if tried else ''}in the library has a {kind} as adversary")
    return tuple(ranked[component].match(i) for component, i in zip(Component, found, strict=True))


# One component


@dataclass(frozen=True, slots=True)
class _Asked:
    """What snippets are ranked by: what a text says, the facts as far as they are decided, a text per component."""

    frame: Frame
    slots: Slots
    parts: SubDescriptions


@dataclass(frozen=True, slots=True)
class _Ranking:
    """Every snippet of a component against what is asked for; a row each."""

    asked: _Asked
    component: Component
    snippets: tuple[Snippet, ...]
    similarity: Scores
    texts: tuple[str, ...]
    agreement: Scores
    conflicts: Scores
    score: Scores

    def match(self, i: int) -> Match:
        snippet = self.snippets[i]
        return Match(
            snippet=snippet,
            similarity=float(self.similarity[i]),
            agreement=float(self.agreement[i]),
            score=float(self.score[i]),
            nearest=self.texts[i],
            conflicts=tuple(_conflicts(self.asked, snippet, self.component)),
        )

    def best(self, count: int) -> tuple[Match, ...]:
        return tuple(self.match(int(i)) for i in np.argsort(-self.score, kind="stable")[:count])


def _ranked(asked: _Asked, library: Library) -> dict[Component, _Ranking]:
    return {component: _rank(asked, shelf) for component, shelf in _shelves(library).items()}


def _rank(asked: _Asked, shelf: _Shelf) -> _Ranking:
    frame, slots = asked.frame, asked.slots
    similarity, texts = shelf.words.search(asked.parts[shelf.component])
    agreement, conflicts = shelf.facts(slots, frame.beliefs)
    if shelf.component is Component.BEHAVIOR:
        p = shelf.said(frame.beliefs, slots.actions) if frame.whole else shelf.meant(frame.beliefs)
        if frame.whole:
            conflicts = conflicts + shelf.of_each(lambda does: reordered(does, slots.actions))
        score = similarity + MEANT * np.log(p + FAINTEST) + AGREEMENT * agreement - CONFLICT * conflicts
    else:
        score = PLACE_WORDING * similarity - PARAMETER * shelf.parameters
        score = score + shelf.likelihood(_alternatives(slots, frame.beliefs), sure=frame.whole)
    if frame.quantities:
        score = score - CONFLICT * np.array(
            [out_of_reach(s, frame.quantities, slots.adversary) for s in shelf.snippets]
        )
    return _Ranking(asked, shelf.component, shelf.snippets, similarity, texts, agreement, conflicts, score)


class _Shelf:
    """The snippets of one component, ready to be searched: words, and facts as codes."""

    def __init__(self, component: Component, snippets: tuple[Snippet, ...]) -> None:
        self.component = component
        self.snippets = snippets
        # Geometry and spawn are facts put into the fixed words of descriptions.
        said = [s.rephrasings if component is Component.BEHAVIOR else () for s in snippets]
        texts = [(s.description, *more) for s, more in zip(snippets, said, strict=True)]
        self.words = WordingIndex(
            tuple(text for each in texts for text in each), tuple(i for i, each in enumerate(texts) for _ in each)
        )
        self.parameters = np.array([len(snippet.parameters) for snippet in snippets], float)
        self.does = list(dict.fromkeys(s.slots.actions for s in snippets))  # many do the same
        number = {does: i for i, does in enumerate(self.does)}
        self.doing = np.array([number[s.slots.actions] for s in snippets], np.intp)
        self.actions = np.array([[action in does for action in Action] for does in self.does], float)[self.doing]
        self.values: dict[str, list[Any]] = {}
        self.codes: dict[str, NDArray[np.intp]] = {}
        for name in sorted(name for name, slot in SLOTS.items() if slot.of):
            values = list(dict.fromkeys(_does(s, name) for s in snippets))
            self.values[name] = values
            self.codes[name] = np.array([values.index(_does(s, name)) for s in snippets])

    def of_each(self, told: Callable[[tuple[Action, ...]], float]) -> Scores:
        """(N,) a number for what each snippet does."""
        return np.array([told(does) for does in self.does], float)[self.doing]

    def meant(self, beliefs: Beliefs) -> Scores:
        """(N,) how likely each behavior is to be meant.

        Where the likeliest does the same in haste, and no haste was heard, its likelihood is the calmer's too: who
        "steps out and freezes" is not said to sprint.
        """
        p = self._told(beliefs)
        heard = self.actions @ np.array([beliefs.heard(action) >= HEARD for action in Action])
        best = int(np.argmax(p))
        hasty = frozenset(self.does[self.doing[best]])
        calmer = self.of_each(lambda does: _hastier(hasty, frozenset(does)))
        return p + p[best] * calmer * (heard == heard[best])

    def said(self, beliefs: Beliefs, actions: tuple[Action, ...]) -> Scores:
        """(N,) how likely each behavior is to be meant where words say all that is done.

        Whoever does just that is meant wherever one who does more was heard; what more is done was not asked for. Where
        there is one who does just that, whoever leaves out what was said is not meant.
        """
        more = [_more(does, actions) for does in self.does]
        p = self._told(beliefs)
        less = FAINTEST if frozenset() in more else 1.0
        share = np.array([less if extra is None else UNASKED ** len(extra) for extra in more])
        beyond, just = (np.array([test(extra) for extra in more])[self.doing] for test in (bool, _nothing))
        return p * share[self.doing] + sum(p[beyond].tolist()) * just

    def _told(self, beliefs: Beliefs) -> Scores:
        return np.array([beliefs.meant(s.id) for s in self.snippets])

    def likelihood(self, maybe: Alternatives, *, sure: bool) -> Scores:
        """(N,) log-likelihood that the facts of each snippet are what was said."""
        total = np.zeros(len(self.snippets))
        for name in slots_of(self.component):
            table = [
                sum(p * (_agreement(wanted, value) if wanted is not None else _free(name, value, sure=sure))
                    for wanted, p in maybe[name])
                for value in self.values[name]
            ]  # fmt: skip
            total += np.log(np.array(table) + UNLIKELY)[self.codes[name]]
        return total

    def facts(self, said: Slots, beliefs: Beliefs) -> tuple[Scores, Scores]:
        """(N,) mean agreement with what was said, and facts contradicted by what was said or heard."""
        parts: list[Scores] = []
        conflicts = np.zeros(len(self.snippets))
        for name in slots_of(self.component):
            if name == "actions":
                against = self._opposes(said.actions, beliefs)
                if said.actions:
                    share = self._acted(said.actions)
                    parts.append(share)
                    against |= (share == 0.0) & self.actions.any(axis=1)
                conflicts += against
                continue
            wanted, codes = getattr(said, name), self.codes[name]
            if wanted is None:
                continue
            table = np.array([_agreement(wanted, value) for value in self.values[name]])
            conflicts += (table == 0.0)[codes]
            if self.component is not Component.BEHAVIOR:
                parts.append(table[codes])
        agreement = np.mean(parts, axis=0) if parts else np.ones(len(self.snippets))
        return agreement, conflicts

    def _opposes(self, said: tuple[Action, ...], beliefs: Beliefs) -> NDArray[np.bool_]:
        """(N,) whether a behavior does an action that was not said, and whose opposite was, or that breaks the law.

        Where nothing is settled yet, what the classifier hears was said, and the likeliest behavior is heard as a
        whole: who "brakes, then moves off" need not name the throttle.
        """
        heard = said or tuple(action for action in Action if beliefs.heard(action) >= HEARD)
        unheard = [action not in heard and (action.opposite in heard or action in OFFENCES) for action in Action]
        against = self.actions @ np.array(unheard, float) > 0
        if not said:
            against[np.argmax([beliefs.behaviors.get(snippet.id, 0.0) for snippet in self.snippets])] = False
        return against

    def _acted(self, said: tuple[Action, ...]) -> Scores:
        wanted = np.array([action in said for action in Action], float)
        both = self.actions @ wanted
        either = self.actions.sum(axis=1) + wanted.sum() - both
        return (2 * both / wanted.sum() + both / np.maximum(either, 1)) / 3


def does_just(behavior: Snippet, said: tuple[Action, ...], unsaid: frozenset[Action]) -> bool:
    """Whether a behavior does what was said, in order, and else only what need not be said."""
    more = _more(behavior.slots.actions, said)
    return more is not None and more <= unsaid


def does_all(behavior: Snippet, said: tuple[Action, ...]) -> bool:
    """Whether a behavior does what was said, in order, whatever else it does."""
    return _more(behavior.slots.actions, said) is not None


def _nothing(extra: frozenset[Action] | None) -> bool:
    return extra is not None and not extra


def _hastier(one: frozenset[Action], other: frozenset[Action]) -> bool:
    """Whether somebody does what another does, and that in haste."""
    return one > other and all(action.row.hasty for action in one - other)


def _more(acts: tuple[Action, ...], said: tuple[Action, ...]) -> frozenset[Action] | None:
    """What is done beyond what was said and what that brings along; None if that is not done, in order."""
    does = set(acts)
    if reordered(acts, said):
        return None
    if not set(said) <= does.union(*(BRINGS[action] for action in does)):
        return None
    return frozenset(does.difference(said, *(BRINGS[action] for action in said)))


Alternatives = dict[str, list[tuple[Any, float]]]  # of each slot, values with how likely each is; None: not said


def _alternatives(slots: Slots, beliefs: Beliefs) -> Alternatives:
    """What may have been said: as was believed, but for facts that were decided otherwise, which are sure."""
    found: Alternatives = {}
    for name in (*slots_of(Component.GEOMETRY), *slots_of(Component.SPAWN)):
        classes, decided = beliefs.slots.get(name, {}), getattr(slots, name)
        likeliest = max(classes, key=lambda value: classes[value], default=decided)
        found[name] = list(classes.items()) if classes and decided == likeliest else [(decided, 1.0)]
    crosses = slots.position is Position.CROSSING and slots.actions and not set(slots.actions) & set(TURNING)
    if crosses and slots.place is Place.JUNCTION:
        found["place"] = [(Place.FOUR_WAY, 1.0)]  # who turns nowhere goes straight on, which takes a crossroads
    return found


_ELSEWHERE = (*TURNS, *LANE_CHANGES, *JUNCTIONS, *CURVES, Maneuver.BYPASS)  # not simply on a road


def _free(name: str, value: object, *, sure: bool) -> float:
    """How likely a snippet's fact is where nothing was said of it."""
    if value in (None, False, NO_SIDE, NOT_RIGHT) or isinstance(value, frozenset):
        return 1.0
    if not SLOTS[name].taught:
        return 0.0  # words say it outright, or it was not said
    if sure and (SLOTS[name].added or value in _ELSEWHERE):
        return UNASKED_SURELY
    return UNASKED if SLOTS[name].added else UNASKED_VALUE


def _does(snippet: Snippet, name: str) -> Any:
    """What a snippet does of a slot; of a side or a distance that it leaves open, what is possible."""
    value = getattr(snippet.slots, name)
    if name == "side" and value is None and snippet.slots.position in IN_LANE:
        return NO_SIDE
    if name == "side" and value is None and snippet.slots.position is Position.ONCOMING:
        return NOT_RIGHT
    return distances(snippet) if name == "distance" and value is None else value


def _conflicts(asked: _Asked, snippet: Snippet, component: Component) -> list[str]:
    """The facts that a snippet contradicts, in words."""
    found: list[str] = []
    said = asked.slots
    for slot in slots_of(component):
        wanted, does = getattr(said, slot), _does(snippet, slot)
        if slot == "actions":
            against = bool(wanted) and bool(does) and not set(wanted) & set(does)
            against |= any(action not in wanted and action.opposite in wanted for action in does)
            against |= asked.frame.whole and reordered(does, wanted)
        else:
            against = wanted is not None and _agreement(wanted, does) == 0.0
        if against:
            found.append(f"{slot}: said {_words(wanted)}, does {_words(does)}")
        elif slot == "actions" and wanted:
            found += [
                f"{slot}: does {action}, which was not said"
                for action in OFFENCES
                if action in does and action not in wanted
            ]
    if said.adversary is not None and snippet.adversaries and said.adversary.acts_as not in snippet.adversaries:
        found.append(f"adversary: said {said.adversary}, does {_words(snippet.adversaries)}")
    return found


def _agreement(said: object, does: object) -> float:
    """How well a snippet does one fact, in [0, 1]."""
    if does is None or (does == NOT_RIGHT and said is Side.LEFT):
        return 0.0 if said is True or isinstance(said, Site) else OPEN if isinstance(said, (Side, Distance)) else UNSAID
    if isinstance(does, frozenset):
        return NARROWER if said in does else OPEN
    if said == does:
        return 1.0
    if isinstance(said, Place) and isinstance(does, Place):
        if includes(said, does):
            return CROSSROADS if does is Place.FOUR_WAY else NARROWER
        return UNSAID if includes(does, said) else 0.0
    return 0.0


def _words(value: object) -> str:
    return ", ".join(map(str, value)) if isinstance(value, tuple) else str(value)


@lru_cache(maxsize=4)
def _shelves(library: Library) -> dict[Component, _Shelf]:
    return {component: _shelf(component, library.of(component)) for component in Component}


@lru_cache(maxsize=12)
def _shelf(component: Component, snippets: tuple[Snippet, ...]) -> _Shelf:
    """A shelf, which a library with a composed behavior has in common with the one without it."""
    return _Shelf(component, snippets)


# The triple


def _adversary(scenario: Scenario, triple: tuple[Match, ...]) -> AdversaryKind:
    """The kind that was said, or the first that behavior and spawn have in common."""
    if scenario.slots.adversary is not None:
        return scenario.slots.adversary
    behavior, _, spawn = (match.snippet for match in triple)
    return next(kind for kind in behavior.adversaries if kind in spawn.adversaries)


def doubts(
    scenario: Scenario, frame: Frame, behavior: Snippet, library: Library, embedder: Embedder
) -> dict[str, float]:
    """What speaks for and against a sentence being served, by the names in `CONFIDENCE`.

    Args:
        scenario: What was understood.
        frame: What the sentence says.
        behavior: What was chosen for it.
        library: Whose other behaviors it may have meant, as far as its adversary can do them.
        embedder: Who says how near the behavior's description is.
    """
    kind, beliefs = scenario.slots.adversary, frame.beliefs
    able = [s for s in library.of(Component.BEHAVIOR) if kind is None or kind in s.adversaries]
    meant = beliefs.meant(behavior.id)
    meant /= max(meant, sum(beliefs.behaviors.get(s.id, 0.0) for s in able)) or 1.0
    text, description = embedder.encode([scenario.parts.behavior, behavior.description])
    words, account = len(frame.told.split()), frame.account
    return {
        "base": 1.0,
        "scope": log_odds(beliefs.in_scope, FAINTEST),
        "beyond": float(any(note.about is About.FOREIGN for note in scenario.notes)),
        "outright": float(min(len(scenario.slots.said()) - len(guessed(scenario.slots, frame)), ENOUGH)),
        "wording": min(max(float(text @ description), FAR_WORDING), NEAR_WORDING),
        "meant": math.log(meant + UNLIKELY),
        "same acts": float(account is not None and set(account.slots.actions) == set(scenario.slots.actions)),
        "same kind": float(account is not None and account.slots.adversary is scenario.slots.adversary),
        "same place": float(account is not None and account.slots.position is scenario.slots.position),
        "no account": float(account is None),
        "touched": float(account is not None and account.touched),
        "unused": sum(one.why is not Why.BESIDES for one in frame.unused) / max(words, FEW),
        "words": math.log(max(words, 1)),
        "facts": beliefs.facts(scenario.slots),
        "acts": beliefs.acts(scenario.slots.actions),
    }


def guessed(slots: Slots, frame: Frame) -> list[str]:
    """The slots that no word says outright; the whole of the text made them likely."""
    return [name for name, value in slots.said().items() if value and not getattr(frame.outright, name)]


def _confidence(
    scenario: Scenario, frame: Frame, triple: tuple[Match, ...], library: Library, embedder: Embedder
) -> float:
    """The probability that every fact of a sentence was read rightly, less for every fact that the triple contradicts.

    Nothing is left of it by another language, by weather and by light.
    """
    if any(one.why in REFUSED for one in scenario.unused):
        return 0.0
    contradicted = CONTRADICTED ** sum(len(match.conflicts) for match in triple)
    if frame.whole:
        return frame.sure * contradicted
    contradicted *= left_by_unread(scenario)
    against = doubts(scenario, frame, triple[0].snippet, library, embedder)
    odds = sum(CONFIDENCE[name] * value for name, value in against.items())
    return contradicted * with_stated_sure(1.0 / (1.0 + math.exp(-odds)), frame, scenario.slots)


def left_by_unread(scenario: Scenario) -> float:
    """What is left of the confidence by road users who are spoken of and were not read: one may do what matters.

    Whoever leads, hides somebody or stands in the way may be told in words that its slot does not know.
    """
    unread = sum(one.why is Why.ROAD_USER for one in scenario.unused)
    slots = scenario.slots
    held = sum(bool(one) for one in (slots.occluder, slots.leader, slots.blocker))
    return UNREAD_ACTOR if unread > held else 1.0


def reasons_of(scenario: Scenario) -> tuple[str, ...]:
    """Why it is not sure what a text says, in a user's words, what decides alone first."""
    return _reasons(scenario, scenario.frame or Frame(outright=scenario.slots), ())


def _reasons(scenario: Scenario, frame: Frame, triple: tuple[Match, ...]) -> tuple[str, ...]:
    """Why a sentence is refused, in a user's words, what decides alone first."""
    told = grouped(scenario.unused)
    if Why.LANGUAGE in told:
        return (told[Why.LANGUAGE],)  # all else follows from it
    unheard = guessed(scenario.slots, frame)
    notes = [note for note in scenario.notes if note.about is About.FOREIGN]
    notes += [
        Note(about=about) for slot, about in (("adversary", About.WHO), ("actions", About.WHAT)) if slot in unheard
    ]
    notes += [note for note in scenario.notes if note.about in (About.WHO, About.STRANGER, About.WHAT)]
    said = [told[why] for why in REFUSED if why in told]
    said += map(str, notes)
    said += [conflict for match in triple for conflict in match.conflicts]
    snippets = [match.snippet for match in triple]
    unmet = [
        quantity.said
        for quantity in frame.quantities
        if snippets and not settable(quantity, snippets, scenario.slots.adversary)
    ]
    said += [f"{number!r}: nothing that fits the rest can be set to it" for number in unmet]
    said += [reason for why, reason in told.items() if why not in (*REFUSED, Why.BESIDES)]
    return tuple(dict.fromkeys(said)) or ("every word is known, but not what is meant",)


def _ruled_out(
    ranked: dict[Component, _Ranking],
    triple: tuple[Match, ...],
    kind: AdversaryKind | None,
    tried: Sequence[Tried],
) -> tuple[RuledOut, ...]:
    """For each component, the best-scoring snippets that beat the chosen one but fit no chosen partner; none tried."""
    chosen = {match.snippet.component: match.snippet for match in triple}
    out: list[RuledOut] = []
    for component, match in zip(Component, triple, strict=True):
        gone = {name for one in tried for name in one.snippet_ids}
        better = [m for m in ranked[component].best(2) if m.score > match.score and m.snippet.id not in gone]
        for candidate in better:
            swapped = {**chosen, component: candidate.snippet}
            reason = incompatibility(*(swapped[c] for c in Component))
            if reason is None and kind is not None and candidate.snippet.adversaries:
                reason = None if kind.acts_as in candidate.snippet.adversaries else f"it has no {kind}"
            against = f"it contradicts what was read: {'; '.join(candidate.conflicts)}" if candidate.conflicts else None
            why = reason or against or "its partners score lower in sum"
            out.append(RuledOut(snippet_id=candidate.snippet.id, reason=why))
    return tuple(out)
