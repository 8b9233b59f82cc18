"""How boxes lie to each other over time is the same in the engine and without it, to the bit."""

from __future__ import annotations

import math

import numpy as np
import pytest

from chatscene.program import encounter
from chatscene.simulate import boxes
from chatscene.simulate.boxes import Boxes, in_numpy, near_any, overlaps
from chatscene.simulate.native.engine import Engine, NoEngine, boxes_of, load_engine
from chatscene.terms.arrays import Array
from chatscene.terms.episode import Role, Track


@pytest.fixture(scope="module")
def engine() -> Engine:
    try:
        return load_engine()
    except NoEngine as missing:
        pytest.skip(str(missing))


def _track(rng: np.random.Generator, steps: int, *, nowhere: int = 0) -> Track:
    """Somebody who goes about, in or near a square of 20 m; nowhere at first, if so said."""
    x, y, heading = (np.cumsum(rng.normal(0.0, by, steps)) for by in (0.6, 0.6, 0.2))
    speed = rng.normal(5.0, 4.0, steps) * (rng.random(steps) > 0.2)
    x[:nowhere] = y[:nowhere] = math.nan
    length, width = rng.uniform(0.5, 6.0, 2).tolist()
    x, y = x + rng.normal(0.0, 3.0), y + rng.normal(0.0, 3.0)
    return Track(
        actor="a", role=Role.EGO, kind="Car", length=length, width=width, x=x, y=y, heading=heading, speed=speed
    )


def _same(first: Array, second: Array) -> bool:
    return first.tobytes() == second.tobytes() or bool(np.array_equal(first, second, equal_nan=True))


def test_how_two_lie_to_each_other_is_the_same(engine: Engine) -> None:
    rng = np.random.default_rng(0)
    touching = 0
    for _ in range(60):
        steps = int(rng.integers(1, 120))
        one, two = _track(rng, steps), _track(rng, steps, nowhere=int(rng.integers(0, 3)))
        found, expected = boxes.between(one, two), in_numpy(Boxes.of(one), Boxes.of(two), one.speed, two.speed)
        assert _same(found.gaps, expected.gaps)
        assert _same(found.times, expected.times)
        assert _same(found.ahead, expected.ahead)
        assert _same(found.closing, expected.closing)
        touching += bool((found.gaps == 0.0).any())
    assert touching > 10


def test_the_nearest_overlaps_are_the_same(engine: Engine, monkeypatch: pytest.MonkeyPatch) -> None:
    rng = np.random.default_rng(1)
    found_any = 0
    for _ in range(60):
        steps, rows = int(rng.integers(2, 60)), int(rng.integers(1, 4))
        ways = [_track(rng, steps, nowhere=int(rng.integers(0, 3))) for _ in range(rows)]
        x, y, heading = (np.array([getattr(way, name) for way in ways]) for name in ("x", "y", "heading"))
        one = Boxes(x, y, np.cos(heading), np.sin(heading), 2.4, 0.9)
        two = Boxes.of(_track(rng, steps))
        at = np.sort(rng.integers(0, steps, steps))
        most = int(rng.integers(0, steps))
        found = sorted(zip(*map(np.ndarray.tolist, overlaps(one, two, at, most)), strict=True))
        with monkeypatch.context() as without:
            without.setattr(boxes, "engine", lambda: None)
            expected = sorted(zip(*map(np.ndarray.tolist, overlaps(one, two, at, most)), strict=True))
        assert found == expected
        found_any += bool(found)
    assert found_any > 10


@pytest.mark.parametrize(("shape", "moments"), [((2, 4), 4), ((1, 5), 4), ((1, 4), 3)])
def test_boxes_that_are_not_as_many_as_is_said_are_refused(
    engine: Engine, shape: tuple[int, int], moments: int
) -> None:
    column = np.zeros(4)
    told = boxes_of(column, column, column, column, 2.4, 0.9)
    with pytest.raises(ValueError, match="4 boxes"):
        engine.overlaps(told, shape, told, np.arange(moments), 1, 1.0)


def test_what_is_near_any_is_the_same(engine: Engine, monkeypatch: pytest.MonkeyPatch) -> None:
    rng = np.random.default_rng(2)
    x, y, other_x, other_y = rng.normal(0.0, 10.0, (4, 50))
    found = near_any(x, y, other_x, other_y, 2.0)
    monkeypatch.setattr(boxes, "engine", lambda: None)
    assert np.array_equal(found, near_any(x, y, other_x, other_y, 2.0))
    assert 0 < found.sum() < 50


def test_columns_of_different_lengths_are_no_boxes() -> None:
    with pytest.raises(ValueError, match="no boxes"):
        boxes_of(np.zeros(3), np.zeros(3), np.zeros(3), np.zeros(4), 1.0, 1.0)


def test_an_encounter_is_the_same_without_the_engine(engine: Engine, monkeypatch: pytest.MonkeyPatch) -> None:
    rng = np.random.default_rng(3)
    met = 0
    for _ in range(40):
        one, two = _track(rng, 60), _track(rng, 60)
        along = np.concatenate(([0.0], np.cumsum(np.hypot(np.diff(one.x), np.diff(one.y)))))
        way = along, one.x, one.y, one.heading
        found = encounter.meeting(one, way, two, 0.1, 5)
        with monkeypatch.context() as without:
            without.setattr(boxes, "engine", lambda: None)
            assert repr(encounter.meeting(one, way, two, 0.1, 5)) == repr(found)
        met += math.isfinite(found.between)
    assert met > 5
