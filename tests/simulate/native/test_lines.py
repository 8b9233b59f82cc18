"""Where the points of a track lie on a line, in the engine and in Python."""

from __future__ import annotations

import numpy as np
import pytest

from chatscene.simulate.native import lines
from chatscene.simulate.native.engine import load_engine
from chatscene.terms.polyline import Polyline


@pytest.mark.parametrize("seed", range(20))
@pytest.mark.parametrize("whole", [False, True])
def test_points_are_found_on_a_line_as_polyline_projects_each(seed: int, whole: bool) -> None:
    load_engine()  # else this compares Python with itself
    rng = np.random.default_rng(seed)
    line = Polyline(np.cumsum(rng.normal(size=(60, 2)), axis=0))
    x, y = line.points_at(np.linspace(-5.0, line.length + 5.0, 300)).T + rng.normal(scale=0.5, size=(2, 300))
    near, expected = None, []
    for point in zip(x.tolist(), y.tolist(), strict=True):
        *found, near = line.project(*point, None if whole else near)
        expected.append(found)
    arc, offset = lines.follow(line, x[::1], y, whole=whole)
    assert np.column_stack((arc, offset)).tolist() == expected


def test_without_an_engine_the_numbers_are_the_same(monkeypatch: pytest.MonkeyPatch) -> None:
    load_engine()  # else this compares Python with itself
    line = Polyline([(0, 0), (10, 0), (10, 10)])
    x, y = np.array([-1.0, 4.0, 12.0, 9.0, 10.0]), np.array([1.0, -2.0, -1.0, 6.0, 12.0])
    with_engine = [lines.follow(line, x, y, whole=whole) for whole in (False, True)]
    monkeypatch.setattr(lines, "engine", lambda: None)
    assert np.array_equal([lines.follow(line, x, y, whole=whole) for whole in (False, True)], with_engine)
