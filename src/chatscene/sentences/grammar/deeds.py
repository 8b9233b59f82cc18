"""What adversaries do, in words: phrases per act and class of road user, from the table of acts."""

from __future__ import annotations

from chatscene.situations.inflection import listed
from chatscene.terms.actors import Manner
from chatscene.terms.acts import Action

Table = dict[Manner, tuple[str, ...]]  # phrases per manner; one that is missing speaks like a driver
W, R, D = Manner.WALKS, Manner.RIDES, Manner.DRIVES

# One act
DEEDS: dict[Action, Table] = {
    action: {
        manner: listed(said)
        for manner, said in ((W, action.row.walks), (R, action.row.rides), (D, action.row.drives))
        if said
    }
    for action in Action
}

AT_SPEED: Table = {
    W: listed("at a run | at full speed | at a sprint | at full tilt | running flat out | at top speed"),
    D: listed(
        """at high speed | much too fast | far too fast | at full speed | well above the speed limit
        at a reckless speed | at breakneck speed"""
    ),
}
SUDDENLY = listed("suddenly | suddenly | suddenly | abruptly | unexpectedly | all of a sudden")


def phrases(table: Table, manner: Manner) -> tuple[str, ...]:
    """What a table has for a class of road user."""
    return table.get(manner) or table[Manner.DRIVES]
