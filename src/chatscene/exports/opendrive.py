"""OpenDRIVE: the map that scenes lie on, once, as it is; beside it what no map can say, when its lights showed what."""

from __future__ import annotations

import csv
import io
from collections.abc import Mapping

from chatscene.exports.exporter import KeptScene
from chatscene.terms.episode import SignalTrack

PLUGIN = {
    "name": "opendrive",
    "makes": "OpenDrive",
    "what": "the map",
    "per scene": "`_signals.csv`: for each traffic light `time_s`, `role`, the end points of the stop line and "
    "`state`, at the start and at each change",
    "also": "the map, `.xodr`",
}

COLUMNS = ("time_s", "role", "x0_m", "y0_m", "x1_m", "y1_m", "state")
_STATES = {"r": "red", "y": "yellow", "g": "green"}


class OpenDrive:
    """The map, and one ``_signals.csv`` per scene with traffic lights; positions are in the map's frame."""

    def files(self, scene: KeptScene) -> Mapping[str, bytes]:
        """The map of a scene; the states of its lights, a row per stop line and change."""
        found = {scene.map.name: scene.map.content}
        if scene.episode.signals:
            out = io.StringIO()
            rows = csv.writer(out, lineterminator="\n")
            rows.writerow(COLUMNS)
            for signal in scene.episode.signals:
                always = (signal.role, signal.x0, signal.y0, signal.x1, signal.y1)
                rows.writerows((step * scene.episode.dt, *always, state) for step, state in _changes(signal))
            found[f"{scene.stem}_signals.csv"] = out.getvalue().encode()
        return found


def _changes(signal: SignalTrack) -> list[tuple[int, str]]:
    """What a light shows at first, and what from each step on at which it changes."""
    before = (" ", *signal.state)
    return [(i, _STATES[now]) for i, (was, now) in enumerate(zip(before, signal.state, strict=False)) if was != now]
