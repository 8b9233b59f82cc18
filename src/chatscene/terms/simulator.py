"""What a simulator says of itself."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True, kw_only=True)
class SimulatorIdentity:
    """What a simulator is, as `run.json` keeps it.

    Attributes:
        name: Its name in the table of simulators.
        version: Version of what its numbers depend on.
        physics: How it moves bodies, in a few words.
        exact: Whether the same scene gives the same episode bit for bit, or only within a tolerance.
        confinable: Whether it can run behind the sandbox's walls: in one process, without files and sockets.
        at_once: Whether bodies answer to pedals and wheel at once, as if there were no tyres.
        brake_lag: How long the brake of a car takes to build up [s], as the time constant of a first-order lag.
        occlusion: Whether bodies hide others from the ego (`chatscene.terms.sight`).
    """

    name: str
    version: str
    physics: str
    exact: bool
    confinable: bool
    at_once: bool = False
    brake_lag: float = 0.0
    occlusion: bool = True
