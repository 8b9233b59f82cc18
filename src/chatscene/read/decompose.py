"""What the words of a sentence say outright.

Paper: section 3.3, step ii. The reference asks a language model; this reader is deterministic and needs none. It
cuts the sentence into clauses, finds whose clause each is (the ego's or the adversary's), and reads each with the
patterns of `chatscene.read.lexicon`.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, replace

from chatscene.errors import SettingsError
from chatscene.read import lexicon as words
from chatscene.read.account import hear_account
from chatscene.read.canonical import canonical
from chatscene.read.clauses import cut, without_things
from chatscene.read.ego_speed import ego_speed_of, not_of_ego
from chatscene.read.ego_state import ego_state_of
from chatscene.read.naming import plainly_named
from chatscene.read.parse import parse
from chatscene.read.quantities import aside_of, quantities_of
from chatscene.read.surroundings import hear_surroundings
from chatscene.read.unused import mentions_of, unused_of
from chatscene.terms.actors import AdversaryKind, Manner
from chatscene.terms.acts import Action
from chatscene.terms.conclusions import JUNCTIONS, LANE_CHANGES, TURNS
from chatscene.terms.frame import About, Clauses, Frame, Note, certain
from chatscene.terms.scenario import (
    Control,
    Distance,
    Maneuver,
    Occluder,
    Place,
    Position,
    Side,
    Site,
    Slots,
    Unused,
    Why,
)

_VEHICLE = r"(?:vehicle|car|van|truck|lorry|bus|taxi|motorcycle|pickup|suv)"
_LEAD = rf"the (?:lead(?:ing)? {_VEHICLE}|{_VEHICLE} (?:ahead|in front)(?: of us)?)"
_STOPS = r"(?:\w+ly )?(?:brak|stop|slow)\w+(?: (?:down|hard|to a (?:stop|halt|standstill)|\w+ly))*"
# Who brakes ahead of us is not who comes up from behind.
_LEAD_BESIDES = re.compile(
    rf"(?:,? ?\b(?:because|as|when|since|after) )?\b(?P<lead>{_LEAD} {_STOPS})(?:, (?:and |so )?| and )"
    rf"(?=[^.;]*\b{_VEHICLE} (?:that (?:is|was) |which (?:is|was) |coming up |approaching from )?behind\b)",
    re.I,
)
RAMPS = (Site.ON_RAMP, Site.OFF_RAMP)
WHOLE = 0.95  # of a text of which every phrase has its place: set, not fitted, as few of others' are
LONGEST = 2000  # characters; a situation fits into a paragraph


def hear(text: str) -> Frame:
    """What the words of a sentence say outright; nothing else is believed.

    Args:
        text: English, one situation.

    Raises:
        SettingsError: The text is empty or longer than `LONGEST`.
    """
    plain = _printable(text)
    named = plainly_named(plain)
    around = hear_surroundings(canonical(named.text))
    mended = re.sub(r"[a-z]+", lambda m: words.mended(m[0]), around.rest)
    notes = [Note(about=About.MENDED, said=(repr(a), repr(b))) for a, b in _changes(around.rest, mended)]
    for pattern, meant in words.KEEPING_RIGHT:
        mended = pattern.sub(meant, mended)
    told = _rewritten(mended)
    clauses = cut(told)
    heard = Frame(text=plain, canonical=around.rest, told=told, clauses=clauses, surroundings=around.surroundings)
    parsed, ego_speed = parse(mended), ego_speed_of(told)
    # What the ego does may be how it reacts, which is its own affair.
    if parsed is not None and parsed.slots.ego is (parsed.slots.ego and ego_state_of(clauses.whole, words.ANYBODY)):
        slots, quantities = parsed.slots, parsed.quantities
        unused = (*around.unlike, *(Unused(said=said, why=Why.WORDS) for said in parsed.looks))
        heard = replace(heard, whole=True, sure=WHOLE)
    else:
        slots = _slots(clauses, notes)
        quantities = tuple(not_of_ego(quantities_of(clauses.adversary or clauses.whole, clauses.whole), ego_speed))
        turned = tuple(
            Unused(said=m["what"] or m["first"], why=Why.MANEUVER) for m in words.NO_MANEUVER.finditer(clauses.whole)
        )
        heard_numbers = (*quantities, *((ego_speed,) if ego_speed is not None else ()))
        unused = (*turned, *unused_of(told, heard_numbers, around.unlike))
        heard = replace(heard, mentions=mentions_of(told), account=hear_account(canonical(clauses.whole), slots))
    both = slots.others or (heard.account is not None and heard.account.slots.others)
    if not both and (lead := _LEAD_BESIDES.search(plain)):
        rest = hear(f"{plain[: lead.start()]}{' and ' if lead.start() else ''}{plain[lead.end() :]}")
        return replace(rest, text=plain, unused=(*rest.unused, Unused(said=lead["lead"].lower(), why=Why.ROAD_USER)))
    return replace(
        heard,
        outright=slots,
        beliefs=certain(slots),
        ego_speed=ego_speed,
        quantities=(*quantities, *aside_of(clauses.adversary or clauses.whole)),
        unused=(*unused, *(Unused(said=said.lower(), why=Why.BESIDES) for said in named.dropped)),
        notes=tuple(notes),
    )


def _printable(text: str) -> str:
    plain = "".join(c if c.isprintable() else " " for c in text)
    plain = " ".join(plain.split())
    if not plain:
        raise SettingsError("the text is empty; describe a situation, such as 'a cyclist cuts across from the left'")
    if len(plain) > LONGEST:
        raise SettingsError(f"the text has {len(plain)} characters; describe one situation in at most {LONGEST}")
    return plain


def _rewritten(text: str) -> str:
    text = words.rewritten(text)
    return text if words.EGO.search(text) else _with_an_ego(text)


def _with_an_ego(text: str) -> str:
    """A bystander's story: the vehicle whose way is told is the ego, if there is another road user besides."""
    told = words.ON_ITS_WAY.search(text)
    if told is None:
        return text
    named = rf"\b(?:the|a|an|my \w+'s|this) (?:\w+ )?{told['vehicle']}\b"
    rest = re.sub(named, "the ego", text)
    return rest if any(pattern.search(rest) for pattern in words.KINDS.values()) else text


def _changes(before: str, after: str) -> list[tuple[str, str]]:
    pairs = zip(re.findall(r"[a-z]+", before), re.findall(r"[a-z]+", after), strict=False)
    return [(a, b) for a, b in pairs if a != b]


# Slots


def _slots(clauses: Clauses, notes: list[Note]) -> Slots:
    kind = _kind(clauses)
    occluder = _occluder(clauses)
    leader = bool(words.LEADER.search(clauses.ego)) or None
    parked = any(words.OCCLUDERS[o].search(clauses.whole) for o in (Occluder.PARKED_CAR, Occluder.PARKED_TRUCK))
    bypass = bool(words.BYPASS.search(clauses.whole)) and parked
    blocker = (bypass or (parked and bool(words.BLOCKING.search(clauses.ego)))) or None
    actions = _actions(clauses, kind)
    side = _side(clauses.adversary) or (_side(clauses.ego) if occluder is not None else None)
    maneuver = Maneuver.BYPASS if blocker else _maneuver(clauses, side, notes)
    control = _control(clauses, actions)
    place = _place(clauses, maneuver, actions)
    if maneuver is None and (place is not None or control is not None):
        maneuver = Maneuver.STRAIGHT
    known = _Known(
        kind=kind,
        actions=actions,
        side=side,
        maneuver=maneuver,
        occluder=None if blocker else occluder,
        junction=place in JUNCTIONS,
    )
    position = _position(clauses, known)
    if Action.PULL_OUT in actions and not _walks(kind) and occluder is None:
        position = Position.KERB
    if actions and Action.REVERSE in actions:
        actions = tuple(action for action in actions if action is not Action.ONCOMING)
    if position is Position.ONCOMING:
        actions = _of_oncoming(actions, kind, place)
    if kind is None:
        strangers = ", ".join(words.strangers(clauses.whole))
        notes.append(Note(about=About.STRANGER, said=(strangers,)) if strangers else Note(about=About.WHO))
    if not actions:
        notes.append(Note(about=About.WHAT))
    if foreign := words.FOREIGN.search(clauses.whole):
        notes.append(Note(about=About.FOREIGN, said=(foreign[0],)))
    return Slots(
        adversary=kind,
        actions=_in_order(actions, clauses.adversary),
        side=side,
        position=position,
        occluder=None if blocker else occluder,
        maneuver=maneuver,
        place=place,
        control=control,
        leader=leader,
        blocker=blocker,
        distance=_distance(clauses.adversary),
        group=bool(words.GROUP.search(clauses.adversary)) or None,
        lanes=_lanes(clauses, place),
        two_way=_two_way(clauses, place),
        ego=ego_state_of(clauses.whole, words.ANYBODY),
        site=_site(clauses, place),
    )


def _site(clauses: Clauses, place: Place | None) -> Site | None:
    """What the ego's way leads along or through; a crosswalk at a junction is a part of that."""
    if words.FROM_RAMP.search(clauses.adversary) and not words.FROM_RAMP.search(clauses.ego):
        return Site.PAST_ON_RAMP
    for site, pattern in words.SITES.items():
        if pattern.search(clauses.ego if site in RAMPS else clauses.whole):
            return None if site is Site.CROSSWALK and place in JUNCTIONS else site
    return None


def _distance(text: str) -> Distance | None:
    if words.FAR_AWAY.search(text):
        return Distance.FAR
    return Distance.NEAR if words.NEAR.search(text) else None


def _lanes(clauses: Clauses, place: Place | None) -> int | None:
    if place in JUNCTIONS:
        return None
    if words.ONE_LANE.search(clauses.whole):
        return 1
    return 2 if words.MANY_LANES.search(clauses.ego) else None


def _two_way(clauses: Clauses, place: Place | None) -> bool | None:
    if place in JUNCTIONS:
        return None
    if words.TWO_WAY.search(clauses.ego) or words.EACH_WAY.search(clauses.whole):
        return True
    return False if words.ONE_WAY.search(clauses.whole) else None


def _walks(kind: AdversaryKind | None) -> bool:
    return kind is not None and kind.row.manner is Manner.WALKS


def _rides(kind: AdversaryKind | None) -> bool:
    return kind is not None and kind.row.manner is Manner.RIDES


def _kind(clauses: Clauses) -> AdversaryKind | None:
    """The kind mentioned first in what is said of the adversary."""
    for text in (clauses.adversary, clauses.whole):
        bare = without_things(text)
        if text is clauses.whole:
            bare = words.EGO.sub(" ", words.EGO_AS_OBJECT.sub(" ", bare))
        found = [(m.start(), i, kind) for i, (kind, p) in enumerate(words.KINDS.items()) if (m := p.search(bare))]
        if found:
            return min(found)[2]
        if words.SOMEBODY.search(bare):
            return _somebody(clauses)
    return None


def _somebody(clauses: Clauses) -> AdversaryKind | None:
    """What kind somebody is of whom only that is said: a driver if he does what only drivers do."""
    driving = (Action.RUN_LIGHT, Action.CUT_IN, Action.REVERSE, Action.CHANGE_LANE)
    drives = any(words.ACTIONS[action].search(clauses.adversary or clauses.whole) for action in driving)
    return AdversaryKind.CAR if drives else AdversaryKind.PEDESTRIAN


def _occluder(clauses: Clauses) -> Occluder | None:
    if not words.HIDING.search(clauses.whole):
        return None
    return next((occluder for occluder, p in words.OCCLUDERS.items() if p.search(clauses.whole)), None)


# What a wording makes of actions: where it is heard and the action (if one is named) was found, some fall, some join.
_WORDINGS: tuple[tuple[re.Pattern[str], Action | None, set[Action], set[Action]], ...] = (
    (words.FEINT, None, {Action.CROSS}, {Action.BRAKE, Action.STOP}),
    (words.SLOWING, Action.SLOW, {Action.SLOW}, {Action.BRAKE}),
    (words.MATCHING, None, {Action.BRAKE, Action.PACE, Action.STOP, Action.CHANGE_LANE}, {Action.SLOW}),
    (words.GOING_ON, Action.STOP, set(), {Action.HESITATE}),
    (words.ANYTHING, Action.PACE, {Action.STOP}, set()),
    # Whoever stops, slows or cuts in is in the way by doing so.
    *(
        (words.ANYTHING, action, {Action.BLOCK}, set[Action]())
        for action in (Action.STOP, Action.BRAKE, Action.SLOW, Action.PACE, Action.CUT_IN)
    ),
)


def _actions(clauses: Clauses, kind: AdversaryKind | None) -> tuple[Action, ...]:
    text = clauses.adversary
    for pattern in (*words.OCCLUDERS.values(), words.NO_ACTION):
        text = pattern.sub(" ", text)
    found = {action for action, pattern in words.ACTIONS.items() if _says(pattern, text)}
    for pattern, action, fall, join in _WORDINGS:
        if pattern.search(text) and (action is None or action in found):
            found = (found - fall) | join
    found = _on_foot(found, text, kind) if kind and kind.is_vulnerable else _at_the_wheel(found, text)
    if found - {Action.ONCOMING, Action.FOLLOW}:
        found -= {Action.FOLLOW}  # whoever does something else drives on as well
    elif kind and not _walks(kind) and words.PASSING.search(text):
        found.add(Action.FOLLOW)
    return tuple(action for action in Action if action in found)


def _in_order(actions: tuple[Action, ...], text: str) -> tuple[Action, ...]:
    """Actions in the order in which words say them; what no word names comes last."""
    turns = {Action.TURN_LEFT: words.LEFT_TURN, Action.TURN_RIGHT: words.RIGHT_TURN}
    named = {action: [m.start() for m in pattern.finditer(text)] for action, pattern in (words.ACTIONS | turns).items()}
    # Who stands at first has not stopped yet.
    said = {action: places[-1 if action is Action.STOP else 0] for action, places in named.items() if places}
    return tuple(sorted(actions, key=lambda action: said.get(action, len(text))))


def _on_foot(found: set[Action], text: str, kind: AdversaryKind | None) -> set[Action]:
    """What the actions of somebody on foot or on two wheels come to, who can cross as well as drive."""
    if _walks(kind):
        running = {Action.ACCELERATE} if Action.CROSS in found and words.RUNNING.search(text) else set[Action]()
        return (found | running) - {Action.CUT_IN, Action.CHANGE_LANE}
    if Action.CROSS in found and not words.CUTTING_IN.search(text):
        found = found - {Action.CUT_IN}
    return found | _turn(text)


def _at_the_wheel(found: set[Action], text: str) -> set[Action]:
    """What the actions of a vehicle come to: it never crosses as a walker does, and a turn is more than a cut."""
    found = found - {Action.CROSS, Action.DIAGONAL}
    if words.ERRATIC.search(text):
        found = found | {Action.SWERVE}
    turn = _turn(text)
    if Action.RUN_LIGHT in found or (turn and "oncoming" not in text):  # either is how somebody is cut off there
        found = found - {Action.CUT_IN}
    return found | turn


def _of_oncoming(actions: tuple[Action, ...], kind: AdversaryKind | None, place: Place | None) -> tuple[Action, ...]:
    """What somebody who comes toward the ego does.

    On open road, coming toward the ego is itself what he does, and on foot he enters the lane rather than crosses
    it; at a junction it only says from where he comes.
    """
    found = set(actions) - ({Action.CROSS} if _walks(kind) else set())
    if Action.SWERVE in found:
        found -= {Action.CUT_IN}
    others = found - {Action.ONCOMING}
    found = others if place in JUNCTIONS and others else others | {Action.ONCOMING}
    return tuple(action for action in Action if action in found)


def _turn(text: str) -> set[Action]:
    if _says(words.LEFT_TURN, text):
        return {Action.TURN_LEFT}
    return {Action.TURN_RIGHT} if _says(words.RIGHT_TURN, text) else set()


def _says(pattern: re.Pattern[str], text: str) -> bool:
    """Whether a pattern occurs without a negation before it."""
    return any(not words.NEGATED.search(text[: m.start()].rstrip()) for m in pattern.finditer(text))


def _side(text: str) -> Side | None:
    """The side of the ego on which the adversary is; where it turns to does not count."""
    found = words.SIDE.search(words.TURNING_WORDS.sub(" ", text))
    return Side(found[1]) if found else None


def _maneuver(clauses: Clauses, side: Side | None, notes: list[Note]) -> Maneuver | None:
    text = clauses.ego
    if words.LEFT_TURN.search(text):
        return Maneuver.LEFT_TURN
    if words.RIGHT_TURN.search(text):
        return Maneuver.RIGHT_TURN
    if words.LANE_CHANGE.search(text):
        stated = words.SIDE.search(text)
        if stated is None and side is None:
            notes.append(Note(about=About.SIDE))
        to = stated[1] if stated else side or "left"
        return Maneuver.LANE_CHANGE_RIGHT if to == "right" else Maneuver.LANE_CHANGE_LEFT
    return Maneuver.STRAIGHT if re.search(r"\bstraight\b|\bgo(?:es|ing)? through\b", text) else None


def _control(clauses: Clauses, actions: tuple[Action, ...]) -> Control | None:
    if Action.RUN_LIGHT in actions or words.UNPROTECTED.search(clauses.whole):
        return Control.SIGNAL
    return next((control for control, p in words.CONTROLS.items() if p.search(clauses.whole)), None)


def _place(clauses: Clauses, maneuver: Maneuver | None, actions: tuple[Action, ...]) -> Place | None:
    if maneuver in (Maneuver.BYPASS, Maneuver.LANE_CHANGE_LEFT, Maneuver.LANE_CHANGE_RIGHT):
        return Place.ROAD
    there = any(action.row.at_junction for action in actions)
    junction = maneuver in TURNS or there or words.PLACES[Place.JUNCTION].search(clauses.whole)
    for place in (Place.THREE_WAY, Place.FOUR_WAY):
        if words.PLACES[place].search(clauses.whole):
            return place
    if junction:
        return Place.JUNCTION
    for place in (Place.LEFT_CURVE, Place.RIGHT_CURVE, Place.CURVE, Place.ROAD):
        if words.PLACES[place].search(clauses.whole):
            return place
    return None


@dataclass(frozen=True, slots=True, kw_only=True)
class _Known:
    """What is known of a scene when the adversary's position is looked for."""

    kind: AdversaryKind | None
    actions: tuple[Action, ...]
    side: Side | None
    maneuver: Maneuver | None
    occluder: Occluder | None
    junction: bool


def _position(clauses: Clauses, known: _Known) -> Position | None:
    """Where the adversary starts, from the most telling word to the least."""
    text = clauses.adversary
    if known.occluder is not None:
        return Position.ROADSIDE
    vulnerable = known.kind is not None and known.kind.is_vulnerable
    if vulnerable and words.FAR.search(text):
        return Position.FAR_CORNER if known.junction else Position.ROADSIDE
    if _rides(known.kind) and known.junction and words.SIDE_ROAD.search(text):
        return Position.CROSSING
    if words.ONCOMING.search(text) and Action.REVERSE not in known.actions:
        return Position.ONCOMING
    if vulnerable and _steps_in(text, known):
        return Position.ROADSIDE
    return _in_a_lane(text, known) or _at_a_junction(clauses, known) or _in_the_ego_s_lane(clauses, known)


def _steps_in(text: str, known: _Known) -> bool:
    """Whether somebody on foot or two wheels comes from beside the road."""
    if Action.RUN_LIGHT in known.actions or (words.BEHIND.search(text) and Action.CROSS not in known.actions):
        return False
    if _rides(known.kind) and Action.CROSS not in known.actions and words.SAME_LANE.search(text):
        return False
    at_corner = known.junction and known.side is not None
    return Action.CROSS in known.actions or at_corner or words.FEINT.search(text) is not None


def _in_a_lane(text: str, known: _Known) -> Position | None:
    neighbour = words.NEIGHBOUR.search(text) is not None
    if words.BEHIND.search(text):
        beside = (neighbour or known.side is not None) and not words.SAME_LANE.search(text)
        return Position.BEHIND_BESIDE if beside else None if not words.SAME_LANE.search(text) else Position.BEHIND
    if words.SAME_LANE.search(text) and words.AHEAD.search(text):
        return Position.AHEAD
    if words.AHEAD.search(text) and (neighbour or (known.side is not None and not known.junction)):
        return Position.AHEAD_BESIDE
    if words.BESIDE.search(text):
        return Position.BESIDE
    return Position.AHEAD_BESIDE if known.maneuver in LANE_CHANGES or neighbour else None


def _at_a_junction(clauses: Clauses, known: _Known) -> Position | None:
    if known.junction and known.side is not None:
        ahead = known.maneuver is Maneuver.RIGHT_TURN and words.AHEAD.search(clauses.adversary)
        return Position.AHEAD_BESIDE if ahead else Position.CROSSING
    if Action.RUN_LIGHT in known.actions or words.CROSSING.search(clauses.adversary):
        return Position.CROSSING
    # Oncoming traffic is what an unprotected turn is unprotected against.
    return Position.ONCOMING if words.UNPROTECTED.search(clauses.whole) else None


def _in_the_ego_s_lane(clauses: Clauses, known: _Known) -> Position | None:
    if words.BEHIND.search(clauses.adversary):
        return Position.BEHIND
    if known.side is not None and Action.CUT_IN in known.actions:
        return Position.BESIDE
    drives = known.kind is not None and not _walks(known.kind)
    return Position.AHEAD if drives and words.AHEAD.search(clauses.whole) else None
