"""What each amount of each act says: the table from which the page and messages are made.

`Act.row.takes` says which amounts an act takes; what they say is the same of all acts of a trait. A new act needs a row
here only where that does not fit.
"""

from __future__ import annotations

from collections.abc import Mapping

from chatscene.terms.vocabulary import Act, Heads, Tempo, by_act

AMOUNTS = ("speed", "acceleration", "distance", "time")
"""The amounts of a deed, in the order in which they are told."""
_USUAL = {
    "speed": "how fast it does that",
    "acceleration": "how hard",
    "distance": "how far it does that",
    "time": "how long it does that",
}
_GAINS = {"speed": "to which speed", "time": "how long it takes"}
_LOSES = _GAINS | {"speed": "down to which speed"}
_ASIDE = {"distance": "how far to the side", "time": "how long it takes"}
_BEHIND = {"distance": "how far behind it keeps"}
_GAP = {
    "distance": "the gap that is left behind it",
    "time": "that gap, as the time that whoever is behind needs for it",
}
_THROUGH = {"time": "how long it still needs to where it meets the ego, when that comes to the junction"}
_MEANS: Mapping[Act, Mapping[str, str]] = by_act(
    {
        Tempo.STANDS: {"time": "how long it stands"},
        Tempo.SETS_OFF: _GAINS,
        Tempo.GAINS: _GAINS | {"distance": "over what distance"},
        Tempo.SLOWS: _LOSES,
        Tempo.BRAKES: _LOSES,
        Tempo.HALTS: {"distance": "in what distance", "time": "how long it then stands"},
        Tempo.PAUSES: {"time": "how long it pauses"},
        Tempo.BACKS: {"distance": "how far back"},
        Heads.BEFORE: _GAP,
        Heads.MERGES: _GAP,
        Heads.THROUGH: _THROUGH,
        Heads.TURNS: _THROUGH,
        Heads.OVER: {"time": "how long it takes", "distance": "within what distance"},
        Heads.OUT: {"time": "how long it takes"},
        Heads.BY: {"distance": "how far ahead it is before it comes back"},
        Heads.DRIFTS: _ASIDE,
        Heads.ASIDE: _ASIDE,
        Heads.BEHIND: _BEHIND | {"time": "the same, as the time that it needs for that"},
        Heads.CLOSE: _BEHIND,
    }
)


def amounts_of(act: Act) -> dict[str, str]:
    """The amounts that an act takes, each with what it says of it."""
    means = _USUAL | dict(_MEANS.get(act, {}))
    return {name: means[name] for name in AMOUNTS if name in act.row.takes}
