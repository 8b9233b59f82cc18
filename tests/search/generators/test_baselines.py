"""Each baseline makes a program that runs on the routes of ChatScene, and finds the answer where there is one."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from chatscene.ego.policy import load_ego
from chatscene.ego.rule_based import RuleBased
from chatscene.errors import SettingsError, SnippetError
from chatscene.library.compatibility import incompatibility
from chatscene.library.load import load_library
from chatscene.maps.network import resolve_map
from chatscene.measure.drive import Ran
from chatscene.program.check import check
from chatscene.program.sample import scene_at
from chatscene.search import explore as exploring
from chatscene.search.climb import simulator_of
from chatscene.search.explore import Block
from chatscene.search.generator import load_generator
from chatscene.search.generators.baselines.nominal import NOMINAL, Baseline
from chatscene.search.generators.baselines.random_triple import RandomTriple
from chatscene.settings import PAPER, RetrievalSettings, SearchSettings, Settings, SimulationSettings
from chatscene.simulate.simulator import load_simulator, simulate
from chatscene.terms.episode import Episode
from chatscene.terms.plan_text import parse_plan
from chatscene.terms.scenario import BaseScenario, Slots
from chatscene.terms.scene import Scene, ScenicProgram
from fake_run import block

NAMES = ("learning-to-collide", "advsim", "adversarial-trajectory", "carla-scenario-generator", "reactive")
SETTINGS = RetrievalSettings()
CRASHED = next(ran for ran in block(0).ran if ran.episode.collision is not None)
MISSED = next(ran for ran in block(0).ran if ran.episode.collision is None)
Shares = Mapping[str, float]


def program_of(name: str, base: BaseScenario) -> ScenicProgram:
    generator = load_generator(name)
    return generator.write(generator.read(generator.texts(base)[0], SETTINGS), SETTINGS).program


def searched(
    name: str, farness: Callable[[Shares], float], monkeypatch: pytest.MonkeyPatch, *, blocks: int, seed: int = 0
) -> list[Block]:
    """The search of a baseline in a world where a scene collides if its values are close enough to an answer.

    `farness` tells by the places of the values in their ranges, in [0, 1], how far from colliding they are; 0 is a hit.
    """
    program = program_of(name, BaseScenario.CROSSING_NEGOTIATION)

    def drive(scene: Scene) -> Ran:
        shares = {p.name: (scene.values[p.name] - p.low) / (p.high - p.low) for p in program.parameters}
        away = farness(shares)
        if away <= 0.0:
            return replace(CRASHED, scene=scene)
        return replace(MISSED, scene=scene, criticality=replace(MISSED.criticality, distance=10.0 * away))

    def drive_all(_program: ScenicProgram, _slots: Slots, scenes: Sequence[Scene], **_: object) -> list[Ran]:
        return [drive(scene) for scene in scenes]

    monkeypatch.setattr(exploring, "drive_all", drive_all)
    return list(
        load_generator(name).explore(
            program,
            Slots(),
            0,
            simulator=SimpleNamespace(),  # type: ignore[arg-type]
            ego=RuleBased(),
            settings=replace(PAPER, scenes=10 * blocks, block=10, seed=seed),
            done=(),
        )
    )


def hits(blocks: list[Block]) -> float:
    """Share of scenes that collided."""
    return float(np.mean([ran.episode.collision is not None for each in blocks for ran in each.ran]))


def fast_and_late(shares: Shares) -> float:
    """Hits where the speed is in its upper third and the trigger in its lower."""
    return max(0.0, 0.67 - shares["OPT_ADV_SPEED"]) + max(0.0, shares["OPT_ADV_DISTANCE"] - 0.33)


def first_fast_then_slow(shares: Shares) -> float:
    """Hits where the profile starts high and goes on low; the tail does not matter."""
    profile = [share for _, share in sorted(shares.items())]
    return max(0.0, 0.8 - float(np.mean(profile[:3]))) + max(0.0, float(np.mean(profile[3:6])) - 0.2)


@pytest.mark.parametrize(
    ("name", "farness", "wanted"),
    [
        ("learning-to-collide", fast_and_late, 0.6),
        ("advsim", first_fast_then_slow, 0.4),
        ("adversarial-trajectory", first_fast_then_slow, 0.4),
    ],
)
def test_a_baseline_that_learns_finds_the_answer_and_stays_there(
    name: str, farness: Callable[[Shares], float], wanted: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    found = searched(name, farness, monkeypatch, blocks=30)
    assert hits(found[:2]) < 0.3
    assert hits(found[-5:]) > wanted


def test_the_grid_reaches_every_corner_of_its_ranges_with_ten_scenes(monkeypatch: pytest.MonkeyPatch) -> None:
    (first,) = searched("carla-scenario-generator", fast_and_late, monkeypatch, blocks=1)
    assert 0.0 < hits([first]) < 0.5


@pytest.mark.parametrize("name", NAMES)
def test_a_baseline_is_determined_by_its_seed(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    one, same = (searched(name, lambda _: 1.0, monkeypatch, blocks=3) for _ in range(2))
    assert [ran.scene for each in one for ran in each.ran] == [ran.scene for each in same for ran in each.ran]


@pytest.mark.parametrize("base", list(BaseScenario))
@pytest.mark.parametrize("name", NAMES)
def test_a_baselines_program_climbs_the_ladder_on_every_base_scenario(name: str, base: BaseScenario) -> None:
    simulator = simulator_of(load_generator(name), resolve_map("town"), Settings())
    program = program_of(name, base)
    checked = check(program, Slots(), simulator, RuleBased(), drives=1)
    assert checked.episodes[0].adversaries
    assert simulator.routes(program) >= 10


def test_what_a_baseline_varies_is_its_own() -> None:
    varied = {name: {p.name for p in program_of(name, BaseScenario.STRAIGHT_OBSTACLE).parameters} for name in NAMES}
    assert varied["learning-to-collide"] == {
        "OPT_ADV_DISTANCE", "OPT_ADV_SPEED", "OPT_ADV_TURN", "OPT_GEO_X", "OPT_GEO_Y",
    }  # fmt: skip
    assert varied["carla-scenario-generator"] == {"OPT_ADV_DISTANCE", "OPT_ADV_SPEED"}
    assert varied["advsim"] == {f"OPT_SPEED_{i:02d}" for i in range(20)}
    assert varied["adversarial-trajectory"] == {f"OPT_OFFSET_{i:02d}" for i in range(20)}
    assert varied["reactive"] == {"OPT_ADV_DISTANCE", "OPT_ADV_TOP", "OPT_ADV_LATE"}


@pytest.mark.parametrize("base", list(BaseScenario))
@pytest.mark.parametrize("name", ["learning-to-collide", "adversarial-trajectory"])
def test_what_safebench_varies_is_beside_ours(name: str, base: BaseScenario) -> None:
    ours, cited = ({p.name: p for p in program_of(n, base).parameters} for n in (name, f"{name}-safebench"))
    assert list(ours) == list(cited)
    told = NOMINAL[base].cited
    if name == "adversarial-trajectory":
        assert {p.high for p in cited.values()} == {told.offset} == {-p.low for p in cited.values()}
        assert f"< {told.trigger:g}" in program_of(f"{name}-safebench", base).source
    else:
        assert (cited["OPT_ADV_DISTANCE"].low, cited["OPT_ADV_DISTANCE"].high) == told.triggers
        assert (cited["OPT_ADV_SPEED"].low, cited["OPT_ADV_SPEED"].high) == told.speeds
        source = program_of(f"{name}-safebench", base).source
        assert all(f"param {p.name} = Range({p.low:g}, {p.high:g})" in source for p in cited.values())
        starts = [p for p in cited.values() if p.name.startswith("OPT_GEO")]
        assert all(p.high - p.low <= 2 * told.start for p in starts if told.start is not None)
        assert all(ours[p.name].low <= p.low < p.high <= ours[p.name].high for p in starts)


@pytest.mark.parametrize("base", [BaseScenario.VEHICLE_PASSING, BaseScenario.RIGHT_TURN])
@pytest.mark.parametrize("name", ["learning-to-collide-safebench", "adversarial-trajectory-safebench"])
def test_within_safebenchs_ranges_it_climbs_the_ladder_too(name: str, base: BaseScenario) -> None:
    simulator = simulator_of(load_generator(name), resolve_map("town"), Settings())
    assert check(program_of(name, base), Slots(), simulator, RuleBased(), drives=1).episodes[0].adversaries


@pytest.mark.parametrize("name", NAMES)
def test_what_a_baselines_adversary_does_is_a_plan_but_where_it_has_no_path_to_be_beside(name: str) -> None:
    for base, nominal in NOMINAL.items():
        told = re.search(r"^behavior AdvBehavior\(\):\n(?:    .*\n|\n)*", program_of(name, base).source, re.MULTILINE)
        assert told is not None
        if name == "adversarial-trajectory" and not nominal.path:
            with pytest.raises(SnippetError):
                parse_plan(told[0])
        else:
            assert parse_plan(told[0]).phases


def _reacted(base: BaseScenario, ego: str, **values: float) -> Episode:
    """What becomes of an adversary that reacts, and may go as fast as it likes."""
    program = program_of("reactive", base)
    scene = scene_at(program, 0, 0.5, name="reacts")
    scene = replace(scene, values={**scene.values, "OPT_ADV_TOP": 2.0, **values})
    episode = simulate(load_simulator(resolve_map("town"), SimulationSettings()), program, scene, load_ego(ego))
    assert isinstance(episode, Episode)
    return episode


@pytest.mark.parametrize("ego", ["sac", "rule-based"])
def test_an_adversary_that_reacts_is_there_when_the_ego_is_however_fast_that_drives(ego: str) -> None:
    episode = _reacted(BaseScenario.CROSSING_NEGOTIATION, ego, OPT_ADV_LATE=0.0)
    assert episode.collision is not None
    assert episode.collision.other == episode.adversaries[0].actor


def test_an_adversary_that_reacts_goes_on_as_it_does_once_the_careful_driver_cannot_stop_any_more() -> None:
    episode = _reacted(BaseScenario.CROSSING_NEGOTIATION, "sac", OPT_ADV_LATE=0.0)
    (adversary,) = episode.adversaries
    speeds = adversary.speed[episode.ego_track.speed > 7]
    assert episode.collision is not None
    assert np.ptp(speeds[-15:]) < 0.05 < np.ptp(speeds[:-15])


def test_an_adversary_that_comes_toward_the_ego_stops_short_of_one_that_stops() -> None:
    episode = _reacted(BaseScenario.VEHICLE_PASSING, "idm", OPT_ADV_SHARE=1.0)
    assert episode.collision is None
    assert episode.adversaries[0].speed.max() > 7
    assert episode.adversaries[0].speed[-1] < 0.1


@pytest.mark.parametrize(("name", "objective"), [("reactive", "avoidable"), ("advsim", "collision")])
def test_only_an_adversary_that_reacts_is_searched_for_avoidable_crashes_whatever_the_settings_are_after(
    name: str, objective: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked: list[str] = []

    def explore(*_: object, settings: SearchSettings, **__: object) -> list[Block]:
        asked.append(settings.objective)
        return []

    monkeypatch.setattr(exploring, "explore", explore)
    searched(name, lambda _: 1.0, monkeypatch, blocks=1)
    assert asked == [objective]


def test_random_triples_are_five_a_base_scenario_determined_by_their_text_and_joinable_by_anybody() -> None:
    generator, library = load_generator("random-triple"), load_library()
    assert isinstance(generator, RandomTriple)
    drawn: set[tuple[str, str]] = set()
    for base, nominal in NOMINAL.items():
        for text in generator.texts(base):
            scenario = generator.read(text, SETTINGS)
            behavior, geometry, spawn = generator.triple(scenario, nominal)
            assert generator.triple(scenario, nominal) == (behavior, geometry, spawn)
            assert incompatibility(behavior, library.get(f"geometry/{nominal.geometry}"), spawn) is None
            assert nominal.adversary in {*behavior.adversaries} & {*spawn.adversaries}
            drawn.add((behavior.id, spawn.id))
            assert geometry.id == f"geometry/{nominal.geometry}"
    assert len(drawn) > 35


def test_a_random_triple_climbs_the_ladder() -> None:
    simulator = simulator_of(load_generator("random-triple"), resolve_map("town"), Settings())
    checked = check(program_of("random-triple", BaseScenario.RIGHT_TURN), Slots(), simulator, RuleBased(), drives=1)
    assert checked.episodes[0].adversaries


def test_baselines_drive_where_chatscene_drives() -> None:
    chatscene = load_generator("chatscene")
    for base, nominal in NOMINAL.items():
        programs = [chatscene.write(chatscene.read(text, SETTINGS), SETTINGS).program for text in chatscene.texts(base)]
        assert f"geometry/{nominal.geometry}" in {program.snippet_ids[1] for program in programs}


def test_a_sentence_is_no_scenario_of_a_baseline() -> None:
    generator = load_generator("advsim")
    assert isinstance(generator, Baseline)
    with pytest.raises(SettingsError, match="such as 'AdvSim: straight-obstacle'"):
        generator.read("A car brakes.", SETTINGS)
