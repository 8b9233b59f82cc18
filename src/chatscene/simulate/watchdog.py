"""A time limit for code that may never come back.

What counts is processor time, so that a busy machine ends nothing that an idle one would not. Code that waits uses
none; for it there is a limit of wall time, so long that load alone hardly reaches it.
"""

from __future__ import annotations

import signal
import threading
import time
from collections.abc import Generator
from contextlib import contextmanager
from types import FrameType

from chatscene.errors import StuckBehavior

PATIENCE = 20.0  # [s] of processor time for one episode, which normally takes some ten milliseconds
BACKSTOP = 300.0  # [s] of wall time for the same


@contextmanager
def time_limit(what: str) -> Generator[None]:
    """Interrupt the block once this process has computed for `PATIENCE`, or `BACKSTOP` has passed, since it began.

    Works in the main thread, where signals arrive; worker processes run their work there. In other threads the
    block is not limited. While an inner block runs, the clocks of the outer one stand still.

    Raises:
        StuckBehavior: The block took longer.
    """
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    began = time.process_time()

    def computed(_signal: int, _frame: FrameType | None) -> None:
        raise computes_for_ever(what, PATIENCE)

    def waited(_signal: int, _frame: FrameType | None) -> None:
        raise waits_for_ever(what, BACKSTOP, time.process_time() - began)

    clocks = (
        (signal.ITIMER_PROF, signal.SIGPROF, computed, PATIENCE),
        (signal.ITIMER_REAL, signal.SIGALRM, waited, BACKSTOP),
    )
    # Again and again: an exception raised while Python runs a finaliser is lost, and its block would run on.
    outer = [
        (signal.signal(number, end), signal.setitimer(clock, limit, limit)) for clock, number, end, limit in clocks
    ]
    try:
        yield
    finally:
        for clock, *_ in clocks:
            signal.setitimer(clock, 0.0)
        for (clock, number, _, _), (end, left) in zip(clocks, outer, strict=True):
            signal.signal(number, end)
            if left != (0.0, 0.0):
                signal.setitimer(clock, *left)


@contextmanager
def unlimited() -> Generator[None]:
    """Let the clocks of the limits around the block stand still: for work that is not the program's.

    The block needs a limit of its own, as a call to a server has.
    """
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    left = [(clock, signal.setitimer(clock, 0.0)) for clock in (signal.ITIMER_PROF, signal.ITIMER_REAL)]
    try:
        yield
    finally:
        for clock, rest in left:
            signal.setitimer(clock, *rest)


def computes_for_ever(what: str, limit: float) -> StuckBehavior:
    """The error for what has used up its processor time [s]."""
    within = f"{limit:g} s of processor time"
    return StuckBehavior(
        f"{what} did not come back within {within}; something in it probably loops without `take` or `wait`",
        within=within,
    )


def waits_for_ever(what: str, limit: float, spent: float) -> StuckBehavior:
    """The error for what has not used up its processor time [s], and yet does not come to its end."""
    within = (
        f"{limit:g} s, in which it computed for {spent:.1f} s: "
        "it waits for something, or this machine has too much else to do"
    )
    return StuckBehavior(f"{what} did not come back within {within}", within=within)
