"""Every number that the measures of a drive take from its tracks, by one call of the engine.

`chatscene.measure.sums_in_numpy` finds the same numbers where there is no engine.
"""

from __future__ import annotations

import math
from collections import OrderedDict
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from chatscene.simulate.boxes import CRAWL, FINENESS
from chatscene.simulate.native.engine import Engine, Habits
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
BLOCK = 16  # drives that are summed up in one call, at most, and of which the numbers are kept


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


@dataclass(frozen=True, slots=True, eq=False)
class Drives:
    """A block of drives as arrays of scenes, road users and steps, padded to the most of each.

    Their steps are as long in all.

    Attributes:
        episodes: The drives.
        about: (scenes, 5) how many steps and road users each has, the step of the ego's first collision and the number
            of whom it collides with, -1 without one, and in how many rows at the end one stands who waits.
        states: (scenes, road users, 4, steps) x [m], y [m], heading [rad] and speed [m/s], the ego's first.
        who: (scenes, road users, 4) half the length and width [m], 1 for an adversary, and by what rolling slows it
            [m/s²]; not a number of who has no wheels.
        aside: (scenes, steps) how far the ego is from its route [m].
    """

    episodes: tuple[Episode, ...]
    about: NDArray[np.int64]
    states: Array
    who: Array
    aside: Array

    @staticmethod
    def of(episodes: Sequence[Episode]) -> Drives:
        """Some drives, one at least, of one simulator."""
        about = np.array([_about(episode) for episode in episodes], np.int64)
        scenes, (longest, actors) = len(episodes), about[:, :2].max(axis=0).tolist()
        states, who, aside = (np.zeros((scenes, *of)) for of in ((actors, 4, longest), (actors, 4), (longest,)))
        for number, episode in enumerate(episodes):
            steps, tracks = len(episode.distance_to_route), episode.tracks
            aside[number, :steps] = episode.distance_to_route
            who[number, : len(tracks)] = [_who(track) for track in tracks]
            for row, track in zip(states[number], tracks, strict=False):
                row[0, :steps], row[1, :steps], row[2, :steps], row[3, :steps] = (
                    track.x,
                    track.y,
                    track.heading,
                    track.speed,
                )
        return Drives(tuple(episodes), about, states, who, aside)


def _about(episode: Episode) -> tuple[int, int, int, int, int]:
    """What `Drives` has about a drive."""
    tracks, crash = episode.tracks, episode.collision
    rows = rows_standing(episode.dt, over=episode.ending is Ending.OVER)
    if crash is None:
        return len(tracks[0].x), len(tracks), -1, -1, rows
    struck = next((i for i, track in enumerate(tracks) if track.actor == crash.other), -1)
    return len(tracks[0].x), len(tracks), crash.step, struck, rows


_found: OrderedDict[Episode, Sums] = OrderedDict()


def sums(episode: Episode) -> Sums:
    """The numbers of a drive, a block of one if it is of none that was summed up (`sum_up`)."""
    if (known := _found.get(episode)) is None:
        sum_up((episode,))
        known = _found[episode]
    return known


def sum_up(episodes: Sequence[Episode]) -> None:
    """Find the numbers of a block of drives, so that `sums` has them: of a block as large, and of some before."""
    if not episodes:
        return
    if (native := engine()) is None:
        from chatscene.measure.sums_in_numpy import sums_in_numpy

        found = [sums_in_numpy(episode) for episode in episodes]
    else:
        found = _sums(Drives.of(episodes), native)
    _found.update(zip(episodes, found, strict=True))
    while len(_found) > max(BLOCK, len(episodes)):
        _found.popitem(last=False)


def _sums(drives: Drives, native: Engine) -> list[Sums]:
    """The numbers of each drive of a block."""
    habits = _habits(drives.episodes[0].dt)
    told, every, paces, least = native.sum_up(
        drives.about, drives.states, drives.who, drives.aside, habits, parts=FINENESS
    )
    rows = zip(
        drives.episodes, drives.about.tolist(), told.tolist(), every.tolist(), paces, least.tolist(), strict=True
    )
    return [_one(*row) for row in rows]


def _one(
    episode: Episode,
    about: list[int],
    told: list[list[float]],
    every: list[float],
    paces: Array,
    least: list[float],
) -> Sums:
    """The numbers of a drive of a block, of its rows of what the engine found."""
    tracks = episode.tracks
    near, nearest, soon, soonest, braked, braked_at, steered, steered_at, meets, begins, *fast = every
    others = [number for number, track in enumerate(tracks) if track.role is Role.ADVERSARY]
    pace, turned, turned_by = np.add.reduce(paces[:, : about[0] - 1], axis=1).tolist()
    return Sums(
        pairs=[tuple(told[number][:5]) for number in others],
        parted=[] if about[3] in others else [least[number] for number in others],
        tyres=tuple((row[5], row[6] > 0.0) for row, track in zip(told, tracks, strict=False) if on_wheels(track.kind)),
        apart=(near, int(nearest)),
        seconds=(soon, int(soonest)),
        braked=(braked, int(braked_at)),
        steered=(steered, int(steered_at)),
        meets=tracks[int(meets)] if meets >= 0 else None,
        begins=int(begins),
        fast=tuple(fast[:6]),
        paces=pace,
        turned=(turned, turned_by),
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
def _habits(dt: float) -> Habits:
    """What is looked for in drives with such a step [s], in the engine's terms."""
    return Habits(
        lately=round(LATELY / dt),
        over=steps_in(OVER, dt),
        within=steps_in(WITHIN, dt),
        pause=round(PAUSE / dt),
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
