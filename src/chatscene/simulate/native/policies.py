"""Egos that the engine drives by itself: those by rule, and networks."""

from __future__ import annotations

from ctypes import POINTER, c_double, c_float, c_int32
from dataclasses import replace
from functools import lru_cache
from typing import Any, TypeGuard

import numpy as np
from numpy.typing import NDArray

from chatscene.ego.at_speed import softness_of
from chatscene.ego.intelligent_driver import CAR, IntelligentDriver
from chatscene.ego.network import HIDDEN, OUTPUTS, Network, NetworkEgo
from chatscene.ego.observation import ALLOWED, OBSERVATIONS
from chatscene.ego.planner import Planner
from chatscene.ego.policy import EgoPolicy
from chatscene.ego.rule_based import RuleBased
from chatscene.ego.traffic_driver import TrafficDriver
from chatscene.simulate.native.binding import limits_of
from chatscene.simulate.native.engine import Caution, Engine, Foot, Layer, Policy
from chatscene.simulate.native.engine import Limits as LimitsOf
from chatscene.terms.actors import Limits
from chatscene.terms.braking import STANDING, STANDSTILL, Braking

RULE_BASED, INTELLIGENT_DRIVER, NETWORK, PLANNER, TRAFFIC_DRIVER = range(5)  # as engine.c numbers them
_AS_CALLED = (
    *("speed", "crash", "graze", "room", "side", "widening", "berth", "haste", "offset", "astray", "jerk", "resolve"),
    *("agility", "drift", "crossing"),
)  # of the planner's caution, what the engine calls alike
REMEMBERS = 1024  # steps of a drive of which what a network answered is kept for the next
ASKED = 16  # observations on which a network's answers are held against numpy's


def drives(ego: EgoPolicy, engine: Engine) -> bool:
    """Whether the engine drives by itself as an ego does (`policy_of`)."""
    return type(ego) in _BY_RULE or (_is_network(ego) and _agree(ego.network, engine))


def policy_of(ego: EgoPolicy, engine: Engine) -> Policy | None:
    """An ego in the engine's terms; None for one that has to be asked at every step."""
    if (driver := _driver(ego)) is not None:
        return driver
    if _is_network(ego):
        if not _agree(ego.network, engine):
            return None
        shared = network_policy(ego.network)
        policy = Policy.from_buffer_copy(shared)
        policy.every, policy.caution.speed = ego.every, ego.at_most
        policy.kept = [shared]
        return policy
    return None


def _is_network(ego: EgoPolicy) -> TypeGuard[NetworkEgo]:
    """Whether an ego is a network that sees what it was trained with."""
    return type(ego) is NetworkEgo and ego.network.size == OBSERVATIONS.get(ego.observation) and ego.every > 0


_BY_RULE = frozenset((RuleBased, IntelligentDriver, Planner, TrafficDriver))


def _driver(ego: EgoPolicy) -> Policy | None:
    """A driver by rule; exactly these, since who derives from one may do something else."""
    if type(ego) is RuleBased:
        return _by_rule(RULE_BASED, Caution(speed=ego.speed), CAR)
    if type(ego) is IntelligentDriver:
        return _by_rule(INTELLIGENT_DRIVER, Caution(speed=ego.speed), ego.body)
    if type(ego) is Planner:
        return _by_rule(PLANNER, _caution(ego), ego.body, swift=ego.wants is not None)
    if type(ego) is TrafficDriver:
        return _by_rule(TRAFFIC_DRIVER, Caution(speed=ego.speed), ego.body, swift=True, around=ego.all_around)
    return None


def foot_of(braking: Braking, own: float, body: Limits) -> Foot:
    """Somebody's foot on the brake in the engine's terms."""
    return Foot(
        begins=braking.begins,
        over=braking.over,
        own=own,
        full=braking.full,
        ramp=braking.ramp,
        car=limits_of(body),
        standstill=STANDSTILL,
        standing=STANDING,
    )


def _by_rule(kind: int, caution: Caution, body: Limits, *, swift: bool = False, around: bool = True) -> Policy:
    """Somebody who decides at every step, and knows what he drives; the wheel is turned as a car's (`controls`)."""
    car, softness = _handled(body)
    return Policy(kind=kind, every=1, swift=swift, around=around, softness=softness, car=car, caution=caution)


@lru_cache(maxsize=64)
def _handled(body: Limits) -> tuple[LimitsOf, float]:
    """What a driver by rule takes a vehicle to do, whose wheel is a car's, and how softly it is steered."""
    return limits_of(replace(body, wheelbase=CAR.wheelbase, wheel_angle=CAR.wheel_angle)), softness_of(body)


def _caution(ego: Planner) -> Caution:
    told = ego.caution
    numbers = {name: getattr(told, name) for name in _AS_CALLED}
    (braking, braked), (starting, started), (stepping, stepped) = told.braking, told.starting, told.stepping
    caution = Caution(
        braking=braking,
        braked=braked,
        starting=starting,
        started=started,
        stepping=stepping,
        stepped=stepped,
        **numbers,
    )
    caution.discount[:] = ego.discount.tolist()
    return caution


@lru_cache(maxsize=8)
def network_policy(network: Network) -> Policy:
    """A network that is asked at every step."""
    kept: list[Any] = []

    def pointer(array: NDArray[Any], kind: Any) -> Any:
        kept.append(array)
        return array.ctypes.data_as(POINTER(kind))

    layers = (Layer * len(network.layers))()
    for layer, (weights, bias) in zip(layers, network.layers, strict=True):
        layer.outputs, layer.inputs = weights.shape
        layer.columns = pointer(np.ascontiguousarray(weights.T, np.float32), c_float)
        layer.bias = pointer(np.ascontiguousarray(bias, np.float32), c_float)
    widest = max(network.size, *(len(bias) for _, bias in network.layers))
    policy = Policy(
        kind=NETWORK,
        swift=network.size > ALLOWED,
        softness=softness_of(CAR),
        hidden=HIDDEN.index(network.hidden),
        output=OUTPUTS.index(network.output),
        every=1,
        car=limits_of(CAR),
        caution=Caution(speed=network.at_most),
        layers=len(layers),
        layer=layers,
        one=pointer(np.empty(widest, np.float32), c_float),
        other=pointer(np.empty(widest, np.float32), c_float),
        told=pointer(np.empty(widest, np.int32), c_int32),
        remembers=REMEMBERS,
        memory=pointer(np.full((REMEMBERS, network.size + 3), np.nan), c_double),  # nan is like nothing that is seen
    )
    policy.kept = kept
    return policy


@lru_cache(maxsize=8)
def _agree(network: Network, engine: Engine) -> bool:
    """Whether the engine gives a network's answers as numpy does here, to the last bit."""
    policy, draw = network_policy(network), np.random.default_rng(0)
    seen = draw.normal(0.0, 3.0, (ASKED, network.size))
    return all(engine.ask(policy, row.tolist()) == network(row) for row in seen)
