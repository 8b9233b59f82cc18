"""Who comes driving begins at its speed and is there in time, on as much road as that takes."""

from __future__ import annotations

from itertools import combinations
from typing import Any

import numpy as np
import pytest
from test_building import drive

from chatscene.build.build import build
from chatscene.build.coming import coming
from chatscene.errors import NotBuilt
from chatscene.maps.network import resolve_map
from chatscene.program.judge import judge
from chatscene.settings import SimulationSettings
from chatscene.simulate.simulator import load_simulator
from chatscene.situations.form import from_plain
from chatscene.terms.episode import Episode, Track
from chatscene.terms.order import Order
from chatscene.terms.polyline import Polyline


def someone(
    where: str, *acts: str, kind: str = "car", ego: dict[str, Any] | None = None, **start: Any
) -> dict[str, Any]:
    does = [{"act": act} for act in acts]
    one = {"id": "A", "kind": kind, "starts": {"where": where, **start}, "does": does}
    return {"ego": ego or {}, "others": [one]}


def driven(said: dict[str, Any], seed: int = 1, ego: str = "idm") -> Episode:
    episode = drive(build(from_plain(said)), seed=seed, ego=ego)
    assert isinstance(episode, Episode), episode
    assert episode.stepped.by == "native", episode.stepped.instead
    return episode


def track(episode: Episode, name: str = "A") -> Track:
    return next(one for one in episode.tracks if one.actor == name)


COMING = {
    "through a junction": someone("arm", "go-straight", side="left", speed="40 km/h"),
    "toward us": someone("oncoming", "drift", speed="40 km/h"),
    "toward us, who turn": someone("oncoming", "go-straight", speed="40 km/h", ego={"route": "left-turn"}),
    "toward us, who swing out": someone("oncoming", "go-along", speed="40 km/h", ego={"route": "bypass"}),
    "across, on two wheels": someone("roadside", "cross", kind="bicycle", side="right", speed="15 km/h"),
    "across, on foot": someone("roadside", "cross", kind="pedestrian", side="right", speed="9 km/h"),
}


@pytest.mark.parametrize("way", COMING)
@pytest.mark.parametrize("ego", ["idm", "planner"])
def test_who_comes_driving_begins_at_its_speed(way: str, ego: str) -> None:
    said = COMING[way]
    wanted = float(said["others"][0]["starts"]["speed"].split()[0]) / 3.6
    speed = track(driven(said, ego=ego)).speed
    assert speed[0] == pytest.approx(wanted, rel=0.01)
    assert speed[:20].min() > 0.9 * wanted


def test_traffic_of_which_no_speed_was_said_comes_driving_too() -> None:
    assert track(driven(someone("arm", "go-straight", side="right"))).speed.min() > 3.0


@pytest.mark.parametrize("seed", range(4))
def test_who_comes_driving_is_at_the_junction_when_the_ego_would_be(seed: int) -> None:
    made = build(from_plain(someone("arm", "go-straight", side="left", speed="40 km/h")))
    episode = drive(made, seed=seed)
    assert isinstance(episode, Episode)
    there, ego = track(episode), episode.ego_track
    aside = (there.x - ego.x[0]) * np.sin(ego.heading[0]) - (there.y - ego.y[0]) * np.cos(ego.heading[0])
    # The ego, which nothing holds, would be there at 50 km/h.
    meets = int(np.abs(aside).argmin())
    along = np.hypot(there.x[meets] - ego.x[0], there.y[meets] - ego.y[0])
    assert meets * episode.dt == pytest.approx(along * 3.6 / 50, abs=1.0)


def test_who_waits_for_something_waits() -> None:
    said = someone("arm", "go-straight", side="left", ego={"does": [{"act": "stand"}, {"act": "set-off"}]})
    said["others"][0]["does"][0]["when"] = {"after": "ego.set-off"}
    assert track(driven(said)).speed[0] == 0.0


def test_an_ego_that_is_held_is_waited_for() -> None:
    route: Any = type("Straight", (), {"line": Polyline([(0.0, 0.0), (100.0, 0.0)]), "eventAt": 40.0})
    free = coming(8.0, (), route, 40.0, stands=False)
    held = coming(8.0, (Order(at_most=0, till=4.0),), route, 40.0, stands=True)
    assert free.late == pytest.approx(0.0, abs=0.15)
    assert held.late is not None
    assert held.late > 4.0
    assert coming(8.0, (Order(at_most=0, place=20.0),), route, 40.0, stands=False).late is None


def test_a_distance_and_a_speed_that_lead_past_the_ego_are_refused_with_where_it_would_have_to_start() -> None:
    with pytest.raises(NotBuilt, match=r"A\.starts\.distance: 10 m: .* the ego after 6\.5 s; .* 124 m before"):
        build(from_plain(someone("arm", "go-straight", side="left", speed="80 km/h", distance="10 m")))


def test_a_speed_for_which_the_road_is_too_short_is_refused_with_the_most() -> None:
    with pytest.raises(NotBuilt, match=r"others\.A: the road that it comes from is too short for more than \d+"):
        build(from_plain(someone("arm", "go-straight", side="left", speed="150 km/h", ego={"speed": "15 km/h"})))


@pytest.mark.parametrize(("where", "metres"), [("ahead", 85.0), ("ahead", 180.0), ("roadside", 90.0)])
def test_who_was_said_to_be_far_ahead_is_so_far_ahead_on_a_longer_road(where: str, metres: float) -> None:
    side = {"side": "right"} if where == "roadside" else {}
    kind, act = ("pedestrian", "cross") if where == "roadside" else ("car", "stand")
    said = someone(where, act, kind=kind, distance=f"{metres:g} m")
    said["others"][0]["starts"] |= side
    episode = driven(said)
    there, ego = track(episode), episode.ego_track
    level = abs((there.x[0] - ego.x[0]) * np.cos(ego.heading[0]) + (there.y[0] - ego.y[0]) * np.sin(ego.heading[0]))
    bodies = (there.length + ego.length) / 2 if where == "ahead" else 0.0  # from nose to tail of who goes the same way
    assert level - bodies == pytest.approx(metres, abs=1.0)


@pytest.mark.parametrize(("where", "acts"), [("ahead", ("stand",)), ("oncoming", ("enter",))])
def test_a_distance_beyond_the_longest_road_is_refused_with_that(where: str, acts: tuple[str, ...]) -> None:
    with pytest.raises(NotBuilt, match=r"others\.A\.starts\.distance: 9000 m: the longest road has \d+ m"):
        build(from_plain(someone(where, *acts, distance="9000 m")))


def test_a_faster_ego_has_more_road_before_what_happens() -> None:
    said = someone("roadside", "cross", kind="pedestrian", side="right", ego={"speed": "50 km/h"})
    assert "approach=" in build(from_plain(said)).program.source
    assert "approach=" not in build(from_plain(said | {"ego": {"speed": "28 km/h"}})).program.source
    there = track(driven(said))
    ego = driven(said).ego_track
    assert np.hypot(there.x[0] - ego.x[0], there.y[0] - ego.y[0]) > 55.0


ROUND = {"in the ring": "in-roundabout", "at an entry": "roundabout-entry"}


def in_roundabout(where: str, route: str = "roundabout", *acts: str, **start: str) -> dict[str, Any]:
    said = someone(where, *(acts or ("go-along",)), ego={"route": route})
    said["others"][0]["starts"] |= start
    return said | {"road": {"kind": "roundabout"}}


@pytest.mark.parametrize("where", ROUND.values())
@pytest.mark.parametrize("route", ["roundabout", "right-turn", "straight", "left-turn"])
def test_who_is_at_a_roundabout_meets_an_ego_on_each_way_through_it(where: str, route: str) -> None:
    episode = driven(in_roundabout(where, route))
    there, ego = track(episode), episode.ego_track
    assert np.hypot(there.x - ego.x, there.y - ego.y).min() < 16.0
    assert abs(there.speed[0]) > 3.0


def test_who_goes_round_is_in_the_ring_from_the_first_and_who_enters_is_not() -> None:
    inside, outside = (track(driven(in_roundabout(where))) for where in ROUND.values())
    turned = [abs(float(np.unwrap(one.heading)[10] - one.heading[0])) for one in (inside, outside)]
    assert turned[0] > 0.2
    assert turned[1] < 0.1


@pytest.mark.parametrize(("where", "side"), [("arm", "left"), ("arm", "right"), ("oncoming", None)])
def test_an_arm_of_a_roundabout_is_that_arm(where: str, side: str | None) -> None:
    start = {"side": side} if side else {}
    episode = driven(in_roundabout(where, "left-turn", "enter", **start))
    there, ego = track(episode), episode.ego_track
    turned = np.degrees(np.remainder(there.heading[0] - ego.heading[0] + np.pi, 2 * np.pi) - np.pi)
    assert abs(turned) > 135 if side is None else turned == pytest.approx(-90 if side == "left" else 90, abs=30)


def test_a_roundabout_has_signs_to_give_way() -> None:
    made = build(
        from_plain(in_roundabout("roundabout-entry") | {"road": {"kind": "roundabout", "control": "yield-sign"}})
    )
    assert made.left_out == ()


@pytest.mark.parametrize(
    ("light", "shown"), [("yellow", "gyr"), ("turns-green", "rg"), ("turns-red", "gyr"), ("red", "r"), ("green", "g")]
)
def test_the_light_of_the_ego_is_what_was_said_at_a_junction_that_has_one(light: str, shown: str) -> None:
    said = someone("arm", "go-straight", side="left") | {"road": {"ego_light": light}}
    episode = driven(said)
    own = next(one.state for one in episode.signals if one.role == "ego")
    assert "".join(dict.fromkeys(own[:120])) == shown


@pytest.mark.parametrize(("breach", "control"), [("red-light", "signal"), ("stop-sign", "none")])
def test_a_rule_that_is_broken_is_there(breach: str, control: str) -> None:
    said = someone("arm", "go-straight", side="left")
    said["others"][0]["does"][0]["breaks"] = breach
    assert f"control='{control}'" in build(from_plain(said)).program.source


@pytest.mark.parametrize("ego", ["idm", "planner"])
def test_who_yields_stands_until_the_ego_has_gone_by_and_then_goes(ego: str) -> None:
    episode = driven(someone("arm", "yield", side="right"), ego=ego)
    there, own = track(episode), episode.ego_track
    off = int(np.flatnonzero(np.abs(there.speed) < 0.1)[-1])
    level = (own.x - there.x[off]) * np.cos(own.heading[0]) + (own.y - there.y[off]) * np.sin(own.heading[0])
    assert level[off] > 3.0
    assert there.speed[off:].max() > 3.0


def test_who_parks_comes_to_stand_at_the_kerb() -> None:
    episode = driven(someone("ahead", "park"))
    there, own = track(episode), episode.ego_track
    aside = (there.x - own.x[0]) * np.sin(own.heading[0]) - (there.y - own.y[0]) * np.cos(own.heading[0])
    assert aside[-1] > 2.0
    assert there.speed[-1] < 0.1


def test_who_walks_along_the_road_beside_it_stays_beside_it() -> None:
    episode = driven({"others": [{"id": "A", "kind": "pedestrian", "starts": {"where": "roadside", "side": "right"},
                                  "does": [{"act": "go-along"}]}]})  # fmt: skip
    there, ego = track(episode), episode.ego_track
    aside = (there.x - ego.x[0]) * np.sin(ego.heading[0]) - (there.y - ego.y[0]) * np.cos(ego.heading[0])
    assert np.ptp(aside) < 0.5
    assert np.hypot(there.x[-1] - there.x[0], there.y[-1] - there.y[0]) > 5.0


def test_who_is_beyond_a_junction_is_as_far_from_there_as_was_said_and_judged_by_that() -> None:
    for where, kind in (("exit", "car"), ("exit-crossing", "pedestrian")):
        side = {} if where == "exit" else {"side": "right"}
        said = someone(where, "stand", kind=kind, ego={"route": "left-turn"}, distance="9 m", **side)
        built = build(from_plain(said))
        driven_so = drive(built, seed=1, ego="idm")
        assert isinstance(driven_so, Episode)
        simulator = load_simulator(resolve_map(built.map), SimulationSettings())
        found = {one.path: one for one in judge(from_plain(said), driven_so, simulator.route(built.program, 0))}
        finding = found["others.A.starts.distance"]
        assert finding.shown, finding.told


def test_a_crosswalk_is_where_was_said_or_refused_with_where_it_is() -> None:
    with pytest.raises(NotBuilt, match=r"A\.starts\.distance: 3 m: the crosswalk is 6 to 8 m ahead of the ego"):
        build(from_plain(someone("crossing", "cross", kind="pedestrian", side="right", distance="3 m")))
    for metres in (7, 30, 100):
        assert track(driven(someone("crossing", "cross", kind="pedestrian", side="right", distance=f"{metres} m")))


def test_those_of_a_group_by_whom_an_ego_backs_out_stand_apart() -> None:
    ego = {"kind": "van", "route": "leave-driveway", "speed": "8 km/h", "does": [{"act": "reverse"}]}
    for count in (0, 4):
        said = someone("roadside", "stand", kind="child", ego=ego, side="right", distance="3 m")
        said["others"][0]["count"] = count
        there = [one for one in driven(said).tracks if one.actor.startswith("A")]
        assert len(there) == (count or 3)
        apart = [np.hypot(a.x[0] - b.x[0], a.y[0] - b.y[0]) for a, b in combinations(there, 2)]
        assert min(apart) > 1.0
