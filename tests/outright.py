"""A sentence as its words alone say it, without the classifier."""

from chatscene.interpret.decide import understood
from chatscene.read.decompose import hear
from chatscene.terms.scenario import Scenario


def decompose(text: str) -> Scenario:
    """What is understood of a text by what its words say outright."""
    frame = hear(text)
    return understood(frame, frame.outright, frame.notes)
