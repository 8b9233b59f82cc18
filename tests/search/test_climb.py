"""A program that shows something else gives way to the next best, and a sentence is refused when none shows it."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import pytest

from chatscene.ego.rule_based import RuleBased
from chatscene.errors import MeansSomethingElse, NothingFits
from chatscene.maps.network import resolve_map
from chatscene.pipeline import run
from chatscene.program.check import Checked
from chatscene.runs import asked_run, open_run, read_explanation
from chatscene.runs.rebuild import rebuild
from chatscene.search.climb import TRIES, climb, simulator_of
from chatscene.search.generator import Written
from chatscene.search.generators.retrieved import Retrieved
from chatscene.settings import RetrievalSettings, SearchSettings, Settings
from chatscene.terms.scenario import Scenario
from chatscene.terms.scene import ScenicProgram
from chatscene.terms.snippet import Tried
from outright import decompose

SCENARIO = decompose("A car brakes.")
SETTINGS = RetrievalSettings()
CYCLIST = "A cyclist crosses from the right in front of us."
CLIMBED = Checked(episodes=(), meaning=(), rejected=())


def program(number: int) -> ScenicProgram:
    return ScenicProgram(scenario_id=f"p{number}", source="", parameters=(), snippet_ids=())


class Counting(Retrieved):
    """Writes program after program, as many as it has."""

    def __init__(self, programs: int) -> None:
        self._left = [Written(program=program(i), retrieval=None) for i in range(1, programs)]
        self.tried: list[Sequence[Tried]] = []

    def write(self, scenario: Scenario, settings: RetrievalSettings, tried: Sequence[Tried] = ()) -> Written:
        self.tried.append(list(tried))
        if not self._left:
            raise NothingFits("nothing is left")
        return self._left.pop(0)


def climbing(
    monkeypatch: pytest.MonkeyPatch, programs: int, *, means_it: str, blamed: tuple[str, ...] = ("a",)
) -> tuple[str, list[Sequence[Tried]]]:
    """The name of the program that climbs, and what was tried before each writing."""

    def check(tried: ScenicProgram, *_: object) -> Checked:
        if tried.scenario_id == means_it:
            return CLIMBED
        raise MeansSomethingElse(f"{tried.scenario_id} shows something else", blamed=blamed)

    monkeypatch.setattr("chatscene.program.check.check", check)
    counting = Counting(programs)
    written, _ = climb(
        counting,
        SCENARIO,
        Written(program=program(0), retrieval=None),
        settings=SETTINGS,
        simulator=simulator_of(counting, resolve_map("town"), Settings()),
        ego=RuleBased(),
    )
    return written.program.scenario_id, counting.tried


def test_the_next_choice_climbs_where_better_ones_show_something_else(monkeypatch: pytest.MonkeyPatch) -> None:
    climbed, tried = climbing(monkeypatch, 4, means_it="p2")
    assert climbed == "p2"
    assert [[one.reason for one in before] for before in tried] == [
        ["p0 shows something else"],
        ["p0 shows something else", "p1 shows something else"],
    ]


@pytest.mark.parametrize("programs", [2, TRIES + 5], ids=["nothing is left", "all tries are spent"])
def test_a_refusal_speaks_of_the_first_choice(programs: int, monkeypatch: pytest.MonkeyPatch) -> None:
    with pytest.raises(MeansSomethingElse, match=r"^p0 shows"):
        climbing(monkeypatch, programs, means_it=f"p{TRIES}")


def test_a_program_without_snippets_is_tried_once(monkeypatch: pytest.MonkeyPatch) -> None:
    with pytest.raises(MeansSomethingElse, match=r"^p0 shows"):
        climbing(monkeypatch, 2, means_it="p1", blamed=())


def test_what_was_tried_together_is_not_chosen_together_again() -> None:
    scenario = Retrieved().read(CYCLIST, SETTINGS)
    chosen = [Retrieved().write(scenario, SETTINGS)]
    for _ in range(3):
        ids = chosen[-1].program.snippet_ids
        assert chosen[-1].retrieval is not None
        before = chosen[-1].retrieval.tried
        chosen.append(Retrieved().write(scenario, SETTINGS, [*before, Tried(snippet_ids=ids[1:], reason="")]))
    assert len({written.program.snippet_ids[1:] for written in chosen}) == 4


def test_a_run_goes_on_with_the_choice_that_climbed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    first = Retrieved().write(Retrieved().read(CYCLIST, SETTINGS), SETTINGS)

    def check(tried: ScenicProgram, *_: object) -> Checked:
        if tried.snippet_ids == first.program.snippet_ids:
            raise MeansSomethingElse("it shows something else", blamed=tried.snippet_ids)
        return CLIMBED

    monkeypatch.setattr("chatscene.program.check.check", check)
    few = Settings(search=SearchSettings(scenes=2, block=2))
    run(asked_run(CYCLIST, settings=few, ego="rule-based"), tmp_path / "run")
    kept = open_run(tmp_path / "run")
    assert read_explanation(kept)["scenarios"][0]["tried"]
    rebuilt = rebuild(kept).program
    assert rebuilt.snippet_ids != first.program.snippet_ids
