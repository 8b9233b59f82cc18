"""What an adversary does: for every action, the times it is done, as a person who watches the tracks would say.

An act begins and is done at a step. Where the track ends first, it is under way if it has gone so far that the watcher
would say what is coming: a third of the time that it lasts, the nose over the stop line, the turn begun.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chatscene.program.watching import Seen, in_frame, percentile
from chatscene.simulate.roadside import crossing_steps
from chatscene.terms.actors import BY_CLASS, AdversaryKind, RoadUser
from chatscene.terms.acts import Action
from chatscene.terms.arrays import Array, changes, changes_at
from chatscene.terms.seeing import GAIN

STANDING = 0.3  # [m/s]
MOVING = 0.6  # [m/s]
BRAKING = 1.8  # [m/s²] from which a watcher says that it brakes …
LOSING = 1.0  # [m/s²] from which it slows, and does not roll out …
OF_GRIP = 0.5  # … or half of what the road holds, where that is less
GAINING = 30  # [steps] within which who accelerates gains `GAIN`
TURNED = math.radians(45)
TURNED_MIDWAY = math.radians(25)  # of a vehicle that ends up standing in its turn
TURNING = math.radians(10)  # by now it is turning
CLOSE = 0.5  # [s] behind somebody, who is fast: much less than the 1 s of a driver who is wide awake
HALT = 4  # [steps] of standing
PAUSE = 3  # [steps]
BRAKES = 3  # [steps] that somebody brakes at least who is seen to
PARTLY = 0.7  # [m] from the middle of a lane: who stands there leaves a part of it free


@dataclass(frozen=True, slots=True)
class Act:
    """One time that an adversary does something.

    Attributes:
        began: The step at which it began.
        done: The step at which a watcher says that it is done; None if it is under way at the last step.
    """

    began: int
    done: int | None


def _first(condition: NDArray[Any]) -> int | None:
    found = condition.nonzero()[0]
    return int(found[0]) if found.size else None


def _last(condition: NDArray[Any]) -> int:
    """The last step at which a condition holds; the first of all if it never does."""
    found = condition.nonzero()[0]
    return int(found[-1]) if found.size else 0


def runs(condition: NDArray[Any]) -> Iterator[tuple[int, int]]:
    """Every time a condition holds: the first step, and the one after the last."""
    padded = np.zeros(len(condition) + 2, bool)
    padded[1:-1] = condition
    edges = (padded[1:] != padded[:-1]).nonzero()[0].tolist()
    yield from zip(edges[::2], edges[1::2], strict=True)


def lasting(condition: NDArray[Any], steps: int) -> Iterator[Act]:
    """Every time a condition holds for `steps` in a row; under way where the track ends after a third of them."""
    for first, end in runs(condition):
        if end - first >= steps:
            yield Act(first, first + steps - 1)
        elif end == len(condition) and 3 * (end - first) >= steps:
            yield Act(first, None)


def _once(condition: NDArray[Any]) -> Iterator[Act]:
    """The first time that a condition holds, which is no sooner begun than done."""
    if (step := _first(condition)) is not None:
        yield Act(step, step)


def _row(s: Seen) -> RoadUser:
    return BY_CLASS.get(s.track.kind, AdversaryKind.CAR).row


def _speed(s: Seen) -> Array:
    return np.abs(s.track.speed)


# Gaining and losing speed


def _slowing_since(s: Seen, step: int) -> int:
    """Since when it has lost speed at every step up to one, and more than by rolling out."""
    losing = changes(_speed(s)[: step + 1]) < -min(LOSING, OF_GRIP * s.grip) * s.dt
    return _last(~losing) + 1 if not losing.all() else 0


def _slowing(s: Seen) -> Iterator[Act]:
    """Under way to be slow or to stand: at the end it has lost a fifth of its speed without a break."""
    speed = _speed(s)
    began = _slowing_since(s, len(speed) - 1)
    if speed[began] > MOVING and speed[-1] <= 0.8 * speed[began]:
        yield Act(began, None)


def _gaining(s: Seen) -> Iterator[Act]:
    """Under way to be fast: at the end it is faster by a quarter of `GAIN` than a moment ago, and no slower since."""
    lately = _speed(s)[-GAINING - 1 :]
    low = _last(lately <= lately.min() + 0.1)
    if lately[-1] - lately[low] >= GAIN / 4 and lately[-1] >= lately[low:].max():
        yield Act(len(s.track.x) - len(lately) + low, None)


def _halts(s: Seen) -> Iterator[tuple[int, int, int]]:
    """Every time it comes to stand: since when it slows, the first step it stands, and the one after the last."""
    speed = _speed(s)
    for first, end in runs(speed < STANDING):
        if (speed[:first] > MOVING).any():
            yield _slowing_since(s, first), first, end


def _stops(s: Seen) -> Iterator[Act]:
    for began, first, end in _halts(s):
        if end - first >= HALT or (end < len(s.track.x) and s.track.speed[end] < 0.0):  # whoever backs has stood
            yield Act(began, min(first + HALT, end) - 1)
        elif end == len(s.track.x):
            yield Act(began, None)
    yield from _slowing(s)


def _hesitates(s: Seen) -> Iterator[Act]:
    for began, first, end in _halts(s):
        again = _first(_speed(s)[end:] > MOVING)
        if again is None:
            yield Act(began, None)
        elif end - first >= PAUSE:
            yield Act(began, end + again)
    yield from _slowing(s)


def braking(s: Seen) -> NDArray[np.bool_]:
    """At which steps a watcher says that somebody brakes."""
    return changes_at(_speed(s)) / s.dt < -min(BRAKING, OF_GRIP * s.grip)


def _brakes(s: Seen) -> Iterator[Act]:
    return lasting(braking(s), BRAKES)


def _accelerates(s: Seen) -> Iterator[Act]:
    speed = _speed(s)
    for first, end in runs(changes_at(speed) > -0.5 * s.dt):
        rising = speed[max(first - 1, 0) : end]
        ahead = np.lib.stride_tricks.sliding_window_view(np.pad(rising, (0, GAINING), mode="edge"), GAINING + 1)
        for low, high in runs(ahead.max(axis=1) - rising >= GAIN):
            least = rising[low:high].min()
            began = low + _last(rising[low:high] <= least + 0.1)
            done = began + int((rising[began:] >= least + GAIN).argmax())
            yield Act(max(first - 1, 0) + began, max(first - 1, 0) + done)
    yield from _gaining(s)


def _slow(s: Seen) -> Iterator[Act]:
    limit, moving = _row(s).slow, _speed(s) > 0.2
    if moving.any() and percentile(_speed(s)[moving], 25) < limit:
        yield from _once(moving & (_speed(s) < limit))
    yield from _slowing(s)


def _fast(s: Seen) -> Iterator[Act]:
    limit = _row(s).fast
    if percentile(_speed(s), 90) >= limit:
        yield from _once(_speed(s) >= limit)
    yield from _gaining(s)


def _reverses(s: Seen) -> Iterator[Act]:
    for first, end in runs(s.track.speed < 0.0):
        back = _first(s.track.speed[first:end] < -STANDING)
        if back is not None or end == len(s.track.x):
            yield Act(max(first - 1, 0), None if back is None else first + back)


# Going aside, in and across


def comes_in(aside: Array, *, outside: float, there: NDArray[Any], dt: float) -> Iterator[Act]:
    """Every time it sets out from beside a line toward it, until it is there; under way once it is 0.3 m nearer."""
    away = np.abs(aside)
    nearer = -changes_at(away) > 0.05 * dt
    for first, _ in runs(nearer):
        began = max(first - 1, 0)
        if away[began] <= outside:
            continue
        if (arrival := _first(there[first:])) is not None:
            yield Act(began, first + arrival)
        elif away[began] - away[-1] > 0.3:
            yield Act(began, None)


def _before_ego(s: Seen) -> NDArray[Any]:
    """Where it is not behind the ego's back: whoever reaches its line there is in nobody's way."""
    return s.lead > -s.ego.length / 2


def _crosses(s: Seen) -> Iterator[Act]:
    return comes_in(s.offset, outside=1.4, there=_before_ego(s) & (np.abs(s.offset) < 1.3), dt=s.dt)


def _pulls_out(s: Seen) -> Iterator[Act]:
    if _speed(s)[0] < STANDING:
        yield from comes_in(s.offset, outside=1.6, there=_before_ego(s) & (np.abs(s.offset) < 1.3), dt=s.dt)


def _cuts_in(s: Seen) -> Iterator[Act]:
    return comes_in(s.across, outside=1.9, there=np.abs(s.across) < 1.3, dt=s.dt)


def _turns_back(s: Seen) -> Iterator[Act]:
    """It comes in by more than half a metre, then goes back as much; whoever goes on to the far side does not."""
    came = (s.offset[0] - s.offset) * np.sign(s.offset[0])
    farthest = np.maximum.accumulate(came)
    back = np.where(farthest > 0.5, farthest - came, 0.0)
    if (done := _first(back > 0.5)) is not None:
        yield Act(int(came[:done].argmax()), done)
    elif back[-1] > 0.1:
        yield Act(int(came.argmax()), None)


def _changes_lane(s: Seen) -> Iterator[Act]:
    away = np.abs(s.drift)
    if (done := _first(away > 2.4)) is not None:
        yield Act(_last(away[:done] < 0.3), done)
    elif away[-1] > 0.5:
        yield Act(_last(away < 0.3), None)


def _weaves(s: Seen) -> Iterator[Act]:
    turning = (np.flatnonzero(np.diff(np.sign(np.diff(s.drift))) != 0) + 1).tolist()
    swings = [(a, b) for a, b in pairwise(turning) if abs(s.drift[b] - s.drift[a]) > 0.5]
    if len(swings) > 1:
        yield Act(swings[0][0], swings[1][1])
    else:
        peaks = [0, *turning, len(s.drift) - 1]
        yield from (Act(a, None) for a, b in pairwise(peaks) if abs(s.drift[b] - s.drift[a]) > 0.5)


def _swerves(s: Seen) -> Iterator[Act]:
    rate = np.abs(s.track.yaw_rate(s.dt))
    for first, end in runs(rate > 0.02):
        sharp, began = _first(rate[first:end] > 0.12), max(first - 1, 0)
        if sharp is None:
            continue
        aside = np.abs(s.drift[began:] - s.drift[began])
        if (done := _first(aside > 0.8)) is not None:
            yield Act(began, max(began + done, first + sharp))
        elif aside[-1] > 0.2:
            yield Act(began, None)


def _diagonal(s: Seen) -> Iterator[Act]:
    slant = np.abs(np.sin(s.track.heading - s.ego.heading[0]))
    return lasting((_speed(s) > MOVING) & (slant > 0.3) & (slant < 0.95), 5)


# Turning


def _turns(s: Seen, sign: int) -> Iterator[Act]:
    """A turn to the left (`sign` 1) or right (-1); one that stops in its turn need not have finished it."""
    turned = sign * (s.track.heading - s.track.heading[0])
    enough = TURNED_MIDWAY if _speed(s)[-1] < STANDING else TURNED
    done = _first(turned > enough) if turned[-1] > enough else None
    if done is not None or turned[-1] > TURNING:
        yield Act(_last(turned[:done] < TURNING / 2), done)


def _turns_round(s: Seen) -> Iterator[Act]:
    turned = np.abs(s.track.heading - s.track.heading[0])
    done = _first(turned > math.radians(140))
    if done is not None or turned[-1] > math.radians(30):
        yield Act(_last(turned[:done] < TURNING / 2), done)


# With the ego and against it


def _overtakes(s: Seen) -> Iterator[Act]:
    if s.lead[0] >= 2.0:
        return
    done = _first(s.lead > (s.ego.length + s.track.length) / 2)
    lowest = _last(s.lead[:done] <= s.lead[:done].min() + 0.1)
    if done is not None or (s.lead[-1] - s.lead[lowest] > 1.0 and abs(s.offset[-1]) > 1.3):
        pulls_out = _first(np.abs(s.drift[:done]) > 0.3)
        yield Act(lowest if pulls_out is None else pulls_out, done)


def before(s: Seen) -> Array:
    """How far [m] before another somebody is, along the ego's way or against it, as it goes."""
    way = s.line.heading_at(float(s.at[0].clip(0.0, s.line.length)))
    return -s.lead if math.cos(float(s.track.heading[0]) - way) < 0.0 else s.lead


def tailgates(s: Seen, within: float = 8.0) -> Iterator[Act]:
    """It keeps close behind the ego: as near as is usual, or as was said [m]."""
    lead = before(s)
    between = -lead - (s.ego.length + s.track.length) / 2
    near = between < np.maximum(within, CLOSE * s.ego.speed)
    close = (lead < 0.0) & near & (np.abs(s.offset) < 1.3) & (s.ego.speed > 1.0) & (_speed(s) > 1.0)
    return lasting(close, 15)


def _paces(s: Seen) -> Iterator[Act]:
    ego_along, _ = in_frame(s.ego, s.ego.x[0], s.ego.y[0], s.ego.heading[0])
    return lasting((np.abs(ego_along - s.along) < 8.0) & (s.ego.speed > 1.0) & (_speed(s) > 1.0), 15)


def _against(s: Seen) -> NDArray[Any]:
    return np.abs(s.facing) > math.radians(120)


def _wrong_way(s: Seen) -> Iterator[Act]:
    return lasting(_against(s) & (np.abs(s.offset) < 1.5) & (s.lead > 0.0) & (_speed(s) > MOVING), 8)


def _blocks_way(s: Seen) -> Iterator[Act]:
    within = np.minimum(np.abs(s.offset), np.abs(s.aside)) < 1.3 + s.track.width / 2
    start = _first(within & (_speed(s) < STANDING) & (s.lead > 0.0))
    if start is not None:  # once there, an ego that drives through it was in its way as well
        stands = within & (_speed(s) < STANDING)
        yield from lasting(stands & (np.arange(len(stands)) >= start), 10)
    if within[-1] and s.lead[-1] > 0.0:
        yield from _slowing(s)


def _runs_light(s: Seen) -> Iterator[Act]:
    ahead, heading = s.track.length / 2, s.track.heading
    nose = replace(s.track, x=s.track.x + ahead * np.cos(heading), y=s.track.y + ahead * np.sin(heading))
    others = [signal for signal in s.signals if signal.role != "ego"]
    for signal, over, done in zip(others, crossing_steps(nose, others), crossing_steps(s.track, others), strict=True):
        if done is not None and signal.state[done] == "r":
            yield Act(done if over is None else over, done)
        elif done is None and over is not None and signal.state[over] == "r":
            yield Act(over, None)


def _follows(s: Seen) -> Iterator[Act]:
    moved = np.hypot(s.track.x - s.track.x[0], s.track.y - s.track.y[0])
    if moved[-1] > 1.0:
        yield Act(_last(moved < 0.1), _first(moved > 5.0))


def _stands(s: Seen) -> Iterator[Act]:
    still = _speed(s) < STANDING
    if still.all():
        yield from lasting(still, 10)


def _narrows(s: Seen) -> Iterator[Act]:
    """It stands, not in the middle of the ego's lane, and yet in the way of somebody who keeps to its middle."""
    aside = np.minimum(np.abs(s.offset), np.abs(s.aside))
    if (aside > PARTLY).all() and (aside - s.track.width / 2 < 1.3).all():
        yield from _stands(s)


ACTIONS: dict[Action, Callable[[Seen], Iterable[Act]]] = {
    Action.CROSS: _crosses,
    Action.STOP: _stops,
    Action.BRAKE: _brakes,
    Action.ACCELERATE: _accelerates,
    Action.SLOW: _slow,
    Action.REVERSE: _reverses,
    Action.CUT_IN: _cuts_in,
    Action.CHANGE_LANE: _changes_lane,
    Action.WEAVE: _weaves,
    Action.SWERVE: _swerves,
    Action.PACE: _paces,
    Action.RUN_LIGHT: _runs_light,
    Action.TURN_LEFT: lambda s: _turns(s, 1),
    Action.TURN_RIGHT: lambda s: _turns(s, -1),
    Action.ONCOMING: lambda s: _once(_against(s) & (_speed(s) > STANDING)),
    Action.HESITATE: _hesitates,
    Action.DIAGONAL: _diagonal,
    Action.TURN_BACK: _turns_back,
    Action.OVERTAKE: _overtakes,
    Action.TAILGATE: tailgates,
    Action.PULL_OUT: _pulls_out,
    Action.WRONG_WAY: _wrong_way,
    Action.U_TURN: _turns_round,
    Action.BLOCK: _blocks_way,
    Action.FAST: _fast,
    Action.FOLLOW: _follows,
    Action.STAND: _stands,
    Action.NARROW: _narrows,
}
