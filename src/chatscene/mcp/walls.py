"""The second wall around an agent's folder: the kernel, which knows no path that leads out.

The first is `chatscene.mcp.folder`, which refuses such names in words. After this one the process that works, and all
that it starts, can read Python, the packages and the system's libraries, and write to the folder, to a temporary one of
its own and to chatscene's caches; without a language model on another machine it reaches no network.
"""

from __future__ import annotations

import os
import sys
import tempfile
from pathlib import Path

from chatscene.files.caches import cache_folder
from chatscene.simulate.confined.confinement import python_folders
from chatscene.simulate.confined.landlock import kept_to
from chatscene.simulate.confined.seccomp import no_new_privileges

SYSTEM = (
    "/usr", "/lib", "/lib64", "/bin", "/proc", "/sys/devices", "/sys/bus", "/sys/class", "/sys/fs/cgroup",
    "/dev/urandom", "/dev/random", "/etc/ld.so.cache", "/etc/localtime", "/etc/fonts",
)  # fmt: skip
NETWORK = ("/etc/hosts", "/etc/resolv.conf", "/etc/nsswitch.conf", "/etc/ssl", "/etc/pki", "/etc/gai.conf")
DEVICES = ("/dev/null", "/dev/shm")
OFFLINE, LOCAL = "offline", "gguf:"


def stay_in(folder: Path, temporary: Path, language_model: str = OFFLINE) -> bool:
    """Give up for ever, in this process, every file but those of a folder and what working in it takes.

    Args:
        folder: The agent's.
        temporary: A folder for what is in between.
        language_model: Who reads sentences.

    Returns:
        Whether the kernel keeps to it; False where it has no Landlock.
    """
    os.environ["TMPDIR"] = tempfile.tempdir = str(temporary)
    os.environ["MPLCONFIGDIR"] = str(temporary)
    caches = cache_folder("code").parent
    caches.mkdir(parents=True, exist_ok=True)
    network = language_model != OFFLINE and not language_model.startswith(LOCAL)
    readable = [*python_folders(), sys.prefix, sys.base_prefix, *SYSTEM, *(NETWORK if network else ())]
    if language_model.startswith(LOCAL):
        readable.append(language_model.removeprefix(LOCAL))
    no_new_privileges()
    return kept_to(readable, [str(folder), str(temporary), str(caches), *DEVICES], network=network)
