"""What was said in the page and what came of it, in order; one line is worked on at a time, in a child process."""

from __future__ import annotations

import threading
import time
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from chatscene.view.child import Child, Ended

Turn = dict[str, Any]


class Busy(Exception):  # noqa: N818 - reads as what it says
    """Another line is worked on; the message says which."""


class Conversation:
    """One talk, which every window of the page shows.

    A process that ended, or was ended, loses nothing: another one goes on from where the talk stood. It hears no line
    again, so what was refused, failed or was run is over.

    Args:
        folder: Where the folders of runs go.
        reading: How sentences are read: options of `chatscene.explain`.
        search: How a run is searched: options of `chatscene.run`.
    """

    def __init__(self, folder: Path, reading: Mapping[str, Any], search: Mapping[str, Any]) -> None:
        self._folder = folder
        self._child = Child(lambda: {"folder": str(folder), "reading": reading, "search": search, "kept": self._kept})
        self._lock = threading.Lock()
        self._kept: dict[str, Any] = {}
        self._turns: list[Turn] = []
        self._work: dict[str, Any] | None = None
        self._answering: threading.Thread | None = None

    def say(self, line: str) -> None:
        """Begin to work on a line.

        Raises:
            Busy: Another one is worked on.
        """
        line = " ".join(line.split())
        with self._lock:
            if self._work:
                raise Busy(f"{self._work['line']!r} is worked on; wait until it is done, or cancel it")
            self._child.start()  # so that whoever cancels finds it
            self._work = {"line": line, "since": time.monotonic(), "cancelled": False, "folder": ""}
            self._answering = threading.Thread(target=self._answer, args=(line, self._work), daemon=True)
            self._answering.start()

    def cancel(self) -> bool:
        """End the work on a line at once; whether there was one."""
        with self._lock:
            if not self._work:
                return False
            self._work["cancelled"] = True
            self._child.end()
        return True

    def state(self, since: int) -> dict[str, Any]:
        """What there is to show.

        Returns:
            The turns after these, how many there are, and what is worked on, as far as it is.
        """
        with self._lock:
            work = self._work and {
                **{name: self._work.get(name) for name in ("line", "what", "done", "total", "left", "folder")},
                "seconds": round(time.monotonic() - self._work["since"]),
            }
            return {"turns": self._turns[since:], "count": len(self._turns), "work": work}

    def close(self) -> None:
        """End what is worked on; the talk is gone."""
        self.cancel()
        if self._answering:
            self._answering.join()
        self._child.close()

    def _answer(self, line: str, work: dict[str, Any]) -> None:
        try:
            turn = self._child.ask({"line": line}, lambda told: self._tell(work, told))
            self._kept = turn.pop("kept")
        except Ended as error:
            turn = self._ended(work, str(error))
        with self._lock:
            self._turns.append({"line": line, **turn})
            self._work = None

    def _tell(self, work: dict[str, Any], told: Mapping[str, Any]) -> None:
        spent = time.monotonic() - work["since"]
        done, total = told.get("done", 0), told.get("total", 0)
        left = round(spent / done * (total - done)) if 0 < done < total else None
        with self._lock:
            work.update(told, left=left)

    def _ended(self, work: Mapping[str, Any], how: str) -> Turn:
        folder = self._folder / work["folder"]
        begun = work["folder"] and (folder / "run.json").is_file()
        return {
            "kind": "cancelled" if work["cancelled"] else "crashed",
            "message": "" if work["cancelled"] else how,
            "resume": f"chatscene resume {folder}" if begun else "",
        }
