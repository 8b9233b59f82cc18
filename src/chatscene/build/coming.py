"""How fast the ego comes, and how much road that takes: what encounters are timed by."""

from __future__ import annotations

import math
from bisect import bisect_right
from dataclasses import dataclass, replace

from chatscene.build.relations import speed_kept_up, speed_of_traffic
from chatscene.build.usual import speed_of_road
from chatscene.terms.backing import backs
from chatscene.terms.order import Order
from chatscene.terms.pace import NOMINAL, usual_speed
from chatscene.terms.profile import Timetable
from chatscene.terms.situation import Situation
from chatscene.world.ego_route import EgoRoute as Route
from chatscene.world.places import timetable

_STEP = 0.1  # [s], in which a drive on an empty road is computed
_LONGEST = 60.0  # [s] of it
WAITS = 4.0  # [s] that an ego is taken to wait for what somebody else does
WALKS = 1.6  # [m/s] that an ego backs at, if no speed was said
_ASIDE = 1.2  # [m] to the side: an ego that turns so far goes over the way of who is beside it


@dataclass(frozen=True, slots=True, kw_only=True)
class Coming:
    """How an ego that nobody meets gets on.

    Attributes:
        speed: What it drives at where nothing holds it [m/s].
        table: When it is where on the first route that was found, if it drives as it wants from the first.
        late: How much later [s] than by that it is where the others meet it; None if it never is.
        stands: Whether it stands, from the first on and all the time.
        drive: Where on that route [m] it begins, then how far it is from there [m] and when [s], step by step.
        held: For how long [s] it is held where it stands at first, before it sets off.
        keeps_limits: Whether the limits of roads hold for it.
        gain: With which it takes up speed [m/s²].
        gains: Whether it gains more speed than it wants at first.
    """

    speed: float
    table: Timetable
    late: float | None
    drive: tuple[float, tuple[tuple[float, float], ...]] = (0.0, ())
    stands: bool = False
    held: float = 0.0
    keeps_limits: bool = False
    gain: float = NOMINAL.gain
    gains: bool = False

    def seconds(self, metres: str, at: float | None = None) -> str:
        """When it is so many metres on its way, as a text of Scenic.

        Args:
            metres: How many, as a text of Scenic.
            at: How many that are on the first route that was found [m]; where its manoeuvre begins, if it is not said.

        Raises:
            ValueError: It never is.
        """
        if self.late is None:
            raise ValueError("it never gets there")
        keeps = "".join((f", {self.keeps_limits}", f", {self.gain:.3g}" if self.gain != NOMINAL.gain else ""))
        late = self.late if at is None else self.late_at(at)
        more = f" {'+' if late > 0.0 else '-'} {abs(late):.2f}" if abs(late) > _STEP else ""
        return f"timeTo(egoRoute, {metres}, {self.speed:.4g}{keeps})" + more

    def late_at(self, metres: float) -> float:
        """How much later [s] it is so many metres on its way than if it drove as it wants from the first.

        It is sooner there, which is less than 0, if it gains more speed than it wants at first.
        """
        begins, drive = self.drive
        i = bisect_right(drive, (metres - begins, math.inf))
        if i == len(drive):
            return self.late or 0.0
        late = drive[i][1] - self.table.time_to(begins, metres)
        return late if self.gains else max(0.0, late)

    def time_at(self, metres: float) -> float:
        """When it is so many metres on its way [s], if it is not late there."""
        return self.table.time_at(metres)


def wanted_by(situation: Situation) -> float:
    """What the ego drives at where nothing holds it [m/s]: as was said of it or of the traffic, else as is usual."""
    said = situation.ego.speed
    if said is None and backs(situation):
        return WALKS
    return min(free_speed(situation), speed_kept_up(situation)) if said is None else said.most


def free_speed(situation: Situation) -> float:
    """What an ego of no said speed usually drives at [m/s], whoever is to keep up with it."""
    body = situation.ego.body
    usual = max(usual_speed(body, speed_of_road(situation)), speed_of_traffic(situation))
    return min(usual, body.row.limits.fastest)


def keeps_limits(situation: Situation) -> bool:
    """Whether the limits of roads hold for the ego: it wants what its road does, and not what was said of anybody."""
    said = situation.ego.speed is not None or situation.road.speed_limit is not None or backs(situation)
    return not said and speed_of_traffic(situation) <= speed_of_road(situation)


def speeds_to_try(situation: Situation) -> tuple[float, ...]:
    """The speeds [m/s] at which an ego may be built, best first: if none was said, slower ones besides."""
    first = wanted_by(situation)
    if situation.ego.speed is not None or first <= NOMINAL.speed:
        return (first,)
    tens = range(10 * math.ceil(0.36 * first - 1e-9) - 10, 0, -10)
    return (first, *(speed for ten in tens if (speed := ten / 3.6) > NOMINAL.speed), NOMINAL.speed)


def further(speed: float) -> float:
    """How many times as much road as usual leads up to what happens; 1 at the nominal speed [m/s] or below."""
    return max(1.0, speed / NOMINAL.speed)


def coming(
    speed: float,
    orders: tuple[Order, ...],
    route: Route,
    metres: float,
    *,
    stands: bool,
    keeps_limits: bool = False,
    gain: float = NOMINAL.gain,
    later: float = 0.0,
) -> Coming:
    """How an ego gets on that wants a speed and has orders.

    Args:
        speed: What it wants [m/s].
        orders: What it is held to.
        route: Its way.
        metres: How far it is, from where it begins, to where its manoeuvre does.
        stands: Whether it stands at first.
        keeps_limits: Whether the limits of roads hold for it.
        gain: How it gets under way [m/s²].
        later: What it wants in the end [m/s], if that is more; its orders hold it before.
    """
    orders = tuple(replace(one, till=WAITS) if one.ends else one for one in orders if one.ends or not one.whom)
    table = timetable(route, speed, keeps_limits=keeps_limits, gain=gain)
    gains = later > speed
    wants = timetable(route, later, keeps_limits=keeps_limits, gain=gain) if gains else table
    begins = route.eventAt - metres
    at, time, now = 0.0, 0.0, 0.0 if stands else speed
    drive, end = [(0.0, 0.0)], route.line.length - begins
    while at < end and time < _LONGEST:
        allowed = min([wants.speed_at(begins + at), *(order.allows(time, at) for order in orders)])
        now = min(allowed, now + gain * _STEP)
        at, time = at + now * _STEP, time + _STEP
        drive.append((at, time))
    there = next((when for far, when in drive if far >= metres), None)
    first = (order.till for order in orders if order.allows(0.0, 0.0) <= 0.0 and order.till < math.inf)
    late = None if there is None else there - table.time_to(begins, route.eventAt)
    return Coming(
        speed=speed,
        table=table,
        late=late if late is None or gains else max(0.0, late),
        drive=(begins, tuple(drive)),
        stands=at <= 0.0,
        held=max(first, default=0.0),
        keeps_limits=keeps_limits,
        gain=gain,
        gains=gains,
    )


def goes_over(route: Route, ego: Coming) -> tuple[float, float]:
    """How far on [m] straight ahead, and when [s], an ego goes over the way of who is beside it."""
    line, begins = route.line, route.eventAt
    (x, y), heading = line.point_at(begins), line.heading_at(begins)
    along = begins
    for at in (begins + 0.5 * step for step in range(80)):
        px, py = line.point_at(at)
        along = begins + (px - x) * math.cos(heading) + (py - y) * math.sin(heading)
        if abs((py - y) * math.cos(heading) - (px - x) * math.sin(heading)) > _ASIDE:
            break
    else:
        at = along = begins
    return along, ego.time_at(at)
