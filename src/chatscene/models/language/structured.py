"""From a pydantic model to the schema a language model is given, and from what it writes to an object."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

from pydantic import BaseModel, ValidationError

from chatscene.models.language.completion import JsonSchema
from chatscene.models.language.protocol import Answer

LONGEST_REPLY = 200_000  # characters; no answer we ask for comes near
_MOST_OBJECTS = 20  # places in a reply at which an answer is looked for
_LONGEST_REASON = 1000  # characters of why a reply cannot be used
_NOT_IN_STRICT = ("default", "title")  # words that strict endpoints refuse or that only cost tokens


@dataclass(frozen=True, slots=True)
class Unusable:
    """Why a reply cannot be used, in words for the model and the user."""

    reason: str


def strict_schema(schema: type[BaseModel]) -> JsonSchema:
    """The JSON schema of a pydantic model in the form that strict endpoints take.

    Every object is closed and all its fields are required; a reference stands alone.
    """
    return _strict(schema.model_json_schema())


def _strict(node: Any) -> Any:
    if isinstance(node, list):
        return [_strict(item) for item in node]
    if not isinstance(node, dict):
        return node
    if "$ref" in node:
        return {"$ref": node["$ref"]}
    named = {key: {n: _strict(v) for n, v in node[key].items()} for key in ("properties", "$defs") if key in node}
    rest = {k: _strict(v) for k, v in node.items() if k not in named and k not in _NOT_IN_STRICT}
    closed = {"required": sorted(named["properties"]), "additionalProperties": False} if "properties" in named else {}
    return rest | named | closed


def instruction(schema: JsonSchema) -> str:
    """What a model is told when its endpoint does not hold it to the schema."""
    return "Reply with one JSON object and nothing else. It must fit this JSON schema:\n" + json.dumps(schema)


def read_answer(text: str, schema: type[Answer], check: Callable[[Answer], str] | None = None) -> Answer | Unusable:
    """The first object in a reply that fits `schema` and passes `check`, or why there is none.

    Text around it, code fences and a model's thoughts are passed over.
    """
    if len(text) > LONGEST_REPLY:
        return Unusable(f"the reply has {len(text)} characters, which is far too long")
    failure = Unusable("the reply holds no JSON object" if text.strip() else "the reply is empty")
    for candidate in _objects(after_thoughts(text)):
        try:
            answer = schema.model_validate_json(candidate)
        except ValidationError as error:
            failure = Unusable(_in_words(error))
            continue
        if not (wrong := check(answer) if check else ""):
            return answer
        failure = Unusable(printable(wrong, _LONGEST_REASON))
    return failure


def after_thoughts(text: str) -> str:
    """A reply without what a reasoning model thinks aloud before it."""
    return text.rpartition("</think>")[2]


def _objects(text: str) -> Iterator[str]:
    """The outermost JSON objects in a text; where there is a brace but no whole object, the text from there on."""
    decoder = json.JSONDecoder()
    start, broken = text.find("{"), True
    first = start
    for _ in range(_MOST_OBJECTS):
        if start < 0:
            break
        try:
            end = decoder.raw_decode(text, start)[1]
        except (ValueError, RecursionError):
            end = start + 1
        else:
            broken = False
            yield text[start:end]
        start = text.find("{", end)
    if broken and first >= 0:
        yield text[first:]


def _in_words(error: ValidationError) -> str:
    """The first faults of a reply, without its contents."""
    faults = error.errors(include_url=False, include_context=False, include_input=False)
    said = [f"{'.'.join(map(str, f['loc'])) or 'the object'}: {f['msg']}" for f in faults[:5]]
    return printable("; ".join(said), _LONGEST_REASON)


def printable(text: str, longest: int) -> str:
    """A stranger's words on one line, cut, without what could steer a terminal."""
    return "".join(c for c in " ".join(text.split()) if c.isprintable())[:longest]
