"""What every ego owes; see `chatscene.ego.policy.EgoPolicy`."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from itertools import product
from typing import Any, cast

import numpy as np

from chatscene.ego.asking import answer, begin, driving, wanting
from chatscene.ego.observation import Observation, RouteView, Seen
from chatscene.ego.policy import EgoPolicy, load_ego, observation_of, pedals_of
from chatscene.errors import EgoError
from chatscene.terms.actors import LIMITS
from chatscene.terms.nouns import with_article
from chatscene.terms.polyline import Polyline
from chatscene.testing.contract import ContractBroken, require

_ROAD = Polyline([(x, 0.0) for x in range(100)])
ROUNDS = 6  # of the poses: some egos fail after a while
WANTED = 8.0  # [m/s] an ego that can be told a speed is told
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


def ego_of(ego: str | EgoPolicy | Callable[[], EgoPolicy]) -> EgoPolicy:
    """An ego from what a test names: its name, file or ``package.module:factory``; a class, a factory, or itself.

    Raises:
        EgoError: There is none of that name, making it fails, or what was made is none.
    """
    if isinstance(ego, str):
        return load_ego(ego)
    made: Any = ego
    if isinstance(ego, type) or (callable(ego) and not hasattr(ego, "act")):
        try:
            made = cast("Any", ego)()
        except (Exception, SystemExit) as error:
            raise EgoError(f"{ego!r} makes no ego: {type(error).__name__}: {error}") from error
    if not callable(getattr(made, "act", None)):
        raise EgoError(f"an ego has a method act(observation), and {with_article(type(made).__name__)} has none")
    return made


def check_ego(ego: str | EgoPolicy | Callable[[], EgoPolicy]) -> None:
    """Hold an ego to the contract of all.

    Args:
        ego: An ego, its class or factory, or its name, file or ``package.module:factory``.

    Raises:
        ContractBroken: It breaks a rule; the message says which.
        EgoError: It cannot be loaded.
    """
    if isinstance(ego, str):
        driver = ego_of(ego)
    else:
        try:
            driver = ego_of(ego)
        except EgoError as error:
            raise ContractBroken(str(error)) from error
    _check(driver)
    for made in (lambda: wanting(driver, WANTED), lambda: driving(driver, LIMITS["Bus"])):
        try:
            other = made()
        except EgoError as error:
            raise ContractBroken(f"what an ego has besides `act` makes an ego; found: {error}") from error
        if other is not driver:
            _check(other)


def _check(ego: EgoPolicy) -> None:
    try:
        pedals_of(ego)
        observation_of(ego)
    except EgoError as error:
        raise ContractBroken(f"an ego names an observation and pedals that there are; found: {error}") from error
    first, again = list(_driven(ego)), list(_driven(ego))
    same = np.array_equal(np.asarray(first), np.asarray(again))
    differ = next(((one, two) for one, two in zip(first, again, strict=True) if one != two), "")
    require(same, "the same observations since reset give the same actions", differ)


def _driven(ego: EgoPolicy) -> Iterator[tuple[float, float]]:
    """The actions of an episode on an empty road and on one with a car ahead."""
    try:
        begin(ego)
    except EgoError as error:
        raise ContractBroken(f"an episode can begin; found: {error}") from error
    for step, (_, pose) in enumerate(product(range(ROUNDS), _POSES)):
        for others in ([], [_Car(pose[0] + 12.0, 0.0, 0.0, 2.0)]):
            observation = _seen(observation_of(ego), _Car(*pose), others)
            before = observation.copy()
            try:
                action = answer(ego, observation, step=2 * step + bool(others), scene="a straight road")
            except EgoError as error:
                raise ContractBroken(f"an action is two finite numbers; found: {error}") from error
            require(np.array_equal(before, observation), "an ego leaves what it is shown as it is")
            bounded = all(-1.0 <= number <= 1.0 for number in action)
            require(bounded, "acceleration and steering lie in [-1, 1]", action)
            yield action


def _seen(preset: str, ego: _Car, others: list[_Car]) -> Observation:
    view = RouteView(_ROAD)
    view.locate(ego.x, ego.y)
    if preset == "safebench":
        return view.four_numbers(ego.x, ego.y, ego.heading, ego.speed, bool(others))
    see = {"actors": view.actors, "road": view.road, "traffic": view.traffic}[preset]
    return see(ego, [Seen(other, False, math.inf) for other in others])
