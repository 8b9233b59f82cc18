"""Roads laid to order: the file of a road that a map's name says.

``road:2+2,median=4,bend=left-250`` is a map: two lanes each way, four metres of grass between them, a bend to the left
with a radius of 250 m. The name says all of it, so that whoever has the name can lay the same road, byte for byte.
"""

from __future__ import annotations

import hashlib
from contextlib import suppress
from functools import cache, lru_cache
from pathlib import Path
from tempfile import TemporaryDirectory

from chatscene.errors import MapError
from chatscene.files.atomic import write_whole
from chatscene.files.caches import cache_folder, only_mine
from chatscene.maps.laid_junctions import meeting
from chatscene.maps.laid_streets import open_road
from chatscene.maps.road_spec import LaidRoad, is_laid, road_of
from chatscene.maps.writing.opendrive import write_opendrive

DIGEST = 12  # [bytes] of a map's digest


def laid(road: LaidRoad) -> str:
    """The OpenDRIVE file of a road."""
    return write_opendrive(str(road), open_road(road) if road.junction is None else meeting(road), located=True)


def laid_file(name: str) -> Path:
    """The file of the road that a map's name says, which is laid now if it is not there.

    It lies in this user's cache, or where there can be none in a folder of this process, by its content.

    Raises:
        MapError: The name says no road, or one that cannot be laid.
    """
    name, content = _content(name)
    digest = hashlib.blake2b(content, digest_size=DIGEST).hexdigest()
    file = f"{name.replace(':', '-')}.xodr"
    if (folder := only_mine(cache_folder("maps") / digest)) is not None:
        with suppress(OSError):
            return _written(folder / file, content)
    return _written(Path(_folder().name, file), content)


def laid_name(path: Path) -> str | None:
    """The name of the road that was laid in a file; None if it is another map."""
    name = path.stem.replace("-", ":", 1)
    try:
        return name if is_laid(name) and laid_file(name) == path else None
    except MapError:
        return None


@lru_cache(maxsize=64)
def _content(name: str) -> tuple[str, bytes]:
    """The one name of a road, and what is in its file."""
    road = road_of(str(road_of(name)))  # with its numbers as the name has them
    return str(road), laid(road).encode()


def _written(path: Path, content: bytes) -> Path:
    if not path.exists() or path.read_bytes() != content:
        write_whole(path, content)
    return path


@cache
def _folder() -> TemporaryDirectory[str]:
    return TemporaryDirectory(prefix="chatscene-")
