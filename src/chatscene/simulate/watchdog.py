"""A time limit for code that may never come back."""

from __future__ import annotations

import signal
import threading
from collections.abc import Generator
from contextlib import contextmanager
from types import FrameType

from chatscene.errors import StuckBehavior

PATIENCE = 20.0  # [s] of wall time for one episode, which normally takes some ten milliseconds


@contextmanager
def time_limit(seconds: float, what: str) -> Generator[None]:
    """Interrupt the block after `seconds` of wall time.

    Works in the main thread, where signals arrive; worker processes run their work there. In other threads the
    block is not limited.

    Raises:
        StuckBehavior: The block took longer.
    """
    if threading.current_thread() is not threading.main_thread():
        yield
        return

    def interrupt(_signal: int, _frame: FrameType | None) -> None:
        raise StuckBehavior(
            f"{what} did not come back within {seconds:g} s; a behavior in it probably loops without `take` or `wait`"
        )

    previous = signal.signal(signal.SIGALRM, interrupt)
    # Again and again: an exception raised while Python runs a finaliser is lost, and its block would run on.
    signal.setitimer(signal.ITIMER_REAL, seconds, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, previous)
