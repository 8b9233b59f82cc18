"""The second half of step 3: the triple that serves a scenario, with the numbers that were said set in it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from chatscene.interpret.retrieve import retrieve
from chatscene.library.bind import Triple, bound
from chatscene.library.load import library_with
from chatscene.models.encoders.embedding import load_embedder
from chatscene.settings import RetrievalSettings
from chatscene.terms.scenario import Scenario
from chatscene.terms.snippet import Retrieval, Tried


def choose(scenario: Scenario, settings: RetrievalSettings, tried: Sequence[Tried] = ()) -> tuple[Retrieval, Triple]:
    """Choose the snippets of a scenario.

    Args:
        scenario: What was understood.
        settings: Which library and encoder, and the confidence below which nothing is chosen.
        tried: Choices that did not show what was said; they are not made again.

    Returns:
        The choice with its reasons, and its snippets with every parameter narrowed to what was said.

    Raises:
        NothingFits: No triple serves it well enough, or none can be set to a number that was said.
    """
    retrieval = retrieve(scenario, library_with(settings.library), load_embedder(settings.embedder), settings, tried)
    made = bound(retrieval.snippets, scenario)
    return replace(retrieval, notes=made.notes, unused=made.unused), made.triple
