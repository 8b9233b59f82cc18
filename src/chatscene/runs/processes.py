"""Work in processes of this machine."""

from __future__ import annotations

import os
import pickle
import sys
import threading
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import connection, get_context, parent_process
from multiprocessing.shared_memory import ShareableList
from typing import Any

_SAFE_PATH = "PYTHONSAFEPATH"
_LOADED_ONCE = ["chatscene.runs.searching"]  # and with it Scenic, which takes longest


class Processes(ProcessPoolExecutor):
    """Processes that begin without this one's state, and without the working folder among the places of modules.

    Python puts it first in a process that is started with ``-c``, as these are, unless it is told otherwise. On Linux
    they are forked from a process that loads what most of them need, once for all pools of this one.

    Args:
        max_workers: How many.
        initializer: What each calls first.
        initargs: With what.
    """

    def __init__(self, max_workers: int, *, initializer: Callable[..., object], initargs: tuple[Any, ...]) -> None:
        self._before = os.environ.get(_SAFE_PATH)
        os.environ[_SAFE_PATH] = "1"
        # Not by the pipe: it holds less, and this process would wait for ever for a child that died before it read it.
        self._setup = ShareableList([pickle.dumps((dict(os.environ), initializer, initargs))])
        context = get_context("forkserver" if sys.platform == "linux" else "spawn")
        context.set_forkserver_preload(_LOADED_ONCE)
        super().__init__(max_workers, mp_context=context, initializer=_begin, initargs=(self._setup.shm.name,))

    def shutdown(self, wait: bool = True, *, cancel_futures: bool = False) -> None:
        """Take no more; see `chatscene.runs.executor.Executor`."""
        super().shutdown(wait, cancel_futures=cancel_futures)
        self._setup.shm.close()
        self._setup.shm.unlink()
        if self._before is None:
            os.environ.pop(_SAFE_PATH, None)
        else:
            os.environ[_SAFE_PATH] = self._before


def _begin(setup: str) -> None:
    threading.Thread(target=_die_with_parent, daemon=True).start()
    shared: ShareableList[bytes] = ShareableList(name=setup)
    environment, initializer, initargs = pickle.loads(shared[0])  # noqa: S301 - its parent's own
    shared.shm.close()
    os.environ.clear()  # that of when the process began from which it was forked
    os.environ.update(environment)
    initializer(*initargs)


def _die_with_parent() -> None:
    """A worker whose run was killed must not go on."""
    parent = parent_process()
    if parent is not None:
        connection.wait([parent.sentinel])
        os._exit(1)
