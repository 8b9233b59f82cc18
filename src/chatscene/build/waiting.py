"""What a deed waits for: another that was done or goes on, or that the ego is near."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from chatscene.build.asked import stands_first
from chatscene.build.deeds import OWN
from chatscene.build.naming import name_of
from chatscene.build.numbers import MOST, RANGES, Numbers
from chatscene.build.own import ASIDE
from chatscene.build.place import NEXT_LANE
from chatscene.build.possible import OFF_ROAD
from chatscene.build.relations import AGAINST
from chatscene.errors import NothingBuilds
from chatscene.terms.situation import EGO, Deed, Other, When
from chatscene.terms.vocabulary import CHANGES, HALTS, NOSE_TO_TAIL, Act, Heads, Tempo, Where, acts_of, by_act

if TYPE_CHECKING:
    from chatscene.build.actor import Actor


LONGEST_DELAY = 5.0  # [s], where it was only said how long at least
TURNS_OUT = 1.2  # [s] in which somebody at speed is clear of what stands in the lane that it leaves
UNDER_WAY = 0.3  # [m/s]
SEEN_BEFORE = 1.5  # [s] for which somebody is seen before the ego is as near as was said
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


_IN = Sign("abs(offsetFrom(egoRoute, {who})) < 2.4", "abs(offsetFrom(egoRoute, {who})) < 1.3")
_ASIDE = Sign("abs(offsetFrom(way{who}, {who})) > 0.6", "abs(offsetFrom(way{who}, {who})) > 0.9")
_OVER = Sign("abs(offsetFrom(egoRoute, {who})) > 0.8", "abs(offsetFrom(egoRoute, {who})) > 2.2")
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
    Heads.BY: Sign(
        f"headway(way{{who}}, {{whom}}, {{who}}) > -{_NEAR} - 3", f"headway(way{{who}}, {{whom}}, {{who}}) > {_NEAR}"
    ),
    Act.OPEN_DOOR: Sign("abs(offsetFrom(way{who}, {who}_door_{k})) > 0.7"),
    Act.DROP_LOAD: Sign("{who}_load_{k}.pose[3] < 0.9 * {who}.pose[3]"),
    **dict.fromkeys((Heads.CLOSE, Heads.LEVEL), Sign(f"gap({{whom}}, {{who}}) < {_NEAR} + 8")),
}
SIGNS = by_act(_OF)
"""Deeds of somebody else, or of the ego, that a plan can wait for."""


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
        if condition := _seen(actor, k, name, reference):
            yield f"{meanwhile} until {condition}"
        actor.ledger.take(f"{at}.{name}")
    if when.delay is not None:
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


def _near(actor: Actor, k: int, when: When) -> str:
    """What shows that the ego is as near as was said: its front to the tail of who is on its way, or to where that is.

    In seconds to who stands or goes slower it is the time to collision; to who goes as fast, the headway.
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
    if whom.starts.where in AGAINST and not seconds:
        return f"gap({name}, ego) - (ego.length + {name}.length) / 2 < ${near}"
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


def _seen(actor: Actor, k: int, name: str, reference: str) -> str:
    """What shows that a deed of somebody is done, or goes on; empty for a deed of its own before this one."""
    who, _, _ = reference.partition(".")
    situation = actor.ledger.situation
    deed = situation.deed(reference)
    at = f"{actor.path}.does.{k}.when.{name}"
    if who == actor.one.id:
        if any(deed is earlier for earlier in actor.deeds[:k]):
            return ""  # its own deeds come one after the other, each while the one before is under way
        raise NothingBuilds(f"cannot be built yet: {at}: {reference}, its own deed")
    does = situation.does(who)
    if name == "during" and deed.act.row.lasting and deed is does[0] and deed.act is not Act.TAILGATE:
        return ""  # what it does from the beginning
    sign = _sign_of(actor, who, deed)
    if sign is None:
        raise NothingBuilds(
            f"cannot be built yet: {at}: {reference}: it cannot be seen when {deed.act} happens; "
            "wait for another deed, or say ego_within"
        )
    called, whom = (one if one == EGO else name_of(one) for one in (who, deed.whom or EGO))
    waits = who != EGO and (situation[who].starts.where in OFF_ROAD or stands_first(situation[who]))
    first = deed is next((one for one in does if one.act is not Act.STAND), None)
    delayed = (own := actor.deeds[k].when) is not None and own.delay is not None
    if name == "during" and delayed and waits and first:
        return f"{name_of(who)}.pose[3] > {UNDER_WAY:g}"  # from when it begins, not from when it is seen to
    text = (sign.begun if name == "during" else sign.done or sign.begun).format(
        who=called, whom=whom, usual=f"{_usual(actor, who):.3g}", k=situation.number_of(reference)
    )
    return f"{text} and progressOn(egoRoute, ego)[0] > 1" if who == EGO and deed.act in HALTS else text


def _sign_of(actor: Actor, who: str, deed: Deed) -> Sign | None:
    """What is seen of a deed; None where it cannot be told from what goes before."""
    if who == EGO:
        if deed.act in ASIDE:  # of its way, or of its lane if its way leads to another
            changes = deed.act is Act.LANE_CHANGE and actor.ledger.situation.ego.route in CHANGES
            line, over = (OWN, 2) if changes else ("egoRoute", 1)
            return Sign(f"abs(offsetFrom({line}, ego)) > 0.5", f"abs(offsetFrom({line}, ego)) > {over}")
        return SIGNS[deed.act] if "offset" not in SIGNS.get(deed.act, _IN).begun else None
    where = actor.ledger.situation[who].starts.where
    if deed.act is Act.STOP and stands_first(actor.ledger.situation[who]):
        return _STANDS  # before that it is slow as well
    if deed.act in acts_of(Heads.BY, Heads.OVER):
        if where in AGAINST or (deed.act is Act.LANE_CHANGE and where in NEXT_LANE):
            return _IN
        return _OVER if deed.act is Act.LANE_CHANGE else SIGNS[deed.act]
    return SIGNS.get(deed.act)


def _usual(actor: Actor, who: str) -> float:
    """About how fast [m/s] somebody is before its first deed."""
    if who == EGO:
        return actor.ego_speed
    one = actor.ledger.situation[who]
    if (said := one.starts.speed) is not None and not said.than_ego and said.low > 0.0:
        return said.low
    body = one.kind.row.body.row
    if not body.motorised:
        return Numbers(who, body).middle("SPEED")
    return min(actor.ego_speed, MOST * body.limits.top_speed)
