"""Maps of clients are read in a process of their own first: whoever else calls is answered meanwhile.

The wheel holds Python's lock while it reads a map, so a thread would hold up all others. The server itself then reads
the map once more, but for what was found; a map for which even that would take long is refused.
"""

from __future__ import annotations

import asyncio
import json
import os
import sys
import time
from dataclasses import asdict

from carla_stand_in.roads import Found, Roads, Signal
from chatscene.errors import ChatSceneError, MapError

PROCESSOR_TIME = 30  # [s], of a reading
READING = 3.0  # [s] of the processor, for which others may wait
LOOKING = 0.005  # [s] of the processor, for one look at the road below a place
_MEMORY = 8 * 2**30  # bytes
_LONGEST = 120.0  # [s] of a reading, on a busy machine
_PLACES = 20
_OURS = "ours"


async def read(name: str, text: str, *, ours: bool = False) -> Found:
    """What is found in a map.

    Args:
        name: What clients see as the map's name.
        text: OpenDRIVE.
        ours: Whether it was named at the start: it may take what it takes then.

    Raises:
        MapError: It cannot be used, or takes too long.
    """
    # -P: the working folder is no place of modules
    command = [sys.executable, "-P", "-m", "carla_stand_in.reading", name, *[_OURS] * ours]
    pipe = asyncio.subprocess.PIPE
    process = await asyncio.create_subprocess_exec(*command, stdin=pipe, stdout=pipe, stderr=asyncio.subprocess.DEVNULL)
    try:
        async with asyncio.timeout(None if ours else _LONGEST):
            said, _ = await process.communicate(text.encode(errors="surrogateescape"))
    except TimeoutError:
        raise MapError(f"map {name!r} was not read within {_LONGEST:g} s") from None
    finally:
        if process.returncode is None:
            process.kill()
            await process.wait()
    if process.returncode:
        raise MapError(
            f"map {name!r} cannot be read: that takes more than {PROCESSOR_TIME} s of the processor, more than "
            f"{_MEMORY // 2**30} GiB, or breaks the wheel"
        )
    told = json.loads(said)
    if "fault" in told:
        raise MapError(told["fault"])
    if not ours and (told["reading"] > READING or told["looking"] > LOOKING):
        raise MapError(
            f"map {name!r} takes {told['reading']:.1f} s to be read and {1e3 * told['looking']:.1f} ms for each look "
            f"at a road; others wait meanwhile, for which {READING:g} s and {1e3 * LOOKING:g} ms are allowed"
        )
    signals = (
        Signal(
            id=one["id"],
            location=tuple(one["location"]),
            rotation=tuple(one["rotation"]),
            stops=tuple(tuple(stop) for stop in one["stops"]),
            junction=one["junction"],
        )
        for one in told["signals"]
    )
    return Found(told["text"], told["spawn_points"], tuple(signals))


def main() -> None:
    """Read the map that is on the standard input; tell of it, in JSON, on the standard output."""
    answers = os.dup(1)
    os.dup2(2, 1)  # no word of the wheel is taken for an answer
    name, *rest = sys.argv[1:]
    if rest != [_OURS]:
        import resource  # which other systems than Unix have not

        for what, most in ((resource.RLIMIT_CPU, PROCESSOR_TIME), (resource.RLIMIT_AS, _MEMORY)):
            resource.setrlimit(what, (most, most))
    try:
        told = _told(name, sys.stdin.buffer.read().decode(errors="surrogateescape"))
    except ChatSceneError as error:
        told = {"fault": str(error)}
    with os.fdopen(answers, "w", encoding="utf-8") as file:
        json.dump(told, file)


def _told(name: str, text: str) -> dict[str, object]:
    before = time.process_time()
    roads = Roads(name, text)
    reading = time.process_time() - before
    places = [place for place, _ in roads.spawn_points[:_PLACES]]
    before = time.process_time()
    for place in places:
        roads.ground(place)
    return {
        "reading": reading,
        "looking": (time.process_time() - before) / max(1, len(places)),
        "text": roads.text,
        "spawn_points": roads.spawn_points,
        "signals": [asdict(signal) for signal in roads.signals],
    }


if __name__ == "__main__":
    main()
