"""Whether a careful and competent driver would have avoided a crash.

UN Regulation No. 157 (automated lane keeping systems, 01 series of amendments, annex 3, "guidance on traffic
disturbance critical scenarios") models such a driver: once somebody is perceived as a risk, the driver needs 0.4 s to
judge it, 0.75 s until braking begins, and 0.6 s until the brake gives 0.774 g. The regulation says what a risk is for
cut-ins, cut-outs and braking leaders on motorways; decision 0013 says what we take for one anywhere.

The answer is found by driving, not by formula: the same ego drives the same scene again and does as it did, until the
moment the careful driver would brake; from then on it keeps to its way and brakes as that driver would, and the
adversary reacts to that as its program says.
"""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from chatscene.ego.asking import begin, decide, fitted
from chatscene.ego.observation import Observation
from chatscene.ego.policy import PEDALS, EgoPolicy, pedals_of
from chatscene.errors import ProgramError, ProgramStopped, SandboxError, ServerError, SimulationError
from chatscene.measure.instead import drive_instead
from chatscene.simulate.boxes import Boxes
from chatscene.simulate.native.engine import Course as NativeCourse
from chatscene.simulate.native.engine import Engine, boxes_of, course_of
from chatscene.simulate.native.lines import engine, follow
from chatscene.simulate.simulator import Simulator, limited
from chatscene.terms.actors import LIMITS, Limits, has_lamps, height_of_kind
from chatscene.terms.arrays import Array, fixed
from chatscene.terms.braking import Braking
from chatscene.terms.episode import Episode, Role, Track
from chatscene.terms.polyline import Polyline
from chatscene.terms.scene import CAR, Scene, ScenicProgram
from chatscene.terms.sight import BEHIND_NOSE, EYE

RISK_EVALUATION = 0.4  # [s] (UN R157, annex 3)
BRAKING_DELAY = 0.75  # [s] from having judged until braking begins (the same)
RAMP = 0.6  # [s] from the first touch of the pedal to full braking (the same)
FULL_BRAKE = 0.774 * 9.81  # [m/s²] (the same)
WANDERING = 0.375  # [m] beside a vehicle that its wandering in its lane takes up (the same)
HORIZON = 3.0  # [s] a driver looks ahead; braking from 50 km/h takes 1.15 + 0.6 + 1.5 s


def risk_step(episode: Episode, route: Polyline, *, occlusion: bool = True) -> int | None:
    """The step at which the actor that the ego will hit becomes a risk, and stays one while it is judged.

    It is a risk if both, going on as they do, will touch within `HORIZON`: the ego along its route at its present
    speed, the other straight on; and if nothing hides it, neither a thing nor the dark or fog.

    Args:
        episode: A drive with a collision.
        route: The ego's.
        occlusion: Whether all bodies hide others, from the ego as well; else only things at the roadside do, which is
            what the drivers of runs without occlusion are judged by.

    Returns:
        The step, or None if it never was a risk, or there was no collision.
    """
    crash = episode.collision
    if crash is None:
        return None
    other = next(track for track in episode.tracks if track.actor == crash.other)
    judged = math.ceil(RISK_EVALUATION / episode.dt)
    seen, native = _visible(episode, other, occlusion=occlusion), engine()
    if native is not None:
        return _first_risk(episode, other, route, seen, judged + 1, native)
    risk = _predicted(episode, other, route) & seen
    lasting = np.convolve(risk, np.ones(judged + 1, dtype=int), mode="valid") == judged + 1
    steps = np.flatnonzero(lasting)
    return int(steps[0]) if steps.size else None


def avoidable(
    episode: Episode, program: ScenicProgram, scene: Scene, ego: EgoPolicy, simulator: Simulator
) -> bool | None:
    """Whether a careful and competent driver, in the ego's place from the moment of risk, does not crash.

    Args:
        episode: What happened to the ego.
        program: What it happened in.
        scene: The scene.
        ego: Who drove.
        simulator: Where to drive it again.

    Returns:
        None if the ego did not crash, or the program's own ego drives, in whose place nobody can be put.

    Raises:
        SimulationError: The scene cannot be driven again.
        EgoError: The ego fails this time.
    """
    crash = episode.collision
    if crash is None or program.as_written:
        return None
    ego = fitted(ego, program)
    risk = risk_step(episode, simulator.route_in(program, scene).line, occlusion=simulator.identity.occlusion)
    if risk is None:
        return False
    braking = braking_step(risk, episode.dt)
    if braking >= crash.step:
        return False
    with limited(simulator, program, scene, ego, f"scene {scene.id!r}, driven again"):
        return not crashes_braking_from(braking, ego, program, scene, simulator, episode.dt)


def avoidable_if_driven(
    episode: Episode, program: ScenicProgram, scene: Scene, ego: EgoPolicy, simulator: Simulator
) -> tuple[bool | None, tuple[str, ...]]:
    """As `avoidable`, and None where somebody's program fails once it is driven again; with why, in words.

    What happened to the ego is not lost by that.

    Raises:
        SimulationError: Of no program's doing: the simulator is lost.
        EgoError: The ego fails this time.
    """
    try:
        return avoidable(episode, program, scene, ego, simulator), ()
    except (ProgramError, SimulationError) as error:
        if isinstance(error, ServerError | SandboxError) and not isinstance(error, ProgramStopped):
            raise
        why = str(error).partition("\n")[0]
    return None, (f"whether a careful driver avoids the collision is not known: driven again, {why}",)


def braking_step(risk: int, dt: float) -> int:
    """The step at which the careful driver brakes for a risk that began at another; `dt` [s]."""
    return risk + math.ceil((RISK_EVALUATION + BRAKING_DELAY) / dt - 1e-9)


def crashes_braking_from(
    step: int,
    ego: EgoPolicy,
    program: ScenicProgram,
    scene: Scene,
    simulator: Simulator,
    dt: float,
    *,
    not_over_before: int = 0,
) -> bool:
    """Whether the ego still crashes if it brakes as the careful driver does from a step on.

    Args:
        step: When braking begins.
        ego: Who drives until then, and steers throughout.
        program: What is driven.
        scene: Its scene.
        simulator: Where.
        dt: Length of a step [s].
        not_over_before: A step, beside `step`, until which standing does not end the drive.

    Raises:
        SimulationError: The scene cannot be driven again.
        EgoError: The ego fails this time.
    """
    lag = simulator.identity.brake_lag
    if lag and program.ego_kind != CAR:
        lag = program.ego_limits.brake_lag
    braking = careful_braking(step, dt, lag, not_over_before=not_over_before)
    return drive_instead(
        CarefulDriver(ego, braking, dt, program.ego_limits),
        ego,
        program,
        scene,
        simulator,
        pedals="full-brake",
        not_over_before=braking.over,
        dt=dt,
        braking=braking,
    ).crashed


def careful_braking(step: int, dt: float, brake_lag: float = 0.0, *, not_over_before: int = 0) -> Braking:
    """The braking of the careful driver from a step on.

    The regulation's ramp is of the deceleration. A brake that takes time to build up does a part of it: it loses as
    much speed as a ramp of twice its time constant, and the foot has the rest.

    Args:
        step: When it begins.
        dt: Length of a step [s].
        brake_lag: Time constant with which the brake builds up [s].
        not_over_before: A step, beside `step`, until which standing does not end the drive.
    """
    ramp = max(RAMP - 2.0 * brake_lag, dt)
    return Braking(begins=step, full=FULL_BRAKE, ramp=ramp, over=max(step, not_over_before))


class CarefulDriver:
    """Another ego until a step, then the brake of the careful driver; the other's steering throughout."""

    def __init__(self, ego: EgoPolicy, braking: Braking, dt: float, body: Limits = LIMITS[CAR]) -> None:
        self._ego, self._body = ego, body
        self._scale = PEDALS[pedals_of(ego)]
        self._braking = braking
        self.begins = braking.begins
        self._dt = dt
        self._step = 0
        begin(ego)

    def skip(self) -> None:
        """Everything before it brakes was driven without it."""
        self._step = self.begins

    def act(self, observation: Observation) -> tuple[float, float]:
        """Decide for one step."""
        acceleration, steering = decide(self._ego, observation)
        if acceleration < 0.0:
            acceleration *= self._scale
        if self._step >= self.begins:
            wish = self._braking.wish(self._step, self._dt)
            acceleration = min(acceleration, -max(0.0, wish - self._body.drag) / self._body.brake)
        self._step += 1
        return acceleration, steering


_Way = tuple[Array, Array]
"""Cosine and sine of a heading."""


@lru_cache(maxsize=64)
def _course(route: Polyline) -> tuple[Array, Array, Array]:
    """(N,) Arc length [m] of each point of a line, and (N - 1,) cosine and sine of where each piece of it leads."""
    along = np.diff(route.points, axis=0).T
    heading = np.unwrap(np.arctan2(*along[::-1]))
    arc = np.concatenate(([0.0], np.cumsum(np.hypot(*along))))
    return fixed(arc), fixed(np.cos(heading)), fixed(np.sin(heading))


@lru_cache(maxsize=64)
def _told(route: Polyline) -> NativeCourse:
    """A course in the engine's terms."""
    x, y = route.points.T
    return course_of(x, y, *_course(route))


def _first_risk(
    episode: Episode, other: Track, route: Polyline, seen: NDArray[np.bool_], lasting: int, native: Engine
) -> int | None:
    """What `risk_step` finds, in the engine."""
    ego, there = episode.ego_track, Boxes.of(other)
    along, _ = follow(route, ego.x, ego.y, whole=True)
    half = there.half_length, there.half_width + _wanders(other)
    boxes = boxes_of(there.x, there.y, there.cos, there.sin, *half)
    own = ego.length / 2, ego.width / 2
    return native.first_risk(
        _moments(episode.dt), _told(route), along, ego.speed, own, boxes, other.speed, seen, lasting
    )


@lru_cache(maxsize=4)
def _moments(dt: float) -> Array:
    """The times [s] to which a driver looks ahead."""
    return fixed(np.arange(0.0, HORIZON + 1e-9, dt))


def _wanders(track: Track) -> float:
    """The room [m] to either side that a road user needs to wander in its lane; an occluder needs none."""
    return WANDERING if track.role is not Role.OCCLUDER else 0.0


def _predicted(episode: Episode, other: Track, route: Polyline) -> NDArray[np.bool_]:
    """(T,) Whether, at each step, the ego along its route and the other straight on will touch within `HORIZON`."""
    ego = episode.ego_track
    ahead = _moments(episode.dt)
    along, _ = follow(route, ego.x, ego.y, whole=True)
    arc, cos, sin = _course(route)
    stops = along[:, None] + np.maximum(ego.speed, 0.0)[:, None] * ahead
    beyond = np.maximum(stops - arc[-1], 0.0)
    piece = np.clip(np.searchsorted(arc, stops, side="right") - 1, 0, len(cos) - 1)
    toward = cos[piece], sin[piece]
    ex = np.interp(stops, arc, route.points[:, 0]) + beyond * toward[0]
    ey = np.interp(stops, arc, route.points[:, 1]) + beyond * toward[1]
    boxes = Boxes.of(other)
    ox = other.x[:, None] + (other.speed * boxes.cos)[:, None] * ahead
    oy = other.y[:, None] + (other.speed * boxes.sin)[:, None] * ahead
    touching = _touching(ex, ey, toward, ego, ox, oy, (boxes.cos[:, None], boxes.sin[:, None]), other)
    return np.logical_or.reduce(touching, axis=1)


def _touching(
    ax: Array, ay: Array, a_way: _Way, a: Track, bx: Array, by: Array, b_way: _Way, b: Track
) -> NDArray[np.bool_]:
    """Whether boxes overlap, where `b` is wider than it is by `WANDERING` on each side (separating axes)."""
    dx, dy = bx - ax, by - ay
    (ca, sa), (cb, sb) = a_way, b_way
    c, s = np.abs(ca * cb + sa * sb), np.abs(ca * sb - sa * cb)
    al, aw = a.length / 2, a.width / 2
    bl, bw = b.length / 2, b.width / 2 + _wanders(b)
    overlap: NDArray[np.bool_] = np.logical_and.reduce(
        (
            np.abs(dx * ca + dy * sa) <= al + bl * c + bw * s,
            np.abs(dy * ca - dx * sa) <= aw + bl * s + bw * c,
            np.abs(dx * cb + dy * sb) <= bl + al * c + aw * s,
            np.abs(dy * cb - dx * sb) <= bw + al * s + aw * c,
        )
    )
    return overlap


def _visible(episode: Episode, other: Track, *, occlusion: bool = True) -> NDArray[np.bool_]:
    """(T,) Whether the other is near enough to be seen, and nobody and nothing hides it (`chatscene.terms.sight`).

    Without occlusion, only things at the roadside hide it, by the line from centre to centre.
    """
    ego = episode.ego_track
    sight = episode.surroundings.sight(lit=has_lamps(other.kind))
    seen: NDArray[np.bool_] = np.hypot(other.x - ego.x, other.y - ego.y) < sight
    between = [track for track in episode.tracks if track is not other and track is not ego]
    between = [track for track in between if occlusion or track.role is Role.OCCLUDER]
    if not between:
        return seen
    ahead = max(0.0, ego.length / 2 - BEHIND_NOSE) if occlusion else 0.0
    eye = ego.x + ahead * np.cos(ego.heading), ego.y + ahead * np.sin(ego.heading)
    at, high = (EYE * height_of_kind(ego.kind), height_of_kind(other.kind)) if occlusion else (0.0, 0.0)
    cos, sin = np.cos(other.heading), np.sin(other.heading)
    corners = _CORNERS if occlusion else _CORNERS[:, :1]
    along, aside = other.length / 2 * corners[0], other.width / 2 * corners[1]
    points = other.x + along * cos - aside * sin, other.y + along * sin + aside * cos  # (5, T)
    hidden = np.zeros(points[0].shape, dtype=bool)
    for track in between:
        hidden |= _stopped(track, eye, points, at, high)
    return seen & ~hidden.all(axis=0)


_CORNERS = np.array(((0, 1, 1, -1, -1), (0, 1, -1, 1, -1)), dtype=float)[:, :, None]
"""Along and across a box: its middle and its corners."""
_Places = tuple[NDArray[np.float64], NDArray[np.float64]]


def _stopped(track: Track, eye: _Places, points: _Places, at: float, high: float) -> NDArray[np.bool_]:
    """(5, T) Whether lines from an eye to points go through somebody's box, slab by slab.

    Args:
        track: Whose.
        eye: Where it is, (T,).
        points: Where these are, (5, T).
        at: How high the eye is [m].
        high: How high the points are [m].
    """
    cos, sin = np.cos(track.heading), np.sin(track.heading)
    dx, dy = eye[0] - track.x, eye[1] - track.y
    starts = dx * cos + dy * sin, dy * cos - dx * sin
    dx, dy = points[0] - eye[0], points[1] - eye[1]
    enter, leave = np.zeros(dx.shape), np.ones(dx.shape)
    for start, way, half in zip(
        starts, (dx * cos + dy * sin, dy * cos - dx * sin), (track.length / 2, track.width / 2), strict=True
    ):
        along = np.where(np.abs(way) < 1e-12, 1e-12, way)  # a line along a slab divides by nothing
        first, second = (-half - start) / along, (half - start) / along
        enter, leave = np.maximum(enter, np.minimum(first, second)), np.minimum(leave, np.maximum(first, second))
    rise = high - at
    lowest = at + rise * (leave if rise < 0.0 else enter)
    return (enter < leave) & (lowest < height_of_kind(track.kind))
