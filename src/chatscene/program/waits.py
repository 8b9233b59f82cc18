"""Whether a deed begins when it was said to: after or while another, so long after that, or with the ego so near."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import numpy as np

from chatscene.program.amounts import settled
from chatscene.program.contacts import is_of
from chatscene.program.deeds import Act
from chatscene.program.finding import Finding
from chatscene.program.meaning import TOGETHER
from chatscene.program.measured import SLACK, SLACK_LENGTH, SLACK_TIME
from chatscene.program.near import how_near
from chatscene.program.watching import Seen, watch
from chatscene.terms.amount import Duration
from chatscene.terms.episode import Episode
from chatscene.terms.route import Route
from chatscene.terms.situation import Deed, Situation, When
from chatscene.terms.vocabulary import ALONG_THE_ROAD, COMES_IN, Heads, acts_of

_OVER = acts_of(Heads.BEFORE, Heads.OVER, Heads.OUT, Heads.MERGES, Heads.IN)
EDGE = 4.0  # [m] from the ego's line: who is so near comes into its lane


@dataclass(frozen=True, slots=True)
class Waiting:
    """What deeds wait for in one drive.

    Attributes:
        situation: What was said.
        episode: What happened.
        route: The ego's.
        contact: The step of the first contact, after which nothing is judged.
    """

    situation: Situation
    episode: Episode
    route: Route
    contact: int | None

    def of(self, path: str, deed: Deed, once: Act, seen: Seen, done: Mapping[str, Act]) -> Iterator[Finding]:
        """What is seen of when a deed begins.

        Args:
            path: Of when it does.
            deed: What was said.
            once: When it was done.
            seen: Who does it.
            done: When all others were, by who does each and its number or act.
        """
        when = deed.when
        assert when is not None
        slack = TOGETHER / seen.dt
        for name, reference in (("after", when.after), ("during", when.during)):
            other = None if reference is None else done.get(reference)
            if reference is None or other is None:
                continue  # which has a finding of its own
            right = once.began >= other.began - slack
            lasts = reference.partition(".")[0] == path.split(".")[1] or self.situation.deed(reference).act.row.lasting
            if name == "during" and other.done is not None and not lasts:  # else it is under way until this begins
                right = right and once.began <= other.done + slack
            told = f"said {name} {reference}, it begins {(once.began - other.began) * seen.dt:.1f} s after that begins"
            yield Finding(path=f"{path}.{name}", shown=right, told=told, at=once.began * seen.dt)
        if when.delay is not None and (since := self._since(path, when, done, seen)) is not None:
            yield _later(f"{path}.delay", when.delay, *((once.began - step) * seen.dt for step in since))
        if when.ego_within is not None and (whom := self._whom(when, seen)) is not None:
            yield self._near(path, deed, once, seen, whom)

    def _since(self, path: str, when: When, done: Mapping[str, Act], seen: Seen) -> tuple[int, int] | None:
        """The steps from which on a delay is counted, the latest first; None where that was not seen.

        Who comes over to another lane is there when it is on its line, and for others when it is over the edge.
        """
        if when.during is not None:
            other = done.get(when.during)
            return None if other is None else (other.began, other.began)
        _, who, _, number, _ = path.split(".")
        before = when.after or (f"{who}.{int(number) - 1}" if int(number) else "")
        if not before:
            return 0, 0  # the beginning of the scene
        other = done.get(before)
        if other is None or other.done is None:
            return None
        own = before.partition(".")[0] == who and self.situation.deed(before).act in _OVER
        ends = max(other.done, settled(seen, other)) if own else other.done
        return ends, other.done

    def _whom(self, when: When, seen: Seen) -> Seen | None:
        """To whom the ego is to be near; None if that one is not there, which has a finding of its own."""
        if when.of is None:
            return seen
        tracks = (track for track in self.episode.tracks if is_of(track.actor, when.of))
        return next((watch(self.episode, self.route, track, self.contact) for track in tracks), None)

    def _near(self, path: str, deed: Deed, once: Act, seen: Seen, whom: Seen) -> Finding:
        """How near the ego is to somebody when a deed begins."""
        assert deed.when is not None
        near = deed.when.ego_within
        assert near is not None
        step = _comes(deed, once, seen)
        seconds = isinstance(near, Duration)
        most = near.high if math.isfinite(near.high) else near.low
        leaves = deed.act not in ALONG_THE_ROAD
        nearest = min(how_near(whom, step, in_seconds=seconds, leaves=leaves), key=lambda one: abs(one - most))
        right = nearest <= most * (1 + SLACK) + 2 * (SLACK_TIME if seconds else SLACK_LENGTH)
        told = f"said within {near}, the ego is at {nearest:.1f}"
        return Finding(path=f"{path}.ego_within", shown=right, told=told, at=once.began * seen.dt)


def _later(path: str, said: Duration, least: float, most: float) -> Finding:
    """Whether something begins so long after another, of which it is seen from when to when that ended."""
    aim = said.low if math.isfinite(said.low) else said.high
    slack = max(SLACK_TIME, SLACK * aim)
    right = most >= said.low - slack and least <= said.high + slack
    return Finding(path=path, shown=right, told=f"said {said}, it begins {least:.1f} s later")


def _comes(deed: Deed, once: Act, seen: Seen) -> int:
    """The step at which a deed is seen to begin: of who comes into the ego's lane, when it comes to its edge."""
    if deed.act not in COMES_IN:
        return once.began
    near = np.flatnonzero(np.abs(seen.offset[once.began :]) < EDGE)
    return once.began + int(near[0]) if near.size else once.began
