"""XML that a stranger wrote, within bounds: no document type, no entities, nothing that leads out of the file."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from xml.parsers import expat

from chatscene.errors import ScenarioError

LARGEST = 8 * 2**20  # [bytes]
DEEPEST = 60
MOST = 200_000  # elements
LONGEST = 10_000  # characters of an attribute
_BUILT_IN = "&lt; &gt; &amp; &quot; &apos;"


class TooMany(ScenarioError):  # noqa: N818 - reads as what it says
    """A file has more elements than are read."""


@dataclass(frozen=True, slots=True)
class Element:
    """An element of XML.

    Attributes:
        file: The name of the file that it stands in; empty for the file that was asked for.
    """

    tag: str
    attributes: Mapping[str, str]
    line: int
    inside: list[Element] = field(default_factory=list["Element"])
    file: str = ""

    @property
    def where(self) -> str:
        """Its file, where that is another than the one that was asked for, and its line."""
        return f"{self.file}, line {self.line}" if self.file else f"line {self.line}"

    def all(self, tag: str) -> list[Element]:
        """The elements of a name directly in it."""
        return [one for one in self.inside if one.tag == tag]

    def find(self, *tags: str) -> Element | None:
        """The first element on a path of names; None if there is none."""
        one: Element | None = self
        for tag in tags:
            one = next((below for below in one.inside if below.tag == tag), None) if one else None
        return one

    def walk(self) -> Iterator[Element]:
        """It and everything in it."""
        waiting: list[Element] = [self]
        while waiting:
            yield (one := waiting.pop())
            waiting.extend(reversed(one.inside))


def read_xml(path: Path, *, file: str = "", most: int = MOST) -> Element:
    """The root of a file of XML.

    Raises:
        ScenarioError: It cannot be read, is not XML, or is larger, deeper or more than an XML file of a scenario is.
    """
    try:
        if not path.is_file():
            raise ScenarioError(f"there is no file {path}; give an .xosc file")
        with path.open("rb") as opened:
            content = opened.read(LARGEST + 1)
    except OSError as error:
        raise ScenarioError(f"{path} cannot be read: {error.strerror}") from error
    if len(content) > LARGEST:
        raise ScenarioError(f"{path} has more than {LARGEST // 2**20} MB, and a scenario has less; cut it down")
    try:
        return _Reader(path, file, most).root(content)
    except expat.ExpatError as error:
        raise ScenarioError(f"{path} is not complete XML: {error}; export it again") from error
    except (ValueError, LookupError) as error:
        raise ScenarioError(f"{path} is not XML in an encoding that is known: {error}; save it as UTF-8") from error


class _Reader:
    """Expat, told to stop at whatever is not plain elements."""

    def __init__(self, path: Path, file: str, most: int) -> None:
        self._path, self._file, self._most, self._count = path, file, most, 0
        self._open: list[Element] = []
        self._root: Element | None = None
        self._parser = expat.ParserCreate()
        self._parser.StartDoctypeDeclHandler = self._doctype
        self._parser.EntityDeclHandler = self._doctype
        self._parser.StartElementHandler = self._start
        self._parser.EndElementHandler = lambda _: self._open.pop()

    def root(self, content: bytes) -> Element:
        """The root of a text."""
        self._parser.Parse(content, True)
        assert self._root is not None
        return self._root

    def _refuse(self, why: str) -> None:
        raise ScenarioError(f"{self._path}, {self._line}: {why}")

    @property
    def _line(self) -> str:
        return f"line {self._parser.CurrentLineNumber}"

    def _doctype(self, *_: object) -> None:
        self._refuse(f"it declares a document type, and with it entities; leave that out, {_BUILT_IN} need none")

    def _start(self, tag: str, attributes: dict[str, str]) -> None:
        self._count += 1
        if self._count > self._most:
            raise TooMany(f"{self._path}, {self._line}: it has more than {self._most} elements; a scenario has less")
        if len(self._open) >= DEEPEST:
            self._refuse(f"elements lie more than {DEEPEST} deep in one another; a scenario's do not")
        if any(len(value) > LONGEST for value in attributes.values()):
            self._refuse(f"an attribute of <{tag[:40]}> has more than {LONGEST} characters")
        one = Element(tag.rpartition(":")[2], attributes, self._parser.CurrentLineNumber, file=self._file)
        if self._open:
            self._open[-1].inside.append(one)
        else:
            self._root = one
        self._open.append(one)
