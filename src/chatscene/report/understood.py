"""What became of a sentence, for scripts, people and notebooks."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from chatscene import runs
from chatscene.report.notebook import understanding_frame
from chatscene.report.terminal import understanding_text
from chatscene.terms.scenario import Scenario
from chatscene.terms.scene import ScenicProgram
from chatscene.terms.snippet import Retrieval


@dataclass(frozen=True, slots=True, kw_only=True)
class Understood:
    """What became of a sentence before anything was run (steps 2 to 4)."""

    scenario: Scenario
    retrieval: Retrieval | None
    program: ScenicProgram

    def as_dict(self) -> dict[str, Any]:
        """For a script: the explanation, and the program's text."""
        explanation = runs.explain(self.scenario.text, [(self.scenario, self.retrieval)])
        return {**explanation, "program": self.program.source}

    def __str__(self) -> str:
        """For a person, as the command line prints it."""
        return understanding_text(self)

    def _repr_html_(self) -> str:
        """For a notebook, as the report shows it."""
        return understanding_frame(self.scenario, self.as_dict())
