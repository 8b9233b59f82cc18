"""The form in which situations are written: plain values, as JSON and YAML have them, and the schema of these."""

from __future__ import annotations

import inspect
import re
from collections.abc import Callable, Iterator, Mapping
from copy import deepcopy
from dataclasses import MISSING, Field, fields, is_dataclass
from enum import Enum
from functools import cache
from types import NoneType, UnionType
from typing import TYPE_CHECKING, Any, Union, cast, get_args, get_origin, get_type_hints

from chatscene.errors import SituationError
from chatscene.situations.check import faults_of
from chatscene.situations.faults import Fault, Malformed, Path, by_name, listed
from chatscene.situations.meant import field_meant, fields_at, word_meant, words_at
from chatscene.terms import situation as nouns
from chatscene.terms.amount import Amount
from chatscene.terms.situation import VERSION, Situation

if TYPE_CHECKING:
    from pydantic import TypeAdapter, ValidationError


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


def from_plain(written: object) -> Situation:
    """A situation of plain values.

    Raises:
        SituationError: It is none; the message lists every fault with its path.
    """
    try:
        return parsed(written)
    except Malformed as error:
        told = (f"{at}: {said}" if at else said for at, said in by_name(written, error.faults))
        raise SituationError(listed("the situation", told)) from error


def parsed(written: object) -> Situation:
    """A situation of plain values.

    Raises:
        Malformed: It is none.
    """
    if not isinstance(written, Mapping):
        raise Malformed([Fault((), "a situation is a mapping, with ego, road and others")])
    version = cast("Mapping[str, Any]", written).get("version", VERSION)
    if type(version) is not int or version != VERSION:
        raise Malformed(
            [Fault(("version",), f"version {version!r} is from another chatscene; this one reads version {VERSION}")]
        )
    try:
        situation = situation_in(cast("Mapping[str, Any]", written))
    except NotPlain:
        situation = _validated(written)
    if faults := tuple(faults_of(situation)):
        raise Malformed(faults)
    return situation


def to_plain(situation: Situation) -> dict[str, Any]:
    """The plain values of a situation; what was not said is left out."""
    return {"version": situation.version, **plain(situation)}


def _validated(written: object) -> Situation:
    """The situation of what is not plain to the last value, or what is wrong with it."""
    from pydantic import ValidationError

    try:
        return _form().validate_python(written)
    except ValidationError as error:
        raise Malformed(_faults(error)) from error


def schema() -> dict[str, Any]:
    """The JSON schema (2020-12) of written situations, each word and field with what it means."""
    return deepcopy(_schema())


@cache
def _schema() -> dict[str, Any]:
    made = _form().json_schema()
    described = {name: noun for name, noun in vars(nouns).items() if inspect.isclass(noun) and is_dataclass(noun)}
    for name, part in ((Situation.__name__, made), *made["$defs"].items()):
        if name not in described:
            continue  # a table of words, which says itself what they mean
        part["description"], meanings = _documented(described[name])
        for field, property_ in part["properties"].items():
            property_.pop("title", None)
            property_["description"] = meanings[field]
    return {"$schema": "https://json-schema.org/draft/2020-12/schema", **made}


_EITHER = "function-plain[of()]"  # what pydantic calls each kind of amount that one may be of


@cache
def _form() -> TypeAdapter[Situation]:
    from pydantic import TypeAdapter

    return TypeAdapter(Situation)


def _faults(error: ValidationError) -> Iterator[Fault]:
    told: set[Path] = set()
    for one in error.errors(include_url=False):
        path: Path = one["loc"]
        if one["type"] == "value_error" and path[-1] == _EITHER:
            path = path[:-1]
        if path in told and one["type"] == "value_error":
            continue  # of each kind of amount that it might have been
        told.add(path)
        yield Fault(path, _said(one, path))


def _said(one: Any, path: Path) -> str:  # noqa: PLR0911
    """What is wrong, by what pydantic says of it."""
    given, context = one["input"], one.get("ctx", {})
    match str(one["type"]).partition("_")[0]:
        case "int":
            return f"{given!r} is not a whole number; write one, as in 2"
        case "bool":
            return f"{given!r} is neither true nor false"
        case "string":
            return f"{given!r} is not text; write it in quotes"
        case "missing":
            words = words_at(path)
            return f"is missing; write one of {', '.join(words)}" if words else "is missing"
        case "enum":
            words = re.findall(r"'([^']*)'", str(context["expected"]))
            return f"{given!r} is none of {', '.join(words)}{word_meant(str(given), words)}"
        case "value":
            return str(context["error"])
        case "dataclass":
            return f"{given!r} is not a mapping; write one with {', '.join(fields_at(path))}"
        case "tuple":
            return "a list stands here, as in [a, b]"
        case "unexpected" | "extra":
            return f"there is no {path[-1]!r} here{field_meant(str(path[-1]), path[:-1])}"
        case _:
            return f"{given!r}: {one['msg'][0].lower()}{one['msg'][1:]}"


@cache
def _documented(noun: type[Any]) -> tuple[str, Mapping[str, str]]:
    """What a noun's docstring says of it, and of each of its fields."""
    said = inspect.getdoc(noun) or ""
    head, _, attributes = said.partition("Attributes:\n")
    meanings: dict[str, str] = {}
    for name, meaning in re.findall(r"^    (\w+): (.*(?:\n {8}.*)*)", attributes, re.MULTILINE):
        meanings[name] = " ".join(meaning.split()).replace("``", "`")
    return " ".join(head.split()), meanings
