"""What an adversary does: one test on the tracks for every action, at which a person who watches would say yes."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chatscene.program.watching import Seen, in_frame
from chatscene.simulate.embedded.roadside import crossing_step
from chatscene.terms.episode import Array
from chatscene.terms.scenario import Action

STANDING = 0.3  # [m/s]
MOVING = 0.6  # [m/s]
SLOW = {"Pedestrian": 1.45}  # [m/s]; of others 4
FAST = {"Pedestrian": 3.0, "Bicycle": 6.5}  # [m/s]; of vehicles 11
TURNED = math.radians(45)
TURNED_MIDWAY = math.radians(25)  # of a vehicle that ends up standing in its turn


def _first(condition: NDArray[Any]) -> int | None:
    found = np.flatnonzero(condition)
    return int(found[0]) if found.size else None


def _lasting(condition: NDArray[Any], steps: int) -> NDArray[Any]:
    """Where a condition has held for `steps` in a row, ending there."""
    if len(condition) < steps:
        return np.zeros(len(condition), bool)
    held = np.convolve(condition.astype(int), np.ones(steps, int))[: len(condition)]
    return held == steps


def _speed(s: Seen) -> Array:
    return np.abs(s.track.speed)


def _crosses(s: Seen) -> bool:
    # Whoever reaches the line behind the ego's back crosses nobody's way.
    before = s.lead > -s.ego.length / 2
    return abs(s.offset[0]) > 1.4 and bool((before & (np.abs(s.offset) < 1.3)).any())


def _stops(s: Seen) -> bool:
    start = _first(_speed(s) > MOVING)
    return start is not None and bool(_lasting(_speed(s)[start:] < STANDING, 4).any())


def _brakes(s: Seen) -> bool:
    return bool(_lasting(np.diff(_speed(s), prepend=_speed(s)[:1]) / s.dt < -1.8, 3).any())


def _accelerates(s: Seen) -> bool:
    speed = _speed(s)
    window = min(30, len(speed) - 1)
    return window > 0 and float((speed[window:] - speed[:-window]).max()) >= 2.0


def _slow(s: Seen) -> bool:
    moving = _speed(s)[_speed(s) > 0.2]
    return moving.size > 0 and float(np.percentile(moving, 25)) < SLOW.get(s.track.kind, 4.0)


def _fast(s: Seen) -> bool:
    return float(np.percentile(_speed(s), 90)) >= FAST.get(s.track.kind, 11.0)


def _overtakes(s: Seen) -> bool:
    return float(s.lead[0]) < 2.0 and float(s.lead.max()) > s.ego.length / 2 + s.track.length / 2


def _tailgates(s: Seen) -> bool:
    between = -s.lead - (s.ego.length + s.track.length) / 2
    close = (s.lead < 0.0) & (between < 8.0) & (np.abs(s.offset) < 1.3) & (s.ego.speed > 1.0) & (_speed(s) > 1.0)
    return bool(_lasting(close, 15).any())


def _pulls_out(s: Seen) -> bool:
    beside = _speed(s)[0] < STANDING and abs(s.offset[0]) > 1.6
    return beside and bool(((np.abs(s.offset) < 1.3) & (s.lead > -s.ego.length / 2)).any())


def _wrong_way(s: Seen) -> bool:
    against = (np.abs(s.facing) > math.radians(120)) & (np.abs(s.offset) < 1.5) & (s.lead > 0.0)
    return bool(_lasting(against & (_speed(s) > MOVING), 8).any())


def _blocks_way(s: Seen) -> bool:
    stands = (np.abs(s.offset) < 1.3 + s.track.width / 2) & (_speed(s) < STANDING)
    start = _first(stands & (s.lead > 0.0))  # once there, an ego that drives through it was in its way as well
    return start is not None and bool(_lasting(stands[start:], 10).any())


def _cuts_in(s: Seen) -> bool:
    return abs(s.across[0]) > 1.9 and float(np.abs(s.across).min()) < 1.3


def _weaves(s: Seen) -> bool:
    lateral = s.drift
    turning = np.flatnonzero(np.diff(np.sign(np.diff(lateral))) != 0) + 1
    peaks = lateral[turning]
    return int((np.abs(np.diff(peaks)) > 0.5).sum()) >= 2


def _swerves(s: Seen) -> bool:
    rate = np.abs(s.track.yaw_rate(s.dt))
    return float(np.abs(s.drift).max()) > 0.8 and float(rate.max()) > 0.12


def _paces(s: Seen) -> bool:
    ego_along, _ = in_frame(s.ego, s.ego.x[0], s.ego.y[0], s.ego.heading[0])
    level = (np.abs(ego_along - s.along) < 8.0) & (s.ego.speed > 1.0) & (_speed(s) > 1.0)
    return bool(_lasting(level, 15).any())


def _runs_light(s: Seen) -> bool:
    return any(
        (step := crossing_step(s.track, signal)) is not None and signal.state[step] == "r"
        for signal in s.signals
        if signal.role != "ego"
    )


def _turns(s: Seen, sign: int) -> bool:
    """Whether it turns left (`sign` 1) or right (-1); one that stops in its turn need not have finished it."""
    turned = sign * float(s.track.heading[-1] - s.track.heading[0])
    return turned > (TURNED_MIDWAY if _speed(s)[-1] < STANDING else TURNED)


def _hesitates(s: Seen) -> bool:
    start = _first(_speed(s) > MOVING)
    if start is None:
        return False
    pause = _first(_lasting(_speed(s)[start:] < STANDING, 3))
    return pause is not None and bool((_speed(s)[start + pause :] > MOVING).any())


def _diagonal(s: Seen) -> bool:
    moving = _speed(s) > MOVING
    slant = np.abs(np.abs(np.sin(s.track.heading - s.ego.heading[0])))
    return bool(_lasting(moving & (slant > 0.3) & (slant < 0.95), 5).any())


def _turns_back(s: Seen) -> bool:
    inward = np.abs(s.offset[0]) - np.abs(s.offset)
    peak = int(inward.argmax())
    return float(inward[peak]) > 0.5 and float(inward[peak] - inward[peak:].min()) > 0.5


ACTIONS: dict[Action, Callable[[Seen], bool]] = {
    Action.CROSS: _crosses,
    Action.STOP: _stops,
    Action.BRAKE: _brakes,
    Action.ACCELERATE: _accelerates,
    Action.SLOW: _slow,
    Action.REVERSE: lambda s: float(s.track.speed.min()) < -STANDING,
    Action.CUT_IN: _cuts_in,
    Action.CHANGE_LANE: lambda s: float(np.abs(s.drift).max()) > 2.4,
    Action.WEAVE: _weaves,
    Action.SWERVE: _swerves,
    Action.PACE: _paces,
    Action.RUN_LIGHT: _runs_light,
    Action.TURN_LEFT: lambda s: _turns(s, 1),
    Action.TURN_RIGHT: lambda s: _turns(s, -1),
    Action.ONCOMING: lambda s: bool((np.abs(s.facing) > math.radians(120))[_speed(s) > STANDING].any()),
    Action.HESITATE: _hesitates,
    Action.DIAGONAL: _diagonal,
    Action.TURN_BACK: _turns_back,
    Action.OVERTAKE: _overtakes,
    Action.TAILGATE: _tailgates,
    Action.PULL_OUT: _pulls_out,
    Action.WRONG_WAY: _wrong_way,
    Action.U_TURN: lambda s: float(np.abs(s.track.heading - s.track.heading[0]).max()) > math.radians(140),
    Action.BLOCK: _blocks_way,
    Action.FAST: _fast,
    Action.FOLLOW: lambda s: float(np.hypot(np.ptp(s.track.x), np.ptp(s.track.y))) > 5.0,
}
