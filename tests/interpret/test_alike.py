"""Kinds of road users that no snippet names are served by those of the kind that they are like."""

from __future__ import annotations

import pytest

from chatscene import pipeline
from chatscene.ego.policy import load_ego
from chatscene.maps.network import resolve_map
from chatscene.program.check import check
from chatscene.settings import SimulationSettings
from chatscene.simulate.simulator import load_simulator
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.acts import Action
from chatscene.terms.episode import Role
from outright import decompose

SAID = [
    ("A dog crosses the road from the right.", AdversaryKind.DOG, Action.CROSS),
    ("A deer jumps onto the road from the left and stops.", AdversaryKind.DEER, Action.STOP),
    ("A man in a wheelchair crosses from the left in front of us.", AdversaryKind.WHEELCHAIR, Action.CROSS),
    ("An e-scooter cuts across from the left while we turn right.", AdversaryKind.E_SCOOTER, Action.CROSS),
]


@pytest.mark.parametrize(("text", "kind", "act"), SAID)
def test_a_kind_that_is_like_another_is_read_served_and_driven_as_itself(
    text: str, kind: AdversaryKind, act: Action
) -> None:
    understood = pipeline.understand(text)
    retrieval = understood.retrieval
    assert retrieval is not None
    assert understood.scenario.slots.adversary is retrieval.adversary is kind
    assert act in understood.scenario.slots.actions
    assert kind.acts_as in retrieval.behavior.snippet.adversaries
    simulator = load_simulator(resolve_map("town"), SimulationSettings())
    checked = check(understood.program, understood.scenario.slots, simulator, load_ego("rule-based"))
    (adversary,) = (track for track in checked.episodes[0].tracks if track.role is Role.ADVERSARY)
    assert adversary.kind == kind.row.scenic
    assert (adversary.length, adversary.width) == (kind.row.limits.length, kind.row.limits.width)
    assert abs(adversary.speed).max() <= kind.row.limits.top_speed + 1e-9


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("A scooter overtakes us and brakes.", AdversaryKind.MOTORCYCLE),
        ("A cyclist crosses from the right.", AdversaryKind.BICYCLE),
        ("A girl on an e-scooter crosses from the right.", AdversaryKind.E_SCOOTER),
        ("An old man in an electric wheelchair crosses from the right.", AdversaryKind.WHEELCHAIR),
    ],
)
def test_whoever_is_named_by_several_words_is_of_the_kind_of_all_of_them(text: str, kind: AdversaryKind) -> None:
    assert decompose(text).slots.adversary is kind
