"""Work on the machines of a Ray cluster."""

from __future__ import annotations

import os
import uuid
from collections.abc import Callable
from concurrent.futures import BrokenExecutor, Executor, Future
from contextlib import chdir
from importlib import import_module
from typing import Any

from chatscene.errors import SettingsError

ray: Any = import_module("ray")  # an extra that is too large for tests, so that nothing may ask for its types
AGAIN = 3  # how often Ray itself gives a task to another worker that is lost with one
LOOPBACK = "127.0.0.1"


class RayExecutor(Executor):
    """Tasks of a Ray cluster, a core each.

    What is sent and what comes back is pickled; who can reach a cluster's ports, and knows its token if it has one,
    runs code on it. A cluster that is started here is reached from this machine alone.

    Args:
        max_workers: How many tasks at a time the caller means to submit; Ray does as many at a time as it has cores.
        initializer: What each worker calls first.
        initargs: With what.
        address: ``HOST:PORT`` of the cluster; empty for that in ``RAY_ADDRESS``, or a new one on this machine.

    Raises:
        SettingsError: There is no cluster to reach there.
    """

    def __init__(
        self,
        max_workers: int,
        *,
        initializer: Callable[..., object],
        initargs: tuple[Any, ...],
        address: str = "",
    ) -> None:
        self._is_mine = not ray.is_initialized()
        if self._is_mine:
            _connect(address, max_workers)
        self._name = uuid.uuid4().hex
        self._setup = ray.put((initializer, initargs))
        self._call: Any = ray.remote(_called).options(num_cpus=1, max_retries=AGAIN)

    def submit(self, fn: Callable[..., Any], /, *args: Any) -> Future[Any]:  # pyright: ignore[reportIncompatibleMethodOverride]
        """Call a function; see `chatscene.runs.executor.Executor`."""
        promised: Future[Any] = Future()
        promised.set_running_or_notify_cancel()
        come: Future[Any] = self._call.remote(self._name, self._setup, fn, args).future()
        come.add_done_callback(lambda done: _settle(promised, done))
        return promised

    def shutdown(self, wait: bool = True, *, cancel_futures: bool = False) -> None:  # noqa: ARG002
        """Leave the cluster, which drops whatever of this is still being done there."""
        if self._is_mine:
            ray.shutdown()


def _connect(address: str, cores: int) -> None:
    """Reach a cluster or start one; nothing is told to anybody else, and no worker imports from the working folder."""
    os.environ.setdefault("RAY_USAGE_STATS_ENABLED", "0")
    os.environ.setdefault("RAY_raylet_start_wait_time_s", "300")  # on a machine with much else to do
    quiet: dict[str, Any] = {"include_dashboard": False} if not address else {}
    own = {"num_cpus": cores, "_node_ip_address": LOOPBACK, **quiet}
    mine = not address and "RAY_ADDRESS" not in os.environ
    try:
        with chdir("/"):  # Ray lets its workers import from where the driver stands when it connects
            ray.init(address or None, log_to_driver=False, configure_logging=False, **(own if mine else {}))
    except (ConnectionError, ray.exceptions.RayError, RuntimeError, ValueError) as error:
        raise SettingsError(f"no Ray cluster at {address or 'RAY_ADDRESS'}: {error}") from error


_begun = ""


def _called(name: str, setup: tuple[Callable[..., object], tuple[Any, ...]], fn: Callable[..., Any], args: Any) -> Any:
    """A task, in a worker, which begins once for each executor."""
    global _begun  # noqa: PLW0603 - the worker's own, as long as it is there
    if _begun != name:
        initializer, initargs = setup
        initializer(*initargs)
        _begun = name
    return fn(*args)


def _settle(promised: Future[Any], done: Future[Any]) -> None:
    error: Any = done.exception()
    if error is None:
        promised.set_result(done.result())
    elif isinstance(error, ray.exceptions.RayTaskError):
        promised.set_exception(error.cause)
    elif isinstance(error, ray.exceptions.RayError):
        promised.set_exception(BrokenExecutor(str(error)))
    else:
        promised.set_exception(error)
