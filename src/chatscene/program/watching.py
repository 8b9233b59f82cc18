"""An adversary as a watcher sees it: where it is and goes, in the ego's frame and along the ego's route."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache

import numpy as np

from chatscene.maps.sites import BEFORE_SWERVE
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
    """One adversary as a watcher sees it. What is seen of it is worked out when somebody asks, once.

    Attributes:
        track: Its track.
        ego: The ego's track.
        route: The ego's route.
        dt: Step [s].
        signals: At the junction on the route.
        grip: The largest acceleration that the road lets anybody have [m/s²].
        whole: What is seen of it from its beginning, and the step from which this is a part of that (`since`); None of
            the whole.
    """

    track: Track
    ego: Track
    route: Route
    dt: float
    signals: tuple[SignalTrack, ...]
    grip: float
    whole: tuple[Seen, int] | None = None

    def since(self, first: int) -> Seen:
        """What is seen from a step on, as if it began there."""
        signals = tuple(replace(one, state=one.state[first:]) for one in self.signals)
        track, ego = _from(self.track, first), _from(self.ego, first)
        return replace(self, track=track, ego=ego, signals=signals, whole=(self, first))

    @property
    def line(self) -> Polyline:
        """The route's."""
        return self.route.line

    @cached_property
    def _in_frame(self) -> tuple[Array, Array]:
        return in_frame(self.track, self.ego.x[0], self.ego.y[0], self.ego.heading[0])

    @cached_property
    def _on_line(self) -> tuple[Array, Array]:
        return follow(self.line, self.track.x, self.track.y)

    @cached_property
    def along(self) -> Array:
        """(T,) [m], position along the ego's start heading, from the ego's start."""
        return self._in_frame[0] if self.whole is None else self._of_whole("along")

    @cached_property
    def across(self) -> Array:
        """(T,) [m], to the left of it."""
        return self._in_frame[1] if self.whole is None else self._of_whole("across")

    @cached_property
    def offset(self) -> Array:
        """(T,) [m], signed lateral offset from the ego's route."""
        return self._on_line[1] if self.whole is None else self._of_whole("offset")

    @cached_property
    def at(self) -> Array:
        """(T,) [m], how far along the route it is; before its start the route is taken to come straight."""
        if self.whole is not None:
            return self._of_whole("at")
        at = self._on_line[0]
        if float(at.min()) > 0.0:
            return at
        behind, _ = in_frame(self.track, *self.line.point_at(0.0), self.route.start_heading)
        return np.where(at > 0.0, at, np.minimum(behind, 0.0))

    @cached_property
    def aside(self) -> Array:
        """(T,) [m], signed lateral offset from the lane that the ego starts in; as `offset` where it keeps it."""
        return self.offset + _left_by_route(self.route, self.at) if self.whole is None else self._of_whole("aside")

    @cached_property
    def beyond(self) -> Array:
        """(T,) [m], how far along the route it is past the end of the turn at the route's junction.

        On open road, past the route's event.
        """
        return self.at - _turned_at(self.route) if self.whole is None else self._of_whole("beyond")

    @cached_property
    def drift(self) -> Array:
        """(T,) [m], to the left of the line on which it itself began; NaN where no such line is known."""
        if self.whole is not None:
            whole, first = self.whole
            return fixed(whole.drift[first:] - whole.drift[first])
        return _drift(self.track, self.route, self.at, self.offset, self.aside, float(self.facing[0]))

    @cached_property
    def acceleration(self) -> Array:
        """(T,) [m/s²]."""
        return self.track.acceleration(self.dt) if self.whole is None else self._of_whole("acceleration")

    @cached_property
    def bearing(self) -> Array:
        """(T,) [rad], heading against the ego's start heading, in (-pi, pi]."""
        if self.whole is not None:
            return self._of_whole("bearing")
        return (self.track.heading - self.ego.heading[0] + math.pi) % (2 * math.pi) - math.pi

    @cached_property
    def facing(self) -> Array:
        """(T,) [rad], heading against the route where it is; on open road, which may bend, else as `bearing`."""
        if self.whole is not None:
            return self._of_whole("facing")
        if self.route.junction is not None:
            return self.bearing
        return (self.track.heading - self.line.headings_at(self.at) + math.pi) % (2 * math.pi) - math.pi

    @cached_property
    def lead(self) -> Array:
        """(T,) [m], how far along the route it is ahead of the ego."""
        return fixed(self.at - follow(self.line, self.ego.x, self.ego.y)[0])

    def _of_whole(self, name: str) -> Array:
        """What is seen of it, from the step on from which this is seen."""
        assert self.whole is not None
        found: Array = getattr(self.whole[0], name)[self.whole[1] :]
        return found


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
    return Seen(
        track=_until(track, until),
        ego=_until(of or episode.ego_track, until),
        route=route,
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
    if abs(math.sin(facing)) >= math.sin(ALONG):
        return np.full_like(offset, math.nan) if route.site is Site.ROUNDABOUT else _straight(track)
    way = math.copysign(1.0, math.cos(facing))
    beside = (aside - aside[0]) * way
    if route.site is Site.ROUNDABOUT:
        return beside if way > 0.0 else np.full_like(offset, math.nan)
    lines = [beside] if route.junction is None or includes(Place.CURVE, route.place) else [beside, _straight(track)]
    if route.site in LEADS_OVER:
        lines.append((offset - offset[0]) * way)
    drift = min(lines, key=lambda line: float(np.abs(line).max()))
    there = np.flatnonzero((at > 0.0) & (at < route.length))
    if there.size:
        drift[there[-1] + 1 :] = drift[there[-1]]
    return drift


def _straight(track: Track) -> Array:
    """(T,) [m], how far somebody is to the left of where it headed at first."""
    return in_frame(track, track.x[0], track.y[0], track.heading[0])[1]


@lru_cache(maxsize=64)
def headings(line: Polyline) -> Array:
    """(N - 1,) [rad], where each piece of a line leads, without jumps."""
    step = np.diff(line.points, axis=0)
    return fixed(np.unwrap(np.arctan2(step[:, 1], step[:, 0])))


@lru_cache(maxsize=64)
def moved_over(route: Route) -> Array:
    """(N - 1,) [m], how far a route is to the left of a line that bends evenly from its first to its last direction.

    Past a bend it is that line until it is straight again.
    """
    line = route.line
    heading = headings(line)
    along = np.hypot(*np.diff(line.points, axis=0).T)
    even = heading[0] + (heading[-1] - heading[0]) * np.cumsum(along) / along.sum()
    if route.site is Site.PAST_BEND:
        even = np.where(np.cumsum(along) < (1.0 - BEFORE_SWERVE) * route.event_at, heading, heading[-1])
    return fixed(np.cumsum(np.sin(heading - even) * along))


def _left_by_route(route: Route, at: Array) -> Array:
    """How far [m] to the left a route has left its first lane at arc lengths, if it leaves it at all."""
    if route.maneuver not in (*LANE_CHANGES, Maneuver.BYPASS):
        return np.zeros_like(at)
    over = moved_over(route)
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
