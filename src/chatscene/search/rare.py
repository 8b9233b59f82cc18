"""How often something happens, from drives that were drawn where it is likelier than on the road.

Multiple importance sampling with the balance heuristic (Veach and Guibas 1995): a drive counts as often as its point
occurs under the exposure for once that it is drawn by all batches together. Shares are self-normalised (Owen, *Monte
Carlo theory, methods and examples*, chapter 9), so that points where the scene cannot be placed, of which nobody knows
how many there are, need no weight: what is told is of scenes that can be.

Batches that aim at what crashed before would make a drive count too little that crashed, since they were drawn there
for that. So a drive counts as if neither it nor any drive that it led to had drawn others (decision 0107).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Protocol

import numpy as np
from numpy.typing import NDArray
from scipy import special, stats

from chatscene.search.exposure import Exposure

Array = NDArray[np.float64]
Flags = NDArray[np.bool_]
Numbers = NDArray[np.intp]

ROUNDS = 10  # of drives; where the next looks depends on what came of those before
COMMON = 0.1  # share of crashes from which on nothing is aimed: the exposure shows enough of them
CONFIDENCE = 0.95  # of intervals, where nothing was aimed
# Where it did, weights are uneven, and how much they vary is known no better than they are: intervals of 95 % hold what
# is true too seldom, those as wide as of 99 % in 97 to 99 of 100 where most rates can be told (decision 0107).
CONFIDENCE_AIMED = 0.99
FEWEST = 30  # effective crashes of which a share is told
DEFENSIVE = 0.35  # share of the draws of an aimed batch that are left to the exposure, so that nothing is overlooked
CENTRES = 50  # at most, of an aimed batch
FEWEST_CENTRES = 10
_ROOT = np.sqrt(2 * np.pi)
NARROWEST = 0.05  # width of a kernel, as a share of the declared range


class Density(Protocol):
    """What the points of a batch were drawn from."""

    def density(self, points: Array) -> Array:
        """(N,) of points, (N, dimensions), in the unit cube."""
        ...


@dataclass(frozen=True, slots=True)
class Box:
    """Uniform in a box.

    Attributes:
        low: (dimensions,) its lower corner in the unit cube.
        high: (dimensions,) its upper one; a side without length is as wide as values are exact.
    """

    low: Array
    high: Array

    def density(self, points: Array) -> Array:
        """(N,) of points, (N, dimensions)."""
        side = np.maximum(self.high - self.low, 1e-6)
        inside = ((points >= self.low - 1e-6) & (points <= self.high + 1e-6)).all(axis=1)
        return np.where(inside, 1.0 / np.prod(side), 0.0)


@dataclass(frozen=True, slots=True)
class Aimed:
    """Kernels around drives, and a share that is left to the exposure.

    Attributes:
        centres: (M, dimensions) their points.
        lines: Of each, the numbers of the drives that led to it one by one, with its own.
        width: (dimensions,) standard deviations of the kernels, which are normal and cut off at the cube.
    """

    centres: Array
    lines: tuple[tuple[int, ...], ...]
    width: Array
    exposure: Exposure

    def density(self, points: Array) -> Array:
        """(N,) of points, (N, dimensions)."""
        return self._mixed(self._near(points).mean(axis=1), points)

    def at_drives(self, points: Array) -> Array:
        """(N,) of the points of all drives before, in their order, each without its own kernel and those it led to.

        Where none is left, nobody knows where would have been drawn without it: as if it were the exposure.
        """
        near = self._near(points)
        others = np.ones(near.shape, bool)
        for centre, line in enumerate(self.lines):
            others[list(line), centre] = False
        left = others.sum(axis=1)
        kernels = np.where(others, near, 0.0).sum(axis=1) / np.maximum(left, 1)
        return self._mixed(np.where(left > 0, kernels, self.exposure.density(points)), points)

    def _near(self, points: Array) -> Array:
        """(N, M) of each kernel."""
        near = np.ones((len(points), len(self.centres)))
        for d, width in enumerate(self.width):
            centres = self.centres[:, d]
            share = special.ndtr((1 - centres) / width) - special.ndtr(-centres / width)
            near *= np.exp(-0.5 * ((points[:, d, None] - centres) / width) ** 2) / (_ROOT * width * share)
        return near

    def _mixed(self, kernels: Array, points: Array) -> Array:
        return DEFENSIVE * self.exposure.density(points) + (1 - DEFENSIVE) * kernels

    def draw(self, count: int, rng: np.random.Generator) -> tuple[Array, Numbers]:
        """(count, dimensions) points, and (count,) around which drive each was drawn; -1 of none."""
        points = self.exposure.draw(count, rng)
        aimed = rng.random(count) >= DEFENSIVE
        chosen = rng.integers(len(self.centres), size=count)
        centres = self.centres[chosen]
        low, high = special.ndtr(-centres / self.width), special.ndtr((1 - centres) / self.width)
        kernels = centres + self.width * special.ndtri(low + rng.random(centres.shape) * (high - low))
        drives = np.array([line[-1] for line in self.lines], np.intp)[chosen]
        return np.where(aimed[:, None], np.clip(kernels, 0.0, 1.0), points), np.where(aimed, drives, -1)


@dataclass(frozen=True, slots=True, kw_only=True)
class Share:
    """How often something happens, of scenes that can be placed.

    Attributes:
        seen: How many of the drives it happened in, wherever they were drawn.
        effective: As many drives without weights would tell as much of it: it is told of from `FEWEST` on.
        probability: Its share under the exposure; None where `effective` is too few.
        low: Lower end of the interval; None as `probability`.
        high: Upper end; where nothing is told, what it is below with 95 % if it never happened, else None.
    """

    seen: int
    effective: float
    probability: float | None
    low: float | None
    high: float | None


@dataclass(frozen=True, slots=True, kw_only=True)
class Batch:
    """Points that were drawn together, whether they could be placed or not.

    Attributes:
        route: On which route all of them; None if on every route alike.
        around: (count,) the number of the drive around which each was drawn, -1 of none; None if none was around any.
    """

    count: int
    density: Density
    route: int | None = None
    around: Numbers | None = None

    @property
    def aimed(self) -> bool:
        """Whether earlier drives led to where it was drawn."""
        narrowed = isinstance(self.density, Box) and bool((self.density.high - self.density.low < 1).any())
        return narrowed or isinstance(self.density, Aimed)


def share_of(happened: Flags, weights: Array, *, aimed: bool = False) -> Share:
    """How often something happens.

    The interval is Wilson's for as many drives as would have the same variance without weights, of `CONFIDENCE` or,
    where some were aimed, as wide as one of `CONFIDENCE_AIMED`. Where all weigh the same it is told of however few.

    Args:
        happened: (N,) in which drives.
        weights: (N,) of the drives.
        aimed: Whether some were drawn where others had led.
    """
    seen, total = int(happened.sum()), float(weights.sum())
    if not seen:
        effective = total**2 / float((weights**2).sum()) if total else 0.0
        below = 1.0 - (1.0 - CONFIDENCE) ** (1.0 / effective) if effective else 1.0
        return Share(seen=0, effective=0.0, probability=None, low=None, high=below)
    hit = weights[happened]
    effective = float(hit.sum() ** 2 / (hit**2).sum())
    alike = bool(np.allclose(weights, weights[0]))  # quotients of densities, whose last bits differ
    if effective < FEWEST and not alike:
        return Share(seen=seen, effective=effective, probability=None, low=None, high=None)
    p = float(hit.sum()) / total
    variance = float((weights**2 * (happened - p) ** 2).sum()) / total**2
    count = float(len(weights)) if alike else p * (1 - p) / variance if variance > 0 else effective
    low, high = _wilson(p, count, CONFIDENCE_AIMED if aimed else CONFIDENCE)
    return Share(seen=seen, effective=effective, probability=p, low=low, high=high)


def _wilson(p: float, count: float, confidence: float) -> tuple[float, float]:
    z = float(stats.norm.ppf(0.5 + confidence / 2))
    middle = (p + z * z / (2 * count)) / (1 + z * z / count)
    half = z / (1 + z * z / count) * np.sqrt(p * (1 - p) / count + z * z / (4 * count * count))
    return max(0.0, float(middle - half)), min(1.0, float(middle + half))


@dataclass(frozen=True, slots=True)
class Came:
    """What came of one scene that could be placed.

    Attributes:
        danger: How near it came (`chatscene.terms.outcome.Outcome.danger`).
        crashed: Whether the ego crashed with an adversary.
        avoidable: Whether it did, and a careful driver would not have; None where that is not known.
    """

    danger: float
    crashed: bool
    avoidable: bool | None


class Tally:
    """All drives so far, and what each batch of them was drawn from.

    Args:
        exposure: How often their points occur.
    """

    def __init__(self, exposure: Exposure) -> None:
        self._exposure = exposure
        self._points = np.empty((0, len(exposure.densities)))
        self._routes = np.empty(0, np.intp)
        self._around = np.empty(0, np.intp)
        self._came: list[Came] = []
        self._batches: list[Batch] = []
        self._densities: list[Array] = []  # of each batch, at every point

    @property
    def placed(self) -> int:
        """How many scenes were driven."""
        return len(self._came)

    @property
    def drawn(self) -> int:
        """How many were drawn, with those that could not be placed."""
        return sum(batch.count for batch in self._batches)

    def add(self, points: Array, routes: Sequence[int], came: Sequence[Came | None], batch: Batch) -> None:
        """Count a batch.

        Args:
            points: (N, dimensions) that were drawn.
            routes: On which route each.
            came: What came of each; None of what could not be placed.
            batch: What they were drawn from.
        """
        placed = [number for number, one in enumerate(came) if one is not None]
        new, density = points[placed], batch.density
        known = density.at_drives(self._points) if isinstance(density, Aimed) else density.density(self._points)
        self._densities.append(known)
        self._batches.append(batch)
        self._densities = [
            np.concatenate((before, one.density.density(new)))
            for before, one in zip(self._densities, self._batches, strict=True)
        ]
        self._points = np.concatenate((self._points, new))
        self._routes = np.concatenate((self._routes, np.array(routes, np.intp)[placed]))
        around = np.full(len(points), -1, np.intp) if batch.around is None else batch.around
        self._around = np.concatenate((self._around, around[placed]))
        self._came += [one for one in came if one is not None]

    def draw(self, count: int, rng: np.random.Generator) -> tuple[Array, Batch]:
        """(count, dimensions) points to drive next, and what they were drawn from.

        That is the exposure, or where crashes are rare, also around what crashed, and where nearly nothing did, around
        what came nearest to it.
        """
        aimed = self._aim(rng)
        if aimed is None:
            return self._exposure.draw(count, rng), Batch(count=count, density=self._exposure)
        points, around = aimed.draw(count, rng)
        return points, Batch(count=count, density=aimed, around=around)

    def _aim(self, rng: np.random.Generator) -> Aimed | None:
        if not self._came or not self._exposure.densities:
            return None
        weights, crashed = self._weights(), self._flags("crashed")
        if weights[crashed].sum() >= COMMON * weights.sum():
            return None
        hits = np.flatnonzero(crashed)
        if len(hits) < FEWEST_CENTRES:
            dangers = np.array([one.danger for one in self._came])
            chosen = np.argsort(-dangers, kind="stable")[:FEWEST_CENTRES]
        else:
            chosen = np.sort(rng.permutation(hits)[:CENTRES])
        centres = self._points[chosen]
        # Scott's rule for kernels of a density in so many dimensions
        width = centres.std(axis=0) * len(centres) ** (-1 / (centres.shape[1] + 4))
        lines = tuple(self._line(int(number)) for number in chosen)
        return Aimed(centres, lines, np.maximum(width, NARROWEST), self._exposure)

    def _line(self, number: int) -> tuple[int, ...]:
        """The drives that led to a drive one by one, with its own at the end."""
        line = [number]
        while (before := int(self._around[line[0]])) >= 0:
            line.insert(0, before)
        return tuple(line)

    @property
    def unknown(self) -> int:
        """Of how many crashes it is not known whether they were avoidable."""
        return sum(one.avoidable is None for one in self._came)

    def shares(self) -> tuple[Share, Share | None]:
        """Of crashes with an adversary, and of those that were avoidable; None where that is not known of each."""
        weights, aimed = self._weights(), any(batch.aimed for batch in self._batches)
        crashed, avoidable = (share_of(self._flags(name), weights, aimed=aimed) for name in ("crashed", "avoidable"))
        return crashed, None if self.unknown else avoidable

    def _weights(self) -> Array:
        """(N,) how often each drive counts; on every route that was driven alike."""
        many = len(np.unique(self._routes))
        mixture = np.zeros(self.placed)
        for batch, density in zip(self._batches, self._densities, strict=True):
            there = 1.0 if batch.route is None else many * (self._routes == batch.route)
            mixture += batch.count / self.drawn * density * there
        return self._exposure.density(self._points) / mixture

    def _flags(self, name: str) -> Flags:
        return np.array([getattr(one, name) for one in self._came], bool)


def rounds(scenes: int) -> Iterator[int]:
    """How many scenes to draw at once."""
    ends = [scenes * number // ROUNDS for number in range(ROUNDS + 1)]
    yield from (b - a for a, b in pairwise(ends) if b > a)
