"""The clause about the ego: what it does, on what road, in whose company."""

from __future__ import annotations

from chatscene.sentences.grammar import roads
from chatscene.sentences.grammar.voice import Voice
from chatscene.situations.inflection import Form, conjugated
from chatscene.terms.conclusions import JUNCTIONS, LANE_CHANGES, TURNS
from chatscene.terms.description import Style
from chatscene.terms.nouns import with_article
from chatscene.terms.scenario import Control, Maneuver, Place, Position


def ego_does(voice: Voice, at_junction: bool) -> str:
    """What the ego does and where, as a marked verb phrase; empty if neither is said."""
    slots, place = voice.slots, _place(voice)
    side = roads.MANEUVER_SIDE.get(slots.maneuver or Maneuver.STRAIGHT, "")
    where = "junction" if at_junction else "curve" if slots.place in roads.CURVE_NOUNS else "road"
    if slots.maneuver in TURNS:
        said = voice.pick(_turns(voice)).format(side=side) + (f" at {place}" if place else "")
    elif slots.maneuver in LANE_CHANGES:
        said = voice.pick(roads.EGO_LANE_CHANGE).format(side=side) + _worth_telling(voice, place)
    elif slots.maneuver is Maneuver.BYPASS:
        ways = roads.EGO_BYPASS_ONE_WAY if slots.two_way is False else roads.EGO_BYPASS
        said = voice.pick(ways).format(blocker=voice.pick(roads.BLOCKERS), own=voice.ego.own)
        said += _worth_telling(voice, place)
    elif slots.maneuver is Maneuver.STRAIGHT:
        said = voice.pick(roads.EGO_STRAIGHT[where if place else ""]).format(place=place)
    else:
        said = voice.pick(roads.EGO_NEARS[where]).format(place=place) if place else ""
    return _in_company(voice, said)


def ego_clause(voice: Voice, does: str, under_way: bool) -> str:
    """A whole clause of a marked verb phrase.

    Args:
        voice: Who tells it.
        does: What `ego_does` returned.
        under_way: "is turning" rather than "turns".
    """
    ego = voice.ego
    if not under_way:
        return f"{ego.subject} {voice.finite(does, ego.many)}"
    doing = conjugated(does, Form.ING)
    if voice.style is Style.COLLOQUIAL and ego.many and voice.chance(0.6):
        return f"{ego.subject}'{'m' if ego.subject == 'I' else 're'} {doing}"
    return f"{ego.subject} {'am' if ego.subject == 'I' else voice.be(ego.many)} {doing}"


def _place(voice: Voice) -> str:
    """A noun phrase for where it happens; empty if that is not said."""
    slots = voice.slots
    if slots.place in JUNCTIONS or slots.control is not None:
        noun = voice.pick(roads.JUNCTION_NOUNS.get(slots.place or Place.JUNCTION, roads.JUNCTION_NOUNS[Place.JUNCTION]))
        if slots.control is None:
            return with_article(noun)
        if voice.chance(0.5):
            return with_article(f"{voice.pick(roads.CONTROL_BEFORE[slots.control])} {noun}")
        return f"{with_article(noun)} {voice.pick(roads.CONTROL_AFTER[slots.control])}"
    lanes = _lanes(voice)
    if slots.place is not None and slots.place in roads.CURVE_NOUNS:
        bend = with_article(voice.pick(roads.CURVE_NOUNS[slots.place]))
        return f"{bend} on {lanes}" if lanes else bend
    return lanes or (with_article(voice.pick(roads.ROAD_NOUNS)) if slots.place is Place.ROAD else "")


def _lanes(voice: Voice) -> str:
    lanes, two_way = voice.slots.lanes, voice.slots.two_way
    if lanes is None and two_way is None:
        return ""
    many = roads.NUMBERS.get(lanes, str(lanes)) if lanes is not None and lanes > 1 else ""
    options = roads.MANY_LANES[two_way] if many else roads.LANES[lanes and 1, two_way]
    return voice.pick(options).format(road=voice.pick(roads.ROAD_NOUNS), n=many, egos=voice.ego.own)


def _turns(voice: Voice) -> tuple[str, ...]:
    slots = voice.slots
    against = slots.position is Position.ONCOMING and slots.control is Control.SIGNAL
    if against and slots.maneuver is Maneuver.LEFT_TURN and voice.chance(0.6):
        return roads.EGO_UNPROTECTED
    if voice.style is Style.COLLOQUIAL and voice.chance(0.5):
        return roads.EGO_TURN_COLLOQUIAL
    return roads.EGO_TURN


def _worth_telling(voice: Voice, place: str) -> str:
    """A road where the manoeuvre does not imply all of it."""
    slots = voice.slots
    told = slots.lanes is not None or slots.two_way is not None or slots.place is not Place.ROAD
    return f" on {place}" if place and told else ""


def _in_company(voice: Voice, said: str) -> str:
    """What the ego does, with the slow leader or the parked vehicle in its lane."""
    slots = voice.slots
    if slots.leader:
        options = roads.OVERTAKING if slots.maneuver in LANE_CHANGES else roads.LED
        said = f"{said or '[drive]'} {voice.pick(options).format(leader=voice.pick(roads.LEADERS))}"
    if slots.blocker and slots.maneuver is not Maneuver.BYPASS:
        blocked = voice.pick(roads.BLOCKED).format(blocker=voice.pick(roads.BLOCKERS), own=voice.ego.own)
        said = f"{said or '[drive]'} {blocked}"
    return said
