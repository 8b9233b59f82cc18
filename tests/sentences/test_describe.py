from __future__ import annotations

import pytest

from chatscene.errors import NothingFits
from chatscene.interpret.asked import scenario_of
from chatscene.library.compatibility import incompatibility
from chatscene.library.load import load_library
from chatscene.models.encoders.embedding import load_embedder
from chatscene.sentences.describe import describe, diversity, joined, misread
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.acts import Action
from chatscene.terms.conclusions import base_of
from chatscene.terms.scenario import BaseScenario, Place, Position, Side, Slots


@pytest.mark.parametrize("base", BaseScenario)
def test_descriptions_belong_to_their_base_scenario_and_can_be_joined(base: BaseScenario) -> None:
    library = load_library()
    made = describe(base, 3, library=library, seed=0)
    assert len(made) == 3
    assert len({d.snippet_ids for d in made}) == len({d.text for d in made}) == 3
    for description in made:
        behavior, geometry, spawn = (library.get(snippet_id) for snippet_id in description.snippet_ids)
        assert incompatibility(behavior, geometry, spawn) is None
        assert description.adversary in behavior.adversaries
        assert description.adversary in spawn.adversaries
        assert base_of(description.slots) is description.base is base


def test_descriptions_are_read_as_they_are_meant() -> None:
    for description in describe(BaseScenario.TURNING_OBSTACLE, 3, library=load_library(), seed=1):
        heard = scenario_of(description.text)
        assert heard.base is description.base
        assert misread(heard.slots, description.slots) is None


def test_the_same_seed_describes_the_same() -> None:
    one, same, other = (describe(None, 2, library=load_library(), seed=seed) for seed in (3, 3, 4))
    assert one == same
    assert one != other


def test_no_behavior_comes_twice_while_others_wait() -> None:
    made = describe(BaseScenario.STRAIGHT_OBSTACLE, 6, library=load_library(), seed=0)
    assert len({d.snippet_ids[0] for d in made}) == 6
    assert len({d.adversary for d in made}) >= 3


def test_without_a_base_scenario_all_of_them_occur() -> None:
    made = describe(None, 16, library=load_library(), seed=0)
    assert len({d.base for d in made}) >= 6


def test_an_instruction_restricts_who_and_where() -> None:
    made = describe(None, 3, library=load_library(), seed=0, instruction="dangerous cyclists at junctions")
    assert {d.adversary for d in made} == {AdversaryKind.BICYCLE}
    assert {d.slots.place for d in made} <= {Place.JUNCTION, Place.THREE_WAY, Place.FOUR_WAY}


def test_an_instruction_restricts_the_side_and_the_action() -> None:
    made = describe(None, 2, library=load_library(), seed=0, instruction="pedestrians who cross from the left and stop")
    assert {d.slots.side for d in made} == {Side.LEFT}
    assert all({Action.CROSS, Action.STOP} <= set(d.slots.actions) for d in made)


def test_vehicles_are_more_than_cars() -> None:
    made = describe(BaseScenario.RIGHT_TURN, 3, library=load_library(), seed=0, instruction="vehicles that brake")
    assert len({d.adversary for d in made}) > 1


def test_a_plural_is_no_group_and_a_parked_bus_no_adversary() -> None:
    made = describe(None, 3, library=load_library(), seed=0, instruction="pedestrians behind a parked bus")
    assert {d.adversary for d in made} == {AdversaryKind.PEDESTRIAN}
    assert not all(d.slots.group for d in made)


def test_emergency_vehicles_are_not_all_vehicles() -> None:
    made = describe(None, 1, library=load_library(), seed=0, instruction="emergency vehicles")
    assert {d.adversary for d in made} == {AdversaryKind.EMERGENCY_VEHICLE}


@pytest.mark.parametrize("instruction", ["something nice", "xyzzy"])
def test_an_instruction_that_says_nothing_is_refused(instruction: str) -> None:
    with pytest.raises(NothingFits, match="name who"):
        describe(None, 3, library=load_library(), seed=0, instruction=instruction)


def test_what_the_library_has_not_is_refused() -> None:
    with pytest.raises(NothingFits, match="ask for less"):
        describe(
            BaseScenario.RED_LIGHT_RUNNING, 3, library=load_library(), seed=0, instruction="pedestrians who turn back"
        )


def test_the_more_exact_place_counts_in_a_joined_triple() -> None:
    library = load_library()
    triple = [
        library.get(i) for i in ("behavior/junction-cross", "geometry/straight-signalised", "spawn/crossing-from-left")
    ]
    facts = joined(triple, AdversaryKind.CAR)
    assert (facts.place, facts.side, facts.position) == (Place.FOUR_WAY, Side.LEFT, Position.CROSSING)


@pytest.mark.parametrize(
    ("read", "fact"),
    [
        (Slots(adversary=AdversaryKind.BUS, actions=(Action.BRAKE,)), "adversary"),
        (Slots(adversary=AdversaryKind.CAR, actions=()), "actions"),
        (Slots(adversary=AdversaryKind.CAR, actions=(Action.BRAKE, Action.SWERVE)), "actions"),
        (Slots(adversary=AdversaryKind.CAR, actions=(Action.BRAKE,), place=Place.ROAD), "place"),
        (Slots(adversary=AdversaryKind.CAR, actions=(Action.BRAKE,), side=Side.LEFT), "side"),
        (Slots(adversary=AdversaryKind.CAR, actions=(Action.BRAKE,), group=True), "group"),
    ],
)
def test_a_reading_that_says_more_is_a_misreading(read: Slots, fact: str) -> None:
    meant = Slots(adversary=AdversaryKind.CAR, actions=(Action.BRAKE, Action.STOP), place=Place.FOUR_WAY)
    assert (misread(read, meant) or "").startswith(fact)


def test_a_reading_that_says_less_is_none() -> None:
    meant = Slots(adversary=AdversaryKind.CAR, actions=(Action.BRAKE, Action.STOP), place=Place.FOUR_WAY)
    read = Slots(adversary=AdversaryKind.CAR, actions=(Action.BRAKE, Action.FOLLOW), place=Place.JUNCTION)
    assert misread(read, meant) is None


def test_diversity_counts_parts_and_measures_words() -> None:
    made = describe(BaseScenario.LANE_CHANGING, 6, library=load_library(), seed=0)
    varied, flat = diversity(made, load_embedder()), diversity((made[0],) * 6, load_embedder())
    assert varied.behaviors == 6
    assert flat.behaviors == flat.kinds == 1
    assert varied.distance > 0.2 > flat.distance == pytest.approx(0.0, abs=1e-5)
    assert varied.distinct_2 > flat.distinct_2
