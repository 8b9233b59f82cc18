"""Harden the driver that looks ahead: what it weighs is searched for, against scenes that are searched for again.

    python benchmarks/harden.py --out FOLDER [--seed 0] [--rounds 3] [--generations 30] [--tries 12] [--jobs 2]
    python benchmarks/harden.py --out FOLDER --at-speed …

Scenes are those of the benchmark's forty sentences on routes 0 to 7, and ordinary drives; routes 8 and 9, other
sentences and other generators are left to test on. To begin with, scenes are drawn, and those that one of `idm` and
`planner` crashes in but not both, and a few of the rest, are learned from. In each round CMA-ES searches for a
`Caution` (`chatscene.ego.planner`) by which there are fewer crashes, without standing, without leaving the way in
ordinary drives and at no less than 6.1 m/s in these; then the adversaries of each sentence and route are searched for
against it, and one crash of each is learned from as well. Writes the caution of each round. The same seed gives the
same, with any number of jobs. Needs the extra `search`.

With `--at-speed`, scenes are those of `lessons_at_speed.py`, the search begins with the weights of `hardened` at 8 m/s,
`planner` takes part in what is hard, ordinary drives are to be as fast as the first driver's (within 2 %), and of what
adversaries find only crashes are learned from that a careful driver would have avoided.
"""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass, fields, replace
from pathlib import Path

import click
import numpy as np
from building import simulator
from cmaes import CMA
from lessons_at_speed import Placed, encounters_at_speed, ordinary_at_speed
from numpy.typing import NDArray

from chatscene import pipeline
from chatscene.ego.asking import fitted
from chatscene.ego.caution import HARDENED
from chatscene.ego.planner import Caution, Planner
from chatscene.ego.policy import EgoPolicy, load_ego
from chatscene.measure.avoidability import avoidable
from chatscene.program.ordinary import Course, ordinary_courses
from chatscene.runs.executor import Workers
from chatscene.runs.parallel import spread
from chatscene.search.generator import load_generator
from chatscene.simulate.native.simulator import NativeSimulator
from chatscene.simulate.simulator import routes_of, simulate
from chatscene.terms.episode import Ending, Episode
from chatscene.terms.scenario import BaseScenario
from chatscene.terms.scene import Rejected, Scene

Array = NDArray[np.float64]
START = replace(Caution(), speed=7.0, crossing=1.0)
AS_FAST = 0.98  # of the first driver at speed, on ordinary drives
FASTEST = 9.0  # [m/s]
SLOWEST = 6.1  # [m/s], on ordinary drives
ASIDE = 0.8  # [m] from the route beyond which an ordinary drive has left it
ROUTES = 8  # of each sentence, to learn from
EASY = 8  # one in so many of those that nobody crashes in is learned from
NEAREST, AWAY = 3, 0.12  # an adversary is searched for around so many, so far away as a share of the ranges
KINDS = ("hard", "easy", "ordinary")
PARTS = 8  # that lessons are spread in
KEPT = 3000  # scenes that stay placed, since they are driven again and again


@dataclass(frozen=True)
class Lesson:
    """A scene to learn from: what it is for, its course with its values, and on which map."""

    kind: str
    placed: Placed


@dataclass(frozen=True)
class Judging:
    """Lessons for some cautions, one part of all."""

    part: int
    lessons: tuple[Lesson, ...]
    cautions: tuple[Caution, ...]


@dataclass(frozen=True)
class Attack:
    """A course to search an adversary on, against a caution; whether any crash counts, or an avoidable one only."""

    number: int
    placed: Placed
    caution: Caution
    tries: int
    seed: int
    avoidable: bool


def judges(_: None) -> Callable[[Judging], tuple[int, Array]]:
    """Drives lessons, in one process."""
    return Driver().judged


def attackers(_: None) -> Callable[[Attack], tuple[int, Lesson | None]]:
    """Searches for adversaries, in one process."""
    return Driver().attacked


class Driver:
    """Drives, in one process."""

    def __init__(self) -> None:
        NativeSimulator.keeps = KEPT

    def judged(self, task: Judging) -> tuple[int, Array]:
        """(kinds, cautions, 5) sums of drives, crashes, drives without an end, time aside and speed."""
        sums = np.zeros((len(KINDS), len(task.cautions), 5))
        for lesson in task.lessons:
            for number, caution in enumerate(task.cautions):
                if (driven := self.drive(lesson.placed, Planner(caution))) is not None:
                    aside = float((driven.distance_to_route > ASIDE).mean())
                    crash, stuck = driven.collision is not None, driven.ending is Ending.TIMEOUT
                    speed = float(np.abs(driven.ego_track.speed).mean())
                    sums[KINDS.index(lesson.kind), number] += (1.0, crash, stuck, aside, speed)
        return task.part, sums

    def attacked(self, task: Attack) -> tuple[int, Lesson | None]:
        """A crash, if one is found."""
        rng, ego = np.random.default_rng(task.seed), Planner(task.caution)
        seen: list[tuple[float, dict[str, float]]] = []
        for number in range(task.tries):
            near = sorted(seen, key=lambda one: one[0])[:NEAREST]
            around = near[number % len(near)][1] if near and number >= task.tries // 2 else None
            values = drawn(task.placed.course, rng, around)
            placed = with_values(task.placed, values)
            if (driven := self.drive(placed, ego)) is None:
                continue
            if driven.collision is not None and (not task.avoidable or self.avoids(placed, driven, ego)):
                return task.number, Lesson("hard", placed)
            seen.append((nearest(driven), values))
        return task.number, None

    def drive(self, placed: Placed, ego: EgoPolicy) -> Episode | None:
        """A course with values, driven; None where it cannot be placed."""
        driven = simulate(simulator(placed.map_name), placed.course.program, scene_of(placed), ego)
        return None if isinstance(driven, Rejected) else driven

    def avoids(self, placed: Placed, driven: Episode, ego: EgoPolicy) -> bool:
        """Whether a careful driver would not have collided there."""
        program = placed.course.program
        ego = fitted(ego, program)
        return bool(avoidable(driven, program, scene_of(placed), ego, simulator(placed.map_name)))


def scene_of(placed: Placed) -> Scene:
    """The scene of a course with values."""
    course, called = placed.course, placed.course.program.scenario_id
    values = dict(course.values or {})
    return Scene(id=f"{called}/harden", scenario_id=called, route=course.route, block=0, seed=0, values=values)


def with_values(placed: Placed, values: dict[str, float]) -> Placed:
    """The same course with values."""
    return replace(placed, course=replace(placed.course, values=values))


def drawn(course: Course, rng: np.random.Generator, around: dict[str, float] | None = None) -> dict[str, float]:
    """Values of a course's ranges: anywhere, or around others."""
    values: dict[str, float] = {}
    for p in course.program.parameters:
        if around is None:
            value = rng.uniform(p.low, p.high)
        else:
            value = np.clip(around[p.name] + rng.normal(0.0, AWAY) * (p.high - p.low), p.low, p.high)
        values[p.name] = round(float(value), 6)
    return values


def nearest(driven: Episode) -> float:
    """How near the ego came to an adversary [m], from centre to centre."""
    ego = driven.ego_track
    gaps = [np.hypot(one.x - ego.x, one.y - ego.y).min() for one in driven.adversaries]
    return float(min(gaps, default=math.inf))


def first_lessons(
    courses: Sequence[Placed],
    ordinary: Sequence[Placed],
    egos: Sequence[EgoPolicy],
    draws: int,
    rng: np.random.Generator,
) -> list[Lesson]:
    """Scenes that one of the egos crashes in, but not all, a few that none does, and ordinary ones."""
    driver, hard, easy = Driver(), list[Lesson](), list[Lesson]()
    for one in courses:
        for _ in range(draws):
            placed = with_values(one, drawn(one.course, rng))
            driven = [driver.drive(placed, ego) for ego in egos]
            crashed = [one.collision is not None for one in driven if one is not None]
            if crashed and any(crashed) and not all(crashed):
                hard.append(Lesson("hard", placed))
            elif crashed and not any(crashed):
                easy.append(Lesson("easy", placed))
    kept = [easy[i] for i in rng.permutation(len(easy))[: len(easy) // EASY]]
    usual = [
        Lesson("ordinary", one if one.course.values else with_values(one, drawn(one.course, rng))) for one in ordinary
    ]
    return [*hard, *kept, *usual]


def cost(sums: Array, slowest: float) -> float:
    """What is minimised of one caution; `sums`: (kinds, 5); `slowest`: what is no less fast on ordinary drives."""
    hard, easy, ordinary = sums[:, 1:] / np.maximum(sums[:, :1], 1.0)
    scenes = 0.6 * (hard[0] + 0.15 * hard[1]) + 0.4 * (easy[0] + 0.15 * easy[1]) + 0.1 * hard[2]
    return float(scenes + 2.0 * ordinary[0] + ordinary[1] + 0.6 * ordinary[2] + 0.3 * max(0.0, slowest - ordinary[3]))


def moved(x: Array, start: Caution) -> Caution:
    """The start, each number times e to the power of one of `x`; what is believed of others at most twice over."""
    numbers = iter(np.exp(np.clip(x, -3.0, 3.0)).tolist())
    values: dict[str, float | tuple[float, float]] = {}
    for field in fields(start):
        value = getattr(start, field.name)
        if isinstance(value, tuple):
            how, belief = value
            values[field.name] = (how * next(numbers), min(belief * next(numbers), 2.0))
        else:
            values[field.name] = value * next(numbers)
    found = Caution(**values)  # type: ignore[arg-type]
    return replace(found, speed=min(found.speed, FASTEST))


def in_words(sums: Array) -> str:
    shares = sums[:, 1:] / np.maximum(sums[:, :1], 1.0)
    return "; ".join(
        f"{kind}: {n:.0f} drives, {crash:.3f} crash, {stuck:.3f} without an end, {aside:.3f} aside, {speed:.2f} m/s"
        for kind, n, (crash, stuck, aside, speed) in zip(KINDS, sums[:, 0], shares, strict=True)
    )


@click.command()
@click.option("--out", type=click.Path(file_okay=False, path_type=Path), required=True)
@click.option("--seed", default=0, show_default=True)
@click.option("--rounds", default=3, show_default=True)
@click.option("--generations", default=30, show_default=True)
@click.option("--population", default=12, show_default=True)
@click.option("--tries", default=12, show_default=True, help="Scenes driven against each sentence on each route.")
@click.option("--jobs", default=2, show_default=True)
@click.option("--drawn", "draws", default=2, show_default=True, help="Scenes of each course, to begin with.")
@click.option("--at-speed", is_flag=True, help="At the speed of traffic.")
def main(
    out: Path,
    seed: int,
    rounds: int,
    generations: int,
    population: int,
    tries: int,
    jobs: int,
    draws: int,
    at_speed: bool,
) -> None:
    out.mkdir(parents=True, exist_ok=True)
    rng, workers = np.random.default_rng(seed), Workers(jobs)
    courses = list(encounters_at_speed(0)) if at_speed else of_the_benchmark()
    ordinary = ordinary_at_speed() if at_speed else map(Placed, ordinary_courses(simulator("town")))
    start = HARDENED if at_speed else START
    egos = [load_ego("idm"), Planner(start), *([Planner()] if at_speed else [])]
    lessons = first_lessons(courses, list(ordinary), egos, draws, rng)

    def judged(cautions: tuple[Caution, ...]) -> Array:
        parts = [Judging(k, tuple(lessons[k::PARTS]), cautions) for k in range(PARTS)]
        done = dict(spread(judges, None, parts, workers=workers))
        return np.sum([done[k] for k in range(PARTS)], axis=0)

    slowest = SLOWEST
    if at_speed:
        began = judged((start,))[:, 0]
        slowest = AS_FAST * began[KINDS.index("ordinary"), 4] / began[KINDS.index("ordinary"), 0]
        print(f"to begin with: {in_words(began)}", flush=True)
    mean = np.zeros(sum(2 if isinstance(getattr(start, f.name), tuple) else 1 for f in fields(start)))
    for number in range(rounds):
        search = CMA(mean=mean, sigma=0.1 if number else 0.25, seed=seed + number, population_size=population)
        for _ in range(generations):
            asked = [search.ask() for _ in range(population)]
            sums = judged(tuple(moved(x, start) for x in asked))
            search.tell([(x, cost(sums[:, i], slowest)) for i, x in enumerate(asked)])
        mean, caution = search.mean, moved(search.mean, start)
        (out / f"round-{number}.json").write_text(json.dumps(asdict(caution), indent=2))
        print(f"round {number}: {in_words(judged((caution,))[:, 0])}", flush=True)
        seeds = np.random.SeedSequence((seed, number)).generate_state(len(courses)).tolist()
        attacks = [Attack(k, course, caution, tries, seeds[k], at_speed) for k, course in enumerate(courses)]
        done = dict(spread(attackers, None, attacks, workers=workers))
        found = [one for k in range(len(attacks)) if (one := done[k]) is not None]
        print(f"  crashes on {len(found)} of {len(courses)} courses", flush=True)
        lessons += found


def of_the_benchmark() -> list[Placed]:
    """The benchmark's sentences, on the routes to learn from."""
    texts = [text for base in BaseScenario for text in load_generator("chatscene").texts(base)]
    programs = [pipeline.understand(text).program for text in texts]
    town = simulator("town")
    return [Placed(Course(program=p, route=route)) for p in programs for route in routes_of(town, p, ROUTES)]


if __name__ == "__main__":
    main()
