"""How far everybody of a drive is in the plan of the program that it follows."""

from __future__ import annotations

from chatscene.simulate.over import Over
from chatscene.simulate.simulation import SteppedSimulation
from chatscene.terms.episode import Reached
from chatscene.terms.written_plans import WrittenPlan, written_plans


class FollowedPlans:
    """The plans of a program, and how far who follows them is.

    Attributes:
        plans: The plans in the text by the names of their behaviors.
    """

    def __init__(self, source: str, simulation: SteppedSimulation) -> None:
        self.plans = written_plans(source)
        self._simulation = simulation

    def in_plan(self, number: int, phase: int) -> Reached:
        """That an object is so far in its plan."""
        return Reached(behavior=type(self._simulation.objects[number].behavior).__name__, phase=phase)

    def plan_of(self, number: int) -> WrittenPlan | None:
        """The plan of the program's own that an object follows."""
        plan = self.plans.get(type(self._simulation.objects[number].behavior).__name__)
        return plan if isinstance(plan, WrittenPlan) else None

    def reached(self) -> dict[int, int]:
        """How far everybody is who follows a plan: the phase whose line the behavior stands at."""
        found = {number: self.phase_of(number) for number in range(len(self._simulation.objects))}
        return {number: phase for number, phase in found.items() if phase >= 0}

    def phase_of(self, number: int) -> int:
        """How far an object is in its plan; -1 if it follows none."""
        plan = self.plan_of(number)
        running = getattr(self._simulation.objects[number].behavior, "_runningIterator", None)
        if plan is None or running is None:
            return -1
        frame = running.gi_frame
        return len(plan.lines) if frame is None else plan.phase_at(frame.f_lineno)

    def all_phases(self, over: Over) -> dict[int, int]:
        """How far everybody is who acts; of one that does one thing alone, 0, or 1 once that is done."""
        found: dict[int, int] = {}
        for one in over.acting:
            if (phase := self.phase_of(one.number)) < 0:
                running = getattr(self._simulation.objects[one.number].behavior, "_runningIterator", None)
                phase = int(running is not None and running.gi_frame is None)
            found[one.number] = phase
        return found
