"""How fast who was in a drive, and how hard the two met: from the tracks alone; `docs/metrics.md` defines each."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from chatscene.measure.criticality import line_of_contact, part_struck
from chatscene.measure.severity import Found, Hurt, curves_for
from chatscene.simulate.boxes import gaps
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
    return min(others, key=lambda other: float(gaps(episode.ego_track, other).min())) if others else None


def speeds(episode: Episode) -> Speeds:
    """How fast the ego and whom it meets were, and how hard they met."""
    ego, other, crash, dt = episode.ego_track, whom_it_meets(episode), episode.collision, episode.dt
    mine = np.abs(ego.speed)
    if other is None:
        return Speeds(
            ego_kind=ego.kind,
            ego_speed_before=float(mine.max()),
            ego_speed_most=float(mine.max()),
            ego_braking_most=_hardest(mine, dt),
        )
    nearest = max(crash.step - 1, 0) if crash is not None else int(gaps(ego, other).argmin())
    mine, theirs = mine[: nearest + 1], np.abs(other.speed[: nearest + 1])
    turned = float(other.heading[nearest] - ego.heading[nearest])
    begins = _begins(mine, theirs, dt, same_way=math.cos(turned) > SAME_WAY)
    return Speeds(
        ego_kind=ego.kind,
        other_kind=other.kind,
        encounter_time=round(begins * dt, 6),
        ego_speed_before=float(mine[begins]),
        other_speed_before=float(theirs[begins]),
        ego_speed_most=float(mine.max()),
        other_speed_most=float(theirs.max()),
        ego_braking_most=_hardest(mine, dt),
        other_braking_most=_hardest(theirs, dt),
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
    return abs(float(changes(speed).min(initial=0.0))) / dt


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


def _closing_speed(ego: Track, other: Track, crash: Event) -> float:
    """How much of the impact speed is along the line of contact [m/s]."""
    step, before = crash.step, max(crash.step - 1, 0)
    ways = [
        np.array((math.cos(track.heading[step]), math.sin(track.heading[step]))) * float(track.speed[before])
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
