"""The parent's side of the second wall: starts confined processes, asks them, and ends them in time."""

from __future__ import annotations

import json
import os
import select
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import time
import weakref
from collections import deque
from contextlib import suppress
from dataclasses import asdict
from functools import lru_cache
from pathlib import Path
from typing import Any

from platformdirs import user_cache_path

from chatscene import errors
from chatscene.errors import ChatSceneError, DoesNotCompile, MapError, ProgramStopped, SandboxError, StuckBehavior
from chatscene.maps.network import map_digest
from chatscene.settings import SimulationSettings
from chatscene.simulate.confined.child import CHUNK, WATCHMAN
from chatscene.simulate.confined.confinement import LAYERS, Limits, check_layers
from chatscene.simulate.confined.plain_text import TRUST
from chatscene.simulate.confined.wire import Message, decode, encode, nonsense, program_to_json, words
from chatscene.simulate.watchdog import computes_for_ever, waits_for_ever
from chatscene.terms.pointing import SourcePlace, pointed
from chatscene.terms.scene import ScenicProgram

LAST_MOMENT = 1.0  # [s] of processor time for a process that has closed its end to die by itself
SHARED = 2  # nurseries that are kept for the next who asks
ENVIRONMENT = {"LC_ALL": "C.UTF-8", "PYTHONHASHSEED": "0"}

_PASSED_ON = {
    name: kind
    for name in (
        "DoesNotCompile",
        "EgoError",
        "MapError",
        "ProgramError",
        "SettingsError",
        "SimulationError",
        "StuckBehavior",
    )
    if isinstance(kind := getattr(errors, name), type) and issubclass(kind, ChatSceneError)
}


def shared_nursery(map_path: Path, settings: SimulationSettings, limits: Limits) -> Nursery:
    """The nursery of this process for a map as it is now, settings and limits: starting one takes seconds.

    Nobody closes it; it goes with the process, or once others were asked for and nobody uses it.
    """
    try:
        content = map_digest(map_path)
    except MapError:  # told by the process that reads it
        content = ""
    return _nursery(map_path, settings, limits, content, os.getpid())


@lru_cache(maxsize=SHARED)
def _nursery(map_path: Path, settings: SimulationSettings, limits: Limits, _content: str, _process: int) -> Nursery:
    return Nursery(map_path, settings, limits)


class Nursery:
    """Makes a confined process for each program it is given; threads may share it.

    One process imports Scenic and reads the map, once; each program gets a fork of it that has seen no other program.
    """

    def __init__(self, map_path: Path, settings: SimulationSettings, limits: Limits | None = None) -> None:
        self.limits = limits or Limits()
        self._map_path = map_path
        self._settings = settings
        self._warm: _Warm | None = None
        self._starting = threading.Lock()

    def __enter__(self) -> Nursery:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def layers(self) -> tuple[str, ...]:
        """The layers of the second wall that this machine has.

        Raises:
            SandboxError: Too few to run anything of a stranger's.
        """
        empty = ScenicProgram(scenario_id="nothing", source="", parameters=(), snippet_ids=())
        confined = self.confine(empty)
        confined.close()
        return confined.layers

    def confine(self, program: ScenicProgram) -> Confined:
        """A confined process that holds a program, not compiled yet.

        Raises:
            SandboxError: There can be none on this machine.
        """
        warm = self._started()
        with suppress(IndexError):  # until there is none
            while True:
                warm.end(warm.dropped.popleft())
        ours, theirs = socket.socketpair()
        with theirs:
            try:
                pid = warm.ask(b"fork", theirs.fileno())
            except BaseException:
                ours.close()
                raise
        confined = Confined(warm, self.limits, pid, ours)
        try:
            confined.greet(program)
        except BaseException:
            confined.close()
            raise
        return confined

    def close(self) -> None:
        """End all processes and delete their folder."""
        with self._starting:
            if self._warm is not None:
                self._warm.close()

    def _started(self) -> _Warm:
        with self._starting:
            if self._warm is None or not self._warm.alive:
                if sys.platform != "linux":
                    raise SandboxError(
                        "programs by strangers are confined by the Linux kernel, which this system does not have; "
                        "run chatscene in a Linux container or virtual machine"
                    )
                self._warm = warm = _Warm()
                try:
                    warm.set_up(self._map_path, self._settings, self.limits)
                except BaseException:
                    warm.close()
                    raise
            return self._warm


class _Warm:
    """The process that confined ones are forked from: our own code alone. It goes with this object.

    Attributes:
        dropped: Confined processes that nobody holds any more, by number; they are ended before another is forked.
    """

    def __init__(self) -> None:
        self._folder = Path(tempfile.mkdtemp(prefix="chatscene-"))
        self._control, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        here = str(self._folder)
        with theirs, (self._folder / "errors").open("wb") as log:
            process = subprocess.Popen(
                [sys.executable, "-I", "-m", "chatscene.simulate.confined.child", str(theirs.fileno())],
                stdin=subprocess.DEVNULL,
                stdout=subprocess.DEVNULL,
                stderr=log,
                cwd=here,
                env={**ENVIRONMENT, "HOME": here, "TMPDIR": here, "MPLCONFIGDIR": here},
                pass_fds=(theirs.fileno(),),
            )
        self.dropped: deque[int] = deque()
        self._one_at_a_time = threading.Lock()
        self._end = weakref.finalize(self, _end, os.getpid(), self._control, process, self._folder)

    @property
    def alive(self) -> bool:
        """Whether it has not been ended."""
        return self._end.alive

    def set_up(self, map_path: Path, settings: SimulationSettings, limits: Limits) -> None:
        """Say what is to be simulated, and wait until it is ready.

        Raises:
            MapError: The map is none.
            SandboxError: It does not start.
        """
        setup = {
            "map": str(map_path),
            "settings": asdict(settings),
            "limits": asdict(limits),
            "cache": str(user_cache_path()),
            "folder": str(self._folder),
        }
        with suppress(BrokenPipeError):  # it is no more, and has left its reason in the log
            self._control.send(json.dumps(setup).encode())
        said = json.loads(self._hear())
        if "error" in said:
            raise _PASSED_ON.get(said["error"], SandboxError)(said["message"])

    def ask(self, request: bytes, *handles: int) -> int:
        """The number that it answers to a request that comes with handles; without an answer it is ended.

        Raises:
            SandboxError: There is none.
        """
        with self._one_at_a_time:
            if not self.alive:  # ended while another thread had its turn
                raise SandboxError("the process that confines programs was ended")
            try:
                with suppress(ConnectionError):  # its reason is in the log
                    socket.send_fds(self._control, [request], handles)
                return int(self._hear())
            except BaseException:
                self.close()
                raise

    def end(self, pid: int) -> int:
        """End a confined process and its group.

        Returns:
            Its exit status; negative: the signal that ended it. 0 if the kernel has ended it with this one.
        """
        if not self.alive:
            return 0
        with suppress(ProcessLookupError):  # until it is asked for below, the number is nobody else's
            os.kill(pid, signal.SIGKILL)
        with suppress(ProcessLookupError, PermissionError):
            os.killpg(pid, signal.SIGKILL)
        try:
            return self.ask(b"%d" % pid)
        except SandboxError:
            return 0

    def _hear(self) -> bytes:
        with suppress(ConnectionError):
            if said := self._control.recv(CHUNK):
                return said
        log = self._folder / "errors"
        tail = words(log.read_text(encoding="utf-8", errors="replace")[-400:]) if log.exists() else ""
        raise SandboxError(f"the process that confines programs does not answer: {tail or 'it said nothing'}")

    def close(self) -> None:
        """End it, and with it all that was forked from it; may be called again."""
        self._end()


def _end(owner: int, control: socket.socket, process: subprocess.Popen[bytes], folder: Path) -> None:
    control.close()
    if os.getpid() != owner:  # a fork of who started it, which has it only to forget
        return
    process.kill()
    process.wait()
    shutil.rmtree(folder, ignore_errors=True)


class _Patience:
    """How much longer a process is waited for: until it has computed, or anybody has waited, for so long [s]."""

    def __init__(self, pid: int, processor: float, wall: float) -> None:
        self._pid = pid
        self._processor = processor
        self._wall = wall
        self._spent = _processor_time(pid)
        self._began = time.monotonic()

    def until_readable(self, handle: int) -> bool:
        """Whether there was something to read from a handle before patience came to its end."""
        while not select.select([handle], [], [], max(0.0, left := self._left()))[0]:
            if left <= 0.0:
                return False
        return True

    def at_an_end(self, what: str) -> StuckBehavior:
        """The error for a process that was waited for long enough."""
        spent = _processor_time(self._pid) - self._spent
        if spent >= self._processor:
            return computes_for_ever(what, self._processor)
        return waits_for_ever(what, self._wall, spent)

    def _left(self) -> float:
        """The least wall time [s] in which patience can come to its end."""
        computing = self._processor - (_processor_time(self._pid) - self._spent)
        return min(computing, self._began + self._wall - time.monotonic())


def _processor_time(pid: int) -> float:
    """What a process has computed so far [s], by the clock that Linux keeps for it."""
    return time.clock_gettime((~pid << 3) | 2)  # the number that clock_getcpuclockid(3) gives


class Confined:
    """One confined process, and the program in it; made by `Nursery.confine`.

    Attributes:
        layers: The layers of the second wall that are in force for it.
    """

    def __init__(self, warm: _Warm, limits: Limits, pid: int, channel: socket.socket) -> None:
        self._warm = warm
        self._limits = limits
        self.pid = pid
        self._channel = channel
        self._rest = bytearray()
        self._label = "the program"
        self._source = ""
        self._hint = ""
        self._open = True
        self.layers: tuple[str, ...] = ()

    def greet(self, program: ScenicProgram) -> None:
        """See which layers are in force, and hand the program over.

        Warns where one is missing that can be done without.

        Raises:
            SandboxError: The kernel does not confine it.
        """
        said = self._hear("confining itself").get("layers")
        self.layers = tuple(layer for layer in LAYERS if isinstance(said, list) and layer in said)
        check_layers(self.layers, LAYERS)
        self._label = program.called
        self._source = program.source
        self._hint = f". {TRUST}" if program.own else ""
        self.ask("load", program=program_to_json(program))

    @property
    def alive(self) -> bool:
        """Whether it can be asked."""
        return self._open

    def __del__(self) -> None:
        self._channel.close()
        if self._open:
            self._warm.dropped.append(self.pid)

    @property
    def spent(self) -> bool:
        """Whether it has used half of the processor time that its life has."""
        return self._open and _processor_time(self.pid) > self._limits.processor / 2

    def ask(self, do: str, **arguments: Any) -> Message:
        """Have something done.

        Raises:
            StuckBehavior: It took too long; the process is no more.
            SandboxError: It was stopped, ran out of memory, crashed, or answered nonsense; the process is no more.
            ChatSceneError: What the program came to.
        """
        if not self._open:
            raise ProgramStopped(f"{self._label} was stopped and cannot be asked again")
        try:
            self._say(encode({"do": do, **arguments}))
            answer = self._hear(do)
        except BaseException:  # an interrupted conversation cannot be taken up again
            self.close()
            raise
        if "error" in answer:
            raise self._error(answer)
        return answer

    def close(self) -> int:
        """End the process and its group.

        Returns:
            Its exit status; negative: the signal that ended it.
        """
        if not self._open:
            return 0
        self._open = False
        self._channel.close()
        return self._warm.end(self.pid)

    def _say(self, line: bytes) -> None:
        self._channel.settimeout(self._limits.wall)
        try:
            self._channel.sendall(line)
        except OSError as error:
            raise self._ended() from error

    def _hear(self, do: str) -> Message:
        patience = _Patience(self.pid, self._limits.answer, self._limits.wall)
        scanned = 0
        while (end := self._rest.find(b"\n", scanned)) < 0:
            scanned = len(self._rest)
            if scanned > self._limits.message:
                raise nonsense(f"more than {self._limits.message} bytes")
            if not patience.until_readable(self._channel.fileno()):
                raise patience.at_an_end(f"{self._label} ({do})")
            try:
                more = self._channel.recv(CHUNK)
            except OSError as error:
                raise self._ended() from error
            if not more:
                raise self._ended()
            self._rest += more
        line = bytes(self._rest[:end])
        del self._rest[: end + 1]
        message = decode(line)
        if "stopped" in message:
            tried = f"it tried what no scene needs: {words(message['stopped'])}"
            raise ProgramStopped(f"{self._label} was stopped: {tried}{self._hint}")
        return message

    def _ended(self) -> ProgramStopped:
        """The error for a process that is no more."""
        status = self._last_moment()
        causes = {
            WATCHMAN: "the watchman ended it",
            -signal.SIGXCPU: "it used up its processor time",
            -signal.SIGKILL: "it used up its processor time",
            -signal.SIGSYS: "it made a forbidden system call",
            -signal.SIGSEGV: "it crashed, perhaps by endless recursion",
        }
        return ProgramStopped(f"{self._label} was stopped: {causes.get(status, f'its process ended ({status})')}")

    def _last_moment(self) -> int:
        """Wait for a process that has closed its end to die by itself, so that its own cause is seen, but not long."""
        with suppress(OSError):
            handle = os.pidfd_open(self.pid)
            try:
                _Patience(self.pid, LAST_MOMENT, self._limits.wall).until_readable(handle)
            finally:
                os.close(handle)
        return self.close()

    def _error(self, answer: Message) -> ChatSceneError:
        kind, message = answer.get("error"), words(answer.get("message"))
        place = _place(answer.get("place"))
        if place is not None and (shown := pointed(self._source, place)):
            named = "" if f"line {place.line}" in message else f" (line {place.line})"
            message = f"{message}{named}\n{shown}"
        if kind == "MemoryError":
            return ProgramStopped(f"{self._label} was stopped: it used up its memory")
        if isinstance(kind, str) and kind in _PASSED_ON:
            return _PASSED_ON[kind](message)
        return DoesNotCompile(f"{self._label} fails: {words(kind)}: {message}")


def _place(sent: object) -> SourcePlace | None:
    """The place in a program that its process names."""
    match sent:
        case [int(line), int(column), int(width)]:
            return SourcePlace(line, column, width)
        case _:
            return None
