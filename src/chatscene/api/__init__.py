"""What `import chatscene` gives: the verbs of the command line as functions, and what they come to.

A folder may be left out: a new one is made in the system's temporary folder then, and stays. Errors are those of
`chatscene.errors`, the same that the command line shows.
"""

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
