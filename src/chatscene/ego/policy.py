"""Who drives: the one thing an ego must be able to do, and the table of those we know by name."""

from __future__ import annotations

import math
import warnings
from collections.abc import Iterable, Mapping
from pathlib import Path
from textwrap import shorten
from typing import Any, Protocol

from chatscene.ego.observation import IN_WORDS, Observation, check_preset
from chatscene.errors import EgoError
from chatscene.plugins import Kind, make
from chatscene.terms.actors import LIMITS, Limits
from chatscene.terms.scene import CAR

FAR = 1.1  # of an action; what is less beyond [-1, 1] is a network's rounding


class EgoPolicy(Protocol):
    """An ego under test.

    Input: one of the presets of `chatscene.ego.observation`.
    Output: acceleration and steering, each in [-1, 1]; steering is right positive. They are mapped to pedals and
    wheel as SafeBench maps them (see `controls`).
    Determinism: the same observations since the start of an episode give the same actions.

    What it may have besides:
        name: How it is called in tables; its class name if it does not say.
        observation: Which preset it sees; ``safebench`` if it does not say.
        pedals: Which of `PEDALS` its actions go through; ``safebench`` if it does not say.
        reset: Called without arguments before each episode.
        wanting: Called with a speed [m/s], gives an ego that is like it and wants to drive at that; see
            `chatscene.ego.asking`.
        driving: Called with what a kind of vehicle can do, gives an ego that is like it and knows that it drives such
            a one, and no car; see `chatscene.ego.asking`.
    """

    def act(self, observation: Observation) -> tuple[float, float]:
        """Decide for one step of 0.1 s."""
        ...


def name_of(ego: EgoPolicy) -> str:
    """How an ego is called in tables."""
    return str(getattr(ego, "name", type(ego).__name__))


def takes_speed(ego: EgoPolicy) -> bool:
    """Whether an ego can be told at what speed it is to drive."""
    return getattr(ego, "wanting", None) is not None


def knows_body(ego: EgoPolicy) -> bool:
    """Whether an ego can be told what kind of vehicle it drives."""
    return hasattr(ego, "driving")


def is_cut_off(action: Iterable[float]) -> bool:
    """Whether an action lies so far outside [-1, 1] that its ego means something else by it."""
    acceleration, steering = action
    return not (-FAR <= acceleration <= FAR and -FAR <= steering <= FAR)


def tell_cut_off(whose: str, action: Iterable[float]) -> None:
    """Warn of an action that is cut off; once for each ego of a run.

    Args:
        whose: What the message calls the ego.
        action: The first of its actions that is.
    """
    if whose in cut_off:
        return
    cut_off.add(whose)
    acceleration, steering = (f"{float(one):.6g}" for one in action)
    warnings.warn(
        f"{whose} answers with an acceleration of {acceleration} and a steering of {steering}: both lie in "
        "[-1, 1], where 1 is the whole pedal or wheel, and what is beyond is cut off",
        RuntimeWarning,
        stacklevel=2,
    )


cut_off: set[str] = set()
"""Of whom it was told that actions are cut off; a run begins with nobody."""


def observation_of(ego: EgoPolicy) -> str:
    """Which preset an ego sees.

    Raises:
        EgoError: There is no such preset.
    """
    return check_preset(getattr(ego, "observation", "safebench"))


def pedals_of(ego: EgoPolicy) -> str:
    """Which of `PEDALS` an ego's actions go through.

    Raises:
        EgoError: There is no such mapping.
    """
    pedals = getattr(ego, "pedals", "safebench")
    if pedals not in PEDALS:
        raise EgoError(f"the ego {name_of(ego)!r} wants pedals {pedals!r}; known: {', '.join(PEDALS)}")
    return pedals


def senses_of(ego: EgoPolicy, kind: str = CAR, *, occlusion: bool = True) -> dict[str, str]:
    """What an ego sees and brakes with, by the names of the presets, and what it drives if that is no car.

    Args:
        ego: Which; `in_words` says it.
        kind: The class of what it drives.
        occlusion: Whether bodies hide others from it.

    Raises:
        EgoError: There is no such preset, or no such pedals.
    """
    seen = {"observation": observation_of(ego), "pedals": pedals_of(ego)}
    if seen["observation"] != "safebench":
        seen["hidden"] = "unseen" if occlusion else "seen"
    return seen if kind == CAR else seen | {"body": kind}


def in_words(senses: Mapping[str, str]) -> str:
    """What an ego sees and how hard it can brake, to stand beside its collisions wherever these are told."""
    seen, pedals = senses.get("observation"), senses.get("pedals")
    if seen not in IN_WORDS or pedals not in PEDALS:
        return "(what it sees was not recorded)"
    share = PEDALS[pedals]
    brake = LIMITS.get(senses.get("body", CAR), LIMITS[CAR]).brake
    part = "the full brake pedal" if share == 1.0 else f"{share:g} of the pedal"
    hidden = ", not hidden ones" if senses.get("hidden") == "unseen" else ", hidden ones too"
    if seen == "safebench":  # which sees only who is ahead in its lane
        hidden = ""
    return f"{IN_WORDS[seen]}{hidden}; brakes at up to {share * brake:g} m/s² ({part})"


FILES = (".npz", ".zip", ".pt", ".onnx")
"""What an ego may be loaded from: ours, Stable-Baselines3, TorchScript or SafeBench, ONNX."""

EGOS: Kind[EgoPolicy] = Kind(
    noun="ego",
    group="chatscene.egos",
    method="act",
    built_in={
        "rule-based": "chatscene.ego.rule_based:RuleBased",
        "idm": "chatscene.ego.intelligent_driver:IntelligentDriver",
        "planner": "chatscene.ego.planner:Planner",
        "hardened": "chatscene.ego.planner:hardened",
        "sac": "chatscene.ego.trained:sac",
        "ppo": "chatscene.ego.trained:ppo",
        "td3": "chatscene.ego.trained:td3",
    },
    forms=(f"a file ({', '.join(FILES)})",),
    beyond=lambda name: Path(name).suffix in FILES,
    error=EgoError,
)


def load_ego(name: str) -> EgoPolicy:
    """An ego from a file, or by its name (`chatscene.plugins`).

    Raises:
        EgoError: Nothing of that name exists, its code fails, or what the factory makes has no `act`.
        MissingExtra: A package that it needs is missing.
    """
    if Path(name).suffix in FILES:
        from chatscene.ego.files import load_file

        return load_file(Path(name))
    return make(EGOS, name)


PEDALS: dict[str, float] = {"safebench": 0.375, "full-brake": 1.0}
"""How an acceleration becomes pedals, by name, and the hardest brake each can command."""


TURNED = 0.3
"""Of a car's wheel, the most that an ego can command."""
_CAR = LIMITS[CAR]


def controls(action: Any, pedals: str = "safebench", body: Limits = _CAR) -> tuple[float, float, float]:
    """Throttle, brake and steering for an action, as SafeBench maps it.

    Acceleration is three times the first number [m/s²]: throttle = a/3 when positive, else brake = -a/8, so that
    the hardest brake an ego can command is 0.375; ``full-brake`` stretches braking to the whole pedal. Steering is
    0.3 times the second, of a car; any other body turns on the circle on which a car then turns.

    Args:
        action: What an ego answers.
        pedals: Which of `PEDALS` it goes through.
        body: What its vehicle can do.

    Raises:
        EgoError: The action is not two finite numbers.
    """
    acceleration, steering = two_numbers(action)
    acceleration = min(max(acceleration, -1.0), 1.0)
    steer = wheel_of(body, TURNED * min(max(steering, -1.0), 1.0))
    if acceleration > 0.0:
        return acceleration, 0.0, steer
    return 0.0, -acceleration * PEDALS[pedals], steer


def two_numbers(action: Any) -> tuple[float, float]:
    """Acceleration and steering, of whatever an ego answers.

    Raises:
        EgoError: They are not two finite numbers.
    """
    try:
        acceleration, steering = map(_number, action)
    except Exception as error:
        raise EgoError(f"an action is acceleration and steering, two finite numbers, not {_shown(action)}") from error
    if not (math.isfinite(acceleration) and math.isfinite(steering)):
        raise EgoError(f"acceleration and steering must be finite, not {_shown(action)}")
    return acceleration, steering


def _number(one: Any) -> float:
    if isinstance(one, str | bytes):
        raise TypeError(f"{one!r} is a text")
    return float(one)


def _shown(action: Any) -> str:
    """An answer in a line."""
    try:
        return shorten(repr(action), 120, placeholder=" ...")
    except Exception:  # noqa: BLE001 - as above
        return type(action).__name__


def wheel_of(body: Limits, steer: float) -> float:
    """The share of its wheel angle with which a body turns on the circle on which a car turns with another share."""
    if body.wheelbase == _CAR.wheelbase and body.wheel_angle == _CAR.wheel_angle:
        return steer
    turned = math.atan(body.wheelbase * (math.tan(steer * _CAR.wheel_angle) / _CAR.wheelbase)) / body.wheel_angle
    return min(max(turned, -1.0), 1.0)
