"""What `import chatscene` gives: the verbs of the command line as functions, and what they come to.

A folder may be left out: a new one is made in the system's temporary folder then, and stays. Errors are those of
`chatscene.errors`, the same that the command line shows.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from chatscene.api.exchange import export, import_scenario
    from chatscene.api.learn import finetune, train
    from chatscene.api.look import replay, sql, story, why
    from chatscene.api.make import conflicts, describe, explain, read_situation, resume, run
    from chatscene.api.measure import evaluate, rate, verify
    from chatscene.api.results import DrivenScene, Run

__all__ = [
    "DrivenScene",
    "Run",
    "conflicts",
    "describe",
    "evaluate",
    "explain",
    "export",
    "finetune",
    "import_scenario",
    "rate",
    "read_situation",
    "replay",
    "resume",
    "run",
    "sql",
    "story",
    "train",
    "verify",
    "why",
]

_NAMES = {
    "exchange": "export import_scenario",
    "learn": "finetune train",
    "look": "replay sql story why",
    "make": "conflicts describe explain read_situation resume run",
    "measure": "evaluate rate verify",
    "results": "DrivenScene Run",
}
"""Names by the module that defines them, loaded when one is first used: who explains a text needs one of them."""

if not TYPE_CHECKING:  # else a type checker would take any name for one of ours

    def __getattr__(name: str) -> object:
        """Load a name where it is first used."""
        module = next((module for module, names in _NAMES.items() if name in names.split()), None)
        if module is None:
            raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
        found = globals()[name] = getattr(import_module(f"{__name__}.{module}"), name)
        return found
