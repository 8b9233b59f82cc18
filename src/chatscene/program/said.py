"""What was said of a deed as a judge needs it: for what it waits, to which side it goes, and what no track tells."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from chatscene.program.deeds import Act
from chatscene.program.doing import moved_left
from chatscene.program.meaning import TOGETHER
from chatscene.program.watching import Seen
from chatscene.terms.situation import EGO, Deed, Other
from chatscene.terms.vocabulary import ASIDE, Breach, Heads, Manner, Side, acts_of

LEAVES_LINE = ASIDE | acts_of(Heads.EDGE)
HARD = 3.0  # [m/s²] of braking: whoever was said to brake by less is seen to slow down


def waits_for_others(one: Other) -> bool:
    """Whether a deed of somebody waits for one of somebody else."""
    return not {one.id, EGO}.issuperset(_waited_for(one))


def waits_for_ego(one: Other) -> bool:
    """Whether a deed of somebody waits for one of the ego."""
    return EGO in _waited_for(one)


def _waited_for(one: Other) -> Iterator[str]:
    """For whom deeds of somebody wait, by ids."""
    waits = (deed.when for deed in one.does if deed.when is not None)
    yield from (name.partition(".")[0] for when in waits for name in (when.after, when.during) if name is not None)


def due(deed: Deed, once: Act, done: Mapping[str, Act], seen: Seen) -> bool:
    """Whether a time that a deed is seen is one at which it was due, by what it waits for."""
    references = (deed.when.after, deed.when.during) if deed.when is not None else ()
    others = (done[one] for one in references if one is not None and one in done)
    return all(once.began >= other.began - TOGETHER / seen.dt for other in others)


def gently(deed: Deed) -> bool:
    """Whether somebody brakes who was said to lose speed by no more than a watcher calls slowing down."""
    return deed.time is not None or (deed.acceleration is not None and deed.acceleration.low < HARD)


def to_side(deed: Deed, once: Act, seen: Seen) -> bool:
    """Whether somebody who leaves its line does so to the side that was said, if one was."""
    if deed.to is None or deed.act not in LEAVES_LINE:
        return True
    return (moved_left(seen, once) > 0) == (deed.to is Side.LEFT)


def untold(deed: Deed) -> Iterator[str]:
    """What of a deed no track tells."""
    if deed.manner is not None and deed.manner is not Manner.SLANTING:
        yield "manner"
    if deed.breaks in (Breach.STOP_SIGN, Breach.RIGHT_OF_WAY):
        yield "breaks"
