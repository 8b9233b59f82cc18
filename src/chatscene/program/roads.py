"""What a drive shows of the road, of the ego's light and of what surrounds it."""

from __future__ import annotations

from collections.abc import Iterator

from chatscene.program.finding import Finding, not_judged
from chatscene.program.meaning import is_place, maneuver_of
from chatscene.situations.phrases import ROADS
from chatscene.terms.changing import changes_later
from chatscene.terms.episode import Episode
from chatscene.terms.route import Route
from chatscene.terms.routing import CONTROLS, PLACES
from chatscene.terms.scenario import Maneuver
from chatscene.terms.situation import Road, Situation
from chatscene.terms.vocabulary import EgoLight, EgoRoute, RoadKind

_ROUTES: dict[EgoRoute | None, tuple[Maneuver, ...]] = {
    EgoRoute.STRAIGHT: (Maneuver.STRAIGHT,),
    EgoRoute.LEFT_TURN: (Maneuver.LEFT_TURN,),
    EgoRoute.RIGHT_TURN: (Maneuver.RIGHT_TURN,),
    EgoRoute.TURN: (Maneuver.LEFT_TURN, Maneuver.RIGHT_TURN),
    EgoRoute.LANE_CHANGE_LEFT: (Maneuver.LANE_CHANGE_LEFT,),
    EgoRoute.LANE_CHANGE_RIGHT: (Maneuver.LANE_CHANGE_RIGHT,),
    EgoRoute.LANE_CHANGE: (Maneuver.LANE_CHANGE_LEFT, Maneuver.LANE_CHANGE_RIGHT),
    EgoRoute.BYPASS: (Maneuver.BYPASS,),
    EgoRoute.OVERTAKE: (Maneuver.BYPASS,),
}
_LIGHTS: dict[EgoLight, tuple[str, ...]] = {
    EgoLight.GREEN: ("g",),
    EgoLight.RED: ("r",),
    EgoLight.YELLOW: ("y",),
    EgoLight.TURNS_GREEN: ("r", "g"),
    EgoLight.TURNS_RED: ("g", "r"),
}
"""What the ego's light shows at first, and then."""


def of_road(situation: Situation, episode: Episode, route: Route, until: int | None) -> Iterator[Finding]:
    """What a drive shows of the ego's way, of the road and of what surrounds it."""
    way, road = situation.ego.route, situation.road
    goes = maneuver_of(route)
    if changes_later(situation.ego):
        yield not_judged("ego.route")  # which its deed is, and is judged as that
    elif way in _ROUTES:
        yield Finding(path="ego.route", shown=goes in _ROUTES[way], told=f"said {way}, its route goes {goes}")
    elif way is not None:
        yield not_judged("ego.route")
    if road.control is not None and road.control in CONTROLS and road.kind is not RoadKind.RAIL_CROSSING:
        right = route.control is CONTROLS[road.control]
        yield Finding(path="road.control", shown=right, told=f"said {road.control}, the junction has {route.control}")
    if road.kind is not None and road.kind in PLACES:
        right = is_place(PLACES[road.kind], route) or (road.kind is RoadKind.ROAD and route.junction is None)
        yield Finding(
            path="road.kind", shown=right, told=f"said {road.kind}, the route lies {ROADS[RoadKind(route.place)]}"
        )
    yield from _ego_light(road, episode, until)
    names = ("arms", "side_road", "diameter", "setting", "lanes", "ego_lane", "two_way", "speed_limit")
    sought = {"ego.exit": situation.ego.exit, **{f"road.{name}": getattr(road, name) for name in names}}
    yield from (not_judged(path) for path, fact in sought.items() if fact is not None)  # by which its route was found
    yield from (not_judged(f"road.has.{i}") for i in range(len(road.has)))
    for name in ("light", "weather", "surface"):
        said, there = getattr(situation.around, name), getattr(episode.surroundings, name)
        if said is not None:
            yield Finding(path=f"around.{name}", shown=said == there, told=f"said {said}, it is {there}")


def _ego_light(road: Road, episode: Episode, until: int | None) -> Iterator[Finding]:
    """Whether the ego's light shows what was said: at first, and then; yellow at any time."""
    if road.ego_light is None:
        return
    own = [signal.state[:until] for signal in episode.signals if signal.role == "ego"]
    if not own or not own[0]:
        yield Finding(path="road.ego_light", shown=False, told=f"said {road.ego_light}, the ego has no light")
        return
    turns = [state for i, state in enumerate(own[0]) if state != "y" and (not i or own[0][i - 1] != state)]
    wanted = _LIGHTS[road.ego_light]
    shown = "y" in own[0] if road.ego_light is EgoLight.YELLOW else tuple(dict.fromkeys(turns))[: len(wanted)] == wanted
    yield Finding(
        path="road.ego_light",
        shown=shown or (None if until is not None and len(wanted) > 1 else False),
        told=f"said {road.ego_light}, it shows {''.join(turns) or own[0][0]}",
    )
