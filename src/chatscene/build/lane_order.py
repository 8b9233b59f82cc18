"""Who is before whom in one lane: where that follows from what each does, and no distance was said."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from chatscene.build.actor import Actor
from chatscene.build.aim import LEADS
from chatscene.build.aside import SWERVES_AT, answered_by, avoids, seconds_aside
from chatscene.build.asked import ROOM, Meets, stands_first
from chatscene.build.numbers import Numbers
from chatscene.build.revealed import shows_slow
from chatscene.build.towards import done_to, screens
from chatscene.build.turning_round import WIDER
from chatscene.errors import NotBuilt
from chatscene.terms.situation import EGO, Other
from chatscene.terms.vocabulary import ASIDE, COMES_IN, COMES_OVER, SIDEWAYS, SLOWS, Role, Where
from chatscene.world.places import FOLLOWING_BRAKE

HEADWAY = 1.3  # [s] that somebody is behind another who comes in between that and the ego
GETS_GOING = 2.0  # [s] at its speed that it takes somebody from the kerb until it goes along the lane
SHOWS = 6.0  # [s] that somebody has before it is where another goes slowly for which it leaves the lane
GOES_ON = 5.0  # [s] that somebody goes on before it brakes for who stands in its lane
_AHEAD = frozenset((Where.AHEAD, Where.AHEAD_BESIDE))


def set_in_order(actors: Sequence[Actor]) -> None:
    """Let each be as far ahead as others ask for who are in its lane before it or behind it."""
    free = [actor for actor in actors if _is_free(actor)]
    for actor in free * len(free):  # who has been moved may move another
        nearest = max((_tail(other, actor) for other in actors if other is not actor), default=0.0)
        if nearest > actor.nearest:
            actor.numbers.move("Y", nearest - actor.nearest)


def _is_free(actor: Actor) -> bool:
    return actor.one.starts.where in _AHEAD and actor.one.starts.distance is None and actor.first is None


def _tail(by: Actor, one: Actor) -> float:
    """How far ahead of the ego [m] the tail of somebody must be to be before another; 0 if that does not matter."""
    situation, speed = one.ledger.situation, one.ego.speed
    if screens(by.one, one.one):  # who is hidden by it
        return by.farthest + ROOM
    if _goes_along(one) and one.one.starts.where is Where.AHEAD and _comes_between(by):
        return by.farthest + HEADWAY * speed
    if any(by.one.id == other.hidden_by for other in situation.others):
        return 0.0
    if any(avoids(by, k) is one.one for k in range(len(by.deeds))):
        brakes = by.numbers.range_of("BRAKE_TIME")[1] if not SLOWS.isdisjoint(deed.act for deed in by.deeds) else 0.0
        return by.farthest + ROOM + (seconds_aside(by, one.one) + brakes) * speed
    if _waits(one):
        return _beyond(by, one, speed)
    only_goes = one.one.role is Role.SUPPORTING and all(deed.act.row.lasting for deed in one.deeds)
    passed = by.lies and _goes_along(one) and only_goes
    return by.farthest + ROOM if passed and _in_one_lane(by, one) else 0.0


def _beyond(by: Actor, one: Actor, speed: float) -> float:
    """The same, of who stands in the lane in which another drives, which is not to brake for it before all is done.

    Who comes against the ego, and over into its lane, has come by.
    """
    if by.one.starts.where is Where.ONCOMING and by.stand.meets is Meets.TOWARD and not _stays(by):
        by.phases()  # which say from how far it comes
        return by.farthest + ROOM if one.one.starts.where is Where.AHEAD and "$Y" in by.stand.at else 0.0
    if _pulls_out_before(by, one):  # and has room to get going, and to stop again behind that
        fast = by.numbers.range_of("SPEED")[1]
        return by.farthest + ROOM + GETS_GOING * fast + fast * fast / (2.0 * FOLLOWING_BRAKE)
    if _goes_along(by) and _stays(by) and _in_one_lane(by, one):
        return by.farthest + GOES_ON * speed + speed * speed / (2.0 * FOLLOWING_BRAKE)
    return 0.0


def _pulls_out_before(by: Actor, one: Actor) -> bool:
    """Whether somebody comes from the kerb into the lane in which another stands, from no distance that was said."""
    comes = by.stand.meets is Meets.KERB and any(deed.act in COMES_IN for deed in by.deeds)
    return comes and one.one.starts.where is Where.AHEAD and "$Y" in by.stand.at


def come_before_who_answers(actors: Sequence[Actor]) -> None:
    """Let who is not met, and comes into our lane, do so just before somebody ahead of the ego that is to answer it."""
    for actor in actors:
        comes = actor.stand.meets in (Meets.ACROSS, Meets.KERB) and actor.one.role is Role.SUPPORTING
        if not comes or actor.one.starts.distance is not None:
            continue
        needs = [_needs(by, k) for by in actors for k in _answers(by, actor.one.id)]
        if needs:
            actor.sooner = (max(needs) + 0.5 * actor.limits.width + ROOM) / actor.ego_speed
            if actor.stand.meets is Meets.KERB:
                actor.numbers.narrow("OFFSET", actor.sooner, actor.sooner + LEADS)


def _answers(by: Actor, name: str) -> Iterator[int]:
    """The deeds by which somebody who drives before the ego, as fast as it, slows or swerves as another does something.

    Who swerves answers only what it was said to.
    """
    if by.one.starts.speed is None and by.one.starts.where is Where.AHEAD and _goes_along(by):
        for k, deed in enumerate(by.deeds):
            answer = by.ledger.situation.answered(deed)
            whom = {answer[1].partition(".")[0]} if answer is not None else set[str]()
            if name in whom or (deed.act in ASIDE and name in answered_by(by, k)):
                yield k


def _needs(by: Actor, k: int) -> float:
    """How far ahead of where the ego then is [m] somebody comes into the lane for whom another does its k-th deed."""
    return _rests(by, k) if by.deeds[k].act in SLOWS else by.farthest + SWERVES_AT * by.ego_speed


def _rests(by: Actor, k: int) -> float:
    """How far ahead of where the ego then is [m] the nose of somebody is at most that has braked in its k-th deed."""
    by.phases()  # which say how hard it brakes, and from where
    share = by.numbers.range_of(f"BRAKE_{k}")[0]
    return by.farthest + by.ego_speed**2 / (2.0 * share * by.limits.brake)


def _waits(actor: Actor) -> bool:
    """Whether somebody stands in a lane, and is not met there."""
    stands = stands_first(actor.one) and not actor.lies and actor.one.starts.where in _AHEAD
    return stands and actor.one.role is not Role.ADVERSARY and actor.one.hidden_by is None


def _in_one_lane(by: Actor, one: Actor) -> bool:
    return by.one.starts.where is one.one.starts.where and by.one.starts.side is one.one.starts.side


def _goes_along(actor: Actor) -> bool:
    """Whether somebody drives along before the ego."""
    ahead = actor.one.starts.where in _AHEAD and actor.stand.meets is Meets.ALONG
    return ahead and not (stands_first(actor.one) or actor.walks)


def _stays(actor: Actor) -> bool:
    return SIDEWAYS.isdisjoint(deed.act for deed in actor.deeds)


def _comes_between(actor: Actor) -> bool:
    """Whether somebody comes over from beside the ego, in between it and who drives before it."""
    over = any(deed.act in COMES_OVER and done_to(deed) == EGO for deed in actor.deeds)
    return over and actor.one.starts.where is Where.AHEAD_BESIDE


def leaves_row(actor: Actor) -> float:
    """How much more room [m] somebody needs before it who comes out of a row of others: to turn out from a stand.

    Who leaves the lane before somebody slow is so far behind that one that it has the time to.
    """
    limits, along = actor.limits, actor.stand.meets is Meets.ALONG
    if (slow := next((one for one in actor.ledger.situation.others if shows_slow(actor.one, one)), None)) is not None:
        return SHOWS * max(actor.ego_speed - _goes_at(slow), 0.0)
    if not (along and limits.wheelbase and stands_first(actor.one)) or _stays(actor):
        return 0.0
    radius = WIDER * limits.wheelbase / math.tan(limits.wheel_angle)
    return math.sqrt(2.0 * radius * limits.width)


def _goes_at(one: Other) -> float:
    """About how fast [m/s] somebody goes along who is slow."""
    row = one.kind.row.body.row
    usual = Numbers(one.id, row).middle("SLOW" if row.motorised else "SPEED")
    return usual if one.starts.speed is None else one.starts.speed.near(usual)


def behind_leaders(actors: Sequence[Actor]) -> Iterator[tuple[Actor, Actor]]:
    """Those who are hidden by somebody nearer in the ego's lane, with whom hides each."""
    yield from ((actor, by) for actor in actors for by in actors if screens(by.one, actor.one))


def check_hidden(actors: Sequence[Actor]) -> None:
    """Those who are hidden in the ego's lane are farther away there than who hides them.

    Raises:
        NotBuilt: Somebody is not.
    """
    for actor, by in behind_leaders(actors):
        if not actor.stand.behind and actor.nearest <= by.farthest:
            raise NotBuilt(
                f"impossible: {actor.path}.hidden_by: {by.one.id} is not nearer than {actor.one.id}, which would have"
                f" to be {by.farthest + ROOM:.0f} m ahead at least"
            )
        actor.ledger.take(f"{actor.path}.hidden_by")
