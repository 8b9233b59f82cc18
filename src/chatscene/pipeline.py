"""The whole method on one screen: one call per step.

Paper: figure 1. Steps 1 (describe) and 9 (finetune) are commands of their own.
"""

from __future__ import annotations

import re
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

from chatscene.agent.decompose import decompose
from chatscene.ego.policy import load_ego
from chatscene.maps.network import resolve_map
from chatscene.program.assemble import assemble
from chatscene.program.check import check
from chatscene.search.select import select
from chatscene.settings import Settings
from chatscene.simulate.backend import load_backend
from chatscene.snippets.embedding import load_embedder
from chatscene.snippets.library import load_library
from chatscene.snippets.retrieve import retrieve
from chatscene.terms.scenario import Scenario
from chatscene.terms.scene import ScenicProgram
from chatscene.terms.snippet import Retrieval

Progress = Callable[[str, int, int], None]


@dataclass(frozen=True, slots=True, kw_only=True)
class Understood:
    """What became of a sentence before anything was run (steps 2 to 4)."""

    scenario: Scenario
    retrieval: Retrieval
    program: ScenicProgram


def understand(text: str, settings: Settings | None = None) -> Understood:
    """Steps 2 to 4: a sentence to the program that expresses it.

    Raises:
        SettingsError: The text is empty or too long.
        NothingFits: The library cannot serve it.
    """
    settings = settings or Settings()
    scenario = decompose(text)
    retrieval = retrieve(scenario, load_library(), load_embedder(), settings.retrieval)
    program = assemble(scenario, *retrieval.snippets, retrieval.adversary)
    return Understood(scenario=scenario, retrieval=retrieval, program=program)
