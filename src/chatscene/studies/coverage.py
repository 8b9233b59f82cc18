"""What of a catalogue of traffic situations is served, entry by entry.

An entry is served if its sentence is read and a program is chosen for it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict
from typing import Any

from chatscene.errors import NothingFits, SettingsError
from chatscene.library.compose import COMPOSED
from chatscene.runs.parallel import spread
from chatscene.runs.progress import Progress
from chatscene.search.generators.retrieved import Retrieved
from chatscene.settings import RetrievalSettings
from chatscene.terms.coverage import Answer, Catalogue, Covered, Entry, Tally
from chatscene.terms.scenario import Scenario, grouped
from chatscene.terms.snippet import Retrieval

Task = tuple[int, str, Entry]


def cover(
    catalogues: Sequence[Catalogue], *, settings: RetrievalSettings, jobs: int = 1, progress: Progress
) -> tuple[Covered, ...]:
    """Ask for every entry of catalogues.

    Args:
        catalogues: What to ask for; no two have the same name.
        settings: How sentences are read.
        jobs: Processes; any number gives the same.
        progress: Told what is done.

    Returns:
        A row for each entry, in their order.

    Raises:
        SettingsError: Two catalogues have the same name.
    """
    names = [catalogue.name for catalogue in catalogues]
    for name in names:
        if names.count(name) > 1:
            raise SettingsError(f"two catalogues are called {name!r}; give one file another name")
    asked = [(catalogue.name, entry) for catalogue in catalogues for entry in catalogue.entries]
    tasks = [(number, name, entry) for number, (name, entry) in enumerate(asked)]
    rows: dict[int, Covered] = {}
    for number, row in spread(_Desk, settings, tasks, jobs=jobs):
        rows[number] = row
        progress("entries", len(rows), len(tasks))
    return tuple(rows[number] for number in range(len(tasks)))


class _Desk:
    """Answers for one entry after another."""

    def __init__(self, settings: RetrievalSettings) -> None:
        self._settings = settings
        self._generator = Retrieved()

    def __call__(self, task: Task) -> tuple[int, Covered]:
        number, catalogue, entry = task
        return number, self._covered(catalogue, entry)

    def _covered(self, catalogue: str, entry: Entry) -> Covered:
        if not entry.sentence:
            reasons = (entry.reason,)
            return Covered(catalogue=catalogue, entry=entry, answer=Answer.OUT_OF_REACH, reasons=reasons, slots={})
        scenario = self._generator.read(entry.sentence, self._settings)
        read: dict[str, Any] = {"catalogue": catalogue, "entry": entry, "slots": _in_words(scenario)}
        try:
            retrieval = self._generator.write(scenario, self._settings).retrieval
        except NothingFits as refusal:
            unused = tuple(grouped(scenario.unused).values())
            return Covered(**read, answer=Answer.REFUSED, reasons=refusal.reasons, unused=unused)
        assert retrieval is not None  # whoever retrieves says so
        return Covered(**read, answer=Answer.SERVED, **_chosen(scenario, retrieval))


def _in_words(scenario: Scenario) -> dict[str, str]:
    """What was read, by slot."""
    return {
        name: ", then ".join(value) if isinstance(value, tuple) else str(value)
        for name, value in scenario.slots.said().items()
    }


def _chosen(scenario: Scenario, retrieval: Retrieval) -> dict[str, Any]:
    ids = tuple(snippet.id for snippet in retrieval.snippets)
    return {
        "snippet_ids": ids,
        "composed": tuple(name for name in ids if name.startswith(COMPOSED)),
        "confidence": retrieval.confidence,
        "unused": tuple(grouped((*scenario.unused, *retrieval.unused)).values()),
    }


def as_json(catalogues: Sequence[Catalogue], rows: Sequence[Covered]) -> dict[str, Any]:
    """Every entry with what became of it, for a script; `docs/coverage.md` lists the keys."""
    return {"catalogues": [_told(catalogue, of_catalogue(catalogue, rows)) for catalogue in catalogues]}


def of_catalogue(catalogue: Catalogue, rows: Sequence[Covered]) -> list[Covered]:
    """The rows of one catalogue."""
    return [row for row in rows if row.catalogue == catalogue.name]


def _told(catalogue: Catalogue, rows: Sequence[Covered]) -> dict[str, Any]:
    told: list[dict[str, Any]] = []
    for row in rows:
        content = asdict(row)
        entry: dict[str, str] = content.pop("entry")
        del content["catalogue"]
        told.append({"name": entry["name"], "sentence": entry["sentence"], **content})
    return {"name": catalogue.name, "title": catalogue.title, **asdict(Tally.of(rows)), "rows": told}
