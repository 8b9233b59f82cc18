"""Who comes against the ego in the lane in which another passes it: it is there when that one is back in its own."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace

from chatscene.build.actor import Actor
from chatscene.build.asked import Meets, stands_first
from chatscene.build.chain import in_terms_of
from chatscene.build.deeds import OWN
from chatscene.build.gaps import seconds_to_get_by
from chatscene.build.place import LANE, NEXT_LANE, room_against
from chatscene.build.relations import AHEAD
from chatscene.build.sideways import USUAL
from chatscene.build.timing import Body
from chatscene.errors import NotBuilt
from chatscene.terms.situation import EGO
from chatscene.terms.vocabulary import COMES_IN, ENDS, HALTS, Act, Heads, Role, Side, Tempo, Where, acts_of
from chatscene.world.places import FOLLOWING_BRAKE, lanes_beside

SPREAD = 5.0  # [m] by which where somebody begins is drawn
BEHIND = 30.0  # [m] of road behind who comes against the ego
_PASSES = NEXT_LANE | {Where.BEHIND}
_STOPS = ENDS | HALTS | acts_of(Tempo.BACKS, Heads.EDGE)


def come_after_who_passes(actors: Sequence[Actor]) -> None:
    """Let who comes against the ego begin so far off that another which passes it is back before the two meet.

    Raises:
        NotBuilt: No road is so long.
    """
    for actor in actors:
        start = actor.one.starts
        comes = start.where is Where.ONCOMING and actor.stand.meets is Meets.TOWARD and "$Y" in actor.stand.at
        if not comes or start.distance is not None or actor.first is not None:
            continue
        for by, k in _passing(actors):
            actor.phases()
            _begin_at(actor, by, k)


def come_by_before_who_crosses(actors: Sequence[Actor]) -> None:
    """Let who only comes against the ego, and is not met, be by before somebody is in its lane who crosses the road."""
    for actor in actors:
        comes = actor.stand.meets is Meets.TOWARD and "$Y" in actor.stand.at and not stands_first(actor.one)
        if not comes or actor.one.role is not Role.SUPPORTING or actor.one.starts.distance is not None:
            continue
        for by in actors:
            if by.stand.meets is Meets.ACROSS and by.stand.left != "0" and not COMES_IN.isdisjoint(_acts(by)):
                _begin_nearer(actor, by)


def _acts(actor: Actor) -> frozenset[Act]:
    return frozenset(deed.act for deed in actor.deeds)


def stand_beyond_who_passes(actors: Sequence[Actor]) -> None:
    """Let who is not met, and stands or stops in a lane, be beyond where another that passes the ego needs it."""
    for by in actors:
        passes = (k for k, deed in enumerate(by.deeds) if deed.act is Act.OVERTAKE and deed.whom in (None, EGO))
        if by.stand.meets is not Meets.ALONG or (k := next(passes, None)) is None:
            continue
        comes_back = OWN in " ".join(by.phases())
        for actor in actors:
            if _comes_to_stand(actor) and _is_in_its_lane(actor, by, comes_back=comes_back):
                _stand_beyond(actor, by, k)


def _comes_to_stand(actor: Actor) -> bool:
    """Whether somebody who is not met stands or stops ahead in a lane, where that was not said."""
    ahead = actor.one.starts.where in AHEAD and actor.stand.meets is Meets.ALONG and actor.first is None
    free = ahead and actor.one.starts.distance is None and actor.one.role is Role.SUPPORTING
    stops = stands_first(actor.one) or not _acts(actor).isdisjoint(_STOPS)
    return free and stops and all(deed.when is None for deed in actor.deeds)


def _is_in_its_lane(actor: Actor, by: Actor, *, comes_back: bool) -> bool:
    """Whether another drives along in the lane of somebody."""
    if actor.one.starts.where is Where.AHEAD:
        return comes_back
    side = by.one.starts.side if by.one.starts.where in NEXT_LANE else by.named.get("side") or Side.LEFT
    return actor.one.starts.side is None or str(actor.one.starts.side) == str(side)


def _stand_beyond(actor: Actor, by: Actor, k: int) -> None:
    """Let somebody be so far ahead that who passes the ego is before that, and past its lane or able to stop there."""
    fast = by.numbers.range_of(f"FAST_{k}")[1]
    length = 0.5 * by.ego_limits.length + by.limits.length + 0.5 * actor.limits.length
    far = by.ego_speed * _seconds(by, k) + by.numbers.range_of(f"AHEAD_{k}")[1] + length
    if actor.one.starts.where is Where.AHEAD or OWN not in " ".join(by.phases()):
        far += fast * fast / (2.0 * FOLLOWING_BRAKE)
    low, high, unit, meaning = actor.numbers.range_of("Y")
    if low < far:
        actor.numbers.measure("Y", far, far + min(high - low, SPREAD), unit, meaning)
        actor.takes = max(actor.takes, far + BEHIND)


def _begin_nearer(actor: Actor, by: Actor) -> None:
    """Let somebody begin so near that it is past another's way over the road before that is in its lane."""
    seconds = by.met - by.numbers.range_of("OFFSET")[1]
    if by.one.starts.side is not Side.RIGHT:  # it is in that lane before it is in the ego's
        over = LANE + 0.5 * (actor.limits.width + by.limits.length)
        seconds -= Body(by.limits, by.walks).covers(over, by.numbers.range_of("SPEED")[0])
    low, high, unit, meaning = actor.numbers.range_of("Y")
    past = by.meets_at + actor.numbers.range_of("SPEED")[0] * seconds - actor.limits.length - actor.room
    if seconds > 0.0 and past < high:
        actor.numbers.measure("Y", past - min(high - low, SPREAD), past, unit, meaning)


def _passing(actors: Sequence[Actor]) -> Iterator[tuple[Actor, int]]:
    """Those who pass the ego where others come against it, and then come back; with the number of that deed."""
    for actor in actors:
        passes = (k for k, deed in enumerate(actor.deeds) if deed.act is Act.OVERTAKE and deed.whom in (None, EGO))
        k = next(passes, None)
        side = actor.named.get("side") or str(actor.one.starts.side or Side.LEFT)
        against = lanes_beside(actor.found.route).get(side) is not False and side == Side.LEFT
        if k is not None and against and actor.one.starts.where in _PASSES and OWN in " ".join(actor.phases()):
            yield actor, k


def _seconds(actor: Actor, k: int) -> float:
    """After how many seconds [s] somebody who passes the ego in its k-th deed is back in the ego's lane."""
    return actor.numbers.middle("STEADY") + seconds_to_get_by(actor, k) + USUAL


def _begin_at(actor: Actor, by: Actor, k: int) -> None:
    """Let somebody begin so far off that it comes to who passes the ego in its k-th deed once that is back."""
    lengths = 0.5 * (by.ego_limits.length + actor.limits.length) + by.limits.length
    comes = actor.numbers.range_of("SPEED")[1]

    def needed() -> float:
        seconds = _seconds(by, k)
        return (by.ego_speed + comes) * seconds + lengths + by.numbers.middle(f"AHEAD_{k}")

    usual = 0.5 * (needed() + _at_slowest(by, f"FAST_{k}", needed))  # it takes more than in proportion longer then
    low, _, unit, meaning = actor.numbers.range_of("Y")
    if low >= usual + SPREAD:
        return
    actor.takes = max(actor.takes, usual + SPREAD + BEHIND)
    most = room_against(actor.found.route)
    if most < usual and actor.found.route.line.length > usual:
        raise NotBuilt(
            f"others.{actor.one.id}: the road is only {most:.0f} m long; {by.one.id} is back in our lane after"
            f" {_seconds(by, k):.0f} s, so {actor.one.id} would have to start {usual:.0f} m ahead"
        )
    actor.numbers.measure("Y", usual, usual + SPREAD, unit, meaning)
    middle = needed()
    more = in_terms_of(by.numbers, ("$STEADY", f"$FAST_{k}", f"$AHEAD_{k}", "$Y"), lambda: needed() - middle)
    actor.stand = replace(actor.stand, at=actor.stand.at.replace("$Y", f"$Y {by.filled(more)}"))


def _at_slowest(actor: Actor, name: str, metres: Callable[[], float]) -> float:
    """A distance [m] where a parameter is the least."""
    kept = actor.numbers.range_of(name)
    actor.numbers.narrow(name, kept[0], kept[0])
    far = metres()
    actor.numbers.ranges[name] = kept
    return far
