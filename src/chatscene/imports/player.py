"""An actor whose events are read: what is known of it, and what it does after the events so far."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

from chatscene.imports.stranger_xml import Element
from chatscene.terms.actors import Limits
from chatscene.terms.plan import After, Phase, Until
from chatscene.terms.polyline import Polyline
from chatscene.terms.sums import Sum, number

AHEAD = "ahead"  # the way of somebody who goes straight on, and follows no line
STANDS = 0.1  # [m/s]


@dataclass(frozen=True, slots=True)
class InLane:
    """A lane that somebody stands in.

    Attributes:
        number: Of the lane, as OpenDRIVE counts: it grows to the left of the road's reference line.
        left: 1 where the left of whoever stands there is the left of the reference line; -1 where that road user faces
            against the line, so that lanes to its left have lower numbers.
    """

    number: int
    left: int


@dataclass(frozen=True, slots=True, kw_only=True)
class Player:
    """Whose events are read.

    Attributes:
        prefix: What its lines are called, with a number behind.
        speed: At first [m/s].
        way: The name of the line that it follows at first; None if it follows none.
        start: Where on that line it is, of its centre [m].
        beside: How far to the left of that line it begins, and stays until it is told otherwise [m].
        lane: The line of a lane beside its own, by number.
        lane_from: The lane that somebody stands in at first, and how that road user faces.
        left: 1 where a lane's offset to the left of the road's line is left of who drives in it, else -1.
        side: 1 where the file counts y to the left; -1 where it counts to the right of whoever drives, as CARLA does.
        toward: Whether it faces the ego's way at first, so that the two come straight toward each other.
        ego_at: How far along the ego's route [m] a position is.
        lines: All lines, by name; those of its own are added.
        lanes: The lane of each line that somebody changes to.
    """

    name: str
    ego: str
    prefix: str
    limits: Limits
    walks: bool
    speed: float
    way: str | None
    beside: float
    lane: Callable[[Element, int], Polyline]
    lane_from: Callable[[Element, str], InLane]
    left: int
    side: int
    toward: bool
    ego_at: Callable[[Element], Sum]
    line_of: Callable[[Element, str], tuple[str, Polyline]]
    lines: dict[str, Polyline]
    lanes: dict[str, int]

    @property
    def measured_on(self) -> str:
        """The line along which it is told how far it has come."""
        return self.way or f"{self.prefix}Way"


@dataclass(slots=True)
class Done:
    """When an action is done: at once, after some time, or once something holds."""

    end: After | Until | None = None


@dataclass(slots=True)
class State:
    """What an actor does after the events so far."""

    way: str | None
    speed: Sum
    left: Sum = field(default_factory=lambda: number(0.0))
    turn: float = 0.0
    phases: list[Phase] = field(default_factory=list[Phase])
    done: Done = field(default_factory=Done)
    turned: Done = field(default_factory=Done)
    measured: bool = False
