"""Facts said once, plainly and always in the same words, so that a person can tell two readings apart.

`chatscene.sentences.rendering` says facts in many ways, by chance; this is for whoever is asked which of them is meant.
Most of what it says is read whole again (`chatscene.read.parse`), and then as just these facts.
"""

from __future__ import annotations

from chatscene.situations.inflection import Form, conjugated, listed
from chatscene.terms.actors import AdversaryKind, Manner
from chatscene.terms.acts import Action
from chatscene.terms.conclusions import JUNCTIONS
from chatscene.terms.nouns import plural, with_article
from chatscene.terms.scenario import (
    Control,
    Distance,
    EgoState,
    Maneuver,
    Occluder,
    Place,
    Position,
    Site,
    Slots,
)

_EGO_DOES = {
    Maneuver.STRAIGHT: "drive straight on",
    Maneuver.LEFT_TURN: "turn left",
    Maneuver.RIGHT_TURN: "turn right",
    Maneuver.LANE_CHANGE_LEFT: "change lanes to the left",
    Maneuver.LANE_CHANGE_RIGHT: "change lanes to the right",
    Maneuver.BYPASS: "go around a parked car",
}
_EGO_STATES = {
    EgoState.STANDS: "wait",
    EgoState.SETS_OFF: "set off",
    EgoState.SLOW: "drive slowly",
    EgoState.SLOWS_DOWN: "slow down",
    EgoState.BRAKES: "brake",
    EgoState.STOPS: "stop",
}
_PLACES = {
    Place.ROAD: "down a road",
    Place.CURVE: "in a curve",
    Place.LEFT_CURVE: "in a left curve",
    Place.RIGHT_CURVE: "in a right curve",
    Place.THREE_WAY: "at a T-junction",
    Place.FOUR_WAY: "at a crossroads",
    Place.JUNCTION: "at an intersection",
}
_SITES = {
    Site.ROUNDABOUT: "in a roundabout",
    Site.MOTORWAY: "down a motorway",
    Site.ON_RAMP: "from an on-ramp",
    Site.OFF_RAMP: "to an off-ramp",
    Site.PAST_ON_RAMP: "past an on-ramp",
    Site.PAST_OFF_RAMP: "past an off-ramp",
    Site.WEAVING: "in a weaving section",
    Site.LANE_DROP: "in a lane that ends",
    Site.RURAL: "down a rural road",
    Site.CROSSWALK: "at a crosswalk",
    Site.PARKING: "along parking places",
    Site.BUS_BAY: "at a bus bay",
}
_CONTROLS = {
    Control.SIGNAL: "with traffic lights",
    Control.STOP_SIGN: "with stop signs",
    Control.NONE: "without traffic lights",
}
_LANES = {1: "a single lane", 2: "two lanes", 3: "three lanes"}
_STARTS = {  # without and with a side
    Position.AHEAD: ("ahead of us", "ahead of us"),
    Position.ROADSIDE: ("from the side of the road", "from the {side} side of the road"),
    Position.BESIDE: ("beside us", "beside us on the {side}"),
    Position.AHEAD_BESIDE: ("ahead of us in the next lane", "ahead of us in the {side} lane"),
    Position.BEHIND: ("behind us", "behind us"),
    Position.BEHIND_BESIDE: ("behind us in the next lane", "behind us in the {side} lane"),
    Position.ONCOMING: ("", ""),
    Position.CROSSING: ("from a side street", "from the {side} side street"),
    Position.FAR_CORNER: ("from the far corner", "from the far corner on the {side}"),
    Position.KERB: ("at the kerb", "at the {side} kerb"),
    Position.BEYOND: ("around the corner", "around the corner"),
}
_HIDES = {
    Occluder.BUS_STOP: "a bus stop",
    Occluder.VENDING_MACHINE: "a vending machine",
    Occluder.PARKED_CAR: "a parked car",
    Occluder.PARKED_TRUCK: "a parked truck",
    Occluder.KIOSK: "a kiosk",
    Occluder.CONTAINER: "a container",
    Occluder.PARKED_BUS: "a parked bus",
    Occluder.HEDGE: "a hedge",
    Occluder.BILLBOARD: "a billboard",
}
_DISTANCES = {Distance.NEAR: "close", Distance.FAR: "far away"}


def told(slots: Slots) -> str:
    """Facts in one or two plain sentences.

    Args:
        slots: The facts, none of them guessed at: what is not filled is not said.
    """
    sentences = [_ego(slots), *(_road_user(one) for one in (slots, *slots.others))]
    return " ".join(f"{sentence[0].upper()}{sentence[1:]}." for sentence in sentences if sentence)


def _ego(slots: Slots) -> str:
    """What the ego does and where; empty if nothing is said of it."""
    does = [_EGO_STATES[slots.ego]] if slots.ego else []
    if slots.maneuver is not None and (slots.maneuver is not Maneuver.STRAIGHT or slots.place in JUNCTIONS):
        does.append(_EGO_DOES[slots.maneuver])
    where = " ".join(one for one in ("behind a slow car" if slots.leader else "", _where(slots)) if one)
    if where and not does:
        does = ["drive"]
    return f"we {' and '.join(does)} {where}".strip() if does else ""


def _where(slots: Slots) -> str:
    if slots.site is not None:
        return _SITES[slots.site]
    if slots.place is not None and slots.place in JUNCTIONS:
        control = f" {_CONTROLS[slots.control]}" if slots.control else ""
        return f"{_PLACES[slots.place]}{control}"
    lanes = f" with {_LANES[slots.lanes]} in our direction" if slots.lanes else ""
    if slots.two_way is not None:
        return f"down {'a two' if slots.two_way else 'a one'}-way road{lanes}"
    if slots.place is None and not lanes:
        return ""
    return f"{_PLACES[slots.place or Place.ROAD]}{lanes}"


def _road_user(slots: Slots) -> str:
    """Who does what, from where."""
    oncoming = slots.position is Position.ONCOMING
    name = f"{'oncoming ' * oncoming}{slots.adversary.replace('-', ' ') if slots.adversary else 'road user'}"
    noun = f"several {plural(name)}" if slots.group else with_article(name)
    form = Form.PLURAL if slots.group else Form.SINGULAR
    acts = [one for one in slots.actions if one is not Action.ONCOMING or not oncoming or len(slots.actions) == 1]
    does = [_act(one, slots.adversary, form) for one in acts] or [conjugated("[do] something", form)]
    distance = _DISTANCES[slots.distance] if slots.distance else ""
    return " ".join(word for word in (noun, distance, _start(slots), ", then ".join(does)) if word)


def _start(slots: Slots) -> str:
    """Where somebody starts, as it stands behind the noun."""
    if slots.occluder is not None:
        return f"from behind {_HIDES[slots.occluder]}" + (f" on the {slots.side}" if slots.side else "")
    if slots.position is None:
        return f"from the {slots.side}" if slots.side else ""
    plain, sided = _STARTS[slots.position]
    return sided.format(side=slots.side) if slots.side else plain


def _act(action: Action, kind: AdversaryKind | None, form: Form) -> str:
    """An act in the first words of its table that somebody of this manner has."""
    row, manner = action.row, kind.row.manner if kind else Manner.DRIVES
    own = {Manner.RIDES: row.rides, Manner.WALKS: row.walks}.get(manner, "")
    phrase = listed(own or row.drives)[0]
    for brace, meant in _BRACES.items():
        phrase = phrase.replace(brace, meant)
    of_several = form is Form.PLURAL or manner is Manner.WALKS
    return conjugated(phrase.replace("{its}", "their" if of_several else "its"), form)


_BRACES = {" {from}": "", "{ego}": "us", "{egos}": "our"}
