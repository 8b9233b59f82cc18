"""Scenic's network of a map for programs of our world model, which ask it for nothing.

They have routes and points on them from `chatscene.maps.roads`. Scenic's driving model asks for regions as it is
loaded, and hands them on; the network itself, a tenth of a second for a town and half a second for a region, is
unpacked once anything is asked of it or of a region.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property, lru_cache
from pathlib import Path
from typing import Any

from scenic.core.regions import EmptyRegion, PolygonalRegion, PolylineRegion, Region, nowhere
from scenic.core.vectors import VectorField
from scenic.domains.driving.roads import Network

from chatscene.errors import MapError
from chatscene.maps.loading import kept_roads
from chatscene.maps.network import MapContent, load_network, map_digest

_NOT_DRAWN = frozenset(("_needsSampling", "_needsLazyEval", "_isLazy", "_dependencies", "_conditioned"))
"""What Scenic looks for in every value, which only what is drawn has."""


class _Later(Region):
    """A region that is made once something is asked of it that every region has not."""

    def __init__(self, name: str, make: Callable[[], Any]) -> None:
        Region.__init__(self, name)
        del self.orientation  # which is the region's own
        self._make = make

    @cached_property
    def _made(self) -> Any:
        return self._make()

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__") or name in ("_make", "_made"):
            raise AttributeError(name)
        return getattr(self._made, name)


class _LaterArea(_Later, PolygonalRegion):
    def union(self, other: Any, triedReversed: bool = False, buf: float = 0) -> Any:  # noqa: N803 - Scenic's name
        """Joined with another region, once something is asked of that."""
        if isinstance(other, EmptyRegion):
            return self
        return _LaterArea(self.name, lambda: self._made.union(other, triedReversed, buf))


class _LaterLine(_Later, PolylineRegion):
    pass


def light_network(path: Path | str) -> LightNetwork:
    """The network of a map, one for a process and file content.

    Raises:
        MapError: As `chatscene.maps.network.load_network`.
    """
    path = Path(path)
    return _light(map_digest(path), path)


@lru_cache(maxsize=8)
def _light(digest: str, path: Path) -> LightNetwork:
    return LightNetwork(path, digest)


class LightNetwork(Network):
    """A network that is made once something is asked of it.

    Args:
        path: The map.
        digest: Its `chatscene.maps.network.map_digest`.

    Raises:
        MapError: As `chatscene.maps.network.load_network`.
    """

    def __init__(self, path: Path, digest: str) -> None:
        roads = kept_roads(MapContent(digest, path))
        self._path, self._digest, self.mirrored = path, digest, roads.mirrored
        self.drivableRegion = _LaterArea("drivable", lambda: self._whole.drivableRegion)
        curb: Any = _LaterLine("curb", lambda: self._whole.curbRegion) if roads.roads else nowhere
        self.curbRegion = curb
        for name, parts in (
            ("sidewalkRegion", roads.sidewalks),
            ("shoulderRegion", roads.shoulders),
            ("intersectionRegion", roads.intersections),
        ):
            setattr(self, name, self._later(name) if parts else nowhere)
        self.roadDirection = VectorField("roadDirection", self._direction_at)

    def _direction_at(self, point: Any) -> Any:
        return self._whole._defaultRoadDirection(point)

    def _later(self, name: str) -> Any:
        return _LaterArea(name, lambda: getattr(self._whole, name))

    @cached_property
    def _whole(self) -> Any:
        network = load_network(self._path)
        if map_digest(self._path) != self._digest:
            raise MapError(f"map {self._path.name!r} was changed since its roads were read; start again ({self._path})")
        return network

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__") or name in _NOT_DRAWN or name in ("_path", "_digest", "_whole"):
            raise AttributeError(name)
        return getattr(self._whole, name)
