"""Contacts that were said, that were said not to be, and of which nothing was said, as drives show them."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from test_building import drive, simulator
from test_towards import car, deed, others

from chatscene.build.build import build
from chatscene.program.judge import failures, judge
from chatscene.simulate.boxes import gaps
from chatscene.simulate.contact import sides_touched
from chatscene.situations.form import from_plain
from chatscene.terms.episode import Episode, Track
from chatscene.terms.situation import Situation

SEEDS = (0, 1, 2)
STRUCK = {"whom": "A", "ego": "rear", "other": "front", "striker": "other"}


def driven(said: Situation, seed: int) -> Episode:
    made = build(said)
    episode = drive(made, seed=seed)
    assert isinstance(episode, Episode), episode
    route = simulator(made.map, "native").route(made.program, 0)
    assert not failures(judge(said, episode, route)), failures(judge(said, episode, route))
    return episode


def track(episode: Episode, name: str) -> Track:
    return next(one for one in episode.tracks if one.actor == name)


@pytest.mark.parametrize("seed", SEEDS)
def test_who_strikes_an_ego_that_stops_for_somebody_does_so_when_it_stands_and_that_one_is_over(seed: int) -> None:
    walks: dict[str, Any] = {"id": "B", "kind": "pedestrian", "starts": {"where": "crossing"}}
    said = others(
        car("A", "behind", deed("go-along")),
        {**walks, "does": [deed("cross")]},
        ego={"does": [deed("stop")]},
        road={"has": ["crosswalk"]},
        contact=STRUCK,
    )
    episode = driven(said, seed)
    assert episode.collision is not None
    assert (episode.collision.other, episode.collision.side) == ("A", "rear")
    assert episode.ego_track.speed[episode.collision.step - 1] < 0.1
    assert gaps(episode.ego_track, track(episode, "B"))[-1] > 2.0


@pytest.mark.parametrize("seed", SEEDS)
def test_who_strikes_the_ego_before_something_in_its_lane_does_so_when_it_has_all_but_stopped(seed: int) -> None:
    lies: dict[str, Any] = {"id": "B", "kind": "debris", "starts": {"where": "ahead"}, "does": [deed("stand")]}
    episode = driven(others(car("A", "behind", deed("go-along")), lies, contact=STRUCK), seed)
    assert episode.collision is not None
    assert episode.collision.other == "A"
    assert episode.ego_track.speed[episode.collision.step - 1] < 0.2 * episode.ego_track.speed[0]


def test_the_parts_of_two_who_are_in_line_are_not_told_as_left_out() -> None:
    said = others(car("A", "behind", deed("go-along")), ego={"does": [deed("stop")]}, contact=STRUCK)
    assert not build(said).left_out
    beside = {**STRUCK, "ego": "left"}
    said = others(car("A", "behind", deed("go-along")), ego={"does": [deed("stop")]}, contact=beside)
    assert build(said).left_out == ("contact.ego: left",)


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("kind", ["car", "motorcycle"])
def test_who_comes_in_our_lane_and_is_not_touched_goes_by_close(kind: str, seed: int) -> None:
    comes = car("A", "oncoming-in-our-lane", deed("go-along"), kind=kind)
    episode = driven(others(comes, contact={"happens": False}), seed)
    assert episode.collision is None
    assert 0.1 < gaps(episode.ego_track, track(episode, "A")).min() < 1.5


@pytest.mark.parametrize("seed", SEEDS)
def test_who_cuts_in_and_is_not_touched_stays_in_our_lane(seed: int) -> None:
    comes = car("A", "ahead-beside", deed("cut-in", to="right", distance="18 m"), side="left", speed="40 km/h")
    episode = driven(others(comes, ego={"speed": "60 km/h"}, contact={"happens": False}), seed)
    ego, other = episode.ego_track, track(episode, "A")
    heading = ego.heading[0]
    beside = (other.y - ego.y[0]) * np.cos(heading) - (other.x - ego.x[0]) * np.sin(heading)
    assert beside[0] > 2.5
    assert abs(beside[-1]) < 1.0


@pytest.mark.parametrize("seed", SEEDS)
def test_who_goes_by_in_our_lane_does_so_on_the_right_where_somebody_is_on_the_left(seed: int) -> None:
    comes = car("A", "oncoming-in-our-lane", deed("go-along"), kind="motorcycle")
    bus = {"id": "B", "kind": "bus", "starts": {"where": "beside", "side": "left"}}
    episode = driven(others(comes, bus, contact={"happens": False}), seed)
    ego, scooter = episode.ego_track, track(episode, "A")
    near = int(gaps(ego, scooter).argmin())
    dx, dy, heading = scooter.x[near] - ego.x[near], scooter.y[near] - ego.y[near], ego.heading[near]
    assert dy * np.cos(heading) - dx * np.sin(heading) < -1.0


@pytest.mark.parametrize("seed", SEEDS)
def test_who_swerves_behind_the_ego_does_so_as_the_ego_brakes_for_somebody(seed: int) -> None:
    stands: dict[str, Any] = {"id": "B", "kind": "bus", "starts": {"where": "ahead"}, "does": [deed("stand")]}
    episode = driven(others(car("A", "behind", deed("swerve")), stands), seed)
    assert episode.collision is None
    assert gaps(episode.ego_track, track(episode, "A")).min() < 2.0


@pytest.mark.parametrize("seed", SEEDS)
def test_an_animal_that_the_ego_goes_round_lies_where_it_swings_out(seed: int) -> None:
    said = from_plain(
        {
            "ego": {"route": "bypass"},
            "others": [{"id": "A", "kind": "animal", "starts": {"where": "ahead"}, "does": [{"act": "stand"}]}],
        }
    )
    episode, ego = (one := driven(said, seed)), one.ego_track
    lies = track(episode, "A")
    ahead = np.array([lies.x[-1] - ego.x[-1], lies.y[-1] - ego.y[-1]])
    assert episode.collision is None
    assert ahead @ [np.cos(ego.heading[-1]), np.sin(ego.heading[-1])] < 0.0  # it is past


def cuts(said: Situation, seed: int) -> list[str]:
    made = build(said)
    episode = drive(made, seed=seed)
    assert isinstance(episode, Episode), episode
    found = judge(said, episode, simulator(made.map, "native").route(made.program, 0))
    return [one.path for one in found if one.cut]


@pytest.mark.parametrize("seed", SEEDS)
def test_a_contact_cuts_nothing_short_of_who_is_to_be_touched_by_what_it_last_does(seed: int) -> None:
    assert not cuts(others(car("A", "behind", deed("go-along")), ego={"does": [deed("stop")]}, contact=STRUCK), seed)


@pytest.mark.parametrize("seed", SEEDS)
def test_a_contact_before_the_ego_has_stopped_cuts_that_short(seed: int) -> None:
    near = car("A", "behind", deed("go-along"), distance="4 m", speed="30 km/h")
    said = others(near, ego={"speed": "30 km/h", "does": [deed("stop")]}, contact=STRUCK)
    assert "ego.does.0.act" in cuts(said, seed)


@pytest.mark.parametrize("seed", (0, 3, 5))
def test_who_comes_partly_in_our_lane_touches_the_side_that_was_said(seed: int) -> None:
    comes = car("A", "oncoming-in-our-lane", deed("go-along"), kind="motorcycle")
    said = others(comes, road={"two_way": True}, contact={"ego": "left", "striker": "other"})
    assert not build(said).left_out
    episode = driven(said, seed)
    assert (met := episode.collision) is not None
    assert "left" in sides_touched(episode.ego_track, track(episode, "A"), met.step, met.earlier)  # it is a corner


@pytest.mark.parametrize("seed", (2, 3, 4))
def test_an_ego_that_is_to_clip_a_door_has_no_time_to_stop_for_it(seed: int) -> None:
    parked: dict[str, Any] = {"id": "A", "kind": "car", "starts": {"where": "kerb", "side": "right"}}
    said = others(
        {**parked, "does": [deed("stand"), deed("open-door", to="left")]},
        ego={"speed": "25 mph"},
        contact={"other": "left", "striker": "ego"},
    )
    assert not build(said).left_out
    episode = driven(said, seed)
    assert episode.collision is not None
    assert episode.collision.other == "A-door"


@pytest.mark.parametrize("seed", SEEDS)
def test_those_whom_the_ego_lets_by_at_a_junction_come_before_whom_it_meets(seed: int) -> None:
    arm: dict[str, Any] = {"starts": {"where": "arm", "side": "right"}, "does": [deed("go-straight")]}
    said = others(
        {"id": "A", "kind": "van", **arm},
        {"id": "B", "kind": "motorcycle", "count": 2, **arm},
        ego={"does": [deed("stand"), deed("set-off")]},
        road={"kind": "junction", "control": "signal", "ego_light": "turns-green"},
    )
    episode = driven(said, seed)
    met, *by = (
        int(np.hypot(one.x - episode.ego_track.x[-1], one.y - episode.ego_track.y[-1]).argmin())
        for one in (track(episode, name) for name in ("A", "B", "B-2"))
    )
    assert max(by) < met


@pytest.mark.parametrize("seed", SEEDS)
def test_an_animal_is_by_before_the_ego_that_is_to_strike_the_other(seed: int) -> None:
    deer: dict[str, Any] = {"kind": "deer", "starts": {"where": "roadside", "side": "right"}, "does": [deed("cross")]}
    said = from_plain(
        {
            "ego": {"speed": "55 mph"},
            "others": [{"id": "A", **deer}, {"id": "B", **deer}],
            "contact": {"whom": "B", "striker": "ego"},
        }
    )
    episode = drive(build(said), seed=seed)
    assert isinstance(episode, Episode), episode
    assert episode.collision is None or episode.collision.other == "B"


@pytest.mark.parametrize("seed", SEEDS)
def test_who_cuts_in_behind_another_that_brakes_does_not_drive_through_it(seed: int) -> None:
    said = others(
        car("A", "ahead-beside", deed("cut-in")),
        car("B", "ahead", deed("go-along"), {"act": "brake", "when": {"after": "A.cut-in"}}),
    )
    driven(said, seed)


@pytest.mark.parametrize("side", ["left", "right"])
@pytest.mark.parametrize("part", ["front", "rear"])
def test_who_passes_and_strikes_the_ego_s_side_comes_over_into_that(side: str, part: str) -> None:
    said = others(
        car("A", "behind-beside", deed("overtake"), kind="motorcycle", side=side),
        contact={"ego": f"{side}-{part}", "striker": "other"},
    )
    episode = driven(said, 0)
    assert episode.collision is not None
    assert (episode.collision.other, episode.collision.side) == ("A", side)


def test_who_has_passed_the_ego_before_a_junction_goes_on_beyond_it() -> None:
    said = others(car("A", "behind-beside", deed("overtake"), side="left"), road={"kind": "junction"})
    episode = driven(said, 0)
    turned = np.abs(track(episode, "A").heading - episode.ego_track.heading[0])
    assert float(np.max(np.minimum(turned, 2 * np.pi - turned))) < 1.0


@pytest.mark.parametrize(("corner", "sign"), [("left-rear", 1), ("right-rear", -1)])
def test_who_strikes_a_corner_of_the_ego_from_behind_is_as_far_aside_of_it(corner: str, sign: int) -> None:
    said = others(
        car("A", "behind", deed("go-along")), ego={"does": [deed("stop")]}, contact={"ego": corner, "striker": "other"}
    )
    assert build(said).left_out == ()
    episode = driven(said, 0)
    ego, other = episode.ego_track, track(episode, "A")
    dx, dy = other.x[-1] - ego.x[-1], other.y[-1] - ego.y[-1]
    aside = -dx * np.sin(ego.heading[-1]) + dy * np.cos(ego.heading[-1])
    assert 0.4 < sign * float(aside) < 1.3


def test_of_who_backs_into_an_ego_that_stops_nothing_is_left_out() -> None:
    said = others(
        car("A", "ahead", deed("stand"), deed("reverse")),
        ego={"does": [deed("stop")]},
        contact={"ego": "front", "other": "rear", "striker": "other"},
    )
    assert build(said).left_out == ()


def test_an_ego_that_sets_off_at_a_speed_is_no_faster_then() -> None:
    said = others(
        car("A", "behind", deed("go-along")),
        ego={"does": [deed("stop"), {"act": "set-off", "speed": "10 km/h"}]},
        road={"kind": "junction"},
    )
    speed = driven(said, 0).ego_track.speed
    stands = int(np.flatnonzero(speed < 0.1)[0])
    assert float(speed[:stands].max()) > 5.0
    assert 2.0 < float(speed[stands:].max()) < 3.0


def test_who_is_seen_to_come_before_the_ego_begins_no_farther_back_than_its_way_does() -> None:
    dog = {"id": "A", "kind": "dog", "starts": {"where": "median"}, "does": [deed("fall")]}
    one = car("B", "in-roundabout", deed("go-straight", speed="21 km/h"), kind="motorcycle")
    other = car("C", "exit-crossing", deed("go-straight"), kind="emergency-vehicle", side="right")
    made = build(
        from_plain(
            {
                "ego": {"route": "straight", "speed": "23 km/h"},
                "others": [dog, *(who | {"role": "supporting"} for who in (one, other))],
            }
        )
    )
    assert isinstance(drive(made, seed=0), Episode)
