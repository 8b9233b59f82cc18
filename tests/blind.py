"""An ego that sees its route and nobody."""

from __future__ import annotations

from chatscene.ego.observation import Observation


class Blind:
    """Drives at about 8 m/s and brakes for nobody."""

    def act(self, observation: Observation) -> tuple[float, float]:
        lateral, heading, speed, _ = observation.tolist()
        return 0.5 * (8.0 - speed), 0.35 * lateral + 1.6 * heading
