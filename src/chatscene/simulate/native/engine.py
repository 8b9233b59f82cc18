"""The engine's library: where it comes from, whether it computes as Python does here, and its structures.

A wheel brings it compiled. Where there is none of the present source beside it, as in a checkout, the machine's C
compiler makes one into the user's cache; where there is no compiler either, there is no engine, and that is said.
"""

from __future__ import annotations

import ctypes
import hashlib
import math
import operator
import os
import random
import stat
import tempfile
import warnings
from collections.abc import Callable, Iterator, Sequence
from ctypes import POINTER, Structure, c_double, c_float, c_int32, c_int64, c_uint64, c_void_p
from functools import lru_cache
from itertools import repeat
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chatscene.errors import EgoError
from chatscene.files.caches import cache_folder, keep, only_mine
from chatscene.simulate.native.building import NoEngine, compile_engine, source_digest

PACKAGED = Path(__file__).with_name("libengine.so")  # by a name that Python takes for no module of ours
_SEAL = 16  # bytes
CHECKED = 4000  # numbers on which each function is held against Python's
ARGUMENTS, LOCALS, SEEN, MOST_BODIES, STACK, STEPS, PART = 6, 8, 83, 32, 64, 20, 16  # as in engine.c
END = 2**63 - 1  # a step that no scene comes to

ROUNDING = 1e-6  # [m], more than rounding makes of a distance

_Doubles = POINTER(c_double)
Array = NDArray[np.float64]


def address(array: Any) -> int:
    """Where the numbers of an array are in memory; a sandbox allows nobody to ask `ctypes` for it."""
    found: int = array.ctypes.data
    return found


class Line(Structure):
    """A line: its points, their arc lengths, the direction of each segment, and the boxes of its parts."""

    _fields_ = (("points", c_int64), *((name, _Doubles) for name in ("x", "y", "s", "hx", "hy", "boxes")))


class Timetable(Structure):
    """When an ego is where on a line: arc length and time of each point, the speed on each segment."""

    _fields_ = (("points", c_int64), *((name, _Doubles) for name in ("s", "seconds", "speeds")))


class Limits(Structure):
    """What a body can do."""

    _fields_ = tuple(
        (name, c_double)
        for name in (
            *("length", "width", "throttle", "brake", "top_speed", "wheelbase", "wheel_angle", "wheel_rate"),
            *("lateral", "drag"),
        )
    )


class Body(Structure):
    """A body and what is asked of it."""

    _fields_ = (
        *(
            (name, c_double)
            for name in (
                *("x", "y", "heading", "speed", "before", "cos", "sin", "half_length", "half_width", "radius", "grip"),
                *("throttle", "brake", "steer", "wheel", "course", "target_speed", "vx", "vy", "sight", "height"),
                *("was_x", "was_y", "was_heading"),
                *("even_speed", "even_heading", "even_distance", "spin"),
            )
        ),
        ("limits", Limits),
        *((name, c_int32) for name in ("kind", "reverse", "walks", "seen_as_vehicle", "backs", "together", "slides")),
    )


class Instruction(Structure):
    """One step of a program for a stack."""

    _fields_ = (("op", c_int32), ("a", c_int32), ("b", c_int32), ("c", c_int32), ("value", c_double))


class Code(Structure):
    """A stretch of instructions."""

    _fields_ = (("start", c_int64), ("count", c_int64))


class Phase(Structure):
    """A phase of a plan."""

    _fields_ = (
        *((name, c_int32) for name in ("primitive", "path", "other", "end", "values", "first_local")),
        ("value", Code * LOCALS),
        ("argument", Code * ARGUMENTS),
        ("condition", Code),
        ("caps", _Doubles),
    )


class Agent(Structure):
    """Somebody with a plan, and how far he is in it."""

    _fields_ = (
        *((name, c_int32) for name in ("body", "phase", "phases", "loop", "entered", "begun")),
        ("since", c_int64),
        *((name, c_int32) for name in ("near", "other_near", "passed", "last")),
        *((name, c_double) for name in ("until", "along", "seconds", "ahead", "turned", "before", "course")),
        ("argument", c_double * ARGUMENTS),
        ("local", c_double * LOCALS),
        ("straight", c_double * 8),
        ("list", POINTER(Phase)),
    )


class Order(Structure):
    """An order to the ego."""

    _fields_ = (
        *(
            (name, c_double)
            for name in (
                "at_most",
                "since",
                "till",
                "place",
                "braking",
                "at_least",
                "aside",
                "over",
                "back",
                "within",
                "met",
            )
        ),
        *((name, c_int64) for name in ("of", "agent", "phase", "ends")),
    )


class Area(Structure):
    """A polygon of a lane: its rings, and its bounds."""

    _fields_ = (
        *((name, c_int64) for name in ("ring_start", "rings", "lane")),
        *((name, c_double) for name in ("low_x", "low_y", "high_x", "high_y")),
    )


class Ring(Structure):
    """Corners of a polygon."""

    _fields_ = (("start", c_int64), ("points", c_int64))


class Contact(Structure):
    """When the ego began to touch whom, where, and how fast they met."""

    _fields_ = (("step", c_int64), ("other", c_int64), ("side", c_int64), ("speed", c_double), ("earlier", c_double))


class World(Structure):
    """A scene, and where it is in it.

    Attributes:
        kept: What it points at, so that this stays as long as the scene.
    """

    kept: list[Any]

    _fields_ = (
        *(
            (name, c_int64)
            for name in (
                *("bodies", "agents", "areas", "orders", "limit", "step", "moving", "contacts", "most_contacts"),
                "quiet",
            )
        ),
        *((name, c_int32) for name in ("ending", "through", "preset", "near", "fault", "ends_when_over")),
        *((name, c_int32) for name in ("moved", "unused")),
        *((name, c_double) for name in ("dt", "arrival", "along", "offset", "hardest", "wheelbase", "wheel_angle")),
        ("swept", c_double),
        *((name, c_double) for name in ("beyond", "settled", "wanted")),
        ("touching", c_uint64),
        ("body", POINTER(Body)),
        ("agent", POINTER(Agent)),
        ("line", POINTER(Line)),
        ("table", POINTER(Timetable)),
        ("code", POINTER(Instruction)),
        ("area", POINTER(Area)),
        ("ring", POINTER(Ring)),
        ("corner", _Doubles),
        ("order", POINTER(Order)),
        ("row", _Doubles),
        ("offsets", _Doubles),
        ("contact", POINTER(Contact)),
        ("room", _Doubles),
        ("allowed", _Doubles),
        ("seen", c_double * SEEN),
    )


class Layer(Structure):
    """A layer of a network: for each input its weight to each output, and the bias."""

    _fields_ = (("inputs", c_int64), ("outputs", c_int64), ("columns", POINTER(c_float)), ("bias", POINTER(c_float)))


class Caution(Structure):
    """What the planner weighs its ways by, and what a crash counts that it expects at each time."""

    _fields_ = (
        *(
            (name, c_double)
            for name in (
                *("speed", "crash", "graze", "braking", "braked", "starting", "started", "stepping", "stepped"),
                *("crossing", "room", "side", "widening", "berth", "haste", "offset", "astray", "jerk", "resolve"),
                *("agility", "drift"),
            )
        ),
        ("discount", c_double * STEPS),
    )


class Policy(Structure):
    """Who drives; `chatscene.simulate.native.policies` makes them.

    Attributes:
        kept: What it points at, so that this stays as long as the policy.
    """

    kept: list[Any]

    _fields_ = (
        *((name, c_int32) for name in ("kind", "hidden", "output", "every", "swift", "around")),
        ("softness", c_double),
        ("car", Limits),
        ("caution", Caution),
        ("layers", c_int64),
        ("layer", POINTER(Layer)),
        *((name, POINTER(c_float)) for name in ("one", "other")),
        ("told", POINTER(c_int32)),
        ("remembers", c_int64),
        ("memory", _Doubles),
    )


class Foot(Structure):
    """Somebody's foot on the brake, beside whoever drives."""

    _fields_ = (
        ("begins", c_int64),
        ("over", c_int64),
        *((name, c_double) for name in ("own", "full", "ramp", "standstill", "standing")),
        ("car", Limits),
    )


class Boxes(Structure):
    """The boxes of one body at some moments, as `chatscene.simulate.boxes` has them.

    Attributes:
        kept: What it points at, so that this stays as long as these.
    """

    kept: list[Any]

    _fields_ = (
        *((name, c_void_p) for name in ("x", "y", "cos", "sin")),
        *((name, c_double) for name in ("half_length", "half_width")),
    )


def boxes_of(x: Array, y: Array, cos: Array, sin: Array, half_length: float, half_width: float) -> Boxes:
    """Boxes by the columns of their moments; cosine and sine are of the heading."""
    if not x.size == y.size == cos.size == sin.size:
        raise ValueError(f"columns of {x.size}, {y.size}, {cos.size} and {sin.size} moments are no boxes")
    kept = np.array((x, y, cos, sin), np.float64)
    at, size = address(kept), 8 * x.size
    found = Boxes(at, at + size, at + 2 * size, at + 3 * size, half_length, half_width)
    found.kept = [kept[0]]
    return found


class Habits(Structure):
    """What `sum_up` looks for; `chatscene.measure.sums` has each."""

    _fields_ = (
        *((name, c_int64) for name in ("lately", "over", "within", "pause")),
        *((name, c_double) for name in ("dt", "crawl", "as_near", "reacts", "still", "gains", "same_way")),
        *((name, c_double) for name in ("air", "across", "fast", "standing", "behind")),
    )


def reach_squared(half: tuple[float, float], other: tuple[float, float]) -> float:
    """Of how far [m] the centres of boxes that overlap are from each other at most, by half their sizes [m]."""
    reach = math.hypot(*half) + math.hypot(*other) + ROUNDING
    return reach * reach


class Course(Structure):
    """A line by arc length: how its points change along each piece, and where each leads.

    Attributes:
        kept: What it points at, so that this stays as long as the line.
    """

    kept: list[Any]

    _fields_ = (
        ("points", c_int64),
        *((name, c_void_p) for name in ("arc", "x", "y", "x_rate", "y_rate", "cos", "sin")),
    )


def course_of(x: Array, y: Array, arc: Array, cos: Array, sin: Array) -> Course:
    """A line by its points [m], their arc lengths [m], and cosine and sine of where each piece leads."""
    if not len(x) == len(y) == len(arc) == len(cos) + 1 == len(sin) + 1:
        raise ValueError(f"{len(x)} points are no course of {len(cos)} pieces")
    step = np.diff(arc)
    with np.errstate(divide="ignore", invalid="ignore"):  # of points that are one, which nobody is between
        columns = arc, x, y, np.diff(x) / step, np.diff(y) / step, cos, sin
    kept = [np.ascontiguousarray(column, np.float64) for column in columns]
    found = Course(len(x), *map(address, kept))
    found.kept = kept
    return found


_FUNCTIONS: dict[str, tuple[Any, ...]] = {
    "size_of": (c_int64, c_int64),
    "evaluate": (None, c_int64, c_int64, _Doubles, _Doubles, _Doubles),
    "see_world": (None, POINTER(World)),
    "step_world": (None, POINTER(World), c_double, c_double, c_double),
    "room_of": (c_int64, POINTER(World)),
    "copy_world": (None, POINTER(World), POINTER(World), *[c_void_p] * 3),
    "step_worlds": (c_int64, c_void_p, c_int64, *[c_void_p] * 3, c_int64),
    "run_world": (c_int64, POINTER(World), POINTER(Policy), c_int64),
    "brake_world": (None, POINTER(World), POINTER(Policy), POINTER(Foot)),
    "run_worlds": (c_int64, POINTER(POINTER(World)), c_int64, POINTER(Policy)),
    "ask": (None, POINTER(Policy), _Doubles, _Doubles, _Doubles),
    "follow": (None, POINTER(Line), c_int64, c_int32, *[c_void_p] * 4),
    "compare_boxes": (None, c_int64, *(POINTER(Boxes), c_void_p) * 2, c_void_p),
    "overlaps": (
        c_int64,
        *(c_int64, c_int64, POINTER(Boxes), c_int64, POINTER(Boxes), c_void_p),
        *(c_int64, c_double, c_void_p, c_void_p),
    ),
    "near_any": (None, c_int64, c_void_p, c_void_p, c_int64, c_void_p, c_void_p, c_double, c_void_p),
    "closest": (None, c_int64, c_void_p, c_void_p, c_double, c_void_p),
    "sum_up": (c_int64, *[c_int64] * 4, *[c_void_p] * 6, POINTER(Habits), *[c_void_p] * 10),
    "part": (None, *[c_int64] * 4, *[c_void_p] * 12),
    "first_risk": (
        c_int64,
        *(c_int64, c_int64, c_void_p, POINTER(Course), c_void_p, c_void_p),
        *(c_double, c_double, POINTER(Boxes), c_void_p, c_void_p, c_int64),
    ),
    "in_cells": (
        c_int64,
        *(c_int64, c_void_p, c_void_p, c_double, c_double, c_double),
        *(c_int64, c_int64, c_void_p, c_void_p),
    ),
    "cross": (None, c_int64, c_void_p, c_void_p, c_int64, c_void_p, c_void_p),
    "lane_events": (None, c_int64, *[c_void_p] * 3),
}
"""What each function of the library returns, and what it takes."""


class Engine:
    """The loaded library, checked.

    Args:
        library: What was compiled of the present source.

    Raises:
        NoEngine: It computes something else than Python on this machine.
    """

    def __init__(self, library: ctypes.CDLL) -> None:
        for name, (returns, *takes) in _FUNCTIONS.items():
            function = getattr(library, name)
            function.restype, function.argtypes = returns, takes
        self._library = library
        structures = (Line, Body, Instruction, Phase, Agent, World, Layer, Policy, Foot, Boxes, Course, Habits)
        for i, structure in enumerate(structures):
            if library.size_of(i) != ctypes.sizeof(structure):
                raise NoEngine(f"its {structure.__name__} has another size than is expected")
        if wrong := [name for name, count in self._differences().items() if count]:
            raise NoEngine(f"its {', '.join(wrong)} differ from Python's on this machine")

    def see(self, world: World) -> None:
        """What the ego sees now, where no step was made yet."""
        self._library.see_world(ctypes.byref(world))

    def step(self, world: World, throttle: float, brake: float, steer: float) -> None:
        """One step of a scene."""
        self._library.step_world(ctypes.byref(world), throttle, brake, steer)

    def copy(self, world: World) -> tuple[World, Array, Array]:
        """The same scene as far as it is, to be stepped by itself; what stays as it is, is shared.

        Returns:
            The copy, and what it keeps of its states and of the ego's offsets, of each state so far and of those to
            come.
        """
        found, states = World(), world.limit + 1
        rows = 4 * world.moving * states
        room = np.empty(rows + states + -(-self._library.room_of(ctypes.byref(world)) // 8))
        at = address(room)
        offsets = at + 8 * rows
        self._library.copy_world(ctypes.byref(world), ctypes.byref(found), offsets + 8 * states, at, offsets)
        found.kept = [*world.kept, room]
        return found, room[:rows].reshape(states, world.moving, 4), room[rows : rows + states]

    def step_many(self, worlds: NDArray[np.uint64], actions: Array, size: int) -> tuple[Array, Array]:
        """One step of each of several scenes.

        Args:
            worlds: (N,) Where each is in memory.
            actions: (N, 2) Acceleration and steering in [-1, 1], pressed with the hardest brake of the scene.
            size: How many numbers the ego sees.

        Returns:
            (N, 6) how far along the ego was before the step and is after it, its offset and its speed, how the scene
            ended and whether it failed; and (N, size) what the ego sees.

        Raises:
            EgoError: A scene is over; then none is stepped.
        """
        actions = np.ascontiguousarray(actions, np.float64)
        if actions.shape != (len(worlds), 2) or not 0 < size <= SEEN:
            raise ValueError(f"{actions.shape} are no actions of {len(worlds)} scenes, or {size} numbers are not seen")
        told, seen = np.empty((len(worlds), 6)), np.empty((len(worlds), size))
        columns = map(address, (actions, told, seen))
        over = self._library.step_worlds(address(worlds), len(worlds), *columns, size)
        if over >= 0:
            raise EgoError(f"drive {over} of {len(worlds)} is over: begin another")
        return told, seen

    def run(self, world: World, policy: Policy, until: int = END) -> int:
        """Run a scene to its end, or to a step; how many steps it took."""
        steps: int = self._library.run_world(ctypes.byref(world), ctypes.byref(policy), until)
        return steps

    def brake(self, world: World, policy: Policy, foot: Foot) -> None:
        """Run a scene to its end, or until the ego has stood long enough, with somebody else's foot on the brake."""
        self._library.brake_world(ctypes.byref(world), ctypes.byref(policy), ctypes.byref(foot))

    def run_many(self, worlds: list[World], policy: Policy) -> int:
        """Run scenes to their ends, one after the other; how many steps they took together."""
        pointers = (POINTER(World) * len(worlds))(*(ctypes.pointer(world) for world in worlds))
        steps: int = self._library.run_worlds(pointers, len(worlds), ctypes.byref(policy))
        return steps

    def ask(self, policy: Policy, seen: Sequence[float]) -> tuple[float, float]:
        """Acceleration and steering in [-1, 1] of whoever drives, to what he sees."""
        acceleration, steering = c_double(), c_double()
        numbers = (c_double * len(seen))(*seen)
        self._library.ask(ctypes.byref(policy), numbers, ctypes.byref(acceleration), ctypes.byref(steering))
        return acceleration.value, steering.value

    def follow(self, line: Line, x: Array, y: Array, *, whole: bool) -> tuple[Array, Array]:
        """(T,) arc length [m] and (T,) signed lateral offset [m] of points on a line; see `native.lines.follow`."""
        x, y = np.ascontiguousarray(x, np.float64), np.ascontiguousarray(y, np.float64)
        if x.shape != y.shape:
            raise ValueError(f"{len(x)} abscissas and {len(y)} ordinates are no points")
        arc, offset = np.empty(len(x)), np.empty(len(x))
        columns = map(address, (x, y, arc, offset))
        self._library.follow(ctypes.byref(line), len(x), whole, *columns)
        return arc, offset

    def between(
        self, a: Boxes, speed: Array, b: Boxes, other_speed: Array, crawl: float
    ) -> tuple[Array, tuple[float, ...]]:
        """(4, T) How two bodies lie to each other at each step, and the least of it; see `chatscene.simulate.boxes`."""
        one, other = np.ascontiguousarray(speed, np.float64), np.ascontiguousarray(other_speed, np.float64)
        if not len(one) == len(other) == a.kept[0].size == b.kept[0].size:
            raise ValueError(f"tracks of {len(one)} and {len(other)} steps are not beside each other")
        found = np.empty((4, len(one)))
        self._library.compare_boxes(
            len(one), ctypes.byref(a), address(one), ctypes.byref(b), address(other), address(found)
        )
        told = (c_double * 5)()
        self._library.closest(len(one), address(found), address(one), crawl, told)
        return found, tuple(told)

    def overlaps(
        self, a: Boxes, shape: tuple[int, int], b: Boxes, at: NDArray[np.int64], most: int, square: float
    ) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
        """Where boxes overlap that are nearest in time; see `chatscene.simulate.boxes.overlaps`."""
        if a.kept[0].size != shape[0] * shape[1] or b.kept[0].size != len(at):
            raise ValueError(f"{a.kept[0].size} boxes are no {shape}, or {b.kept[0].size} are not at {len(at)} moments")
        at = np.ascontiguousarray(at, np.int64)
        found = np.empty((2, 4 * shape[0] * len(at)), np.int64)  # at most two steps before and two after each
        count = self._library.overlaps(
            *(*shape, ctypes.byref(a), len(at), ctypes.byref(b), address(at)),
            *(most, square, address(found), address(found) + found.strides[0]),
        )
        return found[0, :count], found[1, :count]

    def sum_up(
        self, about: NDArray[np.int64], states: Array, who: Array, aside: Array, habits: Habits, parts: int
    ) -> tuple[Array, Array, Array, Array]:
        """The numbers of a block of drives; see `chatscene.measure.sums`.

        Args:
            about: (scenes, 5) how many steps and road users each has, the step of the ego's first collision and the
                number of whom it collides with, -1 without one, and in how many rows at the end one stands who waits.
            states: (scenes, road users, 4, steps) x, y, heading and speed, the ego's first.
            who: (scenes, road users, 4) half the length and width [m], 1 for an adversary, and by what rolling slows it
                [m/s²]; not a number of who has no wheels.
            aside: (scenes, steps) how far the ego is from its route [m].
            habits: What is looked for.
            parts: Into how many parts a step is cut to time who leaves a place and who comes to it.

        Returns:
            (scenes, road users, 8) numbers of each road user, (scenes, 17) of each drive, (scenes, 3, steps) what is to
            be added up over the steps; and (scenes, road users) of each adversary the least time [steps] between one
            leaving a place and the other coming to it, if the ego collides with none.
        """
        scenes, actors, _, longest = states.shape
        given = states, who, aside
        if not all(of.flags.c_contiguous and of.dtype == np.float64 for of in given) or about.dtype != np.int64:
            raise ValueError("the arrays of a block are not numbers one after the other")
        if (about.shape, who.shape, aside.shape) != ((scenes, 5), (scenes, actors, 4), (scenes, longest)):
            raise ValueError(f"{who.shape} road users and {aside.shape} distances are none of {states.shape}")
        if about[:, 0].max() > longest or about[:, 1].max() > actors or not (about[:, 3] < about[:, 1]).all():
            raise ValueError(f"a scene has more steps or road users than {states.shape}")
        turned = states[:, :, 2]
        cos, sin = np.cos(turned), np.sin(turned)
        pairs = 4 * int(about[:, 0] @ about[:, 1])
        counts, moments = np.empty((scenes, actors, 2), np.int64), np.empty((2, pairs), np.int64)
        room = np.empty((5 + 4 * actors) * longest)
        told, every, paces = np.empty((scenes, actors, 8)), np.empty((scenes, 17)), np.empty((scenes, 3, longest))
        places, least = np.empty((3, pairs * (parts + 1))), np.empty((scenes, actors))
        shape = scenes, actors, longest, parts
        state, cosine, sine, body = map(address, (states, cos, sin, who))
        first, x, count = address(moments), address(places), address(counts)
        second, y, heading = first + 8 * pairs, x + places.strides[0], x + 2 * places.strides[0]
        found: int = self._library.sum_up(
            *(*shape, address(about), state, cosine, sine, body, address(aside), ctypes.byref(habits), address(room)),
            *(address(told), address(every), address(paces), count, first, second, x, y, heading),
        )
        there = places[2, : found * (parts + 1)]
        cos, sin = np.cos(there), np.sin(there)
        ways = map(address, (cos, sin, least))
        self._library.part(*shape, state, cosine, sine, body, count, first, second, x, y, *ways)
        return told, every, paces, least

    def first_risk(
        self,
        ahead: Array,
        course: Course,
        along: Array,
        speed: Array,
        half: tuple[float, float],
        other: Boxes,
        other_speed: Array,
        seen: NDArray[np.bool_],
        lasting: int,
    ) -> int | None:
        """When a risk begins that lasts; see `chatscene.measure.avoidability.risk_step`."""
        if not len(along) == len(speed) == other.kept[0].size == len(other_speed) == len(seen):
            raise ValueError("columns of other lengths are no drive")
        columns = [np.ascontiguousarray(column, np.float64) for column in (ahead, along, speed, other_speed)]
        seen = np.ascontiguousarray(seen, np.bool_)
        moments, one, two, three = map(address, columns)
        found: int = self._library.first_risk(
            *(len(along), len(ahead), moments, ctypes.byref(course), one, two, *half),
            *(ctypes.byref(other), three, address(seen), lasting),
        )
        return None if found < 0 else found

    def in_cells(
        self, x: Array, y: Array, low: tuple[float, float], side: float, known: NDArray[np.int32], at: int
    ) -> tuple[NDArray[np.int32], bool]:
        """(N,) What is known of the cell of each point, -1 beside the map; and whether that is more than 0 of all.

        Args:
            x: (N,) [m].
            y: (N,) [m].
            low: Where the cells begin [m].
            side: Of a cell [m].
            known: (rows, columns) What is known of each.
            at: Where that is in memory.
        """
        if len(x) != len(y) or known.dtype != np.int32 or not known.flags.c_contiguous:
            raise ValueError("columns of other lengths are no points, or the cells are none")
        one, two = np.ascontiguousarray(x, np.float64), np.ascontiguousarray(y, np.float64)
        found = np.empty(len(one), np.int32)
        told: int = self._library.in_cells(
            *(len(one), address(one), address(two), *low, side, known.shape[1], known.shape[0], at, address(found))
        )
        return found, told == len(one)

    def lane_events(self, codes: NDArray[np.int32]) -> tuple[NDArray[np.bool_], list[int], list[int]]:
        """Of what `in_cells` tells of a track, if it tells all: see `chatscene.simulate.cells.Cells.along`."""
        steps, codes = len(codes), np.ascontiguousarray(codes, np.int32)
        off_road, found = np.empty(steps, np.bool_), np.empty(2 * steps + 2, np.int64)
        self._library.lane_events(steps, address(codes), address(off_road), address(found))
        onsets, changes = found[:2].tolist()
        return off_road, found[2 : 2 + onsets].tolist(), found[2 + steps : 2 + steps + changes].tolist()

    def cross(self, x: Array, y: Array, lines: Array) -> list[int | None]:
        """The first step at which a track crosses each of some lines; None if it never does.

        Args:
            x: (T,) [m].
            y: (T,) [m].
            lines: (N, 4) x and y of one end and of the other [m].
        """
        if len(x) != len(y) or lines.shape[1:] != (4,) or not lines.flags.c_contiguous:
            raise ValueError("columns of other lengths are no track, or the lines are none")
        one, two = np.ascontiguousarray(x, np.float64), np.ascontiguousarray(y, np.float64)
        found = np.empty(len(lines), np.int64)
        self._library.cross(len(one), address(one), address(two), len(lines), address(lines), address(found))
        return [None if step < 0 else step for step in found.tolist()]

    def near_any(self, x: Array, y: Array, other_x: Array, other_y: Array, within: float) -> NDArray[np.bool_]:
        """(N,) Whether each point is nearer [m] than that to any of the others."""
        if len(x) != len(y) or len(other_x) != len(other_y):
            raise ValueError("columns of other lengths are no points")
        columns = [np.ascontiguousarray(column, np.float64) for column in (x, y, other_x, other_y)]
        one, two, three, four = map(address, columns)
        near = np.empty(len(x), np.bool_)
        self._library.near_any(len(x), one, two, len(other_x), three, four, within**2, address(near))
        return near

    def _differences(self) -> dict[str, int]:
        """On how many of `CHECKED` numbers each function differs from Python's."""
        draw = random.Random(0)
        scales = [10.0 ** draw.uniform(-4, 4) for _ in range(CHECKED)]
        a = [scale * draw.uniform(-1, 1) for scale in scales]
        b = [scale * draw.uniform(-1, 1) for scale in scales]
        numbers = c_double * CHECKED
        first, second, out = numbers(*a), numbers(*b), numbers()
        found: dict[str, int] = {}
        for i, (name, of) in enumerate(_PYTHON.items()):
            self._library.evaluate(i, CHECKED, first, second, out)
            found[name] = sum(map(operator.ne, of(a, b), out))
        return found


def _lengths(a: Sequence[float], b: Sequence[float]) -> Iterator[float]:
    return map(float, map(np.hypot, a, b))


_PYTHON: dict[str, Callable[[Sequence[float], Sequence[float]], Iterator[float]]] = {
    "sine": lambda a, _: map(math.sin, a),
    "cosine": lambda a, _: map(math.cos, a),
    "tangent": lambda a, _: map(math.tan, a),
    "arc tangent": lambda a, _: map(math.atan, a),
    "arc sine": lambda a, _: map(math.asin, map(math.sin, a)),
    "arc tangent of two": lambda a, b: map(math.atan2, a, b),
    "hypotenuse": lambda a, b: map(math.hypot, a, b),
    "modulo": lambda a, b: map(operator.mod, a, b),
    "square": lambda a, _: map(pow, a, repeat(2)),
    "fourth power": lambda a, _: map(pow, a, repeat(4)),
    "remainder": lambda a, _: map(math.remainder, a, repeat(2.0 * math.pi)),
    "hyperbolic tangent": lambda a, _: map(math.tanh, a),
    "rounding": lambda a, _: map(round, map(math.sin, a), repeat(6)),
    "length": _lengths,
}  # in the order of `evaluate` in engine.c


@lru_cache(maxsize=1)
def load_engine() -> Engine:
    """The engine of the present source, loaded and checked once per process.

    Raises:
        NoEngine: There is none for this machine.
    """
    digest = source_digest()
    library = _opened(PACKAGED, digest) or _opened(_kept(digest), digest)
    if library is None:
        raise NoEngine("what was compiled of it cannot be loaded")
    return Engine(library)


def _kept(digest: str) -> Path:
    """The library in this user's cache, compiled now if it is not there.

    Raises:
        NoEngine: It cannot be compiled, or there is no folder that nobody else can write to.
    """
    if (folder := only_mine(cache_folder("engines"))) is None:
        raise NoEngine("no compiled engine came with this installation, and there is no folder to keep one in")
    path = folder / f"engine-{digest}-{os.uname().machine}.so"
    if not _is_sealed(path):
        if os.path.lexists(path):
            warnings.warn(
                f"the compiled engine {path} was damaged or is not of this user; it is made anew", stacklevel=2
            )
            path.unlink()
        with tempfile.TemporaryDirectory() as made:
            compile_engine(target := Path(made) / "engine.so")
            content = target.read_bytes()
            keep(path, content + _seal(content))
    return path


def _seal(content: bytes) -> bytes:
    """What stands behind a library: the loader of ELF files looks at nothing there."""
    return hashlib.blake2b(content, digest_size=_SEAL).digest()


def _is_sealed(path: Path) -> bool:
    """Whether a library is a file of this user, to the byte as it was kept; to load a damaged one kills the process."""
    try:
        state = path.lstat()
        whole = path.read_bytes()
    except OSError:
        return False
    mine = stat.S_ISREG(state.st_mode) and state.st_uid == os.getuid() and not state.st_mode & 0o022
    return mine and whole[-_SEAL:] == _seal(whole[:-_SEAL])


def _opened(path: Path, digest: str) -> ctypes.CDLL | None:
    """A library, if it can be loaded and was compiled of the present source."""
    try:
        library = ctypes.CDLL(str(path))
        library.source_digest.restype = ctypes.c_char_p
        return library if library.source_digest() == digest.encode() else None
    except (OSError, AttributeError):
        return None
