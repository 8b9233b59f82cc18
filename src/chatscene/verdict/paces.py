"""How somebody's speed rises and falls, in words: what is gentle and what is hard are two."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from chatscene.measure.severity import in_kmh
from chatscene.program.deeds import BRAKES, BRAKING, STANDING, braking, runs
from chatscene.program.watching import Seen
from chatscene.terms.arrays import Array
from chatscene.terms.vocabulary import Act
from chatscene.verdict.told import Told

LEVEL = 0.2  # [m/s] from where a speed was or comes to, within which it does not change yet, or any more
CHANGED = 1.0  # [m/s] by which a speed rises or falls at least, to be told
PAUSE = 1.0  # [s] without, after which a hard braking is another, or the speed that is lost in it is told

Steps = tuple[int, int]


def paces(who: str, seen: Seen) -> Iterator[Told]:
    """Each rise and fall of somebody's speed, by what it is, with its speeds and how hard it is at most."""
    speed, hard = np.abs(seen.track.speed), braking(seen)
    for first, last in _legs(speed):
        if speed[last] > speed[first]:
            act = Act.SET_OFF if speed[first] < STANDING else Act.ACCELERATE
            yield _pace(who, act, seen, speed, (first, last))
        else:
            for act, steps in _falls(speed, hard, (first, last), round(PAUSE / seen.dt)):
                yield _pace(who, act, seen, speed, steps)


def _pace(who: str, act: Act, seen: Seen, speed: Array, steps: Steps) -> Told:
    first, last = steps
    way = 1.0 if speed[last] > speed[first] else -1.0
    hardest = float((way * np.diff(speed[first : last + 1])).max()) / seen.dt
    ends = " and stops" if speed[last] < STANDING else ""
    fast = f"from {in_kmh(float(speed[first]))} to {in_kmh(float(speed[last]))}{ends}"
    begins, done = _without_level(speed, steps)
    dab = " for a moment" if act is Act.SLOW_DOWN and hardest > BRAKING else ""  # too short for a hard braking
    what = f"{act.meaning} ({act}), {fast}, at up to {hardest:.1f} m/s²{dab}"
    return Told(at=begins * seen.dt, until=done * seen.dt, who=who, what=what)


def _legs(speed: Array) -> Iterator[Steps]:
    """The first and the last step of each rise and fall of a speed; shivers are none."""
    turns, way, least, most = [0], 0, 0, 0
    for step in range(1, len(speed)):
        least = step if speed[step] < speed[least] else least
        most = step if speed[step] > speed[most] else most
        rises = way <= 0 and speed[step] - speed[least] >= CHANGED
        falls = way >= 0 and speed[most] - speed[step] >= CHANGED
        if rises or falls:
            turns.append(least if rises else most)
            way, least, most = 1 if rises else -1, step, step
    turns.append(most if way > 0 else least)
    yield from ((a, b) for a, b in pairwise(turns) if b > a and abs(speed[b] - speed[a]) >= CHANGED)


def _falls(speed: Array, hard: NDArray[np.bool_], leg: Steps, pause: int) -> Iterator[tuple[Act, Steps]]:
    """The gentle and the hard parts of a fall of speed in which enough is lost to be told."""
    at, last = leg
    parts = _hard(speed, hard, leg, pause)
    for number, (first, end) in enumerate(parts):
        if speed[at] - speed[first] >= CHANGED:
            yield Act.SLOW_DOWN, (at, first)
        rest = speed[end] - speed[last] < CHANGED and (last - end <= pause or speed[last] < STANDING)
        at = last if rest and number == len(parts) - 1 else end
        yield Act.BRAKE, (first, at)
    if speed[at] - speed[last] >= CHANGED or not parts:
        yield Act.SLOW_DOWN, (at, last)


def _hard(speed: Array, hard: NDArray[np.bool_], leg: Steps, pause: int) -> list[Steps]:
    """The parts of a fall of speed in which it is lost hard, as those are joined that little parts."""
    first, last = leg
    found = list[Steps]()
    for begin, end in runs(hard[first + 1 : last + 1]):  # what leads to each row
        if end - begin < min(BRAKES, last - first):
            continue
        part = first + begin, first + end
        joins = found and part[0] - found[-1][1] <= pause and speed[found[-1][1]] - speed[part[0]] < CHANGED
        found[-1:] = [(found[-1][0], part[1])] if joins else [*found[-1:], part]
    return found


def _without_level(speed: Array, steps: Steps) -> Steps:
    """Some steps without those at either end in which the speed does not change yet, or any more."""
    first, last = steps
    there = speed[first : last + 1]
    begins = int(np.argmax(np.abs(there - there[0]) >= LEVEL)) - 1
    return first + max(begins, 0), first + int(np.argmax(np.abs(there - there[-1]) < LEVEL))
