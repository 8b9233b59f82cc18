"""Which part is met, whom somebody shows or hides, and where a lane beside the ego's is needed."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from test_starting import driven, someone, track

from chatscene.build.aim import EGO, OTHER, STRIKER, aimed
from chatscene.build.build import build
from chatscene.situations.form import from_plain
from chatscene.terms.situation import Contact, Other, Start
from chatscene.terms.vocabulary import Part, Side, Striker, UserKind, Where

LEFT = Other(id="A", kind=UserKind.CAR, starts=Start(where=Where.ARM, side=Side.LEFT))


def test_each_part_and_who_strikes_has_a_window_of_time() -> None:
    assert set(EGO) == set(OTHER) == set(Part)
    assert set(STRIKER) == set(Striker)
    assert all(-1.0 <= low < high <= 1.0 for rows in (EGO, OTHER, STRIKER) for low, high in rows.values())


@pytest.mark.parametrize(
    ("contact", "window", "taken"),
    [
        (None, (-0.6, 0.6), []),
        (Contact(striker=Striker.OTHER), (-0.6, 0.0), ["contact.striker"]),
        (Contact(ego=Part.LEFT_REAR, striker=Striker.OTHER), (-0.6, -0.33), ["contact.striker", "contact.ego"]),
        (Contact(ego=Part.FRONT, other=Part.RIGHT_REAR), (0.33, 0.6), ["contact.ego", "contact.other"]),
        (Contact(ego=Part.RIGHT), (-0.6, 0.6), []),  # who comes from the left meets no right side
        (Contact(ego=Part.REAR, striker=Striker.EGO), (0.0, 0.6), ["contact.striker"]),
        (Contact(happens=False), (0.6, 1.6), ["contact.happens"]),
        (Contact(whom="B", ego=Part.REAR), (-0.6, 0.6), []),
    ],
)
def test_the_part_that_was_said_narrows_when_somebody_is_there(
    contact: Contact | None, window: tuple[float, float], taken: list[str]
) -> None:
    low, high, *paths = aimed(contact, LEFT, -0.6, 0.6)
    assert (low, high) == pytest.approx(window)
    assert paths == taken


@pytest.mark.parametrize("seed", range(3))
def test_an_aim_at_the_tail_lets_the_ego_pass_first_and_a_near_miss_lets_the_other(seed: int) -> None:
    def there_at(contact: dict[str, Any]) -> float:
        said = someone("arm", "go-straight", side="left", speed="40 km/h") | {"contact": contact}
        episode = driven(said, seed=seed)
        one, ego = track(episode), episode.ego_track
        aside = (one.x - ego.x[0]) * np.sin(ego.heading[0]) - (one.y - ego.y[0]) * np.cos(ego.heading[0])
        return float(np.abs(aside).argmin() * episode.dt)

    assert there_at({"ego": "rear"}) > there_at({"ego": "front"}) > there_at({"happens": False})


def test_who_leaves_the_lane_does_so_before_who_stands_in_it() -> None:
    said = someone("ahead", "cut-out")
    said["others"][0]["role"] = "supporting"
    said["others"].append({"id": "B", "kind": "car", "starts": {"where": "ahead"}, "does": [{"act": "stand"}]})
    for seed in range(3):
        episode = driven(said, seed=seed)
        a, b = track(episode), track(episode, "B")
        assert np.hypot(a.x - b.x, a.y - b.y).min() > 2.4


@pytest.mark.parametrize(
    ("where", "act", "to", "beside"),
    [
        ("ahead", "cut-out", None, "left"),
        ("ahead", "cut-out", "right", "right"),
        ("ahead", "lane-change", "left", "left"),
        ("behind", "overtake", None, "left"),
    ],
)
def test_who_goes_over_beside_the_ego_has_a_lane_there(where: str, act: str, to: str | None, beside: str) -> None:
    said = someone(where, act)
    if to is not None:
        said["others"][0]["does"][0]["to"] = to
    assert f"beside='{beside}'" in build(from_plain(said)).program.source
    one_lane = build(from_plain(said | {"road": {"lanes": 1}})) if beside == "left" else None
    assert one_lane is None or "beside" not in one_lane.program.source.split("egoRoute =")[1].split("\n")[0]


def test_who_is_in_a_bus_bay_stands_beside_the_lane_and_pulls_out() -> None:
    episode = driven(someone("bus-bay", "stand", "pull-out", kind="bus"))
    bus, ego = track(episode), episode.ego_track
    aside = (bus.x - ego.x[0]) * np.sin(ego.heading[0]) - (bus.y - ego.y[0]) * np.cos(ego.heading[0])
    assert aside[0] > 2.5
    assert abs(aside[-1]) < 1.0


def test_who_stands_in_the_way_may_hide_somebody_though_it_is_there_for_more() -> None:
    said = someone("roadside", "cross", kind="pedestrian", side="right")
    said["others"][0]["hidden_by"] = "B"
    kerb = {"where": "kerb", "side": "right"}
    said["others"].append(
        {"id": "B", "kind": "truck", "role": "supporting", "starts": kerb, "does": [{"act": "stand"}]}
    )
    assert build(from_plain(said)).left_out == ()
