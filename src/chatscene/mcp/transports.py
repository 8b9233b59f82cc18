"""How agents reach the server: by the standard streams, or over HTTP on loopback with a token."""

from __future__ import annotations

import io
import json
import secrets
import socket
import sys
from collections.abc import AsyncIterable, AsyncIterator, Awaitable, Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

from chatscene.errors import SettingsError
from chatscene.mcp.server import agent_server
from chatscene.mcp.tool import short

if TYPE_CHECKING:
    from mcp.server.lowlevel import Server

LOOPBACK = "127.0.0.1"
PATH = "/mcp"
TOKEN = "CHATSCENE_MCP_TOKEN"
SHORTEST = 16  # characters of a token of the user's own

App = Callable[[Any, Any, Any], Awaitable[None]]


def serve_stdio(folder: Path, reading: Mapping[str, Any]) -> None:
    """Serve who started this process, by its standard streams, until they end."""
    server = agent_server(folder, reading)
    import anyio

    anyio.run(_over_stdio, server)


async def _over_stdio(server: Server[Any]) -> None:
    import anyio
    from mcp.server.stdio import stdio_server

    text = io.TextIOWrapper(sys.stdin.buffer, encoding="utf-8", errors="replace")
    try:
        async with stdio_server(stdin=cast("Any", _Lines(anyio.wrap_file(text)))) as (read, write):
            await over_streams(server, read, write)
    finally:
        text.detach()  # else it would close what it reads from


class _Lines:
    """Lines of messages, of which none has an id that no request can have: else it would pass for a notification."""

    def __init__(self, file: AsyncIterable[str]) -> None:
        self._file = file

    async def __aiter__(self) -> AsyncIterator[str]:
        async for line in self._file:
            yield '{"id": null}' if _odd(line) else line


def _odd(line: str | bytes) -> bool:
    """Whether a line or a body is a request but for its id."""
    try:
        said = json.loads(line)
    except (ValueError, RecursionError):
        return False  # which is told by whoever takes it for a message
    return isinstance(said, dict) and "id" in said and "method" in said and type(said["id"]) not in (int, str)


async def over_streams(server: Server[Any], read: Any, write: Any) -> None:
    """Serve over a pair of streams; a line that is no message is answered, which the package would pass over.

    Args:
        server: Which.
        read: Messages, and an error for what is none.
        write: Where answers go.
    """
    import anyio

    send, messages = anyio.create_memory_object_stream[Any](0)

    async def sort() -> None:
        from mcp.shared.message import SessionMessage

        async with read, send:
            async for item in read:
                if isinstance(item, Exception):
                    await write.send(SessionMessage(_no_message(item)))
                else:
                    await send.send(item)

    async with messages, anyio.create_task_group() as group:
        group.start_soon(sort)
        await server.run(messages, write, server.create_initialization_options())
        group.cancel_scope.cancel()


def _no_message(error: Exception) -> Any:
    """The answer to a line, or to the body of a request, that is no message."""
    from mcp_types import INVALID_REQUEST, PARSE_ERROR, ErrorData, JSONRPCError
    from pydantic import ValidationError

    faults = error.errors(include_url=False) if isinstance(error, ValidationError) else []
    if not faults or faults[0]["type"] == "json_invalid":
        message = f"this is not JSON: {faults[0]['msg'] if faults else short(str(error))}"
        return JSONRPCError(jsonrpc="2.0", id=None, error=ErrorData(code=PARSE_ERROR, message=message))
    given = next((one["input"] for one in faults if isinstance(one["input"], dict) and "id" in one["input"]), {})
    known = given.get("id")
    own = known if isinstance(known, str) or type(known) is int else None
    message = 'this is not a message of JSON-RPC 2.0: a request has "jsonrpc": "2.0", an "id" and a "method"'
    return JSONRPCError(jsonrpc="2.0", id=own, error=ErrorData(code=INVALID_REQUEST, message=message))


def serve_http(folder: Path, reading: Mapping[str, Any], port: int, token: str, say: Callable[[str], None]) -> None:
    """Serve whoever has the token, on loopback, until this is interrupted.

    Args:
        folder: Where agents work.
        reading: How sentences are read: options of `chatscene.explain`.
        port: Of loopback; 0 for a free one.
        token: What a request must have; empty for a fresh one.
        say: Told where the server is, and the token.

    Raises:
        SettingsError: The port is taken, or the token is short.
    """
    if token and (len(token) < SHORTEST or not token.isascii() or not token.isprintable() or " " in token):
        raise SettingsError(f"the token in {TOKEN} must have {SHORTEST} or more letters, digits or signs, and no space")
    server = agent_server(folder, reading)
    import uvicorn

    try:
        listening = socket.create_server((LOOPBACK, port))
    except OSError as error:
        message = f"port {port} of {LOOPBACK} cannot be had ({error.strerror}); say another --port"
        raise SettingsError(message) from error
    secret = token or secrets.token_urlsafe(24)
    with listening:
        address = f"http://{LOOPBACK}:{listening.getsockname()[1]}{PATH}"
        told = f"the one in {TOKEN}" if token else secret
        say(f"agents are served at {address} until this is interrupted (Ctrl+C)")
        say(f"they send: Authorization: Bearer {told}")
        sys.stdout.flush()
        app = guarded(checked(server.streamable_http_app(streamable_http_path=PATH, host=LOOPBACK)), secret)
        config = uvicorn.Config(app, log_level="warning", server_header=False, access_log=False)
        uvicorn.Server(config).run(sockets=[listening])


def checked(app: App) -> App:
    """An application of HTTP to which only messages come: the package would take a request of an odd id for none."""
    from mcp.server.transport_security import DEFAULT_MAX_REQUEST_BODY_SIZE, RequestBodyLimitMiddleware
    from mcp_types import jsonrpc_message_adapter

    async def check(scope: Any, receive: Any, send: Any) -> None:
        if scope["type"] != "http" or scope["method"] != "POST":
            await app(scope, receive, send)
            return
        came = [await receive()]  # the whole body, which the package has gathered
        body: bytes = came[0].get("body", b"")
        try:
            if came[0]["type"] == "http.request" and not came[0].get("more_body"):
                jsonrpc_message_adapter.validate_json(b'{"id": null}' if _odd(body) else body, by_name=False)
        except ValueError as error:
            said = _no_message(error).model_dump(mode="json", by_alias=True, exclude_unset=True)
            await _send(send, 400, said)
            return

        async def again() -> Any:
            return came.pop() if came else await receive()

        await app(scope, again, send)

    return cast("App", RequestBodyLimitMiddleware(cast("Any", check), DEFAULT_MAX_REQUEST_BODY_SIZE))


def guarded(app: App, token: str) -> App:
    """An application of HTTP that answers nobody without the token."""

    async def guard(scope: Any, receive: Any, send: Any) -> None:
        if scope["type"] == "http":
            scheme, _, given = dict(scope["headers"]).get(b"authorization", b"").partition(b" ")
            if scheme.lower() != b"bearer" or not secrets.compare_digest(given.strip(b" "), token.encode()):
                await _refuse(send)
                return
        await app(scope, receive, send)

    return guard


async def _refuse(send: Any) -> None:
    said = {"error": "unauthorized", "message": "send the header that was printed: Authorization: Bearer TOKEN"}
    await _send(send, 401, said, (b"www-authenticate", b"Bearer"))


async def _send(send: Any, status: int, said: Mapping[str, Any], *headers: tuple[bytes, bytes]) -> None:
    headers = ((b"content-type", b"application/json"), *headers)
    await send({"type": "http.response.start", "status": status, "headers": headers})
    await send({"type": "http.response.body", "body": json.dumps(said).encode()})
