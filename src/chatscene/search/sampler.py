"""Where a search looks next: one Protocol, and a file of `samplers` for each name.

A sampler has no memory of its own. What it proposes for a block follows from the parameters, from what came of the
blocks before and from the block's seed; so a search that was cut goes on exactly as if it had not been.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Protocol

from chatscene.plugins import Kind, Packaged, make
from chatscene.terms.outcome import Outcome
from chatscene.terms.snippet import ParameterRange


@dataclass(frozen=True, slots=True, kw_only=True)
class Proposal:
    """Where the scenes of a block lie.

    Attributes:
        ranges: What they are drawn from, a range per parameter; the declared ones where a sampler has no ranges.
        draw: The values of the next scene, each within its declared range. Its argument is the scene's seed, which a
            sampler whose scenes depend on each other may leave aside. A scene that cannot be placed is followed by
            another draw.
    """

    ranges: tuple[ParameterRange, ...]
    draw: Callable[[int], dict[str, float]]


class Sampler(Protocol):
    """Says where to look next.

    One that walks a sequence in place of drawing at random cannot know from `done` alone how far it came, since draws
    that could not be placed leave no outcome: `chatscene.search.samplers.unit_cube.walk_on` goes on behind them.
    """

    def propose(
        self, declared: Sequence[ParameterRange], done: Sequence[Sequence[Outcome]], *, count: int, seed: int
    ) -> Proposal:
        """Where the next block lies.

        Args:
            declared: The parameters with the ranges that must be kept.
            done: What came of each block before, scene by scene; rejected draws are not among them.
            count: How many scenes the block is to have.
            seed: Of the block.
        """
        ...


SAMPLERS: Kind[Sampler] = Kind(
    noun="sampler",
    group="chatscene.samplers",
    method="propose",
    built_in=Packaged("search/samplers"),
)


def looks_back(name: str) -> bool:
    """Whether what the sampler of a name proposes follows from what came of the blocks before.

    One that has a `looks_back` of False is told of empty blocks, and nobody keeps for it what came of a million scenes.
    """
    return bool(getattr(load_sampler(name), "looks_back", True))


def load_sampler(name: str) -> Sampler:
    """A sampler by its name (`chatscene.plugins`).

    Raises:
        SettingsError: There is none of that name.
        MissingExtra: Its package is missing.
    """
    return make(SAMPLERS, name)
