"""Whether somebody does what was said before the ego has gone by.

Who is ahead of an ego, comes toward it or crosses its way is met once. What it does when all of it is behind the ego is
done to nobody: an ego that looks ahead need not answer it. So of each deed there is a moment at which it tells, and at
that a part of the body must not yet be behind the ego's tail.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from chatscene.program.deeds import Act
from chatscene.program.finding import Finding, Late
from chatscene.program.watching import Seen
from chatscene.simulate.boxes import Boxes
from chatscene.terms.arrays import Array
from chatscene.terms.episode import Track
from chatscene.terms.situation import EGO, Deed, Other, Situation
from chatscene.terms.vocabulary import (
    ASIDE,
    COMES_IN,
    COMES_OVER,
    LETS_GO,
    LOSES,
    SLOWS,
    SWINGS,
    Heads,
    Tempo,
    Where,
    acts_of,
)

COMES = COMES_IN | COMES_OVER | ASIDE | SWINGS | acts_of(Heads.TURNS, Heads.ROUND)
"""What leads into the ego's way: it tells when the body is in that, or once done where it never is."""
ENDS = acts_of(Tempo.HALTS, Tempo.LIES)
"""What tells once it is done: somebody stands or lies then. All else tells as it begins."""
PASSES = acts_of(Tempo.WAITS, Heads.BY, Heads.LEVEL, Heads.BEHIND, Heads.CLOSE, Heads.OUT, Heads.OFF, Heads.EDGE)
"""What is done from behind, or to let the ego by."""
ANSWERS = SLOWS | ASIDE
"""What somebody does for what is before it."""
ANSWERED = COMES | LOSES | acts_of(Tempo.LIES, Tempo.BACKS, Heads.OUT)
"""What is answered so."""
FOLLOWS = frozenset((Where.BEHIND, Where.BEHIND_BESIDE))
"""Places from which somebody acts behind the ego."""


def gone_by(one: Other, seen: Seen, done: Mapping[str, Act], *, touched: bool = False) -> Finding | None:
    """That the ego has gone by when somebody does what was said, of its first such deed; None without one.

    Args:
        one: Who.
        seen: What is seen of it.
        done: When it did each of its deeds, by its name and the number of the deed.
        touched: Whether it was said to touch the ego, by which what it lets go may come beside that.
    """
    if one.starts.where in FOLLOWS:
        return None
    by = past(seen.ego, seen.track)
    for k, deed in enumerate(one.does):
        once = done.get(f"{one.id}.{k}")
        before = {was.act for was in one.does[:k] if deed.when is None}
        goes_on = deed.act in acts_of(Tempo.SETS_OFF) and not before.isdisjoint(ENDS)
        goes_on = goes_on or not before.isdisjoint(acts_of(Tempo.WAITS))  # which it does once it has let the ego by
        if once is None or goes_on or not _is_for_ego(one, deed):
            continue
        step = _tells(deed, once, seen)
        over = by + seen.ego.length if deed.act in LETS_GO and not touched else by  # its nose is by what is let go
        if over[step] > 0.0:
            since = step - int(np.argmax(over[step::-1] <= 0.0)) if (over[:step] <= 0.0).any() else 0
            late = Late(seconds=(step - since) * seen.dt, metres=-float(over[step]))
            told = f"the ego has gone by {late.seconds:.1f} s before it does its {deed.act}"
            return Finding(path=f"encounter.{one.id}", shown=False, told=told, at=step * seen.dt, late=late)
    return None


def has_passed(
    situation: Situation, one: Other, seen: Seen, done: Mapping[str, Act], others: Mapping[str, Seen]
) -> Finding | None:
    """That somebody has passed another by when it slows or swerves for what that one does; None if it has not.

    It answers what is before it. Who was behind it, or beside it from the first, is no matter.

    Args:
        situation: What was said.
        one: Who.
        seen: What is seen of it.
        done: When others did each of their deeds, by the name and the number of the deed.
        others: What is seen of all others, by ids.
    """
    for k, deed in enumerate(one.does):
        once = done.get(f"{one.id}.{k}")
        if once is None or deed.act not in ANSWERS or deed.when is None:
            continue
        for reference in (deed.when.after, deed.when.during):
            who = (reference or "").partition(".")[0]
            if reference is None or who == one.id or situation.deed(reference).act not in ANSWERED:
                continue
            track = seen.ego if who == EGO else others[who].track if who in others else None
            if track is None:
                continue
            by = past(seen.track, track)
            if by[0] < -(seen.track.length + track.length) and by[once.began] > 0.0:  # all of it was before it
                since = once.began - int(np.argmax(by[once.began :: -1] <= 0.0))
                late = Late(seconds=(once.began - since) * seen.dt, metres=float(by[once.began]))
                whom = "the ego" if who == EGO else who
                told = f"it has passed {whom} {late.seconds:.1f} s before it does its {deed.act} for that"
                return Finding(path=f"encounter.{one.id}", shown=False, told=told, at=once.began * seen.dt, late=late)
    return None


def _is_for_ego(one: Other, deed: Deed) -> bool:
    """Whether a deed is one that the ego is to have before it; who is level with it falls behind as it loses speed."""
    if deed.act in PASSES or deed.done_to != EGO or (deed.act.row.lasting and deed.when is None):
        return False
    return one.starts.where is not Where.BESIDE or deed.act in COMES


def _tells(deed: Deed, once: Act, seen: Seen) -> int:
    """The step at which a deed tells; the last, if a contact came before it was done."""
    done = len(seen.track.x) - 1 if once.done is None else once.done
    if deed.act in LETS_GO:
        return once.began  # what is let go has a body of its own
    if deed.act in ENDS:
        return done
    if deed.act not in COMES:
        return once.began
    turned = seen.facing[once.began :]
    half = 0.5 * (seen.track.length * np.abs(np.sin(turned)) + seen.track.width * np.abs(np.cos(turned)))
    inside = np.flatnonzero(np.abs(seen.offset[once.began :]) <= half + 0.5 * seen.ego.width)
    return once.began + int(inside[0]) if inside.size else done


def past(ego: Track, other: Track) -> Array:
    """(T,) How far [m] the ego is past somebody at each of its steps: from the foremost part of that to its own tail.

    Less than 0 until the whole body is behind the ego. At the end it is as the ego is then.
    """
    return behind(ego, other)[0]


def behind(ego: Track, other: Track) -> tuple[Array, Array]:
    """The same, and (T,) the cosine of how far somebody is turned away from the ego."""
    boxes = Boxes.of(ego)
    x, y, heading, cos, sin = ego.x, ego.y, ego.heading, boxes.cos, boxes.sin
    if len(other.x) != len(ego.x):
        last = np.arange(len(other.x)).clip(max=len(ego.x) - 1)
        x, y, heading, cos, sin = (column[last] for column in (x, y, heading, cos, sin))
    ahead = (other.x - x) * cos + (other.y - y) * sin
    turned = other.heading - heading
    along = np.cos(turned)
    reach = other.length * np.abs(along) + other.width * np.abs(np.sin(turned))
    return np.asarray(-ahead - 0.5 * (ego.length + reach)), along
