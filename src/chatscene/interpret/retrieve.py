"""Step 3 of 9: sub-descriptions and slots to the best compatible triple of snippets, with the reasons.

Paper: section 3.3, step iii. The reference takes the nearest snippet per component, each on its own; here the three
are chosen together, so that what cannot be joined cannot be chosen, and typed facts weigh beside wording, because
an embedding hardly tells left from right (decisions 0006 and 0017).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chatscene.errors import NothingFits
from chatscene.interpret.joint_choice import highest, none_left
from chatscene.interpret.wording_index import WordingIndex
from chatscene.library.bind import distances, out_of_reach, settable
from chatscene.library.compatibility import compatibility, incompatibility
from chatscene.library.load import Library
from chatscene.settings import RetrievalSettings
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.acts import BRINGS, Action, reordered
from chatscene.terms.acts import TURNS as TURNING
from chatscene.terms.conclusions import CURVES, JUNCTIONS, LANE_CHANGES, TURNS
from chatscene.terms.frame import About, Frame
from chatscene.terms.scenario import (
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
    grouped,
    includes,
)
from chatscene.terms.slots import SLOTS, slots_of
from chatscene.terms.snippet import Match, Retrieval, RuledOut, Snippet, Tried

CONFLICT = 5.0  # what one contradicted action or quantity costs, in nats
UNASKED = 0.5  # likelihood of an act beside those that were said …
UNASKED_SURELY = 0.02  # … of a thing that nobody asked for: an occluder, a leader, a control, a group …
UNASKED_VALUE = 0.8  # … and of a value nobody asked for, such as a side
UNLIKELY = 1e-3  # least likelihood of a fact, so that one surprise does not decide everything
CONTRADICTED = 0.2  # confidence left by a fact that the triple contradicts: its program would not mean what was said
UNSAID = 0.5  # agreement of a fact that the snippet leaves open, or does less exactly than it was said …
OPEN = 0.02  # … and of a side or a distance: who leaves that open starts anywhere
NARROWER = 0.85  # agreement of a place that is one kind of what was said, of a distance that can be told
CROSSROADS = 0.97  # … and of a crossroads, which is what a junction mostly is
AGREEMENT = 0.5  # weight of the actions that a behavior shares with what was read
PARAMETER = 0.01  # what a parameter costs: of equals, the simpler one
PLACE_WORDING = 0.1  # weight of wording for geometry and spawn: it decides among equals
MEANT = 1.4  # weight of a behavior's log-likelihood beside the words that it shares (decision 0017)
FAINTEST = 1e-4  # least likelihood of a behavior

IN_LANE = (Position.AHEAD, Position.BEHIND)
OFFENCES = (Action.RUN_LIGHT,)  # nobody is shown to commit them who is not said to
NO_SIDE = "neither"  # of a spawn in the ego's lane, which contradicts a side; one that leaves it open has either
NOT_RIGHT = "oncoming traffic, which keeps left of us"  # of a spawn there, which contradicts the right side

Scores = NDArray[np.float64]


def retrieve(
    scenario: Scenario,
    library: Library,
    settings: RetrievalSettings | None = None,
    tried: Sequence[Tried] = (),
) -> Retrieval:
    """Choose the compatible triple that serves a scenario best.

    Raises:
        NothingFits: No triple serves it well enough; the message names the nearest.
    """
    settings = settings or RetrievalSettings()
    frame = scenario.frame or Frame(outright=scenario.slots, sure=1.0)
    asked = _Asked(frame, scenario.slots, scenario.parts)
    ranked = _ranked(asked, library)
    triple = _best(ranked, library, scenario.slots.adversary, tried)
    confidence = _confidence(frame, triple)
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


def _best(
    ranked: dict[Component, _Ranking], library: Library, kind: AdversaryKind | None, tried: Sequence[Tried]
) -> tuple[Match, ...]:
    """The compatible triple that scores highest of those that were not tried.

    It contradicts nothing that was read, if there is such a one: any other would be refused.
    """
    joint = compatibility(library)
    allowed = joint.able(kind)
    scores = [ranked[component].score for component in Component]
    free = tuple(ok & (ranked[component].conflicts == 0) for ok, component in zip(allowed, Component, strict=True))
    found = highest(joint, scores, free, tried) or highest(joint, scores, allowed, tried)
    if found is None:
        raise none_left(kind, tried)
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
    agreement, conflicts = shelf.facts(slots)
    if shelf.component is Component.BEHAVIOR:
        conflicts = conflicts + shelf.of_each(lambda does: reordered(does, slots.actions))
        score = similarity + MEANT * np.log(shelf.said(slots.actions)) + AGREEMENT * agreement - CONFLICT * conflicts
    else:
        score = PLACE_WORDING * similarity - PARAMETER * shelf.parameters + shelf.likelihood(slots)
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

    def said(self, actions: tuple[Action, ...]) -> Scores:
        """(N,) how likely each behavior is to be meant by who says all that is done.

        What more is done was not asked for. Where there is one who does just that, whoever leaves out what was said is
        not meant.
        """
        more = [_more(does, actions) for does in self.does]
        less = FAINTEST if frozenset() in more else 1.0
        return np.array([less if extra is None else UNASKED ** len(extra) for extra in more])[self.doing]

    def likelihood(self, said: Slots) -> Scores:
        """(N,) log-likelihood that the facts of each snippet are what was said."""
        total = np.zeros(len(self.snippets))
        for name in slots_of(self.component):
            wanted = _wanted(said, name)
            table = [
                _agreement(wanted, value) if wanted is not None else _free(name, value) for value in self.values[name]
            ]
            total += np.log(np.array(table) + UNLIKELY)[self.codes[name]]
        return total

    def facts(self, said: Slots) -> tuple[Scores, Scores]:
        """(N,) mean agreement with what was said, and facts contradicted by that."""
        parts: list[Scores] = []
        conflicts = np.zeros(len(self.snippets))
        for name in slots_of(self.component):
            if name == "actions":
                against = self._opposes(said.actions)
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

    def _opposes(self, said: tuple[Action, ...]) -> NDArray[np.bool_]:
        """(N,) whether a behavior does an action that was not said, and whose opposite was, or that breaks the law."""
        unheard = [action not in said and (action.opposite in said or action in OFFENCES) for action in Action]
        return self.actions @ np.array(unheard, float) > 0

    def _acted(self, said: tuple[Action, ...]) -> Scores:
        wanted = np.array([action in said for action in Action], float)
        both = self.actions @ wanted
        either = self.actions.sum(axis=1) + wanted.sum() - both
        return (2 * both / wanted.sum() + both / np.maximum(either, 1)) / 3


def does_all(behavior: Snippet, said: tuple[Action, ...]) -> bool:
    """Whether a behavior does what was said, in order, whatever else it does."""
    return _more(behavior.slots.actions, said) is not None


def _more(acts: tuple[Action, ...], said: tuple[Action, ...]) -> frozenset[Action] | None:
    """What is done beyond what was said and what that brings along; None if that is not done, in order."""
    does = set(acts)
    if reordered(acts, said):
        return None
    if not set(said) <= does.union(*(BRINGS[action] for action in does)):
        return None
    return frozenset(does.difference(said, *(BRINGS[action] for action in said)))


def _wanted(slots: Slots, name: str) -> Any:
    """What was said of a slot, and where that is a junction what follows from the way across it."""
    crosses = slots.position is Position.CROSSING and slots.actions and not set(slots.actions) & set(TURNING)
    if name == "place" and crosses and slots.place is Place.JUNCTION:
        return Place.FOUR_WAY  # who turns nowhere goes straight on, which takes a crossroads
    return getattr(slots, name)


_ELSEWHERE = (*TURNS, *LANE_CHANGES, *JUNCTIONS, *CURVES, Maneuver.BYPASS)  # not simply on a road


def _free(name: str, value: object) -> float:
    """How likely a snippet's fact is where nothing was said of it."""
    if value in (None, False, NO_SIDE, NOT_RIGHT) or isinstance(value, frozenset):
        return 1.0
    if not SLOTS[name].taught:
        return 0.0  # words say it outright, or it was not said
    return UNASKED_SURELY if SLOTS[name].added or value in _ELSEWHERE else UNASKED_VALUE


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
            against |= reordered(does, wanted)
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


def _confidence(frame: Frame, triple: tuple[Match, ...]) -> float:
    """The probability that every fact was read rightly, less for every fact that the triple contradicts."""
    return frame.sure * CONTRADICTED ** sum(len(match.conflicts) for match in triple)


def _reasons(scenario: Scenario, frame: Frame, triple: tuple[Match, ...]) -> tuple[str, ...]:
    """Why a sentence is refused, in a user's words, what decides alone first."""
    notes = [note for note in scenario.notes if note.about is About.NOTHING]
    said = list(map(str, notes))
    said += [conflict for match in triple for conflict in match.conflicts]
    snippets = [match.snippet for match in triple]
    unmet = [
        quantity.said
        for quantity in frame.quantities
        if snippets and not settable(quantity, snippets, scenario.slots.adversary)
    ]
    said += [f"{number!r}: nothing that fits the rest can be set to it" for number in unmet]
    said += grouped(scenario.unused).values()
    return tuple(dict.fromkeys(said)) or ("it is not sure what is meant",)


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
