"""What cannot be is refused by a rule, and what no rule refuses is built and seen."""

from __future__ import annotations

from typing import Any

import pytest

from chatscene.build.build import build
from chatscene.build.possible import FROM
from chatscene.errors import NotBuilt
from chatscene.search.rehearsal import unseen_at_first
from chatscene.situations.form import from_plain
from chatscene.terms.vocabulary import Act, Where


def refusal(where: str, *acts: str, kind: str = "car") -> str:
    side = {"side": "right"} if Where(where).row.sided else {}
    one: dict[str, Any] = {"id": "A", "kind": kind, "starts": {"where": where, **side}}
    with pytest.raises(NotBuilt) as refused:
        build(from_plain({"others": [one | {"does": [{"act": act} for act in acts]}]}))
    return str(refused.value)


@pytest.mark.parametrize(
    ("where", "acts", "told"),
    [
        ("behind", ("pull-out",), "others.A.does.0.act: pull-out is not possible from behind, only from"),
        ("ahead", ("cross",), "others.A.does.0.act: cross is not possible from ahead, only from"),
        ("oncoming", ("tailgate",), "others.A.does.0.act: tailgate is not possible from oncoming, only from"),
        ("ahead", ("stop", "swerve"), "others.A.does.1.act: a standing road user must set off before it can swerve"),
        (
            "driveway",
            ("cross", "stop", "cross"),
            "others.A.does.2.act: after cross it is already in our lane or past it, so it cannot cross",
        ),
        (
            "driveway",
            ("go-straight", "enter"),
            "others.A.does.1.act: after go-straight it is already in our lane or past it, so it cannot enter",
        ),
        (
            "ahead",
            ("slow-down", "set-off"),
            "others.A.does.1.act: after slow-down it is already moving, so it cannot set-off",
        ),
        ("beside", ("turn-left", "cut-in"), "others.A.does.1.act: after turn-left it is no longer there to cut-in"),
        (
            "beside",
            ("lane-change", "overtake"),
            "others.A.does.1.act: after lane-change it is ahead of ego and must fall back before it can overtake",
        ),
        (
            "oncoming",
            ("overtake", "cut-in"),
            "others.A.does.1.act: after overtake it is already in our lane or past it, so it cannot cut-in",
        ),
    ],
)
def test_a_deed_that_cannot_be_is_refused_by_its_path(where: str, acts: tuple[str, ...], told: str) -> None:
    assert refusal(where, *acts).startswith(f"impossible: {told}")


@pytest.mark.parametrize(
    ("where", "acts"),
    [
        ("behind-beside", ("lane-change", "overtake")),
        ("behind-beside", ("lane-change", "follow", "overtake")),
        ("beside", ("lane-change", "tailgate", "overtake")),
    ],
)
def test_who_is_behind_the_ego_after_a_deed_can_overtake_it(where: str, acts: tuple[str, ...]) -> None:
    starts = {"where": where, "side": "left"}
    one: dict[str, Any] = {"id": "A", "kind": "car", "starts": starts, "does": [{"act": act} for act in acts]}
    assert build(from_plain({"others": [one]}))


@pytest.mark.parametrize(
    ("deed", "more", "told"),
    [
        ({"act": "stop", "distance": "0 to 1 m"}, {}, "others.A.does.0.distance: 0 to 1 m needs"),
        ({"act": "accelerate", "time": "0 to 0.1 s"}, {}, "others.A.does.0.time: 0 to 0.1 s is more than a car can do"),
        (
            {"act": "accelerate", "speed": "80 km/h", "distance": "3 m"},
            {},
            "others.A.does.0.distance: 3 m is more than a car can do from 50 to 80 km/h; say ",
        ),
        ({"act": "brake"}, {"ego": {"speed": "at least 0 km/h"}}, "impossible: ego.speed: at least 0 km/h"),
        (
            {"act": "brake"},
            {"road": {"speed_limit": "at least 0 km/h"}},
            "impossible: road.speed_limit: at least 0 km/h",
        ),
    ],
)
def test_a_range_or_a_bound_that_begins_at_0_is_refused_by_its_path(
    deed: dict[str, str], more: dict[str, Any], told: str
) -> None:
    one: dict[str, Any] = {"id": "A", "kind": "car", "starts": {"where": "ahead"}, "does": [deed]}
    with pytest.raises(NotBuilt) as refused:
        build(from_plain({"others": [one], **more}))
    assert str(refused.value).startswith(told)


def test_a_rate_that_was_said_of_what_follows_is_named_where_it_is_refused() -> None:
    does: list[dict[str, str]] = [{"act": "pull-out"}, {"act": "accelerate", "acceleration": "6 m/s²"}]
    one: dict[str, Any] = {"id": "A", "kind": "truck", "starts": {"where": "kerb"}, "does": does}
    with pytest.raises(NotBuilt, match=r"does\.1\.acceleration: 6 m/s² is more than a truck can do"):
        build(from_plain({"others": [one]}))


def test_an_act_can_be_begun_from_somewhere() -> None:
    assert all(FROM[act] for act in FROM)
    assert set(FROM) <= set(Act)


def test_what_was_done_before_may_have_taken_it_elsewhere() -> None:
    does = [{"act": "overtake"}, {"act": "cut-out", "to": "left"}]
    behind = {"id": "A", "kind": "car", "starts": {"where": "behind-beside", "side": "left"}, "does": does}
    assert "DoesA" in build(from_plain({"others": [behind]})).program.source


def test_what_cannot_be_done_from_a_place_is_refused_with_the_places_from_which_it_can() -> None:
    told = "keep-level is not possible from ahead, only from ahead-beside, beside, behind-beside, on-ramp"
    assert refusal("ahead", "keep-level").endswith(told)


BACKS = {"ego": {"route": "leave-parking", "does": [{"act": "reverse"}]}}


@pytest.mark.parametrize(
    ("kind", "where", "acts", "more"),
    [
        ("pedestrian", "ahead-beside", ("cross",), {}),
        ("deer", "beside", ("cross",), {}),
        ("pedestrian", "behind", ("cross",), BACKS),
        ("pedestrian", "behind", ("stand",), {"ego": {"route": "reverse"}}),
        ("car", "on-ramp", ("keep-level", "merge"), {}),
        ("car", "ahead-beside", ("open-door",), {}),
        ("car", "ahead-beside", ("drop-load",), {}),
        ("car", "oncoming", ("drop-load",), {}),
        ("car", "arm", ("pull-out",), {}),
        ("car", "arm", ("hesitate", "set-off"), {}),
        ("car", "kerb", ("cut-in",), {}),
        ("car", "bus-bay", ("merge",), {}),
        ("car", "driveway", ("yield", "enter"), {}),
        ("car", "oncoming-in-our-lane", ("drift",), {}),
        ("car", "in-roundabout", ("cut-in",), {}),
    ],
)
def test_what_is_built_and_seen_from_a_place_is_possible_there(
    kind: str, where: str, acts: tuple[str, ...], more: dict[str, Any]
) -> None:
    side = {"side": "right"} if Where(where).row.sided else {}
    does = [{"act": act} for act in acts]
    said = from_plain({"others": [{"id": "A", "kind": kind, "starts": {"where": where, **side}, "does": does}], **more})
    assert not unseen_at_first(build(said), said)
