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
    from chatscene.api import (
        DrivenScene,
        Run,
        conflicts,
        describe,
        evaluate,
        explain,
        export,
        finetune,
        import_scenario,
        rate,
        read_situation,
        replay,
        resume,
        run,
        sql,
        story,
        train,
        verify,
        why,
    )
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

_ELSEWHERE = {
    "Settings": "chatscene.settings",
    "Situation": "chatscene.terms.situation",
    "load_ego": "chatscene.ego.policy",
    "load_sampler": "chatscene.search.sampler",
    "load_simulator": "chatscene.simulate.simulator",
    "scene": "chatscene.testing.scenes",
}
"""Where a public name is defined, if not in `chatscene.api`."""

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

            found = getattr(import_module(_ELSEWHERE.get(name, "chatscene.api")), name)
        globals()[name] = found
        return found


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
