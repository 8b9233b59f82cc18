"""How long somebody takes from when its first deed is due to when it meets the ego, whatever its numbers are."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING

from chatscene.build.asked import Meets
from chatscene.build.facing import LONGER
from chatscene.build.numbers import Numbers
from chatscene.build.place import LANE
from chatscene.build.timing import Meeting
from chatscene.maps.crossings import MEETING
from chatscene.terms.vocabulary import Side, Where
from chatscene.world.control import curve_speeds
from chatscene.world.places import beside_road

if TYPE_CHECKING:
    from chatscene.build.actor import Actor

_NAME = re.compile(r"\$([A-Z][A-Z0-9_]*)")
_ON_ROAD = re.compile(r"^pointOn\(.*, (-?[\d.]+)( [+-] \$X)?\)$")
ASIDE = 4.0  # [m] before or beyond a junction, where its road is as wide as it is
_FELT = 0.05  # [s] by which a time changes over a range, from which on that is told


def in_terms_of(numbers: Numbers, texts: Iterable[str], seconds: Callable[[], float]) -> str:
    """A time as signed terms of Scenic: linear in the parameters that it depends on, and right at the middle of each.

    Args:
        numbers: The parameters.
        texts: Texts that read those on which it may depend.
        seconds: The time, at the middle of each range.
    """
    constant, terms = seconds(), list[str]()
    for name in sorted({name for text in texts for name in _NAME.findall(text)} - {"OFFSET"}):
        low, high, *_ = kept = numbers.range_of(name)
        if high <= low:
            continue
        was = numbers.ranges.get(name)
        ends = [_at(numbers, name, end, seconds) for end in (low, high)]
        if was is None:
            del numbers.ranges[name]
        else:
            numbers.ranges[name] = kept
        slope = (ends[1] - ends[0]) / (high - low)
        if abs(ends[1] - ends[0]) > _FELT:
            constant -= slope * 0.5 * (low + high)
            terms.append(f"{slope:+.3f} * ${name}")
    return " ".join(f"{term[0]} {term[1:]}" for term in (f"{constant:+.2f}", *terms))


def _at(numbers: Numbers, name: str, value: float, seconds: Callable[[], float]) -> float:
    numbers.narrow(name, value, value)
    return seconds()


def meeting_of(actor: Actor) -> Meeting:
    """Where somebody meets the ego, seen from where it begins."""
    stand = actor.stand
    if stand.meets is Meets.ACROSS:
        return Meeting(metres=_across(actor), beyond=1.0)
    far = actor.numbers.middle("Y") if "$Y" in stand.at else 0.0
    if (found := stand.found) is None:
        return Meeting(metres=far + 2 * LANE, beyond=MEETING)
    metres = far + found.meets_at - found.entry
    speeds = curve_speeds(found.line)
    begins = found.meets_at - metres

    def allowed(gone: float) -> float:
        return speeds[min(max(int(begins + gone), 0), len(speeds) - 1)]  # a segment is a metre long

    return Meeting(metres=metres, beyond=MEETING, allowed=allowed)


def _lanes_between(actor: Actor) -> int:
    """How many lanes lie between the ego's and the edge of the road at which somebody begins."""
    route, side = actor.found.route, actor.one.starts.side or Side.RIGHT
    behind = actor.one.starts.where is Where.EXIT_CROSSING
    at = route.exitAt + ASIDE if behind else max(route.eventAt - ASIDE, 0.0)
    edge = beside_road(route, at, str(side), 0.0)
    if edge is None:  # lanes go on and on to that side
        return int(side is Side.LEFT)
    return max(0, round((abs(route.line.project(*edge)[1]) - 0.5 * LANE) / LANE))


def _across(actor: Actor) -> float:
    if actor.stand.left == "0":
        return 0.1
    if on_road := _ON_ROAD.search(actor.stand.point):
        straight = abs(float(on_road[1])) - 1.0 + (actor.numbers.middle("X") if on_road[2] else 0.0)
    else:
        aside = actor.numbers.middle("X") if "$X" in actor.stand.point else 0.0
        straight = aside + LANE * _lanes_between(actor) + 1.0
    return straight * (LONGER if actor.stand.left.startswith(f"{LONGER:g} *") else 1.0)
