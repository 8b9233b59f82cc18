"""The page over runs in a real browser, with the hands of a user: what is said, run, changed, compared and ended."""

from __future__ import annotations

import os
import signal
import threading
from collections.abc import Generator
from pathlib import Path
from typing import Any

import pytest

from browser import CHROMIUM, Browser
from chatscene.view.server import Server

pytestmark = pytest.mark.skipif(CHROMIUM is None, reason="needs Chromium to run the page's scripts")

READING = {"library": "", "embedder": "minilm", "language_model": "offline"}
SEARCH = {"map": None, "ego": "rule-based", "scenes": 2, "seed": 3}
_TURNS = "document.querySelectorAll('#turns .turn').length"
SENTENCE = "A pedestrian crosses the road from the right."


@pytest.fixture
def server(tmp_path: Path) -> Generator[Server]:
    with Server(tmp_path / "runs", 0, READING, SEARCH) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield server
        server.shutdown()


@pytest.fixture
def window(server: Server, tmp_path: Path) -> Generator[Browser]:
    with Browser(tmp_path / "profile") as browser:
        browser.open(f"{server.address}#/say")
        known = server.conversation.state(0)["count"]
        browser.wait(f"document.querySelector('#line')?.placeholder && {_TURNS} === {known}")
        yield browser
        assert browser.errors == []
        elsewhere = [one for one in browser.asked if not one.startswith((server.address, "data:", "about:", "blob:"))]
        assert [one for one in elsewhere if not one.startswith(f"http://127.0.0.1:{server.server_port}/")] == []
        assert browser.asked


def turns(window: Browser) -> int:
    return window.run(_TURNS)


def settled(window: Browser, known: int) -> str:
    """What the turn after so many is, once nothing is worked on any more."""
    window.wait(f"document.querySelectorAll('#turns .turn').length > {known} && document.querySelector('#work').hidden")
    return window.run("document.querySelector('#turns').lastChild.className.replace('turn ', '')")


def said(window: Browser, line: str) -> str:
    """What comes of a line that is typed, and sent with the Enter key."""
    known = turns(window)
    window.run("document.querySelector('#line').focus()")
    window.type(line)
    window.press("Enter")
    return settled(window, known)


def clicked(window: Browser, place: str) -> str:
    known = turns(window)
    window.run(f"document.querySelector({place!r}).click()")
    return settled(window, known)


def last(window: Browser) -> str:
    return window.run("document.querySelector('#turns').lastChild.innerText")


def child_of(server: Server) -> int:
    talk: Any = server.conversation
    return talk._child._process.pid


def fits(window: Browser, *, framed: bool = False) -> None:
    """Wide and narrow, nothing is cut off, and the Tab key comes to every control; not where it goes through frames."""
    for width in (1400, 400):
        window.resize(width, 900)
        assert window.run("document.documentElement.scrollWidth <= innerWidth")
        assert framed or window.passed_over() == []
    window.resize(1400, 1000)


def test_a_situation_is_said_run_changed_and_compared(window: Browser, server: Server, tmp_path: Path) -> None:
    assert said(window, SENTENCE) == "shown", last(window)
    assert "pedestrian" in last(window)
    fits(window)
    assert clicked(window, "#run") == "ran"
    assert "scenes in" in last(window)
    window.wait("document.querySelector('#turns iframe')?.ariaBusy === null")
    assert said(window, "make it a cyclist") == "edited"
    assert "cyclist" in last(window)
    with Browser(tmp_path / "another") as another:  # a second window shows the same talk
        another.open(f"{server.address}#/say")
        another.wait("document.querySelectorAll('#turns .turn').length === 3")
        assert clicked(another, "#run") == "ran"
        another.open(f"{server.address}#/runs")
        another.wait("document.querySelectorAll('#runs tbody tr').length === 2")
        fits(another)
        for number in (1, 2):
            another.run(f"document.querySelector('#runs tbody tr:nth-child({number}) input').click()")
        another.run("document.querySelector('#compare').click()")
        another.wait("document.querySelector('#compared').innerText.includes('cyclist')")
        another.wait("[...document.querySelectorAll('#frames iframe')].every((one) => one.ariaBusy === null)")
        fits(another, framed=True)
        assert another.errors == []
    window.run("document.dispatchEvent(new Event('said'))")  # as when the window is looked at again
    window.wait("document.querySelectorAll('#turns .turn').length === 4")
    assert clicked(window, "#undo") == "undone"


def test_a_question_is_answered_by_a_button(window: Browser) -> None:
    assert said(window, "new a truck comes at the junction") == "shown"
    assert "It may also say" in last(window)
    assert clicked(window, "#turns .turn:last-child .reading-choice") == "shown"
    assert said(window, "new the moon is made of green cheese") == "refused"
    assert clicked(window, "#turns .turn:last-child .ask button, #turns .turn:last-child .reading-choice") == "shown"


def test_work_is_cancelled_and_a_process_that_was_killed_loses_nothing(window: Browser, server: Server) -> None:
    assert said(window, f"new {SENTENCE}") == "shown"
    known = turns(window)
    window.run("document.querySelector('#run').click()")
    window.wait("!document.querySelector('#work').hidden")
    window.run("document.querySelector('#cancel').click()")
    assert settled(window, known) == "cancelled"
    known = turns(window)
    window.run("document.querySelector('#run').click()")
    window.wait("!document.querySelector('#work').hidden")
    os.kill(child_of(server), signal.SIGKILL)
    assert settled(window, known) == "crashed"
    assert "The situation is as it was" in last(window)
    assert said(window, "make it a cyclist") == "edited"
    assert clicked(window, "#run") == "ran"
