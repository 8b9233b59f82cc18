"""A triple by wording alone: the paper's own way from a text to snippets.

Paper: section 3.3, steps ii and iii: a sub-description per component, embedded, and the snippet whose description is
nearest to it. There a language model writes the sub-descriptions; here they are the adversary's clause, and what
whoever reads makes out of the rest, in the words of the library. There each snippet is the nearest of its component,
and many such triples cannot be joined (decision 0006); here the nearest that can be joined are taken.
Nothing is weighed, doubted or refused: what the triple does is what was read.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from chatscene.interpret.joint_choice import highest, none_left
from chatscene.interpret.nearest import cosines
from chatscene.interpret.wording import parts_of
from chatscene.library.bind import does
from chatscene.library.compatibility import compatibility
from chatscene.library.load import Library, library_with
from chatscene.models.encoders.embedding import load_embedder
from chatscene.settings import RetrievalSettings
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.frame import Frame
from chatscene.terms.scenario import Component, SubDescriptions
from chatscene.terms.snippet import Match, Retrieval, Snippet, Tried

Cosines = NDArray[np.float64]


def read_as_in_paper(frame: Frame, settings: RetrievalSettings) -> tuple[Frame, SubDescriptions]:
    """A text whose facts are those of the nearest triple, and the sub-descriptions by which that was found.

    Raises:
        NothingFits: No triple has the kind of road user that was said.
    """
    parts = parts_of(frame, frame.outright)
    found = nearest_triple(parts, frame.outright.adversary, settings)
    return replace(frame, outright=does(found.snippets, found.adversary), sure=1.0, readings=()), parts


def nearest_triple(
    parts: SubDescriptions, kind: AdversaryKind | None, settings: RetrievalSettings, tried: Sequence[Tried] = ()
) -> Retrieval:
    """The triple whose descriptions have the greatest sum of cosines with the sub-descriptions.

    Returns:
        The choice. Its confidence is the mean of the three cosines, which is no probability.

    Raises:
        NothingFits: There is no such triple.
    """
    library, embedder = library_with(settings.library), load_embedder(settings.embedder)
    scores = {c: cosines(parts[c], library.of(c), embedder) for c in Component}
    joint = compatibility(library)
    at = highest(joint, [scores[c] for c in Component], joint.able(kind), tried)
    if at is None:
        raise none_left(kind, tried)
    behavior, geometry, spawn = (_match(library, c, scores[c], i) for c, i in zip(Component, at, strict=True))
    return Retrieval(
        behavior=behavior,
        geometry=geometry,
        spawn=spawn,
        adversary=kind or _common(behavior.snippet, spawn.snippet),
        confidence=float(np.mean([one.similarity for one in (behavior, geometry, spawn)])),
        candidates={c: _best(library, c, scores[c], settings.candidates) for c in Component},
        tried=tuple(tried),
        notes=("found by wording alone, as in the paper; the confidence is the mean cosine, no probability",),
    )


def _best(library: Library, component: Component, scores: Cosines, count: int) -> tuple[Match, ...]:
    best = np.argsort(-scores, kind="stable")[:count].tolist()
    return tuple(_match(library, component, scores, i) for i in best)


def _match(library: Library, component: Component, scores: Cosines, i: int) -> Match:
    snippet, near = library.of(component)[i], float(scores[i])
    return Match(snippet=snippet, similarity=near, agreement=0.0, score=near, nearest=snippet.description, conflicts=())


def _common(behavior: Snippet, spawn: Snippet) -> AdversaryKind:
    """The first kind of road user that both can have."""
    return next(kind for kind in behavior.adversaries if kind in spawn.adversaries)
