"""The result tables, in the paper's layout, each number with its interval.

Paper: table 1 (`generation_table`), table 2 (`diagnostic_table`), tables 4 and 5 (`ego_table`). How it averages was
read off its numbers: a base scenario's number is the mean over the egos, the last column the mean over the base
scenarios. The other tables are ours. Decision 0014 says which interval is used where.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Literal, TypeVar

import numpy as np

from chatscene.measure.intervals import DRAWS, percentiles, resample_means, resample_scores
from chatscene.measure.score import score, wilson
from chatscene.terms.arrays import Array
from chatscene.terms.criticality import Fault
from chatscene.terms.metrics import Mode
from chatscene.terms.results import Cell, Displacement, Drive, ResultTable
from chatscene.terms.scenario import BaseScenario

Which = Literal["collision_rate", "overall_score", "completion"]
D = TypeVar("D", Drive, Displacement)
K = TypeVar("K", bound=str)

MISSING = Cell(None)
BASES = tuple(base.replace("-", " ").capitalize() for base in BaseScenario)
ABBREVIATIONS = {
    "collision_rate": "CR", "red_light": "RR", "stop_sign": "SS", "off_road": "OR", "route_following": "RF",
    "completion": "Comp", "time_spent": "TS", "acceleration": "ACC", "yaw_velocity": "YV", "lane_invasion": "LI",
    "overall_score": "OS",
}  # fmt: skip
TITLES: dict[Which, str] = {
    "collision_rate": "Collision rate (CR) of each ego",
    "overall_score": "Overall score (OS) of each ego",
    "completion": "Route completion (Comp) of each ego",
}

WILSON = "95 % Wilson interval that takes drives for independent"
FEW_ROUTES = f"CR of a base scenario with too few routes, or where all or none collided: {WILSON}"
BOOTSTRAP = (
    f"95 % cluster bootstrap over the routes of a base scenario, {DRAWS} draws; none where they are too few or alike."
    " Scenarios, egos and their trainings are not resampled: how others would differ is in no interval"
)


def generation_table(drives: Sequence[Drive], displacements: Sequence[Displacement], mode: Mode) -> ResultTable:
    """Table 1: collision rate, overall score and displacement of each generator on each base scenario.

    Args:
        drives: Of any generators and egos, in any order.
        displacements: Of the same.
        mode: How the overall score is computed.
    """
    scores = {name: _scores(own, mode) for name, own in _split(drives, _generator).items()}
    displaced = _split(displacements, _generator)
    distances = {name: _distances(displaced.get(name, [])) for name in scores}
    rows = [
        *((f"CR, {name}", _cells(found, "collision_rate")) for name, found in scores.items()),
        *((f"OS, {name}", _cells(found, "overall_score")) for name, found in scores.items()),
        *((f"ADE [m], {name}", _cells(found, "ADE")) for name, found in distances.items()),
    ]
    return ResultTable(
        title="Scenes by generator: collision rate (CR), overall score (OS), average displacement error (ADE)",
        columns=(*BASES, "Avg."),
        rows=tuple(rows),
        notes=(
            _mode_note(mode),
            "A base scenario's number is the mean over the egos, Avg. the mean over the base scenarios.",
            f"{BOOTSTRAP}. {FEW_ROUTES}.",
            *_counts(drives),
        ),
    )


def diagnostic_table(drives: Sequence[Drive], mode: Mode) -> ResultTable:
    """Table 2: the ten metrics and the overall score of each generator, mean over egos and base scenarios.

    Args:
        drives: Of any generators and egos, in any order.
        mode: How the numbers are computed.
    """
    rows = [
        (name, tuple(_average(_scores(own, mode), metric) for metric in ABBREVIATIONS))
        for name, own in _split(drives, _generator).items()
    ]
    return ResultTable(
        title="Diagnostic report: safety (CR, RR, SS, OR), functionality (RF, Comp, TS), etiquette (ACC, YV, LI), OS",
        columns=tuple(ABBREVIATIONS.values()),
        rows=tuple(rows),
        notes=(
            _mode_note(mode),
            "Mean over the egos, then over the base scenarios.",
            f"{BOOTSTRAP}.",
            *_counts(drives),
        ),
    )


def ego_table(drives: Sequence[Drive], mode: Mode, *, which: Which) -> ResultTable:
    """Tables 4 and 5: one number of each ego on the scenes of each generator.

    Args:
        drives: Of any generators and egos, in any order.
        mode: How the overall score is computed.
        which: Table 4 (``collision_rate``), 5 (``overall_score``), or the completion that must stand beside them.
    """
    rows = [
        (f"{ego}, {generator}", _unless_selected(own, _cells(_scores(own, mode), which)))
        for ego, of_ego in _split(drives, lambda drive: drive.ego).items()
        for generator, own in _split(of_ego, _generator).items()
    ]
    rate = which == "collision_rate"
    interval = f"{BOOTSTRAP}. {FEW_ROUTES}." if rate else f"{BOOTSTRAP}."
    return ResultTable(
        title=TITLES[which],
        columns=(*BASES, "Avg."),
        rows=tuple(rows),
        notes=(_mode_note(mode), "Avg. is the mean over the base scenarios.", interval, *_counts(drives)),
    )


def avoidability_table(drives: Sequence[Drive]) -> ResultTable:
    """Of the collisions, those a careful driver would have avoided; of the scenes, the fill-ins.

    Args:
        drives: Of any generators and egos, in any order.
    """
    by_generator = _split(drives, _generator)
    avoidable = [(f"Avoidable, {name}", _shares(own, _avoidable)) for name, own in by_generator.items()]
    fill_ins = [(f"Fill-in, {name}", _shares(own, _fill_ins)) for name, own in by_generator.items()]
    return ResultTable(
        title="Share of collisions that a careful driver would have avoided, and of scenes that are fill-ins",
        columns=(*BASES, "All"),
        rows=(*avoidable, *fill_ins),
        notes=(
            "Avoidable: of the drives with a collision. Fill-in: of the scenes. All: of those of all base scenarios.",
            f"{WILSON}.",
            *_counts(drives),
        ),
    )


def fault_table(drives: Sequence[Drive]) -> ResultTable:
    """Of the collisions, the share of each fault.

    Args:
        drives: Of any generators and egos, in any order.
    """
    rows = [
        (f"{fault}, {name}", _shares(own, lambda some, of=fault: [d.fault == of for d in some if d.fault is not None]))
        for name, own in _split(drives, _generator).items()
        for fault in Fault
    ]
    return ResultTable(
        title="Whose own motion closed the gap, share of the collisions",
        columns=(*BASES, "All"),
        rows=tuple(rows),
        notes=("All: of the collisions of all base scenarios.", f"{WILSON}.", *_counts(drives)),
    )


@dataclass(frozen=True, slots=True)
class _Found:
    """The numbers of one base scenario: their values, their resampled values, and from how many drives and routes."""

    values: dict[str, float]
    resampled: dict[str, Array]
    drives: int
    routes: int


def _scores(drives: Sequence[Drive], mode: Mode) -> dict[BaseScenario, _Found]:
    """The ten numbers and the overall score on each base scenario, mean over the egos."""
    found: dict[BaseScenario, _Found] = {}
    for base, own in _by_base(drives).items():
        sets = _split(own, lambda drive: drive.ego).values()
        metrics = [score([drive.measurements for drive in some], mode=mode) for some in sets]
        routes = [[(drive.ego, drive.measurements) for drive in route] for route in _routes(own)]
        found[base] = _Found(
            values={name: _mean([getattr(each, name) for each in metrics]) for name in ABBREVIATIONS},
            resampled=resample_scores(routes, mode, seed=_seed(base)),
            drives=len(own),
            routes=len(routes),
        )
    return found


def _distances(displacements: Sequence[Displacement]) -> dict[BaseScenario, _Found]:
    """The ADE on each base scenario, mean over scenarios and routes, then over the egos."""
    found: dict[BaseScenario, _Found] = {}
    for base, own in _by_base(displacements).items():
        routes = [_by_ego(route) for route in _routes(own)]
        found[base] = _Found(
            values={"ADE": _mean([_mean(values) for values in _by_ego(own).values()])},
            resampled={"ADE": resample_means(routes, seed=_seed(base))},
            drives=len(own),
            routes=len(routes),
        )
    return found


def _by_ego(displacements: Sequence[Displacement]) -> dict[str, list[float]]:
    values: dict[str, list[float]] = {}
    for each in displacements:
        values.setdefault(each.ego, []).append(each.value)
    return values


def _cells(found: dict[BaseScenario, _Found], name: str) -> tuple[Cell, ...]:
    """A row: each base scenario and their mean."""
    return *(_cell(found[base], name) if base in found else MISSING for base in BaseScenario), _average(found, name)


def _cell(found: _Found, name: str) -> Cell:
    value, interval = found.values[name], percentiles(found.resampled[name], [found.routes])
    if name == "collision_rate" and math.isnan(interval[0]):
        # The mean over egos is the pooled rate if all drove the same scenes; it is so near it that Wilson holds it.
        interval = wilson(round(value * found.drives), found.drives)
    return _with_interval(value, interval)


def _average(found: dict[BaseScenario, _Found], name: str) -> Cell:
    """The mean over base scenarios, whose routes are resampled each on their own."""
    if not found:
        return MISSING
    value = _mean([each.values[name] for each in found.values()])
    resampled = np.mean([each.resampled[name] for each in found.values()], axis=0)
    return _with_interval(value, percentiles(resampled, [each.routes for each in found.values()]))


def _with_interval(value: float, interval: tuple[float, float]) -> Cell:
    return Cell(value) if math.isnan(interval[0]) else Cell(value, *interval)


def _unless_selected(drives: Sequence[Drive], cells: tuple[Cell, ...]) -> tuple[Cell, ...]:
    """The row of an ego; where its scenes were kept for what it did in them, the values alone."""
    if not all(drive.by_selection for drive in drives):
        return cells
    return tuple(cell if cell.value is None else Cell(cell.value, by_selection=True) for cell in cells)


def _shares(drives: Sequence[Drive], of: Callable[[Sequence[Drive]], Sequence[bool]]) -> tuple[Cell, ...]:
    """A row: what share of something is so, on each base scenario and on all."""
    by_base = _by_base(drives)
    return *(_share(of(by_base.get(base, []))) for base in BaseScenario), _share(of(drives))


def _avoidable(drives: Sequence[Drive]) -> list[bool]:
    return [drive.avoidable for drive in drives if drive.avoidable is not None]


def _fill_ins(drives: Sequence[Drive]) -> list[bool]:
    """One per scene, however many egos drove it."""
    return list({_scene(drive): drive.fill_in for drive in drives}.values())


def _share(flags: Sequence[bool]) -> Cell:
    return Cell(sum(flags) / len(flags), *wilson(sum(flags), len(flags))) if flags else MISSING


def _seed(base: BaseScenario) -> int:
    """Each base scenario is resampled independently of the others, whichever there are."""
    return list(BaseScenario).index(base)


def _generator(each: Drive | Displacement) -> str:
    return each.generator


def _scene(drive: Drive) -> tuple[str, str, str]:
    return drive.generator, drive.scenario_id, drive.scene_id


def _split(found: Sequence[D], key: Callable[[D], K]) -> dict[K, list[D]]:
    """What is found by some key of it, keys and members in a fixed order."""
    split: dict[K, list[D]] = {}
    for each in sorted(found, key=_place):
        split.setdefault(key(each), []).append(each)
    return dict(sorted(split.items()))


def _by_base(found: Sequence[D]) -> dict[BaseScenario, list[D]]:
    return _split(found, lambda each: each.base_scenario)


def _routes(found: Sequence[D]) -> list[list[D]]:
    """What shares a route of a base scenario; on another map it is another route."""
    return list(_split(found, lambda each: f"{each.base_scenario}/{each.map_name}/{each.route:09d}").values())


def _place(each: Drive | Displacement) -> tuple[str, str, str, int, str, str]:
    scene = each.scene_id if isinstance(each, Drive) else ""
    return each.generator, each.base_scenario, each.scenario_id, each.route, scene, each.ego


def _mean(values: Sequence[float]) -> float:
    return math.fsum(values) / len(values)


def _mode_note(mode: Mode) -> str:
    return f"Mode: {mode}."


def _counts(drives: Sequence[Drive]) -> tuple[str, ...]:
    """What each generator's numbers are made of, which base scenarios lack, and whom the scenes were kept for."""
    notes: list[str] = []
    for name, own in _split(drives, _generator).items():
        there = _by_base(own)
        scenes, egos = len({_scene(drive) for drive in own}), len({drive.ego for drive in own})
        routes = sorted({len(_routes(some)) for some in there.values()})
        span = f"{routes[0]}" if len(routes) == 1 else f"{routes[0]} to {routes[-1]}"
        notes.append(
            f"{name}: {len(own)} drives, {scenes} scenes, {span} routes per base scenario, egos: {egos},"
            f" base scenarios: {len(there)} of {len(BaseScenario)}."
        )
    notes += [
        f"{ego}: by selection. The scenes were kept for what it did in them, so its numbers say how well they were"
        " searched and not how it fares; they are part of every mean and share over egos."
        for ego in sorted({drive.ego for drive in drives if drive.by_selection})
    ]
    return tuple(notes)
