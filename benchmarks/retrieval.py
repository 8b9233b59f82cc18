"""How long reading a sentence and retrieving its triple take on the packaged library.

    OMP_NUM_THREADS=1 python benchmarks/retrieval.py [--embedder minilm]

Nothing is read from the user's cache. Times are of one thread of this machine, by the clock and, in brackets, of the
processor, which a busy machine changes less. Linux only.
"""

from __future__ import annotations

import argparse
import os
import tempfile
import time
from collections.abc import Callable, Sequence
from contextlib import suppress
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from chatscene.errors import NothingFits
from chatscene.interpret.asked import scenario_of
from chatscene.interpret.retrieve import retrieve
from chatscene.library.load import load_library
from chatscene.models.encoders.embedding import load_embedder
from chatscene.settings import RetrievalSettings
from chatscene.terms.scenario import Component, Scenario

Times = NDArray[np.float64]  # by the clock and of the processor, s


def resident() -> float:
    """Memory of this process now, in MB."""
    pages = int(Path("/proc/self/statm").read_text(encoding="ascii").split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE") / 1e6


def clocks() -> Times:
    return np.array([time.perf_counter(), time.process_time()])


def timed(work: Callable[[], object]) -> Times:
    began = clocks()
    work()
    return clocks() - began


def spread(times: Sequence[Times]) -> str:
    (wall, cpu), (wall95, cpu95) = 1e3 * np.quantile(np.array(times), (0.5, 0.95), axis=0)
    return f"median {wall:.2f} ms, p95 {wall95:.2f} ms ({cpu:.2f}, {cpu95:.2f})"


def packaged(name: str) -> None:
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


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--embedder", default="minilm")
    given = parser.parse_args()
    with tempfile.TemporaryDirectory() as cache:
        os.environ["XDG_CACHE_HOME"] = cache
        packaged(given.embedder)


if __name__ == "__main__":
    main()
