"""A filter on system calls: after it, a process can read files, use memory and time, and nothing else.

Linux' seccomp takes a small program that judges each system call (``man 2 seccomp``). Ours is an allow-list: what is
not on it fails with EPERM. There is no call on it that makes a process or a thread, a socket, or a file; that sends
a signal, looks into another process, or changes a limit. Files are opened for reading only, which the filter sees
from the flags. A filter can be made stricter later, never looser, whatever runs behind it.
"""

from __future__ import annotations

import ctypes
import errno
import platform
import struct
from dataclasses import dataclass

_PR_SET_SECCOMP, _PR_SET_NO_NEW_PRIVS = 22, 38
_MODE_FILTER = 2
_LOAD, _JUMP_EQUAL, _JUMP_FROM, _JUMP_ANY_BIT, _RETURN = 0x20, 0x15, 0x35, 0x45, 0x06
_ALLOW, _KILL = 0x7FFF0000, 0x80000000
_REFUSE = 0x00050000 | errno.EPERM
_NUMBER, _MACHINE, _SECOND, _THIRD = 0, 4, 24, 32  # offsets in struct seccomp_data; the last two are of arguments
_OPENING_TO_WRITE = 0o3 | 0o100 | 0o1000  # access mode, O_CREAT, O_TRUNC
_BUT_DUPLICATING = 0xFFFFFFFC  # what asks fcntl for more than F_DUPFD, F_GETFD, F_SETFD and F_GETFL
_IO_URING_SETUP = 425  # of every machine; through it sockets are made without a call of their own
_OTHER_NUMBERS = 0x40000000  # from where x86_64 has the same calls by other numbers (x32)


@dataclass(frozen=True, slots=True)
class _Machine:
    """The numbers of one kind of machine (``asm/unistd.h``, ``linux/audit.h``).

    `starting` are the calls that the start of a program needs besides; `openat` and, for it, `fcntl` are judged by
    what they ask for. `socket` is on no list.
    """

    audit: int
    openat: int
    fcntl: int
    socket: int
    allowed: dict[str, int]
    starting: dict[str, int]


_X86_64 = _Machine(
    0xC000003E,
    257,
    72,
    41,
    {
        "read": 0, "write": 1, "close": 3, "fstat": 5, "poll": 7, "lseek": 8, "mmap": 9, "mprotect": 10,
        "munmap": 11, "brk": 12, "rt_sigaction": 13, "rt_sigprocmask": 14, "rt_sigreturn": 15, "pread64": 17,
        "readv": 19, "access": 21, "select": 23, "sched_yield": 24, "mremap": 25, "madvise": 28, "nanosleep": 35,
        "getitimer": 36, "alarm": 37, "setitimer": 38, "getpid": 39, "exit": 60, "uname": 63, "getcwd": 79,
        "readlink": 89, "gettimeofday": 96, "getrusage": 98, "times": 100, "getuid": 102, "getgid": 104,
        "geteuid": 107, "getegid": 108, "sigaltstack": 131, "gettid": 186, "futex": 202, "sched_getaffinity": 204,
        "getdents64": 217, "restart_syscall": 219, "clock_gettime": 228, "clock_getres": 229,
        "clock_nanosleep": 230, "exit_group": 231, "newfstatat": 262, "readlinkat": 267, "faccessat": 269,
        "pselect6": 270, "ppoll": 271, "getrandom": 318, "membarrier": 324, "statx": 332, "rseq": 334,
        "faccessat2": 439,
    },
    {"execve": 59, "arch_prctl": 158, "set_tid_address": 218, "set_robust_list": 273, "stat": 4, "lstat": 6},
)  # fmt: skip
_AARCH64 = _Machine(
    0xC00000B7,
    56,
    25,
    198,
    {
        "read": 63, "write": 64, "close": 57, "fstat": 80, "lseek": 62, "mmap": 222, "mprotect": 226, "munmap": 215,
        "brk": 214, "rt_sigaction": 134, "rt_sigprocmask": 135, "rt_sigreturn": 139, "pread64": 67, "readv": 65,
        "sched_yield": 124, "mremap": 216, "madvise": 233, "nanosleep": 101, "getitimer": 102, "setitimer": 103,
        "getpid": 172, "exit": 93, "uname": 160, "getcwd": 17, "gettimeofday": 169, "getrusage": 165, "times": 153,
        "getuid": 174, "getgid": 176, "geteuid": 175, "getegid": 177, "sigaltstack": 132, "gettid": 178,
        "futex": 98, "sched_getaffinity": 123, "getdents64": 61, "restart_syscall": 128, "clock_gettime": 113,
        "clock_getres": 114, "clock_nanosleep": 115, "exit_group": 94, "newfstatat": 79, "readlinkat": 78,
        "faccessat": 48, "pselect6": 72, "ppoll": 73, "getrandom": 278, "membarrier": 283, "statx": 291,
        "rseq": 293, "faccessat2": 439,
    },
    {"execve": 221, "set_tid_address": 96, "set_robust_list": 99},
)  # fmt: skip
_MACHINES = {"x86_64": _X86_64, "aarch64": _AARCH64}


class _Program(ctypes.Structure):
    _fields_ = (("length", ctypes.c_ushort), ("filter", ctypes.c_void_p))


def no_new_privileges() -> bool:
    """Whether this process has given up ever gaining privileges, which the other walls need."""
    libc = ctypes.CDLL(None, use_errno=True)
    return libc.prctl(_PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0


def filter_system_calls(*, starting: bool = False) -> bool:
    """Put the filter on this process, for ever; False if the kernel or the machine has none.

    Args:
        starting: Whether this process may become another program, which the filter goes on to hold.
    """
    machine = _MACHINES.get(platform.machine())
    if machine is None:
        return False
    allowed, judged = [*machine.allowed.values()], [(machine.openat, _THIRD, _OPENING_TO_WRITE)]
    if starting:
        allowed += machine.starting.values()
        judged.append((machine.fcntl, _SECOND, _BUT_DUPLICATING))
    return _put_on(_assemble(machine.audit, allowed, judged))


def filter_sockets() -> bool:
    """Let this process, and all that it starts, make no socket, for ever; False if the kernel or the machine cannot.

    Pairs of sockets that lead nowhere else can still be made.
    """
    machine = _MACHINES.get(platform.machine())
    if machine is None:
        return False
    steps = [
        *_number_of_call(machine.audit),
        (_JUMP_FROM, 3, 0, _OTHER_NUMBERS),
        (_JUMP_EQUAL, 2, 0, machine.socket),
        (_JUMP_EQUAL, 1, 0, _IO_URING_SETUP),
        (_RETURN, 0, 0, _ALLOW),
        (_RETURN, 0, 0, _REFUSE),
    ]
    return _put_on(_packed(steps))


def _put_on(code: bytes) -> bool:
    if not no_new_privileges():
        return False
    room = ctypes.create_string_buffer(code, len(code))
    program = _Program(len(code) // 8, ctypes.addressof(room))
    libc = ctypes.CDLL(None, use_errno=True)
    return libc.prctl(_PR_SET_SECCOMP, _MODE_FILTER, ctypes.byref(program), 0, 0) == 0


def _assemble(audit: int, allowed: list[int], judged: list[tuple[int, int, int]]) -> bytes:
    """The filter as the kernel reads it: 8 bytes an instruction, jumps count instructions to skip.

    Judged calls are given with the offset of an argument and the bits that it may not have.
    """
    steps = _number_of_call(audit)
    for i, (number, argument, forbidden) in enumerate(judged, 1):
        left = 3 * (len(judged) - i) + len(allowed)
        steps += [
            (_JUMP_EQUAL, 0, 2, number),
            (_LOAD, 0, 0, argument),
            (_JUMP_ANY_BIT, left, left + 1, forbidden),
        ]
    steps += [(_JUMP_EQUAL, len(allowed) - i, 0, number) for i, number in enumerate(allowed)]
    steps += [(_RETURN, 0, 0, _REFUSE), (_RETURN, 0, 0, _ALLOW)]
    return _packed(steps)


def _number_of_call(audit: int) -> list[tuple[int, int, int, int]]:
    """Hold a call to being one of this machine, and take its number."""
    return [
        (_LOAD, 0, 0, _MACHINE),
        (_JUMP_EQUAL, 1, 0, audit),
        (_RETURN, 0, 0, _KILL),  # called as another kind of machine, whose numbers mean other calls
        (_LOAD, 0, 0, _NUMBER),
    ]


def _packed(steps: list[tuple[int, int, int, int]]) -> bytes:
    return b"".join(struct.pack("=HBBI", *step) for step in steps)
