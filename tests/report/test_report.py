from __future__ import annotations

import base64
import html
import io
import json
import os
import re
import shlex
import shutil
import subprocess
import zlib
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import asdict, fields, replace
from html.parser import HTMLParser
from pathlib import Path
from typing import Any, cast
from unittest.mock import Mock

import click
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray
from PIL import Image, ImageChops, ImageColor

from chatscene import runs
from chatscene.commands.main import main
from chatscene.ego.observation import IN_WORDS, OBSERVATIONS
from chatscene.ego.policy import EGOS, in_words, load_ego, observation_of, senses_of
from chatscene.errors import RunError
from chatscene.exports.export import kept_scenes
from chatscene.exports.exporter import load_exporter
from chatscene.library.load import load_snippet
from chatscene.maps import picture
from chatscene.report import animation, viewer
from chatscene.report.animation import write_gif
from chatscene.report.egos import egos_in_words
from chatscene.report.measures import MEASURES
from chatscene.report.measures import in_words as measures_in_words
from chatscene.report.plots import BOTTOM, LINE, plot_outcomes, plot_ranges
from chatscene.report.sections import command, highlight, tiles, verdict
from chatscene.report.span import AFTER, span
from chatscene.report.terminal import progress_line
from chatscene.report.tracks import NEVER, called, extent, pack_beside, pack_drawing, pack_episode
from chatscene.report.viewer import FORMATS, pack_files, write_report
from chatscene.runs import (
    ProgramRecord,
    SituationRecord,
    Status,
    create,
    metrics_of,
    read_episode,
    read_ranges,
    read_record,
    read_scenes,
    update,
    write_block,
)
from chatscene.search.generators.own_program import generator_for
from chatscene.settings import SearchSettings, Settings, SimulationSettings
from chatscene.terms.criticality import Criticality
from chatscene.terms.episode import Ending, Episode, Role, Track, contact_point
from chatscene.terms.speeds import Speeds
from fake_run import (
    DECLARED,
    DT,
    PROGRAM,
    SCENARIO,
    TEXT,
    asked,
    blocks,
    drawing,
    drive,
    finished,
    resealed,
    scene,
    started,
)
from places import FIXTURES

NASTY = """</script><script>alert(1)</script><img src=x onerror="alert(2)"> & 'quotes' "too" {{script}} <!--"""

CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")


def _page(folder: Path) -> str:
    return write_report(folder).read_text(encoding="utf-8")


def test_the_page_tells_the_run_in_order(tmp_path: Path) -> None:
    page = _page(finished(tmp_path / "run").path)
    parts = (
        TEXT,
        "collided in 44 ",
        "The ego:",
        'id="view"',
        'id="scenes-title"',
        'id="understood-title"',
        "cross-hesitate",
    )
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
    assert html.unescape(body).count(NASTY.strip()) >= 2


class Elements(HTMLParser):
    """The elements of a page with the names of their attributes; not those that colour a program."""

    def __init__(self, page: str) -> None:
        super().__init__()
        self.found: list[tuple[str, ...]] = []
        self.text = ""
        self.feed(page)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        if tag != "span" or dict(attrs).get("class") not in (
            "comment",
            "string",
            "tuned",
            "keyword",
            "number",
            "actor",
        ):
            self.found.append((tag, *(name for name, _ in attrs)))
        self.text += " ".join(value or "" for _, value in attrs)

    def handle_data(self, data: str) -> None:
        self.text += data


def _with(addition: str, value: Any) -> Any:
    """A value of a run with an addition to each text in it that a stranger may set."""
    if isinstance(value, dict):
        return {
            key + addition * key.startswith("OPT_"): each if key == "status" else _with(addition, each)
            for key, each in cast(dict[str, Any], value).items()
        }
    if isinstance(value, list):
        return [_with(addition, each) for each in cast(list[Any], value)]
    return value + addition if isinstance(value, str) else value


@pytest.mark.parametrize("status", [Status.DONE, Status.FAILED])
def test_hostile_text_wherever_a_stranger_can_put_it_adds_no_element(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, status: Status
) -> None:
    run = finished(tmp_path / "run", count=1)
    record = read_record(run)
    names = ("text", "map_name")
    scenes, ranges, programs = read_scenes(run), read_ranges(run), viewer.read_programs(run)
    explanation = viewer.read_explanation(run)
    episodes = list(viewer.read_episodes(run, [row["scene_id"] for row in scenes if row["status"] == "ran"]))

    def elements(addition: str) -> Elements:
        told = {name: getattr(record, name) + addition for name in names}
        told |= {
            "egos": [record.ego + addition],
            "status": status,
            "reason": f"why{addition}",
            "versions": _with(addition, dict(record.versions)),
        }
        renamed = [replace(each, scene_id=each.scene_id + addition) for each in episodes]
        for name, value in {
            "read_record": record.model_copy(update=told),
            "read_scenes": _with(addition, scenes),
            "read_ranges": _with(addition, ranges),
            "read_programs": _with(addition, dict(programs)),
            "read_explanation": _with(addition, explanation),
            "read_episodes": renamed,
        }.items():
            monkeypatch.setattr(viewer, name, Mock(return_value=value))
        return Elements(_page(run.path))

    harmless, hostile = elements(""), elements(NASTY)
    assert hostile.found == harmless.found
    assert hostile.text.count(NASTY) > 100


def test_the_selected_scenes_come_first(tmp_path: Path) -> None:
    run = finished(tmp_path / "run")
    order = viewer.ranked(read_scenes(run))
    assert [row["selected"] for row in order[:3]] == [True, True, False]
    kept = [(len(row["meaning_failures"]), not row["collision"]) for row in order if row["selected"]]
    assert kept == sorted(kept)


def test_a_scene_that_shows_more_comes_before_one_that_collides() -> None:
    rows = [
        {"scene_id": name, "status": "ran", "selected": True, "collision": hit, "meaning_failures": missing}
        | {"overall_score": score}
        for name, hit, missing, score in (
            ("a", True, ["others.A.does.0.act: said stop, but it never does"], 0.1),
            ("b", False, [], 0.9),
            ("c", True, [], 0.8),
            ("d", False, ["one", "two"], 0.2),
        )
    ]
    assert [row["scene_id"] for row in viewer.ranked(rows)] == ["c", "b", "a", "d"]


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
    resealed(run)
    assert 'class="play-scene"' in _page(run.path)
    assert write_gif(run.path).stat().st_size > 0


def test_the_verdict_carries_an_interval() -> None:
    row = {"status": "ran", "selected": False, "fill_in": False, "meaning_ok": True, "impact_speed": None}
    rows = [row | {"collision": i < 41, "avoidable": i < 12 if i < 41 else None} for i in range(50)]
    assert "<dd>29%</dd>" in tiles(rows)
    counts = {"ran": 50, "collided": 41, "off_road": 3, "timeout": 2, "waiting": 1, "selected": 0}
    head = verdict(rows, counts, read=True)
    assert "82%, 95 % interval 69% to 90%" in head
    assert "left the road in 3, ran out of time in 2, waited behind somebody to the end in 1" in head


def test_where_nothing_collided_there_is_no_hardest_impact() -> None:
    row = {"status": "ran", "selected": True, "fill_in": True, "meaning_ok": True, "impact_speed": None}
    page = tiles([row | {"collision": False, "avoidable": None}] * 3)
    assert "km/h</dd>" not in page
    assert page.count("nothing collided") == 2


def test_the_command_can_be_pasted_into_a_shell(tmp_path: Path) -> None:
    run = started(tmp_path / "run", text='don\'t $(rm -rf) `this`; "please"')
    words = command(read_record(run)).replace("chatscene", "printf '%s\\n'", 1)
    said = subprocess.run(["sh", "-c", words], capture_output=True, text=True, check=True).stdout.splitlines()
    assert said[:2] == ["run", 'don\'t $(rm -rf) `this`; "please"']
    assert said[-4:] == ["--seed", "7", "--simulator", "embedded"]


def test_the_page_says_what_was_read_and_how_many_scenes_show_it(tmp_path: Path) -> None:
    run = finished(tmp_path / "run", count=2)
    page = _page(run.path)
    assert "<b>Read as</b> adversary: pedestrian; actions: cross, then stop; side: right; position: roadside" in page
    ran = [row for row in read_scenes(run) if row["status"] == "ran"]
    kept = [row for row in ran if row["selected"]]
    shown, shown_kept = (sum(row["meaning_ok"] for row in rows) for rows in (ran, kept))
    assert shown < len(ran)
    assert f"{shown_kept} of 2 kept scenes and {shown} of all 20 that were driven show all that was read" in page
    assert "what the sentence says" not in page


def test_a_program_of_ones_own_is_named_and_held_to_nothing(tmp_path: Path) -> None:
    mine = ProgramRecord(name="mine", source=PROGRAM)
    run = create(tmp_path / "run", asked(text="", program=mine, generator="program", egos=["sac"]))
    page = _page(run.path)
    assert "<h1>mine</h1>" in page
    assert "chatscene run --program programs/mine.scenic --map town --ego sac" in page
    rows = [
        {"status": "ran", "selected": True, "fill_in": False, "collision": True, "avoidable": None, "meaning_ok": True}
        | {"impact_speed": 3.0}
    ]
    assert "show all" not in verdict(rows, {"ran": 1, "collided": 1, "selected": 1}, read=False)


def test_what_the_ego_sees_stands_beside_its_collisions(tmp_path: Path) -> None:
    run = finished(tmp_path / "run", count=1)
    assert "rule-based (what it sees was not recorded)" in _page(run.path)
    update(run, senses={"rule-based": senses_of(load_ego("rule-based"))})
    page = _page(run.path)
    said = "only whether a vehicle is within 15 m ahead in its lane; brakes at up to 3 m/s² (0.375 of the pedal)"
    assert 0 < page.index("the ego <strong>collided in ") < page.index(said) < page.index('id="replay"')


@pytest.mark.parametrize("name", EGOS.built_in)
def test_every_packaged_ego_has_its_senses_in_words(name: str) -> None:
    said = in_words(senses_of(load_ego(name)))
    assert said.startswith(("sees its route and", "sees its route, how wide"))
    assert ("not hidden ones" in said) == (observation_of(load_ego(name)) != "safebench")
    assert re.search(r"brakes at up to (3 m/s² \(0\.375 of the pedal|8 m/s² \(the full brake pedal)\)$", said)


@pytest.mark.parametrize(
    "senses", [senses_of(load_ego("planner"), occlusion=False), {"observation": "traffic", "pedals": "full-brake"}]
)
def test_an_ego_from_which_nothing_hides_anybody_is_told_so(senses: dict[str, str]) -> None:
    assert "hidden ones too" in in_words(senses)  # and of runs that were made before anything did


def test_every_preset_has_words() -> None:
    assert set(IN_WORDS) == set(OBSERVATIONS)


def test_every_number_of_a_scene_has_a_name_a_unit_and_a_direction(tmp_path: Path) -> None:
    row = next(row for row in read_scenes(finished(tmp_path / "run", count=1)) if row["status"] == "ran")
    apart = {"impact_speed", "severity", "ego_kind", "other_kind"}
    kept = {f.name for noun in (Criticality, Speeds) for f in fields(noun)} - apart
    assert set(metrics_of(row)) | kept == set(MEASURES)
    told = measures_in_words(dict.fromkeys(MEASURES, 0.5))
    assert len(told) == len(MEASURES)
    for one, measure in zip(told, MEASURES.values(), strict=True):
        assert re.search(r"[\d.]+ (s|m|m/s|m/s²|rad)$", one["value"]) or measure.of
        assert one["note"].endswith(f"more is {measure.more}" if measure.more else measure.of)
        assert measure.more in ("better", "worse", "")


@pytest.mark.parametrize(("needed", "said"), [(9.9, True), (88.4, True), (8.0, False)])
def test_a_deceleration_that_no_tyre_can_do_is_said_to_be_one(needed: float, said: bool) -> None:
    (one,) = measures_in_words({"deceleration_required": needed})
    assert ("more than any tyre can do" in one["note"]) == said
    assert one["value"] == f"{needed:g} m/s²"


def test_the_page_says_how_long_the_run_took(tmp_path: Path) -> None:
    run = finished(tmp_path / "run", count=1)
    assert "<dt>Time</dt><dd>not recorded</dd>" in _page(run.path)
    update(run, timings={"total": 12.0})
    update(run, timings={"total": 3.5})  # after a kill
    assert "<dt>Time</dt><dd>15.5 s, until this page was written</dd>" in _page(run.path)


def _caught(words: Sequence[str], monkeypatch: pytest.MonkeyPatch) -> dict[str, Any]:
    """What `chatscene run` would start with these words."""
    caught: dict[str, Any] = {}

    def ask(
        text: str,
        *,
        settings: Settings,
        map_name: str,
        ego: str,
        edits: Sequence[str],
        situation: SituationRecord | None = None,
        **_: Any,
    ) -> None:
        caught.update(text=text, settings=asdict(settings), map_name=map_name, egos=[ego], edits=[*edits])
        caught.update(situation=situation)
        raise SystemExit

    monkeypatch.setattr(runs, "asked_run", ask)
    with suppress(SystemExit):
        main.main(words, standalone_mode=False)
    return caught


THERE = {
    "map": ("outskirts",),
    "ego": ("idm",),
    "sampler": ("random",),
    "simulator": ("confined",),
    "embedder": ("t5:some 'folder",),
    # else it is asked at once, and what it read is run as a situation
    "language_model": ("openai:some 'thing else", "--reader", "paper"),
}
"""A value that is not the default, of options that name something that must be there."""


def _other(option: click.Option, folder: Path) -> list[str]:
    """An option with a value that is not its default; what it names is written below a folder."""
    if option.name == "library":
        library = folder / "some 'library"
        (library / "behavior").mkdir(parents=True)
        shutil.copy(FIXTURES / "library" / "behavior" / "brake.scenic", library / "behavior")
        return [option.opts[0], str(library)]
    if option.name in THERE:  # what is not there is refused at once
        return [option.opts[0], *THERE[option.name]]
    if option.is_flag:
        return [option.secondary_opts[0] if option.default is True else option.opts[0]]
    if option.multiple:
        values = {"edit": ("make it a truck", "at night"), "set": ("side=left", "actions=cut-in,stop")}
        return [word for value in values[str(option.name)] for word in (option.opts[0], value)]
    if isinstance(option.type, click.Choice):
        return [option.opts[0], next(choice for choice in option.type.choices if choice != option.default)]
    usual = "90" if isinstance(option.type, click.FloatRange) else "some 'thing else"
    return [option.opts[0], str(option.default + 1) if isinstance(option.default, int) else usual]


NOT_OF_THE_SCENES = {"out", "jobs", "executor", "as_json", "program", "report", "trust", "as_written", "param"}
OWN = load_snippet(FIXTURES / "library" / "behavior" / "brake.scenic").description
RUN = main.commands["run"]
OPTIONS_OF_RUN = [p for p in RUN.params if isinstance(p, click.Option) and p.name not in NOT_OF_THE_SCENES]


@pytest.mark.parametrize("option", OPTIONS_OF_RUN, ids=lambda option: option.name)
def test_the_command_to_run_it_again_leaves_out_no_option(
    option: click.Option, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    there = ["--map", "town"]  # the one that is taken for this text
    texts = {"reading": "a car surprises us", "library": OWN}  # one is not sure alone, one is about an own snippet
    text = texts.get(str(option.name), "a car cuts in")
    first = _caught(["run", text, *there, *_other(option, tmp_path), "--out", str(tmp_path / "x")], monkeypatch)
    assert first
    assert first != _caught(["run", text, *there, "--out", str(tmp_path / "x")], monkeypatch)
    run = create(tmp_path / "run", asked(**first))
    words = shlex.split(command(read_record(run)))
    assert words[0] == "chatscene"
    if (situation := first["situation"]) is None:  # a text for which snippets are chosen
        assert _caught([*words[1:], "--out", str(tmp_path / "x")], monkeypatch) == first
        return
    monkeypatch.chdir(run.path)
    Path("situation.yaml").write_text(situation.text, encoding="utf-8")  # with its edits, and all that was stated
    again = _caught([*words[1:], "--out", str(tmp_path / "x")], monkeypatch)
    assert again["situation"].text == situation.text
    for one in (again, first):
        for own in ("text", "edits", "situation"):
            del one[own]
        del one["settings"]["retrieval"]  # which says how the text was read
    assert again == first


@pytest.mark.parametrize("trusted", [True, False])
@pytest.mark.parametrize("as_written", [True, False])
def test_the_command_says_of_a_program_whether_it_is_trusted_and_who_drives(
    trusted: bool, as_written: bool, tmp_path: Path
) -> None:
    generator = generator_for(trusted=trusted, as_written=as_written)
    program = ProgramRecord(name="mine", source="x")
    record = read_record(create(tmp_path / "run", asked(text="", program=program, generator=generator)))
    words = shlex.split(command(record))
    assert ("--trust" in words, "--as-written" in words) == (trusted, as_written)
    assert ("rode along" in egos_in_words(record)[0]) is as_written


def test_what_the_command_cannot_say_stands_beside_it(tmp_path: Path) -> None:
    settings = Settings(search=SearchSettings(block=7, sampler="random"), simulation=SimulationSettings(dt=0.05))
    run = create(tmp_path / "run", asked(settings=asdict(settings)))
    assert "block 7, dt 0.05" in _page(run.path)


@given(source=st.text(max_size=300) | st.just(PROGRAM))
def test_highlighting_changes_no_character_of_the_program(source: str) -> None:
    assert "".join(piece for _, piece in highlight(source)) == source


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
    assert len(plot["rows"]) == 3
    assert sum(len(row["dots"]) for row in plot["rows"]) == 30


def test_outcomes_lie_above_the_line_where_it_collided_and_below_where_not(tmp_path: Path) -> None:
    run = finished(tmp_path / "run", count=2)
    rows = [row for row in read_ranges(run) if row["parameter"] == "OPT_GEO_Y"]
    ran = [row for row in read_scenes(run) if row["status"] == "ran"]
    plot = plot_outcomes("OPT_GEO_Y", rows, ran)
    assert len(plot["points"]) == len(ran)
    for point in plot["points"]:
        assert (point["y"] < LINE) == point["kind"].startswith("hit")
        assert point["y"] <= BOTTOM


def test_the_page_holds_the_files_of_kept_scenes_as_they_are_exported(tmp_path: Path) -> None:
    run = finished(tmp_path / "run", count=1)
    kept = [row["scene_id"] for row in read_scenes(run) if row["selected"]]
    packed = pack_files(run.path, kept)
    assert list(packed) == kept
    files = json.loads(zlib.decompress(base64.b64decode(packed[kept[0]])))
    assert files.keys() == FORMATS.keys()
    (scene,) = kept_scenes(run.path, kept[:1])
    (written,) = load_exporter("csv").files(scene).items()
    assert (files["csv"]["name"], files["csv"]["text"].encode()) == written


def test_files_that_do_not_fit_are_left_out_of_the_page(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    run = finished(tmp_path / "run", count=1)
    monkeypatch.setattr(viewer, "FILES_BYTES", 10)
    assert pack_files(run.path, [row["scene_id"] for row in read_scenes(run) if row["selected"]]) == {}


def test_gap_and_time_to_collision_are_kept_step_by_step() -> None:
    episode = drive(scene(0, {"OPT_ADV_SPEED": 2.0, "OPT_ADV_DISTANCE": 20.0, "OPT_GEO_Y": 40.0}))
    packed = pack_episode(episode)
    gap = _unpacked(packed["near"]["gap"], 100, packed["steps"])
    left = _unpacked(packed["near"]["time"], 100, packed["steps"])
    assert gap[0] == pytest.approx(36.95, abs=1.0)
    assert gap[-1] == left[-1] == 0.0
    assert set(left[left < 0].round(2).tolist()) <= {NEVER / 100}


def test_a_drive_beside_another_has_the_ego_and_whom_that_one_met() -> None:
    values = {"OPT_ADV_SPEED": 2.0, "OPT_ADV_DISTANCE": 20.0, "OPT_GEO_Y": 40.0}
    shown, other = drive(scene(0, values)), drive(scene(0, values | {"OPT_ADV_DISTANCE": 0.0}), steps=300)
    packed = pack_beside(other, shown)
    assert [actor["name"] for actor in packed["actors"]] == ["ego", "adversary"]
    assert packed["steps"] == len(shown.ego_track.x) + 40


def test_a_page_says_why_no_scene_was_driven_again(tmp_path: Path) -> None:
    run = finished(tmp_path / "run", count=1)
    assert "The kept scenes were not driven again for this page" in _page(run.path)  # its snippets are not ours
    update(run, egos=["somebodys.stack:make_ego"])
    assert "the run uses code that is not packaged, so it cannot be run here" in _page(run.path)


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


def test_a_gif_of_a_run_says_what_was_asked_for_who_is_who_and_how_long_a_metre_is(tmp_path: Path) -> None:
    run = finished(tmp_path / "run", text="A pedestrian steps out.", count=1)
    with Image.open(write_gif(run.path)) as shown:
        whole = shown.convert("RGB")
    top, bottom = animation.above("A pedestrian steps out."), whole.height - animation.LINE - animation.EDGE
    assert whole.size == (picture.WIDTH, top.height + picture.HEIGHT + animation.LINE + animation.EDGE)
    apart = np.asarray(ImageChops.difference(whole.crop((0, 0, *top.size)), top))
    assert apart.max() < 60  # but for the palette's colours
    blue = whole.getpixel((animation.EDGE + 6, bottom + animation.EDGE // 2 + 9))
    assert blue == pytest.approx(ImageColor.getrgb(picture.ROLES[Role.EGO]), abs=12)


@pytest.mark.parametrize(
    ("role", "kind", "name"),
    [
        (Role.OCCLUDER, "Car", "parked car"),
        (Role.OCCLUDER, "BusStop", "bus stop"),
        (Role.OCCLUDER, "Box", "box"),
        (Role.ADVERSARY, "Car", "car"),
        (Role.ADVERSARY, "Pedestrian", "pedestrian"),
    ],
)
def test_a_vehicle_that_hides_others_is_called_parked(role: Role, kind: str, name: str) -> None:
    assert called(role, kind) == name


def test_a_long_text_above_a_gif_is_cut_and_a_short_one_is_not() -> None:
    assert animation.above("word " * 500).height == animation.LINES * animation.LINE + animation.EDGE
    assert animation.above("A car brakes.").height == animation.LINE + animation.EDGE


def test_a_gif_needs_a_scene_that_was_driven(tmp_path: Path) -> None:
    run = started(tmp_path / "run")
    with pytest.raises(RunError, match="nothing to animate"):
        write_gif(run.path)


def test_a_gif_of_a_drive_without_a_collision_shows_when_the_ego_was_nearest(monkeypatch: pytest.MonkeyPatch) -> None:
    values = dict(zip((p.name for p in DECLARED), (1.0, 0.0, 30.0), strict=True))  # the walker stays at the kerb
    episode = drive(scene(0, values))
    assert episode.collision is None
    (walker,) = episode.adversaries
    apart = np.hypot(walker.x - episode.ego_track.x, walker.y - episode.ego_track.y)
    shown = _steps_shown(episode, monkeypatch)
    assert len(shown) == 20
    moment = span(episode).moment
    assert abs(moment - apart.argmin()) <= 5
    assert shown[0] < moment < shown[-1] < len(apart) - 1


def test_a_gif_shows_what_is_done_after_the_ego_was_nearest(monkeypatch: pytest.MonkeyPatch) -> None:
    values = dict(zip((p.name for p in DECLARED), (1.0, 0.0, 30.0), strict=True))
    episode = drive(scene(0, values))
    ego, (walker,) = episode.ego_track, episode.adversaries
    late = len(ego.x) * 2 // 3  # level with the ego till then; it falls back by five metres from there on, and stays so
    behind = np.clip((np.arange(len(ego.x)) - late) * 1.0, 0.0, 5.0)
    beside = replace(walker, x=ego.x - behind, y=ego.y + 3.5)
    tracks = tuple(beside if track is walker else track for track in episode.tracks)
    shown = _steps_shown(replace(episode, tracks=tracks), monkeypatch)
    assert shown[0] < late < late + 5 <= shown[-1] < len(ego.x) - 1


def test_a_gif_of_two_that_come_to_stand_ends_soon_after_that_though_they_drift_nearer(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    values = dict(zip((p.name for p in DECLARED), (1.0, 0.0, 30.0), strict=True))
    episode = drive(scene(0, values))
    ego, (walker,) = episode.ego_track, episode.adversaries
    steps = np.arange(len(ego.x))
    stop = len(steps) // 3
    x = np.where(steps < stop, 1.0 * steps, stop + 0.001 * (steps - stop))  # it goes on by a millimetre a step
    stands = replace(walker, x=np.full(len(steps), stop + 5.0), y=ego.y * 0, speed=steps * 0.0)
    comes = replace(ego, x=x, y=ego.y * 0, speed=np.where(steps < stop, 10.0, 0.01))
    tracks = tuple({"ego": comes, walker.actor: stands}.get(track.actor, track) for track in episode.tracks)
    shown = _steps_shown(replace(episode, tracks=tracks), monkeypatch)
    assert shown[0] < stop < shown[-1] <= stop + round(AFTER / episode.dt) + 1 < len(steps) - 1


@given(
    stops=st.tuples(st.integers(0, 200), st.integers(0, 200)),
    apart=st.floats(-30.0, 30.0),
    lateral=st.floats(-8.0, 8.0),
    drift=st.sampled_from([0.0, 0.001, -0.001]),
)
def test_the_part_of_a_drive_that_is_shown_holds_the_moment_whenever_all_come_to_stand(
    stops: tuple[int, int], apart: float, lateral: float, drift: float
) -> None:
    steps, dt = np.arange(200), 0.05

    def track(actor: str, role: Role, stop: int, begins: float, y: float) -> Track:
        speed = np.where(steps < stop, 10.0, drift / dt)
        x = begins + np.cumsum(speed) * dt
        still = np.zeros(len(steps))
        return Track(
            actor=actor, role=role, kind="Car", length=4.5, width=2.0, x=x, y=still + y, heading=still, speed=speed
        )

    tracks = (track("ego", Role.EGO, stops[0], 0.0, 0.0), track("A", Role.ADVERSARY, stops[1], apart, lateral))
    episode = Episode(
        scene_id="s",
        ego="idm",
        dt=dt,
        tracks=tracks,
        events=(),
        signals=(),
        ending=Ending.TIMEOUT,
        route_completion=0.5,
        distance_to_route=np.zeros(len(steps)),
        off_road=np.zeros(len(steps), bool),
    )
    part = span(episode)
    assert 0 <= part.first <= part.moment <= part.last < len(steps)


def _steps_shown(episode: Episode, monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """The steps of a drive that are drawn in a GIF of twenty frames."""
    shown: list[int] = []

    def noting(camera: Any, ground: Any, driven: Any, step: int, small: Any) -> Any:
        shown.append(step)
        return picture.draw_frame(camera, ground, driven, step, small)

    monkeypatch.setattr(animation, "draw_frame", noting)
    animation.animate(episode, drawing(), frames=20)
    return sorted(shown)


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
    run = finished(tmp_path / "run", count=1)
    best = viewer.ranked(read_scenes(run))[0]["scene_id"]
    steps = len(read_episode(run, best).ego_track.x)
    document = _opened(write_report(run.path), tmp_path / "profile")
    assert re.search(r'id="trouble"[^>]*hidden', document)
    assert _text(document, "clock") == f"{(steps - 1) * DT:.1f} s of {(steps - 1) * DT:.1f} s"
    assert _text(document, "play") == "Replay"
    assert re.findall(r"<span>([^<]*) <b>", document)[:3] == ["ego: rule-based", "pedestrian", "gap"]
    assert re.findall(r'<tr data-scene="([^"]*)"[^>]* aria-current="true"', document) == [best]


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
press("h"); say(document.getElementById("heading").getAttribute("aria-pressed"));
const find = document.getElementById("find");
find.value = "scene 003"; find.dispatchEvent(new Event("input")); say(document.getElementById("found").textContent);
const impact = document.querySelectorAll(".sort")[4]; impact.click(); impact.click();
say(impact.parentElement.getAttribute("aria-sort"));
say(document.getElementById("trouble").hidden);
"""


WORKED = ["true", "1 of 10 scenes", "descending", "true"]


@needs_chromium
def test_in_a_browser_keys_and_buttons_do_what_they_say(tmp_path: Path) -> None:
    run = finished(tmp_path / "run", count=1)
    page = write_report(run.path)
    text = page.read_text(encoding="utf-8").replace('http-equiv="Content-Security-Policy"', "")
    page.write_text(text.replace("</body>", f"<script>{PRESSES}</script></body>"), encoding="utf-8")
    said = re.findall(r'<p class="heard">([^<]*)</p>', _opened(page, tmp_path / "profile"))
    order = [row["scene_id"][-9:].replace("-", " ") for row in viewer.ranked(read_scenes(run))]
    assert said == ["0.0", "0.2", "Replay", "false", f"route 00 · {order[1]}", f"route 00 · {order[4]}", *WORKED]


STANDING = """
press(" "); press("Home");
document.getElementById("rate").value = "2"; press(" ");
setTimeout(() => { say(clock()); say(document.getElementById("play").textContent); press("End"); say(clock()); }, 3000);
"""


@needs_chromium
def test_in_a_browser_a_replay_ends_soon_after_what_happened(tmp_path: Path) -> None:
    page = write_report(finished(tmp_path / "run", count=1).path)
    text = page.read_text(encoding="utf-8").replace('http-equiv="Content-Security-Policy"', "")
    packed = re.search(r'(<script[^>]* id="content"[^>]*>)(.*?)(</script>)', text, re.DOTALL)
    assert packed
    content = json.loads(packed[2])
    for one in content["scenes"]:
        one["drive"] |= {"span": [0, 20, 34], "events": []}
    stands = text.replace(packed[2], json.dumps(content).replace("<", "\\u003c"))
    script = PRESSES.partition("press(")[0] + STANDING
    page.write_text(stands.replace("</body>", f"<script>{script}</script></body>"), encoding="utf-8")
    ended, button, whole = re.findall(r'<p class="heard">([^<]*)</p>', _opened(page, tmp_path / "profile"))
    assert (ended, button) == ("3.4", "Replay")
    assert float(whole) > 3.4


@needs_chromium
def test_in_a_browser_nothing_a_user_wrote_runs(tmp_path: Path) -> None:
    nasty = NASTY.replace("alert(1)", "document.title='owned'").replace("alert(2)", "document.title='owned'")
    page = write_report(finished(tmp_path / "run", text=nasty, program=nasty, count=1).path)
    document = _opened(page, tmp_path / "profile")
    assert "<title>owned" not in document
    assert float(_text(document, "clock").split()[0]) > 0


def test_a_terminal_shows_how_far_it_is_and_a_file_only_what_is_done() -> None:
    terminal, file = io.StringIO(), io.StringIO()
    terminal.isatty = lambda: True  # type: ignore[method-assign]
    for stream in (terminal, file):
        show = progress_line(stream)
        for done in (0, 1, 4):
            show("searching, scenes", done, 4)
    lines = terminal.getvalue().replace("\x1b[K", "").split("\r")[1:]
    assert lines[0] == "searching, scenes [....................] 0 of 4"
    assert re.fullmatch(r"searching, scenes \[#####\.{15}\] 1 of 4, \d+ s left", lines[1])
    assert lines[2] == "searching, scenes [####################] 4 of 4\n"
    assert file.getvalue() == "searching, scenes\n"


def test_nobody_who_reads_how_far_it_is_is_no_reason_to_give_up_the_work() -> None:
    reads, writes = os.pipe()
    os.close(reads)
    with suppress(BrokenPipeError), os.fdopen(writes, "w") as pipe:
        closed = io.StringIO()
        closed.close()
        for stream in (None, closed, pipe):
            show = progress_line(stream)
            for done in range(5):
                show(f"part {done}", done, 5)
