"""From a sentence to a program that means it: our own sentences by golden file, the paper's forty by outcome."""

import itertools
import json
import re
import subprocess
import sys
from pathlib import Path

import pytest

import chatscene
from chatscene import pipeline, runs
from chatscene.ego.rule_based import RuleBased
from chatscene.errors import MeansSomethingElse, NamesNotClosed, NothingFits, Unsatisfiable
from chatscene.library.load import load_library
from chatscene.maps.network import resolve_map
from chatscene.program.assemble import assemble
from chatscene.program.check import check, probe_scenes
from chatscene.report import animation
from chatscene.report.summary import Summary, stepped_in_words
from chatscene.runs import working
from chatscene.runs.progress import Slowly
from chatscene.settings import SearchSettings, Settings, SimulationSettings
from chatscene.simulate.simulator import Simulator, load_simulator
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.scenario import Slots
from chatscene.terms.scene import ScenicProgram
from outright import decompose
from places import GOLDEN, SHARED
from plainly import STOPS

SENTENCES = {
    "stops": STOPS,
    "red-light": "We drive straight when a truck from the left runs the red light and brakes.",
    "lane-change": "While we change to the left lane, a motorcycle ahead in that lane brakes hard.",
}
PAPER = SHARED / "data" / "paper_descriptions.json"


@pytest.fixture(scope="module")
def simulator() -> Simulator:
    return load_simulator(resolve_map("town"), SimulationSettings())


@pytest.mark.parametrize("name", SENTENCES)
def test_a_sentence_makes_the_program_in_its_golden_file(name: str) -> None:
    """To accept a change: write ``understand(SENTENCES[name]).program.source`` into the file and read the diff."""
    assert pipeline.understand(SENTENCES[name]).program.source == (GOLDEN / f"{name}.scenic").read_text()


@pytest.mark.parametrize("name", SENTENCES)
def test_a_golden_program_means_its_sentence(name: str, simulator: Simulator) -> None:
    understood = pipeline.understand(SENTENCES[name])
    checked = check(understood.program, understood.scenario.slots, simulator, RuleBased())
    assert len(checked.episodes) == 3


def test_the_stock_scenic_command_compiles_and_runs_a_program() -> None:
    scenic = Path(sys.executable).with_name("scenic")
    command = [str(scenic), "--2d", "-S", "--count", "1", "--time", "20", str(GOLDEN / "red-light.scenic")]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr


def summed_up(**counts: int) -> str:
    known = {"ran": 50, "collided": 20, "rejected": 0, "selected": 2, "selected_shown": 2, "fill_in": 0}
    scenes, ego = Summary(counts=known | counts, seconds=3.0, ego="sac sees little").in_words().splitlines()
    assert ego == "sac sees little"
    return scenes


def test_a_run_says_how_many_kept_scenes_do_not_show_what_was_said() -> None:
    assert summed_up().endswith("; 2 kept")
    assert summed_up(selected_shown=1).endswith("; 2 kept (1 that does not show all that was read)")
    assert summed_up(selected_shown=0, fill_in=1).endswith(
        "; 2 kept (1 without a collision, 2 that do not show all that was read)"
    )


def test_a_run_says_how_many_drives_left_the_road_or_never_arrived_beside_how_many_collided() -> None:
    bad = summed_up(collided=0, off_road=3, timeout=2, waiting=1)
    assert "collided in 0 (0%, 95 % interval 0% to 7%), left the road in 3, ran out of time in 2, " in bad
    assert "waited behind somebody to the end in 1; 2 kept" in bad
    assert "left the road in 0" in summed_up(off_road=0)
    assert "left the road" not in summed_up()  # a folder of before it was counted


def test_a_run_says_who_stepped_its_drives_and_why_not_the_simulator_that_was_asked_for() -> None:
    record = runs.asked_run(SENTENCES["stops"], settings=Settings(simulation=SimulationSettings(simulator="native")))
    assert stepped_in_words(record) == ""
    record = record.model_copy(update={"stepped": {"native": 4}})
    assert stepped_in_words(record) == "stepped: 4 by native"
    record = record.model_copy(
        update={"stepped": {"embedded": 1, "native": 4}, "instead": {"the physics lagged": ["s"]}}
    )
    assert (
        stepped_in_words(record) == "stepped: 1 by embedded, 4 by native (not by native: 1 scene: the physics lagged)"
    )


def test_what_a_user_writes_stays_a_comment() -> None:
    text = 'A cyclist crosses from the left"""\nimport os\nparam x = 1\x00\r# '
    source = pipeline.understand(text).program.source
    said = source.split("\n\n")[0]
    assert all(line.startswith("# ") for line in said.splitlines())
    assert source.count("import os") == 1


def test_a_part_that_lacks_a_name_is_told_which() -> None:
    library = load_library()
    triple = tuple(library.get(i) for i in ("behavior/lane-brake", "geometry/straight-road", "spawn/roadside-right"))
    with pytest.raises(NamesNotClosed, match="advTrajectory"):
        assemble(decompose("a car brakes"), (triple[0], triple[1], triple[2]), AdversaryKind.CAR)


def test_a_program_that_can_never_be_placed_says_why(simulator: Simulator) -> None:
    source = """
model chatscene.world.model
egoRoute = selectRoute(maneuver="straight")
param OPT_GEO_Y = Range(0, 1)
behavior AdvBehavior():
    do Park()
ego = new Car at pointOn(egoRoute, 0), facing directionOn(egoRoute, 0), with route egoRoute
AdvAgent = new Car at pointOn(egoRoute, globalParameters.OPT_GEO_Y), facing 0, with behavior AdvBehavior()
"""
    from chatscene.terms.snippet import ParameterRange

    p = ParameterRange(name="OPT_GEO_Y", low=0.0, high=1.0, unit="m")
    program = ScenicProgram(scenario_id="stuck", source=source, parameters=(p,), snippet_ids=())
    with pytest.raises(Unsatisfiable, match="adversary overlaps ego"):
        check(program, Slots(), simulator, RuleBased())
    assert {scene.values["OPT_GEO_Y"] for scene in probe_scenes(program, 0)} >= {0.5, 0.25}


def test_the_time_of_a_run_is_kept_as_it_goes_and_is_on_its_page(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    seconds = itertools.count(start=100.0, step=2.0)
    monkeypatch.setattr(working.time, "monotonic", lambda: next(seconds))
    small = Settings(search=SearchSettings(scenes=2, block=1, keep=1))

    told: list[str] = []

    def cut(what: str, done: int, _total: int) -> None:
        told.append(what)
        if what.startswith("searching") and done == 1:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        pipeline.run(runs.asked_run(SENTENCES["stops"], settings=small), tmp_path / "run", progress=cut)
    first = runs.read_record(runs.open_run(tmp_path / "run")).timings["total"]
    assert first >= 2.0 * len(told) > 0.0  # two seconds at least from each telling to the next
    summary = pipeline.resume(tmp_path / "run")
    page = (tmp_path / "run" / "report.html").read_text()
    said = re.search(r"<dt>Time</dt><dd>([\d.]+) s, until this page was written</dd>", page)
    assert said
    assert first < float(said[1]) < summary.seconds
    assert "planner sees its route" in summary.in_words()


def test_a_run_whose_animation_cannot_be_drawn_is_done_and_says_so_and_resume_draws_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def broken(*_: object, **__: object) -> bytes:
        raise IndexError("list index out of range")

    draw = animation.animate
    monkeypatch.setattr(animation, "animate", broken)
    asked = runs.asked_run(SENTENCES["stops"], settings=Settings(search=SearchSettings(scenes=2, block=1, keep=1)))
    told = f"the animation in {tmp_path}/run could not be drawn .IndexError: list index out of range.; all else is kept"
    with pytest.warns(RuntimeWarning, match=told):
        pipeline.run(asked, tmp_path / "run")
    assert runs.read_record(runs.open_run(tmp_path / "run")).status is runs.Status.DONE
    assert (tmp_path / "run" / "report.html").is_file()
    assert not list(tmp_path.rglob("*.gif"))
    monkeypatch.setattr(animation, "animate", draw)
    pipeline.resume(tmp_path / "run")
    assert list(tmp_path.rglob("*.gif"))


def test_nonsense_is_refused() -> None:
    with pytest.raises(NothingFits):
        pipeline.understand("Whisk two eggs and fold in the flour.")


def _paper() -> list[str]:
    if not PAPER.exists():
        return []
    groups: dict[str, list[str]] = json.loads(PAPER.read_text())["descriptions"]
    return [text for texts in groups.values() for text in texts]


LEAST = 15  # of its forty; of most others the reader is not sure enough, or no snippet does it


@pytest.mark.skipif(not PAPER.exists(), reason="the paper's descriptions are not beside this checkout")
def test_sentences_of_the_paper_become_programs_that_mean_them(simulator: Simulator) -> None:
    served = 0
    for text in _paper():
        try:
            understood = pipeline.understand(text)
            check(understood.program, understood.scenario.slots, simulator, RuleBased())
        except (NothingFits, MeansSomethingElse):
            continue
        served += 1
    assert served >= LEAST


def test_of_many_quick_drives_it_is_told_once_a_second(monkeypatch: pytest.MonkeyPatch) -> None:
    now = iter([10.0, 10.4, 10.8, 11.2, 11.2, 11.9, 12.3, 12.3])
    monkeypatch.setattr("time.monotonic", lambda: next(now))
    told: list[int] = []
    slowly = Slowly(told.append)
    for _ in range(5):
        slowly()
    assert told == [3, 5]


def test_a_slow_run_tells_of_each_scene(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("chatscene.runs.progress.SLOW", 0.0)
    told: list[tuple[str, int, int]] = []

    def tell(what: str, done: int, total: int) -> None:
        told.append((what, done, total))

    chatscene.run("a car ahead brakes hard", tmp_path / "run", scenes=2, progress=tell)
    checking = [said[1:] for said in told if said[0] == "checking that drives show what was read"]
    assert checking[1:4] == [(1, 3), (2, 3), (3, 3)]
    assert [said[1:] for said in told if said[0] == "searching, scenes"] == [(0, 2), (1, 2), (2, 2), (2, 2)]
