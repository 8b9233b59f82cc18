"""Rule-based search: all scenes together walk a grid over the declared ranges.

The baseline "Carla scenario generator" (CARLA ScenarioRunner's rules, as in SafeBench) grid-searches what the paper
learns. A sampler is not told how many scenes there will be, so the grid is refined as it is walked: first the corners,
then every range halved, then quartered, and so on, each level a full-factorial grid around the former one. With one
to three parameters the first 9, 9 and 8 scenes are a classic grid; with eight, 250 scenes are not even all corners,
which is what a grid costs.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import chain, count, repeat

from chatscene.search.sampler import Proposal
from chatscene.search.samplers.unit_cube import UnitCube, walk_on
from chatscene.terms.outcome import Outcome
from chatscene.terms.snippet import ParameterRange

PLUGIN = {
    "name": "grid",
    "makes": "Grid",
    "what": "a grid over the ranges, first coarse, then fine",
}

GOLDEN = (math.sqrt(5) - 1) / 2


class Grid:
    """A grid that grows finer; see `chatscene.search.sampler.Sampler` for the contract."""

    def propose(
        self,
        declared: Sequence[ParameterRange],
        done: Sequence[Sequence[Outcome]],
        *,
        count: int,
        seed: int,
    ) -> Proposal:
        """The points after the last one that was driven."""
        cube = UnitCube(tuple(declared))
        walk = walk_on(cube, done, count, grid)
        return Proposal(ranges=cube.declared, draw=lambda _: next(walk))


def grid(dimensions: int) -> Iterator[tuple[float, ...]]:
    """The points of ever finer grids over the unit cube, none twice, without end.

    Level k has 2**k + 1 values per dimension. Its points come in the order of a fractional factorial design: the first
    (2**k + 1)**m, those of the level before among them, have every pair of values of every two of up to 2**m - 1
    dimensions equally often; so a level that is cut short has still been in every region.

    Args:
        dimensions: Of the cube; without any there is one point, over and over.
    """
    return chain.from_iterable(_level(k, dimensions) for k in count()) if dimensions else repeat(())


def _level(level: int, dimensions: int) -> Iterator[tuple[float, ...]]:
    size = 2**level + 1
    # Within a range, too, no end before the other: a stride near the golden section of the values.
    stride = next(s for s in count(round(size * GOLDEN)) if math.gcd(s, size) == 1)
    design = _design(dimensions)
    for index in range(size**dimensions):
        digits = [index // size**j % size for j in range(dimensions)]
        mixed = [sum(digits[j] for j in chosen) for chosen in design]
        steps = [stride * each % size for each in mixed]
        if level == 0 or any(step % 2 for step in steps):  # else it was on the level before
            yield tuple(step / (size - 1) for step in steps)


def _design(dimensions: int) -> list[list[int]]:
    """Which digits of a point's index each dimension sums.

    Of the fast digits dimension j takes the binary digits of j, so that no two take the same ones; a slow digit of
    its own, where those are more than one, makes the whole reversible: each point of the level has its index.
    """
    fast = dimensions.bit_length()
    return [
        [i for i in range(fast) if j >> i & 1] + [fast + j - j.bit_length() - 1] * (j.bit_count() > 1)
        for j in range(1, dimensions + 1)
    ]
