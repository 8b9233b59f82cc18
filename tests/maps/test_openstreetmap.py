"""Extracts of OpenStreetMap: what is in them, and what is said of those that no map can be made of."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from chatscene.errors import MapError
from chatscene.maps.openstreetmap import LARGEST, read_extract

EXTRACTS = Path(__file__).with_name("osm")
NODES = '<node id="1" lat="1" lon="2"/><node id="2" lat="1.001" lon="2.001"/>'
WAY = '<way id="7"><nd ref="1"/><nd ref="2"/>{}</way>'
STREET = WAY.format('<tag k="highway" v="residential"/>')
FOOTWAY = WAY.format('<tag k="highway" v="footway"/>')


def _written(folder: Path, text: str | bytes) -> Path:
    path = folder / "street.osm"
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return path


@pytest.mark.parametrize(("name", "streets"), [("crossing", 2), ("roundabout", 5), ("motorway", 5)])
def test_an_extract_tells_its_streets_and_where_their_middle_is(name: str, streets: int) -> None:
    extract = read_extract(EXTRACTS / f"{name}.osm")
    assert (extract.streets, extract.backways, extract.stacked) == (streets, 0, ())
    assert abs(extract.latitude) < 0.001
    assert abs(extract.longitude) < 0.001


def test_the_middle_is_that_of_the_streets_alone(tmp_path: Path) -> None:
    far = '<node id="3" lat="50" lon="50"/>'
    extract = read_extract(_written(tmp_path, f"<osm>{NODES}{far}{STREET}</osm>"))
    assert (extract.latitude, extract.longitude) == (1.0005, 2.0005)


def test_bridges_tunnels_and_backways_are_told(tmp_path: Path) -> None:
    named = '<tag k="highway" v="primary"/><tag k="name" v="Over"/><tag k="bridge" v="yes"/>'
    level = '<tag k="highway" v="primary"/><tag k="name" v="Level"/><tag k="bridge" v="no"/><tag k="layer" v="0"/>'
    under = '<tag k="highway" v="primary"/><tag k="layer" v="-1"/>'
    drive = '<tag k="highway" v="service"/>'
    ways = "".join(WAY.format(tags) for tags in (named, level, under, drive))
    extract = read_extract(_written(tmp_path, f"<osm>{NODES}{ways}</osm>"))
    assert (extract.streets, extract.backways, extract.stacked) == (3, 1, ("Over", "way 7"))


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "is empty; export"),
        ("{}", "is not complete XML: .*; if it is truncated, export it again"),
        (f"<osm>{NODES}", "is not complete XML: .*; if it is truncated"),
        ("<gpx/>", "is not an extract of OpenStreetMap: its root is <gpx>"),
        ("<osm/>", "with nothing in it; export a small area"),
        (f"<osm>{NODES}</osm>", "has no street to drive on: none of its 0 ways"),
        (f"<osm>{NODES}{FOOTWAY}</osm>", "none of its 1 ways has a highway tag"),
        (f"<osm>{STREET}</osm>", "has 1 streets, but not the nodes .* Overpass"),
        ('<osm><node id="9" lat="x" lon="2"/></osm>', "is not an extract of OpenStreetMap: could not convert"),
        ('<osm><node id="9" lat="91" lon="2"/></osm>', "node 9 has no lat"),
        (b"\x1f\x8b\x08\x00", "osmium cat street.osm -o plain.osm"),
        (b"\x00\x00\x00\x0d\x0a\x09OSMHeader", "compressed or binary"),
    ],
)
def test_an_extract_without_a_street_says_what_it_is_and_what_to_do(
    text: str | bytes, said: str, tmp_path: Path
) -> None:
    path = _written(tmp_path, text)
    with pytest.raises(MapError, match=f"^{re.escape(str(path))} .*{said}"):
        read_extract(path)


def test_a_file_that_is_none_is_told(tmp_path: Path) -> None:
    with pytest.raises(MapError, match=r"there is no extract .*street\.osm to be read: No such file"):
        read_extract(tmp_path / "street.osm")
    with pytest.raises(MapError, match=r"is a folder; give an \.osm file"):
        read_extract(tmp_path)


def test_a_country_is_not_read(tmp_path: Path) -> None:
    path = _written(tmp_path, "<osm>")
    with path.open("r+b") as stream:
        stream.truncate(LARGEST + 1)
    with pytest.raises(MapError, match="at most 32 MB are read; export a small area"):
        read_extract(path)
