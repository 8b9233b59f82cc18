"""The paper's own way from a text to snippets: by the wording of three sub-descriptions, and nothing else."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from chatscene.errors import SettingsError
from chatscene.interpret.nearest import cosines
from chatscene.interpret.paper import nearest_triple
from chatscene.library.bind import does
from chatscene.library.compatibility import compatibility, incompatibility
from chatscene.library.load import load_library
from chatscene.models.encoders.embedding import load_embedder
from chatscene.search.generators.retrieved import Retrieved
from chatscene.settings import RetrievalSettings
from chatscene.terms.scenario import Component, SubDescriptions
from chatscene.terms.snippet import Retrieval, Tried

PAPER = RetrievalSettings(reader="paper")
VAGUE = "Somebody did something odd near the shop."


def served(text: str, settings: RetrievalSettings = PAPER) -> Retrieval:
    written = Retrieved().write(Retrieved().read(text, settings), settings)
    assert written.retrieval is not None
    return written.retrieval


def test_the_descriptions_of_three_snippets_find_just_these() -> None:
    library = load_library()
    joint = compatibility(library)
    triple = tuple(library.of(c)[i] for c, i in zip(Component, np.argwhere(joint.mask)[0].tolist(), strict=True))
    parts = SubDescriptions(**{c.value: one.description for c, one in zip(Component, triple, strict=True)})
    found = nearest_triple(parts, None, PAPER)
    assert found.snippets == triple
    assert found.confidence == pytest.approx(1.0, abs=1e-3)


def test_no_triple_that_can_be_joined_is_nearer() -> None:
    library, embedder = load_library(), load_embedder()
    scenario = Retrieved().read("a van on our left swings into our lane and brakes", PAPER)
    found = nearest_triple(scenario.parts, scenario.slots.adversary, PAPER)
    assert incompatibility(*found.snippets) is None
    joint = compatibility(library)
    behavior, geometry, spawn = (cosines(scenario.parts[c], library.of(c), embedder) for c in Component)
    sums = behavior[:, None, None] + geometry[None, :, None] + spawn[None, None, :]
    best = np.where(joint.of_kind(scenario.slots.adversary), sums, -np.inf).max()
    assert 3 * found.confidence == pytest.approx(best)


def test_what_the_triple_does_is_what_was_read_and_is_what_is_driven() -> None:
    scenario = Retrieved().read("a van on our left swings into our lane and brakes", PAPER)
    found = served(scenario.text)
    assert scenario.slots == does(found.snippets, found.adversary)


def test_a_text_that_facts_refuse_is_served_and_it_is_said_that_nothing_was_weighed() -> None:
    found = served(VAGUE)
    assert any("no probability" in note for note in found.notes)


def test_a_choice_that_did_not_show_what_it_does_is_not_made_again() -> None:
    scenario = Retrieved().read(VAGUE, PAPER)
    first = nearest_triple(scenario.parts, None, PAPER)
    tried = Tried(snippet_ids=tuple(one.id for one in first.snippets), reason="not seen")
    second = nearest_triple(scenario.parts, None, PAPER, [tried])
    assert second.snippets != first.snippets
    assert second.confidence <= first.confidence


def test_a_reader_that_there_is_not_is_told_with_those_that_there_are() -> None:
    with pytest.raises(SettingsError, match="paper"):
        replace(PAPER, reader="papers")
