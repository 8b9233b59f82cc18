"""Do results hinge on how bodies answer: the same searches under each physics, and what a step of it costs.

    python benchmarks/physics.py [--scenes 20] [--routes 2] [--seed 0] [--ego sac] [--ego idm]
        [--base red-light-running] [--jobs 1]

Three generators search with one scenario of each of four base scenarios, as in a benchmark, under each physics:

    kinematic    the default
    lagged       build-up, yaw lag, understeer, a friction circle; a dry road
    lagged, wet  the same with a friction coefficient of 0.5
    CARLA-like   kinematic, but cars brake with 12.5 m/s²: users of CARLA report 10 to 15 m/s² where it is left as it
                 comes (carla-simulator/carla, issue 5463); other vehicles are left as ours are

The first ego is the one that is searched against. The two scenes per route that are kept are driven by every ego;
the table has the collision rate and the median impact speed of those drives, and of all scenes of the search the
collision rate and the share of the crashes that a careful driver would have avoided. The processor time of a step is
that of a car that slaloms, without Scenic and without an ego. How far each physics is from a car of others at 50, 80
and 120 km/h is `benchmarks/manoeuvres.py`.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial
from statistics import median

import click

from chatscene.ego.policy import load_ego
from chatscene.errors import ChatSceneError
from chatscene.maps.network import resolve_map
from chatscene.measure.drive import Ran, drive
from chatscene.runs.executor import Workers
from chatscene.runs.parallel import spread
from chatscene.search.climb import climb
from chatscene.search.generator import load_generator
from chatscene.search.select import Candidate, select
from chatscene.settings import RetrievalSettings, SearchSettings, SimulationSettings
from chatscene.simulate.embedded.dynamics import VehicleBody, make_body
from chatscene.simulate.embedded.lagged import LaggedVehicle
from chatscene.simulate.embedded.physics import EmbeddedPhysics, make_simulator
from chatscene.simulate.simulator import Simulator, routes_of
from chatscene.simulate.stepped import SteppedSimulator
from chatscene.terms.actors import LIMITS, Limits
from chatscene.terms.scenario import BaseScenario

GENERATORS = ("chatscene", "learning-to-collide", "advsim")
BASES = (
    BaseScenario.STRAIGHT_OBSTACLE,
    BaseScenario.LANE_CHANGING,
    BaseScenario.RED_LIGHT_RUNNING,
    BaseScenario.UNPROTECTED_LEFT_TURN,
)
WET = 0.5  # friction coefficient
CARLA_BRAKE = 12.5  # [m/s²]
STEPS = 100_000


def carla_like(x: float, y: float, heading: float, limits: Limits, speed: float) -> VehicleBody:
    """A vehicle of the kinematic physics; a car brakes as CARLA's do."""
    is_car = limits.wheelbase == LIMITS["Car"].wheelbase
    return VehicleBody(x, y, heading, replace(limits, brake=CARLA_BRAKE) if is_car else limits, speed)


Vehicles = Callable[[float, float, float, Limits, float], VehicleBody]
VEHICLES: dict[str, tuple[str, Vehicles]] = {
    "kinematic": ("kinematic", VehicleBody),
    "lagged": ("lagged", LaggedVehicle),
    "lagged, wet": ("lagged", partial(LaggedVehicle, friction=WET)),
    "CARLA-like": ("kinematic", carla_like),
}


@dataclass(frozen=True)
class Task:
    """The searches of one generator under one physics."""

    physics: str
    generator: str


@dataclass
class Found:
    """What the searches came to."""

    task: Task
    searched: list[bool]  # whether each scene collided
    avoidable: list[bool]  # of each of these crashes
    kept: list[bool]  # whether each drive of a kept scene collided
    impacts: list[float]  # [m/s], of these crashes
    refused: list[str]

    def row(self) -> str:
        """A row of the table."""
        impact = f"{median(self.impacts):.1f}" if self.impacts else "none"
        cells = (_share(self.kept), _share(self.searched), _share(self.avoidable), impact)
        return f"| {self.task.physics} | {self.task.generator} | " + " | ".join(cells) + " |"


def _share(those: list[bool]) -> str:
    return f"{sum(those) / len(those):.2f} of {len(those)}" if those else "none"


class Searcher:
    """Does tasks in one process."""

    def __init__(self, given: tuple[SearchSettings, tuple[str, ...], tuple[str, ...]]) -> None:
        self._search, names, bases = given
        self._bases = [BaseScenario(base) for base in bases]
        self._egos = [load_ego(name) for name in names]

    def __call__(self, task: Task) -> Found:
        """Search, and let every ego drive what is kept."""
        found, search, reading = Found(task, [], [], [], [], []), self._search, RetrievalSettings()
        generator, simulator, surrogate = load_generator(task.generator), simulator_of(task.physics), self._egos[0]
        for base in self._bases:
            scenario = generator.read(generator.texts(base)[0], reading)
            first = generator.write(scenario, reading)
            try:
                written, _ = climb(generator, scenario, first, settings=reading, simulator=simulator, ego=surrogate)
            except ChatSceneError as error:
                found.refused.append(f"{task.physics}, {task.generator}, {base}: {error}")
                continue
            for route in routes_of(simulator, written.program, search.routes):
                blocks = generator.explore(
                    written.program, scenario.slots, route, simulator=simulator, ego=surrogate, settings=search, done=()
                )
                every = [ran for block in blocks for ran in block.ran]
                crashed = [ran for ran in every if ran.episode.collision is not None]
                found.searched += [ran.episode.collision is not None for ran in every]
                found.avoidable += [bool(ran.avoidable) for ran in crashed]
                for ran in kept(every, search):
                    for ego in self._egos:
                        again = drive(written.program, scenario.slots, ran.scene, simulator=simulator, ego=ego)
                        if isinstance(again, Ran):
                            found.kept.append(again.episode.collision is not None)
                            if again.criticality.impact_speed is not None:
                                found.impacts.append(again.criticality.impact_speed)
        return found


def simulator_of(physics: str) -> Simulator:
    """The embedded simulator with the vehicles of a physics."""
    setting, vehicle = VEHICLES[physics]
    settings, town = SimulationSettings(physics=setting), resolve_map("town")
    physics_of = partial(EmbeddedPhysics, partial(make_body, vehicle=vehicle))
    return SteppedSimulator(town, settings, identity=make_simulator(town, settings).identity, physics_of=physics_of)


def kept(every: list[Ran], search: SearchSettings) -> list[Ran]:
    """Those that a run keeps of the scenes of one route."""
    candidates = [
        Candidate(
            scene_id=ran.scene.id,
            collided=ran.episode.collision is not None,
            shown=not ran.meaning,
            avoidable=ran.avoidable,
            overall_score=ran.metrics["overall_score"],
        )
        for ran in every
    ]
    chosen = {one.scene_id for one in select(candidates, count=search.keep, selection=search.selection)}
    return [ran for ran in every if ran.scene.id in chosen]


def step_time(vehicle: Vehicles) -> float:
    """Processor time of a step of a car that slaloms [µs], the least of seven."""
    least = float("inf")
    for _ in range(7):
        body = vehicle(0.0, 0.0, 0.0, LIMITS["Car"], 10.0)
        body.throttle = 0.3
        began = time.process_time()
        for number in range(STEPS):
            body.steer = 0.02 if number % 40 < 20 else -0.02
            body.step(0.1)
        least = min(least, time.process_time() - began)
    return least / STEPS * 1e6


@click.command()
@click.option("--scenes", default=20, show_default=True, help="Simulations per scenario and route.")
@click.option("--routes", default=2, show_default=True)
@click.option("--seed", default=0, show_default=True)
@click.option("--ego", "egos", multiple=True, default=("sac", "idm"), show_default=True)
@click.option("--base", "bases", multiple=True, default=BASES, show_default=True)
@click.option("--jobs", default=1, show_default=True)
def main(scenes: int, routes: int, seed: int, egos: tuple[str, ...], bases: tuple[str, ...], jobs: int) -> None:
    """Search under each physics and print the table, the order of the generators, and the time of a step."""
    search = SearchSettings(scenes=scenes, routes=routes, seed=seed)
    tasks = [Task(physics, generator) for physics in VEHICLES for generator in GENERATORS]
    click.echo(
        "| physics | generator | kept scenes: collision rate | all scenes: collision rate | avoidable | impact |"
    )
    click.echo("|---|---|---|---|---|---|")
    order: dict[str, dict[str, float]] = {physics: {} for physics in VEHICLES}
    refused: list[str] = []
    for found in spread(Searcher, (search, egos, bases), tasks, workers=Workers(jobs)):
        click.echo(found.row())
        order[found.task.physics][found.task.generator] = sum(found.kept) / max(len(found.kept), 1)
        refused += found.refused
    for physics, rates in order.items():
        click.echo(f"{physics}: {' > '.join(sorted(rates, key=lambda name: -rates[name]))}")
    for why in refused:
        click.echo(f"refused: {why}")
    kinematic, lagged = (step_time(vehicle) for vehicle in (VehicleBody, LaggedVehicle))
    click.echo(f"a step: {kinematic:.2f} µs kinematic, {lagged:.2f} µs lagged, ratio {lagged / kinematic:.2f}")


if __name__ == "__main__":
    main()
