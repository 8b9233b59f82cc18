"""A snippet's file, or a family's: a header, a program, and what stands behind ``#:`` in a line of it.

::

    #: description = "The pedestrian crosses the road without stopping."
    #: adversaries = ["pedestrian", "bicycle", "motorcycle"]
    #: origin = "own code"
    #: [slots]
    #: actions = ["cross"]

    param OPT_ADV_SPEED = Range(0.8, 4)  #: [m/s] how fast it goes

    behavior AdvBehavior():
        do MoveAhead(globalParameters.OPT_ADV_SPEED)

The header says what only a person knows. What a snippet requires, provides and tunes is read off its code.

A header with a table ``variants`` makes a family: each row is a snippet and its key the snippet's name. A row's value
fills the slot of that name and stands wherever the code and the description say ``$key``; a line that ends in ``#: if
key``, ``#: if key value`` or ``#: unless …`` is there in some rows only. Nothing is run: a value is a text, a number,
a truth or a list of these. Where sentences differ beyond a word, a table ``descriptions`` has them.

::

    #: description = "The adversary is behind a $occluder on the $side front."
    #: adversaries = ["pedestrian"]
    #: [variants]
    #: behind-kiosk-left = { side = "left", occluder = "kiosk", Thing = "Kiosk", x = [1.9, 2.8] }
    #: behind-hedge-right = { side = "right", occluder = "hedge", Thing = "Hedge", x = [1.4, 2.2] }
"""

from __future__ import annotations

import json
import keyword
import re
import tomllib
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from dataclasses import fields as dataclass_fields
from pathlib import Path
from string import Template
from typing import Any

from pydantic import TypeAdapter, ValidationError

from chatscene.errors import SnippetError
from chatscene.files.bounded import check_file
from chatscene.terms.scenario import Slots
from chatscene.terms.snippet import ParameterRange, Snippet

MARK = "#:"
ENDING = ".scenic"
WORDINGS = "wordings"  # the folder of a library that holds the other ways to say what its snippets do
UNITS = ("m", "m/s", "s", "rad", "1")
ADVERSARY_CLASS = "AdvClass"  # every program defines it …
GIVEN = (ADVERSARY_CLASS, "ego")  # … and its ego, so that nobody requires them
ADVERSARY_BEHAVIOR = "AdvBehavior"

_KEYS = frozenset(("description", "descriptions", "adversaries", "origin", "slots", "variants"))
_OWN = ("adversaries", "origin")  # what a row may say of itself in the place of the header
_SLOTS = frozenset(f.name for f in dataclass_fields(Slots) if f.name != "others")
_OLD = {
    "rephrasings": "they stand in {wordings}, one a line; move them there",
    "requires": "it is read off the code; take it out",
    "provides": "it is read off the code; take it out",
    "parameters": "unit and meaning stand in the code, as in: param OPT_ADV_SPEED = Range(1, 4)  #: [m/s] how fast it "
    "goes",
}
"""Keys that headers had once, and what became of them."""

_NAME = re.compile(r"[a-z0-9]+(?:-[a-z0-9]+)*")  # of a variant
_NUMBER = r"([-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?)"
_PARAMETER = re.compile(rf"param\s+(OPT_\w+)\s*=\s*Range\(\s*{_NUMBER}\s*,\s*{_NUMBER}\s*\)\s*(?:#.*)?")
_MEANING = re.compile(r"\[([^\]]*)\]\s*(.*)")
_CONDITION = re.compile(r"(if|unless)\s+(\w+)(?:\s+(\S+))?")
_adapter: TypeAdapter[Snippet] = TypeAdapter(Snippet)


def read_snippets(path: Path) -> tuple[Snippet, ...]:
    """The snippets of a file: one, or the rows of a family, with their wordings.

    Raises:
        SnippetError: Its header is missing, is not TOML, or lacks or mistakes a key; its code tunes something without
            saying what; or its wordings cannot be read.
    """
    lines = _text(path).splitlines()
    end = next((i for i, line in enumerate(lines) if not line.startswith(MARK)), len(lines))
    try:
        header = tomllib.loads("\n".join(line.removeprefix(MARK) for line in lines[:end]))
    except (tomllib.TOMLDecodeError, RecursionError) as error:
        raise SnippetError(f"{path}: the header (lines that start with {MARK!r}) is not TOML: {error}") from error
    _check_keys(path, header)
    body = list(enumerate(lines[end:], end + 1))
    if "variants" not in header:
        return (_snippet(path, header, body, _Row(where=str(path), name=path.stem)),)
    rows = header["variants"]
    if not isinstance(rows, dict) or not rows or not all(isinstance(row, dict) for row in rows.values()):
        raise SnippetError(f"{path}: variants is a table with a row for each snippet, NAME = {{ key = value, … }}")
    said = header.get("descriptions", {})
    if not isinstance(said, dict) or said.keys() - rows.keys():
        raise SnippetError(f'{path}: descriptions is a table NAME = "sentence" with names that variants has')
    known = frozenset(key for row in rows.values() for key in row)
    return tuple(_snippet(path, header, body, _row(path, name, row, known)) for name, row in rows.items())


def read_wordings(path: Path) -> tuple[str, ...]:
    """The lines of a file of wordings, without empty ones; none if there is no file.

    Raises:
        SnippetError: It cannot be read, or a line stands there twice.
    """
    if not path.exists():
        return ()
    lines = [line.strip() for line in _text(path).split("\n")]
    wordings = tuple(filter(None, lines))
    if len({text.casefold() for text in wordings}) < len(wordings):
        seen: set[str] = set()
        for number, text in enumerate(lines, 1):
            if text and text.casefold() in seen:
                raise SnippetError(f"{path}, line {number}: {text!r} stands there already; take it out")
            seen.add(text.casefold())
    return wordings


def wordings_path(library: Path, snippet_id: str) -> Path:
    """Where the wordings of a snippet lie in the folder of a library."""
    return library / WORDINGS / f"{snippet_id}.txt"


def _text(path: Path) -> str:
    try:
        check_file(path)
        return path.read_text(encoding="utf-8")
    except (OSError, ValueError) as error:
        raise SnippetError(f"{path} cannot be read: {error}") from error


def _snippet(path: Path, header: Mapping[str, Any], body: list[tuple[int, str]], row: _Row) -> Snippet:
    code, parameters, lines = _code(path, body, row)
    description = header.get("descriptions", {}).get(row.name, header.get("description"))
    if not isinstance(description, str):
        raise SnippetError(f"{row.where}: the header lacks its description, a sentence")
    requires, provides = names_in(code)
    snippet_id = f"{path.parent.name}/{row.name}"
    wordings = wordings_path(path.parent.parent, snippet_id)
    fields: dict[str, Any] = {
        **{key: value for key, value in {**header, **row.values}.items() if key in _OWN},
        "id": snippet_id,
        "component": path.parent.name,
        "description": row.filled(row.where, description),
        "rephrasings": read_wordings(wordings),
        "slots": {**header.get("slots", {}), **{key: row.values[key] for key in row.values if key in _SLOTS}},
        "requires": requires,
        "provides": provides,
        "parameters": parameters,
        "source": code,
        "file": f"{path.parent.name}/{path.name}",
        "lines": lines,
    }
    if unused := sorted(row.values.keys() - row.used - _SLOTS - {*_OWN}):
        raise SnippetError(
            f"{row.where}: nothing uses {', '.join(unused)}; say ${unused[0]} where it belongs, or take it out"
        )
    try:
        snippet = _adapter.validate_python(fields)
    except ValidationError as error:
        problem = error.errors()[0]
        key = ".".join(str(part) for part in problem["loc"])
        raise SnippetError(f"{row.where}: {key}: {problem['msg']}") from error
    if snippet.description.casefold() in {wording.casefold() for wording in snippet.rephrasings}:
        raise SnippetError(f"{wordings}: {snippet.description!r} is the description; take it out")
    return snippet


def _code(
    path: Path, body: list[tuple[int, str]], row: _Row
) -> tuple[str, tuple[ParameterRange, ...], tuple[int, ...]]:
    """The code of one snippet of a file without our marks, what it tunes, and where in the file its lines stand."""
    code: list[str] = []
    lines: list[int] = []
    parameters: list[ParameterRange] = []
    for number, line in body:
        at = f"{path}, line {number}"
        text, mark, said = line.partition(MARK)
        marks = [one.strip() for one in said.split(MARK)] if mark else []
        conditions = [found for one in marks if (found := _CONDITION.fullmatch(one))]
        holds = [row.holds(at, one) for one in conditions]  # each is asked, so that each of its keys counts as used
        if all(holds):
            code.append(row.filled(at, text.rstrip() if mark else text))
            lines.append(number)
            meanings = [row.filled(at, one) for one in marks if not _CONDITION.fullmatch(one)]
            parameters += _parameters(at, code[-1], meanings)
    return "\n".join(code), tuple(parameters), tuple(lines)


def _check_keys(path: Path, header: Mapping[str, Any]) -> None:
    for key, remedy in _OLD.items():
        if key in header:
            wordings = wordings_path(path.parent.parent, f"{path.parent.name}/{path.stem}")
            raise SnippetError(f"{path}: a header has no {key} any more: {remedy.format(wordings=wordings)}")
    if "descriptions" in header and "variants" not in header:
        raise SnippetError(f"{path}: descriptions are for the variants of a family; one snippet has a description")
    if "description" not in header and "variants" not in header:
        raise SnippetError(f"{path}: the header lacks description")
    for where, given, keys in (("slots", header.get("slots", {}), _SLOTS), ("the header", header, _KEYS)):
        unknown = sorted(given.keys() - keys) if isinstance(given, dict) else []
        if unknown:  # a key that nobody reads is a slip of the author's
            raise SnippetError(
                f"{path}: {where} has unknown keys {', '.join(unknown)}; known: {', '.join(sorted(keys))}"
            )


# Rows


@dataclass(frozen=True, slots=True, kw_only=True)
class _Row:
    """A snippet among those of a file.

    Attributes:
        values: Values of the row; empty if the file is no family.
        known: Keys that some row of the family has.
    """

    where: str
    name: str
    values: Mapping[str, Any] = field(default_factory=dict[str, Any])
    written: Mapping[str, str] = field(default_factory=dict[str, str])
    known: frozenset[str] = frozenset()
    used: set[str] = field(default_factory=set[str])

    def filled(self, at: str, text: str) -> str:
        """A text with the row's values in the place of ``$key``."""
        if not self.known or "$" not in text:
            return text
        template = Template(text)
        try:
            filled = template.substitute(self.written)
        except KeyError as error:
            has = ", ".join(self.written)
            raise SnippetError(f"{at}: {self.name} has no value for ${error.args[0]}; it has {has}") from error
        except ValueError as error:
            raise SnippetError(f"{at}: a $ begins the name of a value, as in $side or ${{side}}: {error}") from error
        self.used.update(template.get_identifiers())
        return filled

    def holds(self, at: str, condition: re.Match[str]) -> bool:
        """Whether a line with this condition is there."""
        word, key, wanted = condition.groups()
        if key not in self.known:
            raise SnippetError(f"{at}: {condition[0]!r}: no row of variants has {key}")
        self.used.add(key)
        value = self.values.get(key, False)
        listed = [str(one) for one in (value if isinstance(value, list) else [value])]
        return (word == "if") is (value is not False if wanted is None else wanted in listed)


def _row(path: Path, name: str, values: Mapping[str, Any], known: frozenset[str]) -> _Row:
    where = f"{path}: variants.{name}"
    if not _NAME.fullmatch(name):
        raise SnippetError(f"{where}: a name has letters a to z, digits and hyphens")
    written = {key: _written(where, key, value) for key, value in values.items()}
    return _Row(where=where, name=name, values=values, written=written, known=known)


def _written(where: str, key: str, value: object) -> str:
    """A value as it stands in a text: as it is, a list in round brackets."""
    if isinstance(value, list):
        items = [json.dumps(one, ensure_ascii=False) if isinstance(one, str) else str(one) for one in value]
        return f"({', '.join(items)}{',' if len(items) == 1 else ''})"
    if isinstance(value, str | int | float):
        return str(value)
    raise SnippetError(f"{where}: {key} is a text, a number, true, false or a list of these")


# Code


def _words(text: str) -> frozenset[str]:
    return frozenset(text.split())


_SCENIC = _words(
    """
    above abort ahead along altitude always angle apparent apparently at away back behavior behind below beyond bottom
    by can choose compose contained deg distance do eventually facing final following front heading implies initial
    interrupt invariant left model monitor mutate new next of offset on override param past position precondition record
    relative require right scenario seconds see setup shuffle simulation steps take terminate to top toward try until
    using visible wait when
    """
)
_NOBODYS = _SCENIC | {*keyword.kwlist, *GIVEN, "self", "globalParameters", "network", "roadDirection", "workspace"}
_PROSE = re.compile(r'"""[\s\S]*?"""|"[^"\n]*"|\'[^\'\n]*\'|#[^\n]*')
# Neither an attribute, nor a property, a class, a function or an argument's name.
_READ = re.compile(r"(?<![\w.])(?<!\bwith )(?<!\bnew )([A-Za-z_]\w*)\b(?!\s*\()(?!\s*=(?!=))")
_BOUND = re.compile(r"^\s*(\w+)\s*=(?!=)", re.MULTILINE)
_COUNTED = re.compile(r"\bfor (\w+(?:\s*,\s*\w+)*) in\b")
_DEFINED = re.compile(r"^(?:(?:behavior|monitor|scenario|class|def)\s+(\w+)|(\w+)\s*=(?!=))", re.MULTILINE)


def names_in(source: str) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """What a snippet requires of its partners and what it provides for them, each sorted, by the words of its code.

    Scenic's own parser says the same and takes seconds for a library; `chatscene library lint` asks it. A name that
    is called is a function or a behavior of the world's, but for `AdvBehavior`.
    """
    code = _PROSE.sub("", source)
    provides = {name for pair in _DEFINED.findall(code) for name in pair if name}
    own = provides.union(_BOUND.findall(code), *(names.replace(" ", "").split(",") for names in _COUNTED.findall(code)))
    read = {*_READ.findall(code), *re.findall(rf"\b{ADVERSARY_BEHAVIOR}\b", code)}
    return tuple(sorted(read - own - _NOBODYS)), tuple(sorted(provides))


def tuned_in(source: str) -> frozenset[str]:
    """Names of the parameters that have a line of their own in a piece of code."""
    return frozenset(found[1] for line in source.split("\n") if (found := _PARAMETER.fullmatch(line)))


def _parameters(at: str, code: str, meanings: list[str]) -> list[ParameterRange]:
    """What a line tunes: a parameter or nothing."""
    found = _PARAMETER.fullmatch(code) if code.startswith("param") else None
    if found is None:
        if code.startswith("param") and re.match(r"param\b.*\bOPT_", code):
            raise SnippetError(
                f"{at}: a parameter has a line of its own, param OPT_NAME = Range(low, high)  {MARK} [unit] meaning, "
                "with two numbers"
            )
        if meanings:
            raise SnippetError(
                f"{at}: what follows {MARK!r} says unit and meaning of a parameter, or when a line of a family is "
                f"there; it is {meanings[0]!r}"
            )
        return []
    name, low, high = found[1], float(found[2]), float(found[3])
    said = _MEANING.fullmatch(meanings[0]) if len(meanings) == 1 else None
    if said is None:
        raise SnippetError(f"{at}: {name} lacks its unit and meaning, as in: {MARK} [m/s] how fast it goes")
    if low > high:
        raise SnippetError(f"{at}: {name} runs from {low:g} to {high:g}")
    if said[1] not in UNITS:
        raise SnippetError(f"{at}: {name} has unit {said[1]!r}; known: {', '.join(UNITS)}")
    return [ParameterRange(name=name, low=low, high=high, unit=said[1], meaning=said[2])]


# Writing


def as_text(snippet: Snippet) -> str:
    """A snippet as the text of a file of its own, which `read_snippets` reads; `wordings_text` goes beside it."""
    lines = [f"description = {_quoted(snippet.description)}"]
    if snippet.adversaries:
        lines += [f"adversaries = {_toml(snippet.adversaries)}"]
    lines += [f"origin = {_quoted(snippet.origin)}", "[slots]"]
    lines += [f"{name} = {_toml(value)}" for name, value in snippet.slots.said().items()]
    header = "\n".join(f"{MARK} {line}" for line in lines)
    meant = {p.name: f"  {MARK} [{p.unit}] {_meaning(p)}".rstrip() for p in snippet.parameters}
    code: list[str] = []
    for line in snippet.source.strip().split("\n"):
        found = _PARAMETER.fullmatch(line)
        code.append(line + meant.pop(found[1], "") if found else line)
    return f"{header}\n\n" + "\n".join(code) + "\n"


def wordings_text(wordings: Iterable[str]) -> str:
    """Wordings as the text of a file that `read_wordings` reads."""
    return "".join(f"{_printable(text)}\n" for text in wordings)


def _meaning(parameter: ParameterRange) -> str:
    return _printable(parameter.meaning).replace(MARK, "")


def _toml(value: object) -> str:
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, tuple):
        return f"[{', '.join(map(_toml, value))}]"
    return str(value) if isinstance(value, int) else _quoted(str(value))


def _printable(text: str) -> str:
    return "".join(c for c in text if c.isprintable())


def _quoted(text: str) -> str:
    """A text as TOML; what cannot be printed is left out, so that no line can begin within it."""
    return json.dumps(_printable(text), ensure_ascii=False)
