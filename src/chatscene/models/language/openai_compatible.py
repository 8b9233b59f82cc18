"""Any endpoint that speaks OpenAI's chat protocol: hosted ones, vLLM, Ollama, llama.cpp, LM Studio."""

from __future__ import annotations

import asyncio
import importlib.util
import os
import re
from collections.abc import Coroutine, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, Literal
from urllib.parse import urlsplit

from pydantic import BaseModel, NonNegativeInt, ValidationError

from chatscene.errors import LanguageModelError, MissingExtra, SettingsError
from chatscene.models.language.completion import Completion, JsonSchema, Message, Price
from chatscene.models.language.protocol import Limits
from chatscene.models.language.structured import after_thoughts, instruction, printable

if TYPE_CHECKING:
    import openai

OPENAI_URL = "https://api.openai.com/v1"
SEED = 0
RETRIES = 3  # of the client, with growing pauses or the server's `Retry-After`, all within the time limit
_NO_KEY = "none"  # local servers ask for none, the client for some
_SHORTEST_SECRET = 8  # anything shorter is a placeholder such as "ollama"
_LONGEST_MESSAGE = 300  # characters of a server's own words that an error repeats
_CHECK = "check the model's name, CHATSCENE_LLM_URL and CHATSCENE_LLM_KEY"
_CODE = re.compile(r"^Error code: \d+( - )?")  # the client says it in some versions
_SCHEMA_REFUSED = re.compile(r"response_format|json_schema|json_object")

Structure = Literal["json_schema", "json_object", "text"]
_WEAKER: dict[Structure, Structure] = {"json_schema": "json_object", "json_object": "text"}


@dataclass(frozen=True, slots=True)
class Terms:
    """What an endpoint takes. It starts with all we want and gives way where it refuses."""

    structure: Structure = "json_schema"
    length: Literal["max_tokens", "max_completion_tokens"] = "max_tokens"
    temperature: bool = True
    seed: bool = True

    def after(self, status: int, message: str) -> Terms | None:
        """The terms to try after a refusal, or None when it was not about the terms."""
        if status not in (400, 415, 422, 500, 501):
            return None
        if self.length in message and self.length == "max_tokens":
            return replace(self, length="max_completion_tokens")
        if "temperature" in message and self.temperature:
            return replace(self, temperature=False)
        if "seed" in message and self.seed:
            return replace(self, seed=False)
        return self.weaker() if status != 500 or _SCHEMA_REFUSED.search(message) else None

    def weaker(self) -> Terms | None:
        """The same with less structure, or None when there is none left to give up."""
        weaker = _WEAKER.get(self.structure)
        return replace(self, structure=weaker) if weaker else None


class _Usage(BaseModel):
    prompt_tokens: NonNegativeInt | None = None
    completion_tokens: NonNegativeInt | None = None


class _Text(BaseModel):
    content: str | None = None
    refusal: str | None = None


class _Choice(BaseModel):
    message: _Text
    finish_reason: str | None = None


class _Envelope(BaseModel):
    choices: list[_Choice]
    usage: _Usage | None = None


class OpenAICompatible:
    """A model behind a URL.

    The address and the key come from ``CHATSCENE_LLM_URL`` and ``CHATSCENE_LLM_KEY``; without the former, from
    ``OPENAI_BASE_URL`` and ``OPENAI_API_KEY``. A key of the second pair is never sent to an address of the first.
    ``CHATSCENE_LLM_PRICE`` (``IN/OUT``, US dollars per million tokens) lets costs be counted.

    Raises:
        SettingsError: The address or the price cannot be read, or OpenAI itself is meant and there is no key.
        MissingExtra: The package `openai` is missing.
    """

    def __init__(self, model: str, *, limits: Limits, environment: Mapping[str, str] | None = None) -> None:
        if importlib.util.find_spec("openai") is None:
            raise MissingExtra("a language model behind a URL needs the package openai", extra="llm")
        self.name = f"openai:{model}"
        self._model, self._limits = model, limits
        environment = os.environ if environment is None else environment
        self._url, self._key = _address(environment)
        self._foreign = _headers_for_openai() if environment.get("CHATSCENE_LLM_URL") else ()
        self.price = _price(environment.get("CHATSCENE_LLM_PRICE", ""))
        self.identity: Mapping[str, str | int | float] = {
            "model": self.name, "url": self._url, "temperature": 0, "seed": SEED, "reply_tokens": limits.reply_tokens,
        }  # fmt: skip
        self.terms = Terms()

    def complete(self, messages: Sequence[Message], schema: JsonSchema) -> Completion:
        """Ask the endpoint, with as much structure as it takes.

        Raises:
            LanguageModelError: It cannot be reached, refuses, answers with something else, or takes too long.
        """
        completion = self._read(_run(self._post(messages, schema)))
        if not after_thoughts(completion.text).lstrip().startswith("{") and not completion.cut:
            self.terms = self.terms.weaker() or self.terms  # it took the schema and did not keep to it
        return completion

    async def _post(self, messages: Sequence[Message], schema: JsonSchema) -> bytes:
        """The body of the reply. One clock stops everything: connecting, slow bytes, retries and their pauses."""
        import openai

        failure = f"gave no reply within {self._limits.seconds:g} s"
        advice = "allow more (CHATSCENE_LLM_SECONDS), or use a faster model"
        try:
            async with (
                asyncio.timeout(self._limits.seconds),
                self._client() as client,
            ):
                return await self._negotiate(client, messages, schema)
        except (TimeoutError, openai.APITimeoutError):
            pass
        except openai.APIStatusError as error:
            said = _CODE.sub("", error.message)
            failure, advice = f"answers with status {error.status_code}: {said}", _CHECK
        except openai.APIError as error:
            failure, advice = f"cannot be reached: {error.message} {error.__cause__ or ''}", _CHECK
        # Raised out here, so that the client's error, which may repeat the key, is not shown as the cause.
        raise self._failure(failure, advice)

    def _client(self) -> openai.AsyncOpenAI:
        import openai

        omitted: dict[str, Any] = {name: openai.Omit() for name in self._foreign}
        return openai.AsyncOpenAI(
            api_key=self._key,
            base_url=self._url,
            max_retries=RETRIES,
            timeout=self._limits.seconds,
            default_headers=omitted,
        )

    async def _negotiate(self, client: openai.AsyncOpenAI, messages: Sequence[Message], schema: JsonSchema) -> bytes:
        import openai

        create: Any = client.chat.completions.with_raw_response.create
        terms = self.terms
        while True:
            try:
                reply = await create(**self._body(terms, messages, schema))
            except openai.APIStatusError as error:
                easier = terms.after(error.status_code, error.message)
                if easier is None:
                    raise
                terms = easier
            else:
                self.terms = terms
                return bytes(reply.content)

    def _body(self, terms: Terms, messages: Sequence[Message], schema: JsonSchema) -> dict[str, Any]:
        turns = [{"role": m.role, "content": m.text} for m in messages]
        body: dict[str, Any] = {"model": self._model, terms.length: self._limits.reply_tokens}
        if terms.temperature:
            body["temperature"] = 0
        if terms.seed:
            body["seed"] = SEED
        if terms.structure == "json_schema":
            named = {"name": "answer", "schema": schema, "strict": True}
            body["response_format"] = {"type": "json_schema", "json_schema": named}
        else:
            turns = _instructed(turns, schema)
        if terms.structure == "json_object":
            body["response_format"] = {"type": "json_object"}
        return body | {"messages": turns}

    def _read(self, body: bytes) -> Completion:
        try:
            envelope = _Envelope.model_validate_json(body)
            choice = envelope.choices[0]
        except (ValidationError, IndexError):
            failure = f"answers with something that is not a chat completion ({len(body)} bytes)"
            raise self._failure(failure, f"{_CHECK} (most addresses end in /v1)") from None
        if choice.message.refusal:
            raise self._failure(f"refuses to answer: {choice.message.refusal}", "say it in other words")
        usage = envelope.usage or _Usage()
        return Completion(
            text=self._without_key(choice.message.content or ""),
            tokens_in=usage.prompt_tokens,
            tokens_out=usage.completion_tokens,
            cut=choice.finish_reason == "length",
        )

    def _failure(self, what: str, advice: str) -> LanguageModelError:
        said = printable(self._without_key(what), _LONGEST_MESSAGE)
        return LanguageModelError(f"{self.name} at {self._url} {said}; {advice}")

    def _without_key(self, text: str) -> str:
        return text.replace(self._key, "[key]") if len(self._key) >= _SHORTEST_SECRET else text


def _run(work: Coroutine[Any, Any, bytes]) -> bytes:
    """Run to the end, from a notebook, where an event loop is already running, too."""
    try:
        asyncio.get_running_loop()
    except RuntimeError:
        return asyncio.run(work)
    with ThreadPoolExecutor(1) as thread:
        return thread.submit(asyncio.run, work).result()


def _instructed(turns: list[dict[str, str]], schema: JsonSchema) -> list[dict[str, str]]:
    """The conversation with the schema in its system message."""
    if turns[0]["role"] != "system":
        return [{"role": "system", "content": instruction(schema)}, *turns]
    return [{"role": "system", "content": f"{turns[0]['content']}\n\n{instruction(schema)}"}, *turns[1:]]


def _address(environment: Mapping[str, str]) -> tuple[str, str]:
    """The base URL and the key."""
    if own := environment.get("CHATSCENE_LLM_URL"):
        url, key = own, environment.get("CHATSCENE_LLM_KEY") or _NO_KEY
    else:
        url = environment.get("OPENAI_BASE_URL") or OPENAI_URL
        key = environment.get("CHATSCENE_LLM_KEY") or environment.get("OPENAI_API_KEY") or _NO_KEY
    try:
        parts = urlsplit(url)
        plain = parts.scheme in ("http", "https") and parts.hostname and (parts.port or 1) > 0
    except ValueError:
        raise SettingsError("the address of the language model is not a URL; see CHATSCENE_LLM_URL") from None
    if not plain or parts.username is not None or parts.query or parts.fragment:
        raise SettingsError(
            "CHATSCENE_LLM_URL (or OPENAI_BASE_URL) must be http(s)://HOST[:PORT]/PATH and nothing else; "
            "a key belongs into CHATSCENE_LLM_KEY"
        )
    if url.rstrip("/") == OPENAI_URL and key == _NO_KEY:
        raise SettingsError("OpenAI needs a key: set CHATSCENE_LLM_KEY, or name another server in CHATSCENE_LLM_URL")
    if not (key := key.strip()).isascii() or not key.isprintable():
        raise SettingsError("the key in CHATSCENE_LLM_KEY (or OPENAI_API_KEY) holds characters that no key has")
    return url.rstrip("/"), key or _NO_KEY


def _headers_for_openai() -> tuple[str, ...]:
    """Headers that the client takes from the environment for OpenAI, and would send to any other server too."""
    lines = os.environ.get("OPENAI_CUSTOM_HEADERS", "").splitlines()
    return ("OpenAI-Organization", "OpenAI-Project", *(line.partition(":")[0].strip() for line in lines))


def _price(text: str) -> Price | None:
    if not text:
        return None
    match = re.fullmatch(r"(\d+(?:\.\d+)?)/(\d+(?:\.\d+)?)", text.strip())
    if match is None:
        raise SettingsError(f"CHATSCENE_LLM_PRICE must be IN/OUT in dollars per million tokens, not {text!r}")
    return Price(float(match[1]), float(match[2]))
