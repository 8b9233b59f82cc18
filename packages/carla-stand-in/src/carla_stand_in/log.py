"""What the server says, as much as somebody can read: what clients send decides how much there would be."""

from __future__ import annotations

import time
from collections.abc import Callable

MOST = 200  # lines
DURING = 10.0  # [s]


class Bounded:
    """Passes lines on, so many in a time; how many it left out it says before the next.

    Args:
        log: Is told.
        clock: Tells the time [s].
    """

    def __init__(self, log: Callable[[str], None], clock: Callable[[], float] = time.monotonic) -> None:
        self._log, self._clock = log, clock
        self._since, self._count = clock(), 0

    def __call__(self, line: str) -> None:
        """Say a line, or leave it out."""
        if (now := self._clock()) - self._since > DURING:
            if self._count > MOST:
                self._log(f"{self._count - MOST} more lines within {DURING:g} s were left out")
            self._since, self._count = now, 0
        self._count += 1
        if self._count <= MOST:
            self._log(line)
