"""The benchmark of others' programs: how far each came is told by what was done, not by the words of an error."""

from __future__ import annotations

import importlib
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest

from chatscene.errors import ChatSceneError, DoesNotCompile, ProgramError, StuckBehavior
from chatscene.search.generators.foreign import read_foreign
from chatscene.terms.scene import Rejected, Scene, ScenicProgram


@dataclass
class Fails:
    """A simulator that fails at a stage, or rejects the scene there."""

    at: str
    error: ChatSceneError | None
    rejection: str = ""
    ending: None = None
    step_number: int = 0
    observation: tuple[float, ...] = ()

    def routes(self, _program: ScenicProgram) -> int:
        self._fail("compile")
        return 1

    def open(self, _program: ScenicProgram, scene: Scene, **_how: Any) -> Any:
        self._fail("draw")
        return Rejected(scene=scene, reason="no place") if self.at == "draw" else self

    def step(self, _action: object) -> None:
        self._fail("drive")
        self.rejection = "it gives up"

    def close(self) -> None:
        pass

    def _fail(self, stage: str) -> None:
        if self.at == stage and self.error is not None:
            raise self.error


class _Still:
    """An ego that does nothing."""

    name = "still"

    def act(self, _observation: object) -> tuple[float, float]:
        return 0.0, 0.0


@pytest.mark.parametrize(
    ("at", "error", "stages"),
    [
        ("compile", DoesNotCompile("x"), (False, 0, 0)),
        ("compile", StuckBehavior("x, being compiled, computes for ever"), (False, 0, 0)),
        ("draw", ProgramError("x fails where it is placed"), (True, 0, 0)),
        ("draw", StuckBehavior("x (open) computes for ever"), (True, 0, 0)),
        ("draw", None, (True, 0, 0)),
        ("drive", ProgramError("x fails: the brake is set up badly"), (True, 1, 0)),
        ("drive", None, (True, 1, 0)),
    ],
)
def test_how_far_a_program_came_is_told_by_what_was_done(
    at: str,
    error: ChatSceneError | None,
    stages: tuple[bool, int, int],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.syspath_prepend(str(Path(__file__).parents[2] / "benchmarks"))
    bench = importlib.import_module("programs_in")
    (tmp_path / "x.scenic").write_text("model scenic.domains.driving.model\nego = new Car\n")
    own, row = read_foreign(tmp_path / "x.scenic"), bench.Row("x")
    run = bench.Running([], _Still(), False, 1, 1, 0, False, None, {}, {tmp_path: Fails(at, error)})
    assert bench.driven(own, tmp_path, row, run) == []
    assert (row.compiles, row.samples, row.runs) == stages


def test_a_program_runs_on_the_map_that_it_names_if_that_is_there(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.syspath_prepend(str(Path(__file__).parents[2] / "benchmarks"))
    bench = importlib.import_module("programs_in")
    own = tmp_path / "x.scenic"
    own.write_text("param map = localPath('own.xodr')\nmodel scenic.domains.driving.model\nego = new Car\n")
    elsewhere = [tmp_path / "other.xodr"]
    assert bench.maps_of(read_foreign(own), elsewhere) == elsewhere
    (tmp_path / "own.xodr").write_text("")
    assert bench.maps_of(read_foreign(own), elsewhere) == [tmp_path / "own.xodr"]
