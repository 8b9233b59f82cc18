"""Nearest rows by cosine: exact for libraries of ordinary size, approximate for very large ones.

Paper: section 3.3, step iii, an index of faiss per component. Exact search takes a time in proportion to the rows;
below `EXACT_UP_TO` that is little beside encoding the sentence, so nothing is gained by guessing. Above it the rows are
put into lists around centres (`IndexIVFFlat`), and only the nearest lists are read. HNSW searches faster still, but
takes four times as long to build and cannot be asked for everything (docs/lab/encoders.md).
"""

from __future__ import annotations

import hashlib
import math
from collections.abc import Generator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chatscene.errors import SettingsError
from chatscene.files.caches import cache_folder, keep
from chatscene.models.encoders.embedding import Vectors

Rows = NDArray[np.int64]

EXACT_UP_TO = 20_000  # rows; as many cost about a millisecond
PROBED = 64  # lists that are read for one query
SEED = 0  # of the centres
_TRAINED_ON = 64  # rows per centre; more take longer and find no better centres
_LENGTH_ERROR = 1e-3  # of a row of length 1


@dataclass(frozen=True, slots=True)
class VectorIndex:
    """Rows of length 1, ready to be searched; made by `build`.

    Attributes:
        lists: How many lists the rows lie in; 1 if every search is exact.
        size: How many rows.
        dimension: Length of a row in numbers.
        core: The index of faiss.
    """

    lists: int
    size: int
    dimension: int
    core: Any

    def search(self, queries: Vectors, count: int) -> tuple[Vectors, Rows]:
        """The rows nearest to each query, best first; of equal ones the earlier first.

        As many as asked for are always found: where the lists that are read hold fewer, all are read.

        Args:
            queries: (Q, D), of length 1.
            count: How many per query; `size` at most are found.

        Returns:
            (Q, min(count, `size`)) cosines and row numbers.

        Raises:
            SettingsError: A query is not of length 1, or not of the rows' dimension.
        """
        queries = self._asked(queries)
        count = min(count, self.size)
        if not len(queries) or not count:
            return np.zeros((len(queries), count), np.float32), np.zeros((len(queries), count), np.int64)
        cosines, rows = self._nearest(queries, count, PROBED)
        short = (rows < 0).any(axis=1)
        if short.any():
            cosines[short], rows[short] = self._nearest(queries[short], count, self.lists)
        order = np.lexsort((rows, -cosines))
        return np.take_along_axis(cosines, order, 1), np.take_along_axis(rows, order, 1)

    def cosines(self, query: Vectors) -> Vectors:
        """(N,) the cosine of one query, (1, D), of length 1, to every row: sooner than a search for all of them."""
        query = self._asked(query)
        with _one_thread():
            _, cosines, rows = self.core.range_search(query, -2.0, params=self._reading(self.lists))
        found = np.empty(self.size, np.float32)
        found[rows] = cosines
        return found

    def _asked(self, queries: Vectors) -> Vectors:
        queries = _checked(queries)
        if queries.shape[1] != self.dimension:
            raise SettingsError(
                f"a query of {queries.shape[1]} numbers in an index of rows of {self.dimension}; "
                "encode both with the same embedder"
            )
        return queries

    def _nearest(self, queries: Vectors, count: int, probed: int) -> tuple[Vectors, Rows]:
        with _one_thread():
            return self.core.search(queries, count, params=self._reading(min(probed, self.lists)))

    def _reading(self, lists: int) -> Any:
        """How a search is told to read so many lists."""
        import faiss

        if self.lists == 1:
            return None
        how: Any = faiss.SearchParametersIVF()
        how.nprobe = lists
        return how


def build(vectors: Vectors, *, exact_up_to: int = EXACT_UP_TO) -> VectorIndex:
    """An index of rows; the same rows always give the same index.

    Args:
        vectors: (N, D), of length 1.
        exact_up_to: Up to how many rows every search is exact.

    Raises:
        SettingsError: A row is not of length 1.
    """
    import faiss

    vectors = _checked(vectors)
    size, dimension = vectors.shape
    exact: Any = faiss.IndexFlatIP(dimension)
    if size <= max(exact_up_to, 1):
        exact.add(vectors)
        return VectorIndex(1, size, dimension, exact)
    lists = _lists(size)
    index: Any = faiss.IndexIVFFlat(exact, dimension, lists, faiss.METRIC_INNER_PRODUCT)
    index.cp.seed = SEED
    index.cp.min_points_per_centroid = 1  # else it warns on standard output
    index.cp.max_points_per_centroid = _TRAINED_ON
    with _one_thread():
        index.train(vectors)
        index.add(vectors)
    return VectorIndex(lists, size, dimension, index)


def build_cached(vectors: Vectors, *, exact_up_to: int = EXACT_UP_TO) -> VectorIndex:
    """`build`, keeping an index that took long in the user's cache folder.

    The file is named by a hash of the rows and of how they are indexed, and begins with a hash of the rest. One that
    is missing, damaged or cannot be written costs time and nothing else.
    """
    if len(vectors) <= max(exact_up_to, 1):
        return build(vectors, exact_up_to=exact_up_to)
    vectors = _checked(vectors)
    path = cache_folder("vectors") / f"{_content_hash(vectors)}.ivf"
    index = _load(path, vectors)
    if index is None:
        index = build(vectors, exact_up_to=exact_up_to)
        keep(path, _stored(index))
    return index


def _stored(index: VectorIndex) -> bytes:
    import faiss

    content = faiss.serialize_index(index.core).tobytes()
    return hashlib.blake2b(content).digest() + content


def _load(path: Path, vectors: Vectors) -> VectorIndex | None:
    """A stored index; none if there is none that is whole. What fails its hash never reaches faiss."""
    import faiss

    try:
        stored = path.read_bytes()
    except OSError:
        return None
    size = hashlib.blake2b().digest_size
    content = stored[size:]
    if hashlib.blake2b(content).digest() != stored[:size]:
        return None
    index: Any = faiss.deserialize_index(np.frombuffer(content, np.uint8))
    rows, dimension = vectors.shape
    return VectorIndex(_lists(rows), rows, dimension, index)


def _lists(size: int) -> int:
    return min(size, round(2 * math.sqrt(size)))


def _content_hash(vectors: Vectors) -> str:
    import faiss

    how = f"{faiss.__version__} {vectors.shape} {_lists(len(vectors))} {SEED} {_TRAINED_ON}"
    return hashlib.blake2b(vectors.tobytes(), key=how.encode(), digest_size=16).hexdigest()


def _checked(vectors: Vectors) -> Vectors:
    vectors = np.ascontiguousarray(vectors, np.float32)
    if not np.all(np.abs(np.linalg.norm(vectors, axis=1) - 1) < _LENGTH_ERROR):  # also false for what is no number
        raise SettingsError("an index holds and compares rows of length 1 only; divide each by its length")
    return vectors


@contextmanager
def _one_thread() -> Generator[None]:
    """Sums in another order give other last digits; and several threads wait more than they work here."""
    import faiss

    before = faiss.omp_get_max_threads()
    faiss.omp_set_num_threads(1)
    try:
        yield
    finally:
        faiss.omp_set_num_threads(before)
