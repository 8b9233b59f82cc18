"""Load a map into Scenic's road network, once per process, with clear words when that fails.

Scenic keeps a parsed network beside the map, as a pickle. We never read such a file from where a map came from: a
copy of the map is parsed in a cache folder that only this user can write, named by the map's content.
"""

from __future__ import annotations

import difflib
import hashlib
import os
import pickle
import warnings
from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import dataclass, field
from functools import lru_cache, partial
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any
from xml.etree import ElementTree as Xml

from chatscene.errors import ChatSceneError, MapError, UnreadRoad
from chatscene.files.atomic import write_whole
from chatscene.files.bounded import is_there
from chatscene.files.caches import cache_folder, only_mine
from chatscene.maps.apart import read_apart, takes_seconds
from chatscene.maps.carla_towns import carla_town, how_to_have
from chatscene.maps.laid import DIGEST, laid_file, laid_name
from chatscene.maps.left_hand import check_one_rule, keeps_left, lanes_on_map
from chatscene.maps.plain_form import FORM, in_plain_form, without_namespace
from chatscene.maps.road_spec import PREFIX, is_laid
from chatscene.maps.scenic_parser import read_other_makers
from chatscene.maps.unread import road_unread, why_unread
from chatscene.terms.scenario import Site

LONGEST = 1e5  # [m] of a road
FARTHEST = 1e8  # [m] from the origin; projected coordinates have it far away
SHORTEST = 1e-9  # [m] of a section of lanes
LARGEST = 100 * 2**20  # [bytes]
DEEPEST = 100
MOST_TURN = 200.0  # [rad] of one piece of a road: thirty times round
MOST_LANES = 100  # beside each other; Scenic fails at some three hundred

# What the numbers of a road lie between, by the name of the attribute.
_MEASURES = (
    {"length": (0.0, LONGEST)}
    | dict.fromkeys(("s", "sOffset"), (-LONGEST, LONGEST))
    | dict.fromkeys(("x", "y", "t"), (-FARTHEST, FARTHEST))
    | dict.fromkeys(("hdg", "curvature", "curvStart", "curvEnd"), (-1e3, 1e3))
    | dict.fromkeys(("a", "b", "c", "d", *(f"{k}{axis}" for k in "abcd" for axis in "UV")), (-1e6, 1e6))
)

_POWERS = {"b": 1, "c": 2, "d": 3}
"""Of the distance, by which each coefficient of a width is multiplied."""

TOWN, OUTSKIRTS, REGION = "town", "outskirts", "region"
PACKAGED = {name: Path(__file__).with_name(f"{name}.xodr") for name in (TOWN, OUTSKIRTS, REGION)}


def resolve_map(name: str) -> Path:
    """The file of a map: the packaged ``town``, ``outskirts`` or ``region``, or a path to an ``.xodr`` file.

    A town of CARLA's by its name, as ``Town05``, is that of the package that brings them, if it is installed. A road
    that its name says, as ``road:1+1``, is laid (`chatscene.maps.laid`).

    Raises:
        MapError: There is no such file; the nearest known name is given. Or no such road can be laid.
    """
    if name in PACKAGED:
        return PACKAGED[name]
    if is_laid(name):
        return laid_file(name)
    path = Path(name).expanduser()
    if is_there(path):
        return path.resolve()
    if (town := carla_town(name)) is not None:
        return town
    if os.path.isdir(path):  # noqa: PTH112 - as `is_there`
        raise MapError(f"map {name!r} is a folder; give an .xodr file")
    beside = [p.name for p in path.parent.glob("*.xodr")] if path.parent.is_dir() else []
    near = difflib.get_close_matches(path.name, [*PACKAGED, *beside], n=1, cutoff=0.4)
    hint = how_to_have(name) or (f"; did you mean {near[0]!r}?" if near else "")
    raise MapError(f"there is no map {name!r}: neither packaged ({', '.join(PACKAGED)}) nor a file{hint}")


def name_of(path: Path) -> str:
    """By what a map is asked for: a packaged one, a laid road and a town of CARLA's by its name, any other by path."""
    packaged = next((name for name, file in PACKAGED.items() if file == path), None) or laid_name(path)
    return packaged or (path.stem if carla_town(path.stem) == path else str(path))


def is_named(name: str) -> bool:
    """Whether a map's name is the same everywhere, and no path: of a packaged one, or of a road that is laid."""
    return name in PACKAGED or is_laid(name)


def map_with(site: Site | None) -> str:
    """The map for those who name none: the town or, for a site, of which it has none, the first with it.

    That is a packaged one, or a road that is laid.
    """
    return TOWN if site is None else _WITH.get(site, OUTSKIRTS)


_WITH = {
    Site.RAIL_CROSSING: REGION,
    Site.DRIVEWAY: f"{PREFIX}1+1,driveway=right",
    Site.DRIVEWAY_LEFT: f"{PREFIX}1+1,driveway=left",
    Site.PAST_LANE_DROP_LEFT: f"{PREFIX}2+2,median=3,drop-left",
    Site.PAST_BEND: f"{PREFIX}1+1,bend=left-80",
}


def load_network(path: Path | str) -> Any:
    """Scenic's network of a map, parsed once per process and file content.

    Raises:
        MapError: The file cannot be read, is no OpenDRIVE, or has no lane to drive on.
    """
    return _parse(MapContent.of(Path(path)))


@dataclass(frozen=True)
class MapContent:
    """What a map holds, and where it was read: two files that hold the same are one.

    Attributes:
        digest: Its `map_digest`.
        path: Where it lies, for messages.
    """

    digest: str
    path: Path = field(compare=False)

    @classmethod
    def of(cls, path: Path) -> MapContent:
        """The content of a file.

        Raises:
            MapError: It cannot be read.
        """
        return cls(map_digest(path), path)


def map_digest(path: Path) -> str:
    """What tells the content of a map from that of every other.

    Raises:
        MapError: The file cannot be read.
    """
    try:
        content = path.read_bytes()
    except OSError as error:
        raise MapError(f"map {path.name!r} cannot be read: {error.strerror} ({path})") from error
    return hashlib.blake2b(content, digest_size=DIGEST).hexdigest()


@lru_cache(maxsize=8)
def _parse(content: MapContent) -> Any:
    digest, path = content.digest, content.path
    root = check_opendrive(path)
    copy = _private_copy(path, digest)
    if takes_seconds(root) or digest in _packaged() or laid_name(path):
        return furnished(path, root, lambda: _kept(path, copy) or _made(path, copy))
    network = _kept(path, copy) or read_apart(path, root, partial(_taken, copy))
    return furnished(path, root, lambda: network)


@lru_cache(maxsize=1)
def _packaged() -> frozenset[str]:
    return frozenset(map_digest(path) for path in PACKAGED.values())


def furnished(path: Path, root: Xml.Element, make: Callable[[], Any]) -> Any:
    """Scenic's network of a map, with what stands on its roads and how fast one may drive there.

    That of a map of left-hand traffic is of its mirror image, and says so: it is `mirrored`.

    Args:
        path: The map.
        root: What it holds.
        make: Makes the network, or reads it.

    Raises:
        MapError: It cannot be made into lanes.
        MemoryError: There is too little memory.
    """
    from scenic.domains.driving.roads import Network

    from chatscene.maps.furniture import read_furniture
    from chatscene.maps.limits import read_limits

    try:
        network = make()
        furniture, limits = read_furniture(root, network), read_limits(root)
    except (ChatSceneError, MemoryError):  # such as that the time for it is up
        raise
    except Exception as error:  # whatever a parser and its geometry library raise for a map they were not made for
        if "bad_alloc" in str(error):  # how that library says it
            raise MemoryError(str(error)) from error
        why = why_unread(root, error)
        why = lanes_on_map(why) if keeps_left(path) else why
        said = f"map {path.name!r} is OpenDRIVE, but its roads cannot be made into lanes: {why} ({path})"
        raise (UnreadRoad(said, road=road) if (road := road_unread(error)) else MapError(said)) from error
    if not network.lanes:
        raise MapError(f"map {path.name!r} has no lane to drive on ({path})")
    assert isinstance(network, Network)
    _remember_union(network)
    setattr(network, "furniture", furniture)  # noqa: B010 - a class of somebody else's
    setattr(network, "speed_limits", limits)  # noqa: B010
    setattr(network, "mirrored", keeps_left(path))  # noqa: B010
    setattr(network, "written", path.read_bytes())  # noqa: B010 - for what is seldom asked of a map
    return network


def _kept(path: Path, copy: Path | None) -> Any:
    """The network that was made of a map before, if it is still there and whole."""
    from scenic.domains.driving.roads import Network

    if copy is None:
        return None
    original, options = marks_of(path)
    try:
        return Network.fromPickle(copy.with_suffix(Network.pickledExt), originalDigest=original, optionsDigest=options)
    except (OSError, pickle.UnpicklingError, Network.DigestMismatchError):
        return None


def marks_of(path: Path) -> tuple[bytes, bytes]:
    """By what a kept network is known to be of a map, and of how maps are read now."""
    from scenic.core.serialization import deterministicHash

    return hashlib.blake2b(path.read_bytes()).digest(), deterministicHash({"form": FORM}, digest_size=8)


def _made(path: Path, copy: Path | None) -> Any:
    """The network of a map, made in this process and kept beside the copy of the map."""
    network = parsed(copy or path)
    with suppress(OSError), TemporaryDirectory() as folder:
        if copy is not None:
            network.dumpPickle(made := Path(folder, "made" + network.pickledExt), *marks_of(path))
            write_whole(copy.with_suffix(network.pickledExt), made.read_bytes())
    return network


def _taken(copy: Path | None, made: Path) -> Any:
    """The network that another process has written to a file, which is kept beside the copy of its map."""
    from scenic.domains.driving.roads import Network

    if copy is not None:
        with suppress(OSError):  # a cache saves time; a run must not fail for want of one
            write_whole(copy.with_suffix(Network.pickledExt), made.read_bytes())
    return Network.fromPickle(made)


def _remember_union(network: Any) -> None:
    """Join roads and shoulders once: Scenic's driving model asks for it in every program, for 10 ms each time."""
    road, shoulder = network.drivableRegion, network.shoulderRegion
    joined = road.union(shoulder)

    def union(other: Any, *rest: Any, **named: Any) -> Any:
        return joined if other is shoulder else type(road).union(road, other, *rest, **named)

    road.union = union


def parsed(path: Path) -> Any:
    """What Scenic makes of a file, without its warnings about shoulders it leaves out.

    Args:
        path: OpenDRIVE that has been checked.
    """
    from scenic.formats.opendrive.xodr_parser import OpenDriveWarning

    read_other_makers()
    parse = _scenic_from_file()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", OpenDriveWarning)
        return parse(str(path), useCache=False, writeCache=False)


def check_opendrive(path: Path) -> Xml.Element:
    """Hold a file to what every map is.

    Returns:
        Its root, in the plain form.

    Raises:
        MapError: It cannot be read, is no OpenDRIVE, has no road, or has numbers that no road has.
    """
    root = _read(path)
    without_namespace(root)
    if root.tag != "OpenDRIVE":
        raise MapError(f"map {path.name!r} is XML but not OpenDRIVE: its root is <{root.tag}> ({path})")
    if root.find("road") is None:
        raise MapError(f"map {path.name!r} is OpenDRIVE without a single road ({path})")
    check_one_rule(root, path)
    for road in root.iter("road"):
        if fault := next(_faults(road), None):
            raise MapError(f"map {path.name!r} is OpenDRIVE, but road {road.get('id')!r} {fault} ({path})")
    in_plain_form(root)
    return root


def check_given(path: Path) -> None:
    """`check_opendrive` for those who want nothing that the file holds; a map of ours is one.

    Raises:
        MapError: As there.
    """
    if path not in PACKAGED.values() and laid_name(path) is None:
        check_opendrive(path)


def put_right(path: Path) -> tuple[str, ...]:
    """What is wrong with the links and pieces of a map, and is read as it must be meant; in words."""
    root = _read(path)
    turned = lanes_on_map if keeps_left(path) else str
    return tuple(map(turned, in_plain_form(root)))


def _read(path: Path) -> Xml.Element:
    """The root of a file of XML of a size that is read."""
    try:
        if path.stat().st_size > LARGEST:
            raise MapError(f"map {path.name!r} has more than {LARGEST // 2**20} MB; cut it down ({path})")
        return _root(path)
    except OSError as error:
        raise MapError(f"map {path.name!r} cannot be read: {error.strerror} ({path})") from error
    except Xml.ParseError as error:
        raise MapError(
            f"map {path.name!r} is not complete XML: {error}; give an .xodr file, or export it again ({path})"
        ) from error
    except (ValueError, LookupError) as error:
        why = f"is no XML in an encoding that is known: {error}; save it as UTF-8"
        raise MapError(f"map {path.name!r} {why} ({path})") from error


def _root(path: Path) -> Xml.Element:
    """The root of a file of XML whose elements do not lie too deep in one another; what is read goes round in them."""
    depth, road, root = 0, "", None
    for event, element in Xml.iterparse(path, ("start", "end")):
        depth += 1 if event == "start" else -1
        root = element if root is None else root
        if event == "start" and element.tag == "road" and depth <= DEEPEST:
            road = element.get("id", "")
        if depth > DEEPEST:
            raise MapError(
                f"map {path.name!r}: at road {road!r}, elements lie more than {DEEPEST} deep in one another ({path})"
            )
    assert root is not None
    return root


def _faults(road: Xml.Element) -> Iterator[str]:
    """What no road has, and what would keep those who compute with it busy for ever."""
    anything = {element for own in road.iter("userData") for element in own.iter()}  # of a maker's own
    reach = dict(_reaches(road))
    for element in road.iter():
        for name, value in () if element in anything else element.items():
            times = reach.get(element, 1.0) ** _POWERS.get(name, 0)
            if name in _MEASURES and not _within(value, *_MEASURES[name], times):
                low, high = _MEASURES[name]
                yield f"has <{element.tag} {name}={value[:40]!r}>; that is a number from {low:g} to {high:g}"
    for one in road.iterfind("planView/geometry"):
        for shape in (inner for inner in one if inner.tag in ("arc", "spiral")):
            bends = [abs(float(shape.get(name, 0))) for name in ("curvature", "curvStart", "curvEnd")]
            if (turn := max(bends) * float(one.get("length", 0))) > MOST_TURN:
                yield (
                    f"turns by up to {turn:.0f} rad in the <{shape.tag}> at s={one.get('s')!r}; "
                    f"at most {MOST_TURN:.0f} are followed"
                )
    for section in road.iter("laneSection"):
        lanes = sum(1 for _ in section.iter("lane"))
        if lanes > MOST_LANES:
            yield f"has {lanes} lanes beside each other; at most {MOST_LANES} are read"


def _reaches(road: Xml.Element) -> Iterator[tuple[Xml.Element, float]]:
    """The widths of sections shorter than a metre, with that length [m]: CARLA's Town03 has some of a micrometre."""
    sections = list(road.iter("laneSection"))
    ends = [*(one.get("s", "") for one in sections[1:]), road.get("length", "")]
    for section, end in zip(sections, ends, strict=False):  # a road may have no section, which is refused by that
        try:
            length = float(end) - float(section.get("s", ""))
        except ValueError:
            continue  # which is told by the attribute
        if SHORTEST <= length < 1.0:
            yield from ((width, length) for width in section.iter("width"))


def _within(value: str, low: float, high: float, times: float) -> bool:
    try:
        return low <= float(value) * times <= high
    except ValueError:
        return False


def _private_copy(path: Path, digest: str) -> Path | None:
    """The map in the user's cache folder, or None where there can be none."""
    if (folder := only_mine(cache_folder("maps") / digest)) is None:
        return None
    copy = folder / path.name
    try:
        content = path.read_bytes()
        if not copy.exists():
            write_whole(copy, content)
        elif copy.read_bytes() != content:
            warnings.warn(
                f"the copy of map {path.name!r} in {folder} was damaged or changed; it is made anew", stacklevel=2
            )
            write_whole(copy, content)
    except OSError:
        return None
    return copy


def install_network_memo(*, light: bool = False) -> None:
    """Make Scenic's driving model, which loads the map in every program, use `load_network`.

    Stock ``scenic`` works without it, only slower.

    Args:
        light: Whether the network is made only once something is asked of it (`chatscene.maps.light_network`).
    """
    from scenic.domains.driving.roads import Network

    from chatscene.maps.light_network import light_network

    _scenic_from_file()
    load = light_network if light else load_network

    def from_file(path: Any, *_: Any, **_options: Any) -> Any:
        return load(path)

    setattr(Network, "fromFile", staticmethod(from_file))  # noqa: B010 - a class of somebody else's


@lru_cache(maxsize=1)
def _scenic_from_file() -> Any:
    """Scenic's own loader, kept before it is replaced."""
    from scenic.domains.driving.roads import Network

    return Network.fromFile
