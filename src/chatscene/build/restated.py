"""What was said in another form than it is built in: the same facts, as the rest of the builder reads them.

Each rule says one fact by another that has it too. What it says so is taken; what it chooses is told.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace

from chatscene.build.asked import PARKED_APART, ROOM, slow_speed, stands_first
from chatscene.build.coming import wanted_by
from chatscene.build.paces import AT_ONE_SPEED
from chatscene.build.place import GOES_OVER, NEXT_LANE
from chatscene.build.possible import OVERTAKEN
from chatscene.build.standing_before import stand_before_ego
from chatscene.build.timing import Body
from chatscene.build.waiting import SIGNS
from chatscene.errors import NotBuilt
from chatscene.situations.check import MOST
from chatscene.terms.actors import Manner as Moves
from chatscene.terms.amount import Length, Speed
from chatscene.terms.changing import changes_later
from chatscene.terms.lateral import PLACED
from chatscene.terms.situation import EGO, LATERALS, SEVERAL, Deed, Ego, Lateral, Other, Situation, When
from chatscene.terms.vocabulary import (
    ENDS_THERE,
    FOR_SOMEBODY,
    PLAIN,
    SIDEWAYS,
    SLOWS,
    Act,
    EgoRoute,
    Facing,
    Role,
    Side,
    Where,
)

_AGAINST = frozenset((Where.ONCOMING_IN_OUR_LANE, Where.ONCOMING))
"""Where somebody comes the other way."""
FROM_LINE, EGO_FIRST = 8.0, 1.0  # [m] from its line to the ego's way; [s] that the ego may be there first
_IN_LINE = frozenset((Where.AHEAD, Where.ONCOMING_IN_OUR_LANE))
"""Where somebody is met by the ego's front along its lane."""
QUEUES = 0.6  # of what the ego wants, the most speed of traffic that queues beside it
_TO_SIDE = {EgoRoute.LEFT_TURN: Side.LEFT, EgoRoute.RIGHT_TURN: Side.RIGHT}


@dataclass(slots=True)
class Restated:
    """A situation as it is built.

    Attributes:
        situation: The same, in the form that is built.
        taken: The paths of facts that others say besides.
        assumed: What was chosen for it, in words.
    """

    situation: Situation
    taken: list[str] = field(default_factory=list[str])
    assumed: list[str] = field(default_factory=list[str])

    def each(self, rule: Callable[[Restated, Other], Other]) -> None:
        """Let everybody be as a rule says it."""
        self.situation = replace(self.situation, others=tuple(rule(self, one) for one in self.situation.others))


def restated(situation: Situation) -> Restated:
    """A situation in the form in which it is built."""
    made = Restated(situation)
    _turn_where_the_road_ends(made)
    _go_past(made)
    _over_when_told(made)
    _met_at_a_point(made)
    for rule in (
        _fills_its_row,
        _keeps_aside,
        _comes_aside,
        _on_foot_against,
        _on_foot_at_arm,
        _at_its_first_speed,
        _for_whom,
        _comes_into_view,
        _right_behind,
        _in_slow_row,
    ):
        made.each(rule)
    stand_before_ego(made)
    return made


def _turn_where_the_road_ends(made: Restated) -> None:
    """An ego whose road ends at a junction turns there."""
    ego = made.situation.ego
    if made.situation.road.kind in ENDS_THERE and ego.route is None:
        made.situation = replace(made.situation, ego=replace(ego, route=EgoRoute.TURN))


def _fills_its_row(made: Restated, one: Other) -> Other:
    """Of a row that was said to be so long there are as many as stand in it.

    Raises:
        NotBuilt: They move, or more would stand in it than is built.
    """
    if one.stretch is None:
        return one
    at, length = f"others.{one.id}.stretch", one.row.limits.length
    if not stands_first(one):
        raise NotBuilt(f"{at}: only a row of those who stand at first has a length; say distances of who moves")
    apart = PARKED_APART if one.starts.where is Where.KERB else ROOM
    many = max(2, round((one.stretch.near(one.stretch.least) + apart) / (length + apart)))
    if one.count not in (SEVERAL, 1, many):
        least, most = (n * length + (n - 1) * apart for n in (one.count, one.count + 1))
        raise NotBuilt(f"{at}: {one.stretch}: {one.count} of {one.id} make a row of {least:.0f} to {most:.0f} m")
    if many > MOST:
        raise NotBuilt(f"{at}: {one.stretch} is more than a row of {MOST}: {MOST * (length + apart) - apart:.0f} m")
    made.taken.append(at)
    made.assumed.append(f"there are {many} of {one.id}, as many as stand in {one.stretch}")
    return replace(one, count=many)


def _comes_aside(_: Restated, one: Other) -> Other:
    """How fast somebody comes aside is no speed along the road: how it is done reads it from what was said."""
    aside = [one.speed_aside(k) is not None for k in range(len(one.does))]
    does = (replace(deed, speed=None) if aside[k] else deed for k, deed in enumerate(one.does))
    return replace(one, does=tuple(does)) if any(aside) else one


def _keeps_aside(made: Restated, one: Other) -> Other:
    """Who goes on from the first where it was said to be across the road starts there."""
    first = one.does[0] if one.does else None
    if first is None or first.act is not Act.GO_ALONG or first.lateral is None or first.when is not None:
        return one
    if one.starts.lateral is not None or one.starts.where not in PLACED:
        return one
    made.taken.append(f"others.{one.id}.does.0.lateral")
    does = (replace(first, lateral=None), *one.does[1:])
    return replace(one, starts=replace(one.starts, lateral=first.lateral), does=does)


def _at_its_first_speed(made: Restated, one: Other) -> Other:
    """A speed at the start is the speed that the first deed begins with; of one that keeps it, it is said once."""
    first = one.does[0] if one.does else None
    if one.starts.where is Where.ROADSIDE and one.kind.moves is not Moves.WALKS:
        return _over_the_road(one)
    if first is None or first.speed is None or first.act not in AT_ONE_SPEED or first.speed != one.starts.speed:
        return one
    made.taken.append(f"others.{one.id}.does.0.speed")
    return replace(one, does=(replace(first, speed=None), *one.does[1:]))


def _over_the_road(one: Other) -> Other:
    """Who rides over the road is built to come at a speed and to keep it: the speed at which it is said to cross."""
    first = one.does[0] if one.does else None
    if first is None or first.act is not Act.CROSS or first.speed is None or one.starts.speed is not None:
        return one
    if first.speed.than_ego or first.speed.low > one.row.limits.fastest:
        return one  # which is refused as it was said
    return replace(one, starts=replace(one.starts, speed=first.speed))


def _on_foot_against(made: Restated, one: Other) -> Other:
    """Who comes the other way on foot is ahead, and faces the ego."""
    start = one.starts
    if one.kind.moves is not Moves.WALKS or start.where not in _AGAINST or start.facing not in (None, Facing.AGAINST):
        return one
    if start.where is Where.ONCOMING:  # beside the road, where people walk who are not said to be in a lane
        start = replace(start, where=Where.ROADSIDE, side=start.side or Side.LEFT, facing=Facing.AGAINST)
        made.assumed.append(f"{one.id} is beside the road, on the {start.side}")
    else:
        start = replace(start, where=Where.AHEAD, facing=Facing.AGAINST)
    return replace(one, starts=start)


def _on_foot_at_arm(made: Restated, one: Other) -> Other:
    """Who is on foot at a side road crosses that where the ego turns into it, or where it goes past it."""
    start, route = one.starts, made.situation.ego.route
    if one.kind.moves is not Moves.WALKS or start.where is not Where.ARM:
        return one
    crosses = any(deed.act is Act.CROSS for deed in one.does)
    if route is not None and route in _TO_SIDE and start.side in (None, _TO_SIDE[route]):
        return replace(one, starts=replace(start, where=Where.EXIT_CROSSING, side=None))
    if one.role is Role.ADVERSARY:
        made.assumed.append(f"{one.id} is at our road before the junction, which it crosses to meet us")
        return replace(one, starts=replace(start, where=Where.CROSSING))
    does = tuple(replace(deed, act=Act.GO_ALONG) if deed.act is Act.CROSS else deed for deed in one.does)
    if crosses:
        made.assumed.append(f"{one.id} crosses the side road along ours")
    return replace(one, starts=replace(start, where=Where.CROSSING, facing=Facing.ALONG), does=does)


def _for_whom(made: Restated, one: Other) -> Other:
    """What is done for somebody begins while that one does what it is done for."""
    does: list[Deed] = []
    for k, deed in enumerate(one.does):
        if deed.whom is None or deed.act not in FOR_SOMEBODY:
            does.append(deed)
            continue
        made.taken.append(f"others.{one.id}.does.{k}.whom")
        if deed.act in SIDEWAYS and deed.whom not in (EGO, one.id):
            does.append(deed)  # by which it goes round that one
            continue
        reference = _seen_of(made.situation, one, deed) if deed.when is None else None
        does.append(replace(deed, whom=None, when=deed.when if reference is None else When(during=reference)))
        if reference is None and deed.when is None and deed.whom != EGO:
            made.assumed.append(f"{one.id}'s {deed.act} comes in its order and does not wait for {deed.whom}")
        elif deed.when is not None and deed.whom not in (EGO, one.id):
            made.assumed.append(untimed(one, deed))
    return replace(one, does=tuple(does))


def untimed(one: Other, deed: Deed) -> str:
    """That somebody does something when it was said to, and not by whom it does it for, in words."""
    return f"{one.id}'s {deed.act} comes when it was said to and does not wait for {deed.whom}"


def _comes_into_view(made: Restated, one: Other) -> Other:
    """Who is hidden on an arm until the ego is too near for it to set off comes driving, and is seen that late."""
    first = one.does[0] if one.does else None
    near = first.when.ego_within if first is not None and first.when is not None else None
    if first is None or near is None or one.hidden_by is None or one.starts.where is not Where.ARM:
        return one
    row, when = one.kind.row.body.row, first.when
    if when is None or when.of not in (None, one.id) or when.after or when.during or one.starts.speed is not None:
        return one
    wish = first.speed or Speed(0.55 * row.fast, 0.82 * row.fast)
    has = near.most / wanted_by(made.situation) if isinstance(near, Length) else near.most
    if Body(row.limits, walks=False).covers(FROM_LINE + 0.5 * row.limits.length, wish.most) - EGO_FIRST <= has:
        return one
    made.taken.append(f"others.{one.id}.does.0.when.ego_within")
    made.assumed.append(f"{one.id} drives from the start, and {one.hidden_by} hides it until late")
    does = (replace(first, when=None, speed=None), *one.does[1:])
    made.taken += [f"others.{one.id}.does.0.speed"] * (first.speed is not None)
    return replace(one, starts=replace(one.starts, speed=wish), does=does)


def _in_slow_row(made: Restated, one: Other) -> Other:
    """Who comes out of a lane in which others queue goes as slowly as those, before."""
    start = one.starts
    own = one.count == 1 and start.where in NEXT_LANE and start.side is not None and start.speed is None
    if not own or not one.kind.row.body.row.motorised or stands_first(one) or any(deed.speed for deed in one.does):
        return one
    for row in made.situation.others:
        in_lane = row.count != 1 and row.starts.where in NEXT_LANE and row.starts.side is start.side
        slow = slow_speed(row) if in_lane and not stands_first(row) else None
        if slow is not None and slow < QUEUES * wanted_by(made.situation):
            made.assumed.append(f"{one.id} goes as slowly as {row.id}, in whose lane it is")
            return replace(one, starts=replace(start, speed=Speed(slow, slow)))
    return one


def _right_behind(made: Restated, one: Other) -> Other:
    """Who does what another does from the same place, and after that one, comes right behind it."""
    first = one.does[0] if one.does else None
    when = first.when if first is not None else None
    if first is None or when is None or when.after is None or when != When(after=when.after) or stands_first(one):
        return one
    before = when.after.partition(".")[0]
    if before in (EGO, one.id) or first.act not in PLAIN:
        return one
    other, does = made.situation[before], made.situation.deed(when.after)
    alike = other.starts.where is one.starts.where and other.starts.side is one.starts.side and not stands_first(other)
    if not alike or does is not other.does[0] or does.act is not first.act or does.when is not None:
        return one
    made.taken.append(f"others.{one.id}.does.0.when")
    made.assumed.append(f"{one.id} comes right behind {before}")
    return replace(one, does=(replace(first, when=None), *one.does[1:]))


def _seen_of(situation: Situation, one: Other, deed: Deed) -> str | None:
    """The deed of somebody for which another does something, if it is seen that it is done."""
    if deed.whom in (None, EGO, one.id):
        return None
    other = situation[str(deed.whom)]
    waits = {
        reference.partition(".")[0]
        for then in other.does
        if then.when is not None
        for reference in (then.when.after, then.when.during)
        if reference is not None
    }
    seen = (k for k, then in enumerate(other.does) if not then.act.row.lasting and then.act in SIGNS)
    first = next(seen, None)
    return None if first is None or one.id in waits or stands_first(one) else f"{other.id}.{first}"


def _met_at_a_point(made: Restated) -> None:
    """Who is met in the ego's lane at a point of the ego's width stands or goes so far aside, which is an overlap."""
    situation, contact = made.situation, made.situation.contact
    if contact is None or contact.at is None or contact.behind_nose is not None:
        return
    for one in situation.adversaries:
        lateral = one.starts.lateral or Lateral()
        free = all(getattr(lateral, name) is None for name in LATERALS)
        if not free or contact.whom not in (None, one.id) or one.starts.where not in _IN_LINE:
            continue
        made.taken += ["contact.at", f"others.{one.id}.starts.lateral"]
        placed = replace(one, starts=replace(one.starts, lateral=replace(lateral, overlap=contact.at)))
        others = tuple(placed if other is one else other for other in situation.others)
        made.situation = replace(situation, others=others, contact=replace(contact, at=None))
        return


def _go_past(made: Restated) -> None:
    """An ego that overtakes: that is its way, unless whom it passes is beside it."""
    ego, situation = made.situation.ego, made.situation
    does: list[Deed] = []
    route = ego.route
    for k, deed in enumerate(ego.does):
        of_itself = deed.act in FOR_SOMEBODY and deed.act not in SLOWS and deed.whom == EGO
        made.taken += [f"ego.does.{k}.whom"] * of_itself
        route = _way_past(situation, deed, route) if deed.act is Act.OVERTAKE else route
        does.append(_off_at_a_rate(ego.does, k, replace(deed, whom=None) if of_itself else deed))
    made.situation = replace(situation, ego=replace(ego, route=route, does=tuple(does)))
    for k, (was, now) in enumerate(zip(ego.does, does, strict=True)):
        if was.act is not now.act:  # others name it as it was called
            made.each(lambda _, one, old=f"{EGO}.{was.act}", new=f"{EGO}.{k}": _naming(one, old, new))


def _over_when_told(made: Restated) -> None:
    """An ego that changes lanes once another does something: not its way, which waits for nobody, but its own deed."""
    ego = made.situation.ego
    if ego.route is None or not changes_later(ego):
        return
    usual = GOES_OVER.get(ego.route, Side.LEFT)
    does = tuple(
        replace(deed, to=usual) if deed.act is Act.LANE_CHANGE and deed.to is None else deed for deed in ego.does
    )
    made.taken.append("ego.route")
    made.situation = replace(made.situation, ego=replace(ego, route=EgoRoute.STRAIGHT, does=does))


def _naming(one: Other, old: str, new: str) -> Other:
    """Somebody whose deeds name a deed otherwise."""

    def named(deed: Deed) -> Deed:
        if (when := deed.when) is None or old not in (when.after, when.during):
            return deed
        after, during = (new if name == old else name for name in (when.after, when.during))
        return replace(deed, when=replace(when, after=after, during=during))

    return replace(one, does=tuple(map(named, one.does)))


def _off_at_a_rate(does: tuple[Deed, ...], k: int, deed: Deed) -> Deed:
    """An ego that sets off as hard as was said gains speed so from where it stood."""
    stood = k > 0 and does[k - 1].act is Act.STAND and deed.when is None
    gains = deed.act is Act.SET_OFF and deed.acceleration is not None
    return replace(deed, act=Act.ACCELERATE) if stood and gains else deed


def _way_past(situation: Situation, deed: Deed, route: EgoRoute | None) -> EgoRoute | None:
    passed = [one for one in situation.others if one.starts.where in OVERTAKEN and deed.whom in (None, one.id)]
    beside = bool(passed) and all(one.starts.where in NEXT_LANE for one in passed)
    return EgoRoute.OVERTAKE if route in (None, EgoRoute.STRAIGHT) and passed and not beside else route


def is_way(ego: Ego, deed: Deed) -> bool:
    """Whether an overtaking of the ego is the way it goes."""
    return deed.act is Act.OVERTAKE and ego.route in (EgoRoute.OVERTAKE, EgoRoute.BYPASS)
