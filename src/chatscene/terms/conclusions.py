"""What follows from a set of facts: further facts, and which of the eight base scenarios it is (paper, section 4.1)."""

from __future__ import annotations

from dataclasses import replace

from chatscene.terms.acts import Action
from chatscene.terms.scenario import BaseScenario, Control, Maneuver, Occluder, Place, Position, Slots

TURNS = (Maneuver.LEFT_TURN, Maneuver.RIGHT_TURN)
LANE_CHANGES = (Maneuver.LANE_CHANGE_LEFT, Maneuver.LANE_CHANGE_RIGHT)
CURVES = (Place.CURVE, Place.LEFT_CURVE, Place.RIGHT_CURVE)
JUNCTIONS = (Place.JUNCTION, Place.THREE_WAY, Place.FOUR_WAY)


def base_of(slots: Slots) -> BaseScenario | None:  # noqa: PLR0911 - eight of them
    """The base scenario that a set of slots belongs to."""
    vulnerable = slots.adversary is not None and slots.adversary.is_vulnerable
    if slots.maneuver is Maneuver.BYPASS:
        return BaseScenario.VEHICLE_PASSING
    if slots.maneuver in LANE_CHANGES:
        return BaseScenario.LANE_CHANGING
    if Action.RUN_LIGHT in slots.actions:
        return BaseScenario.RED_LIGHT_RUNNING
    if slots.maneuver in TURNS and vulnerable:
        return BaseScenario.TURNING_OBSTACLE
    if slots.maneuver is Maneuver.LEFT_TURN:
        return BaseScenario.UNPROTECTED_LEFT_TURN
    if slots.maneuver is Maneuver.RIGHT_TURN:
        return BaseScenario.RIGHT_TURN
    if slots.place in JUNCTIONS:
        return BaseScenario.CROSSING_NEGOTIATION
    return BaseScenario.STRAIGHT_OBSTACLE if slots.adversary is not None else None


def concluded(slots: Slots) -> Slots:
    """Facts with what follows from them: who runs a light is at a junction with one, who turns is at a junction."""
    place, control, maneuver, position = slots.place, slots.control, slots.maneuver, slots.position
    if Action.RUN_LIGHT in slots.actions:
        control = Control.SIGNAL
    if maneuver in (*LANE_CHANGES, Maneuver.BYPASS):
        place = place if place not in (None, *JUNCTIONS) else Place.ROAD
        control = None
    elif (maneuver in TURNS or control is not None or position is Position.CROSSING) and place not in JUNCTIONS:
        place = Place.JUNCTION
    if maneuver is None and place is not None:
        maneuver = Maneuver.STRAIGHT
    parked = slots.occluder in (Occluder.PARKED_CAR, Occluder.PARKED_TRUCK, Occluder.PARKED_BUS)
    blocker = slots.blocker or maneuver is Maneuver.BYPASS or None
    occluder = None if blocker and parked else slots.occluder
    if occluder is not None and position is None:
        position = Position.ROADSIDE
    return replace(
        leaving_first(slots),
        place=place,
        control=control,
        maneuver=maneuver,
        position=position,
        blocker=blocker,
        occluder=occluder,
    )


def leaving_first(slots: Slots) -> Slots:
    """Of two ahead of the ego of whom one leaves the lane and the other stands or drives on, the one who leaves first.

    It is the adversary: when it leaves is what a test varies, and whom it hid is beside it.
    """
    if len(slots.others) != 1 or slots.occluder is not None:
        return slots
    other = slots.others[0]
    ahead = slots.position is Position.AHEAD and other.position in (None, Position.AHEAD)
    leaves, stays = Action.CHANGE_LANE in other.actions, all(action.row.all_along for action in slots.actions)
    if not (ahead and leaves and stays):
        return slots
    first = replace(slots, adversary=other.adversary, actions=other.actions, side=other.side, position=Position.AHEAD)
    behind = Slots(adversary=slots.adversary, actions=slots.actions, side=slots.side, position=Position.AHEAD)
    return replace(first, others=(behind,))
