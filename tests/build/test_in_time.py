"""Deeds begin in time, change the speed so that it is seen, and last as was said; what cannot is refused."""

from __future__ import annotations

import random
import re
from typing import Any

import numpy as np
import pytest
from test_building import drive, simulator

from chatscene.build.build import Built, build
from chatscene.build.numbers import Numbers
from chatscene.build.timing import Body, course
from chatscene.errors import NotBuilt
from chatscene.program.judge import failures, judge
from chatscene.situations.form import from_plain
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.amount import Speed
from chatscene.terms.episode import Episode
from chatscene.terms.situation import Situation
from chatscene.terms.vocabulary import UserKind


def somebody(kind: str, where: str, *does: dict[str, Any], ego: dict[str, Any] | None = None) -> Situation:
    sided = where in ("roadside", "driveway", "crossing", "arm", "beside", "kerb", "ahead-beside", "behind-beside")
    start = {"where": where, **({"side": "right"} if sided else {})}
    one = {"id": "A", "kind": kind, "starts": start, "does": list(does)}
    return from_plain({"others": [one], **({"ego": ego} if ego else {})})


def deed(act: str, **said: str) -> dict[str, Any]:
    return {"act": act, **said}


def unseen(said: Situation, seed: int = 1) -> tuple[str, ...]:
    made = build(said)
    episode = drive(made, seed=seed)
    assert isinstance(episode, Episode), episode
    return failures(judge(said, episode, simulator(made.map, "native").route(made.program, 0)), met=False)


@pytest.mark.parametrize(
    "said",
    [
        somebody("pedestrian", "roadside", deed("stand", time="3 s"), deed("cross")),
        somebody("pedestrian", "roadside", deed("hesitate", time="3 s"), deed("cross", speed="4 km/h")),
        somebody("pedestrian", "roadside", deed("stop"), deed("stand", time="2 s"), deed("set-off")),
        somebody("pedestrian", "crossing", deed("cross"), deed("hesitate", time="2 s"), deed("turn-back")),
        somebody("dog", "roadside", deed("turn-back"), deed("cross")),
        somebody("deer", "driveway", deed("slow-down", speed="10 km/h"), deed("cross")),
        somebody("pedestrian", "median", deed("slow-down")),
        somebody("pedestrian", "ahead", deed("brake"), deed("set-off"), deed("turn-back")),
        somebody("wheelchair", "roadside", deed("accelerate")),
        somebody("wheelchair", "roadside", deed("cross"), deed("go-along"), deed("stop"), deed("go-along")),
        somebody("bus", "driveway", deed("slow-down")),
        somebody("truck", "roadside", deed("hesitate", time="4 s"), deed("go-along")),
        somebody("motorcycle", "driveway", deed("cross", speed="22 km/h"), ego={"speed": "30 km/h"}),
        somebody("bicycle", "beside", deed("weave"), deed("brake")),
        somebody("car", "ahead", deed("accelerate"), deed("accelerate"), deed("slow-down")),
        somebody("car", "ahead", deed("slow-down", speed="40 km/h")),
        somebody("bus", "ahead", deed("accelerate")),
        somebody("car", "ahead", deed("brake"), deed("set-off"), deed("accelerate", speed="30 km/h")),
        somebody("car", "behind", deed("overtake")),
        somebody("bicycle", "arm", deed("go-straight", speed="8 km/h")),
    ],
)  # fmt: skip
def test_all_deeds_are_seen_before_the_drive_ends(said: Situation) -> None:
    assert unseen(said) == ()


ON_FOOT = ("hesitate", "slow-down", "accelerate", "stop", "turn-back", "go-along", "brake")
NEXT = {"stop": ("set-off",), "brake": ("set-off",), "turn-back": ("go-along", "slow-down")}


def test_who_turns_across_our_way_and_then_stops_stands_in_it() -> None:
    van = somebody("van", "oncoming", deed("turn-left"), deed("stop"), ego={"speed": "80 km/h", "route": "straight"})
    made = build(van)
    episode = drive(made, seed=1)
    assert isinstance(episode, Episode), episode
    track = episode.tracks[1]
    still = track.speed < 0.1
    way = simulator(made.map, "native").route(made.program, 0).line
    assert (
        abs(way.project(float(track.x[still][-1]), float(track.y[still][-1]))[1])
        < 0.5 * UserKind.VAN.row.body.row.limits.length
    )


def by_chance(seed: int) -> Situation:
    """A walker with two deeds, or three where it must set off again."""
    rng = random.Random(seed)
    first = rng.choice(ON_FOOT)
    acts = [first, rng.choice(NEXT.get(first, ("hesitate", "go-along", "stop")))]
    kind = rng.choice(("pedestrian", "child", "dog", "deer", "wheelchair"))
    return somebody(kind, rng.choice(("roadside", "driveway", "crossing")), *(deed(act) for act in acts))


@pytest.mark.parametrize("seed", range(12))
def test_whatever_is_built_of_a_walker_is_seen(seed: int) -> None:
    assert unseen(by_chance(seed)) == ()


@pytest.mark.parametrize(
    ("said", "told"),
    [
        (
            somebody("bicycle", "behind", deed("overtake"), ego={"speed": "50 km/h"}),
            "a cyclist at 36 km/h does not overtake an ego at 50 km/h; say an ego at 31 km/h at most",
        ),
        (
            somebody("pedestrian", "roadside", deed("cross", speed="5 km/h"), deed("slow-down", speed="6 km/h")),
            "others.A.does.1.act: slow-down cannot be seen from 5 km/h to 6 km/h; say 4 km/h at most",
        ),
        (
            somebody("wheelchair", "roadside", deed("slow-down", speed="9 km/h")),
            "slow-down to 9 km/h is not visible for a wheelchair user, which drives at most 10 km/h",
        ),
        (
            somebody("bus", "driveway", deed("cross", speed="60 km/h")),
            "60 km/h is more than a bus reaches when it sets off beside our lane; say",
        ),
        (somebody("car", "ahead", deed("reverse", speed="40 km/h")), "is more than a car can do: at most 20 km/h"),
    ],
)
def test_what_speeds_and_bodies_do_not_give_is_refused_with_what_could_be_said(said: Situation, told: str) -> None:
    with pytest.raises(NotBuilt) as refused:
        build(said)
    assert told in str(refused.value)


@pytest.mark.parametrize(("kind", "speed"), [("bicycle", 18), ("bicycle", 20), ("bicycle", 40), ("bus", 60)])
def test_the_speed_that_is_told_for_one_that_is_not_reached_is_built(kind: str, speed: int) -> None:
    with pytest.raises(NotBuilt) as refused:
        build(somebody(kind, "driveway", deed("cross", speed=f"{speed} km/h")))
    most = re.search(r"say (\d+) km/h at most", str(refused.value))
    assert most
    assert int(most[1]) < speed
    assert build(somebody(kind, "driveway", deed("cross", speed=f"{most[1]} km/h")))


@pytest.mark.parametrize(("kind", "speed"), [("pedestrian", "3 km/h"), ("pedestrian", "4 km/h"), ("child", "5 km/h")])
def test_the_time_that_is_told_for_one_that_is_too_late_is_built(kind: str, speed: str) -> None:
    def crosses(within: str) -> Situation:
        return somebody(kind, "roadside", deed("cross", speed=speed) | {"when": {"ego_within": within}})

    with pytest.raises(NotBuilt) as refused:
        build(crosses("0.3 s"))
    least = re.search(r"say ([\d.]+) s at least", str(refused.value))
    assert least
    assert build(crosses(f"{least[1]} s"))


def test_the_more_is_done_before_the_ego_comes_the_farther_it_is_or_the_slower_is_the_ego() -> None:
    def nearest(one: Built) -> float:
        found = re.search(r"OPT_A_Y = Range\(([\d.]+)|shortOfJunction\(egoRoute, ([\d.]+)", one.program.source)
        assert found
        return float(found[1] or found[2])

    one = build(somebody("pedestrian", "roadside", deed("cross")))
    more = build(somebody("pedestrian", "roadside", deed("hesitate", time="4 s"), deed("cross")))
    assert nearest(more) > nearest(one)
    fixed = build(somebody("pedestrian", "crossing", deed("hesitate", time="4 s"), deed("stop"), deed("set-off")))
    assert fixed.program.wanted_speed is not None
    assert one.program.wanted_speed is not None
    assert fixed.program.wanted_speed < one.program.wanted_speed
    assert any(told.startswith("the ego drives at") for told in fixed.assumed)


def test_a_phase_takes_the_time_that_a_body_needs() -> None:
    row = AdversaryKind.PEDESTRIAN.row
    numbers = Numbers("A", row)
    numbers.bind("SPEED", Speed.of(2))
    gone = course(("MoveAhead($SPEED) for 2 seconds", "Halt() for 1 seconds"), numbers, Body(row.limits, walks=True))
    assert gone.seconds == pytest.approx(3.0, abs=0.2)
    assert gone.metres == pytest.approx(2 * 2 - 0.5 + 0.4, abs=0.4)
    assert gone.speed == 0.0


@pytest.mark.parametrize(
    "one",
    [
        {"kind": "car", "starts": {"where": "kerb", "side": "right"}, "does": [deed("pull-out")]},
        {"kind": "pedestrian", "starts": {"where": "roadside", "side": "left"}, "does": [deed("cross")]},
        {"kind": "car", "starts": {"where": "ahead-beside", "side": "left"}, "does": [deed("cut-in")]},
    ],
    ids=lambda one: one["does"][0]["act"],
)
@pytest.mark.parametrize("when", ["after", "during"])
def test_how_the_ego_brakes_because_of_another_is_left_to_its_driver_and_told(one: dict[str, Any], when: str) -> None:
    brakes: dict[str, Any] = {"act": "brake", "when": {when: "A.0"}}
    said = from_plain({"ego": {"does": [brakes]}, "others": [{"id": "A", **one}]})
    act = one["does"][0]["act"]
    assert f"the ego's brake {when} the {act} of A is left to its driver" in build(said).assumed
    assert not [fact for fact in unseen(said) if fact.startswith("ego.")]
    numbered = from_plain({"ego": {"does": [brakes | {"acceleration": "6 m/s²"}]}, "others": [{"id": "A", **one}]})
    made = build(numbered)
    assert not any("left to its driver" in told for told in made.assumed)  # a number binds
    assert "ego.does.0.acceleration" not in " ".join(made.left_out)
    assert "Order(" in made.program.source


@pytest.mark.parametrize(("role", "does", "told"), [("adversary", "MoveAhead", True), ("supporting", "Halt", False)])
def test_who_is_beside_the_road_without_a_deed_crosses_or_stands(role: str, does: str, *, told: bool) -> None:
    lead = {"id": "B", "kind": "car", "starts": {"where": "ahead"}}
    one = {"id": "A", "kind": "pedestrian", "role": role, "starts": {"where": "roadside", "side": "left"}}
    made = build(from_plain({"others": [lead, one]}))
    assert f"do {does}" in made.program.source.partition("behavior DoesA():")[2].partition("\n\n")[0][:60]
    assert ("A crosses our lane" in made.assumed) == told


def test_what_only_lies_there_holds_no_speed() -> None:
    assert Body(UserKind.OBJECT.row.body.row.limits, walks=False).fastest == 0.0


@pytest.mark.parametrize("speed", [12, 20, 30])
def test_who_rides_over_the_road_at_a_speed_comes_at_it(speed: int) -> None:
    assert unseen(somebody("bicycle", "roadside", deed("cross", speed=f"{speed} km/h"))) == ()


def test_who_stood_ahead_and_speeds_away_is_slow_yet_when_the_ego_closes_in() -> None:
    said = somebody("car", "ahead", deed("stand"), deed("set-off"), deed("accelerate"))
    episode = drive(build(said), seed=1)
    assert isinstance(episode, Episode), episode
    ego, other = episode.tracks
    steps = min(len(ego.x), len(other.x))
    gap = np.hypot(other.x[:steps] - ego.x[:steps], other.y[:steps] - ego.y[:steps])
    assert float(gap.min()) < 50.0
    assert float(other.speed[int(gap.argmin())]) < 45 / 3.6


def test_who_leads_a_row_is_before_all_of_it() -> None:
    follows = {"id": "C", "kind": "car", "count": 4, "starts": {"where": "ahead"}, "does": [deed("follow", whom="B")]}
    leads = {"id": "B", "kind": "truck", "starts": {"where": "ahead"}, "does": [deed("go-along")]}
    supporting = [one | {"role": "supporting"} for one in (leads, follows)]
    meets = {"id": "A", "kind": "pedestrian", "starts": {"where": "roadside"}, "does": [deed("cross")]}
    assert isinstance(drive(build(from_plain({"others": [meets, *supporting]})), seed=1), Episode)


def test_who_crosses_at_a_crosswalk_is_held_to_it() -> None:
    one = {"id": "A", "kind": "child", "starts": {"where": "crossing"}, "does": [deed("cross")]}
    built = build(from_plain({"road": {"has": ["crosswalk"]}, "others": [one]}))
    assert "OPT_A_Y" in built.bound
