"""What clients ask of actors, by the names that the wheel uses; see `calls` for the form."""

from __future__ import annotations

import math
from typing import Any

from carla_stand_in import wire
from carla_stand_in.actors import Actor, BodyActor
from carla_stand_in.calls import Call
from carla_stand_in.wire import Refused
from carla_stand_in.world import World
from chatscene.terms.actors import LIMITS
from chatscene.terms.nouns import with_article

_TAGS = {"vehicle": b"\x0e", "walker": b"\x0c", "traffic": b"\x07", "static": b"\x14"}
_FRONT_WHEELS = 2
_LEAST_TURN = 0.05  # [rad] of a wheel, so that steering is a share of something


def described(actor: Actor, port: int) -> list[Any]:
    """An actor as it goes over the wire; sensors of the server's own have a stream."""
    blueprint = actor.blueprint
    streams = blueprint.group == "sensor" and blueprint.id != "sensor.other.lane_invasion"  # the wheel makes those
    parent = actor.parent.id if actor.parent else 0
    stream = wire.token(actor.id, port) if streams else b""
    return [actor.id, parent, actor.description, actor.box, _TAGS.get(blueprint.group, b""), stream]


def checked_vehicle_control(control: Any) -> list[Any]:
    """Throttle, steer, brake, hand brake, reverse, manual gears, gear, out of a message."""
    if not isinstance(control, list) or len(control) < 7:
        raise Refused("a vehicle's control is needed")
    throttle, steer, brake = wire.numbers(control, 3)
    pedals = [max(0.0, min(1.0, throttle)), max(-1.0, min(1.0, steer)), max(0.0, min(1.0, brake))]
    return [*pedals, *(bool(flag) for flag in control[3:6]), int(max(-9.0, min(9.0, wire.number(control[6]))))]


def apply_control_to_vehicle(world: World, actor: Any, control: Any) -> None:
    """Pedals and wheel, until others are given."""
    body = world.body(actor, "vehicle")
    body.control = checked_vehicle_control(control)
    body.target = None


def apply_ackermann_control_to_vehicle(world: World, actor: Any, control: Any) -> None:
    """An angle [rad, right positive] and a speed [m/s], reached within the body's limits."""
    body = world.body(actor, "vehicle")
    angle, _, speed = wire.numbers(control, 3)
    share = angle / max(LIMITS[body.blueprint.kind].wheel_angle, _LEAST_TURN)
    body.target = (max(-1.0, min(1.0, share)), speed)


def apply_control_to_walker(world: World, actor: Any, control: Any) -> None:
    """A direction and a speed [m/s], reached as fast as legs can."""
    body = world.body(actor, "walker")
    if not isinstance(control, list) or len(control) < 3:
        raise Refused("a walker's control is needed")
    body.control = [wire.numbers(control[0], 3), wire.number(control[1]), bool(control[2])]


def set_actor_transform(world: World, actor: Any, place: Any) -> None:
    """Put it elsewhere."""
    location, rotation = wire.transform(place)
    world.actor(actor).place(location, rotation)


def set_actor_location(world: World, actor: Any, location: Any) -> None:
    """Put it elsewhere, turned as it is."""
    found = world.actor(actor)
    found.place(wire.numbers(location, 3), None if found.parent else found.rotation)


def set_actor_target_velocity(world: World, actor: Any, velocity: Any) -> None:
    """Have a velocity [m/s] at once, as far as it lies along the heading."""
    world.body(actor).push(wire.numbers(velocity, 3))


def set_actor_target_angular_velocity(world: World, actor: Any, turning: Any) -> None:
    """Only none at all can be asked for: bodies turn as their wheels or legs do."""
    world.actor(actor)
    if any(wire.numbers(turning, 3)):
        raise Refused("bodies turn as their wheels or legs do here; an angular velocity other than zero cannot be set")


def add_actor_impulse(world: World, actor: Any, impulse: Any) -> None:
    """Push a vehicle at once [N s], as far as it lies along the heading."""
    world.body(actor, "vehicle").strike(wire.numbers(impulse, 3))


def add_actor_force(world: World, actor: Any, force: Any) -> None:
    """Push a vehicle during the next step [N], as far as it lies along the heading."""
    body, given = world.body(actor, "vehicle"), wire.numbers(force, 3)
    body.force = [had + more for had, more in zip(body.force, given, strict=True)]


def enable_actor_constant_velocity(world: World, actor: Any, velocity: Any) -> None:
    """Be held at a forward speed [m/s]; the velocity is in the vehicle's own frame."""
    body = world.body(actor, "vehicle")
    top = LIMITS[body.blueprint.kind].top_speed
    body.constant = max(-top, min(top, wire.numbers(velocity, 3)[0]))


def disable_actor_constant_velocity(world: World, actor: Any) -> None:
    """Obey the pedals again."""
    world.body(actor, "vehicle").constant = None


def set_actor_simulate_physics(world: World, actor: Any, on: Any) -> None:
    """Whether it moves by itself; what has no body, and a thing, never does."""
    found = world.actor(actor)
    if isinstance(found, BodyActor) and found.body.moves:
        found.moving = bool(on)


def set_actor_collisions(world: World, actor: Any, on: Any) -> None:
    """Whether others can touch it."""
    found = world.actor(actor)
    if isinstance(found, BodyActor):
        found.touchable = bool(on)


def set_vehicle_light_state(world: World, actor: Any, lamps: Any) -> None:
    """Which lamps are on; kept and told."""
    world.body(actor, "vehicle").lights_on = wire.whole(lamps[0] if isinstance(lamps, list) and lamps else lamps)


def get_vehicle_light_state(world: World, actor: Any) -> list[int]:
    """Which lamps are on."""
    return [world.body(actor, "vehicle").lights_on]


def get_vehicle_light_states(world: World) -> list[list[int]]:
    """The lamps of all vehicles."""
    return [[body.id, body.lights_on] for body in world.bodies() if body.blueprint.group == "vehicle"]


def get_wheel_steer_angle(world: World, actor: Any, wheel: Any) -> float:
    """The angle that is asked of a wheel [degrees, right positive]; rear wheels do not turn."""
    body = world.body(actor, "vehicle")
    turns = wire.whole(wheel) < _FRONT_WHEELS
    return body.control[1] * math.degrees(LIMITS[body.blueprint.kind].wheel_angle) if turns else 0.0


def get_physics_control(world: World, actor: Any) -> list[Any]:
    """What a client can know of a body: mass, wheels with their largest angle, one torque for all speeds.

    Places of wheels are in the world, in centimetres, as in CARLA.
    """
    body = world.body(actor, "vehicle")
    limits, (length, width, _) = LIMITS[body.blueprint.kind], body.blueprint.size
    radius, angle = 0.35, math.degrees(limits.wheel_angle)
    base = limits.wheelbase * length / limits.length
    yaw = math.radians(body.rotation[1])
    c, s = math.cos(yaw), math.sin(yaw)
    wheels: list[list[Any]] = []
    for front in (True, False):
        for side in (-1.0, 1.0):
            ahead, right = base / 2 if front else -base / 2, side * width / 2
            x, y, z = body.location
            spot = [100 * (x + c * ahead - s * right), 100 * (y + s * ahead + c * right), 100 * (z + radius)]
            hand_brake = 0.0 if front else 3000.0
            turn = angle if front else 0.0
            wheels.append([3.5, 0.25, turn, 100 * radius, 1500.0, hand_brake, 2.0, 17.0, 1000.0, spot])
    mass = body.blueprint.mass
    torque = mass * limits.throttle * radius
    gears = [[1.0, 0.5, 0.65]]
    return [
        [[0.0, torque], [5000.0, torque]],
        *(5000.0, 1.0, 0.15, 2.0, 0.35),
        *(True, 0.5, 10.0, 1.0),
        gears,
        *(mass, 0.3, [0.0, 0.0, 0.0]),
        [[0.0, 1.0], [100.0, 1.0]],
        wheels,
        False,
    ]


def get_actor_bounding_box(world: World, actor: Any) -> list[Any]:
    """Its box, also when it is gone; none for what never was, since an error would end a traffic manager."""
    found = world.actors.get(actor) if isinstance(actor, int) else None
    was = world.was(actor)
    return found.box if found else was.box if was else [[0.0] * 3, [0.0] * 3, [0.0] * 3]


def destroy_actor(world: World, actor: Any) -> bool:
    """Take it away; whether there was one. Lights and the spectator stay."""
    found = world.actors.get(wire.whole(actor))
    if found is not None and found.blueprint.group in ("traffic", "spectator"):
        raise Refused(f"actor {actor} is {with_article(found.blueprint.id)} and belongs to the map")
    return world.destroy(actor)


def _accepted(world: World, actor: Any, *_: Any) -> None:
    """For what changes nothing here: vehicles stand on their roads, traffic managers drive from the client."""
    world.actor(actor)


ACTOR_CALLS: dict[str, Call] = {
    "destroy_actor": destroy_actor,
    "get_actor_bounding_box": get_actor_bounding_box,
    "apply_control_to_vehicle": apply_control_to_vehicle,
    "apply_ackermann_control_to_vehicle": apply_ackermann_control_to_vehicle,
    "apply_control_to_walker": apply_control_to_walker,
    "set_actor_transform": set_actor_transform,
    "set_actor_location": set_actor_location,
    "set_actor_target_velocity": set_actor_target_velocity,
    "set_actor_target_angular_velocity": set_actor_target_angular_velocity,
    "add_actor_impulse": add_actor_impulse,
    "add_actor_force": add_actor_force,
    "enable_actor_constant_velocity": enable_actor_constant_velocity,
    "disable_actor_constant_velocity": disable_actor_constant_velocity,
    "set_actor_simulate_physics": set_actor_simulate_physics,
    "set_actor_collisions": set_actor_collisions,
    "set_actor_enable_gravity": _accepted,
    "set_actor_autopilot": _accepted,
    "set_vehicle_light_state": set_vehicle_light_state,
    "get_vehicle_light_state": get_vehicle_light_state,
    "get_vehicle_light_states": get_vehicle_light_states,
    "get_wheel_steer_angle": get_wheel_steer_angle,
    "get_physics_control": get_physics_control,
}
"""Each by its name."""
