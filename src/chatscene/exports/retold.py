"""A scene of packaged snippets as a storyboard: its program is placed again, and its plans are said in plain words.

What cannot be said is refused by name. Where somebody starts changes with each parameter in proportion, or the scene is
refused: it is placed at both ends of each range, one after the other, and at all upper ends together.
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import combinations
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np
import shapely
from scenic.core.object_types import Object

from chatscene.errors import RunError, SnippetError
from chatscene.exports.exporter import KeptScene
from chatscene.exports.plain_numbers import Site, Unsayable
from chatscene.exports.plain_plan import Plain, plainly
from chatscene.maps.left_hand import keeps_left
from chatscene.maps.network import load_network
from chatscene.program.without import placings
from chatscene.simulate.native.code import Compiler, NotCovered, Surrounding
from chatscene.simulate.staging import Stage
from chatscene.terms.actors import BY_CLASS, Manner
from chatscene.terms.episode import Role, Track
from chatscene.terms.mirroring import mirrored_drive
from chatscene.terms.pace import Pace, limits_in
from chatscene.terms.plan import Expression, Parameter, Plan, expressions_of, walk
from chatscene.terms.plan_text import BEHAVIOR, parse_plan
from chatscene.terms.polyline import Polyline
from chatscene.terms.scene import Rejected, Scene, ScenicProgram
from chatscene.terms.storyboard import EGO_ROUTE, THING, Actor, Start, Storyboard
from chatscene.terms.sums import Sum, number, product, valued
from chatscene.world.places import line_of

_OWN = 60.0  # [m] either way, of a line that nobody follows
BEFORE, BEYOND = 10.0, 40.0  # [m], by which the lines of others are longer than ours
_ASTRAY = 0.05  # [m] that a start may be off from what its parameters say
_TURNED = 0.02  # [rad]
_THIN = 1e-3  # [m]
_BESIDE = 30.0  # [m] of its route in which a line keeps the number of its lane
_BEHAVES = re.compile(r"with behavior (\w+\(.*?\))(?=,\s*with\b|,?\s*$)", re.DOTALL)
_PARAM = re.compile(r"^param [^\n]*", re.MULTILINE)
_DEFINED = re.compile(r"^behavior (\w+)\(\):[^\n]*\n((?:[ \t]+[^\n]*\n|[ \t]*\n)+)", re.MULTILINE)


def retold(scene: KeptScene) -> Storyboard:
    """A scene as a storyboard.

    Raises:
        RunError: It cannot be said, or it is no scene of packaged snippets; the message names what.
    """
    program = scene.joined()
    with TemporaryDirectory() as folder:
        path = Path(folder) / scene.map.name
        path.write_bytes(scene.map.content)
        if keeps_left(path):
            scene = replace(scene, episode=mirrored_drive(scene.episode))
        try:
            return _Retelling(scene, program, path).storyboard()
        except (Unsayable, NotCovered) as reason:
            raise RunError(
                f"scene {scene.episode.scene_id!r} cannot be told again in OpenSCENARIO: {reason}; export what was "
                "driven: --to openscenario"
            ) from reason


@dataclass(frozen=True, slots=True)
class _Placed:
    """Everybody where he starts, by the values of parameters: x, y [m], heading [rad]."""

    values: Mapping[str, float]
    poses: Sequence[tuple[float, float, float]]


class _Retelling:
    def __init__(self, scene: KeptScene, program: ScenicProgram, path: Path) -> None:
        self._scene, self._program, self._stage = scene, program, Stage(path)
        self._network = load_network(path)
        self._ranges = {one.name: one for one in program.parameters}
        placed = self._place(scene.values)
        self._objects: list[Any] = list(placed.objects)
        self._params: Mapping[str, Any] = placed.params
        self._names: Mapping[str, Any] = {}
        own = {found[1] for found in _DEFINED.finditer(program.source)}
        for thing in self._objects:
            if type(thing.behavior).__name__ in own:
                self._names = type(thing.behavior).makeGenerator.__globals__
        self._ego_line = line_of(self._objects[0].route)
        self._base = _Placed(scene.values, _poses(placed))
        self._texts: list[str] = []
        self._ends: dict[str, tuple[_Placed, _Placed]] = {}
        self._pairs: dict[tuple[str, str], _Placed] = {}  # everybody with both at the upper ends of their ranges

    def storyboard(self) -> Storyboard:
        unsaid: list[str] = []
        plans, why = self._plans()
        read = {p for plan in plans if plan for p in _parameters(plan)}
        placing = _PARAM.sub("", _DEFINED.sub("", self._program.source))
        named = {name for name in self._scene.values if re.search(rf"\b{name}\b", placing)}
        try:
            self._ends = self._at_ends(sorted((set(self._scene.values) - read) | named))
        except Unsayable as reason:
            unsaid.append(f"everybody starts where they do in this scene, as {reason}")
        tracks = [self._track(pose) for pose in self._base.poses]
        lines: dict[str, Polyline] = {EGO_ROUTE: _thinned(self._ego_line)}
        lanes: dict[str, int] = {}
        actors: list[Actor] = []
        for index, (plan, track) in enumerate(zip(plans, tracks, strict=True)):
            try:
                plain = self._told(index, plan, track, why)
                name, line = self._way(index, track, plain)
                actor = self._actor(index, track, plain, name, line)
            except (Unsayable, NotCovered) as reason:
                unsaid.append(f"{track.actor} goes as it was driven, as {str(reason).removeprefix(f'{track.actor}, ')}")
                plain, (name, line) = None, self._own_way(index, track)
                actor = self._led(index, track, name, line)
            if plain:
                lines |= plain.lines
                lanes |= plain.lanes
                unsaid += [f"{track.actor} {one}" for one in plain.unsaid]
            lines.setdefault(name, line)
            actors.append(actor)
        order = {Role.EGO: 0, Role.ADVERSARY: 1}
        ranked = sorted(zip(actors, tracks, strict=True), key=lambda pair: order.get(pair[1].role, 2))
        return Storyboard(
            actors=tuple(actor for actor, _ in ranked),
            lines=lines,
            lanes=lanes,
            parameters=tuple(replace(one, meaning="") for one in self._program.parameters),
            values=dict(self._scene.values),
            surroundings=self._scene.episode.surroundings,
            unsaid=tuple(dict.fromkeys(unsaid)),
            mirrored=bool(self._network.mirrored),
        )

    def _place(self, values: Mapping[str, float]) -> Any:
        one = Scene(
            id=self._scene.episode.scene_id,
            scenario_id=self._program.scenario_id,
            route=self._scene.route,
            block=0,
            seed=0,
            values=dict(values),
        )
        placed = self._stage.place(self._program, one)
        if isinstance(placed, Rejected):
            raise Unsayable(f"with other values of its parameters there is no such scene ({placed.reason})")
        return placed

    def _told(self, index: int, plan: Plan | None, track: Track, why: Mapping[int, str]) -> Plain | None:
        """What somebody does in plain words; None of the ego and of what stands."""
        if index in why:
            raise Unsayable(why[index])
        return None if plan is None else self._plainly(plan, index, track)

    def _plans(self) -> tuple[list[Plan | None], dict[int, str]]:
        """What each does, in the order of the objects, and why that is not known of some."""
        count = len(self._objects)
        try:
            self._texts = self._said()
        except Unsayable as reason:
            return [None] * count, {index: str(reason) for index in range(1, count)}
        plans: list[Plan | None] = []
        why: dict[int, str] = {}
        for index in range(count):
            try:
                plans.append(self._plan(index))
            except Unsayable as reason:
                plans.append(None)
                why[index] = str(reason)
        return plans, why

    def _said(self) -> list[str]:
        """The text that places each thing, in the order of the objects."""
        rows = self._program.source.splitlines()
        texts = ["\n".join(rows[one.first : one.last + 1]) for one in placings(self._program)]
        if len(texts) != len(self._objects) - 1 or any(text[0] in " \t" for text in texts):
            raise Unsayable("several are placed by one line of its program")
        return ["", *texts]

    def _plan(self, index: int) -> Plan | None:
        """What somebody does; None of the ego and of what stands."""
        if index == 0 or self._objects[index].behavior is None:
            return None
        found = _BEHAVES.search(self._texts[index])
        if found is None:
            raise Unsayable(f"what {self._texts[index]!r} does is not told there")
        does = found[1]
        defined = dict(_DEFINED.findall(self._program.source))
        body = defined.get(does.partition("(")[0], f"    do {does}\n")
        try:
            return parse_plan(f"behavior {BEHAVIOR}():\n{body}")
        except SnippetError as error:
            raise Unsayable(f"{does.partition('(')[0]} is not a plan: {error}") from error

    def _at_ends(self, names: Sequence[str]) -> dict[str, tuple[_Placed, _Placed]]:
        """Everybody with each parameter at the ends of its range; under an empty name, with all at the upper end.

        Keeps everybody with each two at their upper ends as well, where both are not there already.
        """
        found: dict[str, tuple[_Placed, _Placed]] = {}
        for name in names:
            ends = [{**self._scene.values, name: end} for end in (self._ranges[name].low, self._ranges[name].high)]
            low, high = (_Placed(values, _poses(self._place(values))) for values in ends)
            found[name] = low, high
        rising = [name for name in names if self._ranges[name].high > self._scene.values[name]]
        self._pairs = {pair: self._at_upper_ends(pair) for pair in combinations(rising, 2)}
        if len(names) > 1:
            both = self._pairs.get((names[0], names[1])) if len(names) == 2 else None
            all_high = both or self._at_upper_ends(names)
            found[""] = all_high, all_high
        return found

    def _at_upper_ends(self, names: Sequence[str]) -> _Placed:
        values = {**self._scene.values, **{name: self._ranges[name].high for name in names}}
        return _Placed(values, _poses(self._place(values)))

    def _start_on(self, index: int, line: Polyline) -> tuple[Sum, Sum, float]:
        """Where somebody starts on a line: along and to the left [m], and its turn [rad]."""

        def on(placed: _Placed) -> tuple[float, float, float]:
            x, y, heading = placed.poses[index]
            along, left, _ = line.project(x, y)
            return along, left, math.remainder(heading - line.heading_at(along), math.tau)

        base = on(self._base)
        sums = [number(base[0]), number(base[1])]
        for name, (low, high) in self._ends.items():
            if not name or self._ranges[name].high == self._ranges[name].low:
                continue
            width = self._ranges[name].high - self._ranges[name].low
            for axis in range(2):
                slope = (on(high)[axis] - on(low)[axis]) / width
                slope = float(round(slope)) if abs(slope - round(slope)) * width < _ASTRAY else slope
                if slope:
                    own = Sum(-slope * self._scene.values[name], ((slope, Parameter(name)),))
                    sums[axis] = sums[axis] + own
        for pair, placed in self._pairs.items():
            more = [on(placed)[axis] - valued(sums[axis].expression, placed.values) for axis in range(2)]
            sums = [
                at + self._together(*pair, far) if abs(far) > _ASTRAY else at
                for at, far in zip(sums, more, strict=True)
            ]
        sums = [self._without_dust(one) for one in sums]
        for name, placed in ((n, p) for n, pair in self._ends.items() for p in pair):
            now = on(placed)
            away = max(abs(valued(sums[i].expression, placed.values) - now[i]) for i in range(2))
            if away > _ASTRAY or abs(math.remainder(now[2] - base[2], math.tau)) > _TURNED:
                what = name or "its parameters"
                raise Unsayable(f"where the {self._kind(index)} starts does not change with {what} in proportion")
        if not 0.0 < base[0] < line.length and abs(base[1]) > 1.0:
            raise Unsayable("somebody starts beyond the end of a line")
        return sums[0], sums[1], base[2]

    def _without_dust(self, one: Sum) -> Sum:
        """A sum without what a parameter changes by less than a millimetre all over its range."""
        kept: list[tuple[float, Expression]] = []
        constant = one.constant
        for factor, term in one.terms:
            if isinstance(term, Parameter):
                parameter = self._ranges[term.name]
                if abs(factor) * (parameter.high - parameter.low) < _THIN:
                    constant += factor * (parameter.high + parameter.low) / 2
                    continue
            kept.append((factor, term))
        return number(constant) + Sum(0.0, tuple(kept))

    def _together(self, one: str, other: str, more: float) -> Sum:
        """What two parameters change only together, by how much that is [m] where both are at their upper ends."""
        now, its = self._scene.values[one], self._scene.values[other]
        area = (self._ranges[one].high - now) * (self._ranges[other].high - its)
        factor = more / area
        factor = float(round(factor)) if abs(factor - round(factor)) * area < _ASTRAY else factor
        first, second = (Sum(0.0, ((1.0, Parameter(name)),)) for name in (one, other))
        away = product(first, second) + first.times(-its) + second.times(-now) + number(now * its)
        return away.times(factor)

    def _site(self, index: int, track: Track) -> Site:
        compiler = Compiler(
            [], [], Surrounding(names=self._names, parameters=self._params, objects=self._objects, self_index=index)
        )
        known: dict[Expression, Any] = {}

        def value(expression: Expression) -> Any:
            if expression not in known:
                found = compiler.value(expression)
                known[expression] = found if isinstance(found, float | int | str | bool) else line_of(found)
            return known[expression]

        kind = BY_CLASS.get(track.kind)
        if kind is None:  # as a door, which is a thing and moves
            raise Unsayable("it is not a road user")
        return Site(
            limits=limits_in(self._objects[index]),
            grip=self._scene.episode.surroundings.surface.row.friction * 9.81,
            walks=kind.row.manner is Manner.WALKS,
            prefix=_plain(track.actor),
            value=value,
            start_on=lambda line: self._start_on(index, line),
            ego_line=self._ego_line,
            lane_of=lambda line: self._lane_of(line, index),
            ranges=self._ranges,
            pace=Pace.of(self._objects[0]).speed,
        )

    def _plainly(self, plan: Plan, index: int, track: Track) -> Plain:
        try:
            plain = plainly(plan, self._site(index, track))
        except Unsayable as reason:
            raise Unsayable(f"{track.actor}, {reason}") from reason
        return replace(plain, lines={name: _longer(line) for name, line in plain.lines.items()})

    def _lane_of(self, line: Polyline, index: int) -> int:
        """The number of the lane that a line follows from level with an actor's start on."""
        x, y, _ = self._base.poses[index]
        along = line.project(x, y)[0]
        numbers: set[int] = set()
        for ahead in (2.0, _BESIDE / 2, _BESIDE):
            section = self._network.laneSectionAt(line.point_at(along + ahead))
            if section is None or (section.lane.maneuvers and section.road in self._network.connectingRoads):
                raise Unsayable("it changes to something that is not a lane")
            numbers.add(int(section.openDriveID))
        if len(numbers) > 1:
            raise Unsayable("it changes to a line that does not stay in one lane")
        return numbers.pop()

    def _way(self, index: int, track: Track, plain: Plain | None) -> tuple[str, Polyline]:
        """The line on which somebody starts: the one that it follows, the ego's, or one of its own the way it faces."""
        if plain and plain.lines:
            return next(iter(plain.lines.items()))
        x, y, heading = self._base.poses[index]
        along, _, _ = self._ego_line.project(x, y)
        turn = math.remainder(heading - self._ego_line.heading_at(along), math.tau)
        if plain is None and abs(turn) < _TURNED and 0.0 < along < self._ego_line.length:
            return EGO_ROUTE, _thinned(self._ego_line)
        return self._own_way(index, track)

    def _own_way(self, index: int, track: Track) -> tuple[str, Polyline]:
        """A line of somebody's own through its start, the way that it faces."""
        x, y, heading = self._base.poses[index]
        ends = [(x + d * math.cos(heading), y + d * math.sin(heading)) for d in (-_OWN, _OWN)]
        return f"{_plain(track.actor)}Way", _thinned(Polyline(ends))

    def _actor(self, index: int, track: Track, plain: Plain | None, name: str, line: Polyline) -> Actor:
        if index == 0:
            along, left, turn = number(0.0), number(0.0), 0.0
        else:
            along, left, turn = self._start_on(index, line)
        return Actor(
            name=track.actor,
            kind=track.kind if track.kind in BY_CLASS else THING,
            length=track.length,
            width=track.width,
            start=Start(
                line=name,
                along=along.expression,
                left=left.expression,
                turn=0.0 if abs(turn) < _TURNED else round(turn, 6),
            ),
            speed=float(track.speed[0]),
            plan=plain.plan if plain else None,
        )

    def _led(self, index: int, track: Track, name: str, line: Polyline) -> Actor:
        """Somebody who starts where it did, and is led along its track where it moves."""
        x, y, _ = self._base.poses[index]
        along, left, _ = line.project(x, y)
        return Actor(
            name=track.actor,
            kind=track.kind if track.kind in BY_CLASS else THING,
            length=track.length,
            width=track.width,
            start=Start(line=name, along=number(along).expression, left=number(left).expression, turn=0.0),
            speed=float(track.speed[0]),
            led=bool(np.ptp(track.x) or np.ptp(track.y) or np.ptp(track.heading)),
        )

    def _kind(self, index: int) -> str:
        return type(self._objects[index]).__name__.lower()

    def _track(self, pose: tuple[float, float, float]) -> Track:
        """The track of whoever starts there."""
        return min(self._scene.episode.tracks, key=lambda one: math.dist(pose[:2], (one.x[0], one.y[0])))


def _plain(name: str) -> str:
    return re.sub(r"\W", "_", name, flags=re.ASCII)


def _longer(line: Polyline) -> Polyline:
    """A line that begins before and ends beyond, straight on."""
    return _thinned(Polyline([line.point_at(-BEFORE), *line.points, line.point_at(line.length + BEYOND)]))


def _thinned(line: Polyline) -> Polyline:
    """The same line without the points that lie between others, to the millimetre."""
    return Polyline(np.round(shapely.LineString(line.points).simplify(_THIN).coords, 6).tolist())


def _poses(placed: Any) -> list[tuple[float, float, float]]:
    objects: Sequence[Object] = placed.objects
    return [(float(o.position.x), float(o.position.y), float(o.heading) + math.pi / 2) for o in objects]


def _parameters(plan: Plan) -> set[str]:
    return {p.name for phase in plan.phases for e in expressions_of(phase) for p in walk(e) if isinstance(p, Parameter)}
