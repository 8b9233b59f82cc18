"""Whether two could meet at all: when each is where their ways share a place, if the ego just goes on.

An ego that reacts does not show by its own track whom it could have met. So it is followed from each moment at which it
neither brakes nor gains speed, along its way and at the speed that it then has; the other goes as it went. If it meets
nobody where it went, its route counts in place of its way, since it may have steered round whom it could have met.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from chatscene.program.contacts import is_with
from chatscene.program.deeds import LOSING, MOVING, STANDING
from chatscene.program.doing import GOES_WITH
from chatscene.program.finding import Finding, Late
from chatscene.program.gone_by import behind, past
from chatscene.program.meaning import TOGETHER
from chatscene.simulate.boxes import Boxes, gaps, near_any, overlaps, times_to_collision
from chatscene.simulate.native.lines import follow
from chatscene.terms.arrays import Array, paces, unwrapped
from chatscene.terms.episode import Episode, Track
from chatscene.terms.polyline import Polyline
from chatscene.terms.route import Route
from chatscene.terms.situation import EGO, Other, Situation
from chatscene.terms.vocabulary import (
    LOSES,
    PLAIN,
    SIDES_OF,
    Act,
    EgoRoute,
    Heads,
    Side,
    Striker,
    Tempo,
    Where,
    acts_of,
)

LONGEST = 3.0  # [s] at most between the two at a place, or until two who both drive on would touch
EVERY = 1.0  # [s] after which an ego that goes on evenly is followed anew
BEFORE = 1.5  # [s] at most by which somebody is there before the ego and still meets it: the usual bound of a conflict
NEARLY = 3.0  # [m] between who follows the ego and that, at most, of whom it was said that they nearly touch
NEAR = 1.0  # [m] between two bodies that meet, once somebody has begun with what it does
CLOSES = 0.3  # [m/s] by which somebody comes up to an ego that it is to run into
COMES_TO = 6.0  # [m] from what it is to brush, an ego at least comes that then brakes or steers
BRUSHES = 0.5  # [m] at most beside the ego's way is what it is to brush
BRUSHED = frozenset((Where.KERB, Where.ROADSIDE, Where.MEDIAN, Where.BESIDE))
"""Where what the ego brushes with its side stands."""
BACKS_TO = 2.0  # [m] from the ego at most, who is to back into it
ASIDE = 1.0  # [m] beside its route an ego is that steers round somebody
TO_COME = 150.0  # [m] that somebody may still have to come to where the ways meet at a junction
THROUGH = 30.0  # [m] behind the entry of a junction at which a way has left it
BACK = 80.0  # [m] behind its start that the ego's way is taken to lead straight
LETS_BY = acts_of(Tempo.WAITS, Heads.OUT, Heads.OFF, Heads.EDGE)
"""What is done so that there is no encounter."""
STAYS = acts_of(Tempo.STANDS, Tempo.PAUSES, Tempo.LIES, Heads.BACK)
"""What alone brings nobody into the ego's way who is not in it."""
COMES_NEARER = LOSES | acts_of(Tempo.BACKS)
"""What brings whoever is ahead in the ego's own lane nearer to it; who stands there is so unless it sets off again."""


GOES_BY = PLAIN | acts_of(Tempo.GAINS)
"""What somebody does who comes up beside the ego and goes by."""
CHANGES_TO: dict[EgoRoute | None, Side | None] = {
    EgoRoute.LANE_CHANGE: None,
    EgoRoute.LANE_CHANGE_LEFT: Side.LEFT,
    EgoRoute.LANE_CHANGE_RIGHT: Side.RIGHT,
}
"""To which side an ego changes lanes by its route; None to either."""
FINE = 0.5  # [m] between the places on the ego's way at which it is seen how near that leads past somebody
ALL_BUT, EARLY = 0.05, 0.7  # [s] before the ego at most, who is level with it; by which it is to come later than that

Flags = NDArray[np.bool_]
Way = tuple[Array, Array, Array, Array]


@dataclass(frozen=True, slots=True, kw_only=True)
class Meeting:
    """When two would meet, or nearly.

    Attributes:
        between: From when one leaves a place to when the other comes to it [s]; inf where they share none.
        at: When the other is there [s].
        ego_first: Whether the ego is there first.
    """

    between: float = math.inf
    at: float = math.nan
    ego_first: bool = False


def encounter(
    situation: Situation, one: Other, tracks: Sequence[Track], episode: Episode, route: Route, since: int
) -> Finding | None:
    """Whether the ego could meet an adversary; None where it need not.

    Their ways come together and it does more than stay; or it is said that they touch or nearly do; or it is before the
    ego in its lane, or comes against it there, and does what brings it nearer.

    Args:
        situation: What was said.
        one: The adversary.
        tracks: Its track, or those of several.
        episode: What happened.
        route: The ego's.
        since: The step at which it begins with what it does.
    """
    path, crash, ego = f"encounter.{one.id}", episode.collision, episode.ego_track
    if crash is not None and is_with(crash.other, one.id):
        return Finding(path=path, shown=True, told="they touch", at=crash.step * episode.dt)
    way, later = way_of(ego, route.line), [_goes_on_evenly(track, episode) for track in tracks]
    least = min((meeting(ego, way, track, episode.dt, since) for track in later), key=_between)
    if math.isinf(least.between) and (kept := _not_steered(ego, route.line)) is not None:
        way = way_of(kept, route.line)
        least = min((meeting(kept, way, track, episode.dt, since) for track in later), key=_between)
    passes = _passes_who_stands(one, ego, since) and not _touches(situation, one)
    if passes or not _must_meet(situation, one, ego, way, tracks[0], least, route):
        return None
    meant = _as_said(situation, one, ego, tracks, route) or _otherwise(situation, one, ego, tracks, least, since)
    if meant is not None:
        return replace(meant, path=path, shown=meant.shown or (None if crash is not None else False))
    if least.between <= (TOGETHER if least.ego_first else BEFORE):
        told = f"they could meet: {least.between:.1f} s between one and the other"
        return Finding(path=path, shown=True, told=told, at=least.at)
    gap = min(float(gaps(ego, track)[since:].min()) for track in tracks)
    if (gap <= NEAR and since) or any(_heads_for(ego, track, since) for track in tracks):
        return Finding(path=path, shown=True, told=f"they are as near as {gap:.1f} m")
    when = "after" if least.ego_first else "before"
    told = f"it is where their ways meet {least.between:.1f} s {when} the ego"
    if math.isinf(least.between):
        told = f"it is nowhere within {LONGEST:g} s of the ego"
    told = f"they could not meet: {told}, and never nearer than {gap:.1f} m"
    late = _late(least, ego, tracks[0], since)
    return Finding(path=path, shown=None if crash is not None else False, told=told, late=late)


def _as_said(situation: Situation, one: Other, ego: Track, tracks: Sequence[Track], route: Route) -> Finding | None:
    """Whether two could touch as was said, where that says more than that they meet; None where it does not."""
    if (told := _never_strikes(situation, one, ego, tracks[0])) is not None:
        return Finding(path="", shown=False, told=told)
    return _brushes(situation, one, ego, tracks, route)


def _least(ego: Track, track: Track, steps: int) -> float:
    """The least gap [m] between two in so many steps."""
    return float(gaps(ego, track)[:steps].min())


def _stands_all_along(track: Track, steps: int) -> Track:
    """Who stands where it does at first, for so many steps."""
    ones = np.ones(steps)
    x, y, heading = (value[0] * ones for value in (track.x, track.y, track.heading))
    return replace(track, x=x, y=y, heading=heading, speed=0.0 * ones)


def _never_strikes(situation: Situation, one: Other, ego: Track, track: Track) -> str | None:
    """That somebody in line with the ego who is to run into it never comes up to it, in words; None if it does.

    Who is behind comes up to it if it is faster and would soon touch it; who backs, if it backs near to it.
    """
    contact = situation.contact
    if contact is None or not contact.happens or contact.striker is Striker.EGO:
        return None
    if not _touches(situation, one) or len(track.x) > len(ego.x):
        return None
    acts, steps = {deed.act for deed in one.does}, len(track.x)
    gap = gaps(ego, track)[:steps]
    if one.starts.where is Where.BEHIND and acts <= PLAIN:
        faster = np.abs(track.speed) - np.abs(ego.speed[:steps])
        near = (times_to_collision(ego, track)[:steps] <= LONGEST) & (faster > CLOSES)
        return (
            None if near.any() else f"it is to run into the ego, and never comes up to it: {gap.min():.1f} m at least"
        )
    if one.starts.where is Where.AHEAD and Act.REVERSE in acts:
        backing = gap[track.speed < -CLOSES]
        if backing.size and backing.min() <= BACKS_TO:
            return None
        nearest = f"it is {backing.min():.1f} m from it" if backing.size else "it never backs"
        return f"it is to back into the ego, and {nearest}"
    return None


def _brushes(situation: Situation, one: Other, ego: Track, tracks: Sequence[Track], route: Route) -> Finding | None:
    """Whether the way of an ego that is to brush, with its side, who stands or lies there leads so near past that.

    None where no such thing was said.
    """
    contact = situation.contact
    if contact is None or not contact.happens or contact.striker is not Striker.EGO or contact.ego is None:
        return None
    stands = _touches(situation, one) and all(deed.act is Act.STAND for deed in one.does)
    by_side = not {"left", "right"}.isdisjoint(SIDES_OF[contact.ego])
    if not (stands and by_side and one.starts.where in BRUSHED):
        return None
    along = np.arange(0.0, route.line.length, FINE)
    x, y = route.line.points_at(along).T
    heading, still = route.line.headings_at(along), np.zeros_like(along)
    kept = replace(ego, x=x, y=y, heading=heading, speed=still)
    own = min(_least(ego, track, len(track.x)) for track in tracks)
    if own > COMES_TO:
        return Finding(path="", shown=False, told=f"the ego comes no nearer than {own:.1f} m to what it is to brush")
    gap = min(own, *(_least(kept, _stands_all_along(track, len(along)), len(along)) for track in tracks))
    told = f"the ego's way leads past it at {gap:.1f} m"
    return Finding(path="", shown=gap <= BRUSHES, told=told)


def _otherwise(
    situation: Situation, one: Other, ego: Track, tracks: Sequence[Track], least: Meeting, since: int
) -> Finding | None:
    """That two meet at another moment than was meant: who follows is never near, or who comes up is by too soon."""
    if (far := _not_nearly(situation, one, ego, tracks)) is not None:
        told = f"it was said to all but run into the ego, and is never nearer than {far:.1f} m"
        return Finding(path="", shown=False, told=told)
    if not _is_by_first(situation, one, least):
        return None
    early = least.between + EARLY
    fast = max(float(np.abs(tracks[0].speed[since:]).max(initial=0.0)), 1.0)
    told = f"it is by {least.between:.1f} s before the ego comes into its lane"
    return Finding(path="", shown=False, told=told, late=Late(seconds=-early, metres=-early * fast))


def _not_nearly(situation: Situation, one: Other, ego: Track, tracks: Sequence[Track]) -> float | None:
    """How near [m] who follows the ego, and was said not to touch it, comes; None of others, and of who nearly does."""
    contact = situation.contact
    if contact is None or contact.happens or contact.whom != one.id or one.starts.where is not Where.BEHIND:
        return None
    if any(deed.act in acts_of(Heads.BY, Heads.OVER, Heads.ASIDE) for deed in one.does):
        return None
    gap = min(float(gaps(ego, track).min()) for track in tracks)
    return gap if gap > NEARLY else None


def _is_by_first(situation: Situation, one: Other, meets: Meeting) -> bool:
    """Whether somebody who only comes up in the next lane is by before an ego that changes to that lane is in it."""
    comes_up = one.starts.where is Where.BEHIND_BESIDE and all(deed.act in GOES_BY for deed in one.does)
    if not comes_up or meets.ego_first or meets.between <= ALL_BUT or math.isinf(meets.between):
        return False
    ego = situation.ego
    sides = [deed.to for deed in ego.does if deed.act in acts_of(Heads.OVER)]
    sides += [CHANGES_TO[ego.route]] if ego.route in CHANGES_TO else []
    return bool(sides) and (sides[0] is None or one.starts.side in (None, sides[0]))


def _late(meets: Meeting, ego: Track, track: Track, since: int) -> Late | None:
    """How much too late somebody is who does not meet the ego; None where that is not told by time or place."""
    fast = max(float(np.abs(track.speed[since:]).max(initial=0.0)), 1.0)
    if math.isfinite(meets.between):
        seconds = meets.between if meets.ego_first else -meets.between
        return Late(seconds=seconds, metres=seconds * fast)
    far = float(past(ego, track)[since])
    return Late(seconds=far / fast, metres=far) if far > 0.0 else None


def _between(meets: Meeting) -> float:
    return meets.between


def _not_steered(ego: Track, line: Polyline) -> Track | None:
    """The ego as if it had kept to its route, as far along it; None if it did, or was not on it at first.

    Who steers round another reacts, as who brakes does.
    """
    along, offset = follow(line, ego.x, ego.y, whole=True)
    aside = np.abs(offset)
    if aside[0] > ASIDE or aside.max() <= ASIDE:
        return None
    x, y = line.points_at(along).T
    return replace(ego, x=x, y=y, heading=unwrapped(line.headings_at(along)))


def _passes_who_stands(one: Other, ego: Track, since: int) -> bool:
    """Whether somebody passes an ego that stands then: it need not come into the ego's way for that."""
    passes = any(deed.act in acts_of(Heads.BY) and deed.done_to == EGO for deed in one.does)
    return passes and abs(float(ego.speed[min(since, len(ego.speed) - 1)])) < STANDING


def _touches(situation: Situation, one: Other) -> bool:
    """Whether it was said that the ego touches somebody, or just does not."""
    contact = situation.contact
    return contact is not None and one.id == (contact.whom or situation.adversaries[0].id)


def _must_meet(
    situation: Situation, one: Other, ego: Track, way: Way, track: Track, found: Meeting, route: Route
) -> bool:
    """Whether what was said asks for an encounter, as `encounter` has it."""
    if _touches(situation, one):
        return True
    acts = {deed.act for deed in one.does}
    if acts & LETS_BY:
        return False
    boxes = Boxes.of(track)
    if not _on(way, ego, boxes.at(slice(1))):
        if acts and acts <= STAYS:
            return False
        if _on_its_way_in(way, ego, track, route):
            return True
        return found.between <= LONGEST or _on(way, ego, boxes.at(slice(None, None, 5)))
    along, x, y, heading = way
    near = int(np.argmin(np.hypot(x - track.x[0], y - track.y[0])))
    against = math.cos(float(track.heading[0] - heading[near])) < 0.0
    ahead = along[near] > 0.0
    stays = bool(one.does) and one.does[-1].act is Act.STAND
    return bool(ahead) and (against or stays or bool(acts & COMES_NEARER))


def _on_its_way_in(way: Way, ego: Track, track: Track, route: Route) -> bool:
    """Whether somebody is last seen on its way to the ego's way through a junction, straight on from where it is."""
    if route.junction is None or abs(float(track.speed[-1])) < MOVING:
        return False
    far, heading = np.arange(0.0, TO_COME, 1.0), float(track.heading[-1])
    ones = np.ones_like(far)
    x, y = track.x[-1] + far * math.cos(heading), track.y[-1] + far * math.sin(heading)
    boxes = Boxes(x, y, math.cos(heading) * ones, math.sin(heading) * ones, track.length / 2, track.width / 2)
    there = (way[0] > route.event_at) & (way[0] < route.event_at + THROUGH)
    through = (way[0][there], way[1][there], way[2][there], way[3][there])
    return bool(there.any()) and _on(through, ego, boxes)


def _heads_for(ego: Track, track: Track, since: int) -> bool:
    """Whether the two would touch soon if both went on as they go: an ego that stands, or one that drives."""
    stands = np.abs(ego.speed[since:]) < STANDING
    return bool((times_to_collision(ego, track)[since:] <= np.where(stands, BEFORE, LONGEST)).any())


def _on(way: Way, ego: Track, boxes: Boxes) -> bool:
    """Whether one of the boxes of somebody touches that of an ego somewhere on its way."""
    _, x, y, heading = way
    own = Boxes(x, y, np.cos(heading), np.sin(heading), ego.length / 2, ego.width / 2)
    return overlaps(own, boxes, np.zeros(len(boxes.x), np.int64), len(x))[0].size > 0


def _goes_on_evenly(track: Track, episode: Episode) -> Track:
    """A track, and how it would go on at the end of a drive that no contact ended."""
    if episode.collision is not None:
        return track
    heading, speed = float(track.heading[-1]), float(track.speed[-1])
    gone = speed * episode.dt * np.arange(1, round(LONGEST / episode.dt) + 1)
    x, y = track.x[-1] + gone * math.cos(heading), track.y[-1] + gone * math.sin(heading)
    rest = np.ones_like(gone)
    return replace(
        track,
        x=np.concatenate((track.x, x)),
        y=np.concatenate((track.y, y)),
        heading=np.concatenate((track.heading, heading * rest)),
        speed=np.concatenate((track.speed, speed * rest)),
    )


def meeting(ego: Track, way: Way, other: Track, dt: float, since: int) -> Meeting:
    """How near two come to be at one place at one time.

    Args:
        ego: Who could go on.
        way: Where it came from and goes, beyond where it got (`way_of`).
        other: Who goes as it went.
        dt: Step [s].
        since: The step from which it counts.
    """
    lags = round(LONGEST / dt)
    far = math.hypot(ego.length, ego.width) / 2 + math.hypot(other.length, other.width) / 2
    there = since + np.flatnonzero(_within(way, other, since, far) & ~_follows(ego, other)[since:])
    if not there.size:
        return Meeting()
    own = _goes_on(ego, way, dt, len(other.x) - len(ego.x) + lags + 1, since)
    places, moments = overlaps(own, Boxes.of(other).at(there), there, lags)
    if not places.size:
        return Meeting()
    rows, steps = np.divmod(places, own.x.shape[1])
    lag = steps - there[moments]
    first = np.lexsort((moments, rows, lag > 0, np.abs(lag)))[0]
    step = int(there[moments[first]])
    return Meeting(between=abs(int(lag[first])) * dt, at=step * dt, ego_first=bool(lag[first] < 0))


def _follows(ego: Track, other: Track) -> Flags:
    """(T,) Whether somebody is behind the ego and goes its way: it is there later, and meets nobody there."""
    far, along = behind(ego, other)
    return (far > 0.0) & (along > GOES_WITH)


def _within(way: Way, other: Track, since: int, far: float) -> Flags:
    """(T - since,) Whether somebody is so near [m] to the ego's way, of which a point in a metre is enough."""
    along, x, y, _ = way
    points = np.searchsorted(along, np.arange(along[0], along[-1], 1.0)).clip(max=len(x) - 1)
    points = points[np.append(True, points[1:] != points[:-1])] if points.size else points
    return near_any(other.x[since:], other.y[since:], x[points], y[points], far + 1.0)


def _goes_on(ego: Track, way: Way, dt: float, more: int, since: int) -> Boxes:
    """(K, T + more) Its boxes: as it went, then as it would go on from each moment at which it goes evenly.

    Before the other begins with what it does it is nowhere (nan): where it was by then, nobody could have met it.
    """
    steps = len(ego.x)
    gone = np.concatenate(([0.0], np.cumsum(paces(ego.x, ego.y))))
    rows = [np.concatenate((gone, gone[-1] + ego.speed[-1] * dt * np.arange(1, more + 1)))]
    time = np.arange(steps + more)
    for k in _even(ego, dt):
        row = gone[k] + ego.speed[k] * dt * (time - k)
        row[:k] = gone[:k]
        rows.append(row)
    along = np.array(rows)
    along[:, :since] = np.nan
    x, y, heading = (np.interp(along, way[0], values) for values in way[1:])
    beyond = (along - way[0][-1]).clip(min=0.0)
    cos, sin = np.cos(heading), np.sin(heading)
    return Boxes(x + beyond * cos, y + beyond * sin, cos, sin, ego.length / 2, ego.width / 2)


def _even(ego: Track, dt: float) -> list[int]:
    """Moments at which the ego moves and neither brakes nor gains speed: every second, and before it brakes."""
    even = (np.abs(ego.acceleration(dt)) < LOSING) & (np.abs(ego.speed) > MOVING)
    last = np.append(even[:-1] & ~even[1:], False)
    return np.flatnonzero(even & (last | (np.arange(len(even)) % round(EVERY / dt) == 0))).tolist()


def way_of(ego: Track, line: Polyline) -> Way:
    """Arc length, x, y and heading of where the ego came from, where it went, and of the rest of its way."""
    moved = np.concatenate(([True], paces(ego.x, ego.y) > 1e-3))
    x, y, heading = ego.x[moved], ego.y[moved], ego.heading[moved]
    there, aside, _ = line.project(float(ego.x[-1]), float(ego.y[-1]))
    rest = np.arange(there + 2.0, line.length, 2.0) if abs(aside) < 3.0 else np.empty(0)
    points, turned = line.points_at(rest), line.headings_at(rest)
    back, first = np.arange(-BACK, 0.0, 1.0), float(heading[0])
    x = np.concatenate((x[0] + back * math.cos(first), x, points[:, 0]))
    y = np.concatenate((y[0] + back * math.sin(first), y, points[:, 1]))
    heading = unwrapped(np.concatenate((np.full(len(back), first), heading, turned)))
    return np.concatenate(([0.0], np.cumsum(paces(x, y)))) - BACK, x, y, heading
