"""What an ego drives at the moment for which its speed and its gap were said: when who is before it begins to act.

    python benchmarks/run_ups.py FILE... [--ego planner] [--ego idm] [--drives 4]

FILE has recorded replies, as `benchmarks/reading/fresh-seventh.jsonl`: of those in which an ego of a said speed follows
somebody, or has somebody at a said distance before it, who then brakes, stops or leaves the lane. Each is built and
driven. Prints for each ego the share of its said speed and of its gap at first that it has when that one has lost
1.5 m/s, or has turned by 2 degrees.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path

import click
import numpy as np
from recorded_replies import Recorded, replayed

from chatscene.build.build import build
from chatscene.ego.asking import wanting
from chatscene.ego.policy import load_ego
from chatscene.maps.network import resolve_map
from chatscene.program.sample import drawn_scene
from chatscene.settings import SimulationSettings
from chatscene.simulate.simulator import load_simulator, simulate
from chatscene.terms.episode import Episode
from chatscene.terms.situation import Other, Situation
from chatscene.terms.vocabulary import LOSES, Act, Heads, Where, acts_of

LOST, TURNED = 1.5, 0.035  # [m/s], [rad]
_ACTS = LOSES | acts_of(Heads.OUT)


def leads(situation: Situation) -> Iterator[Other]:
    """Those who go before an ego of a said speed, at a gap that was said, and then act."""
    follows = any(deed.act is Act.FOLLOW and (deed.time or deed.distance) for deed in situation.ego.does)
    for one in situation.others:
        near = one.starts.where is Where.AHEAD and (follows or one.starts.distance is not None)
        if situation.ego.speed is not None and near and any(deed.act in _ACTS for deed in one.does):
            yield one


def at_event(episode: Episode, name: str) -> tuple[float, float] | None:
    """The shares of its first speed and of its first gap that an ego has when somebody begins to act."""
    ego, one = episode.ego_track, next(track for track in episode.tracks if track.actor == name)
    acts = np.flatnonzero((one.speed < one.speed[0] - LOST) | (np.abs(one.heading - one.heading[0]) > TURNED))
    if not acts.size or one.speed[0] < 1.0:
        return None
    gap = np.hypot(one.x - ego.x, one.y - ego.y) - 0.5 * (one.length + ego.length)
    return float(ego.speed[acts[0]] / ego.speed[0]), float(gap[acts[0]] / gap[0])


@click.command()
@click.argument("files", type=click.Path(exists=True, path_type=Path), nargs=-1)
@click.option("--ego", "egos", multiple=True, default=("planner", "idm"))
@click.option("--drives", default=4)
def main(files: tuple[Path, ...], egos: tuple[str, ...], drives: int) -> None:
    """Measure what is held at the moment for which it was said."""
    found: dict[str, list[tuple[float, float]]] = {ego: [] for ego in egos}
    for row in (json.loads(line) for file in files for line in file.read_text(encoding="utf-8").splitlines()):
        if not row.get("replies"):
            continue
        met = replayed(Recorded(id=row["id"], text=row["text"], replies=tuple(row["replies"])))
        if met.outcome != "built" or met.situation is None or not (lead := next(leads(met.situation), None)):
            continue
        program, where = (made := build(met.situation)).program, resolve_map(made.map)
        simulator = load_simulator(where, SimulationSettings(simulator="native"))
        for ego in egos:
            driver = wanting(load_ego(ego), program.wanted_speed)
            episodes = [simulate(simulator, program, drawn_scene(program, k, seed=0), driver) for k in range(drives)]
            shares = [at_event(one, lead.id) for one in episodes if isinstance(one, Episode)]
            found[ego] += (seen := [one for one in shares if one is not None])
            speed, gap = np.median(seen, axis=0) if seen else (np.nan, np.nan)
            click.echo(f"{row['id']}\t{ego}\tspeed {speed:.2f}\tgap {gap:.2f}")
    for ego, shares in found.items():
        speed, gap = np.median(shares, axis=0)
        off = sum(abs(speed - 1.0) > 0.05 or abs(gap - 1.0) > 0.1 for speed, gap in shares)
        click.echo(f"{ego}: {len(shares)} drives, median speed {speed:.2f}, gap {gap:.2f}; {off} off by 5 % or 10 %")


if __name__ == "__main__":
    main()
