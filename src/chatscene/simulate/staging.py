"""From a scene's concrete values to Scenic's scene: nothing is drawn, everything is set."""

from __future__ import annotations

import random
from collections import OrderedDict
from collections.abc import Callable
from pathlib import Path
from typing import Any

from scenic.core.distributions import RejectionException
from scenic.core.sample_checking import SampleChecker

from chatscene.errors import ProgramError
from chatscene.maps.network import load_network
from chatscene.simulate.watchdog import time_limit
from chatscene.terms.scene import Rejected, Scene, ScenicProgram
from chatscene.world.compilation import compile_program

_open: list[Callable[[], None]] = []  # how to end the session that is open in this process
NO_PLACE = "a place that the program asks for, such as the edge of the road, is not there"
COMPILED = 16  # programs kept per process; a compiled one holds a few MB


def take_process(end: Callable[[], None]) -> None:
    """Say that a session is open in this process, and how it is ended where another needs the process."""
    free_process()
    _open.append(end)


def free_process() -> None:
    """End the session that is open in this process, if any: Scenic compiles and runs one program at a time."""
    while _open:
        _open.pop()()


class _InOrder(SampleChecker):
    """Checks the program's own requirements in the order they are written.

    Scenic's checker orders them by measured time, which would make the reason of a rejection a matter of luck;
    overlaps are checked on the bodies instead (`chatscene.simulate.session`).
    """

    reason = ""

    def setRequirements(self, requirements: Any) -> None:  # noqa: N802 - Scenic's name
        super().setRequirements([req for req in requirements if hasattr(req, "prob")])

    def checkRequirementsInner(self, sample: Any) -> Any:  # noqa: N802
        for req in self.requirements or ():
            if req.active and req.falsifiedBy(sample):
                self.reason = str(req.violationMsg)
                return self.reason
        return None


class Stage:
    """The compiled programs of one map, ready to have values set in them."""

    def __init__(self, map_path: Path) -> None:
        self._map_path = map_path
        self._compiled: OrderedDict[tuple[str, int], Any] = OrderedDict()

    def compiled(self, program: ScenicProgram, route: int) -> Any:
        """Scenic's scenario for a program on one of its routes.

        Raises:
            DoesNotCompile: Scenic refuses the program.
            MapError: The map has no such route.
            StuckBehavior: It does not come to its end.
        """
        key = (program.digest, route)
        if key not in self._compiled:
            free_process()
            load_network(self._map_path)  # a large map takes its time, which is not the program's
            with time_limit(f"program {program.scenario_id!r}, being compiled,"):
                scenario = compile_program(
                    program.source, map_path=self._map_path, route=route, filename=f"<{program.scenario_id}>"
                )
            scenario.setSampleChecker(_InOrder())
            self._compiled[key] = scenario
            while len(self._compiled) > COMPILED:
                self._compiled.popitem(last=False)
        self._compiled.move_to_end(key)
        return self._compiled[key]

    def place(self, program: ScenicProgram, scene: Scene) -> Any | Rejected:
        """Scenic's scene with the values of ours, or why there is none.

        Raises:
            ProgramError: The scene has not a value for every parameter, or the program cannot be evaluated.
        """
        scenario = self.compiled(program, scene.route)
        declared = {name for name in scenario.params if name.startswith("OPT_")}
        if declared != set(scene.values):
            raise ProgramError(
                f"scene {scene.id!r} has values for {sorted(scene.values)}, its program tunes {sorted(declared)}"
            )
        if scene.values:
            scenario.conditionOn(params=dict(scene.values))
        random.seed(scene.seed)  # nothing of ours draws from it; a stranger's program might
        scenario.checker.reason = NO_PLACE
        try:
            return scenario.generate(maxIterations=1)[0]
        except RejectionException:
            return Rejected(scene=scene, reason=scenario.checker.reason)
