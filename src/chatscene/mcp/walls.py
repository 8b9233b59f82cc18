"""The second wall around an agent's folder: the kernel, which knows no path that leads out.

The first is `chatscene.mcp.folder`, which refuses such names in words. After this one the process that works, and all
that it starts, can read Python, the packages and the system's libraries, and write to the folder, to a temporary one of
its own and to chatscene's caches: Landlock, from Linux 5.13 on. Without a language model on another machine it makes no
socket: a filter of system calls, on x86_64 and aarch64.
"""

from __future__ import annotations

import os
import sys
import tempfile
from pathlib import Path

from chatscene.errors import SettingsError
from chatscene.files.caches import cache_folder
from chatscene.models.language.protocol import LANGUAGE_MODELS
from chatscene.simulate.confined.confinement import python_folders
from chatscene.simulate.confined.landlock import kept_to
from chatscene.simulate.confined.seccomp import filter_sockets, no_new_privileges

SYSTEM = (
    "/usr", "/lib", "/lib64", "/bin", "/proc", "/sys/devices", "/sys/bus", "/sys/class", "/sys/fs/cgroup",
    "/dev/urandom", "/dev/random", "/etc/ld.so.cache", "/etc/localtime", "/etc/fonts",
)  # fmt: skip
NETWORK = ("/etc/hosts", "/etc/resolv.conf", "/etc/nsswitch.conf", "/etc/ssl", "/etc/pki", "/etc/gai.conf")
DEVICES = ("/dev/null", "/dev/shm")
OFFLINE = "offline"
LOCAL = ("gguf", "scripted")  # language models that are a file of this machine
NO_LANDLOCK = "this kernel has no Landlock: only chatscene's own checks keep agents in the folder"
NO_FILTER = (
    "this machine has no filter of system calls: agents are kept from TCP alone, and before Linux 6.7 from nothing"
)


def served_model(name: str) -> str:
    """A language model by the name that a user types, as the process knows it that works in an agent's folder.

    A file is named by its whole path. Models that somebody brings are refused: their code would be looked for there.

    Raises:
        SettingsError: It is none of those that are built in, or its file is not there.
    """
    kind, _, which = name.partition(":")
    if name == OFFLINE:
        return name
    if kind not in LANGUAGE_MODELS.built_in or not which.strip():
        known = ", ".join((OFFLINE, *(f"{one}:…" for one in LANGUAGE_MODELS.built_in)))
        raise SettingsError(f"{name[:60]!r} is not a language model that can read for agents; there are {known}")
    if kind not in LOCAL:
        return name
    file = os.path.realpath(which)
    if not os.path.isfile(file):  # noqa: PTH113 - Path.is_file() raises for a path that the system refuses
        raise SettingsError(f"{which[:200]!r}, the file of the language model, is not there")
    return f"{kind}:{file}"


def stay_in(folder: Path, temporary: Path, language_model: str = OFFLINE) -> tuple[str, ...]:
    """Give up for ever, in this process, every file but those of a folder and what working in it takes.

    Returns:
        What the kernel does not keep to here, in words.
    """
    os.environ["TMPDIR"] = tempfile.tempdir = str(temporary)
    os.environ["MPLCONFIGDIR"] = str(temporary)
    caches = cache_folder("code").parent
    caches.mkdir(parents=True, exist_ok=True)
    kind, _, file = language_model.partition(":")
    network = kind not in (OFFLINE, *LOCAL)
    readable = [*python_folders(), sys.prefix, sys.base_prefix, *SYSTEM, *(NETWORK if network else ())]
    if kind in LOCAL:
        readable.append(file)
    no_new_privileges()
    kept = kept_to(readable, [str(folder), str(temporary), str(caches), *DEVICES], network=network)
    alone = network or filter_sockets()
    return (*[NO_LANDLOCK] * (not kept), *[NO_FILTER] * (not alone))
