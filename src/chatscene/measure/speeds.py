"""How fast who was in a drive, and how hard the two met: from the tracks alone; `docs/metrics.md` defines each."""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np

from chatscene.measure.criticality import part_struck
from chatscene.measure.severity import Found, Hurt, curves_for
from chatscene.measure.sums import lost, sums
from chatscene.simulate.striking import line_of_contact
from chatscene.terms.actors import BY_CLASS, LOOSE
from chatscene.terms.episode import Episode, Event, Track
from chatscene.terms.speeds import Speeds

_MOVED, _SLIDES = 0.1, 1.0  # [m] in two steps; [rad] from where it heads that no wheel leads: who goes so slides


def speeds(episode: Episode, friction_demand: float | None = None) -> Speeds:
    """How fast the ego and whom it meets were, and how hard they met, beside the friction that tyres took."""
    found, ego, dt = sums(episode), episode.ego_track, episode.dt
    if (other := found.meets) is None:
        mine = np.abs(ego.speed)
        return Speeds(
            ego_kind=ego.kind,
            ego_speed_before=float(mine.max()),
            ego_speed_most=float(mine.max()),
            ego_braking_most=lost(mine) / dt,
            friction_demand=friction_demand,
        )
    ego_before, other_before, ego_most, other_most, ego_lost, other_lost = found.fast
    crash = episode.collision
    return Speeds(
        ego_kind=ego.kind,
        other_kind=other.kind,
        encounter_time=round(found.begins * dt, 6),
        ego_speed_before=ego_before,
        other_speed_before=other_before,
        ego_speed_most=ego_most,
        other_speed_most=other_most,
        ego_braking_most=ego_lost / dt,
        other_braking_most=other_lost / dt,
        friction_demand=friction_demand,
        **(_impact(episode, other, crash) if crash is not None else {}),
    )


def risks(episode: Episode) -> tuple[list[Found], list[Found]]:
    """The injury-risk curves that hold of the first collision: of the ego, and of whom or what it struck."""
    crash, other = episode.collision, sums(episode).meets
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
    (mx, my), (tx, ty) = (
        (math.cos(way) * speed, math.sin(way) * speed)
        for way, speed in (_course(track, max(crash.step - 1, 0)) for track in (ego, other))
    )
    x, y = line_of_contact(ego, other, crash.step)
    along = (mx - tx) * x + (my - ty) * y
    return min(along, crash.impact_speed) if along > 0.0 else 0.0


def _course(track: Track, step: int) -> tuple[float, float]:
    """Where somebody goes [rad], and how fast [m/s]."""
    return _goes(track, step), float(track.speed[step])


def _goes(track: Track, step: int) -> float:
    """Where somebody goes [rad]: where it heads, unless it slides aside of that."""
    heading, last = float(track.heading[step]), len(track.x) - 1
    dx, dy = (float(row[min(step + 1, last)] - row[max(step - 1, 0)]) for row in (track.x, track.y))
    way = math.atan2(dy, dx) + (math.pi if track.speed[step] < 0.0 else 0.0)
    aside = math.remainder(way - heading, math.tau)
    return heading + aside if math.hypot(dx, dy) > _MOVED and abs(aside) > _SLIDES else heading


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
