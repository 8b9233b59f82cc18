"""Commands of a batch: each has an index and a payload, and an answer of its own."""

from __future__ import annotations

from typing import Any

from carla_stand_in import calls_actors as actors
from carla_stand_in import wire
from carla_stand_in.calls import Call, set_traffic_light_state
from carla_stand_in.wire import Refused
from carla_stand_in.world import World

_SPAWN, _DESTROY = 0, 1
_MOST = 10_000
_DEEPEST = 8  # commands after a spawn after a spawn
_COMMANDS: dict[int, Call] = {
    2: actors.apply_control_to_vehicle,
    3: actors.apply_ackermann_control_to_vehicle,
    4: actors.apply_control_to_walker,
    6: actors.set_actor_transform,
    8: actors.set_actor_target_velocity,
    9: actors.set_actor_target_angular_velocity,
    10: actors.add_actor_impulse,
    11: actors.add_actor_force,
    14: actors.set_actor_simulate_physics,
    15: actors.ACTOR_CALLS["set_actor_enable_gravity"],
    16: actors.ACTOR_CALLS["set_actor_autopilot"],
    17: actors.ACTOR_CALLS["set_actor_autopilot"],  # shows telemetry, of which there is none
    18: actors.set_vehicle_light_state,
    19: actors.set_actor_location,
    21: set_traffic_light_state,
}
_NAMES = {
    5: "ApplyVehiclePhysicsControl",
    12: "ApplyAngularImpulse",
    13: "ApplyTorque",
    20: "ConsoleCommand",
}


def apply_batch(world: World, commands: Any, tick: Any = False) -> list[Any]:
    """Carry commands out in their order, each whether or not others could be; perhaps go on by a step then.

    Raises:
        Refused: This is no list of commands.
    """
    if not isinstance(commands, list):
        raise Refused("a list of commands is needed")
    if len(commands) > _MOST:
        raise Refused(f"a batch has {len(commands)} commands, and {_MOST} at most are taken at a time")
    answers = [_answer(world, command) for command in commands]
    if tick:
        world.step()
    return answers


def _answer(world: World, command: Any) -> list[Any]:
    try:
        return wire.answered(_carried_out(world, command, 0))
    except Refused as error:
        return wire.refused(str(error))
    except (TypeError, ValueError, IndexError, KeyError) as error:
        return wire.refused(f"the command cannot be read: {type(error).__name__}: {error}")


def _carried_out(world: World, command: Any, depth: int) -> int:
    """The id of the actor that a command was for."""
    index, payload = command[0] if isinstance(command[0], list) else command
    if index == _SPAWN:
        return _spawned(world, payload, depth)
    actor = payload[0]
    if index == _DESTROY:
        if not actors.destroy_actor(world, actor):
            raise Refused(f"unable to destroy actor {actor}: not found")
    elif index == 7:  # a walker's state: where it is, and its speed, which its control decides here
        actors.set_actor_transform(world, actor, payload[1])
    elif index in _COMMANDS:
        _COMMANDS[index](world, *payload)
    else:
        raise Refused(f"this stand-in for CARLA does not support the command {_NAMES.get(index, index)}")
    return actor


def _spawned(world: World, payload: list[Any], depth: int) -> int:
    if depth > _DEEPEST:
        raise Refused("commands after a spawn are nested too deep")
    description, place, parent, *rest = payload
    number = parent[1] if parent and parent[0] else 0
    actor = world.spawn(description, place, number).id
    for command in rest[-1] if rest and isinstance(rest[-1], list) else []:
        index, then = command[0] if isinstance(command[0], list) else command
        _carried_out(world, [index, then if index == _SPAWN else [actor, *then[1:]]], depth + 1)
    return actor
