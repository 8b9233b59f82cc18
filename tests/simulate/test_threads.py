"""Every process that drives computes on one thread, whatever its environment asks for."""

import json
import subprocess
import sys
from collections.abc import Callable
from importlib.util import find_spec
from pathlib import Path

import pytest

from chatscene.maps.network import resolve_map
from chatscene.runs.executor import Workers
from chatscene.runs.parallel import spread
from chatscene.settings import SimulationSettings
from chatscene.simulate.confined.nursery import Nursery
from chatscene.terms.scene import ScenicProgram

threadpoolctl = pytest.importorskip("threadpoolctl", reason="it tells how many threads a library has")

DRIVE = """
import json
from chatscene.ego.policy import load_ego
from chatscene.maps.network import resolve_map
from chatscene.settings import SimulationSettings
from chatscene.simulate.simulator import load_simulator, simulate
from chatscene.terms.scene import Scene, ScenicProgram
from threadpoolctl import threadpool_info
source = '''
model chatscene.world.model
egoRoute = selectRoute(maneuver="straight")
ego = new Car at pointOn(egoRoute, 0), facing directionOn(egoRoute, 0), with route egoRoute
'''
program = ScenicProgram(scenario_id="x", source=source, parameters=(), snippet_ids=())
scene = Scene(id="x", scenario_id="x", route=0, block=0, seed=0, values={})
simulate(load_simulator(resolve_map("town"), SimulationSettings()), program, scene, load_ego("sac"))
print(json.dumps([library["num_threads"] for library in threadpool_info()]))
"""
BELIEVE = """
from chatscene.read.learned.reader import LearnedReader
for text in (
    "A cyclist rides out from the left and stops in front of us.",
    "We were on the ring road, with a lorry on our right that indicated and came over without looking.",
    "Somebody pushing a pram came round the back of the bus, saw us, hesitated, and then ran for the other side.",
):
    print(repr(LearnedReader().read(text)))
"""
MANY = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")


@pytest.fixture(autouse=True)
def many(monkeypatch: pytest.MonkeyPatch) -> None:
    """Ask for four threads in every process that is started."""
    for name in MANY:
        monkeypatch.setenv(name, "4")


def test_a_process_that_drives_has_one_thread_per_library() -> None:
    done = subprocess.run([sys.executable, "-c", DRIVE], capture_output=True, text=True, check=True)
    assert set(json.loads(done.stdout)) == {1}


def test_the_explanation_of_a_sentence_does_not_depend_on_the_number_of_threads(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    command = [sys.executable, "-m", "chatscene", "explain", "A cyclist rides out from the left.", "--json"]
    said: set[str] = set()
    for count in ("1", "4"):
        for name in MANY:
            monkeypatch.setenv(name, count)
        said.add(subprocess.run(command, capture_output=True, text=True, check=True).stdout)
    assert len(said) == 1


def test_what_is_believed_of_a_sentence_does_not_depend_on_what_was_imported_first(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    # Kernels whose sums are known to depend on their threads; the newest do not show it.
    monkeypatch.setenv("OPENBLAS_CORETYPE", "Haswell")
    said: set[str] = set()
    for first in filter(find_spec, ("chatscene", "numpy", "torch")):
        code = f"import {first}\n{BELIEVE}"
        said.add(subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout)
    assert len(said) == 1


def _counting(_: None) -> Callable[[int], list[int]]:
    return lambda _task: [library["num_threads"] for library in threadpoolctl.threadpool_info()]


def test_the_workers_of_a_run_have_one_thread_per_library() -> None:
    for counts in spread(_counting, None, (1, 2), workers=Workers(2)):
        assert set(counts) == {1}


@pytest.mark.skipif(sys.platform != "linux", reason="strangers' programs are confined on Linux alone")
def test_the_process_that_strangers_programs_are_forked_from_has_one_thread() -> None:
    program = ScenicProgram(scenario_id="x", source="", parameters=(), snippet_ids=())
    with Nursery(resolve_map("town"), SimulationSettings()) as nursery:
        nursery.confine(program).close()
        warm = [pid for pid in _children() if b"simulate.confined.child" in Path(f"/proc/{pid}/cmdline").read_bytes()]
        assert warm
        assert all("Threads:\t1\n" in Path(f"/proc/{pid}/status").read_text() for pid in warm)


def _children() -> list[str]:
    return [pid for task in Path("/proc/self/task").iterdir() for pid in (task / "children").read_text().split()]
