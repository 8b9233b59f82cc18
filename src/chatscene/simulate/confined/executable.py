"""Somebody else's program, not written in Scenic, behind the walls of the kernel: a file in, text out."""

from __future__ import annotations

import json
import os
import selectors
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path

from chatscene.errors import SandboxError
from chatscene.simulate.confined.child import CHUNK
from chatscene.simulate.confined.confinement import KERNEL, Limits, check_layers
from chatscene.simulate.confined.nursery import ENVIRONMENT
from chatscene.simulate.confined.wire import words

_BECOMING = "chatscene.simulate.confined.becoming"
GIVEN = "/proc/self/fd/0"
"""The name under which a program finds the file that it is given, whatever that file is called."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Executable:
    """A program that can be run behind the walls.

    Attributes:
        command: Its file, and arguments that it always has.
        readable: Files and folders that it reads, beside the libraries of the system.
        environment: All that it finds in its environment.
    """

    command: tuple[str, ...]
    readable: tuple[str, ...]
    environment: Mapping[str, str]


@dataclass(frozen=True, slots=True, kw_only=True)
class Ended:
    """What became of a program.

    Attributes:
        fault: Why it did not end as it should, in words; empty if it did.
        said: The lines that it said besides, on standard error.
    """

    fault: str
    output: bytes
    said: tuple[str, ...]


def run_confined(program: Executable, arguments: Sequence[str], given: Path, limits: Limits) -> Ended:
    """Run a program to its end, or to that of its limits, in a process that can read, compute and write to a pipe.

    It makes no process, thread or socket, writes no file, and sees no file but its own and the one that it is given.

    Args:
        program: What is run.
        arguments: For this run; `GIVEN` stands for the file.
        given: A file that it may read.
        limits: Time in all (`processor`, `wall`) [s], memory [MB], and how much it may write (`message`) [bytes].

    Raises:
        SandboxError: It cannot be confined here.
    """
    if sys.platform != "linux":
        raise SandboxError(
            "programs by strangers are confined by the Linux kernel, which this system does not have; "
            "run chatscene in a Linux container or virtual machine"
        )
    asked = {
        "command": [*program.command, *arguments],
        "readable": [*program.readable, str(given.resolve())],
        "environment": dict(program.environment),
        "limits": asdict(limits),
    }
    hears, tells = socket.socketpair()
    with hears:
        with tells, given.open("rb") as stream:
            process = subprocess.Popen(
                [sys.executable, "-I", "-m", _BECOMING, str(tells.fileno()), json.dumps(asked)],
                stdin=stream,
                stdout=subprocess.PIPE,
                stderr=subprocess.PIPE,
                cwd="/",
                env=ENVIRONMENT,
                pass_fds=(tells.fileno(),),
            )
        with process:
            try:
                output, said, fault = _listen(process, limits)
            finally:
                process.kill()
        layers = hears.recv(CHUNK).decode().split()
    if not layers:
        raise SandboxError(f"the process that confines programs does not answer: {said[-1:] or 'it said nothing'}")
    check_layers(layers, KERNEL)
    return Ended(fault=fault or _fault(process.returncode, limits), output=output, said=said)


def _listen(process: subprocess.Popen[bytes], limits: Limits) -> tuple[bytes, tuple[str, ...], str]:
    """What a process writes and says until it ends, and why that was not waited for."""
    assert process.stdout is not None
    assert process.stderr is not None
    output, said = bytearray(), bytearray()
    deadline, fault = time.monotonic() + limits.wall, ""
    with selectors.DefaultSelector() as open_ends:
        open_ends.register(process.stdout, selectors.EVENT_READ, output)
        open_ends.register(process.stderr, selectors.EVENT_READ, said)
        while open_ends.get_map() and not fault:
            for key, _ in open_ends.select(max(0.0, deadline - time.monotonic())):
                more = os.read(key.fd, CHUNK)
                key.data.extend(more)
                if not more:
                    open_ends.unregister(key.fileobj)
            if len(output) + len(said) > limits.message:
                fault = f"it wrote more than {limits.message / 2**20:.0f} MB"
            elif time.monotonic() >= deadline:
                fault = f"it had not ended after {limits.wall:g} s"
    if not fault:
        process.wait()  # who closes both ends and computes on has its processor time
    return bytes(output), tuple(filter(None, map(words, said.decode("utf-8", "replace").splitlines()))), fault


def _fault(status: int, limits: Limits) -> str:
    if status >= 0:
        return f"it gave up (exit status {status})" if status else ""
    if status in (-signal.SIGXCPU, -signal.SIGKILL):
        return f"it used up its processor time ({limits.processor} s)"
    return f"it crashed ({signal.Signals(-status).name})"
