"""Step 3 of 9: sub-descriptions and slots to the best compatible triple of snippets, with the reasons.

Paper: section 3.3, step iii. The reference takes the nearest snippet per component, each on its own; here the three
are chosen together, so that what cannot be joined cannot be chosen, and typed facts weigh beside wording, because
an embedding hardly tells left from right (decision 0006).
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from chatscene.errors import NothingFits
from chatscene.settings import RetrievalSettings
from chatscene.snippets.compatibility import agree, compatibility, incompatibility
from chatscene.snippets.embedding import Embedder, Vectors, encode_cached
from chatscene.snippets.library import Library
from chatscene.terms.scenario import AdversaryKind, Component, Scenario, Slots
from chatscene.terms.snippet import Match, Retrieval, RuledOut, Snippet

OF_COMPONENT: dict[Component, tuple[str, ...]] = {
    Component.BEHAVIOR: ("actions",),
    Component.GEOMETRY: ("maneuver", "place", "control"),
    Component.SPAWN: ("side", "position", "place", "occluder", "leader", "blocker"),
}
CONFLICT = 1.5  # what one contradicted fact costs; more than any similarity can make up for
UNASKED = 0.12  # what one thing nobody asked for costs: an occluder, a leader, a further action
CONTRADICTED = 0.3  # confidence left by a fact that the triple contradicts: its program would not mean what was said
NO_ACTION = 0.45  # confidence left where nothing the adversary does was understood
NO_ADVERSARY = 0.3  # … or who it is
UNSAID = 0.5  # agreement of a fact that the snippet leaves open

Scores = NDArray[np.float64]


def nearest(
    text: str, component: Component, library: Library, embedder: Embedder, *, count: int
) -> list[tuple[Snippet, float]]:
    """The snippets of one component most similar to a text, with their cosines, best first."""
    snippets = library.of(component)
    similarity, _ = _similarities(text, snippets, embedder)
    best = np.argsort(-similarity, kind="stable")[:count]
    return [(snippets[i], float(similarity[i])) for i in best]


def retrieve(
    scenario: Scenario, library: Library, embedder: Embedder, settings: RetrievalSettings | None = None
) -> Retrieval:
    """Choose the compatible triple that serves a scenario best.

    Args:
        scenario: What was understood.
        library: What can be chosen.
        embedder: Measures wording.
        settings: Weights, and the confidence below which nothing is chosen.

    Raises:
        NothingFits: No triple serves it well enough; the message names the nearest.
    """
    settings = settings or RetrievalSettings()
    joint = compatibility(library)
    ranked = {
        component: _match_all(scenario, component, snippets, embedder, settings)
        for component, snippets in zip(Component, (joint.behaviors, joint.geometries, joint.spawns), strict=True)
    }
    allowed = joint.mask if scenario.slots.adversary is None else joint.of_kind(scenario.slots.adversary)
    if not allowed.any():
        raise NothingFits(f"nothing in the library has a {scenario.slots.adversary} as adversary")
    scores = [np.array([match.score for match in ranked[component]]) for component in Component]
    total = scores[0][:, None, None] + scores[1][None, :, None] + scores[2][None, None, :]
    index = np.unravel_index(int(np.argmax(np.where(allowed, total, -np.inf))), allowed.shape)
    triple = tuple(ranked[component][i] for component, i in zip(Component, index, strict=True))
    confidence = _confidence(scenario, triple)
    if confidence < settings.refuse_below:
        raise NothingFits(_refusal(scenario, triple, confidence))
    return Retrieval(
        behavior=triple[0],
        geometry=triple[1],
        spawn=triple[2],
        adversary=_adversary(scenario, triple),
        confidence=confidence,
        candidates={
            component: tuple(sorted(matches, key=lambda m: -m.score)[: settings.candidates])
            for component, matches in ranked.items()
        },
        ruled_out=_ruled_out(ranked, triple, scenario.slots.adversary),
    )


# One component


def _match_all(
    scenario: Scenario,
    component: Component,
    snippets: tuple[Snippet, ...],
    embedder: Embedder,
    settings: RetrievalSettings,
) -> list[Match]:
    similarity, texts = _similarities(scenario.parts[component], snippets, embedder)
    return [
        _match(scenario.slots, component, snippet, float(similarity[i]), texts[i], settings.similarity_weight)
        for i, snippet in enumerate(snippets)
    ]


def _match(said: Slots, component: Component, snippet: Snippet, similarity: float, text: str, weight: float) -> Match:
    parts = [_agreement(slot, getattr(said, slot), getattr(snippet.slots, slot)) for slot in OF_COMPONENT[component]]
    filled = [value for value in parts if value is not None]
    agreement = sum(filled) / len(filled) if filled else 1.0
    conflicts = tuple(
        f"{slot}: said {_words(wanted)}, does {_words(does)}"
        for slot in (*OF_COMPONENT[component], "adversary")
        if (wanted := getattr(said, slot)) not in (None, ())
        and (does := _does(snippet, slot)) not in (None, ())
        and _agreement(slot, wanted, does) == 0.0
    )
    score = weight * similarity + (1 - weight) * agreement
    score -= CONFLICT * len(conflicts) + UNASKED * _unasked(said, snippet.slots, component)
    return Match(
        snippet=snippet, similarity=similarity, agreement=agreement, score=score, nearest=text, conflicts=conflicts
    )


def _does(snippet: Snippet, slot: str) -> object:
    return snippet.adversaries if slot == "adversary" else getattr(snippet.slots, slot)


def _agreement(slot: str, said: object, does: object) -> float | None:
    """How well a snippet does one fact, in [0, 1]; None where nothing was said about it."""
    if said in (None, ()):
        return None
    if slot == "adversary":
        return 1.0 if isinstance(does, tuple) and (not does or said in does) else 0.0
    if isinstance(said, tuple) and isinstance(does, tuple):
        both, either = set(said) & set(does), set(said) | set(does)
        return (len(both) / len(said) * 2 + len(both) / len(either)) / 3
    if does is None:
        return 0.0 if isinstance(said, bool) and said else UNSAID
    return 1.0 if agree(slot, said, does) else 0.0


def _unasked(said: Slots, does: Slots, component: Component) -> int:
    """How many things a snippet brings that nobody asked for."""
    names = [slot for slot in OF_COMPONENT[component] if slot in ("occluder", "leader", "blocker", "control")]
    return sum(getattr(does, name) not in (None, False) and getattr(said, name) is None for name in names)


def _words(value: object) -> str:
    return ", ".join(map(str, value)) if isinstance(value, tuple) else str(value)


def _similarities(text: str, snippets: tuple[Snippet, ...], embedder: Embedder) -> tuple[Scores, list[str]]:
    """(N,) cosine of a text to the nearest wording of each snippet, and that wording."""
    index, owners, wordings = _index(snippets, embedder)
    cosines, rows = index.search(_query(text, embedder), len(wordings))
    best = np.full(len(snippets), -np.inf)
    nearest_text = [""] * len(snippets)
    for cosine, row in zip(cosines[0], rows[0], strict=True):  # best first: the first of each owner counts
        if best[owners[row]] == -np.inf:
            best[owners[row]] = cosine
            nearest_text[owners[row]] = wordings[row]
    return best, nearest_text


@lru_cache(maxsize=256)
def _query(text: str, embedder: Embedder) -> Vectors:
    """A text's row; geometries and spawns are put into few different words, so most are asked for again."""
    return embedder.encode([text])


@lru_cache(maxsize=8)
def _index(snippets: tuple[Snippet, ...], embedder: Embedder):
    """A faiss index over every wording of the snippets (paper, section 3.2), who owns each row, and the wordings."""
    import faiss

    wordings = [text for snippet in snippets for text in (snippet.description, *snippet.rephrasings)]
    owners = [i for i, snippet in enumerate(snippets) for _ in range(1 + len(snippet.rephrasings))]
    index = faiss.IndexFlatIP(embedder.dimension)
    index.add(encode_cached(embedder, wordings))
    return index, owners, wordings


# The triple


def _adversary(scenario: Scenario, triple: tuple[Match, ...]) -> AdversaryKind:
    """The kind that was said, or the first that behavior and spawn have in common."""
    if scenario.slots.adversary is not None:
        return scenario.slots.adversary
    behavior, _, spawn = (match.snippet for match in triple)
    return next(kind for kind in behavior.adversaries if kind in spawn.adversaries)


def _confidence(scenario: Scenario, triple: tuple[Match, ...]) -> float:
    """In [0, 1]: how much was said that we understand, how much of it the triple does, how near its wording is."""
    said = scenario.slots.said()
    understood = min(1.0, len(said) / 3) * (1.0 if scenario.slots.actions else NO_ACTION)
    understood *= 1.0 if scenario.slots.adversary is not None else NO_ADVERSARY
    facts = sum(match.agreement for match in triple) / len(triple)
    wording = (0.6 * triple[0].similarity + 0.2 * triple[1].similarity + 0.2 * triple[2].similarity - 0.2) / 0.5
    broken = CONTRADICTED ** sum(len(match.conflicts) for match in triple)
    return float(understood * broken * (0.6 * facts + 0.4 * min(max(wording, 0.0), 1.0)))


def _refusal(scenario: Scenario, triple: tuple[Match, ...], confidence: float) -> str:
    near = "; ".join(f"{m.snippet.id} ({m.similarity:.2f}): {m.snippet.description}" for m in triple)
    doubts = [*scenario.notes, *(conflict for match in triple for conflict in match.conflicts)]
    because = f" What is in doubt: {'; '.join(doubts)}." if doubts else ""
    return f"nothing in the library does this (confidence {confidence:.0%}).{because} Nearest are: {near}"


def _ruled_out(
    ranked: dict[Component, list[Match]],
    triple: tuple[Match, ...],
    kind: AdversaryKind | None,
) -> tuple[RuledOut, ...]:
    """For each component, the best-scoring snippets that beat the chosen one but fit no chosen partner."""
    chosen = {match.snippet.component: match.snippet for match in triple}
    out: list[RuledOut] = []
    for component, match in zip(Component, triple, strict=True):
        better = sorted((m for m in ranked[component] if m.score > match.score), key=lambda m: -m.score)
        for candidate in better[:2]:
            swapped = {**chosen, component: candidate.snippet}
            reason = incompatibility(*(swapped[c] for c in Component))
            if reason is None and kind is not None and candidate.snippet.adversaries:
                reason = None if kind in candidate.snippet.adversaries else f"it has no {kind}"
            out.append(RuledOut(snippet_id=candidate.snippet.id, reason=reason or "its partners score lower in sum"))
    return tuple(out)
