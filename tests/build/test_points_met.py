"""Which point of whom is met at which point of the ego's width."""

from __future__ import annotations

from typing import Any

import pytest
from test_amounts import shown
from test_meeting import met

from chatscene.build.build import build
from chatscene.errors import NotBuilt, SituationError
from chatscene.situations.form import from_plain
from chatscene.situations.words import told


def comes(where: str, behind: str, **start: str) -> dict[str, Any]:
    car = {"id": "A", "kind": "car", "starts": {"where": where, "speed": "40 km/h", **start}}
    return {
        "ego": {"route": "left-turn" if where == "oncoming" else "straight", "speed": "15 km/h"},
        "road": {"kind": "four-way", "control": "none"},
        "others": [car | {"does": [{"act": "go-straight", "speed": "40 km/h"}]}],
        "contact": {"ego": "front", "at": "50 %", "behind_nose": behind},
    }


@pytest.mark.parametrize(("where", "start", "share"), [("arm", {"side": "left"}, "25 %"), ("oncoming", {}, "0 %")])
def test_a_point_of_a_car_that_comes_through_a_junction_is_met_where_it_was_said_to_be(
    where: str, start: dict[str, str], share: str
) -> None:
    said, other = (from_plain(comes(where, behind, **start)) for behind in (share, "90 %"))
    built = build(said)
    assert built.left_out == ()
    for seed in range(2):
        found = shown(said, met(built, seed))
        assert found["contact.at"] is found["contact.behind_nose"] is True
    assert shown(other, met(built, 0))["contact.behind_nose"] is False
    assert f"a point {share} of its length behind its nose" in " ".join(told(said).split())


def test_a_point_of_the_other_is_said_of_a_place_on_the_ego_s_width() -> None:
    facts = comes("arm", "25 %", side="left")
    del facts["contact"]["at"]
    with pytest.raises(SituationError, match=r"contact\.at"):
        from_plain(facts)


@pytest.mark.parametrize("where", ["roadside", "exit-crossing", "crossing"])
def test_who_crosses_starts_so_far_beside_the_lanes_as_was_said(where: str) -> None:
    start = {"where": where, "side": "right"}

    def facts(beyond: str) -> dict[str, Any]:
        crosses = {"id": "A", "kind": "pedestrian", "starts": start | {"lateral": {"beyond": beyond}}}
        route = {"route": "right-turn" if where == "exit-crossing" else "straight", "speed": "15 km/h"}
        return {"ego": route, "others": [crosses | {"does": [{"act": "cross", "speed": "5 km/h"}]}]}

    said = from_plain(facts("4.5 m"))
    built = build(said)
    assert built.left_out == ()
    episode = met(built, 0)
    assert shown(said, episode)["others.A.starts.lateral.beyond"] is True
    assert shown(from_plain(facts("2 m")), episode)["others.A.starts.lateral.beyond"] is False
    assert "4.5 m beside the lanes" in " ".join(told(said).split())


def test_nobody_on_the_road_is_beside_its_lanes() -> None:
    ahead = {"id": "A", "kind": "car", "starts": {"where": "ahead", "lateral": {"beyond": "1 m"}}}
    with pytest.raises(NotBuilt, match=r"lateral\.beyond: 1 m"):
        build(from_plain({"others": [ahead | {"does": [{"act": "stand"}]}]}))
