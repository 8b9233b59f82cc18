"""The second half of step 3: the triple that serves a scenario, with the numbers that were said set in it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from chatscene.errors import NothingFits
from chatscene.interpret.paper import nearest_triple
from chatscene.interpret.retrieve import does_all, retrieve
from chatscene.library.bind import Triple, bound
from chatscene.library.load import library_with
from chatscene.settings import PAPER_READER, RetrievalSettings
from chatscene.terms.scenario import Scenario, Slots, Unused, Why
from chatscene.terms.snippet import Retrieval, Tried


def choose(scenario: Scenario, settings: RetrievalSettings, tried: Sequence[Tried] = ()) -> tuple[Retrieval, Triple]:
    """Choose the snippets of a scenario.

    Returns:
        The choice with its reasons, and its snippets with every parameter narrowed to what was said.

    Raises:
        NothingFits: No triple serves it well enough, or none can be set to a number that was said.
    """
    if settings.reader == PAPER_READER:
        found = nearest_triple(scenario.parts, scenario.slots.adversary, settings, tried)
        return found, found.snippets
    found = retrieve(scenario, library_with(settings.library), settings, tried)
    _refuse_another(scenario, found)
    return _bound(found, scenario)


def _refuse_another(scenario: Scenario, found: Retrieval) -> None:
    """Refuse what does not do all that was said, in order, where it is sure that nothing else was said."""
    said = scenario.slots
    if scenario.frame is None:
        return
    if said.others:
        others = "; ".join(map(_in_words, said.others))
        raise _none_for(found, f"no snippet has another road user beside the adversary ({others})")
    if not does_all(found.behavior.snippet, said.actions):
        raise _none_for(found, f"no snippet does all of it, in this order: {_in_words(said)}")


def _in_words(one: Slots) -> str:
    return f"{one.adversary} {', then '.join(one.actions)}"


def _none_for(found: Retrieval, reason: str) -> NothingFits:
    return NothingFits(
        f"nothing in the library does this: {reason}",
        reasons=(reason,),
        confidence=found.confidence,
        nearest={snippet.id: snippet.description for snippet in found.snippets},
    )


def _bound(retrieval: Retrieval, scenario: Scenario) -> tuple[Retrieval, Triple]:
    made = bound(retrieval.snippets, scenario)
    if made.unused and scenario.frame is not None:
        said = ", ".join(repr(one.said) for one in made.unused)
        raise _none_for(retrieval, f"{said}: nothing that fits the rest can be set to it")
    ego = scenario.frame.ego_speed if scenario.frame is not None else None
    unused = (*made.unused, *((Unused(said=ego.said, why=Why.NUMBER),) if ego is not None else ()))
    return replace(retrieval, notes=(*retrieval.notes, *made.notes), unused=unused), made.triple
