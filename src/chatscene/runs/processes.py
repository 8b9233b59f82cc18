"""Work in processes of this machine."""

from __future__ import annotations

import os
import pickle
import signal
import sys
import threading
from collections.abc import Callable, Generator, Mapping
from concurrent.futures import Future, ProcessPoolExecutor
from contextlib import contextmanager
from functools import cache
from multiprocessing import connection, forkserver, get_context, parent_process, resource_tracker
from multiprocessing.shared_memory import ShareableList
from types import FrameType
from typing import Any

_SAFE_PATH, _PATHS = "PYTHONSAFEPATH", "PYTHONPATH"
_LOADED_ONCE = ["chatscene.runs.searching"]  # and with it Scenic, which takes longest


class Processes(ProcessPoolExecutor):
    """Processes that begin without this one's state, and without the working folder among the places of modules.

    Python puts it first in a process that is started with ``-c``, as these are, unless it is told otherwise. On Linux
    they are forked from a process that loads what most of them need, once for all pools of this one.
    """

    def __init__(self, max_workers: int, *, initializer: Callable[..., object], initargs: tuple[Any, ...]) -> None:
        self._before = os.environ.get(_SAFE_PATH)
        os.environ[_SAFE_PATH] = "1"
        context, begun_with = _context()
        names = {*os.environ, *begun_with}
        differs = {name: os.environ.get(name) for name in names if os.environ.get(name) != begun_with.get(name)}
        # Not by the pipe: it holds less, and this process would wait for ever for a child that died before it read it.
        self._setup = ShareableList([pickle.dumps((differs, initializer, initargs))])
        super().__init__(max_workers, mp_context=context, initializer=_begin, initargs=(self._setup.shm.name,))

    def submit(self, fn: Callable[..., Any], /, *args: Any) -> Future[Any]:  # pyright: ignore[reportIncompatibleMethodOverride]
        """Call a function by a worker that is free; see `chatscene.runs.executor.Executor`.

        The first call starts all workers: one that an interrupt cut off half started could not be ended.
        """
        with _interrupted_after():
            return super().submit(fn, *args)

    def shutdown(self, wait: bool = True, *, cancel_futures: bool = False) -> None:
        """Take no more; see `chatscene.runs.executor.Executor`. Who does not wait ends what is being done."""
        working = [] if wait else list((self._processes or {}).values())
        super().shutdown(wait, cancel_futures=cancel_futures)
        for one in working:
            one.kill()
        self._setup.shm.close()
        self._setup.shm.unlink()
        _set(_SAFE_PATH, self._before)


def _context() -> tuple[Any, Mapping[str, str]]:
    """How processes are started, and with which environment."""
    if sys.platform != "linux":
        return get_context("spawn"), os.environ
    before = os.environ.get(_PATHS)
    os.environ[_PATHS] = os.pathsep.join(filter(None, sys.path))  # so that what it loads is what is loaded here
    try:
        forkserver.set_forkserver_preload(_LOADED_ONCE)
        with _uninterrupted():
            forkserver.ensure_running()
        return get_context("forkserver"), _as_it_was()
    except ChildProcessError:  # this process is a fork of one that has started one
        return get_context("spawn"), os.environ
    finally:
        _set(_PATHS, before)


@contextmanager
def _interrupted_after() -> Generator[None]:
    """Have a keyboard interrupt wait until what is done inside is done, or has failed; then who handles it hears it."""
    heard: list[FrameType | None] = []
    before = signal.getsignal(signal.SIGINT)
    if threading.current_thread() is not threading.main_thread() or not callable(before):  # it is ignored, or ends us
        yield
        return
    signal.signal(signal.SIGINT, lambda _, frame: heard.append(frame))
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)
        if heard:
            before(signal.SIGINT, heard[0])


@contextmanager
def _uninterrupted() -> Generator[None]:
    """Have what is started inside not hear of a keyboard interrupt, which is this process's to handle.

    A terminal tells it to all processes of a command, and a process that is forked or started inherits what is blocked.
    """
    resource_tracker.ensure_running()  # else it would be started inside, and lets interrupts through again
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


@cache
def _as_it_was() -> Mapping[str, str]:
    """The environment of when this was asked first: when the process was started that others are forked from."""
    return dict(os.environ)


def _set(name: str, value: str | None) -> None:
    if value is None:
        os.environ.pop(name, None)
    else:
        os.environ[name] = value


def _begin(setup: str) -> None:
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # where it was not blocked before
    threading.Thread(target=_die_with_parent, daemon=True).start()
    shared: ShareableList[bytes] = ShareableList(name=setup)
    differs, initializer, initargs = pickle.loads(shared[0])  # noqa: S301 - its parent's own
    shared.shm.close()
    for name, value in differs.items():
        _set(name, value)
    initializer(*initargs)


def _die_with_parent() -> None:
    """A worker whose run was killed must not go on."""
    parent = parent_process()
    if parent is not None:
        connection.wait([parent.sentinel])
        os._exit(1)
