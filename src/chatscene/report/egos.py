"""Who drove, and what they could see: without that no collision rate means anything."""

from __future__ import annotations

from chatscene.ego.policy import in_words
from chatscene.runs import MapRecord


def egos_in_words(record: MapRecord) -> tuple[str, ...]:
    """Each ego of a run or an evaluation, with what it sees and how hard it brakes."""
    return tuple(f"{ego} {in_words(record.senses.get(ego, {}))}" for ego in record.egos)
