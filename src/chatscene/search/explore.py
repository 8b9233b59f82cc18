"""Steps 5 and 6 of 9: blocks of scenes, each where a sampler looks next, knowing what came of those before.

Paper: section 3.3, steps iv and v, and section 4.2. A job is one scenario on one route; jobs are independent, so
that any number of processes gives the same scenes.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import islice

from chatscene.ego.policy import EgoPolicy
from chatscene.measure.drive import Ran, drive_all
from chatscene.program.sample import scene_seed
from chatscene.search.sampler import Proposal, load_sampler, looks_back
from chatscene.settings import SearchSettings
from chatscene.simulate.simulator import Simulator
from chatscene.terms.outcome import Outcome
from chatscene.terms.scenario import Said
from chatscene.terms.scene import Rejected, Scene, ScenicProgram
from chatscene.terms.snippet import ParameterRange

DRAWN_TRIES = 3  # scenes to try for one place where each is drawn until it meets the requirements or time is up


@dataclass(frozen=True, slots=True, kw_only=True)
class Block:
    """The scenes between two range updates."""

    scenario_id: str
    route: int
    number: int
    ranges: tuple[ParameterRange, ...]
    ran: tuple[Ran, ...]
    rejected: tuple[Rejected, ...]


def explore(
    program: ScenicProgram,
    said: Said,
    route: int,
    *,
    simulator: Simulator,
    ego: EgoPolicy,
    settings: SearchSettings,
    done: Sequence[Sequence[Outcome]] = (),
) -> Iterator[Block]:
    """Search one route, block by block.

    Args:
        program: What to search with.
        said: What was said, to judge each drive by.
        route: Index of the route.
        simulator: Where to drive.
        ego: The surrogate ego.
        settings: Scenes, block size, sampler, seed.
        done: What came of each block already done; the search goes on after them exactly as if it had not stopped.

    Yields:
        The blocks still to be done.
    """
    sampler, told = load_sampler(settings.sampler), looks_back(settings.sampler)
    history = list(done)
    for number in range(len(done), -(-settings.scenes // settings.block)):
        places = [
            _Slot(program.scenario_id, route, number, index)
            for index in range(number * settings.block, min((number + 1) * settings.block, settings.scenes))
        ]
        seed = scene_seed(settings.seed, f"{program.scenario_id}/route-{route:02d}/block-{number:03d}")
        asked = [[_asked(outcome, settings.objective) for outcome in block] for block in history] if told else []
        proposal = sampler.propose(program.parameters, asked, count=len(places), seed=seed)
        block = _run_block(program, said, places, proposal, simulator, ego, settings)
        history.append(outcomes(block) if told else [])
        yield block


def outcomes(block: Block) -> list[Outcome]:
    """What came of the scenes of a block, in order."""
    return [
        Outcome(
            values=dict(ran.scene.values),
            collided=ran.episode.collision is not None,
            distance=ran.criticality.distance,
            impact_speed=ran.criticality.impact_speed or 0.0,
            completion=float(ran.episode.route_completion),
            avoidable=ran.avoidable,
            by_ego=ran.fault is not None and ran.fault.by_ego,
            crash_type=ran.crash_type,
            waits=ran.waits,
            touch=ran.touch,
        )
        for ran in block.ran
    ]


def _asked(outcome: Outcome, objective: str) -> Outcome:
    """An outcome as far as an objective asks for it."""
    return outcome if objective == "avoidable" else replace(outcome, avoidable=None, waits=False)


@dataclass(frozen=True, slots=True)
class _Slot:
    """The place of one scene in the search."""

    scenario_id: str
    route: int
    block: int
    index: int


def _run_block(
    program: ScenicProgram,
    said: Said,
    places: Sequence[_Slot],
    proposal: Proposal,
    simulator: Simulator,
    ego: EgoPolicy,
    settings: SearchSettings,
) -> Block:
    tries = [islice(_draws(place, proposal, settings), DRAWN_TRIES if program.drawn else None) for place in places]
    ran: dict[int, Ran] = {}
    rejected: list[list[Rejected]] = [[] for _ in places]
    left = list(range(len(places)))
    while left:
        drawn = [(number, scene) for number in left if (scene := next(tries[number], None)) is not None]
        came = drive_all(program, said, [scene for _, scene in drawn], simulator=simulator, ego=ego)
        for (number, _), outcome in zip(drawn, came, strict=True):
            if isinstance(outcome, Ran):
                ran[number] = outcome
            else:
                rejected[number].append(outcome)
        left = [number for number, _ in drawn if number not in ran]
    return Block(
        scenario_id=program.scenario_id,
        route=places[0].route,
        number=places[0].block,
        ranges=proposal.ranges,
        ran=tuple(ran[number] for number in sorted(ran)),
        rejected=tuple(one for of_place in rejected for one in of_place),
    )


def _draws(place: _Slot, proposal: Proposal, settings: SearchSettings) -> Iterator[Scene]:
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
            values=proposal.draw(seed),
        )
