"""Step 3 of 9: sub-descriptions and slots to the best compatible triple of snippets, with the reasons.

Paper: section 3.3, step iii. The reference takes the nearest snippet per component, each on its own; here the three
are chosen together, so that what cannot be joined cannot be chosen, and typed facts weigh beside wording, because
an embedding hardly tells left from right (decisions 0006 and 0017).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chatscene.agent.base import ALONG
from chatscene.agent.decompose import UNKNOWN, WHAT, WHO
from chatscene.errors import NothingFits
from chatscene.settings import RetrievalSettings
from chatscene.snippets.bind import distances, out_of_reach, settable
from chatscene.snippets.compatibility import compatibility, incompatibility
from chatscene.snippets.embedding import Embedder, Vectors
from chatscene.snippets.library import Library
from chatscene.snippets.slot_classifier import Probabilities, as_class, as_value, likelihoods
from chatscene.snippets.vector_index import VectorIndex, build_cached
from chatscene.snippets.wording_index import WordingIndex, best_of_each, word_index
from chatscene.snippets.wording_vectors import vectors_of
from chatscene.terms.scenario import (
    REFUSED,
    Action,
    AdversaryKind,
    Component,
    Distance,
    Place,
    Position,
    Scenario,
    Side,
    Slots,
    Why,
    grouped,
    includes,
    reordered,
)
from chatscene.terms.snippet import Match, Retrieval, RuledOut, Snippet, Tried

OF_COMPONENT: dict[Component, tuple[str, ...]] = {
    Component.BEHAVIOR: ("actions", "position", "control"),
    Component.GEOMETRY: ("maneuver", "place", "control", "lanes", "two_way"),
    Component.SPAWN: ("side", "position", "place", "occluder", "leader", "blocker", "distance", "group"),
}
CONFLICT = 5.0  # what one contradicted action or quantity costs, in nats
UNASKED = 0.5  # likelihood of a thing nobody asked for: an occluder, a leader, a control, a group …
UNASKED_VALUE = 0.8  # … and of a value nobody asked for, such as a side
UNLIKELY = 1e-3  # least likelihood of a fact, so that one surprise does not decide everything
ADDED = ("occluder", "leader", "blocker", "control", "group", "distance", "lanes")
CONTRADICTED = 0.2  # confidence left by a fact that the triple contradicts: its program would not mean what was said
# Log-odds that a sentence can be served, beside those of its scope: fitted by likelihood on sentences that the
# classifier had not seen, those that can be and those that cannot weighing the same (benchmarks/confidence.py).
CONFIDENCE = {
    "base": -5.86, "scope": 0.50, "beyond": -1.29, "outright": 0.70, "wording": 3.63, "meant": 0.61,
}  # fmt: skip
ENOUGH = 4  # facts that words say outright; more make nothing surer
FAR_WORDING, NEAR_WORDING = 0.2, 0.7  # cosines of a behavior's wording below and above which it says nothing more
UNSAID = 0.5  # agreement of a fact that the snippet leaves open, or does less exactly than it was said …
OPEN = 0.02  # … and of a side or a distance: who leaves that open starts anywhere
NARROWER = 0.85  # agreement of a place that is one kind of what was said, of a distance that can be told
CROSSROADS = 0.97  # … and of a crossroads, which is what a junction mostly is
AGREEMENT = 0.5  # weight of the actions that a behavior shares with what was read
PARAMETER = 0.01  # what a parameter costs: of equals, the simpler one
PLACE_WORDING = 0.1  # weight of wording for geometry and spawn: it decides among equals
# Of a behavior: cosine of the adversary's part, shared words, log-likelihood under the classifier. Fitted by likelihood
# on sentences of behaviors of which the classifier had seen none (decision 0017).
WORDING = np.array([0.2, 1.0, 1.4])
FAINTEST = 1e-4  # least likelihood of a behavior

SURE, POSSIBLE = 0.9, 0.05  # a fact as likely as this stands; one as likely as this may be what was meant
HASTE = {Action.ACCELERATE, Action.FAST}  # how a thing is done, which need not be said
HEARD = 0.25  # an action less likely than this was not heard
UNLIKE = 0.4  # cosine of a wording that has nothing to do with a text

OPPOSITES = ((Action.TURN_LEFT, Action.TURN_RIGHT), (Action.ACCELERATE, Action.BRAKE))
IN_LANE = (Position.AHEAD, Position.BEHIND)
NO_SIDE = "neither"  # of a spawn in the ego's lane, which contradicts a side; one that leaves it open has either

Scores = NDArray[np.float64]


def nearest(
    text: str, component: Component, library: Library, embedder: Embedder, *, count: int, lexical_weight: float = 0.0
) -> list[tuple[Snippet, float]]:
    """The snippets of one component most similar to a text, best first, with their similarities.

    Args:
        text: Compared with every wording of a snippet; the nearest counts.
        component: Which snippets.
        library: From which library.
        embedder: Of the cosines.
        count: How many.
        lexical_weight: Share of shared words in the similarity, in [0, 1].
    """
    shelf = _shelf(library, component, embedder)
    similarity, _ = shelf.dense(_query(text, embedder))
    if lexical_weight:
        similarity = (1 - lexical_weight) * similarity + lexical_weight * shelf.words.search(text)[0]
    best = np.argsort(-similarity, kind="stable")[:count]
    return [(shelf.snippets[i], float(similarity[i])) for i in best]


def retrieve(
    scenario: Scenario,
    library: Library,
    embedder: Embedder,
    settings: RetrievalSettings | None = None,
    tried: Sequence[Tried] = (),
) -> Retrieval:
    """Choose the compatible triple that serves a scenario best.

    Args:
        scenario: What was understood.
        library: What can be chosen.
        embedder: Measures wording.
        settings: How many candidates are named, and the confidence below which nothing is chosen.
        tried: Choices that did not show what was said; they are not made again.

    Raises:
        NothingFits: No triple serves it well enough; the message names the nearest.
    """
    settings = settings or RetrievalSettings()
    likely = likelihoods(scenario.text, settings.library)
    ranked, triple = _best(scenario, library, embedder, likely, agreeing=True, tried=tried)
    confidence = _confidence(scenario, triple, library, likely)
    if confidence < settings.refuse_below:
        reasons = _reasons(scenario, triple)
        raise NothingFits(
            f"nothing in the library does this (confidence {confidence:.0%}): {'; '.join(reasons)}",
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


def settled(scenario: Scenario, rules: Slots, library: Library, embedder: Embedder, likely: Probabilities) -> Slots:
    """What was read, made whole with the library in mind: facts that only together are likely are read together.

    A fact that the best triple contradicts is taken to be what the triple does, if the patterns read that or if it may
    as well be.

    Args:
        scenario: What was read, fact by fact.
        rules: What the patterns read.
        library: What can be chosen.
        embedder: Measures wording.
        likely: How likely each fact is.
    """
    who, possible = scenario.slots.adversary, likely.slots["adversary"]
    kinds = [kind for kind in AdversaryKind if kind is who or (who is not None and possible.get(kind, 0.0) >= POSSIBLE)]
    found: list[tuple[float, Slots, tuple[Match, ...]]] = []
    for kind in kinds or [who]:
        slots = replace(scenario.slots, adversary=kind)
        try:
            # What is done is part of the doubt, unless words say it.
            heard = slots if scenario.plain else replace(slots, actions=())
            _, triple = _best(replace(scenario, slots=heard), library, embedder, likely)
        except NothingFits:
            continue
        doubt = math.log(possible.get(as_class(kind), 0.0) + UNLIKELY)
        found.append((doubt + sum(match.score for match in triple), slots, triple))
    if not found:
        return scenario.slots
    _, slots, triple = max(found, key=lambda one: one[0])
    for component, match in zip(Component, triple, strict=True):
        does = match.snippet.slots
        for name in OF_COMPONENT[component]:
            said, value = getattr(slots, name), getattr(does, name)
            if name == "actions" and scenario.plain:
                continue
            if name == "actions":
                known = likely.behaviors.get(match.snippet.id, 1.0)  # the classifier has not heard of a user's own
                heard = bool(rules.actions) and set(rules.actions) <= set(value)
                sure = tuple(a for a in said if a in rules.actions or likely.actions[a] >= HEARD)
                slots = replace(slots, actions=value if known >= POSSIBLE or heard else sure)
            elif name == "side" and value is None and rules.side is None:
                slots = replace(slots, side=None)  # no word says it, and where the triple starts there is none
            elif said is not None and _agreement(said, _does(match.snippet, name)) == 0.0:
                unsure = likely.slots[name].get(as_class(said), 0.0) < SURE
                possible = likely.slots[name].get(as_class(value), 0.0) >= POSSIBLE
                read = getattr(rules, name) == value  # then words and library are two against one
                slots = replace(slots, **{name: value}) if read or (unsure and possible) else slots
    return slots


def _best(
    scenario: Scenario,
    library: Library,
    embedder: Embedder,
    likely: Probabilities,
    *,
    agreeing: bool = False,
    tried: Sequence[Tried] = (),
) -> tuple[dict[Component, _Ranking], tuple[Match, ...]]:
    """Every component ranked, and the compatible triple that scores highest of those that were not tried.

    With `agreeing`, one that contradicts nothing that was read, if there is one: any other would be refused.
    """
    joint = compatibility(library)
    ranked = {component: _rank(scenario, component, library, embedder, likely) for component in Component}
    kind = scenario.slots.adversary
    allowed = joint.able(kind)
    mask = joint.mask
    for one in tried:
        mask = mask & ~joint.with_all(one.snippet_ids)
    scores = [ranked[component].score for component in Component]
    found = None
    if agreeing:
        free = tuple(ok & (ranked[component].conflicts == 0) for ok, component in zip(allowed, Component, strict=True))
        found = _highest(mask, scores, free)
    if found is None and (found := _highest(mask, scores, allowed)) is None:
        raise NothingFits(f"nothing {'else ' if tried else ''}in the library has a {kind} as adversary")
    return ranked, tuple(ranked[component].match(i) for component, i in zip(Component, found, strict=True))


def _highest(
    mask: NDArray[np.bool_], scores: Sequence[Scores], allowed: Sequence[NDArray[np.bool_]]
) -> tuple[int, int, int] | None:
    """The triple of a (B, G, S) mask, of allowed parts only, with the highest sum of scores; None if there is none.

    Behaviors are looked at from the best down, until the best partners of all could not lift the next one any more.
    """
    places = np.where(allowed[1][:, None] & allowed[2], scores[1][:, None] + scores[2], -np.inf)
    ceiling = float(places.max(initial=-np.inf))
    best, found = -np.inf, None
    for b in np.argsort(-scores[0], kind="stable").tolist():
        if scores[0][b] + ceiling <= best:
            break
        if allowed[0][b]:
            joined = np.where(mask[b], places, -np.inf)
            at = int(np.argmax(joined))
            if scores[0][b] + joined.flat[at] > best:
                best = float(scores[0][b] + joined.flat[at])
                found = b, *divmod(at, joined.shape[1])
    return found


# One component


@dataclass(frozen=True, slots=True)
class _Ranking:
    """Every snippet of a component against one scenario; a row each."""

    said: Slots
    plain: bool
    component: Component
    snippets: tuple[Snippet, ...]
    similarity: Scores
    texts: list[str]
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
            conflicts=tuple(_conflicts(self.said, snippet, self.component, ordered=self.plain)),
        )

    def best(self, count: int) -> tuple[Match, ...]:
        return tuple(self.match(int(i)) for i in np.argsort(-self.score, kind="stable")[:count])


def _rank(
    scenario: Scenario,
    component: Component,
    library: Library,
    embedder: Embedder,
    likely: Probabilities,
) -> _Ranking:
    shelf = _shelf(library, component, embedder)
    text = scenario.parts[component]
    # Geometry and spawn are facts put into fixed words: an encoder adds nothing to them but time.
    places = component is not Component.BEHAVIOR
    lexical, texts = (shelf.names if places else shelf.words).search(text)
    similarity = lexical
    score = PLACE_WORDING * lexical - PARAMETER * shelf.parameters
    if not places:
        similarity, texts = shelf.dense(_query(text, embedder))
        p = (
            shelf.said(likely, similarity, scenario.slots.actions)
            if scenario.plain
            else shelf.meant(likely, similarity)
        )
        score = WORDING @ np.array([similarity, lexical, np.log(p + FAINTEST)])
    agreement, conflicts = shelf.facts(scenario.slots, likely, component)
    if scenario.plain and not places:
        conflicts = conflicts + [reordered(s.slots.actions, scenario.slots.actions) for s in shelf.snippets]
    if places:
        score = score + shelf.likelihood(_beliefs(scenario.slots, likely), component)
    else:
        score = score + AGREEMENT * agreement - CONFLICT * conflicts
    if scenario.quantities:
        score = score - CONFLICT * np.array([out_of_reach(s, scenario.quantities) for s in shelf.snippets])
    return _Ranking(
        scenario.slots, scenario.plain, component, shelf.snippets, similarity, texts, agreement, conflicts, score
    )


class _Shelf:
    """The snippets of one component, ready to be searched: vectors, words, and facts as codes."""

    def __init__(self, snippets: tuple[Snippet, ...], embedder: Embedder) -> None:
        self.snippets = snippets
        self._embedder = embedder
        self.wordings = [text for snippet in snippets for text in (snippet.description, *snippet.rephrasings)]
        self.owners = np.array([i for i, s in enumerate(snippets) for _ in range(1 + len(s.rephrasings))])
        self.words: WordingIndex = word_index(tuple(self.wordings), tuple(self.owners.tolist()))
        self.names: WordingIndex = word_index(tuple(s.description for s in snippets), tuple(range(len(snippets))))
        self.parameters = np.array([len(snippet.parameters) for snippet in snippets], float)
        self.actions = np.array([[action in s.slots.actions for action in Action] for s in snippets], float)
        does = [frozenset(s.slots.actions) for s in snippets]
        # (N, N) whether the second does what the first does, and that in haste.
        self.hastier = np.array([[bool(b > a) and b - a <= HASTE for b in does] for a in does], bool)
        names = {slot for slots in OF_COMPONENT.values() for slot in slots} - {"actions"}
        self.values: dict[str, list[Any]] = {}
        self.codes: dict[str, NDArray[np.intp]] = {}
        for name in sorted(names):
            values = list(dict.fromkeys(_does(s, name) for s in snippets))
            self.values[name] = values
            self.codes[name] = np.array([values.index(_does(s, name)) for s in snippets])

    @cached_property
    def index(self) -> VectorIndex:
        """Every wording as a vector (paper, section 3.2); of geometries and spawns only a direct search asks for it."""
        return build_cached(vectors_of(self.wordings, self._embedder))

    def dense(self, query: Vectors) -> tuple[Scores, list[str]]:
        """(N,) cosine of a text to the nearest wording of each snippet, and that wording."""
        best, rows = best_of_each(self.index.cosines(query), self.owners)
        return best.astype(float), [self.wordings[row] for row in rows]

    def meant(self, likely: Probabilities, similarity: Scores) -> Scores:
        """(N,) how likely each behavior is to be meant.

        One that the classifier was not trained on, such as a user's own, is as likely as its wording is near. Where
        the likeliest does the same in haste, and no haste was heard, its likelihood is the calmer's too: who "steps out
        and freezes" is not said to sprint.
        """
        p = self._told(likely, similarity)
        heard = self.actions @ np.array([likely.actions[action] >= HEARD for action in Action])
        best = int(np.argmax(p))
        return p + p[best] * (self.hastier[:, best] & (heard == heard[best]))

    def said(self, likely: Probabilities, similarity: Scores, actions: tuple[Action, ...]) -> Scores:
        """(N,) how likely each behavior is to be meant where words say all that is done.

        Whoever does just that is meant wherever one who does more was heard; what more is done was not asked for.
        """
        more = [_more(s, actions) for s in self.snippets]
        p = self._told(likely, similarity)
        lent = sum(one for one, extra in zip(p.tolist(), more, strict=True) if extra)
        return np.array(
            [
                one if extra is None else one * UNASKED ** len(extra) if extra else one + lent
                for one, extra in zip(p.tolist(), more, strict=True)
            ]
        )

    def _told(self, likely: Probabilities, similarity: Scores) -> Scores:
        near = _near(similarity).tolist()
        return np.array([likely.behaviors.get(s.id, other) for s, other in zip(self.snippets, near, strict=True)])

    def likelihood(self, beliefs: Beliefs, component: Component) -> Scores:
        """(N,) log-likelihood that the facts of each snippet are what was said."""
        total = np.zeros(len(self.snippets))
        for name in OF_COMPONENT[component]:
            table = [
                sum(p * (_agreement(wanted, value) if wanted is not None else _free(name, value))
                    for wanted, p in beliefs[name])
                for value in self.values[name]
            ]  # fmt: skip
            total += np.log(np.array(table) + UNLIKELY)[self.codes[name]]
        return total

    def facts(self, said: Slots, likely: Probabilities, component: Component) -> tuple[Scores, Scores]:
        """(N,) mean agreement with what was said, and facts contradicted by what was said or heard."""
        parts: list[Scores] = []
        conflicts = np.zeros(len(self.snippets))
        for name in OF_COMPONENT[component]:
            if name == "actions":
                against = self._opposes(said.actions, likely)
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
            if component is not Component.BEHAVIOR:
                parts.append(table[codes])
        agreement = np.mean(parts, axis=0) if parts else np.ones(len(self.snippets))
        return agreement, conflicts

    def _opposes(self, said: tuple[Action, ...], likely: Probabilities) -> NDArray[np.bool_]:
        """(N,) whether a behavior does an action that was not said, and whose opposite was.

        Where nothing is settled yet, what the classifier hears was said, and the likeliest behavior is heard as a
        whole: who "brakes, then moves off" need not name the throttle.
        """
        heard = said or tuple(action for action in Action if likely.actions[action] >= HEARD)
        unheard = [action not in heard and _opposite(action) in heard for action in Action]
        against = self.actions @ np.array(unheard, float) > 0
        if not said:
            against[np.argmax([likely.behaviors.get(snippet.id, 0.0) for snippet in self.snippets])] = False
        return against

    def _acted(self, said: tuple[Action, ...]) -> Scores:
        wanted = np.array([action in said for action in Action], float)
        both = self.actions @ wanted
        either = self.actions.sum(axis=1) + wanted.sum() - both
        return (2 * both / wanted.sum() + both / np.maximum(either, 1)) / 3


def _more(behavior: Snippet, said: tuple[Action, ...]) -> frozenset[Action] | None:
    """What a behavior does beyond what was said and what that brings along; None if it does not do that, in order."""
    does = set(behavior.slots.actions)
    if reordered(behavior.slots.actions, said):
        return None
    if not set(said) <= does.union(*(ALONG.get(action, set()) for action in does)):
        return None
    return frozenset(does.difference(said, *(ALONG.get(action, set()) for action in said)))


def _near(similarity: Scores) -> Scores:
    """How likely a behavior is that the classifier was not trained on, from its wording's cosine."""
    return np.clip((similarity - UNLIKE) / (1 - UNLIKE), 0.0, 1.0) ** 2


Beliefs = dict[str, list[tuple[Any, float]]]  # of each slot, values with how likely each is; None: not said


def _beliefs(slots: Slots, likely: Probabilities) -> Beliefs:
    """What may have been said: as the classifier has it, but for facts that were read otherwise."""
    found: Beliefs = {}
    for name, classes in likely.slots.items():
        read = as_class(getattr(slots, name))
        if read == max(classes, key=lambda value: classes[value]):
            found[name] = [(as_value(name, value), p) for value, p in classes.items()]
        else:
            found[name] = [(getattr(slots, name), 1.0)]
    return found


def _free(name: str, value: object) -> float:
    """How likely a snippet's fact is where nothing was said of it."""
    if value in (None, False, NO_SIDE) or isinstance(value, frozenset):
        return 1.0
    return UNASKED if name in ADDED else UNASKED_VALUE


def _does(snippet: Snippet, name: str) -> Any:
    """What a snippet does of a slot; where it leaves a distance open, those that it can be told."""
    value = getattr(snippet.slots, name)
    if name == "side" and value is None and snippet.slots.position in IN_LANE:
        return NO_SIDE
    return distances(snippet) if name == "distance" and value is None else value


def _conflicts(said: Slots, snippet: Snippet, component: Component, *, ordered: bool) -> list[str]:
    """The facts that a snippet contradicts, in words; `ordered` acts were said in their order."""
    found: list[str] = []
    for slot in OF_COMPONENT[component]:
        wanted, does = getattr(said, slot), _does(snippet, slot)
        if slot == "actions":
            against = bool(wanted) and bool(does) and not set(wanted) & set(does)
            against |= any(action not in wanted and _opposite(action) in wanted for action in does)
            against |= ordered and reordered(does, wanted)
        else:
            against = wanted is not None and _agreement(wanted, does) == 0.0
        if against:
            found.append(f"{slot}: said {_words(wanted)}, does {_words(does)}")
    if said.adversary is not None and snippet.adversaries and said.adversary not in snippet.adversaries:
        found.append(f"adversary: said {said.adversary}, does {_words(snippet.adversaries)}")
    return found


def _agreement(said: object, does: object) -> float:
    """How well a snippet does one fact, in [0, 1]."""
    if does is None:
        return 0.0 if said is True else OPEN if isinstance(said, (Side, Distance)) else UNSAID
    if isinstance(does, frozenset):
        return NARROWER if said in does else OPEN
    if said == does:
        return 1.0
    if isinstance(said, Place) and isinstance(does, Place):
        if includes(said, does):
            return CROSSROADS if does is Place.FOUR_WAY else NARROWER
        return UNSAID if includes(does, said) else 0.0
    return 0.0


def _opposite(action: Action) -> Action | None:
    return next((b for pair in OPPOSITES for a, b in (pair, pair[::-1]) if a is action), None)


def _words(value: object) -> str:
    return ", ".join(map(str, value)) if isinstance(value, tuple) else str(value)


@lru_cache(maxsize=256)
def _query(text: str, embedder: Embedder) -> Vectors:
    """A text's row."""
    return embedder.encode([text])


@lru_cache(maxsize=16)
def _shelf(library: Library, component: Component, embedder: Embedder) -> _Shelf:
    return _Shelf(library.of(component), embedder)


# The triple


def _adversary(scenario: Scenario, triple: tuple[Match, ...]) -> AdversaryKind:
    """The kind that was said, or the first that behavior and spawn have in common."""
    if scenario.slots.adversary is not None:
        return scenario.slots.adversary
    behavior, _, spawn = (match.snippet for match in triple)
    return next(kind for kind in behavior.adversaries if kind in spawn.adversaries)


def doubts(scenario: Scenario, behavior: Match, library: Library, likely: Probabilities) -> dict[str, float]:
    """What speaks for and against a sentence being served, by the names in `CONFIDENCE`.

    Args:
        scenario: What was understood.
        behavior: What was chosen for it.
        library: Whose other behaviors it may have meant, as far as its adversary can do them.
        likely: How likely each fact is.
    """
    kind = scenario.slots.adversary
    able = [s for s in library.of(Component.BEHAVIOR) if kind is None or kind in s.adversaries]
    meant = likely.behaviors.get(behavior.snippet.id, float(_near(np.array(behavior.similarity))))
    if scenario.plain and _more(behavior.snippet, scenario.slots.actions) == frozenset():
        meant += sum(likely.behaviors.get(s.id, 0.0) for s in able if _more(s, scenario.slots.actions))
    meant /= max(meant, sum(likely.behaviors.get(s.id, 0.0) for s in able))
    return {
        "base": 1.0,
        "scope": math.log((likely.in_scope + FAINTEST) / (1.0 - likely.in_scope + FAINTEST)),
        "beyond": float(any(note.startswith(UNKNOWN) for note in scenario.notes)),
        "outright": float(min(len(scenario.slots.said()) - len(scenario.guessed), ENOUGH)),
        "wording": min(max(behavior.similarity, FAR_WORDING), NEAR_WORDING),
        "meant": math.log(meant + UNLIKELY),
    }


def _confidence(scenario: Scenario, triple: tuple[Match, ...], library: Library, likely: Probabilities) -> float:
    """The probability that the library can serve a sentence, less for every fact that the triple contradicts.

    Nothing is left of it by another language, by weather and by light.
    """
    if any(one.why in REFUSED for one in scenario.unused):
        return 0.0
    odds = sum(CONFIDENCE[name] * value for name, value in doubts(scenario, triple[0], library, likely).items())
    return CONTRADICTED ** sum(len(match.conflicts) for match in triple) / (1.0 + math.exp(-odds))


def _reasons(scenario: Scenario, triple: tuple[Match, ...]) -> tuple[str, ...]:
    """Why a sentence is refused, in a user's words, what decides alone first."""
    told = grouped(scenario.unused)
    if Why.LANGUAGE in told:
        return (told[Why.LANGUAGE],)  # all else follows from it
    said = [told[why] for why in REFUSED if why in told]
    said += [note for note in scenario.notes if note.startswith(UNKNOWN)]
    said += [note for slot, note in (("adversary", WHO), ("actions", WHAT)) if slot in scenario.guessed]
    said += [note for note in scenario.notes if note.startswith((WHO, WHAT))]
    said += [conflict for match in triple for conflict in match.conflicts]
    snippets = [match.snippet for match in triple]
    unmet = [quantity.said for quantity in scenario.quantities if not settable(quantity, snippets)]
    said += [f"{number!r}: nothing that fits the rest can be set to it" for number in unmet]
    said += [reason for why, reason in told.items() if why not in REFUSED]
    return tuple(dict.fromkeys(said)) or ("every word is known, but not which act of the library is meant",)


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
                reason = None if kind in candidate.snippet.adversaries else f"it has no {kind}"
            against = f"it contradicts what was read: {'; '.join(candidate.conflicts)}" if candidate.conflicts else None
            why = reason or against or "its partners score lower in sum"
            out.append(RuledOut(snippet_id=candidate.snippet.id, reason=why))
    return tuple(out)
