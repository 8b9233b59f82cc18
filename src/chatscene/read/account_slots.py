"""From the parties of an account to slots: who is the adversary, where it starts and what it does.

Whoever touches the ego is the adversary; if nobody does, whoever does most. The ego's way and the place are as told,
as patterns read them, and as follows from what everybody does.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from chatscene.read.account_acts import QUIET, acts_of, position_of
from chatscene.read.account_meaning import of_party
from chatscene.read.account_rules import LIGHTS, REVEALS, SIGNALISED, STATED, UNCONTROLLED, side_named
from chatscene.read.phrases import Where
from chatscene.read.telling import Contact, Party, Telling
from chatscene.terms.actors import AdversaryKind, Manner
from chatscene.terms.acts import TURNS as TURNING
from chatscene.terms.acts import Action
from chatscene.terms.conclusions import JUNCTIONS, LANE_CHANGES, TURNS
from chatscene.terms.frame import Account
from chatscene.terms.scenario import Control, EgoState, Maneuver, Occluder, Place, Position, Side, Site, Slots

_TO_ANOTHER_LANE = frozenset((Action.CUT_IN, Action.CHANGE_LANE))
_DRIVEN = frozenset(
    (
        Action.REVERSE,
        Action.OVERTAKE,
        Action.CUT_IN,
        Action.CHANGE_LANE,
        Action.PULL_OUT,
        Action.U_TURN,
        Action.TAILGATE,
    )
)  # nobody does one of these on foot
_SIDED = (Position.BESIDE, Position.AHEAD_BESIDE, Position.BEHIND_BESIDE, Position.CROSSING, Position.KERB)
_CURVES = (Place.CURVE, Place.LEFT_CURVE, Place.RIGHT_CURVE)
_OF_A_LEADER = frozenset(
    (Action.BRAKE, Action.STOP, Action.HESITATE, Action.REVERSE, Action.SWERVE)
)  # dangerous to who follows
_COMES_UP = frozenset((Where.OPPOSITE, Where.BEHIND))  # who is there is in conflict without an act
_OBLIQUE = (45, 90, 135, 225, 270, 315)  # degrees between two who meet at a junction


def account_of(telling: Telling, text: str, known: Slots) -> Account | None:
    """The facts of what was told; None if nobody does anything with the ego, or something that no slot has.

    Args:
        telling: What was made out.
        text: All of it.
        known: What patterns say of the place, its control, what hides somebody, the lanes and whether the ego goes on.
    """
    if not telling.parties:
        _add_nobody_in_particular(telling)
    adversary = None if telling.reverses or telling.foreign else _adversary(telling)
    if adversary is None:
        return None
    party, contact = adversary
    facts = _facts(telling, text, known)
    if _is_behind_a_leader(telling, party):
        facts["leader"] = True
    if party.side is None and telling.own_lane is not None and _TO_ANOTHER_LANE & set(party.acts):
        party.side = Side.LEFT if telling.own_lane is Side.RIGHT else Side.RIGHT
    _place_by_compass(party, telling.heading, facts)
    slots = _slots(party, contact, facts, known)
    if slots is None:
        return None
    slots = _hidden_by_another(telling, party, slots)
    ego = _ego_state(telling, telling.parties.index(party), slots.position)
    if known.ego is EgoState.SETS_OFF and ego in (EgoState.STANDS, EgoState.STOPS):
        ego = known.ego  # as patterns know that it goes on
    return Account(
        slots=replace(slots, ego=ego, others=_others(telling, party, contact, text)),
        quantities=tuple(party.quantities),
        unread=tuple(dict.fromkeys(telling.unread)),
        touched=contact is not None,
    )


def _add_nobody_in_particular(telling: Telling) -> None:
    """A car of which only is told what it does: "we were rear-ended"."""
    if not telling.struck_behind and not (telling.bare and telling.deeds):
        return
    nobody = Party(kind=AdversaryKind.CAR, acts=list(telling.deeds))
    for rule, match in telling.pending:
        of_party(telling, nobody, rule, match)
    if telling.struck_behind:
        nobody.where.add(Where.BEHIND)
    nobody.acts = nobody.acts or [Action.FOLLOW]
    telling.parties.append(nobody)


def _adversary(telling: Telling) -> tuple[Party, Contact | None] | None:
    """Who touches the ego first, or else who does most or goes on where it ought to wait; what lies there last.

    Where nobody is, whom the ego only drives behind is it, if it does what makes a leader dangerous.
    """
    there = (one for one in telling.parties if not one.aside)
    able = [one for one in there if one.acts or one.wayward or _COMES_UP & one.where]
    able = able or [one for one in telling.parties if Where.AHEAD in one.where and _OF_A_LEADER & set(one.acts)]
    acting = [one for one in able if not one.kind.lies]
    touched = [one for one in telling.contacts if not acting or not telling.parties[one.party].kind.lies]
    if touched:
        return telling.parties[touched[0].party], touched[0]
    if not able:
        return None
    party = max(acting or able, key=lambda one: bool(set(one.acts) - QUIET - {Action.BLOCK}) or one.wayward)
    standing = [one for one in able if Action.STAND in one.acts and one is not party]
    if standing and Action.CHANGE_LANE in party.acts and Where.AHEAD in party.where:
        party = standing[0]  # who leaves the lane uncovers it
    return party, None


def _is_behind_a_leader(telling: Telling, party: Party) -> bool:
    """Whether somebody else only drives slowly, ahead of the ego."""
    slow = any(one.acts == [Action.SLOW] for one in telling.parties if one is not party)
    return slow and bool(set(party.acts) - QUIET)


def _hidden_by_another(telling: Telling, party: Party, slots: Slots) -> Slots:
    """With whoever stands at the side of the road as what hides somebody who crosses."""
    standing = (one for one in telling.parties if one is not party and Action.STAND in one.acts)
    hides = [one for one in standing if _occluder(one)]
    if not hides or slots.occluder is not None or not party.kind.is_vulnerable or Action.CROSS not in slots.actions:
        return slots
    hides[0].aside = True
    if slots.maneuver is Maneuver.BYPASS:
        return slots  # it is what the ego drives around
    return replace(slots, occluder=_occluder(hides[0]), position=Position.ROADSIDE)


def _occluder(party: Party) -> Occluder | None:
    """What somebody who stands at the side of the road is to whom it hides."""
    return next((occluder for occluder in Occluder if occluder == f"parked-{party.kind}"), None)


def _ego_state(telling: Telling, adversary: int, position: Position | None) -> EgoState | None:
    """What the ego does at the pedals; what it does once the adversary is there may be how it answers."""
    found: EgoState | None = None
    for told in telling.pedals:
        said = told.state
        if told.because_of == adversary and position not in (Position.BEHIND, Position.AHEAD):
            continue
        if said is EgoState.SETS_OFF:
            found = EgoState.SETS_OFF if found in (EgoState.STANDS, EgoState.STOPS, EgoState.SETS_OFF) else found
        elif (
            said in (EgoState.STANDS, EgoState.SLOW)
            or not told.after
            or position in (Position.BEHIND, Position.BEHIND_BESIDE)
        ):
            found = EgoState.STANDS if found is EgoState.STANDS and said is EgoState.STOPS else said
    return found


# Others


def _others(telling: Telling, party: Party, contact: Contact | None, text: str) -> tuple[Slots, ...]:
    """A second road user who does something of its own: who uncovers the adversary, or acts beside it."""
    rest = [one for one in telling.parties if one is not party and not one.kind.lies]
    if Action.STAND in party.acts:
        uncovers = next((one for one in rest if _TO_ANOTHER_LANE & set(one.acts)), None)
        if uncovers and not _is_beside_us(uncovers):
            return (Slots(adversary=uncovers.kind, actions=(Action.CHANGE_LANE,), position=Position.AHEAD),)
    others = [one for one in rest if not one.aside and one.acts and set(one.acts) != {Action.SLOW}]
    revealed = REVEALS.search(text) is not None
    if not others or (contact is not None and not revealed):
        return ()
    other = others[0]
    position, acts = _start_and_acts(other)
    only_hides = set(acts) <= {Action.STAND, Action.FOLLOW} and not revealed and party.occluder is not None
    if not acts or only_hides:
        return ()
    return (Slots(adversary=other.kind, actions=tuple(acts), position=position),)


def _start_and_acts(other: Party) -> tuple[Position | None, list[Action]]:
    """Where a second road user starts, and what it does: who leaves the ego's lane uncovers somebody."""
    leaves = Action.CHANGE_LANE in other.acts and Where.AHEAD in other.where
    position = Position.AHEAD if leaves else position_of(other, None, {})
    acts = acts_of(other, position, touched=False)
    if position is Position.AHEAD and Action.CUT_IN in acts:
        acts = [Action.CHANGE_LANE]
    return position, acts


def _is_beside_us(party: Party) -> bool:
    return bool(party.where & {Where.NEXT_LANE, Where.BESIDE}) and Where.AHEAD not in party.where


# The ego's way and the place


def _facts(telling: Telling, text: str, known: Slots) -> dict[str, Any]:
    """The ego's way and the place; what the phrases of an account leave open is as patterns read it."""
    facts = dict(telling.facts)
    if known.place in JUNCTIONS and not STATED.search(text) and facts.get("maneuver") not in TURNS:
        known = replace(known, place=None, control=None)
    if known.maneuver is Maneuver.BYPASS:
        facts.setdefault("maneuver", Maneuver.BYPASS)
    for name in ("control", "lanes", "two_way"):
        if getattr(known, name) is not None:
            facts.setdefault(name, getattr(known, name))
    control = _control(facts, text)
    place = _place(facts, text, known)
    if facts.get("site") is not None:
        facts.pop("lanes", None)
    if facts.get("site") is Site.CROSSWALK and place in JUNCTIONS:
        del facts["site"]
    without = {name: value for name, value in facts.items() if name not in ("place", "control")}
    return without | _stated("place", place) | _stated("control", control if place in JUNCTIONS else None)


def _stated(name: str, value: object) -> dict[str, Any]:
    return {} if value is None else {name: value}


def _control(facts: dict[str, Any], text: str) -> Control | None:
    """How a junction is controlled, as far as the text says so."""
    control = facts.get("control")
    if UNCONTROLLED.search(text) and not LIGHTS.search(text):
        return Control.NONE
    if LIGHTS.search(text):
        return Control.SIGNAL
    if control is Control.SIGNAL and "unprotected" in text and not SIGNALISED.search(text):
        return None
    return None if control is Control.NONE and not UNCONTROLLED.search(text) else control


def _place(facts: dict[str, Any], text: str, known: Slots) -> Place | None:
    """Where it is: as told, as patterns read it, and as the ego's way and the site want it."""
    place, maneuver, site = facts.get("place"), facts.get("maneuver"), facts.get("site")
    vague = place in (None, Place.ROAD) or (place is Place.JUNCTION and known.place in JUNCTIONS)
    if known.place is not None and vague:
        place = known.place
    if maneuver in TURNS or (place is None and (STATED.search(text) or LIGHTS.search(text))):
        place = place if place in JUNCTIONS else Place.JUNCTION
    if maneuver in (*LANE_CHANGES, Maneuver.BYPASS):
        place = Place.ROAD
    if site not in (None, Site.CROSSWALK) and place not in _CURVES:
        place = Place.JUNCTION if site is Site.ROUNDABOUT else Place.ROAD
    return place


def _place_by_compass(party: Party, heading: int | None, facts: dict[str, Any]) -> None:
    """Where somebody comes from, by where it and the ego drive to."""
    if heading is None or party.heading is None:
        return
    angle = (party.heading - heading) % 360
    if angle in _OBLIQUE and facts.get("place") in (*JUNCTIONS, None) and Where.BEHIND not in party.where:
        party.side = party.side or (Side.LEFT if angle < 180 else Side.RIGHT)
        party.where.add(Where.ARM)
    elif angle == 180 and Action.WRONG_WAY not in party.acts:
        party.where.add(Where.OPPOSITE)


# The adversary


def _slots(party: Party, contact: Contact | None, facts: dict[str, Any], known: Slots) -> Slots | None:
    if contact is not None and contact.ego_hits and not party.acts and Where.EDGE in party.where:
        party.acts.append(Action.STAND)
    position = position_of(party, contact, facts)
    acts = acts_of(party, position, touched=contact is not None)
    if not acts:
        return None
    occluder = party.occluder
    if occluder is None and party.kind.is_vulnerable and Action.CROSS in acts:
        occluder = known.occluder
    return Slots(
        adversary=_kind(party, acts),
        actions=tuple(acts),
        side=_side(party, contact, position, acts),
        position=Position.ROADSIDE if occluder else position,
        occluder=occluder,
        group=party.group or None,
        **_with_place_of_acts(facts, position, acts),
    )


def _kind(party: Party, acts: list[Action]) -> AdversaryKind:
    drives = party.drives or _DRIVEN & set(acts)
    return AdversaryKind.CAR if party.kind.row.manner is Manner.WALKS and drives else party.kind  # "a woman hit us"


def _side(party: Party, contact: Contact | None, position: Position | None, acts: list[Action]) -> Side | None:
    """On which side somebody starts, if it is on one; who is not said to be on one is where it touches the ego."""
    behind = position is Position.BEHIND and Action.OVERTAKE not in acts
    ahead = position is Position.AHEAD and Action.CUT_IN not in acts
    if behind or ahead or position is Position.ONCOMING:
        return None
    if party.side is None and contact is not None and (position in _SIDED or Action.OVERTAKE in acts):
        return side_named(contact.part)
    return party.side


def _with_place_of_acts(facts: dict[str, Any], position: Position | None, acts: list[Action]) -> dict[str, Any]:
    """The facts, and the junction that acts and positions want."""
    facts = dict(facts)
    lights = Action.RUN_LIGHT in acts
    if TURNING.keys() & set(acts) and facts.get("place") in (None, Place.ROAD) and facts.get("site") is None:
        facts["place"] = Place.JUNCTION
    if (position is Position.CROSSING or lights) and facts.get("place") not in JUNCTIONS:
        facts["place"] = Place.JUNCTION
    if lights:
        facts["control"] = Control.SIGNAL
    if facts.get("place") is not None:
        facts.setdefault("maneuver", Maneuver.STRAIGHT)
    return facts
