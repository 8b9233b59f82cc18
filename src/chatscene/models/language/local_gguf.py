"""A GGUF file, run in this process by llama.cpp through `xllamacpp`, held to the schema by a grammar."""

from __future__ import annotations

import hashlib
import importlib
import importlib.util
import secrets
import threading
import time
from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

from chatscene.errors import LanguageModelError, MissingExtra, SettingsError
from chatscene.models.language.completion import FREE, Completion, JsonSchema, Message
from chatscene.models.language.protocol import Limits
from chatscene.models.language.structured import printable

CONTEXT = 8192  # tokens of prompt and reply together
SEED = 0
_READ_AT_ONCE = 256  # tokens of a prompt between two looks at the clock
_SILENT = -1
_LONGEST_MESSAGE = 300  # characters of the engine's own words that an error repeats


class LocalGguf:
    """A model in a file, on one thread.

    llama.cpp's threads wait by spinning: two of them on two cores of which one is busy are about 50 times slower than
    one, so there is one. The prompt is read anew at each call, because what is kept from the last one changes the
    rounding, and with it, now and then, a word. The engine listens on the loopback address while the model is loaded;
    a key that nobody is told closes it to others.

    Raises:
        SettingsError: The file is missing, or is not a model.
        MissingExtra: The package `xllamacpp` is missing.
    """

    price = FREE

    def __init__(self, path: str, *, limits: Limits) -> None:
        if importlib.util.find_spec("xllamacpp") is None:
            raise MissingExtra("a language model in a file needs the package xllamacpp", extra="local-llm")
        self.name = f"gguf:{path}"
        self._limits = limits
        self.identity: Mapping[str, str | int | float] = {
            "model": "gguf", "sha256": _sha256(Path(path)), "engine": _engine_version(), "context": CONTEXT,
            "temperature": 0, "seed": SEED, "reply_tokens": limits.reply_tokens,
        }  # fmt: skip
        self._engine = _engine(path)

    def complete(self, messages: Sequence[Message], schema: JsonSchema) -> Completion:
        """Write the next turn, until it ends or time is up.

        Raises:
            LanguageModelError: The conversation is longer than the context, the model's template or the engine cannot
                take it, or time is up.
        """
        pieces: list[str] = []
        last: dict[str, Any] = {}
        stopped = threading.Event()
        until = time.monotonic() + self._limits.seconds

        def enough(chunk: dict[str, Any]) -> bool:
            for choice in chunk.get("choices", ()):
                pieces.append(choice["delta"].get("content") or "")
                if choice["finish_reason"]:
                    last["ending"] = choice["finish_reason"]
            last.update({key: chunk[key] for key in ("usage", "error") if key in chunk})
            return stopped.is_set() or time.monotonic() > until

        # In a thread of its own, because the engine swallows the interrupt of a user who presses ctrl-C.
        with ThreadPoolExecutor(1) as thread:
            try:
                thread.submit(self._engine.handle_chat_completions, self._body(messages, schema), enough).result()
            except (RuntimeError, ValueError) as error:
                raise self._failure(str(error)) from error
            finally:
                stopped.set()
        if "error" in last:
            raise self._failure(str(last["error"].get("message")))
        if "ending" not in last:
            raise LanguageModelError(
                f"{self.name} did not finish within {self._limits.seconds:g} s; allow more (CHATSCENE_LLM_SECONDS), "
                "or use a smaller model"
            )
        usage = last.get("usage", {})
        return Completion(
            text="".join(pieces),
            tokens_in=usage.get("prompt_tokens"),
            tokens_out=usage.get("completion_tokens"),
            cut=last["ending"] == "length",
        )

    def _failure(self, what: str) -> LanguageModelError:
        said = printable(what, _LONGEST_MESSAGE)
        return LanguageModelError(f"{self.name} cannot answer: {said}; shorten the question, or use another chat model")

    def _body(self, messages: Sequence[Message], schema: JsonSchema) -> dict[str, Any]:
        named = {"name": "answer", "schema": schema, "strict": True}
        return {
            "messages": [{"role": m.role, "content": m.text} for m in messages],
            "response_format": {"type": "json_schema", "json_schema": named},
            "max_tokens": self._limits.reply_tokens,
            "temperature": 0,
            "seed": SEED,
            "cache_prompt": False,
            "stream": True,
            "stream_options": {"include_usage": True},
            "return_progress": True,
        }


def _engine(path: str) -> Any:
    xllamacpp: Any = importlib.import_module("xllamacpp")
    params = xllamacpp.CommonParams()
    params.model.path = path
    params.n_ctx, params.n_parallel, params.n_gpu_layers = CONTEXT, 1, 0
    params.n_batch = params.n_ubatch = _READ_AT_ONCE
    params.cpuparams.n_threads = params.cpuparams_batch.n_threads = 1
    params.hostnames, params.port, params.api_keys = ["127.0.0.1"], 0, [secrets.token_hex(16)]
    params.warmup, params.verbosity = False, _SILENT
    try:
        return xllamacpp.Server(params)
    except RuntimeError as error:
        raise SettingsError(f"{path} cannot be loaded: {error}; it must be a GGUF file of a chat model") from error


def _engine_version() -> str:
    module: Any = importlib.import_module("xllamacpp")
    return str(module.__version__)


def _sha256(path: Path) -> str:
    try:
        with path.open("rb") as file:
            return hashlib.file_digest(file, "sha256").hexdigest()
    except OSError as error:
        raise SettingsError(f"cannot read the model {path}: {error.strerror or error}") from error
