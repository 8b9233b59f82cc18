"""A process of its own for work: whatever it does, whoever asked goes on, and can end it at any time.

It answers questions, one at a time, as lines of JSON through its pipes, and ends with whoever asked. What it does is in
a module such as `chatscene.view.working`, which is all that it loads.
"""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
from collections.abc import Callable, Mapping
from contextlib import suppress
from typing import Any

Answer = dict[str, Any]


class Ended(Exception):  # noqa: N818 - reads as what it says
    """The process ended before it answered; the message says how."""


class Child:
    """A process that can be started again after it ended; one at a time asks it.

    Args:
        setup: What each is told first, in words of JSON: `chatscene.view.working.serve` reads it.
        module: What it does: a module that serves when it is run.
    """

    def __init__(self, setup: Callable[[], Mapping[str, Any]], module: str = "chatscene.view.working") -> None:
        self._setup, self._module = setup, module
        self._process: subprocess.Popen[bytes] | None = None

    def start(self) -> None:
        """Have it there, if it is not."""
        if self._process is not None:
            if self._process.poll() is None:
                return
            self.close()
        # -P: the working folder is no place of modules; a session of its own: it ends with all that it started
        command = [sys.executable, "-P", "-m", self._module]
        pipe = subprocess.PIPE
        self._process = process = subprocess.Popen(command, stdin=pipe, stdout=pipe, start_new_session=True)
        with suppress(BrokenPipeError):  # it was ended already, which is told when it is asked
            _write(process, self._setup())

    def ask(self, question: Mapping[str, Any], told: Callable[[Answer], None] = lambda _: None) -> Answer:
        """Its answer to a question.

        Raises:
            Ended: It ended first.
        """
        process = self._process
        assert process, "it is started first"
        try:
            _write(process, question)
            while line := _read(process):
                if "answer" in line:
                    return line["answer"]
                told(line)
        except (BrokenPipeError, ValueError):  # it went while it was written to, or in the middle of a line
            pass
        raise Ended(_how(process))

    def end(self) -> None:
        """End it, and whatever it started, at once."""
        process = self._process  # which another thread may let go of meanwhile
        if process is not None and process.poll() is None:
            os.killpg(process.pid, signal.SIGKILL)
            process.wait()

    def close(self) -> None:
        """End it, and let go of it; nobody may be asking it."""
        self.end()
        for pipe in (self._process.stdin, self._process.stdout) if self._process is not None else ():
            if pipe:
                with suppress(BrokenPipeError):  # of what it was told last and did not hear
                    pipe.close()
        self._process = None


def _write(process: subprocess.Popen[bytes], content: Mapping[str, Any]) -> None:
    assert process.stdin
    process.stdin.write(json.dumps(content).encode() + b"\n")
    process.stdin.flush()


def _read(process: subprocess.Popen[bytes]) -> Answer | None:
    assert process.stdout
    line = process.stdout.readline()
    return json.loads(line) if line else None


def _how(process: subprocess.Popen[bytes]) -> str:
    """How a process ended, in words."""
    code = process.wait()
    if code >= 0:
        return f"the process that worked on it ended with status {code}; its last words are in the terminal"
    name = signal.Signals(-code).name if -code in set(signal.Signals) else f"signal {-code}"
    return f"the process that worked on it was ended by {name}" + (", perhaps for want of memory" * (name == "SIGKILL"))
