"""What the kinds of our scenes are in CARLA: one blueprint each, so that a scene is its values and nothing is drawn."""

from __future__ import annotations

from chatscene.terms.actors import BY_CLASS
from chatscene.world.bodies import Placement

PROPS = {
    "BusStop": "static.prop.busstop",
    "VendingMachine": "static.prop.vendingmachine",
    "Kiosk": "static.prop.kiosk_01",
    "Container": "static.prop.container",
    "Hedge": "static.prop.plantpot04",  # there is no hedge; this trough has its length and width, but not its height
    "Billboard": "static.prop.advertisement",
    "WarningSign": "static.prop.streetsign",
}
OTHER_PROP = "static.prop.barrel"


def blueprint_of(placement: Placement) -> str:
    """What a thing is in CARLA: what its program says, if it says so; else the one blueprint of its kind.

    That of a road user stands in the table of road users (`chatscene.terms.actors.RoadUser.blueprint`).
    """
    kind = placement.kind
    return placement.blueprint or (BY_CLASS[kind].row.blueprint if kind in BY_CLASS else PROPS.get(kind, OTHER_PROP))
