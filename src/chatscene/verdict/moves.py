"""What somebody's way across the road is called: only what its track shows of it, against the ego's lane and road.

What the judge sees may be one movement in several ways, or the ego's own. Here each movement has one name, of which all
must hold: a road user that keeps its line makes no movement; one that was never in the ego's lane does not leave it.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from chatscene.measure.severity import in_kmh
from chatscene.program.deeds import STANDING, TURNING, Act
from chatscene.program.doing import ACTS, GOES_WITH, OUTSIDE, turned_by
from chatscene.program.lateral import LANE
from chatscene.program.watching import ALONG, Seen, in_frame
from chatscene.terms.arrays import Array
from chatscene.terms.route import Route
from chatscene.terms.scenario import Site
from chatscene.terms.vocabulary import ASIDE, SWINGS, Heads, acts_of
from chatscene.terms.vocabulary import Act as Said
from chatscene.verdict.told import Told

BESIDE = 3 * LANE  # [m] aside of the ego's lane at most is who drives on its road
NEXT = 1.5 * LANE  # [m] aside of it at most is who drives in the next lane
BEGUN = 0.3  # [m] that somebody moves aside at least who has begun to …
MOVED = 1.0  # … and who comes in …
OVER = 2.0  # … or has changed lanes
BEFORE = 1.0  # [s] before it is seen to begin, when it went along its line yet
SWUNG = 0.5  # [m] that it is moved aside and back


@dataclass(frozen=True, eq=False)
class _Move:
    """One time that somebody does something, beside the ego's lane and road."""

    seen: Seen
    once: Act
    round_about: bool

    @cached_property
    def end(self) -> int:
        """The step at which it is done, or the last."""
        return len(self.seen.track.x) - 1 if self.once.done is None else self.once.done

    @property
    def begins(self) -> int:
        return self.once.began

    def _there(self, row: Array) -> Array:
        return row[self.begins : self.end + 1]

    @cached_property
    def with_ego(self) -> Array:
        """The cosine of its heading against the ego's way, at each of its steps."""
        line = self.seen.line
        return np.cos(self._there(self.seen.track.heading - line.headings_at(self.seen.at.clip(0.0, line.length))))

    @cached_property
    def moved(self) -> float:
        """How far [m] it moves aside: against the ego's first lane and, if it goes along, against its own line.

        An ego that changes lanes comes nearer to who keeps its own; a road that bends turns who keeps to it.
        """
        over = float(np.ptp(self._there(self.seen.aside)))
        if abs(float(self.with_ego[0])) < GOES_WITH:
            return over
        track, k = self.seen.track, max(self.begins - round(BEFORE / self.seen.dt), 0)  # it may have begun to turn
        _, straight = in_frame(track, track.x[k], track.y[k], track.heading[k])
        return min(over, float(np.ptp(self._there(straight))))

    @property
    def changed(self) -> float:
        """How far [m] aside it is when it is done of where it began; positive to the left of the ego."""
        over = float(self.seen.aside[self.end] - self.seen.aside[self.begins])
        return math.copysign(min(abs(over), self.moved), over)

    def least(self, done: float, begun: float = BEGUN) -> float:
        """The least [m] that counts: for a movement that is done, or for one that has only begun."""
        return begun if self.once.done is None else done

    @property
    def on_road(self) -> bool:
        """Whether it goes along the ego's road, or against it, all the time; elsewhere no lanes are known."""
        before_end = self._there(self.seen.at) < self.seen.line.length
        near = np.abs(self._there(self.seen.aside)) <= BESIDE
        return bool((before_end & near & (np.abs(self.with_ego) >= GOES_WITH)).all())

    @property
    def same_way(self) -> bool:
        return self.on_road and bool((self.with_ego > 0.0).all())


def _turns(m: _Move) -> bool:
    return not m.round_about and bool(turned_by(m.seen)[m.end] > TURNING)


def _overtakes(m: _Move) -> bool:
    near = abs(float(m.seen.aside[m.end])) <= BESIDE and m.with_ego[-1] > GOES_WITH
    return near and bool(m.seen.lead[m.begins] < 0.0)


def _cuts_in(m: _Move) -> bool:
    next_lane = abs(float(m.seen.aside[m.begins])) <= NEXT
    return m.same_way and next_lane and m.moved >= m.least(MOVED) and bool(m.seen.lead[m.end] > 0.0)


def _cuts_out(m: _Move) -> bool:
    in_lane = abs(float(m.seen.offset[m.begins])) < LANE / 2 and m.seen.lead[m.begins] > 0.0
    return bool(in_lane) and m.same_way and abs(m.changed) >= m.least(OVER, SWUNG)


def _enters(m: _Move) -> bool:
    """Who comes in goes along the lane then, or comes to stand in it; who goes on over it crosses."""
    s, after = m.seen, slice(m.end, None)
    way = s.track.heading - s.line.headings_at(s.at.clip(0.0, s.line.length))
    goes_along = (np.abs(s.offset) < LANE / 2) & (np.abs(np.cos(way)) > math.cos(ALONG))
    stays = bool(goes_along[after].any()) or abs(float(s.track.speed[-1])) < STANDING
    return stays and m.moved >= m.least(MOVED)


def _swings(m: _Move) -> bool:
    return m.on_road and m.moved >= SWUNG


MOVEMENTS: dict[Said, Callable[[_Move], bool]] = {
    Said.TURN_LEFT: _turns,
    Said.TURN_RIGHT: _turns,
    Said.U_TURN: _turns,
    Said.PULL_OUT: lambda m: m.moved >= m.least(MOVED),
    Said.OVERTAKE: _overtakes,
    Said.CUT_IN: _cuts_in,
    Said.CUT_OUT: _cuts_out,
    Said.ENTER: _enters,
    Said.CROSS: lambda m: m.moved >= m.least(MOVED),
    Said.LANE_CHANGE: lambda m: m.on_road and abs(m.changed) >= m.least(OVER, SWUNG),
    Said.WEAVE: _swings,
    Said.SWERVE: _swings,
    Said.DRIFT: _swings,
}
"""Ways across the road, and what must hold of each; one movement may look like several, of which the first is told."""
ALSO = (Said.REVERSE, Said.TURN_BACK, Said.TAILGATE)
"""What is told beside a movement."""
_ONCE_DONE = ASIDE | SWINGS | frozenset(ALSO)
"""What is told once it is done: until then it may be anything."""
_FROM_BESIDE = acts_of(Heads.ACROSS, Heads.IN)
"""What is begun from beside the road, perhaps from afar."""


def moves(who: str, may: frozenset[Said], seen: Seen, route: Route) -> Iterator[Told]:
    """What somebody else does beside changing speed: each movement across the road once, and what goes with it.

    Args:
        who: What it is called.
        may: What one of its kind can do.
        seen: As the ego sees it.
        route: The ego's.
    """
    told = list[tuple[Said, Act]]()
    for act in (*MOVEMENTS, *ALSO):
        for once in ACTS[act](seen) if act in may else ():
            move = _Move(seen, once, route.site is Site.ROUNDABOUT)
            again = any(_overlap(once, other) and (it is act or {it, act} <= MOVEMENTS.keys()) for it, other in told)
            shown = MOVEMENTS[act](move) if act in MOVEMENTS else True
            if again or not shown or (once.done is None and act in _ONCE_DONE):
                continue
            told.append((act, once))
            yield _told(who, act, move)


def _told(who: str, act: Said, move: _Move) -> Told:
    seen, once = move.seen, move.once
    if act is Said.CROSS:
        once = _to_the_other_side(seen, once)
    if act in _FROM_BESIDE:  # who comes from afar is on its way until then
        far = np.flatnonzero(np.abs(seen.offset[: move.end + 1]) > BESIDE)
        once = replace(once, began=max(once.began, int(far[-1]) if far.size else 0))
    what = _WORDS[act](move) if act in _WORDS else act.meaning
    undone = ", unfinished at the end" if once.done is None else ""
    fast = in_kmh(abs(float(seen.track.speed[once.began])))
    until = None if once.done is None else once.done * seen.dt
    return Told(at=once.began * seen.dt, until=until, who=who, what=f"{what} ({act}){undone}, at {fast} first")


def _to_the_other_side(seen: Seen, once: Act) -> Act:
    """A crossing until it is beyond the ego's lane on the other side, which one may never be."""
    over = np.flatnonzero(seen.offset[once.began :] * np.sign(seen.offset[once.began]) < -OUTSIDE)
    return replace(once, done=once.began + int(over[0]) if over.size else None)


def _side(left: float) -> str:
    return "left" if left > 0.0 else "right"


def _in_front(move: _Move) -> str:
    if move.once.done is None:
        return "comes from the next lane toward the ego's, ahead of it"
    seen = move.seen
    room = float(seen.lead[move.end]) - (seen.ego.length + seen.track.length) / 2
    return f"comes from the next lane into the ego's, {max(room, 0.0):.0f} m in front of it"


def _changes_lanes(move: _Move) -> str:
    return f"changes lanes to its {_side(move.changed * float(move.with_ego[0]))}"


def _comes_in(move: _Move) -> str:
    comes_from = abs(float(move.seen.offset[move.begins]))
    return "enters the roundabout" if move.round_about and comes_from > NEXT else Said.ENTER.meaning


_WORDS: dict[Said, Callable[[_Move], str]] = {
    Said.OVERTAKE: lambda _: "overtakes the ego",
    Said.CUT_IN: _in_front,
    Said.CUT_OUT: lambda m: f"leaves the ego's lane to the {_side(m.changed)}",
    Said.ENTER: _comes_in,
    Said.CROSS: lambda m: f"crosses the ego's way from its {_side(float(m.seen.offset[m.begins]))}",
    Said.LANE_CHANGE: _changes_lanes,
}
"""What of an act holds of this movement, where its meaning in a sentence says more than a track shows."""


def _overlap(one: Act, other: Act) -> bool:
    late = 10**9
    return one.began <= (late if other.done is None else other.done) and other.began <= (
        late if one.done is None else one.done
    )
