"""Tracks as a table of text: a row per actor and step, in the order of `episodes/`.

Numbers are written with all their digits, so that they are read back to the last bit.
"""

from __future__ import annotations

import csv
import io
from collections.abc import Mapping

from chatscene.exports.exporter import KeptScene

PLUGIN = {
    "name": "csv",
    "makes": "TracksCsv",
    "what": "the tracks",
    "per scene": "`.csv`",
}

COLUMNS = (
    "time_s",
    "actor",
    "role",
    "kind",
    "length_m",
    "width_m",
    "x_m",
    "y_m",
    "heading_rad",
    "speed_m_per_s",
)


class TracksCsv:
    """One ``.csv`` per scene; SI units stand in the names of the columns, positions are in the map's frame."""

    def files(self, scene: KeptScene) -> Mapping[str, bytes]:
        """The table of a scene."""
        out = io.StringIO()
        rows = csv.writer(out, lineterminator="\n")
        rows.writerow(COLUMNS)
        for track in scene.episode.tracks:
            always = (track.actor, track.role.value, track.kind, track.length, track.width)
            moving = zip(track.x.tolist(), track.y.tolist(), track.heading.tolist(), track.speed.tolist(), strict=True)
            rows.writerows((step * scene.episode.dt, *always, *pose) for step, pose in enumerate(moving))
        return {f"{scene.stem}.csv": out.getvalue().encode()}
