"""What a watcher works out of a track."""

from __future__ import annotations

import numpy as np
import pytest

from chatscene.program.watching import percentile


@pytest.mark.parametrize("count", [1, 2, 7, 56, 301])
@pytest.mark.parametrize("of", [0, 25, 50, 90, 100])
def test_a_percentile_is_numpys_to_the_bit(count: int, of: float) -> None:
    for seed in range(20):
        values = np.random.default_rng(seed).normal(size=count)
        assert percentile(values, of) == np.percentile(values, of)
