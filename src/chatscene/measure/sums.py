"""Every number that the measures of a drive take from its tracks, by one call of the engine.

`chatscene.measure.sums_in_numpy` finds the same numbers where there is no engine.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from chatscene.simulate.boxes import CRAWL, FINENESS
from chatscene.simulate.native.engine import Habits
from chatscene.simulate.native.lines import engine
from chatscene.terms.actors import AIR_DRAG, BY_CLASS, LIMITS
from chatscene.terms.arrays import Array, changes
from chatscene.terms.braking import STANDSTILL
from chatscene.terms.episode import QUIET, Ending, Episode, Role, Track

LATELY = 2.0  # [s] for which who has come before the ego is near, though the ego comes no nearer
AS_NEAR = 0.3  # [m] farther apart than at their nearest, two are as near: what comes of driving level is at its end
OVER = 0.4  # [s] that an ego brakes at least that brakes hard
WITHIN = 1.5  # [s] in which an ego leaves its way that steers clear of somebody
REACTS = 1.0  # [m/s²] of speed that is lost: more than rolling out
PAUSE = 2.0  # [s] without, after which a braking is another
GAINS = 1.0  # [m/s]
SAME_WAY = math.cos(math.radians(45))
STILL = 0.1  # [m/s]
FAST = 50.0 / 3.6  # [m/s]
ACROSS = 4.0  # [m/s²], up to which cars answer to the wheel in proportion (ISO 4138 looks for no more)
BEHIND = 10.0  # [m] of gap within which one waits behind another
STANDING = 0.1  # [m/s]


@dataclass(frozen=True, slots=True)
class Sums:
    """The numbers of a drive.

    Attributes:
        pairs: Of each adversary: the least gap between the boxes [m] and the first step of it, the least time until
            they touch [s], the least headway [s] and the hardest braking [m/s²], as `chatscene.simulate.boxes.between`
            has them.
        tyres: Of everybody on wheels: what tyres did at most [m/s²], and whether too much at speed.
        apart: The least gap to any adversary [m], and the last step that is as near.
        seconds: The least gap in time to any adversary [s], and the first step of it.
        braked: How much speed the ego loses at most within `OVER` [m/s], and the step at which it has.
        steered: How far it leaves its way at most within `WITHIN` [m], and the step at which it has.
        meets: Whom it meets: whom it collides with first, else the first adversary that comes nearest.
        begins: At which step the encounter with that one begins.
        fast: Of the ego and that one in turn: the speed at that step, the most, and the most that is lost over a step
            [m/s].
        paces: The sum of the changes of the ego's velocity [m/s].
        turned: The sum of the changes of its heading [rad], as the reference sees it, and as it is.
        waits: Whether it stands at the end beside or behind somebody who stands as well, and both have for a while.
    """

    pairs: list[tuple[float, ...]]
    parted: list[float]
    tyres: tuple[tuple[float, bool], ...]
    apart: tuple[float, int]
    seconds: tuple[float, int]
    braked: tuple[float, int]
    steered: tuple[float, int]
    meets: Track | None
    begins: int
    fast: tuple[float, ...]
    paces: float
    turned: tuple[float, float]
    waits: bool


@lru_cache(maxsize=1)
def sums(episode: Episode) -> Sums:
    """The numbers of a drive."""
    if (native := engine()) is None:
        from chatscene.measure.sums_in_numpy import sums_in_numpy

        return sums_in_numpy(episode)
    tracks, crash = episode.tracks, episode.collision
    steps = len(tracks[0].x)
    columns = [column for track in tracks for column in (track.x, track.y, track.heading, track.speed)]
    states = np.concatenate(columns).reshape(len(tracks), 4, steps)
    headings = states[:, 2]
    others = [number for number, track in enumerate(tracks) if track.role is Role.ADVERSARY]
    told, every, totals, parted = native.sum_up(
        states,
        np.cos(headings),
        np.sin(headings),
        np.array([_who(track) for track in tracks]),
        episode.distance_to_route,
        _habits(episode.dt, episode.ending is Ending.OVER),
        crash=-1 if crash is None else crash.step,
        struck=-1 if crash is None else next((i for i, track in enumerate(tracks) if track.actor == crash.other), -1),
        others=others,
        parts=FINENESS,
    )
    near, nearest, soon, soonest, braked, braked_at, steered, steered_at, meets, begins, *fast = every
    return Sums(
        pairs=[tuple(told[number][:5]) for number in others],
        parted=parted,
        tyres=tuple((row[5], row[6] > 0.0) for row, track in zip(told, tracks, strict=True) if on_wheels(track.kind)),
        apart=(near, int(nearest)),
        seconds=(soon, int(soonest)),
        braked=(braked, int(braked_at)),
        steered=(steered, int(steered_at)),
        meets=tracks[int(meets)] if meets >= 0 else None,
        begins=int(begins),
        fast=tuple(fast[:6]),
        paces=totals[0],
        turned=(totals[1], totals[2]),
        waits=fast[6] > 0.0,
    )


@lru_cache(maxsize=256)
def on_wheels(kind: str) -> bool:
    """Whether what is of a class is a road user on wheels."""
    return kind in BY_CLASS and LIMITS[kind].wheelbase > 0.0


def _who(track: Track) -> tuple[float, float, float, float]:
    rolls = LIMITS[track.kind].drag if on_wheels(track.kind) else math.nan
    return track.length / 2, track.width / 2, float(track.role is Role.ADVERSARY), rolls


@lru_cache(maxsize=16)
def _habits(dt: float, over: bool) -> Habits:
    """What is looked for, of drives with such a step [s] and ending, in the engine's terms."""
    return Habits(
        lately=round(LATELY / dt),
        over=steps_in(OVER, dt),
        within=steps_in(WITHIN, dt),
        pause=round(PAUSE / dt),
        rows=rows_standing(dt, over=over),
        dt=dt,
        crawl=CRAWL,
        as_near=AS_NEAR,
        reacts=REACTS * dt,
        still=STILL,
        gains=GAINS,
        same_way=SAME_WAY,
        air=AIR_DRAG,
        across=ACROSS,
        fast=FAST,
        standing=STANDING,
        behind=BEHIND,
    )


def steps_in(seconds: float, dt: float) -> int:
    """How many steps a while lasts, one at least, so that something can change in it; both [s]."""
    return max(1, round(seconds / dt))


def rows_standing(dt: float, *, over: bool) -> int:
    """In how many rows at the end one stands who waits; of a drive in which nothing is to come any more, or not."""
    return math.ceil((QUIET if over else STANDSTILL) / dt) + 1


def lost(speed: Array) -> float:
    """The most speed [m/s] that somebody loses over a step; 0 of who loses none."""
    return abs(float(changes(speed).min(initial=0.0)))


def mean(values: Array) -> float:
    """The mean of some numbers, to the bit as numpy's, whose call takes longer than its work."""
    return float(np.add.reduce(values) / len(values))
