"""How many random situations are built, placed, driven and shown, and why the others are not.

    python benchmarks/building.py --count 1000 --seed 7

Draws situations of one to three road users with one to four deeds each, from all places, kinds and acts that one such
road user can have, half of the deeds with a number; builds each, drives it with drawn values and judges the tracks.
`--files FOLDER` takes the situations of a folder (`.yaml`, `.json`) in their place. Prints the shares, the commonest
reasons, and with `--each` a line per situation.
"""

from __future__ import annotations

import random
from collections import Counter
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import click

from chatscene.build.build import build
from chatscene.build.deeds import steps_for
from chatscene.build.starts import STARTS, Meets
from chatscene.commands.situations import SUFFIXES
from chatscene.ego.policy import load_ego, wanting
from chatscene.errors import DoesNotCompile, MapError, NotBuilt
from chatscene.maps.network import resolve_map
from chatscene.program.judge import failures, judge
from chatscene.program.sample import draw
from chatscene.settings import SimulationSettings
from chatscene.simulate.simulator import Simulator, load_simulator, simulate
from chatscene.situations.check import faults_of
from chatscene.situations.file import read_file
from chatscene.terms.actors import Manner as Moves
from chatscene.terms.amount import Acceleration, Duration, Length, Speed
from chatscene.terms.scene import Rejected, Scene
from chatscene.terms.situation import Deed, Ego, Other, Situation, Start
from chatscene.terms.vocabulary import Act, EgoRoute, Facing, Role, Side, UserKind, Where

MEETS = {
    Where.ARM: Meets.THROUGH,
    Where.IN_ROUNDABOUT: Meets.THROUGH,
    Where.ROUNDABOUT_ENTRY: Meets.THROUGH,
    Where.ONCOMING: Meets.TOWARD,
    Where.ONCOMING_IN_OUR_LANE: Meets.TOWARD,
    Where.KERB: Meets.KERB,
} | dict.fromkeys(
    (Where.ROADSIDE, Where.DRIVEWAY, Where.CROSSING, Where.EXIT_CROSSING, Where.MEDIAN), Meets.ACROSS
)  # fmt: skip
NUMBERS = {
    "speed": lambda rng: Speed.of(f"{rng.randint(5, 60)} km/h"),
    "acceleration": lambda rng: Acceleration.of(f"{rng.randint(2, 7)} m/s²"),
    "time": lambda rng: Duration.of(f"{rng.randint(1, 4)} s"),
    "distance": lambda rng: Length.of(f"{rng.randint(2, 10)} m"),
}


def drawn(rng: random.Random) -> Situation:
    """A situation at random."""
    others = tuple(_somebody(rng, name) for name in "ABC"[: rng.choice((1, 1, 2, 3))])
    speed = Speed.of(f"{rng.randint(15, 50)} km/h") if rng.random() < 0.3 else None
    routes = (None, EgoRoute.STRAIGHT, EgoRoute.LEFT_TURN, EgoRoute.RIGHT_TURN, EgoRoute.LANE_CHANGE_LEFT)
    return Situation(ego=Ego(route=rng.choice(routes), speed=speed), others=others)


def _somebody(rng: random.Random, name: str) -> Other:
    kind = rng.choice([one for one in UserKind if one.moves is not Moves.LIES])
    walks = kind.moves is Moves.WALKS
    on_foot = (Where.AHEAD, Where.ROADSIDE, Where.CROSSING, Where.EXIT_CROSSING, Where.MEDIAN, Where.DRIVEWAY)
    where = rng.choice([one for one in STARTS if not walks or one in on_foot])
    table = steps_for(MEETS.get(where, Meets.ALONG), walks=walks, beside="beside" in where.value)
    acts = [act for act in Act if act in table and kind.moves in act.row.by]
    does = tuple(_deed(rng, rng.choice(acts), table) for _ in range(rng.choice((1, 1, 2, 3, 4))))
    side = rng.choice((Side.LEFT, Side.RIGHT, None)) if where.row.sided else None
    facing = rng.choice((None, Facing.ALONG)) if where is Where.AHEAD and walks else None
    return Other(
        id=name,
        kind=kind,
        role=Role.ADVERSARY if name == "A" else Role.SUPPORTING,
        starts=Start(where=where, side=side, facing=facing),
        does=does,
    )


def _deed(rng: random.Random, act: Act, table: object) -> Deed:
    binds = table[act].binds  # type: ignore[index]
    taken = [name for name in binds if name in act.row.takes]
    said = {name: NUMBERS[name](rng) for name in taken if rng.random() < 0.5}
    return Deed(act=act, **said)


@cache
def simulator(map_name: str) -> Simulator:
    """The native simulator on a map."""
    return load_simulator(resolve_map(map_name), SimulationSettings(simulator="native"))


def outcome(situation: Situation, drives: int, ego: str) -> tuple[str, list[str]]:
    """What became of one, and why: ``refused``, ``not placed``, ``shown`` in all drives, ``in part``, ``not shown``."""
    try:
        made = build(situation)
    except NotBuilt as refusal:
        return "refused", [str(refusal)]
    shown, seen, reasons = 0, 0, list[str]()
    for seed in range(drives):
        values = draw(made.program.parameters, seed=seed)
        scene = Scene(id=f"s/route-00/{seed}", scenario_id="s", route=0, block=0, seed=seed, values=values)
        try:
            driver = wanting(load_ego(ego), made.program.wanted_speed)
            episode = simulate(simulator(made.map), made.program, scene, driver)
        except MapError as error:
            return "refused", [str(error)]
        except DoesNotCompile as error:
            return "not placed", [str(error)]
        if isinstance(episode, Rejected):
            reasons.append(episode.reason)
            continue
        seen += 1
        unseen = failures(judge(situation, episode, simulator(made.map).route(made.program, 0)))
        shown += not unseen
        reasons += unseen
    if not seen:
        return "not placed", reasons
    return ("shown" if shown == seen else "in part" if shown else "not shown"), reasons


def situations(count: int, seed: int, files: Path | None) -> Iterator[tuple[str, Situation]]:
    """Those that are measured, each with a name."""
    if files is not None:
        for file in sorted(files.iterdir()):
            if file.suffix in SUFFIXES:
                yield file.name, read_file(file)
        return
    rng = random.Random(seed)
    made = 0
    while made < count:
        one = drawn(rng)
        if not tuple(faults_of(one)):
            made += 1
            yield str(made), one


@click.command()
@click.option("--count", default=200, show_default=True)
@click.option("--seed", default=7, show_default=True)
@click.option("--drives", default=4, show_default=True)
@click.option("--ego", default="idm", show_default=True)
@click.option("--files", type=click.Path(path_type=Path, exists=True, file_okay=False), default=None)
@click.option("--each", is_flag=True)
def main(count: int, seed: int, drives: int, ego: str, files: Path | None, each: bool) -> None:
    """Build, drive and judge situations."""
    became, why = Counter[str](), Counter[str]()
    for name, one in situations(count, seed, files):
        what, reasons = outcome(one, drives, ego)
        became[what] += 1
        why.update({f"{what}: {_general(reason)}" for reason in reasons})
        if each:
            who = "; ".join(f"{o.kind} {o.starts.where}: {', '.join(d.act for d in o.does)}" for o in one.others)
            click.echo(f"{name}\t{what}\t{one.ego.route or 'straight'}; {who}\t{'; '.join(sorted(set(reasons)))[:200]}")
    total = sum(became.values())
    for what, number in became.most_common():
        click.echo(f"{what}: {number} of {total} ({number / total:.1%})")
    for reason, number in why.most_common(25):
        click.echo(f"  {number}  {reason}")


def _general(reason: str) -> str:
    """A reason without names and numbers."""
    import re

    words = re.sub(r"others\.\w+\.does\.\d+\.", "", reason)
    return re.sub(r"others\.\w+\.|\d+(?:\.\d+)?", "", words)[:90]


if __name__ == "__main__":
    main()
