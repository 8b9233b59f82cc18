"""A network for programs that ask it for nothing is made once they do, and is then Scenic's own."""

from __future__ import annotations

from collections import OrderedDict
from pathlib import Path
from typing import Any

import pytest
from scenic.core.distributions import needsSampling
from scenic.core.regions import EmptyRegion, PolygonalRegion, PolylineRegion, Region
from scenic.core.vectors import Vector
from scenic.domains.driving.roads import Network

from chatscene.errors import MapError
from chatscene.maps import light_network as module
from chatscene.maps.light_network import LightNetwork, light_network
from chatscene.maps.network import load_network, map_digest, resolve_map
from chatscene.settings import SimulationSettings
from chatscene.simulate.simulator import load_simulator
from chatscene.terms.scene import Scene, ScenicProgram
from chatscene.world import compilation
from chatscene.world.compilation import compile_program

TOWN = resolve_map("town")
REGIONS = ("drivableRegion", "curbRegion", "sidewalkRegion", "shoulderRegion", "intersectionRegion")
ASKS_NOTHING = """model chatscene.world.model
egoRoute = selectRoute(maneuver="straight")
ego = new Car at startOf(egoRoute), facing directionOn(egoRoute, 0), with route egoRoute
other = new Truck at pointOn(egoRoute, 30), facing directionOn(egoRoute, 30)
"""
ASKS = """model chatscene.world.model
egoRoute = selectRoute(maneuver="straight")
ego = new Car at startOf(egoRoute), facing directionOn(egoRoute, 0), with route egoRoute
other = new Truck at pointOn(egoRoute, 30)
beside = new Car at network.lanes[3].centerline.start
require other in roadOrShoulder
require ego in road
"""


@pytest.fixture
def asked(monkeypatch: pytest.MonkeyPatch) -> list[Path]:
    """Which networks are made, of light ones that were not used before."""
    made: list[Path] = []

    def load(path: Path) -> Any:
        made.append(path)
        return load_network(path)

    monkeypatch.setattr(module, "load_network", load)

    def light(path: Path | str) -> LightNetwork:
        return LightNetwork(Path(path), map_digest(Path(path)))

    monkeypatch.setattr(module, "light_network", light)
    monkeypatch.setattr(
        compilation, "_models", OrderedDict()
    )  # a world model holds the network that it was loaded with
    return made


def _compiled(source: str) -> Any:
    return compile_program(source, map_path=TOWN, route=0)


def _driven(source: str) -> Any:
    program = ScenicProgram(scenario_id="light", source=source, parameters=(), snippet_ids=())
    scene = Scene(id="light/0", scenario_id="light", route=0, block=0, seed=0, values={})
    return load_simulator(TOWN, SimulationSettings()).open(program, scene)


def test_a_program_that_asks_for_nothing_makes_no_network(asked: list[Path]) -> None:
    session = _driven(ASKS_NOTHING)
    session.step((0.5, 0.0))
    session.episode("light/0", "nobody")
    session.close()
    assert asked == []


def test_a_program_that_asks_has_what_scenics_network_answers(asked: list[Path]) -> None:
    scenario = _compiled(ASKS)
    scene, _ = scenario.generate(maxIterations=1)
    assert asked == [TOWN]
    _, other, beside = scene.objects
    network = load_network(TOWN)
    assert other.heading == pytest.approx(network.roadDirection[other.position].yaw, abs=0.0)
    assert beside.position == network.lanes[3].centerline.start.position


def test_regions_are_of_scenics_kind_and_made_once_asked(asked: list[Path]) -> None:
    light, network = LightNetwork(TOWN, map_digest(TOWN)), load_network(TOWN)
    assert isinstance(light, Network)
    for name in REGIONS:
        mine, scenics = getattr(light, name), getattr(network, name)
        assert isinstance(mine, Region)
        assert isinstance(mine, PolylineRegion) == isinstance(scenics, PolylineRegion)
        assert isinstance(mine, PolygonalRegion) == isinstance(scenics, PolygonalRegion)
        assert not needsSampling(mine)
    joined: Any = light.drivableRegion.union(light.shoulderRegion)
    assert asked == []
    there = Vector(*network.lanes[0].centerline.points[0])
    assert light.drivableRegion.containsPoint(there)
    assert asked == [TOWN]
    whole: Any = network.drivableRegion.union(network.shoulderRegion)
    assert joined.polygons.equals_exact(whole.polygons, 0.0)
    assert joined.orientation[there].yaw == whole.orientation[there].yaw
    assert light.curbRegion.length == network.curbRegion.length
    assert light.laneAt(there) is network.laneAt(there)
    assert light.lanes is network.lanes


def test_nothing_is_joined_where_there_is_nothing_to_join() -> None:
    light = LightNetwork(TOWN, map_digest(TOWN))
    assert light.drivableRegion.union(EmptyRegion("nowhere")) is light.drivableRegion


def test_there_is_one_for_a_map() -> None:
    assert light_network(TOWN) is light_network(str(TOWN))


def test_a_map_that_is_changed_meanwhile_is_no_other_one_of_a_sudden(tmp_path: Path) -> None:
    path = tmp_path / "street.xodr"
    path.write_bytes(TOWN.read_bytes())
    light = light_network(path)
    path.write_bytes(resolve_map("outskirts").read_bytes())
    with pytest.raises(MapError, match=r"street\.xodr' was changed since its roads were read; start again"):
        _ = light.lanes
