"""What a page is to who sees little, uses no mouse, or does not bear motion."""

from __future__ import annotations

import re
from collections.abc import Iterator
from importlib.resources import files
from itertools import product
from pathlib import Path

import pytest

from browser import CHROMIUM, Browser
from chatscene.report.viewer import write_report
from fake_run import finished

REPORT = files("chatscene.report")
SHEETS = [
    *(REPORT.joinpath(name).read_text() for name in ("viewer.css", "coverage.css", "evaluation.css")),
    files("chatscene.view").joinpath("page/view.css").read_text(),
]
RULES = [(s.strip(), d) for sheet in SHEETS for s, d in re.findall(r"([^{}]+)\{([^{}]*)\}", sheet)]
SCHEMES: dict[str, dict[str, str]] = dict(
    zip(
        ("light", "dark"),
        (dict(re.findall(r"--([\w-]+): (#\w{6})", one)) for one in re.findall(r":root \{([^}]*)\}", SHEETS[0])),
        strict=True,
    )
)
GROUNDS = ("page", "card", "fill")
TEXT, GRAPHIC = 4.5, 3.0  # WCAG 2.2, 1.4.3 and 1.4.11, level AA

# What is drawn on the map, on what, and by its edge where that tells it apart.
DRAWN = [
    *product(("ego", "adversary", "background", "occluder", "route", "hit", "miss"), ("road", "sidewalk")),
    *product(("green", "yellow", "red"), ("edge",)),
    *product(("ego", "adversary", "ink", "hit"), ("card",)),
]
PALE = {"button:disabled", "from", "::placeholder"}  # WCAG asks nothing of the first; the others end up whole


def light(colour: str) -> float:
    """The relative luminance of a colour, as WCAG 2 has it."""
    parts = (int(colour[at : at + 2], 16) / 255 for at in (1, 3, 5))
    linear = [part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4 for part in parts]
    return sum(weight * part for weight, part in zip((0.2126, 0.7152, 0.0722), linear, strict=True))


def contrast(ink: str, on: str) -> float:
    """The contrast ratio of two colours, from 1 to 21."""
    dark, bright = sorted((light(ink), light(on)))
    return (bright + 0.05) / (dark + 0.05)


def mixed(over: str, under: str, share: float) -> str:
    """What `color-mix` makes of two colours in sRGB."""
    pairs = [(int(over[at : at + 2], 16), int(under[at : at + 2], 16)) for at in (1, 3, 5)]
    return "#" + "".join(f"{round(share * a + (1 - share) * b):02x}" for a, b in pairs)


def texts() -> set[tuple[str, str]]:
    """Every colour that a rule gives to text, with what it lies on: what the rule says, else any ground."""
    found = {("ink", ground) for ground in GROUNDS}
    for _, does in RULES:
        inks = re.findall(r"(?<![\w-])(?:color|fill): var\(--([\w-]+)\)", does)
        grounds = re.findall(r"background: var\(--([\w-]+)\)", does)
        if "font" in does or "fill:" not in does:  # a fill is of text where there is a font
            found |= set(product(inks or ("ink",) * bool(grounds), grounds or GROUNDS))
    lies = ("accent", *GROUNDS, *(name for name in SCHEMES["light"] if name.endswith("-fill")))
    return {(ink, on) for ink, on in found if on in lies} - {("ink", "accent")}  # a meter, in which nothing is written


@pytest.mark.parametrize("scheme", SCHEMES)
def test_every_text_stands_out_from_what_it_lies_on(scheme: str) -> None:
    colours = SCHEMES["light"] | SCHEMES[scheme]
    pairs = {f"{ink} on {on}": (colours[ink], colours[on]) for ink, on in texts()}
    assert {"soft on page", "comment on card", "hit on hit-fill", "page on accent", "ink on warn-fill"} <= pairs.keys()
    for on in ("accent", "ink"):  # the page that is chosen; what was said
        pairs[f"{on} on accent, pale"] = (colours[on], mixed(colours["accent"], colours["card"], 0.14))
    for tone in re.findall(r"\.c\d \{ --tone: var\(--([\w-]+)\)", SHEETS[0]):  # words that gave a fact
        pairs[f"ink on {tone}, pale"] = (colours["ink"], mixed(colours[tone], colours["page"], 0.17))
    poor = {name: round(contrast(*pair), 2) for name, pair in pairs.items() if contrast(*pair) < TEXT}
    assert not poor


@pytest.mark.parametrize("scheme", SCHEMES)
def test_every_graphic_stands_out_from_what_it_lies_on(scheme: str) -> None:
    colours = SCHEMES["light"] | SCHEMES[scheme]
    poor = {f"{one} on {on}": contrast(colours[one], colours[on]) for one, on in DRAWN}
    poor |= {f"border of a field on {on}": contrast(colours["soft"], colours[on]) for on in GROUNDS}
    assert not {name: round(ratio, 2) for name, ratio in poor.items() if ratio < GRAPHIC}


def test_nothing_that_is_read_is_made_paler_than_its_colour() -> None:
    pale = {selector for selector, does in RULES if re.search(r"(?<!-)opacity: [0.]", does)}
    assert pale <= PALE


def test_nothing_moves_but_where_no_preference_is_said() -> None:
    for sheet in SHEETS:
        rest = "".join(re.split(r"@media \(prefers-reduced-motion: no-preference\).*\n", sheet))
        assert not re.search(r"(animation|transition|scroll-behavior)\s*:", rest)


needs_chromium = pytest.mark.skipif(CHROMIUM is None, reason="needs Chromium to run the page's script")


@pytest.fixture
def report(tmp_path: Path) -> Iterator[Browser]:
    with Browser(tmp_path / "profile") as browser:
        browser.open(write_report(finished(tmp_path / "run", count=1).path).as_uri())
        yield browser


@needs_chromium
def test_in_a_browser_nothing_plays_by_itself_for_who_asks_for_less_motion(report: Browser) -> None:
    report.wait("document.querySelector('#clock')?.textContent.includes(' of ')")
    clock = "document.querySelector('#clock').textContent"
    was = report.run(clock)
    assert report.run("document.querySelector('#play').textContent") != "Pause"
    assert report.run(f"new Promise((done) => setTimeout(() => done({clock}), 300))") == was


@needs_chromium
def test_in_a_browser_the_tab_key_comes_to_every_control_and_shows_it(report: Browser) -> None:
    report.wait("document.querySelector('#found')?.textContent")
    assert report.passed_over() == []
