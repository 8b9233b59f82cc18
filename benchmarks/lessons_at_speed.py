"""Scenes to learn from at the speed of traffic: plain sentences, each built for an ego at several speeds.

Sentences are the even lines of `texts/plain.jsonl` and, in the order of the lines, the first of `texts/street.jsonl`
and `texts/everyday.jsonl` that are read offline as situations; the odd lines of `plain.jsonl` are left to test on.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import islice

from building import simulator
from encounters import TEXTS, sentences

from chatscene.build.build import build
from chatscene.errors import ChatSceneError
from chatscene.maps.limits import MOTORWAY
from chatscene.program.ordinary import Course, ordinary_courses
from chatscene.report.filled import explain_text
from chatscene.report.stated import Stated
from chatscene.simulate.simulator import routes_of
from chatscene.situations.facts import with_fact
from chatscene.terms.situation import Situation

SPEEDS = (None, 80.0, 110.0)  # [km/h]; None is that of the road
MORE = 6  # sentences of each of the other files
MAPS = ("town", "region")  # of ordinary drives
EACH = 4  # every so many-th ordinary drive is learned from


@dataclass(frozen=True)
class Placed:
    """A course, and the map that it is on."""

    course: Course
    map_name: str = "town"


def situations(half: int) -> Iterator[Situation]:
    """Of the even (0) or the odd sentences (1); with the even ones more of others."""
    yield from _read(text for i, (_, text) in enumerate(sentences()) if i % 2 == half)
    if half == 0:
        for name in ("street", "everyday"):
            lines = (TEXTS.parent / f"{name}.jsonl").read_text(encoding="utf-8").splitlines()
            yield from islice(_read(json.loads(line)["text"] for line in lines), MORE)


def _read(texts: Iterator[str]) -> Iterator[Situation]:
    for text in texts:
        try:
            if isinstance(read := explain_text(text), Stated):
                yield read.situation
        except ChatSceneError:
            continue


def encounters_at_speed(half: int, routes: int = 1) -> Iterator[Placed]:
    """Situations at each of `SPEEDS`, on some of their routes."""
    for number, situation in enumerate(situations(half)):
        for speed in SPEEDS:
            try:
                made = build(situation if speed is None else with_fact(situation, "ego.speed", f"{speed:g} km/h"))
                found = list(routes_of(simulator(made.map), made.program, 10))
            except ChatSceneError:
                continue
            for k in range(min(routes, len(found))):
                yield Placed(Course(program=made.program, route=found[(number + k) % len(found)]), made.map)


def ordinary_at_speed() -> Iterator[Placed]:
    """Ordinary drives at the speed of the road."""
    for name in MAPS:
        courses = ordinary_courses(simulator(name), MOTORWAY)
        yield from (Placed(one, name) for one in courses[::EACH])
