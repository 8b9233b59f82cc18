"""The second half of step 3: the triple that serves a scenario, with the numbers that were said set in it."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import replace

from chatscene.errors import NothingFits
from chatscene.interpret.paper import nearest_triple
from chatscene.interpret.retrieve import does_all, does_just, retrieve
from chatscene.library.beside import placed_beside, reveals
from chatscene.library.bind import Triple, bound, narrowed, settable
from chatscene.library.compatibility import agree, contradiction, incompatibility
from chatscene.library.compose import Asked, compose, goes_without_saying
from chatscene.library.load import Library, library_with
from chatscene.settings import PAPER_READER, RetrievalSettings
from chatscene.terms.conclusions import CURVES, JUNCTIONS
from chatscene.terms.plan import Plan, waits_for_ego
from chatscene.terms.plan_text import plan_of
from chatscene.terms.scenario import Component, Distance, EgoState, Maneuver, Position, Scenario, Slots, Unused, Why
from chatscene.terms.slots import SLOTS
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
    if settings.reader == PAPER_READER:
        found = nearest_triple(scenario.parts, scenario.slots.adversary, settings, tried)
        return found, found.snippets
    library = library_with(settings.library)
    found: Retrieval | NothingFits
    try:
        found = retrieve(scenario, library, settings, tried)
    except NothingFits as error:
        found = error
    if (composed := _composed(scenario, found, tried)) is not None:
        with suppress(NothingFits):
            own = _with_others(retrieve(scenario, library, settings, tried, composed), scenario, library)
            return _bound(own, scenario, "no snippet does just this: the behavior is composed of its acts")
    if isinstance(found, NothingFits):
        raise found
    _refuse_another(scenario, found)
    return _bound(_with_others(found, scenario, library), scenario)


def _composed(scenario: Scenario, found: Retrieval | NothingFits, tried: Sequence[Tried]) -> Snippet | None:
    """A behavior that does just what was said; None if it was left open, a snippet does it, or it was tried."""
    slots = scenario.slots
    if scenario.frame is None or slots.adversary is None:
        return None
    position = slots.position
    if isinstance(found, Retrieval):
        position = position or found.spawn.snippet.slots.position
    if position is None:
        return None
    junction = slots.place in JUNCTIONS
    held = slots.ego is EgoState.STANDS
    asked = Asked(
        kind=slots.adversary.acts_as,
        position=position,
        actions=slots.actions,
        junction=junction,
        ego_stands=held,
    )
    unsaid = goes_without_saying(asked)
    if (
        isinstance(found, Retrieval)
        and does_just(found.behavior.snippet, slots.actions, unsaid)
        and all(settable(one, found.snippets, slots.adversary) for one in scenario.frame.quantities)
        and not (held and _waits_for_ego(found.behavior.snippet))
    ):
        return None
    made = compose(asked)
    return None if made is None or any(made.id in one.snippet_ids for one in tried) else made


def _waits_for_ego(behavior: Snippet) -> bool:
    plan = plan_of(behavior)
    return isinstance(plan, Plan) and waits_for_ego(plan)


def _refuse_another(scenario: Scenario, found: Retrieval) -> None:
    """Refuse what does not do all that was said, in order, where it is sure that nothing else was said.

    Raises:
        NothingFits: Neither a snippet does it, nor are there steps for it.
    """
    frame, actions = scenario.frame, scenario.slots.actions
    if frame is None or does_all(found.behavior.snippet, actions):
        return
    kind = scenario.slots.adversary
    reason = f"no snippet, and no steps that a plan could be composed of: {kind} {', then '.join(actions)}"
    raise _none_for(found, reason)


def _with_others(found: Retrieval, scenario: Scenario, library: Library) -> Retrieval:
    """The choice with everybody in its spawn who does something beside the adversary.

    Raises:
        NothingFits: There are no steps for what one does, or no place where all can start.
    """
    for said in scenario.slots.others:
        found = _with_other(found, said, scenario.slots, library)
    return found


def _with_other(found: Retrieval, said: Slots, slots: Slots, library: Library) -> Retrieval:
    behavior, chosen, spawn = found.snippets
    who = f"{said.adversary}: {', then '.join(said.actions)}"
    if said.adversary is None or said.position is None:
        raise _none_for(found, f"where another road user starts was not said ({who})")
    asked = Asked(
        kind=said.adversary.acts_as,
        position=said.position,
        actions=said.actions,
        junction=slots.place in JUNCTIONS,
        ego_stands=slots.ego is EgoState.STANDS,
    )
    composed = compose(asked)
    if composed is None:
        raise _none_for(found, f"no steps that a plan of another road user could be composed of ({who})")
    places = [
        place
        for place in library.of(Component.SPAWN)
        if place.slots.position is said.position and agree(said.side, place.slots.side) and _plain_start(place)
    ]
    geometries = sorted(
        (
            g
            for g in library.of(Component.GEOMETRY)
            if g.slots.site is slots.site and contradiction(slots, g.slots) is None
        ),
        key=lambda g: (
            g.id != chosen.id,
            g.slots.maneuver is not (slots.maneuver or Maneuver.STRAIGHT),
            g.slots.place in CURVES,
            len(g.slots.said()),
        ),
    )
    pairs = [
        (place, geometry)
        for geometry in geometries
        if incompatibility(behavior, geometry, spawn) is None
        for place in places
        if incompatibility(composed, geometry, place) is None
    ]
    if not pairs:
        raise _none_for(found, f"no place where both can start ({who})")
    first = pairs[0][1]
    in_way = said.position is Position.AHEAD and all(action.row.stands for action in said.actions)
    # A place that asks for what only this behavior tells is made for it.
    told = set(composed.provides) - {"AdvBehavior"}
    behind = said.position is slots.position or in_way  # the other is the farther one
    place = min(
        (place for place, geometry in pairs if geometry is first),
        key=lambda place: (
            not told & set(place.requires),
            said.side is not None and place.slots.side is None,
            (place.slots.distance is Distance.FAR) is not behind,
            len(place.slots.said()),
            place.id,
        ),
    )
    if reveals(spawn, asked):
        behavior = narrowed((behavior, first, spawn), _sooner(behavior))[0]
    return replace(
        found,
        behavior=replace(found.behavior, snippet=behavior),
        geometry=replace(found.geometry, snippet=first),
        spawn=replace(found.spawn, snippet=placed_beside(spawn, replace(asked, kind=said.adversary), place)),
        notes=(*found.notes, f"beside the adversary: {who}"),
    )


def _sooner(behavior: Snippet) -> dict[str, tuple[float, float]]:
    """The half of its range in which a behavior acts sooner, so that it acts before it comes to who stands there."""
    triggers = (p for p in behavior.parameters if p.name == "OPT_ADV_DISTANCE")
    return {p.name: (round((p.low + p.high) / 2, 3), p.high) for p in triggers}


def _plain_start(place: Snippet) -> bool:
    """Whether nothing but somebody's start is in a spawn."""
    return not any(getattr(place.slots, name) for name, slot in SLOTS.items() if slot.about)


def _none_for(found: Retrieval, reason: str) -> NothingFits:
    return NothingFits(
        f"nothing in the library does this: {reason}",
        reasons=(reason,),
        confidence=found.confidence,
        nearest={snippet.id: snippet.description for snippet in found.snippets},
    )


def _bound(retrieval: Retrieval, scenario: Scenario, *notes: str) -> tuple[Retrieval, Triple]:
    made = bound(retrieval.snippets, scenario)
    if made.unused and scenario.frame is not None:
        said = ", ".join(repr(one.said) for one in made.unused)
        raise _none_for(retrieval, f"{said}: nothing that fits the rest can be set to it")
    ego = scenario.frame.ego_speed if scenario.frame is not None else None
    unused = (*made.unused, *((Unused(said=ego.said, why=Why.NUMBER),) if ego is not None else ()))
    return replace(retrieval, notes=(*notes, *retrieval.notes, *made.notes), unused=unused), made.triple
