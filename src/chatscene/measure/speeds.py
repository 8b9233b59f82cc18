"""How fast who was in a drive, and how hard the two met: from the tracks alone; `docs/metrics.md` defines each."""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from chatscene.measure.criticality import part_struck
from chatscene.measure.severity import Found, Hurt, curves_for
from chatscene.simulate.boxes import between, least_gap
from chatscene.simulate.native.lines import engine
from chatscene.simulate.striking import line_of_contact
from chatscene.terms.actors import BY_CLASS, LOOSE
from chatscene.terms.arrays import Array, changes, changes_at
from chatscene.terms.episode import Episode, Event, Track
from chatscene.terms.speeds import Speeds

REACTS = 1.0  # [m/s²] of speed that is lost: more than rolling out
PAUSE = 2.0  # [s] without, after which a braking is another
GAINS = 1.0  # [m/s]
SAME_WAY = math.cos(math.radians(45))
STILL = 0.1  # [m/s]


def whom_it_meets(episode: Episode) -> Track | None:
    """Whom or what the ego collides with first, else the adversary that comes nearest; None where there is neither."""
    if (crash := episode.collision) is not None:
        return next(track for track in episode.tracks if track.actor == crash.other)
    others = episode.adversaries
    return min(others, key=lambda other: least_gap(episode.ego_track, other)) if others else None


def speeds(episode: Episode) -> Speeds:
    """How fast the ego and whom it meets were, and how hard they met."""
    ego, other, crash, dt = episode.ego_track, whom_it_meets(episode), episode.collision, episode.dt
    if other is None:
        mine = np.abs(ego.speed)
        return Speeds(
            ego_kind=ego.kind,
            ego_speed_before=float(mine.max()),
            ego_speed_most=float(mine.max()),
            ego_braking_most=_hardest(mine, dt),
        )
    nearest = max(crash.step - 1, 0) if crash is not None else between(ego, other).nearest
    mine, theirs = ego.speed[: nearest + 1], other.speed[: nearest + 1]
    turned = float(other.heading[nearest] - ego.heading[nearest])
    before = _before(mine, theirs, dt, same_way=math.cos(turned) > SAME_WAY)
    begins, (ego_before, other_before, ego_most, other_most, ego_lost, other_lost) = before
    return Speeds(
        ego_kind=ego.kind,
        other_kind=other.kind,
        encounter_time=round(begins * dt, 6),
        ego_speed_before=ego_before,
        other_speed_before=other_before,
        ego_speed_most=ego_most,
        other_speed_most=other_most,
        ego_braking_most=ego_lost / dt,
        other_braking_most=other_lost / dt,
        **(_impact(episode, other, crash) if crash is not None else {}),
    )


def risks(episode: Episode) -> tuple[list[Found], list[Found]]:
    """The injury-risk curves that hold of the first collision: of the ego, and of whom or what it struck."""
    crash, other = episode.collision, whom_it_meets(episode)
    if crash is None or other is None:
        return [], []
    ego, before = episode.ego_track, max(crash.step - 1, 0)
    closing = _closing_speed(ego, other, crash)
    mine, theirs = _delta_v(ego, other, closing)
    one, two = (
        Hurt(kind=BY_CLASS.get(track.kind), part=part, speed=abs(float(track.speed[before])), delta_v=delta_v)
        for track, part, delta_v in (
            (ego, crash.side, mine),
            (other, part_struck(other, ego, crash), theirs),
        )
    )
    told = {"impact_speed": crash.impact_speed, "closing_speed": closing}
    return list(curves_for(one, two, **told)), list(curves_for(two, one, **told))


def _before(mine: Array, theirs: Array, dt: float, *, same_way: bool) -> tuple[int, tuple[float, ...]]:
    """The step at which an encounter begins (`_begins`), and how fast both were.

    Of the ego and the other in turn: the speed at that step, the most, and the most that is lost over a step [m/s].
    """
    if (native := engine()) is not None:
        return native.braking_begins(mine, theirs, REACTS * dt, STILL, round(PAUSE / dt), GAINS, same_way=same_way)
    mine, theirs = np.abs(mine), np.abs(theirs)
    begins = _begins(mine, theirs, dt, same_way=same_way)
    both = (mine, theirs)
    most = tuple(float(one.max()) for one in both)
    return begins, (float(mine[begins]), float(theirs[begins]), *most, *map(_lost, both))


def _begins(mine: Array, theirs: Array, dt: float, *, same_way: bool) -> int:
    """The step before the first of the last braking, of either, before the nearest moment; that one if neither does.

    What is parted by no more than `PAUSE` is one braking, and so is it of two that go the same way while the ego has
    not become faster again by `GAINS`; who stands after having moved still brakes. Else it had another reason.
    """
    reacts = _brakes(mine, dt) | _brakes(theirs, dt)
    pause = round(PAUSE / dt)
    begins = last = len(mine) - 1
    for step in np.flatnonzero(reacts)[::-1].tolist():
        follows = same_way and float(mine[step : last + 1].max() - mine[step]) < GAINS
        if last - step > pause and not follows:
            break
        begins, last = max(step - 1, 0), step
    return begins


def _brakes(speed: Array, dt: float) -> NDArray[np.bool_]:
    """(T,) Whether somebody loses speed in the step that led to each row, or stands there after having moved."""
    loses = -changes_at(speed) > REACTS * dt
    return loses | ((speed < STILL) & (np.maximum.accumulate(speed) >= STILL))


def _hardest(speed: Array, dt: float) -> float:
    """The hardest loss of speed over a step [m/s²]; 0 of who loses none."""
    return _lost(speed) / dt


def _lost(speed: Array) -> float:
    return abs(float(changes(speed).min(initial=0.0)))


def _impact(episode: Episode, other: Track, crash: Event) -> dict[str, float | None]:
    """What `Speeds` has of a collision, by name."""
    ego, before = episode.ego_track, max(crash.step - 1, 0)
    turned = float(other.heading[crash.step] - ego.heading[crash.step])
    closing = _closing_speed(ego, other, crash)
    mine, theirs = _delta_v(ego, other, closing)
    told: dict[str, float | None] = {
        "ego_speed_at_impact": abs(float(ego.speed[before])),
        "other_speed_at_impact": abs(float(other.speed[before])),
        "closing_speed": closing,
        "impact_angle": math.remainder(turned, 2 * math.pi),
        "ego_delta_v": mine,
        "other_delta_v": theirs,
    }
    for who, of in zip(("ego", "other"), risks(episode), strict=True):
        told |= {f"{who}_{found.curve.outcome.column}": found.risk for found in of}
    return told


@lru_cache(maxsize=2)
def _closing_speed(ego: Track, other: Track, crash: Event) -> float:
    """How much of the impact speed is along the line of contact [m/s]."""
    step, before = crash.step, max(crash.step - 1, 0)
    ways = [
        np.array((math.cos(track.heading[before]), math.sin(track.heading[before]))) * float(track.speed[before])
        for track in (ego, other)
    ]
    return float(np.clip((ways[0] - ways[1]) @ line_of_contact(ego, other, step), 0.0, crash.impact_speed))


def _delta_v(ego: Track, other: Track, closing: float) -> tuple[float | None, float | None]:
    """By how much an impact after which neither closes in on the other changes the velocity of each [m/s].

    What stands beside the road counts as a wall, whose own change is None; what came off somebody weighs nothing.

    Args:
        ego: One.
        other: The other.
        closing: Their relative speed along the line of contact [m/s].
    """
    if ego.kind not in BY_CLASS:
        return None, None
    if other.kind not in BY_CLASS:
        return (0.0, closing) if other.kind in LOOSE else (closing, None)
    mine, theirs = (BY_CLASS[track.kind].row.mass for track in (ego, other))
    return closing * theirs / (mine + theirs), closing * mine / (mine + theirs)
