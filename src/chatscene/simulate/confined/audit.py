"""A watchman inside Python: the interpreter tells it of every dangerous step, and it ends the process at once.

Python says itself that this is no wall (PEP 578): code that breaks the interpreter gets past it. The kernel's walls
stand behind. What it adds is that an attempt is fatal instead of an exception that can be caught and tried again,
and that it has a name.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Iterable
from typing import Any

_ENDING = (
    "os.system", "os.exec", "os.fork", "os.forkpty", "os.posix_spawn", "os.spawn", "os.startfile", "os.kill",
    "os.killpg", "os.putenv", "os.unsetenv", "os.remove", "os.rename", "os.rmdir", "os.mkdir", "os.link", "os.symlink",
    "os.truncate", "os.chmod", "os.chown", "os.utime", "os.setxattr", "os.chdir", "os.fchdir", "os.add_dll_directory",
    "os.lockf", "os.chflags", "os.fwalk", "pty.", "subprocess.", "socket.", "ssl.", "urllib.", "http.", "ftplib.",
    "smtplib.", "telnetlib.", "poplib.", "imaplib.", "nntplib.", "webbrowser.", "syslog.", "fcntl.", "msvcrt.",
    "winreg.", "shutil.", "tempfile.", "sqlite3.", "pickle.find_class", "ctypes.dlopen", "ctypes.dlsym",
    "ctypes.call_function", "ctypes.cdata", "ctypes.string_at", "ctypes.wstring_at", "ctypes.set_errno",
    "mmap.", "resource.", "signal.pthread_kill", "_thread.", "gc.get_objects", "gc.get_referrers",
    "gc.get_referents", "sys.addaudithook", "sys.settrace", "sys.setprofile", "sys.monitoring.", "sys._current_frames",
    "code.__new__", "function.__new__", "cpython.run_", "cpython.PyInterpreterState_New", "builtins.breakpoint",
    "builtins.input",
)  # fmt: skip
_LISTING = ("os.listdir", "os.scandir", "glob.glob", "os.walk")
_NEVER_IMPORTED = (
    "asyncio", "ctypes", "_ctypes", "dill", "ftplib", "http", "imaplib", "joblib", "mmap", "multiprocessing", "pdb",
    "poplib", "pty", "requests", "smtplib", "socket", "_socket", "socketserver", "ssl", "subprocess",
    "_posixsubprocess", "telnetlib", "urllib", "webbrowser",
    "_interpreters", "_xxsubinterpreters",  # in another interpreter nobody watches
)  # fmt: skip


def watch(roots: Iterable[str], end: Callable[[str], Any]) -> None:
    """Watch this process from now on; it cannot be undone.

    Args:
        roots: Folders and files that may be read.
        end: Told what was tried; it ends the process.
    """
    readable = tuple(os.path.realpath(root) for root in roots)

    def refused(event: str, arguments: tuple[Any, ...]) -> bool:
        if event == "open":
            return not _reads(arguments, readable)
        if event in _LISTING:
            return not _within(arguments[0] if arguments else ".", readable)
        if event == "import":
            return str(arguments[0]).partition(".")[0] in _NEVER_IMPORTED
        return event.startswith(_ENDING)

    def hook(event: str, arguments: tuple[Any, ...]) -> None:
        if refused(event, arguments):
            what = event if event != "open" else "open for writing" if _writes(arguments) else "open outside"
            end(what + _named(arguments))

    sys.addaudithook(hook)


def _named(arguments: tuple[Any, ...]) -> str:
    """The file, folder or module that something was tried with, to be told after it; empty if there is none."""
    first = arguments[0] if arguments else None
    if type(first) is bytes:
        first = first.decode("ascii", "replace")
    return f" {first}" if type(first) is str else ""  # nothing that may have code of its own


def _reads(arguments: tuple[Any, ...], readable: tuple[str, ...]) -> bool:
    return not _writes(arguments) and _within(arguments[0], readable)


def _writes(arguments: tuple[Any, ...]) -> bool:
    _, mode, flags = arguments
    return bool(isinstance(mode, str) and set(mode) & set("wax+")) or bool(
        isinstance(flags, int) and flags & (os.O_WRONLY | os.O_RDWR | os.O_CREAT | os.O_TRUNC)
    )


def _within(path: Any, readable: tuple[str, ...]) -> bool:
    if isinstance(path, int):
        return path > 2
    real = os.path.realpath(os.fsdecode(path) if path is not None else ".")
    return any(real == root or real.startswith(root + os.sep) for root in readable)
