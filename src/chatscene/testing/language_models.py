"""What every language model owes; see `chatscene.models.language.protocol.LanguageModel`."""

from __future__ import annotations

from enum import StrEnum
from typing import Literal

from pydantic import BaseModel, ConfigDict, field_validator

from chatscene.errors import LanguageModelError
from chatscene.models.language.protocol import Example, LanguageModel, Prompt, load_language_model
from chatscene.testing.contract import ContractBroken, require


class _Who(StrEnum):
    CAR = "car"
    PEDESTRIAN = "pedestrian"


class _Seen(BaseModel):
    model_config = ConfigDict(extra="forbid")

    who: _Who
    count: Literal[1, 2]


class _Never(BaseModel):
    who: _Who

    @field_validator("who")
    @classmethod
    def refuse(cls, value: _Who) -> _Who:  # noqa: ARG003
        raise ValueError("nothing is ever right")


PROMPT = Prompt(
    system="Say who acts, as JSON.",
    text="A pedestrian crosses the road.",
    examples=(Example("A car stops.", '{"who": "car", "count": 1}'),),
)
"""What a model is asked; a scripted one must know an answer."""


def check_language_model(model: str | LanguageModel) -> None:
    """Hold a language model to the contract of all; it is asked a few questions.

    Args:
        model: A model, or its name, such as ``gguf:FILE``.

    Raises:
        ContractBroken: It breaks a rule; the message says which.
        LanguageModelError: It gives no usable reply to a question that it should answer.
        SettingsError: The name or what it needs is not right.
        MissingExtra: Its package is missing.
    """
    made = load_language_model(model) if isinstance(model, str) else model
    require(made.name != "", "a model has a name")
    identity = made.identity
    require(len(identity) > 0, "an identity says what decides a reply", identity)
    before = made.spending
    reply = made.reply(PROMPT, _Seen)
    require(type(reply.answer) is _Seen, "an answer is an object of the schema", reply.answer)
    require(reply.cached or reply.attempts >= 1, "a reply took a call, or came from the cache", reply.attempts)
    after = made.spending
    counted = after.calls - before.calls == reply.attempts
    require(counted, "every call is counted", (before, after, reply.attempts))
    require(after.tokens_out - before.tokens_out == reply.tokens_out, "every token is counted", (before, after))
    again = made.reply(PROMPT, _Seen).answer
    require(again == reply.answer, "the same question has the same answer", (reply.answer, again))
    try:
        made.reply(PROMPT, _Never)
    except LanguageModelError:
        return
    raise ContractBroken("a reply that fits no schema is a LanguageModelError; found: an answer")
