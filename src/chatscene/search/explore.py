"""Steps 5 and 6 of 9: blocks of scenes, each drawn from ranges moved by what collided before.

Paper: section 3.3, steps iv and v, and section 4.2. A job is one scenario on one route; jobs are independent, so
that any number of processes gives the same scenes.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from chatscene.ego.policy import EgoPolicy
from chatscene.evaluate.drive import Ran, drive
from chatscene.program.sample import draw, scene_seed
from chatscene.search.refine import refine
from chatscene.settings import SearchSettings
from chatscene.simulate.backend import Backend
from chatscene.terms.scenario import Slots
from chatscene.terms.scene import Rejected, Scene, ScenicProgram
from chatscene.terms.snippet import ParameterRange


@dataclass(frozen=True, slots=True, kw_only=True)
class Block:
    """The scenes between two range updates.

    Attributes:
        scenario_id: Which scenario.
        route: Index of the route.
        number: Which block, from 0.
        ranges: What its scenes were drawn from.
        ran: Scenes that were driven, in order.
        rejected: Draws that could not be placed, in order.
    """

    scenario_id: str
    route: int
    number: int
    ranges: tuple[ParameterRange, ...]
    ran: tuple[Ran, ...]
    rejected: tuple[Rejected, ...]


def explore(
    program: ScenicProgram,
    slots: Slots,
    route: int,
    *,
    backend: Backend,
    ego: EgoPolicy,
    settings: SearchSettings,
    collided: Sequence[Sequence[dict[str, float]]] = (),
) -> Iterator[Block]:
    """Search one route, block by block.

    Args:
        program: What to search with.
        slots: What was said, to judge each drive by.
        route: Index of the route.
        backend: Where to drive.
        ego: The surrogate ego.
        settings: Scenes, block size, seed.
        collided: For each block already done, the values of its scenes that collided; the search goes on after
            them exactly as if it had not stopped.

    Yields:
        The blocks still to be done.
    """
    hits = [values for block in collided for values in block]
    for number in range(len(collided), -(-settings.scenes // settings.block)):
        ranges = refine(program.parameters, hits)
        first = number * settings.block
        block = _run_block(
            program,
            slots,
            [
                _Slot(program.scenario_id, route, number, index)
                for index in range(first, min(first + settings.block, settings.scenes))
            ],
            ranges,
            backend,
            ego,
            settings,
        )
        hits += collided_values(block)
        yield block


def collided_values(block: Block) -> list[dict[str, float]]:
    """The values of the scenes of a block in which the ego collided, in order."""
    return [dict(ran.scene.values) for ran in block.ran if ran.episode.collision is not None]


@dataclass(frozen=True, slots=True)
class _Slot:
    """The place of one scene in the search."""

    scenario_id: str
    route: int
    block: int
    index: int


def _run_block(
    program: ScenicProgram,
    slots: Slots,
    places: Sequence[_Slot],
    ranges: tuple[ParameterRange, ...],
    backend: Backend,
    ego: EgoPolicy,
    settings: SearchSettings,
) -> Block:
    ran: list[Ran] = []
    rejected: list[Rejected] = []
    for place in places:
        for scene in _draws(place, ranges, settings):
            outcome = drive(program, slots, scene, backend=backend, ego=ego)
            if isinstance(outcome, Ran):
                ran.append(outcome)
                break
            rejected.append(outcome)
    return Block(
        scenario_id=program.scenario_id,
        route=places[0].route,
        number=places[0].block,
        ranges=ranges,
        ran=tuple(ran),
        rejected=tuple(rejected),
    )


def _draws(place: _Slot, ranges: tuple[ParameterRange, ...], settings: SearchSettings) -> Iterator[Scene]:
    """Scenes to try for one place: the first, then as many again as may be needed until one can be placed."""
    stem = f"{place.scenario_id}/route-{place.route:02d}/scene-{place.index:03d}"
    for attempt in range(settings.tries):
        name = stem if attempt == 0 else f"{stem}.{attempt}"
        seed = scene_seed(settings.seed, name)
        yield Scene(
            id=name,
            scenario_id=place.scenario_id,
            route=place.route,
            block=place.block,
            seed=seed,
            values=draw(ranges, seed=seed),
        )
