"""How long retrieval takes on the packaged library, and what a library of 100,000 snippets would cost.

    OMP_NUM_THREADS=1 python benchmarks/retrieval.py [--embedder minilm] [--size 100000] [--hnsw]

Nothing is read from the user's cache. The rows of the large library are not texts that were encoded, which would take
an hour: every wording of the packaged library is encoded, and the rest are made from those rows, two at a time in
random shares plus noise, scaled to length 1. Times are of one thread of this machine, by the clock and, in brackets,
of the processor, which a busy machine changes less; the ratios are of the latter, against the exact search of numpy in
the same run. With ``--hnsw`` that index is built too, for comparison. Linux only.
"""

from __future__ import annotations

import argparse
import os
import tempfile
import time
from collections.abc import Callable, Sequence
from contextlib import suppress
from pathlib import Path
from typing import Any

import faiss
import numpy as np
from numpy.typing import NDArray

from chatscene.errors import NothingFits
from chatscene.interpret.asked import scenario_of
from chatscene.interpret.retrieve import retrieve
from chatscene.interpret.vector_index import PROBED, Rows, build
from chatscene.library.load import load_library
from chatscene.models.encoders.embedding import Embedder, Vectors, encode_cached, load_embedder
from chatscene.settings import RetrievalSettings
from chatscene.terms.scenario import Component, Scenario

Times = NDArray[np.float64]  # by the clock and of the processor, s

COUNT = 10
QUERIES = 500
NOISE = 0.2  # length of what is added to a row of length 1
HNSW = (32, 64)  # neighbours of each row, rows looked at in a search


def resident() -> float:
    """Memory of this process now, in MB."""
    pages = int(Path("/proc/self/statm").read_text(encoding="ascii").split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE") / 1e6


def held(index: Any) -> float:
    """Size of an index of faiss in MB; what the process grows by depends on what it freed before."""
    return faiss.serialize_index(index).nbytes / 1e6


def clocks() -> Times:
    return np.array([time.perf_counter(), time.process_time()])


def timed(work: Callable[[], object]) -> Times:
    began = clocks()
    work()
    return clocks() - began


def spread(times: Sequence[Times]) -> str:
    (wall, cpu), (wall95, cpu95) = 1e3 * np.quantile(np.array(times), (0.5, 0.95), axis=0)
    return f"median {wall:.2f} ms, p95 {wall95:.2f} ms ({cpu:.2f}, {cpu95:.2f})"


# The packaged library


def packaged(name: str) -> Embedder:
    library = load_library()
    behaviors = library.of(Component.BEHAVIOR)
    settings = RetrievalSettings(embedder=name)
    memory = [resident()]
    embedder = load_embedder(name)
    memory.append(resident())

    def one(text: str) -> tuple[Times, Times]:
        scenarios: list[Scenario] = []
        reading = timed(lambda: scenarios.append(scenario_of(text, settings)))

        def choose() -> None:
            with suppress(NothingFits):
                retrieve(scenarios[0], library, embedder, settings)

        return reading, timed(choose)

    first = sum(one(behaviors[0].description))
    memory.append(resident())
    print(f"packaged library: {len(library)} snippets, {len(behaviors)} of them behaviors; embedder {embedder.name}")
    print(f"  first sentence in a process: {first[0]:.1f} s ({first[1]:.1f})")
    print("  memory: {:.0f} MB, with the encoder {:.0f} MB, with all of it {:.0f} MB".format(*memory))
    reading, choosing = zip(*(one(snippet.description) for snippet in behaviors), strict=True)
    print(f"  reading a further sentence, {len(reading)} of them: {spread(reading)}")
    print(f"  retrieving its triple: {spread(choosing)}")
    return embedder


# A large library


def made(real: Vectors, count: int, seed: int) -> Vectors:
    """Rows like those of sentences about two things: two real ones in random shares, plus noise."""
    rng = np.random.default_rng(seed)
    one, other = real[rng.integers(len(real), size=(2, count))]
    share = rng.random((count, 1), np.float32)
    noise = rng.standard_normal(one.shape, np.float32) * np.float32(NOISE / np.sqrt(real.shape[1]))
    rows = share * one + (1 - share) * other + noise
    return np.asarray(rows / np.linalg.norm(rows, axis=1, keepdims=True), np.float32)


def numpy_exact(rows: Vectors, query: Vectors) -> Rows:
    cosines = rows @ query[0]
    best = np.argpartition(-cosines, COUNT)[:COUNT]
    return best[np.argsort(-cosines[best])]


def line(name: str, search: Callable[[Vectors], Rows], queries: Vectors, exact: list[Rows], base: float) -> float:
    """Time a search and compare what it finds with `exact`, which the first one fills; the median of its CPU time."""
    times: list[Times] = []
    found: list[Rows] = []
    for i in range(len(queries)):
        began = clocks()
        found.append(search(queries[i : i + 1]))
        times.append(clocks() - began)
    recall = np.mean([len(np.intersect1d(a, b)) / COUNT for a, b in zip(found, exact, strict=True)]) if exact else 1.0
    exact.extend([] if exact else found)
    median = float(np.median(np.array(times)[:, 1]))
    ratio = median / base if base else 1.0
    print(f"  {name:<34} {spread(times)}; {ratio:.2f} of numpy's; recall@{COUNT} {recall:.3f}")
    return median


def large(real: Vectors, size: int, hnsw: bool) -> None:
    rows = np.vstack([real, made(real, size - len(real), 0)]) if size > len(real) else real[:size]
    queries = made(real, QUERIES, 1)
    print(f"{size} rows: {len(real)} real, the rest made from them; {QUERIES} queries made alike, one at a time")
    exact: list[Rows] = []
    base = line("numpy, exact", lambda q: numpy_exact(rows, q), queries, exact, 0.0)
    for exact_up_to in (size, size - 1):
        ours(rows, exact_up_to, queries, exact, base)
    if hnsw:
        graph(rows, queries, exact, base)
    print(f"  memory of the process: {resident():.0f} MB, {rows.nbytes / 1e6:.0f} MB of it the rows")


def ours(rows: Vectors, exact_up_to: int, queries: Vectors, exact: list[Rows], base: float) -> None:
    began = clocks()
    index = build(rows, exact_up_to=exact_up_to)
    wall, cpu = clocks() - began
    name = "faiss, exact" if index.lists == 1 else f"faiss, {index.lists} lists"
    print(f"  {name}: built in {wall:.1f} s ({cpu:.1f}), {held(index.core):.0f} MB")
    read = {"": 0} if index.lists == 1 else {f", {n} read": n for n in (PROBED // 8, PROBED // 4, PROBED // 2, PROBED)}
    for suffix, probed in read.items():
        line(name + suffix, lambda q, p=probed: index._nearest(q, COUNT, p)[1], queries, exact, base)


def graph(rows: Vectors, queries: Vectors, exact: list[Rows], base: float) -> None:
    index = faiss.IndexHNSWFlat(rows.shape[1], HNSW[0], faiss.METRIC_INNER_PRODUCT)
    index.hnsw.efSearch = HNSW[1]
    wall, cpu = timed(lambda: index.add(rows))
    print(f"  HNSW{HNSW[0]}: built in {wall:.1f} s ({cpu:.1f}), {held(index):.0f} MB")
    line(f"HNSW{HNSW[0]}, {HNSW[1]} looked at", lambda q: index.search(q, COUNT)[1], queries, exact, base)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--embedder", default="minilm")
    parser.add_argument("--size", type=int, default=100_000, help="rows of the large library")
    parser.add_argument("--hnsw", action="store_true", help="build HNSW too, which takes minutes")
    given = parser.parse_args()
    with tempfile.TemporaryDirectory() as cache:
        os.environ["XDG_CACHE_HOME"] = cache
        embedder = packaged(given.embedder)
        wordings = [text for snippet in load_library() for text in (snippet.description, *snippet.rephrasings)]
        real = encode_cached(embedder, wordings)
    for size in (len(real), 20_000, given.size):
        large(real, size, given.hnsw)


if __name__ == "__main__":
    main()
