"""Whether each number that can be said of a deed is what the tracks show: each act, each amount, several values.

    python benchmarks/amounts.py --drives 3

Builds for each act and each amount that it takes a situation with a number that such a body can do, drives it before
an ego that sees nobody and before one that reacts, and holds the number against the tracks as the judge does. Prints
for each act and amount how many drives show it, how many do not, and what was refused; with `--each` a line per value.
Last, for each amount, by how much of the number the nearest that the judge sees misses it, to the 0.1 that it tells,
and by how much the ego misses its speed of 50 km/h as the encounter begins.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator
from typing import Any

import click
import numpy as np
from building import simulator

from chatscene.build.build import Built, build
from chatscene.ego.asking import wanting
from chatscene.ego.intelligent_driver import OWN, IntelligentDriver, Observation
from chatscene.ego.policy import EgoPolicy, load_ego
from chatscene.errors import DoesNotCompile, MapError, NotBuilt
from chatscene.measure.speeds import speeds
from chatscene.program.judge import judge
from chatscene.program.sample import draw
from chatscene.simulate.simulator import simulate
from chatscene.situations.form import from_plain
from chatscene.terms.act_amounts import AMOUNTS
from chatscene.terms.episode import Episode
from chatscene.terms.scene import Scene
from chatscene.terms.situation import Situation
from chatscene.terms.vocabulary import Act

AHEAD: dict[str, Any] = {"where": "ahead"}
BESIDE: dict[str, Any] = {"where": "ahead-beside", "side": "right"}
BEHIND: dict[str, Any] = {"where": "behind-beside", "side": "left"}
KERB: dict[str, Any] = {"where": "kerb", "side": "right"}
STARTS: dict[Act, tuple[str, dict[str, Any], tuple[str, ...]]] = {
    Act.STAND: ("car", AHEAD, ()),
    Act.GO_STRAIGHT: ("car", {"where": "arm", "side": "right"}, ()),
    Act.TURN_LEFT: ("car", {"where": "oncoming"}, ()),
    Act.TURN_RIGHT: ("car", AHEAD, ()),
    Act.CROSS: ("pedestrian", {"where": "roadside", "side": "right"}, ()),
    Act.ENTER: ("bicycle", {"where": "roadside", "side": "right"}, ()),
    Act.SET_OFF: ("car", AHEAD, ("stand",)),
    Act.PULL_OUT: ("car", KERB, ()),
    Act.CUT_IN: ("car", BESIDE, ()),
    Act.LANE_CHANGE: ("car", BESIDE, ()),
    Act.MERGE: ("car", BESIDE, ()),
    Act.OVERTAKE: ("car", BEHIND, ()),
    Act.DRIFT: ("car", BESIDE, ()),
    Act.KEEP_LEVEL: ("car", {"where": "beside", "side": "left"}, ()),
    Act.FOLLOW: ("car", {"where": "behind"}, ()),
    Act.TAILGATE: ("car", {"where": "behind"}, ()),
    Act.TURN_BACK: ("pedestrian", {"where": "roadside", "side": "right"}, ("cross",)),
    Act.HESITATE: ("pedestrian", {"where": "roadside", "side": "right"}, ("cross",)),
    Act.PARK: ("car", AHEAD, ()),
}
"""Who does an act, where it is at first, and what it does before; a car ahead that has done nothing, of all others."""
LASTING = frozenset((Act.STAND, Act.GO_ALONG, Act.FOLLOW, Act.TAILGATE, Act.KEEP_LEVEL, Act.WEAVE))
"""What ends only when something else is done."""
VALUES: dict[str, tuple[str, ...]] = {
    "speed": ("20 km/h", "40 km/h"),
    "acceleration": ("1 m/s²", "2 m/s²", "4 m/s²"),
    "distance": ("4 m", "12 m", "25 m"),
    "time": ("1.5 s", "3 s", "5 s"),
}
WITHIN = (2, 5, 15)  # [%] of a number
SPECIAL: dict[tuple[Act, str], tuple[str, ...]] = {
    (Act.CROSS, "speed"): ("3 km/h", "5 km/h", "9 km/h"),
    (Act.TURN_BACK, "speed"): ("3 km/h", "5 km/h"),
    (Act.REVERSE, "speed"): ("5 km/h", "10 km/h"),
    (Act.REVERSE, "distance"): ("2 m", "5 m"),
    (Act.DRIFT, "distance"): ("0.5 m", "1 m"),
    (Act.SWERVE, "distance"): ("1 m", "1.5 m", "2 m"),
    (Act.TAILGATE, "distance"): ("2 m", "4 m"),
    (Act.CUT_IN, "time"): ("0.5 s", "1 s", "1.5 s"),
    (Act.ACCELERATE, "speed"): ("60 km/h", "70 km/h"),
    (Act.OVERTAKE, "speed"): ("60 km/h", "80 km/h"),
    (Act.GO_ALONG, "distance"): ("20 m", "40 m"),
    (Act.STOP, "distance"): ("12 m", "25 m", "40 m"),
}


class Blind(IntelligentDriver):
    """A driver that sees nobody."""

    def wanting(self, speed: float) -> Any:
        """The same with another speed."""
        return Blind(speed)

    def act(self, observation: Observation) -> tuple[float, float]:
        """As on an empty road."""
        return super().act(observation[:OWN])


def cases() -> Iterator[tuple[Act, str, str, Situation]]:
    """Each act, amount, value, and a situation that says it."""
    for act in Act:
        kind, start, before = STARTS.get(act, ("car", AHEAD, ()))
        for name in (one for one in AMOUNTS if one in act.row.takes):
            for value in SPECIAL.get((act, name), VALUES[name]):
                does: list[dict[str, Any]] = [{"act": one} for one in before]
                does.append({"act": act.value, name: value})
                if name in ("time", "distance") and act in LASTING and kind == "car":
                    does.append({"act": "set-off" if act is Act.STAND else "brake"})
                ego = {"speed": "50 km/h"}
                if act is Act.CUT_IN and name == "distance":
                    yield act, f"{name}, slower", value, _situation(kind, start | {"speed": "40 km/h"}, does, ego)
                yield act, name, value, _situation(kind, start, does, ego)


def _situation(kind: str, start: dict[str, Any], does: list[dict[str, Any]], ego: dict[str, Any]) -> Situation:
    return from_plain({"ego": ego, "others": [{"id": "A", "kind": kind, "starts": start, "does": does}]})


def drive(made: Built, ego: EgoPolicy, seed: int) -> Episode | None:
    """One drive; None where it cannot be placed."""
    values = draw(made.program.parameters, seed=seed)
    scene = Scene(id=f"s/route-00/{seed}", scenario_id="s", route=0, block=0, seed=seed, values=values)
    try:
        made_so = simulate(simulator(made.map), made.program, scene, wanting(ego, made.program.wanted_speed))
    except (MapError, DoesNotCompile):
        return None
    return made_so if isinstance(made_so, Episode) else None


_SEEN = re.compile(r"it .*? (\d+\.\d)\b")
"""The number that the judge says it saw."""


def held(said: Situation, name: str, drives: int, of_ego: list[float]) -> tuple[Counter[str], list[str], list[float]]:
    """How many drives show a number, what was seen where they do not, and by which shares it is missed.

    Args:
        said: A situation that says it of the last deed of somebody.
        name: Of the amount.
        drives: How many before each ego.
        of_ego: Is given by which share each drive misses what was said of the ego, before the encounter.
    """
    aim = next(amount for deed in said.others[0].does if (amount := getattr(deed, name)) is not None)
    try:
        made = build(said)
    except NotBuilt as refusal:
        return Counter({"refused": 1}), [str(refusal)], []
    counts, told, misses = Counter[str](), list[str](), list[float]()
    for seed in range(drives):
        for ego in (Blind(), load_ego("idm")):
            if (episode := drive(made, ego, seed)) is None:
                counts["not placed"] += 1
                continue
            if said.ego.speed is not None:
                of_ego.append(abs(speeds(episode).ego_speed_before - said.ego.speed.low) / said.ego.speed.low)
            found = judge(said, episode, simulator(made.map).route(made.program, 0))
            mine = [one for one in found if one.path.endswith(f".{name}") and one.path.startswith("others.A.does")]
            if not mine:
                counts["no finding"] += 1
            for one in mine:
                counts["shown" if one.shown else "open" if one.shown is None else "wrong"] += 1
                told += [] if one.shown else [one.told]
                if one.shown is not None and (seen := _SEEN.search(one.told)):
                    misses.append(abs(float(seen[1]) - aim.low) / aim.low)
            told += [
                f"{one.path.rpartition('.')[2]}: {one.told}"
                for one in found
                if one.path.endswith("act") and one.shown is False
            ]
    return counts, told, misses


@click.command()
@click.option("--drives", default=2, help="Drives of each, before each of two egos.")
@click.option("--act", "only", default="", help="Only acts whose name has this in it.")
@click.option("--amount", "of", default="", help="Only amounts whose name has this in it.")
@click.option("--each", is_flag=True, help="A line per value.")
def main(drives: int, only: str, of: str, each: bool) -> None:
    """Hold the numbers of deeds against tracks."""
    rows: dict[tuple[str, str], Counter[str]] = {}
    misses: dict[str, list[float]] = {"the ego": []}
    for act, name, value, said in cases():
        if only not in act or of not in name:
            continue
        amount = name.partition(",")[0]
        counts, told, missed = held(said, amount, drives, misses["the ego"])
        misses.setdefault(amount, []).extend(missed)
        rows.setdefault((act, name), Counter()).update(counts)
        if each:
            click.echo(f"{act} {name} {value}: {dict(counts)} {'; '.join(told[:3])}")
    np.set_printoptions(precision=2)
    for (act, name), counts in rows.items():
        click.echo(f"{act:12} {name:18} {', '.join(f'{many} {what}' for what, many in sorted(counts.items()))}")
    whole = sum(rows.values(), Counter[str]())
    click.echo(f"{'all':31} {', '.join(f'{many} {what}' for what, many in sorted(whole.items()))}")
    for amount, missed in misses.items():
        shares = ", ".join(f"{np.mean(np.array(missed) <= 0.01 * most):.0%} by {most} % at most" for most in WITHIN)
        click.echo(f"{amount:12} {len(missed)} numbers missed: {shares}; the worst by {max(missed, default=0.0):.0%}")


if __name__ == "__main__":
    main()
