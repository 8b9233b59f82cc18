"""Spread the blocks of a run over processes.

A block needs what came of the blocks before it on the same route, and nothing else; so routes run side by
side, and any number of processes gives the same blocks.
"""

from __future__ import annotations

import os
import threading
from collections.abc import Callable, Generator, Iterable, Iterator, Mapping, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, as_completed, wait
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from dataclasses import dataclass
from multiprocessing import connection, get_context, parent_process
from pathlib import Path
from typing import Any, TypeVar

from chatscene.ego.policy import EgoPolicy, load_ego
from chatscene.errors import RunError
from chatscene.runs import Workspace, read_record, settings_of, write_block
from chatscene.runs.progress import Progress
from chatscene.runs.rebuild import map_of
from chatscene.search.climb import simulator_of
from chatscene.search.explore import outcomes
from chatscene.search.generator import load_generator
from chatscene.settings import Settings
from chatscene.simulate.simulator import Simulator
from chatscene.terms.outcome import Outcome
from chatscene.terms.scenario import Slots
from chatscene.terms.scene import ScenicProgram

_SAFE_PATH = "PYTHONSAFEPATH"

Setup = TypeVar("Setup")
Task = TypeVar("Task")
Result = TypeVar("Result")


@dataclass(frozen=True, slots=True, kw_only=True)
class Work:
    """What every process of a run needs to know.

    Attributes:
        folder: The run folder.
        generator: Who explores, by name.
        program: What to search with.
        slots: What was said.
        map_path: The map.
        ego: The surrogate ego, by name.
        settings: All settings.
        routes: On which routes.
    """

    folder: Path
    generator: str
    program: ScenicProgram
    slots: Slots
    map_path: Path
    ego: str
    settings: Settings
    routes: tuple[int, ...]

    @classmethod
    def of(cls, run: Workspace, slots: Slots, program: ScenicProgram, routes: Iterable[int]) -> Work:
        """What is to be done for a run folder, with a program on some routes."""
        record = read_record(run)
        return cls(
            folder=run.path,
            generator=record.generator,
            program=program,
            slots=slots,
            map_path=map_of(record),
            ego=record.ego,
            settings=settings_of(record),
            routes=tuple(routes),
        )

    @property
    def per_route(self) -> int:
        """How many blocks a route has."""
        return -(-self.settings.search.scenes // self.settings.search.block)

    def blocks(self) -> list[tuple[str, int, int]]:
        """Scenario, route and number of every block there has to be."""
        return [(self.program.scenario_id, route, n) for route in self.routes for n in range(self.per_route)]


class _Worker:
    """Runs one block after another and keeps what was compiled."""

    def __init__(self, work: Work) -> None:
        self._work = work
        self._ego: EgoPolicy = load_ego(work.ego)
        self._generator = load_generator(work.generator)
        self._simulator: Simulator = simulator_of(self._generator, work.map_path, work.settings)

    def run_block(self, route: int, done: list[list[Outcome]]) -> list[Outcome]:
        """Run and keep the next block of a route; what came of it."""
        work = self._work
        block = next(
            self._generator.explore(
                work.program,
                work.slots,
                route,
                simulator=self._simulator,
                ego=self._ego,
                settings=work.settings.search,
                done=done,
            )
        )
        write_block(Workspace(work.folder), block)
        return outcomes(block)


def run_blocks(
    work: Work, done: Mapping[tuple[str, int], list[list[Outcome]]], *, jobs: int, progress: Progress
) -> None:
    """Run every block that is not done yet, and keep each in the run folder.

    Args:
        work: The run.
        done: For each scenario and route, what came of each block that is done (`chatscene.runs.resume`).
        jobs: How many processes; 1 runs in this one.
        progress: Told after each block.

    Raises:
        RunError: A process died, or the folder cannot be written.
        ChatSceneError: Whatever a block raised.
    """
    history = {route: list(done.get((work.program.scenario_id, route), ())) for route in work.routes}
    open_routes = [route for route in sorted(history) if len(history[route]) < work.per_route]

    def tell() -> None:
        progress("searching, blocks", sum(map(len, history.values())), len(work.blocks()))

    if jobs == 1 or len(open_routes) <= 1:
        worker = _Worker(work)
        for route in open_routes:
            while len(history[route]) < work.per_route:
                history[route].append(worker.run_block(route, history[route]))
                tell()
        return
    try:
        _in_processes(work, history, open_routes, min(jobs, len(open_routes)), tell)
    except BrokenProcessPool as error:
        raise RunError(
            "a worker process was killed, perhaps for want of memory; nothing finished is lost: "
            f"continue with chatscene resume {work.folder}, perhaps with --jobs 1"
        ) from error


def _in_processes(
    work: Work,
    history: dict[int, list[list[Outcome]]],
    routes: list[int],
    jobs: int,
    tell: Callable[[], None],
) -> None:
    with _processes(jobs, _start_worker, work) as pool:

        def submit(route: int) -> Future[list[Outcome]]:
            return pool.submit(_run_block, route, history[route])

        pending = {submit(route): route for route in routes}
        try:
            while pending:
                finished, _ = wait(pending, return_when=FIRST_COMPLETED)
                for future in sorted(finished, key=lambda f: pending[f]):
                    route = pending.pop(future)
                    history[route].append(future.result())
                    tell()
                    if len(history[route]) < work.per_route:
                        pending[submit(route)] = route
        finally:
            pool.shutdown(wait=False, cancel_futures=True)


@contextmanager
def _processes(count: int, start: Callable[..., None], *setup: Any) -> Generator[ProcessPoolExecutor]:
    """Processes that begin without this one's state, and without the working folder among the places of modules.

    Python puts it first in a process that is started with ``-c``, as these are, unless it is told otherwise.
    """
    before = os.environ.get(_SAFE_PATH)
    os.environ[_SAFE_PATH] = "1"
    try:
        with ProcessPoolExecutor(count, mp_context=get_context("spawn"), initializer=start, initargs=setup) as pool:
            yield pool
    finally:
        if before is None:
            del os.environ[_SAFE_PATH]
        else:
            os.environ[_SAFE_PATH] = before


_worker: list[_Worker] = []


def _start_worker(work: Work) -> None:
    threading.Thread(target=_die_with_parent, daemon=True).start()
    _worker.append(_Worker(work))


def _run_block(route: int, done: list[list[Outcome]]) -> list[Outcome]:
    return _worker[0].run_block(route, done)


def spread(
    make: Callable[[Setup], Callable[[Task], Result]], setup: Setup, tasks: Sequence[Task], *, jobs: int
) -> Iterator[Result]:
    """Do tasks that do not depend on one another, in this process or in several.

    Args:
        make: Makes what does one task; called once per process, with `setup`.
        setup: What every process needs to know.
        tasks: What to do.
        jobs: How many processes.

    Yields:
        What each task came to, as it is done.

    Raises:
        RunError: A process died.
    """
    if jobs == 1 or len(tasks) <= 1:
        do = make(setup)
        yield from map(do, tasks)
        return
    with _processes(min(jobs, len(tasks)), _start_spread, make, setup) as pool:
        try:
            for future in as_completed([pool.submit(_do, task) for task in tasks]):
                yield future.result()
        except BrokenProcessPool as error:
            raise RunError(
                "a worker process was killed, perhaps for want of memory; nothing finished is lost: continue with "
                "chatscene resume DIR, perhaps with --jobs 1"
            ) from error
        finally:
            pool.shutdown(wait=False, cancel_futures=True)


_doing: list[Callable[[Any], Any]] = []


def _start_spread(make: Callable[[Any], Callable[[Any], Any]], setup: Any) -> None:
    threading.Thread(target=_die_with_parent, daemon=True).start()
    _doing.append(make(setup))


def _do(task: Any) -> Any:
    return _doing[0](task)


def _die_with_parent() -> None:
    """A worker whose run was killed must not go on writing into its folder."""
    parent = parent_process()
    if parent is not None:
        connection.wait([parent.sentinel])
        os._exit(1)
