"""What can be: which act from which place, and what can follow what; so that what is refused is refused by a rule.

A row says where an act can be begun from, by whoever has done nothing before that took it elsewhere. An act without a
row can be begun anywhere.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from chatscene.build.place import NEXT_LANE
from chatscene.situations.check import on_another_side
from chatscene.situations.faults import Fault
from chatscene.terms.act_amounts import AMOUNTS
from chatscene.terms.actors import Manner as Moves
from chatscene.terms.amount import Amount
from chatscene.terms.backing import backs
from chatscene.terms.situation import EGO, Deed, Other, Situation, When
from chatscene.terms.vocabulary import (
    ASIDE,
    COMES_IN,
    HALTS,
    LETS_GO,
    PLAIN,
    SLOWS,
    Act,
    EgoRoute,
    Heads,
    Tempo,
    Where,
    acts_of,
    by_act,
)

OFF_ROAD = frozenset(
    (Where.ROADSIDE, Where.DRIVEWAY, Where.CROSSING, Where.EXIT_CROSSING, Where.MEDIAN, Where.KERB, Where.BUS_BAY)
)
_JOINS = frozenset((Where.ON_RAMP, Where.ROUNDABOUT_ENTRY, Where.IN_ROUNDABOUT))
_AGAINST = frozenset((Where.ONCOMING,))
_EDGE = frozenset((Where.KERB, Where.BUS_BAY))
_LANES = NEXT_LANE | _AGAINST | {Where.AHEAD, Where.BEHIND, Where.ARM, Where.ONCOMING_IN_OUR_LANE}

_FROM: dict[Tempo | Heads | Act, frozenset[Where]] = {
    Heads.FROM_EDGE: _EDGE | {Where.DRIVEWAY, Where.AHEAD_BESIDE, Where.ARM, Where.ROUNDABOUT_ENTRY},
    Heads.BEFORE: NEXT_LANE | _JOINS | _AGAINST | _EDGE | {Where.ARM},
    Heads.MERGES: NEXT_LANE | _JOINS | _EDGE | {Where.ARM},
    Heads.IN: NEXT_LANE | _JOINS | OFF_ROAD | _AGAINST | {Where.ARM},
    Heads.BY: frozenset((Where.BEHIND, Where.BEHIND_BESIDE, Where.BESIDE, Where.ONCOMING)),
    Heads.CLOSE: frozenset((Where.BEHIND,)),
    Heads.LEVEL: NEXT_LANE | {Where.ON_RAMP},
    Heads.ACROSS: OFF_ROAD | {Where.ARM, Where.ROUNDABOUT_ENTRY, Where.IN_ROUNDABOUT},
    Heads.OUT: frozenset((Where.AHEAD, Where.BEHIND)),
    Heads.OVER: _LANES - {Where.ARM} | _EDGE | {Where.ON_RAMP},
    Heads.TURNS: _LANES | {Where.DRIVEWAY},
    Heads.BACK: OFF_ROAD | {Where.AHEAD, Where.ARM},
    Act.OPEN_DOOR: _EDGE | {Where.AHEAD, Where.AHEAD_BESIDE, Where.BESIDE, Where.ONCOMING},
    Heads.DRIFTS: frozenset(Where) - OFF_ROAD | _EDGE,
}
FROM = by_act(_FROM)
"""Where an act can be begun from; of one that is done to somebody, where it is done to the ego."""
TO_ANOTHER = by_act(
    {
        Heads.BY: _LANES,
        Heads.CLOSE: _LANES,
        Heads.LEVEL: _LANES,
        Heads.BEFORE: NEXT_LANE | _JOINS | _AGAINST | {Where.AHEAD},
    }
)
"""Where from to somebody else."""
_ON_FOOT = NEXT_LANE - {Where.BEHIND_BESIDE} | {Where.AHEAD}
"""Where somebody on foot can be on the road who crosses it."""
_OURS = {Where.AHEAD, Where.BEHIND, Where.ONCOMING_IN_OUR_LANE}
_LEVEL_WITH = _LANES - {Where.ARM} - _OURS | {Where.KERB, Where.BUS_BAY, Where.ON_RAMP}
"""Where somebody is with whom the ego can be level: not in its own lane."""
_TURNED = acts_of(Heads.ROUND, Heads.BACK, Heads.TURNS, Heads.OFF)
_STILL = HALTS | acts_of(Tempo.WAITS, Tempo.LIES, Heads.EDGE)
_MAY_STAND = _STILL | acts_of(Tempo.BRAKES, Tempo.BACKS, Tempo.PAUSES) | {Act.OPEN_DOOR}
_GOES = SLOWS | PLAIN | acts_of(Tempo.GAINS, Tempo.LIES, Heads.ACROSS)
_OFF = (
    COMES_IN
    | PLAIN
    | acts_of(
        Tempo.SETS_OFF,
        Tempo.GAINS,
        Tempo.BACKS,
        Tempo.STANDS,
        Heads.TURNS,
        Heads.ROUND,
        Heads.BEFORE,
        Heads.OVER,
        Heads.MERGES,
        Heads.BACK,
    )
)
_FALLS_BACK = SLOWS | _STILL | acts_of(Tempo.BACKS)
OVERTAKEN = NEXT_LANE | {Where.AHEAD, Where.KERB, Where.BUS_BAY, Where.ROADSIDE}
"""Where somebody can be whom the ego overtakes."""
_KEEPS_ROOM = acts_of(Heads.BEHIND, Heads.CLOSE, Heads.BEFORE, Heads.BY)
"""By what the distance, or the time, is the room between two."""
_WHERE_IT_STANDS = frozenset(LETS_GO) | acts_of(Tempo.WAITS)
"""What is done standing, too."""


def impossible(situation: Situation) -> Iterator[Fault]:
    """Each deed that cannot be done from where somebody is, or after what was before; sides and numbers of nothing."""
    yield from _of_nothing(situation)
    yield from _of_ego(situation)
    for one in situation.others:
        yield from on_another_side(one, ("others", one.id))
        at = f"others.{one.id}.does"
        stood = False
        for k, deed in enumerate(one.does):
            moved_away = any(other.act in FROM for other in one.does[:k])
            on_foot = one.starts.where in _ON_FOOT and one.kind.moves is Moves.WALKS  # at a lane's edge
            on_foot = on_foot or (one.starts.where is Where.BEHIND and backs(situation))  # where the ego then goes
            crosses = on_foot and deed.act in acts_of(Heads.ACROSS)
            if not (moved_away or crosses) and one.starts.where not in _from(deed):
                places = ", ".join(where for where in Where if where in _from(deed))
                told = f"{deed.act} is not possible from {one.starts.where}, only from {places}"
                yield Fault((f"{at}.{k}.act",), told)
            if stood and deed.act not in _OFF | _WHERE_IT_STANDS:
                yield Fault((f"{at}.{k}.act",), f"a standing road user must set off before it can {deed.act}")
            if k and deed.act is Act.SET_OFF and one.does[k - 1].act not in _MAY_STAND:
                yield Fault(
                    (f"{at}.{k}.act",), f"after {one.does[k - 1].act} it is already moving, so it cannot set-off"
                )
            if stood and deed.act is Act.STAND and deed.time is not None and one.does[k - 1].time is not None:
                yield Fault((f"{at}.{k}.time",), f"it already stands for {one.does[k - 1].time}")
            stood = deed.act in _STILL or (stood and deed.act in _WHERE_IT_STANDS)
        yield from _comes_in_twice(one, at)
        yield from _passes_twice(one, at)
        for k, (before, after) in enumerate(pairwise(one.does), 1):
            if before.act in _TURNED and after.act not in _GOES:
                yield Fault((f"{at}.{k}.act",), f"after {before.act} it is no longer there to {after.act}")


def _of_nothing(situation: Situation) -> Iterator[Fault]:
    """Each number that is 0 of what there is only where it is more; between two there may be no room."""
    for path, said in (("ego.speed", situation.ego.speed), ("road.speed_limit", situation.road.speed_limit)):
        if _is_nothing(said):
            yield Fault((path,), f"{said}: nobody drives at that; of an ego that waits say ego.does: {Act.STAND}")
        elif said is not None and not said.than_ego and said.most <= 0.0:
            yield Fault((path,), f"{said}: that is true of any speed; leave it out or say one above 0")
    for who, does in situation.everybody():
        at = f"{'' if who == EGO else 'others.'}{who}.does"
        for k, deed in enumerate(does):
            rooms = ("distance", "time") if deed.act in _KEEPS_ROOM else ()
            for name in AMOUNTS:
                if name not in rooms and _is_nothing(said := getattr(deed, name)):
                    told = f"nobody goes at that; say {Act.STOP} or {Act.STAND}" if name == "speed" else "that is none"
                    yield Fault((f"{at}.{k}.{name}",), f"{said}: {told}")
            if (
                deed.when is not None
                and _is_nothing(deed.when.ego_within)
                and not _is_passed(situation, who, deed.when)
            ):
                yield Fault((f"{at}.{k}.when.ego_within",), f"{deed.when.ego_within}: then it is too late")


def _is_passed(situation: Situation, who: str, when: When) -> bool:
    """Whether the ego can be level with somebody: it goes by who is on the road, or at its edge."""
    whom = when.of or who
    return whom != EGO and situation[whom].starts.where in _LEVEL_WITH


def _is_nothing(said: Amount | None) -> bool:
    return said is not None and not said.than_ego and said.high <= 0.0


def _of_ego(situation: Situation) -> Iterator[Fault]:
    """Each deed of an ego that stands for which it would have to set off first."""
    for k, (before, after) in enumerate(pairwise(situation.ego.does), 1):
        stays = before.act in _STILL and before.time is None and situation.answered(before) is None
        if stays and after.act in ASIDE:
            yield Fault((f"ego.does.{k}.act",), f"a standing ego must set off before it can {after.act}")
    if situation.ego.route is EgoRoute.OVERTAKE and not any(one.starts.where in OVERTAKEN for one in situation.others):
        places = ", ".join(where for where in Where if where in OVERTAKEN)
        yield Fault(("ego.route",), f"there is nobody to overtake; a road user to overtake starts at {places}")


def _from(deed: Deed) -> frozenset[Where]:
    """Where a deed can be begun from."""
    rows = FROM if deed.whom in (None, EGO) else FROM | TO_ANOTHER
    return rows.get(deed.act, frozenset(Where))


def _passes_twice(one: Other, at: str) -> Iterator[Fault]:
    """Who has passed somebody is ahead of that one, and must lose speed before it can pass it again."""
    passed = set[str]()
    for k, deed in enumerate(one.does):
        whom = deed.whom or EGO
        if deed.act is Act.OVERTAKE and whom in passed:
            before = next(other.act for other in one.does[k - 1 :: -1] if (other.whom or EGO) == whom)
            again = " again" if before is Act.OVERTAKE else ""
            yield Fault(
                (f"{at}.{k}.act",),
                f"after {before} it is ahead of {whom} and must fall back before it can overtake{again}",
            )
        if deed.act is Act.OVERTAKE or (whom == EGO and _comes_before(one, deed)):
            passed.add(whom)
        elif deed.act in _FALLS_BACK:
            passed.clear()
        elif deed.act in acts_of(Heads.BEHIND, Heads.CLOSE):  # behind whom it then is
            passed.discard(whom)


def _comes_before(one: Other, deed: Deed) -> bool:
    """Whether somebody comes into the ego's lane by a deed from beside it, and so is ahead of it.

    Who begins behind and beside it may come in behind it, unless the deed itself is to come in before somebody.
    """
    aside = deed.act in acts_of(Heads.OVER) and deed.to is not None and deed.to is one.starts.side
    begins = NEXT_LANE if deed.act in acts_of(Heads.BEFORE) else NEXT_LANE - {Where.BEHIND_BESIDE}
    return one.starts.where in begins and deed.act in acts_of(Heads.BEFORE, Heads.MERGES, Heads.OVER) and not aside


def _comes_in_twice(one: Other, at: str) -> Iterator[Fault]:
    """Who came into the ego's lane from beside it must be outside again before it can come in again."""
    came: Act | None = None
    against = one.starts.where in _AGAINST
    comes_in = COMES_IN | acts_of(Heads.BEFORE) if against else COMES_IN
    for k, deed in enumerate(one.does):
        over = deed.act is Act.GO_STRAIGHT and one.starts.where in OFF_ROAD
        past = deed.act is Act.OVERTAKE and deed.whom in (None, EGO) and against
        if deed.act in comes_in or over or past:
            if came is not None:
                yield Fault(
                    (f"{at}.{k}.act",), f"after {came} it is already in our lane or past it, so it cannot {deed.act}"
                )
            came = deed.act
        elif deed.act in _TURNED:
            came = None
