"""From an extract of OpenStreetMap to a map, by netconvert or, where that is not installed, by what stands in for it.

The maps in ``tests/maps/osm`` are what ``chatscene map import`` made of the extracts beside them, which are ours, with
eclipse-sumo 1.28.0.
"""

from __future__ import annotations

import os
import sys
from importlib.util import find_spec
from pathlib import Path

import pytest

from chatscene.errors import MapError, MissingExtra
from chatscene.maps.network import load_network
from chatscene.maps.openstreetmap import read_extract
from chatscene.simulate.confined import netconvert
from chatscene.simulate.confined.confinement import Limits
from chatscene.simulate.confined.executable import Executable
from chatscene.simulate.confined.netconvert import Conversion, convert
from places import TESTS

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="netconvert runs behind the walls of Linux")

MADE = TESTS / "maps" / "osm"
CROSSING = MADE / "crossing.osm"
ROAD = '<OpenDRIVE><header date="Mon"/>{}<road id="1"/></OpenDRIVE>\nSuccess.'


def _by(code: str, monkeypatch: pytest.MonkeyPatch, limits: Limits = netconvert.LIMITS) -> Conversion:
    """What comes of the crossing where this is netconvert."""
    stand_in = Executable(
        command=(os.path.realpath(sys.executable), "-I", "-S", "-c", code),
        readable=(sys.base_prefix,),
        environment={},
    )
    monkeypatch.setattr(netconvert, "installed_netconvert", lambda: stand_in)
    monkeypatch.setattr(netconvert, "version", {netconvert.PACKAGE: "0"}.get)
    return convert(CROSSING, read_extract(CROSSING), limits)


def test_what_is_written_is_the_map_and_what_is_warned_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    said = "Warning: a bend\nSomething else\nWarning: a gap"
    made = _by(
        f"import sys; print({ROAD.format('<!-- on Monday -->')!r}); print({said!r}, file=sys.stderr)", monkeypatch
    )
    assert made.warnings == ("a bend", "a gap")
    assert made.xodr.decode().splitlines()[2] == '<OpenDRIVE><header /><road id="1" /></OpenDRIVE>'
    assert b"OpenStreetMap contributors, ODbL" in made.xodr


def test_netconvert_is_told_the_middle_of_the_streets(monkeypatch: pytest.MonkeyPatch) -> None:
    made = _by(f"import sys; print({ROAD!r}.format('<geoReference>' + sys.argv[-1] + '</geoReference>'))", monkeypatch)
    assert b"+proj=tmerc +lat_0=0.0 +lon_0=0.0 +k=1 +x_0=0 +y_0=0 +datum=WGS84 +units=m<" in made.xodr


def test_a_curve_is_said_to_be_no_longer_than_it_is(monkeypatch: pytest.MonkeyPatch) -> None:
    # A quarter of a parabola, v = u²/2 from 0 to 1, is (sqrt(2) + asinh(1)) / 2 long.
    parabola = '<paramPoly3 aU="0" bU="1" cU="0" dU="0" aV="0" bV="0" cV="0.5" dV="0" pRange="normalized"/>'
    road = ROAD.format(f'<geometry length="1.2"><line/></geometry><geometry length="1.2">{parabola}</geometry>')
    made = _by(f"print({road!r})", monkeypatch)
    assert b'length="1.2"' in made.xodr
    assert b'length="1.147793573"' in made.xodr


@pytest.mark.parametrize(
    ("code", "said"),
    [
        ("import sys; sys.exit('Error: no such type\\nQuitting (on error).')", "status 1\\): no such type; import a"),
        ("import os; os.abort()", r"it crashed \(SIG\w+\); import a smaller area"),
        ("while True: pass", r"it used up its processor time \(1 s\)"),
        ("print('<OpenDRIVE')", "something that is not XML"),
        ("print('<OpenDRIVE/>')", "of 2 streets: it does not say why; if all"),
        ("print('Success.')", "something that is not XML"),
    ],
)
def test_what_netconvert_fails_at_is_told(code: str, said: str, monkeypatch: pytest.MonkeyPatch) -> None:
    with pytest.raises(MapError, match=f"netconvert .*crossing\\.osm.*{said}"):
        _by(code, monkeypatch, Limits(processor=1, memory=256))


def test_without_the_extra_the_message_names_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(netconvert, "find_spec", dict[str, None]().get)
    with pytest.raises(MissingExtra, match=r'package eclipse-sumo, .* pip install .*\[osm\]"'):
        convert(CROSSING, read_extract(CROSSING))


@pytest.mark.parametrize("name", ["crossing", "roundabout", "motorway"])
def test_the_real_netconvert_makes_the_maps_that_are_kept(name: str, tmp_path: Path) -> None:
    if find_spec("sumo") is None:
        pytest.skip("the extra 'osm' is not installed")
    path = MADE / f"{name}.osm"
    made = convert(path, read_extract(path))
    if netconvert.version(netconvert.PACKAGE) == "1.28.0":
        assert made.xodr == path.with_suffix(".xodr").read_bytes()
    (tmp_path / "made.xodr").write_bytes(made.xodr)
    assert len(load_network(tmp_path / "made.xodr").lanes) > 10
