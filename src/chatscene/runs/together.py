"""Runs whose scenes are driven together: they may lie on several maps, and are simulated alike."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, replace

from chatscene.errors import RunError
from chatscene.runs.record import RunRecord, settings_of
from chatscene.runs.workspace import Workspace
from chatscene.settings import SimulationSettings

_CALLED = {"dt": "step [s]", "max_steps": "most steps of a drive"}  # others are called what they are
_OPTIONS = ("simulator", "physics")  # those of which the user may name one for all


def simulated_alike(
    found: Sequence[Workspace], records: Sequence[RunRecord], *, simulator: str, physics: str
) -> SimulationSettings:
    """How the scenes of runs are simulated: as they were, or all in another simulator or with another physics.

    Raises:
        RunError: They were not simulated alike.
    """
    first, *others = (_simulation(record, simulator, physics) for record in records)
    for run, other in zip(found[1:], others, strict=True):
        if other != first:
            raise RunError(f"{run.path} and {found[0].path} {_difference(asdict(other), asdict(first))}")
    return first


def _simulation(record: RunRecord, simulator: str, physics: str) -> SimulationSettings:
    simulation = settings_of(record).simulation
    return replace(simulation, simulator=simulator or simulation.simulator, physics=physics or simulation.physics)


def _difference(one: dict[str, object], other: dict[str, object]) -> str:
    """In what two differ, with both values, and what to do."""
    differ = [name for name in one if one[name] != other[name]]
    told = ", ".join(f"{_CALLED.get(name, name)} ({_value(one[name])} and {_value(other[name])})" for name in differ)
    named = " ".join(f"--{name} {other[name]}" for name in differ if name in _OPTIONS)
    todo = [f"name one for all, as with {named}"] if named else []
    if any(name not in _OPTIONS for name in differ):
        todo.append("repeat one run with the other's settings, or take each by itself")
    return f"differ in {told}; {'; and '.join(todo)}"


def _value(value: object) -> str:
    return ("on" if value else "off") if isinstance(value, bool) else str(value)
