"""How long a program is probed that cannot be placed, and what is said of it."""

from __future__ import annotations

from typing import cast

import pytest

from chatscene.ego.rule_based import RuleBased
from chatscene.errors import Unsatisfiable
from chatscene.program.check import DRAWN_PROBES, PROBES, check
from chatscene.simulate.simulator import Simulator
from chatscene.terms.scenario import Slots
from chatscene.terms.scene import OWN_MODEL, Rejected, Scene, ScenicProgram


class Full:
    """A world in which nobody can be placed: mostly there is no room, the last time another reason."""

    def __init__(self) -> None:
        self.tried: list[Scene] = []

    def open(self, _: ScenicProgram, scene: Scene, **__: object) -> Rejected:
        """Nothing."""
        self.tried.append(scene)
        return Rejected(scene=scene, reason="no room" if len(self.tried) != DRAWN_PROBES else "no road")


def refused(model: str) -> tuple[str, Full]:
    """What is said of a program for a world model that can never be placed, and what was tried."""
    program = ScenicProgram(scenario_id="toy", source="", parameters=(), snippet_ids=(), model=model, own="toy")
    full = Full()
    with pytest.raises(Unsatisfiable) as told:
        check(program, Slots(), cast("Simulator", full), RuleBased())
    return str(told.value), full


def test_a_program_that_draws_its_scenes_is_told_that_probing_ended_early() -> None:
    said, full = refused("scenic.domains.driving.model")
    assert said == (
        "your program toy: none of 3 probing scenes could be placed; most often: no room; "
        "no more were tried, since each takes its time to be drawn"
    )
    assert len(full.tried) == DRAWN_PROBES < len(PROBES)


def test_a_program_whose_scenes_are_its_parameters_is_probed_to_the_end_and_nothing_is_said_of_time() -> None:
    said, full = refused(OWN_MODEL)
    assert said == f"your program toy: none of {len(PROBES)} probing scenes could be placed; most often: no room"
    assert len(full.tried) == len(PROBES)
