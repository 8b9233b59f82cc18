"""How an ego fares on ordinary drives: whether it gets there, and whether it crashes on the way."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from statistics import fmean

from chatscene.ego.policy import EgoPolicy, name_of
from chatscene.measure.intervals import bootstrap
from chatscene.measure.score import wilson
from chatscene.program.ordinary import Course, ordinary_courses
from chatscene.program.sample import draw, scene_seed
from chatscene.simulate.simulator import Simulator, simulate
from chatscene.terms.episode import Episode, EventKind
from chatscene.terms.results import Cell, ResultTable
from chatscene.terms.scene import Rejected, Scene


@dataclass(frozen=True, slots=True, kw_only=True)
class OrdinaryDrive:
    """One drive of a course.

    Attributes:
        course: Which, by number.
        completion: Share of the route driven, in [0, 1].
        speed: Mean speed [m/s].
        off_road: Share of the time that it was off the driving lanes, in [0, 1].
        collided: Whether it crashed.
        ran_red: Whether it went over the stop line at red.
    """

    course: int
    completion: float
    speed: float
    off_road: float
    collided: bool
    ran_red: bool = False


@dataclass(frozen=True, slots=True, kw_only=True)
class OrdinaryResult:
    """The ordinary drives of one ego.

    Attributes:
        ego: Its name.
        drives: Course by course.
        rejected: Draws that could not be placed.
    """

    ego: str
    drives: tuple[OrdinaryDrive, ...]
    rejected: int

    def figures(self) -> dict[str, float]:
        """The means, by name, the Wilson interval of the collision rate, and the share of drives that left the road."""
        hits = sum(drive.collided for drive in self.drives)
        low, high = wilson(hits, len(self.drives))
        return {
            "drives": float(len(self.drives)),
            "completion": fmean(drive.completion for drive in self.drives),
            "collision_rate": hits / len(self.drives),
            "collision_rate_low": low,
            "collision_rate_high": high,
            "off_road": fmean(drive.off_road for drive in self.drives),
            "off_road_rate": fmean(drive.off_road > 0.0 for drive in self.drives),
            "mean_speed": fmean(drive.speed for drive in self.drives),
        }


def drive_ordinary(
    ego: EgoPolicy, simulator: Simulator, *, scenes: int, seed: int, speed: float | None = None
) -> OrdinaryResult:
    """Let an ego drive every ordinary course of a map.

    Args:
        ego: Who drives.
        simulator: Where, on which map.
        scenes: Variants of the traffic per course.
        seed: Of the traffic.
        speed: What the ego wants to drive at [m/s] within the limits of the roads; None if it is told nothing.

    Raises:
        MapError: The map offers no route.
        EgoError: The ego fails.
    """
    driven: list[OrdinaryDrive] = []
    rejected = 0
    for course, outcome in ordinary_episodes(ego, simulator, scenes=scenes, seed=seed, speed=speed):
        if isinstance(outcome, Rejected):
            rejected += 1
            continue
        driven.append(
            OrdinaryDrive(
                course=course,
                completion=outcome.route_completion,
                speed=float(outcome.ego_track.speed.mean()),
                off_road=float(outcome.off_road.mean()),
                collided=outcome.collision is not None,
                ran_red=any(event.kind is EventKind.RED_LIGHT for event in outcome.events),
            )
        )
    return OrdinaryResult(ego=name_of(ego), drives=tuple(driven), rejected=rejected)


def ordinary_episodes(
    ego: EgoPolicy, simulator: Simulator, *, scenes: int, seed: int, speed: float | None = None
) -> Iterator[tuple[int, Episode | Rejected]]:
    """The drives themselves, each with the number of its course."""
    for number, course in enumerate(ordinary_courses(simulator, speed)):
        for index in range(scenes):
            yield number, simulate(simulator, course.program, _scene(course, index, seed), ego)


def ordinary_table(results: Sequence[OrdinaryResult]) -> ResultTable:
    """Completion, collisions, share of the time off the road, red lights that were run, and mean speed of each ego."""
    rows: list[tuple[str, tuple[Cell, ...]]] = []
    for result in results:
        hits, reds = (sum(getattr(drive, name) for drive in result.drives) for name in ("collided", "ran_red"))
        rate, red = (Cell(many / len(result.drives), *wilson(many, len(result.drives))) for many in (hits, reds))
        completion, off_road, speed = (_mean(result, name) for name in ("completion", "off_road", "speed"))
        rows.append((result.ego, (completion, rate, off_road, red, speed)))
    counts = sorted({len(result.drives) for result in results})
    courses = len({drive.course for result in results for drive in result.drives})
    return ResultTable(
        title="Ordinary drives",
        columns=("Completion", "Collision rate", "Off road", "Red lights", "Mean speed [m/s]"),
        rows=tuple(rows),
        notes=(
            f"{', '.join(map(str, counts))} drives per ego on {courses} courses.",
            "Collision rate, and the share of drives with a red light run: 95 % Wilson interval. The others: 95 % "
            "cluster bootstrap over the courses.",
        ),
    )


def _mean(result: OrdinaryResult, name: str) -> Cell:
    courses: dict[int, list[float]] = {}
    for drive in result.drives:
        courses.setdefault(drive.course, []).append(float(getattr(drive, name)))
    value = fmean(number for course in courses.values() for number in course)
    low, high = bootstrap(list(courses.values()), fmean, seed=0)
    return Cell(value) if math.isnan(low) else Cell(value, low, high)


def _scene(course: Course, number: int, seed: int) -> Scene:
    name = f"{course.program.scenario_id}/route-{course.route:02d}/scene-{number:03d}"
    own = scene_seed(seed, name)
    return Scene(
        id=name,
        scenario_id=course.program.scenario_id,
        route=course.route,
        block=0,
        seed=own,
        values=draw(course.program.parameters, seed=own),
    )
