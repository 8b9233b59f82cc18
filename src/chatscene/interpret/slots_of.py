"""A situation as the facts that have names of their own: `chatscene.interpret.situation_rows` read back.

What no slot holds is not here; it stays in the situation, whatever is stated.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from chatscene.interpret.situation_rows import (
    ACTS,
    BESIDE,
    BLOCKS,
    EGO_DOES,
    HIDES,
    HIDING,
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
from chatscene.terms.acts import Action
from chatscene.terms.amount import Amount
from chatscene.terms.edit import Facts
from chatscene.terms.scenario import (
    Control,
    EgoState,
    Maneuver,
    Occluder,
    Place,
    Position,
    Quantity,
    QuantityKind,
    Site,
    Slots,
)
from chatscene.terms.scenario import Side as Aside
from chatscene.terms.situation import Deed, Ego, Other, Situation
from chatscene.terms.surroundings import FOLLOWS, Light, Surface, Surroundings, Weather
from chatscene.terms.vocabulary import PLAIN, Act, Breach, EgoRoute, Manner, RightOfWay, RoadKind, Role, Where

POSITIONS: dict[Where, Position] = {
    **{where: position for position, where in STARTS.items()},
    Where.ONCOMING_IN_OUR_LANE: Position.ONCOMING,
    Where.CROSSING: Position.ROADSIDE,
    Where.DRIVEWAY: Position.ROADSIDE,
    Where.MEDIAN: Position.ROADSIDE,
    Where.ON_RAMP: Position.AHEAD_BESIDE,
    Where.BUS_BAY: Position.KERB,
}
ACTIONS: dict[Act, Action] = {
    **{act: action for action, act in reversed(ACTS.items())},
    Act.CUT_OUT: Action.CHANGE_LANE,
    Act.MERGE: Action.CUT_IN,
    Act.SET_OFF: Action.ACCELERATE,
    Act.SLOW_DOWN: Action.BRAKE,
    Act.DRIFT: Action.SWERVE,
    Act.ENTER: Action.CROSS,
    Act.GO_ALONG: Action.FOLLOW,
    Act.FOLLOW: Action.FOLLOW,
    Act.STAND: Action.STAND,
    Act.CROSS: Action.CROSS,
}
_MEASURES = (("speed", QuantityKind.SPEED), ("time", QuantityKind.TIME), ("acceleration", QuantityKind.DECELERATION))


@dataclass(frozen=True, slots=True, kw_only=True)
class Parties:
    """Who of a situation is who among the facts that have names of their own.

    Attributes:
        adversary: The first who meets the ego.
        leads: Who drives slowly ahead of the ego.
        blocks: Who stands in the ego's way, beside the adversary.
    """

    adversary: Other
    beside: tuple[Other, ...] = ()
    hides: Other | None = None
    leads: Other | None = None
    blocks: Other | None = None

    @property
    def names(self) -> Mapping[str, str]:
        """The ids that `situation_of` gives, by the ids that they have here."""
        single = ((self.adversary, WHO), (self.hides, HIDES), (self.leads, LEADS), (self.blocks, BLOCKS))
        several = zip(self.beside, BESIDE, strict=False)
        return {one.id: name for one, name in (*single, *several) if one is not None}


def parties_of(situation: Situation) -> Parties | None:
    """Who is who; None where nobody meets the ego."""
    who = next(iter(situation.adversaries), None)
    if who is None:
        return None
    rest = [one for one in situation.others if one is not who]
    hides = next((one for one in rest if one.id == who.hidden_by), None)
    rest = [one for one in rest if one is not hides]
    ahead = [one for one in rest if one.starts.where is Where.AHEAD and one.role is Role.SUPPORTING]
    leads = next((one for one in ahead if [(d.act, d.manner) for d in one.does] == [(Act.GO_ALONG, Manner.SLOW)]), None)
    swings = situation.ego.route is EgoRoute.BYPASS
    blocks = next((one for one in ahead if swings and [d.act for d in one.does] == [Act.STAND]), None)
    beside = tuple(one for one in rest if one is not leads and one is not blocks)
    return Parties(adversary=who, beside=beside[: len(BESIDE)], hides=hides, leads=leads, blocks=blocks)


def facts_of(situation: Situation, parties: Parties) -> Facts:
    """The facts that have names of their own."""
    around, road = situation.around, situation.road
    follows = FOLLOWS.get(around.weather) if around.weather is not None else None
    who = parties.adversary
    site = _site(situation)
    places: dict[RoadKind | None, Place] = {kind: place for place, kind in ROADS.items()}
    rules: dict[RightOfWay | None, Control | None] = {rule: control for control, rule in RULES.items()}
    ways: dict[EgoRoute | None, Maneuver | None] = {way: one for one, way in ROUTES.items()}
    slots = _slots(
        who,
        occluder=_occluder(parties.hides),
        maneuver=ways.get(situation.ego.route),
        place=places.get(road.kind),
        control=rules.get(road.control),
        leader=True if parties.leads is not None else None,
        blocker=True if parties.blocks is not None else None,
        lanes=road.lanes if road.lanes is not None and road.lanes <= 3 else None,
        two_way=road.two_way,
        ego=_ego_state(situation.ego.does),
        site=site,
        others=tuple(_slots(one) for one in parties.beside),
    )
    surroundings = Surroundings(
        light=around.light or Light.DAY,
        weather=around.weather or Weather.CLEAR,
        surface=around.surface or follows or Surface.DRY,
    )
    return Facts(slots=slots, surroundings=surroundings, quantities=tuple(_quantities(who, situation.ego)))


def _slots(one: Other, **more: object) -> Slots:
    side = one.starts.side
    return Slots(
        adversary=one.kind.row.body.heard_as,
        actions=tuple(dict.fromkeys(_actions(one))),
        side=Aside(side.value) if side is not None else None,
        position=POSITIONS.get(one.starts.where),
        group=True if one.count != 1 else None,
        **more,  # type: ignore[arg-type]
    )


_AGAINST = {Where.ONCOMING_IN_OUR_LANE: Action.WRONG_WAY, Where.ONCOMING: Action.ONCOMING}
_THROUGH = {Where.ARM: Action.CROSS}


def _actions(one: Other) -> Iterator[Action]:
    where = one.starts.where
    manners: dict[Manner | None, Action] = {manner: action for action, manner in MANNERS.items()}
    acts = [deed.act for deed in one.does]
    if where is Where.ONCOMING_IN_OUR_LANE or (where is Where.ONCOMING and set(acts) <= PLAIN):
        yield _AGAINST[where]
    for i, deed in enumerate(one.does):
        if deed.act is Act.STAND and i == 0 and len(acts) > 1:
            continue  # what it did before
        if deed.breaks is Breach.RED_LIGHT:
            yield Action.RUN_LIGHT  # which comes first, whatever else is done on the way through
        said = deed.manner in manners or deed.breaks is Breach.RED_LIGHT or where in _AGAINST
        if deed.act in PLAIN and where in _THROUGH and deed.breaks is not Breach.RED_LIGHT:
            yield _THROUGH[where]
        elif deed.act in ACTIONS and not (deed.act in PLAIN and said):
            yield ACTIONS[deed.act]
        if deed.manner in manners:
            yield manners[deed.manner]


def _occluder(hides: Other | None) -> Occluder | None:
    """What hides somebody; a van that does is a parked car."""
    if hides is None:
        return None
    exact = (one for one, (kind, _) in HIDING.items() if kind is hides.kind)
    body = hides.kind.row.body.heard_as
    alike = (one for one, (kind, _) in HIDING.items() if not kind.row.prop and kind.row.body is body)
    return next(exact, next(alike, None))


def _ego_state(does: tuple[Deed, ...]) -> EgoState | None:
    acts = [(deed.act, deed.manner) for deed in does]
    return next((state for state, deeds in EGO_DOES.items() if [(d.act, d.manner) for d in deeds] == acts), None)


def _site(situation: Situation) -> Site | None:
    road = situation.road
    by_way = next((site for site, way in WAYS_OF_SITES.items() if way is situation.ego.route), None)
    if by_way is not None:
        return by_way
    fits = [
        site
        for site, there in SITES.items()
        if site not in WAYS_OF_SITES
        and (there.kind in (None, road.kind))
        and (there.setting in (None, road.setting))
        and set(there.has) <= set(road.has)
    ]
    return max(fits, key=lambda site: len(SITES[site].has), default=None)


def _quantities(who: Other, ego: Ego) -> Iterator[Quantity]:
    """The numbers that were said of somebody and of the ego."""
    if (drives := _number(QuantityKind.EGO_SPEED, ego.speed)) is not None:
        yield drives
    if (there := _number(QuantityKind.DISTANCE, who.starts.distance)) is not None:
        yield there
    for name, measure in _MEASURES:
        amounts = [getattr(deed, name) for deed in who.does] + [who.starts.speed] * (measure is QuantityKind.SPEED)
        said = next((one for amount in amounts if (one := _number(measure, amount)) is not None), None)
        if said is not None:
            yield said
    near = (deed.when.ego_within for deed in who.does if deed.when is not None)
    if (
        trigger := next((one for one in (_number(QuantityKind.TRIGGER, amount) for amount in near) if one), None)
    ) is not None:
        yield trigger
    aside = next((deed.to for deed in who.does if deed.act is Act.SWERVE and deed.to is not None), None)
    if aside is not None:
        yield Quantity(measure=QuantityKind.ASIDE, value=aside_of(aside, who.starts.where), said=f"to the {aside}")


def _number(measure: QuantityKind, amount: Amount | None) -> Quantity | None:
    if amount is None or amount.than_ego or not amount.exact:
        return None
    return Quantity(measure=measure, value=amount.low, said=str(amount))
