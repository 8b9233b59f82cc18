"""Scenic 2 is rewritten to Scenic 3, token by token, and each change can be shown.

Driving programs use little that differs, and each difference is one row: things are placed with `new`, monitors have
parameters and are required, a heading is faced, the nearest point of a line is a vector. Three more rows mend what
neither Scenic runs and people write all the same, and one leaves out what does nothing in either. Nothing is run, and
what no row knows stays as it is.
"""

from __future__ import annotations

import difflib
import io
import re
import tokenize
from bisect import bisect_right
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from importlib.resources import files
from itertools import pairwise

from chatscene.simulate.confined.words import known_properties

SHOWN = 3  # changes of one kind whose lines are named

# Scenic's own, and those of its driving domain that our models take from there; the others are read from our models.
_CLASSES = "Object OrientedPoint Point DrivingObject Vehicle Car NPCCar Pedestrian"
_SPECIFIERS = (
    "ahead apparently at behind beyond contained facing following in left not offset on right using visible with"
)
_BEGINS_SPECIFIER = frozenset(_SPECIFIERS.split())
_ENDS = frozenset((tokenize.NEWLINE, tokenize.ENDMARKER))
_UNSEEN = frozenset((tokenize.COMMENT, tokenize.NL))
_REALS = frozenset(("Range", "VerifaiRange", "Normal", "TruncatedNormal"))
_DEFINES = frozenset(("behavior", "class", "def", "monitor", "scenario"))
_CLASS_LINE = re.compile(r"^class +(\w+)", re.MULTILINE)


@dataclass(frozen=True, slots=True, order=True)
class Change:
    """One change of a text.

    Attributes:
        line: Of the text as it was, from 1.
        column: From 0.
        end_column: From 0.
    """

    line: int
    column: int
    end_line: int
    end_column: int
    text: str
    why: str


@dataclass(frozen=True, slots=True)
class Rewritten:
    """A program as Scenic 3 reads it.

    Attributes:
        changes: In order of lines; none where the two are the same.
        meanings: Lines about names that nothing defined, and what they were taken to be.
    """

    before: str
    source: str
    changes: tuple[Change, ...]
    meanings: tuple[str, ...] = ()

    def diff(self, called: str) -> str:
        """What was changed, as a unified diff without lines around it; empty if nothing was."""
        before, after = self.before.splitlines(), self.source.splitlines()
        return "\n".join(difflib.unified_diff(before, after, called, f"{called}, as it is run", n=0, lineterm=""))

    def reasons(self) -> tuple[str, ...]:
        """Each kind of change, with the lines where it was made."""
        lines: dict[str, list[int]] = {}
        for change in self.changes:
            if change.line not in (seen := lines.setdefault(change.why, [])):
                seen.append(change.line)
        return (*(f"{_lines(where)}: {why}" for why, where in lines.items()), *self.meanings)

    def defined(self, source: str, lists: frozenset[str], meanings: tuple[str, ...]) -> Rewritten:
        """It with names defined that nothing defined."""
        changes = tuple(_far_from_lists(_code(source), lists)) if lists else ()
        return replace(self, source=_applied(source, changes), meanings=meanings)


UNCHANGED = Rewritten("", "", ())
"""Of no text."""


def _lines(where: Sequence[int]) -> str:
    named = ", ".join(str(one) for one in where[:SHOWN])
    more = f" and {len(where) - SHOWN} more" if len(where) > SHOWN else ""
    return f"line{'s' if len(where) > 1 else ''} {named}{more}"


def rewrite(source: str) -> Rewritten:
    """A program of Scenic 2 as one of Scenic 3; one of Scenic 3 is as it was but for what neither runs."""
    code = _code(source)
    older = not any(a.string == "new" and b.string[:1].isupper() for a, b in pairwise(code))
    rows = (*_OLDER, *_FAULTY) if older else _FAULTY
    changes = tuple(sorted(change for row in rows for change in row(code)))
    return Rewritten(source, _applied(source, changes), changes)


def _code(source: str) -> _Code:
    """The tokens of a text that mean something; none of one that has none."""
    try:
        every = list(tokenize.generate_tokens(io.StringIO(source).readline))
    except (tokenize.TokenError, SyntaxError, UnicodeError):
        return ()
    return [token for token in every if token.type not in _UNSEEN]


def _applied(source: str, changes: Iterable[Change]) -> str:
    lines = source.split("\n")
    for change in sorted(changes, reverse=True):
        first, last = change.line - 1, change.end_line - 1
        if first == len(lines):
            lines.append("")
        end = lines[last][change.end_column :]
        lines[first : last + 1] = (lines[first][: change.column] + change.text + end).split("\n")
    return "\n".join(lines)


_Code = Sequence[tokenize.TokenInfo]


def _replaced(first: tokenize.TokenInfo, last: tokenize.TokenInfo, text: str, why: str) -> Change:
    return Change(*first.start, *last.end, text, why)


def _before(token: tokenize.TokenInfo, text: str, why: str) -> Change:
    return Change(*token.start, *token.start, text, why)


# What Scenic 3 writes otherwise


def _new(code: _Code) -> Iterator[Change]:
    classes = placeable() | {b.string for a, b in pairwise(code) if _begins(a, "class", "constructor")}
    for k, token in enumerate(code[:-1]):
        placed = code[k + 1].type in _ENDS or code[k + 1].string in _BEGINS_SPECIFIER
        previous = code[k - 1].string if k else ""
        if token.string in classes and placed and previous not in {"new", "class", "constructor", "import", "as", "."}:
            yield _before(token, "new ", "Scenic 3 places things with `new`")


def _monitors(code: _Code) -> Iterator[Change]:
    why = "Scenic 3 gives monitors parameters, and requires those that are to watch"
    for k, token in enumerate(code[:-2]):
        if _begins(token, "monitor") and code[k + 2].string == ":" and (k == 0 or code[k - 1].type != tokenize.NAME):
            yield Change(*code[k + 1].end, *code[k + 1].end, "()", why)
            # At the end of the text where it can be, so that lines keep their numbers.
            end = _end_of_block(code, k) + 1 if token.start[1] else code[-1].start[0]
            required = f"{token.line[: token.start[1]]}require monitor {code[k + 1].string}()\n"
            yield Change(end, 0, end, 0, required, why)


def _end_of_block(code: _Code, k: int) -> int:
    """The last line of the block that begins after a token."""
    deep, line = 0, code[k].start[0]
    for token in code[k:]:
        deep += (token.type == tokenize.INDENT) - (token.type == tokenize.DEDENT)
        if token.type == tokenize.DEDENT and deep <= 0:
            break
        if token.type == tokenize.NEWLINE:
            line = token.start[0]
    return line


def _headings(code: _Code) -> Iterator[Change]:
    for a, b in pairwise(code):
        if a.string == "with" and b.string == "heading":
            yield _replaced(a, b, "facing", "Scenic 3 turns a thing with `facing`, and its heading follows")


def _projected(code: _Code) -> Iterator[Change]:
    for k, token in enumerate(code):
        if token.string == "project" and code[k + 1].string == "(":
            end = _closing(code, k + 1)
            if [one.string for one in code[end + 1 : end + 6]] == [".", "coords", "[", "0", "]"]:
                why = "in Scenic 3 the point of a line that is nearest is a vector itself"
                yield _replaced(code[end + 1], code[end + 5], "", why)


# What neither runs


def _far_from_lists(code: _Code, more: frozenset[str] = frozenset()) -> Iterator[Change]:
    """`distance from x to lanes`, where these are a list."""
    opened = (
        (k, a) for k, (a, b, c) in enumerate(_threes(code)) if b.string == "=" and c.string == "[" and not a.start[1]
    )
    lists = more | {a.string for k, a in opened if _is_list(code, k + 2)}
    taken = {token.string for token in code}
    part = next(name for name in ("part", "piece", "one_part", "_") if name not in taken or name == "_")
    for k, token in enumerate(code):
        if token.string == "distance" and code[k + 1].string == "from":
            to = next((at for at in _level(code, k + 2) if code[at].string == "to"), None)
            if to is not None and code[to + 1].string in lists and code[to + 2].string not in {".", "[", "("}:
                why = "a distance leads to one place: to the nearest of those in the list"
                yield _before(token, "min([", why)
                name = code[to + 1]
                yield Change(*name.start, *name.end, f"{part} for {part} in {name.string}])", why)


def _is_list(code: _Code, k: int) -> bool:
    """Whether the bracket that opens at a token is all of a value, and no place in numbers, which Scenic takes too."""
    end = _closing(code, k)
    inside = code[k + 1 : end]
    numbers = sum(one.type == tokenize.NUMBER for one in inside)
    place = numbers in (2, 3) and all(one.type == tokenize.NUMBER or one.string in {",", "-", "+"} for one in inside)
    return code[end + 1].type in _ENDS and not place


def _whole_turns(code: _Code) -> Iterator[Change]:
    """`range(x)`, where this is a real number that is drawn."""
    names = _Names(code)
    for k, token in enumerate(code):
        if token.string == "range" and code[k + 1].string == "(":
            end = _closing(code, k + 1)
            what = [one.string for one in code[k + 2 : end]]
            if names.real(what, token):
                why = "a count is a whole number, and this one is drawn as a real one"
                yield _before(code[k + 2], "int(", why)
                yield _before(code[end], ")", why)


class _Names:
    """Which names of a program stand for real numbers that are drawn, and where.

    Each definition at the left margin has names of its own, which hide those of the program there.
    """

    def __init__(self, code: _Code) -> None:
        self._begins = sorted({token.start[0] for token in code if token.type == tokenize.NAME and not token.start[1]})
        self._defines = {token.start[0] for token in code if not token.start[1] and token.string in _DEFINES}
        self._params = set[str]()
        self._bound = dict[tuple[int, str], bool]()  # whether everything that a name is given in a block is such
        param = False
        for k, token in enumerate(code[:-2]):
            first = not token.line[: token.start[1]].strip()
            param = token.string == "param" if first else param
            drawn = code[k + 1].string == "=" and code[k + 2].string in _REALS
            given = first and code[k + 1].string == "="
            taken = token.start[0] in self._defines or code[k - 1].string == "for"
            if token.type == tokenize.NAME and param and drawn:
                self._params.add(token.string)
            elif token.type == tokenize.NAME and (given or taken):
                at = self._block(token), token.string
                self._bound[at] = given and drawn and self._bound.get(at, True)

    def real(self, what: Sequence[str], where: tokenize.TokenInfo) -> bool:
        """Whether an expression is a name or a parameter that stands for such a number there."""
        match what:
            case ["globalParameters", ".", name]:
                return name in self._params
            case [name]:
                return self._bound.get((self._block(where), name), self._bound.get((0, name), False))
            case _:
                return False

    def _block(self, token: tokenize.TokenInfo) -> int:
        """The line where the definition begins that a token is in; 0 for one that is in none."""
        at = bisect_right(self._begins, token.start[0])
        begins = self._begins[at - 1] if at else 0
        return begins if begins in self._defines else 0


def _actions_done(code: _Code) -> Iterator[Change]:
    behaviors = {b.string for a, b, _ in _threes(code) if _begins(a, "behavior")}
    for a, b, c in _threes(code):
        if _begins(a, "do") and b.string.endswith("Action") and c.string == "(" and b.string not in behaviors:
            yield _replaced(a, a, "take", "an action is taken; a behavior is done")


def _set_in_vain(code: _Code) -> Iterator[Change]:
    """`ego.steering = -0.8`: a property that no world model has and that the program never reads."""
    sets = {k + 2 for k, token in enumerate(code[:-3]) if _sets_property(code, k, token)}
    named = [k for k in range(1, len(code)) if code[k - 1].string == "." and code[k].type == tokenize.NAME]
    read = {code[k].string for k in named if k not in sets}
    for k in sorted(sets):
        name = code[k].string
        end = next(at for at in range(k, len(code)) if code[at].type in _ENDS)
        if name not in read and not any(one.string == "(" for one in code[k:end]) and name not in known_properties():
            why = f"no world model has .{name}, and nothing reads it, so that to set it does nothing"
            yield _replaced(code[k - 2], code[end - 1], "pass", why)


def _sets_property(code: _Code, k: int, token: tokenize.TokenInfo) -> bool:
    """Whether a token begins a line that sets a property, as `ego.steering = -0.8`."""
    dot, name, equals = code[k + 1 : k + 4]
    alone = _begins(token, token.string) and token.type == name.type == tokenize.NAME
    return alone and dot.string == "." and equals.string == "="


def _threes(code: _Code) -> Iterator[tuple[tokenize.TokenInfo, ...]]:
    return zip(code, code[1:], code[2:], strict=False)


def _begins(token: tokenize.TokenInfo, *words: str) -> bool:
    """Whether a token is one of some words and the first of its line."""
    return token.string in words and not token.line[: token.start[1]].strip()


def _level(code: _Code, k: int) -> Iterator[int]:
    """The tokens from one on, to the end of the brackets that it is in, without those in further brackets."""
    deep = 0
    for at in range(k, len(code)):
        deep -= code[at].string in {")", "]", "}"}
        if deep < 0 or code[at].type in _ENDS:
            return
        if deep == 0:
            yield at
        deep += code[at].string in {"(", "[", "{"}


def _closing(code: _Code, k: int) -> int:
    """Where the bracket that opens at a token closes; the last token if it does not."""
    deep = 0
    for at in range(k, len(code)):
        deep += (code[at].string in {"(", "[", "{"}) - (code[at].string in {")", "]", "}"})
        if deep == 0:
            return at
    return len(code) - 1


_Row = Callable[[_Code], Iterator[Change]]
_OLDER: tuple[_Row, ...] = (_new, _monitors, _headings, _projected)
_FAULTY: tuple[_Row, ...] = (_far_from_lists, _whole_turns, _actions_done, _set_in_vain)


@lru_cache(maxsize=1)
def placeable() -> frozenset[str]:
    """The classes of things that programs for Scenic's driving domain and for CARLA place."""
    texts = (
        files("chatscene.world").joinpath(name).read_text("utf-8") for name in ("driving.scenic", "carla_model.scenic")
    )
    return frozenset(_CLASSES.split()).union(*(_CLASS_LINE.findall(text) for text in texts))
