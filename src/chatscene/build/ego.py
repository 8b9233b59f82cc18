"""The ego of a program: the speed it wants, where it begins, and the orders by which it does what was said of it."""

from __future__ import annotations

import math
from collections.abc import Generator, Iterator, Mapping, Sequence
from dataclasses import dataclass, fields, replace
from itertools import takewhile

from chatscene.build.asked import FROM_A_STAND, ROOM, is_still, stands_first
from chatscene.build.awaiting import awaited, waiting
from chatscene.build.coming import Coming, coming, free_speed, keeps_limits, wanted_by
from chatscene.build.halting import line_before
from chatscene.build.ledger import Ledger
from chatscene.build.numbers import FIRM, rigid, strong, stronger
from chatscene.build.own import FIRST, KEEPS, LATER, Drives, fastest, is_own, own_orders
from chatscene.build.own_speeds import at_own_speeds
from chatscene.build.place import GOES_OVER, NEXT_LANE, Found, at_junction, changed_at, merged_at
from chatscene.build.relations import PASSES, speed_of
from chatscene.build.restated import is_way
from chatscene.build.standing_before import halts, keeps_in_lane, stops_on_its_way_round
from chatscene.build.struck import STANDS_FOR, creeps_at, gives_way, slows_turning
from chatscene.errors import NotBuilt, NothingBuilds
from chatscene.maps.routes import TO_LINE
from chatscene.situations.phrases import one_of
from chatscene.terms.actors import LIMITS, REVERSE_SPEED
from chatscene.terms.actors import Manner as Moves
from chatscene.terms.backing import backs
from chatscene.terms.conclusions import JUNCTIONS
from chatscene.terms.order import Order
from chatscene.terms.pace import NOMINAL, gain_in
from chatscene.terms.route import Beside
from chatscene.terms.routing import BEGINS, ENDS
from chatscene.terms.scenario import Maneuver
from chatscene.terms.scene import CAR
from chatscene.terms.situation import EGO, Deed, Situation
from chatscene.terms.vocabulary import (
    CHANGES,
    GOES_ON,
    Act,
    Breach,
    EgoLight,
    EgoRoute,
    Heads,
    Manner,
    Side,
    Tempo,
    UserKind,
    Where,
    acts_of,
)
from chatscene.world.ego_route import EgoRoute as Route

LINE = 3.5  # [m] before the junction the centre of a car stands whose nose is at the line
STOPS_WITHIN = 2.0  # [s] before somebody who does so from the start, that an ego begins to stop for that
HALTS = 5.0  # [m/s²] with which an ego stops before what others do then
STAND = 4.0  # [s] that somebody stands who sets off again
BESIDE = 3.0  # [s] that the ego stands beside its lane before it comes into it
SLOW = 3.0  # [m/s]
EASED = 0.4  # of its speed that an ego keeps that loses some before it does something with its wheel
AT_ONCE = 0.1  # [s] after which an ego begins to lose speed that waited for somebody
SLOWED = 1.0  # [s] that it has lost speed, so that it is seen to, when it does something else
GOES_THROUGH, THROUGH = 5.0, 14.0  # [m/s], [m] before and beyond where it is to give way, that an ego goes on
TURNING = 3.0  # [m] beyond where the junction begins, an ego is seen to turn
OVER_LANE, INTO_TURN = 3.0, 9.0  # [m] on its way into a lane, or through a turn, that an ego is across a lane
UP, UP_FOR, UP_AFTER = 1.5, 2.5, 1.0  # [m/s], [s] that an ego goes back, and [s] that it has stood before
UP_GAIN = 2.0  # [m/s²] about with which it gets there
_OVER_BY_ITS_WAY = CHANGES | {EgoRoute.MERGE}
_BESIDE_ROAD = frozenset((*BEGINS, *ENDS))
BACKS = 20.0  # [m] at most that an ego backs, if only a bound was said
_DRIVES = GOES_ON | acts_of(Tempo.SETS_OFF, Tempo.GAINS)
_SETS_OFF = acts_of(Tempo.SETS_OFF, Tempo.GAINS, Heads.ALONG, Heads.OVER)
"""What an ego does that has stood."""
EASILY = 0.9  # of a brake, the most that an ego is braked with of which it was not said how hard


@dataclass(frozen=True, slots=True, kw_only=True)
class BuiltEgo:
    """What a program says of its ego.

    Attributes:
        params: Lines before the route is chosen.
        query: What the map is asked for besides.
        coming: How it gets on.
        properties: What stands behind its place.
        orders: What it is held to; those that wait for a deed of somebody name it (`chatscene.build.awaiting`).
    """

    params: tuple[str, ...]
    query: dict[str, float]
    coming: Coming
    properties: str
    orders: tuple[Order, ...]


def ego_of(ledger: Ledger, found: Found, at_most: float = NOMINAL.speed) -> BuiltEgo:
    """What a program says of its ego.

    Args:
        ledger: What was said.
        found: Where it happens.
        at_most: The speed [m/s] that it wants if none was said.

    Raises:
        NotBuilt: It is to do something that no order brings about.
    """
    situation = ledger.situation
    ego, junction = situation.ego, at_junction(situation)
    speed = wanted_by(situation) if ego.speed is not None else at_most
    body = ego.row.limits
    if ego.speed is not None:
        if ego.speed.low > (most := body.fastest):
            what = one_of(ego.kind or UserKind.CAR)
            holds = math.floor(3.6 * most + 1e-9)
            raise NotBuilt(f"ego.speed: {ego.speed} is more than {what} can do: at most {holds} km/h")
        ledger.take("ego.speed")
    if told := stronger("the ego", ego.kind or UserKind.CAR, ego.row):
        ledger.assume(told)
    if ego.row.tows:
        ledger.assume(rigid("the ego", ego.row))
    ledger.take("ego.kind")
    keeps = keeps_limits(situation)
    beside = Ledger(at_own_speeds(situation, speed))
    all_along = [one.at_most for one in _orders(beside, ego.does, 0.0, speed, {}) if _all_along(one)]
    if held := [at_most for at_most in all_along if 0.0 < at_most < math.inf]:
        speed, keeps = min(speed, *held), False  # which is as fast as it ever is
    elif ego.speed is None:  # others are timed by it, so that it is wanted of every ego
        _assume_speed(speed, ledger, found.route if keeps else None, drives=0.0 not in all_along)
    wanted = f", with wantedSpeed {fastest(ego.does, speed):.4g}" + (", with keepsLimits True" if keeps else "")
    stands = bool(ego.does) and ego.does[0].act in FROM_A_STAND
    at_line = stands and junction
    longer = 0.5 * (body.length - LIMITS[CAR].length) + _queue(
        situation, waits=at_line or _halts_at_line(situation, found)
    )  # its nose is so much nearer
    ledger.situation = situation = at_own_speeds(situation, speed)
    _over_in_time(ledger, found.route)
    stop = _stops_at(situation, found, longer, junction=junction, at_line=at_line)
    orders = (
        *_orders(ledger, ego.does, stop, speed, found.sides),
        *_struck_as_it_sets_off(ledger, speed),
        *keeps_in_lane(situation),
    )
    back = backs(situation)
    if (ego.route in BEGINS or back) and not stands:  # others are to come meanwhile
        stands, orders = True, (Order(at_most=0, till=BESIDE), *orders)
        where = "" if ego.route is EgoRoute.REVERSE else " beside its lane"
        ledger.assume(f"the ego first waits{where} for {BESIDE:g} s")
    params = ["param egoStart = 'at-line'"] if at_line else []
    params += _lights(ledger, found)
    at_first = f"speedOn(egoRoute, 0, {speed:.4g})" if keeps else f"{speed:.4g}"
    moving = ", with backwards True" if back else "" if stands else f", with speed {at_first}"
    metres = TO_LINE + longer if at_line else found.route.eventAt
    later, gain = fastest(ego.does, speed), gain_in(body)
    comes = coming(speed, orders, found.route, metres, stands=stands, keeps_limits=keeps, gain=gain, later=later)
    query = {"to_line": round(metres, 2)} if at_line and longer else {}
    return BuiltEgo(
        params=tuple(params), query=query, coming=comes, properties=moving + strong(ego.row) + wanted, orders=orders
    )


def _stops_at(situation: Situation, found: Found, longer: float, *, junction: bool, at_line: bool) -> float:
    """How far [m] along its way an ego is to be slow, or to stand, whose nose is so much nearer [m] to the line."""
    if stops_across(situation.ego.does) and (across := _across(found, junction=junction)) is not None:
        return across
    if (there := stops_on_its_way_round(situation, found.route)) is not None:
        return there
    if junction and slows_turning(situation):
        return found.route.eventAt + TURNING
    if at_line:  # it begins there, and stops again with its nose in the junction
        return TO_LINE + longer
    return found.route.eventAt - (LINE + longer if junction else 0.0)


def _struck_as_it_sets_off(ledger: Ledger, speed: float) -> Iterator[Order]:
    """Orders of an ego that somebody runs into as it sets off: it has stood before, and gets no faster at first."""
    if (creeps := creeps_at(ledger.situation, speed)) is None:
        return
    first, (slow, who) = ledger.situation.ego.does[0], creeps
    stands = STANDS_FOR if first.act is not Act.STAND else _wait(first, ledger.situation.ego.does[1:])
    ledger.assume(f"the ego sets off slowly, at {3.6 * slow:.0f} km/h, because {who} then runs into its rear")
    if first.act is not Act.STAND:
        yield Order(at_most=0, till=stands)
    yield Order(at_most=round(slow, 2), till=2.0 * stands)


def _halts_at_line(situation: Situation, found: Found) -> bool:
    """Whether an ego comes to a stand by its first deed, where a sign or a light has all others stop before it."""
    return halts(situation) is not None and line_before(situation, found) is not None


def _queue(situation: Situation, *, waits: bool) -> float:
    """How much road [m] those take who stand at the line before an ego that waits there, too."""
    ahead = (one for one in situation.others if one.starts.where is Where.AHEAD and one.starts.distance is None)
    return sum(
        (one.count or 2) * (situation.row_of(one).limits.length + ROOM)
        for one in ahead
        if waits and stands_first(one) and one.kind.moves is not Moves.WALKS and not is_still(one)
    )


def _over_in_time(ledger: Ledger, route: Route) -> None:
    """Take within what way the ego is to be in the next lane, by its deed or since its own lane ends then.

    Raises:
        NotBuilt: It is not.
    """
    ego = ledger.situation.ego
    for k, deed in enumerate(ego.does):
        along = deed.act is Act.LANE_CHANGE or (deed.act is Act.GO_ALONG and ego.route is EgoRoute.MERGE)
        if deed.distance is None or not along or ego.route not in _OVER_BY_ITS_WAY:
            continue
        over = merged_at(route) if ego.route is EgoRoute.MERGE else changed_at(route)
        if over > LATER * deed.distance.most:
            raise NotBuilt(
                f"ego.does.{k}.distance: {deed.distance}: at its speed the ego is in the next lane after {over:.0f} m;"
                " say that, or a slower ego"
            )
        ledger.take(f"ego.does.{k}.distance")
        ledger.assume(f"the ego is in the next lane {over:.0f} m after it begins")


def _assume_speed(speed: float, ledger: Ledger, kept: Route | None, *, drives: bool) -> None:
    """Tell what speed [m/s] was chosen for the ego, if it drives at all; `kept` is its route, if it keeps limits."""
    ledger.take("road.speed_limit")
    if drives:
        ledger.assume(_drives_at(speed, ledger, kept))


def _drives_at(speed: float, ledger: Ledger, kept: Route | None) -> str:
    """What a speed [m/s] that was chosen for the ego comes to, in words; `kept` is its route, if it keeps limits."""
    situation, drives, why = ledger.situation, speed, ""
    usual = wanted_by(situation)
    free = usual if backs(situation) else free_speed(situation)
    if speed < usual - 0.01:
        because = (
            "drives show what was said only then" if ledger.slow else f"{3.6 * free:.0f} km/h cannot be built here"
        )
        why = f", since {because}"
    elif usual < free - 0.01:
        why = f", since others do not keep up with {3.6 * free:.0f} km/h"
    if kept is not None:
        way = kept.allowed(keeps_limits=True)[: kept.line.segment_at(kept.eventAt) + 1]
        if (most := float(way.max())) < speed - 0.01:
            drives, why = most, f", all that its road allows ({3.6 * speed:.0f} km/h elsewhere)"
    return f"the ego drives at {3.6 * drives:.0f} km/h{why}"


def ordered(orders: Sequence[Order]) -> str:
    """The orders of an ego, as they stand behind its place."""
    return f", with orders ({', '.join(map(_written, orders))},)" if orders else ""


def _waits_to_set_off(deed: Deed) -> bool:
    """Whether an ego sets off once somebody else does something, before which it stands."""
    return deed.act is Act.SET_OFF and awaited(deed) is not None


def _across(found: Found, *, junction: bool) -> float | None:
    """How far [m] along its way an ego is that stands across the lane that it goes over, or comes into."""
    if found.query.get("begins") in (Beside.DRIVEWAY, Beside.KERB):
        return found.route.eventAt + OVER_LANE
    turns = found.query["maneuver"] in (Maneuver.LEFT_TURN, Maneuver.RIGHT_TURN)
    return TO_LINE + INTO_TURN if junction and turns else None


def stops_across(deeds: tuple[Deed, ...]) -> bool:
    """Whether an ego stops after it had waited: on its way, and not where it waits."""
    acts = [deed.act for deed in deeds]
    begins = next((k for k, act in enumerate(acts) if act in acts_of(Tempo.SETS_OFF, Tempo.WAITS)), None)
    return begins is not None and Act.STOP in acts[begins:] and Act.STOP not in acts[:begins]


def _all_along(order: Order) -> bool:
    """Whether an order holds from the beginning to the end."""
    return order.since <= 0.0 and order.till == order.place * -1 == math.inf and not order.whom


def _written(order: Order) -> str:
    """An order as a program has it."""
    given = {one.name: getattr(order, one.name) for one in fields(Order)}
    usual = {one.name: one.default for one in fields(Order)}
    said = {name: value for name, value in given.items() if repr(value) != repr(usual[name])}
    texts = (f"{name}={value!r}" if isinstance(value, str) else f"{name}={value:.4g}" for name, value in said.items())
    return f"Order({', '.join(texts)})"


def _lights(ledger: Ledger, found: Found) -> list[str]:
    if found.query.get("control") != "signal":
        may_have_lights = found.query.get("place") in JUNCTIONS and "control" not in found.query
        return [f"param signals = 'ego-{EgoLight.GREEN}'"] if may_have_lights else []
    ledger.take("road.ego_light")
    said, others = ledger.situation.road.ego_light, ledger.situation.others
    if said is None and any(deed.breaks is Breach.RED_LIGHT for deed in ledger.situation.ego.does):
        said = EgoLight.RED
    if said is None and not any(deed.breaks is Breach.RED_LIGHT for one in others for deed in one.does):
        ledger.assume("the ego's light is green")
    return [f"param signals = 'ego-{said or EgoLight.GREEN}'"]


def _orders(
    ledger: Ledger, deeds: tuple[Deed, ...], stop: float, speed: float, sides: Mapping[str, Side]
) -> Iterator[Order]:
    begins, slow, stood = 0.0, speed, 0.0  # [s], when what was said with times has gone by; its speed then; its wait
    stops = [k for k, deed in enumerate(deeds) if deed.act is Act.STOP]
    steered: Order | None = None  # from when on it has steered, if that waited for somebody
    for k, deed in enumerate(deeds):
        at = f"ego.does.{k}"
        yield from _waits_first(ledger, deeds, k, stop)
        if along := tuple(_along_its_way(ledger, deed, at, speed)):
            ledger.take(*along)
            yield from _breaks(ledger, deed, at, stop, speed)
            continue
        if is_own(deed):
            if row := _own_from(deeds, k):
                drives = Drives(wants=speed, speed=slow, since=max(begins, stood))
                yield from (own := tuple(own_orders(ledger, row, k, drives, sides)))
                steered = _steered(own)
            continue
        ledger.take(f"{at}.act", *_in_a_row(deed, at))
        yield from _breaks(ledger, deed, at, stop, speed)
        if (answers := ledger.situation.answered(deed)) is not None:  # it does so by itself, as it has to
            ledger.take(f"{at}.whom", *(f"{at}.when.{name}" for name in ("after", "during")), f"{at}.manner")
            told = _stops_for_others(ledger, k, speed) or _as_told(ledger, deed, at, speed)
            yield from told
            if not told:
                ledger.assume(f"the ego's {deed.act} {_for_which(ledger.situation, *answers)} is left to its driver")
            continue
        if ends := tuple(_ends(ledger, deeds, k, steered, stop, speed)):
            yield from ends
            continue
        there = begins * speed if begins else stop  # where it is to be slow, or to stand
        if k in stops and len(stops) > 1:  # one after the other
            there = stop * (stops.index(k) + 1) / len(stops)
        if (then := _own_then(deeds, k)) is not None:
            begins, slow = yield from _slower_before(ledger, deed, at, then, begins or FIRST, speed)
        else:
            begins = yield from _pedals(ledger, deed, at, _then(deeds, k), there, begins, speed)
        stood = _wait(deed, deeds[k + 1 :]) or stood


def _steered(own: tuple[Order, ...]) -> Order | None:
    """An order that begins when the ego has steered by others, if those wait for somebody and end; None if not."""
    waits, till = next((one for one in own if one.whom), None), max((one.till for one in own), default=math.inf)
    return (
        None if waits is None or till == math.inf else replace(Order(), whom=waits.whom, phase=waits.phase, since=till)
    )


def _ends(
    ledger: Ledger, deeds: tuple[Deed, ...], k: int, steered: Order | None, stop: float, speed: float
) -> Iterator[Order]:
    """An ego that backs up, or stops in the end once it has steered by what waited for somebody: wherever that is."""
    if backs_up(ledger.situation, deeds[k]):
        yield from _backs_up(ledger, deeds, k, stop, speed)
    elif steered is not None and deeds[k].act is Act.STOP and k + 1 == len(deeds):
        yield replace(steered, at_most=0, braking=_braking(ledger, deeds[k], f"ego.does.{k}", 3.0))


def _stops_for_others(ledger: Ledger, k: int, speed: float) -> tuple[Order, ...]:
    """Orders to stop once another does something, and to stay, if others act once the ego has; none of any other.

    Whoever drives would stop, too, but perhaps elsewhere, or not for long: and then nothing comes of what others do.
    """
    situation = ledger.situation
    deed, waits = situation.ego.does[k], awaited(situation.ego.does[k])
    if waits is None or deed.act is not Act.STOP or k + 1 < len(situation.ego.does):
        return ()
    whens = (one.when for other in situation.others for one in other.does if one.when is not None)
    named = (name for when in whens for name in (when.after, when.during) if name and name.startswith(f"{EGO}."))
    if all(situation.number_of(name) != k for name in named):
        return ()
    ledger.assume("the ego keeps its lane until it has stopped, because other road users wait for that")
    stops = Order(at_most=0, since=round(speed / HALTS, 2), braking=HALTS, within=STOPS_WITHIN * speed)
    return Order(aside=0.0), waiting(stops, *waits)


def _as_told(ledger: Ledger, deed: Deed, at: str, speed: float) -> tuple[Order, ...]:
    """An order to lose speed by numbers that were said, once another does something; none where none were.

    It ends when the ego has lost it: what comes then is left to its driver.
    """
    waits, said = awaited(deed), deed.speed is not None or deed.acceleration is not None
    if waits is None or not said or deed.act not in acts_of(Tempo.SLOWS, Tempo.BRAKES):
        return ()
    order = _slower(ledger, deed, at, 0.0, AT_ONCE, speed, EASED * speed)
    return (waiting(replace(order, till=round(order.since + SLOWED, 1)), *waits),)


def backs_up(situation: Situation, deed: Deed) -> bool:
    """Whether an ego that drives forwards goes back some way by a deed, on the road."""
    return deed.act is Act.REVERSE and not backs(situation) and situation.ego.route not in _BESIDE_ROAD


def _backs_up(ledger: Ledger, deeds: tuple[Deed, ...], k: int, stop: float, speed: float) -> Iterator[Order]:
    """An ego that comes to a stand, goes back for some time or some way, and stands there or drives on.

    Raises:
        NotBuilt: It cannot go back so fast, or on so short a way.
    """
    deed, at, before = deeds[k], f"ego.does.{k}", deeds[k - 1] if k else None
    ledger.take(f"{at}.whom", f"{at}.manner", *_in_a_row(deed, at))
    back = UP if deed.manner is not Manner.SLIGHT else 0.5 * UP
    if deed.speed is not None:
        ledger.take(f"{at}.speed")
        back = deed.speed.near(UP)
        if back > REVERSE_SPEED:
            most = math.floor(3.6 * REVERSE_SPEED)
            raise NotBuilt(f"{at}.speed: {deed.speed}: the ego cannot back up so fast; say {most} km/h at most")
    lasts = UP_FOR
    if deed.distance is not None:
        ledger.take(f"{at}.distance")
        far = deed.distance.near(UP * UP_FOR)
        if deed.speed is not None and far < back:
            raise NotBuilt(
                f"{at}.distance: {deed.distance} is too short to back up at {deed.speed}; say"
                f" {math.ceil(10 * back) / 10:g} m at least"
            )
        back = min(back, max(0.5, far))  # a short way slowly
        lasts = far / back + back / UP_GAIN
    elif deed.time is not None:
        ledger.take(f"{at}.time")
        lasts = deed.time.near(UP_FOR)
    halted = before is not None and before.act is not Act.STAND
    since = max(stop, 0.0) / speed + speed / 6.0 if halted else 0.0
    since += UP_AFTER if before is None or before.time is None else before.time.near(UP_AFTER)
    waits = awaited(deed)
    if waits is not None:
        ledger.take(f"{at}.when.{waits[0]}")
    since = 0.0 if waits is not None else round(since, 1)
    orders = [Order(back=round(back, 2), since=since, till=round(since + lasts, 1))]
    if k + 1 == len(deeds):
        orders.append(Order(at_most=0, since=round(since + lasts, 1)))
    yield from (order if waits is None else waiting(order, *waits) for order in orders)


def _waits_first(ledger: Ledger, deeds: tuple[Deed, ...], k: int, stop: float) -> Iterator[Order]:
    """An ego that goes on once somebody else does something stands until then."""
    deed = deeds[k]
    if (waits := awaited(deed)) is None or deed.act not in acts_of(Tempo.SETS_OFF, Heads.ALONG):
        return
    name, reference = waits
    if k == 0 and deed.act is Act.GO_ALONG:
        ledger.assume(f"the ego already drives along before {reference}")
    else:
        drives = any(one.act in _DRIVES for one in deeds[:k])  # and so waits where it then stops
        yield waiting(Order(at_most=0, ends=True, place=stop if drives else -math.inf), name, reference)
    ledger.take(f"ego.does.{k}.when.{name}")


def _own_from(deeds: tuple[Deed, ...], k: int) -> tuple[Deed, ...]:
    """The deeds of an ego's own of which the k-th is the first, with all that follow; none if it is not the first."""
    return () if k and is_own(deeds[k - 1]) else tuple(takewhile(is_own, deeds[k:]))


def _own_then(deeds: tuple[Deed, ...], k: int) -> Deed | None:
    """The deed of the ego's own before which it loses speed by its k-th; None if no such deed follows."""
    slows = deeds[k].act in acts_of(Tempo.SLOWS, Tempo.BRAKES)
    return next((then for then in deeds[k + 1 : k + 2] if slows and is_own(then)), None)


def _to_its_side(ledger: Ledger, deed: Deed, at: str) -> Iterator[str]:
    """The path of the side to which the ego changes lanes, if its way does."""
    route = ledger.situation.ego.route
    if route is not None and deed.to is GOES_OVER.get(route, Side.LEFT):
        yield f"{at}.to"


def _for_which(situation: Situation, name: str, reference: str) -> str:
    """What the ego answers by a deed of its own, in words."""
    if name == "whom":
        return f"for {reference}"
    return f"{name} the {situation.deed(reference).act} of {reference.partition('.')[0]}"


def _along_its_way(ledger: Ledger, deed: Deed, at: str, speed: float) -> Iterator[str]:
    """The paths of a deed that is what the ego does by going its way; nothing of others."""
    if deed.act is Act.LANE_CHANGE and ledger.situation.ego.route in _OVER_BY_ITS_WAY:
        yield from (f"{at}.act", f"{at}.manner", *_to_its_side(ledger, deed, at))
    elif deed.act is Act.OVERTAKE:
        yield from _goes_past(ledger, deed, at, speed)


def _goes_past(ledger: Ledger, deed: Deed, at: str, speed: float) -> Iterator[str]:
    """The paths of an overtaking by the ego: its way swings out for it, or it is faster than who is beside it.

    Raises:
        NotBuilt: Its way leads elsewhere, or it is no faster.
    """
    situation = ledger.situation
    if not is_way(situation.ego, deed):
        beside = (one for one in situation.others if one.starts.where in NEXT_LANE and deed.whom in (None, one.id))
        passed = next(beside, None)
        if passed is None:
            raise NothingBuilds(
                f"cannot be built yet: {at}.act: {Act.OVERTAKE}, with ego.route: {situation.ego.route}; say one of them"
            )
        if speed_of(situation, passed.id, speed) > speed - PASSES:
            raise NotBuilt(f"{at}.act: {Act.OVERTAKE}: {passed.id} is as fast as the ego; say a slower {passed.id}")
    yield from (f"{at}.{name}" for name in ("act", "whom", "manner"))
    if deed.to is not Side.RIGHT:
        yield f"{at}.to"


def _breaks(ledger: Ledger, deed: Deed, at: str, stop: float, speed: float) -> Iterator[Order]:
    """An ego that breaks a rule does not slow down for it: no driver sees lights or signs, and all see others."""
    if deed.breaks is not None:
        ledger.take(f"{at}.breaks")
    if deed.breaks is Breach.RIGHT_OF_WAY:
        keeps = min(GOES_THROUGH, KEEPS * speed)
        till = (stop + THROUGH) / keeps
        ledger.assume(f"the ego keeps at least {3.6 * keeps:.0f} km/h until it is through")
        yield Order(at_least=round(keeps, 2), place=round(max(stop - THROUGH, 0.0), 1), till=round(till, 1))


def _wait(deed: Deed, then: tuple[Deed, ...]) -> float:
    """How long [s] an ego stands that stands from the first and sets off then; 0 of any other."""
    sets_off = any(one.act in _SETS_OFF for one in then) and awaited(then[0]) is None
    return (STAND if deed.time is None else deed.time.near(STAND)) if deed.act is Act.STAND and sets_off else 0.0


def _then(deeds: tuple[Deed, ...], k: int) -> Deed | None:
    return deeds[k + 1] if k + 1 < len(deeds) else None


def _pedals(
    ledger: Ledger, deed: Deed, at: str, follows: Deed | None, there: float, begins: float, speed: float
) -> Generator[Order, None, float]:
    """Orders for a deed at the pedals; gives when [s] what was said with times has gone by."""
    then = None if follows is None else follows.act
    again = then in _SETS_OFF
    match deed.act:
        case Act.STAND:
            if follows is not None and _waits_to_set_off(follows):
                return begins
            wait = _seconds(ledger, deed, at)
            yield Order(at_most=0, till=wait if again or deed.time is not None else math.inf)
        case Act.STOP | Act.YIELD if deed.act is Act.STOP or gives_way(ledger.situation):
            till = max(there, 0.0) / speed + speed / 6.0 + _seconds(ledger, deed, at)
            ends = round(till, 1) if again or deed.time is not None else math.inf
            yield Order(at_most=0, place=round(there, 1), till=ends, braking=_braking(ledger, deed, at, 3.0))
        case Act.SLOW_DOWN | Act.BRAKE:
            yield _slower(ledger, deed, at, there, begins, speed)
        case Act.GO_ALONG | Act.FOLLOW if deed.manner is Manner.SLOW or deed.speed is not None:
            said = ledger.situation.ego.speed
            if deed.speed is None and begins <= 0.0 and said is not None and said.low > SLOW:
                raise NotBuilt(f"{at}.manner: slow, with ego.speed: {said}; say only one of the two")
            ledger.take(f"{at}.speed" if deed.speed is not None else f"{at}.manner")
            till = _lasts(ledger, deed, at)
            yield Order(at_most=deed.speed.near(speed) if deed.speed is not None else SLOW, till=begins + till)
            return begins + (till if till < math.inf else 0.0)
        case Act.SET_OFF if deed.speed is not None or deed.manner is Manner.SLOW:  # from where it stood on
            ledger.take(f"{at}.speed", f"{at}.manner")
            stopped = any(one.act is Act.STOP for one in ledger.situation.ego.does)
            yield Order(
                at_most=deed.speed.near(speed) if deed.speed is not None else SLOW,
                place=round(there, 1) if stopped else -math.inf,
            )
        case Act.GO_ALONG if deed.time is not None and then is not None:
            return begins + _lasts(ledger, deed, at)
        case Act.GO_ALONG if _leads_on(deed, there, speed):
            ledger.take(f"{at}.time", f"{at}.distance")
        case _:
            yield from _otherwise(ledger, deed, at, speed)
    return begins


def _leads_on(deed: Deed, there: float, speed: float) -> bool:
    """Whether the ego's way leads as long, or as far, before anything happens."""
    far = [] if deed.time is None else [deed.time.low * speed]
    far += [] if deed.distance is None else [deed.distance.low]
    return bool(far) and max(far) <= there


def _otherwise(ledger: Ledger, deed: Deed, at: str, speed: float) -> Iterator[Order]:
    """What orders nothing, or is the ego's way rather than what it does at the pedals."""
    match deed.act:
        case Act.GO_ALONG | Act.SET_OFF | Act.YIELD | Act.FOLLOW:  # which is left to the ego
            if deed.act is Act.SET_OFF and deed.manner is Manner.SUDDEN:  # it shows that by nothing beforehand
                ledger.take(f"{at}.manner")
        case Act.REVERSE if backs(ledger.situation):
            yield from _backed(ledger, deed, at, speed)
        case _:
            raise NothingBuilds(f"cannot be built yet: {at}.act: {deed.act}")


def _backed(ledger: Ledger, deed: Deed, at: str, speed: float) -> Iterator[Order]:
    """How fast, and how far, an ego backs whose way is driven backwards."""
    if deed.speed is not None:
        ledger.take(f"{at}.speed")
        yield Order(at_most=deed.speed.near(speed))
    elif deed.manner is Manner.SLOW:  # as an ego backs anyway
        ledger.take(f"{at}.manner")
    if deed.distance is not None:
        ledger.take(f"{at}.distance")
        yield Order(at_most=0, place=round(deed.distance.near(BACKS), 1))


def _in_a_row(deed: Deed, at: str) -> Iterator[str]:
    """What holds of its deeds since they come one after the other, each while the one before is under way."""
    for name in ("after", "during"):
        if deed.when is not None and (getattr(deed.when, name) or "").startswith(f"{EGO}."):
            yield f"{at}.when.{name}"
    if deed.act in acts_of(Tempo.WAITS, Heads.BEHIND) and deed.whom not in (None, EGO):
        yield f"{at}.whom"  # to whoever is there it does so anyway


def _slower(
    ledger: Ledger, deed: Deed, at: str, there: float, begins: float, speed: float, usual: float | None = None
) -> Order:
    """An order to lose speed, by some place or for some time; to a usual speed [m/s], if none was said."""
    hard = deed.act is Act.BRAKE
    to = usual or (1.0 if hard else SLOW)
    if deed.speed is not None:
        ledger.take(f"{at}.speed")
        to = deed.speed.near(to)
    braking, lasts = _braking(ledger, deed, at, 6.0 if hard else 2.5), _lasts(ledger, deed, at)
    if lasts < math.inf and deed.acceleration is None and deed.speed is not None:
        braking = max((speed - to) / lasts, 0.1)  # so that it takes as long
    elif lasts < math.inf and deed.speed is None:
        to = max(0.0, speed - braking * lasts)
    if begins:
        return Order(at_most=to, since=round(begins + (speed - to) / braking, 1), braking=braking)
    return Order(at_most=to, place=round(there, 1), braking=braking)


def _slower_before(
    ledger: Ledger, deed: Deed, at: str, then: Deed, begins: float, speed: float
) -> Generator[Order, None, tuple[float, float]]:
    """An order to lose speed before a deed of the ego's own; gives when that begins [s], and its speed then."""
    gains = then.act is Act.ACCELERATE
    order = _slower(ledger, deed, at, 0.0, begins, speed, None if gains else EASED * speed)
    begins = order.since + SLOWED
    yield replace(order, till=begins) if gains else order
    return begins, order.at_most


def _lasts(ledger: Ledger, deed: Deed, at: str) -> float:
    """For how long [s] something goes on; without end where that was not said."""
    return _seconds(ledger, deed, at) if deed.time is not None else math.inf


def _seconds(ledger: Ledger, deed: Deed, at: str) -> float:
    if deed.time is None:
        return STAND
    ledger.take(f"{at}.time")
    return deed.time.near(STAND)


def _braking(ledger: Ledger, deed: Deed, at: str, usual: float) -> float:
    body, kind = ledger.situation.ego.body.row.limits, one_of(ledger.situation.ego.kind or UserKind.CAR)
    if deed.acceleration is None and deed.manner is not None and deed.manner in FIRM:
        ledger.take(f"{at}.manner")
        return min(max(usual, FIRM[deed.manner] * body.brake), EASILY * body.brake)
    usual = min(usual, EASILY * body.brake)
    if deed.acceleration is None:
        return usual
    if deed.acceleration.low > body.brake + body.drag:
        raise NotBuilt(
            f"{at}.acceleration: {deed.acceleration} is more than {kind} can do: at most {body.brake:g} m/s²"
        )
    ledger.take(f"{at}.acceleration")
    return deed.acceleration.near(usual)
