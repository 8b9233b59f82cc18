"""How a junction is controlled, and where its traffic has to stop."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

from chatscene.errors import MapError
from chatscene.maps.furniture import furniture_of
from chatscene.maps.kept import kept
from chatscene.terms.scenario import Control

STOP_SIGN, GIVE_WAY_SIGN = "206", "205"  # OpenDRIVE's catalogue follows the German one, as do CARLA's maps


@dataclass(frozen=True, slots=True, kw_only=True)
class StopLine:
    """Where a lane meets a junction.

    Attributes:
        lane: Scenic's id of the incoming lane; manoeuvres that start in it obey this line.
        junction: Scenic's id of the junction.
        control: What tells drivers to stop here.
        x0: Left end, seen by the driver [m].
        y0: Left end [m].
        x1: Right end [m].
        y1: Right end [m].
        heading: Driving direction across it [rad, 0 = +x, counter-clockwise].
        lights: Ids of its traffic lights in OpenDRIVE.
    """

    lane: str
    junction: str
    control: Control
    x0: float
    y0: float
    x1: float
    y1: float
    heading: float
    lights: tuple[str, ...]


def junction_control(junction: Any) -> Control:
    """How one of Scenic's intersections is controlled; a traffic light outranks a stop sign.

    Signals stand on the roads through it or, as some maps have them, at the end of the roads into it.
    """
    return kept(junction, "control", _control)


def control_before(junction: Any, lane: Any) -> Control:
    """How a lane into a junction is controlled: as the junction, or free where only other lanes have a stop sign."""
    whole = junction_control(junction)
    free = whole is Control.STOP_SIGN and lane.uid not in (signed := _with_stop_sign(junction)) and bool(signed)
    return Control.NONE if free else whole


def _with_stop_sign(junction: Any) -> frozenset[str]:
    """Scenic's ids of the lanes whose ways through a junction have a stop sign; some maps have them elsewhere."""
    lanes = {maneuver.startLane.uid: maneuver.startLane for maneuver in junction.maneuvers}
    return frozenset(
        uid for uid, lane in lanes.items() if _strongest(_signals_before(junction, lane)) is Control.STOP_SIGN
    )


def _signals_before(junction: Any, lane: Any) -> list[Any]:
    """The signals of the ways that lead on from a lane."""
    return [one for m in junction.maneuvers if m.startLane is lane for one in m.connectingLane.road.signals]


def _control(junction: Any) -> Control:
    if any(_lights(maneuver) for maneuver in junction.maneuvers):
        return Control.SIGNAL
    return _strongest(list(junction.signals))


def _lights(maneuver: Any) -> tuple[str, ...]:
    """OpenDRIVE's ids of the lights of a way through a junction, on the way itself or at the end of its first lane."""
    lights = furniture_of(maneuver.startLane.network).lights
    before, way = maneuver.startLane, maneuver.connectingLane.road.id
    places = ((before.road.id, before.group is before.road.forwardLanes), (way, True), (way, False))
    return tuple(light for place in places for light in lights.get(place, ()))


def junction_signals(network: Any, junction: str) -> tuple[StopLine, ...]:
    """The stop lines of a junction, one for each incoming lane, sorted by lane id.

    A lane is under the control of the signals on the connecting roads that lead on from it, and of the lights at its
    own end. Lanes that nothing controls have a line with control ``none``.

    Args:
        network: Scenic's road network.
        junction: Scenic's id of an intersection.

    Raises:
        MapError: The network has no such junction.
    """
    found = next((element for element in network.intersections if element.uid == junction), None)
    if found is None:
        raise MapError(f"the map has no junction {junction!r}")
    lanes = {maneuver.startLane.uid: maneuver.startLane for maneuver in found.maneuvers}
    return tuple(_stop_line(lanes[uid], found) for uid in sorted(lanes))


def _stop_line(lane: Any, junction: Any) -> StopLine:
    ways = [m for m in junction.maneuvers if m.startLane is lane]
    signals = _signals_before(junction, lane)
    lights = {light for maneuver in ways for light in _lights(maneuver)}
    (x0, y0, *_), (x1, y1, *_) = lane.leftEdge.points[-1], lane.rightEdge.points[-1]
    return StopLine(
        lane=lane.uid,
        junction=junction.uid,
        control=Control.SIGNAL if lights else _strongest(signals),
        x0=float(x0),
        y0=float(y0),
        x1=float(x1),
        y1=float(y1),
        heading=math.atan2(x1 - x0, y0 - y1),  # a quarter turn to the left of the way from left to right
        lights=tuple(sorted(lights | {str(signal.openDriveID) for signal in signals if signal.isTrafficLight})),
    )


def _strongest(signals: list[Any]) -> Control:
    if any(signal.isTrafficLight for signal in signals):
        return Control.SIGNAL
    if any(signal.type == STOP_SIGN for signal in signals):
        return Control.STOP_SIGN
    return Control.NONE
