"""Drives and the map around them as compact JSON for the replay: whole centimetres, differences, no repeats."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping, Sequence
from itertools import groupby
from typing import Any

import numpy as np
import shapely

from chatscene.report.span import span
from chatscene.simulate.boxes import gaps, times_to_collision
from chatscene.terms.actors import Manner, manner_of, noun_of
from chatscene.terms.arrays import Array
from chatscene.terms.criticality import LONGEST
from chatscene.terms.episode import Episode, Event, EventKind, Role, SignalTrack, Track, contact_point

MARGIN = 70.0  # [m] of map around a drive
TOLERANCE = 0.03  # [m] by which a line of the map may be off
NEVER = -1  # in place of a time to collision where the two never would touch
AFTER = 4.0  # [s] that a drive beside another goes on after that has ended

Box = tuple[float, float, float, float]


def pack_episode(episode: Episode) -> dict[str, Any]:
    """One drive. Positions [cm], headings [mrad], speeds [cm/s]; see `_differences` for how numbers are kept."""
    part = span(episode)
    return {
        "dt": episode.dt,
        "steps": len(episode.ego_track.x),
        "span": [part.first, part.moment, part.last],
        "actors": [_pack_track(track) for track in episode.tracks],
        "signals": [_pack_signal(signal) for signal in episode.signals],
        "events": [_pack_event(episode, event) for event in episode.events],
        "near": _pack_nearness(episode),
    }


def pack_beside(episode: Episode, shown: Episode) -> dict[str, Any]:
    """A drive of the same scene by another ego: that ego, and whom the ego that is shown meets, as `pack_episode`."""
    other = met(shown)
    names = {episode.ego_track.actor, other.actor if other else ""}
    until = len(shown.ego_track.x) + round(AFTER / shown.dt)
    return {
        "steps": min(len(episode.ego_track.x), until),
        "actors": [_pack_track(track, until) for track in episode.tracks if track.actor in names],
    }


def met(episode: Episode) -> Track | None:
    """Whom the ego meets: whom it collides with, else its adversary; None where it is alone."""
    crash = episode.collision
    others = [track for track in episode.tracks if crash is not None and track.actor == crash.other]
    return next(iter((*others, *episode.adversaries)), None)


def called(role: Role, kind: str) -> str:
    """What somebody or something is called: by its class, and a vehicle that hides others is parked."""
    parked = role is Role.OCCLUDER and manner_of(kind) in (Manner.DRIVES, Manner.RIDES)
    return f"parked {noun_of(kind)}" if parked else noun_of(kind)


def _pack_nearness(episode: Episode) -> dict[str, Any]:
    """Gap [cm] and time to collision [0.01 s, `NEVER` where there is none] to whom the ego meets, step by step."""
    other = met(episode)
    if other is None:
        return {"gap": [], "time": []}
    left = times_to_collision(episode.ego_track, other)
    return {
        "gap": _differences(gaps(episode.ego_track, other), 100),
        "time": _differences(np.where(left <= LONGEST, left, NEVER / 100), 100),
    }


def size_of(packed: Mapping[str, Any]) -> int:
    """How many bytes it takes on the page."""
    return len(json.dumps(packed, separators=(",", ":")))


def _pack_track(track: Track, until: int | None = None) -> dict[str, Any]:
    return {
        "name": track.actor,
        "role": track.role.value,
        "kind": track.kind,
        "length": round(track.length, 2),
        "width": round(track.width, 2),
        "x": _differences(track.x[:until], 100),
        "y": _differences(track.y[:until], 100),
        "heading": _differences(track.heading[:until], 1000),
        "speed": _differences(track.speed[:until], 100),
    }


def _differences(values: Array, scale: float) -> list[int]:
    """First value and differences, in units of 1/scale; trailing zeros dropped, so standing still costs nothing."""
    whole = np.rint(np.asarray(values) * scale).astype(np.int64)
    steps = np.diff(whole, prepend=0)
    moving = np.flatnonzero(steps)
    return steps[: moving[-1] + 1].tolist() if len(moving) else []


def _pack_signal(signal: SignalTrack) -> dict[str, Any]:
    return {
        "line": [round(value, 2) for value in (signal.x0, signal.y0, signal.x1, signal.y1)],
        "role": signal.role,
        "states": [[state, len(list(run))] for state, run in groupby(signal.state)],
    }


def _pack_event(episode: Episode, event: Event) -> dict[str, Any]:
    packed: dict[str, Any] = {
        "kind": event.kind.value,
        "step": event.step,
        "other": event.other,
        "side": event.side,
        "impact": round(event.impact_speed, 2),
    }
    if event.kind is EventKind.COLLISION:
        packed["at"] = contact_point(episode, event)
    return packed


def extent(episode: Episode, margin: float = MARGIN) -> Box:
    """West, south, east, north [m] of where the ego and its adversaries were, with a margin."""
    actors = [track for track in episode.tracks if track.role in (Role.EGO, Role.ADVERSARY)]
    x = np.concatenate([track.x for track in actors])
    y = np.concatenate([track.y for track in actors])
    return x.min() - margin, y.min() - margin, x.max() + margin, y.max() + margin


def pack_drawing(drawing: Mapping[str, Any], boxes: Sequence[Box]) -> dict[str, Any]:
    """The parts of the map's drawing that reach into any of the boxes, in differences of centimetres."""
    around = shapely.union_all([shapely.box(*box) for box in sorted(set(boxes))])
    packed: dict[str, Any] = {
        kind: [[_pack_line(ring) for ring in area] for area in drawing.get(kind, ()) if _reaches(area[0], around)]
        for kind in _AREAS
    }
    packed["lane_boundaries"] = [
        {"kind": line["kind"], "points": _pack_line(line["points"])}
        for line in drawing.get("lane_boundaries", ())
        if _reaches(line["points"], around)
    ]
    packed["stop_lines"] = [
        _pack_line(line["points"]) for line in drawing.get("stop_lines", ()) if _reaches(line["points"], around)
    ]
    packed["routes"] = {name: _pack_line(line) for name, line in drawing.get("routes", {}).items()}
    return packed


_AREAS = ("sidewalks", "shoulders", "driveways", "cycle_lanes", "roads", "junctions", "crosswalks", "rails")


def _reaches(points: Sequence[Sequence[float]], area: Any) -> bool:
    return len(points) > 1 and bool(shapely.box(*shapely.MultiPoint(points).bounds).intersects(area))


def _pack_line(points: Iterable[Sequence[float]]) -> list[int]:
    """x, y of the first point, then differences, alternating."""
    line = shapely.LineString([(x, y) for x, y, *_ in points]).simplify(TOLERANCE)
    whole = np.rint(np.asarray(line.coords) * 100).astype(np.int64)
    return np.diff(whole, axis=0, prepend=np.zeros((1, 2), np.int64)).ravel().tolist()
