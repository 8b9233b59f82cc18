"""What became of a sentence for which snippets were chosen, and what an edit of it changes: for scripts and people."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from chatscene import runs
from chatscene.report.stated import difference_told, lines_changed
from chatscene.report.terminal import understanding_text
from chatscene.search.generator import load_generator
from chatscene.sentences.plain import told
from chatscene.settings import RetrievalSettings, Settings
from chatscene.terms.scenario import Scenario
from chatscene.terms.scene import ScenicProgram
from chatscene.terms.snippet import Retrieval

if TYPE_CHECKING:
    from chatscene.interpret.amend import Amended


@dataclass(frozen=True, slots=True)
class Understood:
    """What became of a sentence before anything was run (steps 2 to 4).

    Attributes:
        scenario: What was read.
        retrieval: The snippets that serve it and why; None for a generator that does not retrieve.
        program: The program.
        generator: Who made it, by name.
        reading: The settings by which it was made.
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
        numbers = [one.said for one in (*frame.quantities, *frame.shifts)] if frame is not None else []
        besides = {"Light, weather and road": str(scenario.surroundings), "Numbers": ", ".join(numbers)}
        return " ".join((told(scenario.slots), *(f"{name}: {said}." for name, said in besides.items() if said)))

    def edit(self, text: str) -> Edited:
        """The same situation but for what an edit names, such as "make it a truck, from the left".

        Raises:
            EditRefused: The edit was not understood, contradicts itself or what stays, or changes nothing.
            NothingFits: The library cannot serve the edited situation.
        """
        from chatscene.interpret.amend import amended

        made = amended(self.scenario, text, self.reading)
        written = load_generator(self.generator).write(made.scenario, self.reading)
        return Edited(
            scenario=made.scenario,
            retrieval=written.retrieval,
            program=written.program,
            generator=self.generator,
            reading=self.reading,
            before=self,
            amended=made,
        )

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


@dataclass(frozen=True, slots=True, kw_only=True)
class Edited(Understood):
    """What became of a situation after an edit; as text it is the difference.

    Attributes:
        before: What it was.
        amended: What the edit names and what follows from that.
    """

    before: Understood
    amended: Amended

    @property
    def difference(self) -> tuple[str, ...]:
        """The lines of the program that went (``-``) and came (``+``), without comments."""
        return lines_changed(self.before.program.source, self.program.source)

    def as_dict(self) -> dict[str, Any]:
        """For a script: the explanation and the program, and the difference."""
        return {
            **Understood.as_dict(self),
            "edit": self.amended.edit.text,
            "told": self.told,
            "changes": [
                {
                    "fact": one.fact,
                    "before": str(one).partition(": ")[2].partition(" → ")[0],
                    "after": str(one).partition(" → ")[2],
                    "named": one.fact in self.amended.edit.named,
                }
                for one in self.amended.changes
            ],
            "difference": list(self.difference),
        }

    def __str__(self) -> str:
        """For a person: the sentence told anew, the facts and the lines of the program that changed, what was noted."""
        retrieval = self.retrieval
        notes = [f"  note  {one}" for one in (retrieval.notes if retrieval else ())]
        return "\n".join(
            [
                f"now: {self.told}",
                *(f"  {one}" for one in self.amended.in_words()),
                *notes,
                *difference_told(self.difference),
            ]
        )


def understand(
    text: str, settings: Settings | None = None, *, generator: str = "chatscene", edits: Sequence[str] = ()
) -> Understood:
    """Steps 2 to 4: a sentence, and edits of it, to the program that expresses it.

    Raises:
        SettingsError: The text is empty or too long.
        EditRefused: An edit was not understood.
        NothingFits: The library cannot serve it.
    """
    reading = (settings or Settings()).retrieval
    maker = load_generator(generator)
    said = maker.read(text, reading)
    made = maker.write(said, reading)
    understood = Understood(said, made.retrieval, made.program, generator=generator, reading=reading)
    for one in edits:
        understood = understood.edit(one)
    return understood
