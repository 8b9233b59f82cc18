"""A network as lanelets has its lanes' areas, and joins where they join."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from chatscene.maps.lanelets import Lanelet, lanelets_along, lanelets_of
from chatscene.maps.network import PACKAGED, load_network
from chatscene.maps.routes import find_routes
from chatscene.terms.route import RouteQuery
from chatscene.terms.scenario import Maneuver

MAPS = [*PACKAGED.values(), Path(__file__).parent / "osm" / "roundabout.xodr"]


@pytest.fixture(scope="module", params=MAPS, ids=lambda path: path.stem)
def network(request: pytest.FixtureRequest) -> Any:
    return load_network(request.param)


@pytest.fixture(scope="module")
def lanelets(network: Any) -> tuple[Lanelet, ...]:
    return lanelets_of(network)


def test_every_piece_of_a_lane_is_one_with_as_many_points_on_either_side(
    network: Any, lanelets: tuple[Lanelet, ...]
) -> None:
    assert len(lanelets) == sum(len(lane.sections) for lane in network.lanes)
    assert [one.number for one in lanelets] == list(range(1, len(lanelets) + 1))
    assert all(len(one.left) == len(one.right) >= 2 for one in lanelets)


def test_they_cover_the_lanes_to_a_centimetre_on_the_whole(network: Any, lanelets: tuple[Lanelet, ...]) -> None:
    sections = [section for lane in sorted(network.lanes, key=lambda lane: lane.uid) for section in lane.sections]
    assert all(one.area.is_valid for one in lanelets)
    off = sum(one.area.symmetric_difference(s.polygons).area for one, s in zip(lanelets, sections, strict=True))
    assert off < 0.01 * sum(section.centerline.length for section in sections)


def test_bounds_go_on_where_one_follows_another(lanelets: tuple[Lanelet, ...]) -> None:
    for one in lanelets:
        for other in (lanelets[number - 1] for number in one.after):
            assert one.number in other.before
            assert np.array_equal([one.left[-1], one.right[-1]], [other.left[0], other.right[0]])


def test_those_beside_each_other_share_a_bound_from_end_to_end(lanelets: tuple[Lanelet, ...]) -> None:
    for one in lanelets:
        if one.on_right:
            other = lanelets[one.on_right.number - 1]
            assert other.on_left
            assert (other.on_left.number, other.on_left.same_way) == (one.number, True)
            assert np.array_equal(one.right[[0, -1]], other.left[[0, -1]])
        if one.on_left and not one.on_left.same_way:
            other = lanelets[one.on_left.number - 1]
            assert other.on_left
            assert (other.on_left.number, other.on_left.same_way) == (one.number, False)
            assert np.array_equal(one.left[[0, -1]], other.left[[-1, 0]])


@pytest.mark.parametrize("maneuver", [Maneuver.LEFT_TURN, Maneuver.RIGHT_TURN, Maneuver.STRAIGHT])
def test_a_way_leads_along_lanelets_that_follow_one_another(maneuver: Maneuver) -> None:
    network = load_network(PACKAGED["town"])
    lanelets = lanelets_of(network)
    for route in find_routes(network, "town", RouteQuery(maneuver=maneuver), count=5):
        along = lanelets_along(lanelets, route.line)
        assert len(along) == len(route.lane_ids)
        assert all(b in lanelets[a - 1].after for a, b in pairwise(along))
