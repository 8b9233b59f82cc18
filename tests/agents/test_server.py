"""The server as the official client speaks to it, and as one that should not."""

from __future__ import annotations

import base64
import json
import platform
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Generator, Mapping
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner
from hypothesis import given, settings
from hypothesis import strategies as st

from chatscene.commands.main import main
from chatscene.errors import MissingExtra
from chatscene.mcp import server as serving
from chatscene.mcp import walls
from chatscene.mcp.server import MOST_ERROR, MOST_TEXT, agent_server, require_mcp
from chatscene.mcp.tools import TOOLS
from chatscene.mcp.transports import guarded
from chatscene.mcp.walls import served_model
from chatscene.simulate.confined.landlock import landlock_version
from chatscene.view.child import Ended
from folder_of_agents import CROSSES, furnished

mcp = pytest.importorskip("mcp")

import anyio  # noqa: E402
from anyio.from_thread import BlockingPortal, start_blocking_portal  # noqa: E402

INITIALIZE = {
    "jsonrpc": "2.0",
    "id": 0,
    "method": "initialize",
    "params": {"protocolVersion": "2025-06-18", "capabilities": {}, "clientInfo": {"name": "test", "version": "1"}},
}


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return furnished(tmp_path_factory.mktemp("served") / "folder")


@pytest.fixture(scope="module")
def portal() -> Generator[BlockingPortal]:
    with start_blocking_portal() as made:
        yield made


@pytest.fixture(scope="module")
def client(folder: Path, portal: BlockingPortal) -> Generator[Any]:
    opened = mcp.Client(agent_server(folder), mode="legacy")
    with portal.wrap_async_context_manager(opened) as made:
        yield made


def text_of(answer: Any) -> str:
    return answer.content[0].text


def test_the_tools_are_those_of_the_table_each_with_parts(client: Any, portal: BlockingPortal) -> None:
    tools = {tool.name: tool for tool in portal.call(client.list_tools).tools}
    assert list(tools) == list(TOOLS)
    assert all("part" in tool.input_schema["properties"] for tool in tools.values())
    assert tools["story"].annotations.read_only_hint
    assert not tools["run"].annotations.read_only_hint


def test_a_call_is_answered_and_a_picture_comes_as_png(client: Any, portal: BlockingPortal) -> None:
    answer = portal.call(client.call_tool, "story", {"what": "drive.csv", "at": 2.0})
    assert not answer.is_error
    assert "the ego goes at 36 km/h" in text_of(answer)
    assert answer.content[1].mime_type == "image/png"
    read = portal.call(client.read_resource, "chatscene://picture/drive.csv?at=2")
    assert base64.b64decode(read.contents[0].blob).startswith(b"\x89PNG")


def test_a_long_answer_comes_in_parts_and_is_made_once(
    client: Any, portal: BlockingPortal, monkeypatch: pytest.MonkeyPatch
) -> None:
    def halves(text: str) -> list[str]:
        return [text[:50], text[50:]]

    monkeypatch.setattr(serving, "in_parts", halves)
    first = portal.call(client.call_tool, "vocabulary", {"about": "Act"})
    assert "(part 1 of 2; for the next call vocabulary again with part=2)" in text_of(first)
    second = portal.call(client.call_tool, "vocabulary", {"about": "Act", "part": 2})
    assert "brake: loses speed hard" in text_of(second)
    for arguments, says in (
        ({"about": "Act", "part": 3}, "has 2 parts"),
        ({"about": "Act", "part": "x"}, "not a whole number"),
        ({"about": "Where", "part": 2}, "no answer to this call"),
    ):
        wrong = portal.call(client.call_tool, "vocabulary", arguments)
        assert wrong.is_error
        assert says in text_of(wrong)


def test_long_work_says_how_far_it_is_and_ends_when_it_is_cancelled(
    client: Any, portal: BlockingPortal, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(serving, "LOOK", 0.05)
    told: list[tuple[float, str]] = []

    async def hear(progress: float, _total: float | None, message: str | None) -> None:
        told.append((progress, message or ""))

    async def begin() -> bool:
        with anyio.move_on_after(60) as scope:
            async with anyio.create_task_group() as group:

                async def call() -> None:
                    arguments = {"sentence": CROSSES, "scenes": 1000, "out": "cancelled"}
                    await client.call_tool("run", arguments, progress_callback=hear)

                group.start_soon(call)
                while not any("of 1000" in message for _, message in told):
                    await anyio.sleep(0.05)
                group.cancel_scope.cancel()
        return scope.cancelled_caught

    assert not portal.call(begin)
    assert [progress for progress, _ in told] == sorted(progress for progress, _ in told)
    began = time.monotonic()
    assert not portal.call(client.call_tool, "vocabulary", {"about": "brake"}).is_error
    assert time.monotonic() - began < 60.0  # not after a thousand scenes
    assert json.loads((folder / "cancelled" / "run.json").read_text())["status"] != "done"


class Starting:
    """A process that is being started for as long as nobody ends it."""

    def __init__(self, *_: Any) -> None:
        self.begun, self.ended, self.told = threading.Event(), threading.Event(), list[str]()

    def start(self) -> None:
        self.begun.set()
        assert self.ended.wait(10)
        self.told.append("there")

    def end(self) -> None:
        self.told.append("ended")
        self.ended.set()

    def ask(self, *_: Any) -> dict[str, Any]:
        if self.told[-1] == "ended":
            raise Ended("ended")
        self.told.append("asked")
        return {}

    def close(self) -> None:
        self.ended.set()


def test_a_call_that_is_cancelled_while_the_process_starts_is_not_worked_on(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(serving, "Child", Starting)

    async def begin() -> list[str]:
        worker: Any = serving.Worker(tmp_path, {})
        async with anyio.create_task_group() as group:
            group.start_soon(worker.ask, {"list": 0}, None)
            while not worker._child.begun.is_set():
                await anyio.sleep(0.01)
            group.cancel_scope.cancel()
        worker.close()
        return worker._child.told

    assert anyio.run(begin) == ["ended", "there", "ended"]


def test_an_unknown_tool_and_an_unknown_address_are_told_by_their_nearest(client: Any, portal: BlockingPortal) -> None:
    with pytest.raises(mcp.MCPError, match="did you mean 'verify'"):
        portal.call(client.call_tool, "verfy", {})
    with pytest.raises(mcp.MCPError, match="did you mean 'acts'"):
        portal.call(client.read_resource, "chatscene://act")


# A hostile client in miniature

VALUES = st.recursive(
    st.none()
    | st.booleans()
    | st.integers()
    | st.floats()
    | st.text(max_size=30)
    | st.sampled_from(["../x.yaml", "/etc/passwd", "link/secret.yaml", "a" * 5000, "drive.csv\0", "~", "."]),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=8), inner, max_size=3),
    max_leaves=6,
)
NAMES = sorted({name for tool in TOOLS.values() for name in tool.arguments.model_fields})


@st.composite
def wrong_calls(draw: st.DrawFn) -> tuple[str, dict[str, Any]]:
    """A call of which no argument is as it must be, or one is no argument."""
    tool = draw(st.sampled_from(sorted(TOOLS)))
    arguments: dict[str, Any] = draw(st.dictionaries(st.sampled_from(NAMES), VALUES, max_size=4))
    wrong = draw(st.sampled_from(("nonsense", "Part", "what ", "__class__")))
    return tool, {**arguments, wrong: draw(VALUES)}


@settings(max_examples=25)
@given(wrong_calls())
def test_every_malformed_call_has_one_clear_error_and_the_server_lives_on(
    client: Any, portal: BlockingPortal, call: tuple[str, dict[str, Any]]
) -> None:
    tool, arguments = call
    answer = portal.call(client.call_tool, tool, arguments)
    assert answer.is_error
    assert len(answer.content) == 1
    assert text_of(answer).startswith(("WrongArguments: ", f"{tool}: part"))
    assert len(text_of(answer)) <= MOST_ERROR + 1
    assert portal.call(client.list_tools).tools


def lines_answered(folder: Path, *lines: bytes) -> list[dict[str, Any]]:
    """What the command answers to lines, of which each has an answer, in order."""
    command = [sys.executable, "-m", "chatscene", "mcp", str(folder)]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE) as process:
        assert process.stdin
        assert process.stdout
        process.stdin.write(b"\n".join(lines) + b"\n")
        process.stdin.flush()
        answers = [json.loads(process.stdout.readline()) for _ in lines]
        process.stdin.close()
        assert process.wait(60) == 0
        assert not process.stdout.read()
    return answers


MALFORMED: Mapping[bytes, int] = {
    b"garbage": -32700,
    b"[" * 10_000: -32700,
    b"\xff\xfe\x00": -32700,
    b"[]": -32600,
    b'{"jsonrpc": "2.0", "id": 1.5, "method": "tools/list"}': -32600,
    b'{"jsonrpc": "2.0", "id": null, "method": "tools/list"}': -32600,
    b'{"jsonrpc": "1.0", "id": 1, "method": "tools/list"}': -32600,
    b'{"jsonrpc": "2.0", "id": 2}': -32600,
    b'{"jsonrpc": "2.0", "id": 3, "method": "tools/call"}': -32602,
    b'{"jsonrpc": "2.0", "id": 4, "method": "tools/call", "params": {"name": 7}}': -32602,
    b'{"jsonrpc": "2.0", "id": 5, "method": "tools/call", "params": {"name": "verify", "arguments": [1]}}': -32602,
    b'{"jsonrpc": "2.0", "id": 6, "method": "tools/call", "params": {"name": "verfy"}}': -32602,
    b'{"jsonrpc": "2.0", "id": 7, "method": "prompts/list"}': -32601,
    b'{"jsonrpc": "2.0", "id": 8, "method": "resources/list", "params": {"cursor": "x"}}': -32602,
}


def test_each_line_that_is_no_request_has_one_answer_that_says_so(folder: Path) -> None:
    before = b'{"jsonrpc": "2.0", "id": "early", "method": "tools/list"}'
    last = b'{"jsonrpc": "2.0", "id": "last", "method": "tools/list"}'
    answers = lines_answered(folder, before, json.dumps(INITIALIZE).encode(), *MALFORMED, last)
    by_id = {one["id"]: one for one in answers}
    assert "initialize" in by_id["early"]["error"]["message"]
    assert "loop" in by_id[0]["result"]["instructions"]
    assert len(by_id["last"]["result"]["tools"]) == len(TOOLS)
    wrong = [one["error"] for one in answers if one["id"] not in ("early", 0, "last")]
    assert sorted(one["code"] for one in wrong) == sorted(MALFORMED.values())
    assert all(0 < len(one["message"]) <= MOST_ERROR for one in wrong)


# HTTP, and what is not there


def asked(headers: list[tuple[bytes, bytes]]) -> list[Any]:
    """What an application behind the token answers."""
    sent: list[Any] = []

    async def app(_scope: Any, _receive: Any, _send: Any) -> None:
        sent.append("let in")

    async def send(message: Any) -> None:
        sent.append(message)

    async def ask() -> None:
        await guarded(app, "a-token-of-the-users-own")({"type": "http", "headers": headers}, None, send)

    anyio.run(ask)
    return sent


def test_nobody_is_let_in_without_the_token() -> None:
    assert asked([(b"authorization", b"Bearer a-token-of-the-users-own")]) == ["let in"]
    for wrong in (b"", b"Bearer ", b"Bearer a-token-of-the-users-ow", b"a-token-of-the-users-own", b"Bearer \xff"):
        refused, body = asked([(b"authorization", wrong)])
        assert refused["status"] == 401
        assert b"Authorization" in body["body"]
    assert asked([])[0]["status"] == 401


def test_without_the_package_the_extra_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    def nowhere(_name: str) -> None:
        return None

    monkeypatch.setattr(serving, "find_spec", nowhere)
    with pytest.raises(MissingExtra, match=r"\[mcp\]"):
        require_mcp()


def test_a_language_model_is_one_that_is_built_in_and_its_file_has_a_whole_path(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "model.gguf").write_bytes(b"GGUF")
    assert served_model("offline") == "offline"
    assert served_model("openai:small") == "openai:small"
    assert served_model("gguf:model.gguf") == f"gguf:{tmp_path / 'model.gguf'}"
    for wrong in ("mine:make:x", "gguf:", "gguf:none.gguf", "offline:x", ""):
        refused = CliRunner().invoke(main, ["mcp", str(tmp_path), "--language-model", wrong])
        assert refused.exit_code == 1, wrong
        assert "language model" in refused.output


WALLED = """
import errno, socket, sys
from pathlib import Path
from chatscene.mcp.walls import stay_in
assert stay_in(Path(sys.argv[1]), Path(sys.argv[1]), sys.argv[2]) == ()
socket.socketpair()
def made(family, kind):
    try:
        socket.socket(family, kind).close()
    except PermissionError:
        return "refused"
    return "made"
families = (socket.AF_INET, socket.AF_INET6, socket.AF_UNIX)
print(*{made(family, kind) for family in families for kind in (socket.SOCK_STREAM, socket.SOCK_DGRAM)})
"""


@pytest.mark.parametrize(("model", "sockets"), [("offline", "refused"), ("openai:small", "made")])
def test_who_works_for_an_agent_makes_no_socket_unless_a_model_elsewhere_reads(
    tmp_path: Path, model: str, sockets: str
) -> None:
    if landlock_version() == 0 or platform.machine() not in ("x86_64", "aarch64"):
        pytest.skip("this kernel or machine has no such walls")
    command = [sys.executable, "-c", WALLED, str(tmp_path), model]
    assert subprocess.run(command, capture_output=True, text=True, check=True).stdout.strip() == sockets


def test_what_the_kernel_does_not_keep_to_is_said(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def neither(*_: Any, **__: Any) -> bool:
        return False

    for name in ("TMPDIR", "MPLCONFIGDIR"):
        monkeypatch.setenv(name, "")
    monkeypatch.setattr(tempfile, "tempdir", None)
    for name in ("kept_to", "filter_sockets", "no_new_privileges"):
        monkeypatch.setattr(walls, name, neither)
    assert walls.stay_in(tmp_path, tmp_path) == (walls.NO_LANDLOCK, walls.NO_FILTER)
    assert walls.stay_in(tmp_path, tmp_path, "openai:small") == (walls.NO_LANDLOCK,)


def test_the_command_needs_a_folder_and_a_long_token(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    none = CliRunner().invoke(main, ["mcp", str(tmp_path / "none")])
    assert none.exit_code == 1
    assert "no folder" in none.output
    monkeypatch.setenv("CHATSCENE_MCP_TOKEN", "short")
    short = CliRunner().invoke(main, ["mcp", str(tmp_path), "--http"])
    assert short.exit_code == 1
    assert "16 or more" in short.output
    assert CliRunner().invoke(main, ["mcp", str(tmp_path), "--port", "80"]).exit_code == 2
    assert MOST_TEXT < 10_000
