"""What each amount of each act says: the table from which the page and messages are made.

`Act.row.takes` says which amounts an act takes; a new one needs a row here only where the usual words do not fit.
"""

from __future__ import annotations

from collections.abc import Mapping

from chatscene.terms.vocabulary import Act

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
_MEANS: Mapping[Act, Mapping[str, str]] = {
    Act.STAND: {"time": "how long it stands"},
    Act.SET_OFF: _GAINS,
    Act.ACCELERATE: _GAINS | {"distance": "over what distance"},
    Act.SLOW_DOWN: _LOSES,
    Act.BRAKE: _LOSES,
    Act.STOP: {"distance": "in what distance", "time": "how long it then stands"},
    Act.HESITATE: {"time": "how long it pauses"},
    Act.REVERSE: {"distance": "how far back"},
    Act.CUT_IN: _GAP,
    Act.MERGE: _GAP,
    Act.GO_STRAIGHT: _THROUGH,
    Act.TURN_LEFT: _THROUGH,
    Act.TURN_RIGHT: _THROUGH,
    Act.LANE_CHANGE: {"time": "how long it takes", "distance": "within what distance"},
    Act.CUT_OUT: {"time": "how long it takes"},
    Act.OVERTAKE: {"distance": "how far ahead it is before it comes back"},
    Act.DRIFT: _ASIDE,
    Act.SWERVE: _ASIDE,
    Act.FOLLOW: _BEHIND | {"time": "the same, as the time that it needs for that"},
    Act.TAILGATE: _BEHIND,
}


def amounts_of(act: Act) -> dict[str, str]:
    """The amounts that an act takes, each with what it says of it."""
    means = _USUAL | dict(_MEANS.get(act, {}))
    return {name: means[name] for name in AMOUNTS if name in act.row.takes}
