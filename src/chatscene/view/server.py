"""The server of the page: loopback alone, for whoever has its address, and for no page of anybody else.

A request must name this server as its host, which a name of somebody else's that leads here does not, and begin with
a secret that only the printed address has. What changes anything must come from the page itself, by its origin. Reports
of runs may be anybody's, so they are under a secret of their own and in a sandbox, from which nothing here is reached.
"""

from __future__ import annotations

import base64
import json
import re
import secrets
import socket
import sys
import time
from collections.abc import Callable, Generator, Mapping
from contextlib import contextmanager, suppress
from http import HTTPStatus
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from importlib.resources import files
from pathlib import Path
from threading import Lock, RLock
from typing import Any
from urllib.parse import parse_qs, unquote, urlsplit

from chatscene.errors import RunError, SettingsError
from chatscene.interpret.stated import FACTS, in_text
from chatscene.view.below import page_below
from chatscene.view.child import Child, Ended
from chatscene.view.conversation import Busy, Conversation

LOOPBACK = "127.0.0.1"
MOST = 64 * 1024  # bytes of what is said; a text that is read has less
CONNECTIONS = 32  # at a time; a browser has six
_WHOLE = 60.0  # [s] for a request, and between two
_QUERIES = {"talk": ("since",), "compare": ("first", "second"), "still": ("run",)}  # what paths ask for
_LONGEST = 8192  # characters of a value
_KINDS = {"html": "text/html", "css": "text/css", "js": "text/javascript", "json": "application/json"}
_ASSETS = {"": ("chatscene.view", "page/view.html"), "viewer.css": ("chatscene.report", "viewer.css")} | {
    name: ("chatscene.view", f"page/{name}")
    for name in ("view.css", "view.js", "page.js", "runs.js", "talk.js", "compare.js")
}
_OF_THE_PAGE = (
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data:; connect-src 'self'; "
    "frame-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'; "
    "require-trusted-types-for 'script'; trusted-types 'none'"
)
_OF_A_REPORT = (
    "sandbox allow-scripts allow-downloads; default-src 'none'; script-src 'unsafe-inline'; "
    "style-src 'unsafe-inline'; img-src data:; base-uri 'none'; form-action 'none'; frame-ancestors 'self'"
)


class Refused(Exception):  # noqa: N818 - reads as what it says
    """A request is refused."""

    def __init__(self, status: HTTPStatus, message: str) -> None:
        super().__init__(message)
        self.status = status


class Server(ThreadingHTTPServer):
    """Serves the page until it is closed.

    Args:
        folder: Whose runs it shows, and where new ones go.
        port: Of loopback; 0 for a free one.
        reading: How sentences are read: options of `chatscene.explain`.
        search: How a run is searched: options of `chatscene.run`.

    Raises:
        SettingsError: The port is taken.
    """

    daemon_threads = True
    request_queue_size = 128  # connections that wait to be let in; of more, each costs a browser a second at least

    def __init__(self, folder: Path, port: int, reading: Mapping[str, Any], search: Mapping[str, Any]) -> None:
        self.folder, self.search = folder, search
        self.secret, self.of_reports = secrets.token_urlsafe(18), secrets.token_urlsafe(18)
        self.conversation = Conversation(folder, reading, search)
        self._looking, self._turn = Child(lambda: {"folder": str(folder)}), Lock()
        self._waiting: dict[socket.socket, float] = {}  # since when nothing was asked [s], of those not answered now
        self._answered: set[socket.socket] = set()
        self._counting = RLock()
        try:
            super().__init__((LOOPBACK, port), _Handler)
        except OSError as error:
            message = f"port {port} of {LOOPBACK} cannot be had ({error.strerror}); say another --port"
            raise SettingsError(message) from error

    @property
    def address(self) -> str:
        """Where the page is."""
        return f"http://{LOOPBACK}:{self.server_port}/{self.secret}/"

    def look(self, what: str, *runs: str) -> dict[str, Any]:
        """What `chatscene.view.looking` tells of runs.

        Raises:
            Refused: It has nothing to tell.
        """
        try:
            with self._turn:
                self._looking.start()
                found = self._looking.ask({"look": what, "runs": runs})
        except Ended as error:
            raise Refused(HTTPStatus.INTERNAL_SERVER_ERROR, str(error)) from error
        if "error" in found:
            raise Refused(HTTPStatus.NOT_FOUND, found["error"])
        return found

    def process_request(self, request: Any, client_address: Any) -> None:
        """Begin to serve a connection; if there are too many, the one ends that has asked for nothing for longest."""
        with self._counting:
            full = len(self._waiting) + len(self._answered) >= CONNECTIONS
            if full and not self._waiting:
                self.shutdown_request(request)
                return
            if full:
                self._end(min(self._waiting, key=lambda connection: self._waiting[connection]))
            self._waiting[request] = time.monotonic()
        super().process_request(request, client_address)

    def service_actions(self) -> None:
        """End who takes too long to ask; called all the time."""
        with self._counting:
            for connection, since in list(self._waiting.items()):
                if time.monotonic() - since > _WHOLE:
                    self._end(connection)

    def _end(self, connection: socket.socket) -> None:
        del self._waiting[connection]
        with suppress(OSError):  # it has gone by itself
            connection.shutdown(socket.SHUT_RDWR)  # its thread finds that, and ends

    @contextmanager
    def answering(self, connection: socket.socket) -> Generator[None]:
        """While somebody is answered, who was let in."""
        with self._counting:
            self._waiting.pop(connection, None)
            self._answered.add(connection)
        try:
            yield
        finally:
            with self._counting:
                self._answered.discard(connection)
                self._waiting[connection] = time.monotonic()

    def shutdown_request(self, request: Any) -> None:
        """End a connection."""
        with self._counting:
            self._waiting.pop(request, None)
            self._answered.discard(request)
        super().shutdown_request(request)

    def handle_error(self, request: Any, client_address: Any) -> None:
        """Tell of what went wrong with a request, unless whoever asked has only gone away."""
        if not isinstance(sys.exception(), ConnectionError):
            super().handle_error(request, client_address)

    def server_close(self) -> None:
        """Close it, and end what it works on."""
        super().server_close()
        self.conversation.close()
        self._looking.end()
        with self._turn:
            self._looking.close()


class _Handler(BaseHTTPRequestHandler):
    server: Server  # pyright: ignore[reportIncompatibleVariableOverride] - which it is
    server_version, sys_version = "chatscene", ""
    protocol_version = "HTTP/1.1"
    timeout = 30  # [s] for whoever connects and says nothing

    def do_GET(self) -> None:
        self._serve(self._shown)

    def do_POST(self) -> None:
        self._serve(self._done)

    def _serve(self, answer: Callable[[str, Mapping[str, str]], None]) -> None:
        try:
            self._require_ours()
            try:
                split = urlsplit(self.path)
            except ValueError as error:
                raise Refused(HTTPStatus.BAD_REQUEST, f"this is not an address: {error}") from error
            secret, _, path = split.path.removeprefix("/").partition("/")
            if _same(secret, self.server.of_reports):
                self._report(unquote(path))
            else:
                self._require_secret(secret)
                path = unquote(path)
                answer(path, _queried(path, split.query))
        except Refused as refused:
            self.close_connection = True  # what it has sent besides was not read
            self._send(json.dumps({"error": str(refused)}).encode(), "json", status=refused.status)

    def _require_ours(self) -> None:
        """Refuse what a page of somebody else's may have a browser ask."""
        names = {f"{name}:{self.server.server_port}" for name in (LOOPBACK, "localhost")}
        host, origin = self.headers.get("Host", ""), self.headers.get("Origin")
        if host not in names:
            raise Refused(HTTPStatus.FORBIDDEN, f"the request names another host than this server, {LOOPBACK}")
        if origin != f"http://{host}" and (origin is not None or self.command != "GET"):
            raise Refused(HTTPStatus.FORBIDDEN, "only the page itself may ask for that")

    def _require_secret(self, told: str) -> None:
        if not _same(told, self.server.secret):
            raise Refused(HTTPStatus.FORBIDDEN, "take the address that chatscene view printed, whole")

    def _shown(self, path: str, asked: Mapping[str, str]) -> None:
        with self.server.answering(self.connection):
            self._show(path, asked)

    def _show(self, path: str, asked: Mapping[str, str]) -> None:
        server = self.server
        match path:
            case "about":
                facts = {name: [in_text({"": value})[1:] for value in values] for name, values in FACTS.items()}
                about = {"folder": str(server.folder), "reports": server.of_reports, "facts": facts}
                self._say({**about, **server.search})
            case "runs":
                self._say(server.look("list"))
            case "compare":
                self._say(server.look("compare", asked.get("first", ""), asked.get("second", "")))
            case "still":
                self._send(base64.b64decode(server.look("still", asked.get("run", ""))["webp"]), "webp")
            case "talk":
                since = asked.get("since", "0")
                if not re.fullmatch("[0-9]{1,9}", since):
                    raise Refused(HTTPStatus.BAD_REQUEST, "say since how many turns, as a number")
                self._say(server.conversation.state(int(since)))
            case _ if path in _ASSETS:
                package, name = _ASSETS[path]
                self._send(files(package).joinpath(name).read_bytes(), name.rpartition(".")[2])
            case _:
                raise Refused(HTTPStatus.NOT_FOUND, "there is no such page")

    def _done(self, path: str, _asked: Mapping[str, str]) -> None:
        said = self._said()
        with self.server.answering(self.connection):
            self._do(path, said)

    def _do(self, path: str, said: Mapping[str, Any]) -> None:
        match path:
            case "say":
                line = said.get("line")
                if not isinstance(line, str) or not line.strip():
                    raise Refused(HTTPStatus.BAD_REQUEST, "say a line")
                try:
                    self.server.conversation.say(line)
                except Busy as busy:
                    raise Refused(HTTPStatus.CONFLICT, str(busy)) from busy
                self._say({})
            case "cancel":
                self._say({"cancelled": self.server.conversation.cancel()})
            case _:
                raise Refused(HTTPStatus.NOT_FOUND, "there is no such page")

    def _said(self) -> dict[str, Any]:
        """What was sent: an object in JSON, of a size that a text may have."""
        length = self.headers.get("Content-Length", "")
        if not length.isdecimal():
            raise Refused(HTTPStatus.LENGTH_REQUIRED, "say how long it is")
        if len(length) > len(str(MOST)) or int(length) > MOST:
            raise Refused(HTTPStatus.REQUEST_ENTITY_TOO_LARGE, f"what is said may have {MOST // 1024} kB")
        if self.headers.get("Content-Type") != "application/json":
            raise Refused(HTTPStatus.UNSUPPORTED_MEDIA_TYPE, "say it in JSON")
        try:
            said = json.loads(self.rfile.read(int(length)))
        except (ValueError, RecursionError) as error:
            raise Refused(HTTPStatus.BAD_REQUEST, "this is not JSON") from error
        if not isinstance(said, dict):
            raise Refused(HTTPStatus.BAD_REQUEST, "say an object")
        return said

    def _report(self, path: str) -> None:
        """A page of a run, or of several, as it is."""
        try:
            page = page_below(self.server.folder, path)
        except RunError as error:
            raise Refused(HTTPStatus.NOT_FOUND, str(error)) from error
        with self.server.answering(self.connection):
            self._send(page.read_bytes(), "html", policy=_OF_A_REPORT)

    def _say(self, content: Mapping[str, Any]) -> None:
        self._send(json.dumps(content).encode(), "json")

    def _send(
        self, content: bytes, kind: str, *, status: HTTPStatus = HTTPStatus.OK, policy: str = _OF_THE_PAGE
    ) -> None:
        self.send_response(status)
        self.send_header("Content-Type", f"{_KINDS[kind]}; charset=utf-8" if kind in _KINDS else f"image/{kind}")
        self.send_header("Content-Length", str(len(content)))
        self.send_header("Content-Security-Policy", policy)
        self.send_header("X-Content-Type-Options", "nosniff")
        self.send_header("Referrer-Policy", "no-referrer")
        self.send_header("Cross-Origin-Opener-Policy", "same-origin")
        self.send_header("Cross-Origin-Resource-Policy", "same-origin")
        self.send_header("Cache-Control", "no-store")
        if self.close_connection:
            self.send_header("Connection", "close")
        self.end_headers()
        self.wfile.write(content)

    def log_message(self, format: str, *args: object) -> None:  # noqa: A002 - its name there
        """Say nothing: the terminal is for what goes wrong in the work."""


def _queried(path: str, query: str) -> dict[str, str]:
    """What a path is asked for, by name."""
    try:
        asked = parse_qs(query, keep_blank_values=True, max_num_fields=len(_QUERIES))
    except ValueError as error:
        raise Refused(HTTPStatus.BAD_REQUEST, "this asks for too much") from error
    for name, values in asked.items():
        if name not in _QUERIES.get(path, ()) or len(values) > 1 or len(values[0]) > _LONGEST:
            raise Refused(HTTPStatus.BAD_REQUEST, f"{name[:100]!r} cannot be asked so")
    return {name: value for name, (value,) in asked.items()}


def _same(one: str, other: str) -> bool:
    return secrets.compare_digest(one.encode(), other.encode())
