"""What an order allows the ego, before it holds and while it does."""

import math

import pytest

from chatscene.terms.order import Order


def test_an_order_without_a_time_or_place_always_holds() -> None:
    assert Order(at_most=2.5).allows(0.0, 0.0) == Order(at_most=2.5).allows(99.0, 500.0) == 2.5


def test_an_order_ends() -> None:
    order = Order(at_most=0.0, till=1.5)
    assert (order.allows(1.4, 0.0), order.allows(1.5, 0.0)) == (0.0, math.inf)


def test_before_its_place_the_ego_may_go_as_fast_as_it_can_still_be_braked_evenly() -> None:
    order = Order(at_most=2.0, place=50.0, braking=3.0)
    assert order.allows(0.0, 50.0) == order.allows(9.0, 80.0) == 2.0
    assert order.allows(0.0, 40.0) == pytest.approx(math.sqrt(2.0**2 + 2 * 3.0 * 10.0))


def test_before_its_time_the_ego_may_go_as_fast_as_it_can_still_be_braked_evenly() -> None:
    order = Order(at_most=1.0, since=4.0, braking=2.0)
    assert (order.allows(1.0, 0.0), order.allows(4.0, 0.0)) == (7.0, 1.0)


def test_an_order_of_a_time_and_a_place_holds_where_both_have_come() -> None:
    order = Order(at_most=0.0, since=4.0, place=50.0, braking=2.0)
    assert order.allows(9.0, 34.0) == 8.0
    assert order.allows(1.0, 90.0) == 6.0
    assert order.allows(9.0, 90.0) == 0.0
