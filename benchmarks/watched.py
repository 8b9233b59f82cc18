"""What a user's texts come to, written down so that somebody who cannot see a picture can judge the drives.

    python benchmarks/watched.py TEXTS.jsonl --out FOLDER [--ego planner] [--scenes 6] [--drives 2]

TEXTS has a JSON object a line with `id` and `text`. Each is run as `chatscene run` does, on one route with seed 0.
FOLDER gets a file per text: what is told first, the reading in words and how many drives our own judge sees it in, or
the refusal; and of the first drives that the run shows, what is drawn of the road along the ego's way, and where
everybody is, twice a second: `gone` metres of the ego's way, `ahead` and `left` of the ego's middle in metres, seen by
the ego, `km/h`, and `faces` in degrees against the ego.
A text that has a file already is not run again, so that one that was stopped goes on.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import click
import numpy as np
from shapely import LineString, Point, Polygon, get_parts

import chatscene
from chatscene.errors import ChatSceneError
from chatscene.runs import open_run, read_drawing
from chatscene.terms.episode import Episode, Track

EVERY = 0.5  # [s]
WIDE = 20.0  # [m] to each side of the ego, that is told of the road
NEAR = 1.0  # [m] from the ego's way that a stop line, or a stripe, is one that it leads over


def road(drawing: Mapping[str, Any], ego: Track) -> Iterator[str]:
    """Lines that say what is drawn of the road: what lies beside the ego at first, then what its way leads over.

    The first are seen from the ego's middle, from left to right: `centre` parts the two directions, `solid` is an edge.
    """
    beside = ", ".join(f"{what} {left:.1f}" for left, what in sorted(_beside_ego(drawing, ego), reverse=True))
    yield f"road: beside the ego at first, metres to its left: {beside or 'nothing is drawn'}"
    over = ", ".join(f"{at} {what}" for at, what in sorted(_led_over(drawing, ego)))
    yield f"road: after metres of the ego's way: {over or 'nothing is drawn'}"


def _beside_ego(drawing: Mapping[str, Any], ego: Track) -> Iterator[tuple[float, str]]:
    x, y, c, s = ego.x[0], ego.y[0], np.cos(ego.heading[0]), np.sin(ego.heading[0])
    across = LineString([(x - WIDE * s, y + WIDE * c), (x + WIDE * s, y - WIDE * c)])
    lines = [(str(one["kind"]), LineString(one["points"])) for one in drawing["lane_boundaries"]]
    areas = [(name[:-1].replace("_", " "), Polygon(one[0])) for name in _BESIDE for one in drawing.get(name, ())]
    for name, shape in (*lines, *areas):
        for part in get_parts(across.intersection(shape)):
            if not part.is_empty:
                wide = f" {part.length:.1f} m wide" if part.length else ""
                yield (part.centroid.y - y) * c - (part.centroid.x - x) * s, name + wide


_BESIDE = ("shoulders", "sidewalks", "cycle_lanes", "driveways")


def _led_over(drawing: Mapping[str, Any], ego: Track) -> Iterator[tuple[int, str]]:
    way = LineString(np.column_stack((ego.x, ego.y)))
    yield from ((round(way.project(one.centroid)), "a crosswalk") for one in _zebras(drawing, way))
    rails = (one for rings in drawing.get("rails", ()) if way.intersects(one := Polygon(rings[0])))
    yield from ((round(way.project(way.intersection(one).centroid)), "a rail") for one in rails)
    for line in drawing["stop_lines"]:
        if way.distance(drawn := LineString(line["points"])) < NEAR:
            yield round(way.project(drawn.centroid)), f"a stop line ({line['control']})"
    for area in drawing["junctions"]:
        if not (part := way.intersection(Polygon(area[0]))).is_empty:
            yield round(way.project(Point(get_parts(part)[0].coords[0]))), "a junction"


def _zebras(drawing: Mapping[str, Any], way: LineString) -> Iterator[Polygon]:
    """The stripes that the ego's way leads over, the first of each crosswalk."""
    stripes = [one for rings in drawing.get("crosswalks", ()) if way.intersects(one := Polygon(rings[0]).buffer(NEAR))]
    return (one for n, one in enumerate(stripes) if all(one.distance(other) > WIDE for other in stripes[:n]))


def seen(episode: Episode) -> Iterator[str]:
    """Lines that say where everybody is, at each half second."""
    ego, *others = episode.tracks
    step = round(EVERY / episode.dt)
    gone = np.concatenate(([0.0], np.cumsum(np.hypot(np.diff(ego.x), np.diff(ego.y)))))
    names = ", ".join(f"{one.actor} = {one.kind} ({one.length:.1f} x {one.width:.1f} m)" for one in episode.tracks)
    yield f"who: {names}"
    turned = np.degrees(ego.heading - ego.heading[0])
    for at in range(0, len(ego.x), step):
        now, fast = at * episode.dt, ego.speed[at] * 3.6
        first = f"{now:5.1f} s  ego gone {gone[at]:6.1f}, {fast:4.0f} km/h, turned {turned[at]:4.0f}"
        yield "; ".join((first, *(_beside(ego, one, at) for one in others if at < len(one.x))))


def _beside(ego: Track, one: Track, at: int) -> str:
    c, s = np.cos(ego.heading[at]), np.sin(ego.heading[at])
    x, y = one.x[at] - ego.x[at], one.y[at] - ego.y[at]
    faces = (np.degrees(one.heading[at] - ego.heading[at]) + 180) % 360 - 180
    ahead, left = x * c + y * s, y * c - x * s
    return f"{one.actor} ahead {ahead:.1f} left {left:.1f}, {one.speed[at] * 3.6:.0f} km/h, faces {faces:.0f}"


def watched(text: str, ego: str, scenes: int, drives: int) -> Iterator[str]:
    """What is told of a text, and its drives."""
    with TemporaryDirectory() as folder:
        try:
            run = chatscene.run(text, Path(folder) / "run", scenes=scenes, ego=ego)
        except ChatSceneError as error:
            yield f"REFUSED: {error}"
            return
        yield from run.told_first
        yield f"reading: {run.understood.as_dict()['told']}"
        rows = [row for row in run.scenes.to_pylist() if row["status"] == "ran"]
        shown = sum(bool(row["meaning_ok"]) for row in rows)
        yield f"our judge: {shown} of {len(rows)} drives show it; {sum(bool(r['collision']) for r in rows)} collide"
        drawing = read_drawing(open_run(Path(folder) / "run"))
        ids = [run.best.id, *(one.id for one in run.kept if one.id != run.best.id)]
        for name in ids[:drives]:
            episode = run.scene(name).episode
            around = episode.surroundings
            light = f"{around.light.value}, {around.weather.value}, {around.surface.value}"
            yield f"\n# drive {name}: ends with {episode.ending.value}; {light}"
            for one in episode.events:
                yield f"event: {one.kind.value} at {one.step * episode.dt:.1f} s, {one.other} {one.side}"
            yield from road(drawing, episode.tracks[0])
            yield from seen(episode)


@click.command()
@click.argument("texts", type=click.Path(exists=True, path_type=Path))
@click.option("--out", type=click.Path(path_type=Path), required=True)
@click.option("--ego", default="planner")
@click.option("--scenes", default=6)
@click.option("--drives", default=2)
def main(texts: Path, out: Path, ego: str, scenes: int, drives: int) -> None:
    """Run each text and write down its drives."""
    out.mkdir(parents=True, exist_ok=True)
    for line in texts.read_text(encoding="utf-8").splitlines():
        row = json.loads(line)
        file = out / f"{str(row['id']).replace('/', '-')}.txt"
        if not file.exists():
            told = "\n".join(("text: " + row["text"], *watched(row["text"], ego, scenes, drives)))
            file.write_text(told + "\n", encoding="utf-8")
            click.echo(f"{row['id']}: {told.splitlines()[1][:120]}")


if __name__ == "__main__":
    main()
