"""An adversary as a watcher sees it: where it is and goes, in the ego's frame and along the ego's route."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from chatscene.terms.episode import Array, Episode, SignalTrack, Track
from chatscene.terms.polyline import Polyline
from chatscene.terms.route import Route


@dataclass(frozen=True, slots=True)
class Seen:
    """One adversary as a watcher sees it.

    Attributes:
        track: Its track.
        ego: The ego's track.
        along: (T,) [m], position along the ego's start heading, from the ego's start.
        across: (T,) [m], to the left of it.
        offset: (T,) [m], signed lateral offset from the ego's route.
        lead: (T,) [m], how far along the route it is ahead of the ego.
        drift: (T,) [m], to the left of the line on which the adversary itself began.
        acceleration: (T,) [m/s²].
        bearing: (T,) [rad], heading against the ego's start heading, in (-pi, pi].
        facing: (T,) [rad], heading against the route where it is; on open road, which may bend, else as `bearing`.
        dt: Step [s].
        signals: At the junction on the route.
        grip: The largest acceleration that the road lets anybody have [m/s²].
    """

    track: Track
    ego: Track
    along: Array
    across: Array
    offset: Array
    lead: Array
    drift: Array
    acceleration: Array
    bearing: Array
    facing: Array
    dt: float
    signals: tuple[SignalTrack, ...]
    grip: float


def watch(episode: Episode, route: Route, track: Track, until: int | None = None) -> Seen:
    """See one adversary of an episode in the ego's frame, to the end or until a step, which is seen too."""
    ego, track = _until(episode.ego_track, until), _until(track, until)
    along, across = in_frame(track, ego.x[0], ego.y[0], ego.heading[0])
    at, offset = _on_line(route.line, track)
    behind, _ = in_frame(track, *route.line.point_at(0.0), route.start_heading)
    at = np.where(at > 0.0, at, np.minimum(behind, 0.0))  # before its start the route is taken to come straight
    bearing = (track.heading - ego.heading[0] + math.pi) % (2 * math.pi) - math.pi
    facing = bearing
    if route.junction is None:
        there = np.array([route.line.heading_at(float(s)) for s in at])
        facing = (track.heading - there + math.pi) % (2 * math.pi) - math.pi
    _, drift = in_frame(track, track.x[0], track.y[0], track.heading[0])
    return Seen(
        track=track,
        ego=ego,
        along=along,
        across=across,
        offset=offset,
        lead=at - _on_line(route.line, ego)[0],
        drift=drift,
        acceleration=track.acceleration(episode.dt),
        bearing=bearing,
        facing=facing,
        dt=episode.dt,
        signals=episode.signals,
        grip=episode.surroundings.grip,
    )


def _until(track: Track, step: int | None) -> Track:
    if step is None:
        return track
    x, y, heading, speed = (row[: step + 1] for row in (track.x, track.y, track.heading, track.speed))
    return replace(track, x=x, y=y, heading=heading, speed=speed)


def _on_line(line: Polyline, track: Track) -> tuple[Array, Array]:
    """(T,) arc length and (T,) signed lateral offset [m] of an actor on a line."""
    found = np.empty((2, len(track.x)))
    near: int | None = None
    for i, (x, y) in enumerate(zip(track.x.tolist(), track.y.tolist(), strict=True)):
        found[0, i], found[1, i], near = line.project(x, y, near)
    return found[0], found[1]


def in_frame(track: Track, x: float, y: float, heading: float) -> tuple[Array, Array]:
    """(T,) [m] ahead and (T,) [m] to the left of a pose."""
    dx, dy = track.x - x, track.y - y
    cos, sin = math.cos(heading), math.sin(heading)
    return dx * cos + dy * sin, dy * cos - dx * sin
