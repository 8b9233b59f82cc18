"""What was said: a situation, or what is read in a sentence or a report."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from chatscene.errors import SettingsError
from chatscene.files.bounded import is_there
from chatscene.settings import RetrievalSettings
from chatscene.situations.facts import with_fact
from chatscene.situations.file import read_file
from chatscene.terms.situation import Situation

SITUATIONS, REPORTS = (".yaml", ".yml", ".json"), (".txt", ".md")
"""What the names of files end in that are a situation, or a report."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Asked:
    """What a scene is to show.

    Attributes:
        situation: What was said.
        not_read: Words of a text that gave no fact.
    """

    situation: Situation
    not_read: tuple[str, ...] = ()


def asked(said: str | Path | Situation, reading: RetrievalSettings, facts: Mapping[str, object] | None = None) -> Asked:
    """What was said.

    Args:
        said: A sentence, a situation, or the file of a situation or of a report.
        reading: Who reads texts.
        facts: Facts that the user states beside it, by path; beside a text also by their names.

    Raises:
        SituationError: A file has no situation, or a fact has no place.
        SettingsError: A file cannot be read, a report tells several conflicts, or texts are to be read otherwise than
            into a situation.
        NothingFits: Nothing, or nothing for sure, is read in a text.
    """
    if isinstance(said, Situation) or str(said).lower().endswith(SITUATIONS):
        made = said if isinstance(said, Situation) else read_file(Path(said))
        for path, value in (facts or {}).items():
            made = with_fact(made, path, value)
        return Asked(situation=made)
    from chatscene.interpret.conflicts import conflicts_in, read_report
    from chatscene.read.quotes import left_over
    from chatscene.report.filled import is_filled, read_in

    text = str(said)
    if text.lower().endswith(REPORTS) and (isinstance(said, Path) or is_there(Path(text))):
        found, *others = conflicts_in(read_report(Path(text)), Path(text).name)
        if others:
            raise SettingsError(f"{text} has {found.of} conflicts; give the text of one")
        text = found.text
    if not is_filled(text, reading):
        raise SettingsError("say what it is to show: a sentence that is read into facts, a situation or a report")
    one = read_in(text, reading, facts)
    return Asked(situation=one.situation, not_read=left_over(one.situation))
