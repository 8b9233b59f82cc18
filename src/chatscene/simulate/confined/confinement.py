"""The second wall: what a process gives up before it looks at a stranger's program. Linux only; needs no root.

Each layer stands by itself, and what one kernel lacks another layer mostly covers; `docs/security.md` has the table.
"""

from __future__ import annotations

import ctypes
import os
import resource
import signal
import sys
import sysconfig
import warnings
from collections.abc import Callable, Collection, Iterable
from dataclasses import dataclass
from typing import Any

from chatscene.errors import SandboxError
from chatscene.simulate.confined.audit import watch
from chatscene.simulate.confined.landlock import landlock_version, read_only
from chatscene.simulate.confined.seccomp import filter_system_calls, no_new_privileges
from chatscene.simulate.watchdog import BACKSTOP, PATIENCE

_NEW_IPC, _NEW_USER, _NEW_NET = 0x08000000, 0x10000000, 0x40000000
_PR_SET_DUMPABLE, _PR_SET_PDEATHSIG = 4, 1
_OPEN_FILES = 64

LIMITS, NAMESPACES, LANDLOCK, SECCOMP, AUDIT = "limits", "namespaces", "landlock", "seccomp", "audit"
KERNEL = (LIMITS, NAMESPACES, LANDLOCK, SECCOMP)
LAYERS = (*KERNEL, AUDIT)


@dataclass(frozen=True, slots=True, kw_only=True)
class Limits:
    """What a stranger's program may use up.

    Attributes:
        answer: Processor time for one answer [s]: compiling, placing a scene, one step.
        wall: Wall time for one answer [s], for a program that waits instead of computing.
        processor: Processor time in all [s].
        memory: Address space beyond what the simulator itself takes [MB].
        message: Longest answer [bytes].
    """

    answer: float = PATIENCE
    wall: float = BACKSTOP
    processor: int = 120
    memory: int = 1024
    message: int = 4_000_000


def confine(limits: Limits, readable: Iterable[str], end: Callable[[str], Any]) -> tuple[str, ...]:
    """Give up for ever, in this process, everything but computing.

    Args:
        limits: Time and memory.
        readable: Files and folders beside Python's own that may be read.
        end: Told what was tried when the watchman ends the process.

    Returns:
        The layers in force, of `LAYERS`.
    """
    readable = (*readable, *python_folders())
    layers = give_up(limits, readable)
    watch(readable, end)
    return (*layers, AUDIT)


def give_up(limits: Limits, readable: Iterable[str], program: str = "") -> tuple[str, ...]:
    """Have the kernel take from this process, for ever, everything but computing.

    Args:
        limits: Time and memory.
        readable: Files and folders that may be read, beside the libraries of the system.
        program: The file of another program that this process is about to become; empty for none.

    Returns:
        The layers in force, of `KERNEL`.
    """
    no_new_privileges()
    _limit(limits)
    alone = _leave_network()
    # After the change of namespace, which makes the kernel forget both: end with the parent, hide our memory.
    ctypes.CDLL(None).prctl(_PR_SET_PDEATHSIG, signal.SIGKILL, 0, 0, 0)
    ctypes.CDLL(None).prctl(_PR_SET_DUMPABLE, 0, 0, 0, 0)
    layers = {
        LIMITS: True,
        NAMESPACES: alone,
        LANDLOCK: landlock_version() > 0
        and read_only((*readable, *_SHARED_LIBRARIES), (program, *_LOADERS) if program else ()),
        # Last of the kernel's walls, since it forbids putting up the others.
        SECCOMP: filter_system_calls(starting=bool(program)),
    }
    return tuple(name for name, stands in layers.items() if stands)


def check_layers(layers: Collection[str], of: Iterable[str]) -> None:
    """Warn of layers that are missing where others will do.

    Raises:
        SandboxError: The others will not do.
    """
    if SECCOMP not in layers:
        raise SandboxError(
            "this kernel or machine cannot confine programs by strangers (no seccomp filter on "
            f"{os.uname().machine}); run chatscene on Linux on x86_64 or aarch64"
        )
    if LANDLOCK not in layers and os.geteuid() == 0:
        raise SandboxError(
            "this kernel has no Landlock, and to root every file is open: programs by strangers are not run; "
            "run chatscene as another user, or on Linux 5.13 or later"
        )
    if missing := [layer for layer in of if layer not in layers]:
        warnings.warn(
            f"programs by strangers run without {', '.join(missing)} here; docs/security.md says what that means",
            RuntimeWarning,
            stacklevel=3,
        )


def python_folders() -> tuple[str, ...]:
    """Where Python's own modules and the installed packages lie."""
    library = [sysconfig.get_path(name) for name in ("stdlib", "platstdlib", "purelib", "platlib")]
    return tuple(sorted({os.path.realpath(path) for path in (*library, *sys.path) if path and os.path.exists(path)}))  # noqa: PTH110


_LOADERS = ("/lib64/ld-linux-x86-64.so.2", "/lib/ld-linux-aarch64.so.1")  # what the kernel starts a program with
_SHARED_LIBRARIES = ("/lib", "/lib64", "/usr/lib", "/usr/lib64", "/etc/ld.so.cache")


def _limit(limits: Limits) -> None:
    room = _address_space() + limits.memory * 2**20
    for what, limit in (
        (resource.RLIMIT_CPU, limits.processor),
        (resource.RLIMIT_AS, room),
        (resource.RLIMIT_FSIZE, 0),
        (resource.RLIMIT_CORE, 0),
        (resource.RLIMIT_NOFILE, _OPEN_FILES),
        (resource.RLIMIT_NPROC, 0),  # the kernel does not hold root to it; the filter on system calls does
    ):
        _, hard = resource.getrlimit(what)
        most = limit if hard == resource.RLIM_INFINITY else min(limit, hard)
        # Processor time: a signal first, which tells the cause, and one second later the end that cannot be put off.
        resource.setrlimit(what, (most, most + 1 if what == resource.RLIMIT_CPU and most != hard else most))


def _address_space() -> int:
    """What this process takes now [bytes]."""
    with open("/proc/self/statm", encoding="ascii") as file:  # noqa: PTH123
        return int(file.read().split()[0]) * resource.getpagesize()


def _leave_network() -> bool:
    """Move to namespaces of our own, which hold no network and nobody's shared memory."""
    libc = ctypes.CDLL(None, use_errno=True)
    return any(libc.unshare(kinds) == 0 for kinds in (_NEW_USER | _NEW_NET | _NEW_IPC, _NEW_NET | _NEW_IPC))
