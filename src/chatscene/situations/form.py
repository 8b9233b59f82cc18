"""The form in which situations are written: plain values, as JSON and YAML have them, and the schema of these."""

from __future__ import annotations

import inspect
import re
from collections.abc import Iterator, Mapping
from dataclasses import fields, is_dataclass
from functools import cache
from typing import Any, cast

from pydantic import TypeAdapter, ValidationError

from chatscene.errors import SituationError
from chatscene.situations.check import faults_of
from chatscene.situations.faults import Fault, Malformed, Path, by_name, listed
from chatscene.terms import situation as nouns
from chatscene.terms.pointing import meant
from chatscene.terms.situation import VERSION, Situation


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
        raise Malformed([Fault(("version",), f"{version!r} is of another chatscene; this one reads version {VERSION}")])
    try:
        situation = _form().validate_python(written)
    except ValidationError as error:
        raise Malformed(_faults(error)) from error
    if faults := tuple(faults_of(situation)):
        raise Malformed(faults)
    return situation


def to_plain(situation: Situation) -> dict[str, Any]:
    """The plain values of a situation; what was not said is left out."""
    return {"version": situation.version, **_form().dump_python(situation, mode="json", exclude_defaults=True)}


def schema() -> dict[str, Any]:
    """The JSON schema (2020-12) of written situations, each word and field with what it means."""
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
        given, context = one["input"], one.get("ctx", {})
        match one["type"]:
            case "unexpected_keyword_argument" | "extra_forbidden":
                yield Fault(
                    path, f"there is no {path[-1]!r} here{meant(str(path[-1]), _fields_at(path[:-1]), alike=0.6)}"
                )
            case "missing" | "missing_argument" | "missing_keyword_only_argument":
                yield Fault(path, "is missing")
            case "enum":
                words = re.findall(r"'([^']*)'", str(context["expected"]))
                yield Fault(path, f"{given!r} is none of {', '.join(words)}{meant(str(given), words, alike=0.6)}")
            case "value_error":
                yield Fault(path, str(context["error"]))
            case "dataclass_type":
                yield Fault(path, f"{given!r} is no mapping; write one with {', '.join(_fields_at(path))}")
            case "tuple_type":
                yield Fault(path, "a list stands here, as in [a, b]")
            case _:
                yield Fault(path, f"{given!r}: {one['msg'][0].lower()}{one['msg'][1:]}")


def _fields_at(path: Path) -> tuple[str, ...]:
    """The fields of the noun at a path."""
    noun: Any = Situation
    for step in path:
        if isinstance(step, str) and is_dataclass(noun):
            hint = str({one.name: one.type for one in fields(noun)}.get(step, ""))
            names = [name for name in re.findall(r"\w+", hint) if is_dataclass(getattr(nouns, name, None))]
            noun = getattr(nouns, names[0]) if names else None
    return tuple(one.name for one in fields(noun)) if noun is not None else ()


@cache
def _documented(noun: type[Any]) -> tuple[str, Mapping[str, str]]:
    """What a noun's docstring says of it, and of each of its fields."""
    said = inspect.getdoc(noun) or ""
    head, _, attributes = said.partition("Attributes:\n")
    meanings: dict[str, str] = {}
    for name, meaning in re.findall(r"^    (\w+): (.*(?:\n {8}.*)*)", attributes, re.MULTILINE):
        meanings[name] = " ".join(meaning.split()).replace("``", "`")
    return " ".join(head.split()), meanings
