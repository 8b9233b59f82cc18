"""The wheel's traffic manager, which lives in a client, can miss the word that a step began; here it is woken.

In a synchronous tick the wheel sets a flag and wakes the thread that plans for the cars, but holds no lock meanwhile:
if that thread has looked at the flag and does not sleep yet, it is woken in vain, and both wait for ever. That was seen
in a debugger, at hundreds of ticks a second on a busy machine. Whoever changes the manager's mode from synchronous to
asynchronous wakes that thread, too, which then does the one cycle that it owes; the mode is set back at once.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from typing import Any

PATIENCE = 1.0  # [s] from the answer to a tick to the first call of the cycle that follows
_LONGEST = 2.0  # [s] for a connection


async def wake(host: str, port: int, pack: Callable[[Any], bytes]) -> None:
    """Wake the traffic manager of a client by its own remote calls.

    Args:
        host: Of the client.
        port: Of its traffic manager.
        pack: Msgpack.

    Raises:
        OSError: It cannot be reached, or does not answer.
    """
    async with asyncio.timeout(_LONGEST):
        reader, writer = await asyncio.open_connection(host, port)
        try:
            for number, mode in enumerate((False, True)):
                writer.write(pack([0, number, "set_synchronous_mode", [mode]]))
            await reader.read(1)
        finally:
            writer.close()
