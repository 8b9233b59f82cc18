"""A program is driven before it is run: what drives do not show as it was said is shifted, and nothing else."""

from __future__ import annotations

import math
import re
from dataclasses import replace
from typing import Any

import pytest

from chatscene.build.build import Built, build
from chatscene.build.coming import speeds_to_try
from chatscene.ego.policy import EgoPolicy, load_ego, name_of
from chatscene.errors import ProgramError
from chatscene.maps.network import resolve_map
from chatscene.program.sample import scene_at
from chatscene.program.together import Late, apart
from chatscene.report.stated import explain_stated
from chatscene.search import rehearsal
from chatscene.search.generators.situated import Situated
from chatscene.search.rehearsal import declared, rehearsed, with_range
from chatscene.settings import RetrievalSettings, SimulationSettings
from chatscene.simulate.simulator import load_simulator, simulate
from chatscene.situations.file import to_yaml
from chatscene.situations.form import from_plain
from chatscene.terms.episode import Episode
from chatscene.terms.scene import Rejected, Scene, ScenicProgram
from chatscene.terms.situation import Situation
from chatscene.terms.snippet import ParameterRange


def said(kind: str, where: str, *acts: str, ego: dict[str, Any] | None = None, **start: str) -> Situation:
    one = {"id": "A", "kind": kind, "starts": {"where": where, **start}, "does": [{"act": act} for act in acts]}
    return from_plain({"others": [one], "ego": ego or {}})


DOOR = from_plain(
    {
        "ego": {"speed": "14 mph"},
        "others": [
            {
                "id": "A",
                "kind": "car",
                "starts": {"where": "kerb", "side": "right"},
                "does": [{"act": "stand"}, {"act": "open-door", "to": "left"}],
            }
        ],
        "contact": {"ego": "right-front", "striker": "ego"},
    }
)
"""A door that opens too late for an ego that sees it, by rule."""


def ranges(built: Built) -> dict[str, ParameterRange]:
    return {one.name: one for one in built.program.parameters}


@pytest.mark.parametrize(
    "shown", [said("car", "ahead", "brake"), said("pedestrian", "roadside", "cross", side="right")]
)
def test_a_program_whose_drives_show_what_was_said_stays_as_it_is(shown: Situation) -> None:
    built = build(shown)
    assert rehearsed(built, shown) is built


def test_who_comes_too_late_comes_sooner_and_is_told_so() -> None:
    built, shifted = build(DOOR), rehearsed(build(DOOR), DOOR)
    before, after = ranges(built)["OPT_A_OFFSET"], ranges(shifted)["OPT_A_OFFSET"]
    assert after.low > before.low
    assert after.high - after.low == pytest.approx(before.high - before.low)
    assert [one for one in shifted.assumed if one not in built.assumed] == [
        f"OPT_A_OFFSET ({after.meaning}) is {after.low:.3g} to {after.high:.3g} s, not {before.low:.3g} to"
        f" {before.high:.3g} s, since drives show what was said only then"
    ]


def test_a_slower_ego_that_cannot_be_driven_takes_nobody_s_place(monkeypatch: pytest.MonkeyPatch) -> None:
    situation = said("car", "ahead", "brake")
    built = build(situation)
    slower: list[str] = []

    def fails(_: Any, program: ScenicProgram, scene: Scene, ego: EgoPolicy) -> Rejected:
        if program.wanted_speed != built.program.wanted_speed:
            slower.append(name_of(ego))
            raise ProgramError("it ends in an error")
        return Rejected(scene=scene, reason="nobody finds a place")

    monkeypatch.setattr("chatscene.search.rehearsal.simulate", fails)
    told = rehearsed(built, situation)
    assert told.program is built.program
    assert told.unseen == ("none of 16 drives begins: nobody finds a place",)
    assert slower


FACT = "others.A.does.0.act: said brake, but it never does"


@pytest.mark.parametrize(
    ("missing", "told"),
    [
        (((FACT,), ("the scene cannot be placed",), (FACT,)), f"none of 2 drives shows {FACT}"),
        (((FACT,), (), (FACT,), ()), f"none of 2 drives by {rehearsal.EGO} shows {FACT}"),
        (
            (("unasked.contact: the ego and B touch, which the text does not say",),) * 3,
            "all 3 drives show something that was not said: the ego and B touch, which the text does not say",
        ),
    ],
)
def test_what_all_drives_have_in_common_is_told_as_it_is(missing: rehearsal.Missing, told: str) -> None:
    tried = rehearsal._Tried(program=build(DOOR).program, missing=missing, values=())  # pyright: ignore[reportPrivateUsage]
    assert [*tried.unseen()] == [told]


def test_an_ego_is_said_to_be_slower_for_what_drives_show_and_not_since_more_cannot_be_built() -> None:
    situation = from_plain(
        {
            "road": {"kind": "motorway"},
            "others": [{"id": "A", "kind": "car", "starts": {"where": "ahead"}, "does": [{"act": "brake"}]}],
        }
    )
    first, *_, slowest = speeds_to_try(situation)
    assert not any("since" in one for one in build(situation).assumed)
    assert (
        f"the ego drives at {3.6 * slowest:.0f} km/h, since drives show what was said only then"
        in build(situation, at_most=slowest).assumed
    )
    assert first > slowest


def test_only_the_part_of_a_range_goes_in_which_somebody_comes_too_late() -> None:
    crosses = said("deer", "roadside", "cross", side="right")
    before, after = ranges(build(crosses)), ranges(rehearsed(build(crosses), crosses))
    assert [name for name in before if before[name] != after[name]] == ["OPT_A_OFFSET"]
    assert after["OPT_A_OFFSET"].low > before["OPT_A_OFFSET"].low
    assert after["OPT_A_OFFSET"].high == before["OPT_A_OFFSET"].high


def test_what_a_program_is_called_does_not_change_its_ranges() -> None:
    crosses = said("deer", "roadside", "cross", side="right")
    named, stated = (rehearsed(build(crosses, name=name), crosses) for name in ("a-deer-1f2e3d", "situation"))
    assert named.program.scenario_id == "a-deer-1f2e3d"
    assert named.program.parameters == stated.program.parameters


def test_no_more_is_driven_than_is_bounded(monkeypatch: pytest.MonkeyPatch) -> None:
    driven: list[str] = []

    def counted(simulator: Any, program: Any, scene: Any, ego: EgoPolicy) -> Any:
        driven.append(name_of(ego))
        return simulate(simulator, program, scene, ego)

    monkeypatch.setattr("chatscene.search.rehearsal.simulate", counted)
    monkeypatch.setattr("chatscene.search.rehearsal.DRIVES", (20, 16))
    rehearsed(build(DOOR), DOOR)
    assert len(driven) <= 36
    assert set(driven) == set(rehearsal.EGOS)


def test_an_explanation_with_its_program_tells_what_was_shifted() -> None:
    explained = explain_stated(DOOR)
    (line,) = explained.shifted
    assert line.startswith("assumed: OPT_A_OFFSET (")
    assert line.removeprefix("assumed: ") in explained.as_dict()["assumed"]


def test_a_shifted_program_says_its_ranges_in_its_text() -> None:
    for one in rehearsed(build(DOOR), DOOR).program.parameters:
        assert declared(one) in rehearsed(build(DOOR), DOOR).program.source


def test_a_range_of_a_program_is_another_in_its_text_as_well() -> None:
    program = build(DOOR).program
    one = program.parameters[0]
    again = with_range(program, ParameterRange(name=one.name, low=one.low + 1, high=one.high + 1, unit=one.unit))
    assert again.source != program.source
    back = ParameterRange(name=one.name, low=one.low, high=one.high, unit=one.unit, meaning=one.meaning)
    assert with_range(again, back).source == program.source


def test_numbers_that_were_said_are_bound() -> None:
    walks = from_plain(
        {
            "others": [
                {
                    "id": "A",
                    "kind": "pedestrian",
                    "starts": {"where": "roadside", "side": "right", "distance": "20 to 30 m"},
                    "does": [{"act": "cross", "speed": "4 to 6 km/h"}],
                }
            ]
        }
    )
    assert {"OPT_A_SPEED", "OPT_A_Y"} <= build(walks).bound


TOGETHER = "so that it is there when others meet"


def stops_for_a_dog(**start: str) -> Situation:
    """A dog crosses, and a car that comes the other way stops."""
    dog = {"id": "A", "kind": "dog", "starts": {"where": "roadside"}, "does": [{"act": "cross", "manner": "fast"}]}
    comes = {"id": "C", "kind": "car", "starts": {"where": "oncoming", **start}, "does": [{"act": "stop"}]}
    return from_plain({"ego": {"speed": "30 mph"}, "others": [dog, comes | {"role": "supporting"}]})


def test_who_stops_on_its_way_against_the_ego_does_so_short_of_who_crosses() -> None:
    situation = stops_for_a_dog()
    built = build(situation)
    assert "C does its stop for A" in built.assumed
    shifted = rehearsed(built, situation)
    assert ranges(shifted)["OPT_C_Y"].low > ranges(built)["OPT_C_Y"].high
    assert any(one.startswith("OPT_C_Y") and one.endswith(TOGETHER) for one in shifted.assumed)
    episode = driven(shifted)
    dog, comes = (next(one for one in episode.tracks if one.actor == name) for name in ("A", "C"))
    sets_out = next(k for k, speed in enumerate(dog.speed) if speed > 0.5)
    nose = comes.x[-1] + math.cos(comes.heading[-1]) * comes.length / 2
    nose = nose, comes.y[-1] + math.sin(comes.heading[-1]) * comes.length / 2
    ahead = (dog.x[sets_out] - nose[0]) * math.cos(comes.heading[-1])
    ahead += (dog.y[sets_out] - nose[1]) * math.sin(comes.heading[-1])
    assert comes.speed[-1] < 0.5
    assert 0.0 < ahead < 30.0
    assert all(abs(one.seconds) < 1.0 for one in apart(situation, episode).values())


def test_who_was_said_to_come_from_a_distance_is_not_shifted_for_a_meeting() -> None:
    situation = stops_for_a_dog(distance="100 m")
    assert not any(TOGETHER in one for one in rehearsed(build(situation), situation).assumed)


def test_who_comes_the_other_way_is_level_with_who_pulls_out_as_the_ego_is_there() -> None:
    out = {"id": "A", "kind": "van", "starts": {"where": "kerb", "side": "right"}, "does": [{"act": "pull-out"}]}
    bus = {"id": "B", "kind": "bus", "starts": {"where": "oncoming"}, "does": [{"act": "go-along"}]}
    situation = from_plain({"ego": {"speed": "30 mph"}, "others": [out, bus | {"role": "supporting"}]})
    late = apart(situation, driven(build(situation)))
    assert late["B"].seconds > 0.0
    assert late["B"].metres > 8.0 * late["B"].seconds
    assert not apart(situation, driven(rehearsed(build(situation), situation)))


def test_who_is_in_time_by_its_place_is_not_shifted_in_time_as_well(monkeypatch: pytest.MonkeyPatch) -> None:
    program = build(said("pedestrian", "roadside", "cross", side="right")).program
    mine = {one.unit: one for one in program.parameters if "_A_" in one.name}
    assert {"m", "s"} < {*mine}
    late = rehearsal._Tried(  # pyright: ignore[reportPrivateUsage]
        program=program, missing=((),), values=({},), late=({"A": Late(seconds=1.0, metres=2.0)},)
    )
    shifted: list[ScenicProgram] = []

    def in_time(self: Any, program: ScenicProgram, *_: Any) -> Any:
        shifted.append(program)
        return replace(late, program=program, late=({},))

    monkeypatch.setattr(rehearsal._Stage, "nearer", in_time)  # pyright: ignore[reportPrivateUsage]
    stage = rehearsal._Stage.of(build(said("car", "ahead", "brake")), said("car", "ahead", "brake"), 16)  # pyright: ignore[reportPrivateUsage]
    best = rehearsal._together(stage, late, ())  # pyright: ignore[reportPrivateUsage]
    assert [best.program] == shifted


def driven(built: Built) -> Episode:
    """A drive in the middle of all ranges."""
    simulator = load_simulator(resolve_map(built.map), SimulationSettings(simulator="native"))
    episode = simulate(simulator, built.program, scene_at(built.program, 0, 0.5, name="middle"), load_ego("planner"))
    assert isinstance(episode, Episode)
    return episode


def test_a_program_is_the_same_whoever_asks_for_it() -> None:
    written = Situated().read(to_yaml(DOOR), RetrievalSettings())
    runs = Situated().write(written, RetrievalSettings()).program
    assert explain_stated(DOOR).program.source == runs.source
    assert not explain_stated(DOOR).unseen
    assert Situated().write_again(written, None, RetrievalSettings()).source == runs.source


def test_what_no_drive_shows_is_told_with_what_is_seen_instead() -> None:
    far = said("car", "beside", "stand", "open-door", side="left")  # it stands where we will pass it
    (line,) = rehearsed(build(far), far).unseen
    assert re.match(r"none of 16 drives shows others\.A\.starts\.where: said beside, it starts ", line)
    written = Situated().write(Situated().read(to_yaml(far), RetrievalSettings()), RetrievalSettings())
    assert written.left_out[0] == explain_stated(far).unseen[0] == line


def test_what_no_shift_helps_stays_as_it_was_built() -> None:
    cannot = from_plain(
        {
            "others": [
                {
                    "id": "A",
                    "kind": "car",
                    "starts": {"where": "ahead"},
                    "does": [{"act": "stand"}],
                    "count": 1,
                }
            ],
            "contact": {"happens": True, "ego": "rear"},
        }
    )
    built = build(cannot)
    assert rehearsed(built, cannot).program is built.program


def test_nobody_is_shifted_so_near_that_the_drive_is_over_before_all_is_done() -> None:
    comes = {"id": "A", "kind": "van", "starts": {"where": "oncoming-in-our-lane"}, "does": [{"act": "go-along"}]}
    rides = {"id": "B", "kind": "bicycle", "starts": {"where": "behind"}, "does": [{"act": "follow"}]}
    ego = {"speed": "25 km/h", "does": [{"act": "stop"}, {"act": "reverse", "distance": "15 m"}]}
    situation = from_plain({"ego": ego, "others": [comes, rides]})
    built = build(situation)
    assert ranges(rehearsed(built, situation))["OPT_A_Y"].low > 0.7 * ranges(built)["OPT_A_Y"].low


def test_who_turns_across_our_way_may_act_after_the_moment_at_which_the_two_would_meet() -> None:
    truck = {"id": "A", "kind": "truck", "starts": {"where": "oncoming"}, "does": [{"act": "turn-left"}]}
    road, wet = {"kind": "road", "lanes": 2}, {"surface": "wet"}
    situation = from_plain({"ego": {"speed": "110 km/h"}, "road": road, "around": wet, "others": [truck]})
    shifted = rehearsed(build(situation), situation)
    assert ranges(shifted)["OPT_A_LEAD_TIME"].low < 0.0
