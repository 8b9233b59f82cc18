"""What follows from facts."""

from __future__ import annotations

from chatscene.terms.actors import AdversaryKind
from chatscene.terms.acts import Action
from chatscene.terms.conclusions import leaving_first
from chatscene.terms.scenario import Maneuver, Position, Slots

STANDS = Slots(adversary=AdversaryKind.TRUCK, actions=(Action.STAND,), position=Position.AHEAD)
LEAVES = Slots(adversary=AdversaryKind.CAR, actions=(Action.CHANGE_LANE,), position=Position.AHEAD)


def told(first: Slots, then: Slots) -> Slots:
    return Slots(
        adversary=first.adversary,
        actions=first.actions,
        position=first.position,
        maneuver=Maneuver.STRAIGHT,
        others=(then,),
    )


def test_who_leaves_the_lane_is_the_adversary_and_whom_it_hid_is_beside_it() -> None:
    assert leaving_first(told(STANDS, LEAVES)) == told(LEAVES, STANDS)


def test_where_that_was_told_so_nothing_changes() -> None:
    assert leaving_first(told(LEAVES, STANDS)) == told(LEAVES, STANDS)


def test_who_does_something_sudden_stays_the_adversary() -> None:
    brakes = Slots(adversary=AdversaryKind.BUS, actions=(Action.BRAKE,), position=Position.AHEAD)
    assert leaving_first(told(brakes, LEAVES)) == told(brakes, LEAVES)
