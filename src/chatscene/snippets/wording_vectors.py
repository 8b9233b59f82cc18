"""The packaged library's wordings as vectors, so that the first sentence on a new machine does not wait for them.

Encoding six thousand wordings takes half a minute. Their rows lie beside the library, a byte per number, found by a
hash of encoder and text; a wording that is not there, such as a user's own, is encoded when it is asked for.
"""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from functools import lru_cache
from pathlib import Path

import numpy as np

from chatscene.snippets.embedding import Embedder, Vectors, encode_cached, plain

PACKAGED = Path(__file__).parent / "wording_vectors.npz"


def vectors_of(texts: Sequence[str], embedder: Embedder) -> Vectors:
    """(N, D) rows of length 1, as the embedder gives them but for rounding."""
    known = _known()
    keys = [_key(text, embedder) for text in texts]
    missing = sorted({text for text, key in zip(texts, keys, strict=True) if key not in known})
    if missing:
        rows = encode_cached(embedder, missing)
        known = known | {_key(text, embedder): row for text, row in zip(missing, rows, strict=True)}
    return np.array([known[key] for key in keys], np.float32)


def save_vectors(texts: Sequence[str], embedder: Embedder, path: Path = PACKAGED) -> None:
    """Keep the rows of texts for `vectors_of`."""
    different = sorted(set(texts))
    rows = encode_cached(embedder, different)
    scale = np.abs(rows).max(axis=1, keepdims=True) / 127
    keys = np.array([int.from_bytes(_key(text, embedder), "big") for text in different], np.uint64)
    np.savez_compressed(path, keys=keys, rows=np.round(rows / scale).astype(np.int8))


def _key(text: str, embedder: Embedder) -> bytes:
    return hashlib.blake2b(f"{embedder.identity}\0{plain(text)}".encode(), digest_size=8).digest()


@lru_cache(maxsize=1)
def _known() -> dict[bytes, Vectors]:
    """The packaged rows by their keys; none where the file is missing or damaged, which costs time and no more."""
    try:
        with np.load(PACKAGED, allow_pickle=False) as arrays:
            rows = arrays["rows"].astype(np.float32)
            keys = [int(key).to_bytes(8, "big") for key in arrays["keys"].tolist()]
    except (OSError, ValueError, KeyError):
        return {}
    rows /= np.linalg.norm(rows, axis=1, keepdims=True)
    return dict(zip(keys, rows, strict=True))
