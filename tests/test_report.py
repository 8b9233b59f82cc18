from __future__ import annotations

import html
import re
import shutil
import subprocess
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray
from PIL import Image

from chatscene.errors import RunError
from chatscene.report import viewer
from chatscene.report.animation import write_gif
from chatscene.report.highlight import highlight
from chatscene.report.ranges import plot_ranges
from chatscene.report.sections import command, verdict
from chatscene.report.tracks import contact_point, extent, pack_drawing, pack_episode
from chatscene.report.viewer import write_report
from chatscene.runs import Status, read_ranges, read_record, read_scenes, update, write_block
from fake_run import PROGRAM, SCENARIO, TEXT, blocks, drawing, drive, finished, scene, started

NASTY = """</script><script>alert(1)</script><img src=x onerror="alert(2)"> & 'quotes' "too" {{script}} <!--"""

CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")


def _page(folder: Path) -> str:
    return write_report(folder).read_text(encoding="utf-8")


def test_the_page_tells_the_run_in_order(tmp_path: Path) -> None:
    page = _page(finished(tmp_path / "run").path)
    parts = (TEXT, "44 collided", 'id="view"', 'id="scenes-title"', 'id="understood-title"', "cross-hesitate")
    rest = ("needs advTrajectory", "AdvBehavior", 'class="ranges"', "bus-stop overlaps adversary", "chatscene run")
    places = [page.index(part, page.index("<body>")) for part in (*parts, *rest)]
    assert places == sorted(places)


def test_the_page_asks_for_nothing_from_anywhere(tmp_path: Path) -> None:
    page = _page(finished(tmp_path / "run", count=1).path)
    assert not re.search(r"""\b(src|href)\s*=|url\(|@import|://|fetch\(|XMLHttpRequest""", page)
    assert "default-src 'none'" in page


def test_fifty_scenes_of_ten_seconds_stay_under_three_megabytes(tmp_path: Path) -> None:
    folder = finished(tmp_path / "run", steps=100).path
    page = _page(folder)
    assert len(page.encode()) < 3_000_000
    assert page.count('class="play-scene"') == 50


def test_a_page_that_would_be_too_large_replays_the_best_scenes_and_says_so(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(viewer, "REPLAY_BYTES", 20_000)
    run = finished(tmp_path / "run", count=2)
    page = _page(run.path)
    shown = page.count('class="play-scene"')
    assert 2 <= shown < 20
    assert f"{shown} of 20 scenes have a replay" in page
    for row in read_scenes(run):
        assert not row["selected"] or f'class="play-scene" data-scene="{row["scene_id"]}"' in page


def test_nothing_a_user_wrote_becomes_markup(tmp_path: Path) -> None:
    folder = finished(tmp_path / "run", text=NASTY, program=NASTY, count=1).path
    update(viewer.open_run(folder), status=Status.FAILED, reason=NASTY)
    page = _page(folder)
    body = page[page.index("<body>") :]
    assert "<script>alert" not in page
    assert "<img" not in body
    assert "<!--" not in body
    assert body.count("<script") == 2  # the tracks and the viewer
    assert html.escape(NASTY.strip()) in body


def test_the_selected_scenes_come_first(tmp_path: Path) -> None:
    run = finished(tmp_path / "run")
    order = viewer.ranked(read_scenes(run))
    assert [row["selected"] for row in order[:3]] == [True, True, False]
    assert [row["collision"] for row in order] == sorted((row["collision"] for row in order), reverse=True)


def test_an_unfinished_run_has_a_page_of_what_was_done(tmp_path: Path) -> None:
    run = started(tmp_path / "run")
    assert "No scene was driven" in _page(run.path)
    write_block(run, blocks(1)[0])
    page = _page(run.path)
    assert "not finished" in page
    assert "10 scenes driven" in page


def test_a_refused_run_has_a_page_that_says_why(tmp_path: Path) -> None:
    run = started(tmp_path / "run")
    update(run, status=Status.REFUSED, reason="nothing in the library does this; nearest are cross, stop")
    page = _page(run.path)
    assert "refused" in page
    assert "nearest are cross, stop" in page


def test_a_run_without_a_drawing_of_its_map_still_replays(tmp_path: Path) -> None:
    run = finished(tmp_path / "run", count=1)
    run.file("map.json").unlink()
    run.file("explanation.json").unlink()
    assert 'class="play-scene"' in _page(run.path)
    assert write_gif(run.path).stat().st_size > 0


def test_the_verdict_carries_an_interval() -> None:
    row = {"status": "ran", "selected": False, "fill_in": False, "meaning_ok": True, "impact_speed": None}
    rows = [row | {"collision": i < 41, "avoidable": i < 12 if i < 41 else None} for i in range(50)]
    assert "<dd>29%</dd>" in verdict(rows)
    assert "82%, 95 % interval 69% to 90%" in verdict(rows)


def test_the_command_can_be_pasted_into_a_shell(tmp_path: Path) -> None:
    run = started(tmp_path / "run", text='don\'t $(rm -rf) `this`; "please"')
    words = command(read_record(run)).replace("chatscene", "printf '%s\\n'", 1)
    said = subprocess.run(["sh", "-c", words], capture_output=True, text=True, check=True).stdout.splitlines()
    assert said[:2] == ["run", 'don\'t $(rm -rf) `this`; "please"']
    assert said[-2:] == ["--seed", "7"]


@given(source=st.text(max_size=300) | st.just(PROGRAM))
def test_highlighting_changes_no_character_of_the_program(source: str) -> None:
    assert html.unescape(re.sub(r"</?span[^<>]*>", "", highlight(source))) == html.unescape(html.escape(source))


def _unpacked(differences: list[int], scale: float, count: int) -> NDArray[Any]:
    return np.cumsum(differences + [0] * (count - len(differences))) / scale


@given(walking=st.floats(0.8, 3.5), gap=st.floats(8, 40), ahead=st.floats(30, 55))
def test_tracks_on_the_page_are_within_half_a_centimetre(walking: float, gap: float, ahead: float) -> None:
    values = {"OPT_ADV_SPEED": walking, "OPT_ADV_DISTANCE": gap, "OPT_GEO_Y": ahead}
    episode = drive(scene(0, values))
    packed = pack_episode(episode)
    for track, actor in zip(episode.tracks, packed["actors"], strict=True):
        assert np.abs(_unpacked(actor["x"], 100, packed["steps"]) - track.x).max() <= 0.005 + 1e-9
        assert np.abs(_unpacked(actor["heading"], 1000, packed["steps"]) - track.heading).max() <= 0.0005 + 1e-9


def test_the_contact_lies_on_the_ego_nearest_to_what_it_hit() -> None:
    episode = drive(scene(0, {"OPT_ADV_SPEED": 2.0, "OPT_ADV_DISTANCE": 20.0, "OPT_GEO_Y": 40.0}))
    assert episode.collision is not None
    x, y = contact_point(episode, episode.collision)
    assert (x, y) == pytest.approx((40.0, episode.tracks[1].y[-1]), abs=0.01)  # they overlap by then
    ahead = replace(episode.collision, other="oncoming")  # as if it had hit the truck further on
    assert contact_point(episode, ahead)[0] == pytest.approx(episode.ego_track.x[-1] + 4.9 / 2, abs=0.01)


def test_only_the_part_of_the_map_around_the_drives_is_on_the_page() -> None:
    everything = pack_drawing(drawing(), [(-1e3, -1e3, 1e3, 1e3)])
    west = pack_drawing(drawing(), [(-60, -10, -20, 10)])
    assert [len(everything[kind]) for kind in ("roads", "junctions", "sidewalks")] == [4, 1, 4]
    assert [len(west[kind]) for kind in ("roads", "junctions", "sidewalks")] == [1, 0, 2]
    assert len(west["sidewalks"][1]) == 2  # the hole stays a hole


def test_the_extent_holds_ego_and_adversary_with_its_margin() -> None:
    episode = drive(scene(0, {"OPT_ADV_SPEED": 2.0, "OPT_ADV_DISTANCE": 20.0, "OPT_GEO_Y": 40.0}))
    west, south, east, north = extent(episode, margin=5.0)
    assert (west, south) == (-5.0, -11.0)
    assert east == pytest.approx(45.0)
    assert north > 3


def test_a_range_plot_has_a_bar_a_block_and_a_dot_a_scene(tmp_path: Path) -> None:
    run = finished(tmp_path / "run", count=3)
    rows = [row for row in read_ranges(run) if row["parameter"] == "OPT_GEO_Y"]
    plot = plot_ranges("OPT_GEO_Y", rows, [row for row in read_scenes(run) if row["status"] == "ran"])
    assert (plot.count("<rect"), plot.count("<circle")) == (3, 30)


def test_a_gif_of_the_best_scene_is_small_and_moves(tmp_path: Path) -> None:
    run = finished(tmp_path / "run", count=1)
    path = write_gif(run.path)
    best = viewer.ranked(read_scenes(run))[0]["scene_id"]
    assert path.name == f"{best.replace('/', '-')}.gif"
    assert path.stat().st_size < 3_000_000
    with Image.open(path) as picture:
        frames = getattr(picture, "n_frames", 1)
        first = picture.convert("RGB").tobytes()
        picture.seek(frames - 1)
        assert frames > 10
        assert picture.convert("RGB").tobytes() != first


def test_a_gif_needs_a_scene_that_was_driven(tmp_path: Path) -> None:
    run = started(tmp_path / "run")
    with pytest.raises(RunError, match="nothing to animate"):
        write_gif(run.path)


needs_chromium = pytest.mark.skipif(CHROMIUM is None, reason="needs Chromium to run the page's script")


def _opened(page: Path, profile: Path, address: str = "") -> str:
    """The page's document after four seconds of its own time."""
    quiet = "--disable-gpu --disable-quic --no-first-run --disable-background-networking --disable-component-update"
    done = subprocess.run(
        [
            str(CHROMIUM),
            "--headless",
            "--no-sandbox",
            *quiet.split(),
            "--disable-sync",
            f"--user-data-dir={profile}",
            "--window-size=1200,1500",
            "--virtual-time-budget=4000",
            "--dump-dom",
            page.as_uri() + address,
        ],
        capture_output=True,
        text=True,
        check=True,
    )
    return done.stdout


def _text(document: str, ident: str) -> str:
    found = re.search(rf'id="{ident}"[^>]*>([^<]*)<', document)
    assert found, ident
    return found[1]


@needs_chromium
def test_in_a_browser_the_replay_starts_by_itself_and_time_goes_on(tmp_path: Path) -> None:
    page = write_report(finished(tmp_path / "run", count=1).path)
    document = _opened(page, tmp_path / "profile")
    assert re.search(r'id="trouble"[^>]*hidden', document)
    assert _text(document, "clock") == "3.2 s of 3.2 s"
    assert _text(document, "play") == "Replay"
    assert f'data-scene="{SCENARIO}/route-00/scene-006" aria-current="true"' in document


@needs_chromium
def test_in_a_browser_a_link_opens_a_scene_at_a_time(tmp_path: Path) -> None:
    page = write_report(finished(tmp_path / "run", count=1).path)
    document = _opened(page, tmp_path / "profile", f"#{SCENARIO}/route-00/scene-003@1.5")
    assert _text(document, "clock").startswith("1.5 s of")
    assert _text(document, "scene-name") == "route 00 · scene 003"


PRESSES = """
const said = (textContent) => Object.assign(document.createElement("p"), { className: "heard", textContent });
const say = (what) => document.body.append(said(what));
const press = (key) => document.body.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true }));
const clock = () => document.getElementById("clock").textContent.split(" s")[0];
press(" "); press("Home"); say(clock());
press("ArrowRight"); press("ArrowRight"); say(clock());
press("End"); say(document.getElementById("play").textContent);
press("f"); say(document.getElementById("follow").getAttribute("aria-pressed"));
press("0"); press("+"); press("-"); press("n"); say(document.getElementById("scene-name").textContent);
document.querySelectorAll(".play-scene")[4].click(); say(document.getElementById("scene-name").textContent);
document.querySelector("#events button").click();
say(document.getElementById("trouble").hidden);
"""


@needs_chromium
def test_in_a_browser_keys_and_buttons_do_what_they_say(tmp_path: Path) -> None:
    run = finished(tmp_path / "run", count=1)
    page = write_report(run.path)
    text = page.read_text(encoding="utf-8").replace('http-equiv="Content-Security-Policy"', "")
    page.write_text(text.replace("</body>", f"<script>{PRESSES}</script></body>"), encoding="utf-8")
    said = re.findall(r'<p class="heard">([^<]*)</p>', _opened(page, tmp_path / "profile"))
    order = [row["scene_id"][-9:].replace("-", " ") for row in viewer.ranked(read_scenes(run))]
    assert said == ["0.0", "0.2", "Replay", "false", f"route 00 · {order[1]}", f"route 00 · {order[4]}", "true"]


@needs_chromium
def test_in_a_browser_nothing_a_user_wrote_runs(tmp_path: Path) -> None:
    nasty = NASTY.replace("alert(1)", "document.title='owned'").replace("alert(2)", "document.title='owned'")
    page = write_report(finished(tmp_path / "run", text=nasty, program=nasty, count=1).path)
    document = _opened(page, tmp_path / "profile")
    assert "<title>owned" not in document
    assert float(_text(document, "clock").split()[0]) > 0
