"""What clients ask, by the names that the wheel uses: the world, its map, its time, its lights and its weather.

A function takes the world and the call's arguments; it gives a value, or None for a call that has none, or raises
`Refused` with a message that the client shows. All quantities are CARLA's.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from carla_stand_in import recorder, wire
from carla_stand_in.blueprints import definitions
from carla_stand_in.lights import OFF
from carla_stand_in.wire import Refused
from carla_stand_in.world import World, checked_settings

Call = Callable[..., Any]

_ROAD = 1  # CARLA's label of what a point lies on


def version(_: World) -> str:
    """Of the protocol."""
    return wire.VERSION


def get_episode_settings(world: World) -> list[Any]:
    """The settings in force."""
    return world.settings


def set_episode_settings(world: World, settings: Any) -> int:
    """New settings; gives the frame they hold from."""
    world.settings = checked_settings(settings)
    return world.frame


def map_and_places(world: World) -> list[Any]:
    """Name and places to begin at."""
    return [world.roads.name, world.roads.spawn_points]


def opendrive(world: World) -> str:
    """OpenDRIVE."""
    return world.roads.text


def get_available_maps(world: World) -> list[str]:
    """What can be loaded, by the paths that CARLA's have."""
    return [f"/Game/Carla/Maps/{name}" for name in sorted(world.maps)]


def get_actor_definitions(_: World) -> list[list[Any]]:
    """The catalogue."""
    return definitions()


def tick_cue(world: World) -> int:
    """Go on by a step; gives its number."""
    return world.step()


def get_weather_parameters(world: World) -> list[float]:
    """The weather that was set, 14 numbers."""
    return world.weather


def set_weather_parameters(world: World, weather: Any) -> None:
    """Weather is kept and told; nothing here gets wet."""
    given = wire.numbers(weather, min(len(weather), 14)) if isinstance(weather, list) else wire.numbers(weather, 14)
    world.weather = [*given, *world.weather[len(given) :]]


def get_imui_gravity(world: World) -> float:
    """What inertial sensors feel of standing on the ground [m/s²]."""
    return world.gravity


def set_imui_gravity(world: World, gravity: Any) -> None:
    """Let them feel another one; nothing falls here."""
    world.gravity = wire.number(gravity)


def project_point(world: World, location: Any, direction: Any, distance: Any) -> list[Any]:
    """The road below a point, where one looks down; there is nothing else to hit."""
    at, down, far = wire.numbers(location, 3), wire.numbers(direction, 3), wire.number(distance)
    ground = world.roads.ground(at)
    found = down[2] < 0.0 and 0.0 <= at[2] - ground <= far
    return [found, [[at[0], at[1], ground if found else at[2]], _ROAD if found else 0]]


def _light(world: World, actor: Any) -> Any:
    number = wire.whole(actor)
    if number not in world.lights.by_actor or number not in world.actors:
        raise Refused(f"actor {number} is not a traffic light")
    return world.lights.by_actor[number]


def set_traffic_light_state(world: World, actor: Any, state: Any) -> None:
    """Show a state until the junction goes on, or for ever where it is frozen."""
    if wire.whole(state) > OFF:
        raise Refused(f"traffic lights have states 0 to {OFF}, not {state}")
    _light(world, actor).set(state)


def _set_time(place: int) -> Call:
    def set_time(world: World, actor: Any, seconds: Any) -> None:
        _light(world, actor).times[place] = max(0.0, wire.number(seconds))

    return set_time


def freeze_all_traffic_lights(world: World, frozen: Any) -> None:
    """Stop, or go on with, the turns of all."""
    world.lights.frozen = bool(frozen)


def freeze_traffic_light(world: World, actor: Any, frozen: Any) -> None:
    """As CARLA does, for all."""
    _light(world, actor)
    world.lights.frozen = bool(frozen)


def get_group_traffic_lights(world: World, actor: Any) -> list[int]:
    """The lights of the same junction."""
    _light(world, actor)
    return world.lights.group(actor)


def reset_traffic_light_group(world: World, actor: Any) -> None:
    """Let a junction begin anew."""
    _light(world, actor)
    world.lights.reset(actor)


def reset_all_traffic_lights(world: World) -> None:
    """Let every junction begin anew."""
    world.lights.reset()


def start_recorder(world: World, name: Any, *_: Any) -> str:
    """Write a file from the next step on, with all there is to tell; gives its path."""
    return world.recorder.start(wire.text(name), world.roads.name.rsplit("/", 1)[-1])


def stop_recorder(world: World) -> None:
    """End the file."""
    world.recorder.stop()


def recorded_steps(world: World, name: Any, every: Any = True) -> str:
    """A recording as text."""
    return recorder.told(world.files, wire.text(name), bool(every))


def show_recorder_collisions(world: World, name: Any, one: Any, other: Any) -> str:
    """Who met whom in a recording."""
    return recorder.collisions(world.files, wire.text(name), wire.letter(one), wire.letter(other))


def show_recorder_actors_blocked(world: World, name: Any, least: Any, within: Any) -> str:
    """Which vehicles of a recording stayed where they were for `least` seconds, within so many centimetres."""
    return recorder.blocked(world.files, wire.text(name), wire.number(least), wire.number(within))


def _nothing(*_: Any) -> None:
    """For what has no effect here, such as drawing."""


def _empty(*_: Any) -> list[Any]:
    """For lists of what there is none of."""
    return []


CALLS: dict[str, Call] = {
    "version": version,
    "get_episode_settings": get_episode_settings,
    "set_episode_settings": set_episode_settings,
    "get_map_info": map_and_places,
    "get_map_data": opendrive,
    "get_required_files": _empty,
    "get_available_maps": get_available_maps,
    "get_actor_definitions": get_actor_definitions,
    "tick_cue": tick_cue,
    "get_weather_parameters": get_weather_parameters,
    "set_weather_parameters": set_weather_parameters,
    "get_imui_gravity": get_imui_gravity,
    "set_imui_gravity": set_imui_gravity,
    "project_point": project_point,
    "set_traffic_light_state": set_traffic_light_state,
    "set_traffic_light_green_time": _set_time(0),
    "set_traffic_light_yellow_time": _set_time(1),
    "set_traffic_light_red_time": _set_time(2),
    "freeze_traffic_light": freeze_traffic_light,
    "freeze_all_traffic_lights": freeze_all_traffic_lights,
    "reset_traffic_light_group": reset_traffic_light_group,
    "reset_all_traffic_lights": reset_all_traffic_lights,
    "get_group_traffic_lights": get_group_traffic_lights,
    "start_recorder": start_recorder,
    "stop_recorder": stop_recorder,
    "show_recorder_file_info": recorded_steps,
    "show_recorder_collisions": show_recorder_collisions,
    "show_recorder_actors_blocked": show_recorder_actors_blocked,
    # There are no boxes around lamps, no street lamps, no meshes.
    "get_light_boxes": _empty,
    "query_lights_state": _empty,
    "get_environment_objects": _empty,
    "get_names_of_all_objects": _empty,
    "get_all_level_BBs": _empty,
    "cast_ray": _empty,
    # Nothing is drawn here, and no map has layers.
    "load_map_layer": _nothing,
    "unload_map_layer": _nothing,
    "draw_debug_shape": _nothing,
    "clear_debug_shape": _nothing,
    "clear_debug_string": _nothing,
    "update_day_night_cycle": _nothing,
    "set_light_manager_active": _nothing,
    "update_lights_state": _nothing,
    "enable_environment_objects": _nothing,
    "show_vehicle_debug_telemetry": _nothing,
}
"""Each by its name."""
