"""JSON for a person to read, as `json.dumps` writes it with an indent: that is Python's own, slow loop."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from json.encoder import encode_basestring
from math import isfinite
from typing import Any, cast


def indented(content: object) -> str:
    """The same text as ``json.dumps(content, indent=1, ensure_ascii=False)``, of data without a circle."""
    return _written(content, "\n")


def _written(value: object, line: str) -> str:
    """A value, and what begins the line on which it ends."""
    if type(value) is str:
        return encode_basestring(value)
    if not isinstance(value, dict | list | tuple):
        return json.dumps(value, ensure_ascii=False)
    inner = f"{line} "
    if isinstance(value, dict):
        members = cast("Mapping[Any, object]", value).items()
        parts = [f"{_name(name)}: {_written(member, inner)}" for name, member in members]
        return f"{{{inner}{f',{inner}'.join(parts)}{line}}}" if parts else "{}"
    if not value:
        return "[]"
    values = cast("Sequence[object]", value)
    if {*map(type, values)} == {float} and all(map(isfinite, cast("Sequence[float]", values))):
        parts = map(repr, values)
    else:
        parts = (_written(one, inner) for one in values)
    return f"[{inner}{f',{inner}'.join(parts)}{line}]"


def _name(name: object) -> str:
    """The name of a member, which JSON has as text."""
    return encode_basestring(name) if isinstance(name, str) else json.dumps({name: 0})[1:-4]
