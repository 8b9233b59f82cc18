"""How a deed is done by somebody: the row of a table, and what its place, its numbers and whom it is done to change."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

from chatscene.build.asked import FROM_A_STAND, Meets, stands_first
from chatscene.build.contact import misses, sideswiped_at, touches
from chatscene.build.deeds import (
    ALONG,
    AS_FAST_BEHIND,
    BACK_OUT,
    BEHIND_ANOTHER,
    BRAKES,
    BRAKES_TO,
    COMES_BACK,
    DRIFTS_OVER,
    INTO_NEXT,
    LOSES_SLOWLY,
    OFF,
    OFF_BY_RAMP,
    SETS_OFF_BEHIND,
    SHIES,
    SLIDES,
    STEPS_BACK,
    Steps,
    by_way_off,
    gets_by,
    goes_on_beside,
    lets_by,
    near_to_pass,
    passes_against,
    pulls_out,
    seen_to_pass,
    sideswipes,
    steps_for,
    turning_off,
    turning_round,
    yielding_to,
)
from chatscene.build.gaps import eases, stops_before
from chatscene.build.hooking import hooks_at, leaves_at
from chatscene.build.leaving import leaves_road
from chatscene.build.local import check_round, way_to_turn_round
from chatscene.build.naming import name_of
from chatscene.build.over_lanes import lane_after
from chatscene.build.paces import Pace
from chatscene.build.place import (
    NEXT_LANE,
    ROUNDABOUT_PLACES,
    at_junction,
    leaves_by_ramp,
    rides_at_edge,
    stands_in_closed_lane,
)
from chatscene.build.rates import at_a_rate
from chatscene.build.relations import ALONG as ALONG_EGO
from chatscene.build.sideways import takes_long
from chatscene.build.towards import done_to
from chatscene.build.turning_round import TURNS_AT
from chatscene.errors import NothingBuilds
from chatscene.maps.ways_off import turns_at
from chatscene.terms.actors import Manner as Moves
from chatscene.terms.situation import EGO, Deed
from chatscene.terms.vocabulary import ASIDE, COMES_IN, GOES_ON, Act, Feature, Heads, Role, Where, acts_of
from chatscene.world.places import wayOff

if TYPE_CHECKING:
    from chatscene.build.actor import Actor

NEAR_ITS_OWN = 0.6  # [m] from the middle of the ego's lane, toward its own, who passes another and not to touch the ego
CLEAR, OUT = 0.2, 2.8  # [m] between two of whom one has pulled out; that it is aside at most for that
_ASIDE = ASIDE | acts_of(Heads.SWINGS, Heads.OVER, Heads.OUT)
_ON_THE_ROAD = NEXT_LANE | {Where.AHEAD}
_COMES_BACK = acts_of(Heads.BEFORE, Heads.OVER, Heads.MERGES)


def steps_of(actor: Actor, k: int) -> Steps:
    """How somebody does its k-th deed.

    Raises:
        NotBuilt: Nobody who is there does it yet.
    """
    deed, where = actor.deeds[k], actor.one.starts.where
    if where in ROUNDABOUT_PLACES:
        check_round(actor, k)
    table, across = dict(_table(actor, k)), actor.stand.meets is Meets.ACROSS
    crossed = across and any(one.act in COMES_IN for one in actor.deeds[:k])
    if deed.act is Act.REVERSE and actor.walks and not crossed:
        raise NothingBuilds(f"cannot be built yet: {deed.act}, {where}; who walks does not go backwards; say turn-back")
    if deed.act is Act.REVERSE and crossed:
        table[Act.REVERSE] = STEPS_BACK if actor.walks else BACK_OUT
    if deed.act is Act.FALL and actor.one.kind.moves is Moves.RIDES:
        table[Act.FALL] = SLIDES
    if deed.act not in table or (deed.act in _ASIDE and where in ROUNDABOUT_PLACES):  # nobody sees it on a bend
        along = (
            "; a road user that goes along the road starts ahead, beside or behind"
            if across and deed.act in ALONG
            else ""
        )
        raise NothingBuilds(f"cannot be built yet: {deed.act}, {where}{along}")
    steps = at_a_rate(actor, k, _by_numbers(actor, k, table[deed.act]), across=across)
    if deed.act is Act.OVERTAKE and not across and _ego_waits_for(actor, k):
        toward = actor.stand.meets is Meets.TOWARD and done_to(deed) != EGO
        steps = near_to_pass(steps) if toward else seen_to_pass(steps)
    return takes_long(actor, k, steps)


def _ego_waits_for(actor: Actor, k: int) -> bool:
    """Whether the ego does something while somebody does its k-th deed."""
    situation = actor.ledger.situation
    named = (deed.when.during for deed in situation.ego.does if deed.when is not None and deed.when.during)
    return any(name.partition(".")[0] == actor.one.id and situation.number_of(name) == k for name in named)


def _table(actor: Actor, k: int) -> Iterator[tuple[Act, Steps]]:
    """The rows, those that hold in this place last."""
    deed = actor.deeds[k]
    where, meets = actor.one.starts.where, actor.stand.meets
    yield from steps_for(meets, walks=actor.walks, beside=where in NEXT_LANE).items()
    along = meets is Meets.ALONG
    if deed.act in acts_of(Heads.OVER, Heads.OFF) and along:
        yield from _changing_lanes(actor, k)
    if deed.act is Act.ENTER and meets is Meets.THROUGH and where not in ROUNDABOUT_PLACES:
        yield Act.ENTER, ALONG[Act.CROSS]  # its way leads onto the ego's road
    if deed.act is Act.SWERVE and actor.walks and where in _ON_THE_ROAD:
        yield Act.SWERVE, SHIES
    if deed.act in OFF and along:
        yield from _turning_off(actor, k)
    yield from _off_the_road(actor, k)
    if deed.act is Act.U_TURN and meets in (Meets.ALONG, Meets.KERB):
        turn = way_to_turn_round(actor, k)
        speed = 0.0 if deed.speed is not None else math.sqrt(TURNS_AT * turn.radius)
        yield Act.U_TURN, turning_round(turn.radius, speed, first=turn.first, back=turn.back)
    yield from _behind_who_stands(actor, k)
    follows = actor.stand.behind and not actor.stand.rolls and not touches(actor.ledger.situation, actor.one)
    if where is Where.BEHIND and deed.act in GOES_ON and follows and not _goes_by_itself(actor, deed):
        said = any(one.speed is not None for one in actor.deeds) or actor.one.starts.speed is not None
        yield deed.act, AS_FAST_BEHIND if said else BEHIND_ANOTHER  # or it would run into the ego
    if deed.act is Act.OVERTAKE and along:
        yield from _overtaking(actor, deed)
    if meets is Meets.TOWARD:
        yield from _toward(actor, k)
    if done_to(deed) != EGO:
        yield from _to_another(actor, k)


def _behind_who_stands(actor: Actor, k: int) -> Iterator[tuple[Act, Steps]]:
    """The row of who sets off behind an ego that stands, and then goes round it: or it would run into that."""
    sets_off = actor.deeds[k].act is Act.SET_OFF and k + 1 < len(actor.deeds)
    if sets_off and actor.stand.behind and actor.ego.stands:
        yield Act.SET_OFF, SETS_OFF_BEHIND


def _off_the_road(actor: Actor, k: int) -> Iterator[tuple[Act, Steps]]:
    """The row of who leaves the road, over the edge that was said or the nearest."""
    if actor.deeds[k].act is Act.LEAVE_ROAD:
        yield Act.LEAVE_ROAD, leaves_road(actor, k)


def _turning_off(actor: Actor, k: int) -> Iterator[tuple[Act, Steps]]:
    """The rows of who goes along the road and turns off it: in the ego's lane, or after it has passed the ego."""
    act, route = actor.deeds[k].act, actor.found.route
    if actor.one.starts.where in (Where.AHEAD, Where.BEHIND):
        yield act, turning_off(act, junction=at_junction(actor.ledger.situation))
    side = "left" if act is Act.TURN_LEFT else "right"
    at = turns_at(route.network, route.route, side)
    if at is None or not (leaves_at(actor) == k or hooks_at(actor) == k):
        return
    actor.named["off"] = side
    driveway = route.route.junction is None
    ends = wayOff(route, side).length if driveway else None
    yield act, by_way_off(at - route.eventAt, ends, comes=not stands_first(actor.one))


def _changing_lanes(actor: Actor, k: int) -> Iterator[tuple[Act, Steps]]:
    """The row of who leaves its lane, for the ego's, for the next to it, for one farther off, or for a ramp."""
    if actor.deeds[k].act is Act.EXIT:
        yield from ((Act.EXIT, OFF_BY_RAMP),) if leaves_by_ramp(actor.ledger.situation, actor.one) else ()
        return
    lane = lane_after(actor.one, actor.deeds, k)
    if abs(lane) > 1:
        actor.named["lane"] = str(lane)
        yield Act.LANE_CHANGE, INTO_NEXT
    elif lane:
        yield Act.LANE_CHANGE, ALONG[Act.CUT_OUT]


def _overtaking(actor: Actor, deed: Deed) -> Iterator[tuple[Act, Steps]]:
    """The rows of who passes somebody that goes the same way."""
    struck = sideswiped_at(actor.ledger.situation, actor.one) if done_to(deed) == EGO else None
    if struck is not None and deed is actor.deeds[-1]:
        actor.ledger.take("contact.ego", "contact.striker", "contact.happens")
        yield Act.OVERTAKE, sideswipes(struck * actor.ego_limits.length)
        return
    if actor.one.starts.where in NEXT_LANE:  # in the lane, or at the edge, where it is
        at_edge = rides_at_edge(actor.one, actor.ledger.situation.ego.route)
        others = (one for one in actor.ledger.situation.others if one.id != actor.one.id)
        free = all(one.starts.where is not Where.AHEAD for one in others)
        free = free and Feature.CLOSED_LANE not in actor.ledger.situation.road.has
        yield Act.OVERTAKE, gets_by(comes_back=free and not at_edge)
    elif not actor.stand.rolls:  # behind whom it passes, which may be slow by then
        clear = 0.5 * (actor.ego_limits.width + actor.limits.width) + CLEAR
        out = pulls_out(min(clear, OUT))
        stays = done_to(deed) == EGO and stands_in_closed_lane(actor.ledger.situation)
        yield Act.OVERTAKE, goes_on_beside(out) if stays else out
    if actor.stand.rolls and done_to(deed) == EGO:  # of which it comes by anyway
        yield Act.OVERTAKE, ALONG[Act.GO_ALONG]


def _goes_by_itself(actor: Actor, deed: Deed) -> bool:
    """Whether somebody behind the ego keeps as far from it as a careful driver does, as no distance was said."""
    return actor.one.role is Role.SUPPORTING and deed.distance is None


def is_in_ours(actor: Actor, k: int) -> bool:
    """Whether somebody who comes against the ego is in its lane before a deed."""
    ours = actor.one.starts.where is Where.ONCOMING_IN_OUR_LANE
    return ours or any(one.act in _COMES_BACK | acts_of(Heads.BY, Heads.IN) for one in actor.deeds[:k])


def _back(actor: Actor, k: int) -> Steps:
    """How somebody goes back to its lane, as fast as it passed another if it did."""
    passed = [n for n, one in enumerate(actor.deeds[:k]) if one.act is Act.OVERTAKE]
    if not passed:
        return COMES_BACK
    fast = tuple(text.replace("$SPEED", f"$FAST_{passed[-1]}") for text in COMES_BACK.does)
    return replace(COMES_BACK, does=fast)


def _toward(actor: Actor, k: int) -> Iterator[tuple[Act, Steps]]:
    """The rows of who comes against the ego."""
    deed = actor.deeds[k]
    if deed.act is Act.YIELD:
        yield deed.act, yielding_to(EGO, against=True)  # until it is by, wherever that is
    if deed.act in _COMES_BACK and is_in_ours(actor, k):
        yield deed.act, _back(actor, k)


def _to_another(actor: Actor, k: int) -> Iterator[tuple[Act, Steps]]:
    """The rows of what is done to another than the ego."""
    deed = actor.deeds[k]
    if deed.act is Act.FOLLOW and deed.speed is None:
        yield Act.FOLLOW, BEHIND_ANOTHER
    elif deed.act is Act.OVERTAKE and actor.stand.meets is Meets.TOWARD:
        aside = NEAR_ITS_OWN if misses(actor.ledger.situation, actor.one) else 0.0
        yield Act.OVERTAKE, passes_against(comes_back=actor.then(k) not in _COMES_BACK, aside=aside)
    elif deed.act is Act.YIELD and actor.stand.meets is Meets.ACROSS:
        yield Act.YIELD, lets_by(name_of(done_to(deed)))
    elif deed.act is Act.YIELD:
        against = actor.stand.meets is Meets.TOWARD and actor.ledger.situation[done_to(deed)].starts.where in ALONG_EGO
        to = actor.ledger.situation[done_to(deed)].starts.where
        junction = at_junction(actor.ledger.situation) and to in (Where.ARM, Where.ONCOMING)
        through = actor.stand.meets is Meets.THROUGH and junction
        yield Act.YIELD, yielding_to(name_of(done_to(deed)), against=against, through=through)


def _by_numbers(actor: Actor, k: int, steps: Steps) -> Steps:
    """The row, by what was said of the deed and by what comes then."""
    deed, then, across = actor.deeds[k], actor.then(k), actor.stand.meets is Meets.ACROSS
    brakes = deed.act is Act.BRAKE or (deed.act is Act.SLOW_DOWN and deed.acceleration is not None)
    if brakes and not across and deed.speed is not None:
        return BRAKES_TO
    if stops_before(actor, k):
        return DRIFTS_OVER
    passes = next((n for n, text in enumerate(steps.does) if "$AHEAD" in text), None)  # none by an ego that stands
    if deed.act is Act.OVERTAKE and then in _COMES_BACK and actor.stand.meets is Meets.ALONG and passes is not None:
        way = "{beside}" if "{beside}" in steps.does[0] else ""
        does = (*steps.does[: passes + 1], eases(actor, k, way or "{p}"))
        return replace(steps, does=does, last=(), way=way)  # what comes then says how it comes back
    if deed.act is Act.BRAKE and across and deed.speed is not None:
        return LOSES_SLOWLY
    if deed.act is Act.BRAKE and not across and deed.time is None and then in FROM_A_STAND:
        return replace(steps, does=(BRAKES,), last=(BRAKES,), pace=Pace.STANDS)
    return steps
