"""Every place of the vocabulary is on the map that is chosen, stands in the scene as things, is told, or is refused."""

from __future__ import annotations

import re
from typing import Any

import pytest
from test_building import drive

from chatscene.build.build import build
from chatscene.errors import NotBuilt, SituationError
from chatscene.situations.form import from_plain
from chatscene.terms.episode import Episode
from chatscene.terms.vocabulary import EgoRoute, Feature, RightOfWay, RoadKind, Setting, UserKind, Where

ANY_ROAD = frozenset(
    (
        *(Where.AHEAD, Where.AHEAD_BESIDE, Where.BESIDE, Where.BEHIND, Where.BEHIND_BESIDE, Where.ROADSIDE, Where.KERB),
        *(Where.ONCOMING, Where.ONCOMING_IN_OUR_LANE, Where.ARM, Where.EXIT),
        *(RoadKind.ROAD, RightOfWay.NONE),
    )
)
"""What every road has, or every junction."""
AS_THING = {
    Feature.BUS_STOP: "BusStop",
    Feature.PARKED_CARS: "Car",
    Feature.PARKED_BOTH_SIDES: "Car",
    Feature.SCHOOL: "WarningSign",
}
ON_MAP = {
    Where.IN_ROUNDABOUT: "roundabout",
    Where.ROUNDABOUT_ENTRY: "roundabout",
    Where.CROSSING: "crosswalk",
    Where.EXIT_CROSSING: "crosswalk",
    Feature.PARKING_PLACES: "parking",
    Feature.MEDIAN: "divided",
    Where.MEDIAN: "divided",
    RoadKind.RAMP: "on-ramp",
    RoadKind.T_END: "stem",
    RoadKind.JUNCTION: "(?:junction|three-way|four-way)",
    RoadKind.PARKING_LOT: "bays",
}
"""As what it is asked of a map, if that is another word."""
IN_NAME = {
    Where.MEDIAN: "median",
    Feature.MEDIAN: "median",
    Feature.PARKING_PLACES: "parking",
    Feature.LANE_DROP: "drop",
    Feature.NARROW: "lane=",
    RoadKind.MINI_ROUNDABOUT: "diameter=18",
    RightOfWay.STOP_SIGN: "signs=side-stop",
    RightOfWay.YIELD_SIGN: "signs=yield",
    RightOfWay.PRIORITY: "signs=side-yield",
}
"""What the name of a road that is laid says of it, if that is another word."""
_ON_FOOT = (Where.ROADSIDE, Where.CROSSING, Where.EXIT_CROSSING, Where.MEDIAN)
FIELDS = {"where": Where, "kind": RoadKind, "setting": Setting, "has": Feature, "control": RightOfWay}
PLACES = [(field, word) for field, words in FIELDS.items() for word in words]
DOES = {Where.DRIVEWAY: "enter", Where.KERB: "pull-out", Where.BUS_BAY: "pull-out", Where.ON_RAMP: "merge"}


def _somebody(where: Where, route: EgoRoute | None = None) -> dict[str, Any]:
    kind, act = (UserKind.PEDESTRIAN, "cross") if where in _ON_FOOT else (UserKind.CAR, "go-along")
    act = DOES.get(where, act)
    ego = {"ego": {"route": route}} if route else {}
    return {"others": [{"id": "A", "kind": kind, "starts": {"where": where}, "does": [{"act": act}]}], **ego}


def _said(field: str, word: Any, *, junction: bool) -> dict[str, Any]:
    if field == "where":
        behind = word in (Where.EXIT, Where.EXIT_CROSSING)
        made = _somebody(word, EgoRoute.RIGHT_TURN if behind else None)
        return made | ({"road": {"kind": "four-way"}} if junction else {})
    made = _somebody(Where.ARM if junction or field == "control" else Where.AHEAD)
    road = {field: [word] if field == "has" else word}
    return made | {"road": road | ({"kind": "four-way"} if junction and field != "kind" else {})}


@pytest.mark.parametrize("junction", [False, True])
@pytest.mark.parametrize(("field", "word"), PLACES)
def test_a_place_that_was_said_is_seen_or_told_or_refused(field: str, word: Any, junction: bool) -> None:
    try:
        built = build(from_plain(_said(field, word, junction=junction)))
    except (NotBuilt, SituationError):
        return
    name = ON_MAP.get(word, str(word))
    query = re.search(r"selectRoute\((.*)\)", built.program.source)
    assert query is not None
    asked = re.search(rf"'[a-z-]*{name}s?'|{name}=True", query[1]) is not None
    thing = word in AS_THING and re.search(rf"new {AS_THING[word]} at .* with label '(?!A')", built.program.source)
    laid = built.map.startswith("road:") and IN_NAME.get(word, str(word)) in built.map
    told = [one for one in (*built.assumed, *built.left_out) if name.replace("-", " ") in one.replace("-", " ")]
    assert word in ANY_ROAD or asked or laid or thing or told or _sign(word, built.assumed), query[1]


def _sign(word: Any, assumed: tuple[str, ...]) -> bool:
    return word is RightOfWay.YIELD_SIGN and any("give-way sign" in one for one in assumed)


def test_signs_of_two_features_stand_beside_each_other_and_cones_are_told_where_they_are() -> None:
    walks = {"id": "A", "kind": "pedestrian", "starts": {"where": "roadside"}, "does": [{"act": "cross"}]}
    built = build(from_plain({"road": {"has": ["roadworks", "closed-lane"]}, "others": [walks]}))
    assert isinstance(drive(built, seed=1), Episode)
    assert "roadworks: a sign stands beside the road" in built.assumed
    assert any("cones close the ego's lane" in one for one in built.assumed)
