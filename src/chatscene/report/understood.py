"""What became of a sentence for which snippets were chosen, for scripts and people."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from chatscene import runs
from chatscene.errors import EditRefused
from chatscene.interpret.situation_of import in_a_situation
from chatscene.report.terminal import understanding_text
from chatscene.search.generator import load_generator
from chatscene.settings import RetrievalSettings, Settings
from chatscene.situations.words import told
from chatscene.terms.scenario import Scenario
from chatscene.terms.scene import ScenicProgram
from chatscene.terms.snippet import Retrieval

if TYPE_CHECKING:
    from chatscene.report.stated import Changed

NO_EDITS = "this run used snippets, and only situations can be edited; start again with the text"


@dataclass(frozen=True, slots=True)
class Understood:
    """What became of a sentence before anything was run (steps 2 to 4).

    Attributes:
        retrieval: The snippets that serve it and why; None for a generator that does not retrieve.
    """

    scenario: Scenario
    retrieval: Retrieval | None
    program: ScenicProgram
    generator: str = "chatscene"
    reading: RetrievalSettings = field(default_factory=RetrievalSettings)

    @property
    def told(self) -> str:
        """All facts as they are decided, in plain sentences."""
        scenario, frame = self.scenario, self.scenario.frame
        numbers = frame.quantities if frame is not None else ()
        return told(in_a_situation(scenario.slots, numbers, scenario.surroundings))

    def edit(self, text: str) -> Changed:  # noqa: ARG002 - as of what was made of a situation
        """Refuse an edit: only a situation can be edited.

        Raises:
            EditRefused: Always.
        """
        raise EditRefused(NO_EDITS)

    def as_dict(self) -> dict[str, Any]:
        """For a script: the explanation, and the program's text."""
        explanation = runs.explain(self.scenario.text, [(self.scenario, self.retrieval)])
        return {**explanation, "program": self.program.source}

    def __str__(self) -> str:
        """For a person, as the command line prints it."""
        return understanding_text(self)

    def _repr_html_(self) -> str:
        """For a notebook, as the report shows it."""
        from chatscene.report.notebook import understanding_frame

        return understanding_frame(self.scenario, self.as_dict())


def understand(text: str, settings: Settings | None = None, *, generator: str = "chatscene") -> Understood:
    """Steps 2 to 4: a sentence to the program that expresses it.

    Raises:
        SettingsError: The text is empty or too long.
        NothingFits: The library cannot serve it.
    """
    reading = (settings or Settings()).retrieval
    maker = load_generator(generator)
    said = maker.read(text, reading)
    made = maker.write(said, reading)
    return Understood(said, made.retrieval, made.program, generator=generator, reading=reading)
