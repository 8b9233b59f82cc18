"""What drivers by rule share at the speed of traffic: how far they see, where others go, how pedals and wheel answer.

All of it is of the preset ``traffic``. Angles are Python's own and sums go in the order in which they are written, so
that `engine.c` gives the same.

Positions of others are those along the route, so that who keeps to a lane beside ours stays beside us in a bend. Where
the route leads beside somebody is told from five points; between the middles of the chords between these the direction
is taken to turn evenly, which is exact in a bend of one radius.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from chatscene.ego.observation import AHEAD, Observation
from chatscene.terms.actors import AIR_DRAG, LIMITS, Limits

CAR = LIMITS["Car"]
SLOWER, GAIN = 4.0, 3.0  # [m/s²], [1/s]: how a driver slows down who is faster than it wants
SWIFTEST = 4.0  # [m/s] below which the wheel is turned as at this speed
CENTRED, STEADIED = 0.5, 5.0  # [s], [1/s]: how soon a driver is where it steers to, and sideways as fast as it wants
SIDEWAYS = 0.6  # of its speed, the most that a driver goes to the side
EVASIVE = 5.0  # [m/s²], across, the most by which a driver goes to the side: less than tyres hold on a dry road
DRIFT = 1.5  # [m/s], the most that a driver goes to the side
PARALLEL = 0.7  # cosine of the angle to the route up to which somebody beyond its sight goes along it
KEEPS = 0.04  # of its speed, sideways, up to which somebody who comes towards us keeps its lane


@dataclass(frozen=True, slots=True)
class Other:
    """Somebody near, in coordinates of the route.

    Attributes:
        along: Ahead of the ego [m], from middle to middle.
        beside: Left of the route [m].
        ds: Speed along the route [m/s].
        db: Speed to its left [m/s].
        half_along: Half its extent along the route [m].
        half_beside: Half its extent across it [m].
    """

    along: float
    beside: float
    ds: float
    db: float
    half_along: float
    half_beside: float
    walks: bool


def bends(seen: Observation, k: float) -> tuple[list[float], list[float]]:
    """Where the route leads [rad, in the ego's frame]: how far ahead [m], and the direction there."""
    leads = -float(seen[2])
    offset = float(seen[1])
    x, y = offset * math.sin(leads), -offset * math.cos(leads)  # of the route beside the ego
    before, middles, bearings = 0.0, [0.0], [leads]
    for i, ahead in enumerate(AHEAD):
        px, py = float(seen[4 + 2 * i]), float(seen[5 + 2 * i])
        turn = math.remainder(math.atan2(py - y, px - x) - bearings[-1], 2.0 * math.pi)
        middles.append(0.5 * (before + ahead * k))
        bearings.append(bearings[-1] + turn)
        x, y, before = px, py, ahead * k
    return middles, bearings


def bearing_at(along: float, middles: list[float], bearings: list[float]) -> float:
    """Where the route leads [rad] so far ahead [m]: it turns evenly from middle to middle, and on beyond the last."""
    if along <= 0.0:
        return bearings[0]
    i = min(sum(middle <= along for middle in middles), len(middles) - 1)
    turning = (bearings[i] - bearings[i - 1]) / (middles[i] - middles[i - 1])
    return bearings[i - 1] + turning * (along - middles[i - 1])


def other(row: list[float], k: float, middles: list[float], bearings: list[float]) -> Other:
    """Somebody of an observation, in coordinates of the route."""
    _, along, beside, _, _, vx, vy, turned, half_length, half_width, walks = row
    way = bearing_at(min(along, AHEAD[-1] * k), middles, bearings)
    c, s = math.cos(way), math.sin(way)
    ds, db = vx * c + vy * s, vy * c - vx * s
    c, s = abs(math.cos(turned - way)), abs(math.sin(turned - way))
    if along > AHEAD[-1] * k and c > PARALLEL:  # the route is not seen so far; it keeps along it
        ds, db, c, s = math.copysign(math.hypot(ds, db), ds), 0.0, 1.0, 0.0
    if ds < -2.0 * abs(db):
        db = math.copysign(max(abs(db) + KEEPS * ds, 0.0), db)
    half_along, half_beside = half_length * c + half_width * s, half_length * s + half_width * c
    return Other(along, beside, ds, db, half_along, half_beside, walks > 0.0)


def slower(speed: float, wish: float) -> float:
    """Acceleration [m/s²] by which a driver comes down to the speed that it wants, or up to it [m/s]."""
    return max(GAIN * (wish - speed), -SLOWER)


def able(speed: float, body: Limits) -> float:
    """The acceleration [m/s²] that the whole throttle gives at a speed [m/s]; none if it does not even keep that."""
    return max(body.throttle * (1.0 - speed / body.top_speed) - body.drag - AIR_DRAG * speed * speed, 0.0)


def pressed(acceleration: float, speed: float, body: Limits) -> float:
    """The pedal in [-1, 1] for an acceleration [m/s²] at a speed: a driver knows what its vehicle needs to go on.

    Args:
        acceleration: What is wanted.
        speed: [m/s].
        body: What the vehicle can do.
    """
    force = acceleration + body.drag + AIR_DRAG * speed * speed
    if force > 0.0:
        return min(force / max(body.throttle * (1.0 - speed / body.top_speed), 0.1), 1.0)
    return max(force / body.brake, -1.0)


def steered(seen: Observation, aside: float, softness: float) -> float:
    """Steering in [-1, 1] along the route, or along beside it.

    The route's own curvature is that of the arc to the nearest point seen of it. How far the ego is from where it is to
    be gives how fast it goes to the side, and that its acceleration across, which is bounded by `EVASIVE`.

    Args:
        seen: The preset ``traffic``.
        aside: How far to the left of the route the ego is to be [m].
        softness: Of `softness_of`, of what is driven.
    """
    speed, offset, leads = float(seen[0]), float(seen[1]), -float(seen[2])
    v = max(speed, SWIFTEST)
    x, y = float(seen[4]) - offset * math.sin(leads), float(seen[5]) + offset * math.cos(leads)
    left = y * math.cos(leads) - x * math.sin(leads)
    bend = 2.0 * left / max(x * x + y * y, 1.0)
    soft = 1.0 + softness * v * v
    most, able = min(DRIFT, SIDEWAYS * v), EVASIVE / soft
    sideways = max(-most, min(most, (aside - offset) / (CENTRED * (0.5 + 0.5 * soft))))
    across = max(-able, min(able, STEADIED * (sideways + v * math.sin(leads))))
    wheel = math.atan(CAR.wheelbase * (soft * (bend + across / (v * v))))
    return max(-1.0, min(1.0, -wheel / CAR.wheel_angle / 0.3))


def softness_of(body: Limits) -> float:
    """By how much more [s²/m²] the wheel is turned at speed: half of what understeer takes, which not all physics have.

    So that the ego is steered about as well where the wheel loses its gain with the speed and where it does not.
    """
    return 0.5 / (body.characteristic_speed * body.characteristic_speed)
