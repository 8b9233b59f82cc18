"""A model that says what it was given to say, for tests and for repeating a session without a model."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from chatscene.errors import LanguageModelError, SettingsError
from chatscene.files.bounded import parse_json
from chatscene.models.language.completion import FREE, Completion, JsonSchema, Message
from chatscene.models.language.protocol import Limits

Script = Sequence[Any] | Mapping[str, Any]


class Scripted:
    """Replies from a script.

    A list is said in order, whatever is asked. A mapping answers by the user's text; where its value is a list, the
    first is said first and the next when the question is asked again. What is not a string is said as JSON. Words
    count as tokens.
    """

    price = FREE

    def __init__(self, script: Script, *, name: str = "scripted") -> None:
        self.name = name
        digest = hashlib.sha256(json.dumps(script, sort_keys=True).encode()).hexdigest()
        self.identity: Mapping[str, str | int | float] = {"model": "scripted", "sha256": digest}
        self.asked: list[tuple[Message, ...]] = []
        self._script = script

    def complete(self, messages: Sequence[Message], schema: JsonSchema) -> Completion:  # noqa: ARG002 - it need not fit
        """Say the next line.

        Raises:
            LanguageModelError: The script has none.
        """
        self.asked.append(tuple(messages))
        reply = self._next_line(messages)
        text = reply if isinstance(reply, str) else json.dumps(reply)
        words_in = sum(len(m.text.split()) for m in messages)
        return Completion(text=text, tokens_in=words_in, tokens_out=len(text.split()))

    def _next_line(self, messages: Sequence[Message]) -> Any:
        if not isinstance(self._script, Mapping):
            return self._line(self._script, len(self.asked) - 1)
        users = [m.text for m in messages if m.role == "user"]
        for asked_again, text in enumerate(reversed(users)):
            if text in self._script:
                lines = self._script[text]
                return self._line(lines, asked_again) if isinstance(lines, list) else lines
        raise LanguageModelError(f"{self.name} has no reply to {users[-1]!r}; add one to the script")

    def _line(self, lines: Sequence[Any], number: int) -> Any:
        if number < len(lines):
            return lines[number]
        raise LanguageModelError(f"{self.name} has {len(lines)} replies and was asked for one more; add one")


def from_file(path: str, *, limits: Limits) -> Scripted:  # noqa: ARG001 - every model is made in the same way
    """A script from a JSON file that holds a list or a mapping.

    Raises:
        SettingsError: The file cannot be read, or holds something else.
    """
    try:
        script = parse_json(Path(path).read_text(encoding="utf-8"))
    except OSError as error:
        raise SettingsError(f"cannot read the script {path}: {error.strerror or error}") from error
    except ValueError as error:
        raise SettingsError(f"the script {path} is not valid JSON: {error}") from error
    if not isinstance(script, list | dict):
        raise SettingsError(f"the script {path} must hold a list of replies, or a mapping from texts to replies")
    return Scripted(script, name=f"scripted:{path}")
