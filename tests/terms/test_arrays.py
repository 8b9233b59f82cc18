"""What stands in for a call of numpy finds the same, to the bit."""

import math

import numpy as np
import pytest

from chatscene.terms.arrays import slopes, unwrapped


@pytest.mark.parametrize("spread", [0.3, 1.5, 4.0])
def test_angles_lose_their_jumps_as_numpy_takes_them(spread: float) -> None:
    rng = np.random.default_rng(0)
    for size in (1, 2, 3, 50):
        angles = np.cumsum(rng.normal(0.0, spread, size))
        jumps = (angles + math.pi) % math.tau - math.pi
        jumps[::7] = -0.0
        gone = jumps.copy()
        gone[size // 2] = math.nan
        for one in (angles, jumps, gone):
            assert unwrapped(one).tobytes() == np.unwrap(one).tobytes()


def test_slopes_are_those_of_numpy() -> None:
    rng = np.random.default_rng(1)
    for size in (2, 3, 4, 200):
        values = rng.normal(0.0, 10.0, size)
        assert slopes(values).tobytes() == np.gradient(values).tobytes()
