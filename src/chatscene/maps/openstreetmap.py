"""What an extract of OpenStreetMap holds of streets, looked at before anybody makes a map of it.

Source: the OSM XML format, version 0.6, and the tags of streets (wiki.openstreetmap.org: OSM XML, Key:highway).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from xml.etree import ElementTree as Xml

from chatscene.errors import MapError

LARGEST = 32 * 2**20  # [bytes]; twice of what openstreetmap.org itself hands out
STREETS = frozenset(
    f"{kind}{link}" for kind in ("motorway", "trunk", "primary", "secondary", "tertiary") for link in ("", "_link")
) | {"unclassified", "residential", "living_street"}
_BACKWAYS = frozenset(("service", "track"))  # drives to garages, aisles of car parks, farm tracks
_EXPORT = "export a small area at openstreetmap.org, or cut one out of a larger file with osmium extract"


@dataclass(frozen=True, slots=True, kw_only=True)
class Extract:
    """What an extract holds.

    Attributes:
        latitude: Of the middle of its streets [degrees north].
        longitude: Of the middle of its streets [degrees east].
        backways: Service roads and tracks, without which a map is made.
        stacked: Streets on bridges, in tunnels or on a layer of their own, by name or id.
    """

    latitude: float
    longitude: float
    streets: int
    backways: int
    stacked: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class _Way:
    tags: Mapping[str, str]
    number: str
    nodes: tuple[str, ...]

    @property
    def stacked(self) -> bool:
        return any(self.tags.get(key, "no") not in ("no", "0") for key in ("bridge", "tunnel", "layer"))


def read_extract(path: Path) -> Extract:
    """What an extract of OpenStreetMap holds.

    Raises:
        MapError: There is none, it is too large or no OSM XML, or nothing in it is a street.
    """
    _check_readable(path)
    try:
        places, ways = _read(path)
    except Xml.ParseError as error:
        raise MapError(f"{path} is not complete XML: {error}; if it is truncated, export it again") from error
    except ValueError as error:
        raise MapError(f"{path} is not an extract of OpenStreetMap: {error}; {_EXPORT}") from error
    if not places and not ways:
        raise MapError(f"{path} is an extract of OpenStreetMap with nothing in it; {_EXPORT}")
    streets = [way for way in ways if way.tags.get("highway") in STREETS]
    if not streets:
        raise MapError(
            f"{path} has no street to drive on: none of its {len(ways)} ways has a highway tag such as residential, "
            f"secondary or motorway; {_EXPORT}"
        )
    used = [places[node] for way in streets for node in way.nodes if node in places]
    if not used:
        raise MapError(
            f"{path} has {len(streets)} streets, but not the nodes that they run along; "
            "a query to Overpass ends with '(._;>;); out;' to have them"
        )
    north, east = zip(*used, strict=True)
    return Extract(
        latitude=round((min(north) + max(north)) / 2, 5),
        longitude=round((min(east) + max(east)) / 2, 5),
        streets=len(streets),
        backways=sum(way.tags.get("highway") in _BACKWAYS for way in ways),
        stacked=tuple(dict.fromkeys(w.tags.get("name") or f"way {w.number}" for w in streets if w.stacked)),
    )


def _check_readable(path: Path) -> None:
    if path.is_dir():
        raise MapError(f"{path} is a folder; give an .osm file")
    try:
        size = path.stat().st_size
        with path.open("rb") as stream:
            begin = stream.read(64)
    except OSError as error:
        raise MapError(f"there is no extract {path} to be read: {error.strerror}; {_EXPORT}") from error
    if size > LARGEST:
        raise MapError(f"{path} has {size / 2**20:.0f} MB, and at most {LARGEST // 2**20} MB are read; {_EXPORT}")
    if b"OSMHeader" in begin or begin[:2] in (b"\x1f\x8b", b"BZ"):
        raise MapError(f"{path} is compressed or binary; make it plain XML with osmium cat {path.name} -o plain.osm")
    if not begin.strip():
        raise MapError(f"{path} is empty; {_EXPORT}")


def _read(path: Path) -> tuple[dict[str, tuple[float, float]], list[_Way]]:
    """The places of nodes [degrees north, degrees east] by id, and the ways."""
    places: dict[str, tuple[float, float]] = {}
    ways: list[_Way] = []
    events = Xml.iterparse(path, events=("start", "end"))
    _, root = next(events)
    if root.tag != "osm":
        raise ValueError(f"its root is <{root.tag}> and not <osm>")
    for event, element in events:
        if event == "start" or element.tag not in ("node", "way", "relation"):
            continue
        number = element.get("id", "?")
        if element.tag == "node":
            places[number] = (_degrees(element, "lat", 90.0), _degrees(element, "lon", 180.0))
        elif element.tag == "way":
            tags = {tag.get("k", ""): tag.get("v", "") for tag in element.iter("tag")}
            ways.append(_Way(tags, number, tuple(node.get("ref", "") for node in element.iter("nd"))))
        root.clear()
    return places, ways


def _degrees(node: Xml.Element, name: str, most: float) -> float:
    value = float(node.get(name, "nan"))
    if not abs(value) <= most:
        raise ValueError(f"node {node.get('id')} has no {name}")
    return value
