"""Does an episode show what was said? Judged from the simulated tracks alone, never from the text of a program.

The last rung of the validation ladder. Each slot of a sentence has one test here; thresholds are those at which a
person watching the replay would say "yes, it does that".
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chatscene.program.assemble import CLASSES
from chatscene.simulate.embedded.roadside import crossing_step
from chatscene.terms.episode import Array, Ending, Episode, Role, SignalTrack, Track
from chatscene.terms.polyline import Polyline
from chatscene.terms.route import Route
from chatscene.terms.scenario import Action, Maneuver, Occluder, Place, Position, Side, Slots

OCCLUDER_CLASSES: dict[Occluder, tuple[str, ...]] = {
    Occluder.BUS_STOP: ("BusStop",),
    Occluder.VENDING_MACHINE: ("VendingMachine",),
    Occluder.PARKED_CAR: ("Car",),
    Occluder.PARKED_TRUCK: ("Truck", "Bus"),
    Occluder.KIOSK: ("Kiosk",),
    Occluder.CONTAINER: ("Container",),
}

STANDING = 0.3  # [m/s]
MOVING = 0.6  # [m/s]
TURNED = math.radians(45)
TURNED_MIDWAY = math.radians(25)  # of a vehicle that ends up standing in its turn


@dataclass(frozen=True, slots=True)
class Seen:
    """One adversary as a watcher sees it.

    Attributes:
        track: Its track.
        ego: The ego's track.
        along: (T,) [m], position along the ego's start heading, from the ego's start.
        across: (T,) [m], to the left of it.
        offset: (T,) [m], signed lateral offset from the ego's route.
        lead: (T,) [m], how far along the route it is ahead of the ego.
        drift: (T,) [m], to the left of the line on which the adversary itself began.
        acceleration: (T,) [m/s²].
        bearing: (T,) [rad], heading against the ego's start heading, in (-pi, pi].
        dt: Step [s].
        signals: At the junction on the route.
    """

    track: Track
    ego: Track
    along: Array
    across: Array
    offset: Array
    lead: Array
    drift: Array
    acceleration: Array
    bearing: Array
    dt: float
    signals: tuple[SignalTrack, ...]


def watch(episode: Episode, route: Route, track: Track) -> Seen:
    """See one adversary of an episode in the ego's frame."""
    ego = episode.ego_track
    along, across = _frame(track, ego.x[0], ego.y[0], ego.heading[0])
    at, offset = _on_line(route.line, track)
    _, drift = _frame(track, track.x[0], track.y[0], track.heading[0])
    return Seen(
        track=track,
        ego=ego,
        along=along,
        across=across,
        offset=offset,
        lead=at - _on_line(route.line, ego)[0],
        drift=drift,
        acceleration=track.acceleration(episode.dt),
        bearing=(track.heading - ego.heading[0] + math.pi) % (2 * math.pi) - math.pi,
        dt=episode.dt,
        signals=episode.signals,
    )


def _on_line(line: Polyline, track: Track) -> tuple[Array, Array]:
    """(T,) arc length and (T,) signed lateral offset [m] of an actor on a line."""
    found = np.empty((2, len(track.x)))
    near: int | None = None
    for i, (x, y) in enumerate(zip(track.x.tolist(), track.y.tolist(), strict=True)):
        found[0, i], found[1, i], near = line.project(x, y, near)
    return found[0], found[1]


def check_meaning(slots: Slots, episode: Episode, route: Route) -> tuple[str, ...]:
    """What an episode does not show of what was said.

    An action that a collision cut short does not count against the scene; one that contradicts does.

    Args:
        slots: What was said; what is not filled is not checked.
        episode: What happened.
        route: The ego's route.

    Returns:
        One sentence per failure; empty if the episode means what was said.
    """
    failures = list(_route_failures(slots, route))
    if not episode.adversaries:
        return (*failures, "adversary: there is none")
    seen = watch(episode, route, episode.adversaries[0])
    failures += _start_failures(slots, seen, episode, route)
    if episode.ending is not Ending.COLLISION:
        failures += [
            f"action: said {action}, but the adversary never does"
            for action in slots.actions
            if not ACTIONS[action](seen)
        ]
    return tuple(failures)


# The ego's route


def maneuver_of(route: Route) -> Maneuver:
    """What a route does, from its shape alone."""
    step = np.diff(route.line.points, axis=0)
    heading = np.unwrap(np.arctan2(step[:, 1], step[:, 0]))
    turned = float(heading[-1] - heading[0])
    if route.junction is not None and abs(turned) > math.radians(45):
        return Maneuver.LEFT_TURN if turned > 0 else Maneuver.RIGHT_TURN
    if route.junction is None and route.place is not Place.CURVE:
        # How far it moves over to the left of a road that bends evenly from its first to its last direction.
        along = np.hypot(step[:, 0], step[:, 1])
        even = heading[0] + turned * np.cumsum(along) / along.sum()
        over = np.cumsum(np.sin(heading - even) * along)
        if over.max() > 1.5 and abs(over[-1]) < 1.0:
            return Maneuver.BYPASS
        if abs(over[-1]) > 1.5:
            return Maneuver.LANE_CHANGE_LEFT if over[-1] > 0 else Maneuver.LANE_CHANGE_RIGHT
    return Maneuver.STRAIGHT


def _route_failures(slots: Slots, route: Route) -> list[str]:
    failures: list[str] = []
    if slots.maneuver is not None and (does := maneuver_of(route)) != slots.maneuver:
        failures.append(f"ego: said {slots.maneuver}, its route goes {does}")
    if slots.control is not None and slots.control != route.control:
        failures.append(f"control: said {slots.control}, the junction has {route.control}")
    if slots.place is not None and not _is_place(slots.place, route.place):
        failures.append(f"place: said {slots.place}, the route lies on a {route.place}")
    return failures


def _is_place(said: Place, real: Place) -> bool:
    junctions = (Place.THREE_WAY, Place.FOUR_WAY, Place.JUNCTION)
    return said == real or (said is Place.JUNCTION and real in junctions)


# The adversary's start and what stands about


def _start_failures(slots: Slots, seen: Seen, episode: Episode, route: Route) -> list[str]:
    failures: list[str] = []
    track = seen.track
    if slots.adversary is not None and track.kind != CLASSES[slots.adversary]:
        failures.append(f"adversary: said {slots.adversary}, it is a {track.kind}")
    if slots.side is not None:
        left = _left_of_ego(seen, route)
        if (left > 0) != (slots.side is Side.LEFT):
            failures.append(f"side: said {slots.side}, it starts {abs(left):.1f} m to the {_side(left)}")
    if slots.position is not None and not POSITIONS[slots.position](seen):
        failures.append(
            f"position: said {slots.position}, it starts {seen.along[0]:.1f} m ahead, "
            f"{abs(seen.across[0]):.1f} m {_side(seen.across[0])}, heading {math.degrees(seen.bearing[0]):.0f}°"
        )
    if slots.occluder is not None and not _hidden(OCCLUDER_CLASSES[slots.occluder], seen, episode):
        failures.append(f"occluder: no {slots.occluder} hides the adversary from the ego")
    if slots.leader and not any(_leads(track, episode.ego_track) for track in _others(episode, Role.BACKGROUND)):
        failures.append("leader: no slow vehicle leads the ego")
    if slots.blocker and not any(_blocks(track, route) for track in _others(episode, Role.OCCLUDER)):
        failures.append("blocker: nothing is parked in the ego's lane")
    return failures


def _left_of_ego(seen: Seen, route: Route) -> float:
    """How far to the left [m] the adversary starts: of the ego's start, or of the route it stands beside.

    Somebody at the kerb who faces the road comes from that side of the road, also where the road has turned.
    """
    if route.junction is None:
        return float(seen.offset[0])
    along, _, _ = route.line.project(float(seen.track.x[0]), float(seen.track.y[0]))
    faces_road = abs(math.sin(float(seen.track.heading[0]) - route.line.heading_at(along))) > math.sin(math.radians(45))
    return float(seen.offset[0] if faces_road and abs(seen.offset[0]) < 20.0 else seen.across[0])


def _side(left: float) -> str:
    return "left" if left > 0 else "right"


def _others(episode: Episode, role: Role) -> list[Track]:
    return [track for track in episode.tracks if track.role is role]


def _frame(track: Track, x: float, y: float, heading: float) -> tuple[Array, Array]:
    dx, dy = track.x - x, track.y - y
    cos, sin = math.cos(heading), math.sin(heading)
    return dx * cos + dy * sin, dy * cos - dx * sin


def _hidden(classes: tuple[str, ...], seen: Seen, episode: Episode) -> bool:
    """Whether a thing of the class stands in the line of sight at some time before the adversary is in the road."""
    things = [track for track in _others(episode, Role.OCCLUDER) if track.kind in classes]
    moved = np.hypot(seen.track.x - seen.track.x[0], seen.track.y - seen.track.y[0])
    steps = np.flatnonzero(moved < 1.0)[::3]
    return any(_in_between(thing, seen.ego, seen.track, int(step)) for thing in things for step in steps)


def _in_between(thing: Track, ego: Track, adversary: Track, step: int) -> bool:
    """Whether the segment from ego to adversary meets the thing's box (slab test in the thing's frame)."""
    x0, y0, heading = float(thing.x[0]), float(thing.y[0]), float(thing.heading[0])
    cos, sin = math.cos(heading), math.sin(heading)

    def local(track: Track) -> tuple[float, float]:
        dx, dy = float(track.x[step]) - x0, float(track.y[step]) - y0
        return dx * cos + dy * sin, dy * cos - dx * sin

    (ax, ay), (bx, by) = local(ego), local(adversary)
    enter, leave = 0.0, 1.0
    for a, d, half in ((ax, bx - ax, thing.length / 2), (ay, by - ay, thing.width / 2)):
        if abs(d) < 1e-9:
            if abs(a) > half:
                return False
            continue
        first, second = sorted(((-half - a) / d, (half - a) / d))
        enter, leave = max(enter, first), min(leave, second)
    return enter <= leave


def _leads(track: Track, ego: Track) -> bool:
    along, across = _frame(track, ego.x[0], ego.y[0], ego.heading[0])
    return bool(along[0] > 3.0 and abs(across[0]) < 2.0 and track.speed.max() < 7.0)


def _blocks(track: Track, route: Route) -> bool:
    x0, y0 = route.line.point_at(0.0)
    along, across = _frame(track, x0, y0, route.line.heading_at(0.0))
    return bool(along[0] > 3.0 and abs(across[0]) < 1.5 and track.kind in ("Car", "Truck", "Bus"))


POSITIONS: dict[Position, Callable[[Seen], bool]] = {
    Position.AHEAD: lambda s: s.along[0] > 2.0 and abs(s.offset[0]) < 1.8,
    Position.ROADSIDE: lambda s: s.along[0] > 0.0 and abs(s.offset[0]) > 1.6,
    Position.BESIDE: lambda s: abs(s.along[0]) < 8.0 and 2.0 < abs(s.across[0]) < 6.0,
    Position.AHEAD_BESIDE: lambda s: s.along[0] > 1.0 and 2.0 < abs(s.across[0]) < 6.0 and abs(s.bearing[0]) < 1.0,
    Position.BEHIND: lambda s: s.along[0] < -2.0 and abs(s.across[0]) < 2.0,
    Position.BEHIND_BESIDE: lambda s: s.along[0] < -1.0 and 2.0 < abs(s.across[0]) < 6.0,
    Position.ONCOMING: lambda s: s.along[0] > 2.0 and abs(s.bearing[0]) > math.radians(130),
    Position.CROSSING: lambda s: s.along[0] > 2.0 and math.radians(40) < abs(s.bearing[0]) < math.radians(140),
    Position.FAR_CORNER: lambda s: s.along[0] > 5.0 and abs(s.offset[0]) > 1.6,
}


# What the adversary does


def _first(condition: NDArray[Any]) -> int | None:
    found = np.flatnonzero(condition)
    return int(found[0]) if found.size else None


def _lasting(condition: NDArray[Any], steps: int) -> NDArray[Any]:
    """Where a condition has held for `steps` in a row, ending there."""
    if len(condition) < steps:
        return np.zeros(len(condition), bool)
    held = np.convolve(condition.astype(int), np.ones(steps, int))[: len(condition)]
    return held == steps


def _speed(s: Seen) -> Array:
    return np.abs(s.track.speed)


def _crosses(s: Seen) -> bool:
    # Whoever reaches the line behind the ego's back crosses nobody's way.
    before = s.lead > -s.ego.length / 2
    return abs(s.offset[0]) > 1.4 and bool((before & (np.abs(s.offset) < 1.3)).any())


def _stops(s: Seen) -> bool:
    start = _first(_speed(s) > MOVING)
    return start is not None and bool(_lasting(_speed(s)[start:] < STANDING, 4).any())


def _brakes(s: Seen) -> bool:
    return bool(_lasting(np.diff(_speed(s), prepend=_speed(s)[:1]) / s.dt < -1.8, 3).any())


def _accelerates(s: Seen) -> bool:
    speed = _speed(s)
    window = min(30, len(speed) - 1)
    return window > 0 and float((speed[window:] - speed[:-window]).max()) >= 2.0


def _slow(s: Seen) -> bool:
    moving = _speed(s)[_speed(s) > 0.2]
    return moving.size > 0 and float(np.percentile(moving, 25)) < 4.0


def _cuts_in(s: Seen) -> bool:
    return abs(s.across[0]) > 1.9 and float(np.abs(s.across).min()) < 1.3


def _weaves(s: Seen) -> bool:
    lateral = s.drift
    turning = np.flatnonzero(np.diff(np.sign(np.diff(lateral))) != 0) + 1
    peaks = lateral[turning]
    return int((np.abs(np.diff(peaks)) > 0.5).sum()) >= 2


def _swerves(s: Seen) -> bool:
    rate = np.abs(s.track.yaw_rate(s.dt))
    return float(np.abs(s.drift).max()) > 0.8 and float(rate.max()) > 0.12


def _paces(s: Seen) -> bool:
    ego_along, _ = _frame(s.ego, s.ego.x[0], s.ego.y[0], s.ego.heading[0])
    level = (np.abs(ego_along - s.along) < 8.0) & (s.ego.speed > 1.0) & (_speed(s) > 1.0)
    return bool(_lasting(level, 15).any())


def _runs_light(s: Seen) -> bool:
    return any(
        (step := crossing_step(s.track, signal)) is not None and signal.state[step] == "r"
        for signal in s.signals
        if signal.role != "ego"
    )


def _turns(s: Seen, sign: int) -> bool:
    """Whether it turns left (`sign` 1) or right (-1); one that stops in its turn need not have finished it."""
    turned = sign * float(s.track.heading[-1] - s.track.heading[0])
    return turned > (TURNED_MIDWAY if _speed(s)[-1] < STANDING else TURNED)


def _hesitates(s: Seen) -> bool:
    start = _first(_speed(s) > MOVING)
    if start is None:
        return False
    pause = _first(_lasting(_speed(s)[start:] < STANDING, 3))
    return pause is not None and bool((_speed(s)[start + pause :] > MOVING).any())


def _diagonal(s: Seen) -> bool:
    moving = _speed(s) > MOVING
    slant = np.abs(np.abs(np.sin(s.track.heading - s.ego.heading[0])))
    return bool(_lasting(moving & (slant > 0.3) & (slant < 0.95), 5).any())


def _turns_back(s: Seen) -> bool:
    inward = np.abs(s.offset[0]) - np.abs(s.offset)
    peak = int(inward.argmax())
    return float(inward[peak]) > 0.5 and float(inward[peak] - inward[peak:].min()) > 0.5


ACTIONS: dict[Action, Callable[[Seen], bool]] = {
    Action.CROSS: _crosses,
    Action.STOP: _stops,
    Action.BRAKE: _brakes,
    Action.ACCELERATE: _accelerates,
    Action.SLOW: _slow,
    Action.REVERSE: lambda s: float(s.track.speed.min()) < -STANDING,
    Action.CUT_IN: _cuts_in,
    Action.CHANGE_LANE: lambda s: float(np.abs(s.drift).max()) > 2.4,
    Action.WEAVE: _weaves,
    Action.SWERVE: _swerves,
    Action.PACE: _paces,
    Action.RUN_LIGHT: _runs_light,
    Action.TURN_LEFT: lambda s: _turns(s, 1),
    Action.TURN_RIGHT: lambda s: _turns(s, -1),
    Action.ONCOMING: lambda s: bool((np.abs(s.bearing) > math.radians(120))[_speed(s) > STANDING].any()),
    Action.HESITATE: _hesitates,
    Action.DIAGONAL: _diagonal,
    Action.TURN_BACK: _turns_back,
    Action.FOLLOW: lambda s: float(np.hypot(np.ptp(s.track.x), np.ptp(s.track.y))) > 5.0,
}
