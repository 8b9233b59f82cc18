"""Who struck whom: the one rule for it, by which verdicts, stories, reports and tables tell the same of a collision."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from chatscene.simulate.boxes import KEPT, NOTHING, Boxes
from chatscene.simulate.contact import side_touched
from chatscene.terms.episode import Episode, Event, Role, Track, contact_point

DOOR = "Door"  # the class of what is opened into somebody's way
STILL = 0.05  # [m], who moved less than this until contact never moved
MOVES = 0.6  # [m/s] from which somebody is under way
TURNED_IN = 3.0  # [s] before they touch, in which somebody is seen to turn toward the other …
TURNED = 0.01  # [rad] … by so much at least


@dataclass(frozen=True, slots=True, kw_only=True)
class Strike:
    """Who struck whom.

    Attributes:
        by_ego: Whether the ego struck; else the other did.
        static: Whether the other is a thing, or had not moved.
        foremost: Whether the ego, and whether the other, touches with the end that leads as it moves.
    """

    by_ego: bool
    static: bool
    foremost: tuple[bool, bool]
    moving: bool

    @property
    def each(self) -> bool:
        """Whether each runs into the other, as head-on."""
        return self.moving and all(self.foremost)

    @property
    def runs_in(self) -> bool:
        """Whether one plainly runs into the other: with the end that leads, or into who stands."""
        return not self.moving or self.foremost == (self.by_ego, not self.by_ego)


def strike(episode: Episode) -> Strike | None:
    """Who struck whom in the first collision of a drive; None without one.

    A thing, or who had not moved, is struck. Who is touched in its front half by a door drives into that; else the door
    opens into it. Where two who move touch with neither's leading end, who turned toward the
    other by more in the last seconds struck. Else it is who moved farther toward the other along the line of contact in
    the step that ended in it; if both did alike, it is the ego.
    """
    crash = episode.collision
    if crash is None:
        return None
    ego, other = episode.ego_track, next(track for track in episode.tracks if track.actor == crash.other)
    before = max(crash.step - 1, 0)
    until = slice(0, crash.step + 1)
    moved = np.hypot(other.x[until] - other.x[0], other.y[until] - other.y[0]).max()
    static = other.role is Role.OCCLUDER or bool(moved < STILL)
    speeds = float(ego.speed[before]), float(other.speed[before])
    sides = crash.side, side_touched(other, ego, crash.step, crash.earlier)
    mine, theirs = (side == _leading(speed) for side, speed in zip(sides, speeds, strict=True))
    moving = all(abs(speed) > MOVES for speed in speeds)
    turned = None if mine or theirs or not moving else _ego_came_over(ego, other, crash.step, episode.dt)
    if other.kind == DOOR:
        turned = _at_front(episode, crash)
    by_ego = static or (_ego_closed_more(ego, other, crash.step) if turned is None else turned)
    return Strike(by_ego=by_ego, static=static, foremost=(mine, theirs), moving=moving)


def _at_front(episode: Episode, crash: Event) -> bool:
    """Whether the ego is touched in its front half."""
    x, y = contact_point(episode, crash)
    own_x, own_y, heading = episode.ego_track.pose(crash.step, crash.earlier)
    return (x - own_x) * math.cos(heading) + (y - own_y) * math.sin(heading) > 0.0


def _leading(speed: float) -> str:
    """The side that leads at a speed; empty for somebody who stands."""
    return "" if abs(speed) <= MOVES else "front" if speed > 0.0 else "rear"


def _ego_came_over(ego: Track, other: Track, step: int, dt: float) -> bool | None:
    """Whether the ego turned toward the other by more than the other toward it; None if neither turned toward one."""
    since = max(step - round(TURNED_IN / dt), 0)
    mine, theirs = _turned_toward(ego, other, since, step), _turned_toward(other, ego, since, step)
    return mine > theirs if max(mine, theirs) >= TURNED else None


def _turned_toward(track: Track, other: Track, since: int, step: int) -> float:
    """How far [rad] somebody turned to the side on which another is."""
    heading = float(track.heading[step])
    dx, dy = float(other.x[step] - track.x[step]), float(other.y[step] - track.y[step])
    left = dy * math.cos(heading) - dx * math.sin(heading)
    return math.copysign(1.0, left) * (heading - float(track.heading[since]))


@lru_cache(maxsize=KEPT)
def line_of_contact(ego: Track, other: Track, step: int) -> tuple[float, float]:
    """The normal, from the ego to the other, of the side at which they met in the step before `step`."""
    (mx, my), (tx, ty), before = _moved(ego, step), _moved(other, step), max(step - 1, 0)
    a, b = Boxes.of(ego), Boxes.of(other)
    ac, az, bc, bz, ax, ay, bx, by = (
        float(column[before]) for column in (a.cos, a.sin, b.cos, b.sin, a.x, a.y, b.x, b.y)
    )
    c, s, dx, dy = abs(ac * bc + az * bz), abs(ac * bz - az * bc), bx - ax, by - ay
    axes = (  # as `Pair` has them: a direction, and how near the centres are along it when the boxes touch
        (ac, az, a.half_length + b.half_length * c + b.half_width * s),
        (-az, ac, a.half_width + b.half_length * s + b.half_width * c),
        (bc, bz, b.half_length + a.half_length * c + a.half_width * s),
        (-bz, bc, b.half_width + a.half_length * s + a.half_width * c),
    )
    enters = [_enters(dx * x + dy * y, reach, (tx - mx) * x + (ty - my) * y) for x, y, reach in axes]
    x, y, _ = axes[enters.index(max(enters))]  # on which they were apart for longest
    side = math.copysign(1.0, dx * x + dy * y)
    return x * side, y * side


def _enters(offset: float, reach: float, speed: float) -> float:
    """When two begin to overlap on an axis, as `Pair.overlap` has it."""
    if abs(speed) < NOTHING:
        return -math.inf if abs(offset) <= reach else math.inf
    return min((-reach - offset) / speed, (reach - offset) / speed)


def _ego_closed_more(ego: Track, other: Track, step: int) -> bool:
    """Whether the ego moved at least as far toward the other as the other toward it, in the step before `step`."""
    x, y = line_of_contact(ego, other, step)
    (mx, my), (tx, ty) = _moved(ego, step), _moved(other, step)
    return mx * x + my * y >= -tx * x + -ty * y - NOTHING


def _moved(track: Track, step: int) -> tuple[float, float]:
    before = max(step - 1, 0)
    return float(track.x[step] - track.x[before]), float(track.y[step] - track.y[before])
