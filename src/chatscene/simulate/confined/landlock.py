"""Which files a process may see: Linux' Landlock, which any process can put on itself (``man 7 landlock``).

After it, only the given folders and files can be read, nothing but in given folders can be written, made, moved or
deleted, no TCP port can be opened or reached, and no process outside can be signalled. Kernels from 5.13 on have it,
newer ones more of it.
"""

from __future__ import annotations

import ctypes
import os
import stat
import struct
from collections.abc import Iterable

_CREATE, _ADD, _RESTRICT = 444, 445, 446  # the same numbers on every machine
_ASK_VERSION = 1
_BENEATH = 1
_EXECUTE, _READ_FILE, _READ_FOLDER = 1 << 0, 1 << 2, 1 << 3
_ALL = (1 << 16) - 1
_OF_FILES = _EXECUTE | 1 << 1 | _READ_FILE | 1 << 14 | 1 << 15  # what can be done to a file: also write, cut, control
_FILE_RIGHTS = {1: 13, 2: 14, 3: 15, 4: 15, 5: 16}  # how many kinds of access to files each version knows
_TCP = 0b11  # bind and connect, from version 4 on
_SCOPES = 0b11  # abstract sockets and signals, from version 6 on


def landlock_version() -> int:
    """Which version the kernel has; 0 for none."""
    return max(0, _call(_CREATE, None, 0, _ASK_VERSION))


def read_only(paths: Iterable[str], programs: Iterable[str] = ()) -> bool:
    """Let this process read what lies in the given folders, and those files, and nothing else, for ever.

    Args:
        paths: Folders and files; what does not exist is passed over.
        programs: Files that it may read and become.

    Returns:
        Whether it is so; False if the kernel has no Landlock.
    """
    return _restrict([*((path, 0) for path in paths), *((program, _EXECUTE) for program in programs)], network=False)


def kept_to(readable: Iterable[str], writable: Iterable[str], *, network: bool) -> bool:
    """Let this process, and all that it starts, read and start what lies in some folders and write in others, for ever.

    Args:
        readable: Folders and files that may be read, and programs in them that may be started.
        writable: Folders and files in which everything may be done.
        network: Whether TCP ports may be opened and reached.

    Returns:
        Whether it is so; False if the kernel has no Landlock.
    """
    return _restrict([*((path, _EXECUTE) for path in readable), *((path, _ALL) for path in writable)], network=network)


def _restrict(granted: Iterable[tuple[str, int]], *, network: bool) -> bool:
    version = landlock_version()
    if version == 0:
        return False
    handled = (1 << _FILE_RIGHTS.get(version, 16)) - 1
    tcp = _TCP if version >= 4 and not network else 0
    attributes = struct.pack("=QQQ", handled, tcp, _SCOPES if version >= 6 else 0)
    size = 8 if version < 4 else 16 if version < 6 else 24
    rules = _call(_CREATE, attributes, size, 0)
    if rules < 0:
        return False
    try:
        return all(_allow(rules, path, more & handled) for path, more in granted) and _call(_RESTRICT, rules, 0) == 0
    finally:
        os.close(rules)


def _allow(rules: int, path: str, more: int) -> bool:
    try:
        place = os.open(path, os.O_PATH | os.O_CLOEXEC)
    except OSError:
        return True
    try:
        folder = stat.S_ISDIR(os.fstat(place).st_mode)
        access = (more | _READ_FILE | _READ_FOLDER) if folder else ((more | _READ_FILE) & _OF_FILES)
        return _call(_ADD, rules, _BENEATH, struct.pack("=Qi", access, place), 0) == 0
    finally:
        os.close(place)


def _call(number: int, *arguments: bytes | int | None) -> int:
    """A system call that the C library has no function for."""
    libc = ctypes.CDLL(None, use_errno=True)
    libc.syscall.restype = ctypes.c_long
    return libc.syscall(number, *(ctypes.c_long(a) if isinstance(a, int) else a for a in arguments))
