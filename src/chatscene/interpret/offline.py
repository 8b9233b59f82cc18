"""The offline reader: words, patterns and a classifier decide facts, and the facts make situations.

Everything that reads without a language model stands behind this one class (`chatscene.read.reader.Reader`).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

from chatscene.interpret.decide import trusted
from chatscene.interpret.placed import require_placed
from chatscene.interpret.readings import as_read, understand
from chatscene.interpret.retrieve import reasons_of
from chatscene.interpret.situation_of import situation_of
from chatscene.read.quotes import unread
from chatscene.read.reading import read
from chatscene.settings import OFFLINE, RetrievalSettings
from chatscene.terms.reading import Ranked, SituationReading, Verdict
from chatscene.terms.scenario import REFUSED, Scenario
from chatscene.terms.situation import Situation


@dataclass(frozen=True, slots=True)
class OfflineReader:
    """Reads without a language model; see `chatscene.read.reader.Reader` for the contract.

    Attributes:
        settings: What the user stated beside the text, and which of the readings that were offered is taken.
        cannot_build: Says why a situation cannot be built; empty if it can.
    """

    settings: RetrievalSettings = field(default_factory=RetrievalSettings)
    cannot_build: Callable[[Situation], str] = lambda _: ""

    @property
    def name(self) -> str:
        """``offline``."""
        return OFFLINE

    def read(self, text: str) -> SituationReading:
        """What a text tells; of one that is not sure enough, why.

        Raises:
            SettingsError: The text is empty or too long, or what the user stated does not go with it.
        """
        frame = read(text, self.settings)
        scenario = understand(frame, self.settings, served=self._is_built)
        require_placed(scenario, self.settings.stated)
        first = _ranked(scenario, sure(scenario, self.settings))
        others = (_ranked(as_read(frame, one.slots), one.probability) for one in scenario.readings)
        unsure = first.probability < self.settings.refuse_below
        return SituationReading(
            text=text,
            reader=self.name,
            verdict=Verdict.SITUATION,
            reason="; ".join(reasons_of(scenario)) if unsure else "",
            ranked=(first, *others),
            settled_by=("", *(one.settled_by for one in scenario.readings)),
            unread=unread(first.situation, text),
        )

    def _is_built(self, scenario: Scenario) -> bool:
        return not self.cannot_build(situation_of(scenario).situation)


def sure(scenario: Scenario, settings: RetrievalSettings) -> float:
    """The probability that every fact of a text was read rightly; 0 where it asks for what no scene has."""
    if any(one.why in REFUSED for one in scenario.unused):
        return 0.0
    frame = scenario.frame
    return frame.sure if frame is not None and frame.whole else trusted(scenario, settings)


def _ranked(scenario: Scenario, probability: float) -> Ranked:
    told = situation_of(scenario)
    return Ranked(situation=told.situation, probability=probability, left_out=told.left_out)
