"""Speeds on a line: what curves let somebody have, however the points of the line lie."""

import math

import numpy as np
import pytest

from chatscene.terms.polyline import Polyline
from chatscene.world.control import CURVE_ACCELERATION, curve_speeds


def test_a_slight_bend_between_a_long_piece_and_short_ones_slows_nobody_down():
    bend = math.radians(0.6)
    short = [(180.0 + 5.0 * k * math.cos(bend), 5.0 * k * math.sin(bend)) for k in range(1, 5)]
    line = Polyline([(0.0, 0.0), (180.0, 0.0), *short, (short[-1][0] + 60.0, short[-1][1] + 1.0)])
    assert min(curve_speeds(line)) > 40.0


@pytest.mark.parametrize("radius", [20.0, 60.0])
def test_a_curve_is_as_slow_by_points_of_any_distance(radius: float):
    angles = np.concatenate((np.linspace(0.0, 0.5, 6), np.linspace(0.5, 1.2, 30)[1:]))
    arc = [(radius * math.sin(a), radius * (1.0 - math.cos(a))) for a in angles.tolist()]
    speeds = curve_speeds(Polyline([(-120.0, 0.0), *arc]))
    assert min(speeds) == pytest.approx(math.sqrt(CURVE_ACCELERATION * radius), rel=0.15)
