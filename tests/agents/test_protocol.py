"""What the protocol asks of a server, by the official client and by bare requests, over both ways to reach it."""

from __future__ import annotations

import http.client
import json
import os
import subprocess
import sys
from collections.abc import AsyncGenerator, Generator, Mapping
from contextlib import AbstractAsyncContextManager, asynccontextmanager
from pathlib import Path
from typing import Any

import pytest

from chatscene.mcp.resources import PAGE
from chatscene.mcp.server import agent_server
from chatscene.mcp.tools import TOOLS
from folder_of_agents import CROSSES, furnished

mcp = pytest.importorskip("mcp")

import anyio  # noqa: E402

TOKEN = "a-token-of-the-users-own"
PROTOCOLS = ("2024-11-05", "2025-03-26", "2025-06-18", "2025-11-25")  # that begin with initialize
STATELESS = "2026-07-28"
TOLD: Mapping[str, str] = {
    "Authorization": f"Bearer {TOKEN}",
    "Content-Type": "application/json",
    "Accept": "application/json, text/event-stream",
}


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    made = furnished(tmp_path_factory.mktemp("protocol") / "folder")
    for number in range(PAGE):
        (made / f"more-{number}.yaml").write_text("{}")
    (made / "broken.csv").write_text("no table\n")
    return made


@pytest.fixture(scope="module")
def port(folder: Path) -> Generator[int]:
    command = [sys.executable, "-m", "chatscene", "mcp", str(folder), "--http", "--port", "0"]
    said = {**os.environ, "CHATSCENE_MCP_TOKEN": TOKEN}
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, env=said, text=True) as process:
        assert process.stdout
        line = process.stdout.readline()
        yield int(line.partition("127.0.0.1:")[2].partition("/")[0])
        process.terminate()


def asked(port: int, body: Any = None, method: str = "POST", **headers: str) -> tuple[int, dict[str, str], Any]:
    """Status, headers and message of an answer; a header is named with ``_`` for ``-``, and left out if it is empty."""
    told = {**TOLD} | {name.replace("_", "-"): value for name, value in headers.items()}
    connection = http.client.HTTPConnection("127.0.0.1", port, timeout=60)
    connection.request(
        method,
        "/mcp",
        body if isinstance(body, bytes) else json.dumps(body).encode(),
        {name: value for name, value in told.items() if value},
    )
    answer = connection.getresponse()
    text = answer.read().decode()
    connection.close()
    lines = [line.removeprefix("data: ") for line in text.splitlines() if line.startswith("data: {")]
    try:
        message = json.loads(lines[-1] if lines else text)
    except ValueError:
        message = text
    return answer.status, {name.lower(): value for name, value in answer.getheaders()}, message


def request(method: str, **params: Any) -> dict[str, Any]:
    return {"jsonrpc": "2.0", "id": 1, "method": method, "params": params}


def begun(port: int, protocol: str) -> tuple[str, str]:
    """The session that a client has which says a protocol first, and the protocol of the server."""
    client = {"name": "test", "version": "1"}
    said = request("initialize", protocolVersion=protocol, capabilities={}, clientInfo=client)
    status, headers, answer = asked(port, said)
    assert status == 200
    return headers["mcp-session-id"], answer["result"]["protocolVersion"]


@pytest.fixture(scope="module")
def session(port: int) -> dict[str, str]:
    return {"Mcp_Session_Id": begun(port, "2025-11-25")[0], "Mcp_Protocol_Version": "2025-11-25"}


@pytest.mark.parametrize("protocol", [*PROTOCOLS, STATELESS, "1999-01-01", "2099-01-01", ""])
def test_a_known_protocol_is_spoken_and_else_the_newest_that_begins_so(port: int, protocol: str) -> None:
    assert begun(port, protocol)[1] == (protocol if protocol in PROTOCOLS else PROTOCOLS[-1])


NO_MESSAGES: Mapping[bytes, int] = {
    b"": -32700,
    b"garbage": -32700,
    b"\xff\xfe": -32700,
    b"[" * 10_000: -32700,
    b"[]": -32600,
    b'[{"jsonrpc": "2.0", "id": 1, "method": "ping"}]': -32600,
    b'{"jsonrpc": "2.0", "id": null, "method": "tools/list"}': -32600,
    b'{"jsonrpc": "2.0", "id": 1.5, "method": "tools/list"}': -32600,
    b'{"jsonrpc": "2.0", "id": true, "method": "tools/list"}': -32600,
    b'{"jsonrpc": "2.0", "id": [1], "method": "tools/list"}': -32600,
    b'{"jsonrpc": "1.0", "id": 1, "method": "ping"}': -32600,
    b'{"jsonrpc": "2.0", "id": 1}': -32600,
}


@pytest.mark.parametrize("body", NO_MESSAGES)
def test_a_body_that_is_no_message_is_answered_so(port: int, session: dict[str, str], body: bytes) -> None:
    status, _, answer = asked(port, body, **session)
    assert status == 400
    assert answer["error"]["code"] == NO_MESSAGES[body]
    assert len(answer["error"]["message"]) < 200
    assert asked(port, request("ping"), **session)[2]["result"] == {}


@pytest.mark.parametrize(
    ("status", "headers"),
    [
        (200, {}),
        (200, {"Authorization": f"bearer {TOKEN}"}),
        (200, {"Origin": "http://localhost:3000"}),
        (401, {"Authorization": ""}),
        (401, {"Authorization": TOKEN}),
        (403, {"Origin": "http://evil.example.com"}),
        (403, {"Origin": "http://localhost.evil.example.com:80"}),
        (403, {"Origin": "null"}),
        (421, {"Host": "evil.example.com"}),
        (404, {"Mcp_Session_Id": "another"}),
        (400, {"Mcp_Session_Id": ""}),
        (400, {"Mcp_Protocol_Version": "1999-01-01"}),
        (400, {"Content_Type": "text/plain"}),
        (406, {"Accept": "text/html"}),
    ],
)
def test_a_request_comes_in_by_its_headers(
    port: int, session: dict[str, str], status: int, headers: dict[str, str]
) -> None:
    assert asked(port, request("ping"), **{**session, **headers})[0] == status


def test_what_is_no_method_is_an_error_and_a_notification_has_no_answer(port: int, session: dict[str, str]) -> None:
    assert asked(port, request("foo/bar"), **session)[2]["error"]["code"] == -32601
    status, _, nothing = asked(port, {"jsonrpc": "2.0", "method": "notifications/foo"}, **session)
    assert (status, nothing) == (202, "")
    assert asked(port, b'"' + b"a" * 5_000_000 + b'"', **session)[0] == 413


def test_a_session_ends_when_its_client_says_so(port: int) -> None:
    mine = {"Mcp_Session_Id": begun(port, "2025-11-25")[0]}
    assert asked(port, method="DELETE", **mine)[0] == 200
    assert asked(port, request("ping"), **mine)[0] == 404


@asynccontextmanager
async def reached(how: str, folder: Path, port: int) -> AsyncGenerator[Any]:
    """The server as the official client takes it: by a process of its own, or over HTTP."""
    if how == "stdio":
        from mcp import StdioServerParameters
        from mcp.client.stdio import stdio_client

        command = ["-m", "chatscene", "mcp", str(folder)]
        yield stdio_client(StdioServerParameters(command=sys.executable, args=command))
        return
    import httpx2
    from mcp.client.streamable_http import streamable_http_client

    async with httpx2.AsyncClient(headers={"Authorization": f"Bearer {TOKEN}"}, timeout=120) as sends:
        yield streamable_http_client(f"http://127.0.0.1:{port}/mcp", http_client=sends)


async def code_of(answer: Any) -> tuple[int, Any]:
    with pytest.raises(mcp.MCPError) as refused:
        await answer
    return refused.value.code, refused.value.data


@pytest.mark.parametrize(("mode", "not_found"), [("legacy", -32002), (STATELESS, -32602)])
def test_lists_and_resources_refuse_as_each_protocol_says(folder: Path, mode: str, not_found: int) -> None:
    async def speak() -> None:
        opened: AbstractAsyncContextManager[Any] = mcp.Client(agent_server(folder), mode=mode)
        async with opened as client:
            for lists in (client.list_tools, client.list_resources, client.list_resource_templates):
                assert await code_of(lists(cursor="x")) == (-32602, None)
            for none in ("chatscene://file/none.yaml", "chatscene://nowhere", "test://x", "chatscene://word/dragon"):
                assert await code_of(client.read_resource(none)) == (not_found, {"uri": none})
            assert await code_of(client.read_resource("chatscene://" + "x" * 5_000)) == (not_found, None)
            assert await code_of(client.read_resource("chatscene://picture/broken.csv")) == (-32603, None)
            assert (await code_of(client.list_prompts()))[0] == -32601

    anyio.run(speak)


@pytest.mark.parametrize(("mode", "how"), [("legacy", "stdio"), (STATELESS, "http")])
def test_the_official_client_is_served_told_how_far_it_is_and_can_cancel(
    folder: Path, port: int, how: str, mode: str
) -> None:
    told: list[float] = []
    out = f"cancelled-{how}-{mode}"

    async def speak() -> None:
        async with reached(how, folder, port) as transport, mcp.Client(transport, mode=mode) as client:
            assert client.protocol_version == (PROTOCOLS[-1] if mode == "legacy" else STATELESS)
            assert [tool.name for tool in (await client.list_tools()).tools] == list(TOOLS)
            first = await client.list_resources()
            rest = await client.list_resources(cursor=first.next_cursor)
            addresses = [one.uri for one in (*first.resources, *rest.resources)]
            assert len(first.resources) == PAGE
            assert len({*addresses}) == len(addresses) > PAGE
            assert "brake" in (await client.read_resource("chatscene://acts")).contents[0].text
            async with anyio.create_task_group() as group:

                async def hear(progress: float, _total: float | None, _message: str | None) -> None:
                    told.append(progress)
                    if len(told) == 2:
                        group.cancel_scope.cancel()

                arguments = {"sentence": CROSSES, "scenes": 1000, "out": out}
                await client.call_tool("run", arguments, progress_callback=hear)
            with anyio.fail_after(60):  # not after a thousand scenes
                assert not (await client.call_tool("vocabulary", {"about": "brake"})).is_error
            record = folder / out / "run.json"
            assert not record.exists() or json.loads(record.read_text())["status"] != "done"

    anyio.run(speak)
    assert told == sorted(told)
    assert len(told) == 2
