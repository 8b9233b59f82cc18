"""What of a situation has a slot: the facts that pages and tables list as what was read.

The page lists these; drives are held against the whole situation (`chatscene.program.judge`).
"""

from __future__ import annotations

from chatscene.build.place import at_junction, met_first
from chatscene.terms.acts import Action
from chatscene.terms.routing import BEGINS, CONTROLS, ENDS, MANEUVERS
from chatscene.terms.scenario import Maneuver, Occluder, Position, Side, Slots
from chatscene.terms.situation import Deed, Other, Situation
from chatscene.terms.vocabulary import Act, Breach, EgoRoute, Manner, UserKind, Where

POSITIONS = {
    Where.AHEAD: Position.AHEAD,
    Where.AHEAD_BESIDE: Position.AHEAD_BESIDE,
    Where.BESIDE: Position.BESIDE,
    Where.BEHIND: Position.BEHIND,
    Where.BEHIND_BESIDE: Position.BEHIND_BESIDE,
    Where.ONCOMING: Position.ONCOMING,
    Where.ARM: Position.CROSSING,
    Where.ROADSIDE: Position.ROADSIDE,
    Where.KERB: Position.KERB,
    Where.EXIT: Position.BEYOND,
    Where.EXIT_CROSSING: Position.FAR_CORNER,
}
ACTIONS = {
    Act.CROSS: Action.CROSS,
    Act.BRAKE: Action.BRAKE,
    Act.STOP: Action.STOP,
    Act.TURN_LEFT: Action.TURN_LEFT,
    Act.TURN_RIGHT: Action.TURN_RIGHT,
    Act.U_TURN: Action.U_TURN,
    Act.CUT_IN: Action.CUT_IN,
    Act.MERGE: Action.CUT_IN,
    Act.CUT_OUT: Action.CHANGE_LANE,
    Act.PULL_OUT: Action.PULL_OUT,
    Act.STAND: Action.STAND,
    Act.SWERVE: Action.SWERVE,
    Act.WEAVE: Action.WEAVE,
    Act.ACCELERATE: Action.ACCELERATE,
    Act.SET_OFF: Action.ACCELERATE,
    Act.REVERSE: Action.REVERSE,
    Act.HESITATE: Action.HESITATE,
    Act.TURN_BACK: Action.TURN_BACK,
    Act.OVERTAKE: Action.OVERTAKE,
    Act.TAILGATE: Action.TAILGATE,
    Act.KEEP_LEVEL: Action.PACE,
}
OCCLUDERS = {
    UserKind.CAR: Occluder.PARKED_CAR,
    UserKind.VEHICLE: Occluder.PARKED_CAR,
    UserKind.VAN: Occluder.PARKED_CAR,
    UserKind.TRUCK: Occluder.PARKED_TRUCK,
    UserKind.BUS: Occluder.PARKED_BUS,
    UserKind.OBJECT: Occluder.VENDING_MACHINE,
}
_PACES = {Manner.SLOW: Action.SLOW, Manner.FAST: Action.FAST}
_ROUTES = frozenset(MANEUVERS) - {None, EgoRoute.ROUNDABOUT, EgoRoute.MERGE, EgoRoute.EXIT, *BEGINS, *ENDS}


def as_slots(situation: Situation) -> Slots:
    """The facts of its first adversary, of the ego's way and of the junction.

    Raises:
        NotBuilt: Nobody meets the ego.
    """
    one = met_first(situation)
    hides = next((other for other in situation.others if other.id == one.hidden_by), None)
    control = CONTROLS.get(situation.road.control) if situation.road.control is not None else None
    sided = one.starts.where is not Where.EXIT_CROSSING
    return Slots(
        adversary=one.kind.row.body,
        actions=_actions(situation, one),
        side=Side(one.starts.side.value) if one.starts.side is not None and sided else None,
        position=POSITIONS.get(one.starts.where),
        occluder=OCCLUDERS.get(hides.kind) if hides is not None else None,
        maneuver=Maneuver(MANEUVERS[situation.ego.route]) if situation.ego.route in _ROUTES else None,
        control=control,
        group=True if one.count != 1 else None,
    )


def _actions(situation: Situation, one: Other) -> tuple[Action, ...]:
    acts: list[Action] = []
    stands = one.does[:1] and one.does[0].act is Act.STAND and len(one.does) > 1  # it does not stand all the time
    for deed in one.does[1 if stands else 0 :]:
        acts += [act for act in _seen(situation, one, deed) if act not in acts]
    return tuple(acts)


def _seen(situation: Situation, one: Other, deed: Deed) -> list[Action]:
    seen = [ACTIONS[deed.act]] if deed.act in ACTIONS else []
    across = one.starts.where is Where.ARM
    if deed.act is Act.GO_STRAIGHT:
        seen = [Action.CROSS] if across else [Action.ONCOMING] if one.starts.where is Where.ONCOMING else []
    if deed.act in (Act.OVERTAKE, Act.CUT_IN, Act.TURN_LEFT) and one.starts.where is Where.ONCOMING:
        seen = [*(seen if at_junction(situation) else []), Action.ONCOMING]
    if deed.breaks is Breach.RED_LIGHT:
        seen = [Action.RUN_LIGHT]  # which is dated from where it sets off, as a crossing is
    pace = _PACES.get(deed.manner) if deed.manner is not None else None
    return [*seen, pace] if pace is not None else seen
