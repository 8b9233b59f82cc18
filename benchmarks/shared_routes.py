"""Of the ten routes of a base scenario, how many each of ChatScene's scenarios shares with the baselines.

    python benchmarks/shared_routes.py

A line for each of the forty scenarios: how many of its first ten routes are among the baselines' first ten, and how
many stand at the same index. Routes are the same if their points are. Nothing is simulated.
"""

from __future__ import annotations

from contextlib import suppress

from chatscene.errors import MapError
from chatscene.maps.network import resolve_map
from chatscene.search.climb import simulator_of
from chatscene.search.generator import Generator, load_generator
from chatscene.settings import RetrievalSettings, Settings
from chatscene.terms.scenario import BaseScenario

ROUTES = 10


def routes(generator: Generator, text: str) -> list[bytes]:
    """The points of the first routes that a scenario is searched on."""
    settings = RetrievalSettings()
    program = generator.write(generator.read(text, settings), settings).program
    simulator = simulator_of(generator, resolve_map("town"), Settings())
    found: list[bytes] = []
    for index in range(simulator.routes(program)):
        with suppress(MapError):  # the adversary has no way there, so the search leaves it out too
            found.append(simulator.route(program, index).line.points.round(2).tobytes())
    return found[:ROUTES]


def main() -> None:
    """Print the comparison."""
    ours, theirs = load_generator("chatscene"), load_generator("advsim")
    apart = 0
    for base in BaseScenario:
        nominal = routes(theirs, theirs.texts(base)[0])
        for number, text in enumerate(ours.texts(base)):
            own = routes(ours, text)
            shared, aligned = len(set(own) & set(nominal)), sum(a == b for a, b in zip(own, nominal, strict=False))
            apart += aligned < ROUTES
            print(f"{base:<24} {number}  shared {shared:2d} of {len(own)}, at the same index {aligned:2d}", flush=True)
    print(f"{apart} of {8 * 5} scenarios drive other routes than the baselines, or the same in another order")


if __name__ == "__main__":
    main()
