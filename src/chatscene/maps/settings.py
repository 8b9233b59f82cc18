"""What lies about the roads of a map: houses, fields, or the other half of a divided road."""

from __future__ import annotations

from typing import Any

from chatscene.maps.car_parks import car_parks
from chatscene.maps.kept import kept_with_network
from chatscene.maps.lane_runs import lane_runs
from chatscene.maps.layout import motorway_groups
from chatscene.maps.limits import SLOW, TOWN, limits_of
from chatscene.maps.neighbours import opposes, section_beside
from chatscene.maps.sites import along
from chatscene.terms.scenario import Site
from chatscene.terms.vocabulary import Setting

_SLACK = 0.5  # [m/s], by which limits are rounded


def lies_in(network: Any, lane: Any, setting: Setting) -> bool:
    """Whether a lane outside junctions lies in a setting: by its width and sidewalks, and by what its map allows."""
    if along(network, lane_runs(network)[lane.uid], Site.RURAL):
        return setting is Setting.RURAL
    if lane.road.id in car_parks(network) or setting is Setting.RURAL or lane.group.uid in _motorways(network):
        return False
    known = limits_of(network).get(lane.road.id)
    allowed = TOWN if known is None else known.at(0.0)
    return allowed <= _SLACK + (SLOW if setting is Setting.RESIDENTIAL else TOWN)


@kept_with_network()
def _motorways(network: Any) -> frozenset[str]:
    return frozenset(group.uid for group in motorway_groups(network))


def is_two_way(lane: Any) -> bool:
    """Whether a lane of the other direction lies directly beside one of a lane's own direction."""
    lefts = ((one, section_beside(one.sections[0], 1)) for one in lane.group.lanes)
    return any(left is not None and opposes(one, left.lane) for one, left in lefts)
