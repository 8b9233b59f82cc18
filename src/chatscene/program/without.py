"""A program without some of the things it places."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass, replace

from chatscene.terms.scene import ScenicProgram

_NEW = re.compile(r"(?:(?P<name>\w+)\s*=\s*)?new\s+\w+\b")
_BLOCK = re.compile(r"(?:for|if|elif|else|while|try|except|finally|with)\b")
_TEXT_OR_COMMENT = re.compile(r""""(?:\\.|[^"\\])*"|'(?:\\.|[^'\\])*'|#.*""")
_MARKS = re.compile(r"[()\[\]{}#,:\\]")


@dataclass(frozen=True, slots=True, kw_only=True)
class Placing:
    """A statement that places things, the ego apart.

    Attributes:
        first: Its first line, from 0.
        last: Its last line.
        named: The name that it gives, or empty.
        asked_for: Whether the program names what it places elsewhere, so that it means nothing without.
    """

    first: int
    last: int
    named: str
    asked_for: bool


def placings(program: ScenicProgram) -> tuple[Placing, ...]:
    """The statements of a program that place things other than the ego when the scene is made, in their order.

    What behaviors and scenarios place as they go on is not among them.
    """
    lines = [_TEXT_OR_COMMENT.sub(_plain, line).rstrip() for line in program.source.splitlines()]
    found: list[Placing] = []
    deeper: int | None = None  # the indent of a definition, whose body is passed over
    row = 0
    while row < len(lines):
        first, text = row, lines[row].strip()
        row += 1
        if not text:
            continue
        indent = len(lines[first]) - len(lines[first].lstrip())
        while row < len(lines) and _goes_on(text):
            text += " " + lines[row].strip()
            row += 1
        if deeper is not None and indent > deeper:
            continue
        deeper = indent if text.endswith(":") and not _BLOCK.match(text) else None
        placed = _NEW.match(text)
        name = (placed["name"] or "") if placed else ""
        if not placed or name == "ego":
            continue
        others = "\n".join(lines[:first] + lines[row:])
        asked_for = bool(name) and re.search(rf"\b{name}\b", others) is not None
        found.append(Placing(first=first, last=row - 1, named=name, asked_for=asked_for))
    return tuple(found)


def without(program: ScenicProgram, left_out: Iterable[Placing]) -> ScenicProgram:
    """The program with nothing in the place of these statements; its parameters stay, whether used or not."""
    lines = program.source.splitlines()
    for placing in left_out:
        indent = len(lines[placing.first]) - len(lines[placing.first].lstrip())
        # As many lines as before, so that messages name those of the program that is kept.
        lines[placing.first : placing.last + 1] = [" " * indent + "pass"] + [""] * (placing.last - placing.first)
    source = "\n".join(lines) + "\n"
    return replace(program, source=source)


def _plain(found: re.Match[str]) -> str:
    """A text without what would look like code, and nothing of a comment."""
    return "" if found[0].startswith("#") else _MARKS.sub(" ", found[0])


def _goes_on(text: str) -> bool:
    opened = sum(text.count(bracket) for bracket in "([{") - sum(text.count(bracket) for bracket in ")]}")
    return opened > 0 or text.endswith((",", "\\"))
