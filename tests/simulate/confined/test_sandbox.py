"""Both walls, part by part: what passes, what is in force, and that what comes back is checked."""

import ast as python
import json
import os
import signal
import subprocess
import sys
import tempfile
import threading
from collections.abc import Generator, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from copy import deepcopy
from dataclasses import replace
from importlib.resources import files
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scenic.syntax import ast as scenic
from scenic.syntax import translator

from chatscene.ego.observation import Observation
from chatscene.ego.policy import load_ego
from chatscene.ego.rule_based import RuleBased
from chatscene.errors import (
    DoesNotCompile,
    EgoError,
    ForeignCodeRefused,
    MapError,
    ProgramError,
    SandboxError,
    StuckBehavior,
)
from chatscene.grow.lint import world_names
from chatscene.library.load import load_library
from chatscene.maps.network import resolve_map
from chatscene.program.check import check, probe_scenes
from chatscene.search.generators.foreign import foreign_program
from chatscene.settings import SimulationSettings
from chatscene.simulate.confined.allow_list import check_foreign
from chatscene.simulate.confined.child import _warmed_up  # type: ignore[reportPrivateUsage]
from chatscene.simulate.confined.confinement import AUDIT, LIMITS, SECCOMP, Limits
from chatscene.simulate.confined.landlock import landlock_version
from chatscene.simulate.confined.nursery import Confined, Nursery, shared_nursery
from chatscene.simulate.confined.plain_text import check_text
from chatscene.simulate.confined.simulator import ConfinedSession, ConfinedSimulator
from chatscene.simulate.confined.wire import (
    decode,
    encode,
    episode_from_json,
    episode_to_json,
    route_from_json,
    route_to_json,
    words,
)
from chatscene.simulate.confined.words import KINDS, PYTHON_NAMES, SCENIC_NAMES, dialect_of, world_words
from chatscene.simulate.native.lines import engine
from chatscene.simulate.simulator import Simulator, load_simulator, simulate
from chatscene.terms.episode import Episode
from chatscene.terms.route import Route
from chatscene.terms.scenario import Slots
from chatscene.terms.scene import OWN_MODEL, Rejected, Scene, ScenicProgram
from places import GOLDEN, TESTS

TOWN = resolve_map("town")
HEAD = 'model chatscene.world.model\negoRoute = selectRoute(maneuver="straight")\n'
EGO = "ego = new Car at startOf(egoRoute), facing directionOn(egoRoute, 0), with route egoRoute\n"
WALKER = (
    'AdvAgent = new Pedestrian at besideRoad(egoRoute, 40, "right", 1), '
    'facing crossingDirection(egoRoute, 40, "right"), with behavior AdvBehavior()\n'
)


def program(behavior: str, *, setup: str = "") -> ScenicProgram:
    body = behavior.replace("\n", "\n    ")
    return foreign_program("toy", f"{HEAD}{setup}behavior AdvBehavior():\n    {body}\n{EGO}{WALKER}")


CROSSES = program("do Halt() until headway(egoRoute, ego, self) < 20\ndo MoveAhead(2)")


def scene(route: int = 0, **values: float) -> Scene:
    return Scene(id="toy/scene", scenario_id="toy", route=route, block=0, seed=0, values=values)


@pytest.fixture(scope="module")
def simulator() -> Iterator[ConfinedSimulator]:
    with ConfinedSimulator(TOWN, SimulationSettings(), Limits(answer=3.0, memory=256)) as simulator:
        yield simulator


@pytest.fixture(scope="module")
def trusting() -> Simulator:
    return load_simulator(TOWN, SimulationSettings())


# The first wall


def test_the_snippets_of_the_library_keep_to_the_list() -> None:
    found = {
        snippet.id: refusals
        for snippet in load_library().snippets[::5]  # all would take long; a list has the same words for each
        if (refusals := check_foreign(snippet.source, given=(*snippet.requires, "AdvClass"), whole=False))
    }
    assert not found


@pytest.mark.parametrize("path", sorted(GOLDEN.glob("*.scenic")), ids=lambda path: path.stem)
def test_the_programs_we_make_keep_to_the_list(path: Path) -> None:
    assert check_foreign(path.read_text()) == ()


def test_the_names_of_the_world_model_are_those_that_scenic_reads_in_it() -> None:
    source = files("chatscene.world").joinpath("model.scenic").read_text(encoding="utf-8")
    source += files("chatscene.world").joinpath("behaviors.scenic").read_text(encoding="utf-8")
    read: set[str] = set()
    for node in translator.parse_string(source, "exec").body:
        if isinstance(node, python.ImportFrom) and str(node.module).startswith("chatscene."):
            read.update(alias.asname or alias.name for alias in node.names)
        elif isinstance(name := getattr(node, "name", None), str):
            read.add(name)
    public = {name for name in read if not name.startswith("_")}
    assert {name for name in public - world_words() if name.isidentifier()} == {"Driven", "Walking"}
    assert world_words() <= public


def test_every_name_on_the_list_is_a_name_of_the_world_model() -> None:
    listed = world_words() | SCENIC_NAMES | PYTHON_NAMES
    assert listed <= world_names()
    assert not any(name.startswith("_") for name in listed)
    assert not listed & {
        "open",
        "exec",
        "eval",
        "getattr",
        "print",
        "network",
        "simulation",
        "globalParameters",
        "math",
    }


DRIVING = "model scenic.domains.driving.model\nego = new Car\n"


@pytest.mark.parametrize("head", [HEAD, DRIVING], ids=["own", "driving"])
def test_the_functions_of_math_may_be_imported(head: str) -> None:
    for text in (
        "import math\nx = math.sqrt(4) + math.pi\n",
        "import math as m\nx = m.hypot(3, 4)\n",
        "from math import sqrt, pi as half, sin\nx = sqrt(half) + sin(1)\n",
    ):
        assert check_foreign(head + text) == (), text


@pytest.mark.parametrize("head", [HEAD, DRIVING], ids=["own", "driving"])
@pytest.mark.parametrize(
    "text",
    [
        "import math, os",
        "import math.os",
        "from . import math",
        "from math import *",
        "from math import factorial",
        "import random",
        "import math as exec",
        "import math as Range",
        "import math as globalParameters",
        "import math as __x",
        "from math import sqrt as open",
        "x = pow(9, 9)\nfrom math import pow",
        "if 1 > 2:\n    import math",
        "behavior B():\n    import math\n    wait",
        *(
            f"import math\n{line}"
            for line in (
                "x = math",
                "x = [math][0].sqrt",
                "x = math.__loader__",
                "x = math.factorial(9)",
                "x = math.sqrt.__self__",
                "math.pi = 3",
                "math = 3",
                "for math in [ego]:\n    x = math.pi",
                "behavior B(math):\n    x = math.pi\n    wait",
                "behavior math():\n    wait",
                "from math import sqrt as math",
            )
        ),
    ],
)
def test_of_modules_nothing_else_is_had(head: str, text: str) -> None:
    assert check_foreign(f"{head}{text}\n")


def test_a_program_computes_with_math_as_python_does(simulator: ConfinedSimulator) -> None:
    plain = program("do Halt() for 2 seconds\ndo MoveAhead(1.5)")
    imports = "import math\nfrom math import fabs\n"
    told = program("do Halt() for math.sqrt(4) seconds\ndo MoveAhead(fabs(-1.5))", setup=imports)
    drives = [simulate(simulator, one, scene(), load_ego("idm")) for one in (plain, told)]
    walkers = [one.adversaries[0] for one in drives if isinstance(one, Episode)]
    first, second = [np.stack((one.x, one.y)) for one in walkers]
    assert np.array_equal(first, second)
    assert np.ptp(first) > 1.0


def test_a_part_of_a_program_imports_nothing() -> None:
    assert [one.what for one in check_foreign("import math\n", whole=False)] == ["import"]


def test_a_refusal_says_where_and_what_and_why() -> None:
    refusals = check_foreign(HEAD + "x = open('a')\nimport os\n")
    assert [refusal.line for refusal in refusals] == [3, 4]
    assert [refusal.what for refusal in refusals] == ["the name open", "import os"]
    assert str(refusals[0]).startswith("line 3: the name open: ")


@pytest.mark.parametrize(
    ("line", "what"),
    [
        ("'#'; x = 'ü'", "the character U+00FC LATIN SMALL LETTER U WITH DIAERESIS"),
        ("'#'; x = 'a\\x41'", "a backslash"),
        ("'''\n#'''; x = 'a\\x41'", "a backslash"),
        ("'" + ")" * 30 + "'; x = " + "(" * 30 + "1" + ")" * 30, "brackets within brackets"),
        ("'#'; x = " + "(" * 30 + "1" + ")" * 30, "brackets within brackets"),
        ("x = (" + "- - -\n" * 5 + "1)", "a pile of signs"),
    ],
)
def test_a_text_hides_nothing_that_stands_behind_it(line: str, what: str) -> None:
    assert [refusal.what for refusal in check_foreign(f"{HEAD}{line}\n")] == [what]


@pytest.mark.parametrize(
    "lines",
    [
        "behavior Follow():\n    do Halt()\nbehavior Other():\n    do Follow()\n",
        "behavior Follow():\n    do Follow()\n",
        "id = 3\nx = id + 1\n",
        "behavior Other(type=1, id=2):\n    if type > id:\n        do Halt()\n",
    ],
)
def test_a_name_that_python_or_scenic_defines_may_be_the_programs_own(lines: str) -> None:
    assert check_foreign(HEAD + lines) == ()


@pytest.mark.parametrize(
    "lines",
    [
        "x = open\nopen = 1\n",
        "open = open\n",
        "open += 1\n",
        "if 1 > 2:\n    open = 1\nx = open\n",
        "for open in range(0):\n    x = 1\nx = open\n",
        "behavior Other(a=open, open=1):\n    wait\n",
        "behavior Other(open=1):\n    wait\nx = open\n",
        "behavior Other(open=1):\n    wait\nbehavior Open():\n    x = open\n    wait\n",
        "behavior Open():\n    x = open\n    wait\nopen = 1\n",
        "behavior Other():\n    open = 1\n    wait\n",
        "x = new Workspace at (0, 0)\nWorkspace = 1\n",
    ],
)
def test_a_name_that_could_lead_to_pythons_or_scenics_may_not_be_defined(lines: str) -> None:
    assert {refusal.what for refusal in check_foreign(HEAD + lines)} & {"the name open", "the name Workspace"}


def test_what_looks_like_code_in_a_comment_or_a_text_is_none() -> None:
    assert check_foreign(f"{HEAD}x = 'left'  # \\ - - - - - - - - - - für '\n'" + "(" * 30 + "'\n") == ()


def test_a_part_of_a_program_has_its_partners_names_and_no_model() -> None:
    part = "behavior AdvBehavior():\n    do DrivePath(advTrajectory, 5)\n"
    assert check_foreign(part, given=("advTrajectory",), whole=False) == ()
    assert [r.what for r in check_foreign(part, whole=False)] == ["the name advTrajectory"]
    assert check_foreign("model chatscene.world.model\n" + part, given=("advTrajectory",), whole=False)


@pytest.mark.parametrize(
    "line",
    [
        "x = 3 ** 3 + abs(-2) // 1",
        "for i in range(3):\n    new Kiosk at pointOn(egoRoute, 20 * i, 9)",
        "x = (1, 2)[0] if 1 < 2 else 3",
        "require (distance from ego to AdvAgent) > 5",
        "terminate when (distance from ego to AdvAgent) < 3",
        "param signals = 'ego-green'",
        "param OPT_A = Range(-1, 2)",
        "# Zebrastreifen für Fußgänger",
        "lines = lanesBeside(egoRoute, 'left')",
    ],
)
def test_what_scenes_are_made_of_passes(line: str) -> None:
    assert check_foreign(f"{HEAD}behavior AdvBehavior():\n    do Halt()\n{EGO}{WALKER}{line}\n") == ()


@pytest.mark.parametrize(
    ("line", "what"),
    [
        ("x = egoRoute.network", ".network"),
        ("x = globalParameters", "globalParameters"),
        ("x = globalParameters.map", "globalParameters.map"),
        ("egoRoute.exitAt = 5", ".exitAt ="),
        ("x = 2 ** x", "**"),
        ("x = [1] * 5", "arithmetic with text or a list"),
        ("x = 1e7", "the constant 10000000.0"),
        ("x = 1j", "the constant 1j"),
        ("x = '%s'", "the text %s"),
        ("for i in egoRoute:\n    x = i", "for"),
        ("x = range(1000)", "range"),
        ("Car = 5", "the name Car"),
        ("self = 5", "the name self"),
        ("ego = Car", "Car without new"),
        ("ego = egoRoute", "ego"),
        ("new Car with physics 5", "with physics"),
        ("x = (ego.position)(1)", ".position()"),
        ("x = [ego][0](1)", "a call of something without a name"),
        ("while 1 < 2:\n    x = 1", "while"),
        ("mutate ego", "mutate"),
        ("record ego.speed", "record"),
        ("workspace = 5", "workspace"),
    ],
)
def test_what_no_scene_needs_is_refused(line: str, what: str) -> None:
    assert what in [refusal.what for refusal in check_foreign(HEAD + line + "\n")]


def test_every_kind_of_syntax_has_a_name_in_the_words_of_the_language() -> None:
    parsed = [getattr(module, name) for module in (python, scenic) for name in dir(module)]
    kinds = {kind for kind in parsed if isinstance(kind, type) and issubclass(kind, python.AST) and kind._fields}
    inner = {
        "Expression",
        "FunctionType",
        "Interactive",
        "Suite",
        "ExtSlice",
        "Index",
        "alias",
        "withitem",
        "TypeIgnore",
    }
    inner |= {"Num", "Str", "Bytes", "NameConstant", "Ellipsis", "match_case"}  # of Python 3.7, or below a match
    refused = {
        k.__name__ for k in kinds if k not in dialect_of(OWN_MODEL).syntax and not k.__name__.startswith("Match")
    }
    assert refused - inner <= set(KINDS)


@pytest.mark.skipif(sys.version_info < (3, 12), reason="before Python 3.12 it is no syntax at all")
@pytest.mark.parametrize(
    ("line", "what"),
    [
        ("type Speed = int", {"a type alias"}),
        ("def f[T](x):\n    return x", {"a type parameter", "a function"}),
        ("def f[*T, **P](x):\n    return x", {"a type parameter", "a function"}),
        ("class Van[T]:\n    pass", {"a class"}),
    ],
)
@pytest.mark.parametrize("model", [OWN_MODEL, "scenic.simulators.carla.model"])
def test_types_and_their_parameters_are_refused_whatever_the_model(line: str, what: set[str], model: str) -> None:
    found = {refusal.what for refusal in check_foreign(f"model {model}\nego = new Car\n{line}\n")}
    assert found
    assert found <= what


@settings(max_examples=60)
@given(st.text(max_size=200))
def test_any_text_is_either_refused_or_fine(text: str) -> None:
    for refusal in check_foreign(text):
        assert str(refusal)
    for refusal in check_text(text):
        assert str(refusal).isprintable()


# The second wall


def test_a_confined_drive_is_bit_for_bit_that_of_the_trusting_simulator(
    simulator: ConfinedSimulator, trusting: Simulator
) -> None:
    for path in sorted(GOLDEN.glob("*.scenic")):
        source = foreign_program(path.stem, path.read_text())
        assert simulator.routes(source) == trusting.routes(source)
        assert simulator.route(source, 0).line.points.tolist() == trusting.route(source, 0).line.points.tolist()
        placed = probe_scenes(source, 0)[0]
        confined, free = (simulate(where, source, placed, RuleBased()) for where in (simulator, trusting))
        assert isinstance(confined, Episode)
        assert isinstance(free, Episode)
        assert _same(confined, free)


def _same(a: Episode, b: Episode) -> bool:
    tracks = zip(a.tracks, b.tracks, strict=True)
    return (
        (a.scene_id, a.ego, a.dt, a.events, a.ending, a.route_completion)
        == (b.scene_id, b.ego, b.dt, b.events, b.ending, b.route_completion)
        and np.array_equal(a.distance_to_route, b.distance_to_route)
        and np.array_equal(a.off_road, b.off_road)
        and [s.state for s in a.signals] == [s.state for s in b.signals]
        and all(
            (x.actor, x.role, x.kind, x.length, x.width) == (y.actor, y.role, y.kind, y.length, y.width)
            and all(np.array_equal(getattr(x, n), getattr(y, n)) for n in ("x", "y", "heading", "speed"))
            for x, y in tracks
        )
    )


def test_a_stranger_climbs_the_same_ladder(simulator: ConfinedSimulator) -> None:
    checked = check(CROSSES, Slots(), simulator, RuleBased(), drives=1)
    assert checked.episodes[0].adversaries[0].kind == "Pedestrian"


def test_every_layer_that_this_kernel_has_is_in_force(simulator: ConfinedSimulator) -> None:
    layers = simulator.layers(CROSSES)
    assert {LIMITS, SECCOMP, AUDIT} <= set(layers)
    assert ("landlock" in layers) == (landlock_version() > 0)


def test_the_walls_of_the_kernel_hold_without_the_watchman(tmp_path: Path) -> None:
    (tmp_path / "secret").write_text("x")
    script = TESTS / "red_team" / "unwatched.py"
    done = subprocess.run([sys.executable, str(script), str(tmp_path)], capture_output=True, text=True, check=True)
    tried: dict[str, str] = json.loads(done.stdout)
    assert len(tried) >= 14
    allowed = {what for what, outcome in tried.items() if outcome == "done"}
    assert allowed <= ({"read a file"} if landlock_version() == 0 else set())
    assert [p.name for p in tmp_path.iterdir()] == ["secret"]


STUCK = program("while True:\n    if 1 > 2:\n        wait")


LATE = """
import os, socket, sys
from chatscene.simulate.confined import child
from chatscene.simulate.confined.confinement import Limits
from chatscene.simulate.confined.wire import program_to_json
from chatscene.terms.scene import ScenicProgram

class Late:
    def routes(self, program):
        import this_late
        return this_late.ROUTES

ours, theirs = socket.socketpair()
sys.path.insert(0, sys.argv[1])
sys.pycache_prefix = sys.argv[2]
sys.dont_write_bytecode = False
if os.fork() == 0:
    ours.close()
    child._live(theirs.detach(), Late(), Limits(), sys.argv[1])
theirs.close()
program = ScenicProgram(scenario_id="a", source="", parameters=(), snippet_ids=())
ours.sendall(child.encode({"do": "load", "program": program_to_json(program)}))
ours.sendall(child.encode({"do": "routes"}))
ours.shutdown(socket.SHUT_WR)
print(ours.makefile().read())
"""
WARM = """
import sys
from chatscene.maps.network import resolve_map
from chatscene.settings import SimulationSettings
from chatscene.simulate.confined import child

child._warmed_up(resolve_map("town"), SimulationSettings())
print(*sorted(sys.modules))
"""


EVENTS = ["_thread.start_new_thread", "_thread.start_joinable_thread", "sys.monitoring.register_callback"]
WATCHED = """
import sys
from chatscene.simulate.confined.audit import watch

told = []
watch(sys.path, told.append)
for event in sys.argv[1:]:
    sys.audit(event)
try:
    import _interpreters
except ImportError:
    pass
print(*told, sep="\\n")
"""


def _told(script: str, *arguments: str) -> str:
    command = [sys.executable, "-c", script, *arguments]
    return subprocess.run(command, capture_output=True, text=True, check=True, timeout=120).stdout


def test_the_watchman_knows_what_other_versions_of_python_call_a_thread_a_trace_and_an_interpreter() -> None:
    assert _told(WATCHED, *EVENTS).split("\n") == [*EVENTS, "import _interpreters", ""]


def test_a_module_that_is_imported_late_comes_in_where_no_bytecode_was_kept(tmp_path: Path) -> None:
    (tmp_path / "this_late.py").write_text("ROUTES = 7\n")
    assert '{"routes":7}' in _told(LATE, str(tmp_path), str(tmp_path / "kept"))
    assert not (tmp_path / "kept").exists()


def test_what_the_first_draw_from_an_area_needs_is_there_before_the_walls() -> None:
    assert "mapbox_earcut" in _told(WARM).split()


def test_who_stops_a_program_names_the_file_that_it_tried(tmp_path: Path) -> None:
    (tmp_path / "this_late.py").write_text("import os\nos.mkdir('a \"new\" folder')\n")
    said = [decode(line.encode()) for line in _told(LATE, str(tmp_path), str(tmp_path / "kept")).split("\n") if line]
    assert said[-1] == {"stopped": 'os.mkdir a "new" folder'}


def test_a_behavior_that_never_yields_is_stopped_and_the_next_scene_runs(simulator: ConfinedSimulator) -> None:
    with pytest.raises(StuckBehavior, match="did not come back within 3 s of processor time"):
        simulate(simulator, STUCK, scene(), RuleBased())
    assert STUCK.digest != CROSSES.digest
    assert simulator.routes(STUCK) == 10
    assert isinstance(simulate(simulator, CROSSES, scene(), RuleBased()), Episode)


@contextmanager
def stopped(limits: Limits) -> Generator[tuple[Confined, int]]:
    """A confined process that does not get its turn, and its number."""
    with Nursery(TOWN, SimulationSettings(), limits) as nursery:
        confined = nursery.confine(CROSSES)
        pid = confined.pid
        os.kill(pid, signal.SIGSTOP)
        yield confined, pid
        confined.close()


def test_a_process_that_does_not_get_its_turn_is_waited_for() -> None:
    with stopped(Limits(answer=2.0)) as (confined, pid):
        turn = threading.Timer(2.2, os.kill, (pid, signal.SIGCONT))
        turn.start()
        assert confined.ask("routes") == {"routes": 10}
        turn.join()


def test_a_process_that_never_answers_is_stopped_without_blaming_a_loop() -> None:
    with (
        stopped(Limits(wall=0.5)) as (confined, _),
        pytest.raises(StuckBehavior, match=r"\(routes\).* within 0\.5 s, in which it computed for 0\.0 s: it waits"),
    ):
        confined.ask("routes")


def test_processor_time_is_limited_over_the_life_of_a_process() -> None:
    with ConfinedSimulator(TOWN, SimulationSettings(), Limits(processor=1)) as simulator:
        with pytest.raises(SandboxError, match="used up its processor time"):
            simulate(simulator, STUCK, scene(), RuleBased())
        assert isinstance(simulate(simulator, CROSSES, scene(), RuleBased()), Episode)


def test_a_program_that_wants_too_much_memory_is_stopped(simulator: ConfinedSimulator) -> None:
    greedy = program("do Halt()", setup="x = 'x'\nfor i in range(90):\n    x += x\n")
    with pytest.raises(SandboxError, match="used up its memory"):
        simulator.routes(greedy)


def test_faults_of_a_program_are_told_as_by_the_trusting_simulator(simulator: ConfinedSimulator) -> None:
    with pytest.raises(DoesNotCompile, match=r"^your program toy fails while it is set up: line 3: NameError"):
        simulator.routes(program("do Halt()", setup="x = later\nlater = 1\n"))
    with pytest.raises(MapError):
        simulator.route(CROSSES, 99)
    with pytest.raises(ProgramError, match="has values for"):
        simulate(simulator, CROSSES, scene(OPT_X=1.0), RuleBased())
    with pytest.raises(ForeignCodeRefused, match="import"):
        simulator.routes(replace(CROSSES, source=CROSSES.source + "import os\n"))


def test_a_scene_that_cannot_be_placed_is_rejected_in_words(simulator: ConfinedSimulator) -> None:
    twice = program(
        "do Halt()", setup="param OPT_A = Range(0, 1)\nx = globalParameters.OPT_A\nnew Kiosk at pointOn(egoRoute, x)\n"
    )
    outcome = simulate(simulator, twice, scene(OPT_A=0.5), RuleBased())
    assert isinstance(outcome, Rejected)
    assert "overlaps" in outcome.reason


def test_a_drive_is_stepped_from_outside(simulator: ConfinedSimulator) -> None:
    drive = simulator.open(CROSSES, scene(), observation="actors", pedals="full-brake")
    assert isinstance(drive, ConfinedSession)
    assert drive.ending is None
    for _ in range(20):
        drive.step((1.0, 0.0))
    assert drive.step_number == 20
    assert drive.speed > 1.0
    assert drive.along > 0.5
    assert drive.observation.shape == (80,)
    assert len(drive.episode("a", "b").ego_track.x) == 21
    with pytest.raises(EgoError):
        drive.step((float("nan"), 0.0))
    drive.close()


class _Broken:
    def act(self, observation: Observation) -> tuple[float, float]:
        raise ValueError("no idea")


def test_an_ego_that_fails_is_to_blame_itself(simulator: ConfinedSimulator) -> None:
    with pytest.raises(EgoError, match=r"fails at step 0 of scene .*: ValueError: no idea"):
        simulate(simulator, CROSSES, scene(), _Broken())
    assert isinstance(simulate(simulator, CROSSES, scene(), RuleBased()), Episode)


def test_a_map_that_is_none_is_told_as_such(tmp_path: Path) -> None:
    (tmp_path / "no.xodr").write_text("<OpenDRIVE>")
    with pytest.raises(MapError, match="not complete XML"), Nursery(tmp_path / "no.xodr", SimulationSettings()) as n:
        n.confine(CROSSES)


def test_nothing_is_left_when_a_nursery_is_closed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    with Nursery(TOWN, SimulationSettings()) as nursery:
        confined = nursery.confine(CROSSES)
        assert confined.ask("routes") == {"routes": 10}
        (folder,) = tmp_path.iterdir()
        assert [path.name for path in folder.iterdir()] == ["errors"]
    assert not list(tmp_path.iterdir())
    confined.close()
    with pytest.raises(SandboxError, match="cannot be asked again"):
        confined.ask("routes")


def test_who_confines_on_one_map_shares_what_processes_are_forked_from(tmp_path: Path) -> None:
    other = tmp_path / "town.xodr"
    other.write_bytes(TOWN.read_bytes())
    before = shared_nursery(other, SimulationSettings(), Limits())
    assert shared_nursery(other, SimulationSettings(), Limits()) is before
    assert shared_nursery(other, SimulationSettings(), Limits(memory=256)) is not before
    other.write_bytes(TOWN.read_bytes() + b"\n")
    assert shared_nursery(other, SimulationSettings(), Limits()) is not before


def test_a_fork_of_a_process_leaves_its_nursery_alone() -> None:
    with Nursery(TOWN, SimulationSettings()) as nursery:
        nursery.confine(CROSSES)
        if (pid := os.fork()) == 0:
            nursery.close()
            os._exit(0)
        os.waitpid(pid, 0)
        assert nursery.confine(CROSSES).ask("routes") == {"routes": 10}


def test_threads_that_share_a_nursery_each_get_their_own_process() -> None:
    with Nursery(TOWN, SimulationSettings()) as nursery, ThreadPoolExecutor(4) as threads:
        confined = list(threads.map(nursery.confine, [CROSSES] * 8))
        assert len({one.pid for one in confined}) == 8
        list(threads.map(Confined.close, confined))
        assert not any(Path(f"/proc/{one.pid}").exists() for one in confined)


def test_whom_nobody_holds_any_more_is_gone_before_the_next_is_forked() -> None:
    with Nursery(TOWN, SimulationSettings()) as nursery:
        dropped = nursery.confine(CROSSES).pid
        nursery.confine(CROSSES)
        assert not Path(f"/proc/{dropped}").exists()


def test_a_nursery_whose_process_is_killed_says_so_and_starts_another() -> None:
    with Nursery(TOWN, SimulationSettings()) as nursery:
        confined = nursery.confine(CROSSES)
        os.kill(int(Path(f"/proc/{confined.pid}/stat").read_text().rpartition(")")[2].split()[1]), signal.SIGKILL)
        with pytest.raises(SandboxError, match="does not answer"):
            nursery.confine(CROSSES)
        assert nursery.confine(CROSSES).ask("routes") == {"routes": 10}
        assert confined.close() == 0  # went with what it was forked from


# What comes back


@pytest.fixture(scope="module")
def honest(trusting: Simulator) -> Episode:
    episode = simulate(trusting, CROSSES, scene(), RuleBased())
    assert isinstance(episode, Episode)
    return episode


def _read(message: dict[str, Any], episode: Episode) -> Episode:
    steps = len(episode.ego_track.x)
    return episode_from_json(message, scene_id=episode.scene_id, ego=episode.ego, dt=episode.dt, steps=steps)


def test_an_honest_episode_and_route_come_back_as_they_were(honest: Episode, trusting: Simulator) -> None:
    assert _same(_read(decode(encode(episode_to_json(honest)).strip()), honest), honest)
    route = trusting.route(CROSSES, 0)
    again: Route = route_from_json(decode(encode(route_to_json(route)).strip()))
    assert again.line.points.tolist() == route.line.points.tolist()
    assert (again.id, again.lane_ids, again.maneuver) == (route.id, route.lane_ids, route.maneuver)


WRONG: list[Any] = [None, True, -1, 10**400, 1e300, "", "<script>", "x" * 10_000, [], [[]], {}, [1] * 100_000]


@pytest.mark.parametrize("wrong", WRONG, ids=lambda wrong: str(wrong)[:12])
def test_no_field_of_an_episode_is_believed(wrong: Any, honest: Episode) -> None:
    true = json.loads(encode(episode_to_json(honest)))
    for key, value in true.items():
        if wrong != value and (key, wrong) != ("reached", {}):  # nobody need have a plan
            with pytest.raises(SandboxError, match="nonsense"):
                _read({**true, key: wrong}, honest)
    assert true["reached"]
    for key in ("behavior", "phase"):
        message = deepcopy(true)
        message["reached"]["adversary"][key] = wrong
        with pytest.raises(SandboxError, match="nonsense"):
            _read(message, honest)
    for key in true["tracks"][0]:
        message = deepcopy(true)
        message["tracks"][1][key] = wrong
        if key not in ("length", "width") or wrong is not True:
            with pytest.raises(SandboxError, match="nonsense"):
                _read(message, honest)


@pytest.mark.parametrize("line", [b"", b"[", b"[" * 100_000, b"5", b'{"a":NaN}', b'{"a":-Infinity}', b"\xff", b'"x"'])
def test_a_line_that_is_no_object_is_refused(line: bytes) -> None:
    with pytest.raises(SandboxError, match="nonsense"):
        decode(line)


@given(st.text(max_size=1000))
def test_words_of_a_stranger_are_fit_for_a_terminal(text: str) -> None:
    shown = words(text)
    assert len(shown) <= 500
    assert shown.isascii()
    assert shown.isprintable() or not shown


@pytest.mark.parametrize("said", ["light = 'night'", "weather = 'rain'", "surface = 'wet'"])
def test_a_program_may_say_light_weather_and_surface(said: str) -> None:
    program = f"param {said}\nmodel chatscene.world.model\nego = new Car at (0, 0)\n"
    assert not [one for one in check_foreign(program) if "param" in str(one)]


@pytest.mark.parametrize("said", ["light = 'pitch'", "weather = Range(0, 1)", "surface = 1"])
def test_a_program_may_say_no_light_weather_or_surface_that_there_is_not(said: str) -> None:
    program = f"param {said}\nmodel chatscene.world.model\nego = new Car at (0, 0)\n"
    assert [one for one in check_foreign(program) if "it is one of" in str(one)]


def test_the_engine_is_loaded_before_the_walls_are_up_on_any_map(monkeypatch: pytest.MonkeyPatch) -> None:
    def no_place(*_: object, **__: object) -> object:
        raise MapError("the map has no such road")

    monkeypatch.setattr("chatscene.simulate.stepped.SteppedSimulator.open", no_place)
    engine.cache_clear()
    _warmed_up(resolve_map("town"), SimulationSettings())
    assert engine.cache_info().currsize == 1
