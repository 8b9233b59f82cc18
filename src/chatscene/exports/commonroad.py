"""CommonRoad 2020a: a planning problem for the ego among lanelets, others' trajectories as driven, and things.

The lanelets are the map's around the scene. Positions are the centres of bodies, headings lie between -π and π. Lights,
signs and intersections as such are not in the file.
"""

from __future__ import annotations

import hashlib
import re
from collections.abc import Iterator, Mapping, Sequence
from functools import lru_cache
from pathlib import Path
from tempfile import TemporaryDirectory
from xml.etree import ElementTree as Xml

import numpy as np
import shapely

from chatscene.errors import RunError
from chatscene.exports.exporter import KeptScene, MapFile
from chatscene.exports.xml_element import element, told
from chatscene.maps.lanelets import Beside, Lanelet, lanelets_along, lanelets_of
from chatscene.maps.network import load_network
from chatscene.terms.actors import BY_CLASS
from chatscene.terms.arrays import Array
from chatscene.terms.episode import Ending, Episode, Track
from chatscene.terms.surroundings import Light, Surface, Surroundings, Weather

PLUGIN = {
    "name": "commonroad",
    "makes": "CommonRoad",
    "what": "a planning problem",
    "per scene": "`.xml`, CommonRoad 2020a",
}

AROUND = 50.0  # [m] from anybody, at any time, within which lanelets are part of the scene
_OCLOCK = {Light.DAY: ("12:00:00", "day"), Light.DUSK: ("18:30:00", "unknown"), Light.NIGHT: ("00:00:00", "night")}
# In clear weather the schema asks for `sunny`, which the format's own reader refuses, and refuses what that reads.
_WEATHER = {Weather.RAIN: "light_rain", Weather.SNOW: "snow", Weather.FOG: "fog"}
_UNDERGROUND = {Surface.DRY: "clean", Surface.WET: "wet", Surface.SNOW: "snow", Surface.ICE: "ice"}


class CommonRoad:
    """One ``.xml`` per scene."""

    def files(self, scene: KeptScene) -> Mapping[str, bytes]:
        """The planning problem of a scene.

        Raises:
            RunError: Nobody in it is near a lane.
        """
        episode, lanelets = scene.episode, _lanelets(scene.map)
        along = lanelets_along(lanelets, scene.way) if scene.way else ()
        near = _around(lanelets, episode.tracks)
        shown = [one for one in lanelets if one.number in near or one.number in along]
        if not shown:
            raise RunError(
                f"nobody in scene {episode.scene_id!r} comes within {AROUND:g} m of a lane of {scene.map.name!r}, and "
                "CommonRoad knows no scene without lanes; export what was driven: --to openscenario or --to csv"
            )
        root = element(
            "commonRoad",
            {
                "commonRoadVersion": "2020a",
                "benchmarkID": _benchmark_id(scene),
                "date": "1970-01-01",  # asked for, and kept by nobody
                "author": "chatscene",
                "affiliation": "",
                "source": f"{episode.scene_id}: {scene.text}",
                "timeStepSize": episode.dt,
            },
            _location(episode.surroundings),
            element("scenarioTags", {}, element("simulated")),
            *_lanelet_elements(shown),
            *_obstacles(episode, len(lanelets)),
            _planning_problem(scene, along, len(lanelets) + len(episode.tracks)),
        )
        Xml.indent(root)
        content = Xml.tostring(root, encoding="UTF-8", xml_declaration=True) + b"\n"
        return {f"{scene.stem}.xml": content}


@lru_cache(maxsize=1)
def _lanelets(where: MapFile) -> tuple[Lanelet, ...]:
    with TemporaryDirectory() as folder:  # Scenic reads a map from a file
        path = Path(folder) / where.name
        path.write_bytes(where.content)
        return lanelets_of(load_network(path))


def _around(lanelets: Sequence[Lanelet], tracks: Sequence[Track]) -> set[int]:
    """The numbers of the lanelets near anybody at any time."""
    centres = shapely.MultiPoint(np.concatenate([np.column_stack((track.x, track.y)) for track in tracks]))
    near = shapely.dwithin([one.area for one in lanelets], centres, AROUND)
    return {one.number for one, is_near in zip(lanelets, near, strict=True) if is_near}


def _benchmark_id(scene: KeptScene) -> str:
    """Country (the one that is nowhere), map, configuration and prediction, in the letters that an id may have."""
    where = re.sub("[^A-Za-z0-9]", "", Path(scene.map.name).stem.title()) or "Map"
    digest = hashlib.blake2b(scene.episode.scene_id.encode(), digest_size=4).digest()
    return f"ZAM_{where}-1_{1 + int.from_bytes(digest)}_T-1"


def _location(surroundings: Surroundings) -> Xml.Element:
    """Nowhere on Earth; what surrounds the scene, where both the schema and the format's own reader can say it."""
    around: list[Xml.Element] = []
    if weather := _WEATHER.get(surroundings.weather):
        oclock, time_of_day = _OCLOCK[surroundings.light]
        around.append(
            element(
                "environment",
                {},
                told("time", oclock),
                told("timeOfDay", time_of_day),
                told("weather", weather),
                told("underground", _UNDERGROUND[surroundings.surface]),
            )
        )
    unknown = (told("geoNameId", -999), told("gpsLatitude", 999), told("gpsLongitude", 999))
    return element("location", {}, *unknown, *around)


def _lanelet_elements(lanelets: Sequence[Lanelet]) -> Iterator[Xml.Element]:
    """Each with those of its neighbours that are there."""
    there = {one.number for one in lanelets}

    def beside(tag: str, other: Beside | None) -> list[Xml.Element]:
        if other is None or other.number not in there:
            return []
        return [element(tag, {"ref": other.number, "drivingDir": "same" if other.same_way else "opposite"})]

    for one in lanelets:
        yield element(
            "lanelet",
            {"id": one.number},
            element("leftBound", {}, *map(_point, one.left)),
            element("rightBound", {}, *map(_point, one.right)),
            *(element("predecessor", {"ref": number}) for number in one.before if number in there),
            *(element("successor", {"ref": number}) for number in one.after if number in there),
            *beside("adjacentLeft", one.on_left),
            *beside("adjacentRight", one.on_right),
            told("laneletType", "intersection" if one.in_junction else "unknown"),
        )


def _obstacles(episode: Episode, first: int) -> Iterator[Xml.Element]:
    """Everybody but the ego, numbered in the order of the tracks; things before road users, as the schema asks for."""
    others = list(enumerate(episode.tracks[1:], first + 1))
    last = len(episode.ego_track.x) - 1
    still = {number for number, track in others if last == 0 or _is_thing(track)}
    for number, track in others:
        if number in still:
            yield element("staticObstacle", {"id": number}, told("type", "unknown"), *_body(track, episode.dt))
    for number, track in others:
        if number not in still:
            states = _states(track, episode.dt)
            yield element(
                "dynamicObstacle",
                {"id": number},
                told("type", BY_CLASS[track.kind].row.commonroad),
                *_body(track, episode.dt),
                element("trajectory", {}, *(element("state", {}, *state) for state in states[1:])),
            )


def _is_thing(track: Track) -> bool:
    kind = BY_CLASS.get(track.kind)
    return kind is None or kind.lies


def _body(track: Track, dt: float) -> tuple[Xml.Element, Xml.Element]:
    size = element("rectangle", {}, told("length", track.length), told("width", track.width))
    return element("shape", {}, size), element("initialState", {}, *_states(track, dt)[0])


def _states(track: Track, dt: float) -> list[tuple[Xml.Element, ...]]:
    """What stands in the state of each step."""
    heading = np.remainder(track.heading + np.pi, 2 * np.pi) - np.pi
    rates = track.speed, track.acceleration(dt), track.yaw_rate(dt)
    rows = np.column_stack((track.x, track.y, heading, *rates))
    return [
        (
            element("position", {}, _point(row[:2])),
            element("orientation", {}, told("exact", float(row[2]))),
            element("time", {}, told("exact", step)),
            element("velocity", {}, told("exact", float(row[3]))),
            element("acceleration", {}, told("exact", float(row[4]))),
            element("yawRate", {}, told("exact", float(row[5]))),
        )
        for step, row in enumerate(rows)
    ]


def _planning_problem(scene: KeptScene, along: Sequence[int], number: int) -> Xml.Element:
    """From where the ego began.

    An ego that arrived has shown that the end of the way can be reached in its time; so that is the goal. Where the
    drive ended otherwise, often in a collision, the goal is to be on the way still when it ended, however far.
    """
    episode = scene.episode
    last = max(len(episode.ego_track.x) - 1, 1)
    arrived = episode.ending is Ending.ARRIVED
    lanelets = along[-1:] if arrived else along
    goal = element(
        "goalState",
        {},
        element("time", {}, told("intervalStart", 0 if arrived else last), told("intervalEnd", last)),
        *([element("position", {}, *(element("lanelet", {"ref": one}) for one in lanelets))] if lanelets else []),
    )
    position, orientation, time, velocity, acceleration, yaw_rate = _states(episode.ego_track, episode.dt)[0]
    slip = element("slipAngle", {}, told("exact", 0.0))
    start = element("initialState", {}, position, velocity, orientation, yaw_rate, slip, time, acceleration)
    return element("planningProblem", {"id": number}, start, goal)


def _point(at: Array) -> Xml.Element:
    return element("point", {}, told("x", float(at[0])), told("y", float(at[1])))
