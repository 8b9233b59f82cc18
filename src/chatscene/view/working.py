"""What a child process does (`chatscene.view.child`): hear lines of a talk, and look at runs."""

from __future__ import annotations

import json
import os
import threading
from collections.abc import Callable, Mapping
from contextlib import suppress
from pathlib import Path
from queue import Queue
from typing import Any, BinaryIO

from chatscene.errors import ChatSceneError

Question = Mapping[str, Any]
Tell = Callable[[Mapping[str, Any]], None]
Answering = Callable[[Question], Mapping[str, Any]]


def main() -> None:
    """Serve a page of runs."""
    serve(lambda setup, tell: _talking(setup, tell) if "search" in setup else _looking(setup))


def serve(made: Callable[[Question, Tell], Answering]) -> None:
    """Read what to be and then questions, a line of JSON each, from the standard input; answer on the standard output.

    Whatever else is printed goes to the standard error output, so that no word of a package is taken for an answer.
    """
    lines: Queue[bytes] = Queue()
    heard = os.fdopen(os.dup(0), "rb")  # not that of sys.stdin, on whose lock an interpreter that ends would wait
    threading.Thread(target=_listen, args=(heard, lines), daemon=True).start()
    with os.fdopen(os.dup(1), "wb", buffering=0) as answers:
        os.dup2(2, 1)

        def tell(told: Mapping[str, Any]) -> None:
            answers.write(json.dumps(told).encode() + b"\n")

        answer = made(json.loads(lines.get()), tell)
        while True:
            tell({"answer": answer(json.loads(lines.get()))})


def _listen(source: BinaryIO, lines: Queue[bytes]) -> None:
    for line in source:
        lines.put(line)
    os._exit(0)  # whoever asked is gone, and must not be worked for any more


def _talking(setup: Question, tell: Tell) -> Callable[[Question], dict[str, Any]]:
    from chatscene.talk import Talk
    from chatscene.view.turns import turn_of

    talk = Talk(setup["reading"], setup["search"], Path(setup["folder"]))
    if setup["kept"]:
        with suppress(ChatSceneError):  # what stood is not understood any more, as where its library is gone
            talk.go_on(setup["kept"])

    def progress(what: str, done: int, total: int) -> None:
        tell({"what": what, "done": done, "total": total})

    def hear(question: Question) -> dict[str, Any]:
        line = question["line"]
        if line == "run":
            tell({"folder": talk.free_folder().name})
        return {**turn_of(talk, line, progress, setup["reading"]["embedder"]), "kept": talk.kept}

    return hear


def _looking(setup: Question) -> Callable[[Question], dict[str, Any]]:
    from chatscene.view.looking import compared, listed, still

    folder = Path(setup["folder"])
    looks: dict[str, Callable[..., dict[str, Any]]] = {"list": listed, "compare": compared, "still": still}

    def look(question: Question) -> dict[str, Any]:
        try:
            return looks[question["look"]](folder, *question["runs"])
        except ChatSceneError as error:
            return {"error": str(error)}

    return look


if __name__ == "__main__":
    main()
