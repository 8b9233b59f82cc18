"""Scenic's own tests of dynamics and of modular scenarios, run in our stepped loop in place of Scenic's.

    python benchmarks/scenic_loop.py SCENIC [pytest's options]

SCENIC is a tree of Scenic 3.1.1 with its `tests`; nothing in it is changed. The tests simulate in a simulator that
does almost nothing. This file is the plug-in of pytest that has that simulator driven by `SteppedLoop`: open, check,
advance, finish.

Two tests are left out: they expect Scenic's warning about a behavior or a compose block that takes long to act. Our
loop does not give it: its steps have no alarm of their own, and a watchdog ends a whole drive with `StuckBehavior`.
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

import pytest
from scenic.core.simulators import DummySimulation, DummySimulator, SimulationResult, TerminationType

from chatscene.simulate.simulation import SteppedLoop

TESTS = ("tests/syntax/test_dynamics.py", "tests/syntax/test_modular.py")
LEFT_OUT = ("tests/syntax/test_dynamics.py::test_behavior_stuck", "tests/syntax/test_modular.py::test_scenario_stuck")


class SteppedDummy(SteppedLoop, DummySimulation):
    """Scenic's simulation that does almost nothing, made and driven by our loop."""

    def __init__(self, scene: Any, drift: float = 0, **options: Any) -> None:
        super().__init__(scene, 1.0 if options["timestep"] is None else float(options["timestep"]))
        self.drift = drift
        self.name = options["name"]
        try:
            with self:
                self._drive(options["maxSteps"])
                self.finish()
        except self.REJECTIONS as error:
            error.simulation = self  # type: ignore[union-attr]
            raise
        self.result = SimulationResult(self.trajectory, self.actionSequence, self.how, self.done, self.records)

    def _drive(self, limit: int | None) -> None:
        self._watched = True  # the tests want the trajectory of every simulation
        self.updateObjects()
        while True:
            self.check()
            if self.done is None and limit and self.currentTime >= limit:
                self.how, self.done = TerminationType.timeLimit, f"reached time limit ({limit} steps)"
            if self.done is None:
                self.advance()
            if self.done is not None:
                return

    def act(self, chosen: list[tuple[Any, tuple[Any, ...]]]) -> None:
        """Keep what was chosen: the tests compare that, and take things for actions that are none."""
        self.actionSequence.append(dict(chosen))


def _create_simulation(self: DummySimulator, scene: Any, **options: Any) -> SteppedDummy:
    return SteppedDummy(scene, drift=self.drift, **options)


def pytest_configure() -> None:
    """Have Scenic's simulator for tests make our simulation."""
    DummySimulator.createSimulation = _create_simulation


def main(tree: str, *options: str) -> int:
    """Run the tests; pytest's exit status."""
    sys.path.insert(0, str(Path(__file__).parent))
    left_out = [argument for test in LEFT_OUT for argument in ("--deselect", test)]
    ours = ["-p", Path(__file__).stem, "-p", "no:randomly", "-p", "no:cacheprovider", "--skip-pegen", "-q"]
    tests = [str(Path(tree) / test) for test in TESTS]
    return int(pytest.main([*ours, "--rootdir", tree, *left_out, *tests, *options]))


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
