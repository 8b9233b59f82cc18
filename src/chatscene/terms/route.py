"""Routes: what the ego must drive.

Paper: section 3.1 ("Route"), section 4.2 (ten routes per base scenario).
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum

from chatscene.terms.polyline import Polyline
from chatscene.terms.scenario import Control, Maneuver, Place, Site
from chatscene.terms.vocabulary import Setting


class Beside(StrEnum):
    """Where a route begins or ends that does not do so in its lane."""

    KERB = "kerb"
    DRIVEWAY = "driveway"
    DRIVEWAY_ACROSS = "driveway-across"
    BACK = "back"
    BACKWARDS = "backwards"
    BACK_FROM_DRIVEWAY = "back-from-driveway"
    BACK_FROM_BAY = "back-from-bay"


class Equipment(StrEnum):
    """What the roads of a route have, beyond their lanes."""

    CROSSWALKS = "crosswalks"  # at its junction, on the arm by which it comes and on the one that it takes
    CYCLE_LANE = "cycle-lane"  # beside the lanes where it begins
    TRAM_TRACK = "tram-track"  # in the road where it begins or, at a junction, in one of its roads
    BAYS = "bays"  # on both sides, as in a car park
    GIVE_WAY = "give-way"  # a sign to give way where it comes into its junction
    BUS_LANE = "bus-lane"  # beside the other lanes of its direction where it begins


class Shape(StrEnum):
    """Where the other two arms of a junction of three lie, as one comes to it."""

    SIDE_LEFT = "side-left"  # straight on and left
    SIDE_RIGHT = "side-right"  # straight on and right
    STEM = "stem"  # left and right: one comes up the stem of a T
    FORK = "fork"  # half left and half right


@dataclass(frozen=True, slots=True, kw_only=True)
class RouteQuery:
    """What a route must offer; a geometry snippet is such a query.

    Attributes:
        maneuver: What the ego does.
        place: Where; None stands for anywhere the manoeuvre is possible. A left or right curve is a bend that way;
            the route's own place is then CURVE.
        control: How the junction is controlled; None for any.
        lanes_same_way: At least this many lanes in the ego's direction.
        most_lanes: At most this many; None for any number.
        opposite_lane: Whether a lane of the opposite direction must lie directly beside the ego's. A bypass leads
            through that lane, or, where there must be none, through a second lane of the ego's direction.
        lane_beside: ``left`` or ``right`` if a lane of the ego's direction must lie directly on that side, ``none``
            if the ego's must be the only one of its direction.
        conflicting_from: Sides ("left", "right", "oncoming") from which another vehicle must be able to
            cross the ego's way at the junction.
        site: What it leads along or through. At ramps, lane drops and where traffic weaves, a lane change is the one
            that is driven for there, and straight on stays in the lane. A roundabout is turned right, left or
            straight through, as seen from its entry.
        lane: Which lane of its direction it starts in, 1 for the outermost and -1 for the innermost, and on open road
            still is where its manoeuvre begins.
        approach: How far [m] it leads up to where its manoeuvre begins, on open road as far beyond; None for as far as
            is usual there.
        begins: Where it begins beside its lane: at the ``kerb`` or in a ``driveway`` on its right. One that is driven
            backwards leads along its lane against that, or out of a driveway or a bay and then against its lane.
        ends: Where it ends beside its lane: at the kerb, in a driveway, in one across the
            lanes of the other direction, or ``back`` in a lane of the other direction.
        setting: What lies about the road that it begins on; None for anything.
        divided: Whether no lane of the other direction may lie beside any of the ego's direction.
        shape: What shape its junction of three arms has, from where it comes.
        arms: How many its junction or roundabout has.
        across: From where to where [m] the diameter of its roundabout may lie.
        by_exit: By which exit it leaves its roundabout, counted from where it enters.
        has: What its roads have. Ways of a car park are found only for those who ask for bays.
    """

    maneuver: Maneuver
    place: Place | None = None
    control: Control | None = None
    lanes_same_way: int = 1
    most_lanes: int | None = None
    opposite_lane: bool | None = None
    lane_beside: str | None = None
    conflicting_from: tuple[str, ...] = ()
    site: Site | None = None
    lane: int | None = None
    approach: float | None = None
    begins: Beside | None = None
    ends: Beside | None = None
    setting: Setting | None = None
    divided: bool = False
    shape: Shape | None = None
    arms: int | None = None
    across: tuple[float, float] | None = None
    by_exit: int | None = None
    has: tuple[Equipment, ...] = ()

    @property
    def slug(self) -> str:
        """A name for all that it asks for, so that a route's id stands for one route of the map."""
        parts = [self.maneuver, self.place, self.control]
        parts += [f"{self.lanes_same_way}-lanes"] * (self.lanes_same_way > 1)
        parts += [None if self.most_lanes is None else f"{self.most_lanes}-lanes-at-most"]
        parts += [None if self.opposite_lane is None else "opposite" if self.opposite_lane else "one-way"]
        parts += ["one-lane" if self.lane_beside == "none" else f"lane-{self.lane_beside}"] if self.lane_beside else []
        parts += [f"from-{side}" for side in self.conflicting_from]
        parts += [self.site, None if self.lane is None else f"lane{self.lane}"]
        parts += [None if self.approach is None else f"after-{self.approach:g}"]
        parts += [None if self.begins is None else f"out-of-{self.begins}"]
        parts += [None if self.ends is None else f"into-{self.ends}"]
        parts += [self.shape, None if self.arms is None else f"{self.arms}-arms"]
        parts += [None if self.across is None else f"{self.across[0]:g}-to-{self.across[1]:g}-m-across"]
        parts += [None if self.by_exit is None else f"exit{self.by_exit}"]
        parts += [self.setting, "divided" if self.divided else None, *self.has]
        return "-".join(part for part in parts if part is not None)


@dataclass(frozen=True, slots=True, kw_only=True)
class Route:
    """A start pose and the waypoints the ego must pass.

    Attributes:
        id: Stable for a map and a query, e.g. ``left-turn-03``.
        map_name: The map's file name without suffix.
        maneuver: What it does.
        place: Where its manoeuvre happens.
        control: How the junction on it is controlled; NONE on open road.
        line: The waypoints, about 1 m apart, (N, 2) [m], map frame, first one at the start pose.
        lane_ids: Scenic's ids of the lanes it uses, in driving order.
        event_at: Arc length [m] where the manoeuvre begins: the junction's entry, the start of the lane change, the
            nose of a ramp, a crosswalk or the start of a bay or, on open road, the middle.
        exit_at: Arc length [m] where it leaves its junction; None on open road, and where nobody asked the map.
        junction: Scenic's id of the junction on it, or None.
        site: What it was asked to lead along or through, if anything.
        mirrored: Whether its map is of left-hand traffic, so that whoever finds or judges keeping to the right takes it
            in the mirror (`chatscene.terms.mirroring`).
    """

    id: str
    map_name: str
    maneuver: Maneuver
    place: Place
    control: Control
    line: Polyline
    lane_ids: tuple[str, ...]
    event_at: float
    exit_at: float | None = None
    junction: str | None = None
    site: Site | None = None
    mirrored: bool = False

    @property
    def length(self) -> float:
        """Length [m]."""
        return self.line.length

    @property
    def start_heading(self) -> float:
        """Heading [rad, 0 = +x, counter-clockwise] at the start pose."""
        return self.line.heading_at(0.0)
