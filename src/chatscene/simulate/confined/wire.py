"""What goes to and comes from a confined process: one JSON object a line, bounded, and believed in nothing.

What comes back was written by a process that may have run hostile code, so every field is checked for type, size and
range here, and nothing is unpickled.
"""

from __future__ import annotations

import json
import math
import re
from collections.abc import Sequence
from dataclasses import asdict
from enum import StrEnum
from typing import Any, NoReturn, TypeVar

import numpy as np

from chatscene.errors import ChatSceneError, ProgramStopped, SandboxError
from chatscene.files.bounded import parse_json
from chatscene.terms.arrays import Array
from chatscene.terms.episode import Ending, Episode, Event, EventKind, Reached, Role, SignalTrack, Track
from chatscene.terms.polyline import Polyline
from chatscene.terms.route import Route
from chatscene.terms.scenario import Control, Maneuver, Place, Site
from chatscene.terms.scene import Scene, ScenicProgram
from chatscene.terms.surroundings import Light, Surface, Surroundings, Weather

Message = dict[str, Any]
Kind = TypeVar("Kind", bound=StrEnum)

MAX_ACTORS = 64
MAX_EVENTS = 1_000
MAX_SIGNALS = 64
MAX_PHASES = 10_000  # of a plan
MAX_POINTS = 20_000  # of a route's line
MAX_LANES = 1_000
MAX_NUMBER = 1e9
MAX_WORDS = 500  # characters of a message shown to a person

_NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9 ,.:_-]{0,79}\Z")
_ID = re.compile(r"[ -~]{1,200}\Z")
_STATES = re.compile(r"[ryg]*\Z")


def encode(message: Message) -> bytes:
    """One line."""
    return json.dumps(message, separators=(",", ":"), allow_nan=False).encode("ascii") + b"\n"


def decode(line: bytes) -> Message:
    """One line back; NaN, infinities and anything that is not an object are refused.

    Raises:
        SandboxError: It is none.
    """
    try:
        message = parse_json(line, parse_constant=_refuse)
    except ValueError as error:
        raise nonsense("no JSON") from error
    if not isinstance(message, dict):
        raise nonsense("no object")
    return message


def _refuse(constant: str) -> NoReturn:
    raise ValueError(constant)


def nonsense(what: str) -> ProgramStopped:
    """The error for an answer that no honest process gives."""
    return ProgramStopped(f"the confined process answered nonsense ({what}); the program is not to be trusted")


def words(value: object) -> str:
    """A message of a stranger's, fit for a terminal: one line of plain characters, not too long."""
    text = value if isinstance(value, str) else ""
    return "".join(c if " " <= c <= "~" else "?" for c in " ".join(text.split()))[:MAX_WORDS]


# What is sent: ours, read by our own code on the other side


def program_to_json(program: ScenicProgram) -> Message:
    """A program, without its ranges, which the other side does not need."""
    return {**asdict(program), "parameters": ()}


def program_from_json(message: Message) -> ScenicProgram:
    """The program again."""
    return ScenicProgram(
        scenario_id=message["scenario_id"],
        source=message["source"],
        parameters=(),
        snippet_ids=tuple(message["snippet_ids"]),
        model=message["model"],
        as_written=message["as_written"],
        own=message["own"],
    )


def scene_to_json(scene: Scene) -> Message:
    """A scene."""
    return {**asdict(scene), "values": dict(scene.values)}


def scene_from_json(message: Message) -> Scene:
    """The scene again."""
    return Scene(**message)


# What comes back


def route_to_json(route: Route) -> Message:
    """A route."""
    names = ("id", "map_name", "maneuver", "place", "control", "lane_ids", "event_at", "exit_at", "junction")
    told = {name: getattr(route, name) for name in (*names, "mirrored")}
    return {**told, "line": route.line.points.tolist(), "site": route.site}


def route_from_json(message: Message) -> Route:
    """A route, checked."""
    junction = message.get("junction")
    try:
        return Route(
            id=_text(message, "id", _ID),
            map_name=_text(message, "map_name", _ID),
            maneuver=_choice(Maneuver, message, "maneuver"),
            place=_choice(Place, message, "place"),
            control=_choice(Control, message, "control"),
            line=Polyline(_points(message.get("line"))),
            lane_ids=tuple(_matching(lane, _ID) for lane in _list(message, "lane_ids", MAX_LANES)),
            event_at=number(message, "event_at"),
            exit_at=None if message.get("exit_at") is None else number(message, "exit_at"),
            junction=None if junction is None else _matching(junction, _ID),
            site=None if message.get("site") is None else _choice(Site, message, "site"),
            mirrored=message.get("mirrored") is True,
        )
    except SandboxError:
        raise
    except ChatSceneError as error:
        raise nonsense(str(error)) from error


def episode_to_json(episode: Episode) -> Message:
    """An episode, without what the other side knows itself."""
    return {
        "tracks": [
            {
                **{name: getattr(track, name) for name in ("actor", "role", "kind", "length", "width")},
                **{name: getattr(track, name).tolist() for name in ("x", "y", "heading", "speed")},
            }
            for track in episode.tracks
        ],
        "events": [asdict(event) for event in episode.events],
        "signals": [asdict(signal) for signal in episode.signals],
        "ending": episode.ending,
        "route_completion": episode.route_completion,
        "distance_to_route": episode.distance_to_route.tolist(),
        "off_road": episode.off_road.astype(int).tolist(),
        "surroundings": asdict(episode.surroundings),
        "reached": {actor: asdict(one) for actor, one in episode.reached.items()},
    }


def episode_from_json(message: Message, *, scene_id: str, ego: str, dt: float, steps: int) -> Episode:
    """An episode, checked.

    Args:
        message: What came.
        scene_id: Which scene was asked for.
        ego: Who drove.
        dt: Step [s].
        steps: How many rows it must have: the steps that were driven, and the start.

    Raises:
        SandboxError: It is not what an honest simulator would tell.
    """
    tracks = tuple(_track(track, steps) for track in _list(message, "tracks", MAX_ACTORS))
    if not tracks or tracks[0].role is not Role.EGO or sum(track.role is Role.EGO for track in tracks) != 1:
        raise nonsense("not one ego, first")
    if len({track.actor for track in tracks}) != len(tracks):
        raise nonsense("two actors of one name")
    completion = number(message, "route_completion")
    if not 0.0 <= completion <= 1.0:
        raise nonsense("route_completion")
    events = tuple(_event(event, steps) for event in _list(message, "events", MAX_EVENTS))
    if any(e.kind is EventKind.COLLISION and e.other not in {track.actor for track in tracks} for e in events):
        raise nonsense("a collision with nobody")
    return Episode(
        scene_id=scene_id,
        ego=ego,
        dt=dt,
        tracks=tracks,
        events=events,
        signals=tuple(_signal(signal, steps) for signal in _list(message, "signals", MAX_SIGNALS)),
        ending=_choice(Ending, message, "ending"),
        route_completion=completion,
        distance_to_route=numbers(message.get("distance_to_route"), steps),
        off_road=numbers(message.get("off_road"), steps) != 0,
        surroundings=_surroundings(_object(message.get("surroundings"))),
        reached=_reached(_object(message.get("reached")), {track.actor for track in tracks}),
    )


def _surroundings(message: Message) -> Surroundings:
    return Surroundings(
        light=_choice(Light, message, "light"),
        weather=_choice(Weather, message, "weather"),
        surface=_choice(Surface, message, "surface"),
    )


def _reached(message: Message, actors: set[str]) -> dict[str, Reached]:
    if not message.keys() <= actors:
        raise nonsense("a plan of nobody")
    return {actor: _in_plan(_object(one)) for actor, one in message.items()}


def _in_plan(message: Message) -> Reached:
    phase = message.get("phase")
    if type(phase) is not int or not 0 <= phase <= MAX_PHASES:
        raise nonsense("how far somebody is in a plan")
    return Reached(behavior=_text(message, "behavior", _NAME), phase=phase)


def _track(message: Any, steps: int) -> Track:
    message = _object(message)
    length, width = number(message, "length"), number(message, "width")
    if not (0.0 < length < 100.0 and 0.0 < width < 100.0):
        raise nonsense("the size of an actor")
    return Track(
        actor=_text(message, "actor", _NAME),
        role=_choice(Role, message, "role"),
        kind=_text(message, "kind", _NAME),
        length=length,
        width=width,
        x=numbers(message.get("x"), steps),
        y=numbers(message.get("y"), steps),
        heading=numbers(message.get("heading"), steps),
        speed=numbers(message.get("speed"), steps),
    )


def _event(message: Any, steps: int) -> Event:
    message = _object(message)
    step = message.get("step")
    if not isinstance(step, int) or isinstance(step, bool) or not 0 <= step < steps:
        raise nonsense("the step of an event")
    side = message.get("side")
    if side not in ("", "front", "rear", "left", "right"):
        raise nonsense("the side of an event")
    other, earlier = message.get("other"), number(message, "earlier")
    if not 0.0 <= earlier < 1.0:
        raise nonsense("the time of an event")
    return Event(
        kind=_choice(EventKind, message, "kind"),
        step=step,
        other="" if other == "" else _matching(other, _ID),
        side=side,
        impact_speed=number(message, "impact_speed"),
        earlier=earlier,
    )


def _signal(message: Any, steps: int) -> SignalTrack:
    message = _object(message)
    state = _text(message, "state", _STATES)
    if len(state) != steps or message.get("role") not in ("ego", "other"):
        raise nonsense("a signal")
    ends = {name: number(message, name) for name in ("x0", "y0", "x1", "y1")}
    return SignalTrack(state=state, role=message["role"], **ends)


# The smallest parts


def number(message: Message, name: str) -> float:
    """A finite number of reasonable size."""
    return _finite(message.get(name))


def numbers(values: object, count: int) -> Array:
    """(count,) finite numbers."""
    if not isinstance(values, list) or len(values) != count:
        raise nonsense("a row of numbers")
    return np.array([_finite(value) for value in values], dtype=float)


def _finite(value: object) -> float:
    # The type is compared, since to Python a truth value is an integer.
    if type(value) not in (int, float) or not abs(value) <= MAX_NUMBER or math.isnan(value):  # type: ignore[arg-type]
        raise nonsense("a number")
    return float(value)  # type: ignore[arg-type]


def _points(values: object) -> Sequence[Array]:
    if not isinstance(values, list) or len(values) > MAX_POINTS:
        raise nonsense("a line")
    return [numbers(point, 2) for point in values]


def _object(value: object) -> Message:
    if not isinstance(value, dict):
        raise nonsense("no object")
    return value


def _list(message: Message, name: str, most: int) -> list[Any]:
    values = message.get(name)
    if not isinstance(values, list) or len(values) > most:
        raise nonsense(name)
    return values


def _text(message: Message, name: str, pattern: re.Pattern[str]) -> str:
    return _matching(message.get(name), pattern)


def _matching(value: object, pattern: re.Pattern[str]) -> str:
    if not isinstance(value, str) or not pattern.match(value):
        raise nonsense("a text")
    return value


def _choice(kind: type[Kind], message: Message, name: str) -> Kind:
    value = message.get(name)
    if not isinstance(value, str) or value not in kind.__members__.values():
        raise nonsense(name)
    return kind(value)
