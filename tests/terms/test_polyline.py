import math
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from chatscene.errors import SettingsError
from chatscene.terms.polyline import Polyline

few = settings(max_examples=60)


@st.composite
def roads(draw: st.DrawFn) -> Polyline:
    """A smooth road: steps of 0.5 to 5 m, at most 0.15 rad of turn from one to the next, no loop."""
    steps = draw(st.lists(st.tuples(st.floats(0.5, 5.0), st.floats(-0.15, 0.15)), min_size=1, max_size=20))
    heading = draw(st.floats(-math.pi, math.pi))
    x, y = draw(st.floats(-500, 500)), draw(st.floats(-500, 500))
    points = [(x, y)]
    for length, turn in steps:
        x, y = x + length * math.cos(heading), y + length * math.sin(heading)
        points.append((x, y))
        heading += turn
    return Polyline(points)


share = st.floats(0.0, 1.0)
sideways = st.floats(-2.0, 2.0)
corner = Polyline([(0, 0), (10, 0), (10, 10)])


def beside(line: Polyline, s: float, left: float) -> tuple[float, float]:
    """The point `left` of the line at arc length `s`."""
    (x, y), heading = line.point_at(s), line.heading_at(s)
    return x - left * math.sin(heading), y + left * math.cos(heading)


def distance(line: Polyline, x: float, y: float) -> float:
    """Straight from the definition: the least distance to any segment."""
    best = math.inf
    for a, b in pairwise(line.points):
        d = b - a
        t = min(max(float(np.dot((x, y) - a, d) / np.dot(d, d)), 0.0), 1.0)
        best = min(best, math.hypot(*((x, y) - (a + t * d))))
    return best


def test_one_point_is_no_line() -> None:
    with pytest.raises(SettingsError, match="two distinct points"):
        Polyline([(1, 2), (1, 2.0005)])


def test_a_point_within_a_millimetre_of_the_one_kept_before_it_is_dropped() -> None:
    line = Polyline([(0.0, 0.0), (0.0006, 0.0), (0.0012, 0.0), (1.0, 0.0), (1.0, 0.0005)])
    assert line.points.tolist() == [[0.0, 0.0], [0.0012, 0.0], [1.0, 0.0]]
    assert line.length == pytest.approx(1.0)


def test_points_may_carry_a_height_that_is_ignored() -> None:
    assert Polyline([(0, 0, 7), (3, 4, 9)]).length == 5.0


def test_points_cannot_be_changed() -> None:
    with pytest.raises(ValueError, match="read-only"):
        corner.points[0, 0] = 1.0


@few
@given(roads(), share)
def test_a_point_on_the_line_projects_onto_itself(line: Polyline, where: float) -> None:
    s, offset, _ = line.project(*line.point_at(where * line.length))
    assert s == pytest.approx(where * line.length, abs=1e-6)
    assert offset == pytest.approx(0.0, abs=1e-6)


@few
@given(roads(), share, sideways)
def test_projecting_undoes_stepping_sideways(line: Polyline, where: float, left: float) -> None:
    # From within a segment, far enough from its ends for the foot of the perpendicular to stay on it.
    i = min(int(where * (len(line) - 1)), len(line) - 2)
    ends = np.hypot(*np.diff(line.points, axis=0).T)
    s = float(ends[:i].sum() + 0.5 * ends[i])
    x, y = beside(line, s, left * min(1.0, float(ends[i])))
    at, offset, segment = line.project(x, y)
    assert at == pytest.approx(s, abs=1e-6)
    assert offset == pytest.approx(left * min(1.0, float(ends[i])), abs=1e-6)
    assert segment == i


@few
@given(roads(), share, sideways, sideways)
def test_the_offset_is_the_distance_to_the_line(line: Polyline, where: float, dx: float, dy: float) -> None:
    x, y = np.add(line.point_at(where * line.length), (dx, dy)).tolist()
    s, offset, _ = line.project(x, y)
    if 0.0 < s < line.length:
        assert abs(offset) == pytest.approx(distance(line, x, y), abs=1e-6)


@few
@given(roads(), share, sideways, sideways, st.integers(-4, 4))
def test_a_hint_near_by_finds_what_the_whole_search_finds(
    line: Polyline, where: float, dx: float, dy: float, steps: int
) -> None:
    x, y = np.add(line.point_at(where * line.length), (dx, dy)).tolist()
    s, offset, segment = line.project(x, y)
    hint = min(max(segment + steps, 0), len(line) - 2)
    assert line.project(x, y, hint)[:2] == pytest.approx((s, offset), abs=1e-6)


@few
@given(roads(), st.lists(st.tuples(sideways, sideways), min_size=1, max_size=9))
def test_many_points_lie_where_each_of_them_does(line: Polyline, points: list[tuple[float, float]]) -> None:
    x, y = np.array(points).T
    assert line.along(x, y).tolist() == [line.project(*point)[0] for point in points]


@few
@given(roads(), st.lists(st.floats(-0.2, 1.2), min_size=1, max_size=9))
def test_many_arc_lengths_lie_where_each_of_them_does(line: Polyline, shares: list[float]) -> None:
    arcs = [share * line.length for share in shares] + list(line.columns[2])
    assert line.points_at(np.array(arcs)).tolist() == [list(line.point_at(arc)) for arc in arcs]
    assert line.headings_at(np.array(arcs)).tolist() == [line.heading_at(arc) for arc in arcs]


def test_left_of_the_line_is_positive() -> None:
    assert corner.project(5, 2)[:2] == (5.0, 2.0)
    assert corner.project(12, 5)[:2] == (15.0, -2.0)


def test_outside_a_corner_the_offset_is_the_distance_to_its_point() -> None:
    s, offset, _ = corner.project(13, -4)
    assert (s, offset) == (10.0, pytest.approx(-5.0))


def test_beyond_the_ends_only_what_lies_to_the_side_counts() -> None:
    assert corner.project(-3, 1)[:2] == (0.0, 1.0)
    assert corner.project(9, 14)[:2] == (20.0, 1.0)


def test_beyond_the_ends_the_line_goes_straight_on() -> None:
    assert corner.point_at(-2) == (-2.0, 0.0)
    assert corner.point_at(23) == (10.0, 13.0)
    assert corner.heading_at(23) == pytest.approx(math.pi / 2)


@few
@given(roads(), share)
def test_the_segment_at_an_arc_length_holds_it(line: Polyline, where: float) -> None:
    s = where * line.length
    x, y, hx, hy = line.segment(line.segment_at(s))
    px, py = line.point_at(s)
    along = (px - x) * hx + (py - y) * hy
    assert -1e-9 <= along <= 5.0 + 1e-9
    assert (x + along * hx, y + along * hy) == pytest.approx((px, py))


def test_past_the_last_segment_stands_the_end_of_the_line() -> None:
    assert corner.segment(2) == (10.0, 10.0, 0.0, 1.0)


@few
@given(roads(), st.floats(0.3, 4.0))
def test_resampled_points_are_evenly_spaced_and_keep_both_ends(line: Polyline, spacing: float) -> None:
    again = line.resampled(spacing)
    assert tuple(again.points[0]) == pytest.approx(tuple(line.points[0]))
    assert tuple(again.points[-1]) == pytest.approx(tuple(line.points[-1]))
    along = [line.project(float(x), float(y))[0] for x, y in again.points]
    assert np.diff(along)[:-1] == pytest.approx(spacing, abs=2e-3)
    assert np.diff(along)[-1] <= spacing + 2e-3


def test_resampling_keeps_the_end_when_the_last_gap_is_tiny() -> None:
    line = Polyline([(0, 0), (10.0005, 0)])
    assert line.resampled(1.0).length == line.length


@few
@given(roads(), share, share)
def test_a_part_has_the_length_between_its_ends(line: Polyline, one: float, other: float) -> None:
    start, end = sorted((one * line.length, other * line.length))
    if end - start > 0.01:
        part = line.between(start, end)
        assert part.length == pytest.approx(end - start, abs=2e-3)
        assert tuple(part.points[0]) == pytest.approx(line.point_at(start), abs=1e-6)


@few
@given(roads(), st.floats(-3.5, 3.5))
def test_a_line_shifted_sideways_stays_at_that_distance(line: Polyline, left: float) -> None:
    shifted = line.offset(left)
    assert len(shifted) == len(line)
    for (x, y), point in zip(line.points, shifted.points, strict=True):
        assert math.hypot(point[0] - x, point[1] - y) == pytest.approx(abs(left), abs=1e-6)
    # Midway between two points the chord is nearer than the points by no more than the turn allows.
    for (ax, ay), (bx, by) in pairwise(shifted.points):
        _, offset, _ = line.project((ax + bx) / 2, (ay + by) / 2)
        assert offset == pytest.approx(left, abs=0.05 * max(1.0, abs(left)))


def test_joined_lines_run_end_to_end() -> None:
    joined = Polyline.join(Polyline([(0, 0), (10, 0)]), Polyline([(10, 0), (10, 10)]))
    assert joined.points.tolist() == corner.points.tolist()
    assert joined.length == 20.0
