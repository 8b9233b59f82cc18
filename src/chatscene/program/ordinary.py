"""Ordinary drives: every route of a map with some traffic that keeps its distance and waits its turn.

What an ego is trained on and judged by before any adversary; never the benchmark's scenes (decision 0011).
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass

from chatscene.ego.observation import USUAL
from chatscene.errors import MapError
from chatscene.maps.routes import BASE_SCENARIO_QUERIES
from chatscene.simulate.simulator import Simulator
from chatscene.terms.route import RouteQuery
from chatscene.terms.scenario import BaseScenario, Maneuver, Place
from chatscene.terms.scene import ScenicProgram
from chatscene.terms.snippet import ParameterRange

_AHEAD = """
param OPT_AHEAD_Y = Range(15, 80)
param OPT_AHEAD_SPEED = Range(5, 9)
new Car at pointOn(egoRoute, globalParameters.OPT_AHEAD_Y),
    facing directionOn(egoRoute, globalParameters.OPT_AHEAD_Y), with label "ahead",
    with behavior FollowTraffic(egoRoute, globalParameters.OPT_AHEAD_SPEED)
"""
_BESIDE = """
param OPT_BESIDE_Y = Range(0, 60)
param OPT_BESIDE_SPEED = Range(4, 10)
for lane, opposing in lanesBeside(egoRoute):
    if opposing:
        new Car at pointOn(lane, levelOn(lane, egoRoute, 50 + globalParameters.OPT_BESIDE_Y)),
            facing directionOn(lane, levelOn(lane, egoRoute, 50 + globalParameters.OPT_BESIDE_Y)),
            with label "oncoming", with behavior FollowTraffic(lane, globalParameters.OPT_BESIDE_SPEED)
    else:
        new Car at pointOn(lane, globalParameters.OPT_BESIDE_Y),
            facing directionOn(lane, globalParameters.OPT_BESIDE_Y),
            with label "beside", with behavior FollowTraffic(lane, globalParameters.OPT_BESIDE_SPEED)
"""
_PARKED = """
param OPT_PARKED_Y = Range(10, 60)
for side in ("left", "right"):
    new Car at besideRoad(egoRoute, globalParameters.OPT_PARKED_Y, side, 1.5),
        facing directionOn(egoRoute, globalParameters.OPT_PARKED_Y), with label "parked"
"""
_BLOCKER = """
new Car at pointOn(ownLane(egoRoute), egoRoute.eventAt), facing directionOn(ownLane(egoRoute), egoRoute.eventAt),
    with label "blocker"
"""
_WAITING = """
param OPT_WAITING_Y = Range(5, 25)
param OPT_WAITING_SPEED = Range(4, 9)
for way in waitingTraffic(egoRoute):
    new Car at pointOn(way, way.entry - globalParameters.OPT_WAITING_Y),
        facing directionOn(way, way.entry - globalParameters.OPT_WAITING_Y),
        with label "waiting", with behavior WaitFor(ego, way, globalParameters.OPT_WAITING_SPEED)
"""
# What is otherwise where the ego drives at the speed of the road: so does everybody, in proportion, and from the first.
_AT_SPEED = {
    "globalParameters.OPT_AHEAD_Y": "maximum(globalParameters.OPT_AHEAD_Y, 15 * pace)",
    "globalParameters.OPT_AHEAD_SPEED": "pace * globalParameters.OPT_AHEAD_SPEED",
    "globalParameters.OPT_BESIDE_SPEED": "pace * globalParameters.OPT_BESIDE_SPEED",
    'with label "ahead"': 'with label "ahead", with speed speedOn(egoRoute, maximum(globalParameters.OPT_AHEAD_Y, '
    "15 * pace), pace * globalParameters.OPT_AHEAD_SPEED)",
    'with label "oncoming"': 'with label "oncoming", with speed pace * globalParameters.OPT_BESIDE_SPEED',
    'with label "beside"': 'with label "beside", with speed pace * globalParameters.OPT_BESIDE_SPEED',
}
_TOLD = re.compile("|".join(map(re.escape, _AT_SPEED)))

_RANGES = {
    "OPT_AHEAD_Y": (15.0, 80.0, "m", "how far ahead on the ego's route a car starts"),
    "OPT_AHEAD_SPEED": (5.0, 9.0, "m/s", "how fast it goes"),
    "OPT_BESIDE_Y": (0.0, 60.0, "m", "how far ahead cars in the lanes beside start"),
    "OPT_BESIDE_SPEED": (4.0, 10.0, "m/s", "how fast they go"),
    "OPT_PARKED_Y": (10.0, 60.0, "m", "how far ahead a car is parked at each kerb"),
    "OPT_WAITING_Y": (5.0, 25.0, "m", "how far before the junction cars wait for the ego to pass"),
    "OPT_WAITING_SPEED": (4.0, 9.0, "m/s", "how fast they go then"),
}


@dataclass(frozen=True, slots=True, kw_only=True)
class Course:
    """A program on one of its routes.

    Attributes:
        program: The program.
        route: Index of the route.
        values: Parameter values of its only scene; None if scenes are drawn from the program's ranges.
    """

    program: ScenicProgram
    route: int
    values: Mapping[str, float] | None = None


def ordinary_queries() -> tuple[RouteQuery, ...]:
    """The geometries of ordinary drives: those of the base scenarios, and bends."""
    queries = [query for base in BaseScenario for query in BASE_SCENARIO_QUERIES.get(base, ())]
    return tuple(dict.fromkeys([*queries, RouteQuery(maneuver=Maneuver.STRAIGHT, place=Place.CURVE)]))


def ordinary_program(query: RouteQuery, speed: float | None = None) -> ScenicProgram:
    """The program of ordinary drives on one geometry: traffic ahead, beside, waiting at the junction, parked cars.

    Signals show green to the ego, because no preset of observations shows it signals; nobody is beside it where it
    changes lanes or passes, because the four numbers do not show it who is there.

    Args:
        query: The geometry.
        speed: What the ego wants to drive at [m/s] as far as the limits of the roads let it; everybody who drives is
            then faster in proportion. None for an ego that is told nothing.
    """
    parts = [_AHEAD]
    if query.place in (Place.ROAD, Place.CURVE):
        parts += [_BESIDE, _PARKED]
    elif query.maneuver is Maneuver.BYPASS:
        parts += [_BLOCKER, _PARKED]
    elif query.maneuver in (Maneuver.STRAIGHT, Maneuver.LEFT_TURN, Maneuver.RIGHT_TURN):
        parts.append(_WAITING)
    arguments = {
        "maneuver": query.maneuver.value,
        "place": query.place and query.place.value,
        "control": query.control and query.control.value,
        "lanes": query.lanes_same_way,
        "opposite": query.opposite_lane,
        "beside": query.lane_beside,
        "crossed": query.conflicting_from,
    }
    written = ", ".join(f"{name}={value!r}" for name, value in arguments.items())
    traffic, wants, pace = "".join(parts), "", ""
    if speed is not None:
        traffic = _TOLD.sub(lambda one: _AT_SPEED[one[0]], traffic)
        pace = f"pace = maximum(1, speedOn(egoRoute, 0, {speed:.4g}) / {USUAL:g})\n"
        begins = f"with speed speedOn(egoRoute, 0, {speed:.4g})"
        wants = f", {begins}, with wantedSpeed {speed:.4g}, with keepsLimits True"
    source = (
        "# An ordinary drive.\n\nmodel chatscene.world.model\n\nparam signals = 'ego-green'\n\n"
        f"egoRoute = selectRoute({written})\negoSpawnPt = startOf(egoRoute)\n"
        f"{pace}ego = new Car at egoSpawnPt, facing directionOn(egoRoute, 0), with route egoRoute{wants}\n{traffic}"
    )
    names = sorted(name for name in _RANGES if name in source)
    return ScenicProgram(
        scenario_id=f"ordinary-{query.slug}",
        source=source,
        parameters=tuple(
            ParameterRange(
                name=name,
                low=_RANGES[name][0],
                high=_RANGES[name][1],
                unit=_RANGES[name][2],
                meaning=_RANGES[name][3],
            )
            for name in names
        ),
        snippet_ids=(),
    )


def ordinary_courses(simulator: Simulator, speed: float | None = None) -> tuple[Course, ...]:
    """Every ordinary drive that a map offers: at most ten routes per geometry.

    Args:
        simulator: On which map.
        speed: As of `ordinary_program`.

    Raises:
        MapError: The map offers none.
    """
    courses: list[Course] = []
    missing: list[str] = []
    for query in ordinary_queries():
        program = ordinary_program(query, speed)
        try:
            count = simulator.routes(program)
        except MapError as error:
            missing.append(str(error))
            continue
        courses += [Course(program=program, route=route) for route in range(count)]
    if not courses:
        raise MapError(f"the map offers no route for an ordinary drive: {missing[0]}")
    return tuple(courses)
