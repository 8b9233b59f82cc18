"""Run an enemy's program behind the second wall alone, and say what became of it."""

from __future__ import annotations

import json
import os
import socket
import threading
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

from chatscene.errors import ChatSceneError, SandboxError, StuckBehavior
from chatscene.simulate.confined.confinement import Limits
from chatscene.simulate.confined.nursery import Confined, Nursery
from chatscene.simulate.confined.wire import scene_to_json
from chatscene.terms.scene import Scene, ScenicProgram

LIMITS = Limits(answer=1.0, wall=10.0, processor=3, memory=256, message=200_000)
STEPS = 5
SECRET = "the-secret-9a1c"


@dataclass(frozen=True)
class Canaries:
    """What an enemy would touch."""

    folder: Path
    port: int
    callers: list[int]

    @property
    def secret(self) -> Path:
        return self.folder / "secret"

    @property
    def target(self) -> Path:
        return self.folder / "target"

    def fill(self, text: str) -> str:
        """A program with the places of the canaries in it."""
        places = {"secret": self.secret, "target": self.target, "port": self.port, "parent": os.getpid()}
        for name, value in places.items():
            text = text.replace(f"@{name}@", str(value))
        return text

    def untouched(self) -> bool:
        """Whether the secret is where it was, nothing was made beside it, and nobody called."""
        return (
            [p.name for p in self.folder.iterdir()] == ["secret"]
            and self.secret.read_text() == SECRET
            and not self.callers
        )


@dataclass
class Listener:
    """Counts who calls on a port of this machine."""

    callers: list[int] = field(default_factory=list[int])

    def __enter__(self) -> Listener:
        self._socket = socket.create_server(("127.0.0.1", 0))
        self.port: int = self._socket.getsockname()[1]
        self._thread = threading.Thread(target=self._listen, daemon=True)
        self._thread.start()
        return self

    def __exit__(self, *_: object) -> None:
        self._socket.shutdown(socket.SHUT_RDWR)
        self._socket.close()
        self._thread.join()

    def _listen(self) -> None:
        while True:
            try:
                caller, address = self._socket.accept()
            except OSError:
                return
            caller.close()
            self.callers.append(address[1])


@dataclass(frozen=True)
class Outcome:
    """What became of a program.

    Attributes:
        stopped_by: ``watchman``, ``kernel``, ``limits``, ``checked answers``, ``an error of its own``, ``its own end``
            or ``nobody``.
        said: Everything that came out of the confined process.
    """

    stopped_by: str
    said: str


def attempt(nursery: Nursery, source: str, limits: Limits = LIMITS) -> Outcome:
    """Do with a program everything that is ever done with one; the allow-list is not asked.

    Args:
        nursery: Where to run it.
        source: The program.
        limits: What it may use up.
    """
    nursery.limits = limits
    program = ScenicProgram(scenario_id="x", source=source, parameters=(), snippet_ids=())
    said: list[str] = []
    confined = nursery.confine(program)
    try:
        _everything(confined, lambda answer: said.append(json.dumps(answer)))
        stopped_by = "nobody"
    except StuckBehavior as error:
        said.append(str(error))
        stopped_by = "limits"
    except ChatSceneError as error:
        said.append(str(error))
        stopped_by = _layer(error)
    finally:
        confined.close()
    return Outcome(stopped_by=stopped_by, said="\n".join(said))


def _everything(confined: Confined, note: Callable[[object], None]) -> None:
    scene = Scene(id="x", scenario_id="x", route=0, block=0, seed=0, values={})
    note(confined.ask("routes"))
    note(confined.ask("route", index=0))
    note(confined.ask("open", scene=scene_to_json(scene), observation="actors", pedals="safebench", through=True))
    for _ in range(STEPS):
        note(confined.ask("step", action=[0.5, 0.0]))
    note(confined.ask("episode"))


_KERNEL = ("Operation not permitted", "Permission denied", "can't start new thread")
_LAYERS = {
    "tried what no scene needs": "watchman",
    "processor time": "limits",
    "memory": "limits",
    "crashed": "limits",
    "nonsense": "checked answers",
    "its process ended": "its own end",
}


def _layer(error: ChatSceneError) -> str:
    if any(words in str(error) for words in _KERNEL):
        return "kernel"
    if isinstance(error, SandboxError):
        return next((layer for words, layer in _LAYERS.items() if words in str(error)), str(error))
    return "an error of its own"
