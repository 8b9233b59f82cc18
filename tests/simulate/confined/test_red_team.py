"""An enemy's programs: none gets anything, and none keeps anybody waiting."""

import subprocess
import sys
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from chatscene.errors import ForeignCodeRefused, NothingFits
from chatscene.maps.network import resolve_map
from chatscene.pipeline import understand
from chatscene.search.generators.foreign import foreign_program
from chatscene.settings import SimulationSettings
from chatscene.simulate.confined import child
from chatscene.simulate.confined.allow_list import check_foreign
from chatscene.simulate.confined.landlock import landlock_version
from chatscene.simulate.confined.nursery import Nursery
from chatscene.simulate.confined.simulator import ConfinedSimulator
from chatscene.simulate.watchdog import BACKSTOP, PATIENCE
from chatscene.terms.scene import ScenicProgram
from outright import decompose
from red_team import table as table_of
from red_team.attempt import LIMITS, SECRET, Canaries, Listener, attempt
from red_team.corpus import ATTACKS, SENTENCES, Attack
from red_team.table import BEGIN, END, PAGE, recorded, table

OUTCOMES = recorded()
PATIENT = replace(LIMITS, answer=PATIENCE, wall=BACKSTOP)  # what comes to an end does so on a busy machine, too
IMPATIENT = replace(LIMITS, answer=0.5, wall=2.0)

UNWATCHED = Path(table_of.__file__).with_name("unwatched_child.py")
PROCESSES = ("fork", "fork-bomb", "thread", "leave-the-group")  # what no layer but the filter on system calls forbids
LATER = {  # what ends a program on newer Pythons, where that is another thing than what was recorded with 3.11
    "recursion-in-c": "an error of its own",  # before it breaks the stack
    "thread": "watchman",  # who is told of threads from then on
}

NAMES = [attack.name for attack in ATTACKS]
REFUSED = [attack for attack in ATTACKS if not attack.listed]
RUN = [attack for attack in ATTACKS if attack.runs]


@pytest.fixture(scope="module")
def canaries(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Canaries]:
    with Listener() as listener:
        canaries = Canaries(tmp_path_factory.mktemp("canaries"), listener.port, listener.callers)
        canaries.secret.write_text(SECRET)
        yield canaries


@pytest.fixture(scope="module")
def nursery() -> Iterator[Nursery]:
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("CANARY", SECRET)
        with Nursery(resolve_map("town"), SimulationSettings(), LIMITS) as nursery:
            yield nursery


@pytest.fixture(scope="module")
def unwatched() -> Iterator[Nursery]:
    """Whose confined processes have no watchman, only the kernel's walls."""
    started = subprocess.Popen

    def start(command: list[str], **how: Any) -> Any:
        assert command[1:4] == ["-I", "-m", child.__name__]
        return started([command[0], "-I", str(UNWATCHED), *command[4:]], **how)

    program = ScenicProgram(scenario_id="x", source="", parameters=(), snippet_ids=())
    with Nursery(resolve_map("town"), SimulationSettings(), LIMITS) as nursery:
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(subprocess, "Popen", start)
            nursery.confine(program).close()
        yield nursery


def name(attack: Attack) -> str:
    return attack.name


def expected_of(attack: Attack) -> str:
    """What stops a program behind the second wall, with this Python."""
    recorded_of = OUTCOMES[attack.name]
    return LATER.get(attack.name, recorded_of) if sys.version_info >= (3, 12) else recorded_of


def test_the_corpus_has_enough_programs_each_with_a_name() -> None:
    assert len(ATTACKS) >= 60
    assert len(set(NAMES)) == len(NAMES)


@pytest.mark.parametrize("attack", REFUSED, ids=name)
def test_the_allow_list_refuses(attack: Attack) -> None:
    with pytest.raises(ForeignCodeRefused, match=r"^your program x: (.+): .+") as why:
        foreign_program("x", attack.source)
    assert str(why.value).replace("\n", "").isprintable()


@pytest.mark.parametrize("attack", [a for a in ATTACKS if a.listed], ids=name)
def test_a_list_of_words_cannot_tell_how_long_a_program_takes(attack: Attack) -> None:
    assert check_foreign(attack.source) == ()


@pytest.mark.parametrize("attack", RUN, ids=name)
def test_the_second_wall_holds_by_itself(attack: Attack, nursery: Nursery, canaries: Canaries) -> None:
    expected = expected_of(attack)
    outcome = attempt(nursery, canaries.fill(attack.source), IMPATIENT if expected == "limits" else PATIENT)
    assert canaries.untouched()
    assert SECRET not in outcome.said
    assert outcome.stopped_by == expected
    assert outcome.stopped_by != "nobody" or attack.harmless


@pytest.mark.parametrize("attack", [a for a in RUN if expected_of(a) in ("watchman", "kernel")], ids=name)
def test_the_kernel_holds_whom_nobody_watches(attack: Attack, unwatched: Nursery, canaries: Canaries) -> None:
    outcome = attempt(unwatched, canaries.fill(attack.source), IMPATIENT)
    assert canaries.untouched()
    assert outcome.stopped_by != "watchman"
    assert SECRET not in outcome.said or landlock_version() == 0  # which files may be read is Landlock's to say
    assert outcome.stopped_by == "kernel" or attack.name not in PROCESSES


def test_no_process_is_started_for_what_the_allow_list_refuses(monkeypatch: pytest.MonkeyPatch) -> None:
    def start(*_: Any, **__: Any) -> None:
        raise AssertionError("a process was started")

    monkeypatch.setattr(subprocess, "Popen", start)
    simulator = ConfinedSimulator(resolve_map("town"), SimulationSettings())
    for attack in REFUSED[::12]:
        program = ScenicProgram(scenario_id="x", source=attack.source, parameters=(), snippet_ids=())
        with pytest.raises(ForeignCodeRefused):
            simulator.routes(program)


@pytest.mark.parametrize("sentence", SENTENCES)
def test_a_sentence_is_data_whatever_it_says(sentence: str, canaries: Canaries) -> None:
    text = canaries.fill(sentence)
    try:
        assert SECRET not in repr(decompose(text))
        program = understand(text).program
    except NothingFits as refusal:
        assert SECRET not in str(refusal)
    else:
        assert check_foreign(program.source) == ()
        code = "\n".join(line.partition("#")[0] for line in program.source.splitlines())
        assert "os" not in code.replace("position", "").replace("crossing", "").split()
        assert str(canaries.target) not in code
    assert canaries.untouched()


def test_the_page_shows_what_was_recorded() -> None:
    page = PAGE.read_text(encoding="utf-8")
    assert page.partition(BEGIN)[2].partition(END)[0].strip() == table(OUTCOMES)
    assert set(OUTCOMES) == {attack.name for attack in RUN}
    assert set(OUTCOMES.values()) <= {
        "watchman", "kernel", "limits", "checked answers", "an error of its own", "its own end", "nobody",
    }  # fmt: skip
