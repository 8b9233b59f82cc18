"""What road users and things are in OpenSCENARIO."""

from __future__ import annotations

from xml.etree import ElementTree as Xml

from chatscene.exports.bodies import height_of, wheelbase_of
from chatscene.exports.xml_element import element
from chatscene.terms.actors import BY_CLASS, Manner
from chatscene.terms.episode import Track

_THING_MASS = 500.0  # [kg]


def entity(track: Track) -> Xml.Element:
    """The element of an actor, with its own size, around the origin that the standard gives it."""
    kind = BY_CLASS.get(track.kind)
    height = height_of(track)
    category = kind.row.openscenario if kind else "obstacle"
    box = element(
        "BoundingBox",
        {},
        element("Center", {"x": wheelbase_of(track) / 2, "y": 0.0, "z": height / 2}),
        element("Dimensions", {"width": track.width, "length": track.length, "height": height}),
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
        "maxSpeed": max(limits.top_speed, float(track.speed.max())),
        "maxAcceleration": limits.throttle,
        "maxDeceleration": limits.brake,
    }
    wheels = {
        "wheelDiameter": kind.row.wheel,
        "trackWidth": 0.0 if kind.row.manner is Manner.RIDES else 0.8 * track.width,
        "positionZ": kind.row.wheel / 2,
    }
    axles = element(
        "Axles",
        {},
        element("FrontAxle", {"maxSteering": limits.wheel_angle, **wheels, "positionX": wheelbase_of(track)}),
        element("RearAxle", {"maxSteering": 0.0, **wheels, "positionX": 0.0}),
    )
    role = {"role": kind.row.role} if kind.row.role else {}
    named = {**role, "name": track.kind, "vehicleCategory": category, "mass": mass}
    return element("Vehicle", named, box, element("Performance", performance), axles, properties)
