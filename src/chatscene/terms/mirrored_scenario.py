"""The mirror image of a scenario in OpenSCENARIO XML: which attributes change their sign, and how that is written.

Source: ASAM OpenSCENARIO XML 1.3, class reference: y, t, dy, dt, offsets, headings and curvatures count to the left;
lanes are numbered as in OpenDRIVE, so that their numbers grow to the left.
"""

from __future__ import annotations

from collections.abc import Mapping

_SIDED: dict[str, tuple[str, ...]] = {
    "WorldPosition": ("y", "h"),
    "RelativeWorldPosition": ("dy",),
    "RelativeObjectPosition": ("dy",),
    "RoadPosition": ("t",),
    "RelativeRoadPosition": ("dt",),
    "LanePosition": ("laneId", "offset"),
    "RelativeLanePosition": ("dLane", "offset"),
    "TrajectoryPosition": ("t",),
    "FromRoadCoordinates": ("t",),
    "FromLaneCoordinates": ("laneId", "laneOffset"),
    "Orientation": ("h",),
    "AbsoluteTargetLane": ("value",),
    "RelativeTargetLane": ("value",),
    "AbsoluteTargetLaneOffset": ("value",),
    "RelativeTargetLaneOffset": ("value",),
    "LaneChangeAction": ("targetLaneOffset",),
    "Clothoid": ("curvature", "curvatureDot", "curvaturePrime"),
    "ClothoidSplineSegment": ("curvatureStart", "curvatureEnd", "hOffset"),
    "AngleCondition": ("angle",),
    "RelativeAngleCondition": ("angle",),
}
_DISPLACED = {
    "leftToReferencedEntity": "rightToReferencedEntity",
    "rightToReferencedEntity": "leftToReferencedEntity",
}
_TURNED = {
    "lessThan": "greaterThan",
    "greaterThan": "lessThan",
    "lessOrEqual": "greaterOrEqual",
    "greaterOrEqual": "lessOrEqual",
    "equalTo": "equalTo",
    "notEqualTo": "notEqualTo",
}


def mirrored_attributes(tag: str, attributes: Mapping[str, str]) -> dict[str, str]:
    """The attributes of an element in the mirror.

    Args:
        tag: What the element is.
        attributes: As they are written; numbers, or expressions of parameters.
    """
    made = dict(attributes)
    for name in _SIDED.get(tag, ()):
        if name in made:
            made[name] = _negated(made[name].strip())
    if tag == "RelativeSpeedCondition" and made.get("direction") == "lateral":
        made |= {"value": _negated(made.get("value", "0").strip()), "rule": _TURNED.get(made.get("rule", ""), "")}
    if tag == "LateralDistanceAction" and made.get("displacement") in _DISPLACED:
        made["displacement"] = _DISPLACED[made["displacement"]]
    return made


def _negated(written: str) -> str:
    """A number with the other sign, to the last digit; of an expression one that has it."""
    if written.startswith("$"):
        inner = written[2:-1] if written.startswith("${") else written
        return f"${{-({inner})}}"
    if not written.strip("+-0.eE"):
        return written  # nothing, which has no sign
    return written[1:] if written.startswith("-") else f"-{written.removeprefix('+')}"
