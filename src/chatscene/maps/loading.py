"""The roads of a map for all who need no Scenic, kept between processes."""

from __future__ import annotations

import hashlib
from functools import lru_cache
from pathlib import Path

from chatscene.errors import MapError
from chatscene.files.caches import cache_folder, keep, keep_latest, kept, only_mine, sealed
from chatscene.maps.network import MapContent, load_network, map_digest
from chatscene.maps.roads import Roads
from chatscene.maps.roads_file import made_by, read, written

ENDING = ".roads"
VERSIONS = 3  # of the roads of a map that are kept


def load_roads(path: Path | str) -> Roads:
    """The roads of a map, read once per process and file content.

    What Scenic makes of the map is kept as plain numbers beside the copy of the map, sealed. A file that is damaged or
    of another version is made anew.

    Raises:
        MapError: As `chatscene.maps.network.load_network`.
    """
    return kept_roads(MapContent.of(Path(path)))


@lru_cache(maxsize=8)
def kept_roads(content: MapContent) -> Roads:
    """The roads of a map, from their file if that is whole."""
    digest, path = content.digest, content.path
    folder = only_mine(cache_folder("maps") / digest)
    named = f"{hashlib.blake2b(made_by(), digest_size=12).hexdigest()}{ENDING}"
    if folder is not None and (found := kept(folder / named)) is not None:
        return read(found)
    made = written(load_network(path))
    if map_digest(path) != digest:
        raise MapError(f"map {path.name!r} was changed while it was read; start again ({path})")
    if folder is not None:
        keep(folder / named, sealed(made))
        keep_latest(folder, VERSIONS, ENDING)
    return read(made)
