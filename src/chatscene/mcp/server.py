"""The server: what agents ask goes to the process that works, one call at a time, and its answer comes back in parts.

The official package of the protocol is loaded when a server is made. Nothing of a call is done here: arguments are
checked, and then a process of its own works, which is ended with whatever it started if the call is cancelled.
"""

from __future__ import annotations

import json
import time
from collections import OrderedDict
from collections.abc import AsyncGenerator, Mapping
from contextlib import asynccontextmanager
from functools import partial
from importlib.metadata import version
from importlib.util import find_spec
from pathlib import Path
from tempfile import TemporaryDirectory
from threading import Event
from typing import TYPE_CHECKING, Any

from chatscene.errors import MissingExtra, no_such
from chatscene.mcp.folder import Folder
from chatscene.mcp.resources import KINDS
from chatscene.mcp.tool import SCHEME, Tool, WrongArguments, short
from chatscene.mcp.tools import TOOLS
from chatscene.view.child import Child, Ended

if TYPE_CHECKING:
    from mcp import types
    from mcp.server.context import CallNext, HandlerResult, ServerRequestContext
    from mcp.server.lowlevel import Server

MOST_TEXT = 6_000  # characters of a part of an answer
MOST_ERROR = 2_000
KEPT = 16  # answers of which the further parts can be asked for
WAITING = 32  # calls that wait for their turn at a time
LOOK, BEAT = 1.0, 5.0  # [s] between two looks at how far the work is, and at most between two times that it is told
NOT_FOUND = -32002  # of a resource, up to the protocol of 2025-11-25; the package does not name it
PART = {
    "type": "integer",
    "minimum": 1,
    "description": "Which part of a long answer; the further ones run nothing again.",
}
INSTRUCTIONS = """chatscene makes driving scenes and judges whether they show what was said.
All paths are below one folder. The loop:
1. vocabulary: the words of a situation. 2. build (or read, for a sentence): a situation becomes a program; save_as
keeps both. 3. verify: does the program show it, fact by fact? 4. story: what happened, if a fact is not shown.
5. edit or build again. 6. run: search it for crashes; why and rate say more; export writes it for other tools.
Trust verify, not that a program compiles. A situation is never misread; a sentence can be."""


def require_mcp() -> None:
    """Hold this installation to having the package of the protocol.

    Raises:
        MissingExtra: It has not.
    """
    if find_spec("mcp") is None:
        raise MissingExtra("a server for agents needs the package 'mcp'", extra="mcp")


class Worker:
    """The process that works, for one call at a time."""

    def __init__(self, folder: Path, reading: Mapping[str, Any]) -> None:
        import anyio

        self._temporary = TemporaryDirectory(prefix="chatscene-")
        setup = {"folder": str(folder), "reading": dict(reading), "temporary": self._temporary.name}
        self._child = Child(lambda: setup, "chatscene.mcp.working")
        self._turn, self._waiting = anyio.Lock(), 0

    async def ask(self, question: Mapping[str, Any], ctx: ServerRequestContext[Any, Any]) -> dict[str, Any]:
        """Its answer to a question; while it works, whoever asked is told how far it is.

        A call that is cancelled ends the process, and the next one has a fresh one.
        """
        if self._waiting >= WAITING:
            return {"error": f"{WAITING} calls wait already; wait for an answer before the next call"}
        self._waiting += 1
        try:
            async with self._turn:
                return await self._asked(question, ctx)
        finally:
            self._waiting -= 1

    async def _asked(self, question: Mapping[str, Any], ctx: ServerRequestContext[Any, Any]) -> dict[str, Any]:
        import anyio
        import anyio.to_thread

        done, answer, state, cancelled = anyio.Event(), dict[str, Any](), dict[str, Any](), Event()

        async def work() -> None:
            try:
                answer.update(await anyio.to_thread.run_sync(partial(self._answer, question, state, cancelled)))
            finally:
                done.set()

        async with anyio.create_task_group() as group:
            group.start_soon(work)
            group.start_soon(_beats, ctx, state, done)
            try:
                await done.wait()
            except anyio.get_cancelled_exc_class():
                cancelled.set()
                self._child.end()
                raise
        return answer

    def _answer(self, question: Mapping[str, Any], state: dict[str, Any], cancelled: Event) -> dict[str, Any]:
        try:
            self._child.start()
            if cancelled.is_set():  # before there was a process to end
                self._child.end()
            return self._child.ask(question, state.update)
        except Ended as error:
            return {"error": f"{error}. What was finished in the folder is kept; call again"}

    def close(self) -> None:
        """End the process; nobody may be asking it."""
        self._child.close()
        self._temporary.cleanup()


async def _beats(ctx: ServerRequestContext[Any, Any], state: Mapping[str, Any], done: Any) -> None:
    """Tell how far the work is: what changed, and from time to time that it goes on."""
    import anyio

    began = told_at = time.monotonic()
    told: dict[str, Any] = {}
    while True:
        with anyio.move_on_after(LOOK):
            await done.wait()
        if done.is_set():
            return
        now = time.monotonic()
        if (state and dict(state) != told) or now - told_at >= BEAT:
            told, told_at = dict(state), now
            how_far = f"{told.get('what', 'working')}" + (
                f": {told['done']} of {told['total']}" if told.get("total") else ""
            )
            # The protocol has a number that only grows; phases of the work begin from nothing again.
            await ctx.session.report_progress(round(now - began, 2), None, f"{how_far}, {now - began:.0f} s")


class Agents:
    """Answers agents in one folder.

    Raises:
        SettingsError: There is no such folder.
    """

    def __init__(self, folder: Path, reading: Mapping[str, Any]) -> None:
        self.worker = Worker(Folder(folder).root, reading)
        self._kept: OrderedDict[str, dict[str, Any]] = OrderedDict()

    async def tools(
        self, _ctx: ServerRequestContext[Any, Any], params: types.PaginatedRequestParams | None
    ) -> types.ListToolsResult:
        """The table of tools."""
        from mcp import types

        _whole(params)
        return types.ListToolsResult(tools=[_listed(tool) for tool in TOOLS.values()])

    async def call(
        self, ctx: ServerRequestContext[Any, Any], params: types.CallToolRequestParams
    ) -> types.CallToolResult:
        """What a tool says, in parts of a bounded size."""
        if (tool := TOOLS.get(params.name)) is None:
            raise _refused(no_such("tool", params.name[:60], TOOLS))
        arguments = dict(params.arguments or {})
        part = arguments.pop("part", 1)
        if type(part) is not int or part < 1:
            return _said(f"{tool.name}: part: {short(part)} is not a whole number from 1 on", error=True)
        try:
            tool.checked(arguments)
        except WrongArguments as error:
            return _said(f"WrongArguments: {error}", error=True)
        key = json.dumps([tool.name, arguments], sort_keys=True)
        if part == 1:
            self._keep(key, await self.worker.ask({"tool": tool.name, "arguments": arguments}, ctx))
        elif key not in self._kept:
            return _said(f"no answer to this call of {tool.name} is kept; call it without `part`", error=True)
        answer = self._kept[key]
        if "error" in answer:
            return _said(answer["error"], error=True)
        parts = in_parts(answer["text"])
        if part > len(parts):
            return _said(f"the answer of {tool.name} has {len(parts)} parts, not {part}", error=True)
        more = f"\n(part {part} of {len(parts)}" + (
            f"; for the next call {tool.name} again with part={part + 1})" if part < len(parts) else ")"
        )
        return _said(parts[part - 1] + more * (len(parts) > 1), picture=answer["picture"] if part == 1 else "")

    def _keep(self, key: str, answer: dict[str, Any]) -> None:
        self._kept[key] = answer
        self._kept.move_to_end(key)
        while len(self._kept) > KEPT:
            self._kept.popitem(last=False)

    async def resources(
        self, ctx: ServerRequestContext[Any, Any], params: types.PaginatedRequestParams | None
    ) -> types.ListResourcesResult:
        """What can be read, some at a time."""
        from mcp import types

        cursor = _cursor(params) or "0"
        if not cursor.isdecimal() or len(cursor) > 9:
            raise _no_cursor(cursor)
        found = await self._asked({"list": int(cursor)}, ctx)
        return types.ListResourcesResult(
            resources=[
                types.Resource(uri=one["uri"], name=one["name"], description=one["says"], mime_type=one["media"])
                for one in found["resources"]
            ],
            next_cursor=None if found["next"] is None else str(found["next"]),
        )

    async def templates(
        self, _ctx: ServerRequestContext[Any, Any], params: types.PaginatedRequestParams | None
    ) -> types.ListResourceTemplatesResult:
        """What can be read by an address that is made up."""
        from mcp import types

        _whole(params)
        return types.ListResourceTemplatesResult(
            resource_templates=[
                types.ResourceTemplate(
                    uri_template=f"{SCHEME}://{name}{kind.behind}",
                    name=name,
                    description=kind.says,
                    mime_type=kind.media,
                )
                for name, kind in KINDS.items()
                if kind.behind
            ]
        )

    async def read(
        self, ctx: ServerRequestContext[Any, Any], params: types.ReadResourceRequestParams
    ) -> types.ReadResourceResult:
        """What stands at an address."""
        from mcp import types

        found = await self._asked({"resource": str(params.uri)}, ctx)
        uri, media = params.uri, found["media"]
        if found["picture"]:
            content = types.BlobResourceContents(uri=uri, mime_type=media, blob=found["picture"])
        else:
            content = types.TextResourceContents(uri=uri, mime_type=media, text=found["text"])
        return types.ReadResourceResult(contents=[content])

    async def _asked(self, question: Mapping[str, Any], ctx: ServerRequestContext[Any, Any]) -> dict[str, Any]:
        answer = await self.worker.ask(question, ctx)
        if "error" in answer:
            raise _failed(answer, question.get("resource", ""), ctx.protocol_version)
        return answer


def agent_server(folder: Path, reading: Mapping[str, Any] | None = None) -> Server[Any]:
    """The server of a folder, for any transport.

    Raises:
        MissingExtra: The package of the protocol is not installed.
        SettingsError: There is no such folder.
    """
    require_mcp()
    import anyio.to_thread
    from mcp.server.lowlevel import Server

    agents = Agents(folder, reading or {})

    @asynccontextmanager
    async def lifespan(_: Server[Any]) -> AsyncGenerator[dict[str, Any]]:
        try:
            yield {}
        finally:
            with anyio.CancelScope(shield=True):
                await anyio.to_thread.run_sync(agents.worker.close)

    server = Server(
        "chatscene",
        version=version("chatscene"),
        title="chatscene",
        description="Driving scenes: made, driven, and judged against what was said.",
        instructions=INSTRUCTIONS,
        lifespan=lifespan,
        on_list_tools=agents.tools,
        on_call_tool=agents.call,
        on_list_resources=agents.resources,
        on_list_resource_templates=agents.templates,
        on_read_resource=agents.read,
    )
    server.middleware[:] = [_clearly]  # and without the package's own, which traces each call
    return server


async def _clearly(ctx: ServerRequestContext[Any, Any], call_next: CallNext) -> HandlerResult:
    """Say what is wrong with a request that the package refuses."""
    from mcp.shared.exceptions import MCPError
    from mcp_types import INVALID_PARAMS, METHOD_NOT_FOUND
    from pydantic import ValidationError

    try:
        return await call_next(ctx)
    except ValidationError as error:
        faults = [f"{'.'.join(map(str, one['loc']))[:60]}: {one['msg']}" for one in error.errors(include_url=False)[:5]]
        raise MCPError(INVALID_PARAMS, _bounded(f"{ctx.method[:60]}: {'; '.join(dict.fromkeys(faults))}")) from None
    except MCPError as error:
        if error.code == METHOD_NOT_FOUND:
            told = f"there is no method {ctx.method[:60]!r}; there are tools/list, tools/call, resources/list, "
            raise MCPError(METHOD_NOT_FOUND, f"{told}resources/templates/list and resources/read") from None
        if error.message == "Invalid request parameters":
            raise MCPError(INVALID_PARAMS, f"{ctx.method[:60]} came before initialize; say that first") from None
        raise


def in_parts(text: str, most: int = MOST_TEXT) -> list[str]:
    """A text in parts of bounded size, each cut at the end of a line where there is one."""
    parts = list[str]()
    while len(text) > most:
        cut = text.rfind("\n", 1, most) + 1 or most
        parts.append(text[:cut].rstrip("\n"))
        text = text[cut:]
    return [*parts, text]


def _listed(tool: Tool) -> types.Tool:
    from mcp import types

    schema = tool.schema
    schema["properties"] = {**schema["properties"], "part": PART}
    hints = types.ToolAnnotations(
        read_only_hint=not tool.writes, destructive_hint=False, idempotent_hint=not tool.writes, open_world_hint=False
    )
    return types.Tool(name=tool.name, description=tool.says, input_schema=schema, annotations=hints)


def _said(text: str, *, picture: str = "", error: bool = False) -> types.CallToolResult:
    from mcp import types

    content: list[Any] = [types.TextContent(text=_bounded(text) if error else text)]
    if picture:
        content.append(types.ImageContent(data=picture, mime_type="image/png"))
    return types.CallToolResult(content=content, is_error=error)


def _cursor(params: types.PaginatedRequestParams | None) -> str:
    """Where a list is to go on; empty for its beginning."""
    return (params.cursor if params is not None else None) or ""


def _whole(params: types.PaginatedRequestParams | None) -> None:
    """Hold a request to a list that comes whole to beginning at its beginning."""
    if cursor := _cursor(params):
        raise _no_cursor(cursor)


def _no_cursor(cursor: str) -> Exception:
    return _refused(f"{short(cursor)} is not a cursor;  begin without one")


def _failed(answer: Mapping[str, Any], uri: str, protocol: str) -> Exception:
    """Why nothing is listed or read: nothing stands at the address, as each protocol says by its code; or a fault."""
    from mcp.shared.exceptions import MCPError
    from mcp_types import INTERNAL_ERROR, INVALID_PARAMS
    from mcp_types.version import HANDSHAKE_PROTOCOL_VERSIONS

    told = _bounded(answer["error"])
    if not answer.get("absent"):
        return MCPError(INTERNAL_ERROR, told)
    code = NOT_FOUND if protocol in HANDSHAKE_PROTOCOL_VERSIONS else INVALID_PARAMS
    return MCPError(code, told, {"uri": uri} if len(uri) <= MOST_ERROR else None)


def _refused(message: str) -> Exception:
    from mcp.shared.exceptions import MCPError
    from mcp_types import INVALID_PARAMS

    return MCPError(INVALID_PARAMS, _bounded(message))


def _bounded(message: str) -> str:
    return message if len(message) <= MOST_ERROR else f"{message[:MOST_ERROR]}…"
