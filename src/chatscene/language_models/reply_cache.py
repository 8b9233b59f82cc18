"""Replies on disk, each in a file that is named by a hash of the question.

A cache that is missing, damaged or cannot be written costs calls and nothing else.
"""

from __future__ import annotations

import contextlib
import hashlib
import json
import os
import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path

from pydantic import BaseModel, ConfigDict, ValidationError

from chatscene.language_models.completion import JsonSchema, Message

FORMAT = 1  # part of every key: raise it when a question is put in other words for the same prompt


class _Entry(BaseModel):
    model_config = ConfigDict(strict=True, extra="forbid")

    key: str
    text: str
    sha256: str


def user_folder() -> Path:
    """Where replies are kept unless a user says otherwise."""
    base = os.environ.get("XDG_CACHE_HOME")
    return (Path(base) if base else Path.home() / ".cache") / "chatscene" / "replies"


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
    with contextlib.suppress(OSError):  # a read-only or full home must not stop a run
        folder.mkdir(parents=True, exist_ok=True)
        with tempfile.NamedTemporaryFile("w", dir=folder, suffix=".part", delete=False, encoding="utf-8") as part:
            path = Path(part.name)
            try:
                part.write(entry.model_dump_json())
                part.close()
                path.replace(folder / f"{key}.json")
            finally:
                path.unlink(missing_ok=True)


def _sha256(text: str) -> str:
    return hashlib.sha256(text.encode()).hexdigest()
