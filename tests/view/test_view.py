"""The page over runs, asked as a browser asks it, and as one that should not; and a talk, as the page holds it."""

from __future__ import annotations

import http.client
import json
import shutil
import socket
import threading
import time
from collections.abc import Callable, Generator, Mapping
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner

from browser import CHROMIUM, Browser
from chatscene import runs
from chatscene.commands.main import main
from chatscene.errors import ChatSceneError, EditRefused, NothingFits, RunError, SettingsError
from chatscene.report.evaluation import write_evaluation
from chatscene.runs.record import Status
from chatscene.talk import Talk
from chatscene.view.below import run_below
from chatscene.view.child import Child, Ended
from chatscene.view.conversation import Conversation
from chatscene.view.server import CONNECTIONS, MOST, Server
from chatscene.view.turns import between
from fake_run import evaluated, finished, started

READING = {"library": "", "embedder": "minilm", "language_model": "offline"}
SEARCH = {"map": None, "ego": "rule-based", "scenes": 2, "seed": 3}
NASTY = "<script>document.title='owned'</script><img src=x onerror=\"document.title='owned'\">"


class Page:
    """Who asks a server, with the headers of a browser on its page unless others are given."""

    def __init__(self, server: Server) -> None:
        self.server = server
        self.host = f"127.0.0.1:{server.server_port}"

    def ask(
        self, path: str, said: object = None, *, secret: str | None = None, headers: Mapping[str, str] | None = None
    ) -> tuple[int, Any, http.client.HTTPResponse]:
        """Status, content and answer; `said` is sent as JSON, or as it is if it is bytes."""
        body = said if isinstance(said, bytes | None) else json.dumps(said).encode()
        ours = {} if body is None else {"Origin": f"http://{self.host}", "Content-Type": "application/json"}
        connection = http.client.HTTPConnection(self.host, timeout=60)
        secret = self.server.secret if secret is None else secret
        connection.request("GET" if body is None else "POST", f"/{secret}/{path}", body, {**ours, **(headers or {})})
        answer = connection.getresponse()
        content = answer.read()
        connection.close()
        is_json = answer.headers.get_content_type() == "application/json"
        return answer.status, json.loads(content) if is_json else content, answer

    def turn(self, line: str) -> dict[str, Any]:
        """Say a line, and wait for what comes of it."""
        known = self.ask("talk")[1]["count"]
        assert self.ask("say", {"line": line})[0] == 200
        return self.awaited(known)

    def awaited(self, known: int) -> dict[str, Any]:
        """The next turn, once it is there."""
        while not (turns := self.ask(f"talk?since={known}")[1]["turns"]):
            time.sleep(0.02)
        return turns[0]


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Three runs, one of them of a sentence that would be a script; one that is not done; one that is damaged.

    Two pages besides: of an evaluation, and of catalogues.
    """
    folder = tmp_path_factory.mktemp("served") / "runs"
    for name, text in (("walks", "A pedestrian steps out."), ("more/nasty", NASTY)):
        run = finished(folder / name, text=text, count=1)
        (run.path / "report.html").write_text(f"<p>report of {name}")
    started(folder / "begun")
    write_evaluation(evaluated(folder / "egos"))
    (folder / "served").mkdir()
    (folder / "served" / "coverage.html").write_text("<p>coverage")
    broken = finished(folder / "broken", count=1)
    broken.file("scenes.parquet").write_bytes(b"no table")
    (folder.parent / "secret.html").write_text("secret")
    for file in ("report.html", "coverage.html"):
        (folder.parent / file).write_text("secret")
    return folder


@pytest.fixture(scope="module")
def page(folder: Path) -> Generator[Page]:
    with Server(folder, 0, READING, SEARCH) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield Page(server)
        server.shutdown()


def test_the_runs_are_listed_with_what_became_of_them_and_what_is_left_out_is_told(page: Page) -> None:
    listed = page.ask("runs")[1]
    told = {run["run"]: run for run in listed["runs"]}
    assert list(told) == sorted(told)
    assert {"begun", "more/nasty", "walks"} <= set(told)  # and what a conversation of another test has run
    walks = told["walks"]
    assert (walks["text"], walks["ego"], walks["adversary"]) == ("A pedestrian steps out.", "rule-based", "pedestrian")
    assert walks["ran"] == 10
    assert sum(walks["struck"].values()) == walks["collided"] > walks["avoidable"] >= 0
    assert walks["report"]
    assert not told["begun"]["report"]
    assert told["begun"]["status"] == "stopped"  # nobody works on it
    assert any("broken" in line for line in listed["left_out"])


def test_pages_about_several_runs_are_listed_and_served(page: Page) -> None:
    told = {one["name"]: (one["kind"], one["title"]) for one in page.ask("runs")[1]["pages"]}
    assert told == {
        "egos/compared": ("evaluation", "idm, planner on every scene of 1 run"),
        "served": ("coverage", "What of catalogues is served"),
    }
    reports = page.server.of_reports
    assert b"planner" in page.ask("egos/compared/report.html", secret=reports)[1]
    assert page.ask("served/coverage.html", secret=reports)[1] == b"<p>coverage"


def test_two_runs_stand_beside_each_other(page: Page) -> None:
    compared = page.ask("compare?first=walks&second=more%2Fnasty")[1]
    groups = {group["title"]: {row["name"]: row["values"] for row in group["rows"]} for group in compared["groups"]}
    assert groups["asked"]["text"] == ["A pedestrian steps out.", NASTY]
    assert groups["read"]["occluder"] == ["bus-stop"] * 2
    assert groups["came to"]["scenes driven"] == ["10", "10"]
    assert compared["difference"] == []
    assert page.ask("compare?first=walks&second=none")[0] == 404


def test_a_run_has_a_picture_and_its_report_is_served_in_a_sandbox(page: Page) -> None:
    status, picture, _ = page.ask("still?run=walks")
    assert status == 200
    assert picture[8:12] == b"WEBP"
    status, report, answer = page.ask("more/nasty/report.html", secret=page.server.of_reports)
    assert (status, report) == (200, b"<p>report of more/nasty")
    policy = answer.headers["Content-Security-Policy"]
    assert policy.startswith("sandbox allow-scripts allow-downloads; default-src 'none';")
    assert "allow-same-origin" not in policy


@pytest.mark.parametrize(
    ("how", "status"),
    [
        ({"secret": "guessed"}, 403),
        ({"secret": ""}, 403),
        ({"headers": {"Host": "evil.example"}}, 403),
        ({"headers": {"Host": "127.0.0.1:1"}}, 403),
        ({"headers": {"Origin": "http://evil.example"}}, 403),
        ({"headers": {"Origin": "null"}}, 403),
        ({"said": {"line": "x"}, "headers": {"Origin": "http://evil.example"}}, 403),
        ({"said": {"line": "x"}, "headers": {"Origin": "null"}}, 403),
        ({"said": {"line": "x"}, "headers": {"Content-Type": "text/plain"}}, 415),
        ({"said": b"{" * 1000}, 400),
        ({"said": b"[]"}, 400),
        ({"said": b"\xff"}, 400),
        ({"said": {"line": 7}}, 400),
        ({"said": {"line": "x" * MOST}}, 413),
        ({"said": {"line": "x"}, "headers": {"Content-Length": "9" * 30}}, 413),
        ({"said": {"line": "x"}, "headers": {"Content-Length": "-1"}}, 411),
    ],
)
def test_nobody_but_the_page_is_heard(page: Page, how: dict[str, Any], status: int) -> None:
    path = "say" if "said" in how else ""
    assert page.ask(path, **how)[0] == status
    assert page.ask("talk")[1]["work"] is None


def test_a_request_without_its_origin_changes_nothing(page: Page) -> None:
    connection = http.client.HTTPConnection(page.host, timeout=60)
    connection.request("POST", f"/{page.server.secret}/cancel", b"{}", {"Content-Type": "application/json"})
    assert connection.getresponse().status == 403
    connection.close()


@pytest.mark.parametrize(
    "path",
    [
        "../report.html",
        "..%2freport.html",
        "%2e%2e/secret.html",
        "walks/../../report.html",
        "walks/run.json",
        "walks/scenes.parquet",
        "/etc/passwd",
        "%2Fetc%2Fpasswd",
        "walks%00/report.html",
        "a" * 5000 + "/report.html",
        "begun/report.html",
        "begun/coverage.html",
        "../coverage.html",
        "served/report.html",
        "",
    ],
)
def test_no_path_leads_to_anything_but_the_report_of_a_run(page: Page, path: str) -> None:
    status, content, _ = page.ask(path, secret=page.server.of_reports)
    assert status == 404
    assert b"secret" not in json.dumps(content).encode()
    assert page.ask(f"still?run={path}")[0] == 404


def test_the_secret_of_reports_opens_nothing_else(page: Page) -> None:
    for path in ("talk", "about", "runs"):
        assert page.ask(path, secret=page.server.of_reports)[0] == 404
    assert page.ask("walks/report.html")[0] == 404


def test_a_link_leads_nowhere(page: Page, folder: Path) -> None:
    linked = folder / "linked"
    linked.symlink_to(folder.parent, target_is_directory=True)
    try:
        assert page.ask("linked/report.html", secret=page.server.of_reports)[0] == 404
        with pytest.raises(RunError, match="no run"):
            run_below(folder, "linked/runs/../../secret")
    finally:
        linked.unlink()


def test_the_page_allows_its_own_scripts_and_nothing_from_anywhere(page: Page) -> None:
    status, content, answer = page.ask("")
    assert status == 200
    policy = answer.headers["Content-Security-Policy"]
    assert "default-src 'none'" in policy
    assert "script-src 'self'" in policy
    assert "unsafe" not in policy
    assert "require-trusted-types-for 'script'" in policy
    assert answer.headers["Referrer-Policy"] == "no-referrer"
    assert b"://" not in content
    for name in ("view.js", "page.js", "runs.js", "talk.js", "compare.js", "view.css", "viewer.css"):
        status, content, answer = page.ask(name)
        assert status == 200
        assert not [word for word in (b"innerHTML", b"outerHTML", b"insertAdjacentHTML", b"http:") if word in content]


def test_a_port_that_is_taken_is_told(page: Page, folder: Path) -> None:
    with pytest.raises(SettingsError, match="say another --port"):
        Server(folder, page.server.server_port, READING, SEARCH)


def test_a_conversation_asks_back_changes_takes_back_and_runs(page: Page, folder: Path) -> None:
    refused = page.turn("new a lorry comes over from the right because of a xylophone")
    assert refused["kind"] == "refused"
    assert [one["reading"] for one in refused["readings"]] == [1, 2, 3]
    assert any(part["unread"] for part in refused["parts"])

    shown = page.turn("reading 1")
    assert shown["told"] == "A truck is on a side road of the junction on our right. It crosses our path."
    assert ["others.A.starts.side", "right"] in shown["facts"]
    assert "Truck" in shown["program"]

    edited = page.turn("from the left")
    assert edited["changes"] == [{"fact": "others.A.starts.side", "before": "right", "after": "left"}]
    assert {"how": "gone", "text": "right."} in edited["sentence"]
    assert {"how": "new", "text": "left."} in edited["sentence"]
    assert any(line.startswith("+") and '"left"' in line for line in edited["difference"])

    assert page.turn("run ../elsewhere")["kind"] == "failed"
    night = page.turn("at night")
    undone = page.turn("undo")
    assert (undone["kind"], undone["edit"], undone["edits"]) == ("undone", "at night", ["from the left"])
    assert undone["told"] == edited["told"] != night["told"]
    assert page.turn("make it a dragon")["kind"] == "failed"

    ran = page.turn("run")
    assert ran["kind"] == "ran"
    assert ran["counts"]["ran"] == 2
    assert ran["summary"][0].startswith("not read: ")  # a pedestrian alone was meant
    assert any(line.startswith("2 scenes") for line in ran["summary"])
    record = runs.read_record(runs.open_run(folder / ran["run"]))
    assert (record.status, record.edits, record.ego) == (Status.DONE, ["from the left"], "rule-based")
    assert b"<canvas" in page.ask(f"{ran['run']}/report.html", secret=page.server.of_reports)[1]
    assert not (folder.parent / "elsewhere").exists()


def test_a_second_line_is_told_that_one_is_worked_on_and_cancelling_leaves_the_situation(page: Page) -> None:
    told = page.turn("new the car ahead brakes hard")["told"]
    known = page.ask("talk")[1]["count"]
    assert page.ask("say", {"line": "run"})[0] == 200
    assert page.ask("talk")[1]["work"]["line"] == "run"
    status, content, _ = page.ask("say", {"line": "at night"})
    assert status == 409
    assert "'run' is worked on" in content["error"]
    assert page.ask("cancel", {})[1] == {"cancelled": True}
    assert page.awaited(known)["kind"] == "cancelled"
    assert page.ask("cancel", {})[1] == {"cancelled": False}
    assert page.turn("show")["told"] == told  # another process has heard it again


def test_a_process_that_dies_of_a_question_is_told_of_and_another_answers(folder: Path) -> None:
    child = Child(lambda: {"folder": str(folder)})
    child.start()
    with pytest.raises(Ended, match="status 1"):
        child.ask({"look": "nothing that there is", "runs": []})
    child.start()
    assert child.ask({"look": "still", "runs": ["none"]})["error"].startswith("there is no run 'none'")
    child.end()
    with pytest.raises(Ended, match="SIGKILL"):
        child.ask({"look": "list", "runs": []})
    child.close()


def test_words_that_would_be_a_script_are_words(page: Page) -> None:
    refused = page.turn(f"new {NASTY}")
    assert refused["kind"] == "refused"
    assert NASTY in page.ask("talk")[1]["turns"][-1]["line"]
    assert page.ask("talk")[2].headers.get_content_type() == "application/json"


def test_two_texts_are_told_as_one() -> None:
    parts = between("A car brakes.", "A big car stops.")
    assert [(part["how"], part["text"]) for part in parts] == [
        ("same", "A"), ("new", "big"), ("same", "car"), ("gone", "brakes."), ("new", "stops."),
    ]  # fmt: skip


def test_a_folder_without_runs_is_an_empty_list(tmp_path: Path) -> None:
    from chatscene.view.looking import listed

    assert listed(tmp_path / "none") == listed(tmp_path) == {"runs": [], "pages": [], "left_out": []}


def test_a_folder_with_an_evaluation_alone_lists_it(tmp_path: Path) -> None:
    from chatscene.view.looking import listed

    write_evaluation(evaluated(tmp_path))
    (tmp_path / "compared").rename(tmp_path / "alone")
    shutil.rmtree(tmp_path / "run")
    assert [one["name"] for one in listed(tmp_path)["pages"]] == ["alone"]
    assert listed(tmp_path)["runs"] == []


def test_open_opens_the_newest_report_or_the_one_that_is_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    opened: list[str] = []
    monkeypatch.setattr("webbrowser.open", opened.append)
    assert CliRunner().invoke(main, ["open"]).exit_code == 1
    for name in ("first", "second"):
        (finished(tmp_path / "runs" / name, count=1).path / "report.html").write_text(name)
    said = CliRunner().invoke(main, ["open", "runs/first"])
    assert said.output == "runs/first/report.html\n"
    assert opened == [(tmp_path / "runs/first/report.html").as_uri()]
    drawn = (tmp_path / "runs/first/report.html").read_text()
    assert drawn.startswith("<!doctype html>")  # anew: what stood there is never given to the browser
    assert len(drawn) > 10_000
    assert CliRunner().invoke(main, ["open"]).output == f"{tmp_path / 'runs/second/report.html'}\n"
    (tmp_path / "runs/broken").mkdir()
    (tmp_path / "runs/broken/run.json").write_text("{")  # which is passed over
    assert CliRunner().invoke(main, ["open"]).exit_code == 0
    (tmp_path / "runs/second/report.html").unlink()
    assert CliRunner().invoke(main, ["open", "runs/second"]).exit_code == 0  # it is drawn from the rest
    assert (tmp_path / "runs/second/report.html").is_file()


@pytest.mark.skipif(CHROMIUM is None, reason="needs Chromium to run the page's scripts")
def test_in_a_browser_runs_are_found_sorted_and_opened_and_nothing_that_was_said_runs(
    page: Page, tmp_path: Path
) -> None:
    with Browser(tmp_path / "profile", 400, 800) as browser:
        browser.open(page.server.address)
        browser.wait("document.querySelectorAll('#runs tbody tr').length >= 3")
        assert NASTY in browser.run("document.querySelector('#runs').innerText")
        browser.run("document.querySelector('#find').focus()")
        browser.type("walks")
        assert browser.run("document.querySelector('#count').textContent").startswith("1 of ")
        assert browser.run("document.querySelector('#pages').hidden")
        browser.run("document.querySelector('#find').value = ''")
        browser.run("document.querySelector('#find').dispatchEvent(new Event('input'))")
        assert browser.run("document.documentElement.scrollWidth <= innerWidth")
        assert browser.passed_over() == []
        browser.run("document.querySelector('#pages a[href^=\"#/evaluation\"]').click()")
        browser.wait("document.querySelector('#report-frame iframe')?.ariaBusy === null")
        titled = browser.run("document.querySelector('#report-title').textContent")
        assert titled == "idm, planner on every scene of 1 run"
        assert browser.run("document.documentElement.scrollWidth <= innerWidth")


class Stub:
    """What is understood of a text, as far as a talk asks."""

    def __init__(self, said: list[str]) -> None:
        self.said = said

    def edit(self, line: str) -> Stub:
        if "refuse" in line:
            raise EditRefused(line)
        return Stub([*self.said, line])


def test_another_process_goes_on_from_where_a_talk_stood_and_hears_no_line_again(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    done: list[tuple[str, object]] = []

    def explain(text: str, **options: Any) -> Stub:
        done.append((text, (options["reading"], options["set"])))
        if "refuse" in text or options["reading"] == 9 or "refuse" in options["set"].values():
            raise NothingFits("it fits nothing")
        return Stub([text])

    def run(text: str, folder: Path, **_: Any) -> None:
        done.append(("run", str(folder)))
        raise SettingsError("the disk is full")

    monkeypatch.setattr("chatscene.talk.make.explain", explain)
    monkeypatch.setattr("chatscene.talk.make.run", run)
    talk = Talk({}, {}, tmp_path)
    for line, kind in (
        ("a car ahead brakes", "shown"), ("at night", "edited"), ("in the rain", "edited"), ("undo", "undone"),
        ("refuse this edit", "refused"), ("run /tmp/elsewhere", "failed"), ("run", "failed"), ("show", "shown"),
        ("reading 9", "refused"), ("reading 1", "shown"), ("set side = refuse", "refused"),
        ("new refuse this sentence", "refused"), ("set side = left", "refused"), ("run", "failed"),
    ):  # fmt: skip
        try:
            talk.hear(line)
            assert kind not in ("refused", "failed"), line
        except ChatSceneError:
            assert kind in ("refused", "failed"), line
    done.clear()
    other = Talk({}, {}, tmp_path)
    other.go_on(json.loads(json.dumps(talk.kept)))
    assert done == [("a car ahead brakes", (1, {}))]
    assert (other.kept, other.edits) == (talk.kept, ["at night"])
    done.clear()
    with pytest.raises(NothingFits):
        other.hear("reading 2")  # answers what was asked back last
    assert done == [("refuse this sentence", (2, {"side": "left"}))]


@pytest.mark.parametrize("kind", ["shown", "edited", "undone", "refused", "failed", "ran"])
def test_a_process_is_given_what_stood_and_never_a_line(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, kind: str
) -> None:
    stood = {"text": "a car ahead brakes"}

    class Answering:
        def __init__(self, setup: Callable[[], dict[str, Any]]) -> None:
            self.setup = setup

        def ask(self, question: dict[str, str], _: object) -> dict[str, Any]:
            if question["line"] == "die":
                raise Ended("it ended")
            return {"kind": kind, "kept": stood}

    monkeypatch.setattr("chatscene.view.conversation.Child", Answering)
    talk: Any = Conversation(tmp_path, {}, {})
    for line in ("run /tmp/elsewhere", "die"):
        talk._answer(line, {"since": 0.0, "cancelled": False, "folder": ""})
    assert talk._child.setup() == {"folder": str(tmp_path), "reading": {}, "search": {}, "kept": stood}
    assert [turn["kind"] for turn in talk.state(0)["turns"]] == [kind, "crashed"]
    assert all("kept" not in turn for turn in talk.state(0)["turns"])


@pytest.mark.parametrize(
    "query",
    [
        "talk?since=" + "9" * 5000, "talk?since=-1", "talk?since=%D9%A3", "talk?since=",
        "talk?since=1&since=2", "talk?until=1", "talk?" + "&".join(f"a{i}=1" for i in range(100)), "runs?first=x",
        "compare?first=" + "a" * 9000, "still?run=a&run=b", "about?x=%00",
    ],
)  # fmt: skip
def test_what_is_asked_is_checked_value_by_value(page: Page, query: str) -> None:
    status, content, _ = page.ask(query)
    assert status == 400
    assert content["error"]


def test_an_address_that_is_none_is_told(page: Page, capfd: pytest.CaptureFixture[str]) -> None:
    with socket.create_connection(("127.0.0.1", page.server.server_port), timeout=60) as connection:
        connection.sendall(f"GET http://[ HTTP/1.1\r\nHost: {page.host}\r\n\r\n".encode())
        assert connection.recv(1000).startswith(b"HTTP/1.1 400")
    assert "Traceback" not in capfd.readouterr().err


def test_who_connects_and_asks_for_nothing_gives_way_to_others(page: Page) -> None:
    before = threading.active_count()
    with ExitStack() as held:
        for number in range(CONNECTIONS + 30):
            place = ("127.0.0.1", page.server.server_port)
            connection = held.enter_context(socket.create_connection(place, timeout=60))
            connection.sendall((b"", b"GET /", b"POST / HTTP/1.1\r\nContent-Length: 9\r\n")[number % 3])
        assert page.ask("about")[0] == 200
        while threading.active_count() > before + CONNECTIONS + 1:  # those that gave way are about to end
            time.sleep(0.01)
        assert page.ask("talk")[0] == 200


def test_who_takes_too_long_to_ask_is_ended(page: Page, monkeypatch: pytest.MonkeyPatch) -> None:
    with socket.create_connection(("127.0.0.1", page.server.server_port), timeout=60) as connection:
        connection.sendall(b"GET /")
        monkeypatch.setattr("chatscene.view.server._WHOLE", 0.0)
        assert connection.recv(100) == b""
