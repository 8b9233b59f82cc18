"""Nobody drives through another: who goes along brakes, and where that is too late, it is elsewhere by then."""

from __future__ import annotations

from typing import Any

import pytest
from test_building import drive, simulator

from chatscene.build.build import build
from chatscene.errors import NotBuilt
from chatscene.program.judge import failures, judge
from chatscene.situations.form import from_plain
from chatscene.terms.episode import Episode
from chatscene.terms.situation import Situation


def one(name: str, kind: str, where: str, *acts: str, **more: Any) -> dict[str, Any]:
    """Somebody, of whom the first is met; with a side, a number or a distance."""
    starts = {"where": where} | {key: more.pop(key) for key in ("side", "distance") if key in more}
    does = [{"act": act, **({"speed": more.pop("speed")} if "speed" in more else {})} for act in acts]
    role = "adversary" if name == "A" else "supporting"
    return {"id": name, "kind": kind, "role": role, "starts": starts, "does": does, **more}


def situation(*others: dict[str, Any], **ego: Any) -> Situation:
    return from_plain({"others": list(others), **({"ego": ego} if ego else {})})


TOGETHER = {
    "who follows the ego stops behind whom the ego goes round": situation(
        one("A", "car", "ahead", "brake"), one("B", "e-scooter", "behind", "tailgate")
    ),
    "who stands is beyond where another has passed the ego": situation(
        one("A", "car", "behind", "overtake"), one("B", "van", "ahead", "stop")
    ),
    "who stands in the next lane is beyond that, too": situation(
        one("A", "bus", "beside", "overtake", side="left"), one("B", "car", "ahead-beside", "stand", side="left")
    ),
    "who comes against us is by before somebody crosses its lane": situation(
        one("A", "e-scooter", "roadside", "cross", side="left"),
        one("B", "car", "oncoming", "go-along", speed="70 km/h"),
    ),
    "who turns out of a row has room for it": situation(
        one("A", "car", "ahead-beside", "stand", "lane-change", side="right"),
        one("B", "van", "ahead-beside", "stand", side="right", count=3),
    ),
    "who waits at the junction waits before the crosswalk": situation(
        one("A", "car", "oncoming", "stand"), one("B", "pedestrian", "exit-crossing", "cross", side="right")
    ),
    "who drives on ahead is beyond who runs over the road": situation(
        one("A", "child", "ahead"), one("B", "bus", "ahead", "go-along")
    ),
    "two behind us in the next lane are one behind the other": situation(
        one("A", "car", "behind-beside", "lane-change", side="right"),
        one("B", "car", "behind-beside", "slow-down", side="right"),
    ),
}


@pytest.mark.parametrize("name", TOGETHER)
def test_nobody_drives_through_another(name: str) -> None:
    said = TOGETHER[name]
    built = build(said)
    episode = drive(built, seed=1)
    assert isinstance(episode, Episode), episode
    found = judge(said, episode, simulator(built.map, "native").route(built.program, 0))
    assert not [one for one in failures(found) if "drive through each other" in one]


def test_a_cyclist_who_follows_is_not_left_behind() -> None:
    follows = one("B", "bicycle", "behind", "follow")
    said = situation(one("A", "pedestrian", "roadside", "cross", side="left"), follows)
    built = build(said)
    assert built.program.wanted_speed == pytest.approx(36.4 / 3.6, abs=0.1)  # which a bicycle holds
    episode = drive(built, seed=1)
    assert isinstance(episode, Episode), episode
    found = judge(said, episode, simulator(built.map, "native").route(built.program, 0))
    assert all(one.shown for one in found if one.path == "others.B.does.0.act")


@pytest.mark.parametrize(
    ("said", "told"),
    [
        (
            situation(one("A", "bicycle", "behind", "follow"), speed="50 km/h"),
            "drives at most 36 km/h, so an ego at 50 km/h leaves it behind; say an ego at 36 km/h at most",
        ),
        (
            situation(
                one("A", "e-scooter", "behind-beside", "go-straight", side="right", distance="50 m", speed="20 km/h"),
                route="right-turn",
                speed="50 km/h",
            ),
            "it would have to start 43 m ahead",
        ),
    ],
)
def test_who_cannot_be_there_is_refused_with_what_can(said: Situation, told: str) -> None:
    with pytest.raises(NotBuilt, match=told):
        build(said)


def test_who_comes_against_us_and_turns_off_does_so_at_a_junction() -> None:
    said = situation(one("A", "truck", "oncoming", "turn-left"), speed="50 km/h")
    built = build(said)
    assert simulator(built.map, "native").route(built.program, 0).junction is not None
