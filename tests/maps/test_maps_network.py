"""Loading maps: once per process, and with a clear word when it fails."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import pytest

from chatscene.errors import MapError, StuckBehavior
from chatscene.maps import network
from chatscene.maps.network import check_opendrive, install_network_memo, load_network, resolve_map
from chatscene.maps.survey import check_map

TOWN = resolve_map("town")
SMALL = """<?xml version="1.0"?>
<OpenDRIVE><header revMajor="1" revMinor="7"/>
<road name="" id="1" length="50" junction="-1">
 <planView>{plan}</planView>
 <lanes><laneSection s="0"><center><lane id="0" type="none"/></center>
  <right><lane id="-1" type="{kind}"><width sOffset="0" a="3.5" b="0" c="0" d="0"/></lane></right>
 </laneSection></lanes></road></OpenDRIVE>"""
LINE = '<geometry s="0" x="0" y="0" hdg="0" length="50"><line/></geometry>'


@pytest.fixture
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    return tmp_path / "cache"


def _map(folder: Path, plan: str = LINE, kind: str = "driving", name: str = "small.xodr") -> Path:
    folder.mkdir(exist_ok=True)
    path = folder / name
    path.write_text(SMALL.format(plan=plan, kind=kind) + f"<!-- {folder} -->")  # no other test has this content
    return path


def test_town_is_the_packaged_map() -> None:
    assert resolve_map("town").name == "town.xodr"


def test_a_path_is_a_map() -> None:
    assert resolve_map(str(TOWN)) == TOWN


def test_a_map_that_is_not_there_is_named_with_the_nearest_there_is(tmp_path: Path) -> None:
    _map(tmp_path, name="harbour.xodr")
    with pytest.raises(MapError, match=r"harbor.*harbour\.xodr"):
        resolve_map(str(tmp_path / "harbor.xodr"))
    with pytest.raises(MapError, match=r"twon.*town"):
        resolve_map("twon")


@pytest.mark.parametrize(
    ("content", "words"),
    [
        ("", "XML"),
        ("not a map", "XML"),
        (SMALL.format(plan=LINE, kind="driving")[:300], "not complete XML"),
        ("<osm></osm>", "not OpenDRIVE"),
        ("<OpenDRIVE></OpenDRIVE>", "without a"),
        (SMALL.format(plan=LINE, kind="sidewalk"), "lane"),
    ],
)
def test_a_broken_map_is_refused_with_the_file_and_the_fault(
    tmp_path: Path, cache: Path, content: str, words: str
) -> None:
    path = tmp_path / "broken.xodr"
    path.write_text(content)
    with pytest.raises(MapError, match=words) as caught:
        load_network(path)
    assert "broken.xodr" in str(caught.value)


def test_the_town_cut_in_half_is_refused(tmp_path: Path, cache: Path) -> None:
    path = tmp_path / "half.xodr"
    path.write_bytes(TOWN.read_bytes()[:100_000])
    with pytest.raises(MapError, match=r"not complete XML"):
        load_network(path)


@pytest.mark.parametrize("plan", ["", '<geometry s="5" x="0" y="0" hdg="0" length="50"><line/></geometry>'])
def test_what_scenic_cannot_parse_is_a_map_error_that_names_the_road(tmp_path: Path, cache: Path, plan: str) -> None:
    with pytest.raises(MapError, match=r"road '?1"):
        load_network(_map(tmp_path, plan))


NOT_A_LENGTH = ("inf", "-inf", "nan", "1e300", "1e400", "-50", "fifty", "")


@pytest.mark.parametrize("length", NOT_A_LENGTH)
@pytest.mark.parametrize("where", ["road", "geometry"])
def test_a_length_that_no_road_has_is_refused_before_anybody_computes_with_it(
    tmp_path: Path, cache: Path, monkeypatch: pytest.MonkeyPatch, length: str, where: str
) -> None:
    monkeypatch.setattr(network, "_scenic_from_file", lambda: pytest.fail("Scenic has seen it"))
    path = _map(tmp_path)
    path.write_text(re.sub(rf'(<{where} [^>]*length=)"50"', rf'\1"{length}"', path.read_text()))
    with pytest.raises(MapError, match=rf"road '1' has <{where} length='{re.escape(length)}'>; .* from 0 to 100000"):
        load_network(path)


@pytest.mark.parametrize("number", ["x", "y", "hdg", "s", "a", "c", "sOffset"])
@pytest.mark.parametrize("value", ["nan", "inf", "1e300"])
def test_a_number_that_no_road_has_is_refused(tmp_path: Path, cache: Path, number: str, value: str) -> None:
    path = _map(tmp_path)
    path.write_text(re.sub(rf' {number}="[^"]*"', f' {number}="{value}"', path.read_text()))
    with pytest.raises(MapError, match=rf"small\.xodr.*road '1' has .* {number}='{value}'"):
        load_network(path)


def test_what_the_maker_of_a_map_notes_for_himself_is_nobody_elses_business(tmp_path: Path, cache: Path) -> None:
    path = _map(tmp_path)
    path.write_text(path.read_text().replace("<planView>", '<userData><own x="inf" a="b"/></userData><planView>'))
    assert len(load_network(path).roads) == 1


def test_more_lanes_than_any_road_has_are_refused(tmp_path: Path, cache: Path) -> None:
    path = _map(tmp_path)
    lane = '<lane id="-{}" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane>'
    lanes = "".join(lane.format(number) for number in range(1, 100_000))
    path.write_text(re.sub("<right>.*</right>", f"<right>{lanes}</right>", path.read_text()))
    with pytest.raises(MapError, match=r"road '1' has 100000 lanes beside each other; at most 100"):
        load_network(path)


def test_whatever_scenic_raises_for_a_map_is_a_map_error(
    tmp_path: Path, cache: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(*_: object, **__: object) -> None:
        raise OverflowError("too far")

    monkeypatch.setattr(network, "_scenic_from_file", lambda: fail)
    with pytest.raises(MapError, match=r"small\.xodr.*cannot be made into lanes: too far"):
        load_network(_map(tmp_path))


def test_the_same_file_gives_the_same_network(tmp_path: Path, cache: Path) -> None:
    path = _map(tmp_path)
    assert load_network(path) is load_network(path)


def test_a_changed_file_is_read_again(tmp_path: Path, cache: Path) -> None:
    path = _map(tmp_path)
    before = load_network(path)
    path.write_text(path.read_text().replace("50", "60"))
    assert load_network(path).roads[0].centerline.length == pytest.approx(60)
    assert before.roads[0].centerline.length == pytest.approx(50)


def test_nothing_is_written_beside_a_map(tmp_path: Path, cache: Path) -> None:
    path = _map(tmp_path / "maps")
    load_network(path)
    assert sorted(p.name for p in path.parent.iterdir()) == ["small.xodr"]


def test_a_cache_file_beside_a_map_is_never_read(tmp_path: Path, cache: Path) -> None:
    path = _map(tmp_path / "maps")
    path.with_suffix(".snet").write_bytes(b"whatever a stranger put here")
    assert len(load_network(path).roads) == 1


def test_the_cache_folder_is_closed_to_others(tmp_path: Path, cache: Path) -> None:
    load_network(_map(tmp_path))
    folders = [p for p in (cache / "chatscene").rglob("*") if p.is_dir()]
    assert folders
    assert any(p.stat().st_mode & 0o077 == 0 for p in folders)


def test_a_map_loads_where_no_cache_can_be_written(tmp_path: Path, cache: Path) -> None:
    cache.write_text("a file where the cache folder should be")
    assert len(load_network(_map(tmp_path / "maps")).roads) == 1


def test_a_cache_that_cannot_be_rewritten_costs_only_time(tmp_path: Path, cache: Path) -> None:
    path = _map(tmp_path / "maps")
    load_network(path)
    (kept,) = cache.rglob("*.snet")
    kept.unlink()
    kept.mkdir()  # neither readable nor replaceable as a file, for whatever user runs this
    vars(network)["_parse"].cache_clear()
    assert len(load_network(path).roads) == 1


def test_files_of_the_same_content_have_one_network_wherever_they_lie(tmp_path: Path, cache: Path) -> None:
    path = _map(tmp_path / "maps")
    copy = tmp_path / "copy.xodr"
    copy.write_bytes(path.read_bytes())
    assert load_network(copy) is load_network(path)


def test_scenics_own_loader_gives_the_same_network_once_the_memo_is_installed(
    tmp_path: Path, cache: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from scenic.domains.driving.roads import Network

    path = _map(tmp_path)
    network = load_network(path)
    monkeypatch.setattr(Network, "fromFile", Network.fromFile)  # put back afterwards
    install_network_memo()
    loaded: Any = Network.fromFile(str(path))
    assert loaded is network


def test_a_good_map_has_no_problems() -> None:
    assert check_map(TOWN) == ()


def test_checking_a_broken_map_says_why_instead_of_raising(tmp_path: Path, cache: Path) -> None:
    path = tmp_path / "broken.xodr"
    path.write_text("<OpenDRIVE>")
    (problem,) = check_map(path)
    assert "XML" in problem


def test_a_map_too_small_for_any_route_is_a_problem(tmp_path: Path, cache: Path) -> None:
    assert any("no base scenario" in problem for problem in check_map(_map(tmp_path)))


def test_a_copy_of_a_map_that_was_changed_is_made_anew_and_that_is_said(tmp_path: Path, cache: Path) -> None:
    path = _map(tmp_path / "maps")
    content = path.read_bytes()
    load_network(path)
    (copy,) = cache.rglob("small.xodr")
    copy.write_bytes(content.replace(b"3.5", b"9.5"))
    vars(network)["_parse"].cache_clear()
    with pytest.warns(UserWarning, match=r"copy of map 'small\.xodr'.*was damaged or changed; it is made anew"):
        (lane,) = load_network(path).lanes
    assert copy.read_bytes() == content
    assert lane.polygon.area == pytest.approx(50 * 3.5, rel=0.01)


@pytest.mark.parametrize("encoding", ["UTF-7", "rot13", "idna", "no-such"])
def test_a_map_in_an_encoding_of_no_map_is_refused(encoding: str, tmp_path: Path) -> None:
    path = tmp_path / "odd.xodr"
    path.write_text(f'<?xml version="1.0" encoding="{encoding}"?><OpenDRIVE/>')
    with pytest.raises(MapError, match=r"odd\.xodr"):
        load_network(path)


def test_that_the_time_for_a_map_is_up_is_no_fault_of_the_map(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def stopped(*_: object, **__: object) -> None:
        raise StuckBehavior("its time is up")

    monkeypatch.setattr(network, "parsed", stopped)
    with pytest.raises(StuckBehavior, match="its time is up"):
        load_network(_map(tmp_path))


@pytest.mark.parametrize(("length", "taken"), [("1e-6", True), ("1e-2", False), ("1e-12", False)])
def test_a_width_is_held_to_what_it_comes_to_in_its_section(length: str, taken: bool, tmp_path: Path) -> None:
    path = _map(tmp_path)
    text = path.read_text()
    section = text[text.index("<laneSection") : text.index("</laneSection>") + len("</laneSection>")]
    short = section.replace('c="0" d="0"', 'c="-1e13" d="7e18"')
    after = section.replace('s="0"', f's="{length}"', 1)
    path.write_text(text.replace(section, short + after))
    if taken:
        check_opendrive(path)
    else:
        with pytest.raises(MapError, match="that is a number from"):
            check_opendrive(path)
