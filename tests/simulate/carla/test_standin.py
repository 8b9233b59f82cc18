"""The stand-in for CARLA, as the real wheel sees it."""

from __future__ import annotations

import math
import time
from typing import Any

import pytest
from standing_in import DT, MKZ, WALKER, connected, listened, settled, spawned, speed, ticked_until

from chatscene.maps.network import PACKAGED

carla: Any = pytest.importorskip("carla", reason="the extra 'carla' is not installed, or has no wheel for this Python")
pytest.importorskip("msgpack", reason="the extra 'carla' is not installed")


def test_the_server_names_carlas_version_and_the_packaged_map(client_and_world: tuple[Any, Any]) -> None:
    client, world = client_and_world
    assert client.get_server_version() == client.get_client_version() == "0.9.16"
    assert [name.rsplit("/", 1)[-1] for name in client.get_available_maps()] == ["town"]
    assert world.get_map().name == "Carla/Maps/town"
    assert world.get_map().to_opendrive().count("<road ") == PACKAGED["town"].read_text().count("<road ")


def test_places_to_begin_at_lie_on_driving_lanes_and_do_not_overlap(world: Any) -> None:
    world_map = world.get_map()
    points = world_map.get_spawn_points()
    assert len(points) > 100
    for point in points:
        waypoint = world_map.get_waypoint(point.location)
        assert waypoint.transform.location.distance(point.location) < 0.6
        assert not waypoint.is_junction
    blueprint = world.get_blueprint_library().find(MKZ)
    assert all(world.try_spawn_actor(blueprint, point) for point in points)


def test_a_waypoint_leads_into_a_junction_and_back_out_of_it(world: Any) -> None:
    waypoints = [first for first, _ in world.get_map().get_topology() if first.is_junction]
    assert len(waypoints) > 100
    assert all(waypoint.previous(2.0) and waypoint.next(2.0) for waypoint in waypoints)


def test_a_tick_is_one_step_and_moves_what_obeys_pedals(world: Any) -> None:
    car = spawned(world)
    world.tick()
    before, start = world.get_snapshot(), car.get_transform()
    car.apply_control(carla.VehicleControl(throttle=0.5))
    for _ in range(40):
        world.tick()
    after = world.get_snapshot()
    assert after.frame - before.frame == 40
    assert after.timestamp.elapsed_seconds - before.timestamp.elapsed_seconds == pytest.approx(2.0, abs=1e-4)
    driven = car.get_location() - start.location
    assert driven.dot(start.get_forward_vector()) == pytest.approx(driven.length(), rel=1e-3)
    assert 3.0 < driven.length() < 6.0
    assert after.find(car.id).get_transform() == car.get_transform()
    assert car.get_control().throttle == pytest.approx(0.5)


def test_positive_steering_turns_right_which_is_where_yaw_grows(world: Any) -> None:
    car = spawned(world)
    world.tick()
    right = car.get_transform().get_right_vector()
    start = car.get_location()
    car.apply_control(carla.VehicleControl(throttle=0.5, steer=0.1))
    for _ in range(40):
        world.tick()
    assert car.get_angular_velocity().z > 1.0
    assert (car.get_location() - start).dot(right) > 0.1


def test_brake_hand_brake_and_reverse_do_what_they_say(world: Any) -> None:
    car = spawned(world)
    for stop in (carla.VehicleControl(brake=1.0), carla.VehicleControl(hand_brake=True)):
        car.apply_control(carla.VehicleControl(throttle=1.0))
        ticked_until(world, lambda: speed(car) > 5.0)
        car.apply_control(stop)
        assert ticked_until(world, lambda: speed(car) == 0.0) < 30
    ahead = car.get_transform().get_forward_vector()
    car.apply_control(carla.VehicleControl(throttle=0.5, reverse=True))
    for _ in range(10):
        world.tick()
    assert car.get_velocity().dot(ahead) < -0.3


def test_an_ackermann_control_reaches_its_speed(world: Any) -> None:
    car = spawned(world)
    car.apply_ackermann_control(carla.VehicleAckermannControl(speed=6.0))
    ticked_until(world, lambda: abs(speed(car) - 6.0) < 1e-3)


def test_a_walker_goes_where_it_is_told_at_the_speed_it_is_told(world: Any) -> None:
    walker = spawned(world, WALKER)
    walker.apply_control(carla.WalkerControl(carla.Vector3D(0.0, -1.0, 0.0), 1.5))
    for _ in range(20):
        world.tick()
    velocity = walker.get_velocity()
    assert (velocity.x, velocity.y) == (pytest.approx(0.0, abs=1e-5), pytest.approx(-1.5))
    assert walker.get_transform().rotation.yaw == pytest.approx(-90.0)
    assert walker.get_location().z == pytest.approx(0.93, abs=0.01)


def test_a_teleport_holds_and_physics_can_be_switched_off(world: Any) -> None:
    car = spawned(world)
    there = world.get_map().get_spawn_points()[20]
    car.set_transform(there)
    car.apply_control(carla.VehicleControl(throttle=1.0))
    car.set_simulate_physics(False)
    for _ in range(10):
        world.tick()
    assert car.get_location().distance(there.location) < 1e-3
    car.set_simulate_physics(True)
    for _ in range(10):
        world.tick()
    assert car.get_location().distance(there.location) > 0.3


def test_a_velocity_is_had_at_once_and_a_constant_one_is_kept(world: Any) -> None:
    car = spawned(world)
    car.set_target_velocity(car.get_transform().get_forward_vector() * 7.0)
    world.tick()
    start = car.get_transform().get_forward_vector()
    car.set_target_velocity(start * 7.0)
    world.tick()
    assert speed(car) == pytest.approx(7.0, abs=0.1)
    car.enable_constant_velocity(carla.Vector3D(4.0, 0.0, 0.0))
    for _ in range(20):
        world.tick()
    assert speed(car) == pytest.approx(4.0)
    car.disable_constant_velocity()
    car.apply_control(carla.VehicleControl(brake=1.0))
    ticked_until(world, lambda: speed(car) == 0.0)


def test_what_lies_in_the_way_of_a_spawn_refuses_it_unless_it_lies_lower(world: Any) -> None:
    car = spawned(world)
    world.tick()
    library = world.get_blueprint_library()
    here = world.get_map().get_spawn_points()[0]
    assert world.try_spawn_actor(library.find(MKZ), here) is None
    with pytest.raises(RuntimeError, match="collision at spawn position"):
        world.spawn_actor(library.find(MKZ), here)
    above = carla.Transform(carla.Location(here.location.x, here.location.y, 30.0), here.rotation)
    assert world.try_spawn_actor(library.find(MKZ), above) is not None
    assert car.destroy()
    world.tick()
    assert car.id not in [actor.id for actor in world.get_actors()]


def test_an_id_is_never_used_again(client_and_world: tuple[Any, Any]) -> None:
    client, world = client_and_world
    first = spawned(world)
    world.tick()
    assert first.destroy()
    second = spawned(world)
    old = {actor.id for actor in world.get_actors()} | {first.id, second.id}
    world = client.reload_world(False)
    assert not old & {actor.id for actor in world.get_actors()}


def test_a_collision_is_told_to_both_with_opposite_impulses(world: Any) -> None:
    car, other = spawned(world), spawned(world, ahead=12.0)
    mine, its = (listened(world, "sensor.other.collision", one) for one in (car, other))
    car.apply_control(carla.VehicleControl(throttle=1.0))
    for _ in range(60):
        world.tick()
    (first,), (answer,) = settled(mine, 1), settled(its, 1)
    assert first.other_actor.id == other.id
    assert answer.other_actor.id == car.id
    assert first.frame == answer.frame
    ahead = car.get_transform().get_forward_vector()
    assert first.normal_impulse.dot(ahead) < -1000.0  # N s: it is pushed back
    assert answer.normal_impulse.dot(ahead) == pytest.approx(-first.normal_impulse.dot(ahead))


def test_who_stands_apart_collides_with_nobody(world: Any) -> None:
    car = spawned(world)
    spawned(world, ahead=12.0)
    heard = listened(world, "sensor.other.collision", car)
    for _ in range(20):
        world.tick()
    time.sleep(0.2)
    assert len(heard) == 1


def test_dirt_on_the_road_is_driven_over(world: Any) -> None:
    car = spawned(world)
    assert spawned(world, "static.prop.dirtdebris01").is_alive
    heard = listened(world, "sensor.other.collision", car)
    world.tick()
    time.sleep(0.2)
    assert len(heard) == 1


def test_an_inertial_sensor_and_a_satellite_receiver_tell_the_truth(world: Any) -> None:
    car = spawned(world)
    inertia = listened(world, "sensor.other.imu", car)
    earth = listened(world, "sensor.other.gnss", car)
    car.apply_control(carla.VehicleControl(throttle=1.0))
    for _ in range(10):
        world.tick()
    told, place = settled(inertia, 10)[-1], settled(earth, 10)[-1]
    assert told.frame == place.frame == world.get_snapshot().frame
    forward = car.get_acceleration().dot(car.get_transform().get_forward_vector())
    assert told.accelerometer.x == pytest.approx(forward, rel=1e-3)
    assert told.accelerometer.z == pytest.approx(9.81)
    assert told.compass == pytest.approx(math.radians(car.get_transform().rotation.yaw + 90.0) % math.tau, abs=1e-4)
    where = world.get_map().transform_to_geolocation(car.get_location())
    assert (place.latitude, place.longitude) == (pytest.approx(where.latitude), pytest.approx(where.longitude))


def test_an_obstacle_ahead_is_told_with_its_distance(world: Any) -> None:
    car, other = spawned(world), spawned(world, ahead=20.0)
    heard = listened(world, "sensor.other.obstacle", car, distance="30", hit_radius="0.1")
    world.tick()
    (told,) = settled(heard, 1)
    assert told.other_actor.id == other.id
    assert told.distance == pytest.approx(20.0 - other.bounding_box.extent.x - 0.1, abs=0.01)


def test_lights_of_a_junction_take_turns_and_stand_still_when_frozen(world: Any) -> None:
    lights = list(world.get_actors().filter("traffic.traffic_light"))
    assert len(lights) == PACKAGED["town"].read_text().count("1000001")
    world.tick()
    group = lights[0].get_group_traffic_lights()
    seen: set[tuple[str, ...]] = set()
    for _ in range(700):
        world.tick()
        seen.add(tuple(str(light.get_state()) for light in group))
    assert {state for states in seen for state in states} == {"Green", "Yellow", "Red"}
    directions = [round(light.get_transform().rotation.yaw / 90.0) % 2 for light in group]
    for states in seen:
        open_axes = {axis for axis, state in zip(directions, states, strict=True) if state != "Red"}
        assert len(open_axes) <= 1
    lights[0].freeze(True)
    lights[0].set_state(carla.TrafficLightState.Yellow)
    for _ in range(300):
        world.tick()
    assert lights[0].get_state() == carla.TrafficLightState.Yellow
    assert lights[-1].is_frozen()


def test_a_vehicle_waits_at_the_light_of_its_own_lane(world: Any) -> None:
    world.tick()
    light = world.get_actors().filter("traffic.traffic_light")[0]
    light.freeze(True)
    light.set_state(carla.TrafficLightState.Red)
    arm = world.get_map().get_waypoint_xodr(int(light.get_opendrive_id()), -1, 0.1)  # signals are called like roads
    stop = light.get_stop_waypoints()[0].transform.location
    assert stop.distance(arm.transform.location) < 4.0
    line = arm.previous(6.0)[0].transform
    line.location.z += 0.5
    car = world.spawn_actor(world.get_blueprint_library().find(MKZ), line)
    world.tick()
    assert car.is_at_traffic_light()
    at = car.get_traffic_light()
    assert car.get_traffic_light_state() == at.get_state()
    assert at.id in [other.id for other in light.get_group_traffic_lights()]
    car.set_transform(world.get_map().get_spawn_points()[0])
    world.tick()
    assert not car.is_at_traffic_light()


def test_lamps_are_kept_and_told(world: Any) -> None:
    car = spawned(world)
    for lamps in (
        carla.VehicleLightState(carla.VehicleLightState.Brake | carla.VehicleLightState.Fog),
        carla.VehicleLightState.LowBeam,
    ):
        car.set_light_state(lamps)
        world.tick()
        assert car.get_light_state() == lamps
        assert world.get_vehicles_light_states() == {car.id: lamps}


def test_weather_is_kept_and_told(world: Any) -> None:
    world.set_weather(carla.WeatherParameters.HardRainNoon)
    assert world.get_weather() == carla.WeatherParameters.HardRainNoon


def test_a_batch_answers_each_command_and_gives_new_actors_to_what_follows(client_and_world: tuple[Any, Any]) -> None:
    client, world = client_and_world
    command, library, points = carla.command, world.get_blueprint_library(), world.get_map().get_spawn_points()
    pedal = command.ApplyVehicleControl(command.FutureActor, carla.VehicleControl(throttle=1.0))
    answers = client.apply_batch_sync(
        [
            command.SpawnActor(library.find(MKZ), points[0]).then(pedal),
            command.SpawnActor(library.find(MKZ), points[0]),
            command.DestroyActor(987654),
            command.ApplyTorque(1, carla.Vector3D(1.0, 0.0, 0.0)),
        ],
        True,
    )
    made, *refused = answers
    assert not made.has_error()
    assert [answer.error for answer in refused] == [
        "Spawn failed because of collision at spawn position",
        "unable to destroy actor 987654: not found",
        "this stand-in for CARLA does not support the command ApplyTorque",
    ]
    for _ in range(20):
        world.tick()
    assert speed(world.get_actor(made.actor_id)) > 2.0


def test_a_world_can_be_made_of_a_clients_own_map(client_and_world: tuple[Any, Any]) -> None:
    client, world = client_and_world
    spawned(world)
    made = client.generate_opendrive_world(PACKAGED["town"].read_text().replace(' name="town"', ' name="mine"'))
    assert made.get_map().name == "Carla/Maps/OpenDriveMap"
    assert not list(made.get_actors().filter("vehicle.*"))
    with pytest.raises(RuntimeError, match="no lane to drive on"):
        client.generate_opendrive_world("<html/>")
    again = client.load_world("town")
    assert again.get_map().name == "Carla/Maps/town"


def test_what_is_not_supported_is_named_and_the_client_goes_on(client_and_world: tuple[Any, Any]) -> None:
    client, world = client_and_world
    car = spawned(world)
    camera = world.get_blueprint_library().find("sensor.camera.depth")
    for call, name in (
        (lambda: client.load_world("Town99"), "map not found: 'Town99'; this stand-in has town"),
        (car.get_telemetry_data, "get_telemetry_data: this stand-in for CARLA does not support it"),
        (lambda: world.spawn_actor(camera, carla.Transform()), "does not support sensor.camera.depth"),
        (lambda: client.replay_file("x", 0.0, 0.0, 0), "replay_file: this stand-in for CARLA does not support it"),
    ):
        with pytest.raises(RuntimeError, match=name):
            call()
    world.tick()
    assert car.is_alive


def test_a_step_that_bodies_cannot_take_is_refused(world: Any) -> None:
    settings = world.get_settings()
    settings.fixed_delta_seconds = 30.0
    with pytest.raises(RuntimeError, match=r"steps 0\.001 to 1 s"):
        world.apply_settings(settings)


def test_an_asynchronous_world_goes_on_by_itself(port: int) -> None:
    _, world = connected(port, None)
    assert not world.get_settings().synchronous_mode
    first = world.wait_for_tick(60.0)
    assert world.wait_for_tick(60.0).frame > first.frame


def driven(port: int) -> list[tuple[float, ...]]:
    """The tracks of a short drive with a collision in it."""
    _, world = connected(port)
    car, _, walker = spawned(world), spawned(world, ahead=15.0), spawned(world, WALKER, 3)
    car.apply_control(carla.VehicleControl(throttle=0.8, steer=0.02))
    walker.apply_control(carla.WalkerControl(carla.Vector3D(1.0, 1.0, 0.0), 2.0))
    track: list[tuple[float, ...]] = []
    for _ in range(50):
        world.tick()
        for actor in (car, walker):
            at, velocity = actor.get_transform(), actor.get_velocity()
            track.append((at.location.x, at.location.y, at.rotation.yaw, velocity.x, velocity.y))
    return track


def test_the_same_calls_give_the_same_frames_bit_for_bit(port: int) -> None:
    assert driven(port) == driven(port)


def test_who_listens_and_ticks_at_once_hears_that_tick(world: Any) -> None:
    car = spawned(world)
    for name in ("sensor.camera.rgb", "sensor.other.imu", "sensor.other.gnss", "sensor.lidar.ray_cast"):
        sensor = world.spawn_actor(world.get_blueprint_library().find(name), carla.Transform(), attach_to=car)
        heard = [sensor]
        sensor.listen(heard.append)
        frame = world.tick()
        (told,) = settled(heard, 1)
        assert told.frame == frame


def test_a_camera_draws_what_is_below_it_with_its_own_direction_upwards(world: Any) -> None:
    car = spawned(world)
    ahead = spawned(world, ahead=15.0)
    # 25 m up, 90 degrees wide: 50 m are 400 pixels.
    heard = listened(world, "sensor.camera.semantic_segmentation", car, image_size_x="400", image_size_y="400")
    world.tick()
    (picture,) = settled(heard, 1)
    pixels = bytes(picture.raw_data)
    tags = [pixels[4 * i + 2] for i in range(400 * 400)]

    def tag(right: float, forward: float) -> int:
        return tags[int(200 - 8 * forward) * 400 + int(200 + 8 * right)]

    assert (picture.width, picture.height, picture.frame) == (400, 400, world.get_snapshot().frame)
    assert tag(0.1, 0.1) == tag(0.1, 15.0) == 14
    assert tag(0.1, 8.0) == 1
    shown = sum(one == 14 for one in tags) / 64  # m²
    area = sum(4 * one.bounding_box.extent.x * one.bounding_box.extent.y for one in (car, ahead))
    assert shown == pytest.approx(area, rel=0.1)


def test_a_lidar_measures_the_distance_to_what_is_ahead_and_to_the_ground(world: Any) -> None:
    car, other = spawned(world), spawned(world, ahead=20.0)
    wanted = {"range": "40", "channels": "3", "upper_fov": "0", "lower_fov": "-20", "rotation_frequency": "20"}
    heard = listened(world, "sensor.lidar.ray_cast", car, 1.0, **wanted, points_per_second="21600")
    world.tick()
    (cloud,) = settled(heard, 1)
    points = [(point.point.x, point.point.y, point.point.z) for point in cloud]
    level = [point for point in points if abs(point[2]) < 1e-3]
    assert min(x for x, y, _ in level if abs(y) < 0.5) == pytest.approx(20.0 - other.bounding_box.extent.x, abs=0.05)
    low = [point for point in points if point[2] < -0.99]
    assert len(low) > 300
    assert all(z == pytest.approx(-1.0, abs=1e-3) for _, _, z in low)


def test_a_sensor_that_cannot_be_made_is_refused(world: Any) -> None:
    camera = world.get_blueprint_library().find("sensor.camera.rgb")
    camera.set_attribute("image_size_x", "1000000")
    with pytest.raises(RuntimeError, match="a picture of 1000000 by 600 pixels"):
        world.spawn_actor(camera, carla.Transform())


def test_a_semantic_lidar_tells_what_each_point_lies_on(world: Any) -> None:
    car, other = spawned(world), spawned(world, ahead=20.0)
    wanted = {"range": "40", "channels": "3", "upper_fov": "0", "lower_fov": "-20", "rotation_frequency": "20"}
    heard = listened(world, "sensor.lidar.ray_cast_semantic", car, 1.0, **wanted, points_per_second="21600")
    world.tick()
    (cloud,) = settled(heard, 1)
    points = list(cloud)
    assert {(point.object_idx, point.object_tag) for point in points} == {(0, 1), (other.id, 14)}
    back = min((point for point in points if point.object_idx == other.id), key=lambda point: abs(point.point.y))
    assert back.point.x == pytest.approx(20.0 - other.bounding_box.extent.x, abs=0.01)
    assert back.cos_inc_angle == pytest.approx(1.0, abs=1e-3)
    ground = next(point for point in points if point.object_idx == 0)
    assert ground.cos_inc_angle == pytest.approx(1.0 / math.dist((ground.point.x, ground.point.y, -1.0), (0, 0, 0)))


def test_a_radar_tells_how_fast_what_is_ahead_comes_nearer(world: Any) -> None:
    car, other = spawned(world), spawned(world, ahead=30.0)
    heard = listened(world, "sensor.other.radar", car, 1.0, horizontal_fov="10", vertical_fov="4")
    other.set_target_velocity(car.get_transform().get_forward_vector() * -5.0)
    world.tick()
    (told,) = settled(heard, 1)
    straight = min(told, key=lambda point: abs(point.azimuth) + abs(point.altitude))
    assert len(told) > 10
    assert straight.velocity == pytest.approx(-speed(other), rel=1e-2)
    away = other.get_location().distance(car.get_location())
    assert straight.depth == pytest.approx(away - other.bounding_box.extent.x, abs=0.05)


def test_impulses_and_forces_change_a_vehicles_speed_by_its_mass(world: Any) -> None:
    car = spawned(world)
    ahead, mass = car.get_transform().get_forward_vector(), car.get_physics_control().mass
    car.add_impulse(ahead * mass * 5.0)
    world.tick()
    after = speed(car)
    assert after == pytest.approx(5.0, abs=0.1)
    car.add_force(ahead * mass * 2.0 / DT)
    world.tick()
    assert speed(car) == pytest.approx(after + 2.0, abs=0.1)
    world.tick()
    assert speed(car) < after + 2.0


def test_sensors_have_the_attributes_that_clients_set(world: Any) -> None:
    for name, attributes in {
        "sensor.camera.rgb": {"gamma": "2.2", "lens_circle_multiplier": "3.0", "enable_postprocess_effects": "False"},
        "sensor.lidar.ray_cast": {"dropoff_general_rate": "0.45", "atmosphere_attenuation_rate": "0.004"},
        "sensor.other.gnss": {"noise_alt_stddev": "0.000005", "noise_lat_bias": "0.0"},
        "sensor.other.imu": {"noise_accel_stddev_x": "0.001", "noise_gyro_stddev_z": "0.001", "noise_seed": "1"},
        "sensor.other.radar": {"horizontal_fov": "30", "noise_seed": "1"},
    }.items():
        blueprint = world.get_blueprint_library().find(name)
        for key, value in attributes.items():
            blueprint.set_attribute(key, value)
        assert world.spawn_actor(blueprint, carla.Transform()).is_alive
