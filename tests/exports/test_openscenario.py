"""What leaves as OpenSCENARIO is what was driven, and what the standard's own checker takes."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from xml.etree import ElementTree as Xml

import numpy as np
import pytest

from asam_checker import assert_nothing_wrong
from chatscene.exports.exporter import KeptScene
from chatscene.exports.openscenario import OpenScenario
from chatscene.terms.actors import AdversaryKind, Manner
from chatscene.terms.surroundings import Light, Surface, Surroundings, Weather
from chatscene.testing.exporters import awkward_scenes

LONG = awkward_scenes()[-1]


def written(scene: KeptScene) -> Xml.Element:
    return Xml.fromstring(OpenScenario().files(scene)[f"{scene.stem}.xosc"])


def numbers(element: Xml.Element | None, names: str) -> list[float]:
    assert element is not None
    return [float(element.attrib[name]) for name in names.split()]


def under(surroundings: Surroundings) -> Xml.Element:
    root = written(replace(LONG, episode=replace(LONG.episode, surroundings=surroundings)))
    (environment,) = root.iter("Environment")
    return environment


def test_whoever_moves_follows_every_step_of_its_track_at_its_time() -> None:
    root = written(LONG)
    centres = {thing.attrib["name"]: numbers(thing.find(".//Center"), "x")[0] for thing in root.iter("ScenarioObject")}
    groups = {group.find(".//EntityRef").attrib["entityRef"]: group for group in root.iter("ManeuverGroup")}  # type: ignore[union-attr]
    moving = [track for track in LONG.episode.tracks if np.ptp(track.heading) > 0]
    assert list(groups) == [track.actor for track in moving]
    for track in moving:
        vertices = list(groups[track.actor].iter("Vertex"))
        times = [float(vertex.attrib["time"]) for vertex in vertices]
        assert times == pytest.approx([0.1 * step for step in range(40)], abs=1e-9)
        x, y, h = np.array([numbers(vertex.find(".//WorldPosition"), "x y h") for vertex in vertices]).T
        assert np.allclose(h, track.heading, atol=1e-9, rtol=0)
        ahead = centres[track.actor]
        assert np.allclose(x + ahead * np.cos(h), track.x, atol=1e-8, rtol=0)
        assert np.allclose(y + ahead * np.sin(h), track.y, atol=1e-8, rtol=0)


def test_the_origin_of_a_vehicle_is_its_rear_axle_and_that_of_a_walker_its_centre() -> None:
    root = written(LONG)
    (car,) = [thing for thing in root.iter("ScenarioObject") if thing.attrib["name"] == "ego"]
    (walker,) = [thing for thing in root.iter("Pedestrian") if thing.attrib["name"] == "Pedestrian"]
    front, rear = (numbers(car.find(f".//{axle}Axle"), "positionX")[0] for axle in ("Front", "Rear"))
    assert rear == 0.0
    assert numbers(car.find(".//Center"), "x")[0] == front / 2 > 0.0
    assert numbers(walker.find(".//Center"), "x") == [0.0]


def test_whoever_stands_is_placed_and_told_nothing_else() -> None:
    root = written(LONG)
    for track in LONG.episode.tracks:
        (own,) = [one for one in root.iter("Private") if one.attrib["entityRef"] == track.actor]
        assert len(list(own.iter("TeleportAction"))) == 1
        assert len(list(own.iter("SpeedAction"))) == (np.ptp(track.heading) > 0)


def test_the_road_is_the_map_beside_it() -> None:
    files = OpenScenario().files(LONG)
    (road,) = written(LONG).iter("LogicFile")
    assert files[road.attrib["filepath"]] == LONG.map.content


def test_a_scene_ends_after_the_last_step() -> None:
    condition = written(LONG).find("Storyboard/StopTrigger//SimulationTimeCondition")
    assert numbers(condition, "value") == pytest.approx([LONG.episode.duration])


def test_light_weather_and_the_road_are_those_of_the_drive() -> None:
    fog = under(Surroundings(light=Light.NIGHT, weather=Weather.FOG, surface=Surface.ICE))
    assert numbers(fog.find(".//Fog"), "visualRange") == [Weather.FOG.row.sight]
    assert numbers(fog.find("RoadCondition"), "frictionScaleFactor") == [Surface.ICE.row.friction]
    assert "T00:" in fog.find("TimeOfDay").attrib["dateTime"]  # type: ignore[union-attr]
    usual = under(Surroundings())
    assert usual.find(".//Fog") is None
    assert usual.find("RoadCondition").attrib == {"frictionScaleFactor": "1", "wetness": "dry"}  # type: ignore[union-attr]
    rain = under(Surroundings(weather=Weather.RAIN, surface=Surface.WET)).find(".//Precipitation")
    assert rain is not None
    assert rain.attrib["precipitationType"] == "rain"


def test_every_kind_of_road_user_is_described() -> None:
    for kind in AdversaryKind:
        on_wheels = kind.row.manner in (Manner.DRIVES, Manner.RIDES)
        assert (kind.row.wheel > 0) == on_wheels
        assert 0 < kind.row.height < 5
        assert kind.row.openscenario


@pytest.mark.parametrize("scene", awkward_scenes(), ids=lambda scene: scene.stem)
def test_the_asam_checker_finds_nothing_wrong(
    caplog: pytest.LogCaptureFixture, tmp_path: Path, scene: KeptScene
) -> None:
    for name, content in OpenScenario().files(scene).items():
        (tmp_path / name).write_bytes(content)
    done, checks = assert_nothing_wrong(tmp_path / f"{scene.stem}.xosc", caplog, "openscenario")
    assert done == checks > 15
