"""An ego that comes into its lane from beside it, or leaves it, or turns round; and whom it meets there."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from test_starting import driven, someone, track

from chatscene.build.build import build
from chatscene.errors import NotBuilt
from chatscene.maps.network import load_network, resolve_map
from chatscene.maps.off_lane import CURB_RADIUS, DRIVEWAY, KERB
from chatscene.situations.form import from_plain
from chatscene.world.ego_route import choose_route
from chatscene.world.places import ownLane

EDGES: dict[str, tuple[dict[str, Any], float, float]] = {
    "leave-parking": ({"begins": "kerb"}, KERB, 0.0),
    "leave-driveway": ({"begins": "driveway"}, CURB_RADIUS + DRIVEWAY, 0.0),
    "park": ({"ends": "kerb"}, 0.0, KERB),
    "enter-driveway": ({"ends": "driveway"}, 0.0, CURB_RADIUS + DRIVEWAY),
}


@pytest.mark.parametrize("route", EDGES)
def test_a_route_begins_or_ends_so_far_beside_its_lane(route: str) -> None:
    asked, first, last = EDGES[route]
    path = str(resolve_map("town"))
    found = choose_route(load_network(path), path, 0, maneuver="straight", place="road", **asked)
    lane, line = ownLane(found), found.route.line
    assert -lane.project(*line.point_at(0.0))[1] == pytest.approx(first, abs=0.1)
    assert -lane.project(*line.point_at(line.length))[1] == pytest.approx(last, abs=0.1)


def test_a_u_turn_comes_back_on_no_tighter_circle_than_a_car_can_drive() -> None:
    path = str(resolve_map("town"))
    found = choose_route(load_network(path), path, 0, maneuver="straight", place="road", ends="back")
    line = found.route.line
    turned = np.unwrap([line.heading_at(s) for s in np.arange(0.5, line.length, 1.0)])
    assert turned[-1] - turned[0] == pytest.approx(np.pi, abs=0.1)
    assert np.diff(turned).max() < 1 / 4.0


MET: dict[str, tuple[str, dict[str, Any]]] = {
    "who comes from behind": ("leave-parking", someone("behind", "go-along", speed="40 km/h")),
    "a bicycle in the lane": ("leave-parking", someone("behind-beside", "go-along", kind="bicycle", side="left")),
    "who comes from the left": ("leave-driveway", someone("arm", "go-straight", side="left")),
    "who comes toward us": ("u-turn", someone("oncoming", "go-along", speed="30 km/h")),
}


@pytest.mark.parametrize("who", MET)
@pytest.mark.parametrize("ego", ["idm", "planner"])
def test_an_ego_that_comes_into_a_lane_meets_who_is_in_it(who: str, ego: str) -> None:
    route, said = MET[who]
    episode = driven(said | {"ego": {"route": route}}, ego=ego)
    there, own = track(episode), episode.ego_track
    assert np.hypot(there.x - own.x, there.y - own.y).min() < 12.0
    assert there.speed[0] > 3.0


@pytest.mark.parametrize(
    ("route", "where", "told"),
    [
        ("leave-driveway", {"where": "arm", "side": "right"}, "starts.where: arm, with ego.route: leave-driveway"),
        ("leave-parking", {"where": "beside", "side": "left"}, "starts.where: beside with a parked ego"),
        ("park", {"where": "exit"}, "starts.where: exit, with ego.route: park"),
        ("park", {"where": "arm"}, "starts.where: arm"),
    ],
)
def test_whom_such_an_ego_cannot_meet_is_refused(route: str, where: dict[str, str], told: str) -> None:
    with pytest.raises(NotBuilt, match=told):
        build(from_plain({"ego": {"route": route}, "others": [{"id": "A", "kind": "car", "starts": where}]}))


def test_that_the_ego_stands_before_it_pulls_out_is_told() -> None:
    made = build(from_plain(someone("behind", "go-along") | {"ego": {"route": "leave-parking"}}))
    assert "the ego first waits beside its lane for 3 s" in made.assumed
