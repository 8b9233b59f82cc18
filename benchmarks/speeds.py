"""Whether whoever drives is as fast as was said, or as the road has it, before anything happens: from tracks.

    python benchmarks/speeds.py [--ego idm] [--ego planner] [--count 30] [--drives 2]

The situations are those that language models read in texts of others (`reading/`), in the order of the files: the first
`--count` that say a speed of the ego or of another on wheels from 10 to 130 km/h, and the first in which nobody has a
speed and the ego is only said to drive. Each is built and driven with seeds from 0.

- The ego, in the last second before it first brakes: its mean speed against what was said, or against the road's usual
  one where nothing was said (town 50, rural 80, motorway 110 km/h).
- Another: of a speed at the start, the first second; of a speed of a deed, any second before the ego touches somebody.

A speed is reached within 5 %. A text counts if each of its speeds is reached in each drive. Prints the misses with
their cause, totals, and in how many drives the ego brakes within its first second, so that it has the speed at first
only.
"""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

import click
import numpy as np
from building import simulator

from chatscene.build.build import Built, build
from chatscene.ego.asking import fitted
from chatscene.ego.policy import load_ego
from chatscene.errors import DoesNotCompile, MapError, NotBuilt
from chatscene.program.sample import draw, scene_seed
from chatscene.read.by_model import situation_in
from chatscene.simulate.simulator import simulate
from chatscene.situations.faults import Malformed
from chatscene.terms.actors import Manner as Moves
from chatscene.terms.amount import Speed
from chatscene.terms.arrays import Array
from chatscene.terms.episode import Episode, Track
from chatscene.terms.scene import Rejected, Scene
from chatscene.terms.situation import EGO, Other, Situation
from chatscene.terms.vocabulary import EgoRoute, RoadKind, Setting

READING = Path(__file__).parent / "reading"
FILES = ("fresh-second.jsonl", "fresh-third.jsonl")
SLOWEST, FASTEST = 10 / 3.6, 130 / 3.6  # [m/s] that are looked at
NEAR = 0.05  # of a speed
SECOND = 10  # steps
TRIES = 20  # draws for a drive, of which the first that can be placed is driven
BRAKES = -0.5  # [m/s²] from which on somebody brakes
USUAL = {RoadKind.MOTORWAY: 110 / 3.6, Setting.RURAL: 80 / 3.6}  # [m/s]
TOWN = 50 / 3.6


@dataclass(frozen=True, slots=True)
class Wanted:
    """A speed that somebody is to have.

    Attributes:
        who: ``ego``, or an id.
        path: Of the fact; empty where nothing was said.
        least: [m/s].
        most: [m/s].
        first: Whether it is had at the start.
    """

    who: str
    path: str
    least: float
    most: float
    first: bool = False

    def by(self, speed: float) -> bool:
        """Whether a speed [m/s] is it within 5 %."""
        return (1 - NEAR) * self.least <= speed <= (1 + NEAR) * self.most

    def __str__(self) -> str:
        ends = sorted({round(3.6 * one) for one in (self.least, self.most) if np.isfinite(one)})
        return f"{self.path or 'ego, not said'}: {' to '.join(map(str, ends))} km/h"


def texts() -> Iterator[tuple[str, Situation]]:
    """The situation of each text of others, by its id."""
    for name in FILES:
        for line in (READING / name).read_text(encoding="utf-8").splitlines():
            row = json.loads(line)
            try:
                yield row["id"], situation_in(row["replies"][-1].get("situation"))
            except (Malformed, AttributeError):
                continue


def said(situation: Situation) -> tuple[Wanted, ...]:
    """The speeds that were said of the ego and of others on wheels, from 10 to 130 km/h."""
    return tuple(_wanted(situation))


def _wanted(situation: Situation) -> Iterator[Wanted]:
    if (one := _speed(situation.ego.speed)) is not None:
        yield Wanted(EGO, "ego.speed", *one)
    for other in situation.others:
        if other.kind.moves is Moves.WALKS:
            continue
        if (one := _speed(other.starts.speed)) is not None:
            yield Wanted(other.id, f"others.{other.id}.starts.speed", *one, first=True)
        for i, deed in enumerate(other.does):
            if (one := _speed(deed.speed)) is not None:
                yield Wanted(other.id, f"others.{other.id}.does.{i}.speed", *one)


def _speed(amount: Speed | None) -> tuple[float, float] | None:
    """Its least and its most [m/s], if it is one of those that are looked at."""
    if amount is None or amount.than_ego:
        return None
    low, high = max(amount.low, 0.0), amount.high
    some = high if np.isfinite(high) else low
    return (low, high) if SLOWEST - 1e-9 <= some <= FASTEST + 1e-9 else None


def unsaid(situation: Situation) -> tuple[Wanted, ...]:
    """The usual speed of the road, where nobody has a speed and the ego is only said to drive; else nothing."""
    drives = not situation.ego.does and situation.ego.route in (None, EgoRoute.STRAIGHT)
    speeds = (one for other in situation.others for one in _of(other))
    if not drives or situation.ego.speed is not None or any(one is not None for one in speeds):
        return ()
    road = situation.road
    usual = USUAL.get(road.kind) or USUAL.get(road.setting) or TOWN  # pyright: ignore[reportArgumentType, reportCallIssue]
    return (Wanted(EGO, "", usual, usual),)


def _of(other: Other) -> Iterator[Speed | None]:
    yield other.starts.speed
    yield from (deed.speed for deed in other.does)


def second_before_braking(track: Track, until: int, dt: float) -> Array:
    """The speeds [m/s] of the last second before somebody first brakes, or before it touches somebody."""
    braking = np.flatnonzero(track.acceleration(dt)[1 : until + 1] < BRAKES)
    end = max(int(braking[0]) if len(braking) else until, 1)
    return track.speed[max(end - SECOND, 0) : end + 1]


def missed(one: Wanted, episode: Episode) -> str:
    """Why a speed is not reached in a drive; empty if it is."""
    until = episode.collision.step if episode.collision else len(episode.ego_track.x) - 1
    if one.who == EGO:
        track = episode.ego_track
        mean = float(np.mean(second_before_braking(track, until, episode.dt)))
        if one.by(mean):
            return ""
        best = float(track.speed[: until + 1].max())
        why = (
            "is reached later" if one.by(best) else "brakes for somebody before" if mean < best - 0.5 else "wants that"
        )
        return f"{3.6 * mean:.0f} km/h before it first brakes, {3.6 * best:.0f} at most ({why})"
    track = next((track for track in episode.tracks if track.actor == one.who), None)
    if track is None:
        return "is not there"
    had = np.abs(track.speed[: max(until, SECOND) + 1])
    means = (
        np.convolve(had, np.full(SECOND + 1, 1 / (SECOND + 1)), "valid")
        if len(had) > SECOND
        else np.array([had.mean()])
    )
    if one.by(float(means[0])) or (not one.first and any(one.by(float(mean)) for mean in means)):
        return ""
    first, least, most = (round(3.6 * float(speed)) for speed in (means[0], means.min(), means.max()))
    return f"{first} km/h at first, {least} to {most} later"


def driven(made: Built, ego: str, seed: int) -> Episode | str:
    """One drive with values drawn by a seed, as a search draws until they can be placed; or why there is none."""
    driver, why = fitted(load_ego(ego), made.program), ""
    for number in range(TRIES):
        own = scene_seed(seed, f"draw-{number}")
        values = draw(made.program.parameters, seed=own)
        scene = Scene(id=f"s/route-00/{seed}", scenario_id="s", route=0, block=0, seed=own, values=values)
        try:
            episode = simulate(simulator(made.map), made.program, scene, driver)
        except (MapError, DoesNotCompile) as error:
            return f"not placed: {error}"
        if not isinstance(episode, Rejected):
            return episode
        why = episode.reason
    return f"not placed: {why}"


@dataclass(slots=True)
class Outcome:
    """What became of a text.

    Attributes:
        misses: The speeds that its drives miss, each with its cause, or why there is no drive; none is good.
        drives: How many were driven.
        early: In how many of them the ego brakes within its first second.
    """

    misses: dict[str, str] = field(default_factory=dict[str, str])
    drives: int = 0
    early: int = 0

    @property
    def kind(self) -> str:
        """``reached``, ``missed``, ``not built`` or ``not placed``."""
        first = next(iter(self.misses.values()), "")
        return "reached" if not first else first.split(":")[0] if first.startswith("not ") else "missed"


def outcome(situation: Situation, wanted: tuple[Wanted, ...], ego: str, drives: int) -> Outcome:
    """What becomes of a text with the speeds that it is to have."""
    found = Outcome()
    try:
        made = build(situation)
    except NotBuilt as refusal:
        return Outcome({"": f"not built: {refusal}"})
    for seed in range(drives):
        episode = driven(made, ego, seed)
        if isinstance(episode, str):
            found.misses.setdefault("", episode)
            continue
        found.drives += 1
        found.early += bool((episode.ego_track.acceleration(episode.dt)[1 : SECOND + 1] < BRAKES).any())
        for one in wanted:
            if why := missed(one, episode):
                found.misses.setdefault(str(one), f"{one}: {why}, {made.map}")
    return found


@click.command()
@click.option("--ego", "egos", multiple=True, default=("idm", "planner"), show_default=True)
@click.option("--count", default=30, show_default=True, help="Texts with a speed, and as many without.")
@click.option("--drives", default=2, show_default=True)
def main(egos: tuple[str, ...], count: int, drives: int) -> None:
    """Drive texts with and without a speed, and see who is how fast."""
    for name, of in (("with a speed", said), ("without", unsaid)):
        chosen = [(text, one, wanted) for text, one in texts() if (wanted := of(one))][:count]
        for ego in egos:
            found = {text: outcome(situation, wanted, ego, drives) for text, situation, wanted in chosen}
            for text, one in found.items():
                for why in one.misses.values():
                    click.echo(f"  {ego} {text} {why[:200]}")
            became = Counter(one.kind for one in found.values())
            told = ", ".join(f"{what} {number}" for what, number in became.items())
            early, all_drives = sum(one.early for one in found.values()), sum(one.drives for one in found.values())
            click.echo(f"{name}, {ego}: reached {became['reached']} of {len(chosen)} ({told})")
            click.echo(f"  {ego} brakes within its first second in {early} of {all_drives} drives")


if __name__ == "__main__":
    main()
