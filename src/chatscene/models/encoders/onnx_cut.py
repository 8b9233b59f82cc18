"""An ONNX file cut into parts, so that encoders of which only the upper layers differ share the lower ones.

Only the framing of the file is read, its nodes' and arrays' names and where they lie (github.com/onnx/onnx,
``onnx.proto``; protobuf's wire format); the package that knows all of it is not needed to run a model. The file is one
whose checksum is pinned, so nothing in it is guarded against.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import DTypeLike, NDArray

_GRAPH = 7  # of a model
_NODE, _ARRAY, _INPUT, _OUTPUT, _BETWEEN = 1, 5, 11, 12, 13  # of a graph
_READS, _WRITES = 1, 2  # of a node
_VALUE_NAME, _ARRAY_NAME, _NUMBERS = 1, 8, 9
_VARINT, _SIZED = 0, 2  # kinds of fields
_FIXED = {1: 8, 5: 4}  # bytes of the other kinds


class _Field(NamedTuple):
    """A field of a message: where it stands in the file, and from where on its value does."""

    number: int
    start: int
    value: int
    end: int


@dataclass(frozen=True, slots=True)
class _Node:
    field: _Field
    reads: tuple[str, ...]
    writes: tuple[str, ...]


class OnnxFile:
    """The content of an ONNX file, of which parts can be cut out."""

    def __init__(self, content: bytes) -> None:
        """Look through the framing."""
        self._content = content
        self._beside = b""  # what the model says besides its graph
        self._nodes: list[_Node] = []
        self._arrays: dict[str, _Field] = {}
        self._values: dict[str, _Field] = {}  # type and shape of what nodes write
        self._inputs: dict[str, _Field] = {}
        for field in _fields(content, 0, len(content)):
            if field.number == _GRAPH:
                self._look_through(field)
            else:
                self._beside += content[field.start : field.end]

    def _look_through(self, graph: _Field) -> None:
        for field in _fields(self._content, graph.value, graph.end):
            if field.number == _NODE:
                self._nodes.append(_Node(field, *self._texts(field, _READS, _WRITES)))
            elif field.number == _ARRAY:
                self._arrays[self._texts(field, _ARRAY_NAME)[0][0]] = field
            elif field.number == _INPUT:
                self._inputs[self._texts(field, _VALUE_NAME)[0][0]] = field
            elif field.number in (_OUTPUT, _BETWEEN):
                self._values[self._texts(field, _VALUE_NAME)[0][0]] = field

    def _texts(self, message: _Field, *numbers: int) -> list[tuple[str, ...]]:
        """The texts in some fields of a message, those of each number by themselves."""
        fields = [one for one in _fields(self._content, message.value, message.end) if one.number in numbers]
        texts = [(one.number, str(self._content[one.value : one.end], "utf-8")) for one in fields]
        return [tuple(text for of, text in texts if of == number) for number in numbers]

    def array(self, name: str, dtype: DTypeLike) -> NDArray[Any]:
        """The numbers of an array of the file, in one row; they are not copied."""
        whole = self._arrays[name]
        numbers = next(one for one in _fields(self._content, whole.value, whole.end) if one.number == _NUMBERS)
        count = (numbers.end - numbers.value) // np.dtype(dtype).itemsize
        return np.frombuffer(self._content, dtype, count, numbers.value)

    def within(self, wanted: str, given: Collection[str], changes: Mapping[int, bytes]) -> bool:
        """Whether all changes are of the arrays of a part; see `part`."""
        fields = self._needed(wanted, given)[1]
        return all(any(field.value <= at < field.end for field in fields) for at in changes)

    def _needed(self, wanted: str, given: Collection[str]) -> tuple[list[_Field], list[_Field], set[str]]:
        """The nodes that make a value out of others, the last first, their arrays, and the values that they need."""
        needed, nodes = {wanted}, list[_Field]()
        for node in reversed(self._nodes):
            if not needed.isdisjoint(node.writes) and not all(name in given for name in node.writes):
                nodes.append(node.field)
                needed.update(node.reads)
        return nodes, [field for name, field in self._arrays.items() if name in needed], needed

    def part(self, wanted: str, given: Collection[str] = (), changes: Mapping[int, bytes] | None = None) -> bytes:
        """The part of the graph that makes one value out of others, as an ONNX file of its own.

        The values at its ends keep type and shape, so that it is optimized as it is within the whole and gives the
        same numbers to the last bit.

        Args:
            wanted: The value that it puts out.
            given: Values that it takes in instead of making them; inputs of the whole are taken in as they are.
            changes: What to add to the bytes of the whole file, modulo 256, by where they stand.

        Raises:
            ValueError: A change is not of an array of this part.
        """
        nodes, arrays, needed = self._needed(wanted, given)
        kept = [bytes(self._content[field.start : field.end]) for field in reversed(nodes)]
        kept += _changed(self._content, arrays, changes or {})
        kept += [self._content[field.start : field.end] for name, field in self._inputs.items() if name in needed]
        for name, field in self._values.items():
            value = self._content[field.value : field.end]
            if name in given:
                kept.append(_sized(_INPUT, value))
            elif name == wanted:
                kept.append(_sized(_OUTPUT, value))
            elif name in needed:
                kept.append(_sized(_BETWEEN, value))
        kept.append(_sized(2, b"part"))  # a graph has a name
        return self._beside + _sized(_GRAPH, b"".join(kept))


def _changed(content: bytes, fields: list[_Field], changes: Mapping[int, bytes]) -> list[bytes]:
    """Some fields of a file, with what is added to their bytes."""
    open_changes, kept = dict(changes), list[bytes]()
    for field in fields:
        numbers = np.frombuffer(content, np.uint8)[field.start : field.end].copy()
        for at in [at for at in open_changes if field.value <= at < field.end]:
            difference = np.frombuffer(open_changes.pop(at), np.uint8)
            numbers[at - field.start :][: len(difference)] += difference  # raises ValueError if it reaches beyond
        kept.append(numbers.tobytes())
    if open_changes:
        raise ValueError("it changes layers that all encoders share")
    return kept


def _fields(content: bytes, at: int, end: int) -> Iterator[_Field]:
    """The fields of a message, one after another."""
    while at < end:
        start, key, at = at, content[at], at + 1
        if key >= 0x80:  # a number of more than one byte, as few are
            key, at = _varint(content, start)
        kind = key & 7
        if kind == _SIZED:
            size, at = content[at], at + 1
            if size >= 0x80:
                size, at = _varint(content, at - 1)
        elif kind == _VARINT:
            size = _varint(content, at)[1] - at
        else:
            size = _FIXED[kind]
        yield _Field(key >> 3, start, at, at + size)
        at += size


def _varint(content: bytes, at: int) -> tuple[int, int]:
    """A number of as many bytes as it needs, and where it ends."""
    number = shift = 0
    while True:
        byte = content[at]
        number |= (byte & 0x7F) << shift
        at, shift = at + 1, shift + 7
        if byte < 0x80:
            return number, at


def _sized(number: int, value: bytes) -> bytes:
    """A field that says how long it is."""
    return _as_varint(number << 3 | _SIZED) + _as_varint(len(value)) + value


def _as_varint(number: int) -> bytes:
    found = bytearray()
    while number >= 0x80:
        found.append(number & 0x7F | 0x80)
        number >>= 7
    return bytes((*found, number))
