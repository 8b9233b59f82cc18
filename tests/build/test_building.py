"""Situations become programs that stand, drive, and have every fact that was said, or say what they lack."""

from __future__ import annotations

import re
from functools import cache
from types import SimpleNamespace
from typing import Any

import pytest
import yaml
from hypothesis import given, settings
from hypothesis import strategies as st

from benchmarks.differing import differences
from chatscene.build.build import Built, build
from chatscene.build.deeds import ACROSS, ALONG, TOWARD, UNDER_WAY, Steps, over_the_road
from chatscene.build.ledger import LEFT_OUT
from chatscene.build.numbers import RANGES, Numbers
from chatscene.build.parts import BUILT_AS
from chatscene.build.place import NEXT_LANE
from chatscene.build.starts import STARTS
from chatscene.ego.asking import wanting
from chatscene.ego.policy import load_ego
from chatscene.errors import MapError, NotBuilt, SituationError
from chatscene.maps.network import resolve_map
from chatscene.program.sample import draw
from chatscene.settings import SimulationSettings
from chatscene.simulate.simulator import Simulator, load_simulator, simulate
from chatscene.situations.facts import said_in, with_fact
from chatscene.situations.file import read_text
from chatscene.situations.form import from_plain
from chatscene.terms.act_amounts import AMOUNTS
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.amount import Acceleration, Speed
from chatscene.terms.episode import Episode, Role
from chatscene.terms.polyline import Polyline
from chatscene.terms.scene import Rejected, Scene
from chatscene.terms.situation import Situation
from chatscene.terms.vocabulary import Act, Where
from chatscene.terms.written_plans import WrittenPlan, written_plans
from chatscene.world.places import secondsTo
from drawn import situations
from places import TESTS

WRITTEN: dict[str, Any] = {
    one.pop("name"): one for one in yaml.safe_load((TESTS / "build" / "written.yaml").read_text(encoding="utf-8"))
}


def situation(name: str) -> Situation:
    return from_plain(WRITTEN[name])


@cache
def built(name: str) -> Built:
    return build(situation(name))


@cache
def simulator(map_name: str, by: str) -> Simulator:
    return load_simulator(resolve_map(map_name), SimulationSettings(simulator=by))


def drive(one: Built, by: str = "native", seed: int = 1, ego: str = "idm") -> Episode | Rejected:
    scene = Scene(
        id=f"{one.program.scenario_id}/route-00/scene-{seed}",
        scenario_id=one.program.scenario_id,
        route=0,
        block=0,
        seed=seed,
        values=draw(one.program.parameters, seed=seed),
    )
    driver = wanting(load_ego(ego), one.program.wanted_speed)
    return simulate(simulator(one.map, by), one.program, scene, driver)


def ahead(*deeds: dict[str, Any]) -> dict[str, Any]:
    """A car ahead that does something."""
    return {"others": [{"id": "A", "kind": "car", "starts": {"where": "ahead"}, "does": list(deeds)}]}


@cache
def driven(name: str) -> Episode | Rejected:
    """One drive of what is built, in the engine."""
    return drive(built(name))


@pytest.mark.parametrize("name", WRITTEN)
def test_what_is_built_drives_in_the_engine_and_the_same_in_the_reference(name: str) -> None:
    mine, theirs = driven(name), drive(built(name), "embedded")
    assert isinstance(mine, Episode), mine
    assert isinstance(theirs, Episode)
    assert mine.stepped.by == "native", mine.stepped.instead
    assert differences(mine, theirs) == []


@pytest.mark.parametrize("name", WRITTEN)
def test_every_plan_is_data(name: str) -> None:
    for behavior, plan in written_plans(built(name).program.source).items():
        assert isinstance(plan, WrittenPlan), (behavior, plan)


@pytest.mark.parametrize("name", WRITTEN)
def test_everybody_who_was_said_is_there_in_the_number_and_part_that_was_said(name: str) -> None:
    said, episode = situation(name), driven(name)
    assert isinstance(episode, Episode)
    roles = {"adversary": Role.ADVERSARY, "supporting": Role.BACKGROUND, "hides": Role.OCCLUDER}
    for one in said.others:
        there = [track for track in episode.tracks if re.fullmatch(rf"{one.id}(-\d+)?", track.actor)]
        assert len(there) == (one.count or 3)
        assert {track.role for track in there} == {roles[one.role]}
    parts = sum(deed.act in BUILT_AS for one in said.others for deed in one.does)
    assert len(episode.tracks) == 1 + sum(one.count or 3 for one in said.others) + parts


def test_every_place_of_these_tables_is_tried_here() -> None:
    there = {one.starts.where for name in WRITTEN for one in situation(name).others}
    assert set(STARTS) - there <= {Where.MEDIAN, Where.CROSSING}
    assert set(Where) - set(STARTS) == {Where.OFF_RAMP}


def test_steps_read_no_parameter_that_has_no_range() -> None:
    speeds = Numbers("A", AdversaryKind.CAR.row).ranges
    for table in (ALONG, TOWARD, ACROSS):
        for act, steps in table.items():
            read = {name for text in (*steps.does, *steps.last) for name in re.findall(r"\$([A-Z_]+)", text)}
            assert read <= {*RANGES, *speeds}, f"{act}: give each parameter a range in build/numbers.py"
            assert set(steps.binds) <= set(AMOUNTS), act
            assert set(steps.binds.values()) <= read, act


def test_every_act_has_its_steps() -> None:
    assert not set(Act) - set(ALONG), "give each act a row of steps, ALONG in build/deeds.py"


def test_an_act_that_only_changes_speed_is_done_over_the_road_by_the_row_of_who_goes_along_it() -> None:
    along = Steps(
        does=("BrakeOnPath({p}, $BRAKE) for $BRAKE_TIME seconds", "DrivePath({p}, $SPEED) until " + UNDER_WAY),
        binds={"acceleration": "BRAKE", "time": "BRAKE_TIME"},
        going=True,
    )
    across = over_the_road(along)
    assert across is not None
    assert across.does == ("Halt() for $BRAKE_TIME seconds", "MoveAhead($SPEED) until " + UNDER_WAY)
    assert across.binds == {"time": "BRAKE_TIME"}
    assert across.going
    assert over_the_road(ALONG[Act.WEAVE]) is over_the_road(ALONG[Act.YIELD]) is None


def test_a_number_that_was_said_is_a_number_of_the_program() -> None:
    braking = built("the car ahead brakes with 4 m/s²").program
    assert "BrakeOnPath(wayA, 0.475)" in braking.source  # of 8 m/s², beside 0.2 of drag
    assert "pointOn(wayA, 19.9)" in braking.source  # 15 m between two cars of 4.9 m
    assert "OPT_A_BRAKE" not in braking.source
    assert "wantedSpeed 8.333" in built("a truck runs a red light from the left, we want 30 km/h").program.source


def test_a_number_that_no_body_can_do_is_refused_with_what_it_can() -> None:
    numbers = Numbers("A", AdversaryKind.BICYCLE.row)
    with pytest.raises(
        NotBuilt, match=r"others\.A\.starts\.speed: 80 km/h is more than a cyclist can do: at most 41 km/h"
    ):
        numbers.bind("SPEED", Speed.of("80 km/h"), "others.A.starts.speed")
    with pytest.raises(
        NotBuilt, match=r"others\.A\.does\.0\.acceleration: 9 m/s² is more than a cyclist can do: at most 4\.5 m/s²"
    ):
        numbers.bind("BRAKE", Acceleration.of(9), "others.A.does.0.acceleration")


def test_bounds_and_differences_to_the_ego_narrow_what_is_searched() -> None:
    numbers = Numbers("A", AdversaryKind.CAR.row)
    numbers.bind("SPEED", Speed.of("at most 25 km/h"))
    low, high, *_ = numbers.ranges["SPEED"]
    assert low < high == pytest.approx(25 / 3.6)
    numbers.bind("SPEED", Speed.of("2 m/s more than the ego").beside(8.0))
    assert numbers.ranges["SPEED"][:2] == (10.0, 10.0)


@pytest.mark.parametrize(
    ("changed", "told"),
    [
        (
            {"others": [{"id": "A", "kind": "car", "starts": {"where": "off-ramp"}}]},
            "others.A.starts.where: off-ramp; the nearest is ahead-beside, on the right",
        ),
        ({"road": {"kind": "rail-crossing", "ego_light": "turns-red"}}, "road.ego_light: turns-red"),
        ({"road": {"lanes": 7}}, "no map has such a place"),
        ({"others": []}, "nobody meets the ego"),
        (ahead({"act": "stop", "distance": "2 m"}), "others.A.does.0.distance: 2 m"),
    ],
)  # fmt: skip
def test_a_fact_that_cannot_be_built_is_refused_by_its_path(changed: dict[str, Any], told: str) -> None:
    with pytest.raises(NotBuilt) as refused:
        build(from_plain(ahead({"act": "brake"}) | changed))
    assert told in str(refused.value)


def test_what_was_not_said_and_had_to_be_something_is_told() -> None:
    assert built("a van ahead in the next lane, side unsaid, cuts in").assumed == (
        "A is on the right",
        "the ego drives at 50 km/h",
    )
    several = built("we turn left, people cross the road we turn into").assumed
    assert several[-1] == "there are 3 of A, since their number is not stated"


def test_others_are_timed_by_the_speed_that_the_ego_wants() -> None:
    crosses = situation("a cyclist crosses when we are 4 s away")
    assert "with wantedSpeed 13.89, with keepsLimits True" in build(crosses).program.source
    for speed, wanted in (("30 km/h", 30 / 3.6), (None, 50 / 3.6)):
        source = build(with_fact(crosses, "ego.speed", speed)).program
        assert source.wanted_speed == pytest.approx(wanted, abs=0.01)
    ego = SimpleNamespace(wantedSpeed=10.0, pose=(0.0, 0.0, 0.0, 10.0), body=SimpleNamespace(grip=9.0))
    assert secondsTo(Polyline([(0.0, 0.0), (100.0, 0.0)]), ego, 50.0) == pytest.approx(5.0)


def test_the_same_situation_is_the_same_program() -> None:
    name = "a child runs out from behind a parked car"
    assert build(situation(name)).program == build(situation(name)).program


@given(situations())
@settings(max_examples=25, deadline=None)
def test_of_whatever_can_be_said_each_fact_is_built_or_left_out_with_a_word_or_refused(said: Situation) -> None:
    try:
        one = build(said)
    except (NotBuilt, MapError) as refusal:
        assert str(refusal)
        return
    left = {line.partition(": ")[0] for line in one.left_out}
    assert left <= {path for path, _ in said_in(said)}
    assert all(LEFT_OUT.match(path) for path in left)
    for behavior, plan in written_plans(one.program.source).items():
        assert isinstance(plan, WrittenPlan), (behavior, plan)
    read = set(re.findall(r"globalParameters\.(\w+)", one.program.source))
    assert read == {parameter.name for parameter in one.program.parameters}


FACTS: tuple[tuple[str, object], ...] = (
    ("starts.distance", "57 m"),
    ("starts.speed", "2.2 m/s"),
    ("starts.facing", "against"),
    ("does.0.manner", "fast"),
    ("does.0.manner", "hard"),
    ("does.0.speed", "2.1 m/s"),
    ("does.0.acceleration", "2.1 m/s²"),
    ("does.0.distance", "4.4 m"),
    ("does.0.time", "3.3 s"),
    ("does.0.to", "right"),
    ("does.0.when", {"ego_within": "21 m"}),
    ("does.0.when", {"ego_within": "2.7 s"}),
)


_AGAINST = (Where.ONCOMING, Where.ONCOMING_IN_OUR_LANE)
_ALONG = tuple(where for where in Where if where not in _AGAINST)  # of those who drive on it, or stand at its edge


@given(
    st.sampled_from(("car", "bicycle", "pedestrian")),
    st.sampled_from(Where),
    st.sampled_from(Act),
    st.sampled_from(FACTS),
)
@settings(max_examples=40, deadline=None)
def test_a_fact_more_is_another_program_or_is_left_out_with_a_word_or_refused(
    kind: str, where: Where, act: Act, fact: tuple[str, object]
) -> None:
    path, value = fact
    start: dict[str, str] = {"where": where, **({"side": "right"} if where.row.sided else {})}
    plain = {"others": [{"id": "A", "kind": kind, "starts": start, "does": [{"act": act}]}]}
    try:
        said = from_plain(plain)
        without, with_it = build(said), build(with_fact(said, f"others.A.{path}", value))
    except (NotBuilt, MapError, SituationError):
        return
    so_anyway = path == "starts.facing" and where in (_AGAINST if value == "against" else _ALONG)
    so_anyway |= path == "does.0.to" and act is Act.OVERTAKE and where in NEXT_LANE  # it passes where it is
    so_anyway |= path == "does.0.to" and where is Where.ONCOMING  # it comes over from our left, so to our right
    assert with_it.program.source != without.program.source or with_it.left_out or so_anyway


CAR = "others: [{id: A, kind: car, starts: {where: "


@pytest.mark.parametrize(
    ("written", "told"),
    [
        ("ego: {route: bypass}\nroad: {two_way: false}\n" + CAR + "oncoming}}]", "road.two_way: false"),
        (
            "contact: {whom: B}\n" + CAR + "ahead}}, {id: B, kind: car, role: supporting, starts: {where: behind}}]",
            "contact.whom: B",
        ),
        (
            CAR + "ahead}, does: [{act: brake, breaks: right-of-way}]}]",
            "others.A.does.0.breaks: right-of-way",
        ),
        (CAR + "kerb, side: right, speed: 36 km/h}, does: [{act: pull-out}]}]", "others.A.starts.speed: 36 km/h"),
    ],
)
def test_a_fact_that_the_program_would_not_have_is_refused(written: str, told: str) -> None:
    with pytest.raises(NotBuilt) as refused:
        build(read_text(written))
    assert told in str(refused.value)
