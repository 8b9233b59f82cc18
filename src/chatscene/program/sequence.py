"""Deeds in the order in which they were said: which of the times that one is seen may be meant."""

from __future__ import annotations

from collections.abc import Iterator
from collections.abc import Sequence as Times
from dataclasses import dataclass, field
from typing import Self

import numpy as np

from chatscene.program.amounts import ends_aside
from chatscene.program.deeds import LOSING, Act
from chatscene.program.meaning import TOGETHER
from chatscene.program.watching import Seen
from chatscene.terms.situation import Other
from chatscene.terms.vocabulary import ASIDE, COMES_IN, LOSES, SIDEWAYS, SWINGS, Heads, Tempo, acts_of
from chatscene.terms.vocabulary import Act as Said

MARKED = 0.5  # of the speed that is lost when most is
BRAKES = acts_of(Tempo.BRAKES)
TURNS = acts_of(Heads.TURNS, Heads.ROUND)
OVER = SIDEWAYS | COMES_IN
BY = acts_of(Heads.BY)
CROSSES = acts_of(Heads.ACROSS)
ONCE_DONE = {
    **dict.fromkeys(OVER, OVER),  # of one movement not two are seen
    **dict.fromkeys(ASIDE | SWINGS, OVER | BY),
    **dict.fromkeys(BY, ASIDE | SWINGS),
    **dict.fromkeys(TURNS, acts_of(Tempo.SLOWS, Tempo.BRAKES)),
}
"""What follows a deed only once that is done: who slows for a turn does not slow after it."""
FOR_A_TURN = LOSES | acts_of(Tempo.WAITS, Tempo.LIES)
"""Deeds that cannot be told from slowing for a turn while somebody still turns."""


@dataclass(slots=True)
class Sequence:
    """What somebody has been seen to do so far, deed by deed as they were said.

    Attributes:
        seen: Who.
        marked: Whether braking is all that it is said to lose speed by, once and without a moment of its own.
        said: What it has been seen to do of what ends, the last one last.
        times: When it did that, and what lasts.
        began: The step by which all that ends has begun.
        ended: The step by which it is done.
        turned: The step by which it has turned; 0 if that was not said.
    """

    seen: Seen
    marked: bool = False
    said: list[Said] = field(default_factory=list[Said])
    times: list[Act] = field(default_factory=list[Act])
    began: int = 0
    ended: int = 0
    turned: int = 0
    _ends: list[tuple[Said, float]] = field(default_factory=list[tuple[Said, float]])

    @classmethod
    def of(cls, one: Other, seen: Seen) -> Self:
        """Of somebody who has not begun."""
        loses = [deed for deed in one.does if deed.act in LOSES | FOR_A_TURN | TURNS]
        return cls(seen=seen, marked=len(loses) == 1 and loses[0].act in BRAKES and loses[0].when is None)

    @property
    def _slack(self) -> float:
        return TOGETHER / self.seen.dt

    def free(self, act: Said) -> float:
        """The step from which on a movement may be another one than those of which deeds were said before."""
        return max((end for said, end in self._ends if act in ONCE_DONE.get(said, ())), default=0.0)

    def since(self, act: Said) -> int:
        """The step from which on a deed is looked for, of which a part may have been done before."""
        return max(self.began, round(self.free(act)))

    def may_be(self, act: Said, once: Act) -> bool:
        """Whether a time that a deed is seen is none at which another was seen: one time seen is one deed."""
        return once not in self.times or act is Said.STAND

    def after(self, act: Said, found: Times[Act], *, during: bool = False) -> list[Act]:
        """The times that a deed neither begins before those that were said before it nor is done before them.

        Within a second either may be the first; what was said to be done while another deed is may be done first. Who
        is said to lose speed once, by braking, is meant to do so when it brakes most.
        """
        if act.row.lasting and act is not Said.STAND:
            return list(found)
        free = self.free(act)
        under_way = max(free, float(self.turned)) if act in FOR_A_TURN else free
        times = [once for once in found if once.began >= (under_way if once.done is None else free)]
        if act in BRAKES and self.marked:
            times = list(_most_marked(self.seen, times))
        return [once for once in times if once.began >= self.began - self._slack and self._is_last(once, during=during)]

    def _is_last(self, once: Act, *, during: bool) -> bool:
        """Whether a deed is not done before those that were said before it; on the road, who crosses may halt."""
        on_the_road = bool(self.said) and self.said[-1] in CROSSES and self._is_half_way(once.began)
        return during or on_the_road or once.done is None or once.done >= self.ended - self._slack

    def _is_half_way(self, step: int) -> bool:
        """Whether somebody has come more than half of the way to the ego's line by a step."""
        aside = np.abs(self.seen.offset)
        return bool(aside[step] < 0.5 * aside[0])

    def add(self, act: Said, once: Act) -> None:
        """Go on from a deed, at the time that is meant."""
        done = once.done or 0
        self.times.append(once)
        self._ends.append((act, ends_aside(self.seen, once) if act in OVER else done - self._slack))
        if act in TURNS:
            self.turned = len(self.seen.track.x) if once.done is None else done
        if not act.row.lasting:
            self.said.append(act)
            self.began, self.ended = max(self.began, once.began), max(self.ended, done)


def _most_marked(s: Seen, times: Times[Act]) -> Iterator[Act]:
    """Of the times that somebody brakes, those in which it loses half as much speed as in the one with most, or more.

    Who is said to brake once is meant to do so when it does most of all.
    """
    lost = [_loses(s, once) for once in times]
    yield from (once for once, much in zip(times, lost, strict=True) if much >= MARKED * max(lost))


def _loses(s: Seen, once: Act) -> float:
    """How much speed [m/s] is lost from when somebody begins to brake, gently perhaps, until it only rolls out."""
    speed, hard = np.abs(s.track.speed), once.began if once.done is None else once.done
    rolls = np.flatnonzero(np.diff(speed[hard:]) > -LOSING * s.dt)
    return float(speed[once.began] - speed[hard + int(rolls[0]) if rolls.size else -1])
