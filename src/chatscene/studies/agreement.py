"""Whether two simulators tell the same of the same scenes: does the ego collide, on which side, when?

A simulator with bodies of its own sizes is beside the embedded one in two ways: as that is, and with its sizes.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import dataclass, replace
from pathlib import Path

from chatscene.ego.policy import EgoPolicy
from chatscene.errors import MapError
from chatscene.measure.criticality import criticality
from chatscene.program.sample import draw, scene_seed
from chatscene.runs.replay import STEPS_APART, apart
from chatscene.search.generators.retrieved import Retrieved
from chatscene.settings import RetrievalSettings, SimulationSettings
from chatscene.simulate.physics import Physics, PhysicsOf
from chatscene.simulate.simulator import Simulator, load_simulator, simulate
from chatscene.simulate.stepped import SteppedSimulator
from chatscene.terms.episode import Episode, Event
from chatscene.terms.scenario import BaseScenario
from chatscene.terms.scene import Rejected, Scene, ScenicProgram
from chatscene.world.bodies import Body, Placement

TRIES = 20  # draws until a simulator can place one
SizeOf = Callable[[Placement], tuple[float, float]]
"""Length and width [m] that a simulator gives a thing."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Compared:
    """One scene in two simulators.

    Attributes:
        difference: What they tell differently, in words; empty where they tell the same.
        collided: Whether the ego collides in the first of them.
        apart: The largest distance [m] between where the two have an actor at the same step; 0 if one rejects it.
    """

    scene: Scene
    difference: str
    collided: bool
    apart: float


def same_sizes(map_path: Path, settings: SimulationSettings, size_of: SizeOf) -> SteppedSimulator:
    """The embedded simulator with bodies of another simulator's sizes, as far as wheelbases go with the length."""
    embedded = load_simulator(map_path, replace(settings, simulator=SimulationSettings().simulator))
    physics_of: PhysicsOf = getattr(embedded, "physics_of")  # noqa: B009 - of one that is made of a physics
    return SteppedSimulator(
        map_path, settings, identity=embedded.identity, physics_of=lambda: _Resized(physics_of(), size_of)
    )


def everyday_programs(simulator: Simulator) -> Iterator[ScenicProgram]:
    """The programs of the benchmark's sentences that have a place on a simulator's map; first one a base scenario."""
    generator, reading = Retrieved(), RetrievalSettings()
    for texts in zip(*(generator.texts(base) for base in BaseScenario), strict=True):
        for text in texts:
            program = generator.write(generator.read(text, reading), reading).program
            with suppress(MapError):
                simulator.route(program, 0)
                yield program


class _Resized:
    """A physics whose bodies have other sizes than a scene gives them."""

    def __init__(self, physics: Physics, size_of: SizeOf) -> None:
        self._physics = physics
        self._size_of = size_of
        self.step = physics.step
        self.close = physics.close

    def add(self, placement: Placement) -> Body:
        """Make the body of a thing."""
        length, width = self._size_of(placement)
        wheelbase = placement.wheelbase * length / placement.length
        return self._physics.add(replace(placement, length=length, width=width, wheelbase=wheelbase))


def compared(
    program: ScenicProgram, count: int, *, route: int, seed: int, ego: EgoPolicy, simulators: tuple[Simulator, ...]
) -> Iterator[tuple[Compared, ...]]:
    """Scenes of a program, drawn uniformly, in several simulators; one that none of them can place is drawn again.

    Yields:
        For each scene, what each further simulator tells beside the first.
    """
    for index in range(count):
        for attempt in range(TRIES):
            name = f"{program.scenario_id}/route-{route:02d}/scene-{index:03d}" + (f".{attempt}" if attempt else "")
            scene = Scene(
                id=name,
                scenario_id=program.scenario_id,
                route=route,
                block=0,
                seed=(own := scene_seed(seed, name)),
                values=draw(program.parameters, seed=own),
            )
            first, *others = (simulate(simulator, program, scene, ego) for simulator in simulators)
            if any(isinstance(one, Episode) for one in (first, *others)):
                yield tuple(_beside(scene, first, other) for other in others)
                break


def _beside(scene: Scene, one: Episode | Rejected, other: Episode | Rejected) -> Compared:
    return Compared(
        scene=scene,
        difference=difference(one, other),
        collided=isinstance(one, Episode) and one.collision is not None,
        apart=0.0
        if isinstance(one, Rejected) or isinstance(other, Rejected)
        else max(map(apart, one.tracks, other.tracks)),
    )


def difference(one: Episode | Rejected, other: Episode | Rejected) -> str:
    """What two drives of a scene tell differently of the ego's first collision, in words; empty for the same."""
    if isinstance(one, Rejected) or isinstance(other, Rejected):
        if isinstance(one, Rejected) and isinstance(other, Rejected):
            return ""
        reason = one.reason if isinstance(one, Rejected) else other.reason if isinstance(other, Rejected) else ""
        return f"{'the first' if isinstance(one, Rejected) else 'the second'} rejects it: {reason}"
    a, b = one.collision, other.collision
    if a is None or b is None:
        return "" if a is b else f"{_told(a, one)}; {_told(b, other)}"
    same = (a.other, a.side) == (b.other, b.side) and abs(a.step - b.step) <= STEPS_APART
    return "" if same else f"{_told(a, one)}; {_told(b, other)}"


def _told(crash: Event | None, episode: Episode) -> str:
    if crash is None:
        return f"no collision, {criticality(episode).distance:.2f} m at the closest"
    return f"{crash.side} with {crash.other} at step {crash.step}"
