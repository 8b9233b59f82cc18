"""Who makes scenes: one Protocol, one table of names. A budget goes in, scenes come out.

A generator says what it searches with for a base scenario, makes the program of it, and explores one route of it
block by block. Everything else — where scenes are kept, how they are selected, who is measured on them — is the same
for all, so that generators can be compared.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Protocol

from chatscene.plugins import Kind, make
from chatscene.settings import RetrievalSettings, SearchSettings
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.outcome import Outcome
from chatscene.terms.scenario import BaseScenario, Said, Scenario
from chatscene.terms.scene import ScenicProgram
from chatscene.terms.snippet import Retrieval, Tried

if TYPE_CHECKING:  # a sentence is read and written without what drives
    from chatscene.ego.policy import EgoPolicy
    from chatscene.search.explore import Block
    from chatscene.simulate.simulator import Simulator


@dataclass(frozen=True, slots=True, kw_only=True)
class Written:
    """What a generator made of a scenario.

    Attributes:
        retrieval: Why it consists of these snippets; None for a generator that does not retrieve.
        left_out: What was written and has no effect on its drives, in lines for a person.
    """

    program: ScenicProgram
    retrieval: Retrieval | None
    left_out: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True)
class Choice:
    """What was retrieved for a scenario, as far as its program depends on it."""

    snippet_ids: tuple[str, str, str]
    adversary: AdversaryKind
    ranges: Mapping[str, tuple[float, float]] = field(default_factory=dict[str, tuple[float, float]])

    @classmethod
    def of(cls, written: Written) -> Choice | None:
        """The choice behind a program; None if it was not retrieved."""
        if written.retrieval is None:
            return None
        behavior, geometry, spawn = (snippet.id for snippet in written.retrieval.snippets)
        return cls(
            snippet_ids=(behavior, geometry, spawn),
            adversary=written.retrieval.adversary,
            ranges={one.name: (one.low, one.high) for one in written.program.parameters},
        )


class Generator(Protocol):
    """Makes scenes.

    Determinism: the same text, settings and seed give the same scenes, whatever ran before and however often the
    search was interrupted.

    Attributes:
        reference: How much the reference lets it try per scenario, and what it keeps (`docs/reproduce.md`).
    """

    @property
    def reference(self) -> SearchSettings: ...  # noqa: D102

    def texts(self, base: BaseScenario) -> tuple[str, ...]:
        """The scenarios it searches with for a base scenario, in order of preference; perhaps none."""
        ...

    def read(self, text: str, settings: RetrievalSettings) -> Scenario:
        """A scenario from its text.

        Raises:
            SettingsError: It is no text of this generator.
        """
        ...

    def write(self, scenario: Scenario, settings: RetrievalSettings, tried: Sequence[Tried] = ()) -> Written:
        """The program of a scenario; another one than those that were tried.

        Raises:
            NothingFits: It cannot make one.
        """
        ...

    def write_again(self, scenario: Scenario, choice: Choice | None, settings: RetrievalSettings) -> ScenicProgram:
        """The program of a scenario that `write` made once: no text is read for it, and nothing retrieved.

        Args:
            scenario: As it was then.
            choice: What was retrieved for it then; None if nothing was.
            settings: As they were then.

        Raises:
            SnippetError: What was chosen is not there any more.
            RunError: It is a retrieval's, and nothing was.
        """
        ...

    def is_trusted(self, settings: RetrievalSettings) -> bool:
        """Whether all code of its programs is packaged or its own; else they are run in the sandbox only."""
        ...

    def explore(
        self,
        program: ScenicProgram,
        said: Said,
        route: int,
        *,
        simulator: Simulator,
        ego: EgoPolicy,
        settings: SearchSettings,
        done: Sequence[Sequence[Outcome]],
    ) -> Iterator[Block]:
        """The blocks of one route that are still to be done; `done` holds what came of those that are."""
        ...


GENERATORS: Kind[Generator] = Kind(
    noun="generator",
    group="chatscene.generators",
    method="explore",
    built_in={
        "chatscene": "chatscene.search.generators.retrieved:Retrieved",
        "learning-to-collide": "chatscene.search.generators.baselines.learning_to_collide:LearningToCollide",
        "advsim": "chatscene.search.generators.baselines.advsim:AdvSim",
        "adversarial-trajectory": "chatscene.search.generators.baselines.adversarial_trajectory:AdversarialTrajectory",
        "learning-to-collide-safebench": (
            "chatscene.search.generators.baselines.learning_to_collide:LearningToCollideCited"
        ),
        "adversarial-trajectory-safebench": (
            "chatscene.search.generators.baselines.adversarial_trajectory:AdversarialTrajectoryCited"
        ),
        "carla-scenario-generator": "chatscene.search.generators.baselines.scenario_runner:ScenarioRunner",
        "reactive": "chatscene.search.generators.baselines.reactive:Reactive",
        "random-triple": "chatscene.search.generators.baselines.random_triple:RandomTriple",
        "situation": "chatscene.search.generators.situated:Situated",
        "program": "chatscene.search.generators.own_program:OwnProgram",
        "program-as-written": "chatscene.search.generators.own_program:as_written",
    },
)


def load_generator(name: str) -> Generator:
    """A generator by its name (`chatscene.plugins`).

    Raises:
        SettingsError: There is none of that name.
    """
    return make(GENERATORS, name)
