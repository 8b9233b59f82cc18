# pyright: reportUnknownLambdaType=false, reportUnknownArgumentType=false
"""What is packaged keeps the contract of its kind, and the functions that say so find what does not."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable, Sequence
from dataclasses import replace
from itertools import islice
from types import SimpleNamespace
from typing import Any

import pytest

from chatscene.ego.policy import EGOS
from chatscene.errors import MissingExtra
from chatscene.exports.exporter import EXPORTERS
from chatscene.models.language.checked import CheckedModel
from chatscene.models.language.protocol import Limits
from chatscene.models.language.scripted import Scripted
from chatscene.read.reader import READERS, check_text
from chatscene.runs.executor import EXECUTORS
from chatscene.search.generator import GENERATORS
from chatscene.search.sampler import SAMPLERS, Proposal
from chatscene.search.samplers.grid import grid
from chatscene.search.samplers.unit_cube import UnitCube
from chatscene.situations.form import from_plain
from chatscene.terms.reading import Ranked, SituationReading, Verdict
from chatscene.terms.scene import AS_WRITTEN
from chatscene.terms.snippet import ParameterRange
from chatscene.testing import (
    ContractBroken,
    check_ego,
    check_executor,
    check_exporter,
    check_generator,
    check_language_model,
    check_reader,
    check_sampler,
)
from chatscene.testing.language_models import PROMPT
from places import GOLDEN

OWN_PROGRAM = GOLDEN / "stops.scenic"


@pytest.mark.parametrize("name", sorted(EGOS.built_in))
def test_every_ego_keeps_the_contract(name: str) -> None:
    check_ego(name)


@pytest.mark.parametrize("name", sorted(SAMPLERS.built_in))
def test_every_sampler_keeps_the_contract(name: str) -> None:
    try:
        check_sampler(name)
    except MissingExtra as error:
        pytest.skip(str(error))


@pytest.mark.parametrize("name", sorted(EXPORTERS.built_in))
def test_every_exporter_keeps_the_contract(name: str) -> None:
    try:
        check_exporter(name)
    except MissingExtra as error:
        pytest.skip(str(error))


@pytest.mark.parametrize("name", sorted(EXECUTORS.built_in))
def test_every_executor_keeps_the_contract(name: str) -> None:
    if name == "ray":
        pytest.skip("a cluster takes longer than all other tests of plug-ins: python benchmarks/two_nodes.py")
    check_executor(name)


@pytest.mark.parametrize("name", sorted(READERS.built_in))
def test_every_reader_keeps_the_contract(name: str) -> None:
    check_reader(name)


def _read(text: str, differs: dict[str, Any]) -> SituationReading:
    check_text(text)
    none = SituationReading(text=text, reader="mine", verdict=Verdict.NO_SITUATION, tells=0.0)
    return replace(none, **differs)


BRAKES = from_plain(
    {
        "others": [{"id": "A", "kind": "car", "starts": {"where": "ahead"}, "does": [{"act": "brake"}]}],
        "evidence": {"quoted": {"others.A.does.0.act": "stops dead"}},
    }
)


@pytest.mark.parametrize(
    ("differs", "rule"),
    [
        ({}, None),
        ({"text": "x"}, "has its text"),
        ({"reader": "yours"}, "the name of its reader"),
        ({"tells": 1.5}, r"in \[0, 1\]"),
        ({"verdict": Verdict.SITUATION}, "has situations if its verdict says so"),
        ({"unread": ("nowhere",)}, "stands in the text"),
        (
            {"verdict": Verdict.SITUATION, "ranked": (Ranked(situation=BRAKES, probability=1.0),)},
            "are words of the text.*'stops dead'",
        ),
        (
            {"verdict": Verdict.SITUATION, "ranked": (Ranked(situation=BRAKES, probability=0.7),) * 2},
            "all of them together",
        ),
    ],
)
def test_a_reader_that_breaks_a_rule_is_told_which(differs: dict[str, Any], rule: str | None) -> None:
    one: Any = SimpleNamespace(name="mine", read=lambda text: _read(text, differs))
    if rule is None:
        return check_reader(lambda: one)
    with pytest.raises(ContractBroken, match=rule):
        check_reader(lambda: one)


PROGRAMS = ("program", "program-as-written")


@pytest.mark.parametrize("name", sorted(set(GENERATORS.built_in) - {*PROGRAMS, "situation"}))
def test_every_generator_keeps_the_contract(name: str) -> None:
    check_generator(name)


@pytest.mark.parametrize("name", PROGRAMS)
def test_a_program_of_ones_own_keeps_the_contract_of_generators(name: str) -> None:
    text = OWN_PROGRAM.read_text(encoding="utf-8")
    if name == "program-as-written":  # its ego is told something
        ego = text.index("ego = new Car")
        does = f"behavior {AS_WRITTEN}():\n    do DrivePath(egoRoute, 8)\n"
        told = text[ego:].replace("ego = new Car ", f"ego = new Car with behavior {AS_WRITTEN}(), ", 1)
        text = text[:ego] + does + told
    check_generator(name, text=text)


def test_a_situation_keeps_the_contract_of_generators() -> None:
    ahead = "others: [{id: A, kind: car, starts: {where: ahead}, does: [{act: brake}]}]"
    check_generator("situation", text=ahead)


def test_a_scripted_model_keeps_the_contract() -> None:
    script = {PROMPT.text: '{"who": "pedestrian", "count": 1}'}
    check_language_model(CheckedModel(Scripted(script), limits=Limits(reasks=1)))


class Ego:
    """An ego that does what a function says."""

    def __init__(self, act: Callable[[Any, int], Any], observation: str = "safebench") -> None:
        self._act, self._calls, self.observation = act, 0, observation

    def act(self, observation: Any) -> Any:
        self._calls += 1
        return self._act(observation, self._calls)


def blind(observation: Any, _: int) -> tuple[float, float]:
    observation[:] = 0.0
    return 0.0, 0.0


@pytest.mark.parametrize(
    ("ego", "rule"),
    [
        (Ego(lambda _, n: (0.01 * n, 0.0)), "the same observations since reset give the same actions"),
        (Ego(lambda *_: (3.0, 0.0)), r"lie in \[-1, 1\]; found: \(3.0, 0.0\)"),
        (Ego(lambda *_: (float("nan"), 0.0)), "two finite numbers"),
        (Ego(lambda *_: None), "two finite numbers"),
        (Ego(blind), "leaves what it is shown as it is"),
        (Ego(lambda *_: (0.0, 0.0), "lidar"), "no observation 'lidar'"),
        (object(), "has a method act"),
    ],
)
def test_an_ego_that_breaks_a_rule_is_told_which(ego: Any, rule: str) -> None:
    with pytest.raises(ContractBroken, match=rule):
        check_ego(ego)


class Sampler:
    """A sampler that draws the same place again and again, or as a function says."""

    def __init__(self, draw: Callable[[ParameterRange, int], float]) -> None:
        self._draw = draw

    def propose(self, declared: Sequence[ParameterRange], done: Any, *, count: int, seed: int) -> Proposal:
        return Proposal(ranges=tuple(declared), draw=lambda s: {p.name: self._draw(p, s) for p in declared})


@pytest.mark.parametrize(
    ("draw", "rule"),
    [
        (lambda p, _: p.high + 1.0, "in its declared range"),
        (lambda p, _: p.low, "is followed by another; found: 1 of 40 differ"),
        (lambda p, s: p.low + (p.high - p.low) / 3.0, "at most six decimals"),
        (lambda p, _: round(p.low), "every value is a float"),
    ],
)
def test_a_sampler_that_breaks_a_rule_is_told_which(draw: Callable[[Any, int], float], rule: str) -> None:
    with pytest.raises(ContractBroken, match=rule):
        check_sampler(lambda: Sampler(draw))


def test_a_sampler_that_walks_a_sequence_and_forgets_what_could_not_be_placed_is_told_how_to_go_on() -> None:
    class Walks:
        def propose(self, declared: Sequence[ParameterRange], done: Any, *, count: int, seed: int) -> Proposal:
            cube = UnitCube(tuple(declared))
            walk = islice(grid(len(cube.free)), sum(map(len, done)), None)
            return Proposal(ranges=cube.declared, draw=lambda _: cube.values(next(walk)))

    with pytest.raises(ContractBroken, match=r"of 40 scenes \d\d differ; .*unit_cube\.walk_on"):
        check_sampler(Walks)


def test_no_test_runner_is_needed() -> None:
    code = "import sys, chatscene.testing; print({'pytest', 'hypothesis'} & {*sys.modules})"
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout == "set()\n"
