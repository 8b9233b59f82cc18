"""Whether a first block brackets the encounter: whom an ego that does not react strikes, and whom it just misses.

    python benchmarks/brackets.py [--scenes 10] [--seed 0] [--each]

Situations of others with one adversary of whom no number was said (`chosen`): the first of each kind among the
plain sentences (`texts/plain.jsonl`, read offline), then among those that language models read (`reading/`). Each is
built for an ego at 30, 50, 80 and 100 km/h, as it was said of it, and driven with the values of the first block of a
run. The ego goes along its route as fast as that lets it, whoever comes (`Oblivious`). A drive is

- struck: the two touch;
- missed, with the other first: they would touch if the other were later, by `LATER` at most;
- missed, with the ego first: they would touch if the other were sooner;
- not met: neither.

A block brackets the encounter if somebody is struck and somebody is missed.
"""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from itertools import islice

import click
import numpy as np
from building import simulator
from encounters import sentences
from speeds import texts

from chatscene.build.build import Built, build
from chatscene.ego.asking import fitted
from chatscene.ego.observation import OWN, ROAD, Observation
from chatscene.ego.traffic_driver import TrafficDriver
from chatscene.errors import ChatSceneError, NotBuilt
from chatscene.program.sample import draw, scene_seed
from chatscene.report.filled import explain_text
from chatscene.report.stated import Stated
from chatscene.simulate.boxes import least_gap
from chatscene.simulate.simulator import simulate
from chatscene.terms.actors import LIMITS, Limits
from chatscene.terms.actors import Manner as Moves
from chatscene.terms.amount import Speed
from chatscene.terms.episode import Episode, Role, Track
from chatscene.terms.scene import Rejected, Scene
from chatscene.terms.situation import Other, Situation
from chatscene.terms.vocabulary import Act, EgoRoute, UserKind, Where
from chatscene.terms.vocabulary import Role as Part

SPEEDS = (30, 50, 80, 100)  # [km/h]
LATER = 5.0  # [s] sooner or later, up to which somebody who is missed counts as met
TRIES = 100  # draws for a drive, as in a search
STRUCK, OTHER_FIRST, EGO_FIRST, UNMET = "struck", "other first", "ego first", "not met"
AHEAD = (Where.AHEAD,)
FROM_BESIDE = (Where.BESIDE, Where.AHEAD_BESIDE, Where.BEHIND_BESIDE)
CUTS_IN = (Act.CUT_IN, Act.LANE_CHANGE, Act.MERGE)
BRAKES = (Act.BRAKE, Act.SLOW_DOWN, Act.STOP)


class Oblivious:
    """`TrafficDriver` that sees nobody: along its route, as fast as it wants and the road lets it."""

    name = "oblivious"
    observation = "traffic"
    pedals = "full-brake"

    def __init__(self, speed: float = 8.0, body: Limits = LIMITS["Car"]) -> None:
        self._speed, self._body = speed, body
        self._driver = TrafficDriver(speed, body=body)

    def wanting(self, speed: float) -> Oblivious:
        """The same at another speed [m/s]."""
        return Oblivious(speed, self._body)

    def driving(self, body: Limits) -> Oblivious:
        """The same in another vehicle."""
        return Oblivious(self._speed, body)

    def act(self, observation: Observation) -> tuple[float, float]:
        """What the driver does on an empty road."""
        empty = np.array(observation)
        empty[OWN:ROAD] = 0.0
        return self._driver.act(empty)


def _straight(situation: Situation) -> bool:
    return situation.ego.route in (None, EgoRoute.STRAIGHT)


def _crosses(situation: Situation, one: Other) -> bool:
    return _straight(situation) and one.starts.where is Where.ARM and one.does[0].act in (Act.GO_STRAIGHT, Act.CROSS)


def _turns(situation: Situation, one: Other) -> bool:
    if one.starts.where is not Where.ONCOMING:
        return False
    turns = one.does[0].act is Act.TURN_LEFT
    return turns if _straight(situation) else situation.ego.route is EgoRoute.LEFT_TURN and not turns


def _rides(one: Other) -> bool:
    return one.kind is UserKind.BICYCLE


def _walks(one: Other) -> bool:
    return one.kind.moves is Moves.WALKS


KINDS: dict[str, tuple[int, Callable[[Situation, Other], bool]]] = {
    "crossing": (4, lambda s, one: not _rides(one) and not _walks(one) and _crosses(s, one)),
    "turning across": (4, lambda s, one: not _rides(one) and _turns(s, one)),
    "cut-in": (3, lambda _, one: one.starts.where in FROM_BESIDE and one.does[0].act in CUTS_IN),
    "lead braking": (3, lambda s, one: _straight(s) and one.starts.where in AHEAD and one.does[0].act in BRAKES),
    "pedestrian": (3, lambda s, one: _straight(s) and _walks(one) and one.does[0].act is Act.CROSS),
    "cyclist": (3, lambda s, one: _rides(one) and (_crosses(s, one) or one.does[0].act is Act.CROSS)),
}
"""How many of each kind, and which are of it."""


@dataclass(frozen=True, slots=True)
class Chosen:
    """A situation of others."""

    name: str
    kind: str
    situation: Situation


def situations() -> Iterator[tuple[str, Situation]]:
    """Those of the plain sentences that are read offline, then those that language models read."""
    for name, text in sentences():
        stated = explain_text(text)
        if isinstance(stated, Stated):
            yield name, stated.situation
    yield from texts()


def chosen() -> Iterator[Chosen]:
    """The first of each kind that can be built, with one adversary and an ego that only drives, without a number."""
    left = {kind: many for kind, (many, _) in KINDS.items()}
    for name, one in situations():
        kind = kind_of(one)
        if kind is not None and left[kind]:
            try:
                build(one)
            except ChatSceneError:
                continue
            left[kind] -= 1
            yield Chosen(name, kind, one)


def kind_of(situation: Situation) -> str | None:
    """Of which kind a situation is; None if of none, or if it says when, where or how fast."""
    ego, others = situation.ego, [one for one in situation.others if one.role is not Part.HIDES]
    if len(others) != 1 or situation.contact is not None or ego.speed is not None or ego.does or not others[0].does:
        return None
    one = others[0]
    numbers = [
        one.starts.speed,
        one.starts.distance,
        *(n for d in one.does for n in (d.speed, d.time, d.distance, d.when)),
    ]
    if one.count not in (None, 1) or len(one.does) > 1 or any(number is not None for number in numbers):
        return None
    return next((kind for kind, (_, holds) in KINDS.items() if holds(situation, one)), None)


def drives(made: Built, scenes: int, seed: int) -> Iterator[Episode]:
    """Those of the first block of a run, to the end of the route, with an ego that does not react."""
    program = replace(made.program, source=made.program.source.replace("param drivesUntil = 'over'\n", ""))
    ego = fitted(Oblivious(), program)
    for number in range(scenes):
        for attempt in range(TRIES):
            name = f"{program.scenario_id}/route-00/scene-{number:03d}" + (f".{attempt}" if attempt else "")
            own = scene_seed(seed, name)
            values = draw(program.parameters, seed=own)
            scene = Scene(id=name, scenario_id=program.scenario_id, route=0, block=0, seed=own, values=values)
            episode = simulate(simulator(made.map), program, scene, ego)
            if not isinstance(episode, Rejected):
                yield episode
                break


def became(episode: Episode) -> str:
    """Whether the ego struck the adversary, and if not, who of the two was first where they would have touched."""
    if episode.collision is not None:
        return STRUCK
    ego = episode.ego_track
    others = [track for track in episode.tracks if track.role is Role.ADVERSARY]
    for steps in range(1, min(round(LATER / episode.dt), len(ego.x) - 1)):
        for other in others:
            if least_gap(_cut(ego, steps, None), _cut(other, 0, -steps)) <= 0.0:
                return OTHER_FIRST
            if least_gap(_cut(ego, 0, -steps), _cut(other, steps, None)) <= 0.0:
                return EGO_FIRST
    return UNMET


def _cut(track: Track, first: int, last: int | None) -> Track:
    x, y, heading, speed = (column[first:last] for column in (track.x, track.y, track.heading, track.speed))
    return replace(track, x=x, y=y, heading=heading, speed=speed)


def _told(counted: Counter[str]) -> str:
    whole = max(counted.total(), 1)
    return ", ".join(f"{what} {counted[what] / whole:.0%}" for what in (STRUCK, OTHER_FIRST, EGO_FIRST, UNMET))


def brackets(counted: Counter[str]) -> bool:
    """Whether somebody is struck and somebody is missed."""
    return counted[STRUCK] > 0 and counted[OTHER_FIRST] + counted[EGO_FIRST] > 0


@click.command()
@click.option("--scenes", default=10, show_default=True)
@click.option("--seed", default=0, show_default=True)
@click.option("--each", is_flag=True)
def main(scenes: int, seed: int, each: bool) -> None:
    """Drive first blocks with an ego that does not react."""
    found = defaultdict[tuple[str, int], list[Counter[str]]](list)
    refused = Counter[tuple[str, int]]()
    for one in islice(chosen(), sum(many for many, _ in KINDS.values())):
        for speed in SPEEDS:
            wanted = replace(one.situation.ego, speed=Speed.of(f"{speed} km/h"))
            try:
                made = build(replace(one.situation, ego=wanted))
                counted = Counter(became(episode) for episode in drives(made, scenes, seed))
            except NotBuilt as error:
                refused[one.kind, speed] += 1
                if each:
                    click.echo(f"  {one.name}, {one.kind}, {speed} km/h: not built: {error}")
                continue
            found[one.kind, speed].append(counted)
            if each:
                click.echo(f"  {one.name}, {one.kind}, {speed} km/h: {_told(counted)}")
    for kind in KINDS:
        for speed in SPEEDS:
            blocks = found[kind, speed]
            bracket = sum(brackets(one) for one in blocks)
            click.echo(
                f"{kind}, {speed} km/h: {_told(sum(blocks, Counter[str]()))}; "
                f"{bracket} of {len(blocks)} bracket, {refused[kind, speed]} not built"
            )


if __name__ == "__main__":
    main()
