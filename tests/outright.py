"""What a text says, for whoever chooses snippets for it, taken for sure."""

from chatscene.interpret.asked import scenario_of
from chatscene.settings import RetrievalSettings
from chatscene.terms.scenario import Scenario


def decompose(text: str) -> Scenario:
    """What the likeliest reading of a text says, which is taken for what was meant."""
    return scenario_of(text, RetrievalSettings(reading=1))
