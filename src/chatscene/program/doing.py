"""The deeds of a situation as a watcher of the tracks sees them: for each act the times that it is done.

What is said in a sentence's slots is seen by `chatscene.program.deeds`, of which most rows are taken.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import replace

import numpy as np

from chatscene.errors import ChatSceneError
from chatscene.program.amounts import EVEN, KEPT
from chatscene.program.deeds import (
    ACTIONS,
    HALT,
    MOVING,
    STANDING,
    TURNED,
    TURNED_MIDWAY,
    Act,
    before,
    comes_in,
    lasting,
    runs,
)
from chatscene.program.lateral import LANE
from chatscene.program.watching import ALONG, Seen
from chatscene.terms.actors import BY_CLASS, AdversaryKind, Manner, manner_of
from chatscene.terms.acts import Action
from chatscene.terms.arrays import Array, changes, changes_at, slopes, unwrapped
from chatscene.terms.seeing import gain_of, loss_of
from chatscene.terms.vocabulary import Act as Said
from chatscene.terms.vocabulary import Heads, Tempo, by_act

DRIFTED = 0.8  # [m]
BACK = 0.5  # [m]
ON_LINE = 0.3  # [m] aside of its line at most, who is still on that
BACK_ASIDE = 0.1  # [m] toward its line, from which somebody goes back to that
MOST_OF = 0.6
BARELY = math.radians(5)  # by which somebody is turned who does not yet turn off
TURNED_OFF = math.radians(60)  # who has turned by so much has not gone straight on
ROUND_ABOUT = math.radians(140)  # by which somebody is turned who has turned round
ROUND = math.radians(30)  # from the ego's way, from which somebody is seen to turn round
GOES_WITH = 0.5  # cosine of the angle to the ego's way up to which somebody goes along that
OUT_OF_LANE = 1.6  # [m] from its line to the near side of a body that is outside its lane
FOLLOWS = 40.0  # [m] behind somebody: who is farther does not follow …
FREE = 5.0  # [s] … if it is also more than this behind, from which drivers are counted as free of whom they follow
FOLLOWED = 15  # [steps] that somebody must be behind another to be seen to follow, or level to keep so
LEVEL = 8.0  # [m] along the road between the middles at most of two who are level
OUTSIDE = 1.4  # [m] from the ego's line: who is no farther away is not outside its lane

SPUN = 0.35  # [rad] from where it goes, from which on somebody is seen to slide turned away
SLID = 1.5  # [m/s] at which that is seen


def _speed(s: Seen) -> Array:
    return np.abs(s.track.speed)


def _stands_at_first(s: Seen) -> Iterable[Act]:
    moving = _speed(s) > STANDING
    end = int(np.argmax(moving)) if moving.any() else len(moving)
    if end > 3:
        yield Act(0, end - 1)


def standing(s: Seen, since: int = 0) -> Iterator[Act]:
    """Every time somebody stands, also after a step at which a deed began that was done before."""
    for first, end in runs(_speed(s) < STANDING):
        if end == len(s.track.x) or (end - first >= HALT and end - 1 >= since + HALT * (since > 0)):
            yield Act(first, end - 1)


def since(once: Act, step: int, s: Seen, *, stands: bool) -> Act:
    """A deed of which a part was done before another began, from when that did: what is seen of it after that.

    Who comes in must still be outside then; who stands need only stand.
    """
    done = len(s.track.x) if once.done is None else once.done
    still = stands or abs(s.offset[step]) > OUTSIDE
    return replace(once, began=step) if once.began < step <= done and still else once


def _opens(s: Seen) -> Iterator[Act]:
    """A door comes out."""
    moving = _speed(s) > STANDING
    if moving.any():
        began = int(np.argmax(moving))
        still = ~moving[began:]
        yield Act(began, began + int(np.argmax(still)) if still.any() else None)


def _moves_on(s: Seen) -> Iterable[Act]:
    """Every time that it gets on by its own length, or by two metres, where that is more."""
    least = max(2.0, s.track.length)
    began = _since_moving(s)
    while True:
        far = np.hypot(s.track.x[began:] - s.track.x[began], s.track.y[began:] - s.track.y[began]) > least
        if not far.any():
            return
        done = began + int(np.argmax(far))
        yield Act(began, done)
        began = done


def enters(s: Seen) -> Iterable[Act]:
    """It comes into the ego's lane, and does not leave it on the other side."""
    inside = np.abs(s.offset) < 1.75
    began = _since_moving(s)
    if np.ptp(s.aside) < ON_LINE:  # the ego's way comes to it, and not it to that
        return
    if (s.offset * np.sign(s.offset[0]) < -1.75).any():
        return
    if abs(s.offset[0]) > 1.6 and inside.any():
        yield Act(began, int(np.argmax(inside)))
    elif abs(s.offset[0]) - abs(s.offset[-1]) > 0.3:
        yield Act(began, None)


def _crosses(s: Seen) -> Iterator[Act]:
    """It comes in over the ego's way, and does not end up in its lane, going along that."""
    lately = s.offset[-round(1.0 / s.dt) - 1 :]
    along = abs(math.sin(float(_from_way(s)[-1]))) < math.sin(ALONG) and abs(s.offset[-1]) < OUTSIDE
    along = along and float(np.ptp(lately)) < ON_LINE  # and not over it, however slantingly
    beside = 0.0 < s.at[-1] < s.line.length
    yield from () if along and beside else ACTIONS[Action.CROSS](s)


def _keeps_level(s: Seen) -> Iterable[Act]:
    """It is level with somebody for a while, and neither gets past nor is passed."""
    level = (np.abs(s.lead) < LEVEL) & (np.abs(changes_at(s.lead)) < EVEN / KEPT)
    return lasting(level & (s.ego.speed > MOVING) & (_speed(s) > MOVING), FOLLOWED)


def _since_moving(s: Seen) -> int:
    moving = _speed(s) > STANDING
    return int(np.argmax(moving)) if moving.any() else 0


def _sets_off(s: Seen) -> Iterable[Act]:
    speed = _speed(s)
    step = 0
    while (stood := np.flatnonzero(speed[step:] < STANDING)).size:
        first = step + int(stood[0])
        if not (goes := np.flatnonzero(speed[first:] > MOVING)).size:
            return
        step = first + int(goes[0])
        yield Act(max(step - 1, 0), step)


def _slows_down(s: Seen) -> Iterable[Act]:
    """Every time that it has lost enough of the speed that it had; then what it has is what is lost from."""
    speed, peak = _speed(s), 0
    for step in range(1, len(speed)):
        if speed[step] >= speed[peak]:
            peak = step
        elif speed[peak] > MOVING and speed[peak] - speed[step] > loss_of(float(speed[peak])):
            yield Act(peak, step)
            peak = step


def accelerates(s: Seen, to: float = math.inf) -> Iterable[Act]:
    """Every time that it gains speed without losing some, by so much as is seen of its kind, or most of what was said.

    Args:
        s: Who.
        to: The speed [m/s] that was said, of which it can gain no more.
    """
    speed, low = _speed(s), 0
    gain = min(gain_of(BY_CLASS.get(s.track.kind, AdversaryKind.CAR).row), MOST_OF * to)
    for step in range(1, len(speed)):
        if speed[step] <= speed[low] or speed[step] < speed[step - 1] - 0.05:
            low = step
        elif speed[step] - speed[low] >= gain:
            yield Act(low, step)
            low = step
    if len(speed) > 1 and speed[-1] - speed[low] >= gain / 4:
        yield Act(low, None)


def _brakes(s: Seen) -> Iterable[Act]:
    """It loses speed hard for some steps, or stands before that; without a break that is one time."""
    found, speed = tuple(ACTIONS[Action.BRAKE](s)), _speed(s)
    yield from found
    for step in range(1, len(speed)):
        if speed[step] < STANDING <= speed[step - 1] and speed[max(step - 3, 0)] > MOVING:
            began = max(step - 3, 0)
            began += int(np.argmax(changes(speed[began : step + 1]) < 0.0))
            if not any(once.began <= step and (changes(speed[once.began : step + 1]) <= 0.0).all() for once in found):
                yield Act(began, step)


def _turns_back(s: Seen) -> Iterable[Act]:
    """Every time that it goes back half a metre after it came as far: from where it began, or on foot over the road."""
    if manner_of(s.track.kind) is Manner.WALKS:
        yield from _backs((s.offset[0] - s.offset) * np.sign(s.offset[0]))
    yield from _backs(np.hypot(s.track.x - s.track.x[0], s.track.y - s.track.y[0]))


def _backs(came: Array) -> Iterator[Act]:
    least = most = 0
    for step in range(1, len(came)):
        if came[step] > came[most]:
            most = step
        elif came[most] - came[least] > BACK and came[most] - came[step] > BACK:
            yield Act(most, step)
            least = most = step
        elif came[most] - came[least] <= BACK and came[step] < came[least]:
            least = most = step
    if came[most] - came[least] > BACK and came[most] - came[-1] > BACK / 5:
        yield Act(most, None)


def drifts(s: Seen, by: float = DRIFTED) -> Iterable[Act]:
    """It leaves its line, to either side, by so much as is seen [m], or by less if that was said."""
    least = min(DRIFTED, by)
    yield from _not_turning_off(s, _leaves_line(s, least))


def _leaves_line(s: Seen, least: float) -> Iterator[Act]:
    for away in (s.drift, -s.drift):
        if (away > least).any():
            done = int(np.argmax(away > least))
            near = np.flatnonzero(away[:done] < min(ON_LINE, least / 2))
            yield Act(int(near[-1]) if near.size else 0, done)


def _cuts_in(s: Seen) -> Iterable[Act]:
    """It comes in before the ego, into its first lane, or on a road that bends into that of its route."""
    if _keeps_line(s):
        return
    found = tuple(_before(s, comes_in(s.aside, outside=1.9, there=np.abs(s.aside) < 1.3, dt=s.dt)))
    yield from found
    if all(once.done is None for once in found):
        yield from _before(s, comes_in(s.offset, outside=1.9, there=np.abs(s.offset) < 1.3, dt=s.dt))


def _before(s: Seen, times: Iterable[Act]) -> Iterator[Act]:
    """The times at whose end its middle is ahead of the ego's, and it goes the ego's way."""
    with_ego = np.cos(_from_way(s)) > GOES_WITH
    yield from (once for once in times if with_ego[-1 if once.done is None else once.done] and _is_ahead(s, once))


def _is_ahead(s: Seen, once: Act) -> bool:
    return once.done is None or bool(s.lead[once.done] > 0.0)


def _from_way(s: Seen) -> Array:
    """(T,) [rad], heading against the ego's way where somebody is, without jumps."""
    way = s.line.headings_at(s.at.clip(0.0, s.line.length))
    return unwrapped(s.track.heading - way)


def turned_by(s: Seen) -> Array:
    """(T,) [rad], how far somebody has turned, of itself: neither with a way that bends nor against one."""
    way = _from_way(s)
    return np.minimum(np.abs(s.track.heading - s.track.heading[0]), np.abs(way - way[0]))


def _turns_once(s: Seen, times: Iterable[Act]) -> Iterator[Act]:
    """The times that somebody turns or exits, who does not end up turned round: it goes back the other way."""
    turned = turned_by(s)[-1]
    yield from () if ROUND_ABOUT < turned < 2.0 * math.pi - ROUND_ABOUT else times


def _not_turning_off(s: Seen, times: Iterable[Act]) -> Iterator[Act]:
    """The times that somebody goes aside that are not a turn into another road, in which it goes aside as well."""
    turned = turned_by(s)
    off = turned[-1] > (TURNED_MIDWAY if _speed(s)[-1] < STANDING else TURNED)
    turns = int(np.flatnonzero(turned < BARELY)[-1]) if off else len(turned)
    yield from (once for once in times if not off or (once.done is not None and once.done <= turns))


def _keeps_line(s: Seen) -> bool:
    """Whether somebody goes along its own line all the time, so that a way that comes to it is the ego's."""
    return abs(math.sin(float(s.facing[0]))) < math.sin(ALONG) and float(np.abs(s.drift).max()) < ON_LINE


def _any_change(s: Seen) -> Iterable[Act]:
    if _keeps_line(s):
        return
    yield from ACTIONS[Action.CHANGE_LANE](s)
    yield from comes_in(s.aside, outside=1.9, there=np.abs(s.aside) < 1.3, dt=s.dt)
    yield from comes_in(s.offset, outside=1.9, there=np.abs(s.offset) < 1.3, dt=s.dt)
    away = np.abs(s.drift)
    for over in (LANE, 2 * LANE):  # the next lane, and one more
        farther = np.flatnonzero(away > over + 2.4)
        if farther.size:
            before = np.flatnonzero(away[: farther[0]] < over + 0.3)
            yield Act(int(before[-1]), int(farther[0]))


def _goes_straight(s: Seen) -> Iterable[Act]:
    """It gets on, and does not turn off."""
    turned = abs(float(s.track.heading[-1] - s.track.heading[0]))
    yield from () if turned > TURNED_OFF else _moves_on(s)


def _turns_round(s: Seen) -> Iterator[Act]:
    """It turns round; who follows a way that bends has not begun to."""
    yield from (o for o in ACTIONS[Action.U_TURN](s) if o.done is not None or turned_by(s)[-1] > ROUND)


def _exits(s: Seen) -> Iterator[Act]:
    """It ends farther aside of the ego's way than it was, by more than a lane, and not because it crossed that.

    Who comes over the ego's way as it goes along it has not crossed it.

    Of an ego that changes lanes, also farther aside of the lane that the ego left: who stays there has not gone.
    """
    away = np.minimum(np.abs(s.offset), np.abs(s.aside))
    if abs(s.offset[0]) > OUTSIDE and s.offset[0] * s.offset[-1] < 0.0:
        over = int(np.argmax(s.offset * s.offset[0] < 0.0))
        if math.cos(float(_from_way(s)[over])) < GOES_WITH:
            return
    near = away <= away.min() + ON_LINE  # for the last time, or it had not left by then
    gone = away > np.minimum.accumulate(away) + LANE
    began = int(np.flatnonzero(near)[-1])
    if gone[-1]:
        yield Act(began, began + int(np.argmax(gone[began:])))
    elif away[-1] > away.min() + ON_LINE:
        yield Act(began, None)


def exits(s: Seen) -> Iterator[Act]:
    """It leaves a road that the ego leaves as well: by the same way, or by another."""
    yield from _exits(s)
    along = (s.beyond > 0.0) & (np.abs(s.offset) < OUTSIDE)
    if along.any():
        yield Act(int(np.argmax(along)), int(np.argmax(along)))


def _waits(s: Seen) -> Iterator[Act]:
    """It comes to a stand, or stands on, as who has stopped before."""
    yield from ACTIONS[Action.STOP](s)
    yield from (Act(first + 1, first + 1) for first, end in runs(_speed(s) < STANDING) if first and end > first + 1)


def _goes_back(s: Seen) -> Iterator[Act]:
    """It goes backwards; on foot it turns back, since nobody walks so."""
    walks = manner_of(s.track.kind) is Manner.WALKS
    yield from _turns_back(s) if walks else ACTIONS[Action.REVERSE](s)


def _parks(s: Seen) -> Iterator[Act]:
    """It comes to stand outside the ego's lane, or aside of the line on which it came."""
    for once in ACTIONS[Action.STOP](s):
        at = len(s.drift) - 1 if once.done is None else once.done
        if once.done is None or abs(s.drift[at]) > DRIFTED or abs(s.offset[at]) > OUTSIDE:
            yield once


def _leaves_road(s: Seen) -> Iterator[Act]:
    """It comes to stand so far aside of its line that all of it is outside its lane, and stays so."""
    aside = np.abs(s.drift)
    wholly = aside > OUT_OF_LANE + 0.5 * s.track.width
    if not wholly[-1]:
        return
    off = int(np.flatnonzero(~wholly)[-1]) + 1 if not wholly.all() else 0
    began = int(np.flatnonzero(aside[: off + 1] <= ON_LINE)[-1]) if (aside[: off + 1] <= ON_LINE).any() else 0
    stands = np.flatnonzero(np.abs(s.track.speed[off:]) < STANDING)
    yield Act(began, off + int(stands[0]) if stands.size else None)


def _spins(s: Seen) -> Iterator[Act]:
    """It slides on and turns away from where it goes."""
    dx, dy = slopes(s.track.x), slopes(s.track.y)
    turned = np.abs(np.remainder(s.track.heading - np.arctan2(dy, dx) + np.pi, 2 * np.pi) - np.pi)
    sliding = np.flatnonzero((turned > SPUN) & (np.abs(s.track.speed) > SLID) & (s.track.speed > 0.0))
    if sliding.size:
        round_ = sliding[turned[sliding] > 2.0 * SPUN]
        yield Act(int(sliding[0]), int(round_[0]) if round_.size else None)


def follows(s: Seen) -> Iterator[Act]:
    """It goes behind somebody for a while; under way at the end if it does so then, after a third of that."""
    lead = before(s)
    behind = (lead < 0.0) & (lead > -np.maximum(FOLLOWS, FREE * _speed(s))) & (_speed(s) > STANDING)
    run = np.flatnonzero(behind)
    if run.size >= FOLLOWED:
        yield Act(int(run[0]), int(run[FOLLOWED - 1]))
    elif 3 * run.size >= FOLLOWED and behind[-1]:
        yield Act(int(run[0]), None)


ACTS: Mapping[Said, Callable[[Seen], Iterable[Act]]] = by_act(
    {
        Tempo.STANDS: _stands_at_first,
        Tempo.WAITS: _waits,
        Tempo.HALTS: ACTIONS[Action.STOP],
        Said.LOSE_CONTROL: _spins,
        Tempo.LIES: ACTIONS[Action.STOP],  # that it lies then, no track tells
        Tempo.BRAKES: _brakes,
        Tempo.SLOWS: _slows_down,
        Tempo.PAUSES: ACTIONS[Action.HESITATE],
        Tempo.BACKS: _goes_back,
        Tempo.GAINS: accelerates,
        Tempo.SETS_OFF: _sets_off,
        Heads.ALONG: _moves_on,
        Heads.THROUGH: _goes_straight,
        Heads.BEHIND: follows,
        Heads.CLOSE: ACTIONS[Action.TAILGATE],
        Heads.LEVEL: _keeps_level,
        Heads.BY: ACTIONS[Action.OVERTAKE],
        Heads.ACROSS: _crosses,
        Heads.IN: enters,
        Heads.FROM_EDGE: ACTIONS[Action.PULL_OUT],
        Heads.BEFORE: _cuts_in,
        Heads.MERGES: _any_change,
        Heads.OVER: lambda s: _not_turning_off(s, _any_change(s)),
        Heads.OUT: lambda s: _not_turning_off(s, ACTIONS[Action.CHANGE_LANE](s)),
        Heads.OFF: lambda s: _turns_once(s, _exits(s)),
        Heads.EDGE: _parks,
        Said.LEAVE_ROAD: _leaves_road,
        Heads.ASIDE: lambda s: _not_turning_off(s, ACTIONS[Action.SWERVE](s)),
        Heads.DRIFTS: drifts,
        Heads.SWINGS: lambda s: _not_turning_off(s, ACTIONS[Action.WEAVE](s)),
        Heads.ROUND: _turns_round,
        Heads.BACK: _turns_back,
        Said.TURN_LEFT: lambda s: _turns_once(s, ACTIONS[Action.TURN_LEFT](s)),
        Said.TURN_RIGHT: lambda s: _turns_once(s, ACTIONS[Action.TURN_RIGHT](s)),
        Said.OPEN_DOOR: _opens,
        Said.DROP_LOAD: ACTIONS[Action.STOP],
    }
)
"""When somebody is seen to do something: as all acts of its trait are seen, or as its own row says, which comes first.

Each act has one; `seen_by` is told of one that has not.
"""


def seen_by(act: Said) -> Callable[[Seen], Iterable[Act]]:
    """What sees an act.

    Raises:
        ChatSceneError: Nothing does yet: it is a new act, whose trait has no row.
    """
    if act not in ACTS:
        raise ChatSceneError(
            f"no test on tracks tells whether somebody does {act}: give ACTS in program/doing.py a row for it, or its"
            " row in terms/vocabulary.py a trait that has one"
        )
    return ACTS[act]


def passes(s: Seen) -> Iterator[Act]:
    """It gets by somebody who goes its way, seen along that one's own heading: from behind until it is ahead of it."""
    cos, sin = np.cos(s.ego.heading), np.sin(s.ego.heading)
    ahead = (s.track.x - s.ego.x) * cos + (s.track.y - s.ego.y) * sin
    reach = (s.ego.length + s.track.length) / 2
    behind = np.flatnonzero(ahead < 0.0)
    if not behind.size:
        return
    began = int(behind[0])
    by = np.flatnonzero(ahead[began:] > reach)
    lowest = began + int(np.argmin(ahead[began : began + int(by[0]) + 1 if by.size else None]))
    if by.size:
        done = began + int(by[0])
        yield Act(max(lowest, _pulls_out(s, done)), done)
    elif ahead[-1] > ahead[lowest] + reach:
        yield Act(max(lowest, _pulls_out(s, len(ahead) - 1)), None)


def _pulls_out(s: Seen, done: int) -> int:
    """The step at which somebody leaves its line who is past another at one, and beside that line; 0 of who keeps it.

    Before that it may have been as near behind as ever.
    """
    aside = np.abs(s.drift[: done + 1])
    beside = np.flatnonzero(aside > DRIFTED)
    if not beside.size:
        return 0
    on_line = np.flatnonzero(aside[: beside[0]] < ON_LINE)
    return int(on_line[-1]) if on_line.size else 0


TO_SOMEBODY: Mapping[Said, Callable[[Seen], Iterable[Act]]] = by_act(
    {
        Heads.BEHIND: follows,
        Heads.CLOSE: ACTIONS[Action.TAILGATE],
        Heads.LEVEL: _keeps_level,
        Heads.BY: passes,
    }
)
"""What is done to another than the ego, seen with that one in the place of the ego."""


def gone_back(s: Seen, once: Act) -> Array:
    """(1,) [m], how far somebody backs up since a deed began."""
    return -s.track.speed[once.began :].clip(max=0.0).sum(keepdims=True) * s.dt


def room_left(s: Seen, once: Act, there: int) -> Array:
    """(T,) [m], the room between the ego and who comes in before it, from when it does to a step, when it is there."""
    done = once.done or 0
    return s.lead[done : max(there, done) + 1] - (s.ego.length + s.track.length) / 2


def stood(s: Seen, once: Act) -> tuple[int, int]:
    """The first time without a break that somebody stands since a deed began: its first step, and the one after it."""
    still = np.abs(s.track.speed) < STANDING
    ahead = np.flatnonzero(still[once.began :])
    if not ahead.size:
        return once.began, once.began
    first = once.began + int(ahead[0])
    goes = np.flatnonzero(~still[first:])
    return first, first + int(goes[0]) if goes.size else len(still)


def gone_aside(s: Seen, once: Act) -> Array:
    """(1,) [m], how far somebody leaves its line since a deed began, until it goes back toward that."""
    began = float(s.drift[once.began])
    aside = np.abs(s.drift[once.began :] - (began if abs(began) > ON_LINE else 0.0))
    farthest = np.maximum.accumulate(aside)
    back = farthest - aside > BACK_ASIDE
    if once.done is not None:
        back[: once.done - once.began] = False
    return farthest[[int(np.argmax(back)) if back.any() else -1]]


def moved_left(s: Seen, once: Act) -> float:
    """How far to the left [m] of the ego, at its start, somebody goes by what is done."""
    end = once.done if once.done is not None else len(s.drift) - 1
    against = math.cos(float(s.facing[once.began])) < 0.0
    return float(s.drift[end] - s.drift[once.began]) * (-1.0 if against else 1.0)
