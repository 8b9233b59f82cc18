"""Situations and plain values, as far as nothing is amiss: what `chatscene.situations.form` does, without its library.

Values of exactly the types that are written are taken here. All others are left to pydantic, which knows what may be
meant by them and says what is wrong; to import it and to tell it of a situation takes a tenth of explaining a text.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import MISSING, Field, fields, is_dataclass
from enum import Enum
from functools import cache
from types import NoneType, UnionType
from typing import Any, Union, cast, get_args, get_origin, get_type_hints

from chatscene.terms.amount import Amount
from chatscene.terms.situation import Situation


class NotPlain(Exception):  # noqa: N818 - reads as what it says
    """A value is not of exactly the type that stands there."""


def plain(value: Any) -> Any:
    """A noun, or a part of one, as plain values; of a noun what is as usual is left out."""
    if isinstance(value, Amount):
        return str(value)
    if isinstance(value, Enum):
        return value.value
    if is_dataclass(value):
        told = ((one, getattr(value, one.name)) for one in fields(value))
        return {one.name: plain(said) for one, said in told if said != _usual(one)}
    if isinstance(value, tuple):
        return [plain(one) for one in cast("tuple[Any, ...]", value)]
    if isinstance(value, Mapping):
        return {name: plain(one) for name, one in cast("Mapping[str, Any]", value).items()}
    return value


def situation_in(written: Mapping[str, Any]) -> Situation:
    """The situation of plain values.

    Raises:
        NotPlain: It is another's to say what they are, or that they are none.
    """
    return _taker(Situation)(written)


def _usual(one: Field[Any]) -> Any:
    return one.default_factory() if one.default_factory is not MISSING else one.default


@cache
def _taker(kind: Any) -> Callable[[Any], Any]:
    """Takes a plain value for what a field is said to be."""
    origin, parts = get_origin(kind), get_args(kind)
    if origin in (Union, UnionType):
        return _of_one([_taker(part) for part in parts if part is not NoneType], empty=NoneType in parts)
    if origin is tuple:
        return _of_list(_taker(parts[0]))
    if origin is not None:  # a mapping of texts
        return _texts
    if kind in (str, int, bool):
        return _exactly(kind)
    if issubclass(kind, Enum | Amount):
        return _word_of(kind, kind.of if issubclass(kind, Amount) else kind)
    return _of_noun(kind)


def _of_one(takers: list[Callable[[Any], Any]], *, empty: bool) -> Callable[[Any], Any]:
    def take(value: Any) -> Any:
        if value is None and empty:
            return None
        found: list[Any] = []
        for one in takers:
            try:
                found.append(one(value))
            except NotPlain:
                continue
        if len(found) != 1:  # none, or one cannot tell which is meant
            raise NotPlain
        return found[0]

    return take


def _of_list(of_each: Callable[[Any], Any]) -> Callable[[Any], Any]:
    def take(value: Any) -> Any:
        if type(value) not in (list, tuple):
            raise NotPlain
        return tuple(of_each(one) for one in value)

    return take


def _texts(value: Any) -> Any:
    if type(value) is not dict or not all(type(one) is str for pair in value.items() for one in pair):
        raise NotPlain
    return dict(value)


def _exactly(kind: type[Any]) -> Callable[[Any], Any]:
    def take(value: Any) -> Any:
        if type(value) is not kind:
            raise NotPlain
        return value

    return take


def _word_of(kind: type[Any], make: Callable[[Any], Any]) -> Callable[[Any], Any]:
    def take(value: Any) -> Any:
        if type(value) is kind:
            return value
        if type(value) is not str:
            raise NotPlain
        try:
            return make(value)
        except ValueError as error:
            raise NotPlain from error

    return take


def _of_noun(noun: type[Any]) -> Callable[[Any], Any]:
    takers = {name: _taker(kind) for name, kind in _kinds(noun).items()}
    needed = {one.name for one in fields(noun) if _usual(one) is MISSING}

    def take(value: Any) -> Any:
        if not isinstance(value, Mapping):
            raise NotPlain
        told = cast("Mapping[str, Any]", value)
        if not needed <= told.keys() <= takers.keys():
            raise NotPlain
        return noun(**{name: takers[name](one) for name, one in told.items()})

    return take


def _kinds(noun: type[Any]) -> dict[str, Any]:
    hints = get_type_hints(noun)
    return {one.name: hints[one.name] for one in fields(noun)}
