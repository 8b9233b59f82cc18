"""What an evaluation yields, and the tables made of it.

Paper: section 4 (setup, tables 1 and 2), appendix (tables of each ego).
"""

from __future__ import annotations

from dataclasses import dataclass

from chatscene.terms.metrics import Measurements
from chatscene.terms.scenario import BaseScenario


@dataclass(frozen=True, slots=True, kw_only=True)
class Drive:
    """One ego's drive through one kept scene.

    Attributes:
        route: Index of the route on the map, for the scenario's geometry.
        map_name: The map; empty where all that is counted together lies on one.
        fill_in: The scene did not collide with the surrogate ego; it was kept because too few did.
        avoidable: Whether a careful driver would have avoided the collision; None without one.
        fault: Whose own motion closed the gap at the collision; None without one.
        by_selection: The scene was kept for what this very ego did in it.
    """

    generator: str
    base_scenario: BaseScenario
    scenario_id: str
    route: int
    scene_id: str
    ego: str
    measurements: Measurements
    fill_in: bool
    avoidable: bool | None
    fault: str | None
    by_selection: bool = False
    map_name: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class Displacement:
    """The average displacement (ADE) of the scenes of one scenario on one route under one ego.

    Attributes:
        route: Index of the route on the map, for the scenario's geometry.
        map_name: The map; empty where all that is counted together lies on one.
        value: The ADE [m].
    """

    generator: str
    base_scenario: BaseScenario
    scenario_id: str
    route: int
    ego: str
    value: float
    map_name: str = ""


@dataclass(frozen=True, slots=True)
class Cell:
    """A number and its confidence interval.

    Attributes:
        value: The number; None where there is nothing to compute it from.
        low: Lower end of the interval; None where none can be given.
        high: Upper end of the interval; None where none can be given.
        by_selection: What was selected for; it has no interval, as it estimates nothing.
    """

    value: float | None
    low: float | None = None
    high: float | None = None
    by_selection: bool = False


@dataclass(frozen=True, slots=True, kw_only=True)
class ResultTable:
    """A table of numbers with intervals.

    Attributes:
        columns: Heads of the columns, without the one over the rows' labels.
        rows: The label of each row and its cells, one per column.
        notes: Which interval, which mode, how many.
    """

    title: str
    columns: tuple[str, ...]
    rows: tuple[tuple[str, tuple[Cell, ...]], ...]
    notes: tuple[str, ...]
