"""Why a text is not Scenic: what its parser says, where, and what the likeliest mistakes look like."""

from __future__ import annotations

import re
from collections.abc import Iterator

from chatscene.simulate.confined.plain_text import NOT_SCENIC, Refusal
from chatscene.simulate.confined.rules import scenic_2, shown
from chatscene.terms.pointing import meant

_SPECIFIERS = frozenset(  # how they begin
    (
        "ahead",
        "apparently",
        "at",
        "behind",
        "beyond",
        "contained",
        "facing",
        "following",
        "in",
        "left",
        "not",
        "offset",
        "on",
        "right",
        "using",
        "visible",
        "with",
    )
)
_PLACED = re.compile(  # as Scenic 2 has it, and with the word that Scenic 3 needs before it
    r"(?P<new>\bnew\s+)?(?<![\w.])(?P<kind>[A-Z]\w*)\s+"
    r"(?:at|ahead\s+of|behind|beyond|left\s+of|right\s+of|offset|following|facing|with|in|on|visible|apparently|not)\b"
)
_PAIRED = re.compile(  # whatever has two ends; comments and whole strings are read over, so that a quote begins none
    r"""\#[^\n]*
    | (?P<three>\"{3}|'{3}) (?:[^\\]|\\.)*? (?P=three)
    | (?!\"{3}|'{3}) (?P<one>["']) (?:(?!(?P=one))[^\\\n]|\\.)* (?P=one)
    | (?P<quote>["'])
    | [()\[\]{}]""",
    re.DOTALL | re.VERBOSE,
)
_CLOSES = {")": "(", "]": "[", "}": "{"}


def not_scenic(source: str, error: Exception) -> Refusal:
    """What is wrong with a text that Scenic's parser refuses."""
    line = getattr(error, "lineno", None) or 0
    column = getattr(error, "offset", None) or 0
    end = getattr(error, "end_offset", None) or 0
    said = ascii(str(error).strip().partition("\n")[0])[1:-1].rstrip(".") or type(error).__name__
    if isinstance(error, RecursionError):
        said = "its brackets, blocks or signs lie too deep in one another"
    if (open_end := _never_closed(source)) is not None:
        return open_end
    old = list(_without_new(source))
    if old and (not line or old[0].line <= line):
        lines = sorted({one.line for one in old})
        where = f" (so too in line{'s' * (len(lines) > 2)} {', '.join(map(str, lines[1:]))})" if len(lines) > 1 else ""
        first = old[0]
        return Refusal(first.line, first.what, first.why + where, first.column, first.width, faulty=True)
    width = end - column if end > column else 1
    text = source.split("\n")[line - 1] if 0 < line <= source.count("\n") + 1 else ""
    if said == "invalid specifier":
        word = text[column - 1 : column - 1 + width]
        said = f"there is no specifier {shown(word)}{meant(word, _SPECIFIERS)}"
    elif text.startswith("\t") and re.search(r"^ +\S", source, re.MULTILINE):
        said = "lines are indented with tabs and with blanks; use blanks"
    return Refusal(line, NOT_SCENIC, said, column, width, faulty=True)


def _without_new(source: str) -> Iterator[Refusal]:
    """Whatever is placed as Scenic 2 has it."""
    for number, line in enumerate(source.split("\n"), 1):
        for found in _PLACED.finditer(line.partition("#")[0]):
            if not found["new"]:
                kind = found["kind"]
                what, why = f"{kind} without new", scenic_2(kind)
                yield Refusal(number, what, why, found.start("kind") + 1, len(kind), faulty=True)


def _never_closed(source: str) -> Refusal | None:
    """A bracket or a quote that is never closed, or a bracket that closes nothing.

    Python's own tokenizer is not asked: where it sees an open quote, and whether it goes on behind it, is another
    matter in each version.
    """
    opened: list[tuple[str, int]] = []
    for found in _PAIRED.finditer(source):
        sign, at = found[0], found.start()
        if found["quote"]:
            return _unpaired("this quote is never closed", source, at)
        if sign in _CLOSES.values():
            opened.append((sign, at))
        elif sign in _CLOSES and (not opened or opened.pop()[0] != _CLOSES[sign]):
            return _unpaired(f"this {sign} closes nothing", source, at)
    return _unpaired(f"this {opened[-1][0]} is never closed", source, opened[-1][1]) if opened else None


def _unpaired(why: str, source: str, at: int) -> Refusal:
    line, column = source.count("\n", 0, at) + 1, at - source.rfind("\n", 0, at)
    return Refusal(line, NOT_SCENIC, why, column, faulty=True)
