"""The files of the learned reader: what was trained of the encoder, its decoder, and how sure it may be.

How sure it may be stands in a text file of its own beside the weights, so that fitting it anew leaves them as they are.
"""

from __future__ import annotations

import hashlib
import io
import json
import zipfile
import zlib
from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np

from chatscene.errors import SnippetError
from chatscene.files.bounded import check_archive
from chatscene.files.caches import cache_folder, keep, keep_latest, kept, only_mine, sealed
from chatscene.read.learned.grammar import Place, Token

NAME = "reader.npz"
PACKAGED = Path(__file__).parent / NAME
Trust = tuple[float, float]
AS_IT_IS: Trust = (1.0, 0.0)
_FILES = 4  # that are kept unpacked


@dataclass(frozen=True, slots=True, eq=False)
class Weights:
    """What was learned.

    Attributes:
        changes: What to add to the bytes of the encoder's file, by where they stand.
        text: The graph of what the decoder takes from a text.
        tokens: Those that it was trained for, in their order.
        places: The places that it was trained for, in their order.
        trust: What the log-odds of a reading are multiplied with, so that it is as often right as it says, and what is
            added then.
    """

    changes: Mapping[int, bytes]
    text: bytes
    following: bytes
    tokens: tuple[Token, ...]
    places: tuple[Place, ...]
    trust: Trust = AS_IT_IS
    trust_in_parts: Trust = AS_IT_IS


def trust_file(path: Path) -> Path:
    """Where it stands how sure a reader may be, beside its weights."""
    return path.with_suffix(".json")


def save(weights: Weights, path: Path) -> None:
    """Write both files."""
    packer = zlib.compressobj(strategy=zlib.Z_HUFFMAN_ONLY)  # small numbers without repeats (decision 0042)
    changes = b"".join(weights.changes.values())
    np.savez_compressed(
        path,
        at=np.array(list(weights.changes), np.int64),
        lengths=np.array([len(new) for new in weights.changes.values()], np.int64),
        changes=np.frombuffer(packer.compress(changes) + packer.flush(), np.uint8),
        text=np.frombuffer(weights.text, np.uint8),
        following=np.frombuffer(weights.following, np.uint8),
        tokens=np.array("\n".join("\t".join(token) for token in weights.tokens)),
        places=np.array("\n".join(weights.places)),
    )
    save_trust(weights, path)


def save_trust(weights: Weights, path: Path) -> None:
    """Write how sure the reader may be, beside its weights."""
    fitted = {"whole": weights.trust, "in parts": weights.trust_in_parts}
    trust_file(path).write_text(f"{json.dumps(fitted, indent=2)}\n", encoding="utf-8")


@lru_cache(maxsize=2)
def load(path: Path = PACKAGED) -> Weights:
    """Read the files. What the weights unpack to is kept between processes, since that takes longer than all else.

    Raises:
        SnippetError: It is missing or damaged.
    """
    try:
        check_archive(path)
        arrays = _unpacked(path.read_bytes())
        ends = np.cumsum(arrays["lengths"]).tolist()
        changes = arrays["changes"].tobytes()
        places = zip(arrays["at"].tolist(), [0, *ends[:-1]], ends, strict=False)
        fitted = json.loads(trust_file(path).read_text(encoding="utf-8"))
        (scale, offset), (of_parts, added) = fitted["whole"], fitted["in parts"]
        return Weights(
            changes={at: changes[low:high] for at, low, high in places},
            text=arrays["text"].tobytes(),
            following=arrays["following"].tobytes(),
            tokens=tuple(_token(line) for line in str(arrays["tokens"]).split("\n")),
            places=tuple(str(arrays["places"]).split("\n")),
            trust=(float(scale), float(offset)),
            trust_in_parts=(float(of_parts), float(added)),
        )
    except (OSError, ValueError, KeyError, TypeError, MemoryError, zipfile.BadZipFile, zlib.error) as error:
        raise SnippetError(f"the learned reader {path} cannot be read ({error}); install chatscene again") from error


def _unpacked(content: bytes) -> dict[str, Any]:
    """The arrays of a file, unpacked: those that were kept of it, if they are whole."""
    folder = only_mine(cache_folder("weights"))
    made_by = Path(__file__).read_bytes()  # what unpacks it, so that no other version takes it for its own
    file = None if folder is None else folder / hashlib.blake2b(content + made_by, digest_size=16).hexdigest()
    if file is not None and (whole := kept(file)) is not None:
        return _arrays(whole)
    arrays = _arrays(content)
    most = int(arrays["lengths"].sum())
    arrays["changes"] = np.frombuffer(zlib.decompressobj().decompress(arrays["changes"].tobytes(), most), np.uint8)
    if file is not None and folder is not None:
        np.savez(sink := io.BytesIO(), **arrays)
        keep(file, sealed(sink.getvalue()))
        keep_latest(folder, _FILES)
    return arrays


def _arrays(content: bytes) -> dict[str, Any]:
    with np.load(io.BytesIO(content), allow_pickle=False) as arrays:
        return dict(arrays)


def _token(line: str) -> Token:
    key, _, word = line.partition("\t")
    return key, word
