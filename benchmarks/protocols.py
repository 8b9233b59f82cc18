"""Euro NCAP's frontal cases as situations, driven by a car that does not react, against what the protocols say.

    python benchmarks/protocols.py [CASE …] [--drives 6]

`protocols/` has a situation for each case, by its name. Here stand the figures of the protocols (facts): speeds, impact
points and steady distances of Euro NCAP's test protocols *AEB Car-to-Car systems* 4.3.1 and *AEB/LSS VRU systems* 4.5.1
(February 2024) and *Crash Avoidance: Frontal Collisions* 1.1 (October 2025), as Vector's OpenSCENARIO files of them
have them (github.com/vectorgrp/OSC-NCAP-scenarios, `Variations`). Traffic keeps to the right: nearside is right.

Each situation is built at three speeds and driven with values drawn by seeds from 0, as a run draws them. The ego keeps
its speed and its lane (`Unmoved`). A drive is held against the protocol by its tracks, up to the moment of the contact,
for which poses between two steps are interpolated:

- contact: with the target, by the part that is named
- VUT speed: in each step of the last 4 s within 1 km/h of the test speed
- 4 s: the drive lasts 4 s at least until the contact (T0 of the protocols), but where the target brakes before
- target speed: over the steady distance before the contact within 1 km/h (a car), 0.5 (a bicycle), 0.2 (on foot);
  where it brakes, before it does
- steady: the distance that it goes before the contact is no less
- impact point: the middle of the target (where a car crosses: a quarter of its length behind its nose, on the side that
  faces the VUT; where one goes straight on as the VUT turns: the near corner of its front) on the front of the VUT
  within 5 % of the VUT's width
- braking: the mean deceleration while it brakes within 0.25 m/s², and the gap before it within 0.5 m
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import click
import numpy as np
from building import simulator

from chatscene.build.build import Built, build
from chatscene.ego.observation import Observation
from chatscene.errors import DoesNotCompile, MapError, NotBuilt
from chatscene.program.sample import draw
from chatscene.simulate.boxes import Boxes, Pair
from chatscene.simulate.simulator import simulate
from chatscene.situations.facts import with_fact
from chatscene.situations.file import read_file
from chatscene.terms.actors import AIR_DRAG, LIMITS, Limits
from chatscene.terms.episode import Episode, Track
from chatscene.terms.scene import Rejected, Scene
from chatscene.terms.situation import Situation

FOLDER = Path(__file__).parent / "protocols"
KMH = 1 / 3.6  # [m/s]
BEFORE = 4.0  # [s] before the contact, from which on a test counts
NEAR_SPEED = 1.0 * KMH  # [m/s] that the speed of a car may be off
NEAR_TARGET = {"GVT": NEAR_SPEED, "EPT": 0.2 * KMH, "EBT": 0.5 * KMH}  # [m/s]
ROOM = 2.0  # [m] more than the steady distance
LEADS = 5.0  # [s] until the contact, where the target goes along the VUT's way from a distance that is said
NEAR_POINT = 0.05  # of the VUT's width
NEAR_BRAKING, NEAR_GAP = 0.25, 0.5  # [m/s²], [m]
PARTS = 100  # into which a step is cut to time a contact
OFF_ROUTE = 2.0  # [1/s], with which a car comes back to its route
CAR = LIMITS["Car"]


class Unmoved:
    """A car that keeps its speed and its lane, whoever comes.

    Args:
        speed: Which [m/s].
        body: What the vehicle can do that it drives.
    """

    name = "unmoved"
    observation = "actors"
    pedals = "full-brake"

    def __init__(self, speed: float, body: Limits = CAR) -> None:
        self._speed, self._body = speed, body

    def wanting(self, speed: float) -> Unmoved:
        """The same at another speed [m/s]."""
        return Unmoved(speed, self._body)

    def act(self, observation: Observation) -> tuple[float, float]:
        """What holds the speed one step later, and the wheel of the route's bend and against what it is off the route.

        The steering is that of G. M. Hoffmann and others, "Autonomous automobile trajectory tracking for off-road
        driving", ACC 2007.
        """
        body, (speed, left, turned) = self._body, observation[:3].tolist()
        wanted = (self._speed - speed) / 0.1 + body.drag + AIR_DRAG * speed * speed
        press = wanted / (body.throttle * (1.0 - speed / body.top_speed)) if wanted > 0.0 else wanted / body.brake
        x, y = observation[4:6].tolist()
        cos, sin = math.cos(turned), math.sin(turned)
        along, aside = x * cos - y * sin, x * sin + y * cos + left  # in the frame of the route at the ego
        bend = 2.0 * aside / max(along * along + aside * aside, 1.0)
        slip = math.atan(0.5 * body.wheelbase * bend)  # of its middle
        wheel = math.atan(body.wheelbase * bend) - turned - slip - math.atan2(OFF_ROUTE * left, max(speed, 1.0))
        return max(-1.0, min(1.0, press)), max(-1.0, min(1.0, -wheel / body.wheel_angle / 0.3))


@dataclass(frozen=True, slots=True, kw_only=True)
class Case:
    """What a protocol says of a case.

    Attributes:
        name: Of the case, and of its file; a variant has the file of another.
        file: The file, where it is another's.
        target: The id of the target.
        speeds: Of the VUT and, where it moves, of the target, three times [km/h].
        facts: Facts of the situation that are the target's speed.
        at: The impact point on the VUT's front, as a share of its width from the side from which the target comes, or
            from the right; None where none is said.
        point: The point of the target that it is of: how far ahead of its middle, as a share of its half length, and
            whether it is the side that faces the VUT.
        steady: How far the target goes at its speed before the contact [m].
        closes: Whether the target goes along the VUT's way: 1 the same way, -1 against it, 0 across.
        brakes: With which deceleration the target brakes [m/s²], and the gap before it does [m].
    """

    name: str
    target: str
    speeds: Sequence[tuple[float, float]]
    file: str = ""
    facts: Sequence[str] = ()
    at: float | None = 0.5
    point: tuple[float, bool] = (0.0, False)
    steady: float = 0.0
    closes: int = 0
    brakes: tuple[float, float] | None = None

    def closing(self, vut: float, target: float) -> float:
        """How fast the two come nearer [m/s], at speeds [km/h]."""
        return (vut - self.closes * target) * KMH


def _at(target: float, *speeds: float) -> tuple[tuple[float, float], ...]:
    return tuple((one, target) for one in speeds)


_DRIVES = ("others.GVT.starts.speed", "others.GVT.does.0.speed")
CASES = (
    Case(name="CCRs", target="GVT", speeds=_at(0, 10, 30, 50)),
    Case(name="CCRs-50", target="GVT", speeds=_at(0, 10, 30, 50), at=0.0),
    Case(name="CCRm", target="GVT", speeds=_at(20, 30, 50, 80), closes=1),
    Case(name="CCRb-12-2", file="CCRb", target="GVT", speeds=_at(50, 50), brakes=(2.0, 12.0)),
    Case(name="CCRb-12-6", file="CCRb", target="GVT", speeds=_at(50, 50), brakes=(6.0, 12.0)),
    Case(name="CCRb-40-6", file="CCRb", target="GVT", speeds=_at(50, 50), brakes=(6.0, 40.0)),
    Case(name="CCCscp", target="GVT", speeds=((20, 20), (40, 40), (60, 60)), point=(0.5, True), facts=_DRIVES),
    Case(name="CCFtap", target="GVT", speeds=((10, 30), (15, 45), (20, 60)), point=(1.0, True), facts=_DRIVES),
    Case(name="CCFhos", target="GVT", speeds=((30, 50), (50, 50), (70, 70)), facts=_DRIVES, closes=-1),
    Case(name="CCFhol", target="GVT", speeds=((50, 50), (70, 70)), at=None, facts=_DRIVES),
    Case(name="CPFA-50", target="EPT", speeds=_at(8, 20, 40, 60), steady=4.5),
    Case(name="CPNA-25", target="EPT", speeds=_at(5, 20, 40, 60), at=0.25, steady=2.5),
    Case(name="CPNA-75", target="EPT", speeds=_at(5, 20, 40, 60), at=0.75, steady=3.0),
    Case(name="CPNCO-50", target="EPT", speeds=_at(5, 20, 40, 60), steady=3.0),
    Case(name="CPLA-50", target="EPT", speeds=_at(5, 20, 40, 60), steady=5.0, closes=1),
    Case(name="CPLA-25", target="EPT", speeds=_at(5, 50, 65, 80), at=0.25, steady=5.0, closes=1),
    Case(name="CPTAfs-50", target="EPT", speeds=_at(5, 10, 15, 20), steady=4.0),
    Case(name="CPTAfo-50", target="EPT", speeds=_at(5, 10, 15, 20), steady=4.0),
    Case(name="CPTAns-50", target="EPT", speeds=_at(5, 10), steady=4.0),
    Case(name="CPTAno-50", target="EPT", speeds=_at(5, 10), steady=4.0),
    Case(name="CBNA-50", target="EBT", speeds=_at(15, 20, 40, 60), steady=17.0),
    Case(name="CBFA-50", target="EBT", speeds=_at(20, 20, 40, 60), steady=22.0),
    Case(name="CBNAO-50", target="EBT", speeds=_at(10, 20, 40, 60), steady=4.5),
    Case(name="CBLA-50", target="EBT", speeds=_at(15, 25, 40, 60), steady=28.0, closes=1),
    Case(name="CBLA-25", target="EBT", speeds=_at(20, 50, 65, 80), at=0.25, steady=28.0, closes=1),
)  # fmt: skip


def situation(case: Case, vut: float, target: float) -> Situation:
    """The situation of a case at the speeds of VUT and target [km/h].

    Who goes along the VUT's way starts so far from it that the contact comes in time, as the protocols have it.
    """
    made = with_fact(read_file(FOLDER / f"{case.file or case.name}.yaml"), "ego.speed", f"{vut:g} km/h")
    for path in case.facts:
        made = with_fact(made, path, f"{target:g} km/h")
    if case.closes:
        seconds = max(LEADS, (case.steady + ROOM) / (target * KMH) if target else 0.0)
        made = with_fact(made, f"others.{case.target}.starts.distance", f"{seconds * case.closing(vut, target):.0f} m")
    if case.brakes is not None:
        brakes, gap = case.brakes
        made = with_fact(made, "others.GVT.does.0.acceleration", f"{brakes:g} m/s²")
        made = with_fact(made, "others.GVT.starts.distance", f"{gap:g} m")
    return made


@dataclass(frozen=True, slots=True)
class Contact:
    """The first contact of two tracks.

    Attributes:
        ego: The ego's track, with one row, at that moment.
        other: The other's.
        step: When [steps].
    """

    ego: Track
    other: Track
    step: float


def contact(episode: Episode, other: Track) -> Contact | None:
    """When and how the ego and another first touch; None where they do not."""
    ego = episode.ego_track
    moments = np.arange((len(ego.x) - 1) * PARTS + 1) / PARTS
    touching = np.flatnonzero(Pair.of(Boxes.within(ego, moments), Boxes.within(other, moments)).touching)
    if not len(touching):
        return None
    step = float(touching[0]) / PARTS
    return Contact(_then(ego, step), _then(other, step), step)


def _then(track: Track, step: float) -> Track:
    rows = np.arange(len(track.x))
    x, y, heading, speed = (np.interp([step], rows, one) for one in (track.x, track.y, track.heading, track.speed))
    return replace(track, x=x, y=y, heading=heading, speed=speed)


def impact_point(case: Case, touch: Contact) -> float:
    """Where on the VUT's front the point of the target is, as a share of its width from the side it comes from."""
    ego, other = touch.ego, touch.other
    x, y, h = (float(one[0]) for one in (other.x, other.y, other.heading))
    dx, dy, eh = x - float(ego.x[0]), y - float(ego.y[0]), float(ego.heading[0])
    ahead, facing = case.point
    if facing:  # the side on which the ego's middle is
        left = 1.0 if -dx * -math.sin(h) - dy * math.cos(h) > 0.0 else -1.0
        along, aside = 0.5 * ahead * other.length, 0.5 * left * other.width
        dx, dy = dx + along * math.cos(h) - aside * math.sin(h), dy + along * math.sin(h) + aside * math.cos(h)
    across = dy * math.cos(eh) - dx * math.sin(eh)  # to the left
    from_left = math.sin(h - eh) < -0.3
    return 0.5 - across / ego.width if from_left else 0.5 + across / ego.width


def departures(case: Case, vut: float, target: float, episode: Episode) -> Iterator[str]:
    """In what a drive departs from the protocol."""
    other = next((track for track in episode.tracks if track.actor == case.target), None)
    touch = contact(episode, other) if other is not None else None
    if other is None or touch is None:
        crash = episode.collision
        yield "no contact" if crash is None else f"contact with {crash.other}"
        return
    at, dt = int(touch.step), episode.dt
    if touch.step * dt < BEFORE and case.brakes is None:
        yield f"4 s: contact after {touch.step * dt:.1f} s"
    last = episode.ego_track.speed[max(at - round(BEFORE / dt), 0) : at + 1]
    if np.abs(last - vut * KMH).max() > NEAR_SPEED:
        yield f"VUT speed: {last.min() / KMH:.1f} to {last.max() / KMH:.1f} km/h"
    yield from _target(case, target, other, touch, dt)
    if case.at is not None:
        share = impact_point(case, touch)
        if abs(share - case.at) > NEAR_POINT:
            yield f"impact point: {share:.0%} for {case.at:.0%}"


def _target(case: Case, wanted: float, other: Track, touch: Contact, dt: float) -> Iterator[str]:
    """In what the target departs: its speed, or its braking."""
    at = int(touch.step)
    speed = np.abs(other.speed[: at + 1])
    if case.brakes is None:
        if abs(float(touch.other.speed[0])) > 0.0 or wanted:
            gone = np.append(np.cumsum(speed[::-1])[::-1][1:] * dt, 0.0)  # [m] from each row to the contact
            held = speed[gone <= case.steady]
            if np.abs(held - wanted * KMH).max() > NEAR_TARGET[case.target]:
                yield f"target speed: {held.min() / KMH:.1f} to {held.max() / KMH:.1f} km/h"
            if gone[0] < case.steady:
                yield f"steady: {gone[0]:.1f} m"
        return
    brakes, _ = case.brakes
    loses = -np.diff(speed) / dt
    braking = loses > 0.5
    if not braking.any():
        yield "braking: none"
        return
    begins = int(np.argmax(braking))
    mean = float(loses[begins:][braking[begins:]].mean())
    if abs(mean - brakes) > NEAR_BRAKING:
        yield f"braking: {mean:.1f} m/s²"
    if abs(speed[begins] - wanted * KMH) > NEAR_SPEED:
        yield f"target speed: {speed[begins] / KMH:.1f} km/h"


def gap_at_braking(case: Case, episode: Episode) -> str:
    """What is wrong with the gap [m] when the target begins to brake; empty if nothing is."""
    other = next(track for track in episode.tracks if track.actor == case.target)
    loses = -np.diff(np.abs(other.speed)) / episode.dt > 0.5
    if case.brakes is None or not loses.any():
        return ""
    begins, ego = int(np.argmax(loses)), episode.ego_track
    apart = math.dist((ego.x[begins], ego.y[begins]), (other.x[begins], other.y[begins]))
    gap = apart - 0.5 * (ego.length + other.length)
    return f"gap: {gap:.1f} m" if abs(gap - case.brakes[1]) > NEAR_GAP else ""


def driven(made: Built, speed: float, seed: int) -> Episode | str:
    """One drive with values drawn by a seed; or why there is none."""
    values = draw(made.program.parameters, seed=seed)
    scene = Scene(id=f"s/route-00/{seed}", scenario_id="s", route=0, block=0, seed=seed, values=values)
    try:
        episode = simulate(simulator(made.map), made.program, scene, Unmoved(speed))
    except (MapError, DoesNotCompile) as error:
        return f"not placed: {error}"
    return f"not placed: {episode.reason}" if isinstance(episode, Rejected) else episode


def outcome(case: Case, vut: float, target: float, drives: int) -> tuple[int, list[str]]:
    """In how many drives a case is as its protocol has it, and in what the others depart."""
    try:
        made = build(situation(case, vut, target))
    except NotBuilt as refusal:
        return 0, [f"not built: {refusal}"]
    good, told = 0, [f"left out: {', '.join(made.left_out)}"] if made.left_out else []
    for seed in range(drives):
        episode = driven(made, vut * KMH, seed)
        if isinstance(episode, str):
            told.append(episode)
            continue
        wrong = list(departures(case, vut, target, episode))
        wrong += [gap] if (gap := gap_at_braking(case, episode)) else []
        good += not wrong
        told += wrong
    return good, told


def kinds(told: Sequence[str]) -> str:
    """What was told, each kind with the number of drives and one of them."""
    firsts = {one.split(":")[0]: one for one in reversed(told)}
    return "; ".join(
        f"{sum(one.split(':')[0] == kind for one in told)}x {first}" for kind, first in sorted(firsts.items())
    )


@click.command()
@click.argument("names", nargs=-1)
@click.option("--drives", default=6, show_default=True)
def main(names: tuple[str, ...], drives: int) -> None:
    """Drive each case at each of its speeds, and say in what it departs from its protocol."""
    click.echo("| case | VUT, target [km/h] | as the protocol has it | departures |\n|---|---|---:|---|")
    whole = cells = 0
    for case in CASES:
        if names and case.name not in names:
            continue
        for vut, target in case.speeds:
            good, told = outcome(case, vut, target, drives)
            whole, cells = whole + (good == drives), cells + 1
            click.echo(f"| {case.name} | {vut:g}, {target:g} | {good} of {drives} | {kinds(told)} |")
    click.echo(f"\nas the protocol has it in each drive: {whole} of {cells}")


if __name__ == "__main__":
    main()
