"""Put up the kernel's walls without the watchman in Python, try them, and print what came of each attempt."""

import ctypes
import json
import os
import resource
import signal
import socket
import sys
import threading
from collections.abc import Callable
from pathlib import Path

from chatscene.simulate.confined import confinement
from chatscene.simulate.confined.confinement import Limits, confine

folder = Path(sys.argv[1])
PARENT = os.getppid()
libc = ctypes.CDLL(None, use_errno=True)


def _checked(result: int) -> None:
    if result < 0:
        raise OSError(ctypes.get_errno(), "the call failed")


ATTEMPTS: dict[str, Callable[[], object]] = {
    "read a file": (folder / "secret").read_text,
    "read another process": lambda: Path(f"/proc/{PARENT}/environ").read_bytes(),
    "write a file": lambda: (folder / "target").write_text("x"),
    "make a file": lambda: os.open(folder / "target", os.O_CREAT),
    "make a folder": (folder / "target").mkdir,
    "delete a file": (folder / "secret").unlink,
    "move a file": lambda: (folder / "secret").rename(folder / "target"),
    "change a file": lambda: os.truncate(folder / "secret", 0),
    "open a socket": lambda: socket.socket(socket.AF_INET, socket.SOCK_STREAM),
    "open a local socket": socket.socketpair,
    "fork": lambda: os.fork() or os._exit(0),
    "run a program": lambda: os.execv("/bin/true", ["true"]),
    "start a thread": lambda: threading.Thread(target=int).start(),
    "signal another process": lambda: os.kill(PARENT, 0),
    "raise a limit": lambda: resource.setrlimit(resource.RLIMIT_NOFILE, (999, 999)),
    "leave the session": lambda: os.setpgid(0, 0),
    "read foreign memory": lambda: _checked(libc.ptrace(16, PARENT, 0, 0)),
    "fork below Python": lambda: _checked(libc.syscall(57 if os.uname().machine == "x86_64" else 220, 17, 0, 0, 0, 0)),
    "mount": lambda: _checked(libc.mount(b"none", b"/", b"tmpfs", 0, None)),
    "signal by a handle": lambda: signal.pidfd_send_signal(0, 0),
}


def _attempt(act: Callable[[], object]) -> str:
    try:
        act()
    except (OSError, RuntimeError, ValueError) as error:
        return type(error).__name__
    return "done"


def _nobody(roots: object, end: object) -> None:
    """In the watchman's place."""


confinement.watch = _nobody
confine(Limits(), (), lambda _: None)
print(json.dumps({what: _attempt(act) for what, act in ATTEMPTS.items()}))
sys.stdout.flush()
os._exit(0)
