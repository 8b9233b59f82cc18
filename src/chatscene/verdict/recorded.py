"""A recording as a drive: the ego's way from where it went, and the first contact from the bodies."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from chatscene.imports.recording import DT, Recording
from chatscene.simulate.boxes import Boxes, Pair
from chatscene.simulate.contact import side_touched
from chatscene.terms.arrays import Array
from chatscene.terms.episode import Ending, Episode, Event, EventKind, Track
from chatscene.terms.polyline import Polyline
from chatscene.terms.route import Route
from chatscene.terms.scenario import Control, Maneuver, Place
from chatscene.verdict.watched import Watched

APART = 1.0  # [m] between points of a way
ONWARD = 100.0  # [m] that a way goes straight on where the ego was last
TURNS = math.radians(45)  # by which an ego turns that does so at a junction
BEGINS = math.radians(10)  # by which it has turned where that begins
PARTS = 10  # of a step, at whose ends it is seen whether two touch
FEWEST = 10  # points of a way of which a turn is told


def watch_recording(found: Recording, name: str) -> Watched:
    """A recording as a drive that was watched; where no map is known, the route is the way that the ego went."""
    route = way_of(found.tracks[0], name)
    episode = Episode(
        scene_id=name,
        ego="recorded",
        dt=DT,
        tracks=found.tracks,
        events=(),
        signals=(),
        ending=Ending.TIMEOUT,
        route_completion=1.0,
        distance_to_route=np.zeros(len(found.tracks[0].x)),
        off_road=np.zeros(len(found.tracks[0].x), dtype=np.bool_),
    )
    crash = _collision(found.tracks)
    if crash is not None:
        episode = _until(replace(episode, events=(crash,), ending=Ending.COLLISION), crash.step + 1)
    return Watched(episode=episode, route=route, mapped=False, tested=False)


def way_of(ego: Track, name: str) -> Route:
    """The way that an ego went, and straight on from where it was last."""
    moved = _apart(ego.x, ego.y)
    x, y = ego.x[moved], ego.y[moved]
    heading = float(ego.heading[-1])
    beyond = np.arange(APART, ONWARD, APART)
    x = np.concatenate((x, x[-1] + beyond * math.cos(heading)))
    y = np.concatenate((y, y[-1] + beyond * math.sin(heading)))
    line = Polyline(list(zip(x.tolist(), y.tolist(), strict=True)))
    turned = ego.heading[moved] - ego.heading[0]
    far = abs(float(turned[-1]))
    maneuver, at = Maneuver.STRAIGHT, line.length / 2
    if len(moved) >= FEWEST and far > TURNS:
        maneuver = Maneuver.LEFT_TURN if turned[-1] > 0 else Maneuver.RIGHT_TURN
        at = float(np.argmax(np.abs(turned) > BEGINS)) * APART
    place = Place.JUNCTION if maneuver is not Maneuver.STRAIGHT else Place.ROAD
    return Route(
        id=name,
        map_name="",
        maneuver=maneuver,
        place=place,
        control=Control.NONE,
        line=line,
        lane_ids=(),
        event_at=at,
        junction="recorded" if place is Place.JUNCTION else None,
    )


def _apart(x: Array, y: Array) -> list[int]:
    """Steps at which somebody has gone so far since the last of them."""
    steps = [0]
    for step in range(1, len(x)):
        if math.hypot(x[step] - x[steps[-1]], y[step] - y[steps[-1]]) >= APART:
            steps.append(step)
    return steps


def _collision(tracks: tuple[Track, ...]) -> Event | None:
    """The first contact of the ego; who touches it as soon as it is there is a part of it, or its load."""
    ego, *others = tracks
    first: tuple[int, Track] | None = None
    for other in others:
        touching = _touching(ego, other)
        if touching.any() and not touching[np.argmax(np.isfinite(other.x))]:
            step = int(np.argmax(touching))
            first = (step, other) if first is None or step < first[0] else first
    if first is None:
        return None
    step, other = first
    before = step - 1
    speed, its = float(ego.speed[before]), float(other.speed[before])
    heading, turned = float(ego.heading[before]), float(other.heading[before])
    vx = speed * math.cos(heading) - its * math.cos(turned)
    vy = speed * math.sin(heading) - its * math.sin(turned)
    return Event(
        kind=EventKind.COLLISION,
        step=step,
        other=other.actor,
        side=side_touched(ego, other, step),
        impact_speed=math.hypot(vx, vy),
    )


def _touching(ego: Track, other: Track) -> NDArray[np.bool_]:
    """(T,) Whether two touch at a step, or came to touch since the one before: who grazes, touches between two."""
    touching = Pair.of(Boxes.of(ego), Boxes.of(other)).touching.copy()
    gone = sum(np.hypot(np.diff(one.x), np.diff(one.y)) for one in (ego, other))
    room = sum(math.hypot(one.length, one.width) / 2 for one in (ego, other))
    apart = np.hypot(other.x - ego.x, other.y - ego.y)
    near = np.flatnonzero(np.minimum(apart[:-1], apart[1:]) < room + gone)
    if near.size:
        moments = (near[:, None] + np.arange(1, PARTS) / PARTS).ravel()
        between = Pair.of(Boxes.within(ego, moments), Boxes.within(other, moments)).touching
        touching[near + 1] |= between.reshape(near.size, PARTS - 1).any(axis=1)
    return touching


def _until(episode: Episode, steps: int) -> Episode:
    """A drive that ends with its first contact, as one of ours does."""

    def part(track: Track) -> Track:
        x, y, heading, speed = (row[:steps] for row in (track.x, track.y, track.heading, track.speed))
        return replace(track, x=x, y=y, heading=heading, speed=speed)

    return replace(
        episode,
        tracks=tuple(map(part, episode.tracks)),
        distance_to_route=episode.distance_to_route[:steps],
        off_road=episode.off_road[:steps],
    )
