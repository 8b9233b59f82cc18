"""Replies on disk, each in a file that is named by a hash of the question.

A cache that is missing, damaged or cannot be written costs calls and nothing else.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping, Sequence
from pathlib import Path

from pydantic import BaseModel, ConfigDict, ValidationError

from chatscene.files.caches import keep
from chatscene.models.language.completion import JsonSchema, Message

FORMAT = 1  # part of every key: raise it when a question is put in other words for the same prompt


class _Entry(BaseModel):
    model_config = ConfigDict(strict=True, extra="forbid")

    key: str
    text: str
    sha256: str


def question_key(identity: Mapping[str, str | int | float], messages: Sequence[Message], schema: JsonSchema) -> str:
    """The address of a question: SHA-256 of the model, its address and parameters, the prompt and the schema."""
    question = [FORMAT, dict(identity), [[m.role, m.text] for m in messages], schema]
    return _sha256(json.dumps(question, sort_keys=True))


def read_reply(folder: Path, key: str) -> str | None:
    """The reply to a question, or None where there is none that is whole."""
    try:
        entry = _Entry.model_validate_json((folder / f"{key}.json").read_bytes())
    except (OSError, ValidationError):
        return None
    return entry.text if entry.key == key and entry.sha256 == _sha256(entry.text) else None


def write_reply(folder: Path, key: str, text: str) -> None:
    """Keep a reply, under its name only when it is whole."""
    entry = _Entry(key=key, text=text, sha256=_sha256(text))
    keep(folder / f"{key}.json", entry.model_dump_json().encode())


def _sha256(text: str) -> str:
    return hashlib.sha256(text.encode()).hexdigest()
