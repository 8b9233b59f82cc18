"""What every ego owes; see `chatscene.ego.policy.EgoPolicy`."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, field

import numpy as np

from chatscene.ego.observation import Observation, RouteView
from chatscene.ego.policy import EgoPolicy, begin, controls, load_ego, observation_of, pedals_of
from chatscene.errors import EgoError
from chatscene.terms.polyline import Polyline
from chatscene.testing.contract import ContractBroken, require

_ROAD = Polyline([(x, 0.0) for x in range(100)])
_POSES = ((0.0, 0.0, 0.0, 0.0), (5.0, -2.0, 0.5, 9.0), (20.0, 0.4, 0.1, 6.0), (50.0, 3.0, -1.0, 15.0))


@dataclass(slots=True)
class _Car:
    """A car on the road, by its pose [m, rad] and speed [m/s]."""

    x: float
    y: float
    heading: float
    speed: float
    half_length: float = 2.4
    half_width: float = 1.0

    def __post_init__(self) -> None:
        self.cos, self.sin = math.cos(self.heading), math.sin(self.heading)

    cos: float = field(init=False)
    sin: float = field(init=False)


def check_ego(ego: str | EgoPolicy) -> None:
    """Hold an ego to the contract of all.

    Args:
        ego: An ego, or its name, file or ``package.module:factory``.

    Raises:
        ContractBroken: It breaks a rule; the message says which.
        EgoError: It cannot be loaded.
    """
    driver = load_ego(ego) if isinstance(ego, str) else ego
    require(callable(getattr(driver, "act", None)), "an ego has a method act(observation)", type(driver).__name__)
    try:
        pedals, _ = pedals_of(driver), observation_of(driver)
    except EgoError as error:
        raise ContractBroken(f"an ego names an observation and pedals that there are; found: {error}") from error
    first = list(_driven(driver))
    for action in first:
        try:
            controls(action, pedals)
        except EgoError as error:
            raise ContractBroken(f"an action is two finite numbers; found: {action!r}") from error
        bounded = all(-1.0 <= float(number) <= 1.0 for number in action)
        require(bounded, "acceleration and steering lie in [-1, 1]", action)
    again = list(_driven(driver))
    same = np.array_equal(np.asarray(first, float), np.asarray(again, float))
    require(same, "the same observations since reset give the same actions", (first, again))


def _driven(ego: EgoPolicy) -> Iterator[tuple[float, float]]:
    """The actions of an episode on an empty road and on one with a car ahead."""
    begin(ego)
    for pose in _POSES:
        for others in ([], [_Car(pose[0] + 12.0, 0.0, 0.0, 2.0)]):
            observation = _seen(observation_of(ego), _Car(*pose), others)
            before = observation.copy()
            yield ego.act(observation)
            require(np.array_equal(before, observation), "an ego leaves what it is shown as it is")


def _seen(preset: str, ego: _Car, others: list[_Car]) -> Observation:
    view = RouteView(_ROAD)
    view.locate(ego.x, ego.y)
    if preset == "safebench":
        return view.four_numbers(ego.x, ego.y, ego.heading, ego.speed, bool(others))
    see = {"actors": view.actors, "road": view.road, "traffic": view.traffic}[preset]
    return see(ego, [(other, False, math.inf) for other in others])
