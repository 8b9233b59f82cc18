"""Kept scenes as the files of other tools, small enough to lie in a page."""

from __future__ import annotations

import base64
import json
import zlib
from collections.abc import Sequence
from pathlib import Path

from chatscene.errors import ChatSceneError
from chatscene.exports.export import kept_scenes
from chatscene.exports.exporter import load_exporter

FORMATS = {"scenic": "Scenic", "openscenario": "OpenSCENARIO", "csv": "CSV"}  # exporters, and what they are called
FILES_BYTES = 400_000  # of files on one page


def pack_files(folder: Path, scene_ids: Sequence[str]) -> dict[str, str]:
    """Scenes of a run as `chatscene export` writes them, without the map, as compressed text.

    Returns:
        By scene: base 64 of what zlib makes of a JSON object: by format the file's ``name`` and ``text``, or ``why``
        there is none.
    """
    packed: dict[str, str] = {}
    left = FILES_BYTES
    if not scene_ids:
        return packed
    exporters = {name: load_exporter(name) for name in FORMATS}
    try:
        scenes = {scene.episode.scene_id: scene for scene in kept_scenes(folder, scene_ids)}
    except ChatSceneError:
        return packed  # without the map the page has the command, which says what is the matter
    for scene_id in scene_ids:
        scene, files = scenes[scene_id], dict[str, dict[str, str]]()
        for name, exporter in exporters.items():
            try:
                made = exporter.files(scene)
            except ChatSceneError as error:
                files[name] = {"why": str(error)}
                continue
            (file,) = made.keys() - {scene.map.name}
            files[name] = {"name": file, "text": made[file].decode()}
        content = json.dumps(files, separators=(",", ":"), ensure_ascii=False).encode()
        text = base64.b64encode(zlib.compress(content, 9)).decode()
        left -= len(text)
        if left < 0:
            break
        packed[scene_id] = text
    return packed
