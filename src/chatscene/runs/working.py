"""Work on a folder as it is told of: how long it took, and how it ended."""

from __future__ import annotations

import time
from collections.abc import Generator
from contextlib import contextmanager

from chatscene.errors import ChatSceneError, MeansSomethingElse, NothingFits
from chatscene.runs.progress import Progress
from chatscene.runs.record import Status
from chatscene.runs.workspace import Workspace, update


@contextmanager
def working(run: Workspace, progress: Progress) -> Generator[Progress]:
    """Write down the time that is spent inside, and the error that ends it.

    Yields:
        What to tell of progress, which adds the time since it was last told: a kill costs no more than that.
    """
    since = time.monotonic()

    def clock() -> None:
        nonlocal since
        before, since = since, time.monotonic()
        update(run, timings={"total": since - before})

    def tell(what: str, done: int, total: int) -> None:
        clock()
        progress(what, done, total)

    try:
        yield tell
    except (NothingFits, MeansSomethingElse) as error:
        update(run, status=Status.REFUSED, reason=str(error))
        raise
    except ChatSceneError as error:
        update(run, status=Status.FAILED, reason=str(error))
        raise
    clock()
