"""How near the ego is to somebody: along its road, and in seconds."""

from __future__ import annotations

import math

from chatscene.program.watching import Seen

AGAINST = math.radians(150)  # from the ego's direction, who comes against it
SLOWEST = 1.0  # [m/s] of who is taken to come near


def how_near(seen: Seen, step: int, *, in_seconds: bool, leaves: bool = True) -> tuple[float, ...]:
    """How near the ego is to somebody at a step, in each way that people mean it.

    In metres it is the room from nose to tail, or that from the ego's nose to where somebody crosses; in seconds the
    time to collision, the headway, and the time that the ego needs to where somebody crosses. Of who comes against the
    ego and stays on its road it is the time to collision alone.

    Args:
        seen: Who.
        step: When.
        in_seconds: Whether it is said in seconds.
        leaves: Whether who comes against the ego leaves its road then, as who turns does.
    """
    lead = abs(float(seen.lead[step]))
    room, front = lead - (seen.ego.length + seen.track.length) / 2, lead - seen.ego.length / 2
    if not in_seconds:
        return room, front
    ego, own = float(seen.ego.speed[step]), float(seen.track.speed[step])
    if abs(float(seen.bearing[step])) > AGAINST and not leaves:
        return (room / max(ego + own, SLOWEST),)
    closing = abs(ego - own) if abs(float(seen.bearing[step])) < 1.0 else ego
    return room / max(closing, SLOWEST), room / max(ego, SLOWEST), front / max(ego, SLOWEST)
