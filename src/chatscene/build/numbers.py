"""Numbers of somebody's plan: what was said binds a parameter, what was not has a range that is searched."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from dataclasses import dataclass, field

from chatscene.errors import NotBuilt
from chatscene.situations.phrases import one_of, one_seen
from chatscene.terms.actors import NEARLY, REVERSE_SPEED, RoadUser
from chatscene.terms.amount import Amount
from chatscene.terms.snippet import ParameterRange
from chatscene.terms.vocabulary import Manner, UserKind

_NAME = re.compile(r"\$([A-Z][A-Z0-9_]*)")
_OF_DEED = re.compile(r"_\d+$")
GENTLEST = 0.02  # of the brakes, the least that is pressed

RANGES: dict[str, tuple[float, float, str, str]] = {
    "OFFSET": (-1.5, 1.0, "s", "how much sooner than the ego it reaches the point where their paths meet"),
    "BRAKE": (0.5, 1, "1", "how hard it brakes"),
    "EASE": (0.2, 0.35, "1", "how gently it brakes"),
    "BRAKE_TIME": (0.7, 1.4, "s", "for how long it brakes"),
    "STOP_TIME": (1, 2.5, "s", "how long it stands"),
    "GO_TIME": (1, 2, "s", "for how long it goes on so"),
    "THROTTLE": (0.6, 1, "1", "how far the pedal is pressed"),
    "BACK": (1, 3, "m/s", "how fast it backs up"),
    "BACK_TIME": (1.5, 3, "s", "for how long it backs up"),
    "AMPLITUDE": (0.7, 1.2, "m", "how far it swings to either side"),
    "SWERVE": (1.6, 2.6, "m", "how far it swerves"),
    "SPIN": (0.1, 0.3, "1/m", "how far it turns about itself for each metre that it slides"),
    "SLIDE": (0.6, 0.8, "1", "how much it loses of its speed as it slides, of what its brakes give"),
    "SWERVE_TIME": (1, 1.6, "s", "for how long it swerves"),
    "DRIFT": (1.4, 2, "m", "how far it drifts"),
    "OFF": (3.1, 4.0, "m", "how far from its line it stops beside the road"),
    "NEAR_TIME": (2, 3, "s", "for how long it goes on before the ego"),
    "PACE_TIME": (2, 3.5, "s", "for how long it keeps so"),
    "LEVEL": (-2, 2, "m", "how far ahead of the ego it keeps"),
    "STEADY": (0.6, 1.8, "s", "for how long it goes on before it does anything"),
    "GAP": (0.5, 2.5, "m", "how much room it leaves"),
    "ROOM": (5, 12, "m", "how far behind whom it follows it is"),
    "AHEAD": (3, 8, "m", "how far ahead it is before it comes back"),
    "NEAR": (12, 30, "m", "how near the ego is when it acts"),
    "LEAD_TIME": (1.2, 2.6, "s", "how long before they would meet it acts"),
    "SLANT": (0.5, 0.8, "rad", "how far from straight over it goes"),
    "X": (1.0, 2.5, "m", "how far outside the lanes it stands"),
}
"""The parameters of plans but for places and speeds: range, unit, meaning."""

_SHARES: dict[str, Callable[[RoadUser], float]] = {
    "BRAKE": lambda row: row.limits.brake,
    "THROTTLE": lambda row: row.limits.throttle,
}
"""Parameters that are a share of what a body can do: of how much [m/s²]."""
FIRM = {Manner.HARD: 0.8, Manner.SUDDEN: 0.8}
"""From which share of its brakes on somebody brakes hard, or suddenly."""

PACES: dict[Manner | None, str] = {Manner.SLOW: "SLOW", Manner.FAST: "FAST"}
"""The ranges of the speed of somebody who is said to go slowly or fast."""


def strong(row: RoadUser) -> str:
    """What a program says of one that holds a higher speed than others of its kind."""
    return f", with topSpeed {row.limits.top_speed:.4g}" if row.limits.most else ""


def rigid(who: str, row: RoadUser) -> str:
    """What is told of two that are coupled."""
    return f"{who} and what it tows are built as one rigid body, {row.limits.length:g} m long"


def stronger(who: str, kind: UserKind, row: RoadUser) -> str:
    """What is told of one that is, with what a common one holds; empty of any other."""
    if not row.limits.most:
        return ""
    usual = kind.row.body.row.limits.holds
    return f"{who} is {one_of(kind)} that is faster than most, which hold {3.6 * usual:.0f} km/h"


@dataclass(slots=True)
class Numbers:
    """The parameters of one road user.

    Attributes:
        name: Whose; stands in the name of each.
        row: What holds of its kind.
        ranges: For each that is used, from where to where, its unit and meaning.
        bound: For each that was said, the path of the fact.
        read: Those that a text reads.
        held: Those that follow from what was said, so that nobody shifts them.
    """

    name: str
    row: RoadUser
    ranges: dict[str, tuple[float, float, str, str]] = field(default_factory=dict[str, tuple[float, float, str, str]])
    bound: dict[str, str] = field(default_factory=dict[str, str])
    read: set[str] = field(default_factory=set[str])
    held: set[str] = field(default_factory=set[str])

    def __post_init__(self) -> None:
        # A watcher calls it slow below one speed and fast from another on: what is neither lies between.
        top = self.row.limits.fastest
        slow, fast = self.row.slow, min(self.row.fast, top)
        meaning = "how fast it goes"
        self.ranges["SPEED"] = (0.55 * fast, 0.82 * fast, "m/s", meaning)
        self.ranges["SLOW"] = (0.5 * slow, 0.9 * slow, "m/s", "how slow it then is")
        self.ranges["FAST"] = (fast, min(1.25 * fast, top), "m/s", "how fast it then is")

    def bind(self, name: str, amount: Amount, path: str = "") -> None:
        """Let a parameter be what was said.

        Args:
            name: The parameter.
            amount: What was said of it.
            path: The fact that says it.

        Raises:
            NotBuilt: No body of its kind can do that.
        """
        low, high, unit, meaning = self.range_of(name)
        share = _SHARES.get(_OF_DEED.sub("", name))
        scale = share(self.row) if share else 1.0
        drag = self.row.limits.drag if name.startswith("BRAKE") and share else 0.0  # which slows it down as well
        least, most = ((end - drag) / scale for end in amount.drawn(low * scale + drag, high * scale + drag))
        fastest = self.row.limits.fastest
        if name.startswith("BACK"):
            fastest = min(NEARLY * REVERSE_SPEED, fastest)
        top = 1.0 if share else fastest if unit == "m/s" else most
        least, most = (max(GENTLEST, least), max(GENTLEST, most)) if drag else (least, most)
        if least > top + 1e-9:
            most_told = f"at most {top * scale:.3g} {unit if unit != '1' else 'm/s²'}"
            if unit == "m/s":
                most_told = f"at most {math.floor(3.6 * top + 1e-9)} km/h"
            at = f"{path}: " if path else ""
            raise NotBuilt(f"{at}{amount} is more than {one_seen(self.row.scenic)} can do: {most_told}")
        self.ranges[name] = (least, min(most, top), unit, meaning)
        self.bound[name] = path

    def built(self) -> tuple[str, ...]:
        """The paths of the facts whose numbers a text reads."""
        return tuple(path for name, path in self.bound.items() if name in self.read)

    def narrow(self, name: str, low: float, high: float) -> None:
        """Give a parameter another range, where no number was said of it; no speed is more than it can."""
        _, _, unit, meaning = self.range_of(name)
        most = self.row.limits.fastest if unit == "m/s" else high
        self.ranges[name] = (min(low, most), min(high, most), unit, meaning)

    def move(self, name: str, by: float) -> None:
        """Let a parameter be more by a number."""
        low, high, *_ = self.range_of(name)
        self.narrow(name, low + by, high + by)

    def measure(self, name: str, low: float, high: float, unit: str, meaning: str, path: str = "") -> None:
        """A parameter that says where it is or when it acts, with the path of the fact if it was said."""
        self.ranges[name] = (low, high, unit, meaning)
        if path:
            self.bound[name] = path

    def middle(self, name: str) -> float:
        """The middle of the range of a parameter."""
        low, high, *_ = self.range_of(name)
        return (low + high) / 2

    def is_said(self, name: str) -> bool:
        """Whether it was said."""
        return name in self.bound

    def range_of(self, name: str) -> tuple[float, float, str, str]:
        """The range of a parameter, or of that which it is for one deed alone, as ``BRAKE_1`` is of ``BRAKE``."""
        if name in self.ranges:
            return self.ranges[name]
        general = _OF_DEED.sub("", name)
        return self.ranges.get(general) or RANGES[general]

    def filled(self, text: str) -> str:
        """A text of Scenic with parameters, or the number where one was said, in the place of ``$NAME``."""
        return _NAME.sub(lambda found: self.value(found[1]), text)

    def value(self, name: str) -> str:
        """What stands for a parameter in a program."""
        low, high, *_ = self.ranges.setdefault(name, self.range_of(name))
        self.read.add(name)
        return f"globalParameters.{self.called(name)}" if high > low else f"{low:.6g}"

    def called(self, name: str) -> str:
        """The name of a parameter in the program."""
        return f"OPT_{self.name.upper().replace('-', '_')}_{name}"

    def declared(self, source: str) -> tuple[ParameterRange, ...]:
        """The parameters that a text reads."""
        read = set(re.findall(r"globalParameters\.(\w+)", source))
        return tuple(
            ParameterRange(name=self.called(name), low=_rounded(low), high=_rounded(high), unit=unit, meaning=meaning)
            for name, (low, high, unit, meaning) in self.ranges.items()
            if self.called(name) in read
        )


def _rounded(value: float) -> float:
    return float(f"{value:.6g}")
