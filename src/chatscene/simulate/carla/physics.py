"""The bodies of one scene in a CARLA server: what is asked of them goes there, where they are comes back.

A step is one batch of controls, one tick and one snapshot.
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import carla  # pyright: ignore[reportMissingTypeStubs]

from chatscene.errors import ServerError
from chatscene.simulate.carla.blueprints import blueprint_of
from chatscene.simulate.carla.connection import Connection, Measured
from chatscene.simulate.carla.frames import direction, transform, turned
from chatscene.simulate.contact import touch
from chatscene.simulate.physics import CannotPlace
from chatscene.terms.actors import LIMITS, one_of_class
from chatscene.world.bodies import Body, Placement, Vehicle, Walker, body_of
from chatscene.world.control import pedals

CLEARANCE = 0.5  # [m] above the road that vehicles and walkers begin at; lower, CARLA finds the road in their way
SETTLED = 0.05  # [m/s], vertical, of who has come to rest on it
SETTLING = 20  # ticks allowed for that
HEARING = 0.2  # [s] until the wheel hears a new sensor, and until it has passed on what one told of a step
VIEW_HEIGHT = 60.0  # [m], of the spectator above the ego
_STATES = {"g": carla.TrafficLightState.Green, "y": carla.TrafficLightState.Yellow, "r": carla.TrafficLightState.Red}
_HELD = carla.VehicleControl(hand_brake=True, manual_gear_shift=True, gear=1)


def size_as_placed(placement: Placement, measured: Measured) -> tuple[float, float]:
    """Length and width [m] of a blueprint in a thing's place: what stands is turned so that its longer side fits."""
    length, width = measured.length, measured.width
    turns = placement.kind not in LIMITS and (length - width) * (placement.length - placement.width) < 0.0
    return (width, length) if turns else (length, width)


@dataclass(slots=True)
class _Actor:
    """A body and the actor that it is in CARLA.

    Attributes:
        steering: What a full turn of our wheel is of its own.
        vx, vy: Velocity that a walker was last asked for [m/s].
        new: Whether nothing was asked of it yet.
    """

    handle: Any
    body: Body
    measured: Measured
    kind: str
    steering: float
    vx: float
    vy: float
    new: bool = True

    def command(self, dt: float) -> Any | None:
        """What is asked of it for the next step, as a command of a batch; None of what stands."""
        body, first = self.body, self.new
        self.new = False
        if isinstance(body, Vehicle):
            return carla.command.ApplyVehicleControl(self.handle.id, self._driven(body, first))
        if isinstance(body, Walker):
            return carla.command.ApplyWalkerControl(self.handle.id, self._walked(body, dt))
        return None

    def _driven(self, body: Vehicle, first: bool) -> Any:
        throttle, brake, reverse = body.throttle, body.brake, body.reverse
        if (wish := body.target_speed) is not None:
            reverse = wish < 0.0
            throttle, brake = pedals(-body.speed if reverse else body.speed, abs(wish))
        return carla.VehicleControl(
            throttle=max(0.0, min(1.0, throttle)),
            steer=max(-1.0, min(1.0, max(-1.0, min(1.0, body.steer)) * self.steering)),
            brake=max(0.0, min(1.0, brake)),
            reverse=reverse,
            manual_gear_shift=first,  # CARLA's gearbox would begin in neutral and take half a second
            gear=-1 if reverse else 1,
        )

    def _walked(self, body: Walker, dt: float) -> Any:
        """CARLA's walkers have any speed at once, ours speed up and slow down as legs can."""
        limits = LIMITS[self.kind]
        wish = min(max(body.target_speed, 0.0), limits.top_speed)
        ax, ay = wish * math.cos(body.course) - self.vx, wish * math.sin(body.course) - self.vy
        change = math.hypot(ax, ay)
        most = (limits.throttle if wish >= math.hypot(self.vx, self.vy) else limits.brake) * dt
        share = most / change if change > most else 1.0
        self.vx, self.vy = self.vx + share * ax, self.vy + share * ay
        speed = math.hypot(self.vx, self.vy)
        toward = direction(self.vx / speed, self.vy / speed) if speed else direction(body.cos, body.sin)
        return carla.WalkerControl(toward, speed, False)

    def take(self, state: Any) -> None:
        """Be where a snapshot says."""
        body, measured = self.body, self.measured
        place, velocity = state.get_transform(), state.get_velocity()
        at = place.location
        body.heading = turned(place.rotation.yaw, body.heading)
        body.cos, body.sin = math.cos(body.heading), math.sin(body.heading)
        body.x = at.x + measured.ahead * body.cos - measured.left * body.sin
        body.y = -at.y + measured.ahead * body.sin + measured.left * body.cos
        body.before = body.speed
        if isinstance(body, Walker):
            body.speed = math.hypot(velocity.x, velocity.y)
        else:
            body.speed = velocity.x * body.cos - velocity.y * body.sin


class CarlaPhysics:
    """The bodies of one scene; see `chatscene.simulate.physics.Physics`.

    Args:
        connection: To the server.
        map_path: What the scene lies on.
        dt: Step [s].
        weather: How the world looks; it moves nothing.
        lights: What traffic lights show after so many steps, by their ids in OpenDRIVE.
        told: Is told what CARLA's collision sensor and our boxes say differently of the ego.
        watched: Whether the server's own window looks down on the ego.
        recording: Where the server writes its recorder's file, if anywhere.
    """

    def __init__(
        self,
        connection: Connection,
        map_path: Path,
        dt: float,
        *,
        weather: Any,
        lights: Callable[[int], Mapping[str, str]],
        told: Callable[[str], None],
        watched: bool,
        recording: Path | None,
    ) -> None:
        self._connection = connection
        self._map_path = map_path
        self._dt = dt
        self._weather = weather
        self._shows = lights
        self._shown: dict[str, str] = {}
        self._told = told
        self._watched = watched
        self._recording = recording
        self._world: Any = None
        self._actors: list[_Actor] = []
        self._lights: dict[str, Any] = {}
        self._sensor: Any = None
        self._touched: dict[int, int] = {}
        self._heard: dict[int, str] = {}
        self._steps = 0
        self._frame = 0
        self._ticked = 0.0

    def add(self, placement: Placement) -> Body:
        """Spawn a thing's actor and make its body, which has the size that the actor has.

        Raises:
            CannotPlace: The server has no room for it there.
            ServerError: The server was lost, or refuses.
        """
        connection, kind = self._connection, placement.kind
        if placement.backs:
            raise CannotPlace("an ego that drives backwards is not driven in CARLA yet")
        world = self._world or self._begin()
        name = blueprint_of(placement)
        measured = connection.measured(name)
        length, width = size_as_placed(placement, measured)
        heading = placement.heading + (0.0 if length == measured.length else math.pi / 2)
        body = body_of(replace(placement, length=length, width=width, grip=math.inf))  # its tyres know no weather
        cos, sin = math.cos(heading), math.sin(heading)
        origin = transform(
            placement.x - measured.ahead * cos + measured.left * sin,
            placement.y - measured.ahead * sin - measured.left * cos,
            0.0,
            heading,
        )
        with connection.asking(f"spawn {name}"):
            ground = connection.ground.get_waypoint(origin.location, True, carla.LaneType.Any)
            height = ground.transform.location.z if ground else 0.0
            origin.location.z = height + measured.above + (CLEARANCE if body.moves else 0.0)
            handle = world.try_spawn_actor(connection.blueprint(name), origin)
            if handle is None:
                raise CannotPlace(
                    f"CARLA has no room for {one_of_class(kind)} ({name}) at ({placement.x:.1f}, {placement.y:.1f})"
                )
            if not body.moves:
                handle.set_simulate_physics(False)
        self._actors.append(
            _Actor(
                handle=handle,
                body=body,
                measured=measured,
                kind=kind,
                steering=placement.wheel_angle / measured.wheel_angle if measured.wheel_angle else 1.0,
                vx=placement.speed * body.cos,
                vy=placement.speed * body.sin,
            )
        )
        return body

    def step(self, dt: float) -> None:
        """Go on by a tick.

        Raises:
            ServerError: The server was lost, or somebody else ticks it or took an actor away.
        """
        if self._frame == 0:
            self._settle()
        self._steps += 1
        self._show_lights()
        asked = [actor.command(dt) for actor in self._actors]
        self._carry_out([*(command for command in asked if command is not None), *self._view()])
        snapshot = self._tick()
        for actor in self._actors:
            if actor.body.moves:
                if (state := snapshot.find(actor.handle.id)) is None:
                    raise ServerError(
                        f"{one_of_class(actor.kind)} is gone from the CARLA server at {self._connection.place}: "
                        "another client uses its world"
                    )
                actor.take(state)
        self._feel()

    def close(self) -> None:
        """Take the actors away, and let the world run by itself again."""
        world, self._world = self._world, None
        if world is None or self._connection.lost:
            return
        self._compare()
        sensors = [] if self._sensor is None else [self._sensor]
        with self._connection.asking("stop its sensor and its recorder"):
            for sensor in sensors:
                sensor.stop()
            if self._recording is not None:
                self._connection.client.stop_recorder()
        self._connection.take_away(*(one.id for one in (*sensors, *(actor.handle for actor in self._actors))))
        self._connection.end(world)

    def _begin(self) -> Any:
        connection = self._connection
        self._world = connection.begin(self._map_path, self._dt)
        with connection.asking("change its weather"):
            self._world.set_weather(self._weather)
        if self._recording is not None:
            with connection.asking("record"):
                connection.client.start_recorder(str(self._recording))
        return self._world

    def _settle(self) -> None:
        """Wait until everybody has come down on the road, held by the hand brake, and the sensor is heard."""
        ego, world = self._actors[0], self._world
        with self._connection.asking("make a sensor"):
            every = world.get_actors().filter("traffic.traffic_light*")
            self._lights = {light.get_opendrive_id(): light for light in every}
            sensor = self._connection.blueprint("sensor.other.collision")
            self._sensor = world.spawn_actor(sensor, carla.Transform(), attach_to=ego.handle)
            self._sensor.listen(self._hear)
        listening = time.monotonic()
        moving = [actor for actor in self._actors if actor.body.moves]
        vehicles = [actor for actor in moving if isinstance(actor.body, Vehicle)]
        self._carry_out([carla.command.ApplyVehicleControl(actor.handle.id, _HELD) for actor in vehicles])
        for number in range(SETTLING):
            snapshot = self._tick()
            states = [snapshot.find(actor.handle.id) for actor in moving]
            if number and all(state is None or abs(state.get_velocity().z) < SETTLED for state in states):
                break  # not after the first: nobody falls yet
        rolling = [actor for actor in vehicles if actor.body.speed]
        self._carry_out(
            [
                carla.command.ApplyTargetVelocity(
                    actor.handle.id, direction(actor.body.speed * actor.body.cos, actor.body.speed * actor.body.sin)
                )
                for actor in rolling
            ]
        )
        time.sleep(max(0.0, HEARING - (time.monotonic() - listening)))
        self._heard.clear()  # the fall on the road

    def _show_lights(self) -> None:
        """Let lights show what they show after this step; the wheel has no command of a batch for that."""
        with self._connection.asking("set traffic lights"):
            for name, state in self._shows(self._steps).items():
                if name in self._lights and self._shown.get(name) != state:
                    self._shown[name] = state
                    self._lights[name].set_state(_STATES[state])

    def _view(self) -> list[Any]:
        """The command that puts the spectator above the ego, where that was asked for."""
        if not self._watched:
            return []
        ego = self._actors[0].body
        above = transform(ego.x, ego.y, VIEW_HEIGHT, ego.heading)
        above.rotation.pitch = -90.0
        return [carla.command.ApplyTransform(self._world.get_spectator().id, above)]

    def _carry_out(self, commands: list[Any]) -> None:
        with self._connection.asking("obey controls"):
            for response in self._connection.client.apply_batch_sync(commands):
                if response.error:
                    raise ServerError(f"the CARLA server at {self._connection.place} did not obey: {response.error}")

    def _tick(self) -> Any:
        snapshot = self._connection.tick(self._world)
        if self._frame and snapshot.frame != self._frame + 1:
            raise ServerError(
                f"another client ticks the CARLA server at {self._connection.place}; only one client can use its world"
            )
        self._frame = snapshot.frame
        self._ticked = time.monotonic()
        return snapshot

    # The sensor of collisions, beside our own boxes

    def _hear(self, event: Any) -> None:
        """Called by the wheel, in a thread of its own."""
        self._heard.setdefault(event.other_actor.id, event.other_actor.type_id)

    def _feel(self) -> None:
        ego, *others = self._actors
        for other in others:
            if touch(ego.body, other.body):
                self._touched.setdefault(other.handle.id, self._steps)

    def _compare(self) -> None:
        """Say where the sensor and our boxes differ, once what it told last, perhaps of the last step, has come."""
        time.sleep(max(0.0, HEARING - (time.monotonic() - self._ticked)))
        names = {actor.handle.id: actor.kind for actor in self._actors}
        for number, step in self._touched.items():
            if number not in self._heard:
                self._told(
                    f"the ego's box meets that of {one_of_class(names[number])} at step {step}; CARLA's sensor tells "
                    "of nothing"
                )
        for number, kind in self._heard.items():
            if number not in self._touched:
                met = names.get(number, kind)
                self._told(f"CARLA's sensor tells that the ego meets {one_of_class(met)}; their boxes never do")
