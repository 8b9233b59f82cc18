"""How much speed somebody gains or loses whom a watcher sees to do so: by it drives are judged, and programs built."""

from __future__ import annotations

from chatscene.terms.actors import RoadUser

GAIN = 2.0  # [m/s] that somebody gains who accelerates …
SHARE_GAINED = 0.5  # … or this share of what is fast for a kind, where that is less
LOST = 1.5  # [m/s] that somebody loses who slows down …
SHARE_LOST = 0.2  # … or this share of the speed that it had, where that is less


def gain_of(row: RoadUser) -> float:
    """How much speed [m/s] somebody of a kind gains whom a watcher sees to accelerate."""
    return min(GAIN, SHARE_GAINED * min(row.fast, row.limits.top_speed))


def loss_of(speed: float) -> float:
    """How much speed [m/s] somebody loses whom a watcher sees to slow down, of what it had."""
    return min(LOST, SHARE_LOST * speed)
