"""A text is looked at before it is parsed: too long, too deep, or made to look like another, and it goes no further."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterator
from dataclasses import dataclass

from chatscene.terms.pointing import SourcePlace

MAX_CHARACTERS = 20_000  # the longest program that our library makes has 3 000
MAX_LINES = 500
MAX_LINE = 400
MAX_BRACKETS = 20  # open at once
MAX_SIGNS = 8  # minus signs or `not` in a row
NOT_SCENIC = "not Scenic"  # what the parser refuses
REPORTED = 20  # refusals; who wrote more needs no longer list

TRUST = (
    "If you trust who wrote it, --trust (in Python: trust=True) runs it with all of Scenic and Python, "
    "outside the sandbox."
)

_DOCSTRING = re.compile(r"\s*(?P<quotes>\"\"\"|\'\'\')(?:(?!(?P=quotes))[^\\])*(?P=quotes)")
_SIGNS = re.compile(rf"(?:(?:[-+~]|\bnot\b)\s*){{{MAX_SIGNS + 1}}}")


@dataclass(frozen=True, slots=True, order=True)
class Refusal:
    """One thing that a program may not do.

    Attributes:
        line: Where, from 1; 0 for the program as a whole.
        what: What was found.
        why: Why it is not allowed.
        column: Where in the line, from 1; 0 for the line as a whole.
        width: How many characters it has.
        faulty: Whether it is wrong whoever runs it; else only the sandbox forbids it.
    """

    line: int
    what: str
    why: str
    column: int = 0
    width: int = 1
    faulty: bool = False

    @property
    def place(self) -> SourcePlace:
        """Where it is."""
        return SourcePlace(self.line, self.column, self.width)

    def __str__(self) -> str:
        column = f", column {self.column}" if self.what == NOT_SCENIC and self.column else ""
        return f"line {self.line}{column}: {self.what}: {self.why}" if self.line else f"{self.what}: {self.why}"


def check_text(source: str) -> tuple[Refusal, ...]:
    """What is wrong with a text before it is parsed; empty if it may be."""
    if len(source) > MAX_CHARACTERS:
        return (Refusal(0, f"{len(source)} characters", f"a program has at most {MAX_CHARACTERS}"),)
    lines = source.split("\n")
    if len(lines) > MAX_LINES:
        return (Refusal(0, f"{len(lines)} lines", f"a program has at most {MAX_LINES}"),)
    prose = _docstring_lines(source)
    found = [refusal for number, line in enumerate(lines, 1) for refusal in _check_line(number, line, number <= prose)]
    return (*found[:REPORTED], *_check_brackets(lines))


def _docstring_lines(source: str) -> int:
    """How many lines, from the first, lie wholly within a docstring at the beginning, where only prose stands."""
    begun = _DOCSTRING.match(source)
    return begun[0].count("\n") if begun else 0


def _check_line(number: int, line: str, prose: bool) -> Iterator[Refusal]:
    if len(line) > MAX_LINE:
        yield Refusal(number, f"{len(line)} characters in a line", f"a line has at most {MAX_LINE}")
    code = "" if prose else line.partition("#")[0]
    for character in sorted(set(line)):
        if character not in "\t " and unicodedata.category(character)[0] in "CZ":
            why = "invisible and control characters can hide what a line does"
            yield Refusal(number, _named(character), why, line.index(character) + 1)
        elif character in code and not character.isascii():
            why = "code is written in ASCII; other letters only in comments"
            yield Refusal(number, _named(character), why, line.index(character) + 1)
    if "\\" in code.removesuffix("\\"):
        why = "nothing in a program needs one; put brackets around a long line"
        yield Refusal(number, "a backslash", why, code.index("\\") + 1)
    if _SIGNS.search(code):
        yield Refusal(number, "a pile of signs", f"at most {MAX_SIGNS} stand in a row")


def _named(character: str) -> str:
    return f"the character U+{ord(character):04X} {unicodedata.name(character, '')}".rstrip()


def _check_brackets(lines: list[str]) -> list[Refusal]:
    open_now = 0
    for number, line in enumerate(lines, 1):
        for character in line.partition("#")[0]:
            open_now += (character in "([{") - (character in ")]}")
            if open_now > MAX_BRACKETS:
                return [Refusal(number, "brackets within brackets", f"at most {MAX_BRACKETS} are open at once")]
    return []
