"""Step 2 of 9: a sentence to a sub-description per component, and typed slots.

Paper: section 3.3, step ii. The reference asks a language model; this reader is deterministic and needs none. It
cuts the sentence into clauses, finds whose clause each is (the ego's or the adversary's), and reads each with the
patterns of `chatscene.agent.lexicon`.
"""

from __future__ import annotations

import hashlib
import re
from dataclasses import dataclass

from chatscene.agent import lexicon as words
from chatscene.agent.base import JUNCTIONS, LANE_CHANGES, ON_FOOT, TURNS, base_of
from chatscene.agent.wording import geometry_in_words, spawn_in_words
from chatscene.errors import SettingsError
from chatscene.terms.scenario import (
    Action,
    AdversaryKind,
    Control,
    Maneuver,
    Occluder,
    Place,
    Position,
    Scenario,
    Side,
    Slots,
    SubDescriptions,
)

LONGEST = 2000  # characters; a situation fits into a paragraph

_SENTENCE = re.compile(
    r"[;.!?:]+|\b(?:when|while|whilst|but|because|until)\b|\bas\b(?! if)|,"
    r"|\band (?=(?:an?|another|some|someone|we|i|the (?!ego\b))\b)"  # somebody else enters
)
_OPENING = re.compile(r"(?:from|on|to|at|in|behind|ahead|beside)\b")


@dataclass(frozen=True, slots=True)
class _Clauses:
    """A sentence, sorted by whom it speaks of.

    Attributes:
        whole: All of it, mended, without what the ego then has to do.
        ego: What is said of the ego.
        adversary: What is said of the adversary.
    """

    whole: str
    ego: str
    adversary: str


def decompose(text: str) -> Scenario:
    """Read a sentence.

    Args:
        text: English, one situation.

    Returns:
        What was understood; slots that were not said are unfilled.

    Raises:
        SettingsError: The text is empty or longer than `LONGEST`.
    """
    plain = "".join(c if c.isprintable() else " " for c in text)
    plain = " ".join(plain.split())
    if not plain:
        raise SettingsError("the text is empty; describe a situation, such as 'a cyclist cuts across from the left'")
    if len(plain) > LONGEST:
        raise SettingsError(f"the text has {len(plain)} characters; describe one situation in at most {LONGEST}")
    lowered = plain.lower().replace("\N{RIGHT SINGLE QUOTATION MARK}", "'")
    mended = re.sub(r"[a-z]+", lambda m: words.mended(m[0]), lowered)
    clauses = _clauses(mended)
    notes = [f"read {a!r} as {b!r}" for a, b in _changes(lowered, mended)]
    slots = _slots(clauses, notes)
    return Scenario(
        id=_id(plain),
        text=plain,
        base=base_of(slots),
        parts=SubDescriptions(
            behavior=clauses.adversary or clauses.whole,
            geometry=geometry_in_words(slots, clauses.ego),
            spawn=spawn_in_words(slots),
        ),
        slots=slots,
        notes=tuple(notes),
    )


def _id(text: str) -> str:
    stem = "-".join(re.findall(r"[a-z0-9]+", text.lower())[:4]) or "scenario"
    return f"{stem[:40]}-{hashlib.blake2b(text.encode(), digest_size=3).hexdigest()}"


def _changes(before: str, after: str) -> list[tuple[str, str]]:
    pairs = zip(re.findall(r"[a-z]+", before), re.findall(r"[a-z]+", after), strict=False)
    return [(a, b) for a, b in pairs if a != b]


# Clauses


def _clauses(text: str) -> _Clauses:
    text = words.REACTION.sub("", text)
    ego: list[str] = []
    adversary: list[str] = []
    subject, opening = "ego", ""
    for clause in (part.strip() for part in _SENTENCE.split(text)):
        if _OPENING.match(clause) and _subject(clause) is None and not _does_something(clause):
            opening = f"{opening} {clause}".strip()  # "On the left, …" speaks of whoever comes next
        elif clause:
            subject = _subject(clause) or subject
            (ego if subject == "ego" else adversary).append(f"{opening} {clause}".strip())
            opening = ""
    if opening:
        (ego if subject == "ego" else adversary).append(opening)
    spoken = ", ".join(adversary)
    if words.ADVERSARIAL.search(spoken):  # whoever is called so is meant, whoever else may drive about
        spoken = spoken[words.ADVERSARIAL.search(spoken).start() :]  # type: ignore[union-attr]
    return _Clauses(text, ", ".join(ego), spoken)


def _subject(clause: str) -> str | None:
    """Who does something in a clause: the first of the two that is mentioned as more than an object."""
    bare = _without_things(words.EGO_AS_OBJECT.sub(" ", clause))
    if words.ADVERSARIAL.search(clause):
        return "adversary"
    ego = words.EGO.search(bare)
    other = min((m.start() for p in words.KINDS.values() if (m := p.search(bare))), default=None)
    if ego and other is not None and words.ENCOUNTER.search(bare[:other]):
        return "ego" if words.BLOCKING.search(clause) else "adversary"
    if ego is None:
        return None if other is None else "adversary"
    return "ego" if other is None or ego.start() < other else "adversary"


def _does_something(clause: str) -> bool:
    return any(pattern.search(clause) for pattern in (*words.ACTIONS.values(), words.LEFT_TURN, words.RIGHT_TURN))


def _without_things(text: str) -> str:
    """A text without what stands about or drives in the background."""
    for pattern in (*words.OCCLUDERS.values(), words.BACKGROUND):
        text = pattern.sub(" ", text)
    # Who is called a leader is one only for somebody else; as the subject of a clause he is the adversary.
    return words.LEADER.sub(lambda m: m[0] if text[: m.start()].strip() in ("", "a", "the") else " ", text)


# Slots


def _slots(clauses: _Clauses, notes: list[str]) -> Slots:
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
    if actions and Action.REVERSE in actions:
        actions = tuple(action for action in actions if action is not Action.ONCOMING)
    if position is Position.ONCOMING:
        actions = _of_oncoming(actions, kind, place)
    if kind is None:
        strangers = words.strangers(clauses.whole)
        heard = f"; no road user the library has: {', '.join(strangers)}" if strangers else ""
        notes.append(f"who the adversary is was not said{heard}")
    if not actions:
        notes.append("what the adversary does was not understood")
    return Slots(
        adversary=kind,
        actions=actions,
        side=side,
        position=position,
        occluder=None if blocker else occluder,
        maneuver=maneuver,
        place=place,
        control=control,
        leader=leader,
        blocker=blocker,
    )


def _kind(clauses: _Clauses) -> AdversaryKind | None:
    """The kind mentioned first in what is said of the adversary."""
    for text in (clauses.adversary, clauses.whole):
        bare = _without_things(text)
        if text is clauses.whole:
            bare = words.EGO.sub(" ", words.EGO_AS_OBJECT.sub(" ", bare))
        found = [(m.start(), i, kind) for i, (kind, p) in enumerate(words.KINDS.items()) if (m := p.search(bare))]
        if found:
            return min(found)[2]
        if words.SOMEBODY.search(bare):
            return _somebody(clauses)
    return None


def _somebody(clauses: _Clauses) -> AdversaryKind | None:
    """What kind somebody is of whom only that is said: a driver if he does what only drivers do."""
    driving = (Action.RUN_LIGHT, Action.CUT_IN, Action.REVERSE, Action.CHANGE_LANE)
    drives = any(words.ACTIONS[action].search(clauses.adversary or clauses.whole) for action in driving)
    return AdversaryKind.CAR if drives else AdversaryKind.PEDESTRIAN


def _occluder(clauses: _Clauses) -> Occluder | None:
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
)


def _actions(clauses: _Clauses, kind: AdversaryKind | None) -> tuple[Action, ...]:
    text = clauses.adversary
    for pattern in (*words.OCCLUDERS.values(), words.NO_ACTION):
        text = pattern.sub(" ", text)
    found = {action for action, pattern in words.ACTIONS.items() if _says(pattern, text)}
    for pattern, action, fall, join in _WORDINGS:
        if pattern.search(text) and (action is None or action in found):
            found = (found - fall) | join
    found = _on_foot(found, text, kind) if kind in ON_FOOT else _at_the_wheel(found, text)
    if found - {Action.ONCOMING, Action.FOLLOW}:
        found -= {Action.FOLLOW}  # whoever does something else drives on as well
    elif kind not in (None, AdversaryKind.PEDESTRIAN) and words.PASSING.search(text):
        found.add(Action.FOLLOW)
    return tuple(action for action in Action if action in found)


def _on_foot(found: set[Action], text: str, kind: AdversaryKind | None) -> set[Action]:
    """What the actions of somebody on foot or on two wheels come to, who can cross as well as drive."""
    if kind is AdversaryKind.PEDESTRIAN:
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
    if turn and Action.RUN_LIGHT not in found and "oncoming" not in text:
        found = found - {Action.CUT_IN}
    return found | turn


def _of_oncoming(actions: tuple[Action, ...], kind: AdversaryKind | None, place: Place | None) -> tuple[Action, ...]:
    """What somebody who comes toward the ego does.

    On open road, coming toward the ego is itself what he does, and on foot he enters the lane rather than crosses
    it; at a junction it only says from where he comes.
    """
    found = set(actions) - ({Action.CROSS} if kind is AdversaryKind.PEDESTRIAN else set())
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


def _maneuver(clauses: _Clauses, side: Side | None, notes: list[str]) -> Maneuver | None:
    text = clauses.ego
    if words.LEFT_TURN.search(text):
        return Maneuver.LEFT_TURN
    if words.RIGHT_TURN.search(text):
        return Maneuver.RIGHT_TURN
    if words.LANE_CHANGE.search(text):
        stated = words.SIDE.search(text)
        if stated is None and side is None:
            notes.append("to which side the ego changes lanes was not said; the left is assumed")
        to = stated[1] if stated else side or "left"
        return Maneuver.LANE_CHANGE_RIGHT if to == "right" else Maneuver.LANE_CHANGE_LEFT
    return Maneuver.STRAIGHT if re.search(r"\bstraight\b|\bgo(?:es|ing)? through\b", text) else None


def _control(clauses: _Clauses, actions: tuple[Action, ...]) -> Control | None:
    if Action.RUN_LIGHT in actions or words.UNPROTECTED.search(clauses.whole):
        return Control.SIGNAL
    return next((control for control, p in words.CONTROLS.items() if p.search(clauses.whole)), None)


def _place(clauses: _Clauses, maneuver: Maneuver | None, actions: tuple[Action, ...]) -> Place | None:
    if maneuver in (Maneuver.BYPASS, Maneuver.LANE_CHANGE_LEFT, Maneuver.LANE_CHANGE_RIGHT):
        return Place.ROAD
    turns = {Action.RUN_LIGHT, Action.TURN_LEFT, Action.TURN_RIGHT} & set(actions)
    junction = maneuver in TURNS or turns or words.PLACES[Place.JUNCTION].search(clauses.whole)
    for place in (Place.THREE_WAY, Place.FOUR_WAY):
        if words.PLACES[place].search(clauses.whole):
            return place
    if junction:
        return Place.JUNCTION
    for place in (Place.CURVE, Place.ROAD):
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


def _position(clauses: _Clauses, known: _Known) -> Position | None:
    """Where the adversary starts, from the most telling word to the least."""
    text = clauses.adversary
    if known.occluder is not None:
        return Position.ROADSIDE
    if known.kind in ON_FOOT and words.FAR.search(text):
        return Position.FAR_CORNER if known.maneuver in TURNS else Position.ROADSIDE
    if words.ONCOMING.search(text) and Action.REVERSE not in known.actions:
        return Position.ONCOMING
    if known.kind in ON_FOOT and _steps_in(text, known):
        return Position.ROADSIDE
    return _in_a_lane(text, known) or _at_a_junction(clauses, known) or _in_the_ego_s_lane(clauses, known)


def _steps_in(text: str, known: _Known) -> bool:
    """Whether somebody on foot or two wheels comes from beside the road."""
    if Action.RUN_LIGHT in known.actions or (words.BEHIND.search(text) and Action.CROSS not in known.actions):
        return False
    at_corner = known.junction and known.side is not None
    return Action.CROSS in known.actions or at_corner or words.FEINT.search(text) is not None


def _in_a_lane(text: str, known: _Known) -> Position | None:
    if words.BESIDE.search(text):
        return Position.BESIDE
    if known.side is not None and words.BEHIND.search(text):
        return Position.BEHIND_BESIDE
    return Position.AHEAD_BESIDE if known.maneuver in LANE_CHANGES or words.NEIGHBOUR.search(text) else None


def _at_a_junction(clauses: _Clauses, known: _Known) -> Position | None:
    if known.junction and known.side is not None:
        ahead = known.maneuver is Maneuver.RIGHT_TURN and words.AHEAD.search(clauses.adversary)
        return Position.AHEAD_BESIDE if ahead else Position.CROSSING
    if Action.RUN_LIGHT in known.actions or words.CROSSING.search(clauses.adversary):
        return Position.CROSSING
    # Oncoming traffic is what an unprotected turn is unprotected against.
    return Position.ONCOMING if words.UNPROTECTED.search(clauses.whole) else None


def _in_the_ego_s_lane(clauses: _Clauses, known: _Known) -> Position | None:
    if words.BEHIND.search(clauses.adversary):
        return Position.BEHIND
    if known.side is not None and Action.CUT_IN in known.actions:
        return Position.BESIDE
    drives = known.kind not in (None, AdversaryKind.PEDESTRIAN)
    return Position.AHEAD if drives and words.AHEAD.search(clauses.whole) else None
