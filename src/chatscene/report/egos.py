"""Who drove, and what they could see: without that no collision rate means anything."""

from __future__ import annotations

from chatscene.ego.policy import in_words
from chatscene.runs import MapRecord, RunRecord
from chatscene.search.generators.own_program import options_of


def egos_in_words(record: MapRecord) -> tuple[str, ...]:
    """Each ego of a run or an evaluation, with what it sees and how hard it brakes.

    In a program that drives as it is written, the ego of the run rides along.
    """
    if isinstance(record, RunRecord) and "--as-written" in options_of(record.generator):
        return tuple(f"the program's own ego drove, and {ego} rode along" for ego in record.egos)
    return tuple(f"{ego} {in_words(record.senses.get(ego, {}))}" for ego in record.egos)
