"""A server on the loopback address that answers chat requests as told, mostly wrongly."""

from __future__ import annotations

import json
import threading
import time
from collections.abc import Callable, Generator
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import Any

JSON = "application/json"


class _Handler(BaseHTTPRequestHandler):
    protocol_version = "HTTP/1.1"

    def do_POST(self) -> None:
        server = self.server
        assert isinstance(server, _Server)
        body = json.loads(self.rfile.read(int(self.headers["Content-Length"])))
        faults = server.faults
        headers = {name.lower(): value for name, value in self.headers.items()}
        faults.requests.append(Request(path=self.path, headers=headers, body=body))
        answer = faults.answers[min(len(faults.requests), len(faults.answers)) - 1]
        with suppress(ConnectionError):
            answer(self)

    def log_message(self, format: str, *args: Any) -> None:  # noqa: A002 - the name is given
        """Nothing: a test that passes is silent."""


class _Server(ThreadingHTTPServer):
    daemon_threads = True
    faults: Faults


Answering = Callable[[BaseHTTPRequestHandler], None]


@dataclass(frozen=True)
class Request:
    path: str
    headers: dict[str, str]
    body: dict[str, Any]


@dataclass
class Faults:
    """What the server says, one after the other, the last one for ever; and what it was asked."""

    url: str = ""
    answers: list[Answering] = field(default_factory=lambda: [chat("{}")])
    requests: list[Request] = field(default_factory=list[Request])


@contextmanager
def fault_server() -> Generator[Faults]:
    server = _Server(("127.0.0.1", 0), _Handler)
    server.faults = faults = Faults(url=f"http://127.0.0.1:{server.server_address[1]}/v1")
    thread = threading.Thread(target=server.serve_forever, kwargs={"poll_interval": 0.01}, daemon=True)
    thread.start()
    try:
        yield faults
    finally:
        server.shutdown()
        server.server_close()
        thread.join()


def send(status: int, body: bytes, content_type: str = JSON, **headers: str) -> Answering:
    """A whole reply."""

    def answer(handler: BaseHTTPRequestHandler) -> None:
        handler.send_response(status)
        handler.send_header("Content-Type", content_type)
        handler.send_header("Content-Length", str(len(body)))
        for name, value in headers.items():
            handler.send_header(name.replace("_", "-"), value)
        handler.end_headers()
        handler.wfile.write(body)

    return answer


def envelope(content: str | None, *, ending: str = "stop", usage: bool = True, **message: str) -> bytes:
    """A chat completion."""
    choice = {"index": 0, "finish_reason": ending, "message": {"role": "assistant", "content": content} | message}
    whole: dict[str, Any] = {"id": "x", "object": "chat.completion", "created": 0, "model": "m", "choices": [choice]}
    return json.dumps(whole | ({"usage": {"prompt_tokens": 100, "completion_tokens": 10}} if usage else {})).encode()


def chat(content: str | None, **rest: Any) -> Answering:
    """A chat completion, sent as it should be."""
    return send(200, envelope(content, **rest))


def refuse(status: int, message: str, **headers: str) -> Answering:
    """An error as OpenAI and its likes send it."""
    return send(status, json.dumps({"error": {"message": message, "type": "test"}}).encode(), **headers)


def cut_off(body: bytes, at: int) -> Answering:
    """The beginning of a reply; then the connection is closed."""

    def answer(handler: BaseHTTPRequestHandler) -> None:
        handler.send_response(200)
        handler.send_header("Content-Type", JSON)
        handler.send_header("Content-Length", str(len(body)))
        handler.end_headers()
        handler.wfile.write(body[:at])
        handler.close_connection = True

    return answer


def hang_up(handler: BaseHTTPRequestHandler) -> None:
    """Close the connection without a word."""
    handler.close_connection = True


def drip(at_once: bytes, slowly: bytes, seconds: float = 20.0) -> Answering:
    """Some bytes, then one at a time, so that no pause between two is long but the whole is."""

    def answer(handler: BaseHTTPRequestHandler) -> None:
        handler.close_connection = True
        handler.wfile.write(at_once)
        until = time.monotonic() + seconds
        for byte in slowly:
            handler.wfile.write(bytes([byte]))
            time.sleep(0.05)
            if time.monotonic() > until:
                break

    return answer


def say_nothing(handler: BaseHTTPRequestHandler) -> None:
    """Take the question and keep the connection, for longer than a test waits."""
    time.sleep(12)
    handler.close_connection = True
