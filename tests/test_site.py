"""The site: built without a warning, of every page there is, and it asks nobody for anything."""

from __future__ import annotations

import html
import json
import os
import re
import runpy
import subprocess
import sys
import zipfile
from collections.abc import Iterator
from html.parser import HTMLParser
from pathlib import Path
from xml.etree import ElementTree

import pytest
import yaml

import chatscene
from chatscene.commands.main import main
from chatscene.report.index_columns import TABLES
from chatscene.terms import vocabulary
from chatscene.terms.acts import Action
from notebooks import TUTORIALS, held
from places import ROOT

DOCS = ROOT / "docs"
GALLERY = re.findall(r'<img src="(gallery/[^"]*)"[^>]*>\n<figcaption>(.*?) <small>', (DOCS / "gallery.md").read_text())


def leaves(nav: object) -> Iterator[str]:
    """The pages that the navigation names."""
    if isinstance(nav, str):
        yield nav
    elif isinstance(nav, dict):
        for below in nav.values():
            yield from leaves(below)
    elif isinstance(nav, list):
        for below in nav:
            yield from leaves(below)


class Loaded(HTMLParser):
    """What a page makes a browser load."""

    def __init__(self) -> None:
        super().__init__()
        self.addresses: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        named = dict(attrs)
        if tag == "link" and named.get("rel") == "canonical":
            return
        wanted = {"link": "href"}.get(tag, "src")
        if tag != "a" and (address := named.get(wanted)):
            self.addresses.append(address)


def test_the_navigation_names_every_page_once() -> None:
    named = list(leaves(yaml.safe_load((ROOT / "mkdocs.yml").read_text())["nav"]))
    pages = {str(page.relative_to(DOCS)) for page in DOCS.rglob("*.md") if page.parent.name not in ("decisions", "lab")}
    made = {"index.md", "contributing.md", "changelog.md", "security-policy.md", "lab/logs.md"}
    made |= {"reference/commands.md"}
    made |= {f"tutorials/{path.stem}.md" for path in TUTORIALS}
    assert sorted(named) == sorted(pages | made)


def test_the_page_of_the_laboratory_leads_to_every_log() -> None:
    linked = set(re.findall(r"\]\(([\w-]+\.md)\)", (DOCS / "lab" / "logs.md").read_text()))
    assert linked == {page.name for page in DOCS.glob("lab/*.md")} - {"logs.md"}


def test_no_two_decisions_have_the_same_number() -> None:
    pages = sorted((DOCS / "decisions").glob("[0-9]*.md"))
    assert len({page.name[:4] for page in pages}) == len(pages)
    assert all(page.read_text().startswith(f"# {page.name[:4]}") for page in pages)


def test_the_page_of_python_has_every_public_name() -> None:
    page = (DOCS / "reference" / "python.md").read_text()
    named = set(re.findall(r"::: [\w.]+\.(\w+)$", page, re.MULTILINE))
    for members in re.findall(r"members: \[(.*)\]", page):
        named |= set(members.split(", "))
    assert set(chatscene.__all__) - {"__version__"} <= named


def test_the_site_is_built_without_a_warning_and_asks_nobody_for_anything(tmp_path: Path) -> None:
    pytest.importorskip("mkdocs", reason="the extra 'docs' is not installed")
    site = tmp_path / "site"
    # not --quiet: then mkdocs counts no warning
    command = [sys.executable, "-m", "mkdocs", "build", "--strict", "--site-dir", str(site)]
    environment = os.environ | {"NO_MKDOCS_2_WARNING": "1"}
    done = subprocess.run(command, cwd=ROOT, env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    assert "WARNING" not in done.stderr, done.stderr

    pages = list(site.rglob("*.html"))
    assert len(pages) > 100
    for page in pages:
        loaded = Loaded()
        loaded.feed(page.read_text())
        assert loaded.addresses
        assert 'class="mermaid"' not in page.read_text(), f"{page} would load Mermaid"
        for address in loaded.addresses:
            assert not re.match(r"(?:\w+:)?//", address), f"{page} loads {address}"
    for sheet in site.rglob("*.css"):
        assert not re.search(r"(?:url\(|@import)\s*[\"']?(?:https?:)?//", sheet.read_text()), sheet

    for path in TUTORIALS:
        page = (site / "tutorials" / f"{path.stem}.html").read_text()
        assert all(
            html.escape(text.splitlines()[0], quote=False) in page
            for text in held(json.loads(path.read_text()))
            if text
        )

    copied = html.unescape("".join(re.findall(r'data-copy="([^"]*)"', (site / "index.html").read_text())))
    assert copied.startswith("make demo\nsource .venv/bin/activate")

    commands = (site / "reference" / "commands.html").read_text()
    assert all(f'id="chatscene-{verb}"' in commands for verb in main.commands)
    decisions = (site / "decisions" / "index.html").read_text()
    assert all(f"{page.stem}.html" in decisions for page in DOCS.glob("decisions/*.md"))
    words = (site / "reference" / "words.html").read_text()
    meant = [one for one in vars(vocabulary).values() if isinstance(one, type) and issubclass(one, vocabulary.Word)]
    for word in (*(word for some in meant for word in some), *Action):
        assert f"<code>{word}</code>" in words
    for word in (*vocabulary.Where, *vocabulary.Act, *vocabulary.UserKind):
        assert html.escape(word.meaning, quote=False) in words
    columns = (site / "reference" / "tables.html").read_text()
    for name, some in TABLES.items():
        assert f'id="{name}"' in columns
        assert all(f"<code>{one.name}</code>" in columns for one in some)
    found = {entry["location"] for entry in json.loads((site / "search" / "search_index.json").read_text())["docs"]}
    assert "tour.html" in found
    assert not [place for place in found if place.startswith(("decisions/", "lab/"))]


def test_the_button_of_a_block_copies_its_commands_without_prompts_and_answers() -> None:
    markdown = pytest.importorskip("markdown", reason="the extra 'docs' is not installed")
    extensions = ["pymdownx.highlight", "pymdownx.superfences"]  # as in mkdocs.yml
    text = '```console\n$ say "a < b"  # so\na & b\n$ make demo\n```\n\n```bash\nmake\n```\n'
    page = markdown.markdown(text, extensions=extensions)
    made = runpy.run_path(str(DOCS / "site.py"))["on_page_content"](page)
    (copied,) = re.findall(r'<div data-copy="([^"]*)" class="[^"]*highlight', made)
    assert html.unescape(copied) == 'say "a < b"  # so\nmake demo'
    assert re.sub(r' data-copy="[^"]*"', "", made) == page


def test_the_gallery_has_a_small_picture_of_each_situation() -> None:
    assert 24 <= len(GALLERY) <= 60
    pictures = {DOCS / picture for picture, _ in GALLERY}
    assert pictures == set(DOCS.glob("gallery/*.webp"))
    assert len(pictures) == len(GALLERY)
    assert sum(picture.stat().st_size for picture in pictures) < 1_500_000
    assert (DOCS / "crash.gif").stat().st_size < 400_000


def test_the_gallery_has_each_scene_for_players_of_others_with_its_map() -> None:
    with zipfile.ZipFile(DOCS / "gallery" / "openscenario.zip") as files:
        names = {Path(name) for name in files.namelist()}
        scenes = [name for name in names if name.suffix == ".xosc"]
        assert {name.stem for name in scenes} == {Path(picture).stem for picture, _ in GALLERY}
        for name in scenes:
            scenario = ElementTree.fromstring(files.read(str(name)))
            road = scenario.find("RoadNetwork/LogicFile")
            assert road is not None
            assert Path(road.attrib["filepath"]) in names
            assert scenario.find("Storyboard/Story") is not None
    assert (DOCS / "gallery" / "openscenario.zip").stat().st_size < 400_000


@pytest.mark.parametrize("sentence", [sentence for _, sentence in GALLERY])
def test_a_sentence_of_the_gallery_is_served(sentence: str) -> None:
    assert chatscene.explain(sentence).program is not None
