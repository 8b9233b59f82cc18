"""ASAM OpenSCENARIO XML 1.2, a logical scenario: what the plans say, with parameters.

What no plan says in the words of the format is followed as it was driven, and told in the description of the file. The
program itself stands in the properties of its head, from which it comes back as it was. Beside it lie a file with the
distribution of each parameter and the OpenDRIVE map. As it stands, the scenario has the values of the scene. Whoever
acts has a variable that counts his phases, by which the trigger of each event asks whether its turn has come. Origins
and headings are as in `chatscene.exports.openscenario`.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from xml.etree import ElementTree as Xml

from chatscene.exports.bodies import wheelbase_of
from chatscene.exports.exporter import KeptScene
from chatscene.exports.openscenario import DATE, after, environment, follows
from chatscene.exports.openscenario_entities import entity
from chatscene.exports.openscenario_events import (
    Events,
    behind,
    private,
    speed_action,
    spelled,
    trajectory,
    variable,
    world,
)
from chatscene.exports.retold import retold
from chatscene.exports.xml_element import element
from chatscene.terms.carried import Row, properties_of
from chatscene.terms.episode import Track
from chatscene.terms.mirrored_scenario import mirrored_attributes
from chatscene.terms.mirroring import mirrored_drive
from chatscene.terms.plan import (
    Number,
)
from chatscene.terms.storyboard import EGO_ROUTE, Actor, Storyboard

PLUGIN = {
    "name": "openscenario-logical",
    "makes": "OpenScenarioLogical",
    "what": "other road users that react to your ego",
    "per scene": "`.xosc`, a logical scenario; `_distribution.xosc`, the ranges",
    "also": "the map, `.xodr`",
}


class OpenScenarioLogical:
    """One ``.xosc`` per scene, its ``_distribution.xosc``, and the map."""

    def files(self, scene: KeptScene) -> Mapping[str, bytes]:
        """The logical scenario of a scene.

        Raises:
            RunError: The format cannot say it; the message names the actor, the phase and what is missing.
        """
        board = retold(scene)
        episode = mirrored_drive(scene.episode) if board.mirrored else scene.episode
        tracks = {track.actor: track for track in episode.tracks}
        text = "; not said: ".join((f"{scene.episode.scene_id}: {scene.text}", *board.unsaid))
        name = f"{scene.stem}.xosc"
        told = scenario(board, tracks, scene.map.name, text, episode.duration, episode.dt)
        if board.mirrored:
            for one in told.iter():
                one.attrib = mirrored_attributes(one.tag, one.attrib)
        carry(told, scene)
        found = {
            name: _whole(told),
            scene.map.name: scene.map.content,
        }
        if board.parameters:
            found[f"{scene.stem}_distribution.xosc"] = _whole(_distribution(board, name, text))
        return found


def _whole(root: Xml.Element) -> bytes:
    Xml.indent(root)
    return Xml.tostring(root, encoding="UTF-8", xml_declaration=True) + b"\n"


def _header(text: str) -> Xml.Element:
    named = {"revMajor": 1, "revMinor": 2, "date": DATE, "description": text, "author": "chatscene"}
    return element("FileHeader", named)


def _distribution(board: Storyboard, name: str, text: str) -> Xml.Element:
    ranges = [
        element(
            "StochasticDistribution",
            {"parameterName": one.name},
            element("UniformDistribution", {}, element("Range", {"lowerLimit": one.low, "upperLimit": one.high})),
        )
        for one in board.parameters
    ]
    return element(
        "OpenSCENARIO",
        {},
        _header(text),
        element(
            "ParameterValueDistribution",
            {},
            element("ScenarioFile", {"filepath": name}),
            element("Stochastic", {"numberOfTestRuns": 10, "randomSeed": 0}, *ranges),
        ),
    )


def carry(told: Xml.Element, scene: KeptScene) -> None:
    """Put the program of a scene into the head of its scenario, for who can read it (`chatscene.terms.carried`)."""
    header = told.find("FileHeader")
    assert header is not None
    lines = properties_of(scene.joined().source, scene.route, scene.map.content, _rows(told))
    header.append(element("Properties", {}, *(_property(name, value) for name, value in lines)))


def _rows(told: Xml.Element) -> Iterator[Row]:
    return ((one.tag, one.attrib, _rows(one)) for one in told)


def scenario(
    board: Storyboard, tracks: Mapping[str, Track], map_name: str, text: str, duration: float, dt: float
) -> Xml.Element:
    """The scenario of a storyboard."""
    ego, *others = board.actors
    acting = [one for one in others if one.plan is not None]
    variables = [
        element("VariableDeclaration", {"name": variable(one), "variableType": "int", "value": 0}) for one in acting
    ]
    told = [Events(board, one, tracks[one.name], wheelbase_of(tracks[ego.name]) / 2) for one in acting]
    entities = [element("ScenarioObject", {"name": one.name}, entity(tracks[one.name])) for one in others]
    host = element("Controller", {"name": "host"}, element("Properties", {}, _property("chatscene.role", "ego")))
    entities.insert(
        0,
        element("ScenarioObject", {"name": ego.name}, entity(tracks[ego.name]), element("ObjectController", {}, host)),
    )
    return element(
        "OpenSCENARIO",
        {},
        _header(text),
        *([element("ParameterDeclarations", {}, *_declared(board))] if board.parameters else []),
        *([element("VariableDeclarations", {}, *variables)] if variables else []),
        element("CatalogLocations"),
        element("RoadNetwork", {}, element("LogicFile", {"filepath": map_name})),
        element("Entities", {}, *entities),
        element(
            "Storyboard",
            {},
            element(
                "Init",
                {},
                element(
                    "Actions",
                    {},
                    environment(board.surroundings),
                    _ego(board, ego, tracks[ego.name]),
                    *(_begins(board, one, tracks[one.name]) for one in others),
                ),
            ),
            element(
                "Story",
                {"name": "as planned"},
                element(
                    "Act",
                    {"name": "the plans"},
                    *(one.group() for one in told),
                    *(follows(tracks[one.name], dt) for one in others if one.led),
                    element("StartTrigger", {}, after(0.0, "it begins", "greaterOrEqual")),
                ),
            )
            if told or any(one.led for one in others)
            else element("Story", {"name": "nobody acts"}),
            element("StopTrigger", {}, after(duration, "it is over", "greaterThan")),
        ),
    )


def _property(name: str, value: str) -> Xml.Element:
    return element("Property", {"name": name, "value": value})


def _declared(board: Storyboard) -> Iterator[Xml.Element]:
    for one in board.parameters:
        limits = (("greaterOrEqual", one.low), ("lessOrEqual", one.high))
        constraints = [element("ValueConstraint", {"rule": rule, "value": value}) for rule, value in limits]
        yield element(
            "ParameterDeclaration",
            {"name": one.name, "parameterType": "double", "value": board.values[one.name]},
            element("ConstraintGroup", {}, *constraints),
        )


def _ego(board: Storyboard, ego: Actor, track: Track) -> Xml.Element:
    line = board.lines[EGO_ROUTE]
    heading, axle = line.heading_at(0.0), wheelbase_of(track) / 2
    x, y = line.point_at(0.0)
    at = {"x": x - axle * math.cos(heading), "y": y - axle * math.sin(heading), "h": heading}
    waypoints = [
        element("Waypoint", {"routeStrategy": "shortest"}, element("Position", {}, world(px, py)))
        for px, py in line.points.tolist()
    ]
    route = element("Route", {"name": EGO_ROUTE, "closed": False}, *waypoints)
    return element(
        "Private",
        {"entityRef": ego.name},
        private("TeleportAction", element("Position", {}, element("WorldPosition", at))),
        private("RoutingAction", element("AssignRouteAction", {}, route)),
        *_at_speed(ego.speed),
    )


def _at_speed(speed: float) -> list[Xml.Element]:
    if not speed:
        return []
    return [private("LongitudinalAction", speed_action(Number(speed), "step", "time", Number(0.0)))]


def _begins(board: Storyboard, actor: Actor, track: Track) -> Xml.Element:
    start = actor.start
    axle = wheelbase_of(track) / 2
    along, left = behind(start, axle)
    position = element(
        "TrajectoryPosition",
        {"s": spelled(along), "t": spelled(left)},
        *([element("Orientation", {"type": "relative", "h": start.turn})] if start.turn else []),
        element("TrajectoryRef", {}, trajectory(start.line, board.lines[start.line])),
    )
    return element(
        "Private",
        {"entityRef": actor.name},
        private("TeleportAction", element("Position", {}, position)),
        *_at_speed(actor.speed),
    )
