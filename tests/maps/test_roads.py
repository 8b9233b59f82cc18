"""Roads without Scenic are those of Scenic's network, and are kept between processes so that damage does no harm."""

from __future__ import annotations

import os
import random
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from chatscene.files.caches import cache_folder
from chatscene.maps import loading
from chatscene.maps.furniture import furniture_of
from chatscene.maps.limits import limits_of
from chatscene.maps.loading import load_roads
from chatscene.maps.network import PACKAGED, load_network, map_digest, resolve_map
from chatscene.maps.roads import Roads
from chatscene.maps.routes import BASE_SCENARIO_QUERIES, find_routes

LINKS = (
    "road",
    "group",
    "lane",
    "forwardLanes",
    "backwardLanes",
    "_opposite",
    "_sidewalk",
    "_laneToLeft",
    "_laneToRight",
)
LISTS = ("lanes", "sections", "incomingLanes", "outgoingLanes")


def _way(maneuver: Any) -> tuple[Any, ...]:
    ends = (maneuver.startLane, maneuver.endLane, maneuver.connectingLane, maneuver.intersection)
    return maneuver.type.name, *(None if one is None else one.uid for one in ends)


def _shape(one: Any) -> list[Any]:
    """Its area, its middle and its edges, to the last bit."""
    lines = (getattr(one, name, None) for name in ("centerline", "leftEdge", "rightEdge"))
    return [one.polygons.wkb, *((tuple(line.points), line.lineString.wkb) for line in lines if line is not None)]


def _told(one: Any, like: Any) -> list[Any]:
    """What else is known of a part of a network: of whichever, what is known of another."""
    told: list[Any] = [one.uid, one.id]
    told += [getattr(getattr(one, link), "uid", None) for link in LINKS if hasattr(like, link)]
    told += [[end.uid for end in getattr(one, many)] for many in LISTS if hasattr(like, many)]
    told += [getattr(one, plain) for plain in ("isForward", "openDriveID") if hasattr(like, plain)]
    if hasattr(like, "maneuvers"):
        told.append(list(map(_way, one.maneuvers)))
    if hasattr(like, "signals"):
        told.append([(signal.openDriveID, signal.type, signal.isTrafficLight) for signal in one.signals])
    return told


@pytest.mark.parametrize("name", sorted(PACKAGED))
def test_every_part_is_as_scenic_has_it(name: str) -> None:
    roads, network = load_roads(resolve_map(name)), load_network(resolve_map(name))
    for listed in ("roads", "connectingRoads", "lanes", "intersections", "sidewalks", "shoulders", "laneSections"):
        assert [one.uid for one in getattr(roads, listed)] == [one.uid for one in getattr(network, listed)]
    assert roads.drivableRegion.polygons.equals_exact(network.drivableRegion.polygons, 0.0)
    assert roads.intersectionRegion.polygons.equals_exact(network.intersectionRegion.polygons, 0.0)
    for uid, mine in roads.elements.items():
        assert mine.network is roads
        assert _shape(mine) == _shape(network.elements[uid])
        assert _told(mine, mine) == _told(network.elements[uid], mine)
    assert furniture_of(roads) == furniture_of(network)
    assert repr(limits_of(roads)) == repr(limits_of(network))


def test_ways_through_a_junction_are_one_thing_from_both_ends() -> None:
    roads = load_roads(resolve_map("town"))
    junction = roads.intersections[0]
    assert all(any(way is one for one in way.startLane.maneuvers) for way in junction.maneuvers)


def test_lanes_are_found_where_scenic_finds_them() -> None:
    roads, network = load_roads(resolve_map("town")), load_network(resolve_map("town"))
    west, south, east, north = roads.drivableRegion.polygons.bounds
    rng = random.Random(5)
    points = [(rng.uniform(west, east), rng.uniform(south, north)) for _ in range(1500)]
    points += [lane.centerline.points[0][:2] for lane in roads.lanes]
    points += [lane.leftEdge.points[len(lane.leftEdge.points) // 2][:2] for lane in roads.lanes]
    found = 0
    for point in points:
        mine, scenics = roads.laneAt(point), network.laneAt(point)
        section, theirs = roads.laneSectionAt(point), network.laneSectionAt(point)
        assert getattr(mine, "uid", None) == getattr(scenics, "uid", None)
        assert getattr(section, "uid", None) == getattr(theirs, "uid", None)
        if section is not None:
            found += 1
            assert section.containsPoint(point) == theirs.containsPoint(point)
            assert section.distanceTo(point) == theirs.distanceTo(point)
    assert found > 300


def test_routes_are_those_of_scenics_network() -> None:
    roads, network = load_roads(resolve_map("town")), load_network(resolve_map("town"))
    for queries in BASE_SCENARIO_QUERIES.values():
        for query in queries:
            mine, scenics = find_routes(roads, "town", query), find_routes(network, "town", query)
            assert [(one.id, one.lane_ids) for one in mine] == [(one.id, one.lane_ids) for one in scenics]
            assert all(np.array_equal(a.line.points, b.line.points) for a, b in zip(mine, scenics, strict=True))


@pytest.fixture
def files(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """The folder of the town's files in a cache folder of its own, with nothing in it."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    loading.kept_roads.cache_clear()
    yield cache_folder("maps") / map_digest(resolve_map("town"))
    loading.kept_roads.cache_clear()


def _read_again() -> Roads:
    loading.kept_roads.cache_clear()
    return load_roads(resolve_map("town"))


def test_they_are_read_from_their_file_and_need_no_scenic(files: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    first = _read_again()
    (kept,) = files.glob("*.roads")

    def parse(_path: Path) -> None:
        pytest.fail("the map is parsed again")

    monkeypatch.setattr(loading, "load_network", parse)
    assert [*_read_again().elements] == [*first.elements]
    assert kept.stat().st_mode & 0o077 == 0


def _cut(content: bytes) -> bytes:
    return content[: len(content) // 2]


def _turned(content: bytes) -> bytes:
    return content[:-1] + bytes([content[-1] ^ 1])


def _emptied(_content: bytes) -> bytes:
    return b""


@pytest.mark.parametrize("harm", [_cut, _turned, _emptied])
def test_a_damaged_file_is_made_anew(files: Path, harm: Callable[[bytes], bytes]) -> None:
    first = _read_again()
    (kept,) = files.glob("*.roads")
    whole = kept.read_bytes()
    kept.write_bytes(harm(whole))
    assert [*_read_again().elements] == [*first.elements]
    assert kept.read_bytes() == whole


def test_files_of_other_versions_are_left_and_the_oldest_taken_away(files: Path) -> None:
    files.mkdir(parents=True, mode=0o700)
    others = [files / f"{number:024}.roads" for number in range(4)]
    for age, other in enumerate(others):
        other.write_bytes(b"of another version")
        os.utime(other, (age, age))
    _read_again()
    assert sorted(set(others) & set(files.glob("*.roads"))) == others[2:]
    assert len(list(files.glob("*.roads"))) == 3


def test_where_nothing_can_be_kept_they_are_made_each_time(files: Path, monkeypatch: pytest.MonkeyPatch) -> None:

    def nowhere(_folder: Path) -> None:
        return None

    monkeypatch.setattr(loading, "only_mine", nowhere)
    assert _read_again().lanes
    assert not files.exists() or not list(files.glob("*.roads"))
