"""Read a map in a process of its own, which the kernel ends when its time is up.

What a map takes does not follow from how much is written in it: four hundred roads that all cross each other, a few
dozen kilobytes, are joined for minutes, in single calls of a geometry library that no signal interrupts. So whoever
cannot be sure of a map lets another process make the network, and reads what that has made. Only a map so small that
it takes seconds, whatever it is, is read where it is asked for: a process takes a second or two to start.

How much time there is follows from the number of pieces of the roads' lines and of their lane sections, since these are
what a sound map takes its time for. Per piece and section that is some 6 ms in CARLA's towns, and 30 ms where all of
them are cubics, as in what netconvert writes.
"""

from __future__ import annotations

import json
import math
import signal
import subprocess
import sys
import tempfile
from collections.abc import Callable, Generator
from contextlib import contextmanager
from pathlib import Path
from typing import Any
from xml.etree import ElementTree as Xml

from chatscene.errors import MapError, UnreadRoad

FEW_PARTS, FEW_ELEMENTS = 50, 500  # the worst map of so few that is known takes five seconds
START = 60  # [s] of the processor that every map has
PER_PART = 0.1  # [s] for each piece and section: three times what the dearest kind takes
LONGEST = 1800  # [s]; a city of 100 MB, written like CARLA's towns, takes a sixth of it

JOINING = "its roads were being joined, which takes long where many cross or lie on each other"


def takes_seconds(root: Xml.Element) -> bool:
    """Whether a map is so small that it takes seconds at most to be read, whatever is written in it."""
    return _parts(root) <= FEW_PARTS and sum(1 for _ in root.iter()) <= FEW_ELEMENTS


def time_for(root: Xml.Element) -> int:
    """How much processor time [s] the reading of a map is given."""
    return math.ceil(min(LONGEST, START + PER_PART * _parts(root)))


def read_apart(path: Path, root: Xml.Element, load: Callable[[Path], Any]) -> Any:
    """The network of a map, made by another process.

    Raises:
        MapError: It cannot be made into lanes, or not within its time or the memory of this machine; the road at which
            that was is named.
    """
    within = time_for(root)
    said, at = dict[str, str](), "it had not begun"
    with tempfile.TemporaryDirectory(prefix="chatscene-") as folder:
        made, log = Path(folder) / "network.snet", Path(folder) / "errors"
        with log.open("wb") as errors, _running(path, made, within, errors) as process:
            assert process.stdout is not None
            for line in process.stdout:
                said = json.loads(line)
                at = said.get("at", at)
        if "fault" in said:
            raise UnreadRoad(said["fault"], road=road) if (road := said.get("road")) else MapError(said["fault"])
        if process.returncode == 0 and made.exists():
            return load(made)
        last = log.read_text("utf-8", "replace").strip().rpartition("\n")[2]
    lacks = {
        -signal.SIGXCPU: f"that takes more than {within} s of the processor, the most for a map with so many "
        f"pieces of road and lane sections ({_parts(root)})",
        -signal.SIGKILL: "the process for it was killed, perhaps for want of memory",
        0: "that takes more memory than this machine has",
    }
    why = lacks.get(process.returncode, f"the process for it failed: {last or process.returncode}")
    raise MapError(
        f"map {path.name!r} cannot be made into lanes: {why}; when it ended, {at}; cut the map down ({path})"
    )


@contextmanager
def _running(path: Path, made: Path, within: int, errors: Any) -> Generator[subprocess.Popen[bytes]]:
    # -P: the working folder is no place of modules
    command = [sys.executable, "-P", "-m", "chatscene.maps.reading", str(path), str(made), str(within)]
    with subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=errors) as process:
        try:
            yield process
        except BaseException:
            process.kill()
            raise


def _parts(root: Xml.Element) -> int:
    return sum(1 for kind in ("geometry", "laneSection") for _ in root.iter(kind))
