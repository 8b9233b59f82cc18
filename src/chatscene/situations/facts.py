"""The facts of a situation by their paths, others by their ids: ``others.A.starts.side``."""

from __future__ import annotations

import re
from collections.abc import Container, Iterator, Mapping, Sequence
from dataclasses import fields, is_dataclass
from typing import Any, cast

from chatscene.situations.form import to_plain
from chatscene.terms.amount import Amount
from chatscene.terms.situation import Situation

NO_FACTS = frozenset(("version", "about", "map", "evidence"))
"""What a situation has beside facts."""
_NAMES = re.compile(rf"(?:^(?:{'|'.join(sorted(NO_FACTS))})(?:\..*)?|\.id|\.role)$")


def said_in(situation: Situation) -> Iterator[tuple[str, object]]:
    """Each fact of a situation by its path; an id and a role are none, as they are there wherever somebody is."""
    for path, value in _leaves(to_plain(situation), ()):
        if not _NAMES.search(path):
            yield path, value


def is_said(situation: Situation, path: str) -> bool:
    """Whether something stands at a path: a fact, or a whole with facts in it."""
    here: Any = situation
    for step in path.split("."):
        if isinstance(here, tuple):
            here = _in_list(cast("tuple[Any, ...]", here), step)
        else:
            here = getattr(here, step) if step in _fields(here) else None
    nothing = (None, ())
    return any(getattr(here, name) not in nothing for name in _fields(here)) if _fields(here) else here not in nothing


def within(path: str, wholes: Container[str]) -> bool:
    """Whether a path is one of some, or lies in one of them."""
    steps = path.split(".")
    return any(".".join(steps[: i + 1]) in wholes for i in range(len(steps)))


def _fields(noun: Any) -> frozenset[str]:
    """Where the parts of a noun stand; none of what is no noun."""
    if not is_dataclass(noun) or isinstance(noun, Amount):
        return frozenset()
    return frozenset(one.name for one in fields(noun)) - NO_FACTS


def _in_list(several: tuple[Any, ...], step: str) -> object:
    for one in several:
        if getattr(one, "id", None) == step:
            return one
    return several[int(step)] if step.isdecimal() and len(step) < 4 and int(step) < len(several) else None


def _leaves(value: object, path: tuple[str, ...]) -> Iterator[tuple[str, object]]:
    if isinstance(value, Mapping):
        for name, part in cast("Mapping[str, object]", value).items():
            yield from _leaves(part, (*path, name))
    elif isinstance(value, Sequence) and not isinstance(value, str):
        for i, part in enumerate(cast("Sequence[object]", value)):
            named = cast("Mapping[str, object]", part).get("id", i) if isinstance(part, Mapping) else i
            yield from _leaves(part, (*path, str(named)))
    else:
        yield ".".join(path), value
