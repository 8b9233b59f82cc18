"""Our judge of drives, held against strangers who watched the same drives.

    python benchmarks/judging.py [--each]
    python benchmarks/judging.py --drives 6 [--each]

`reading/fresh.jsonl` has texts, replies of a language model and the verdicts of strangers, each of one drive of commit
`8364bbe`; those drives are kept in `reading/seen.json.gz`. Prints how many of the drives that strangers call right,
part and wrong our judge finds not shown. It should be none of the right and all of the wrong. Of the part it should be
those that do not show a fact that was read: what was read wrongly, or was left out and told, is not the judge's to see.
With `--drives` each situation is built anew and driven so many times, and the drive that a run would prefer is judged.
That measures the builder, as the verdicts are of other drives. `--each` prints a line for each text.
"""

from __future__ import annotations

import gzip
import json
from collections import Counter
from dataclasses import dataclass
from itertools import accumulate
from pathlib import Path
from typing import Any

import click
import numpy as np
from building import drive, simulator

from chatscene.build.build import build
from chatscene.errors import ChatSceneError
from chatscene.program.finding import UNTOLD, Finding, failures
from chatscene.program.judge import judge
from chatscene.read.by_model import situation_in
from chatscene.terms.episode import Ending, Episode, Event, EventKind, Role, SignalTrack, Track
from chatscene.terms.polyline import Polyline
from chatscene.terms.route import Route
from chatscene.terms.scenario import Control, Maneuver, Place, Site
from chatscene.terms.scene import Rejected
from chatscene.terms.situation import Situation
from chatscene.terms.surroundings import Surroundings

READING = Path(__file__).parent / "reading"
FINE = {"x": 0.01, "y": 0.01, "heading": 0.001, "speed": 0.01}  # what a number of a kept track counts


@dataclass(frozen=True, slots=True, kw_only=True)
class Judged:
    """A text that strangers judged a drive of."""

    id: str
    situation: Situation
    verdict: str
    why: str


def judged() -> list[Judged]:
    """The texts whose drives strangers judged, with the last reply."""
    rows = map(json.loads, (READING / "fresh.jsonl").read_text(encoding="utf-8").splitlines())
    return [
        Judged(
            id=row["id"].removeprefix("fresh/"),
            situation=situation_in((row.get("second") or row["replies"])[-1]["situation"]),
            verdict=row["judged"]["verdict"],
            why=row["judged"]["why"],
        )
        for row in rows
        if row.get("judged")
    ]


def unpacked(name: str, row: dict[str, Any]) -> tuple[Episode, Route]:
    """A drive that was kept, and the ego's route."""

    def values(kept: list[int], fine: float) -> Any:
        return np.array(list(accumulate(kept)), float) * fine

    way = row["route"]
    tracks = tuple(
        Track(
            actor=actor,
            role=Role(role),
            kind=kind,
            length=length,
            width=width,
            **{n: values(one, fine) for (n, fine), one in zip(FINE.items(), rows, strict=True)},
        )
        for actor, role, kind, length, width, *rows in row["tracks"]
    )
    steps = len(tracks[0].x)
    episode = Episode(
        scene_id=name,
        ego="idm",
        dt=row["dt"],
        tracks=tracks,
        events=tuple(
            Event(kind=EventKind(kind), step=step, other=other, side=side, impact_speed=speed)
            for kind, step, other, side, speed in row["events"]
        ),
        signals=tuple(
            SignalTrack(x0=x0, y0=y0, x1=x1, y1=y1, state=state, role=role)
            for x0, y0, x1, y1, state, role in row["signals"]
        ),
        ending=Ending(row["ending"]),
        route_completion=0.0,
        distance_to_route=np.zeros(steps),
        off_road=np.zeros(steps, bool),
        surroundings=Surroundings.named(row),
    )
    route = Route(
        id=name,
        map_name="",
        maneuver=Maneuver(way["maneuver"]),
        place=Place(way["place"]),
        control=Control(way["control"]),
        line=Polyline(np.column_stack([values(one, 0.01) for one in way["line"]])),
        lane_ids=(),
        event_at=way["event_at"],
        junction=way["junction"],
        site=Site(way["site"]) if way["site"] else None,
    )
    return episode, route


def driven(situation: Situation, drives: int, ego: str) -> tuple[Finding, ...] | str:
    """What the drive shows that a run would prefer: shown with a contact, shown, or the first; or why there is none."""
    try:
        made = build(situation)
    except ChatSceneError as refusal:
        return str(refusal)
    best: tuple[tuple[bool, bool, int], tuple[Finding, ...]] | None = None
    for seed in range(drives):
        try:
            episode = drive(made, ego, seed)
        except ChatSceneError as error:
            return str(error)
        if isinstance(episode, Rejected):
            continue
        found = judge(situation, episode, simulator(made.map).route(made.program, 0))
        key = bool(failures(found)), episode.collision is None, seed
        best = min(best, (key, found), key=lambda one: one[0]) if best else (key, found)
    return best[1] if best else "not placed"


@click.command()
@click.option("--drives", default=0, show_default=True, help="Drives of today's builder; 0 for those that were seen.")
@click.option("--ego", default="idm", show_default=True)
@click.option("--each", is_flag=True)
def main(drives: int, ego: str, each: bool) -> None:
    """Judge the drives that strangers judged."""
    seen = json.loads(gzip.decompress((READING / "seen.json.gz").read_bytes()))
    count, kinds, untold = Counter[tuple[str, str]](), Counter[str](), 0
    for one in judged():
        found = driven(one.situation, drives, ego) if drives else judge(one.situation, *unpacked(one.id, seen[one.id]))
        if isinstance(found, str):
            count[one.verdict, "not driven"] += 1
            continue
        faults = failures(found)
        untold += sum(finding.told == UNTOLD for finding in found)
        count[one.verdict, "not shown" if faults else "shown"] += 1
        kinds.update({fault.split(":")[0].rpartition(".does.")[2].lstrip("0123456789.") for fault in faults})
        if each:
            click.echo(f"{one.id}\t{one.verdict}\t{one.why}\t{'; '.join(faults) or 'shown'}")
    for verdict in ("right", "part", "wrong"):
        of = {what: count[verdict, what] for what in ("shown", "not shown", "not driven")}
        click.echo(
            f"strangers call {sum(of.values())} {verdict}; judge: " + ", ".join(f"{n} {w}" for w, n in of.items())
        )
    click.echo(f"facts that are {UNTOLD}: {untold}")
    for kind, number in sorted(kinds.items(), key=lambda one: (-one[1], one[0]))[:20]:
        click.echo(f"  {number}  {kind}")


if __name__ == "__main__":
    main()
