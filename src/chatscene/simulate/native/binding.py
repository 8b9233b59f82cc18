"""A scene that Scenic has placed, as arrays for the engine; or why the engine cannot run it."""

from __future__ import annotations

import ctypes
from collections import ChainMap
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import lru_cache
from typing import Any
from weakref import WeakKeyDictionary

import numpy as np
import shapely
from numpy.typing import NDArray

from chatscene.ego.intelligent_driver import CAR
from chatscene.ego.policy import PEDALS
from chatscene.errors import ChatSceneError
from chatscene.simulate.native import engine
from chatscene.simulate.native.code import Anew, Compiler, NotCovered, Surrounding
from chatscene.simulate.native.lines import line_of
from chatscene.simulate.placing import Placement
from chatscene.simulate.roadside import RouteSurroundings
from chatscene.simulate.session import ARRIVAL, SteppedSession
from chatscene.terms.actors import Limits
from chatscene.terms.order import Order
from chatscene.terms.plan import PRIMITIVES, After, Kind, Name, Phase, Plan, Until
from chatscene.terms.polyline import Polyline
from chatscene.terms.profile import Timetable
from chatscene.terms.scene import ScenicProgram
from chatscene.terms.written_plans import written_plans
from chatscene.world.bodies import Vehicle, Walker
from chatscene.world.control import curve_speeds

THING, VEHICLE, WALKER = 0, 1, 2  # these and the next as engine.c numbers them
UNTIL, AFTER = 1, 2
PRESETS = {"safebench": 0, "actors": 1, "road": 2, "traffic": 3}
ON_FOOT = ("MoveAhead", "Halt")  # what somebody on foot can do
STANDING = ("Park", "Halt")  # what a thing can do
ORDER = [
    "DrivePath",
    "BrakeOnPath",
    "ThrottleOnPath",
    "SwerveOnPath",
    "WeaveOnPath",
    "PaceOnPath",
    "KeepStation",
    "FollowTraffic",
    "WaitFor",
    "ReverseStraight",
    "ReverseTurning",
    "TurnOff",
    "Slide",
    "Park",
    "MoveAhead",
    "Halt",
]  # as engine.c numbers them
POSE = ("x", "y", "heading", "speed", "before", "cos", "sin", "half_length", "half_width", "radius", "grip")
CONTACTS = 256
FAILS = (ArithmeticError, AttributeError, LookupError, TypeError, ValueError, ChatSceneError)
"""What comes of a value that cannot be computed."""


@dataclass(slots=True)
class Bound:
    """A scene in the engine's terms.

    Attributes:
        world: What the engine steps.
        rows: (steps + 1, bodies that move, 4): where each is at each step.
        offsets: (steps + 1,): of the ego from its route [m].
        instructions: How many it has.
        anew: What is to be done again for another scene of the program, on a copy of them.
    """

    world: engine.World
    rows: NDArray[np.float64]
    offsets: NDArray[np.float64]
    instructions: int = 0
    anew: tuple[Anew, ...] = ()

    def again(self, session: SteppedSession, moved: Iterable[int]) -> Bound:
        """Another scene of the program, at its beginning.

        Args:
            session: What this was bound of, at the beginning of that scene (`SteppedSimulator.again`).
            moved: Which bodies are elsewhere in it.

        Raises:
            NotCovered: It differs in more than numbers.
        """
        found = self.copy()
        world, bodies = found.world, session.simulation.bodies
        if self.anew:
            code = (engine.Instruction * self.instructions)()
            ctypes.memmove(code, self.world.code, ctypes.sizeof(code))
            try:
                for part in self.anew:
                    part(code)
            except FAILS as error:
                raise NotCovered("something that cannot be computed before the drive") from error
            world.code = code
            world.kept.append(code)
        for number in moved:
            _pose(world.body[number], bodies[number])
        found.rows[0] = [(b.x, b.y, b.heading, b.speed) for b in bodies if b.moves]
        _watch(world, session)
        return found

    def copy(self) -> Bound:
        """The same scene as far as it is now, to be stepped by itself; what stays as it is, is shared."""
        return Bound(*engine.load_engine().copy(self.world))


def bind(session: SteppedSession, program: ScenicProgram, placement: Placement | None = None) -> Bound:
    """A session at its beginning, as arrays.

    Args:
        session: Opened by the embedded simulator, no step made.
        program: What it is a scene of.
        placement: What its scenes differ in, if others are to be made of it (`Bound.again`).

    Raises:
        NotCovered: The engine does not do what the scene needs; the message says what.
    """
    simulation = session.simulation
    if program.drawn or program.as_written:
        raise NotCovered("a program for another world model")
    if session.settings.physics != "kinematic":
        raise NotCovered(f"the physics {session.settings.physics}")
    if simulation.watched:
        raise NotCovered("a program with conditions, monitors or records of its own")
    if len(simulation.objects) > engine.MOST_BODIES:
        raise NotCovered(f"more than {engine.MOST_BODIES} bodies")
    try:
        return _Binder(session, program, placement).bound()
    except FAILS as error:
        # It would fail in the drive too, if it is reached there.
        raise NotCovered(f"something that cannot be computed before the drive ({type(error).__name__})") from error


class _Binder:
    def __init__(self, session: SteppedSession, program: ScenicProgram, placement: Placement | None) -> None:
        self._session = session
        self._moved = placement.moved if placement is not None else frozenset[int]()
        self._anew: list[Anew] | None = [] if placement is not None else None
        self._objects: list[Any] = list(session.simulation.objects)
        self._bodies: list[Any] = list(session.simulation.bodies)
        self._plans = written_plans(program.source)
        self._instructions: list[engine.Instruction] = []
        self._lines: list[Polyline] = [session.route.line]
        self._tables: list[Timetable] = []
        self._kept: list[Any] = []

    def bound(self) -> Bound:
        session, world = self._session, engine.World()
        agents = [self._agent(i) for i, one in enumerate(self._objects) if one.behavior is not None]
        bodies = [self._body(i) for i in range(len(self._bodies))]
        areas, rings, corners = _areas_of(session.around)
        self._kept += (areas, rings, corners)
        orders = [self._order(number, one) for number, one in enumerate(session.orders)]
        moving = sum(body.moves for body in self._bodies)
        rows = np.zeros((session.limit + 1, moving, 4))
        rows[0] = [(b.x, b.y, b.heading, b.speed) for b in self._bodies if b.moves]
        offsets = np.zeros(session.limit + 1)
        world.body, world.bodies = self._array(engine.Body, bodies), len(bodies)
        world.agent, world.agents = self._array(engine.Agent, agents), len(agents)
        world.line = self._array(engine.Line, [self._line(line) for line in self._lines])
        world.table = self._array(engine.Timetable, [self._table(table) for table in self._tables])
        world.code = self._array(engine.Instruction, self._instructions)
        world.area, world.areas, world.ring, world.corner = areas, len(areas), rings, _pointer(corners)
        world.order, world.orders = self._array(engine.Order, orders), len(orders)
        world.row, world.offsets = self._doubles(rows), self._doubles(offsets)
        world.contact, world.most_contacts = self._array(engine.Contact, [], CONTACTS), CONTACTS
        world.limit, world.moving, world.through = session.limit, moving, session.through
        world.preset, world.hardest = PRESETS[session.preset], PEDALS[session.pedals]
        own = session.limits
        if (own.wheelbase, own.wheel_angle) != (CAR.wheelbase, CAR.wheel_angle):
            world.wheelbase, world.wheel_angle = own.wheelbase, own.wheel_angle
        world.swept = session.swept
        world.dt, world.arrival = session.settings.dt, ARRIVAL * session.route.length
        world.along, world.offset = session.along, session.offset
        if session.preset in ("road", "traffic"):
            world.room = self._doubles(session.around.room)
        if session.allowed is not None:
            world.allowed = self._doubles(session.allowed)
        _watch(world, session)
        offsets[0] = session.offset
        world.kept = self._kept
        return Bound(world, rows, offsets, len(self._instructions), tuple(self._anew or ()))

    def _array(self, kind: Any, items: list[Any], room: int = 1) -> Any:
        """Structures, one after the other, with room for at least so many, that stay as long as the scene."""
        array = (kind * max(len(items), room))(*items)
        self._kept.append(array)
        return ctypes.cast(array, ctypes.POINTER(kind))

    def _doubles(self, values: Any) -> Any:
        array = np.ascontiguousarray(values, dtype=np.float64)
        self._kept.append(array)
        return _pointer(array)

    def _line(self, line: Polyline) -> engine.Line:
        found, columns = line_of(line)
        self._kept += columns
        return found

    def _table(self, table: Timetable) -> engine.Timetable:
        columns = map(self._doubles, (table.arcs, table.seconds, table.speeds))
        return engine.Timetable(len(table.arcs), *columns)

    def _order(self, number: int, order: Order) -> engine.Order:
        of = self._bodies.index(self._session.awaited[number]) if order.whom else -1
        plans = [i for i, one in enumerate(self._objects) if one.behavior is not None]
        follows = of >= 0 and type(self._objects[of].behavior).__name__ in self._plans
        agent = plans.index(of) if follows else -1
        met = np.inf if order.whom and not order.ends else 0.0
        row = engine.Order(of=of, agent=agent, phase=order.phase, ends=order.ends, met=met)
        for name in ("at_most", "since", "till", "place", "braking", "at_least", "aside", "over", "back", "within"):
            setattr(row, name, getattr(order, name))
        return row

    def _body(self, index: int) -> engine.Body:
        body: Any = self._bodies[index]
        thing, kind = self._objects[index], _kind_of(body)
        row = engine.Body()
        row.kind = kind
        row.limits = engine.Limits(length=body.length, width=body.width)
        if body.moves:
            row.limits = limits_of(body.limits)
        row.backs = kind == VEHICLE and body.backs
        _pose(row, body)
        row.seen_as_vehicle = bool(getattr(thing, "isVehicle", False))
        if index:
            _, row.walks, row.sight, row.height = self._session.others[index - 1]
        else:
            row.height = self._session.height
        return row

    def _agent(self, index: int) -> engine.Agent:
        behavior = self._objects[index].behavior
        plan, names = self._plan(behavior)
        scene = Surrounding(
            names=names,
            parameters=self._session.simulation.scene.params,
            objects=self._objects,
            self_index=index,
            drawn=self._drawn_of(names),
            moved=self._moved,
        )
        compiler = Compiler(self._instructions, self._lines, scene, tables=self._tables, anew=self._anew)
        phases = [self._phase(compiler, phase, index) for phase in plan.phases]
        agent = engine.Agent(body=index, phases=len(phases), loop=-1 if plan.loop is None else plan.loop)
        agent.list = self._array(engine.Phase, phases)
        return agent

    def _drawn_of(self, names: Mapping[str, Any]) -> frozenset[str]:
        """Which names are something else in another scene; things are the same ones, elsewhere."""
        drawn: Mapping[str, Any] = names.maps[0] if isinstance(names, ChainMap) else {}
        return frozenset(name for name, value in drawn.items() if not any(value is one for one in self._objects))

    def _plan(self, behavior: Any) -> tuple[Plan, Mapping[str, Any]]:
        """What somebody does, and the names that it speaks of."""
        name, given = type(behavior).__name__, behavior._args  # pyright: ignore[reportPrivateUsage] - Scenic has no other
        if name in self._plans and not given and not behavior._kwargs:
            plan = self._plans[name]
            if isinstance(plan, str):
                raise NotCovered("a behavior that is not a plan")
            # The program's own names, with what the scene drew.
            names = type(behavior).makeGenerator.__globals__
            return plan.plan, ChainMap(self._session.simulation.drawn.get(id(names), {}), names)
        if name not in PRIMITIVES or behavior._kwargs:
            raise NotCovered("a behavior that is not a plan")
        takes = PRIMITIVES[name].takes[: len(given)]
        names = {argument.name: value for argument, value in zip(takes, given, strict=False)}
        return Plan(
            phases=(Phase(name, tuple(Name(a.name, a.kind) for a in PRIMITIVES[name].takes[: len(given)])),)
        ), names

    def _phase(self, compiler: Compiler, phase: Phase, index: int) -> engine.Phase:
        body = self._bodies[index]
        name = _act_of(body, phase.primitive)
        row = engine.Phase(primitive=ORDER.index(name), path=-1, other=-1, first_local=len(compiler.places))
        self._values(compiler, phase, row)
        numbers = self._told(compiler, phase, row)
        if name == "WaitFor":
            if row.other:
                raise NotCovered("waiting for somebody else than the ego")
            numbers.append(compiler.number(self._objects[0].route.exitAt))
        for i, number in enumerate(numbers):
            row.argument[i] = number
        if row.path >= 0:
            row.caps = self._doubles(curve_speeds(self._lines[row.path], body.grip))
        if isinstance(phase.end, Until):
            row.end, row.condition = UNTIL, compiler.code(phase.end.condition)
        elif isinstance(phase.end, After):
            row.end, row.condition = AFTER, compiler.code(phase.end.seconds)
        return row

    def _values(self, compiler: Compiler, phase: Phase, row: engine.Phase) -> None:
        """What is computed before a phase begins: once for all where it stays, else each time."""
        for value in phase.values:
            if value.name in compiler.places or value.name in compiler.bound:
                raise NotCovered("a value that is computed anew")
            if not compiler.is_live(value.expression):
                compiler.bind(value.name, value.expression)
                continue
            if len(compiler.places) == engine.LOCALS:
                raise NotCovered("many values")
            row.value[row.values] = compiler.code(value.expression)
            compiler.put(value.name, row.first_local + row.values)
            row.values += 1

    def _told(self, compiler: Compiler, phase: Phase, row: engine.Phase) -> list[engine.Code]:
        """What a primitive is told: path and actor go into the row, numbers come back."""
        numbers: list[engine.Code] = []
        for argument in PRIMITIVES[phase.primitive].takes:
            given = phase.argument(argument.name)
            if given is None:
                raise NotCovered("a primitive that is not told all")
            if argument.kind is Kind.NUMBER:
                numbers.append(compiler.code(given))
            elif compiler.is_live(given):
                raise NotCovered("a path that changes")
            elif argument.kind is Kind.ACTOR:
                row.other = compiler.actor(given)
            else:
                row.path = compiler.path(given)
        return numbers


def _pose(row: engine.Body, body: Any) -> None:
    """How a body begins."""
    for name in POSE:
        setattr(row, name, getattr(body, name))
    if row.kind == WALKER:
        row.course, row.target_speed, row.vx, row.vy = body.course, body.target_speed, body.vx, body.vy


def _watch(world: engine.World, session: SteppedSession) -> None:
    """What is known of the end of the drive, where it is watched for, as far as the first state tells."""
    over = session.over
    if over is None:
        return
    world.ends_when_over, world.quiet, world.moved = 1, over.since, over.moved
    world.beyond, world.settled, world.wanted = over.beyond, over.settled, over.wanted
    for body, even in zip(world.body[: world.bodies], over.even, strict=False):
        body.even_speed, body.even_heading, body.even_distance = even
    doing = {one.number: one for one in over.acting}
    for agent in world.agent[: world.agents]:
        agent.last, agent.until = doing[agent.body].last, doing[agent.body].until


def _areas_of(around: RouteSurroundings) -> tuple[Any, Any, NDArray[np.float64]]:
    """The lanes of a route as polygons, their rings and all corners."""
    if (known := _areas.get(around)) is None:
        known = _areas[around] = _areas_in(around)
    return known


_areas: WeakKeyDictionary[RouteSurroundings, tuple[Any, Any, NDArray[np.float64]]] = WeakKeyDictionary()


def _areas_in(around: RouteSurroundings) -> tuple[Any, Any, NDArray[np.float64]]:
    areas: list[engine.Area] = []
    rings: list[engine.Ring] = []
    corners: list[Any] = []
    for lane, shape in enumerate(around.lanes):
        for polygon in shapely.get_parts(shape).tolist():
            outlines = [polygon.exterior, *polygon.interiors]
            areas.append(engine.Area(len(rings), len(outlines), lane, *polygon.bounds))
            for outline in outlines:
                points = np.array(outline.coords)[:, :2].tolist()
                rings.append(engine.Ring(len(corners), len(points)))
                corners += points
    return (engine.Area * len(areas))(*areas), (engine.Ring * len(rings))(*rings), np.array(corners)


def _kind_of(body: Any) -> int:
    return VEHICLE if isinstance(body, Vehicle) else WALKER if isinstance(body, Walker) else THING


def _pointer(array: NDArray[np.float64]) -> Any:
    return array.ctypes.data_as(ctypes.POINTER(ctypes.c_double))


@lru_cache(maxsize=64)
def limits_of(limits: Limits) -> engine.Limits:
    """What a body can do, in the engine's terms."""
    names = [name for name, *_ in engine.Limits._fields_]  # pyright: ignore[reportPrivateUsage] - ctypes calls it so
    return engine.Limits(**{name: getattr(limits, name) for name in names})


def _act_of(body: Any, primitive: str) -> str:
    """The primitive that a body does under a name."""
    if isinstance(body, Walker) and primitive not in ON_FOOT:
        raise NotCovered(f"{primitive} on foot")
    if not body.moves and primitive not in STANDING:
        raise NotCovered(f"{primitive} of a thing")
    return primitive
