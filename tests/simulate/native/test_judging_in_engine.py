"""What is judged in the engine is what is judged without it, to the bit."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from types import ModuleType

import numpy as np
import pytest

from chatscene.maps.lane_map import LaneMap
from chatscene.maps.loading import load_roads
from chatscene.maps.network import resolve_map
from chatscene.maps.routes import find_routes
from chatscene.measure import avoidability
from chatscene.measure.sums import Sums, sum_up, sums
from chatscene.measure.sums_in_numpy import sums_in_numpy
from chatscene.simulate import boxes, cells, roadside
from chatscene.simulate.cells import Cells
from chatscene.simulate.native import lines
from chatscene.simulate.native.engine import Engine, NoEngine, load_engine
from chatscene.terms.episode import Ending, Episode, Event, EventKind, Role, SignalTrack, Track
from chatscene.terms.polyline import Polyline
from chatscene.terms.route import RouteQuery
from chatscene.terms.scenario import Maneuver


@pytest.fixture(scope="module", autouse=True)
def engine() -> Engine:
    try:
        return load_engine()
    except NoEngine as missing:
        pytest.skip(str(missing))


def _track(rng: np.random.Generator, steps: int, *, actor: str = "ego", kind: str = "Car") -> Track:
    """Somebody who drives about near a line of 100 m to the east, and stands now and then."""
    speed = np.maximum(rng.normal(6.0, 1.0) + np.cumsum(rng.normal(0.0, 0.6, steps) * (rng.random(steps) < 0.05)), -1.0)
    speed[int(rng.integers(0, steps)) : int(rng.integers(0, steps))] = 0.0
    heading = rng.normal(0.0, 0.5) + np.cumsum(rng.normal(0.0, 0.05, steps))
    x, y = (rng.normal(10.0, 4.0) + np.cumsum(0.1 * speed * way(heading)) for way in (np.cos, np.sin))
    role = Role.EGO if actor == "ego" else Role.ADVERSARY
    return Track(actor=actor, role=role, kind=kind, length=4.5, width=1.8, x=x, y=y, heading=heading, speed=speed)


def _drive(ego: Track, other: Track, crash: int) -> Episode:
    steps = len(ego.x)
    return Episode(
        scene_id="drawn",
        ego="nobody",
        dt=0.1,
        tracks=(ego, other),
        events=(Event(kind=EventKind.COLLISION, step=crash, other=other.actor, side="front", impact_speed=3.0),),
        signals=(),
        ending=Ending.COLLISION,
        route_completion=0.5,
        distance_to_route=np.zeros(steps),
        off_road=np.zeros(steps, np.bool_),
    )


def _both(monkeypatch: pytest.MonkeyPatch, modules: tuple[ModuleType, ...], of: Callable[[], object]) -> object:
    """What a function tells with the engine, and that it tells the same without."""
    found = of()
    with monkeypatch.context() as without:
        for module in modules:
            without.setattr(module, "engine", lambda: None)
        boxes.between.cache_clear()
        assert repr(of()) == repr(found)
    boxes.between.cache_clear()
    return found


def test_when_a_crash_becomes_a_risk_is_the_same(monkeypatch: pytest.MonkeyPatch) -> None:
    rng = np.random.default_rng(0)
    bends = Polyline([(x, 0.02 * (x - 40.0) ** 2 if x > 40.0 else 0.0) for x in np.arange(0.0, 100.0, 2.5)])
    found: list[object] = []
    for _ in range(60):
        steps = int(rng.integers(12, 80))
        episode = _drive(_track(rng, steps), _track(rng, steps, actor="adversary"), steps - 1)
        found.append(_both(monkeypatch, (avoidability,), lambda of=episode: avoidability.risk_step(of, bends)))
    assert {None, 0} < {*found}


def _block(rng: np.random.Generator) -> list[Episode]:
    """Drives of unlike lengths, with unlike numbers of road users, of which every other one ends in a collision."""
    found: list[Episode] = []
    for number in range(24):
        steps = int(rng.integers(2, 160))
        others = [_track(rng, steps, actor=name) for name in ("adversary", "other", "third")[: 1 + number % 3]]
        drive = _drive(_track(rng, steps), others[-1], int(rng.integers(0, steps)))
        aside = np.abs(rng.normal(0.0, 1.0, steps))
        drive = replace(drive, tracks=(drive.ego_track, *others), distance_to_route=aside)
        found.append(drive if number % 2 else replace(drive, events=(), ending=Ending.OVER))
    return found


def test_the_sums_of_a_drive_are_the_same_in_a_block_of_any_size() -> None:
    drives = _block(np.random.default_rng(11))
    alone = [sums(replace(drive)) for drive in drives]
    for size in (2, 5, 24):
        for first in range(0, len(drives), size):
            block = [replace(drive) for drive in drives[first : first + size]]
            sum_up(block)
            assert [sums(drive) for drive in block] == alone[first : first + size]
    assert any(0.0 < least < math.inf for one in alone for least in one.parted)


def test_the_sums_of_a_drive_are_the_same(monkeypatch: pytest.MonkeyPatch) -> None:
    rng = np.random.default_rng(1)
    found: list[Sums] = []
    for number in range(300):
        steps = int(rng.integers(1, 160))
        ego, one = _track(rng, steps), _track(rng, steps, actor="adversary", kind="Bicycle")
        two = replace(_track(rng, steps, actor="leader"), role=Role.BACKGROUND)
        drive = _drive(ego, one, int(rng.integers(0, steps)))
        if number % 3:
            more = {1: (one, two, _track(rng, steps, actor="other", kind="Pedestrian")), 2: (two,)}[number % 3]
            ending = Ending.OVER if number % 2 else Ending.TIMEOUT
            drive = replace(drive, tracks=(ego, *more), events=(), ending=ending)
        drive = replace(
            drive, distance_to_route=np.abs(rng.normal(0.0, 1.0, steps)), dt=1.0 if number % 7 == 0 else 0.1
        )
        for track in drive.tracks:
            track.speed[:] *= 3.0 if not number % 5 else 1.0
        if not number % 4:  # at the end all of them stand
            for track in drive.tracks:
                track.speed[-25:] = 0.0
        found.append(sums(drive))
        with monkeypatch.context() as without:
            without.setattr(boxes, "engine", lambda: None)
            boxes.between.cache_clear()
            assert sums_in_numpy(drive) == found[-1]
        boxes.between.cache_clear()
    assert {one.waits for one in found} == {True, False}
    assert any(much for one in found for _, much in one.tyres)
    parted = [one for each in found for one in each.parted]
    assert 10 < sum(0.0 < one < math.inf for one in parted) < len(parted) - sum(one == 0.0 for one in parted)
    assert len({one.begins for one in found}) > 10


def test_the_least_of_how_two_lie_to_each_other_is_the_same(monkeypatch: pytest.MonkeyPatch) -> None:
    rng = np.random.default_rng(4)
    brakes = 0
    for _ in range(60):
        one, two = _track(rng, 60), _track(rng, 60, actor="adversary")
        least = _both(monkeypatch, (boxes,), lambda a=one, b=two: _least(boxes.between(a, b)))
        assert isinstance(least, tuple)
        brakes += least[-1] > 0.0
    assert brakes > 5


def _least(pair: boxes.Between) -> tuple[float, ...]:
    return pair.least, pair.nearest, pair.soonest, pair.headway, pair.braking


def test_when_somebody_crosses_a_line_is_the_same(monkeypatch: pytest.MonkeyPatch) -> None:
    rng = np.random.default_rng(5)
    found: list[object] = []
    for _ in range(60):
        x0, y0, x1, y1 = rng.normal(15.0, 8.0, 4).tolist()
        line, track = SignalTrack(x0=x0, y0=y0, x1=x1, y1=y1, state="", role="ego"), _track(rng, 60)
        found.append(_both(monkeypatch, (roadside,), lambda a=track, b=line: roadside.crossing_step(a, b)))
    assert 5 < sum(one is not None for one in found) < 50


@pytest.mark.parametrize("points", [2, 20, 70, 161])
def test_where_points_lie_on_a_whole_line_is_the_same(points: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Also of lines that come back to where they were, and of points that are as near to two of their segments."""
    rng = np.random.default_rng(8)
    for bend in (0.0, 0.02, 0.3):
        heading = np.cumsum(rng.normal(0.0, bend, points))
        line = Polyline(np.cumsum(2.0 * np.column_stack((np.cos(heading), np.sin(heading))), axis=0))
        for spread in (0.0, 1.0, 40.0):
            x, y = (line.points[np.sort(rng.integers(0, points, 120))] + rng.normal(0.0, spread, (120, 2))).T
            _both(monkeypatch, (lines,), lambda of=line, x=x, y=y: [*map(list, lines.follow(of, x, y, whole=True))])


@pytest.mark.parametrize("name", ["town", "outskirts"])
def test_squares_of_a_map_tell_lanes_as_the_map_does(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    roads, rng = load_roads(resolve_map(name)), np.random.default_rng(6)
    lane_map = LaneMap(roads)
    queries = [RouteQuery(maneuver=maneuver) for maneuver in (Maneuver.STRAIGHT, Maneuver.LEFT_TURN)]
    for route in (one for query in queries for one in find_routes(roads, name, query)[:3]):
        along, known = route.line.points[:, :2], Cells(lane_map, route)
        for spread in (0.5, 3.0, 12.0, 40.0):
            x, y = (along[rng.integers(0, len(along), 400)] + rng.normal(0.0, spread, (400, 2))).T
            lane, off_road = lane_map.lane_index(xy := np.array((x, y)).T, route.lane_ids), lane_map.off_road(xy)
            begins = [i for i in range(400) if off_road[i] and not (i and off_road[i - 1])]
            changes = [i for i in range(399) if lane[i] >= 0 and lane[i] != lane[i + 1]]
            for _ in range(2):  # of squares that nobody asked of, and of those that are known
                found = known.along(x, y)
                assert np.array_equal(found[0], off_road)
                assert found[1:] == (begins, changes)
        x, y = along.T
        found = known.along(x, y)
        with monkeypatch.context() as without:
            without.setattr(cells, "engine", lambda: None)
            again = known.along(x, y)
        assert np.array_equal(found[0], again[0])
        assert found[1:] == again[1:]
