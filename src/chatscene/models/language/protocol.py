"""What every language model is to the rest of the project: one Protocol, one table of names.

A model is asked for an object of a pydantic schema and gives one that is validated, or an error. What it writes is
data: nothing of it is executed, imported or followed as an instruction.
"""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Generic, Protocol, TypeVar

from pydantic import BaseModel

from chatscene.errors import SettingsError
from chatscene.plugins import Kind, make, names

Answer = TypeVar("Answer", bound=BaseModel)


@dataclass(frozen=True, slots=True)
class Example:
    """A question with the reply that is wanted for it (one shot of a few-shot prompt)."""

    text: str
    reply: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Prompt:
    """What a model is asked.

    Attributes:
        examples: Questions with their replies, shown before the question.
        form: The JSON schema that a reply is held to, where `system` tells in words what it may say, so that it is not
            put beside them again; None for that of the answer, with every field written.

    Raises:
        SettingsError: The question is empty, or a text cannot be written as UTF-8.
    """

    system: str
    text: str
    examples: tuple[Example, ...] = ()
    form: Mapping[str, Any] | None = None

    def __post_init__(self) -> None:
        if not self.text.strip():
            raise SettingsError("there is no text to ask a language model about")
        for text in (self.system, self.text, *(part for e in self.examples for part in (e.text, e.reply))):
            try:
                text.encode()
            except UnicodeEncodeError as error:
                raise SettingsError("the text holds half a character (a lone surrogate); type it again") from error


@dataclass(frozen=True, slots=True, kw_only=True)
class Reply(Generic[Answer]):
    """A validated answer, and what it took.

    Attributes:
        tokens_in: Tokens of all prompts sent for it, as the model counted them; 0 from the cache.
        tokens_out: Tokens the model wrote for it; 0 from the cache.
        seconds: Wall-clock time [s].
        dollars: Cost [US dollars]; None where the price is not known.
        cached: Whether it came from the cache, without a call.
        attempts: Calls it took: 1, one more per question asked again, 0 from the cache.
    """

    answer: Answer
    tokens_in: int
    tokens_out: int
    seconds: float
    dollars: float | None
    cached: bool
    attempts: int


@dataclass(frozen=True, slots=True, kw_only=True)
class Spending:
    """What a model has cost since it was loaded, for the record of a run.

    Attributes:
        calls: Calls made, those that failed among them.
        seconds: Time spent in calls [s].
        dollars: Cost [US dollars]; None where the price is not known. What a provider charges for a call that failed
            cannot be known and is not in it.
    """

    calls: int = 0
    from_cache: int = 0
    tokens_in: int = 0
    tokens_out: int = 0
    seconds: float = 0.0
    dollars: float | None = None


def _patience() -> float:
    text = os.environ.get("CHATSCENE_LLM_SECONDS", "120")
    try:
        return float(text)
    except ValueError:
        raise SettingsError(f"CHATSCENE_LLM_SECONDS must be a number of seconds, not {text!r}") from None


@dataclass(frozen=True, slots=True, kw_only=True)
class Limits:
    """How far one question may go.

    Attributes:
        seconds: Longest wait for one reply [s], connecting, retries and pauses included; 120, or what
            ``CHATSCENE_LLM_SECONDS`` says.
        reasks: How often a question is asked again, with the reason, when the reply cannot be used.
    """

    reply_tokens: int = 1024
    seconds: float = field(default_factory=_patience)
    reasks: int = 2

    def __post_init__(self) -> None:
        if self.reply_tokens < 1 or not 0 < self.seconds < math.inf or self.reasks < 0:
            raise SettingsError(f"the limits of a language model are out of range: {self}")


class LanguageModel(Protocol):
    """Answers a question with an object.

    Input: a prompt and a pydantic schema. Output: an object of that schema, with what it took. Determinism: greedy
    decoding (temperature 0) with a fixed seed wherever the model allows it; the same question in the same process or
    a later one is answered from the cache on disk, so a run can be repeated even where the model itself is not
    repeatable. Failure: `LanguageModelError`, which names the model and the last reason.
    """

    name: str

    @property
    def identity(self) -> Mapping[str, str | int | float]:
        """All that decides a reply besides the question: model, address, parameters. It holds no secret."""
        ...

    @property
    def spending(self) -> Spending:
        """What it has cost so far."""
        ...

    def reply(
        self, prompt: Prompt, schema: type[Answer], *, check: Callable[[Answer], str] | None = None
    ) -> Reply[Answer]:
        """Ask, and validate what comes back.

        Raises:
            LanguageModelError: No usable reply.
        """
        ...


LANGUAGE_MODELS: Kind[Any] = Kind(  # each makes a `chatscene.models.language.completion.Completer`
    noun="language model",
    group="chatscene.language_models",
    method="complete",
    built_in={
        "openai": "chatscene.models.language.openai_compatible:OpenAICompatible",
        "gguf": "chatscene.models.language.local_gguf:LocalGguf",
        "scripted": "chatscene.models.language.scripted:from_file",
    },
)


def load_language_model(name: str, *, limits: Limits | None = None, cache: Path | None = None) -> LanguageModel:
    """A language model by the name a user types.

    Args:
        name: ``openai:MODEL``, ``gguf:FILE`` or ``scripted:FILE``, or another name (`chatscene.plugins`) with what
            its factory is to take behind a colon.
        limits: How far one question may go.
        cache: Folder for replies, such as `cache_folder("replies")`; without one, every question is a call.

    Raises:
        SettingsError: The name or what it needs (a file, a key, an address) is not right.
        MissingExtra: Its package is missing.
    """
    from chatscene.models.language.checked import CheckedModel

    kind, _, which = name.partition(":")
    if ":" in which and kind not in names(LANGUAGE_MODELS):
        module, factory, which = name.split(":", 2)
        kind = f"{module}:{factory}"
    if not which.strip():
        raise SettingsError(f"{name!r} does not say which model; write for instance openai:MODEL or gguf:FILE")
    limits = limits or Limits()
    completer = make(LANGUAGE_MODELS, kind, which, limits=limits)
    return CheckedModel(completer, limits=limits, cache=cache)
