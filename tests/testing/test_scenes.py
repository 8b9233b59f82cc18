"""A sentence, or what a run keeps, as tests of an ego under pytest."""

from __future__ import annotations

import re
import xml.etree.ElementTree as Xml
from collections.abc import Iterator
from dataclasses import replace
from importlib.metadata import entry_points
from pathlib import Path

import pytest

import chatscene
from chatscene.ego.observation import Observation
from chatscene.ego.policy import load_ego
from chatscene.errors import SettingsError
from chatscene.maps.network import resolve_map
from chatscene.program.sample import scene_at
from chatscene.report.understood import understand
from chatscene.settings import SimulationSettings
from chatscene.simulate.simulator import load_simulator, simulate
from chatscene.terms.criticality import Fault
from chatscene.terms.episode import Episode, Role
from chatscene.terms.scene import Scene, ScenicProgram
from chatscene.testing import scenes
from chatscene.testing.scenes import Asked, find, judge
from chatscene.testing.solvable import NOTHING, Unfit, solvable, twins, without_adversary
from places import ROOT

pytest_plugins = ["pytester"]

BRAKING = "the car ahead brakes hard"
CHILD = "A child runs out from behind a parked van on the right."
PAGE = (ROOT / "docs" / "testing.md").read_text(encoding="utf-8")
(EXAMPLE,) = re.findall(r"```python\n(.*?)```", PAGE, re.DOTALL)


def run(pytester: pytest.Pytester, code: str, *arguments: str) -> pytest.RunResult:
    """What pytest makes of some tests, with the plugin as pytest finds it where the package is installed."""
    pytester.makepyfile(test_egos=code)
    installed = any(entry.name == "chatscene" for entry in entry_points(group="pytest11"))
    plugin = () if installed else ("-p", "chatscene.pytest_plugin")
    return pytester.runpytest_inprocess(*plugin, "-p", "no:randomly", "-p", "no:cacheprovider", *arguments)


@pytest.fixture(scope="module")
def braking() -> Iterator[scenes.Found]:
    yield find(Asked(of=BRAKING, scenes=2))


def test_the_example_of_the_page_drives_fails_what_stands_and_says_all_of_it(pytester: pytest.Pytester) -> None:
    done = run(pytester, EXAMPLE, "--junitxml", "scenes.xml", "--scene-replays", "replays")
    done.assert_outcomes(passed=4, failed=2)
    done.stdout.fnmatch_lines(
        [
            "In the harmless twin the ego does not get on: it came 17 % of its way in * s; the driver that survives *",
            f"  sentence  {BRAKING}",
            "  scene     the-car-ahead-brakes-*/route-*/scene-* (its seed *)",
            "  values    A_BRAKE*=*, A_STEADY=*, A_Y=*",
            "  ego       Stands",
            "  survived  by idm; whoever does not react crashes at * m/s after * s",
            "  twin      the same place and start, but the adversary never begins its act",
            "  again     pytest 'test_egos.py::test_standing_is_no_driving[[]scene-0]'",
            "  replay    replays/test_egos-test_standing_is_no_driving[[]scene-0].gif",
            "*= scenes =*",
            f"4 passed, 2 failed: {BRAKING}",
        ],
        consecutive=False,
    )
    assert sorted(path.read_bytes()[:3] for path in (pytester.path / "replays").iterdir()) == [b"GIF", b"GIF"]
    cases = Xml.parse(pytester.path / "scenes.xml").getroot().iter("testcase")
    told = [{one.get("name"): one.get("value") for one in case.iter("property")} for case in cases]
    named = set(re.findall(r"`(\w+)`", PAGE.split("has the properties ")[1].split("\n")[0]))
    assert all(named - {"replay"} <= set(one) for one in told)
    assert [one["verdict"] for one in told] == ["passed", "passed", "failed", "failed", "passed", "passed"]
    assert {one["sentence"] for one in told} == {BRAKING}


def test_an_ego_that_raises_fails_its_test_with_its_own_traceback(pytester: pytest.Pytester) -> None:
    code = f"""
        import chatscene
        class Raises:
            def act(self, observation):
                raise ValueError("no map")
        @chatscene.scene({BRAKING!r}, ego=Raises, scenes=2)
        def test_it(): ...
    """
    done = run(pytester, code, "-k", "scene-0")
    done.assert_outcomes(failed=1, deselected=1)
    done.stdout.fnmatch_lines(
        ["E * ValueError: no map", "*EgoError: the ego 'Raises' fails at step 0 of scene *: *", "1 failed: *"]
    )


def test_the_ego_may_be_a_fixture_and_the_body_runs_after_a_verdict_that_is_good(pytester: pytest.Pytester) -> None:
    code = f"""
        import pytest
        import chatscene
        @pytest.fixture
        def ego():
            return chatscene.load_ego("idm")
        @chatscene.scene({BRAKING!r}, scenes=2)
        def test_it(scene):
            assert scene.ego == "somebody else"
        def test_without_scenes(scene): ...
    """
    done = run(pytester, code)
    done.assert_outcomes(failed=2, errors=1)
    done.stdout.fnmatch_lines(["*the fixture `scene` is for tests that are marked with @chatscene.scene*"])
    done.stdout.fnmatch_lines(["E *assert 'idm' == 'somebody else'"])


def test_what_holds_no_test_is_an_error_and_what_holds_fewer_skips_the_rest(
    pytester: pytest.Pytester, monkeypatch: pytest.MonkeyPatch, braking: scenes.Found
) -> None:
    def fewer(asked: Asked) -> scenes.Found:
        kept = braking.scenes[: 1 if asked.of == BRAKING else 0]
        return replace(braking, text=str(asked.of), scenes=kept, unfit={NOTHING: 9})

    monkeypatch.setattr(scenes, "find", fewer)
    code = f"""
        import chatscene
        @chatscene.scene({BRAKING!r}, ego="idm", scenes=2)
        def test_one(): ...
        @chatscene.scene("nobody survives", ego="idm", scenes=1)
        def test_none(): ...
    """
    done = run(pytester, code, "-rs")
    done.assert_outcomes(passed=1, skipped=1, errors=1)
    done.stdout.fnmatch_lines(
        [
            f"nothing is tested: of 9 scenes of 'nobody survives' 0 are tests; 9 times {NOTHING}",
            f"1 passed, 1 skipped: {BRAKING}",
            "1 error: nobody survives",
            f"SKIPPED * of 10 scenes of {BRAKING!r} 1 are tests; 9 times {NOTHING}",
        ]
    )


def test_a_sentence_that_is_refused_is_an_error_that_says_why(pytester: pytest.Pytester) -> None:
    code = """
        import chatscene
        @chatscene.scene("blue cheese is on the moon", ego="idm", scenes=1)
        def test_it(): ...
    """
    done = run(pytester, code)
    done.assert_outcomes(errors=1)
    done.stdout.fnmatch_lines(["there are no scenes of 'blue cheese is on the moon': *tells no dangerous traffic *"])


def test_the_same_scenes_are_found_again_and_the_verdict_is_the_same(braking: scenes.Found) -> None:
    again = find(Asked(of=BRAKING, scenes=1))  # in a simulator of its own
    first, second = (found.scenes[0] for found in (braking, again))
    assert (first.scene, first.twin) == (second.scene, second.twin)
    one, other = (judge(found, second, load_ego("planner")) for found in (braking, again))
    assert one.properties == other.properties
    assert find(Asked(of=BRAKING, scenes=1, seed=1)).scenes[0].scene.seed != first.scene.seed


def test_in_each_scene_whoever_does_not_react_crashes_and_in_its_twin_nobody_need_react(braking: scenes.Found) -> None:
    assert len({one.scene.route for one in braking.scenes}) == 2
    for one in braking.scenes:
        assert one.survivor == "idm"
        assert one.oblivious.collision is not None
        driven = judge(braking, one, load_ego("idm"))
        assert not driven.failures
        assert driven.episode.adversaries[0].x[0] == driven.twin.adversaries[0].x[0]
        assert driven.episode.ego_track.x[0] == driven.twin.ego_track.x[0]
        assert driven.twin.completion == pytest.approx(1.0, abs=0.01)


def test_who_must_run_into_nobody_may_be_run_into(braking: scenes.Found, monkeypatch: pytest.MonkeyPatch) -> None:
    class Full:
        """Drives on, whoever is there."""

        def act(self, observation: Observation) -> tuple[float, float]:
            return 0.4, 0.0

    one = braking.scenes[0]
    crashed = judge(braking, one, Full(), must="no-fault")
    assert re.match(r"The ego runs into the car after \d+\.\d s, at ", crashed.failures[0])

    def by_the_other(_: Episode) -> Fault:
        return Fault.ADVERSARY_INTO_EGO

    monkeypatch.setattr(scenes, "fault", by_the_other)
    assert judge(braking, one, Full()).failures[0].startswith("The car runs into the ego after ")
    assert not [said for said in judge(braking, one, Full(), must="no-fault").failures if "twin" not in said]


def test_a_word_for_must_that_there_is_not_and_no_scenes_are_refused_where_they_are_written() -> None:
    with pytest.raises(SettingsError, match="avoid"):
        chatscene.scene(BRAKING, ego="idm", must="avoyd")
    with pytest.raises(SettingsError, match="at least 1"):
        chatscene.scene(BRAKING, ego="idm", scenes=0)


@pytest.mark.parametrize(
    ("text", "first"),
    [
        (CHILD, "    do Halt()\n"),
        (BRAKING, "    do KeepStation(advTrajectory, ego)\n"),
    ],
)
def test_the_nearest_twin_is_one_that_stays_in_its_first_phase(text: str, first: str) -> None:
    program = understand(text).program
    nearest, *others = twins(program)
    assert nearest.told == "never begins its act"
    before, after = program.source.split("behavior AdvBehavior():\n")
    assert nearest.program.source.startswith(f"{before}behavior AdvBehavior():\n")
    assert f"behavior AdvBehavior():\n{first}\n## geometry" in re.sub(r"    #.*\n", "", nearest.program.source)
    assert nearest.program.source.split("## geometry")[1] == after.split("## geometry")[1]
    assert others[-1].told == "is not there"
    assert len({twin.program.digest for twin in (nearest, *others)} | {program.digest}) == len(others) + 2


def test_without_the_adversary_all_others_stay_where_they_are() -> None:
    program, scene = child()
    away = without_adversary(program)
    assert away is not None
    simulator = load_simulator(resolve_map("town"), SimulationSettings(simulator="native"))
    with_it, without = (simulate(simulator, one, scene, load_ego("idm")) for one in (program, away))
    assert isinstance(with_it, Episode)
    assert isinstance(without, Episode)
    assert [track.actor for track in with_it.tracks] == [track.actor for track in without.tracks]
    for here, there in zip(with_it.tracks, without.tracks, strict=True):
        assert bool(here.x[0] == there.x[0]) == (here.role is not Role.ADVERSARY)
    assert abs(without.adversaries[0].x[0]) > 10_000


def test_a_program_that_calls_nobody_the_adversary_has_no_twin() -> None:
    program = ScenicProgram(scenario_id="own", source="ego = new Car\n", parameters=(), snippet_ids=())
    assert twins(program) == ()
    simulator = load_simulator(resolve_map("town"), SimulationSettings())
    found = solvable(program, child()[1], simulator)
    assert isinstance(found, Unfit)
    assert "no twin" in found.reason


def test_the_kept_scenes_of_a_run_are_tests(pytester: pytest.Pytester, tmp_path: Path) -> None:
    kept = chatscene.run(BRAKING, tmp_path / "run", ego="rule-based", scenes=2, simulator="native")
    code = f"""
        from pathlib import Path
        import chatscene
        @chatscene.scene(Path({str(kept.folder)!r}), ego="idm", scenes=2)
        def test_kept(scene):
            assert scene.text == {BRAKING!r}
        @chatscene.scene(chatscene.Run({str(kept.folder)!r}), ego="idm", scene_id={kept.best.id!r}, scenes=1)
        def test_best(scene):
            assert scene.scene.id == {kept.best.id!r}
        @chatscene.scene(Path({str(kept.folder)!r}), ego="idm", scene_id="none", scenes=1)
        def test_missing(): ...
    """
    done = run(pytester, code)
    done.assert_outcomes(passed=3, errors=1)
    done.stdout.fnmatch_lines(["*has no scene 'none' that was driven"])


def test_the_workflow_of_the_page_runs_what_pytest_and_the_plugin_know() -> None:
    (line,) = re.findall(r"- run: (pytest .*)", PAGE)
    options = set(re.findall(r"--[a-z-]+", line))
    assert options == {"--dist", "--junitxml", "--scene-replays"}
    plugin = (ROOT / "src" / "chatscene" / "pytest_plugin.py").read_text(encoding="utf-8")
    assert '"--scene-replays"' in plugin


def test_nothing_but_pytest_is_loaded_with_the_plugin(pytester: pytest.Pytester) -> None:
    code = """
        import sys
        import chatscene.pytest_plugin
        assert not {"numpy", "scenic", "pydantic", "chatscene.testing"} & set(sys.modules)
    """
    assert pytester.runpython(pytester.makepyfile(loaded=code)).ret == 0


def child() -> tuple[ScenicProgram, Scene]:
    """A child behind a van."""
    program = understand(CHILD).program
    return program, scene_at(program, 0, 0.5, name="child")
