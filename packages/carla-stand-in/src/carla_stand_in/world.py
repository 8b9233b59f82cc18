"""The world of the server: one episode on one map, its actors, and how it goes on by a step."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from carla_stand_in import wire
from carla_stand_in.actors import Actor, BodyActor, LightActor
from carla_stand_in.blueprints import Blueprint, catalogue, definitions
from carla_stand_in.files import Files
from carla_stand_in.lights import Light, Lights
from carla_stand_in.pushing import Pair, hold_back
from carla_stand_in.recorder import Recorder
from carla_stand_in.roads import Found, Roads
from carla_stand_in.wire import Refused
from chatscene.errors import MapError
from chatscene.simulate.contact import touch
from chatscene.simulate.physics import PhysicsOf
from chatscene.terms.nouns import with_article

STEP = 0.05  # [s], where a client names none
SHORTEST, LONGEST = 0.001, 1.0  # [s]
OPENDRIVE = "OpenDriveMap"
FOLDER = "Carla/Maps/"
_MOST_MAPS = 4  # that stay at hand
MOST_ACTORS = 2000  # that clients have at a time
_MOST_ATTRIBUTES, _LONGEST_ATTRIBUTE, _ALL_ATTRIBUTES = 100, 1000, 10_000  # of an actor; in characters
_MOST_GONE = 100_000  # of whom it is known what they were
SENSORS = frozenset(
    {"sensor.camera.rgb", "sensor.camera.semantic_segmentation"}
    | {"sensor.lidar.ray_cast", "sensor.lidar.ray_cast_semantic"}
    | {f"sensor.other.{name}" for name in ("collision", "lane_invasion", "obstacle", "gnss", "imu", "radar")}
)
TAGS = {"vehicle": 14, "walker": 12, "static": 20}  # CARLA's labels of what a pixel or a point shows
SPECTATOR_HEIGHT = 50.0  # [m]
SPEED_LIMIT = 30.0  # [km/h], CARLA's outside its speed signs
GRAVITY = 9.81  # [m/s²]
_STANDS_IN = [["stands_in_for", 4, "CARLA"]]  # by which a client can tell; CARLA's spectator has no attributes
_IMMOVABLE = 1e6  # [kg], of what stands


@dataclass(frozen=True, slots=True)
class Contact:
    """Two actors that touch.

    Attributes:
        one, other: Who.
        impulse: On `one` [N s] in CARLA's frame, if the two stick together.
    """

    one: BodyActor
    other: BodyActor
    impulse: list[float]


class World:
    """Everything that clients share.

    Args:
        maps: Files of the maps that can be loaded, by name.
        first: The map to begin with.
        physics_of: Makes the physics of each body: those of a simulator of ours.
        files: Where files of clients are.

    Attributes:
        on_spawn: Called before an actor without a body joins; may refuse it.
        on_step: Called after each step with the contacts of it.

    Raises:
        MapError: The first map cannot be used.
        MissingExtra: The wheel is not installed.
    """

    def __init__(self, maps: Mapping[str, Path], first: str, physics_of: PhysicsOf, files: Files | None = None) -> None:
        self.maps = dict(maps)
        self.files = files or Files()
        self.on_spawn: Callable[[Actor], None] = lambda _: None
        self.on_step: Callable[[list[Contact]], None] = lambda _: None
        self.recorder = Recorder(self.files)
        self.opendrive = ""
        self.episode = 0
        self.frame = 0
        self.weather = [0.0] * 14
        self.actors: dict[int, Actor] = {}
        self._were: dict[int, Blueprint] = {}
        self._physics_of = physics_of
        self._roads: dict[tuple[str, str], Roads] = {}
        self._next = 1
        self._numbers = {definition[1]: definition[0] for definition in definitions()}
        self.settings = default_settings()
        self.load(first, reset=True)

    # Episodes

    def load(self, name: str, *, reset: bool) -> None:
        """Begin a new episode; an empty name stands for the map that is loaded.

        Raises:
            Refused: There is no such map, or it cannot be used; the old world goes on.
        """
        roads = self.ready(*self.wanted(name))
        self.recorder.stop()
        self.actors.clear()
        self._touching: list[Pair] = []
        self._just_met, self._took = False, STEP
        self.roads = roads
        self._loaded = next(key for key, value in self._roads.items() if value is roads)
        self.episode += 1
        self.time = 0.0
        if reset:
            self.settings = default_settings()
        self.weather = [0.0] * 14
        self.gravity = GRAVITY
        above = [0.0, 0.0, SPECTATOR_HEIGHT]
        self.spectator = self._add(
            Actor(self._next, [*self._own("spectator")[:2], _STANDS_IN], catalogue()["spectator"], above, [0.0] * 3)
        )
        self.lights = Lights(dict(self._raise_lights()))

    def wanted(self, name: str) -> tuple[str, str]:
        """Name and text of a map that a client names; an empty name stands for the one that is loaded.

        Raises:
            Refused: There is no such map.
        """
        short = name.rsplit("/", 1)[-1].removesuffix("_Opt")
        if not short:
            return self._loaded
        if short == OPENDRIVE:
            if not self.opendrive:
                raise Refused("no OpenDRIVE was sent before; call generate_opendrive_world")
            text = self.opendrive
        elif short in self.maps:
            try:
                text = self.maps[short].read_text(encoding="utf-8")
            except (OSError, UnicodeDecodeError) as error:
                raise Refused(f"map {short!r} cannot be read: {error}") from error
        else:
            raise Refused(f"map not found: {name[:100]!r}; this stand-in has {', '.join(sorted(self.maps))}")
        return short, text

    def has_read(self, short: str, text: str) -> bool:
        """Whether a map is at hand."""
        return (short, text) in self._roads

    def ready(self, short: str, text: str, found: Found | None = None) -> Roads:
        """A map, read now unless it is at hand.

        Args:
            short: Its name.
            text: OpenDRIVE.
            found: What was found in it before.

        Raises:
            Refused: It cannot be used.
        """
        try:
            roads = self._roads.pop((short, text), None) or Roads(f"{FOLDER}{short}", text, found)
        except MapError as error:
            raise Refused(str(error)) from error
        self._roads[short, text] = roads  # the last, of those that were used
        for old in list(self._roads)[:-_MOST_MAPS]:
            del self._roads[old]
        return roads

    def _raise_lights(self) -> Iterator[tuple[int, Light]]:
        blueprint = catalogue()["traffic.traffic_light"]
        for signal in self.roads.signals:
            actor = self._add(LightActor(self._next, self._own(blueprint.id), blueprint, signal))
            yield actor.id, Light(signal)

    # Actors

    def spawn(self, description: Any, place: Any, parent: int = 0) -> Actor:
        """Make an actor.

        Raises:
            Refused: There is no such blueprint or parent, or something is in its place.
        """
        if len(self.actors) - len(self.lights.by_actor) > MOST_ACTORS:
            raise Refused(f"this stand-in has {MOST_ACTORS} actors at most; destroy some")
        described = self._described(description)
        blueprint = catalogue()[described[1]]
        if blueprint.group == "sensor" and blueprint.id not in SENSORS:
            raise Refused(f"this stand-in for CARLA does not support {blueprint.id}")
        location, rotation = wire.transform(place)
        attached = self.actor(parent) if parent else None
        if blueprint.solid:
            body = BodyActor(self._next, described, blueprint, location, rotation, self._physics_of)
            if body.moving and any(overlap(body, other) for other in self.bodies() if other.touchable):
                raise Refused("Spawn failed because of collision at spawn position")
            return self._add(body)
        actor = Actor(self._next, described, blueprint, location, rotation, attached)
        self.on_spawn(actor)
        return self._add(actor)

    def destroy(self, number: int) -> bool:
        """Take an actor and what is attached to it away; whether there was one."""
        if number not in self.actors:
            return False
        gone = {number}
        for other in self.actors.values():  # whoever is attached came later
            if other.parent is not None and other.parent.id in gone:
                gone.add(other.id)
        for other in gone:
            del self.actors[other]
        return True

    def actor(self, number: Any) -> Actor:
        """An actor that is alive.

        Raises:
            Refused: There is none of that id.
        """
        found = self.actors.get(number) if isinstance(number, int) else None
        if found is None:
            raise Refused(f"actor not found: {number!r}"[:100])
        return found

    def body(self, number: Any, *groups: str) -> BodyActor:
        """A vehicle, walker or thing that is alive.

        Raises:
            Refused: There is none of that id, or it is of no such group.
        """
        found = self.actor(number)
        if not isinstance(found, BodyActor) or (groups and found.blueprint.group not in groups):
            raise Refused(f"actor {number} is {with_article(found.blueprint.id)}, no {' or '.join(groups) or 'body'}")
        return found

    def was(self, number: Any) -> Blueprint | None:
        """What an actor is, or was before it died; None if there never was one of that id."""
        return self._were.get(number) if isinstance(number, int) else None

    def bodies(self) -> list[BodyActor]:
        """All actors with a body, in the order of their ids."""
        return [actor for actor in self.actors.values() if isinstance(actor, BodyActor)]

    def _add(self, actor: Any) -> Any:
        self.actors[actor.id] = actor
        self._were[actor.id] = actor.blueprint
        if len(self._were) > MOST_ACTORS + _MOST_GONE:
            self._were = {
                number: blueprint
                for number, blueprint in self._were.items()
                if number in self.actors or number > actor.id - _MOST_GONE // 2
            }
        self._next += 1
        return actor

    def _own(self, blueprint: str) -> list[Any]:
        return [self._numbers[blueprint], blueprint, []]

    def _described(self, description: Any) -> list[Any]:
        try:
            _, name, attributes = description
            wanted = [(wire.text(key), wire.whole(kind), wire.text(value)) for key, kind, value in attributes]
        except (TypeError, ValueError) as error:
            raise Refused("an actor's description is needed") from error
        lengths = [len(key) + len(value) for key, _, value in wanted]
        if (
            len(wanted) > _MOST_ATTRIBUTES
            or max(lengths, default=0) > _LONGEST_ATTRIBUTE
            or sum(lengths) > _ALL_ATTRIBUTES
        ):
            raise Refused(
                f"an actor has at most {_MOST_ATTRIBUTES} attributes, each of {_LONGEST_ATTRIBUTE} characters and all "
                f"together of {_ALL_ATTRIBUTES}"
            )
        if not isinstance(name, str) or name not in catalogue():
            raise Refused(f"there is no blueprint {name!r}"[:100])
        return [self._numbers[name], name, [list(one) for one in wanted]]

    # Time

    @property
    def synchronous(self) -> bool:
        """Whether the world waits for a client's tick."""
        return bool(self.settings[0])

    @property
    def dt(self) -> float:
        """The step [s]."""
        fixed = self.settings[2]
        return fixed[1] if fixed[0] else STEP

    def step(self) -> int:
        """Go on by one step; gives its number."""
        dt = self.dt
        self.frame += 1
        self.time += dt
        self.lights.step(dt)
        bodies = self.bodies()
        met = self._move(bodies, dt)
        for actor in self.actors.values():
            actor.follow()
        for actor in bodies:
            if actor.blueprint.group == "vehicle":
                reach, body = actor.blueprint.extent[0], actor.body
                front = (actor.location[0] + reach * body.cos, actor.location[1] - reach * body.sin)
                actor.light = self.lights.waits_at(*front, actor.rotation[1])
        self.recorder.write(self.time, self.actors, self.lights.by_actor, self.lights.frozen, self._touching)
        self.on_step(met)
        return self.frame

    def _move(self, bodies: list[BodyActor], dt: float) -> list[Contact]:
        """Move everybody by `dt` [s], nobody through anybody; gives who touches whom."""
        if self._just_met:
            hold_back(bodies, None, self._took)
        for actor in bodies:
            actor.step(dt, self.roads)
        met = {(contact.one.id, contact.other.id): contact for contact in contacts(bodies)}
        if hold_back(bodies, self._touching, dt):  # who touches nobody now may have pushed, or jumped
            met |= {
                pair: contact for contact in contacts(bodies) if (pair := (contact.one.id, contact.other.id)) not in met
            }
        self._just_met, self._took = bool(met.keys() - self._touching), dt
        self._touching = sorted(met)
        return [met[pair] for pair in self._touching]


def contacts(bodies: list[BodyActor]) -> list[Contact]:
    """Who touches whom; two things that stand do not count."""
    found: list[Contact] = []
    ordered = sorted((b for b in bodies if b.touchable), key=lambda actor: actor.body.x - actor.body.radius)
    for i, one in enumerate(ordered):
        end = one.body.x + one.body.radius
        for j in range(i + 1, len(ordered)):
            other = ordered[j]
            if other.body.x - other.body.radius > end:
                break
            if (one.body.moves or other.body.moves) and overlap(one, other):
                a, b = sorted((one, other), key=lambda actor: actor.id)
                found.append(Contact(a, b, _impulse(a, b)))
    return sorted(found, key=lambda contact: (contact.one.id, contact.other.id))


def overlap(a: BodyActor, b: BodyActor) -> bool:
    """Whether two boxes overlap, in height, too."""
    return a.level_with(b) and touch(a.body, b.body)


def _impulse(a: BodyActor, b: BodyActor) -> list[float]:
    """On `a` [N s], if the two go on together."""
    one, other = (actor.blueprint.mass or _IMMOVABLE for actor in (a, b))
    both = one * other / (one + other)
    p, q = a.body, b.body
    return [both * (q.before * q.cos - p.before * p.cos), -both * (q.before * q.sin - p.before * p.sin), 0.0]


def default_settings() -> list[Any]:
    """An episode's settings as they go over the wire, asynchronous as CARLA's."""
    return [False, False, [False], True, 0.01, 10, 0.0, True, 3000.0, 2000.0, True]


def checked_settings(value: Any) -> list[Any]:
    """Settings out of a message; the step is what counts here, the rest is kept.

    Raises:
        Refused: They are none, or the step is not between 1 ms and 1 s.
    """
    if not isinstance(value, list) or len(value) < 3 or not isinstance(value[2], list) or not value[2]:
        raise Refused("an episode's settings are needed")
    kept = default_settings()
    for place, given in enumerate(value[: len(kept)]):
        if place != 2:
            kept[place] = type(kept[place])(wire.number(given))
    if value[2][0]:
        dt = wire.number(value[2][1]) if len(value[2]) > 1 else 0.0
        if dt and not SHORTEST <= dt <= LONGEST:
            raise Refused(f"fixed_delta_seconds is {dt:g} s; this stand-in steps {SHORTEST:g} to {LONGEST:g} s")
        kept[2] = [True, dt] if dt else [False]
    return kept
