"""The packaged library: enough for the paper's eight base scenarios, and written by its own rules."""

from __future__ import annotations

import re
from collections import Counter

import pytest

from chatscene.library.compatibility import compatibility, incompatibility
from chatscene.library.load import load_library
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.acts import Action
from chatscene.terms.scenario import Component, Control, Maneuver, Occluder, Position, Side
from chatscene.terms.snippet import Snippet

LIBRARY = load_library()

# Per base scenario, what one sentence of its kind needs: behavior, geometry, spawn, adversary.
SERVED = [
    ("cross-and-stop", "straight-road", "roadside-right", "pedestrian"),
    ("sprint-and-stop", "straight-road", "behind-bus-stop-right", "pedestrian"),
    ("stop-then-diagonal", "straight-road", "roadside-left", "pedestrian"),
    ("cross-and-stop", "straight-road", "behind-parked-car-right", "pedestrian"),
    ("sprint-and-stop", "straight-road", "behind-vending-machine-right", "pedestrian"),
    ("feint-at-edge", "left-turn", "entry-corner-right", "motorcycle"),
    ("cross-and-stop", "left-turn", "exit-corner-right", "pedestrian"),
    ("cross-and-stop", "right-turn", "entry-corner-left", "pedestrian"),
    ("rider-brakes-midway", "left-turn", "entry-corner-left", "bicycle"),
    ("cross-and-stop", "right-turn", "exit-corner-right", "motorcycle"),
    ("merge-into-original-lane", "lane-change-left", "adjacent-lane-ahead-leader", "car"),
    ("pace-ego", "lane-change-right", "right-lane-level", "car"),
    ("lane-brake", "lane-change-right", "right-lane-ahead-leader", "car"),
    ("weave-between-lanes", "lane-change-left", "adjacent-lane-ahead-leader", "car"),
    ("match-leader", "lane-change-left", "adjacent-lane-ahead-leader", "car"),
    ("cross", "bypass", "roadside-left-beyond-blocker", "pedestrian"),
    ("oncoming-rider-swerve", "bypass", "oncoming-beyond-blocker", "motorcycle"),
    ("oncoming-turn-in", "bypass", "oncoming-beyond-blocker", "car"),
    ("oncoming-accelerate", "bypass", "oncoming-beyond-blocker", "car"),
    ("oncoming-enter-and-stop", "bypass", "oncoming-on-foot-beyond-blocker", "pedestrian"),
    ("run-light-accelerate", "straight-signalised", "crossing-from-left", "car"),
    ("run-light-turn-right", "straight-signalised", "crossing-from-left", "car"),
    ("run-light-turn-left", "straight-signalised", "crossing-from-left", "car"),
    ("run-light-brake", "straight-signalised", "crossing-from-right", "car"),
    ("junction-cut-off", "straight-signalised", "crossing-from-left", "car"),
    ("junction-accelerate", "unprotected-left-turn", "oncoming-at-junction", "car"),
    ("junction-brake", "unprotected-left-turn", "oncoming-at-junction", "car"),
    ("last-second-right-turn", "unprotected-left-turn", "oncoming-at-junction", "car"),
    ("junction-veer", "unprotected-left-turn", "oncoming-at-junction", "car"),
    ("junction-crawl", "unprotected-left-turn", "crossing-from-right", "car"),
    ("junction-accelerate", "right-turn", "crossing-from-left", "car"),
    ("lane-brake", "right-turn", "kerb-ahead-right", "car"),
    ("lane-reverse", "right-turn", "kerb-ahead-right", "car"),
    ("accelerate-then-brake", "right-turn", "kerb-behind-right", "car"),
    ("junction-swerve-right", "right-turn", "crossing-from-left", "car"),
    ("junction-accelerate-and-stop", "straight-unsignalised", "crossing-from-left", "car"),
    ("junction-accelerate-and-stop", "straight-unsignalised", "crossing-from-right", "car"),
    ("junction-turn-left-and-stop", "straight-unsignalised", "oncoming-at-junction", "car"),
    ("junction-turn-left-and-stop", "straight-unsignalised", "crossing-from-right", "car"),
    ("junction-crawl", "straight-unsignalised", "crossing-from-right", "car"),
]


def triple(behavior: str, geometry: str, spawn: str) -> tuple[Snippet, Snippet, Snippet]:
    return (
        LIBRARY.get(f"behavior/{behavior}"),
        LIBRARY.get(f"geometry/{geometry}"),
        LIBRARY.get(f"spawn/{spawn}"),
    )


@pytest.mark.parametrize(("behavior", "geometry", "spawn", "kind"), SERVED)
def test_each_situation_of_the_paper_has_a_compatible_triple(
    behavior: str, geometry: str, spawn: str, kind: str
) -> None:
    parts = triple(behavior, geometry, spawn)
    assert incompatibility(*parts) is None
    assert AdversaryKind(kind) in parts[0].adversaries
    assert AdversaryKind(kind) in parts[2].adversaries


@pytest.mark.parametrize(
    ("behavior", "geometry", "spawn"),
    [
        ("cross", "straight-road", "crossing-from-left"),  # a walker has no way through a junction
        ("match-leader", "lane-change-left", "adjacent-lane-ahead"),  # no leader to match
        ("cut-in", "straight-road", "ahead-in-lane"),  # not beside the ego
        ("run-light", "straight-unsignalised", "crossing-from-left"),  # no light
        ("run-light", "straight-signalised", "oncoming-at-junction"),  # oncoming traffic has green
        ("oncoming-drive", "straight-two-way", "roadside-right"),
        ("cross", "bypass", "oncoming-on-foot-beyond-blocker"),  # faces along the road
        ("cross", "straight-road", "exit-corner-right"),  # no junction
        ("pace-ego", "lane-change-left", "right-lane-level"),  # the lane on the wrong side
    ],
)
def test_what_makes_no_sense_together_is_incompatible(behavior: str, geometry: str, spawn: str) -> None:
    assert incompatibility(*triple(behavior, geometry, spawn)) is not None


def test_the_library_has_the_size_that_was_promised() -> None:
    sizes = {component: len(LIBRARY.of(component)) for component in Component}
    assert sizes[Component.BEHAVIOR] >= 36
    assert sizes[Component.GEOMETRY] >= 14
    assert sizes[Component.SPAWN] >= 20


def test_every_action_occluder_position_side_and_manoeuvre_has_a_snippet() -> None:
    slots = [snippet.slots for snippet in LIBRARY]
    assert {action for s in slots for action in s.actions} | {Action.STAND, Action.NARROW} == set(Action)
    assert {s.occluder for s in slots} >= set(Occluder)
    assert {s.position for s in slots} >= set(Position)
    assert {s.side for s in slots} >= set(Side)
    assert {s.maneuver for s in slots} >= set(Maneuver)
    assert {s.control for s in slots} >= set(Control)


def test_every_snippet_fits_at_least_one_triple() -> None:
    joined = compatibility(LIBRARY)
    shelves = ((joined.behaviors, (1, 2)), (joined.geometries, (0, 2)), (joined.spawns, (0, 1)))
    used = {shelf[i].id for shelf, others in shelves for i in joined.mask.any(axis=others).nonzero()[0]}
    used |= {"spawn/on-foot-ahead"}  # of those alone who walk there, who are composed, as are all who stand:
    used |= {s.id for s in LIBRARY.of(Component.SPAWN) if "advStill" in s.requires}
    assert used == {s.id for s in LIBRARY}


def test_no_text_stands_for_two_snippets_of_a_component() -> None:
    for component in Component:
        texts = Counter(text.casefold() for s in LIBRARY.of(component) for text in (s.description, *s.rephrasings))
        assert [text for text, count in texts.items() if count > 1] == []


def words(text: str) -> set[str]:
    return set(re.findall(r"[a-z]{4,}", text.casefold()))


@pytest.mark.parametrize("snippet", LIBRARY.snippets, ids=lambda s: s.id)
def test_most_rephrasings_use_other_words_than_the_description(snippet: Snippet) -> None:
    said = words(snippet.description)
    assert sum(len(words(text) - said) >= 2 for text in snippet.rephrasings) >= 3


def test_parameters_of_different_components_never_share_a_name() -> None:
    of = {c: {p.name for s in LIBRARY.of(c) for p in s.parameters} for c in Component}
    assert not of[Component.BEHAVIOR] & of[Component.SPAWN]
    assert not of[Component.GEOMETRY]


def test_every_parameter_says_what_it_means() -> None:
    assert [f"{s.id} {p.name}" for s in LIBRARY for p in s.parameters if not p.meaning] == []
