"""Make a map into Scenic's network, within a time, for the process that asked; see `chatscene.maps.apart`."""

from __future__ import annotations

import ctypes
import json
import math
import os
import resource
import signal
import sys
import time
from pathlib import Path
from typing import Any

from chatscene.errors import ChatSceneError, UnreadRoad

_PR_SET_PDEATHSIG = 1


def main() -> None:
    """Tell, line by line in JSON on the standard output, which road it is at, and a fault at the end if there is one.

    The arguments: the map, the file to write the network to, and the processor time [s] for it. Memory there is as much
    as the machine has: who takes more is to end, and nobody else.
    """
    answers = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(2, 1)  # no word of a library is taken for an answer

    def tell(**said: str) -> None:
        answers.write(json.dumps(said) + "\n")
        answers.flush()

    path, made, within = Path(sys.argv[1]), Path(sys.argv[2]), int(sys.argv[3])
    try:
        _make(path, made, within, tell)
    except UnreadRoad as error:
        tell(fault=str(error), road=error.road)
    except ChatSceneError as error:
        tell(fault=str(error))
    except MemoryError:
        tell(lacks="memory")


def _make(path: Path, made: Path, within: int, tell: Any) -> None:
    from scenic.formats.opendrive import xodr_parser

    from chatscene.maps import network
    from chatscene.maps.apart import JOINING

    of_road = xodr_parser.Road.calculate_geometry

    def calculate_geometry(road: Any, *rest: Any, **named: Any) -> Any:
        tell(at=f"it was at road '{road.id_}'")
        done = of_road(road, *rest, **named)
        tell(at=JOINING)  # unless another road follows
        return done

    road_type: Any = xodr_parser.Road
    road_type.calculate_geometry = calculate_geometry
    root = network.check_opendrive(path)

    def make() -> Any:
        made_of_it = network.parsed(path)
        made_of_it.dumpPickle(made, *network.marks_of(path))
        return made_of_it

    _hold(within)
    network.furnished(path, root, make)


def _hold(within: int) -> None:
    """Let the kernel end this process after so much more processor time [s], and refuse it more than all memory.

    On Linux it also ends with who asked for it, whatever that was ended by.
    """
    if sys.platform == "linux":
        ctypes.CDLL(None).prctl(_PR_SET_PDEATHSIG, signal.SIGKILL, 0, 0, 0)
    memory = os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE")
    for what, most in (
        (resource.RLIMIT_CPU, math.ceil(time.process_time()) + within),
        (resource.RLIMIT_AS, memory),
        (resource.RLIMIT_CORE, 0),
    ):
        _, hard = resource.getrlimit(what)
        # Processor time: a signal first, which tells the cause, and later the end.
        least = most if hard == resource.RLIM_INFINITY else min(most, hard)
        resource.setrlimit(what, (least, hard))


if __name__ == "__main__":
    main()
