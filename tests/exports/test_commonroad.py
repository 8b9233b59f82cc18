"""What leaves as CommonRoad is what was driven, with the ego's part as a planning problem."""

from __future__ import annotations

from dataclasses import replace
from xml.etree import ElementTree as Xml

import numpy as np
import pytest

from chatscene.errors import RunError
from chatscene.exports.commonroad import CommonRoad
from chatscene.exports.exporter import KeptScene
from chatscene.terms.episode import Ending
from chatscene.terms.polyline import Polyline
from chatscene.terms.surroundings import Weather
from chatscene.testing.exporters import awkward_scenes

LONG = replace(awkward_scenes()[-1], way=Polyline([(99_950, -1.75), (100_150, -1.75)]))
LAST = len(LONG.episode.ego_track.x) - 1


def written(scene: KeptScene) -> Xml.Element:
    (content,) = CommonRoad().files(scene).values()
    return Xml.fromstring(content)


def number(element: Xml.Element, path: str) -> float:
    text = element.findtext(path)
    assert text is not None, path
    return float(text)


def state(element: Xml.Element) -> tuple[float, ...]:
    names = ("position/point/x", "position/point/y", "orientation/exact", "velocity/exact")
    return tuple(number(element, name) for name in names)


def test_everybody_but_the_ego_is_where_its_track_has_it_at_every_step() -> None:
    root = written(LONG)
    obstacles = {int(one.attrib["id"]): one for one in root if one.tag.endswith("Obstacle")}
    for one, track in zip((obstacles[i] for i in sorted(obstacles)), LONG.episode.tracks[1:], strict=True):
        rows = [
            state(found) for found in (one.find("initialState"), *one.findall("trajectory/state")) if found is not None
        ]
        heading = np.remainder(track.heading + np.pi, 2 * np.pi) - np.pi
        driven = np.column_stack((track.x, track.y, heading, track.speed))
        assert np.allclose(rows, driven[: len(rows)], atol=1e-8, rtol=0)
        assert len(rows) == (LAST + 1 if one.tag == "dynamicObstacle" else 1)
        assert number(one, "shape/rectangle/length") == track.length


def test_things_are_static_and_road_users_dynamic_even_if_they_stand() -> None:
    root = written(LONG)
    names = [one.findtext("type") for one in root.iter("dynamicObstacle")]
    assert {"car", "truck", "bus", "bicycle", "motorcycle", "pedestrian", "priorityVehicle", "train", "unknown"} == set(
        names
    )
    things = sum(track.kind in ("Box", "Cone", "Debris", "BusStop", "Hovercraft") for track in LONG.episode.tracks)
    assert len(list(root.iter("staticObstacle"))) == things


def test_the_planning_problem_begins_where_the_ego_did() -> None:
    start = written(LONG).find("planningProblem/initialState")
    assert start is not None
    ego = LONG.episode.ego_track
    assert state(start) == pytest.approx([ego.x[0], ego.y[0], ego.heading[0], ego.speed[0]], abs=1e-8)


def test_who_arrived_shows_that_the_end_can_be_reached_and_others_are_to_be_on_their_way_still() -> None:
    for ending, begin in ((Ending.ARRIVED, 0), (Ending.COLLISION, LAST)):
        goal = written(replace(LONG, episode=replace(LONG.episode, ending=ending))).find("planningProblem/goalState")
        assert goal is not None
        assert [number(goal, f"time/interval{end}") for end in ("Start", "End")] == [begin, LAST]
        assert [one.attrib["ref"] for one in goal.findall("position/lanelet")] == ["1"]


def test_whatever_is_referred_to_is_there_and_has_a_number_of_its_own() -> None:
    root = written(LONG)
    numbers = [one.attrib["id"] for one in root if "id" in one.attrib]
    assert len(set(numbers)) == len(numbers)
    assert {one.attrib["ref"] for one in root.iter() if "ref" in one.attrib} <= set(numbers)


def test_weather_is_told_where_the_schema_and_the_reader_have_a_word_for_it() -> None:
    clear = replace(LONG.episode.surroundings, weather=Weather.CLEAR)
    assert written(LONG).findtext("location/environment/weather") == "snow"
    assert (
        written(replace(LONG, episode=replace(LONG.episode, surroundings=clear))).find("location/environment") is None
    )


def test_a_scene_far_from_every_lane_is_refused() -> None:
    tracks = tuple(replace(track, x=track.x + 5000.0) for track in LONG.episode.tracks)
    with pytest.raises(RunError, match=r"comes within 50 m of a lane of 'some map\.xodr'.*--to openscenario"):
        CommonRoad().files(replace(LONG, episode=replace(LONG.episode, tracks=tracks), way=None))
