"""A text is looked at before it is parsed: too long, too deep, or made to look like another, and it goes no further."""

from __future__ import annotations

import io
import re
import tokenize
import unicodedata
from collections.abc import Iterable, Iterator, Sequence
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
_SIGNS = frozenset(("-", "+", "~", "not"))
_BLANK = frozenset((tokenize.COMMENT, tokenize.NL))  # which a line within brackets may hold between two signs


@dataclass(frozen=True, slots=True, order=True)
class Refusal:
    """One thing that a program may not do.

    Attributes:
        line: Where, from 1; 0 for the program as a whole.
        why: Why it is not allowed.
        column: Where in the line, from 1; 0 for the line as a whole.
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
    code, tokens = _lexed(source, lines)
    found = [
        refusal
        for number, (line, part) in enumerate(zip(lines, code, strict=True), 1)
        for refusal in _check_line(number, line, "" if number <= prose else part)
    ]
    return (*found[:REPORTED], *_check_nesting(tokens))


def _lexed(source: str, lines: Sequence[str]) -> tuple[list[str], list[tokenize.TokenInfo]]:
    """Each line without its comment, and the tokens: only Python can tell a comment from a # within a text.

    Of a text that has an end before Python finds one, which no parser takes, a comment begins at the first #.
    """
    code = list(lines)
    tokens: list[tokenize.TokenInfo] = []
    try:
        for token in tokenize.generate_tokens(io.StringIO(source).readline):
            tokens.append(token)
            if token.type == tokenize.COMMENT:
                row, column = token.start
                code[row - 1] = lines[row - 1][:column]
    except (tokenize.TokenError, SyntaxError, UnicodeError):  # the last from Python 3.12 on, of half a character
        read = tokens[-1].end[0] if tokens else 0
        code[read:] = [line.partition("#")[0] for line in lines[read:]]
    return code, tokens


def _docstring_lines(source: str) -> int:
    """How many lines, from the first, lie wholly within a docstring at the beginning, where only prose stands."""
    begun = _DOCSTRING.match(source)
    return begun[0].count("\n") if begun else 0


def _check_line(number: int, line: str, code: str) -> Iterator[Refusal]:
    if len(line) > MAX_LINE and code:
        yield Refusal(number, f"{len(line)} characters in a line", f"a line has at most {MAX_LINE}")
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


def _named(character: str) -> str:
    return f"the character U+{ord(character):04X} {unicodedata.name(character, '')}".rstrip()


def _check_nesting(tokens: Iterable[tokenize.TokenInfo]) -> list[Refusal]:
    """What a parser would lose its way in: at most one of each kind."""
    found: dict[str, Refusal] = {}
    open_now = signs = 0
    for token in tokens:
        if token.type in _BLANK:
            continue
        signs = signs + 1 if token.string in _SIGNS else 0
        if token.type == tokenize.OP:
            open_now += (token.string in "([{") - (token.string in ")]}")
        line = token.start[0]
        if signs > MAX_SIGNS:
            found.setdefault("signs", Refusal(line, "a pile of signs", f"at most {MAX_SIGNS} stand in a row"))
        if open_now > MAX_BRACKETS:
            why = f"at most {MAX_BRACKETS} are open at once"
            found.setdefault("brackets", Refusal(line, "brackets within brackets", why))
    return list(found.values())
