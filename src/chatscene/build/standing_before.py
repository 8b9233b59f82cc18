"""Who stands before an ego that stands, or comes to a stand behind it: as in a queue, or before it is backed into."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

from chatscene.build.contact import touches
from chatscene.terms.actors import Manner as Moves
from chatscene.terms.amount import Speed
from chatscene.terms.backing import backs
from chatscene.terms.order import Order
from chatscene.terms.situation import EGO, Deed, Other, Situation, When
from chatscene.terms.vocabulary import (
    CHANGES,
    HALTS,
    SIDES_OF,
    SIDEWAYS,
    Act,
    EgoRoute,
    Heads,
    Part,
    Role,
    Striker,
    Tempo,
    Where,
    acts_of,
)
from chatscene.world.ego_route import EgoRoute as Route
from chatscene.world.places import ownLane

if TYPE_CHECKING:
    from chatscene.build.asked import Asked
    from chatscene.build.restated import Restated

_STANDS = Speed(0.0, 0.0)
_ELSEWHERE = CHANGES | {EgoRoute.OVERTAKE, EgoRoute.LEAVE_DRIVEWAY, EgoRoute.LEAVE_PARKING}
_GOES_ON = acts_of(Tempo.SETS_OFF, Tempo.GAINS)
SWUNG = 1.0  # [m] beside its lane an ego is that has begun to swing out round somebody
IN_AGAIN, AGAIN_FOR = 0.3, 4.0  # [m] beside its lane at most an ego is that is in it again, and how far it then goes
BACKS_AT = 1.5, 3.0  # [m/s], from and to, that somebody backs into the ego
BACKS_FOR = 7.0, 9.0  # [s] at most, from and to, that it does: until they touch


def in_queue(situation: Situation) -> Situation:
    """The same; who backs up first, before an ego that stands all the time or stops behind it, stands before it."""
    stands = bool(situation.ego.does) and all(deed.act is Act.STAND for deed in situation.ego.does)
    if not stands and halts(situation) is None:
        return situation
    return replace(situation, others=tuple(map(_standing, situation.others)))


def _standing(one: Other) -> Other:
    backs_first = bool(one.does) and one.does[0].act is Act.REVERSE and one.starts.where is Where.AHEAD
    return replace(one, starts=replace(one.starts, speed=_STANDS)) if backs_first and one.starts.speed is None else one


def halts(situation: Situation) -> int | None:
    """The number of the deed by which the ego comes to a stand of itself, or stands from the first, and stays there.

    None where it does not, or where its way leads it out of its lane before.
    """
    ego = situation.ego
    if backs(situation) or ego.route in _ELSEWHERE:
        return None
    if any(deed.act in _GOES_ON for deed in ego.does):
        return None
    stops = (k for k, deed in enumerate(ego.does) if deed.act in HALTS)
    k = next(stops, None)
    free = k is not None and (situation.answered(ego.does[k]) is None or backed_into(situation) is not None)
    return k if free else None


def backed_into(situation: Situation) -> Other | None:
    """Who ahead of the ego, in its lane, stands at first and is to back into it, as was said of their contact."""
    for one in situation.others:
        acts = [deed.act for deed in one.does]
        backs_up = Act.REVERSE in acts[:2] and acts[0] in acts_of(Tempo.STANDS, Tempo.BACKS)
        placed = one.starts.where is Where.AHEAD and one.starts.distance is None
        if backs_up and placed and one.kind.moves is Moves.DRIVES and touches(situation, one):
            return one
    return None


def backs_into_ego(situation: Situation, one: Other) -> bool:
    """Whether somebody is to back into an ego that stands then."""
    return backed_into(situation) is one and halts(situation) is not None


def beyond_another(situation: Situation, one: Other) -> bool:
    """Whether somebody who is to back into the ego stands beyond another, round whom the ego has swung out before."""
    if situation.ego.route is not EgoRoute.BYPASS or backed_into(situation) is not one or halts(situation) is None:
        return False
    return any(other is not one and other.starts.where is Where.AHEAD for other in situation.others)


def stand_before_ego(made: Restated) -> None:
    """Let who is ahead of an ego that stops, of whom nothing was said, stand; and who backs into it do that then.

    An ego that stops once that one backs does so before: it is not said where else it would stand.
    """
    k = halts(made.situation)
    if k is None:
        return
    made.each(_stands_too)
    one = backed_into(made.situation)
    if one is None:
        return
    ego, stop = made.situation.ego, made.situation.ego.does[k]
    n = next(n for n, deed in enumerate(one.does) if deed.act is Act.REVERSE)
    if stop.act is Act.STOP:
        when = one.does[n].when
        made.taken += [f"others.{one.id}.does.{n}.when"] if when is not None else []
        made.taken += [f"{EGO}.does.{k}.when", f"{EGO}.does.{k}.whom"]
        made.assumed.append(f"{one.id} backs up when the ego has stopped behind it")
        does = (*one.does[:n], replace(one.does[n], when=When(after=f"{EGO}.{Act.STOP}")), *one.does[n + 1 :])
        changed = replace(one, does=does)
        others = tuple(changed if other is one else other for other in made.situation.others)
        halted = (*ego.does[:k], replace(stop, when=None, whom=None), *ego.does[k + 1 :])
        made.situation = replace(made.situation, ego=replace(ego, does=halted), others=others)


def _stands_too(made: Restated, one: Other) -> Other:
    """Who goes before an ego that stops, and of whom it was not said what it does, stands there."""
    start, named = one.starts, {deed.whom for other in made.situation.others for deed in other.does}
    said = bool(one.does) or start.speed is not None or start.distance is not None or one.id in named
    if said or one.role is not Role.SUPPORTING or start.where is not Where.AHEAD or one.kind.moves is not Moves.DRIVES:
        return one
    stands = any(deed.act is Act.STAND for deed in made.situation.ego.does)
    made.assumed.append(f"{one.id} stands, since the ego {'stands' if stands else 'stops'} behind it")
    return replace(one, does=(Deed(act=Act.STAND),))


def parts_backed_into(situation: Situation) -> Iterator[str]:
    """The paths of what was said of a contact with who backs into the ego that is so by where the two stand."""
    contact, one = situation.contact, backed_into(situation)
    if contact is None or one is None or halts(situation) is None:
        return
    if contact.striker is Striker.OTHER:
        yield "contact.striker"
    if contact.ego is not None and "front" in SIDES_OF[contact.ego]:
        yield "contact.ego"


def keeps_in_lane(situation: Situation) -> Iterator[Order]:
    """An order by which the ego stays in its lane that stops behind somebody: some egos would go round that one."""
    k = halts(situation)
    if k is None or situation.ego.does[k].act is not Act.STOP:
        return
    if any(deed.act in SIDEWAYS | acts_of(Heads.EDGE) for deed in situation.ego.does):  # it is to leave its lane
        return
    if any(_is_before(one) for one in situation.others):
        yield Order(aside=0.0)


def _is_before(one: Other) -> bool:
    return one.starts.where is Where.AHEAD and one.starts.distance is None and one.kind.moves is Moves.DRIVES


def stop_behind(asked: Asked) -> float | None:
    """Where on its way [m] the ego comes to a stand behind somebody who stands there; None where it does not."""
    k = halts(asked.situation)
    if k is None or asked.situation.ego.does[k].act is not Act.STOP or asked.one.starts.distance is not None:
        return None
    swings = asked.situation.ego.route is EgoRoute.BYPASS
    if asked.one.role is Role.HIDES or (swings and backed_into(asked.situation) is not asked.one):
        return None
    begins, drive = asked.ego.drive
    *_, before, last = (0.0, *(far for far, _ in drive))
    return begins + last if last - before < 1e-3 else None


def stops_on_its_way_round(situation: Situation, route: Route) -> float | None:
    """Where on its way [m] an ego stops that swings out round somebody, and is backed into; None of any other.

    It is where it has begun to swing out, or back in its lane behind who stands there beyond.
    """
    one = backed_into(situation)
    if one is None or situation.ego.route is not EgoRoute.BYPASS or halts(situation) is None:
        return None
    line, own = route.line, ownLane(route)
    far = [0.5 * n for n in range(int(2.0 * line.length))]
    aside = [abs(own.project(*line.point_at(at))[1]) for at in far]
    if beyond_another(situation, one):
        return max(at for at, out in zip(far, aside, strict=True) if out > IN_AGAIN) + AGAIN_FOR
    left = situation.contact is not None and situation.contact.ego in (Part.LEFT, Part.LEFT_FRONT, Part.LEFT_REAR)
    most = IN_AGAIN if left else SWUNG  # it is not met on its left by who is to its right
    return next((at for at, out in zip(far, aside, strict=True) if out > most), route.eventAt)
