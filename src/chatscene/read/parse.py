"""A text read from its first word to its last: what each phrase means, of whom, and in which order.

A text in which every phrase has its place is read for certain; one in which a single word has none is left to those who
go by likelihood (`chatscene.read.decompose`, `chatscene.read.slot_classifier`).
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field, replace
from typing import Any

from chatscene.read.phrases import Phrase, Sort, Where, is_plural, kind_in, phrases_at, road_user, side_in, traits_in
from chatscene.read.quantities import quantity_at
from chatscene.terms.actors import AdversaryKind, Manner
from chatscene.terms.acts import Action
from chatscene.terms.conclusions import JUNCTIONS, LANE_CHANGES, TURNS
from chatscene.terms.scenario import (
    WAITING,
    Control,
    Maneuver,
    Measure,
    Occluder,
    Place,
    Position,
    Quantity,
    Side,
    Site,
    Slots,
)

_TO_A_SIDE = frozenset((Action.SWERVE, Action.CHANGE_LANE, Action.TURN_LEFT, Action.TURN_RIGHT, Action.U_TURN))
_LEAD_ASIDE = _TO_A_SIDE | {
    Action.CROSS,
    Action.CUT_IN,
    Action.PULL_OUT,
    Action.OVERTAKE,
    Action.TURN_BACK,
}  # behind these, "in front of us" says where they lead
# Who does one of these is in the way by it.
IN_THE_WAY = frozenset((Action.STOP, Action.BRAKE, Action.SLOW, Action.PACE, Action.CUT_IN))
# Who turns round in a lane goes back along it; who does so on the way into it goes back to where it came from.
_ON_ITS_WAY = frozenset((Action.CROSS, Action.PULL_OUT, Action.CUT_IN))
_IN_A_LANE = frozenset((Where.AHEAD, Where.OPPOSITE, Where.OWN_LANE, Where.NEXT_LANE))
_QUIET = frozenset((Action.STAND, Action.FOLLOW, Action.SLOW, Action.FAST, Action.BLOCK, Action.NARROW))
_OF_LANE = frozenset((Action.BLOCK, Action.NARROW))  # who stands so stands in the ego's lane
_OF_MOTORWAYS = (Site.ON_RAMP, Site.OFF_RAMP, Site.PAST_ON_RAMP, Site.PAST_OFF_RAMP)
MOST_ACTORS = 2
SEVERAL = ("two", "three", "several", "a group of", "a pack of")  # before several of a kind


@dataclass(frozen=True, slots=True, kw_only=True)
class Parsed:
    """What a text says, all of it.

    Attributes:
        slots: What it says of the ego, the place, the adversary and the others.
        order: Who does what, in the order of telling: 0 is the adversary.
        quantities: The numbers said of the adversary.
        looks: Words for how a road user looks, which no scene shows.
    """

    slots: Slots
    order: tuple[tuple[int, Action], ...] = ()
    quantities: tuple[Quantity, ...] = ()
    looks: tuple[str, ...] = ()


@dataclass
class _Actor:
    """A road user, as far as it was read."""

    kind: AdversaryKind
    acts: list[Action] = field(default_factory=list[Action])
    where: set[Where] = field(default_factory=set[Where])
    side: Side | None = None
    occluder: Occluder | None = None
    group: bool = False
    quantities: list[Quantity] = field(default_factory=list[Quantity])


@dataclass
class _Told:
    """What was read so far."""

    actors: list[_Actor] = field(default_factory=list[_Actor])
    order: list[tuple[int, Action]] = field(default_factory=list[tuple[int, Action]])
    facts: dict[str, Any] = field(default_factory=dict[str, Any])
    subject: int | None = None  # an actor, or None for the ego
    leads: AdversaryKind | None = None  # who leads the ego slowly
    looks: list[str] = field(default_factory=list[str])  # how somebody looks, which no scene shows
    begun: bool = False  # whether anybody was named
    open: bool = True  # whether somebody may be named here
    met: object = None  # where, by the words before, whoever is named next


class _UnreadError(Exception):
    """A word has no place."""


def parse(text: str) -> Parsed | None:
    """Read a text whole; None if a word of it has no place, or nobody but the ego does anything.

    Args:
        text: Canonical, mended.
    """
    told = _Told()
    try:
        at = 0
        while at < len(text):
            at = _next(told, text, at)
        return _parsed(told)
    except _UnreadError:
        return None


def _next(told: _Told, text: str, at: int) -> int:
    """Read the phrase at a place; where the next one begins."""
    best: tuple[int, Phrase | None, re.Match[str] | None] = (at, None, None)
    for phrase in phrases_at(text[at]):
        if (match := phrase.pattern.match(text, at)) and match.end() > best[0] and _fits(told, phrase):
            best = match.end(), phrase, match
    if told.open or not told.begun:
        named = road_user().match(text, at)
        if named and named.end() > best[0]:
            _name(told, named)
            return _skip(text, named.end())
    if (number := quantity_at(text, at)) is not None and number[1] > best[0]:
        _measure(told, number[0])
        return _skip(text, number[1])
    end, phrase, match = best
    if phrase is None or match is None:
        raise _UnreadError(text[at:])
    _take(told, phrase, match)
    return _skip(text, end)


def _skip(text: str, at: int) -> int:
    while at < len(text) and text[at] == " ":
        at += 1
    return at


def _fits(told: _Told, phrase: Phrase) -> bool:
    """Whether a phrase may be said of whoever is spoken of."""
    if phrase.ego is None:
        return True
    if phrase.ego:
        return told.begun and told.subject is None
    if told.subject is None:
        return False
    return phrase.manner is None or told.actors[told.subject].kind.row.manner is phrase.manner


def _name(told: _Told, match: re.Match[str]) -> None:
    """Somebody is named: one who was already, or another."""
    kind, article = kind_in(match), match["article"] or ""
    known = [i for i, one in enumerate(told.actors) if one.kind is kind]
    another = article in ("another", "a second", "a third", "a", "an", "one", "some") or not known
    if another:
        if len(told.actors) == MOST_ACTORS:
            raise _UnreadError(match[0])
        told.actors.append(_Actor(kind=kind))
        told.subject = len(told.actors) - 1
    elif len(known) == 1:
        told.subject = known[0]
    else:
        raise _UnreadError(match[0])
    one = told.actors[told.subject]
    if article in SEVERAL or (kind.lies and is_plural(match, kind)):
        one.group = True
    if isinstance(told.met, Where):
        one.where.add(told.met)
    for sort, value in traits_in(match):
        if sort is Sort.WHERE and isinstance(value, Where):
            one.where.add(value)
        elif sort is Sort.ACT and isinstance(value, Action):
            _act(told, value)
        else:
            told.looks.append(str(value))
    told.begun, told.open = True, False


def _measure(told: _Told, quantity: Quantity) -> None:
    if told.subject is None:
        raise _UnreadError(quantity.said)
    one = told.actors[told.subject]
    if quantity.measure is Measure.DECELERATION and Action.BRAKE not in one.acts:
        raise _UnreadError(quantity.said)
    if any(quantity.measure is other.measure for other in one.quantities):
        raise _UnreadError(quantity.said)
    one.quantities.append(quantity)


def _act(told: _Told, action: Action) -> None:
    if told.subject is None:
        raise _UnreadError(action)
    acts = told.actors[told.subject].acts
    if action not in acts:
        acts.append(action)
        told.order.append((told.subject, action))


def _fact(told: _Told, name: str, value: object) -> None:
    """A fact of the ego or the place; two that differ are two things."""
    if told.facts.setdefault(name, value) != value:
        raise _UnreadError(name)


def _take(told: _Told, phrase: Phrase, match: re.Match[str]) -> None:
    """Take in what a phrase says."""
    if phrase.sort in (Sort.JOINT, Sort.THEN, Sort.END, Sort.SEES):
        told.open, told.met = True, phrase.value
    elif phrase.sort in (Sort.EGO, Sort.SAME):
        _speak_of(told, phrase, match)
    elif phrase.sort is Sort.PLACE:
        _placed(told, *phrase.value)  # type: ignore[misc]
    elif phrase.sort is Sort.SITE:
        _sited(told, *phrase.value)  # type: ignore[misc]
    elif phrase.sort in _FACTS:
        _fact(told, _FACTS[phrase.sort], phrase.value)
        if phrase.sort is Sort.LEADER:
            told.leads = AdversaryKind.TRUCK if "truck" in match[0] else AdversaryKind.CAR
    elif told.subject is not None:
        _of_actor(told, told.actors[told.subject], phrase, match)
    elif phrase.sort is not Sort.FILLER:
        raise _UnreadError(match[0])
    if phrase.sort not in (Sort.JOINT, Sort.THEN, Sort.END, Sort.SEES, Sort.FILLER):
        told.open = False


_FACTS = {
    Sort.MANEUVER: "maneuver",
    Sort.STATE: "ego",
    Sort.LEADER: "leader",
    Sort.BYPASS: "maneuver",
    Sort.LANES: "lanes",
    Sort.TWO_WAY: "two_way",
}  # which slot they fill


def _speak_of(told: _Told, phrase: Phrase, match: re.Match[str]) -> None:
    """The ego, or whoever was spoken of last, is the subject from here on."""
    if phrase.sort is Sort.EGO:
        if not told.open:
            raise _UnreadError(match[0])
        told.subject, told.begun = None, True
    elif told.subject is None:
        if not told.actors:
            raise _UnreadError(match[0])
        told.subject = len(told.actors) - 1


def _of_actor(told: _Told, actor: _Actor, phrase: Phrase, match: re.Match[str]) -> None:
    """What a phrase says of a road user."""
    value: Any = phrase.value
    if phrase.sort is Sort.ACT:
        if phrase.exit and told.facts.get("site") is not Site.OFF_RAMP:
            _sited(told, Site.PAST_OFF_RAMP)
        _act(told, Action.U_TURN if _turns_in_its_lane(actor, value, match) else value)
    elif phrase.sort is Sort.ROW and not actor.group:
        raise _UnreadError(match[0])
    elif phrase.sort is Sort.OCCLUDER:
        actor.occluder = value
    elif phrase.sort is Sort.WHERE:
        _is_at(told, actor, value)
    elif phrase.sort is Sort.SIDE:
        side = Side(side_in(match) or "")
        whither = bool(actor.acts) and actor.acts[-1] in _TO_A_SIDE and "from" not in match[0]
        if whither or actor.side not in (None, side):
            raise _UnreadError(match[0])  # where somebody turns to is in no slot
        actor.side = side
        if value is not None:
            actor.where.add(value)
        elif "from" in match[0]:
            actor.where.add(Where.FROM_SIDE)


def _turns_in_its_lane(actor: _Actor, action: Action, match: re.Match[str]) -> bool:
    """Whether who turns round drives back along its lane, since it is neither on its way into one nor led into one."""
    whither = re.match(r" (?:in|on)?to\b", match.string[match.end() :])
    turns = action is Action.TURN_BACK and match[0].startswith("turn") and whither is None
    drives = actor.kind.row.manner is Manner.DRIVES and bool(_IN_A_LANE & actor.where)
    return turns and drives and not _ON_ITS_WAY.intersection(actor.acts)


def _is_at(told: _Told, actor: _Actor, where: Where) -> None:
    if where is Where.RAMP:
        _sited(told, Site.PAST_ON_RAMP)
        where = Where.NEXT_LANE
    if not (_LEAD_ASIDE.intersection(actor.acts) and where in (Where.AHEAD, Where.OWN_LANE)):
        actor.where.add(where)


def _placed(told: _Told, place: Place, control: Control | None) -> None:
    known = told.facts.get("place")
    if known is None or (known is Place.JUNCTION and place in JUNCTIONS):
        told.facts["place"] = place
    elif place not in (known, Place.JUNCTION) or (known not in JUNCTIONS and place is not known):
        raise _UnreadError(place)
    if control is not None:
        _fact(told, "control", control)


def _sited(told: _Told, site: Site, maneuver: Maneuver | None = None) -> None:
    """Where the ego's way leads; a motorway may have ramps."""
    known = told.facts.get("site")
    if known is Site.ON_RAMP and told.subject is not None:
        told.actors[told.subject].where.add(Where.NEXT_LANE)  # on the motorway, as the ego is not yet
    if known is None or (known is Site.MOTORWAY and site in _OF_MOTORWAYS):
        told.facts["site"] = site
    elif site is not known and not (site is Site.MOTORWAY and known in _OF_MOTORWAYS):
        raise _UnreadError(site)
    if maneuver is not None:
        _fact(told, "maneuver", maneuver)


# From facts to what follows from them


def start_of(slots: Slots, where: frozenset[Where] = frozenset()) -> Position | None:
    """Where a road user starts whose facts are known, and of whom some words say where it is; None if nothing says it.

    Args:
        slots: All facts but its position.
        where: What words say of that.
    """
    try:
        return _position(*_again(slots, where))
    except _UnreadError:
        return None


def in_order(slots: Slots) -> tuple[Action, ...] | None:
    """What somebody does, in order, without what goes without saying; None if nobody does it all."""
    one, _ = _again(slots, frozenset())
    try:
        return _acts_of(one, slots.position)
    except _UnreadError:
        return None


def _again(slots: Slots, where: frozenset[Where]) -> tuple[_Actor, dict[str, Any]]:
    """Somebody as if the facts were read just now, with the facts of the ego and the place."""
    assert slots.adversary is not None  # whoever asks knows who it is
    one = _Actor(
        kind=slots.adversary,
        acts=list(slots.actions),
        where=set(where),
        side=slots.side,
        occluder=slots.occluder,
        group=bool(slots.group),
    )
    return one, slots.said()


# From phrases to slots


def _parsed(told: _Told) -> Parsed:
    if not told.actors and told.leads is not None:  # nobody else is there to be met
        told.actors.append(_Actor(kind=told.leads, acts=[Action.SLOW], where={Where.AHEAD}))
        told.order.append((0, Action.SLOW))
        del told.facts["leader"]
    acting = [one for one in told.actors if one.acts]
    if not told.actors or len(acting) != len(told.actors):
        raise _UnreadError("nobody does anything")
    first = next((i for i, one in enumerate(told.actors) if not _QUIET.issuperset(one.acts)), 0)
    ranked = [first, *(i for i in range(len(told.actors)) if i != first)]
    facts = _concluded(told)
    slots = [_slots(told.actors[i], facts) for i in ranked]
    if any(one.occluder is not None or one.group for one in slots[1:]):
        raise _UnreadError("another who is hidden, or one of several")
    if any(told.actors[i].quantities for i in ranked[1:]):
        raise _UnreadError("a number of another road user")
    return Parsed(
        slots=replace(slots[0], others=tuple(_alone(one) for one in slots[1:])),
        order=tuple((ranked.index(i), action) for i, action in told.order),
        quantities=tuple(told.actors[first].quantities),
        looks=tuple(told.looks),
    )


def _alone(one: Slots) -> Slots:
    """What is said of a road user, without the ego and the place."""
    return Slots(adversary=one.adversary, actions=one.actions, side=one.side, position=one.position)


def _concluded(told: _Told) -> dict[str, Any]:
    """The facts of the ego and the place, with what follows from them."""
    facts = _with_place_of_site(told.facts)
    maneuver = facts.get("maneuver")
    if maneuver is Maneuver.BYPASS:
        facts["blocker"] = True
    if maneuver in TURNS and facts.get("place") not in JUNCTIONS:
        if facts.get("place") is not None:
            raise _UnreadError("a turn that is at no junction")
        facts["place"] = Place.JUNCTION
    if maneuver in (*LANE_CHANGES, Maneuver.BYPASS):
        if facts.get("place") in JUNCTIONS:
            raise _UnreadError("a lane change at a junction")
        facts["place"] = facts.get("place") or Place.ROAD
    lights = any(Action.RUN_LIGHT in one.acts for one in told.actors)
    arms = any(
        Where.ARM in one.where or {Action.TURN_LEFT, Action.TURN_RIGHT}.intersection(one.acts) for one in told.actors
    )
    if lights:
        facts["control"] = Control.SIGNAL
    if (lights or arms) and facts.get("place") not in JUNCTIONS:
        if facts.get("place") is not None:
            raise _UnreadError("an arm of a road that has none")
        facts["place"] = Place.JUNCTION
    if facts.get("place") is not None and maneuver is None:
        facts["maneuver"] = Maneuver.STRAIGHT
    return facts


def _with_place_of_site(facts: dict[str, Any]) -> dict[str, Any]:
    if facts.get("site") is None:
        return dict(facts)
    place = Place.JUNCTION if facts["site"] is Site.ROUNDABOUT else Place.ROAD
    if facts.get("place", place) is not place:
        raise _UnreadError("one place inside another")
    return {**facts, "place": place}


def _slots(one: _Actor, facts: dict[str, Any]) -> Slots:
    facts = dict(facts)
    if _rides_on_beside(one, facts) and Action.PACE in one.acts:
        one = replace(one, acts=[Action.FOLLOW])  # nobody keeps level with who turns away
    position = _position(one, facts)
    acts = _acts_of(one, position)
    if position is Position.CROSSING and facts.get("place") not in JUNCTIONS:
        if facts.get("place") is not None:
            raise _UnreadError("an arm of a road that has none")
        facts["place"] = Place.JUNCTION
        facts.setdefault("maneuver", Maneuver.STRAIGHT)
    if one.occluder is not None and facts.get("maneuver") is Maneuver.BYPASS:
        raise _UnreadError("hidden beside what is in the way")
    return Slots(
        adversary=one.kind,
        actions=acts,
        side=one.side,
        position=position,
        occluder=one.occluder,
        group=one.group or None,
        **facts,
    )


def _acts_of(one: _Actor, position: Position | None) -> tuple[Action, ...]:
    """The acts in order, without those that go without saying."""
    acts = list(one.acts)
    if len(acts) > 1 and Action.FOLLOW in acts and not {Action.STOP, Action.STAND}.intersection(acts):
        acts.remove(Action.FOLLOW)  # whoever does something else drives on as well
    if len(acts) > 1 and Action.STAND in acts:
        stands_first = acts[0] is Action.STAND and position in WAITING
        if not stands_first and not all(action.row.stands for action in acts):
            raise _UnreadError("it stands, and something else")
        acts.remove(Action.STAND)
    if Action.STOP in acts and Action.FOLLOW in acts[acts.index(Action.STOP) :]:
        acts[acts.index(Action.FOLLOW)] = Action.HESITATE  # it goes on again
    if Action.BLOCK in acts and IN_THE_WAY.intersection(acts):
        acts.remove(Action.BLOCK)
    if position is Position.ONCOMING and acts == [Action.FOLLOW]:
        return (Action.ONCOMING,)
    if Action.WRONG_WAY in acts and Action.ONCOMING in acts:
        acts.remove(Action.ONCOMING)
    return tuple(acts)


def _position(one: _Actor, facts: dict[str, Any]) -> Position | None:
    """Where somebody starts."""
    if Where.BEYOND in one.where:
        if facts.get("place") not in JUNCTIONS:
            raise _UnreadError("behind a corner that is none")
        return Position.BEYOND
    place = _beside_the_road(one, facts) or _against_the_ego(one) or _behind(one)
    return place or (_on_foot(one) if one.kind.row.manner is Manner.WALKS else _on_wheels(one, facts))


def _beside_the_road(one: _Actor, facts: dict[str, Any]) -> Position | None:
    manner, acts = one.kind.row.manner, set(one.acts)
    if Where.FAR_CORNER in one.where:
        return Position.FAR_CORNER if facts.get("place") in JUNCTIONS else Position.ROADSIDE
    if one.occluder is not None:
        return Position.ROADSIDE
    if Where.EDGE not in one.where:
        return Position.KERB if Action.PULL_OUT in acts and manner is not Manner.WALKS else None
    if manner is Manner.WALKS or (manner is Manner.RIDES and Action.CROSS in acts):
        return Position.ROADSIDE
    along = manner is Manner.RIDES and acts & {Action.FOLLOW, Action.SLOW}
    in_lane = Where.OWN_LANE in one.where or (bool(acts & _OF_LANE) and all(action.row.stands for action in acts))
    return Position.AHEAD if along or in_lane else Position.KERB


def _against_the_ego(one: _Actor) -> Position | None:
    against = Where.OPPOSITE in one.where or {Action.ONCOMING, Action.WRONG_WAY}.intersection(one.acts)
    return Position.ONCOMING if against else None


def _behind(one: _Actor) -> Position | None:
    if Where.BEHIND not in one.where and not {Action.OVERTAKE, Action.TAILGATE}.intersection(one.acts):
        return None
    beside = Where.NEXT_LANE in one.where or (one.side is not None and Action.TAILGATE not in one.acts)
    return Position.BEHIND_BESIDE if beside else Position.BEHIND


def _on_foot(one: _Actor) -> Position | None:
    if Action.CROSS in one.acts or one.side is not None:
        return Position.ROADSIDE
    return Position.AHEAD if {Where.AHEAD, Where.OWN_LANE} & one.where else None


def _rides_on_beside(one: _Actor, facts: dict[str, Any]) -> bool:
    """Whether it rides straight on along the kerb where the ego turns across it."""
    rides = one.kind.row.manner is Manner.RIDES
    inner = rides and facts.get("maneuver") is Maneuver.RIGHT_TURN and one.side is Side.RIGHT
    quiet = {*_QUIET, Action.PACE}.issuperset(one.acts)
    return inner and quiet and one.where <= {Where.BESIDE, Where.AHEAD, Where.EDGE}


def _from(one: _Actor) -> set[Where]:
    """Where somebody may be said to be who comes from an arm: behind where it comes from, "ahead" is where it leads."""
    comes = Where.FROM_SIDE in one.where and Action.CUT_IN not in one.acts
    return {Where.FROM_SIDE, Where.AHEAD} if comes else {Where.FROM_SIDE}


def _on_wheels(one: _Actor, facts: dict[str, Any]) -> Position | None:
    junction, rides = facts.get("place") in JUNCTIONS, one.kind.row.manner is Manner.RIDES
    turns = facts.get("maneuver") in TURNS
    comes = Action.CROSS in one.acts or (Where.FROM_SIDE in one.where and Action.CUT_IN not in one.acts)
    if comes and rides and (turns or not junction):
        return Position.ROADSIDE
    arm = Where.ARM in one.where or {Action.RUN_LIGHT, Action.CROSS}.intersection(one.acts)
    beside = _rides_on_beside(one, facts)
    if not beside and (arm or (junction and one.side is not None and one.where <= _from(one))):
        return Position.CROSSING
    if beside or Where.BESIDE in one.where:
        return Position.AHEAD_BESIDE if Where.AHEAD in one.where else Position.BESIDE
    in_way = Action.NARROW in one.acts or (Action.STAND in one.acts and one.side is None)  # or where else is said
    if in_way or {Where.NEXT_LANE, Where.AHEAD, Where.OWN_LANE} & one.where:
        aside = Where.NEXT_LANE in one.where or (one.side is not None and not rides and Action.NARROW not in one.acts)
        return Position.AHEAD_BESIDE if aside else Position.AHEAD
    if Action.CUT_IN in one.acts:
        return Position.AHEAD_BESIDE if one.side is None else Position.BESIDE
    return None
