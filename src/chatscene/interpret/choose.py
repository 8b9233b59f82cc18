"""The second half of step 3: the triple that serves a scenario, with the numbers that were said set in it."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import replace

from chatscene.errors import NothingFits
from chatscene.interpret.retrieve import does_all, does_just, retrieve
from chatscene.library.bind import Triple, bound
from chatscene.library.compose import Asked, compose, goes_without_saying
from chatscene.library.load import library_with
from chatscene.models.encoders.embedding import load_embedder
from chatscene.settings import RetrievalSettings
from chatscene.terms.conclusions import JUNCTIONS
from chatscene.terms.scenario import Scenario
from chatscene.terms.snippet import Retrieval, Snippet, Tried


def choose(scenario: Scenario, settings: RetrievalSettings, tried: Sequence[Tried] = ()) -> tuple[Retrieval, Triple]:
    """Choose the snippets of a scenario; a behavior that does just what was said is composed if none does.

    Args:
        scenario: What was understood.
        settings: Which library and encoder, and the confidence below which nothing is chosen.
        tried: Choices that did not show what was said; they are not made again.

    Returns:
        The choice with its reasons, and its snippets with every parameter narrowed to what was said.

    Raises:
        NothingFits: No triple serves it well enough, or none can be set to a number that was said.
    """
    library, embedder = library_with(settings.library), load_embedder(settings.embedder)
    found: Retrieval | NothingFits
    try:
        found = retrieve(scenario, library, embedder, settings, tried)
    except NothingFits as error:
        found = error
    if (composed := _composed(scenario, found, tried)) is not None:
        with suppress(NothingFits):
            own = retrieve(scenario, library, embedder, settings, tried, composed)
            return _bound(own, scenario, "no snippet does just this: the behavior is composed of its acts")
    if isinstance(found, NothingFits):
        raise found
    _refuse_another(scenario, found)
    return _bound(found, scenario)


def _composed(scenario: Scenario, found: Retrieval | NothingFits, tried: Sequence[Tried]) -> Snippet | None:
    """A behavior that does just what was said; None if words leave it open, a snippet does it, or it was tried."""
    slots = scenario.slots
    if scenario.frame is None or not scenario.frame.plain or slots.adversary is None:
        return None
    position = slots.position
    if isinstance(found, Retrieval):
        position = position or found.spawn.snippet.slots.position
    if position is None:
        return None
    junction = slots.place in JUNCTIONS
    asked = Asked(kind=slots.adversary.acts_as, position=position, actions=slots.actions, junction=junction)
    unsaid = goes_without_saying(asked)
    if isinstance(found, Retrieval) and does_just(found.behavior.snippet, slots.actions, unsaid):
        return None
    made = compose(asked)
    return None if made is None or any(made.id in one.snippet_ids for one in tried) else made


def _refuse_another(scenario: Scenario, found: Retrieval) -> None:
    """Refuse what does not do all that was said, in order, where it is sure that nothing else was said.

    Raises:
        NothingFits: Neither a snippet does it, nor are there steps for it.
    """
    frame, actions = scenario.frame, scenario.slots.actions
    if frame is None or not frame.plain or does_all(found.behavior.snippet, actions):
        return
    kind = scenario.slots.adversary
    reason = f"no snippet, and no steps that a plan could be composed of: {kind} {', then '.join(actions)}"
    raise NothingFits(
        f"nothing in the library does this: {reason}",
        reasons=(reason,),
        confidence=found.confidence,
        nearest={snippet.id: snippet.description for snippet in found.snippets},
    )


def _bound(retrieval: Retrieval, scenario: Scenario, *notes: str) -> tuple[Retrieval, Triple]:
    made = bound(retrieval.snippets, scenario)
    return replace(retrieval, notes=(*notes, *made.notes), unused=made.unused), made.triple
