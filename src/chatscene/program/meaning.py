"""Does an episode show what was said? Judged from the simulated tracks alone, never from the text of a program.

The last rung of the validation ladder. Each slot of a sentence has one test here; thresholds are those at which a
person watching the replay would say "yes, it does that".
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from functools import lru_cache

import numpy as np

from chatscene.program.deeds import ACTIONS, HALT, MOVING, STANDING
from chatscene.program.watching import Seen, headings, in_frame, moved_over, watch
from chatscene.situations.phrases import ROADS, one_seen
from chatscene.terms.actors import Manner, manner_of
from chatscene.terms.acts import Action
from chatscene.terms.arrays import Array
from chatscene.terms.conclusions import LANE_CHANGES
from chatscene.terms.episode import OTHER, Episode, Role, Track
from chatscene.terms.route import Route
from chatscene.terms.scenario import WAITING, EgoState, Maneuver, Occluder, Place, Position, Side, Site, Slots, includes
from chatscene.terms.vocabulary import RoadKind

IN_LANE = 1.75  # [m] from the ego's line
TOGETHER = 1.0  # [s]; acts that begin within this time begin together, to a watcher
AT_FIRST = 1.0  # [s]; who stands for so long before it sets off stood
DRIVING = 3.0  # [m/s]; who has been faster was driving, and can slow down
CRAWLING = 4.0  # [m/s]; who is never as fast, but moves, crawls
SLOWED = 1.5  # [m/s]
TOLD_BY_SITE = (Site.MOTORWAY, Site.ROUNDABOUT, Site.ON_RAMP, Site.OFF_RAMP, Site.WEAVING, Site.LANE_DROP)
TOGETHER_WITHIN = 4.4  # [m] beyond the length of one: so near are those who stand or go together
BRAKED = 4.0  # [m/s²] for so many steps as for a halt

OCCLUDER_CLASSES: dict[Occluder, tuple[str, ...]] = {
    Occluder.BUS_STOP: ("BusStop",),
    Occluder.VENDING_MACHINE: ("VendingMachine",),
    Occluder.PARKED_CAR: ("Car",),
    Occluder.PARKED_TRUCK: ("Truck",),
    Occluder.PARKED_BUS: ("Bus",),
    Occluder.HEDGE: ("Hedge",),
    Occluder.BILLBOARD: ("Billboard",),
    Occluder.KIOSK: ("Kiosk",),
    Occluder.CONTAINER: ("Container",),
}


def check_meaning(slots: Slots, episode: Episode, route: Route, *, through: bool = False) -> tuple[str, ...]:
    """What an episode does not show of what was said.

    It is judged up to the first contact of the ego, which excuses only what was under way: an act that had not begun
    by then was no part of the test. Acts must begin in the order in which they were said, except for what the
    adversary does all along (`all_along` in `chatscene.terms.acts`).

    Args:
        slots: What was said; what is not filled is not checked.
        episode: What happened.
        route: The ego's route.
        through: Judge to the end a drive that went on through a collision: not what the ego was tested with, but what
            the adversary can do.

    Returns:
        One sentence per failure; empty if the episode means what was said.
    """
    failures = list(_route_failures(slots, route))
    if not slots.said():
        return tuple(failures)  # nothing was said that a drive could fail to show
    if not episode.adversaries:
        return (*failures, "adversary: there is none")
    contact = episode.collision.step if episode.collision and not through else None
    seen = watch(episode, route, episode.adversaries[0], contact)
    failures += _ego_failures(slots, seen)
    failures += _start_failures(slots, seen, episode, route)
    failures += _action_failures(slots.actions, seen, contact)
    for said in slots.others:
        failures += _other_failures(said, episode, route, contact)
    return tuple(failures)


def _other_failures(said: Slots, episode: Episode, route: Route, contact: int | None) -> list[str]:
    """What a road user beside the adversary does not show."""
    tracks = [track for track in episode.tracks if track.actor == OTHER]
    if not tracks:
        return [f"other: there is no {said.adversary} beside the adversary"]
    seen = watch(episode, route, tracks[0], contact)
    failures = [*_start_failures(said, seen, episode, route), *_action_failures(said.actions, seen, contact)]
    return [f"other: {failure.replace('adversary', str(said.adversary))}" for failure in failures]


# What the adversary does


def _action_failures(actions: Sequence[Action], seen: Seen, contact: int | None) -> list[str]:
    failures: list[str] = []
    before, latest = None, 0
    for action in actions:
        acts = ACTIONS[action](seen)
        began = [act.began for act in acts if (act.done is not None if contact is None else act.began < contact)]
        if not began:
            never = "never does" if contact is None else "had not begun to when the ego crashed"
            failures.append(f"action: said {action}, but the adversary {never}")
        elif not action.row.all_along:
            after = [step for step in began if step >= latest - TOGETHER / seen.dt]
            if after:
                before, latest = action, max(latest, min(after))
            else:
                failures.append(f"action: said {before}, then {action}, but the adversary does it the other way round")
    return failures


# The ego's route


_SWINGS = math.radians(3.0)
"""How far who leaves its lane turns at least from a line that bends evenly: a road that bends less leads straight."""
_LEAVES = (*LANE_CHANGES, Maneuver.BYPASS)
"""Routes that were found to leave their lane: the more road they do it on, the less they turn."""


@lru_cache(maxsize=256)
def maneuver_of(route: Route) -> Maneuver:
    """What a route does, from its shape; at ramps and roundabouts what it was found for, which no shape tells."""
    if route.site in TOLD_BY_SITE:
        return route.maneuver
    heading = headings(route.line)
    turned = float(heading[-1] - heading[0])
    if route.junction is not None and abs(across := _turned_across(route, turned)) > math.radians(45):
        return Maneuver.LEFT_TURN if across > 0 else Maneuver.RIGHT_TURN
    even = heading[0] + turned * np.linspace(0.0, 1.0, len(heading))
    swings = route.maneuver in _LEAVES or np.abs(heading - even).max() > _SWINGS  # a fast ego changes lanes slantingly
    along = route.place is not Place.CURVE or route.site is Site.PAST_BEND
    if route.junction is None and along and swings:
        over = moved_over(route)
        if over.max() > 1.5 and abs(over[-1]) < 1.0:
            return Maneuver.BYPASS
        if abs(over[-1]) > 1.5:
            return Maneuver.LANE_CHANGE_LEFT if over[-1] > 0 else Maneuver.LANE_CHANGE_RIGHT
    return Maneuver.STRAIGHT


def _turned_across(route: Route, turned: float) -> float:
    """How far a route turns at its junction [rad, positive = left]: the road may bend before and after it.

    Args:
        route: One with a junction.
        turned: How far it turns from its beginning to its end, which counts where nobody asked where its junction
            ends, and for one that was found for a turn and turns behind the junction, as on a slip road.
    """
    if route.exit_at is None:
        return turned
    into, out = (float(route.line.heading_at(at)) for at in (route.event_at, route.exit_at))
    across = math.remainder(out - into, math.tau)
    late = route.maneuver in (Maneuver.LEFT_TURN, Maneuver.RIGHT_TURN) and abs(across) < math.radians(45)
    return turned if late else across


def _route_failures(slots: Slots, route: Route) -> list[str]:
    failures: list[str] = []
    if slots.maneuver is not None and (does := maneuver_of(route)) != slots.maneuver:
        failures.append(f"ego: said {slots.maneuver}, its route goes {does}")
    if slots.control is not None and slots.control != route.control:
        failures.append(f"control: said {slots.control}, the junction has {route.control}")
    if slots.site is not None and slots.site is not route.site:
        failures.append(f"site: said {slots.site}, the route was found for {route.site or 'none'}")
    if slots.place is not None and not is_place(slots.place, route):
        failures.append(f"place: said {slots.place}, the route lies {ROADS[RoadKind(route.place)]}")
    return failures


def is_place(said: Place, route: Route) -> bool:
    """Whether a route lies in such a place."""
    if route.place is Place.CURVE and said in (Place.LEFT_CURVE, Place.RIGHT_CURVE):
        heading = headings(route.line)
        return (said is Place.LEFT_CURVE) == bool(heading[-1] > heading[0])
    return includes(said, route.place)


# What the ego does at the pedals


def _ego_failures(slots: Slots, seen: Seen) -> list[str]:
    if slots.ego is None or EGO_STATES[slots.ego](seen.ego.speed, seen.dt):
        return []
    return [f"pedals: said {slots.ego}, but the ego drives at {_course(seen.ego.speed)}"]


def _course(speed: Array) -> str:
    first, most, last = float(speed[0]), float(speed.max()), float(speed[-1])
    return f"{first:.1f} m/s at first, {most:.1f} at most and {last:.1f} in the end"


def _sets_off(speed: Array, dt: float) -> bool:
    stood = round(AT_FIRST / dt)
    return bool(speed[:stood].max() < STANDING and speed[stood:].max(initial=0.0) > MOVING)


def _slows_down(speed: Array, dt: float) -> bool:  # noqa: ARG001 - as all of them
    fastest = np.maximum.accumulate(speed)
    return bool(((fastest > DRIVING) & (fastest - speed > SLOWED)).any())


def _brakes(speed: Array, dt: float) -> bool:
    return bool((speed[:-HALT] - speed[HALT:] > BRAKED * HALT * dt).any())


def _stops(speed: Array, dt: float) -> bool:
    """It stands after it has driven, or is about to: where it is hit before it stands it has lost half its speed."""
    halves = float(speed[-1]) < 0.5 * float(speed.max())
    return _slows_down(speed, dt) and (halves or bool((speed[np.argmax(speed) :] < STANDING).any()))


EGO_STATES: dict[EgoState, Callable[[Array, float], bool]] = {
    EgoState.STANDS: lambda speed, _: bool(speed.max() < STANDING),
    EgoState.SETS_OFF: _sets_off,
    EgoState.SLOW: lambda speed, _: MOVING < float(speed.max()) < CRAWLING,
    EgoState.SLOWS_DOWN: _slows_down,
    EgoState.BRAKES: _brakes,
    EgoState.STOPS: _stops,
}
"""Whether the ego's speed [m/s] over time shows what was said of it, by steps [s]."""


# The adversary's start and what stands about


def _start_failures(slots: Slots, seen: Seen, episode: Episode, route: Route) -> list[str]:
    failures: list[str] = []
    track = seen.track
    if slots.adversary is not None and track.kind != slots.adversary.row.scenic:
        failures.append(f"adversary: said {slots.adversary}, it is {one_seen(track.kind)}")
    if slots.side is not None:
        left = left_of_ego(seen, route)
        if (left > 0) != (slots.side is Side.LEFT):
            failures.append(f"side: said {slots.side}, it starts {abs(left):.1f} m to the {_side(left)}")
    if slots.position is not None and not POSITIONS[slots.position](seen):
        failures.append(
            f"position: said {slots.position}, it starts {seen.along[0]:.1f} m ahead, "
            f"{abs(seen.across[0]):.1f} m {_side(seen.across[0])}, heading {math.degrees(seen.bearing[0]):.0f}°"
        )
    if slots.occluder is not None and not _hidden(OCCLUDER_CLASSES[slots.occluder], seen, episode):
        failures.append(f"occluder: no {slots.occluder} hides the adversary from the ego")
    if slots.leader and not any(_leads(track, episode.ego_track, route) for track in _others(episode, Role.BACKGROUND)):
        failures.append("leader: no slow vehicle leads the ego")
    if slots.blocker and not any(_blocks(track, route) for track in _others(episode, Role.OCCLUDER)):
        failures.append("blocker: nothing is parked in the ego's lane")
    failures += _distance_failures(slots, seen)
    if slots.group and not any(_accompanies(other, track) for other in episode.adversaries[1:]):
        failures.append("group: the adversary is alone")
    return failures


def _distance_failures(slots: Slots, seen: Seen) -> list[str]:
    if slots.distance is None:
        return []
    least, most = slots.distance.bounds(slots.position)
    away = _away(seen, waits=slots.position in WAITING)
    if any(least <= metres <= most for metres in away):
        return []
    return [f"distance: said {slots.distance}, it is {', then '.join(f'{metres:.0f}' for metres in away)} m away"]


def _away(seen: Seen, *, waits: bool) -> tuple[float, ...]:
    """How far [m] from the ego the adversary starts; where it waits, also when it sets out and comes into the lane.

    Who says that somebody stepped out just ahead speaks of the moment of the step.
    """
    apart = np.hypot(seen.track.x - seen.ego.x, seen.track.y - seen.ego.y)
    moments = [0]
    if waits and seen.track.speed[0] < STANDING:
        inside = (np.abs(seen.offset) < IN_LANE) & (seen.lead > 0.0)
        moments += [int(np.argmax(event)) for event in (seen.track.speed > STANDING, inside) if event.any()]
    return tuple(float(apart[moment]) for moment in moments)


def left_of_ego(seen: Seen, route: Route) -> float:
    """How far to the left [m] the adversary starts: of the ego's start, or of the route it stands beside.

    Somebody at the kerb who faces the road comes from that side of the road, also where the road has turned.
    """
    if route.junction is None and abs(seen.offset[0]) < abs(seen.aside[0]):  # the ego's way leads past it
        return float(seen.aside[0])
    if route.junction is None:
        return float(seen.offset[0])
    along, _, _ = route.line.project(float(seen.track.x[0]), float(seen.track.y[0]))
    faces_road = abs(math.sin(float(seen.track.heading[0]) - route.line.heading_at(along))) > math.sin(math.radians(45))
    return float(seen.offset[0] if faces_road and abs(seen.offset[0]) < 20.0 else seen.across[0])


def _side(left: float) -> str:
    return "left" if left > 0 else "right"


def _others(episode: Episode, role: Role) -> list[Track]:
    return [track for track in episode.tracks if track.role is role]


def _hidden(classes: tuple[str, ...], seen: Seen, episode: Episode) -> bool:
    """Whether a thing of the class stands in the line of sight at some time before the adversary is in the road."""
    things = [track for track in _others(episode, Role.OCCLUDER) if track.kind in classes]
    moved = np.hypot(seen.track.x - seen.track.x[0], seen.track.y - seen.track.y[0])
    steps = np.flatnonzero(moved < 1.0)[::3]
    return any(in_between(thing, seen.ego, seen.track, int(step)) for thing in things for step in steps)


def in_between(thing: Track, ego: Track, adversary: Track, step: int) -> bool:
    """Whether the segment from ego to adversary meets the thing's box (slab test in the thing's frame)."""
    now = min(step, len(thing.x) - 1)
    x0, y0, heading = float(thing.x[now]), float(thing.y[now]), float(thing.heading[now])
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


def _leads(track: Track, ego: Track, route: Route) -> bool:
    """Whether a slow vehicle is ahead of the ego at first: in its lane, or on its way round a bend."""
    along, across = in_frame(track, ego.x[0], ego.y[0], ego.heading[0])
    there, aside, _ = route.line.project(float(track.x[0]), float(track.y[0]))
    ahead = (along[0] > 3.0 and abs(across[0]) < 2.0) or (there > 3.0 and abs(aside) < 2.0)
    return bool(ahead and track.speed.max() < 7.0)


def _blocks(track: Track, route: Route) -> bool:
    x0, y0 = route.line.point_at(0.0)
    along, across = in_frame(track, x0, y0, route.line.heading_at(0.0))
    return bool(along[0] > 3.0 and abs(across[0]) < 1.5 and manner_of(track.kind) is Manner.DRIVES)


def _accompanies(other: Track, track: Track) -> bool:
    apart = math.hypot(other.x[0] - track.x[0], other.y[0] - track.y[0])
    return other.kind == track.kind and apart < TOGETHER_WITHIN + track.length


POSITIONS: dict[Position, Callable[[Seen], bool]] = {
    Position.AHEAD: lambda s: s.along[0] > 2.0 and min(abs(s.offset[0]), abs(s.aside[0])) < 1.8,
    Position.ROADSIDE: lambda s: s.along[0] > 0.0 and abs(s.offset[0]) > 1.6,
    Position.BESIDE: lambda s: abs(s.along[0]) < 8.0 and 2.0 < abs(s.across[0]) < 6.0,
    Position.AHEAD_BESIDE: lambda s: s.along[0] > 1.0 and 2.0 < abs(s.across[0]) < 6.0 and abs(s.bearing[0]) < 1.0,
    Position.BEHIND: lambda s: s.along[0] < -2.0 and abs(s.across[0]) < 2.0,
    Position.BEHIND_BESIDE: lambda s: s.along[0] < -1.0 and 2.0 < abs(s.across[0]) < 6.0,
    Position.ONCOMING: lambda s: s.along[0] > 2.0 and abs(s.facing[0]) > math.radians(130),
    Position.CROSSING: lambda s: s.along[0] > 2.0 and math.radians(40) < abs(s.bearing[0]) < math.radians(140),
    Position.FAR_CORNER: lambda s: s.along[0] > 5.0 and abs(s.offset[0]) > 1.6,
    Position.KERB: lambda s: s.along[0] > 0.0 and 1.6 < abs(s.offset[0]) < 6.0 and abs(s.track.speed[0]) < STANDING,
    Position.BEYOND: lambda s: s.beyond[0] > 0.0 and abs(s.offset[0]) < 1.8,
}
