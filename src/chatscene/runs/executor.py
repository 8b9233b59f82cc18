"""Where the parts of a run are worked on: one Protocol, one table of names.

An executor is what `concurrent.futures` calls one, and is made as its pools are; so those of other packages will do.
"""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import Future
from dataclasses import dataclass
from functools import partial
from typing import Any, Protocol

from chatscene.errors import SettingsError
from chatscene.plugins import Kind, check_name, make, without_address
from chatscene.settings import EXECUTOR


class Executor(Protocol):
    """Calls functions elsewhere; made with ``max_workers``, and ``initializer`` and ``initargs`` by name.

    Every worker calls the initializer before anything else. What a function returns is the future's result, and what
    it raises is raised by that, as it was. What was submitted to a worker that is lost meanwhile is done by another,
    or the future raises `concurrent.futures.BrokenExecutor`. Functions, what they take and what they return are
    pickled; an executor that unpickles what it was not sent by its own workers is none.
    """

    def submit(self, fn: Callable[..., Any], /, *args: Any) -> Future[Any]:
        """Call a function of a module with arguments, by a worker that is free."""
        ...

    def shutdown(self, wait: bool = True, *, cancel_futures: bool = False) -> None:
        """Take no more; with `cancel_futures`, drop what no worker began with."""
        ...


EXECUTORS: Kind[Executor] = Kind(
    noun="executor",
    group="chatscene.executors",
    method="submit",
    built_in={
        EXECUTOR: "chatscene.runs.processes:Processes",
        "ray": "chatscene.runs.ray_cluster:RayExecutor [ray]",
    },
    forms=("ray:HOST:PORT",),
    addressed=frozenset({"ray"}),
)


@dataclass(frozen=True, slots=True)
class Workers:
    """Who works.

    Attributes:
        jobs: How many at a time, at least one; any number gives the same.
        executor: Where they are, by name (`EXECUTORS`); any gives the same.
    """

    jobs: int = 1
    executor: str = EXECUTOR

    def __post_init__(self) -> None:
        if self.jobs < 1:
            raise SettingsError(f"jobs is {self.jobs}; use at least one")
        check_name(EXECUTORS, self.executor)

    def needed(self, tasks: int) -> int:
        """How many workers so many tasks need; 0 if they are done in this process."""
        count = min(self.jobs, tasks)
        return 0 if count <= 1 and self.executor == EXECUTOR else count

    def here(self) -> Workers:
        """As many, on this machine."""
        return Workers(self.jobs)


ONE = Workers()  # this process


def load_executor(name: str, count: int, initializer: Callable[..., object], *setup: Any) -> Executor:
    """An executor with so many workers, each of which begins with a call.

    Raises:
        SettingsError: There is none of that name, or it cannot be reached.
        MissingExtra: Its package is missing.
    """
    bare = without_address(EXECUTORS, name)
    made = partial(make, EXECUTORS, name, count, initializer=initializer, initargs=setup)
    return made(address=name.partition(":")[2]) if bare in EXECUTORS.addressed else made()
