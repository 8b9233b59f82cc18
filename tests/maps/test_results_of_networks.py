"""What is worked out of a map is kept while the map is used, and goes with it."""

from __future__ import annotations

import gc
import weakref

from chatscene.maps.kept import NETWORKS, kept_with_network


class Network:
    """Stands for a road network: what is kept is kept by which one it is."""


asked: list[object] = []


@kept_with_network(2)
def twice(network: Network, number: int) -> tuple[Network, int]:
    """A result that holds its network, as the ego's routes do."""
    asked.append(network)
    return network, 2 * number


@kept_with_network()
def seldom(network: Network) -> Network:
    """What is asked of few networks."""
    return network


def test_a_result_is_worked_out_once_for_each_network() -> None:
    asked.clear()
    one, other = Network(), Network()
    assert [twice(one, 3)[1], twice(one, 3)[1], twice(other, 3)[1], twice(one, number=4)[1]] == [6, 6, 6, 8]
    assert asked == [one, other, one]


def test_a_function_keeps_the_latest_results_of_a_network() -> None:
    asked.clear()
    one = Network()
    for number in (1, 2, 3, 1):
        twice(one, number)
    assert len(asked) == 4


def test_many_maps_one_after_the_other_are_not_all_held() -> None:
    seen = [weakref.ref(network) for network in map(worked_with, range(5 * NETWORKS))]
    asked.clear()
    gc.collect()
    assert sum(one() is not None for one in seen) <= NETWORKS


def worked_with(number: int) -> Network:
    """A network of which something was asked that is asked of few others."""
    network = Network()
    twice(network, number)
    if number == 0:
        seldom(network)
    return network
