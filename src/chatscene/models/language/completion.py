"""What one kind of model has to bring: a conversation in, a text out. The rest is done once, in `checked`."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal, Protocol

JsonSchema = dict[str, Any]


@dataclass(frozen=True, slots=True)
class Message:
    """One turn of a conversation."""

    role: Literal["system", "user", "assistant"]
    text: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Completion:
    """What a model wrote.

    Attributes:
        tokens_in: Tokens of the conversation as the model counted them; None where it does not say.
        tokens_out: Tokens of the reply; None likewise.
        cut: Whether the reply ends at the limit of its length rather than by itself.
    """

    text: str
    tokens_in: int | None
    tokens_out: int | None
    cut: bool = False


@dataclass(frozen=True, slots=True)
class Price:
    """US dollars per million tokens."""

    per_million_in: float
    per_million_out: float

    def of(self, tokens_in: int, tokens_out: int) -> float:
        """The price of so many tokens [US dollars]."""
        return (tokens_in * self.per_million_in + tokens_out * self.per_million_out) / 1e6


FREE = Price(0.0, 0.0)


class Completer(Protocol):
    """Continues a conversation.

    Input: the turns so far and the JSON schema the reply should fit. Output: text, which need not fit. Determinism: as
    `LanguageModel`. Failure: `LanguageModelError` within the time limit, when there is no reply at all.
    """

    @property
    def name(self) -> str:
        """What the user calls it."""
        ...

    @property
    def price(self) -> Price | None:
        """What its tokens cost; None when that is not known."""
        ...

    @property
    def identity(self) -> Mapping[str, str | int | float]:
        """All that decides a reply besides the question; it holds no secret."""
        ...

    def complete(self, messages: Sequence[Message], schema: JsonSchema) -> Completion:
        """Write the next turn."""
        ...
