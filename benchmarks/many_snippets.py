"""What a library of ten thousand snippets costs: to load, and to find snippets for a sentence in.

    python benchmarks/many_snippets.py [--seed 0] [--keep FOLDER] [0 1000 10000]

A folder of so many snippets is made beside the packaged ones, in their proportions: packaged snippets under other
names, with ranges that are drawn. Each behavior has up to four wordings. Nobody looked at them, and `library lint` did
not check them: they are there to be many.

Times are processor time, that of the first sentence from the start of its process, that of later ones and of retrieval
the longest of five; memory is the peak of a process; *first* is with an empty cache folder, *later* in another
process that finds what the first one kept.
"""

from __future__ import annotations

import argparse
import json
import os
import random
import resource
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from contextlib import suppress
from dataclasses import replace
from pathlib import Path

from waited_for import LATER, SENTENCE

from chatscene import pipeline
from chatscene.errors import NothingFits
from chatscene.interpret.asked import scenario_of
from chatscene.interpret.retrieve import retrieve
from chatscene.interpret.situation_of import in_a_situation
from chatscene.library.load import library_with, load_library
from chatscene.library.snippet_file import ENDING, as_text, wordings_path, wordings_text
from chatscene.settings import RetrievalSettings, Settings
from chatscene.situations.phrases import Voice
from chatscene.situations.words import told
from chatscene.terms.scenario import Component
from chatscene.terms.snippet import ParameterRange, Snippet
from chatscene.terms.surroundings import Surroundings

SIZES = (0, 1_000, 10_000)
WORDINGS = 4


def drawn(parameter: ParameterRange, rng: random.Random) -> ParameterRange:
    """A narrower range."""
    low, high = sorted(rng.uniform(parameter.low, parameter.high) for _ in range(2))
    return replace(parameter, low=round(low, 3), high=round(high, 3))


def varied(snippet: Snippet, snippet_id: str, rng: random.Random) -> Snippet:
    """A snippet under another name and with other ranges."""
    parameters = tuple(drawn(p, rng) for p in snippet.parameters)
    source = snippet.source
    for old, new in zip(snippet.parameters, parameters, strict=True):
        before, _, rest = source.partition(f"param {old.name} = Range(")
        source = f"{before}param {old.name} = Range({new.low}, {new.high}){rest.partition(')')[2]}"
    return replace(snippet, id=snippet_id, parameters=parameters, source=source)


def worded(snippet: Snippet) -> tuple[str, ...]:
    """Ways to say what a behavior does, none twice."""
    whose = (replace(snippet.slots, adversary=kind) for kind in snippet.adversaries)
    situations = [in_a_situation(slots, (), Surroundings()) for slots in whose]
    texts = (told(situation, voice) for voice in Voice for situation in situations)
    different = {text.casefold(): text for text in texts}
    different.pop(snippet.description.casefold(), None)
    return tuple(different.values())[:WORDINGS]


def make_library(folder: Path, count: int, seed: int) -> None:
    """Write a folder of so many snippets; the same ones for the same seed."""
    rng = random.Random(seed)
    packaged = load_library()
    numbers = [len(packaged.of(component)) for component in Component]
    for number in range(count):
        component = rng.choices(tuple(Component), numbers)[0]
        snippet = varied(rng.choice(packaged.of(component)), f"{component}/many-{number:05}", rng)
        files = {folder / f"{snippet.id}{ENDING}": as_text(snippet)}
        if component is Component.BEHAVIOR:
            files[wordings_path(folder, snippet.id)] = wordings_text(worded(snippet))
        for path, text in files.items():
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")


def spent(work: Callable[[], object]) -> float:
    """Processor time [s]; a refusal is an answer like any other."""
    began = time.process_time()
    with suppress(NothingFits):
        work()
    return time.process_time() - began


def measure(folder: str) -> dict[str, float]:
    """What this process takes for a library: to load, for its first sentence and later ones, and to retrieve."""
    settings = RetrievalSettings(library=folder)
    whole = Settings(retrieval=settings)
    load = spent(lambda: library_with(folder))
    spent(lambda: pipeline.understand(SENTENCE, whole))
    first = time.process_time()
    later = [spent(lambda text=text: pipeline.understand(text, whole)) for text in LATER]
    scenarios = [scenario_of(text, settings) for text in LATER]
    library = library_with(folder)
    found = [spent(lambda one=one: retrieve(one, library, settings)) for one in scenarios]
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1000
    return {
        "snippets": len(library),
        "load": load,
        "first": first,
        "later": max(later),
        "retrieve": max(found),
        "peak": peak,
    }


def row_told(who: str, row: dict[str, float]) -> str:
    """A row of the table."""
    return (
        f"{row['snippets']:>8} {who:>6} {row['load']:>8.2f} {row['first']:>9.2f} "
        f"{row['later']:>8.3f} {row['retrieve']:>9.3f} {row['peak']:>8.0f}"
    )


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("sizes", nargs="*", type=int, default=SIZES)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--keep", help="a folder for the libraries, instead of one that is removed")
    parser.add_argument("--measure", help=argparse.SUPPRESS)
    given = parser.parse_args()
    if given.measure is not None:
        print(json.dumps(measure(given.measure)))
        return
    print("snippets  cache  load [s]  first [s] later [s] retrieve [s] peak [MB]")
    with tempfile.TemporaryDirectory() as temporary:
        for size in given.sizes:
            folder = Path(given.keep or temporary, f"snippets-{size}")
            if size and not folder.exists():
                make_library(folder, size, given.seed)
            kept = {**os.environ, "XDG_CACHE_HOME": f"{temporary}/cache-{size}"}
            for who in ("first", "later"):
                command = [sys.executable, __file__, "--measure", str(folder) if size else ""]
                said = subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True, env=kept)
                print(row_told(who, json.loads(said.stdout)), flush=True)


if __name__ == "__main__":
    main()
