"""A refusal that names a number names one that is built once it is said."""

from __future__ import annotations

import re
from typing import Any

import pytest
from test_starting import someone

from chatscene.build.build import build
from chatscene.errors import NotBuilt
from chatscene.situations.form import from_plain

BAY = someone("bus-bay", "pull-out", kind="bus")
CROSSWALK = someone("crossing", "cross", kind="pedestrian", side="right")
BLOCKED = someone("ahead", "stand", kind="truck") | {"ego": {"route": "bypass"}}
PARKED = someone("kerb", "stand", side="right") | {"ego": {"route": "bypass"}}
NARROW = BAY | {"road": {"lanes": 1, "two_way": True}}
_NAMED = re.compile(r"say (\d+) m|is (\d+) to (\d+) m ahead")


def _at(said: dict[str, Any], metres: int) -> None:
    other = said["others"][0]
    starts = other["starts"] | {"distance": f"{metres} m"}
    build(from_plain(said | {"others": [other | {"starts": starts}]}))


@pytest.mark.parametrize("said", [BAY, CROSSWALK, BLOCKED, PARKED], ids=["bay", "crosswalk", "ahead", "kerb"])
@pytest.mark.parametrize("metres", [40, 90, 160])
def test_somebody_is_as_far_ahead_as_was_said_where_the_road_has_something(said: dict[str, Any], metres: int) -> None:
    _at(said, metres)


@pytest.mark.parametrize(
    "said", [BAY, NARROW, CROSSWALK, BLOCKED, PARKED], ids=["bay", "narrow", "crosswalk", "ahead", "kerb"]
)
@pytest.mark.parametrize("metres", [3, 12, 300])
def test_a_refused_distance_names_one_that_is_built(said: dict[str, Any], metres: int) -> None:
    try:
        _at(said, metres)
    except NotBuilt as refused:
        named = _NAMED.search(str(refused))
        assert named is not None, refused
        for number in filter(None, named.groups()):
            _at(said, int(number))


HURRIED: dict[str, Any] = {
    "ego": {"speed": "50 km/h"},
    "others": [
        {
            "id": "A",
            "kind": "car",
            "starts": {"where": "beside", "side": "right"},
            "does": [{"act": "slow-down"}, {"act": "lane-change"}, {"act": "exit"}],
        }
    ],
}


def test_deeds_for_which_an_ego_is_too_fast_are_refused_with_a_speed_at_which_they_are_built() -> None:
    with pytest.raises(NotBuilt, match=r"say ego\.speed: \d+ km/h") as refused:
        build(from_plain(HURRIED))
    named = re.search(r"say ego\.speed: (\d+ km/h)", str(refused.value))
    assert named is not None
    assert build(from_plain(HURRIED | {"ego": {"speed": named[1]}}))


ELSEWHERE = [
    someone("arm", "go-straight", side="right", kind="bicycle") | {"ego": {"route": "right-turn"}},
    someone("arm", "go-straight") | {"ego": {"route": "lane-change-left"}},
    someone("oncoming", "turn-left") | {"ego": {"route": "left-turn"}},
]


@pytest.mark.parametrize("said", ELSEWHERE)
def test_ways_that_meet_nowhere_are_refused_with_the_fact_without_which_they_do(said: dict[str, Any]) -> None:
    with pytest.raises(NotBuilt, match=r"leave out ego\.route: [a-z-]+, and a place is found"):
        build(from_plain(said))
    assert build(from_plain(said | {"ego": {}}))


def test_a_light_at_a_roundabout_is_refused_with_the_breach_that_is_built() -> None:
    def said(breach: str) -> dict[str, Any]:
        does = [{"act": "go-straight", "breaks": breach}]
        other = {"id": "A", "kind": "car", "starts": {"where": "arm", "side": "left"}, "does": does}
        return {"others": [other], "ego": {"route": "roundabout"}}

    with pytest.raises(NotBuilt, match="no lights at a roundabout; say right-of-way"):
        build(from_plain(said("red-light")))
    assert build(from_plain(said("right-of-way")))
