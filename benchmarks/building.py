"""How many random situations are built, placed, driven and shown, and why the others are not.

    python benchmarks/building.py --count 1000 --seed 7
    python benchmarks/building.py --count 1000 --seed 7 --as-said

Draws situations of one to three road users with one to four deeds each, from all places, kinds and acts that one such
road user can have, half of the deeds with a number that the body can do; counts those that cannot be apart; builds
each of the others, drives it with drawn values and judges the tracks.
`--as-said` draws them of parts that people said together (`as_said.py`); else any word is as likely as another.
`--act NAME` takes one act in their place: from each place, by each kind that moves in its own way, alone, after another
deed and before one, `--count` of these (200 take about two minutes of one idle core; with `--count 1000` all);
`--files FOLDER` takes the situations of a folder (`.yaml`, `.json`). Prints the shares, the commonest reasons with `#`
for numbers and the name of a situation of each, and with `--each` a line per situation, and below it when what was said
is seen. `--examples FOLDER` writes the situation of each reason there, so that `--files` drives these alone.
"""

from __future__ import annotations

import random
import re
import time
from collections import Counter
from collections.abc import Iterator, Mapping
from functools import cache
from pathlib import Path
from typing import Any

import click
from as_said import drawn_as_said

from chatscene.api.make import SITUATION_SUFFIXES
from chatscene.build.asked import Meets
from chatscene.build.build import Built, build
from chatscene.build.deeds import Steps, steps_for
from chatscene.build.possible import impossible
from chatscene.build.starts import STARTS
from chatscene.ego.asking import wanting
from chatscene.ego.policy import load_ego
from chatscene.errors import DoesNotCompile, MapError, NotBuilt
from chatscene.maps.network import resolve_map
from chatscene.program.judge import failures, judge
from chatscene.program.sample import draw
from chatscene.search.rehearsal import rehearsed
from chatscene.settings import SimulationSettings
from chatscene.simulate.simulator import Simulator, load_simulator, simulate
from chatscene.situations.check import faults_of
from chatscene.situations.file import read_file, to_yaml
from chatscene.terms.actors import Limits
from chatscene.terms.actors import Manner as Moves
from chatscene.terms.amount import Acceleration, Amount, Duration, Length, Speed
from chatscene.terms.episode import Episode
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
TELLS = 10.0  # [s] between two lines that say how far it is
SHARE = 0.9  # of what a body can do, up to which numbers are drawn
GAINS = (Act.ACCELERATE, Act.SET_OFF)


def _amount(rng: random.Random, name: str, act: Act, body: Limits) -> Amount:
    """A number that a body can do."""
    match name:
        case "speed":
            return Speed.of(f"{rng.randint(3, max(4, int(min(60.0, 3.6 * SHARE * body.top_speed))))} km/h")
        case "acceleration":
            most = body.throttle if act in GAINS else body.brake
            return Acceleration.of(f"{rng.uniform(1.0, max(1.0, SHARE * most)):.1f} m/s²")
        case "time":
            return Duration.of(f"{rng.randint(1, 4)} s")
        case _:
            return Length.of(f"{rng.randint(2, 10)} m")


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
    body, many = kind.row.body.row.limits, rng.choice((1, 1, 2, 3, 4))
    does = tuple(_deed(rng, rng.choice(acts), table, body) for _ in range(many))
    side = rng.choice((Side.LEFT, Side.RIGHT, None)) if where.row.sided else None
    facing = rng.choice((None, Facing.ALONG)) if where is Where.AHEAD and walks else None
    return Other(
        id=name,
        kind=kind,
        role=Role.ADVERSARY if name == "A" else Role.SUPPORTING,
        starts=Start(where=where, side=side, facing=facing),
        does=does,
    )


def _deed(rng: random.Random, act: Act, table: Mapping[Act, Steps], body: Limits) -> Deed:
    taken = [name for name in table[act].binds if name in act.row.takes]
    said: dict[str, Any] = {name: _amount(rng, name, act, body) for name in taken if rng.random() < 0.5}
    return Deed(act=act, **said)


@cache
def simulator(map_name: str) -> Simulator:
    """The native simulator on a map."""
    return load_simulator(resolve_map(map_name), SimulationSettings(simulator="native"))


def drive(made: Built, ego: str, seed: int) -> Episode | Rejected:
    """One drive of what was built, with values drawn by a seed; or why there is none.

    Raises:
        MapError: The program asks for a place that its map has not.
        DoesNotCompile: No scene can be made of it.
    """
    values = draw(made.program.parameters, seed=seed)
    scene = Scene(id=f"s/route-00/{seed}", scenario_id="s", route=0, block=0, seed=seed, values=values)
    driver = wanting(load_ego(ego), made.program.wanted_speed)
    return simulate(simulator(made.map), made.program, scene, driver)


def outcome(situation: Situation, drives: int, ego: str) -> tuple[str, list[str], list[str]]:
    """What became of one, why, and when each deed was seen in the first drive that was judged.

    It is ``impossible``, ``refused``, ``not placed``, ``not shown``, shown ``in part`` of its drives, or ``shown``.
    """
    if cannot := [one.said for one in impossible(situation)]:
        return "impossible", cannot, []
    try:
        made = rehearsed(build(situation), situation)
    except NotBuilt as refusal:
        return "refused", [str(refusal)], []
    shown, seen, reasons, times = 0, 0, list[str](), list[str]()
    for seed in range(drives):
        try:
            episode = drive(made, ego, seed)
        except MapError as error:
            return "refused", [str(error)], []
        except DoesNotCompile as error:
            return "not placed", [str(error)], []
        if isinstance(episode, Rejected):
            reasons.append(episode.reason)
            continue
        seen += 1
        findings = tuple(judge(situation, episode, simulator(made.map).route(made.program, 0)))
        times = times or [f"{one.path} at {one.at:.1f} s" for one in findings if one.at is not None]
        unseen = failures(findings)
        shown += not unseen
        reasons += unseen
    if not seen:
        return "not placed", reasons, []
    return ("shown" if shown == seen else "in part" if shown else "not shown"), reasons, times


NEIGHBOURS = (Act.GO_ALONG, Act.BRAKE, Act.ACCELERATE, Act.STOP)
"""What somebody does before or after an act that is tried in every place."""


def of_act(act: Act) -> Iterator[tuple[str, Situation]]:
    """An act from every place: alone, and with each neighbour before it and behind it; who cannot so is left out."""
    kinds = {kind.moves: kind for kind in reversed(UserKind) if kind.can(act) and not kind.row.general}
    row = [(act,), *((one, act) for one in NEIGHBOURS), *((act, one) for one in NEIGHBOURS)]
    for where in Where:
        for kind in kinds.values():
            for acts in row:
                if not all(kind.can(one) for one in acts):
                    continue
                sides = (Side.LEFT, Side.RIGHT) if where.row.sided else (None,)
                for side in sides:
                    does = tuple(Deed(act=one) for one in acts)
                    start = Start(where=where, side=side)
                    made = Situation(ego=Ego(), others=(Other(id="A", kind=kind, starts=start, does=does),))
                    if not tuple(faults_of(made)) and not tuple(impossible(made)):
                        yield f"{where}/{side or '-'}/{kind}/{'+'.join(acts)}", made


def situations(count: int, seed: int, files: Path | None, as_said: bool) -> Iterator[tuple[str, Situation]]:
    """Those that are measured, each with a name."""
    if files is not None:
        for file in sorted(files.iterdir()):
            if file.suffix in SITUATION_SUFFIXES:
                yield file.name, read_file(file)
        return
    rng = random.Random(seed)
    made = 0
    while made < count:
        one = drawn_as_said(rng) if as_said else drawn(rng)
        if not tuple(faults_of(one)):
            made += not tuple(impossible(one))
            yield str(made), one


def sampled(act: Act, count: int, seed: int) -> list[tuple[str, Situation]]:
    """So many of those of an act, drawn by a seed, in their order; all where there are no more."""
    found = list(of_act(act))
    chosen = sorted(random.Random(seed).sample(range(len(found)), min(count, len(found))))
    click.echo(f"{len(chosen)} of {len(found)} situations of {act}", err=True)
    return [found[n] for n in chosen]


@click.command()
@click.option("--count", default=200, show_default=True, help="How many situations, of those of an act as well.")
@click.option("--seed", default=7, show_default=True)
@click.option("--drives", default=4, show_default=True)
@click.option("--ego", default="idm", show_default=True)
@click.option("--files", type=click.Path(path_type=Path, exists=True, file_okay=False), default=None)
@click.option("--as-said", is_flag=True)
@click.option("--act", type=click.Choice([str(one) for one in Act]), default=None)
@click.option("--each", is_flag=True)
@click.option("--examples", type=click.Path(path_type=Path, file_okay=False), default=None)
def main(
    count: int,
    seed: int,
    drives: int,
    ego: str,
    files: Path | None,
    as_said: bool,
    act: str | None,
    each: bool,
    examples: Path | None,
) -> None:
    """Build, drive and judge situations."""
    became, why, example = Counter[str](), Counter[str](), dict[str, tuple[str, Situation]]()
    begun = told = time.monotonic()
    chosen = situations(count, seed, files, as_said) if act is None else sampled(Act(act), count, seed)
    for number, (name, one) in enumerate(chosen):
        if (now := time.monotonic()) - told > TELLS:
            told = now
            click.echo(f"{number} situations in {now - begun:.0f} s: {dict(became)}", err=True)
        what, reasons, times = outcome(one, drives, ego)
        became[what] += 1
        general = {f"{what}: {_general(reason)}" for reason in reasons}
        why.update(general)
        for reason in general:
            example.setdefault(reason, (name, one))
        if each and what != "impossible":
            who = "; ".join(f"{o.kind} {o.starts.where}: {', '.join(d.act for d in o.does)}" for o in one.others)
            click.echo(f"{name}\t{what}\t{one.ego.route or 'straight'}; {who}\t{'; '.join(sorted(set(reasons)))[:200]}")
            if times:
                click.echo(f"\t{', '.join(times)}")
    total = sum(became.values()) - became["impossible"]
    click.echo(f"impossible: {became['impossible']}, which are not counted below")
    for what in ("refused", "not placed", "not shown", "in part", "shown"):
        click.echo(f"{what}: {became[what]} of {total} ({became[what] / max(total, 1):.1%})")
    if tried := total - became["refused"]:
        click.echo(f"shown of what is not refused: {became['shown']} of {tried} ({became['shown'] / tried:.1%})")
    for place, (reason, number) in enumerate(why.most_common(25), 1):
        name, one = example[reason]
        click.echo(f"  {number}  {reason}  (such as {name})")
        if examples is not None:
            examples.mkdir(parents=True, exist_ok=True)
            (examples / f"{place:02}.yaml").write_text(f"# {reason}\n{to_yaml(one)}", encoding="utf-8")


def _general(reason: str) -> str:
    """A reason without names, and with ``#`` for each number."""
    words = re.sub(r"others\.\w+\.(?:does\.\d+\.)?", "", reason)
    return re.sub(r"\d+(?:\.\d+)?", "#", words)[:120]


if __name__ == "__main__":
    main()
