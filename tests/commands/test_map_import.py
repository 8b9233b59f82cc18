"""``chatscene map import``: what it says of a map it has made, and what it leaves where it cannot make one."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from chatscene.commands.main import main
from chatscene.maps.openstreetmap import Extract
from chatscene.simulate.confined import netconvert
from chatscene.simulate.confined.netconvert import Conversion
from places import TESTS

EXTRACTS = TESTS / "maps" / "osm"


@pytest.fixture(autouse=True)
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


def _imported(*arguments: str, made: bytes | None, monkeypatch: pytest.MonkeyPatch) -> Result:
    """The command, where netconvert gives these bytes, and seven warnings."""
    given = made or (EXTRACTS / "roundabout.xodr").read_bytes()
    warnings = tuple(f"bend {number}" for number in range(7))

    def convert(_: Path, __: Extract) -> Conversion:
        return Conversion(xodr=given, warnings=warnings)

    monkeypatch.setattr(netconvert, "convert", convert)
    return CliRunner().invoke(main, ["map", "import", *arguments])


def test_a_map_is_made_here_and_what_it_offers_is_shown(here: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    done = _imported(str(EXTRACTS / "roundabout.osm"), made=None, monkeypatch=monkeypatch)
    assert done.exit_code == 0, done.output
    assert (here / "roundabout.xodr").read_bytes() == (EXTRACTS / "roundabout.xodr").read_bytes()
    assert "roundabouts          1" in done.output
    assert "netconvert: bend 4\nnetconvert: and 2 more warnings\n" in done.output


def test_for_a_script_the_map_is_json_and_the_notes_stand_beside_it(monkeypatch: pytest.MonkeyPatch) -> None:
    street = EXTRACTS / "roundabout.osm"
    done = _imported(str(street), "--out", "deep/other.xodr", "--json", made=None, monkeypatch=monkeypatch)
    described = json.loads(done.stdout)
    assert (described["name"], described["roundabouts"]) == ("other", 1)
    assert set(described["lacking"]) == {base for base, count in described["routes"].items() if not count}
    assert "netconvert: bend 0" in done.stderr


def test_streets_on_bridges_and_what_is_left_out_are_told(here: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    text = (EXTRACTS / "roundabout.osm").read_text()
    text = text.replace('v="East Road"/>', 'v="East Road"/><tag k="bridge" v="yes"/>')
    (here / "street.osm").write_text(text.replace("</osm>", '<way id="9"><tag k="highway" v="service"/></way></osm>'))
    done = _imported("street.osm", made=None, monkeypatch=monkeypatch)
    assert "left out: 1 service roads and tracks" in done.output
    assert "on bridges, in tunnels or on a layer of their own: East Road; this world is flat" in done.output


def test_a_map_that_cannot_be_read_is_not_left_there(here: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    done = _imported(str(EXTRACTS / "crossing.osm"), made=b"<OpenDRIVE/>", monkeypatch=monkeypatch)
    assert done.exit_code == 1
    assert f"{EXTRACTS / 'crossing.osm'} becomes a map that is OpenDRIVE without a single road;" in done.output
    assert "crossing.xodr" not in done.output  # which is gone
    assert not list(here.iterdir())


@pytest.mark.parametrize(
    ("out", "said"),
    [("there.xodr", "there.xodr is there already; delete it, or give another name"), ("a.osm", "ends in .xodr")],
)
def test_nothing_is_written_over(out: str, said: str, here: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (here / "there.xodr").write_text("mine")
    done = _imported(str(EXTRACTS / "crossing.osm"), "--out", out, made=None, monkeypatch=monkeypatch)
    assert done.exit_code == 1
    assert said in done.output
    assert [(path.name, path.read_text()) for path in here.iterdir()] == [("there.xodr", "mine")]
