"""What a deed waits for: another that was done or goes on, or that the ego is near."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from chatscene.build.asked import goes_slowly, stands_first
from chatscene.build.deeds import OWN
from chatscene.build.naming import name_of
from chatscene.build.numbers import RANGES, Numbers
from chatscene.build.over_lanes import lane_after
from chatscene.build.own import ASIDE
from chatscene.build.place import NEXT_LANE
from chatscene.build.possible import OFF_ROAD
from chatscene.build.relations import AGAINST, Relation, relation_of, said_speed
from chatscene.errors import NothingBuilds
from chatscene.terms.situation import EGO, Deed, Other, Situation, When
from chatscene.terms.vocabulary import (
    ALONG_THE_ROAD,
    CHANGES,
    COMES_OVER,
    HALTS,
    LOSES,
    NOSE_TO_TAIL,
    Act,
    EgoRoute,
    Heads,
    Tempo,
    Where,
    acts_of,
    by_act,
)

if TYPE_CHECKING:
    from chatscene.build.actor import Actor


LONGEST_DELAY = 5.0  # [s], where it was only said how long at least
TURNS_OUT = 1.2  # [s] in which somebody at speed is clear of what stands in the lane that it leaves
UNDER_WAY, STILL = 0.3, 0.1  # [m/s]
OVER_OURS, BEFORE_IT = 2.4, 2.0  # [m] from the ego's line, and before the junction, who has gone through that
SEEN_BEFORE = 1.5  # [s] for which somebody is seen before the ego is as near as was said
COMES_NEAR = 40.0  # [m] from somebody who waits for one who goes along from the first
CLOSES_IN = 0.9  # of the ego's speed: on who is slower the ego closes in


@dataclass(frozen=True, slots=True)
class Sign:
    """What is seen of a deed of somebody else, so that a plan can wait for it.

    In texts ``{who}`` is who does it, ``{whom}`` to whom, ``{usual}`` the speed [m/s] that it has before, ``{k}`` the
    number of the deed.

    Attributes:
        begun: What is seen once it is under way.
        done: What is seen once it was done; empty for the same.
    """

    begun: str
    done: str = ""

    @property
    def aside(self) -> bool:
        """Whether it is seen by where somebody is to the side."""
        return "offset" in self.begun

    def text(self, *, done: bool) -> str:
        """What is seen once it was done, or once it is under way."""
        return self.done or self.begun if done else self.begun


_IN = Sign("abs(offsetFrom(egoRoute, {who})) < 2.4", "abs(offsetFrom(egoRoute, {who})) < 1.3")
_LEAVES_FOR_OURS = Sign("abs(offsetFrom(way{who}, {who})) > 0.3", _IN.done)
"""Of who comes over from the next lane, and leaves its own as it begins."""
_ASIDE = Sign("abs(offsetFrom(way{who}, {who})) > 0.6", "abs(offsetFrom(way{who}, {who})) > 0.9")
_OVER = Sign("abs(offsetFrom(egoRoute, {who})) > 0.8", "abs(offsetFrom(egoRoute, {who})) > 2.2")
_OVER_ITS_OWN = Sign("abs(offsetFrom(way{who}, {who})) > 0.8", "abs(offsetFrom(way{who}, {who})) > 2.2")
_NEAR = "(ego.length + {who}.length) / 2"
_STANDS = Sign("{who}.pose[3] < 0.1")
_OF: dict[Tempo | Heads | Act, Sign] = {
    Tempo.HALTS: Sign("{who}.pose[3] < 0.8 * {usual}", "{who}.pose[3] < 0.1"),
    **dict.fromkeys((Tempo.STANDS, Tempo.WAITS, Tempo.LIES, Heads.EDGE), _STANDS),
    Tempo.BRAKES: Sign("{who}.pose[3] < 0.8 * {usual}", "{who}.pose[3] < 0.4 * {usual}"),
    Tempo.SLOWS: Sign("{who}.pose[3] < 0.85 * {usual}", "{who}.pose[3] < 0.65 * {usual}"),
    Tempo.PAUSES: Sign("{who}.pose[3] < 0.5"),
    Tempo.GAINS: Sign("{who}.pose[3] > {usual} + 0.5", "{who}.pose[3] > {usual} + 1.5"),
    Tempo.BACKS: Sign("{who}.pose[3] < -0.3"),
    **dict.fromkeys((Tempo.SETS_OFF, Heads.ALONG, Heads.THROUGH, Heads.BEHIND), Sign("{who}.pose[3] > 0.5")),
    **dict.fromkeys((Heads.ACROSS, Heads.IN, Heads.FROM_EDGE, Heads.BEFORE, Heads.MERGES, Heads.TURNS), _IN),
    **dict.fromkeys((Heads.ASIDE, Heads.DRIFTS, Heads.SWINGS), _ASIDE),
    Heads.OUT: _OVER,
    **dict.fromkeys((Heads.ROUND, Heads.OFF), _OVER_ITS_OWN),
    Heads.BY: Sign(
        f"headway(way{{who}}, {{whom}}, {{who}}) > -{_NEAR} - 3", f"headway(way{{who}}, {{whom}}, {{who}}) > {_NEAR}"
    ),
    Act.LOSE_CONTROL: Sign(_ASIDE.begun, "{who}.pose[3] < 0.5 * {usual}"),
    Act.LEAVE_ROAD: Sign(_ASIDE.begun, "abs(offsetFrom(way{who}, {who})) > 2"),
    Act.OPEN_DOOR: Sign("abs(offsetFrom(way{who}, {who}_door_{k})) > 0.7"),
    Act.DROP_LOAD: Sign("{who}_load_{k}.pose[3] < 0.9 * {who}.pose[3]"),
    **dict.fromkeys((Heads.CLOSE, Heads.LEVEL), Sign(f"gap({{whom}}, {{who}}) < {_NEAR} + 8")),
}
SIGNS = by_act(_OF)
"""Deeds of somebody else, or of the ego, that a plan can wait for."""
_STILL = acts_of(Tempo.HALTS, Tempo.STANDS, Tempo.WAITS, Tempo.PAUSES, Tempo.LIES)
_LOSES_SOME, _GAINS = acts_of(Tempo.BRAKES, Tempo.SLOWS), acts_of(Tempo.GAINS)
_SETS_OFF = acts_of(Tempo.SETS_OFF, Heads.ALONG, Heads.THROUGH, Heads.BEHIND)
_GOES_ON = acts_of(Tempo.STANDS, Heads.ALONG)
"""What ends when the next deed begins, and by nothing else that is seen."""
MOST_OF, HALF = 0.9, 0.5  # of a number that was said: a deed is done by then, or seen to be under way
_UNDER_WAY_FIRST = NEXT_LANE | AGAINST | {Where.AHEAD, Where.BEHIND, Where.ON_RAMP}
"""Where somebody who does not stand goes from the first."""


def when_of(actor: Actor, k: int, when: When, meanwhile: str) -> Iterator[str]:
    """The phases in which somebody waits for a deed of its own to be due.

    Args:
        actor: Who.
        k: The number of its deed.
        when: What it waits for.
        meanwhile: What it does until then.

    Raises:
        NotBuilt: What it waits for cannot be seen.
    """
    at = f"{actor.path}.does.{k}.when"
    for name, reference in (("after", when.after), ("during", when.during)):
        if reference is None:
            continue
        yield from (f"{meanwhile} until {condition}" for condition in _seen(actor, k, name, reference))
        actor.ledger.take(f"{at}.{name}")
    if when.delay is not None:
        _check_delay(actor, k, when)
        low, high = when.delay.drawn(0.0, LONGEST_DELAY)
        actor.numbers.measure(f"DELAY_{k}", low, high, "s", "how long after that it begins", f"{at}.delay")
        yield f"{meanwhile} for $DELAY_{k} seconds"
    if when.ego_within is not None:
        near = _near(actor, k, when)
        _start_far_enough(actor, k, when)
        yield f"{meanwhile} until {near}{_or_must(actor, k, when)}"


def _or_must(actor: Actor, k: int, when: When) -> str:
    """Who leaves the ego's lane before somebody who stands there does so in time, however the ego comes."""
    leaves = actor.deeds[k].act in acts_of(Heads.OUT, Heads.OVER) and actor.one.starts.where is Where.AHEAD
    if when.of is None or not leaves or not stands_first(actor.ledger.situation[when.of]):
        return ""
    name = name_of(when.of)
    room = f"(self.length + {name}.length) / 2 + {TURNS_OUT:g} * self.pose[3]"
    return f" or headway(egoRoute, self, {name}) < {room}"


def _start_far_enough(actor: Actor, k: int, when: When) -> None:
    """Let somebody on whom the ego closes in begin so far ahead that the ego is not as near as was said from the first.

    Who goes as fast as the ego begins as near as was said, or it never would be.
    """
    start, said, numbers = actor.one.starts, when.ego_within, actor.numbers
    if start.distance is not None or actor.first is not None or when.of is not None or said is None:
        return
    if start.where not in (Where.AHEAD, Where.AHEAD_BESIDE, Where.KERB) or "Y" not in numbers.ranges:
        return
    stands = stands_first(actor.one) or start.where is Where.KERB
    own = 0.0 if stands else numbers.middle("SPEED") if numbers.is_said("SPEED") else actor.ego_speed
    closing = actor.ego_speed - own
    if k or closing < (1.0 - CLOSES_IN) * actor.ego_speed:
        return
    nearest = numbers.range_of(f"NEAR_{k}")[1] * (closing if said.QUANTITY == "duration" else 1.0)
    low = nearest + 0.5 * (actor.ego_limits.length + actor.limits.length) + SEEN_BEFORE * closing
    far, most, unit, meaning = numbers.range_of("Y")
    numbers.measure("Y", max(far, low), max(most, low + closing), unit, meaning)
    numbers.held.add("Y")


def _near(actor: Actor, k: int, when: When) -> str:
    """What shows that the ego is as near as was said: its front to the tail of who is on its way, or to where that is.

    In seconds to who stands or goes slower, or comes against the ego along its road, it is the time to collision; to
    who goes as fast, the headway.
    """
    at, near, said = f"{actor.path}.does.{k}.when", f"NEAR_{k}", when.ego_within
    assert said is not None
    seconds = said.QUANTITY == "duration"
    least, most = said.drawn(*RANGES["LEAD_TIME" if seconds else "NEAR"][:2])
    unit = "s" if seconds else "m"
    actor.numbers.measure(near, least, most, unit, "how near the ego is when it acts", f"{at}.ego_within")
    situation = actor.ledger.situation
    whom = actor.one if when.of is None else situation[when.of]
    if when.of is not None:
        actor.ledger.take(f"{at}.of")
    name = "self" if whom is actor.one or whom.id == actor.one.id else name_of(whom.id)
    if whom.starts.where in AGAINST and (not seconds or actor.deeds[k].act in ALONG_THE_ROAD):
        closing = f" * ({name}.pose[3] + ego.pose[3])" if seconds else ""
        return f"gap({name}, ego) - (ego.length + {name}.length) / 2 < ${near}{closing}"
    if whom.starts.where not in NOSE_TO_TAIL | {Where.KERB, Where.BUS_BAY}:
        there = f"progressOn(egoRoute, {name})[0] - ego.length / 2"
        if seconds:
            return f"secondsTo(egoRoute, ego, {there}) < ${near}"
        beside = whom.starts.where in OFF_ROAD
        return f"distanceLeft(egoRoute, ego, {there}) < ${near}" if beside else f"gap({name}, ego) < ${near}"
    behind = whom.starts.where in (Where.BEHIND, Where.BEHIND_BESIDE)
    ends = (name, EGO) if behind else (EGO, name)
    room = f"headway(egoRoute, {ends[0]}, {ends[1]}) - (ego.length + {name}.length) / 2"
    if not seconds:
        return f"{room} < ${near}"
    faster = f"{ends[0]}.pose[3]"
    if _is_slower(actor, whom) and not behind:
        faster = f"({faster} - {ends[1]}.pose[3])"
    return f"{room} < ${near} * {faster}"


def _is_slower(actor: Actor, whom: Other) -> bool:
    """Whether the ego closes in on somebody, by what was said of its speed."""
    if stands_first(whom):
        return False  # which is the same, and does not end when it sets off
    said = whom.starts.speed
    return said is not None and said.least < CLOSES_IN * actor.ego_speed


def _check_delay(actor: Actor, k: int, when: When) -> None:
    """Hold that a delay after a deed of its own counts from the end of the one before, which alone is timed.

    Raises:
        NotBuilt: It counts from another moment.
    """
    for name, reference in (("after", when.after), ("during", when.during)):
        if reference is None or reference.partition(".")[0] != actor.one.id:
            continue
        if name == "during" or actor.ledger.situation.number_of(reference) != k - 1:
            raise NothingBuilds(
                f"cannot be built yet: {actor.path}.does.{k}.when.delay: {when.delay}, {name} {reference}; "
                f"say it after {actor.one.id}.{k - 1}, the deed before"
            )


def _seen(actor: Actor, k: int, name: str, reference: str) -> tuple[str, ...]:
    """What shows, one after the other, that a deed of somebody is done, or goes on; nothing of its own, before this."""
    who, _, _ = reference.partition(".")
    situation = actor.ledger.situation
    deed = situation.deed(reference)
    at = f"{actor.path}.does.{k}.when.{name}"
    if who == actor.one.id:
        if any(deed is earlier for earlier in actor.deeds[:k]):
            return ()  # its own deeds come one after the other, each while the one before is under way
        raise NothingBuilds(f"cannot be built yet: {at}: {reference}, its own deed")
    does = situation.does(who)
    if name == "during" and deed.act.row.lasting and deed is does[0] and deed.act is not Act.TAILGATE:
        return ()  # what it does from the beginning
    number, done = situation.number_of(reference), name == "after"
    gone = gone_through(situation[who], deed.act) if done and who != EGO else ()
    signs = gone or (_of_ego(actor, deed, done=done) if who == EGO else _in_turn(actor, who, number, done=done))
    if signs is None:
        raise NothingBuilds(
            f"cannot be built yet: {at}: {reference}: it cannot be seen when {deed.act} happens; "
            "wait for another deed, or say ego_within"
        )
    waits = who != EGO and (situation[who].starts.where in OFF_ROAD or stands_first(situation[who]))
    first = deed is next((one for one in does if one.act is not Act.STAND), None)
    delayed = (own := actor.deeds[k].when) is not None and own.delay is not None
    if name == "during" and delayed and waits and first:
        return (f"{name_of(who)}.pose[3] > {UNDER_WAY:g}",)  # from when it begins, not from when it is seen to
    return signs


def _of_ego(actor: Actor, deed: Deed, *, done: bool) -> tuple[str, ...] | None:
    """What shows, one after the other, that a deed of the ego is done, or goes on; None where nothing does.

    What the ego waits for comes first: it may be aside, or slow, before that.
    """
    sign, before = SIGNS.get(deed.act), _ego_waits_for(actor, deed)
    if deed.act in ASIDE:  # of its way, or of its lane if its way leads to another
        changes = deed.act is Act.LANE_CHANGE and actor.ledger.situation.ego.route in CHANGES
        line, over = (OWN, 2) if changes else ("egoRoute", 1)
        sign = Sign(f"abs(offsetFrom({line}, ego)) > 0.5", f"abs(offsetFrom({line}, ego)) > {over}")
    elif deed.act is Act.OVERTAKE and (passed := _passed_by_ego(actor.ledger.situation, deed)) is not None:
        name = name_of(passed.id)
        by = f"headway(egoRoute, {name}, ego) > {_NEAR.format(who=name)}"
        return (*before, by if done else f"abs(offsetFrom({OWN}, ego)) > 0.5")
    elif sign is None or sign.aside:
        return None
    wants = actor.ego_speed
    text = _as_said(sign, deed, wants, done=done).format(
        who=EGO, whom=name_of(deed.whom or EGO), usual=f"{wants:.3g}", k=0
    )
    return (*before, f"{text} and progressOn(egoRoute, ego)[0] > 1" if deed.act in HALTS else text)


def _ego_waits_for(actor: Actor, deed: Deed) -> tuple[str, ...]:
    """What shows, one after the other, that the ego has what it waits for with a deed; nothing of others' own deeds."""
    situation, reference = actor.ledger.situation, None if deed.when is None else deed.when.after
    who = EGO if reference is None else reference.partition(".")[0]
    if reference is None or who in (EGO, actor.one.id):
        return ()
    return _in_turn(actor, who, situation.number_of(reference), done=True) or ()


def gone_through(one: Other, act: Act) -> tuple[str, ...]:
    """What shows, one after the other, that somebody has gone straight on through the junction; nothing of others."""
    if act not in acts_of(Heads.THROUGH):
        return ()
    name, where = name_of(one.id), one.starts.where
    if where is Where.ARM:
        aside = f"abs(offsetFrom(egoRoute, {name}))"
        return f"{aside} < {OVER_OURS:g}", f"{aside} > {OVER_OURS:g}"
    if where in AGAINST:
        return (f"progressOn(egoRoute, {name})[0] < egoRoute.eventAt - {BEFORE_IT:g}",)
    if where in _UNDER_WAY_FIRST:
        return (f"progressOn(egoRoute, {name})[0] > egoRoute.exitAt",)
    return ()


def _passed_by_ego(situation: Situation, deed: Deed) -> Other | None:
    """Whom the ego overtakes, along whose lane it goes before that."""
    ahead = (one for one in situation.others if one.starts.where is Where.AHEAD and deed.whom in (None, one.id))
    return next(ahead, None)


def _in_turn(actor: Actor, who: str, n: int, *, done: bool) -> tuple[str, ...] | None:
    """What shows, one after the other, that the n-th deed of somebody is done, or goes on.

    None where nothing tells it from what goes before: who stands or is slow then is so already.
    """
    situation, one = actor.ledger.situation, actor.ledger.situation[who]
    does, act = one.does, one.does[n].act
    if done and act in _GOES_ON and n + 1 < len(does):
        return _in_turn(actor, who, n + 1, done=False)
    began = -1 if stands_first(one) or one.starts.where not in _UNDER_WAY_FIRST else None
    stood = max((k for k in range(n) if does[k].act in _STILL), default=began)
    goes = stood is not None and any(deed.act not in _STILL for deed in does[stood + 1 : n])
    first = stood is None or (began is not None and all(deed.act in _STILL for deed in does[: stood + 1]))
    before = () if stood is None or first else _in_turn(actor, who, stood, done=does[stood].act not in _GOES_ON)
    drives = stood is None and one.starts.where in _UNDER_WAY_FIRST
    if before is None:
        return None
    if act in _SETS_OFF and (goes or drives):
        return _in_turn(actor, who, n - 1, done=True) if n and does[n - 1].act not in _GOES_ON else _comes(actor, who)
    if act in _STILL | _LOSES_SOME | _GAINS and (stood is not None or any(deed.act in LOSES for deed in does[:n])):
        return _of_speed(one, n, before, stood=stood is not None, goes=goes)
    sign = _sign_of(situation, one, n)
    if sign is None:
        return None
    usual = _usual(actor, one)
    told = {"who": name_of(who), "whom": name_of(whom) if (whom := does[n].whom or EGO) != EGO else EGO}
    text = _as_said(sign, does[n], usual, done=done).format(**told, usual=f"{usual:.3g}", k=n)
    moved = [k for k in range(n) if (other := _sign_of(situation, one, k)) is not None and other.aside]
    if sign.aside and moved:  # where it is then it may have been before
        before = _in_turn(actor, who, moved[-1], done=True)
    elif act not in _SETS_OFF:
        before = ()
    return None if before is None else (*before, text)


def _comes(actor: Actor, who: str) -> tuple[str, ...] | None:
    """What shows that somebody who goes along from the first has come near to who waits for it.

    None of who does not come toward that one, so that it may be near from the first.
    """
    toward = actor.ledger.situation[who].starts.where in AGAINST | {Where.BEHIND, Where.BEHIND_BESIDE}
    return (f"gap({name_of(who)}, self) < {COMES_NEAR:g}",) if toward else None


def _as_said(sign: Sign, deed: Deed, usual: float, *, done: bool) -> str:
    """What is seen of a deed that may be said with a number: of a speed that is lost to it, or a way to the side."""
    share = MOST_OF if done else HALF
    if deed.act in _LOSES_SOME and deed.speed is not None and not deed.speed.than_ego:
        lost = usual - deed.speed.near(usual)
        return f"{{who}}.pose[3] < {usual - share * lost:.3g}" if lost > 0.0 else sign.text(done=done)
    if sign is _ASIDE and deed.distance is not None:
        return f"abs(offsetFrom(way{{who}}, {{who}})) > {share * deed.distance.near(1.0):.3g}"
    return sign.text(done=done)


def _of_speed(one: Other, n: int, before: tuple[str, ...], *, stood: bool, goes: bool) -> tuple[str, ...] | None:
    """What shows that somebody stands, or gains speed, that was slow or stood before; None of who gets slower.

    Args:
        one: Who.
        n: The number of its deed.
        before: What shows that it stood.
        stood: Whether it did.
        goes: Whether it went on after that.
    """
    act, speed = one.does[n].act, f"{name_of(one.id)}.pose[3]"
    moves, stands = f"{speed} > {UNDER_WAY:g}", f"{speed} < {STILL:g}"
    if act in _GAINS and stood and not goes:
        return (*before, moves)
    if act not in _STILL:
        return None
    return (*before, moves, stands) if stood and goes else before or (stands,)


def _sign_of(situation: Situation, one: Other, n: int) -> Sign | None:
    """What is seen of the n-th deed of somebody; None where nothing is, or it is seen of an earlier one as well."""
    where, act = one.starts.where, one.does[n].act
    sign = SIGNS.get(act)
    if act in acts_of(Heads.TURNS) and where in (Where.AHEAD, Where.BEHIND):
        sign = _OVER if situation.ego.route in (None, EgoRoute.STRAIGHT) else None  # else both turn
    elif act is Act.LANE_CHANGE and where not in AGAINST:
        ours = lane_after(one, one.does, n) == 0
        sign = _IN if ours else _OVER if lane_after(one, one.does, n - 1) == 0 else _OVER_ITS_OWN
    elif act in acts_of(Heads.BY, Heads.OVER) and where in AGAINST:
        sign = _IN
    if sign is _IN and n == 0 and where in NEXT_LANE and act in COMES_OVER:
        sign = _LEAVES_FOR_OURS
    if sign is None or (sign.aside and any(_sign_of(situation, one, k) is sign for k in range(n))):
        return None
    return sign


def _usual(actor: Actor, one: Other) -> float:
    """About how fast [m/s] somebody is before it gains or loses speed."""
    body = actor.ledger.situation.row_of(one)
    numbers = Numbers(one.id, body)
    if (said := said_speed(one, actor.ego_speed)) is not None and said > 0.0:
        return said
    if goes_slowly(one):
        return numbers.middle("SLOW")
    if not body.motorised:
        return numbers.middle("SPEED")
    passed = relation_of(actor.ledger.situation, one) is Relation.PASSED
    share = 0.5 * sum(Relation.PASSED.value) if passed else 1.0
    return min(share * actor.ego_speed, body.limits.fastest)
