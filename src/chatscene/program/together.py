"""Who is to be where others meet, and when: by how many seconds each misses the meeting that it belongs to.

A text names nobody without a reason. Who comes against the ego while somebody pulls out leaves no room beside that one;
who stops while somebody crosses stops for that one. Such are partners of one meeting, though no word says when either
is there. So this is no judgement of a drive: it tells what to shift where several programs show all that was said.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

import numpy as np
from numpy.typing import NDArray

from chatscene.program.finding import Late
from chatscene.terms.actors import Manner as Moves
from chatscene.terms.conclusions import JUNCTIONS
from chatscene.terms.episode import Episode, Track
from chatscene.terms.situation import Other, Situation
from chatscene.terms.vocabulary import COMES_IN, LOSES, PLAIN, Act, Role, Where

FREE = 0.5  # [s] by which somebody may be early or late
BEFORE = 3.0  # [s] before somebody crosses the road that another may have come by, which is not to strike it
SHORT = 20.0  # [m] before who crosses, within which another stops for it
MOVES = 0.5  # [m/s]: who is faster has set out
SLOW_BEFORE = 1.0, 4.0  # [s] before who stands, that somebody is slowest who loses speed for that one
BRAKES, REACTS = 5.0, 0.3  # [m/s²], [s]
_BESIDE_ROAD = frozenset((Where.ROADSIDE, Where.CROSSING, Where.KERB, Where.DRIVEWAY, Where.BUS_BAY))
_UP_BESIDE = frozenset((Where.BESIDE, Where.BEHIND_BESIDE))


def apart(situation: Situation, episode: Episode) -> dict[str, Late]:
    """How much too late, or too early, each is for the meeting that it belongs to, by ids; none of who is in time.

    Args:
        situation: What was said.
        episode: A drive of it.
    """
    tracks = {one.actor: one for one in episode.tracks}
    found = dict[str, Late]()
    for one in situation.others:
        if one.id in tracks and (late := _late(situation, one, tracks, episode.dt)):
            fast = max(float(tracks[one.id].speed.max()), 1.0)
            found[one.id] = Late(seconds=late, metres=late * fast)
    return found


def _late(situation: Situation, one: Other, tracks: Mapping[str, Track], dt: float) -> float:
    """How much too late [s] somebody is, less than 0 if too early; 0 of who is in time, or belongs to no meeting."""
    if one.starts.distance is not None or any(deed.when is not None for deed in one.does) or one.role is Role.HIDES:
        return 0.0
    acts = [deed.act for deed in one.does]
    if one.starts.where is Where.AHEAD and acts[:1] == [Act.STAND]:
        return _stands_before(situation, one, tracks)
    drives = one.kind.moves is not Moves.WALKS and bool(acts)
    if drives and acts[-1] in LOSES and one.starts.where in _UP_BESIDE | {Where.ONCOMING}:
        return max((_stops(tracks, one, by) for by in _crossing(situation, one)), key=abs, default=0.0)
    if not drives or any(act not in PLAIN for act in acts):
        return 0.0
    if one.starts.where is Where.ONCOMING and situation.road.kind not in JUNCTIONS:
        met = next((by for by in situation.adversaries if by.id != one.id and by.starts.where in _BESIDE_ROAD), None)
        return 0.0 if met is None or met.id not in tracks else _by(tracks, one, met, dt)
    return 0.0


def _stands_before(situation: Situation, one: Other, tracks: Mapping[str, Track]) -> float:
    """How much too late [s] who loses speed comes to somebody who stands ahead in its lane, as it is slowest."""
    stands, found = tracks[one.id], list[float]()
    for by in situation.others:
        slows = by.starts.where is Where.AHEAD and any(deed.act in LOSES for deed in by.does)
        if slows and by.id in tracks and abs(float(stands.speed[0])) < MOVES:
            who = tracks[by.id]
            at = int(who.speed.argmin())
            slow = max(float(who.speed[at]), 1.0)
            gap = math.hypot(stands.x[at] - who.x[at], stands.y[at] - who.y[at]) - 0.5 * (stands.length + who.length)
            found.append(_outside(gap, slow * SLOW_BEFORE[0], max(slow * SLOW_BEFORE[1], SHORT)))
    return max(found, key=abs, default=0.0)


def _crossing(situation: Situation, one: Other) -> Iterator[Other]:
    """Those who cross the road on which somebody drives."""
    for by in situation.others:
        over = any(deed.act in COMES_IN for deed in by.does)
        if by.id != one.id and by.starts.where in _BESIDE_ROAD and over and by.kind.moves is Moves.WALKS:
            yield by


def _stops(tracks: Mapping[str, Track], one: Other, by: Other) -> float:
    """How much too late [s] somebody comes to stop short of another's way over the road, when that one sets out."""
    who, crosses = tracks[one.id], tracks.get(by.id)
    if crosses is None or (at := _first(np.abs(crosses.speed) > MOVES)) is None:
        return 0.0
    fast = max(float(who.speed.max()), 1.0)
    c, s = math.cos(who.heading[at]), math.sin(who.heading[at])
    left = (crosses.x[at] - who.x[at]) * c + (crosses.y[at] - who.y[at]) * s - 0.5 * who.length
    needs = fast * REACTS + fast**2 / (2.0 * BRAKES)
    return _outside(left - needs, 0.0, SHORT) / fast


def _by(tracks: Mapping[str, Track], one: Other, met: Other, dt: float) -> float:
    """How much later than the ego [s] who comes the other way is where the ego meets somebody."""
    ego, who, other = tracks["ego"], tracks[one.id], tracks[met.id]
    near = np.hypot(other.x - ego.x, other.y - ego.y)
    at = int(near.argmin())
    far = np.hypot(who.x - other.x[at], who.y - other.y[at])
    passes = int(far.argmin())
    late = (passes - at) * dt
    if passes == len(far) - 1:  # it is still to come
        late += float(far[-1]) / max(float(who.speed[-1]), 1.0)
    crosses = any(deed.act in COMES_IN for deed in met.does) and met.kind.moves is Moves.WALKS
    return _outside(late, -BEFORE if crosses else -FREE, FREE)


def _outside(value: float, low: float, high: float) -> float:
    """How far a value is from the middle of a range; 0 of one that lies in it."""
    return 0.0 if low <= value <= high else value - 0.5 * (low + high)


def _first(holds: NDArray[np.bool_]) -> int | None:
    steps = np.flatnonzero(holds)
    return int(steps[0]) if steps.size else None
