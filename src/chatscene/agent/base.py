"""Which of the eight base scenarios a set of facts belongs to (paper, section 4.1)."""

from __future__ import annotations

from chatscene.terms.scenario import Action, AdversaryKind, BaseScenario, Maneuver, Place, Slots

ON_FOOT = (AdversaryKind.PEDESTRIAN, AdversaryKind.BICYCLE, AdversaryKind.MOTORCYCLE)  # or on two wheels
TURNS = (Maneuver.LEFT_TURN, Maneuver.RIGHT_TURN)
LANE_CHANGES = (Maneuver.LANE_CHANGE_LEFT, Maneuver.LANE_CHANGE_RIGHT)
JUNCTIONS = (Place.JUNCTION, Place.THREE_WAY, Place.FOUR_WAY)


def base_of(slots: Slots) -> BaseScenario | None:  # noqa: PLR0911 - eight of them
    """The base scenario that a set of slots belongs to."""
    on_foot = slots.adversary in ON_FOOT
    if slots.maneuver is Maneuver.BYPASS:
        return BaseScenario.VEHICLE_PASSING
    if slots.maneuver in LANE_CHANGES:
        return BaseScenario.LANE_CHANGING
    if Action.RUN_LIGHT in slots.actions:
        return BaseScenario.RED_LIGHT_RUNNING
    if slots.maneuver in TURNS and on_foot:
        return BaseScenario.TURNING_OBSTACLE
    if slots.maneuver is Maneuver.LEFT_TURN:
        return BaseScenario.UNPROTECTED_LEFT_TURN
    if slots.maneuver is Maneuver.RIGHT_TURN:
        return BaseScenario.RIGHT_TURN
    if slots.place in JUNCTIONS:
        return BaseScenario.CROSSING_NEGOTIATION
    return BaseScenario.STRAIGHT_OBSTACLE if slots.adversary is not None else None
