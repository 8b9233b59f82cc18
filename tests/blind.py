"""An ego that sees its route and nobody, and a car ahead that it runs into."""

from __future__ import annotations

from chatscene.ego.observation import Observation
from chatscene.program.ordinary import ordinary_program, ordinary_queries
from chatscene.terms.scene import Scene


class Blind:
    """Drives at about 8 m/s and brakes for nobody."""

    def act(self, observation: Observation) -> tuple[float, float]:
        lateral, heading, speed, _ = observation.tolist()
        return clipped(0.5 * (8.0 - speed)), clipped(0.35 * lateral + 1.6 * heading)


def clipped(value: float) -> float:
    """A pedal or a wheel, in [-1, 1]."""
    return max(-1.0, min(1.0, value))


STRAIGHT = ordinary_program(ordinary_queries()[0])


def car_ahead(gap: float) -> Scene:
    """A scene of `STRAIGHT`, in which a car drives at 5 m/s ahead of an ego that comes faster; lengths in m."""
    values = {
        "OPT_PARKED_Y": 40.0,
        "OPT_AHEAD_Y": gap,
        "OPT_AHEAD_SPEED": 5.0,
        "OPT_BESIDE_Y": 0.0,
        "OPT_BESIDE_SPEED": 4.0,
    }
    return Scene(id="s", scenario_id=STRAIGHT.scenario_id, route=0, block=0, seed=0, values=values)
