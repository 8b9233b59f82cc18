"""Files of situations, in YAML or JSON: each fault is told with its line."""

from __future__ import annotations

from contextlib import suppress
from pathlib import Path
from typing import Any, cast

import yaml

from chatscene.errors import SituationError
from chatscene.files.bounded import check_file, parse_json
from chatscene.situations.faults import Fault, Malformed, by_name, listed
from chatscene.situations.faults import Path as Place
from chatscene.situations.form import parsed, to_plain
from chatscene.terms.situation import Situation

MOST_BYTES = 2**20
SHORT = "others: [{id: A, kind: car, starts: {where: ahead}, does: [{act: brake}]}]"  # the file of a situation
_PLAIN = ("tag:yaml.org,2002:map", "tag:yaml.org,2002:seq")
MOST_NODES = 20_000  # of a file: names for what stands elsewhere could make a short one endless


def read_file(file: Path) -> Situation:
    """The situation in a file.

    Raises:
        SituationError: It cannot be read, or is none; the message lists each fault with its line.
    """
    try:
        check_file(file)
        with file.open("rb") as stream:
            raw = stream.read(MOST_BYTES + 1)
    except OSError as error:
        raise SituationError(f"{file}: {error.strerror or error}") from error
    except ValueError as error:
        raise SituationError(f"{file}: {error}") from error
    if len(raw) > MOST_BYTES:
        raise SituationError(f"{file} has more than {MOST_BYTES // 2**20} MB; a situation is a page of text")
    try:
        text = raw.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise SituationError(f"{file} is not UTF-8 text: {error.reason} at byte {error.start}") from error
    return read_text(text, str(file))


def read_text(text: str, called: str = "the situation") -> Situation:
    """The situation that a text in YAML or JSON says.

    Raises:
        SituationError: It is none; the message lists each fault with its line.
    """
    lines: dict[Place, int] = {}
    written: object = None
    try:
        written = _plain(text, lines)
        if written is None:
            raise SituationError(f"{called} is empty; write a situation, such as: {SHORT}")
        return parsed(written)
    except yaml.MarkedYAMLError as error:
        at = error.problem_mark or error.context_mark
        line = f", line {at.line + 1}" if at else ""
        raise SituationError(
            f"{called}{line}: {error.problem or error.context}; it is neither YAML nor JSON"
        ) from error
    except yaml.YAMLError as error:
        raise SituationError(f"{called} is neither YAML nor JSON: {error}") from error
    except Malformed as error:
        told = (
            f"line {_line(one.path, lines)}, {at}: {said}" if at else said
            for one, (at, said) in zip(error.faults, by_name(written, error.faults), strict=True)
        )
        raise SituationError(listed(called, told)) from error


def to_yaml(situation: Situation) -> str:
    """A situation as a file of YAML has it."""
    return yaml.safe_dump(to_plain(situation), sort_keys=False, allow_unicode=True, width=100)


def _line(path: Place, lines: dict[Place, int]) -> int:
    """The line of what is nearest above a path, if not of itself."""
    while path and path not in lines:
        path = path[:-1]
    return lines.get(path, 1)


def _plain(text: str, lines: dict[Place, int]) -> object:
    """The plain values of a text, and on which line each begins."""
    loader = yaml.SafeLoader(text)
    try:
        node = loader.get_single_node()
        return None if node is None else _value(loader, node, (), lines)
    except RecursionError:
        raise Malformed([Fault((), "it is nested too deeply, or in itself")]) from None
    except yaml.MarkedYAMLError:
        with suppress(ValueError):
            return parse_json(text)  # which YAML does not read where it is indented with tabs
        raise
    except ValueError as error:  # such as a date of no calendar
        raise Malformed([Fault((), str(error))]) from error
    finally:
        loader.dispose()


def _value(loader: Any, node: yaml.Node, path: Place, lines: dict[Place, int]) -> object:
    if len(lines) > MOST_NODES:
        raise Malformed([Fault((), f"it has more than {MOST_NODES:,} values; a situation is a page of text")])
    lines[path] = node.start_mark.line + 1
    if not isinstance(node, yaml.ScalarNode) and node.tag not in _PLAIN:
        raise Malformed([Fault(path, f"{node.tag!r} has no meaning in a situation")])
    if isinstance(node, yaml.SequenceNode):
        return [_value(loader, one, (*path, i), lines) for i, one in enumerate(node.value)]
    if not isinstance(node, yaml.MappingNode):
        return loader.construct_object(node)
    made: dict[object, object] = {}
    for key_node, value_node in cast("list[tuple[yaml.Node, yaml.Node]]", node.value):
        key = cast("object", key_node.value) if isinstance(key_node, yaml.ScalarNode) else None
        if not isinstance(key, str):
            raise Malformed([Fault(path, "a name is a word, not a list or a mapping")])
        at = (*path, key)
        if key in made:
            lines[at] = key_node.start_mark.line + 1
            raise Malformed([Fault(at, f"{key!r} is here twice")])
        made[key] = _value(loader, value_node, at, lines)
        lines[at] = key_node.start_mark.line + 1
    return made
