"""The method of the paper as a generator: sentences, retrieved snippets, ranges moved toward collision."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cache
from importlib.resources import files

from chatscene.errors import NothingFits, RunError
from chatscene.library.bind import narrowed
from chatscene.library.load import library_with
from chatscene.maps.network import map_with
from chatscene.program.assemble import assemble
from chatscene.program.orders import ORDERS
from chatscene.read.reader import in_one_line
from chatscene.search.generator import Choice, Written
from chatscene.search.generators.exploring import Exploring
from chatscene.settings import PAPER, PAPER_READER, RetrievalSettings
from chatscene.terms.frame import Clauses, Frame
from chatscene.terms.scenario import BaseScenario, Quantity, Scenario, Site, Slots
from chatscene.terms.scene import ScenicProgram
from chatscene.terms.snippet import Tried


class Retrieved(Exploring):
    """ChatScene itself (paper, section 3.3); see `chatscene.search.generator.Generator` for the contract."""

    reference = PAPER

    def texts(self, base: BaseScenario) -> tuple[str, ...]:
        """Five sentences, in our words, for the situations of the paper's five."""
        return _benchmark_texts()[base]

    def read(self, text: str, settings: RetrievalSettings) -> Scenario:
        """Step 2: any sentence; one of the benchmark says what is listed of it, whatever it reads like."""
        from chatscene.interpret.asked import scenario_of  # no sentence is read for a replayed scene
        from chatscene.interpret.decide import understood

        listed = None if settings.stated or settings.reading else _listed().get(_key(text))
        if listed is None:
            return scenario_of(text, settings)
        told = settings.reader != PAPER_READER and listed.told
        clauses = Clauses(whole=text, ego=listed.ego, adversary=told or listed.adversary)
        plain = in_one_line(text)
        scenario = understood(
            Frame(text=plain, clauses=clauses, outright=listed.slots, quantities=listed.numbers, sure=1.0)
        )
        return replace(scenario, base=listed.base)

    def write(self, scenario: Scenario, settings: RetrievalSettings, tried: Sequence[Tried] = ()) -> Written:
        """Steps 3 and 4."""
        from chatscene.interpret.choose import choose

        try:
            retrieval, triple = choose(scenario, settings, tried)
        except NothingFits as refusal:
            refusal.understood = str(scenario.slots)
            refusal.readings = scenario.readings
            refusal.text = scenario.text
            refusal.words = tuple(one.as_dict() for one in scenario.words)
            raise
        if scenario.slots.ego is not None:
            told = f"the ego is under orders: {ORDERS[scenario.slots.ego].words}"
            retrieval = replace(retrieval, notes=(*retrieval.notes, told))
        if (site := scenario.slots.site) is not None:
            told = f"it needs a map with the {site}: {map_with(site)!r} is taken where no map is named"
            retrieval = replace(retrieval, notes=(*retrieval.notes, told))
        if site is Site.CROSSWALK:
            told = "the crosswalk lies on the ego's way; whoever crosses may do so before or behind it"
            retrieval = replace(retrieval, notes=(*retrieval.notes, told))
        return Written(program=assemble(scenario, triple, retrieval.adversary), retrieval=retrieval)

    def write_again(self, scenario: Scenario, choice: Choice | None, settings: RetrievalSettings) -> ScenicProgram:
        """Step 4 alone: the snippets that were chosen are joined again."""
        if choice is None:
            raise RunError(f"nothing was chosen for {scenario.id}: its explanation.json names no snippets")
        library = library_with(settings.library)
        behavior, geometry, spawn = (library.get(snippet_id) for snippet_id in choice.snippet_ids)
        return assemble(scenario, narrowed((behavior, geometry, spawn), choice.ranges), choice.adversary)

    def is_trusted(self, settings: RetrievalSettings) -> bool:
        """If all snippets are packaged ones, which are reviewed; those of a folder are a stranger's."""
        return not settings.library


@cache
def _benchmark_texts() -> dict[BaseScenario, tuple[str, ...]]:
    packaged = files("chatscene.search.generators").joinpath("benchmark_scenarios.json").read_text(encoding="utf-8")
    return {BaseScenario(base): tuple(texts) for base, texts in json.loads(packaged).items()}


@dataclass(frozen=True, slots=True, kw_only=True)
class _Listed:
    """What is listed of a sentence of the benchmark, so that it is the same for every reader.

    Attributes:
        ego: What it says of the ego, in its own words.
        adversary: What it says of the adversary, in its own words.
        told: What its adversary does, in the words of the library; empty where its own words find it.
    """

    base: BaseScenario
    slots: Slots
    ego: str
    adversary: str
    numbers: tuple[Quantity, ...] = ()
    told: str = ""


def _key(text: str) -> str:
    """A text without what carries nothing: case, white space, what ends it."""
    return in_one_line(text).casefold().rstrip(" .!?")


@cache
def _listed() -> dict[str, _Listed]:
    """The sentences of the benchmark, by `_key`."""
    from pydantic import TypeAdapter

    packaged = files("chatscene.search.generators").joinpath("benchmark_facts.json").read_text(encoding="utf-8")
    facts, listed = json.loads(packaged), TypeAdapter(_Listed)
    return {
        _key(text): listed.validate_python({"base": base, **facts[text]})
        for base, texts in _benchmark_texts().items()
        for text in texts
    }
