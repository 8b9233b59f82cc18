"""The lint catches each kind of broken promise, and the packaged library has none."""

from __future__ import annotations

import re
from collections.abc import Collection
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from chatscene.ego.rule_based import RuleBased
from chatscene.grow.directions import joints
from chatscene.grow.lint import (
    Finding,
    alike,
    check_code,
    implausible,
    refused_code,
    sifted,
    sound_part,
    trials,
    try_joint,
    try_triple,
    unpartnered,
    world_names,
)
from chatscene.library.compatibility import ARMS, compatibility
from chatscene.library.load import Library, load_library
from chatscene.library.snippet_file import names_in
from chatscene.maps.network import resolve_map
from chatscene.settings import SimulationSettings
from chatscene.simulate.simulator import Simulator, load_simulator
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.acts import TURNS, Action
from chatscene.terms.episode import Ending, Episode, Event, EventKind, Role, Track
from chatscene.terms.plan import Foreign
from chatscene.terms.plan_text import plan_of
from chatscene.terms.snippet import Snippet

SHARDS = 2
CROSS = ("behavior/cross", "geometry/straight-road", "spawn/roadside-right")
RIGHT_ON_RED = (
    "behavior/run-light-turn-right-stop",
    "geometry/straight-three-way-side-right-signalised",
    "spawn/crossing-from-right",
)


@pytest.fixture(scope="module")
def simulator() -> Simulator:
    return load_simulator(resolve_map("town"), SimulationSettings())


def few(*ids: str) -> Library:
    library = load_library()
    return Library(tuple(library.get(i) for i in sorted(ids)))


def spoilt(library: Library, snippet: Snippet) -> Library:
    return Library(tuple(snippet if s.id == snippet.id else s for s in library))


def lint(
    library: Library, simulator: Simulator, *, scenes: int = 10, only: Collection[str] | None = None
) -> tuple[Finding, ...]:
    """What `chatscene.grow.curation.lint_library` does with workers, here for any snippets."""
    sound, found = sound_part(library)
    tried: set[str] = set()
    for triple, kind in trials(sound, only):
        tried |= {snippet.id for snippet in triple}
        found |= set(try_triple(triple, kind, simulator, RuleBased(), scenes))
    for joint in joints(sound, only):
        found |= set(try_joint(joint, sound, simulator, RuleBased()))
    return sifted(found | unpartnered(sound, tried) | alike(sound, simulator, RuleBased(), only), only)


def rungs(library: Library, simulator: Simulator) -> set[tuple[str, str]]:
    return {(finding.snippet_id, finding.rung) for finding in lint(library, simulator)}


def with_code(snippet: Snippet, old: str, new: str) -> Snippet:
    assert old in snippet.source
    return replace(snippet, source=snippet.source.replace(old, new))


def arms(spawn: Snippet) -> frozenset[str]:
    return frozenset(ARMS) & set(spawn.requires)


def with_new_words() -> list[Snippet]:
    """Of the packaged snippets those whose code has a word that none before has; numbers are none."""
    seen: set[str] = set()
    found: list[Snippet] = []
    for snippet in load_library():
        words = set(re.findall(r"[A-Za-z_]\w*", snippet.source))
        if not words <= seen:
            found.append(snippet)
            seen |= words
    return found


def test_the_code_of_packaged_snippets_is_sound() -> None:
    # The others are of the same words, in the same families; the command `chatscene library lint` checks each.
    assert [str(finding) for snippet in with_new_words() for finding in check_code(snippet)] == []


def test_three_sound_snippets_have_no_finding(simulator: Simulator) -> None:
    assert lint(few(*CROSS), simulator) == ()


@pytest.mark.parametrize("line", ["advAt = pointsOn(egoRoute, 3)", "x = 1; advLane = 2", "advLane, x = (1, 2)"])
def test_a_name_that_nothing_defines_or_that_is_defined_out_of_sight_is_found(line: str) -> None:
    snippet = few(*CROSS).get(CROSS[0])
    requires, provides = names_in(code := f"{snippet.source}\n{line}\n")
    spoilt = replace(snippet, source=code, requires=requires, provides=provides)
    assert {finding.rung for finding in check_code(spoilt)} == {"names"}


def test_code_that_is_not_scenic_is_found() -> None:
    snippet = replace(few(*CROSS).get(CROSS[0]), source="behavior AdvBehavior(:\n")
    assert {finding.rung for finding in check_code(snippet)} == {"names"}


@pytest.mark.parametrize("value", ["Uniform(1, 2)", "Range(1, 2)", "Normal(1, 2)"])
def test_randomness_outside_of_a_parameter_is_found(value: str) -> None:
    old = "MoveAhead(globalParameters.OPT_ADV_SPEED)"
    snippet = with_code(few(*CROSS).get(CROSS[0]), old, f"MoveAhead(globalParameters.OPT_ADV_SPEED + {value})")
    assert {finding.rung for finding in check_code(snippet)} == {"randomness"}


def test_a_behavior_that_claims_what_it_does_not_show_is_found(simulator: Simulator) -> None:
    library = few(*CROSS)
    behavior = library.get(CROSS[0])
    liar = replace(behavior, slots=replace(behavior.slots, actions=(Action.CROSS, Action.WEAVE)))
    assert rungs(spoilt(library, liar), simulator) == {(CROSS[0], "means")}


def test_a_behavior_that_claims_what_its_plan_cannot_show_is_found_without_a_drive() -> None:
    behavior = few(*CROSS).get(CROSS[0])
    liar = replace(behavior, slots=replace(behavior.slots, actions=(Action.CROSS, Action.REVERSE)))
    assert [str(finding) for finding in check_code(liar)] == [
        "behavior/cross: plan: its actions say reverse, and nothing in its code can show that"
    ]


def test_a_foreign_behavior_is_held_to_everything_but_its_plan(simulator: Simulator) -> None:
    behavior, geometry, spawn = (few(*CROSS).get(part) for part in CROSS)
    foreign = with_code(behavior, "    do MoveAhead(5)", "    wait\n    do MoveAhead(5)")
    assert isinstance(plan_of(foreign), Foreign)
    assert list(check_code(foreign)) == []
    assert list(try_triple((foreign, geometry, spawn), foreign.adversaries[0], simulator, RuleBased(), 2)) == []


def test_a_spawn_on_the_wrong_side_is_found(simulator: Simulator) -> None:
    library = few(*CROSS)
    mislabelled = replace(load_library().get("spawn/roadside-left"), id=CROSS[2], slots=library.get(CROSS[2]).slots)
    assert rungs(spoilt(library, mislabelled), simulator) == {(CROSS[2], "means"), (CROSS[2], "direction")}


def test_a_turn_that_begins_to_the_other_side_is_found_on_the_geometry_where_it_does(simulator: Simulator) -> None:
    sound = few(*RIGHT_ON_RED)
    assert [f for joint in joints(sound) for f in try_joint(joint, sound, simulator, RuleBased())] == []
    # The way out of a side road to the left of the one it comes from.
    behavior = with_code(sound.get(RIGHT_ON_RED[0]), '("straight", "right-turn")', '("straight", "left-turn")')
    library = spoilt(sound, behavior)
    (found,) = [f for joint in joints(library) for f in try_joint(joint, library, simulator, RuleBased())]
    assert (found.snippet_id, found.rung) == (RIGHT_ON_RED[0], "direction")
    assert "said turn-right, it first turns to the other side" in found.message


def test_who_turns_though_it_is_said_to_go_straight_on_is_found(simulator: Simulator) -> None:
    library = few("behavior/junction-fast", "geometry/straight-unsignalised", "spawn/crossing-from-right")
    (joint,) = joints(library)
    assert list(try_joint(joint, library, simulator, RuleBased())) == []
    turning = with_code(library.get("behavior/junction-fast"), '"straight"', '"left-turn"')
    (found,) = try_joint(joint, spoilt(library, turning), simulator, RuleBased())
    assert found.rung == "direction"
    assert "said straight on, it turns by" in found.message


@pytest.mark.parametrize(
    ("snippet_id", "renamed", "word"),
    [
        ("behavior/junction-turn-left", "behavior/junction-turn-right", "turn-right"),
        ("behavior/oncoming-drive", "behavior/lead-drive", "lead"),
        ("spawn/crossing-from-left", "spawn/crossing-from-right", "right"),
        ("spawn/oncoming-lane", "spawn/ahead-lane", "ahead"),
        ("geometry/left-turn-three-way", "geometry/right-turn-three-way", "right-turn"),
        ("geometry/left-turn-three-way", "geometry/left-turn-four-way", "four-way"),
    ],
)
def test_a_name_that_says_another_direction_than_the_facts_is_found(snippet_id: str, renamed: str, word: str) -> None:
    (found,) = check_code(replace(load_library().get(snippet_id), id=renamed))
    assert found.rung == "direction"
    assert f"its name says {word}" in found.message


def test_a_behavior_that_says_straight_on_and_would_turn_as_well_is_found() -> None:
    snippet = load_library().get("behavior/junction-cross")
    (found,) = check_code(with_code(snippet, '"straight"', '("straight", "left-turn")'))
    assert found.rung == "direction"


def test_every_behavior_that_turns_is_tried_on_every_geometry_and_arm_it_joins() -> None:
    library = load_library()
    every = compatibility(library)
    tried = {(joint.ids[0], joint.ids[1], arms(library.get(joint.ids[2]))) for joint in joints(library) if joint.acts}
    for b, behavior in enumerate(every.behaviors):
        if set(TURNS) & set(behavior.slots.actions):
            for g, s in np.argwhere(every.mask[b]).tolist():
                assert (behavior.id, every.geometries[g].id, arms(every.spawns[s])) in tried


def test_every_spawn_is_looked_at_on_every_geometry_it_joins() -> None:
    library = load_library()
    every = compatibility(library)
    tried = {joint.ids[1:] for joint in joints(library)}
    for g, s in np.argwhere(every.mask.any(axis=0)).tolist():
        assert (every.geometries[g].id, every.spawns[s].id) in tried


def test_a_behavior_that_fails_while_it_runs_is_found(simulator: Simulator) -> None:
    library = few(*CROSS)
    broken = with_code(library.get(CROSS[0]), "MoveAhead(globalParameters.OPT_ADV_SPEED)", "MoveAhead('fast')")
    found = rungs(spoilt(library, broken), simulator)
    assert (CROSS[0], "runs") in found


def test_a_spawn_that_overlaps_the_ego_is_found(simulator: Simulator) -> None:
    library = few(*CROSS)
    spawn = library.get(CROSS[2])
    inside = with_code(spawn, "besideRoad(egoRoute, advLevel, \"right\", globalParameters.OPT_GEO_X)",
                       "pointOn(egoRoute, 0 * globalParameters.OPT_GEO_Y, 0 * globalParameters.OPT_GEO_X)")  # fmt: skip
    assert (CROSS[2], "samples") in rungs(spoilt(library, inside), simulator)


def test_a_snippet_that_nothing_fits_is_found(simulator: Simulator) -> None:
    found = rungs(few(*CROSS, "behavior/match-leader"), simulator)
    assert found == {("behavior/match-leader", "partners")}


def test_trials_cover_the_library_and_every_kind_of_adversary() -> None:
    library = load_library()
    tried = list(trials(library))
    joined = {part.id for triple, _ in tried for part in triple}
    there = {snippet.id for snippet in library if snippet.slots.site is None}  # the town has no sites
    composed = {s.id for s in library if "advStill" in s.requires} | {"spawn/on-foot-ahead"}
    assert joined == there - composed
    acted = {(triple[0].id, kind) for triple, kind in tried}
    assert acted >= {(s.id, kind) for s in library if s.component.value == "behavior" for kind in s.adversaries}


def test_the_world_model_names_what_snippets_build_on() -> None:
    assert {"DrivePath", "pointOn", "network", "globalParameters", "abs", "Pedestrian"} <= world_names()
    assert "egoRoute" not in world_names()


def track(name: str, role: Role, kind: str, x: NDArray[Any], speed: NDArray[Any]) -> Track:
    still = np.zeros_like(x)
    return Track(actor=name, role=role, kind=kind, length=4.9, width=2.1, x=x, y=still, heading=still, speed=speed)


def episode(*tracks: Track) -> Episode:
    steps = len(tracks[0].x)
    return Episode(
        scene_id="s",
        ego="e",
        dt=0.1,
        tracks=tracks,
        events=(),
        signals=(),
        ending=Ending.TIMEOUT,
        route_completion=0.0,
        distance_to_route=np.zeros(steps),
        off_road=np.zeros(steps, bool),
    )


def test_a_car_that_drives_through_another_is_implausible() -> None:
    x = np.linspace(-20.0, 20.0, 41)
    car = track("adversary", Role.ADVERSARY, "Car", x, np.full(41, 10.0))
    blocker = track("blocker", Role.OCCLUDER, "Car", np.zeros(41), np.zeros(41))
    assert list(implausible(episode(car, blocker))) == ["the Car goes through the blocker"]


def test_what_would_come_after_a_crash_with_the_ego_is_not_looked_at() -> None:
    x = np.linspace(-20.0, 20.0, 41)
    car = track("adversary", Role.ADVERSARY, "Car", x, np.full(41, 10.0))
    blocker = track("blocker", Role.OCCLUDER, "Car", np.zeros(41), np.zeros(41))
    crashed = replace(episode(car, blocker), events=(Event(kind=EventKind.COLLISION, step=10),))
    assert list(implausible(crashed)) == []


@pytest.mark.parametrize(("speed", "word"), [(np.array([0.0, 5.0, 5.0]), "accelerates"), (np.full(3, 30.0), "reaches")])
def test_a_car_beyond_its_limits_is_implausible(speed: NDArray[Any], word: str) -> None:
    (problem,) = implausible(episode(track("adversary", Role.ADVERSARY, "Car", np.zeros(3), speed)))
    assert word in problem


def telling() -> list[tuple[tuple[Snippet, Snippet, Snippet], AdversaryKind]]:
    """Of the trials those with a kind, or a set of steps, that is new; geometries and spawns are tried elsewhere."""
    seen: set[object] = set()
    found: list[tuple[tuple[Snippet, Snippet, Snippet], AdversaryKind]] = []
    for triple, kind in trials(load_library()):
        new = {frozenset(re.findall(r"\bdo (\w+)", triple[0].source)), kind}
        if not new <= seen:
            found.append((triple, kind))
            seen |= new
    return found


@pytest.mark.parametrize("part", range(SHARDS))
def test_programs_with_all_sets_of_steps_and_all_kinds_run_and_move_plausibly(part: int, simulator: Simulator) -> None:
    # One scene each: that behaviors with other numbers do too, and that nine of ten scenes mean what they say, is shown
    # by the command `chatscene library lint`, which takes minutes.
    tried = telling()[part::SHARDS]
    found = [f for triple, kind in tried for f in try_triple(triple, kind, simulator, RuleBased(), scenes=1)]
    assert [str(f) for f in found if f.rung in ("runs", "plausible")] == []


def test_a_copy_under_another_name_is_found_on_the_tracks(simulator: Simulator) -> None:
    library = few(*CROSS, "behavior/dash")
    # Another plan, so that only the tracks show it.
    other = with_code(library.get(CROSS[0]), "MoveAhead(5)", "MoveAhead(5.01)")
    copy = replace(other, id="behavior/walk-over", description="Somebody walks over.")
    found = lint(Library((*library, copy)), simulator, scenes=1)
    assert {(f.snippet_id, f.rung) for f in found} == {(CROSS[0], "distinct"), ("behavior/walk-over", "distinct")}


def test_only_the_snippets_asked_for_are_checked(simulator: Simulator) -> None:
    library = few(*CROSS)
    broken = with_code(library.get(CROSS[0]), "MoveAhead(globalParameters.OPT_ADV_SPEED)", "MoveAhead('fast')")
    assert lint(spoilt(library, broken), simulator, scenes=1, only={CROSS[1]}) == ()


def test_no_snippet_names_a_simulator_or_looks_with_the_eyes_of_scenic() -> None:
    for snippet in load_library():
        assert "carla" not in snippet.source.casefold(), snippet.id
        assert "can see" not in snippet.source, snippet.id


def test_a_mistake_in_a_snippet_is_shown_by_the_line_of_its_file(tmp_path: Path) -> None:
    (tmp_path / "behavior").mkdir()
    (tmp_path / "behavior" / "mine.scenic").write_text(
        '#: description = "The pedestrian waits."\n#: adversaries = ["pedestrian"]\n#: origin = "my own idea"\n'
        '#: [slots]\n#: actions = ["stop"]\n\nbehavior AdvBehavior():\n    do Hallt() for 3 seconds\n'
    )
    library = load_library(tmp_path)
    (finding,) = refused_code(library.get("behavior/mine"), library)
    assert finding.message == (
        "line 8: the name Hallt: neither the program nor the world model defines it; did you mean Halt?\n"
        "    do Hallt() for 3 seconds\n"
        "       ^^^^^"
    )
