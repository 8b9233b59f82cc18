"""The rooms and files that a sentence goes through, the rooms of a scene, and how often one is entered again.

A room is a folder of the package; nouns, settings, errors, plug-ins and files are everybody's and no rooms here. A stay
begins where a function of one room calls one of another. Whoever hands things on goes through each door once or calls
through it again and again; a room with two doors is one that somebody returned to who did not come from the same place.
A sentence goes through a file if a function in it runs; everybody's files count as well.

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
from chatscene import runs
from chatscene.runs.searching import Desk

ROOT = Path(chatscene.__file__).parent
EVERYBODYS = {"terms", "settings.py", "errors.py", "plugins.py", "plane.py", "files"}
SENTENCE = "A cyclist rides out from the left and stops in front of us."
Stay = tuple[str, str, str]


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


def walked(work: Callable[[], object], files: set[str] | None = None) -> list[Stay]:
    """The stays in order: from which room, into which, by which function; equal ones in a row are one.

    Args:
        work: What is watched.
        files: Takes the files of which a function ran, below the package.
    """
    stays: list[Stay] = []
    known: dict[str, str] = {}

    def look(frame: FrameType, event: str, _argument: Any) -> None:
        name = frame.f_code.co_filename
        if event != "call" or (name not in known and not known.setdefault(name, "x" * name.startswith(str(ROOT)))):
            return
        if not known[name] or frame.f_code.co_name.startswith("<"):
            return
        if files is not None:
            files.add(str(Path(name).relative_to(ROOT)))
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


def show(title: str, stays: list[Stay]) -> None:
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


def show_files(files: set[str]) -> None:
    """Print how many files were gone through, and which, by room."""
    rooms: dict[str, list[str]] = {}
    for path in sorted(files):
        room, _, name = path.partition("/")
        rooms.setdefault(room, []).append((name or room).removesuffix(".py"))
    for room, names in rooms.items():
        print(f"  {room:<12} {len(names):>3}  {', '.join(names)}")
    print(f"{len(files)} files")


def main() -> None:
    chatscene.explain("A truck ahead brakes hard.")  # what is loaded and compiled once is no part of a walk
    files: set[str] = set()
    show(f"sentence: {SENTENCE}", walked(lambda: chatscene.explain(SENTENCE), files))
    show_files(files)
    with tempfile.TemporaryDirectory() as folder:
        blocks: list[list[Stay]] = []
        plain = Desk.block

        def watched(self: Any, *given: Any) -> Any:
            kept: list[Any] = []
            blocks.append(walked(lambda: kept.append(plain(self, *given))))
            return kept[0]

        chatscene.run(SENTENCE, Path(folder) / "first", scenes=1)
        Desk.block = watched
        chatscene.run(SENTENCE, Path(folder) / "second", scenes=1)
        show("scene: one block of one scene", blocks[0])
        assert runs.read_scenes(runs.open_run(Path(folder) / "second"))


if __name__ == "__main__":
    main()
