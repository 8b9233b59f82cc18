"""What happened in one drive: tracks, events, ending."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum

import numpy as np
from numpy.typing import NDArray

from chatscene.terms.arrays import Array, changes_at
from chatscene.terms.surroundings import Surroundings


class Role(StrEnum):
    """The part an actor plays."""

    EGO = "ego"
    ADVERSARY = "adversary"
    BACKGROUND = "background"
    OCCLUDER = "occluder"


AT_REST = 0.1  # [m/s], slower than which somebody stands when a drive is over
QUIET = 2.0  # [s] for which nothing happens any more before it is
OTHER = "other"  # the name of whoever acts beside the adversary, as a text says


class EventKind(StrEnum):
    """Things that happen to the ego (SafeBench's criteria; paper, appendix C)."""

    COLLISION = "collision"
    RED_LIGHT = "red-light"
    STOP_SIGN = "stop-sign"
    OFF_ROAD = "off-road"
    LANE_INVASION = "lane-invasion"


class Ending(StrEnum):
    """Why an episode ended."""

    COLLISION = "collision"
    ARRIVED = "arrived"
    TIMEOUT = "timeout"
    SCENARIO_DONE = "scenario-done"  # the Scenic program ended it
    OVER = "over"  # nothing is to come any more, and nobody can meet the ego


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Track:
    """One actor's motion; T steps, row 0 is the state before the first step.

    Attributes:
        actor: Name unique in the episode: ``ego``, ``adversary``, ``leader``, ``blocker-1``, …
        kind: Class name in the world model, e.g. ``Car``, ``Pedestrian``, ``BusStop``.
        length: Size along its heading [m].
        width: Size across [m].
        x: (T,) [m], map frame, centre of the actor.
        y: (T,) [m].
        heading: (T,) [rad, 0 = +x, counter-clockwise], unwrapped.
        speed: (T,) [m/s], along the heading; negative when reversing.
    """

    actor: str
    role: Role
    kind: str
    length: float
    width: float
    x: Array
    y: Array
    heading: Array
    speed: Array

    def acceleration(self, dt: float) -> Array:
        """(T,) [m/s²] along the heading; 0 in row 0."""
        return changes_at(self.speed) / dt

    def pose(self, step: int, earlier: float = 0.0) -> tuple[float, float, float]:
        """X, y [m] and heading [rad] at a step, or at the last; or a share of a step earlier."""
        now = min(step, len(self.x) - 1)
        x, y, heading = float(self.x[now]), float(self.y[now]), float(self.heading[now])
        if earlier and now:
            x += (float(self.x[now - 1]) - x) * earlier
            y += (float(self.y[now - 1]) - y) * earlier
            heading += (float(self.heading[now - 1]) - heading) * earlier
        return x, y, heading

    def yaw_rate(self, dt: float) -> Array:
        """(T,) [rad/s]; 0 in row 0."""
        return changes_at(self.heading) / dt


@dataclass(frozen=True, slots=True, kw_only=True)
class Event:
    """One event of the ego.

    Attributes:
        other: With whom or what: an actor, a signal or a lane marking; empty where nothing.
        side: For a collision, where on the ego: ``front``, ``rear``, ``left`` or ``right``; else empty.
        impact_speed: For a collision, the speed of approach [m/s] as the step began in which they met; else 0.
        earlier: For a collision, how long before the step the two began to touch, as a share of a step; 0 where only
            the state at the step was looked at. They may have parted again before the step.
    """

    kind: EventKind
    step: int
    other: str = ""
    side: str = ""
    impact_speed: float = 0.0
    earlier: float = 0.0


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class SignalTrack:
    """The state of one traffic signal on the ego's way over time.

    Attributes:
        x0, y0, x1, y1: The ends of its stop line [m].
        state: (T,) of "r", "y", "g", as one string.
        role: ``ego`` if it is the ego's own, else ``other``.
    """

    x0: float
    y0: float
    x1: float
    y1: float
    state: str
    role: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Stepped:
    """Who stepped a drive.

    Attributes:
        by: The name of the simulator; empty where that is not known, as of an episode that was read from a folder.
        instead: Why it was not the one that was asked for; empty where it was.
    """

    by: str = ""
    instead: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class Reached:
    """How far somebody is in a plan.

    Attributes:
        phase: The number of the phase, from 0; as many as there are where all are done.
    """

    behavior: str
    phase: int


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Episode:
    """One drive of one ego through one scene.

    Attributes:
        dt: Step [s].
        tracks: The ego's first, then the adversaries', then the rest.
        signals: Traffic signals at the junction on the route, if any.
        route_completion: Share of the route driven, in [0, 1].
        distance_to_route: (T,) [m], lateral, unsigned.
        off_road: (T,) bool: the ego's centre was off every driving lane.
        surroundings: Light, weather and the state of the road.
        stepped: Who stepped it, which changes no number of it.
        reached: How far everybody who follows a plan of the program's own was in it at the end, by actor; no run folder
            keeps it.
    """

    scene_id: str
    ego: str
    dt: float
    tracks: tuple[Track, ...]
    events: tuple[Event, ...]
    signals: tuple[SignalTrack, ...]
    ending: Ending
    route_completion: float
    distance_to_route: Array
    off_road: NDArray[np.bool_]
    surroundings: Surroundings = field(default_factory=Surroundings)
    stepped: Stepped = field(default_factory=Stepped)
    reached: Mapping[str, Reached] = field(default_factory=dict[str, Reached])

    @property
    def ego_track(self) -> Track:
        """The ego's own track."""
        return self.tracks[0]

    @property
    def kinds(self) -> dict[str, str]:
        """The class of everybody but the ego, by name."""
        return {track.actor: track.kind for track in self.tracks if track.role is not Role.EGO}

    @property
    def adversaries(self) -> tuple[Track, ...]:
        """The tracks of the adversaries."""
        return tuple(track for track in self.tracks if track.role is Role.ADVERSARY)

    @property
    def collision(self) -> Event | None:
        """The first collision, if there was one."""
        return next((e for e in self.events if e.kind is EventKind.COLLISION), None)

    @property
    def completion(self) -> float:
        """Share of the route that counts as driven, in [0, 1]: all of it, where the drive was over with the ego on it.

        Nothing kept that ego from going on. One that stood when all was over has driven what it has.
        """
        went_on = self.ending is Ending.OVER and abs(float(self.ego_track.speed[-1])) >= AT_REST
        return 1.0 if went_on else self.route_completion

    @property
    def duration(self) -> float:
        """Simulated time [s]."""
        return (len(self.ego_track.x) - 1) * self.dt

    def __repr__(self) -> str:
        return (
            f"Episode({self.scene_id}, {self.ego}, {len(self.ego_track.x)} steps, "
            f"{len(self.tracks)} actors, {self.ending})"
        )


def contact_point(episode: Episode, event: Event) -> list[float]:
    """Where the ego was hit [m]: the point of its box nearest to the centre of what it hit."""
    ego = episode.ego_track
    step = min(event.step, len(ego.x) - 1)
    x, y, heading = ego.pose(step, event.earlier)
    other = next((track for track in episode.tracks if track.actor == event.other), ego)
    other_x, other_y, _ = other.pose(step, event.earlier)
    dx, dy = other_x - x, other_y - y
    cos, sin = math.cos(heading), math.sin(heading)
    along = min(max(dx * cos + dy * sin, -ego.length / 2), ego.length / 2)
    across = min(max(dy * cos - dx * sin, -ego.width / 2), ego.width / 2)
    return [round(x + along * cos - across * sin, 2), round(y + along * sin + across * cos, 2)]
