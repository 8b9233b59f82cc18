"""The driver that looks ahead, on streets drawn by hand."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray

from chatscene.ego.observation import AHEAD, OBSERVATIONS, OWN, PER_ACTOR, ROAD
from chatscene.ego.planner import ACCELERATION, HARDENED, HARDENED_AT_SPEED, SHIFT, Caution, Planner, carried_out
from chatscene.ego.policy import load_ego
from chatscene.terms.actors import LIMITS

Array = NDArray[np.float64]


WISH = Caution().speed


def street(
    *actors: list[float], speed: float = WISH, offset: float = 0.0, room: tuple[float, float] = (8.0, 8.0)
) -> Array:
    """A straight street, and who is on it."""
    observation = np.zeros(OBSERVATIONS["road"])
    observation[ROAD:] = room
    observation[:4] = (speed, offset, 0.0, 100.0)
    observation[4:OWN] = [x for ahead in AHEAD for x in (ahead, -offset)]
    for i, row in enumerate(actors):
        observation[OWN + i * PER_ACTOR :][:PER_ACTOR] = row
    return observation


def car(along: float, beside: float, speed: float = 0.0) -> list[float]:
    return [1.0, along, beside, along, beside, speed, 0.0, 0.0, 2.45, 1.05, 0.0]


def walker(along: float, beside: float, across: float = 0.0) -> list[float]:
    return [1.0, along, beside, along, beside, 0.0, across, np.pi / 2, 0.3, 0.3, 1.0]


def test_an_empty_street_is_driven_at_the_wanted_speed_along_the_route() -> None:
    assert Planner().act(street()) == pytest.approx((0.0, 0.0), abs=1e-6)
    assert Planner().act(street(speed=WISH - 2.0))[0] > 0.4
    assert Planner().act(street(speed=WISH + 3.0))[0] < 0.0


def test_no_way_leads_off_the_driving_lanes() -> None:
    lane = (5.25, 1.75)  # there is another lane on the left
    for way, shift in enumerate(SHIFT):
        steered = carried_out(street(room=lane), way, WISH)[1]
        free = carried_out(street(), way, WISH)[1]
        assert steered == free if shift >= -0.5 else 0.0 < steered < free


def test_it_passes_on_a_lane_and_not_on_the_pavement() -> None:
    standing = street(car(20.0, 0.2), speed=4.0)
    assert SHIFT[Planner().choose(standing)] < 0.0
    standing[ROAD:] = 5.25, 1.75
    assert SHIFT[Planner().choose(standing)] > 0.0


def test_what_it_does_is_the_way_that_it_chooses() -> None:
    one, taken = Planner(), street(car(22.0, 0.0), car(22.0, 3.2))
    assert SHIFT[one.choose(taken)] < 0.0  # to the right, since the left is taken
    assert one.act(taken) == carried_out(taken, one.choose(taken), WISH)


@pytest.mark.parametrize(("y", "speed"), [(9.0, 6.0), (9.0, 8.0), (12.0, 6.0), (15.0, 8.0)])
def test_who_crosses_where_the_route_bends_is_expected_to_keep_straight(y: float, speed: float) -> None:
    turn = street(speed=5.0)
    turn[4:OWN] = (5.0, 0.0, 8.5, -3.5, 8.5, -8.5, 8.5, -13.5, 8.5, -23.5)  # to the right, into the lane that he is in
    turn[OWN : OWN + PER_ACTOR] = (1, 7.5, np.hypot(1.7, y + 1.8), 8.5, y, 0.0, -speed, -np.pi / 2, 2.45, 1.05, 0)
    along_the_route, straight = (Planner(replace(HARDENED, crossing=belief)).choose(turn) for belief in (0.0, 1.0))
    assert SHIFT[along_the_route] == 0.0
    assert SHIFT[straight] < -2.0  # keeps to the inside of the turn


@pytest.mark.parametrize(("offset", "turn"), [(1.5, 1.0), (-1.5, -1.0)])
def test_it_returns_to_its_route(offset: float, turn: float) -> None:
    assert np.sign(Planner().act(street(offset=offset))[1]) == turn  # steering right is positive


def test_it_goes_round_who_stands_in_its_way_on_the_side_that_is_free() -> None:
    blocked = car(22.0, 0.0)
    left_taken, right_taken = car(22.0, 3.2), car(22.0, -3.2)
    assert Planner().act(street(blocked, right_taken))[1] < 0.0
    assert Planner().act(street(blocked, left_taken))[1] > 0.0


def test_it_stops_where_both_sides_are_taken() -> None:
    wall = (car(9.0, 0.0), car(9.0, 2.6), car(9.0, -2.6), car(9.0, 5.0), car(9.0, -5.0))
    assert Planner().act(street(*wall))[0] < -0.3


def test_it_gives_way_to_who_walks_into_its_way_and_not_to_who_walks_off() -> None:
    pedal, steering = Planner().act(street(walker(14.0, -4.0, 2.0)))
    assert pedal < -0.1 or abs(steering) > 0.1
    pedal, steering = Planner().act(street(walker(14.0, -4.0, -2.0)))
    assert pedal > -0.05
    assert abs(steering) < 0.1


def test_it_is_slower_beside_who_may_step_out_than_on_an_empty_street() -> None:
    standing = Planner().act(street(walker(10.0, -2.0)))
    assert standing != Planner().act(street())


def test_what_it_does_depends_on_nothing_but_what_it_sees() -> None:
    one, seen = Planner(), street(car(15.0, 0.5, 3.0), walker(20.0, -3.0))
    first = one.act(seen)
    for offset in (-2.0, 2.0):
        one.act(street(car(8.0, 0.0), offset=offset))
    assert one.act(seen) == first == Planner().act(seen)


def test_the_hardened_driver_is_one_of_its_kind_by_another_name() -> None:
    one = load_ego("hardened")
    assert isinstance(one, Planner)
    assert (one.name, one.caution) == ("hardened", HARDENED)
    assert one.wanting(20.0).caution == replace(HARDENED_AT_SPEED, speed=20.0)
    assert one.act(street(speed=WISH))[0] > Planner().act(street(speed=WISH))[0]  # it is the faster of the two


def test_what_ways_are_weighed_by_at_speed_is_used_where_a_speed_is_wanted_and_nowhere_else() -> None:
    usual, swift = Caution(), Caution(crash=40.0, speed=3.0)
    one = Planner(usual, swift=swift)
    assert one.caution == usual
    told = one.driving(LIMITS["Bus"]).wanting(20.0)
    assert told.caution == Caution(crash=40.0, speed=20.0)
    assert told.wanting(10.0).driving(LIMITS["Bus"]).caution == Caution(crash=40.0, speed=10.0)
    assert Planner(usual).wanting(20.0).caution == Caution(speed=20.0)


def test_the_way_that_is_chosen_costs_least() -> None:
    seen = street(walker(12.0, -1.0), car(20.0, 0.0, 2.0))
    costs = Planner().costs(seen)
    assert costs.shape == ACCELERATION.shape
    assert costs[Planner().choose(seen)] == costs.min()
