"""A situation that somebody wrote down as a generator: it is built, and nothing is read or retrieved."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import lru_cache
from typing import TYPE_CHECKING

from chatscene.errors import NotBuilt
from chatscene.interpret.scenario_names import scenario_id
from chatscene.interpret.slots_of import facts_of, parties_of
from chatscene.maps.network import is_named, map_digest, resolve_map
from chatscene.search.generator import Choice, Written
from chatscene.search.generators.exploring import Exploring
from chatscene.search.generators.kept_builds import keep_program, kept_program
from chatscene.settings import RetrievalSettings, SearchSettings
from chatscene.situations.file import read_text
from chatscene.terms.conclusions import base_of, concluded
from chatscene.terms.scenario import BaseScenario, Scenario, SubDescriptions
from chatscene.terms.scene import ScenicProgram
from chatscene.terms.situation import Situation
from chatscene.terms.snippet import Tried

if TYPE_CHECKING:
    from chatscene.build.build import Built

_PARTS = SubDescriptions(behavior="as stated", geometry="as stated", spawn="as stated")


class Situated(Exploring):
    """Searches with the program of a situation; see `chatscene.search.generator.Generator` for the contract."""

    reference = SearchSettings()

    def texts(self, base: BaseScenario) -> tuple[str, ...]:  # noqa: ARG002
        """None: who states a situation states it for no base scenario."""
        return ()

    def read(self, text: str, settings: RetrievalSettings) -> Scenario:  # noqa: ARG002 - nothing is retrieved
        """The scenario of a situation, in YAML or JSON.

        Raises:
            SituationError: It is none.
            NotBuilt: Nobody meets the ego.
        """
        situation = read_text(text)
        parties = parties_of(situation)
        if parties is None:
            from chatscene.build.build import NOBODY

            raise NotBuilt(NOBODY)
        facts = facts_of(situation, parties)
        return Scenario(
            id=scenario_id(situation),
            text=text,
            base=base_of(concluded(facts.slots)),
            parts=_PARTS,
            slots=facts.slots,
            surroundings=facts.surroundings,
            situation=situation,
        )

    def write(self, scenario: Scenario, settings: RetrievalSettings, tried: Sequence[Tried] = ()) -> Written:  # noqa: ARG002
        """The program that is built of it.

        Raises:
            NotBuilt: A fact of it cannot be built.
        """
        from chatscene.read.quotes import not_in_words

        built = _built(scenario.text, scenario.id)
        lost = tuple(f"left out, since it cannot be built yet: {one}" for one in built.left_out)
        assumed = tuple(f"assumed: {one}" for one in built.assumed)
        told = (*built.unseen, *not_in_words(read_text(scenario.text)), *assumed, *lost)
        return Written(program=built.program, retrieval=None, left_out=told)

    def write_again(self, scenario: Scenario, choice: Choice | None, settings: RetrievalSettings) -> ScenicProgram:  # noqa: ARG002
        """The program that is built of it, or was by the same code before."""
        text, name = scenario.text, scenario.id
        return kept_program(text, name, _ground(text)) or _built(text, name).program

    def is_trusted(self, settings: RetrievalSettings) -> bool:  # noqa: ARG002
        """Yes: its program is ours, whoever stated the facts."""
        return True


def on_any_map(situation: Situation) -> Situation:
    """A situation without the name of a map of ours, so that another one may serve what changes; a file stays."""
    return replace(situation, map=None) if situation.map is not None and is_named(situation.map) else situation


def _ground(text: str) -> str:
    """What tells the map from every other that a situation names; empty where it names none."""
    lies = read_text(text).map
    return map_digest(resolve_map(lies)) if lies is not None else ""


def _built(text: str, name: str) -> Built:
    return _rehearsed(text, name, _ground(text))


@lru_cache(maxsize=8)
def _rehearsed(text: str, name: str, ground: str) -> Built:
    from chatscene.build.build import build  # who drives again what was built before needs none of it
    from chatscene.search.rehearsal import rehearsed_once

    situation = read_text(text)
    built = rehearsed_once(build(situation, name=name), situation)
    keep_program(built.program, text, name, ground)
    return built
