"""Spread work over workers.

What a worker makes comes back, and only the process that spreads writes it down: workers may be on other machines,
and one that is lost leaves nothing half done.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, BrokenExecutor, Future, wait
from typing import Any, TypeVar

from chatscene.ego.policy import cut_off
from chatscene.errors import RunError
from chatscene.runs.executor import Workers, load_executor

LOST = 3  # how often in a row, with nothing done in between, workers may be lost

Setup = TypeVar("Setup")
Task = TypeVar("Task")
Result = TypeVar("Result")


def spread(
    make: Callable[[Setup], Callable[[Task], Result]],
    setup: Setup,
    tasks: Sequence[Task],
    *,
    workers: Workers,
    then: Callable[[Result], Iterable[Task]] = lambda _: (),
) -> Iterator[Result]:
    """Do tasks that do not depend on one another, in this process or by workers.

    Args:
        make: Makes what does one task; called once per worker, with `setup`.
        setup: What every worker needs to know.
        tasks: What to do.
        workers: Who does it.
        then: What is to be done because of a result, before what is left.

    Yields:
        What each task came to, as it is done.

    Raises:
        RunError: Workers are lost again and again.
        ChatSceneError: Whatever a task raised.
    """
    left = deque(tasks)
    count = workers.needed(len(left))
    if not count:
        do = make(setup)
        while left:
            result = do(left.popleft())
            left.extendleft(then(result))
            yield result
        return
    lost = 0
    while left:
        pool = load_executor(workers.executor, count, _begin, make, setup, frozenset(cut_off))
        pending: dict[Future[Result], Task] = {}
        waits = True
        try:
            while left or pending:
                while left and len(pending) < count:
                    pending[pool.submit(_do, left[0])] = left[0]
                    left.popleft()
                finished, _ = wait(pending, return_when=FIRST_COMPLETED)
                for future in finished:
                    result = future.result()
                    del pending[future]
                    lost = 0
                    left.extendleft(then(result))
                    yield result
        except BrokenExecutor as error:
            lost += 1
            if lost > LOST:
                raise RunError(
                    f"workers ended {lost} times in a row, perhaps for want of memory; nothing finished is lost: "
                    "continue with chatscene resume DIR, perhaps with --jobs 1; or a script that calls chatscene lacks "
                    'if __name__ == "__main__": before what it does'
                ) from error
            left.extendleft(pending.values())
        except KeyboardInterrupt:
            waits = False  # for nobody; what a worker has begun is done again
            raise
        finally:
            pool.shutdown(waits, cancel_futures=True)


_making: list[tuple[Callable[[Any], Callable[[Any], Any]], Any]] = []
_doing: list[Callable[[Any], Any]] = []


def _begin(make: Callable[[Any], Callable[[Any], Any]], setup: Any, told: frozenset[str]) -> None:
    """What a worker is to do; it is made for the first task, whose result tells what is wrong with it."""
    cut_off.update(told)
    _making[:], _doing[:] = [(make, setup)], []


def _do(task: Any) -> Any:
    if not _doing:
        make, setup = _making[0]
        _doing.append(make(setup))
    return _doing[0](task)
