"""What each kind of road user and thing is in OpenSCENARIO: the one table, and the elements made of it."""

from __future__ import annotations

from xml.etree import ElementTree as Xml

from chatscene.exports.bodies import body_of, wheelbase_of
from chatscene.exports.xml_element import element
from chatscene.terms.actors import BY_CLASS, AdversaryKind, Manner
from chatscene.terms.episode import Track

CATEGORIES: dict[AdversaryKind, str] = {
    AdversaryKind.CAR: "car",
    AdversaryKind.TRUCK: "truck",
    AdversaryKind.BUS: "bus",
    AdversaryKind.MOTORCYCLE: "motorbike",
    AdversaryKind.BICYCLE: "bicycle",
    AdversaryKind.PEDESTRIAN: "pedestrian",
    AdversaryKind.EMERGENCY_VEHICLE: "van",
    AdversaryKind.E_SCOOTER: "bicycle",  # the nearest that 1.2 has
    AdversaryKind.WHEELCHAIR: "wheelchair",
    AdversaryKind.DOG: "animal",
    AdversaryKind.DEER: "animal",
    AdversaryKind.BOX: "obstacle",
    AdversaryKind.CONE: "obstacle",
    AdversaryKind.DEBRIS: "obstacle",
}
"""The standard's category of a vehicle, a pedestrian or a thing."""
_ROLES = {AdversaryKind.EMERGENCY_VEHICLE: "ambulance"}
_THING_MASS = 500.0  # [kg]


def entity(track: Track) -> Xml.Element:
    """The element of an actor, with its own size, around the origin that the standard gives it."""
    kind = BY_CLASS.get(track.kind)
    body = body_of(track)
    category = CATEGORIES[kind] if kind else "obstacle"
    box = element(
        "BoundingBox",
        {},
        element("Center", {"x": wheelbase_of(track) / 2, "y": 0.0, "z": body.height / 2}),
        element("Dimensions", {"width": track.width, "length": track.length, "height": body.height}),
    )
    properties = element(
        "Properties",
        {},
        element("Property", {"name": "chatscene.role", "value": track.role.value}),
        element("Property", {"name": "chatscene.kind", "value": track.kind}),
        # For esmini, which otherwise holds a heading until the next vertex.
        element("Property", {"name": "plineInterpolation", "value": "segment"}),
    )
    mass = kind.row.mass if kind else _THING_MASS
    if kind is None or kind.lies:
        named = {"name": track.kind, "miscObjectCategory": category, "mass": mass}
        return element("MiscObject", named, box, properties)
    if kind.row.manner is Manner.WALKS:
        named = {"name": track.kind, "pedestrianCategory": category, "mass": mass}
        return element("Pedestrian", named, box, properties)
    limits = kind.row.limits
    performance = {
        "maxSpeed": limits.top_speed,
        "maxAcceleration": limits.throttle,
        "maxDeceleration": limits.brake,
    }
    wheels = {
        "wheelDiameter": body.wheel,
        "trackWidth": 0.0 if kind.row.manner is Manner.RIDES else 0.8 * track.width,
        "positionZ": body.wheel / 2,
    }
    axles = element(
        "Axles",
        {},
        element("FrontAxle", {"maxSteering": limits.wheel_angle, **wheels, "positionX": wheelbase_of(track)}),
        element("RearAxle", {"maxSteering": 0.0, **wheels, "positionX": 0.0}),
    )
    role = {"role": _ROLES[kind]} if kind in _ROLES else {}
    named = {**role, "name": track.kind, "vehicleCategory": category, "mass": mass}
    return element("Vehicle", named, box, element("Performance", performance), axles, properties)
