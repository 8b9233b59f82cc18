"""What happens in a drive that nobody said: contacts, rules that the ego breaks, bodies in each other, and deeds."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import combinations

import numpy as np

from chatscene.program.amounts import HALF_LANE
from chatscene.program.contacts import is_of, is_with
from chatscene.program.deeds import BRAKES, LOSING, MOVING, OF_GRIP, STANDING, braking, runs
from chatscene.program.doing import ACTS, BARELY, TURNED_OFF, turned_by
from chatscene.program.finding import Finding
from chatscene.program.meaning import TOGETHER
from chatscene.program.measured import SLACK, SLACK_SPEED
from chatscene.program.own import BROKEN
from chatscene.program.watching import Seen, headings
from chatscene.simulate.boxes import Boxes, Pair
from chatscene.terms.actors import Manner, manner_of
from chatscene.terms.episode import Episode, EventKind, Track
from chatscene.terms.nouns import with_article
from chatscene.terms.route import Route
from chatscene.terms.scenario import Place, includes
from chatscene.terms.situation import EGO, Other, Situation
from chatscene.terms.vocabulary import (
    LETS_GO,
    SIDEWAYS,
    SLOWS,
    SWINGS,
    Act,
    EgoLight,
    Heads,
    RightOfWay,
    Role,
    Tempo,
    Where,
    acts_of,
)

DEEP = 0.3  # [m] that two bodies are in each other, from which one is seen to drive through the other
LEFT_PLACE = 1.0  # [m] from where it stood, from which somebody stands there no more
LEFT_LANE = 2.2  # [m] aside of where it began, from which a road user has left its lane …
LEFT_LINE = 1.4  # [m] … or is seen to leave its line, where no contact is said for which it may have to
STRAIGHT = 0.2  # [rad] that a road turns at most of which lanes are told by how far aside of the ego's way somebody is
INSIDE = 1.3  # [m] from the ego's line to the nearest of a body that stands in its way
STAYS = 2.0  # [s] that somebody stands at least who does not just wait
APART = 0.5  # [s] between two times that somebody brakes, or it is one
IN_LANE = SLOWS | acts_of(Tempo.STANDS, Tempo.SETS_OFF, Tempo.GAINS, Heads.ALONG, Heads.LEVEL)
"""What is done without leaving the lane, and by its own will."""
GOES_BACK = acts_of(Tempo.BACKS, Tempo.WAITS, Heads.BACK, Heads.ROUND, Heads.EDGE)
"""What may be done by going back."""
ALONG = (IN_LANE | SIDEWAYS | acts_of(Heads.BY, Heads.BEHIND, Heads.CLOSE)) - acts_of(Tempo.STANDS)
"""What is done by who goes on along the road."""
RAMPS = frozenset((Where.ON_RAMP, Where.OFF_RAMP))
"""Places whose own way leads over to the ego's road, or off it."""
STAYS_BEHIND = acts_of(Heads.BEHIND, Heads.CLOSE)
"""What is done by who follows another."""
KEEPS_TO = STAYS_BEHIND | acts_of(Heads.LEVEL)
"""What is done by who is as fast as another."""
GETS_AHEAD = acts_of(Heads.BY, Heads.BEFORE, Heads.LEVEL)
"""What brings who is behind another ahead of that."""
LOST = 4.0  # [m/s] that somebody loses, or half of its speed, who is seen to brake for nothing
FIRMLY = 2.5  # [m/s²] with which it does, or the same share of the grip as of who is seen to brake at all
LOOKS = 2  # [steps] apart, at which it is looked for somebody ahead while somebody brakes
EASILY = 2.5  # [m/s²] with which somebody may brake for whoever is slower ahead
AHEAD = 3.0  # [s] ahead of somebody, at its speed, is for whom it may have to brake
IN_FRONT = HALF_LANE  # [m] aside of its line at most
_SAID = {
    EventKind.RED_LIGHT: (EgoLight.RED, EgoLight.YELLOW, EgoLight.TURNS_RED, EgoLight.TURNS_GREEN),
    EventKind.STOP_SIGN: (RightOfWay.STOP_SIGN,),
}
"""What is said of the rules that an ego can break; if it then breaks them, that is how it drives."""


def unasked(situation: Situation, episode: Episode, until: int | None) -> Iterator[Finding]:
    """What befalls the ego and others that was not said, up to a step; nothing where all is as it was said."""
    crash, contact = episode.collision, situation.contact
    if crash is not None and contact is None:
        adversary = any(is_with(crash.other, one.id) for one in situation.adversaries)
        if not adversary:
            told = f"the ego and {crash.other} touch, which the text does not say"
            yield Finding(path="unasked.contact", shown=False, told=told, at=crash.step * episode.dt)
    rules = {EventKind.RED_LIGHT: situation.road.ego_light, EventKind.STOP_SIGN: situation.road.control}
    for event in episode.events:
        broken = any(deed.breaks is not None and BROKEN.get(deed.breaks) is event.kind for deed in situation.ego.does)
        chosen = event.kind in rules and rules[event.kind] not in _SAID[event.kind] and not broken
        if chosen and (until is None or event.step < until):
            told = f"the ego runs {with_article(event.kind.replace('-', ' '))}, which the text does not mention"
            yield Finding(path=f"unasked.{event.kind}", shown=False, told=told, at=event.step * episode.dt)
    yield from _let_go(situation, episode, until)
    yield from _through_others(situation, episode, until)


def _let_go(situation: Situation, episode: Episode, until: int | None) -> Iterator[Finding]:
    """A door that opens, or a load that falls, of which nobody said that it does."""
    for one in situation.others:
        for act, part in LETS_GO.items():
            bodies = [track for track in episode.tracks if is_of(track.actor, f"{one.id}-{part}")]
            said = sum(deed.act is act for deed in one.does) * (one.count or len(bodies))
            for body in bodies[said:]:
                moves = np.abs(body.speed[:until]) > STANDING
                if moves.any():
                    at, name = int(np.argmax(moves)) * episode.dt, f"{one.id}-{part}"
                    told = f"{one.id}: {act} happens {said + 1} times, and the text says {said}"
                    yield Finding(path=f"unasked.{name}", shown=False, told=told, at=at)


def _through_others(situation: Situation, episode: Episode, until: int | None) -> Iterator[Finding]:
    """Two of different names whose bodies are in each other."""
    named = [
        (one.id, track.actor, Boxes.of(track))
        for one in situation.others
        for track in episode.tracks[1:]
        if is_of(track.actor, one.id)
    ]
    for (one, actor, a), (other, another, b) in combinations(named, 2):
        if one != other and (step := _in_each_other(a, b, until)):
            told = f"{actor} and {another} drive through each other"
            yield Finding(path=f"unasked.{actor}-{another}", shown=False, told=told, at=step * episode.dt)


def _in_each_other(a: Boxes, b: Boxes, until: int | None) -> int:
    """The first step at which two are in each other; 0 if they never are, or are from the start."""
    pair = Pair.of(a, b)
    deep = (pair.reach - np.abs(pair.offset)).min(axis=0)[:until] > DEEP
    return int(np.argmax(deep)) if deep.any() else 0


def of_somebody(
    situation: Situation, one: Other, seen: Seen, route: Route, others: Sequence[Track], after: int
) -> Iterator[Finding]:
    """What somebody does that is no part of what it is told to.

    It comes to stand in the way, goes back, turns off; it brakes for nobody, or who is only told to change speed in its
    lane brakes more often, or leaves that. `others` are all that it may have to brake for, `after` the step at which
    all is done that it was told to.

    Who comes against the ego in its lane leaves that where it was said that the two do not touch.
    """
    acts = [deed.act for deed in one.does]
    if acts and acts[-1] is Act.CROSS and (stops := _in_the_way(seen)) is not None:
        told = f"{one.id} stops in the ego's way, which the text does not say"
        yield Finding(path=f"unasked.{one.id}", shown=False, told=told, at=stops * seen.dt)
    if acts and GOES_BACK.isdisjoint(acts) and (back := _back(seen)) is not None:
        told = f"{one.id} moves backwards, which the text does not say"
        yield Finding(path=f"unasked.{one.id}.back", shown=False, told=told, at=back * seen.dt)
    stays = any(deed.act in STAYS_BEHIND and deed.whom in (None, EGO) for deed in one.does)
    if stays and ALONG.issuperset(acts) and GETS_AHEAD.isdisjoint(acts):
        yield from _gets_past(one, seen, route)
    if acts and ALONG.issuperset(acts) and not one.starts.where.row.junction and route.junction is None:
        yield from _along_the_road(one, seen, others, after if np.ptp(headings(route.line)) < STRAIGHT else None)
    if acts and IN_LANE.issuperset(acts):
        yield from _stands_no_more(one, seen) if set(acts) == {Act.STAND} else _in_its_lane(situation, one, seen, route)


def _stands_no_more(one: Other, seen: Seen) -> Iterator[Finding]:
    """Whether somebody moves who is told to stand."""
    gone = np.hypot(seen.track.x - seen.track.x[0], seen.track.y - seen.track.y[0]) > LEFT_PLACE
    if gone.any():
        step = int(np.argmax(gone))
        told = f"{one.id} moves {'backwards' if seen.track.speed[step] < 0.0 else 'away'}, which the text does not say"
        yield Finding(path=f"unasked.{one.id}", shown=False, told=told, at=step * seen.dt)


def _in_its_lane(situation: Situation, one: Other, seen: Seen, route: Route) -> Iterator[Finding]:
    """What somebody does who is only told to change speed in its lane: it brakes more often, or leaves that."""
    later = one.does[1:]  # who goes on at a speed or comes to stand may have to brake for it
    said = (one.does[0].act in SLOWS) + sum(deed.act in (*SLOWS, Act.STAND) or deed.speed is not None for deed in later)
    times = _times_braking(seen, turns=route.junction is not None)
    if said and len(times) > said:
        told = f"{one.id} brakes {len(times)} times, and the text says {'once' if said == 1 else f'{said} times'}"
        yield Finding(path=f"unasked.{one.id}", shown=False, told=told, at=times[0] * seen.dt)
    even = np.ptp(headings(route.line)) < STRAIGHT or includes(Place.CURVE, route.place)
    contact = situation.contact
    missed = one.role is Role.SUPPORTING or (contact is not None and not contact.happens)
    goes_by = missed and one.starts.where is Where.ONCOMING_IN_OUR_LANE  # which it cannot do on its line
    leads_over = one.starts.where.row.junction or one.starts.where in RAMPS
    if even and not goes_by and not leads_over:
        aside = np.abs(seen.aside - seen.aside[0])  # of the lanes: an ego that changes lanes moves its own way over
        inside = (seen.at > 0.0) & (seen.at < route.length)
        least = LEFT_LINE if contact is None else LEFT_LANE
        if (gone := inside & (aside > least)).any() and abs(np.cos(seen.facing[0])) > 0.9:
            step = int(np.argmax(gone))
            told = f"{one.id} leaves its line by {aside[step]:.1f} m, which the text does not say"
            yield Finding(path=f"unasked.{one.id}.lane", shown=False, told=told, at=step * seen.dt)


def _gets_past(one: Other, seen: Seen, route: Route) -> Iterator[Finding]:
    """Whether somebody who is to stay behind gets past the ego, before the two may take different ways."""
    for once in ACTS[Act.OVERTAKE](seen):
        if once.done is not None and (route.junction is None or seen.at[once.done] < route.event_at):
            told = f"{one.id} gets past the ego, which the text does not say"
            yield Finding(path=f"unasked.{one.id}.past", shown=False, told=told, at=once.began * seen.dt)


def _along_the_road(one: Other, seen: Seen, others: Sequence[Track], after: int | None) -> Iterator[Finding]:
    """What somebody does who is only told to go along a road: it leaves that, brakes for nobody."""
    acts = {deed.act for deed in one.does}
    if acts.isdisjoint(SWINGS) and (off := _turns_off(seen)) is not None:
        told = f"{one.id} turns off or turns round, which the text does not say"
        yield Finding(path=f"unasked.{one.id}.turn", shown=False, told=told, at=off * seen.dt)
    speeds = [deed.speed for deed in one.does if deed.speed is not None]
    free = after is not None and acts.isdisjoint(SLOWS | KEEPS_TO) and not any(speed.than_ego for speed in speeds)
    least = min((max(speed.low, 0.0) for speed in speeds), default=math.inf)
    if free and (brakes := _brakes_for_nobody(seen, others, after or 0, least)) is not None:
        told = f"{one.id} brakes hard for nobody, which the text does not say"
        yield Finding(path=f"unasked.{one.id}.brakes", shown=False, told=told, at=brakes * seen.dt)


def _turns_off(seen: Seen) -> int | None:
    """Since when somebody turns off the road along which it goes, or round; None of who does not."""
    beside = (seen.at > 0.0) & (seen.at < seen.line.length)  # elsewhere nothing tells where its road leads
    turned = np.where(beside, turned_by(seen), 0.0)
    if manner_of(seen.track.kind) is Manner.WALKS or turned.max() <= TURNED_OFF:
        return None
    return int(np.flatnonzero(turned[: int(turned.argmax())] < BARELY)[-1])


def _brakes_for_nobody(seen: Seen, others: Sequence[Track], after: int, least: float) -> int | None:
    """The step from which somebody brakes hard although nobody is ahead; None if it never does.

    If speeds were said, it must then be slower than the least of them [m/s].
    """
    speed = np.abs(seen.track.speed)
    for first, end in runs(braking(seen)):
        began = max(first - 1, 0)
        lost, seconds = float(speed[began] - speed[end - 1]), (end - 1 - began) * seen.dt
        firm = lost >= min(FIRMLY, OF_GRIP * seen.grip) * seconds
        much = speed[began] > MOVING and lost >= min(LOST, 0.5 * speed[began])
        slower = speed[end - 1] < least - max(SLACK_SPEED, SLACK * least) if math.isfinite(least) else True
        steps = range(began, end, LOOKS)  # who comes over meanwhile may come behind somebody
        if began >= after and much and firm and slower and not any(_blocked(seen, others, step) for step in steps):
            return began
    return None


def _blocked(seen: Seen, others: Sequence[Track], step: int) -> bool:
    """Whether somebody is ahead of somebody, or may come there, near enough to have to brake for."""
    me = seen.track
    cos, sin = np.cos(me.heading[step]), np.sin(me.heading[step])
    for other in others:
        x, y = other.x[step] - me.x[step], other.y[step] - me.y[step]
        ahead, aside = x * cos + y * sin, y * cos - x * sin
        along = max(0.0, float(other.speed[step] * np.cos(other.heading[step] - me.heading[step])))
        near = max(AHEAD * abs(me.speed[step]), (me.speed[step] ** 2 - along**2) / (2.0 * EASILY))
        near += (me.length + other.length) / 2
        comes = AHEAD * abs(other.speed[step] * np.sin(other.heading[step] - me.heading[step]))
        if other is not me and 0.0 < ahead < near and abs(aside) < IN_FRONT + other.width / 2 + comes:
            return True
    return False


def _back(seen: Seen) -> int | None:
    """Since when somebody goes back, on wheels backwards, on foot over the road; None of who does not so far."""
    backwards = -seen.track.speed.clip(max=0.0)
    left = np.flatnonzero(np.cumsum(backwards) * seen.dt > LEFT_PLACE)
    if left.size:
        stood = np.flatnonzero(backwards[: left[0]] == 0.0)
        return int(stood[-1]) + 1 if stood.size else 0
    if manner_of(seen.track.kind) is not Manner.WALKS:
        return None
    return next((once.began for once in ACTS[Act.TURN_BACK](seen) if once.done is not None), None)


def _in_the_way(seen: Seen) -> int | None:
    """Since when somebody who comes to stand before the ego stays in its lane; None if nobody does."""
    moves = np.flatnonzero(np.abs(seen.track.speed) >= STANDING)
    first = int(moves[-1]) + 1 if moves.size else 0
    if not first or (len(seen.track.speed) - first) * seen.dt < STAYS:
        return None
    within = abs(seen.offset[first]) < seen.track.width / 2 + INSIDE
    return first if within and seen.lead[first] > 0.0 else None


def _times_braking(seen: Seen, *, turns: bool) -> list[int]:
    """Since when it brakes hard, every time that it begins to; while it goes on losing speed it is one time.

    Where it may turn at a junction, not those for a turn.
    """
    times, ended, speed = list[int](), 0, np.abs(seen.track.speed)
    for first, end in runs(braking(seen)):
        if end - first < BRAKES:
            continue
        soon = min(end + round(TOGETHER / seen.dt), len(speed) - 1)
        if turns and abs(seen.track.heading[soon] - seen.track.heading[first]) > BARELY:
            continue
        apart = (first - ended) * seen.dt
        if not times or (apart > APART and speed[ended - 1] - speed[first - 1] < LOSING * apart):
            times.append(first)
        ended = end
    return times
