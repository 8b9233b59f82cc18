"""A language model whose replies are validated, asked for again, cached and counted."""

from __future__ import annotations

import hashlib
import json
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from pydantic import BaseModel, ConfigDict, ValidationError

from chatscene.errors import NoUsableReply
from chatscene.files.caches import keep
from chatscene.models.language.completion import Completer, Completion, JsonSchema, Message
from chatscene.models.language.protocol import Answer, Limits, Prompt, Reply, Spending
from chatscene.models.language.structured import Unusable, instruction, read_answer, strict_schema

_TOKENS_PER_TURN = 16  # more than any chat template adds to one turn
_TOKENS_PER_CHAT = 64  # nor does one add more than this to the whole
_SHOWN_AGAIN = 2000  # characters of a wrong reply that are shown to the model again


class CheckedModel:
    """The `LanguageModel` that any `Completer` becomes. Not for several threads at once: its counters have no lock."""

    def __init__(self, completer: Completer, *, limits: Limits, cache: Path | None = None) -> None:
        self.name = completer.name
        self._completer, self._limits, self._cache = completer, limits, cache
        self._spending = Spending(dollars=None if completer.price is None else 0.0)

    @property
    def identity(self) -> Mapping[str, str | int | float]:
        """All that decides a reply besides the question."""
        return self._completer.identity

    @property
    def spending(self) -> Spending:
        """What it has cost so far."""
        return self._spending

    def reply(
        self, prompt: Prompt, schema: type[Answer], *, check: Callable[[Answer], str] | None = None
    ) -> Reply[Answer]:
        """Answer from the cache, or ask and ask again with the reason, `Limits.reasks` times.

        Raises:
            LanguageModelError: No reply, or none that fits the schema and passes the check.
        """
        begun, before = time.monotonic(), self._spending
        wanted, messages = strict_schema(schema) if prompt.form is None else dict(prompt.form), _conversation(prompt)
        key = question_key(self.identity, messages, wanted)
        kept = read_reply(self._cache, key) if self._cache else None
        if kept is not None and not isinstance(answer := read_answer(kept, schema, check), Unusable):
            self._spending = replace(before, from_cache=before.from_cache + 1)
            return self._reply(answer, before, begun)
        reason = ""
        for _ in range(1 + self._limits.reasks):
            completion = self._call(messages, wanted)
            answer = read_answer(completion.text, schema, check)
            if not isinstance(answer, Unusable):
                if self._cache:
                    write_reply(self._cache, key, completion.text)
                return self._reply(answer, before, begun)
            reason = _cut_reason(self._limits) if completion.cut else answer.reason
            messages = [*messages, *_ask_again(completion.text, reason, wanted if prompt.form is None else None)]
        raise NoUsableReply(
            f"{self.name} gave no usable reply in {1 + self._limits.reasks} attempts; the last one: {reason}. "
            "Try again with a larger model"
        )

    def _call(self, messages: Sequence[Message], schema: JsonSchema) -> Completion:
        most_in = _most_tokens(messages, schema)
        begun = time.monotonic()
        self._spending = replace(self._spending, calls=self._spending.calls + 1)
        try:
            completion = self._completer.complete(messages, schema)
        finally:
            self._spending = replace(self._spending, seconds=self._spending.seconds + time.monotonic() - begun)
        tokens_in = most_in if completion.tokens_in is None else completion.tokens_in
        tokens_out = len(completion.text.encode()) if completion.tokens_out is None else completion.tokens_out
        spent, price = self._spending, self._completer.price
        self._spending = replace(
            spent,
            tokens_in=spent.tokens_in + tokens_in,
            tokens_out=spent.tokens_out + tokens_out,
            dollars=None if price is None else (spent.dollars or 0.0) + price.of(tokens_in, tokens_out),
        )
        return completion

    def _reply(self, answer: Answer, before: Spending, begun: float) -> Reply[Answer]:
        now = self._spending
        return Reply(
            answer=answer,
            tokens_in=now.tokens_in - before.tokens_in,
            tokens_out=now.tokens_out - before.tokens_out,
            seconds=time.monotonic() - begun,
            dollars=None if now.dollars is None or before.dollars is None else now.dollars - before.dollars,
            cached=now.calls == before.calls,
            attempts=now.calls - before.calls,
        )


def _conversation(prompt: Prompt) -> list[Message]:
    shots = [m for e in prompt.examples for m in (Message("user", e.text), Message("assistant", e.reply))]
    system = [Message("system", prompt.system)] if prompt.system.strip() else []
    return [*system, *shots, Message("user", prompt.text)]


def _ask_again(text: str, reason: str, schema: JsonSchema | None) -> tuple[Message, Message]:
    """The reply and what is wrong with it; the schema only where nothing before told it."""
    wanted = instruction(schema) if schema else "Reply with the whole JSON object again, mended, and nothing else."
    asked = f"That reply cannot be used: {reason}.\n{wanted}"
    return Message("assistant", text[:_SHOWN_AGAIN] or "(nothing)"), Message("user", asked)


def _cut_reason(limits: Limits) -> str:
    return f"the reply was cut at {limits.reply_tokens} tokens before it was whole"


def _most_tokens(messages: Sequence[Message], schema: JsonSchema) -> int:
    """An upper bound of the tokens of a conversation: no tokenizer makes more of a text than it has bytes."""
    turns = sum(len(m.text.encode()) + _TOKENS_PER_TURN for m in messages)
    return turns + len(json.dumps(schema)) + len(instruction({})) + _TOKENS_PER_CHAT


# Replies on disk, each in a file that is named by a hash of the question


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
