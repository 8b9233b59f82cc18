"""Compiles the engine. Needs Python alone, since the build of a wheel runs it where nothing else is installed."""

from __future__ import annotations

import hashlib
import shutil
import subprocess
from pathlib import Path

SOURCE = Path(__file__).with_name("engine.c")
COMPILERS = ("cc", "gcc", "clang")
# Nothing that changes a number: no contraction to fused operations, no fast mathematics, and the functions whose
# results a compiler may know better (`pow` to a product, sine and cosine in one) called as Python calls them.
FLAGS = (
    "-O3", "-std=c11", "-fPIC", "-shared", "-ffp-contract=off", "-fno-builtin-pow", "-fno-builtin-sin",
    "-fno-builtin-cos",
)  # fmt: skip
COMPILING = 120.0  # [s]


class NoEngine(Exception):  # noqa: N818 - reads as what it says
    """There is no engine on this machine; the message says why in a line."""


def source_digest() -> str:
    """What a library must say that it was compiled from."""
    return hashlib.blake2b(SOURCE.read_bytes() + " ".join(FLAGS).encode(), digest_size=8).hexdigest()


def compile_engine(target: Path) -> None:
    """Compile the engine.

    Raises:
        NoEngine: There is no compiler, or it fails.
    """
    compiler = next((found for name in COMPILERS if (found := shutil.which(name))), None)
    if compiler is None:
        raise NoEngine(f"none came with this installation, and there is no C compiler ({', '.join(COMPILERS)})")
    command = [compiler, *FLAGS, f'-DSOURCE_DIGEST="{source_digest()}"', str(SOURCE), "-o", str(target), "-lm"]
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=COMPILING, check=False)
    except (OSError, subprocess.TimeoutExpired) as error:
        raise NoEngine(f"the C compiler {compiler} does not run: {error}") from error
    if done.returncode:
        raise NoEngine(f"the C compiler {compiler} fails: {done.stderr.strip().splitlines()[:1]}")
