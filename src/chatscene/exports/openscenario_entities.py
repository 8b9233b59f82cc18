"""What each kind of road user and thing is in OpenSCENARIO: the one table, and the elements made of it."""

from __future__ import annotations

from dataclasses import dataclass
from xml.etree import ElementTree as Xml

from chatscene.exports.xml_element import element
from chatscene.terms.actors import BY_CLASS, AdversaryKind, Manner
from chatscene.terms.episode import Track


@dataclass(frozen=True, slots=True, kw_only=True)
class Described:
    """What the standard asks for and no drive depends on: nominal figures.

    Attributes:
        category: One of the standard's, for a vehicle, a pedestrian or a thing.
        height: [m].
        wheel: Diameter of the wheels [m]; 0 where there are none.
        role: One of the standard's; empty where it is nobody's in particular.
    """

    category: str
    height: float
    wheel: float = 0.0
    role: str = ""


DESCRIBED: dict[AdversaryKind, Described] = {
    AdversaryKind.CAR: Described(category="car", height=1.5, wheel=0.65),
    AdversaryKind.TRUCK: Described(category="truck", height=3.2, wheel=1.0),
    AdversaryKind.BUS: Described(category="bus", height=3.1, wheel=1.0),
    AdversaryKind.MOTORCYCLE: Described(category="motorbike", height=1.6, wheel=0.6),
    AdversaryKind.BICYCLE: Described(category="bicycle", height=1.7, wheel=0.65),
    AdversaryKind.PEDESTRIAN: Described(category="pedestrian", height=1.7),
    AdversaryKind.EMERGENCY_VEHICLE: Described(category="van", height=2.5, wheel=0.7, role="ambulance"),
    AdversaryKind.E_SCOOTER: Described(category="bicycle", height=1.8, wheel=0.25),  # the nearest that 1.2 has
    AdversaryKind.WHEELCHAIR: Described(category="wheelchair", height=1.3),
    AdversaryKind.DOG: Described(category="animal", height=0.6),
    AdversaryKind.DEER: Described(category="animal", height=0.9),
    AdversaryKind.BOX: Described(category="obstacle", height=0.65),
    AdversaryKind.CONE: Described(category="obstacle", height=0.75),
    AdversaryKind.DEBRIS: Described(category="obstacle", height=0.5),
}
_THING = Described(category="obstacle", height=2.0)  # at the roadside, where it hides somebody
_THING_MASS = 500.0  # [kg]


def wheelbase_of(track: Track) -> float:
    """The wheelbase of a vehicle [m]; 0 of walkers and things."""
    kind = BY_CLASS.get(track.kind)
    return min(kind.row.limits.wheelbase, track.length) if kind else 0.0


def entity(track: Track) -> Xml.Element:
    """The element of an actor, with its own size, around the origin that the standard gives it."""
    kind = BY_CLASS.get(track.kind)
    told = DESCRIBED[kind] if kind else _THING
    box = element(
        "BoundingBox",
        {},
        element("Center", {"x": wheelbase_of(track) / 2, "y": 0.0, "z": told.height / 2}),
        element("Dimensions", {"width": track.width, "length": track.length, "height": told.height}),
    )
    properties = element(
        "Properties",
        {},
        element("Property", {"name": "chatscene.role", "value": track.role.value}),
        element("Property", {"name": "chatscene.kind", "value": track.kind}),
    )
    role = {"role": told.role} if told.role else {}
    mass = kind.row.mass if kind else _THING_MASS
    if kind is None or kind.lies:
        named = {"name": track.kind, "miscObjectCategory": told.category, "mass": mass}
        return element("MiscObject", named, box, properties)
    if kind.row.manner is Manner.WALKS:
        named = {"name": track.kind, "pedestrianCategory": told.category, "mass": mass}
        return element("Pedestrian", named, box, properties)
    limits = kind.row.limits
    performance = {
        "maxSpeed": limits.top_speed,
        "maxAcceleration": limits.throttle,
        "maxDeceleration": limits.brake,
    }
    wheels = {
        "wheelDiameter": told.wheel,
        "trackWidth": 0.0 if kind.row.manner is Manner.RIDES else 0.8 * track.width,
        "positionZ": told.wheel / 2,
    }
    axles = element(
        "Axles",
        {},
        element("FrontAxle", {"maxSteering": limits.wheel_angle, **wheels, "positionX": wheelbase_of(track)}),
        element("RearAxle", {"maxSteering": 0.0, **wheels, "positionX": 0.0}),
    )
    named = {"name": track.kind, "vehicleCategory": told.category, "mass": mass, **role}
    return element("Vehicle", named, box, element("Performance", performance), axles, properties)
