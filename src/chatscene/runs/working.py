"""Work on a folder as it is told of: how long it took, and how it ended."""

from __future__ import annotations

import shlex
import time
from collections.abc import Generator, Iterable
from contextlib import contextmanager, suppress
from pathlib import Path

from chatscene.errors import ChatSceneError, MeansSomethingElse, NothingFits
from chatscene.runs.atomic import sweep
from chatscene.runs.digests import digests
from chatscene.runs.exclusive import alone
from chatscene.runs.progress import Progress
from chatscene.runs.record import Record, Status
from chatscene.runs.workspace import Workspace, inside, take_up, update

OFTEN = 2.0  # [s] after which the time that was spent is written down: to write costs more than a short drive


@contextmanager
def working(run: Workspace, progress: Progress) -> Generator[Progress]:
    """Write down the time that is spent inside, and the error that ends it; an interruption says how to go on.

    Yields:
        What to tell of progress, which adds the time since it was last written down to the total and to what was told
        then, when something else is told or after `OFTEN`: a kill costs no more than that.
    """
    since, doing = time.monotonic(), ""

    def clock() -> None:
        nonlocal since
        before, since = since, time.monotonic()
        spent = since - before
        update(run, timings={"total": spent} | ({doing: spent} if doing else {}))

    def tell(what: str, done: int, total: int) -> None:
        nonlocal doing
        if what != doing or time.monotonic() - since > OFTEN:
            clock()
        doing = what
        progress(what, done, total)

    try:
        yield tell
    except KeyboardInterrupt as error:
        error.add_note(f"what was finished is kept; continue with: chatscene resume {shlex.quote(str(run.path))}")
        raise
    except (NothingFits, MeansSomethingElse) as error:
        update(run, status=Status.REFUSED, reason=str(error))
        raise
    except ChatSceneError as error:
        update(run, status=Status.FAILED, reason=str(error))
        raise
    except Exception as error:  # what nobody foresaw, such as that there is no memory, even to write this down
        with suppress(ChatSceneError, MemoryError):
            update(run, status=Status.FAILED, reason=f"{type(error).__name__}: {error}".rstrip(": "))
        raise
    clock()


@contextmanager
def going_on(
    folder: Path, asked: Record, progress: Progress, *, leaves: Iterable[str]
) -> Generator[tuple[Workspace, Progress]]:
    """Work on a folder from where it stands, new or not, and end it.

    Yields:
        The folder, and what to tell of progress.

    Raises:
        RunError: The folder holds something else, or another process works on it.
    """
    with alone(folder):
        run = take_up(folder, asked)
        sweep(folder)
        update(run, status=Status.RUNNING, files={})  # what is done may change now: no digest holds meanwhile
        with working(run, progress) as tell:
            yield run, tell
        update(run, status=Status.DONE, files=digests(folder, leaves), inside=inside(folder))
