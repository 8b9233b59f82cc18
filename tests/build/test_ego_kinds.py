"""The ego is of a kind: it has the body of that, in what is built, in what it is told, in drives and in their judge."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import chatscene.build
from benchmarks.differing import differences
from chatscene.build.build import Built, build
from chatscene.build.timing import Body
from chatscene.ego.asking import fitted
from chatscene.ego.policy import in_words, load_ego, senses_of
from chatscene.errors import NotBuilt, SituationError
from chatscene.maps.network import resolve_map
from chatscene.program.judge import judge
from chatscene.program.sample import draw
from chatscene.runs.asked import asked_run
from chatscene.runs.record import SituationRecord
from chatscene.settings import SimulationSettings
from chatscene.simulate.simulator import Simulator, load_simulator, simulate
from chatscene.situations.facts import with_fact
from chatscene.situations.form import from_plain
from chatscene.situations.phrases import Voice
from chatscene.situations.words import facts_told, told
from chatscene.terms.actors import LIMITS, AdversaryKind
from chatscene.terms.episode import Episode, EventKind
from chatscene.terms.scene import Scene
from chatscene.terms.situation import Situation
from chatscene.terms.vocabulary import UserKind

KINDS = [kind for kind in UserKind if kind.may_be_ego]


@cache
def simulator(map_name: str, by: str) -> Simulator:
    return load_simulator(resolve_map(map_name), SimulationSettings(simulator=by))


def drive(one: Built, ego: str = "idm", by: str = "native", seed: int = 1) -> Episode:
    values = draw(one.program.parameters, seed=seed)
    scene = Scene(id="kind/0", scenario_id="kind", route=0, block=0, seed=seed, values=values)
    episode = simulate(simulator(one.map, by), one.program, scene, load_ego(ego))
    assert isinstance(episode, Episode), episode
    return episode


def stops_ahead(**ego: Any) -> Situation:
    others = [{"id": "A", "kind": "car", "starts": {"where": "ahead"}, "does": [{"act": "stop"}]}]
    return from_plain({"ego": ego, "others": others})


def at_lights(**ego: Any) -> Situation:
    """An ego that sets off at lights, and somebody who comes from an arm."""
    others = [{"id": "A", "kind": "car", "starts": {"where": "arm", "side": "left"}, "does": [{"act": "go-straight"}]}]
    does = [{"act": "stand"}, {"act": "set-off"}]
    road = {"kind": "four-way", "control": "signal"}
    return from_plain({"ego": {"does": does, **ego}, "road": road, "others": others})


def test_who_drives_or_rides_may_be_the_ego_and_nobody_else() -> None:
    assert {str(kind) for kind in KINDS} >= {
        "car",
        "pickup",
        "minibus",
        "auto-rickshaw",
        "cargo-bike",
        "bicycle",
        "tram",
    }
    assert not {str(kind) for kind in KINDS} & {"vehicle", "road-user", "pram", "horse-rider", "cone"}
    for kind in set(UserKind) - set(KINDS):
        with pytest.raises(SituationError, match=r"ego\.kind: .*the ego is one of car, van"):
            stops_ahead(kind=str(kind))


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("voice", Voice)
def test_the_kind_is_told_once(kind: UserKind, voice: Voice) -> None:
    paths = [path for path, _ in facts_told(stops_ahead(kind=str(kind)), voice)]
    assert paths.count("ego.kind") == 1


def test_a_rider_rides_and_a_driver_drives() -> None:
    assert told(stops_ahead(kind="motorcycle", speed="40 km/h")).startswith("We ride a motorcycle. We ride at 40 km/h.")
    assert told(stops_ahead(kind="bus", route="straight")).startswith("We drive a bus. We drive straight ahead.")
    assert told(stops_ahead(kind="bus"), Voice.PROTOCOL).startswith("The subject vehicle (SV) is a bus.")


@pytest.mark.parametrize("kind", KINDS)
def test_a_drive_has_an_ego_of_the_body_that_was_said(kind: UserKind) -> None:
    said = stops_ahead(kind=str(kind))
    one = build(said)
    episode = drive(one)
    ego, limits = episode.ego_track, LIMITS[kind.scenic]
    assert one.program.ego_kind == ego.kind == kind.scenic
    assert (ego.length, ego.width) == (limits.length, limits.width)
    assert ego.speed.max() <= limits.top_speed
    assert -np.diff(ego.speed).min() / episode.dt <= limits.brake + 0.5
    route = simulator(one.map, "native").route(one.program, 0)
    assert {finding.path: finding.shown for finding in judge(said, episode, route)}["ego.kind"]
    other = judge(with_fact(said, "ego.kind", "tram" if kind is UserKind.CAR else "car"), episode, route)
    assert not {finding.path: finding.shown for finding in other}["ego.kind"]


def test_nothing_that_is_built_takes_the_ego_for_a_car() -> None:
    folder = Path(chatscene.build.__file__).parent
    a_car = re.compile(r"AdversaryKind\.CAR\b|LIMITS\[(?:CAR|\"Car\")\]")
    named = {one.name for one in folder.glob("*.py") if a_car.search(one.read_text(encoding="utf-8"))}
    assert named <= {"asked.py", "ego.py", "parts.py", "roadside.py"}, (
        "how much longer it is than a car is known there; take ego.body"
    )


def test_an_ego_of_which_nothing_is_said_is_the_car_that_it_was() -> None:
    assert build(stops_ahead()).program.source == build(stops_ahead(kind="car")).program.source
    assert build(at_lights()).program.source == build(at_lights(kind="car")).program.source


@pytest.mark.parametrize("kind", ["bus", "motorcycle", "bicycle"])
@pytest.mark.parametrize("ego", ["idm", "planner", "hardened", "sac", "rule-based"])
def test_the_engine_drives_every_kind_to_the_bit_as_the_reference(kind: str, ego: str) -> None:
    one = build(at_lights(kind=kind, route="right-turn"))
    mine, theirs = drive(one, ego), drive(one, ego, "embedded")
    assert mine.stepped.by == "native"
    assert differences(mine, theirs) == []


@pytest.mark.parametrize("kind", ["bus", "bicycle"])
def test_the_gap_that_was_said_is_from_nose_to_tail_of_the_bodies(kind: str) -> None:
    starts = {"where": "ahead", "distance": "20 m"}
    others = [{"id": "A", "kind": "truck", "starts": starts, "does": [{"act": "stop"}]}]
    episode = drive(build(from_plain({"ego": {"kind": kind}, "others": others})))
    ego, truck = episode.ego_track, episode.tracks[1]
    middles = float(np.hypot(truck.x[0] - ego.x[0], truck.y[0] - ego.y[0]))
    assert middles - (ego.length + truck.length) / 2 == pytest.approx(20.0, abs=0.2)


def test_whatever_waits_at_the_lights_has_its_nose_at_the_line() -> None:
    noses: list[float] = []
    for kind in ("car", "bus", "motorcycle"):
        one = build(at_lights(kind=kind))
        noses.append(simulator(one.map, "native").route(one.program, 0).event_at - LIMITS[kind.capitalize()].length / 2)
    assert noses == pytest.approx([noses[0]] * 3, abs=0.02)


@pytest.mark.parametrize("kind", KINDS)
def test_every_kind_turns_where_a_car_can(kind: UserKind) -> None:
    others = [{"id": "A", "kind": "car", "starts": {"where": "behind"}, "does": [{"act": "follow"}]}]
    one = build(from_plain({"ego": {"kind": str(kind), "route": "right-turn"}, "others": others}))
    episode = drive(one)
    line, ego = simulator(one.map, "native").route(one.program, 0).line, episode.ego_track
    aside = max(abs(line.project(x, y)[1]) for x, y in zip(ego.x.tolist(), ego.y.tolist(), strict=True))
    assert aside < 1.2
    assert not any(event.kind is EventKind.OFF_ROAD for event in episode.events)


def test_a_bus_needs_longer_than_a_car_to_get_under_way_and_to_stop() -> None:
    under_way: list[float] = []
    hardest: list[float] = []
    for kind in ("car", "bus"):
        speed = drive(build(at_lights(kind=kind))).ego_track.speed
        under_way.append(float(np.argmax(speed > 3.0)))
        hardest.append(float(-np.diff(drive(build(stops_ahead(kind=kind)), "sac").ego_track.speed).min()))
    assert under_way[1] > under_way[0]
    assert hardest[1] < hardest[0]


@pytest.mark.parametrize(
    ("ego", "why"),
    [
        (
            {"kind": "bicycle", "speed": "80 km/h"},
            r"ego\.speed: 80 km/h is more than a cyclist can do: at most 70 km/h",
        ),
        (
            {"kind": "tram", "does": [{"act": "brake", "acceleration": "6 m/s²"}]},
            r"ego\.does\.0\.acceleration: 6 m/s² is more than a tram can do: at most 3 m/s²",
        ),
    ],
)
def test_what_no_such_body_can_do_is_refused(ego: dict[str, Any], why: str) -> None:
    with pytest.raises(NotBuilt, match=why):
        build(stops_ahead(**ego))


@pytest.mark.parametrize("kind", ["car", "van", "tram", "e-scooter", "emergency-vehicle"])
def test_the_speed_that_is_told_for_one_that_a_body_cannot_do_is_built(kind: str) -> None:
    with pytest.raises(NotBuilt) as refused:
        build(stops_ahead(kind=kind, speed="300 km/h"))
    (most,) = re.findall(r"at most (\d+) km/h", str(refused.value))
    assert build(stops_ahead(kind=kind, speed=f"{most} km/h"))


def test_a_cyclist_of_whom_no_speed_is_said_is_as_slow_as_cyclists_are() -> None:
    assert build(stops_ahead(kind="bicycle")).program.wanted_speed == pytest.approx(4.6, abs=0.1)
    assert build(stops_ahead(kind="bus")).program.wanted_speed == build(stops_ahead()).program.wanted_speed


@pytest.mark.parametrize("kind", ["bus", "motorcycle", "bicycle", "car"])
def test_a_door_comes_into_the_way_of_whatever_passes(kind: str) -> None:
    does = [{"act": "stand"}, {"act": "open-door"}]
    others = [{"id": "A", "kind": "car", "starts": {"where": "kerb", "side": "right"}, "does": does}]
    one = build(from_plain({"ego": {"kind": kind, "speed": "20 km/h"}, "others": others}))
    episode = drive(one)
    line, ego = simulator(one.map, "native").route(one.program, 0).line, episode.ego_track
    door = next(track for track in episode.tracks if track.actor == "A-door")
    tip = abs(line.project(float(door.x[-1]), float(door.y[-1]))[1]) - door.length / 2
    assert tip < ego.width / 2 - 0.2


def test_who_is_told_of_the_body_knows_it_and_drives_a_car_as_before() -> None:
    bus, car = build(stops_ahead(kind="bus")).program, build(stops_ahead()).program
    for name in ("idm", "planner", "hardened"):
        assert getattr(fitted(load_ego(name), bus), "body") == LIMITS["Bus"]  # noqa: B009 - of some egos alone
        assert getattr(fitted(load_ego(name), car), "body") == LIMITS["Car"]  # noqa: B009


def test_how_hard_an_ego_brakes_is_told_of_what_it_drives() -> None:
    assert in_words(senses_of(load_ego("idm"), "Bus")).endswith("brakes at up to 5.5 m/s² (the full brake pedal)")
    assert in_words(senses_of(load_ego("idm"))).endswith("brakes at up to 8 m/s² (the full brake pedal)")
    written = "ego: {kind: bus}\nothers: [{id: A, kind: car, starts: {where: ahead}, does: [{act: stop}]}]\n"
    record = SituationRecord(name="", text=written)
    (senses,) = asked_run(situation=record, generator="situation").senses.values()
    assert senses["body"] == "Bus"


def test_the_page_of_the_world_says_what_engines_hold_and_what_a_car_may_begin_with() -> None:
    page = (Path(__file__).parents[2] / "docs" / "world.md").read_text(encoding="utf-8")
    (told,) = re.findall(
        r"engine power: car (\d+) km/h .*?, van (\d+), ambulance (\d+), bus (\d+), truck (\d+)\.", page
    )
    kinds = (
        AdversaryKind.CAR,
        AdversaryKind.VAN,
        AdversaryKind.EMERGENCY_VEHICLE,
        AdversaryKind.BUS,
        AdversaryKind.TRUCK,
    )
    holds = [3.6 * Body(kind.row.limits, walks=False).fastest for kind in kinds]
    assert all(abs(float(one) - own) <= 1.5 for one, own in zip(told, holds, strict=True))
    (most,) = re.findall(r"a car at up to (\d+) km/h", page)
    with pytest.raises(NotBuilt, match=rf"more than a car can do: at most {most} km/h"):
        build(stops_ahead(speed="280 km/h"))
