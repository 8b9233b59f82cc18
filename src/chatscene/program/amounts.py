"""How far and how long something is done that was said with a number: what tracks have of it, for each act."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np
from numpy.typing import NDArray

from chatscene.program.deeds import STANDING, Act, runs
from chatscene.program.watching import Seen
from chatscene.terms.arrays import Array, changes, slopes
from chatscene.terms.seeing import loss_of
from chatscene.terms.vocabulary import GOES_ON, Heads, Tempo, acts_of, by_act
from chatscene.terms.vocabulary import Act as Said

ROLLS = 0.5  # [m/s²] up to which speed is lost by rolling out, or gained by a hill
ENDS = 0.03  # of the way to another lane, at both ends, that nobody sees
NEARLY_THERE = 0.8  # of the way to a side: who drifts or swerves is nearly there
MOST = 0.9  # of what is gained or of the way to a side: it is done with it then
LEFT = 0.1  # [m] from a line: who is farther has left it
COMES_BACK = 0.2  # [m/s] to a side: who comes over so fast comes back
EVEN = 1.0  # [m] by which a gap changes at most that is kept
KEPT = 10  # [steps] for which it is
SWINGS = 0.15  # [m/s] to a side, at which somebody still swings
HALF_LANE = 1.75  # [m] from the ego's line: who is nearer is over the line of its lane

Values = Callable[[Seen, Act], Array]


def losing_run(speed: Array, dt: float) -> tuple[int, int]:
    """The first step and the one after the last of the first time that speed is seen to be lost; 0 and 1 for never."""
    return _first_run(-changes(speed) > ROLLS * dt, speed, 1.0)


def gaining_run(speed: Array, dt: float) -> tuple[int, int]:
    """The same of speed that is gained, up to where most of that is."""
    first, end = _first_run(changes(speed) > 0.2 * ROLLS * dt, speed, -1.0)
    there = speed[first] + MOST * (speed[end] - speed[first])
    return first, first + max(1, int(np.argmax(speed[first : end + 1] >= there)))


def _first_run(condition: NDArray[np.bool_], speed: Array, sign: float) -> tuple[int, int]:
    least = min(loss_of(max(float(speed.max()), 1.0)), 1.0)
    seen = (run for run in runs(condition) if sign * (speed[run[0]] - speed[run[1]]) >= least)
    return next(seen, (0, 1))


def _speed(seen: Seen, once: Act) -> Array:
    return np.abs(seen.track.speed[once.began :])


def _loses_for(seen: Seen, once: Act) -> Array:
    first, end = losing_run(_speed(seen, once), seen.dt)
    return np.array([(end - first) * seen.dt])


def _gains_for(seen: Seen, once: Act) -> Array:
    first, end = gaining_run(_speed(seen, once), seen.dt)
    return np.array([(end - first) * seen.dt])


def _stops_in(seen: Seen, once: Act) -> Array:
    """The way from where it begins to brake to where it stands."""
    speed = np.abs(seen.track.speed)
    still = np.flatnonzero(speed[once.began :] < STANDING)
    end = once.began + int(still[0]) if still.size else len(speed) - 1
    first = end
    while first > 0 and speed[first - 1] - speed[first] > ROLLS * seen.dt:
        first -= 1
    return np.array([speed[first:end].sum() * seen.dt])


def _goes_over_for(seen: Seen, once: Act) -> Array:
    """From when it leaves the line that it was on to when it is all but on the other."""
    first, last = _run_aside(seen, once)
    over = _over(seen, first, last)
    return np.array([(int(np.argmax(over > 1.0 - ENDS)) - int(np.argmax(over > ENDS))) * seen.dt])


def settled(seen: Seen, once: Act) -> int:
    """The step at which somebody who comes over to another lane is all but on its line."""
    first, last = _run_aside(seen, once)
    over = _over(seen, first, last)
    return first + int(np.argmax(over > 1.0 - ENDS))


def ends_aside(seen: Seen, once: Act) -> int:
    """The step at which the way to a side ends of which a deed is a part; 0 of one that is under way."""
    if once.done is None or once.done <= once.began:
        return once.done or 0
    return max(once.done, _run_aside(seen, once)[1])


def _run_aside(seen: Seen, once: Act) -> tuple[int, int]:
    """The first and the last step of the way to a side of which a deed is a part."""
    drift, at = seen.aside, once.done if once.done is not None else len(seen.aside) - 1
    rate = slopes(drift) / seen.dt
    most = once.began + int(np.argmax(np.abs(rate[once.began : at + 1])))
    sign = np.sign(rate[most]) or 1.0
    first = last = most
    while first > 0 and sign * rate[first] > SWINGS / 2:
        first -= 1
    while last < len(drift) - 1 and sign * rate[last] > SWINGS:
        last += 1
    return first, last


def _over(seen: Seen, first: int, last: int) -> Array:
    """How much of its way to a side, beside the ego's lane wherever that bends, somebody has behind it."""
    whole = float(seen.aside[last] - seen.aside[first]) or 1.0
    return (seen.aside[first : last + 1] - seen.aside[first]) / whole


def _goes_aside_for(seen: Seen, once: Act) -> Array:
    """From when it leaves its line to when it is nearly as far from that as it gets, or to when it goes back."""
    since = max(once.began - KEPT, 0)
    aside = np.abs(seen.drift[since:] - seen.drift[since])
    left = int(np.argmax(aside > LEFT)) if (aside > LEFT).any() else 0
    there = aside > NEARLY_THERE * aside.max()
    first, last = int(np.argmax(there)), len(aside) - 1 - int(np.argmax(there[::-1]))
    return np.array([max(first, left) - left, max(last, left) - left]) * seen.dt


def _backs_for(seen: Seen, once: Act) -> Array:
    back = seen.track.speed[once.began :] < -STANDING
    return np.array([back.sum() * seen.dt])


def _is_ahead_by(seen: Seen, once: Act) -> Array:
    """The room that it has before whom it passed when it comes back, or while it is ahead if it does not."""
    room = np.abs(seen.lead) - 0.5 * (seen.ego.length + seen.track.length)
    ahead = seen.lead > 0.0
    done = once.done or 0
    back = np.flatnonzero(ahead[done:] & (slopes(np.abs(seen.offset))[done:] < -COMES_BACK * seen.dt))
    return room[done + int(back[0]) :][:KEPT] if back.size else room[done:]


def _keeps_behind(seen: Seen, once: Act) -> Array:
    """The rooms between the two that are kept for a while."""
    room = np.abs(seen.lead[once.began :]) - 0.5 * (seen.ego.length + seen.track.length)
    if len(room) <= KEPT:
        return room
    windows = np.lib.stride_tricks.sliding_window_view(room, KEPT)
    even = windows.mean(axis=1)[np.ptp(windows, axis=1) < EVEN]
    return even if even.size else room[-1:]


def _swings_for(seen: Seen, once: Act) -> Array:
    rate = np.abs(slopes(seen.drift)) / seen.dt
    swings = np.flatnonzero(rate[max(once.began - KEPT, 0) :] > SWINGS)
    if not swings.size:
        return np.zeros(1)
    crosses = np.flatnonzero(np.diff(np.sign(seen.drift[: max(once.began - KEPT, 0) + int(swings[-1])])) != 0)
    back = int(crosses[-1]) - max(once.began - KEPT, 0) if crosses.size else int(swings[-1])
    ends = np.array([swings[-1], back, 0.5 * (swings[-1] + back)])  # with the way back to its line, or without
    return (ends - swings[0]) * seen.dt


def over_the_line(seen: Seen, once: Act) -> int:
    """The step at which the middle of somebody who comes in crosses the line of the ego's lane."""
    before = np.flatnonzero(np.abs(seen.offset[: (once.done or 0) + 1]) > HALF_LANE)
    return int(before[-1]) + 1 if before.size else once.began


FAR: Mapping[Said, tuple[Values, str]] = by_act(
    {
        Tempo.HALTS: (_stops_in, "stops within"),
        Heads.BY: (_is_ahead_by, "is ahead by"),
        Heads.BEHIND: (_keeps_behind, "keeps behind by"),
        Heads.CLOSE: (_keeps_behind, "keeps behind by"),
    }
)
"""How far, of acts of which the distance has no other test: what is seen, and how that is told."""
LONG: Mapping[Said, tuple[Values, str]] = by_act(
    {
        Tempo.SLOWS: (_loses_for, "loses speed for"),
        Tempo.BRAKES: (_loses_for, "loses speed for"),
        Tempo.GAINS: (_gains_for, "gains speed for"),
        Tempo.BACKS: (_backs_for, "backs up for"),
        Heads.OVER: (_goes_over_for, "takes"),
        Heads.OUT: (_goes_over_for, "takes"),
        Heads.DRIFTS: (_goes_aside_for, "takes"),
        Heads.ASIDE: (_goes_aside_for, "takes"),
        Heads.SWINGS: (_swings_for, "swings for"),
    }
)
"""The same of how long."""
LASTS = GOES_ON | acts_of(Heads.CLOSE, Heads.LEVEL)
"""What is done until something else begins, so that it is seen only how long it was done at least."""
