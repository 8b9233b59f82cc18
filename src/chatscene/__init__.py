"""From a sentence about a dangerous traffic situation to scenes worth testing on.

::

    import chatscene

    run = chatscene.run("a cyclist crosses from the left in front of us", scenes=20)
    run                                # in a notebook: the report, with a replay of the scenes
    run.scenes.to_pandas()             # a row per scene
    run.best.replay()                  # simulated again: the same tracks, bit for bit

Each verb of the command line is a function of the same name, with its options as keywords. What is named here is
loaded when it is first used: to import the package costs nothing.
"""

from __future__ import annotations

import os

from chatscene.plane import use_flat

TYPE_CHECKING = False  # as in `typing`, which costs more to load than all of this; type checkers know the name
if TYPE_CHECKING:
    from chatscene.api.exchange import export, import_scenario
    from chatscene.api.learn import finetune, train
    from chatscene.api.look import replay, sql, story, why
    from chatscene.api.make import conflicts, describe, explain, read_situation, resume, run
    from chatscene.api.measure import evaluate, rate, verify
    from chatscene.api.results import DrivenScene, Run
    from chatscene.ego.policy import load_ego
    from chatscene.search.sampler import load_sampler
    from chatscene.settings import Settings
    from chatscene.simulate.simulator import load_simulator
    from chatscene.terms.situation import Situation
    from chatscene.testing.scenes import scene

    __version__: str

__all__ = [
    "DrivenScene",
    "Run",
    "Settings",
    "Situation",
    "__version__",
    "conflicts",
    "describe",
    "evaluate",
    "explain",
    "export",
    "finetune",
    "import_scenario",
    "load_ego",
    "load_sampler",
    "load_simulator",
    "rate",
    "read_situation",
    "replay",
    "resume",
    "run",
    "scene",
    "sql",
    "story",
    "train",
    "verify",
    "why",
]

_NAMES = {
    "api.exchange": "export import_scenario",
    "api.learn": "finetune train",
    "api.look": "replay sql story why",
    "api.make": "conflicts describe explain read_situation resume run",
    "api.measure": "evaluate rate verify",
    "api.results": "DrivenScene Run",
    "ego.policy": "load_ego",
    "search.sampler": "load_sampler",
    "settings": "Settings",
    "simulate.simulator": "load_simulator",
    "terms.situation": "Situation",
    "testing.scenes": "scene",
}
"""Names by the module that defines them."""

# One thread for linear algebra, in every process that imports us and every process that it starts, said before NumPy
# is loaded and reads it. The networks that drive are so small that a second thread slows them by up to two, the
# processes of a run would fight for the cores, and how a sum is split among threads changes its last bits.
os.environ |= dict.fromkeys(
    ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "VECLIB_MAXIMUM_THREADS"), "1"
)

use_flat()
os.environ.setdefault("ORT_DISABLE_TELEMETRY", "1")  # onnxruntime reports its use unless told not to

if not TYPE_CHECKING:  # else a type checker would take any name for one of ours

    def __getattr__(name: str) -> object:
        """Load a public name where it is first used."""
        if name not in __all__:
            raise AttributeError(f"module 'chatscene' has no attribute {name!r}")
        if name == "__version__":
            from importlib.metadata import version

            found = version("chatscene")
        else:
            from importlib import import_module

            module = next(module for module, names in _NAMES.items() if name in names.split())
            found = getattr(import_module(f"chatscene.{module}"), name)
        globals()[name] = found
        return found


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
