"""The recorder: a file of what happened, which is at once the text that clients are told of it.

CARLA writes a form of its own and tells a text of it. Here the file is that text but for its last two lines, in the
order and words that readers of it (ScenarioRunner's metrics) look for; so CARLA cannot replay it. Lengths and places
are in centimetres, velocities in m/s and degrees/s.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import BinaryIO

from carla_stand_in.actors import Actor, BodyActor
from carla_stand_in.files import Files
from carla_stand_in.lights import Light
from carla_stand_in.wire import Refused

SUFFIX = ".log"
_HEAD = "Version: 1\n"
_MOST = 64 * 2**20  # bytes of a recording that is told of
_MOST_WRITTEN = 4 * 2**30  # bytes of all recordings of a server
_KINDS = {"vehicle": 1, "walker": 2, "traffic": 3}
_LETTERS = {"vehicle": "v", "walker": "w", "traffic": "t"}
_LAMPS = (
    "Position", "LowBeam", "HighBeam", "Brake", "RightBlinker", "LeftBlinker",
    "Reverse", "Fog", "Interior", "Special1", "Special2",
)  # fmt: skip
_ANY = "a"
_HERO = " (hero)"
_Place = tuple[float, float]


class Recorder:
    """What is written of an episode, step by step, while a client wants it.

    Args:
        files: Where.
        most: Bytes that it writes in all; the recording that would have more ends.
    """

    def __init__(self, files: Files, most: int = _MOST_WRITTEN) -> None:
        self._files = files
        self._left = most
        self._to: BinaryIO | None = None
        self._fault = ""

    def start(self, name: str, town: str) -> str:
        """Begin a file, in place of an older recording; gives its path.

        Args:
            name: Its name; it has to end in `.log`.
            town: The map's name.

        Raises:
            Refused: It cannot be written, or something else is in its place.
        """
        self.stop()
        self._to = self._files.write(_checked(name), _HEAD.encode())
        self._frames, self._began, self._known, self._met = 0, None, dict[int, Actor](), set[tuple[int, int]]()
        # No date of the clock, so that the same calls give the same file.
        self._write(f"{_HEAD}Map: {town}\nDate: 01/01/70 00:00:00\n\n")
        return str(self._files.path(name))

    def stop(self) -> None:
        """End the file, if one is open.

        Raises:
            Refused: It could not be written to its end.
        """
        if self._to is not None:
            try:
                self._to.close()
            except OSError as error:
                self._fault = error.strerror or str(error)
            self._to = None
        fault, self._fault = self._fault, ""
        if fault:
            raise Refused(f"the recording ended early: {fault}")

    def write(
        self,
        time: float,
        actors: Mapping[int, Actor],
        lights: Mapping[int, Light],
        frozen: bool,
        met: Sequence[tuple[int, int]],
    ) -> None:
        """Write a step, if a file is open.

        Args:
            time: Simulated [s].
            actors: All, by id.
            lights: The traffic lights, by id.
            frozen: Whether they are.
            met: Who touches whom; it is written where it begins.
        """
        if self._to is None:
            return
        self._frames += 1
        self._began = time if self._began is None else self._began
        kept = {
            number: actor for number, actor in actors.items() if actor.blueprint.group not in ("sensor", "controller")
        }
        lines = [f"Frame {self._frames} at {time - self._began:.6g} seconds"]
        lines += self._changes(kept, met)
        lines += _poses(kept)
        lines += _lights(lights, frozen)
        lines += _conduct([actor for actor in kept.values() if isinstance(actor, BodyActor)])
        lines.append(f" Current platform time: {time:.6g}")
        self._write("\n".join(lines) + "\n\n")

    def _write(self, text: str) -> None:
        """Write on; what cannot be written ends the file, and is told with its end."""
        assert self._to is not None
        content = text.encode(errors="replace")
        self._left -= len(content)
        try:
            if self._left >= 0:
                self._to.write(content)
                return
            self._to.close()
            self._fault = f"recordings of this server have no more room, {_MOST_WRITTEN // 2**30} GiB in all"
        except OSError as error:
            self._fault = error.strerror or str(error)
        self._to = None

    def _changes(self, actors: Mapping[int, Actor], met: Sequence[tuple[int, int]]) -> Iterator[str]:
        for number, actor in actors.items():
            if number not in self._known:
                kind = _KINDS.get(actor.blueprint.group, 0)
                yield f" Create {number}: {actor.blueprint.id} ({kind}) at {_place(actor)}"
                yield from (f"  {key} = {_one_line(value)}" for key, value in actor.attributes.items())
        yield from (f" Destroy {number}" for number in self._known if number not in actors)
        fresh = [pair for pair in met if pair not in self._met]
        yield from (f" Collision id {i} between {one} with {other}" for i, (one, other) in enumerate(fresh))
        for number, actor in actors.items():
            if number not in self._known and actor.parent is not None:
                yield f" Parenting {number} with {actor.parent.id} (parent)"
        self._known, self._met = dict(actors), set(met)


def _place(actor: Actor) -> str:
    return _vector([100 * part for part in actor.location])


def _vector(parts: Sequence[float]) -> str:
    return "({})".format(", ".join(f"{part:.8g}" for part in parts))


def _one_line(text: str) -> str:
    return " ".join(text.split()).replace("Frame", "frame")


def _poses(actors: Mapping[int, Actor]) -> Iterator[str]:
    yield f" Positions: {len(actors)}"
    for number, actor in actors.items():
        pitch, yaw, roll = actor.rotation
        yield f"  Id: {number} Location: {_place(actor)} Rotation: {_vector([roll, pitch, yaw])}"


def _lights(lights: Mapping[int, Light], frozen: bool) -> Iterator[str]:
    if lights:
        yield f" State traffic lights: {len(lights)}"
        for number, light in lights.items():
            yield f"  Id: {number} state: {light.state} frozen: {int(frozen)} elapsedTime: {light.elapsed:.6g}"


def _conduct(bodies: list[BodyActor]) -> Iterator[str]:
    """Pedals, lamps and speeds."""
    vehicles = [body for body in bodies if body.blueprint.group == "vehicle"]
    walkers = [body for body in bodies if body.blueprint.group == "walker"]
    if vehicles:
        yield f" Vehicle animations: {len(vehicles)}"
    for body in vehicles:
        throttle, steer, brake, hand_brake, reverse, _, gear = body.control
        gear = -1 if reverse else gear
        yield (
            f"  Id: {body.id} Steering: {steer:.6g} Throttle: {throttle:.6g} Brake: {brake:.6g}"
            f" Handbrake: {int(hand_brake)} Gear: {gear}"
        )
    if walkers:
        yield f" Walker animations: {len(walkers)}"
    yield from (f"  Id: {body.id} speed: {body.body.speed:.6g}" for body in walkers)
    if vehicles:
        yield f" Vehicle light animations: {len(vehicles)}"
    for body in vehicles:
        on = [lamp for bit, lamp in enumerate(_LAMPS) if body.lights_on >> bit & 1]
        yield f"  Id: {body.id} {' '.join(on or ['None'])}"
    if bodies:
        yield f" Dynamic actors: {len(bodies)}"
    for body in bodies:
        turning = _vector([0.0, 0.0, body.turning])
        yield f"  Id: {body.id} linear_velocity: {_vector(body.velocity)} angular_velocity: {turning}"
    if bodies:
        yield f" Actor bounding boxes: {len(bodies)}"
    for body in bodies:
        origin, extent = (
            _vector([0.0, 0.0, 100 * body.blueprint.lifted]),
            _vector([100 * half for half in body.blueprint.extent]),
        )
        yield f"  Id: {body.id} origin: {origin} extension: {extent}"


# What is told of a recording


@dataclass(frozen=True, slots=True)
class _Recording:
    """A file that was read.

    Attributes:
        head: Its first lines.
        frames: Time [s] and lines of each step.
    """

    head: str
    frames: list[tuple[float, list[str]]]

    @property
    def tail(self) -> str:
        """How many steps, and how long."""
        return f"\nFrames: {len(self.frames)}\nDuration: {self.frames[-1][0] if self.frames else 0.0:.6g} seconds\n"

    @property
    def types(self) -> dict[int, str]:
        """The blueprints of everybody, by id; a hero's with a mark."""
        found: dict[int, str] = {}
        number = 0
        for _, lines in self.frames:
            for line in lines:
                if created := re.match(r" Create (\d+): (\S+)", line):
                    number = int(created[1])
                    found[number] = created[2]
                elif line == "  role_name = hero" and number:
                    found[number] += _HERO
        return found


def told(files: Files, name: str, every: bool) -> str:
    """All of a recording, or only those steps in which actors come, go, or meet.

    Raises:
        Refused: There is no such recording.
    """
    recording = _read(files, name)
    shown: list[str] = []
    for _, lines in recording.frames:
        kept = lines if every else _happened(lines)
        if every or len(kept) > 1:
            shown += [*kept, ""]
    return recording.head + "\n".join(shown) + recording.tail


def collisions(files: Files, name: str, one: str, other: str) -> str:
    """Who met whom, and when.

    Args:
        files: Where recordings are.
        name: Of the recording.
        one: h for heroes, v for vehicles, w for walkers, t for traffic lights, o for others, a for any.
        other: The same.

    Raises:
        Refused: There is no such recording.
    """
    recording = _read(files, name)
    types = recording.types
    rows = [f"{'Time':>8}  Types {'Id':>6} {'Actor 1':36}{'Id':>6} Actor 2"]
    for time, lines in recording.frames:
        for line in lines:
            if met := re.match(r" Collision id \d+ between (\d+) with (\d+)", line):
                pair = [(number, types[number]) for number in (int(met[1]), int(met[2]))]
                if _fits(one, pair[0][1]) and _fits(other, pair[1][1]):
                    letters = " ".join(_letter(blueprint) for _, blueprint in pair)
                    rows.append(f"{time:8.2f}  {letters}   " + "".join(f"{i:6} {name:36}" for i, name in pair).rstrip())
    return recording.head + "\n".join(rows) + "\n" + recording.tail


def blocked(files: Files, name: str, least: float, within: float) -> str:
    """Which vehicles stayed about where they were, and for how long, the longest first.

    Args:
        files: Where recordings are.
        name: Of the recording.
        least: How long at least [s].
        within: How far they may have gone [cm].

    Raises:
        Refused: There is no such recording.
    """
    recording = _read(files, name)
    types = recording.types
    since: dict[int, tuple[float, _Place]] = {}
    found: list[tuple[float, float, int]] = []
    now = 0.0
    for now, lines in recording.frames:
        here = {number: at for number, at in _places(lines) if types[number].startswith("vehicle.")}
        for number, (began, stood) in list(since.items()):
            if number not in here or math.dist(stood, here[number]) > within:
                found.append((now - began, began, number))
                del since[number]
        for number, at in here.items():
            since.setdefault(number, (now, at))
    found += [(now - began, began, number) for number, (began, _) in since.items()]
    rows = [f"{'Time':>8} {'Id':>6} {'Actor':36}{'Duration':>10}"]
    rows += [
        f"{began:8.2f} {number:6} {types[number]:36}{long:10.2f}"
        for long, began, number in sorted(found, key=lambda row: (-row[0], row[1], row[2]))
        if long >= least
    ]
    return recording.head + "\n".join(rows) + "\n" + recording.tail


def _places(lines: list[str]) -> Iterator[tuple[int, _Place]]:
    """Where everybody is [cm], by id."""
    for line in lines:
        if at := re.match(r"  Id: (\d+) Location: \((\S+), (\S+), ", line):
            yield int(at[1]), (float(at[2]), float(at[3]))


def _letter(blueprint: str) -> str:
    return "h" if blueprint.endswith(_HERO) else _LETTERS.get(blueprint.split(".", 1)[0], "o")


def _fits(wanted: str, blueprint: str) -> bool:
    letter = _letter(blueprint)
    return wanted in (_ANY, letter) or (wanted == "v" and letter == "h")


def _happened(lines: list[str]) -> list[str]:
    told = re.compile(r" (Create|Destroy|Collision|Parenting) |  \w+ = ")
    return [lines[0], *(line for line in lines[1:] if told.match(line))]


def _checked(name: str) -> str:
    if not name.endswith(SUFFIX):
        raise Refused(f"a recording is a file whose name ends in {SUFFIX}, not {name[:100]!r}")
    return name


def _read(files: Files, name: str) -> _Recording:
    content = files.read(_checked(name), _HEAD.encode(), _MOST)
    try:
        text = content.decode()
    except UnicodeDecodeError as error:
        raise Refused(f"{files.path(name)} cannot be read: {error}") from error
    head, *parts = re.split(r"^Frame ", text, flags=re.MULTILINE)
    frames: list[tuple[float, list[str]]] = []
    for part in parts:
        lines = f"Frame {part}".rstrip("\n").split("\n")
        if at := re.match(r"Frame \d+ at (\S+) seconds", lines[0]):
            frames.append((float(at[1]), lines))
    return _Recording(head, frames)
