"""Facts that have names, as edits and the library know them, as a situation: the one place where they become one.

They are slots, numbers and surroundings of one adversary, and slots of others. What each is in a situation stands in
`chatscene.interpret.situation_rows`.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any

from chatscene.interpret.situation_rows import (
    ACTS,
    AMOUNTS,
    BESIDE,
    BLOCKS,
    EGO_DOES,
    HIDES,
    HIDING,
    KINDS,
    LEADS,
    MANNERS,
    ROADS,
    ROUTES,
    RULES,
    SITES,
    STARTS,
    WAYS_OF_SITES,
    WHO,
    aside_of,
)
from chatscene.terms.actors import Manner as Moves
from chatscene.terms.acts import Action
from chatscene.terms.amount import Amount, Length, Speed
from chatscene.terms.conclusions import JUNCTIONS
from chatscene.terms.scenario import Control, Distance, EgoState, Quantity, QuantityKind, Site, Slots
from chatscene.terms.situation import Around, Deed, Ego, Other, Road, Situation, Start, When
from chatscene.terms.surroundings import FOLLOWS, Light, Surface, Surroundings, Weather
from chatscene.terms.vocabulary import (
    Act,
    Breach,
    EgoLight,
    EgoRoute,
    Facing,
    Heads,
    Manner,
    Role,
    Side,
    UserKind,
    Where,
    acts_of,
)

_ALL_ALONG = frozenset((*MANNERS, Action.RUN_LIGHT, Action.FOLLOW, Action.ONCOMING, Action.WRONG_WAY))
"""Acts that say how or where another is done, if there is another."""
_ROUNDED = 0.01  # of SI units, to which a number is rounded when it is read


def _ego_speed(numbers: Sequence[Quantity]) -> Speed | None:
    return next((_amount(Speed, one) for one in numbers if one.measure is QuantityKind.EGO_SPEED), None)


def in_a_situation(slots: Slots, numbers: Sequence[Quantity], around: Surroundings) -> Situation:
    """Facts as a situation, without evidence."""
    who = _other(WHO, Role.ADVERSARY, slots, numbers, slots)
    beside = (_other(name, Role.SUPPORTING, one, (), slots) for name, one in zip(BESIDE, slots.others, strict=False))
    return Situation(
        ego=Ego(
            route=_route(slots), speed=_ego_speed(numbers), does=EGO_DOES[slots.ego] if slots.ego is not None else ()
        ),
        road=_road(slots),
        others=(who, *beside, *_around_it(slots)),
        around=_around(around),
    )


def _route(slots: Slots) -> EgoRoute | None:
    by_site = WAYS_OF_SITES.get(slots.site) if slots.site is not None else None
    return by_site or ROUTES[slots.maneuver]


def _road(slots: Slots) -> Road:
    site = SITES[slots.site] if slots.site is not None else Road()
    kind = site.kind or (ROADS[slots.place] if slots.place is not None else None)
    waits = slots.ego is EgoState.STANDS and slots.control is Control.SIGNAL
    light = EgoLight.RED if waits else None
    return replace(
        site,
        kind=kind,
        control=RULES[slots.control],
        ego_light=light,
        lanes=slots.lanes,
        two_way=slots.two_way,
    )


def _around(said: Surroundings) -> Around:
    """Light, weather and road; what is usual is what nobody says."""
    return Around(
        light=said.light if said.light is not Light.DAY else None,
        weather=said.weather if said.weather is not Weather.CLEAR else None,
        surface=said.surface if said.surface not in (Surface.DRY, FOLLOWS.get(said.weather)) else None,
    )


def _around_it(slots: Slots) -> Iterator[Other]:
    """Who hides the adversary, who leads the ego, and who stands in its way."""
    if slots.occluder is not None:
        kind, where = HIDING[slots.occluder]
        start = Start(where=where, side=_side(slots))
        yield Other(id=HIDES, kind=kind, role=Role.HIDES, starts=start, does=(Deed(act=Act.STAND),))
    if slots.leader:
        slowly = (Deed(act=Act.GO_ALONG, manner=Manner.SLOW),)
        yield Other(id=LEADS, kind=UserKind.VEHICLE, role=Role.SUPPORTING, starts=Start(where=Where.AHEAD), does=slowly)
    if slots.blocker:
        yield Other(
            id=BLOCKS,
            kind=UserKind.VEHICLE,
            role=Role.SUPPORTING,
            starts=Start(where=Where.AHEAD),
            does=(Deed(act=Act.STAND),),
        )


# One of the others


def _other(name: str, role: Role, slots: Slots, numbers: Sequence[Quantity], whole: Slots) -> Other:
    kind = KINDS[slots.adversary]
    start = _start(slots, kind, numbers, junction=whole.place in JUNCTIONS or whole.control is not None)
    deeds = _numbered(_deeds(slots, start), numbers, start)
    speed = next((one for one in numbers if one.measure is QuantityKind.SPEED), None)
    if speed is not None and not any("speed" in deed.act.row.takes for deed in deeds):  # so it drove at it before
        start = replace(start, speed=_amount(Speed, speed))
    hidden = HIDES if role is Role.ADVERSARY and slots.occluder is not None else None
    return Other(
        id=name, kind=kind, count=0 if slots.group else 1, role=role, starts=start, hidden_by=hidden, does=deeds
    )


def _side(slots: Slots) -> Side | None:
    return Side(slots.side.value) if slots.side is not None else None


def _start(slots: Slots, kind: UserKind, numbers: Sequence[Quantity], *, junction: bool) -> Start:
    where = STARTS[slots.position] if slots.position is not None else _usual(slots, kind, junction=junction)
    if Action.WRONG_WAY in slots.actions:
        where = Where.ONCOMING_IN_OUR_LANE
    if where is Where.KERB and kind.moves is Moves.WALKS:
        where = Where.ROADSIDE
    if slots.site is Site.CROSSWALK and where is Where.ROADSIDE:
        where = Where.CROSSING
    if slots.site is Site.PAST_ON_RAMP and Action.CUT_IN in slots.actions:
        where = Where.ON_RAMP
    if slots.site is Site.BUS_BAY and where is Where.KERB:
        where = Where.BUS_BAY
    distance = next((_amount(Length, one) for one in numbers if one.measure is QuantityKind.DISTANCE), None)
    if distance is None and slots.distance is not None:
        low, high = slots.distance.bounds(slots.position)
        distance = Length(low, high) if slots.distance is Distance.FAR else Length(-float("inf"), high)
    facing = Facing.AGAINST if kind.moves is Moves.WALKS and Action.ONCOMING in slots.actions else None
    if where is Where.ONCOMING and facing is not None:
        where = Where.AHEAD
    return Start(where=where, side=_side(slots) if where.row.sided else None, distance=distance, facing=facing)


_USUAL: dict[Action, Where] = {
    Action.CUT_IN: Where.AHEAD_BESIDE,
    Action.CHANGE_LANE: Where.AHEAD_BESIDE,
    Action.PACE: Where.BESIDE,
    Action.OVERTAKE: Where.BEHIND,
    Action.TAILGATE: Where.BEHIND,
    Action.PULL_OUT: Where.KERB,
    Action.ONCOMING: Where.ONCOMING,
    Action.TURN_BACK: Where.ROADSIDE,
}


def _usual(slots: Slots, kind: UserKind, *, junction: bool) -> Where:
    """Where somebody is of whom that was not said."""
    drives = kind.moves is Moves.DRIVES or kind is UserKind.MOTORCYCLE
    acts = slots.actions
    if Action.RUN_LIGHT in acts or (junction and drives and Action.CROSS in acts):
        return Where.ARM
    if junction and (Action.TURN_LEFT in acts or Action.TURN_RIGHT in acts):
        return Where.ONCOMING
    if Action.CROSS in acts or Action.DIAGONAL in acts:
        return Where.DRIVEWAY if drives else Where.ROADSIDE
    usual = next((_USUAL[act] for act in acts if act in _USUAL), None)
    return usual or (Where.ROADSIDE if kind.moves is Moves.WALKS and set(acts) == {Action.FOLLOW} else Where.AHEAD)


def _deeds(slots: Slots, start: Start) -> tuple[Deed, ...]:
    """What somebody does, in order."""
    said = [act for act in slots.actions if act not in _ALL_ALONG]
    said = [act for act, after in zip(said, [*said[1:], None], strict=False) if (act, after) not in _BEGINS]
    manner = next((MANNERS[act] for act in _manners(slots)), None)
    runs = Action.RUN_LIGHT in slots.actions
    if not said:
        said = [Action.DIAGONAL if Action.DIAGONAL in slots.actions else next(iter(slots.actions), Action.FOLLOW)]
    deeds = [_deed(act, slots, start) for act in dict.fromkeys(said)]
    if manner is not None:
        at = next((i for i, one in enumerate(deeds) if one.act is not Act.STAND), 0)
        deeds[at] = replace(deeds[at], manner=manner)
    if runs:
        through = acts_of(Heads.THROUGH, Heads.TURNS, Heads.ACROSS)
        at = next((i for i, one in enumerate(deeds) if one.act in through), None)
        if at is None:
            deeds.insert(0, Deed(act=Act.GO_STRAIGHT, breaks=Breach.RED_LIGHT))
        else:
            deeds[at] = replace(deeds[at], breaks=Breach.RED_LIGHT)
    return tuple(deeds)


def _manners(slots: Slots) -> list[Action]:
    """The acts that say how another is done, that which is told first."""
    return [act for act in MANNERS if act in slots.actions]


_BEGINS = ((Action.BRAKE, Action.STOP), (Action.CHANGE_LANE, Action.CUT_IN))
"""Acts of which the first is only how the second begins."""


def _deed(action: Action, slots: Slots, start: Start) -> Deed:
    act, where = ACTS[action], start.where
    through = where is Where.ARM or (where is Where.ONCOMING and (slots.place in JUNCTIONS or slots.control))
    if act in acts_of(Heads.ACROSS, Heads.ALONG) and through:
        act = Act.GO_STRAIGHT
    if act is Act.LANE_CHANGE and where is Where.AHEAD:
        act = Act.CUT_OUT
    if act is Act.CUT_IN and where is Where.ON_RAMP:
        act = Act.MERGE
    if act is Act.CUT_IN and where is Where.ARM:
        act = Act.ENTER
    if act is Act.GO_ALONG and where is Where.BEHIND:
        act = Act.FOLLOW
    return Deed(act=act)


def _numbered(deeds: tuple[Deed, ...], numbers: Sequence[Quantity], start: Start) -> tuple[Deed, ...]:
    """Deeds with the numbers that were said of them: each of the first that it can be said of."""
    made = list(deeds)
    for one in numbers:
        if one.measure in AMOUNTS:
            name, kind = AMOUNTS[one.measure]
            at = next((i for i, deed in enumerate(made) if name in deed.act.row.takes), None)
            if at is not None:
                made[at] = replace(made[at], **{name: _amount(kind, one)})
        elif one.measure is QuantityKind.TRIGGER and made:
            at = next((i for i, deed in enumerate(made) if not deed.act.row.lasting), len(made) - 1)
            made[at] = replace(made[at], when=When(ego_within=_amount(Length, one)))
        elif one.measure is QuantityKind.ASIDE:
            at = next((i for i, deed in enumerate(made) if deed.act is Act.SWERVE), None)
            if at is not None:
                made[at] = replace(made[at], to=next(to for to in Side if aside_of(to, start.where) == one.value))
    return tuple(made)


def _amount(kind: type[Amount], number: Quantity) -> Any:
    """A number as it was said, if its words end in an amount; its value was rounded when it was read."""
    words = number.said.split()
    for at in range(len(words)):
        try:
            said = kind.of(" ".join(words[at:]))
        except ValueError:
            continue
        if said.exact and abs(said.low - number.value) < _ROUNDED:
            return said
    if kind is Speed:  # as finely as it is said
        return kind.of(f"{round(3.6 * number.value, 1):g} km/h")
    read = round(number.value, 2)
    return kind(read, read)
