"""A user's own snippets serve the texts that are about them; any other text becomes a situation, as without them."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

import chatscene
from chatscene import runs
from chatscene.errors import EditRefused, SettingsError
from chatscene.library.load import PACKAGED, load_library
from chatscene.report.stated import Stated
from chatscene.report.understood import Understood

OWN = "Somebody fetches a glove from the middle of the road."
OTHER = "A car ahead of us brakes hard."


@pytest.fixture(scope="module")
def own(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("own")
    text = (PACKAGED / "behavior" / "cross-hesitate.scenic").read_text()
    (folder / "behavior").mkdir()
    (folder / "behavior" / "fetch.scenic").write_text(
        re.sub(r'^#: description = ".*"', f'#: description = "{OWN}"', text, flags=re.MULTILINE)
    )
    return folder


def test_a_text_about_an_own_snippet_is_served_by_it(own: Path) -> None:
    understood = chatscene.explain(OWN, library=own)
    assert isinstance(understood, Understood)
    assert understood.retrieval is not None
    assert understood.retrieval.behavior.snippet.id == "behavior/fetch"
    with pytest.raises(SettingsError, match="the map is for a situation"):
        chatscene.explain(OWN, library=own, map="town")
    with pytest.raises(EditRefused):
        chatscene.explain(OWN, library=own, edit="at night")


def test_any_other_text_becomes_the_situation_that_it_is_without_a_library(own: Path) -> None:
    with_own, without = chatscene.explain(OTHER, library=own, map="town"), chatscene.explain(OTHER, map="town")
    assert isinstance(with_own, Stated)
    assert with_own.situation == without.situation
    assert with_own.program == without.program


def test_a_run_of_any_other_text_needs_no_library_to_be_gone_on_with(own: Path, tmp_path: Path) -> None:
    done = chatscene.run(OTHER, tmp_path / "run", library=own, scenes=1, routes=1, ego="idm")
    record = runs.read_record(runs.open_run(done.folder, runs.RunRecord))
    assert record.situation is not None
    assert runs.settings_of(record).retrieval.library == ""
    assert chatscene.Run(done.folder).understood.told == done.understood.told


def test_what_no_own_snippet_does_is_not_served_by_packaged_ones(own: Path) -> None:
    packaged = {snippet.id for snippet in load_library()}
    understood = chatscene.explain(OWN, library=own)
    assert isinstance(understood, Understood)
    assert understood.retrieval is not None
    assert not packaged.issuperset(snippet.id for snippet in understood.retrieval.snippets)
    assert isinstance(chatscene.explain("A pedestrian crosses from the right.", library=own), Stated)
