"""The page of an evaluation: egos side by side. The drives are made by hand; no simulator."""

from __future__ import annotations

import html
import json
import re
from pathlib import Path

import click
import pytest
from click.testing import CliRunner

from browser import CHROMIUM, Browser
from chatscene import runs
from chatscene.commands.main import main
from chatscene.report.evaluation import fared_in, write_evaluation
from chatscene.report.tables import DASH
from chatscene.settings import EGO
from chatscene.studies.evaluation import COMPARED, Evaluated
from fake_run import evaluated
from places import ROOT

NASTY = "<script>document.title='owned'</script> & <b>bold</b>"


def rows_of(page: str, caption: str) -> list[list[str]]:
    """The texts of the cells of a table's body, by the name of its region."""
    body = page.partition(f'aria-label="{caption}"')[2].partition("<tbody>")[2].partition("</tbody>")[0]
    found = [re.findall(r"<t[hd][^>]*>(.*?)</t[hd]>", row, re.DOTALL) for row in body.split("</tr>")[:-1]]
    return [[" ".join(html.unescape(re.sub("<[^>]*>", " ", cell)).split()) for cell in row] for row in found]


def test_each_ego_has_a_row_with_its_counts_and_an_interval_where_it_estimates_something(tmp_path: Path) -> None:
    run = evaluated(tmp_path)
    rows = [row for row in runs.read_scenes(run) if row["status"] == "ran"]
    hits = [row for row in rows if row["collision"]]
    assert {row["block"] for row in hits} == {0}
    idm, planner = rows_of(write_evaluation(run).read_text(), "Table of egos")
    assert idm[:3] == ["idm by selection", f"{len(hits)} of 10", f"{10 * len(hits)}"]
    assert idm[3] == f"{sum(row['avoidable'] for row in hits)} of {len(hits)}"
    assert idm[5] == str(len({row["crash_type"] for row in hits}))
    assert planner[:4] == ["planner", "0 of 10", "0 0 to 28", ""]


def test_the_command_prints_a_row_per_ego_and_gives_the_rows_to_a_script(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    run = evaluated(tmp_path)
    done = Evaluated(folder=run.path, page=run.path / "report.html", tables={}, failures={}, stepped="", seconds=1.0)
    asked: list[object] = []

    def evaluate(*_: object, **settings: object) -> Evaluated:
        asked.append(settings["ego"])
        return done

    monkeypatch.setattr("chatscene.evaluate", evaluate)
    said = CliRunner().invoke(main, ["evaluate", "runs/x"], catch_exceptions=False).stdout
    rows = json.loads(CliRunner().invoke(main, ["evaluate", "runs/x", "--json"], catch_exceptions=False).stdout)["egos"]
    assert [row["ego"] for row in rows] == ["idm", "planner"]
    assert rows == fared_in(run)
    head, idm, planner = said.splitlines()[:3]
    assert head.startswith("ego      collided  95 % interval  a careful driver avoids")
    assert f"{rows[0]['collided']} of 10" in idm
    assert "by selection" in idm
    assert f"{rows[0]['avoidable']} of {rows[0]['collided']}" in idm
    assert planner.split() == [
        "planner",
        "0",
        "of",
        "10",
        "0",
        "%",
        "to",
        "28",
        "%",
        f"{rows[1]['completion']:.0f}",
        "%",
    ]
    assert "the careful driver is that of UN R157; a driver that brakes earlier may avoid more" in said
    assert len(said.splitlines()) < 10  # the paper's four tables go to files


def test_who_drives_in_a_run_where_nobody_is_named_is_first_among_those_who_are_compared() -> None:
    assert COMPARED[0] == EGO
    told = {name: next(one.help or "" for one in verb.params if isinstance(one, click.Option) and "--ego" in one.opts)
            for name, verb in main.commands.items() if name in ("run", "evaluate")}  # fmt: skip
    assert ", ".join(COMPARED) in told["evaluate"]
    assert f"run with two egos, `{EGO}` and `" in (ROOT / "docs" / "gallery.md").read_text()


def test_an_ego_that_nothing_was_kept_for_has_an_interval(tmp_path: Path) -> None:
    page = write_evaluation(evaluated(tmp_path, kept_for="")).read_text()
    assert " to " in rows_of(page, "Table of egos")[0][2]
    assert "by selection" not in page


def test_every_scene_says_what_became_of_it_under_each_ego_and_links_its_replay(tmp_path: Path) -> None:
    run = evaluated(tmp_path)
    path = write_evaluation(run)
    page = path.read_text()
    rows = {(row["scene_id"], row["block"]): row for row in runs.read_scenes(run) if row["status"] == "ran"}
    links = re.findall(r'<a href="([^"#]*)#([^"]*)"', page)
    assert sorted(scene for _, scene in links) == sorted({scene for scene, _ in rows})
    for to, scene in links:
        assert f'data-scene="{scene}"' in (path.parent / to).read_text()
    cells = rows_of(page, "Table of scenes")
    for line, (_, scene) in zip(cells, links, strict=True):
        mine, other = rows[scene, 0], rows[scene, 1]
        assert line[2] == str(int(mine["collision"]))
        assert line[3].startswith(
            f"{3.6 * mine['impact_speed']:.0f} km/h" if mine["collision"] else f"{mine['distance']:.1f} m"
        )
        assert line[4] == f"{other['distance']:.1f} m"


def test_who_fails_where_another_does_not_is_counted(tmp_path: Path) -> None:
    run = evaluated(tmp_path)
    hits = sum(bool(row["collision"]) for row in runs.read_scenes(run))
    pairs = rows_of(write_evaluation(run).read_text(), "Table of pairs")
    assert pairs == [["idm", DASH, f"{hits} of 10"], ["planner", "0 of 10", DASH]]


def test_the_page_links_no_report_that_is_not_there_and_asks_for_nothing(tmp_path: Path) -> None:
    page = write_evaluation(evaluated(tmp_path, reported=False)).read_text()
    assert not re.search(r"""\b(src|href)\s*=|url\(|@import|://|fetch\(|XMLHttpRequest""", page)
    assert "default-src 'none'" in page


def test_a_failed_ego_and_what_strangers_wrote_are_text(tmp_path: Path) -> None:
    run = evaluated(tmp_path, text=NASTY)
    runs.update(run, failures={NASTY: NASTY})
    page = write_evaluation(run).read_text()
    assert html.unescape(page).count(NASTY) >= 3
    assert page.count("<script") == 1
    assert "<b>bold" not in page


@pytest.mark.skipif(CHROMIUM is None, reason="needs Chromium to run the page's script")
def test_in_a_browser_the_tables_sort_and_scenes_where_egos_differ_are_found(tmp_path: Path) -> None:
    run = evaluated(tmp_path)
    hits = sum(bool(row["collision"]) for row in runs.read_scenes(run))
    with Browser(tmp_path / "profile", 400, 800) as browser:
        browser.open(write_evaluation(run).as_uri())
        browser.wait("document.querySelector('#found')?.textContent")
        assert browser.run("document.documentElement.scrollWidth <= innerWidth")
        first = "document.querySelector('.egos tbody th').textContent"
        browser.run("document.querySelectorAll('.egos .sort')[1].click()")
        assert browser.run(first) == "planner"
        browser.run("document.querySelectorAll('.egos .sort')[1].click()")
        assert browser.run(first).startswith("idm")
        browser.run("document.querySelector('#only').value = 'differ'")
        browser.run("document.querySelector('#only').dispatchEvent(new Event('input'))")
        assert browser.run("document.querySelector('#found').textContent") == f"{hits} of 10 scenes"
        assert browser.passed_over() == []
        assert not browser.errors
