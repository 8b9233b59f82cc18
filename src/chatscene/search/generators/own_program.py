"""A user's own Scenic program as a generator: nothing is retrieved.

It is run behind the sandbox's walls. Who trusts a program says so, and names the generator that does; a run folder
that names it is not followed unless the user says so again, since it is not one of the table.
"""

from __future__ import annotations

from collections.abc import Sequence

from chatscene.search.generator import Choice, Written
from chatscene.search.generators.exploring import Exploring
from chatscene.settings import RetrievalSettings, SearchSettings
from chatscene.terms.scenario import BaseScenario, Scenario, Slots, SubDescriptions
from chatscene.terms.scene import ScenicProgram
from chatscene.terms.snippet import Tried

_PARTS = SubDescriptions(behavior="as programmed", geometry="as programmed", spawn="as programmed")


class OwnProgram(Exploring):
    """Searches with a program as it is; see `chatscene.search.generator.Generator` for the contract."""

    reference = SearchSettings()

    def __init__(self, *, trusted: bool = False, as_written: bool = False) -> None:
        self._trusted = trusted
        self._as_written = as_written

    def _program(self, name: str, source: str) -> ScenicProgram:
        from chatscene.search.generators.foreign import foreign_program

        return foreign_program(name, source, trusted=self._trusted, as_written=self._as_written)

    def texts(self, base: BaseScenario) -> tuple[str, ...]:  # noqa: ARG002
        """None: a program of one's own belongs to no base scenario."""
        return ()

    def read(self, text: str, settings: RetrievalSettings) -> Scenario:  # noqa: ARG002 - nothing is retrieved
        """The scenario of a program, whose text is its code; nothing was said, so nothing is held against it."""
        program = self._program("program", text)
        return Scenario(id=program.scenario_id, text=text, base=None, parts=_PARTS, slots=Slots())

    def write(self, scenario: Scenario, settings: RetrievalSettings, tried: Sequence[Tried] = ()) -> Written:  # noqa: ARG002
        """The program itself."""
        from chatscene.search.generators.left_out import left_out

        program = self._program(scenario.id, scenario.text)
        return Written(program=program, retrieval=None, left_out=left_out(program))

    def write_again(self, scenario: Scenario, choice: Choice | None, settings: RetrievalSettings) -> ScenicProgram:  # noqa: ARG002
        """The program itself."""
        return self._program(scenario.id, scenario.text)

    def is_trusted(self, settings: RetrievalSettings) -> bool:  # noqa: ARG002
        """Whether the user trusts who wrote it."""
        return self._trusted


def as_written() -> OwnProgram:
    """A program whose own ego drives."""
    return OwnProgram(as_written=True)


def trusted() -> OwnProgram:
    """A program that the user trusts."""
    return OwnProgram(trusted=True)


def trusted_as_written() -> OwnProgram:
    """A program that the user trusts and whose own ego drives."""
    return OwnProgram(trusted=True, as_written=True)


def generator_for(*, trusted: bool, as_written: bool) -> str:
    """The name of the generator of a program of the user's own."""
    if trusted:
        return f"{__name__}:{'trusted_as_written' if as_written else 'trusted'}"
    return "program-as-written" if as_written else "program"


def options_of(generator: str) -> list[str]:
    """What of the command line names a generator of programs of the user's own, beside ``--program``."""
    every = (
        (("--trust",) * trusted + ("--as-written",) * as_written, generator_for(trusted=trusted, as_written=as_written))
        for trusted in (False, True)
        for as_written in (False, True)
    )
    return next((list(options) for options, name in every if name == generator), [])
