"""Light, weather and road act in the drives, are kept with a run, and are told."""

from __future__ import annotations

import json
import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pyarrow.parquet as pq
import pytest

from chatscene import pipeline, runs
from chatscene.ego.observation import OWN, PER_ACTOR, RANGE, SIGHT
from chatscene.errors import ProgramError
from chatscene.maps.network import resolve_map
from chatscene.measure.avoidability import risk_step
from chatscene.program.deeds import ACTIONS
from chatscene.program.watching import watch
from chatscene.runs.rebuild import rebuild
from chatscene.runs.replay import replay
from chatscene.runs.tables import SCENES, read_table
from chatscene.settings import SearchSettings, Settings, SimulationSettings
from chatscene.simulate.confined.wire import episode_from_json, episode_to_json
from chatscene.simulate.embedded.dynamics import make_body
from chatscene.simulate.simulator import Simulator, load_simulator, simulate
from chatscene.terms.actors import LIMITS, has_lamps
from chatscene.terms.acts import Action
from chatscene.terms.episode import Episode
from chatscene.terms.polyline import Polyline
from chatscene.terms.scene import Rejected, Scene, ScenicProgram
from chatscene.terms.surroundings import GRAVITY, Light, Surface, Surroundings, Weather, surroundings_of
from chatscene.world.bodies import Placement, Vehicle
from chatscene.world.control import curve_speeds

SCENE = Scene(id="toy/0", scenario_id="toy", route=0, block=0, seed=0, values={})
ROAD = """model chatscene.world.model
{before}
egoRoute = selectRoute(maneuver="straight")
behavior AdvBehavior():
    do {act}
ego = new Car at pointOn(egoRoute, 0), facing directionOn(egoRoute, 0), with route egoRoute
new {kind} at pointOn(egoRoute, {at}, {left}), facing directionOn(egoRoute, {at}),
    with speed {speed}, with behavior AdvBehavior()
"""


class Driver:
    """Asks for the same all the time."""

    observation = "actors"

    def __init__(self, acceleration: float) -> None:
        self._acceleration = acceleration

    def act(self, observation: object) -> tuple[float, float]:
        return self._acceleration, 0.0


@pytest.fixture(scope="module")
def simulator() -> Simulator:
    return load_simulator(resolve_map("town"), SimulationSettings())


def road(
    before: str = "", *, act: str = "Halt()", kind: str = "Car", at: float = 30, left: float = 0, speed: float = 0
) -> ScenicProgram:
    source = ROAD.format(before=before, act=act, kind=kind, at=at, left=left, speed=speed)
    return ScenicProgram(scenario_id="toy", source=source, parameters=(), snippet_ids=())


def driven(simulator: Simulator, program: ScenicProgram, acceleration: float = 0.0) -> Episode:
    episode = simulate(simulator, program, SCENE, Driver(acceleration))
    assert isinstance(episode, Episode), episode
    return episode


def seconds_to_stop(kind: str, surface: Surface) -> float:
    limits = LIMITS[kind]
    body = make_body(
        Placement(
            kind=kind,
            x=0.0,
            y=0.0,
            heading=0.0,
            speed=min(10.0, limits.top_speed),
            length=limits.length,
            width=limits.width,
            wheelbase=limits.wheelbase,
            grip=Surroundings(surface=surface).grip,
        )
    )
    assert isinstance(body, Vehicle)
    body.brake = 1.0
    steps = 0
    while body.speed > 0.0:
        body.step(0.01)  # type: ignore[attr-defined]
        steps += 1
    return steps * 0.01


@pytest.mark.parametrize("surface", Surface)
@pytest.mark.parametrize("kind", ["Car", "Truck", "Bicycle"])
def test_whoever_brakes_loses_no_more_speed_than_the_road_lets_him(kind: str, surface: Surface) -> None:
    limits = LIMITS[kind]
    braking = min(limits.brake, surface.row.friction * GRAVITY) + limits.drag
    assert seconds_to_stop(kind, surface) == pytest.approx(10.0 / braking, rel=0.03)


def test_a_car_takes_seven_times_as_long_to_stop_on_ice() -> None:
    assert seconds_to_stop("Car", Surface.ICE) / seconds_to_stop("Car", Surface.DRY) == pytest.approx(6.8, abs=0.2)


def test_surfaces_hold_less_one_after_the_other_and_a_dry_one_limits_nobody() -> None:
    frictions = [surface.row.friction for surface in Surface]
    assert frictions == sorted(frictions, reverse=True)
    assert Surroundings().grip == math.inf


def test_a_driver_who_knows_the_road_takes_a_bend_slower_on_ice() -> None:
    turns = np.linspace(0.0, math.pi / 2, 30)
    bend = Polyline(np.column_stack((10.0 * np.sin(turns), 10.0 * (1.0 - np.cos(turns)))))
    middle = len(turns) // 2
    assert curve_speeds(bend, 0.1 * GRAVITY)[middle] ** 2 / 10.0 == pytest.approx(0.8 * 0.1 * GRAVITY, rel=0.1)
    assert curve_speeds(bend) == curve_speeds(bend, Surroundings().grip)


def test_a_leader_who_brakes_on_ice_needs_longer_and_is_seen_to_brake(simulator: Simulator) -> None:
    act = "BrakeOnPath(egoRoute)"
    stops: dict[str, int] = {}
    for surface in ("dry", "ice"):
        episode = driven(simulator, road(f"param surface = '{surface}'", act=act, speed=6))
        assert episode.surroundings.surface == surface
        (leader,) = episode.adversaries
        stops[surface] = int(np.flatnonzero(leader.speed < 0.1)[0])
        route = simulator.route(road(act=act, speed=6), 0)
        assert list(ACTIONS[Action.BRAKE](watch(episode, route, leader)))
    assert stops["ice"] > 5 * stops["dry"]


def seen(simulator: Simulator, program: ScenicProgram) -> int:
    """How many others an ego that sees everybody sees at the start."""
    session = simulator.open(program, SCENE, observation="actors")
    assert not isinstance(session, Rejected)
    rows = session.observation[OWN:].reshape(-1, PER_ACTOR)
    session.close()
    return int(rows[:, 0].sum())


@pytest.mark.parametrize(
    ("before", "kind", "at", "count"),
    [
        ("", "Pedestrian", 45, 1),
        ("param light = 'night'", "Pedestrian", 30, 0),
        ("param light = 'night'", "Pedestrian", 20, 1),
        ("param light = 'night'", "Car", 45, 1),
        ("param light = 'dusk'", "Pedestrian", 45, 1),
        ("param weather = 'fog'", "Car", 45, 0),
        ("param weather = 'fog'", "Car", 30, 1),
        ("param weather = 'rain'", "Car", 45, 1),
    ],
)
def test_night_hides_who_has_no_lamps_and_fog_everybody(
    simulator: Simulator, before: str, kind: str, at: float, count: int
) -> None:
    assert seen(simulator, road(before, act="Halt()" if kind == "Car" else "MoveAhead(0)", kind=kind, at=at)) == count


@pytest.mark.parametrize("light", Light)
@pytest.mark.parametrize("weather", Weather)
def test_no_darkness_and_no_fog_hides_what_four_numbers_show(light: Light, weather: Weather) -> None:
    assert Surroundings(light=light, weather=weather).sight(lit=False) > SIGHT
    assert Surroundings(light=light, weather=weather).sight(lit=True) >= 40.0 or weather is not Weather.FOG
    assert Surroundings().sight(lit=False) > RANGE


def test_vehicles_and_cycles_have_lamps_and_nobody_else() -> None:
    assert [has_lamps(kind) for kind in ("Car", "Bicycle", "Pedestrian", "Kiosk")] == [True, True, False, False]


def test_a_careful_driver_knows_of_a_risk_in_the_dark_when_it_can_be_seen(simulator: Simulator) -> None:
    program = road(act="MoveAhead(0)", kind="Pedestrian", at=40)
    episode = driven(simulator, program, 1.0)
    assert episode.collision is not None
    line = simulator.route(program, 0).line
    by_day, by_night = (
        risk_step(replace(episode, surroundings=Surroundings(light=light)), line) for light in (Light.DAY, Light.NIGHT)
    )
    assert by_day is not None
    assert by_night is not None
    ego, other = episode.ego_track, episode.adversaries[0]
    assert by_day < by_night
    assert math.hypot(ego.x[by_night] - other.x[by_night], ego.y[by_night] - other.y[by_night]) < 25.0


@pytest.mark.parametrize("name", ["light", "weather", "surface"])
def test_a_program_that_asks_for_what_there_is_not_is_refused_by_name(simulator: Simulator, name: str) -> None:
    with pytest.raises(ProgramError, match=f"no {name} 'icee'"):
        simulator.open(road(f"param {name} = 'icee'"), SCENE)


def test_a_road_is_what_the_weather_makes_of_it_unless_it_is_said() -> None:
    usual = {"light": "day", "weather": "rain", "surface": None}
    assert surroundings_of(usual).surface is Surface.WET
    assert surroundings_of(usual | {"surface": "dry"}).surface is Surface.DRY
    assert surroundings_of({"weather": "ClearNoon"}) == Surroundings()  # a program for CARLA


def test_an_episode_keeps_its_surroundings_on_its_way_out_of_the_sandbox(simulator: Simulator) -> None:
    episode = driven(simulator, road("param light = 'night', weather = 'rain'"))
    steps = len(episode.ego_track.x)
    message = json.loads(json.dumps(episode_to_json(episode)))
    told = episode_from_json(message, scene_id="toy/0", ego="x", dt=episode.dt, steps=steps)
    assert told.surroundings == Surroundings(light=Light.NIGHT, weather=Weather.RAIN, surface=Surface.WET)


TEXT = "At night a pedestrian crosses from the right on a wet road."
NIGHT_AND_WET = Surroundings(light=Light.NIGHT, surface=Surface.WET)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    few = Settings(search=SearchSettings(scenes=2, block=2, keep=1))
    made = tmp_path_factory.mktemp("surroundings") / "run"
    pipeline.run(runs.asked_run(TEXT, settings=few, ego="idm"), made)
    return made


def test_a_run_keeps_its_surroundings_and_a_replay_has_the_same(folder: Path) -> None:
    run = runs.open_run(folder)
    made = rebuild(run)
    scenario, program = made.scenario, made.program
    assert scenario.surroundings == NIGHT_AND_WET
    assert "param light = 'night', weather = 'clear', surface = 'wet'" in program.source
    rows = [row for row in runs.read_scenes(run) if row["status"] == "ran"]
    assert {(row["light"], row["weather"], row["surface"]) for row in rows} == {("night", "clear", "wet")}
    assert runs.read_episode(run, rows[0]["scene_id"]).surroundings == NIGHT_AND_WET
    assert replay(folder, rows[0]["scene_id"]).identical


def test_a_report_says_what_surrounds_its_scenes_and_what_that_means(folder: Path) -> None:
    report = (folder / "report.html").read_text()
    assert "night, wet road: the road limits what tyres brake" in report
    assert "nothing to an ego that sees four numbers" in report


def test_a_folder_of_before_is_of_days_on_dry_roads(folder: Path, tmp_path: Path) -> None:
    table = pq.read_table(folder / "scenes.parquet")
    pq.write_table(table.drop_columns(["light", "weather", "surface"]), tmp_path / "scenes.parquet")
    read = read_table(tmp_path / "scenes.parquet", SCENES).to_pylist()
    assert {Surroundings.named(row) for row in read if row["status"] == "ran"} == {Surroundings()}


def test_a_sentence_of_day_and_dry_makes_the_program_that_it_made_before() -> None:
    plain, told = (pipeline.understand(f"The car ahead brakes hard{more}.").program for more in ("", " in daylight"))
    wet = pipeline.understand("The car ahead brakes hard on a wet road.")
    assert plain.source.partition("model")[2] == told.source.partition("model")[2]
    assert "param light" not in plain.source
    assert "surface = 'wet'" in wet.program.source
    assert "as said" in str(wet)
    assert wet.as_dict()["scenarios"][0]["surroundings"] == {"surface": "wet"}


def test_an_overcast_sky_hides_nobody_and_dust_does_as_fog_does() -> None:
    assert Surroundings(weather=Weather.OVERCAST).sight(lit=True) == Surroundings().sight(lit=True)
    assert Surroundings(weather=Weather.DUST).sight(lit=True) == Surroundings(weather=Weather.FOG).sight(lit=True)
