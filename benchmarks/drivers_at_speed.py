"""How the drivers by rule drive at the speed of traffic: keeping speed and lane, and braking as Euro NCAP tests it.

    python benchmarks/drivers_at_speed.py [--ego idm ...] [--physics kinematic]
    python benchmarks/drivers_at_speed.py --texts 50 --texts 80 [--draws 5] [--half 1]

On `benchmarks/proving_ground.py`, a straight or bent lane of 3.5 m. Prints tables in Markdown: what is left of the
speed at a collision [km/h], or `-` where there is none. Nothing is drawn, so that there is no seed.

With `--texts`, the forty plain sentences of `encounters.py`, each built for an ego that wants so many km/h and driven
on its first route with values drawn by seeds from 0: in how many drives each ego collides, how fast it then is, and in
how many a careful driver (`chatscene.measure.avoidability`) would not have collided. `--half 1` takes every second
sentence, which nothing that is trained or tuned at speed has learned from; `--half 0` takes the others.

Source of the cases: Euro NCAP, test protocols "AEB Car-to-Car systems" and "AEB/LSS VRU systems"; UN R157, annex 4,
for cut-ins. The pedestrian is seen all the time; in the protocol's CPNC he steps out from behind cars.
"""

from __future__ import annotations

import itertools
import math
from collections import Counter
from collections.abc import Callable, Sequence
from functools import partial

import click
import numpy as np
from building import simulator
from encounters import sentences
from proving_ground import (
    CAR,
    Driven,
    Told,
    ahead,
    cuts_in,
    drive,
    line_of,
    pedestrian,
    towards,
)

from chatscene.build.build import build
from chatscene.ego.asking import fitted, wanting
from chatscene.ego.policy import load_ego
from chatscene.errors import MapError, NotBuilt, NothingFits
from chatscene.measure.avoidability import avoidable
from chatscene.program.sample import draw
from chatscene.report.filled import explain_text
from chatscene.report.stated import Stated
from chatscene.simulate.embedded.dynamics import make_body
from chatscene.simulate.embedded.lagged import LaggedVehicle
from chatscene.simulate.embedded.physics import EmbeddedPhysics
from chatscene.simulate.physics import PhysicsOf
from chatscene.simulate.simulator import routes_of, simulate
from chatscene.situations.facts import with_fact
from chatscene.terms.polyline import Polyline
from chatscene.terms.scene import Rejected, Scene

KMH = 1.0 / 3.6
PHYSICS: dict[str, PhysicsOf] = {
    "kinematic": EmbeddedPhysics,
    "lagged": partial(EmbeddedPhysics, partial(make_body, vehicle=LaggedVehicle)),
}
STRAIGHT = line_of((3000.0, 0.0))
EGOS = ("rule-based", "idm", "planner", "hardened")
BENDS: dict[str, tuple[float, Polyline]] = {
    "straight, 30 km/h": (30.0, line_of((1500.0, 0.0))),
    "straight, 130 km/h": (130.0, line_of((3000.0, 0.0))),
    "bends of 150 m to both sides, 80 km/h": (
        80.0, line_of((300.0, 0.0), (150.0, 1 / 150), (150.0, -1 / 150), (300.0, 0.0)),
    ),
    "bends of 400 m to both sides, 110 km/h": (
        110.0, line_of((300.0, 0.0), (300.0, 1 / 400), (300.0, -1 / 400), (300.0, 0.0)),
    ),
    "a turn of 10 m, wanting 50 km/h": (50.0, line_of((150.0, 0.0), (5.0 * math.pi, 1 / 10), (150.0, 0.0))),
}  # fmt: skip


def standing(speed: float) -> list[Told]:
    return [Told(ahead(max(6.0 * speed, 40.0)))]


def slow(speed: float) -> list[Told]:
    return [Told(ahead(6.0 * (speed - 20.0 * KMH) + 20.0, 20.0 * KMH))]


def braking(gap: float, hard: float) -> Callable[[float], list[Told]]:
    return lambda speed: [Told(ahead(gap, speed, braking=hard))]


def crossing(walks: float, share: float, side: int = -1, walked: float = 6.0) -> Callable[[float], list[Told]]:
    return lambda speed: [pedestrian(speed, walks * KMH, share, side=side, walked=walked)]


def cut_in(gap: float, slower: float, sideways: float) -> Callable[[float], list[Told]]:
    return lambda speed: [Told(cuts_in(gap, speed - slower * KMH, sideways))]


CASES: dict[str, tuple[tuple[int, ...], Callable[[float], list[Told]]]] = {
    "CCRs, a car that stands": ((10, 20, 30, 40, 50, 60, 70, 80, 100, 130), standing),
    "the same, seen 60 m before": ((50, 80, 110, 130), lambda _: [Told(ahead(60.0))]),
    "CCRm, a car at 20 km/h": ((30, 40, 50, 60, 70, 80, 100, 130), slow),
    "CCRb, 12 m ahead, brakes with 2 m/s²": ((50,), braking(12.0, 2.0)),
    "CCRb, 12 m ahead, brakes with 6 m/s²": ((50,), braking(12.0, 6.0)),
    "CCRb, 40 m ahead, brakes with 2 m/s²": ((50,), braking(40.0, 2.0)),
    "CCRb, 40 m ahead, brakes with 6 m/s²": ((50, 80, 110), braking(40.0, 6.0)),
    "CPNA-25, a pedestrian at 5 km/h from the right": ((20, 30, 40, 50, 60), crossing(5.0, 0.25)),
    "CPNA-75": ((20, 30, 40, 50, 60), crossing(5.0, 0.75)),
    "CPNCO-50, a child at 5 km/h, from 2 m": ((20, 30, 40, 50, 60), crossing(5.0, 0.5, walked=2.0)),
    "CPFA-50, a pedestrian at 8 km/h from the left": ((20, 30, 40, 50, 60), crossing(8.0, 0.5, side=1)),
    "a cut-in 30 m ahead, 30 km/h slower, with 1 m/s": ((60, 80, 110, 130), cut_in(30.0, 30.0, 1.0)),
    "a cut-in 15 m ahead, 30 km/h slower, with 1.5 m/s": ((60, 80, 110, 130), cut_in(15.0, 30.0, 1.5)),
}


def keeps(name: str, physics: str) -> None:
    """How an ego keeps its speed and its line."""
    print(f"\n| {name}, {physics} | slowest beside what is allowed | beside the line | across | steering, per step |")
    print("|---|---:|---:|---:|---:|")
    for what, (speed, line) in BENDS.items():
        driven = drive(
            wanting(load_ego(name), speed * KMH), line, speed * KMH, physics=PHYSICS[physics](), seconds=60.0
        )
        least = (driven.speed / np.minimum(driven.allowed, speed * KMH)).min()
        print(
            f"| {what} | {least:.1%} | {np.abs(driven.offset).max():.2f} m | {np.abs(driven.across).max():.1f} m/s² "
            f"| {np.abs(np.diff(driven.steering)).max():.3f} |"
        )
    for speed, radius in ((50.0, 60.0), (80.0, 150.0), (110.0, 400.0)):
        line = line_of((150.0, 0.0), (250.0, 1.0 / radius), (150.0, 0.0))
        met = [Told(towards(line, at, speed * KMH)) for at in (120.0, 170.0, 220.0, 270.0, 330.0, 400.0)]
        ego = wanting(load_ego(name), speed * KMH)
        alone, among = (drive(ego, line, speed * KMH, others, physics=PHYSICS[physics]()) for others in ((), met))
        worst = np.abs(among.speed - alone.speed[: len(among.speed)]).max()
        print(f"| {speed:.0f} km/h in a bend of {radius:.0f} m against oncoming traffic | {worst / KMH:.1f} km/h off |")


def told(driven: Driven) -> str:
    return "-" if driven.impact is None else f"{driven.impact / KMH:.0f}"


def table(egos: Sequence[str], physics: str) -> None:
    """What is left of the speed at a collision."""
    for what, (speeds, case) in CASES.items():
        print(f"\n| {what}; {physics} | {' | '.join(f'{speed} km/h' for speed in speeds)} | hardest \\[m/s²\\] |")
        print(f"|---|{'---:|' * (len(speeds) + 1)}")
        for name in egos:
            runs = [
                drive(wanting(load_ego(name), v * KMH), STRAIGHT, v * KMH, case(v * KMH), physics=PHYSICS[physics]())
                for v in speeds
            ]
            hardest = max(-run.acceleration.min() for run in runs)
            print(f"| {name} | {' | '.join(map(told, runs))} | {hardest:.1f} |")


def among(egos: Sequence[str], speed: float, draws: int, half: int | None) -> None:
    """In how many drives of the sentences each ego collides at a speed [km/h]."""
    counted = {name: list[float]() for name in egos}
    drives, missed = Counter[str](), Counter[str]()
    for number, (_, text) in enumerate(sentences()):
        if half is not None and number % 2 != half:
            continue
        try:
            read = explain_text(text)
            assert isinstance(read, Stated), text
            made = build(with_fact(read.situation, "ego.speed", f"{speed:g} km/h"))
            route = next(iter(routes_of(simulator(made.map), made.program, 1)))
        except (NothingFits, NotBuilt, MapError) as refusal:
            print(f"not built: {text} ({refusal})")
            continue
        for seed, name in itertools.product(range(draws), egos):
            values = draw(made.program.parameters, seed=seed)
            scene = Scene(id="texts", scenario_id="texts", route=route, block=0, seed=seed, values=values)
            ego, where = fitted(load_ego(name), made.program), simulator(made.map)
            episode = simulate(where, made.program, scene, ego)
            if isinstance(episode, Rejected):
                continue
            drives[name] += 1
            if episode.collision is not None:
                counted[name].append(abs(float(episode.ego_track.speed[-1])))
                missed[name] += bool(avoidable(episode, made.program, scene, ego, where))
    print(f"\n| {speed:g} km/h | drives | collisions | then, on average | avoidable |\n|---|---:|---:|---:|---:|")
    for name, speeds in counted.items():
        then = f"{np.mean(speeds) / KMH:.0f} km/h" if speeds else ""
        print(f"| {name} | {drives[name]} | {len(speeds)} | {then} | {missed[name]} |")


@click.command()
@click.option("--ego", "egos", multiple=True, default=EGOS)
@click.option("--physics", type=click.Choice(list(PHYSICS)), default="kinematic")
@click.option("--texts", "speeds", multiple=True, type=float, help="Sentences at so many km/h, and not the tables.")
@click.option("--draws", default=5, show_default=True, help="Of values, for each sentence.")
@click.option("--half", type=click.IntRange(0, 1), default=None, help="Every second sentence, from this one on.")
def main(egos: tuple[str, ...], physics: str, speeds: tuple[float, ...], draws: int, half: int | None) -> None:
    """Print the tables."""
    for speed in speeds:
        among(egos, speed, draws, half)
    if speeds:
        return
    print(f"A car of {CAR.length} m by {CAR.width} m that brakes with {CAR.brake} m/s² at most.")
    for name in egos:
        keeps(name, physics)
    table(egos, physics)


if __name__ == "__main__":
    main()
