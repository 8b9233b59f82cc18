"""What is worked out of an element of a map is kept on it."""

from types import SimpleNamespace

from chatscene.maps.kept import kept
from chatscene.maps.lane_runs import centre_line
from chatscene.maps.layout import arms
from chatscene.maps.network import load_network, resolve_map


def test_something_is_made_of_an_element_once() -> None:
    made: list[object] = []
    element = SimpleNamespace()
    for _ in range(2):
        assert kept(element, "number", lambda one: made.append(one) or len(made)) == 1
    assert made == [element]


def test_elements_of_two_maps_share_nothing() -> None:
    town, region = (load_network(resolve_map(name)) for name in ("town", "region"))
    assert {lane.uid for lane in town.lanes} & {lane.uid for lane in region.lanes}
    lines = [centre_line(lane) for network in (town, region) for lane in network.lanes]
    assert len(set(map(id, lines))) == len(lines)
    assert all(centre_line(lane) is centre_line(lane) for lane in town.lanes)
    assert {arms(junction) for junction in town.intersections} >= {3, 4}
