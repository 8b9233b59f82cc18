"""Drives in a table: a row per body and step, and the way from episodes to rows and back."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from chatscene.runs.tables import Table
from chatscene.terms.episode import Ending, Episode, Event, EventKind, Role, SignalTrack, Track
from chatscene.terms.surroundings import Surroundings

EPISODES = pa.schema(
    [
        ("scene_id", pa.string()),
        ("ego", pa.string()),
        ("step", pa.int32()),
        ("time", pa.float64()),
        ("actor", pa.string()),
        ("role", pa.string()),
        ("kind", pa.string()),
        ("x", pa.float64()),
        ("y", pa.float64()),
        ("heading", pa.float64()),
        ("speed", pa.float64()),
        ("acceleration", pa.float64()),
        ("yaw_rate", pa.float64()),
        ("length", pa.float64()),
        ("width", pa.float64()),
        # Of the ego only, null for the others: with these the metrics can be computed again from the folder.
        ("distance_to_route", pa.float64()),
        ("off_road", pa.bool_()),
    ]
)


def episodes_table(episodes: Sequence[Episode]) -> Table:
    """One row per scene, actor and step, in that order."""
    tracks = [(episode, track) for episode in episodes for track in episode.tracks]
    lengths = [len(track.x) for _, track in tracks]
    step = _joined((np.arange(length) for length in lengths), np.int32)
    dt = np.repeat(np.array([episode.dt for episode, _ in tracks], dtype=np.float64), lengths)
    ego = np.repeat(np.array([track.role is Role.EGO for _, track in tracks], dtype=np.bool_), lengths)
    columns: dict[str, Any] = {
        "scene_id": _spread((episode.scene_id for episode, _ in tracks), lengths),
        "ego": _spread((episode.ego for episode, _ in tracks), lengths),
        "step": step,
        "time": step * dt,
        "actor": _spread((track.actor for _, track in tracks), lengths),
        "role": _spread((track.role.value for _, track in tracks), lengths),
        "kind": _spread((track.kind for _, track in tracks), lengths),
        "x": _joined(track.x for _, track in tracks),
        "y": _joined(track.y for _, track in tracks),
        "heading": _joined(track.heading for _, track in tracks),
        "speed": _joined(track.speed for _, track in tracks),
        "acceleration": _joined(track.acceleration(episode.dt) for episode, track in tracks),
        "yaw_rate": _joined(track.yaw_rate(episode.dt) for episode, track in tracks),
        "length": np.repeat(np.array([track.length for _, track in tracks], dtype=np.float64), lengths),
        "width": np.repeat(np.array([track.width for _, track in tracks], dtype=np.float64), lengths),
        "distance_to_route": _of_ego([e.distance_to_route for e in episodes], ego, np.float64),
        "off_road": _of_ego([e.off_road for e in episodes], ego, np.bool_),
    }
    return pa.table(columns, schema=EPISODES)


def _spread(values: Iterable[str], lengths: Sequence[int]) -> Any:
    rows = np.repeat(np.arange(len(lengths)), lengths)  # Arrow repeats its own texts twenty times as fast as Python's
    return pa.array(list(values), pa.string()).take(pa.array(rows))


def _joined(arrays: Iterable[NDArray[Any]], kind: type[np.generic] = np.float64) -> NDArray[Any]:
    return np.concatenate([np.empty(0, kind), *arrays], dtype=kind)


def _of_ego(arrays: Sequence[NDArray[Any]], ego: NDArray[np.bool_], kind: type[np.generic]) -> Any:
    """Numbers that only the ego has, with nulls in the rows of the others."""
    values = np.zeros(len(ego), kind)
    values[ego] = _joined(arrays, kind)
    return pa.array(values, mask=~ego)


def episode_of(
    rows: Table,
    scene: Mapping[str, Any],
    events: Iterable[Mapping[str, Any]],
    signals: Iterable[Mapping[str, Any]],
) -> Episode:
    """The episode that a scene's rows of the tables were written from, bit for bit."""
    if not scene["dt"] > 0:
        raise ValueError(f"dt is {scene['dt']:g} s")
    tracks = tuple(_track(rows, start, end) for start, end in _runs_of(rows.column("actor").to_pylist()))
    ego = len(tracks[0].x)
    return Episode(
        scene_id=scene["scene_id"],
        ego=scene["ego"],
        dt=scene["dt"],
        tracks=tracks,
        events=tuple(
            Event(
                kind=EventKind(e["kind"]),
                step=e["step"],
                other=e["other"],
                side=e["side"],
                impact_speed=e["impact_speed"],
                earlier=e.get("earlier") or 0.0,  # older tables have none
            )
            for e in events
        ),
        signals=tuple(
            SignalTrack(x0=s["x0"], y0=s["y0"], x1=s["x1"], y1=s["y1"], state=s["state"], role=s["role"])
            for s in signals
        ),
        ending=Ending(scene["ending"]),
        route_completion=scene["route_completion"],
        distance_to_route=rows.column("distance_to_route")[:ego].to_numpy(),
        off_road=rows.column("off_road")[:ego].to_numpy(),
        surroundings=Surroundings.named(scene),
    )


def tracks_of(rows: Table) -> list[tuple[str, Track]]:
    """Each scene's first track among some rows of an episode table, with the scene's id."""
    names = list(zip(rows.column("scene_id").to_pylist(), rows.column("actor").to_pylist(), strict=True))
    found: dict[str, Track] = {}
    for start, end in _runs_of(names):
        found.setdefault(names[start][0], _track(rows, start, end))
    return list(found.items())


def _runs_of(values: Sequence[object]) -> list[tuple[int, int]]:
    """Start and end of each stretch of equal values."""
    starts = [i for i, value in enumerate(values) if i == 0 or value != values[i - 1]]
    return list(zip(starts, [*starts[1:], len(values)], strict=True))


def _track(rows: Table, start: int, end: int) -> Track:
    own = rows.slice(start, end - start)

    def first(name: str) -> Any:
        return own.column(name)[0].as_py()

    return Track(
        actor=first("actor"),
        role=Role(first("role")),
        kind=first("kind"),
        length=first("length"),
        width=first("width"),
        x=own.column("x").to_numpy(),
        y=own.column("y").to_numpy(),
        heading=own.column("heading").to_numpy(),
        speed=own.column("speed").to_numpy(),
    )
