"""ASAM OpenSCENARIO XML 1.2: everybody follows a timed trajectory, as driven; the road is the OpenDRIVE map beside it.

The origin of a vehicle is where the standard has it, on the ground below the middle of the rear axle, which is half a
wheelbase behind the centre that tracks have; of walkers and things it is the centre. Headings are as in the tracks, not
wrapped, so that a player that goes straight from one vertex to the next turns the right way. Heights are left to the
road. Traffic lights are not in the file.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from xml.etree import ElementTree as Xml

import numpy as np

from chatscene.exports.bodies import wheelbase_of
from chatscene.exports.exporter import KeptScene
from chatscene.exports.openscenario_entities import entity
from chatscene.exports.xml_element import element
from chatscene.terms.arrays import Array
from chatscene.terms.episode import Track
from chatscene.terms.surroundings import Light, Surface, Surroundings, Weather

PLUGIN = {
    "name": "openscenario",
    "makes": "OpenScenario",
    "what": "to play a drive back",
    "per scene": "`.xosc`, OpenSCENARIO XML 1.2",
    "also": "the map, `.xodr`",
}

# A date that is asked for and that nobody kept; one of our own clock would make every export another file.
DATE = "1970-01-01T00:00:00"
_OCLOCK = {Light.DAY: "2000-03-20T12:00:00", Light.DUSK: "2000-03-20T18:30:00", Light.NIGHT: "2000-03-20T00:00:00"}
# Type and mm/h; drives know no intensity, so it is a common one: moderate rain, and snowfall as water.
_FALLS = {Weather.RAIN: ("rain", 5.0), Weather.SNOW: ("snow", 2.0)}
_WETNESS = {Surface.DRY: "dry", Surface.WET: "moist"}


class OpenScenario:
    """One ``.xosc`` per scene, and the map."""

    def files(self, scene: KeptScene) -> Mapping[str, bytes]:
        """The scenario of a scene, and the map that it names."""
        tracks = scene.episode.tracks
        root = element(
            "OpenSCENARIO",
            {},
            element(
                "FileHeader",
                {
                    "revMajor": 1,
                    "revMinor": 2,
                    "date": DATE,
                    "description": f"{scene.episode.scene_id}: {scene.text}",
                    "author": "chatscene",
                },
            ),
            element("CatalogLocations"),
            element("RoadNetwork", {}, element("LogicFile", {"filepath": scene.map.name})),
            element(
                "Entities", {}, *(element("ScenarioObject", {"name": track.actor}, entity(track)) for track in tracks)
            ),
            element(
                "Storyboard",
                {},
                element(
                    "Init",
                    {},
                    element("Actions", {}, environment(scene.episode.surroundings), *map(_start, tracks)),
                ),
                _story([follows(track, scene.episode.dt) for track in tracks if _moves(track)]),
                element("StopTrigger", {}, after(scene.episode.duration, "the drive is over", "greaterThan")),
            ),
        )
        Xml.indent(root)
        content = Xml.tostring(root, encoding="UTF-8", xml_declaration=True) + b"\n"
        return {f"{scene.stem}.xosc": content, scene.map.name: scene.map.content}


def _moves(track: Track) -> bool:
    return any(np.ptp(values) > 0 for values in (track.x, track.y, track.heading))


def environment(surroundings: Surroundings) -> Xml.Element:
    """Light, weather and road, all through a scenario."""
    weather, surface = surroundings.weather, surroundings.surface
    falls, intensity = _FALLS.get(weather, ("dry", 0.0))
    sight, friction = weather.row.sight, surface.row.friction
    return element(
        "GlobalAction",
        {},
        element(
            "EnvironmentAction",
            {},
            element(
                "Environment",
                {"name": str(surroundings) or "usual"},
                element("TimeOfDay", {"animation": False, "dateTime": _OCLOCK[surroundings.light]}),
                element(
                    "Weather",
                    {"fractionalCloudCover": "eightOktas"} if weather is Weather.OVERCAST else {},
                    *([element("Fog", {"visualRange": sight})] if math.isfinite(sight) else []),
                    element("Precipitation", {"precipitationType": falls, "precipitationIntensity": intensity}),
                ),
                element(
                    "RoadCondition",
                    # As a share of a dry road, on which a coefficient of friction is near one.
                    {
                        "frictionScaleFactor": friction if math.isfinite(friction) else 1.0,
                        **({"wetness": _WETNESS[surface]} if surface in _WETNESS else {}),
                    },
                ),
            ),
        ),
    )


def _start(track: Track) -> Xml.Element:
    """Where an actor is at first, and how fast."""
    speed = element(
        "SpeedAction",
        {},
        element("SpeedActionDynamics", {"dynamicsShape": "step", "dynamicsDimension": "time", "value": 0.0}),
        element("SpeedActionTarget", {}, element("AbsoluteTargetSpeed", {"value": float(track.speed[0])})),
    )
    return element(
        "Private",
        {"entityRef": track.actor},
        element("PrivateAction", {}, element("TeleportAction", {}, _positions(track)[0])),
        *([element("PrivateAction", {}, element("LongitudinalAction", {}, speed))] if _moves(track) else []),
    )


def _positions(track: Track) -> list[Xml.Element]:
    back = wheelbase_of(track) / 2
    x: Array = track.x - back * np.cos(track.heading)
    y: Array = track.y - back * np.sin(track.heading)
    return [
        element("Position", {}, element("WorldPosition", dict(zip("xyh", pose, strict=True))))
        for pose in zip(x.tolist(), y.tolist(), track.heading.tolist(), strict=True)
    ]


def _story(groups: list[Xml.Element]) -> Xml.Element:
    return element(
        "Story",
        {"name": "scene"},
        element(
            "Act",
            {"name": "drive"},
            *(groups or [element("ManeuverGroup", {"name": "nobody moves", "maximumExecutionCount": 1}, actors_of())]),
            element("StartTrigger", {}, after(0.0, "the drive begins", "greaterOrEqual")),
        ),
    )


def actors_of(*names: str) -> Xml.Element:
    """Of whom a group tells."""
    return element(
        "Actors", {"selectTriggeringEntities": False}, *(element("EntityRef", {"entityRef": name}) for name in names)
    )


def follows(track: Track, dt: float) -> Xml.Element:
    """An actor's trajectory as driven; each has a group of its own, so that one is taken out with its group."""
    vertices = [element("Vertex", {"time": step * dt}, at) for step, at in enumerate(_positions(track))]
    action = element(
        "FollowTrajectoryAction",
        {},
        element(
            "TimeReference", {}, element("Timing", {"domainAbsoluteRelative": "absolute", "offset": 0, "scale": 1})
        ),
        element("TrajectoryFollowingMode", {"followingMode": "position"}),
        element(
            "TrajectoryRef",
            {},
            element(
                "Trajectory",
                {"name": f"{track.actor} as driven", "closed": False},
                element("Shape", {}, element("Polyline", {}, *vertices)),
            ),
        ),
    )
    event = element(
        "Event",
        {"name": f"{track.actor} sets off", "priority": "override"},
        element(
            "Action",
            {"name": f"{track.actor} follows"},
            element("PrivateAction", {}, element("RoutingAction", {}, action)),
        ),
        element("StartTrigger", {}, after(0.0, f"{track.actor} begins", "greaterOrEqual")),
    )
    return element(
        "ManeuverGroup",
        {"name": f"{track.actor} drives", "maximumExecutionCount": 1},
        actors_of(track.actor),
        element("Maneuver", {"name": f"{track.actor} as driven"}, event),
    )


def after(time: float, name: str, rule: str) -> Xml.Element:
    """A trigger at a time [s] of the simulation."""
    at_time = element("SimulationTimeCondition", {"value": time, "rule": rule})
    return element(
        "ConditionGroup",
        {},
        element(
            "Condition",
            {"name": name, "delay": 0, "conditionEdge": "none"},
            element("ByValueCondition", {}, at_time),
        ),
    )
