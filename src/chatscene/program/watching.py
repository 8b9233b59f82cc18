"""An adversary as a watcher sees it: where it is and goes, in the ego's frame and along the ego's route."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache

import numpy as np

from chatscene.simulate.native.lines import follow
from chatscene.terms.arrays import Array, fixed
from chatscene.terms.conclusions import LANE_CHANGES
from chatscene.terms.episode import Episode, SignalTrack, Track
from chatscene.terms.polyline import Polyline
from chatscene.terms.route import Route
from chatscene.terms.scenario import Maneuver, Place, Site, includes

MOST = 0.9  # of the turn at a junction: after it, a road user is seen to be in the street that is turned into
IS_TURN = math.radians(30)
ALONG = math.radians(30)  # of the road's direction, or of the other: who heads so goes along it
LEADS_OVER = frozenset((Site.ON_RAMP, Site.OFF_RAMP, Site.LANE_DROP))
"""Where whoever goes along the ego's way moves over with it."""
CROSSED = 8.0  # [m] behind the entry of a junction: nobody who is farther is before it


@dataclass(frozen=True)
class Seen:
    """One adversary as a watcher sees it.

    Attributes:
        track: Its track.
        ego: The ego's track.
        along: (T,) [m], position along the ego's start heading, from the ego's start.
        across: (T,) [m], to the left of it.
        offset: (T,) [m], signed lateral offset from the ego's route.
        aside: (T,) [m], signed lateral offset from the lane that the ego starts in; as `offset` where it keeps it.
        beyond: (T,) [m], how far along the route it is past the end of the turn at the route's junction; on open road,
            past the route's event.
        at: (T,) [m], how far along the route it is; before its start the route is taken to come straight.
        line: The route's.
        drift: (T,) [m], to the left of the line on which the adversary itself began; NaN where no such line is known.
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
    aside: Array
    beyond: Array
    at: Array
    line: Polyline
    drift: Array
    acceleration: Array
    bearing: Array
    facing: Array
    dt: float
    signals: tuple[SignalTrack, ...]
    grip: float

    def since(self, first: int) -> Seen:
        """What is seen from a step on, as if it began there."""
        rows = ("along", "across", "offset", "aside", "beyond", "at", "acceleration", "bearing", "facing")
        return replace(
            self,
            track=_from(self.track, first),
            ego=_from(self.ego, first),
            drift=fixed(self.drift[first:] - self.drift[first]),
            signals=tuple(replace(one, state=one.state[first:]) for one in self.signals),
            **{name: getattr(self, name)[first:] for name in rows},
        )

    @cached_property
    def lead(self) -> Array:
        """(T,) [m], how far along the route it is ahead of the ego."""
        return fixed(self.at - follow(self.line, self.ego.x, self.ego.y)[0])


def _from(track: Track, first: int) -> Track:
    x, y, heading, speed = (row[first:] for row in (track.x, track.y, track.heading, track.speed))
    return replace(track, x=x, y=y, heading=heading, speed=speed)


def watch(episode: Episode, route: Route, track: Track, until: int | None = None, *, of: Track | None = None) -> Seen:
    """See one adversary of an episode in the ego's frame, to the end or until a step, which is seen too.

    Args:
        episode: What happened.
        route: The ego's.
        track: Of whom.
        until: The last step that is seen.
        of: Who is in the place of the ego, to see what is done to somebody else.
    """
    ego, track = _until(of or episode.ego_track, until), _until(track, until)
    along, across = in_frame(track, ego.x[0], ego.y[0], ego.heading[0])
    at, offset = follow(route.line, track.x, track.y)
    behind, _ = in_frame(track, *route.line.point_at(0.0), route.start_heading)
    at = np.where(at > 0.0, at, np.minimum(behind, 0.0))
    bearing = (track.heading - ego.heading[0] + math.pi) % (2 * math.pi) - math.pi
    facing = bearing
    if route.junction is None:
        facing = (track.heading - route.line.headings_at(at) + math.pi) % (2 * math.pi) - math.pi
    aside = offset + _left_by_route(route, at)
    return Seen(
        track=track,
        ego=ego,
        along=along,
        across=across,
        offset=offset,
        aside=aside,
        beyond=at - _turned_at(route),
        at=at,
        line=route.line,
        drift=_drift(track, route, at, offset, aside, float(facing[0])),
        acceleration=track.acceleration(episode.dt),
        bearing=bearing,
        facing=facing,
        dt=episode.dt,
        signals=episode.signals,
        grip=episode.surroundings.grip,
    )


def _drift(track: Track, route: Route, at: Array, offset: Array, aside: Array, facing: float) -> Array:
    """(T,) [m], how far somebody is to the left of the line on which it began, which bends as the road does.

    Who begins along the ego's road, or against it, keeps to that road or goes straight on, whichever moves it less: at
    a junction its road may leave the ego's. On a ramp the way itself leads over. In a roundabout nobody goes straight
    on, and of who comes by another way than the ego no line is known (NaN); nor is it before or beyond the ego's way.
    """
    _, straight = in_frame(track, track.x[0], track.y[0], track.heading[0])
    if abs(math.sin(facing)) >= math.sin(ALONG):
        return np.full_like(straight, math.nan) if route.site is Site.ROUNDABOUT else straight
    way = math.copysign(1.0, math.cos(facing))
    beside = (aside - aside[0]) * way
    if route.site is Site.ROUNDABOUT:
        return beside if way > 0.0 else np.full_like(straight, math.nan)
    lines = [beside] if includes(Place.CURVE, route.place) else [beside, straight]
    if route.site in LEADS_OVER:
        lines.append((offset - offset[0]) * way)
    drift = min(lines, key=lambda line: float(np.abs(line).max()))
    there = np.flatnonzero((at > 0.0) & (at < route.length))
    if there.size:
        drift[there[-1] + 1 :] = drift[there[-1]]
    return drift


@lru_cache(maxsize=64)
def headings(line: Polyline) -> Array:
    """(N - 1,) [rad], where each piece of a line leads, without jumps."""
    step = np.diff(line.points, axis=0)
    return fixed(np.unwrap(np.arctan2(step[:, 1], step[:, 0])))


@lru_cache(maxsize=64)
def moved_over(line: Polyline) -> Array:
    """(N - 1,) [m], how far a line is to the left of one that bends evenly from its first to its last direction."""
    heading = headings(line)
    along = np.hypot(*np.diff(line.points, axis=0).T)
    even = heading[0] + (heading[-1] - heading[0]) * np.cumsum(along) / along.sum()
    return fixed(np.cumsum(np.sin(heading - even) * along))


def _left_by_route(route: Route, at: Array) -> Array:
    """How far [m] to the left a route has left its first lane at arc lengths, if it leaves it at all."""
    if route.maneuver not in (*LANE_CHANGES, Maneuver.BYPASS):
        return np.zeros_like(at)
    over = moved_over(route.line)
    return np.interp(at, np.linspace(0.0, route.length, len(over)), over)


def _turned_at(route: Route) -> float:
    """Arc length [m] at which a route has done most of its turn at a junction."""
    return route.event_at if route.junction is None else max(route.event_at + CROSSED, _turned_on(route.line))


@lru_cache(maxsize=64)
def _turned_on(line: Polyline) -> float:
    """Arc length [m] at which a line has done most of its turn; 0 of one that hardly turns."""
    heading = headings(line)
    turned = np.abs(heading - heading[0])
    done = int(np.argmax(turned > MOST * turned.max())) if turned.max() > IS_TURN else 0
    return float(done) * line.length / len(heading)


def _until(track: Track, step: int | None) -> Track:
    if step is None:
        return track
    x, y, heading, speed = (row[: step + 1] for row in (track.x, track.y, track.heading, track.speed))
    return replace(track, x=x, y=y, heading=heading, speed=speed)


def in_frame(track: Track, x: float, y: float, heading: float) -> tuple[Array, Array]:
    """(T,) [m] ahead and (T,) [m] to the left of a pose."""
    dx, dy = track.x - x, track.y - y
    cos, sin = math.cos(heading), math.sin(heading)
    return dx * cos + dy * sin, dy * cos - dx * sin


def percentile(values: Array, of: float) -> float:
    """`np.percentile` of numbers, to the bit, in a fifth of its time: every drive is asked for it."""
    ordered, at = np.sort(values), (len(values) - 1) * (of / 100)
    below = int(at)
    low, high, share = float(ordered[below]), float(ordered[min(below + 1, len(values) - 1)]), at - below
    return high - (high - low) * (1 - share) if share >= 0.5 else low + (high - low) * share
