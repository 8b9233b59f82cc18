"""Whether what `chatscene why` says of crashes holds, by driving every alternative.

    python benchmarks/why.py --out FOLDER [--crashes 20]

Makes a small run of each of a few sentences, takes crashed scenes from them in turn, asks why each crashed, and drives
again, in a simulator of its own:

- every subset of the values that differ from those that they are set back to: whether the set that was found crashes,
  whether it does without any single one of them, and how small the smallest set is that crashes;
- the same for every subset of the things that can be left out;
- every braking from the moment found on, and every speed from the one found down, as far as the margin goes: all must
  avoid it; and how many later moments of braking do by luck.
"""

from __future__ import annotations

import itertools
import time
from collections import Counter
from collections.abc import Callable, Hashable, Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TypeVar

import click

import chatscene
from chatscene.ego.policy import load_ego, pedals_of
from chatscene.measure.counterfactual import (
    BEYOND,
    FINENESS,
    Trial,
    _Braking,  # pyright: ignore[reportPrivateUsage]
    _Limited,  # pyright: ignore[reportPrivateUsage]
)
from chatscene.program.without import Placing, placings, without
from chatscene.runs.why import MIDDLE, Why, trial_of, why

MOST = 8  # causes of which every subset is driven
SENTENCES = (
    ("idm", "an oncoming car swerves into our lane"),
    ("sac", "a car stands in our lane ahead, and a pedestrian crosses the road from the right"),
    ("idm", "a car from the right runs the red light while we go straight"),
    ("sac", "an oncoming car turns left across our way"),
    ("idm", "the car ahead of us stops and reverses"),
    ("sac", "a motorcycle overtakes us and cuts in, and a pedestrian crosses the road from the right"),
    ("sac", "the car ahead of us brakes hard"),
)
C = TypeVar("C", bound=Hashable)


@click.command()
@click.option("--out", type=click.Path(path_type=Path), required=True, help="Where runs are made, or are already.")
@click.option("--crashes", default=20, show_default=True)
def main(out: Path, crashes: int) -> None:
    counts, took, drives, wrong = Counter[str](), 0.0, 0, 0
    for folder, scene_id in itertools.islice(_crashed(out), crashes):
        began = time.process_time()
        told = why(folder, scene_id)
        took, drives = took + time.process_time() - began, drives + told.drives
        click.echo(told.in_words())
        problems = list(_problems(folder, told, counts))
        wrong += bool(problems)
        click.echo("\n".join(problems) or "holds")
        click.echo("")
        counts["scenes"] += 1
    click.echo(f"{counts['scenes']} scenes, {wrong} of them with something that does not hold")
    click.echo(f"{took / counts['scenes']:.1f} s of processor time and {drives / counts['scenes']:.0f} drives for each")
    for name, count in sorted(counts.items()):
        click.echo(f"{count:4d} {name}")


def _crashed(out: Path) -> Iterator[tuple[Path, str]]:
    """Crashed scenes, of each run in turn, spread over the run."""
    queues: list[list[tuple[Path, str]]] = []
    for number, (ego, text) in enumerate(SENTENCES):
        folder = out / f"{number}-{ego}"
        run = (
            chatscene.Run(folder)
            if (folder / "report.html").exists()
            else chatscene.run(text, folder, ego=ego, scenes=20)
        )
        rows = [row for row in run.scenes.to_pylist() if row["collision"]]
        queues.append([(folder, row["scene_id"]) for row in [*rows[::4], *rows[1::4], *rows[2::4], *rows[3::4]]])
    for row in itertools.zip_longest(*queues):
        yield from (one for one in row if one is not None)


def _problems(folder: Path, told: Why, counts: Counter[str]) -> Iterator[str]:
    trial, _ = trial_of(folder, told.scene_id)
    mine = trial.scene.values
    if told.back is not None:
        back = told.back.values
        differing = [name for name in mine if mine[name] != back[name]]

        def with_values(kept: frozenset[str]) -> bool:
            return trial.drive(values={name: mine[name] if name in kept else back[name] for name in mine}).crashed

        where = "the middle" if told.back.name == MIDDLE else "a scene"
        counts[f"values needed: {len(told.values)}, set back to {where}"] += 1
        yield from _minimal(differing, frozenset(one.name for one in told.values), with_values, "values", counts)
    free: dict[Placing, str] = {}
    actors = {actor: thing for thing in told.things if thing.needed is not None for actor in thing.actors}
    for placing in placings(trial.program):
        came = trial.drive(without(trial.program, [placing])) if not placing.asked_for else None
        if came is not None and came.episode is not None:
            there = {(track.kind, float(track.x[0])) for track in came.episode.tracks}
            for track in trial.episode.tracks:
                if track.actor in actors and (track.kind, float(track.x[0])) not in there:
                    free[placing] = track.actor

    def with_things(kept: frozenset[Placing]) -> bool:
        return trial.drive(without(trial.program, [one for one in free if one not in kept])).crashed

    needed = frozenset(one for one, actor in free.items() if actors[actor].needed)
    counts["things that can be left out"] += len(free)
    counts["things needed"] += len(needed)
    yield from _minimal(list(free), needed, with_things, "things", counts)
    if told.changeable:
        yield from _of_ego(trial, told, counts)


def _minimal(
    causes: Sequence[C], found: frozenset[C], crashes: Callable[[frozenset[C]], bool], noun: str, counts: Counter[str]
) -> Iterator[str]:
    if not crashes(found):
        yield f"DOES NOT HOLD: the {noun} found do not crash"
    for one in found:
        if crashes(found - {one}):
            yield f"DOES NOT HOLD: of the {noun} found, {one} is not needed"
    if len(causes) > MOST:
        counts[f"{noun}: too many for every subset"] += 1
        return
    sizes = [
        size
        for size in range(len(causes) + 1)
        if any(crashes(frozenset(kept)) for kept in itertools.combinations(causes, size))
    ]
    counts[f"{noun}: {'as few as can be' if min(sizes) == len(found) else 'a smaller set exists'}"] += 1


def _of_ego(trial: Trial, told: Why, counts: Counter[str]) -> Iterator[str]:
    trial = replace(trial, ego=load_ego(trial.episode.ego))
    pedals, crash, dt = pedals_of(trial.ego), trial.crash.step, trial.episode.dt

    def braking(step: int) -> bool:
        return trial.instead(_Braking(trial.ego, step), pedals, max(step, crash))

    def limited(limit: float) -> bool:
        return trial.instead(_Limited(trial.ego, limit, dt), pedals, crash)

    counts["braking earlier avoids it"] += told.braking is not None
    counts["going slower avoids it"] += told.slower is not None
    first = told.braking.step if told.braking else -1
    by_luck = sum(braking(step) for step in range(first + 1, crash))
    counts["later moments of braking that avoid it by luck"] += by_luck
    if told.braking and not all(braking(step) for step in range(max(first - BEYOND, 0), first + 1)):
        yield "DOES NOT HOLD: braking from then on, or a little earlier, crashes"
    if told.slower:
        limits = [told.slower.limit - less * FINENESS for less in range(BEYOND + 1)]
        below = [limit for limit in limits if limit >= told.slower.highest * 0.5]
        if not all(map(limited, below)):
            yield "DOES NOT HOLD: going slower, or a little slower still, crashes"


if __name__ == "__main__":
    main()
