"""A simulator of thirty lines: vehicles follow a script, whatever is asked of them."""

from pathlib import Path

from chatscene.settings import SimulationSettings
from chatscene.simulate.stepped import SteppedSimulator
from chatscene.terms.simulator import SimulatorIdentity
from chatscene.world.bodies import Body, Placement, body_of

SPEEDS = (*(2.0 * step for step in range(5)), 10.0)  # [m/s] at each step; the last holds on


class Scripted:
    """Vehicles go straight ahead at the speeds of the script; walkers stand."""

    def __init__(self) -> None:
        self._bodies: list[Body] = []
        self._steps = 0

    def add(self, placement: Placement) -> Body:
        body = body_of(placement)
        if placement.wheelbase:
            self._bodies.append(body)
        return body

    def step(self, dt: float) -> None:
        self._steps += 1
        for body in self._bodies:
            body.before, body.speed = body.speed, SPEEDS[min(self._steps, len(SPEEDS) - 1)]
            body.x += body.speed * dt * body.cos
            body.y += body.speed * dt * body.sin

    def close(self) -> None:
        self._bodies.clear()


def make_simulator(map_path: Path, settings: SimulationSettings) -> SteppedSimulator:
    identity = SimulatorIdentity(name="scripted", version="1", physics="a script", exact=True, confinable=False)
    return SteppedSimulator(map_path, settings, identity=identity, physics_of=Scripted)
