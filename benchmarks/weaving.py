"""How much an ego weaves: swings of its heading, jerk to the side and collisions, in drives that texts of others give.

    python benchmarks/weaving.py [--ego planner] [--draws 2]

Situations are those that a language model read in the texts of `reading/fresh-eighth.jsonl` and `fresh-ninth.jsonl`, as
far as they are built; each is driven on its first route with values drawn by seeds from 0, without a search. A swing is
a turn of the heading by a degree or more and back by as much, both ends within a second. The jerk is the change of
speed times yaw rate from step to step. Prints one line for each ego.
"""

from __future__ import annotations

import json
from collections.abc import Iterator

import click
import numpy as np
from building import simulator
from numpy.typing import NDArray
from recorded_replies import REPLIES, Recorded, replayed

from chatscene.build.build import Built, build
from chatscene.ego.asking import fitted
from chatscene.ego.policy import load_ego
from chatscene.errors import ChatSceneError
from chatscene.program.sample import draw
from chatscene.simulate.simulator import routes_of, simulate
from chatscene.terms.episode import Episode
from chatscene.terms.scene import Scene

SETS = ("fresh-eighth", "fresh-ninth")
TURNED = np.radians(1.0)
WITHIN = 1.0  # [s]
MOVES = 0.5  # [m/s]


def built() -> Iterator[Built]:
    """What the replies of the sets come to, as far as it is built."""
    for name in SETS:
        for line in REPLIES.with_name(f"{name}.jsonl").read_text().splitlines():
            row = json.loads(line)
            if not row["in_reach"]:
                continue
            said = replayed(Recorded(id=row["id"], text=row["text"], replies=tuple(row["replies"])))
            if said.situation is not None and said.outcome in ("built", "built in part"):
                try:
                    yield build(said.situation)
                except ChatSceneError as refusal:
                    print(f"{row['id']}: {refusal}")


def swings(heading: NDArray[np.float64], dt: float) -> int:
    """How often a heading [rad] turns by `TURNED` and back by as much within `WITHIN`."""
    turns, far, at, way = list[int](), heading[0], 0, 0.0
    for i, now in enumerate(heading.tolist()):
        if way == 0.0:
            way = float(np.sign(now - far)) if abs(now - far) > TURNED else 0.0
            far, at = (now, i) if way else (far, at)
        elif (now - far) * way > 0.0:
            far, at = now, i
        elif (far - now) * way > TURNED:
            turns.append(at)
            far, at, way = now, i, -way
    return int((np.diff(turns) * dt <= WITHIN).sum())


def told(name: str, programs: list[Built], draws: int) -> str:
    """What an ego's drives come to, in words."""
    drives = collisions = turns = 0
    moving, jerks, worst, driven = 0.0, list[NDArray[np.float64]](), list[float](), list[float]()
    for made in programs:
        where, ego = simulator(made.map), fitted(load_ego(name), made.program)
        route = next(iter(routes_of(where, made.program, 1)))
        for seed in range(draws):
            values = draw(made.program.parameters, seed=seed)
            scene = Scene(id="weaving", scenario_id="weaving", route=route, block=0, seed=seed, values=values)
            episode = simulate(where, made.program, scene, ego)
            if not isinstance(episode, Episode):
                continue
            track, dt = episode.ego_track, episode.dt
            heading, speed = np.unwrap(track.heading), np.asarray(track.speed)
            jerk = np.diff(speed[1:] * np.diff(heading) / dt) / dt
            drives, collisions = drives + 1, collisions + (episode.collision is not None)
            turns += swings(heading, dt)
            moving += float((np.abs(speed[1:]) > MOVES).sum()) * dt
            jerks.append(jerk)
            worst.append(float(np.abs(jerk).max(initial=0.0)))
            driven += speed.tolist()
    rms = float(np.sqrt(np.square(np.concatenate(jerks)).mean()))
    return (
        f"{name}: {drives} drives, {moving:.0f} s that it moves; {turns / moving:.3f} swings a second; jerk to the "
        f"side {rms:.1f} m/s³ (rms), its most in the median drive {np.median(worst):.0f}; {collisions} collisions; "
        f"{np.mean(driven):.2f} m/s"
    )


@click.command()
@click.option("--ego", "egos", multiple=True, default=("planner", "hardened", "idm"), show_default=True)
@click.option("--draws", default=2, show_default=True, help="Of values, for each situation.")
def main(egos: tuple[str, ...], draws: int) -> None:
    """Print a line for each ego."""
    programs = list(built())
    for name in egos:
        print(told(name, programs, draws), flush=True)


if __name__ == "__main__":
    main()
