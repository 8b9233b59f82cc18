"""What the kinds of our scenes are in CARLA: one blueprint each, so that a scene is its values and nothing is drawn."""

from __future__ import annotations

from chatscene.terms.actors import BY_CLASS

PROPS = {
    "BusStop": "static.prop.busstop",
    "VendingMachine": "static.prop.vendingmachine",
    "Kiosk": "static.prop.kiosk_01",
    "Container": "static.prop.container",
    "Hedge": "static.prop.plantpot04",  # there is no hedge; this trough has its length and width, but not its height
    "Billboard": "static.prop.advertisement",
}
OTHER_PROP = "static.prop.barrel"


def blueprint_of(kind: str) -> str:
    """The blueprint of a road user (`chatscene.terms.actors.RoadUser.blueprint`) or of a thing that stands."""
    return BY_CLASS[kind].row.blueprint if kind in BY_CLASS else PROPS.get(kind, OTHER_PROP)
