"""What the server knows of a map: the height of its roads, places to begin at, and where its traffic lights stand.

Geometry comes from the wheel's own map class, so that a client that asks its copy of the map gets the same answer.
All positions are CARLA's: metres, left-handed, z up; angles in degrees.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from importlib.metadata import PackageNotFoundError, version
from typing import Any

from carla_stand_in.wire import VERSION
from chatscene.errors import MapError, MissingExtra
from chatscene.simulate.carla.served import as_served

TRAFFIC_LIGHT = "1000001"
_APART = 12.0  # [m] between places to begin at
_LENGTH, _WIDTH = 9.0, 2.0  # [m], of the room that a place needs: lanes may part at one
_ABOVE = 0.5  # [m] that they lie above the road, as CARLA's do
_FARTHEST_STOP = 60  # [m] back through a junction to where one waits for its light


@dataclass(frozen=True, slots=True)
class Signal:
    """Where a traffic light stands, and where one waits for it.

    Attributes:
        id: Of OpenDRIVE.
        location: [m].
        rotation: Pitch, yaw, roll [degrees].
        stops: Where lanes meet its junction: x [m], y [m], yaw [degrees], of driving.
        junction: Of which junction; -1 for none.
    """

    id: str
    location: tuple[float, float, float]
    rotation: tuple[float, float, float]
    stops: tuple[tuple[float, float, float], ...]
    junction: int


@dataclass(frozen=True, slots=True)
class Found:
    """What takes long to find in a map.

    Attributes:
        text: The map as clients get it.
        spawn_points: Places to begin at: transforms.
        signals: The traffic lights.
    """

    text: str
    spawn_points: list[list[list[float]]]
    signals: tuple[Signal, ...]


class Roads:
    """One map.

    Args:
        name: What clients see as the map's name.
        text: OpenDRIVE.
        found: What was found in it before, in another process perhaps.

    Attributes:
        text: The same as clients get it.

    Raises:
        MapError: The text is no OpenDRIVE, has no lane, or a road of left-hand traffic.
        MissingExtra: The wheel is not installed.
    """

    def __init__(self, name: str, text: str, found: Found | None = None) -> None:
        self._carla = _wheel()
        self.name = name
        self._discs: list[tuple[float, float, float]] = []
        self._found = found
        self.text = found.text if found else as_served(text, name)
        try:
            self.map = self._carla.Map(name.rsplit("/", 1)[-1], self.text)
        except RuntimeError as error:
            raise MapError(f"map {name!r} is not OpenDRIVE that CARLA reads: {error}") from error
        if not self.map.get_topology():
            raise MapError(f"map {name!r} has no lane to drive on")

    def ground(self, location: list[float]) -> float:
        """Height of the nearest lane [m]."""
        lanes = self._carla.LaneType.Any
        waypoint = self.map.get_waypoint(self._carla.Location(*location), True, lanes)
        return location[2] if waypoint is None else waypoint.transform.location.z

    def on_earth(self, location: list[float]) -> list[float]:
        """Latitude [degrees], longitude [degrees], altitude [m] of a place."""
        found = self.map.transform_to_geolocation(self._carla.Location(*location))
        return [found.latitude, found.longitude, found.altitude]

    def discs(self, every: float) -> list[tuple[float, float, float]]:
        """Discs that cover the driving lanes: x, y and radius [m]."""
        if not self._discs:
            for waypoint in self.map.generate_waypoints(every):
                at = waypoint.transform.location
                self._discs.append((at.x, at.y, waypoint.lane_width / 2))
        return self._discs

    @cached_property
    def spawn_points(self) -> list[list[list[float]]]:
        """Transforms on driving lanes outside junctions, some metres apart."""
        if self._found:
            return self._found.spawn_points
        found: list[Any] = []
        for first, _ in self.map.get_topology():
            waypoint = None if first.is_junction else next(iter(first.next(_APART / 2)), None)
            for _ in range(5):
                if waypoint is None or waypoint.is_junction:
                    break
                place = waypoint.transform
                if not any(_in_the_way(place, other) for other in found):
                    found.append(place)
                waypoint = next(iter(waypoint.next(_APART)), None)
        return [
            [
                [place.location.x, place.location.y, place.location.z + _ABOVE],
                [wrapped(place.rotation.pitch), wrapped(place.rotation.yaw), wrapped(place.rotation.roll)],
            ]
            for place in found
        ]

    @cached_property
    def signals(self) -> tuple[Signal, ...]:
        """The traffic lights, in the order of their ids; each once, however many roads name it."""
        if self._found:
            return self._found.signals
        by_id: dict[str, list[Any]] = {}
        for landmark in self.map.get_all_landmarks_of_type(TRAFFIC_LIGHT):
            by_id.setdefault(landmark.id, []).append(landmark)
        return tuple(self._signal(name, by_id[name]) for name in sorted(by_id, key=lambda name: (len(name), name)))

    def _signal(self, name: str, landmarks: list[Any]) -> Signal:
        stops: dict[tuple[int, int], tuple[float, float, float]] = {}
        junction = -1
        for landmark in sorted(landmarks, key=lambda landmark: (landmark.road_id, landmark.s)):
            pairs = landmark.get_lane_validities() or [(-1, -1)]
            for lane in sorted({lane for pair in pairs for lane in range(min(pair), max(pair) + 1) if lane}):
                waypoint = self.map.get_waypoint_xodr(landmark.road_id, lane, max(landmark.s, 0.01))
                if waypoint is None or waypoint.lane_type != self._carla.LaneType.Driving:
                    continue
                if waypoint.is_junction:
                    junction = waypoint.get_junction().id
                line = self._before_junction(waypoint)
                at = line.transform.location
                stops.setdefault((round(at.x), round(at.y)), (at.x, at.y, wrapped(line.transform.rotation.yaw)))
        place = landmarks[0].transform
        return Signal(
            id=name,
            location=(place.location.x, place.location.y, place.location.z),
            rotation=(0.0, wrapped(place.rotation.yaw), 0.0),
            stops=tuple(stops[key] for key in sorted(stops)),
            junction=junction,
        )

    def _before_junction(self, waypoint: Any) -> Any:
        """Where one waits: the last place before the junction that a light's lane lies in."""
        for _ in range(_FARTHEST_STOP):
            back = waypoint.previous(1.0) if waypoint.is_junction else []
            if not back:
                break
            waypoint = back[0]
        return waypoint


def _in_the_way(place: Any, other: Any) -> bool:
    """Whether two places to begin at lie on one another."""
    away = place.location - other.location
    along, across = away.dot(other.get_forward_vector()), away.dot(other.get_right_vector())
    return abs(along) < _LENGTH and abs(across) < _WIDTH and abs(away.z) < _LENGTH


def wrapped(degrees: float) -> float:
    """The same angle in [-180, 180) [degrees]."""
    return (degrees + 180.0) % 360.0 - 180.0


def apart(a: float, b: float) -> float:
    """The angle between two directions [degrees], 0 to 180."""
    return abs(wrapped(a - b))


def _wheel() -> Any:
    """The carla package.

    Raises:
        MissingExtra: It is not installed, or another version is.
    """
    try:
        import carla

        found = version("carla")
    except (ImportError, PackageNotFoundError):
        raise MissingExtra(f"a stand-in for CARLA needs the wheel carla {VERSION}", extra="carla") from None
    if found != VERSION:
        raise MissingExtra(f"a stand-in for CARLA needs the wheel carla {VERSION}, not {found}", extra="carla")
    return carla
