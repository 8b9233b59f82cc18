"""What becomes of other people's OpenDRIVE: how many maps load, how many serve a straight road, why others do not.

    python benchmarks/maps_in.py FOLDER... [--only WORD] [--each] [--within SECONDS]

Each FOLDER is a maker: every `.xodr` below it counts. None of them is part of the project. A map *loads* if a road
network is made of it, as `chatscene map check` does; it *serves* if the base scenario of a straight road finds a route
there, as a sentence such as "the car ahead brakes hard" asks; it is *clean* if `chatscene map check` has no complaint.
Nothing is taken from a cache, and everything is read in this process, so that seconds are those of a first reading.

A refusal counts by the types of the error and of what caused it, and by the function in which that was raised; no
message is looked at. One message for each is shown, and the files.
"""

from __future__ import annotations

import os
import signal
import sys
import tempfile
import time
import warnings
from collections import Counter, defaultdict
from dataclasses import dataclass, field
from pathlib import Path
from traceback import walk_tb

import click

from chatscene.errors import MapError
from chatscene.maps import apart
from chatscene.maps.network import load_network
from chatscene.maps.routes import BASE_SCENARIO_QUERIES, find_routes
from chatscene.maps.survey import check_map
from chatscene.terms.scenario import BaseScenario


@dataclass(slots=True)
class Maker:
    """What was counted of a folder: files, loaded, serving, clean; seconds of the processor; refusals by kind."""

    count: Counter[str] = field(default_factory=Counter[str])
    seconds: float = 0.0
    refused: defaultdict[str, list[tuple[str, str]]] = field(
        default_factory=lambda: defaultdict[str, list[tuple[str, str]]](list)
    )


def kind_of(error: BaseException) -> str:
    """The types of an error and of its cause, and the function in which the last of them was raised."""
    types = [type(error).__name__]
    while error.__cause__ is not None:
        error = error.__cause__
        types.append(type(error).__name__)
    frames = [frame.f_code.co_name for frame, _ in walk_tb(error.__traceback__)]
    return f"{' from '.join(types)} in {frames[-1] if frames else '?'}"


def serves(path: Path) -> bool:
    """Whether a straight road is found there."""
    network = load_network(path)
    for query in BASE_SCENARIO_QUERIES[BaseScenario.STRAIGHT_OBSTACLE]:
        try:
            if find_routes(network, path.stem, query, 1):
                return True
        except MapError:
            continue
    return False


def counted(maker: Maker, path: Path, within: int) -> str:
    """Try one map and count it; what to say of it."""

    def late(*_: object) -> None:
        raise TimeoutError(f"more than {within} s")

    signal.signal(signal.SIGALRM, late)
    signal.alarm(within)
    began = time.process_time()
    maker.count["files"] += 1
    try:
        load_network(path)
        maker.count["loaded"] += 1
        straight = serves(path)
        maker.count["serves"] += straight
        problems = check_map(path)
        maker.count["clean"] += not problems
        told = "; ".join(["loads", *([] if straight else ["no straight road"]), *problems[:3]])
    except Exception as error:  # noqa: BLE001 - whatever comes is counted
        maker.refused[kind_of(error)].append((path.name, str(error)))
        told = f"{kind_of(error)}: {error}"
    finally:
        signal.alarm(0)
    maker.seconds += time.process_time() - began
    return f"{time.process_time() - began:.1f} s {told}"


@click.command()
@click.argument("folders", metavar="FOLDER...", nargs=-1, required=True, type=click.Path(path_type=Path, exists=True))
@click.option("--only", default="", help="Only files whose path holds this.")
@click.option("--each", is_flag=True, help="A line for each file.")
@click.option("--within", default=300, show_default=True, help="Seconds for each file.")
def main(folders: tuple[Path, ...], only: str, each: bool, within: int) -> None:
    """Print the tables."""
    warnings.simplefilter("ignore")
    apart.FEW_PARTS = apart.FEW_ELEMENTS = sys.maxsize  # in this process, where the cause of an error can be seen
    makers: dict[str, Maker] = {}
    with tempfile.TemporaryDirectory() as cache:
        os.environ["XDG_CACHE_HOME"] = cache
        for folder in folders:
            maker = makers[folder.name] = Maker()
            for path in sorted(p for p in folder.rglob("*.xodr") if only in str(p)):
                told = counted(maker, path, within)
                if each:
                    print(f"{folder.name}/{path.name}: {told}", flush=True)
    print("\n| maker | maps | load | serve a straight road | clean | s |\n|---|---:|---:|---:|---:|---:|")
    total = Counter[str]()
    for name, maker in makers.items():
        total += maker.count
        cells = [str(maker.count[cell]) for cell in ("files", "loaded", "serves", "clean")]
        print(f"| {name} | {' | '.join(cells)} | {maker.seconds:.0f} |")
    cells = [str(total[cell]) for cell in ("files", "loaded", "serves", "clean")]
    print(f"| all | {' | '.join(cells)} | {sum(maker.seconds for maker in makers.values()):.0f} |\n")
    kinds = defaultdict[str, list[tuple[str, str]]](list)
    for maker in makers.values():
        for kind, refusals in maker.refused.items():
            kinds[kind] += refusals
    for kind, refusals in sorted(kinds.items(), key=lambda pair: (-len(pair[1]), pair[0])):
        print(f"{len(refusals):4} {kind}: {', '.join(name for name, _ in refusals)}\n       {refusals[0][1]}")


if __name__ == "__main__":
    main()
