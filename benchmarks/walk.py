"""The rooms that a sentence and a scene go through, and how often one is entered again.

A room is a folder of the package; nouns, settings, errors, plug-ins and files are everybody's and no rooms here. A stay
begins where a function of one room calls one of another. Whoever hands things on goes through each door once or calls
through it again and again; a room with two doors is one that somebody returned to who did not come from the same place.

    python benchmarks/walk.py
"""

from __future__ import annotations

import sys
import tempfile
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from types import FrameType
from typing import Any

import chatscene
from chatscene import pipeline, runs
from chatscene.pipeline import understand
from chatscene.runs.searching import Desk
from chatscene.settings import SearchSettings, Settings

ROOT = Path(chatscene.__file__).parent
EVERYBODYS = {"terms", "settings.py", "errors.py", "plugins.py", "files"}
SENTENCE = "A cyclist rides out from the left and stops in front of us."


def room_of(frame: FrameType | None) -> str:
    """The room whose function runs in a frame, or that called what runs there; empty for none."""
    while frame is not None:
        path = Path(frame.f_code.co_filename)
        if path.is_relative_to(ROOT):
            room = path.relative_to(ROOT).parts[0]
            if room not in EVERYBODYS:
                return room
        frame = frame.f_back
    return ""


def walked(work: Callable[[], object]) -> list[tuple[str, str, str]]:
    """The stays in order: from which room, into which, by which function; equal ones in a row are one."""
    stays: list[tuple[str, str, str]] = []
    known: dict[str, str] = {}

    def look(frame: FrameType, event: str, _argument: Any) -> None:
        name = frame.f_code.co_filename
        if event != "call" or (name not in known and not known.setdefault(name, "x" * name.startswith(str(ROOT)))):
            return
        if not known[name] or frame.f_code.co_name.startswith("<"):
            return
        here, there = room_of(frame), room_of(frame.f_back)
        own = Path(name).relative_to(ROOT).parts[0]
        if own == here and here != there and (not stays or stays[-1][:2] != (there, here)):
            stays.append((there, here, frame.f_code.co_qualname))

    sys.setprofile(look)
    try:
        work()
    finally:
        sys.setprofile(None)
    return stays


def show(title: str, stays: list[tuple[str, str, str]]) -> None:
    """Print a walk: each door from one room to another when it is first gone through, and how often it was."""
    print(f"\n{title}")
    doors = Counter(stay[:2] for stay in stays)
    first: dict[tuple[str, str], str] = {}
    for there, here, function in stays:
        first.setdefault((there, here), function)
    opened: dict[str, str] = {}
    for (there, here), function in first.items():
        before = f"; entered from {opened[here]} before" if here in opened else ""
        opened.setdefault(here, there)
        print(f"  {there or '-':<12} -> {here:<12} {doors[there, here]:>5} x  first {function}{before}")
    print(f"{len(opened)} rooms, {len(doors)} doors, {len(stays)} stays")


def main() -> None:
    understand("A truck ahead brakes hard.")  # what is loaded and compiled once is no part of a walk
    show(f"sentence: {SENTENCE}", walked(lambda: understand(SENTENCE)))
    small = Settings(search=SearchSettings(scenes=1, block=1, keep=1))
    with tempfile.TemporaryDirectory() as folder:
        asked = runs.asked_run(SENTENCE, settings=small)
        pipeline.run(asked, Path(folder) / "first")
        blocks: list[list[tuple[str, str, str]]] = []
        plain = Desk.block

        def watched(self: Any, *given: Any) -> Any:
            kept: list[Any] = []
            blocks.append(walked(lambda: kept.append(plain(self, *given))))
            return kept[0]

        Desk.block = watched
        pipeline.run(asked, Path(folder) / "second")
        show("scene: one block of one scene", blocks[0])
        assert runs.read_scenes(runs.open_run(Path(folder) / "second"))


if __name__ == "__main__":
    main()
