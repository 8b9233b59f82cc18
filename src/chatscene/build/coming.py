"""How fast the ego comes, and how much road that takes: what encounters are timed by."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from chatscene.build.numbers import MOST
from chatscene.build.relations import speed_of_traffic
from chatscene.terms.backing import backs
from chatscene.terms.order import Order
from chatscene.terms.pace import NOMINAL, usual_speed
from chatscene.terms.polyline import Polyline
from chatscene.terms.profile import CURVE_ACCELERATION, HELD_BACK
from chatscene.terms.situation import Situation
from chatscene.world.control import curve_speeds
from chatscene.world.places import EgoRoute as Route

_STEP = 0.1  # [s], in which a drive on an empty road is computed
_LONGEST = 60.0  # [s] of it
WAITS = 4.0  # [s] that an ego is taken to wait for what somebody else does
WALKS = 1.6  # [m/s] that an ego backs at, if no speed was said
_ASIDE = 1.2  # [m] to the side: an ego that turns so far goes over the way of who is beside it


@dataclass(frozen=True, slots=True)
class Coming:
    """How an ego that nobody meets gets on.

    Attributes:
        speed: What it drives at where nothing holds it [m/s].
        late: How much later [s] than at that speed from the first it is where the others meet it; None if it never is.
        stands: Whether it stands, from the first on and all the time.
        held: For how long [s] it is held where it stands at first, before it sets off.
    """

    speed: float
    late: float | None
    stands: bool = False
    held: float = 0.0

    def seconds(self, metres: str) -> str:
        """When it is so many metres on its way, as a text of Scenic.

        Raises:
            ValueError: It never is.
        """
        if self.late is None:
            raise ValueError("it never gets there")
        return f"{metres} / {self.speed:.4g}" + (f" + {self.late:.2f}" if self.late > _STEP else "")


def wanted_by(situation: Situation) -> float:
    """What the ego drives at where nothing holds it [m/s]: as was said of it or of the traffic, else as is usual."""
    said, body = situation.ego.speed, situation.ego.body
    if said is None and backs(situation):
        return WALKS
    if said is None:
        return min(max(usual_speed(body), speed_of_traffic(situation)), MOST * body.row.limits.top_speed)
    return said.high if said.high < float("inf") else said.low


def further(situation: Situation) -> float:
    """How many times as much road as usual leads up to what happens; 1 at the nominal speed or below."""
    return max(1.0, wanted_by(situation) / NOMINAL.speed)


def coming(
    speed: float, orders: tuple[Order, ...], metres: float, *, stands: bool, gain: float = NOMINAL.gain
) -> Coming:
    """How an ego gets on that wants a speed and has orders.

    Args:
        speed: What it wants [m/s].
        orders: What it is held to.
        metres: How far it is to where the others meet it.
        stands: Whether it stands at first.
        gain: How it gets under way [m/s²].
    """
    orders = tuple(replace(one, till=WAITS) if one.ends else one for one in orders if one.ends or one.phase < 0)
    at, time, now = 0.0, 0.0, 0.0 if stands else speed
    while at < metres and time < _LONGEST:
        allowed = min([speed, *(order.allows(time, at) for order in orders)])
        now = min(allowed, now + gain * _STEP)
        at, time = at + now * _STEP, time + _STEP
    first = (order.till for order in orders if order.allows(0.0, 0.0) <= 0.0 and order.till < math.inf)
    late = max(0.0, time - metres / speed) if at >= metres else None
    return Coming(speed, late, stands=at <= 0.0, held=max(first, default=0.0))


def goes_over(route: Route, speed: float) -> tuple[float, float]:
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
    return along, at / speed + lost_in_curves(line, speed, at)


EGO_GRIP = CURVE_ACCELERATION / HELD_BACK
"""What a road would have to hold [m/s²] for a driver to take its curves as an ego does."""


def lost_in_curves(line: Polyline, speed: float, to: float, grip: float = EGO_GRIP) -> float:
    """How much longer [s] somebody who wants a speed takes to somewhere on its way, since it is slower in curves.

    Args:
        line: Its way.
        speed: What it wants [m/s].
        to: How far along that [m].
        grip: What the road holds [m/s²]; as an ego takes curves, if nothing is said.
    """
    lengths = line.columns[2]
    lost, now = 0.0, speed
    for begins, ends, allowed in zip(lengths, lengths[1:], curve_speeds(line, grip), strict=False):
        if begins >= to:
            break
        now = min(allowed, speed, (now * now + 2.0 * NOMINAL.gain * (ends - begins)) ** 0.5)
        lost += (ends - begins) * (1.0 / now - 1.0 / speed)
    return lost
