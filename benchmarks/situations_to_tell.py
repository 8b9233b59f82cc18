"""Situations at random, for writers to tell in their own words.

    python benchmarks/situations_to_tell.py --count 1800 --seed 1 --out tell.jsonl
    python benchmarks/situations_to_tell.py --count 200 --seed 2 --built --out tell.jsonl

Each line has an `id`, the `situation`, the same `in_words`, and the `voice` in which a writer is to tell it.
Half are parts that people said together (`as_said.py`), with a few facts added; half are drawn so that every word of
the vocabulary comes up: of several candidates that is taken whose rarest facts were drawn least.
Nothing in them is against itself. With `--built` at most a tenth are such as nothing builds yet, which takes about two
seconds for each; without it about half are. No texts of held-out sets are behind them.
"""

from __future__ import annotations

import json
import random
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from dataclasses import fields, replace
from pathlib import Path
from statistics import fmean
from typing import Any

import click
from as_said import drawn_as_said
from building import SHARE, drawn

from chatscene.build.build import build
from chatscene.build.possible import impossible
from chatscene.errors import MapError, NotBuilt
from chatscene.situations.check import faults_of
from chatscene.situations.facts import said_in
from chatscene.situations.form import to_plain
from chatscene.situations.words import told
from chatscene.terms.act_amounts import AMOUNTS
from chatscene.terms.actors import Manner as Moves
from chatscene.terms.amount import Acceleration, Amount, Duration, Length, Share, Speed
from chatscene.terms.situation import LATERALS, Contact, Deed, Lateral, Other, Situation, Start, When
from chatscene.terms.surroundings import Light, Surface, Weather
from chatscene.terms.vocabulary import (
    Act,
    Breach,
    EgoLight,
    EgoRoute,
    Facing,
    Feature,
    Manner,
    Part,
    RightOfWay,
    RoadKind,
    Role,
    Setting,
    Side,
    Striker,
    UserKind,
    Where,
)

VOICES = (
    "police crash report, short sentences",
    "police crash narrative, units 1 and 2, long",
    "insurance claim, first person",
    "insurer's loss adjuster, summary",
    "automated-vehicle operator's collision report",
    "safety driver's log of an automated vehicle, notes",
    "test protocol, VUT and targets",
    "engineer's requirement, one sentence",
    "catalogue of scenarios, terse entry",
    "research paper, description of a scenario",
    "standards writer, careful and dry",
    "bug ticket for a driving stack",
    "prompt of a user to a scenario generator, informal",
    "prompt in telegram style, few words",
    "forum post, chatty",
    "caption of a dashcam video",
    "newspaper item",
    "radio traffic news",
    "driving teacher to a pupil",
    "witness statement, seen from the sidewalk, the ego is the car that the witness names first",
    "cyclist's or walker's complaint about the ego, who tells it is the other",
    "bus company's incident clerk",
    "lorry driver to colleagues",
    "German engineer, English as a second language",
    "Indian or Chinese commuter, English as a second language, traffic keeps right",
    "elderly person in a letter",
    "teenager, text messages, lower case, typing errors",
    "accident researcher, summary of a case",
    "speech, as dictated, no punctuation to speak of",
    "storyteller, with much that does not matter",
)  # fmt: skip
FRESH, CANDIDATES, RARE = ("fresh.jsonl",), 12, 3  # of the candidates one is taken by the mean of its rarest facts
ADDED, EVEN_ADDED = 0.35, 0.55  # how much is added to what was said, and to what is drawn evenly
UNBUILT = 0.1  # of all, the share of those that nothing builds yet
HIDERS = (Where.KERB, Where.KERB, Where.ROADSIDE, Where.AHEAD, Where.AHEAD_BESIDE, Where.ONCOMING)
NAMING = frozenset(one.name for one in fields(When)) | {"whom", "hidden_by"}
HIDDEN = frozenset((Where.ROADSIDE, Where.KERB, Where.CROSSING, Where.ARM, Where.DRIVEWAY, Where.AHEAD, Where.ONCOMING))
Draw = random.Random


def speed(rng: Draw, most: float = 110.0) -> Speed:
    """A speed, as people say it."""
    return Speed.of(_said(rng, rng.choice(("km/h", "km/h", "km/h", "mph")), 3, most, relative=most > 30))


def length(rng: Draw, most: float = 60.0) -> Length:
    """A length."""
    return Length.of(_said(rng, "m", 2, most))


def duration(rng: Draw) -> Duration:
    """A time."""
    return Duration.of(_said(rng, "s", 1, 6))


def acceleration(rng: Draw) -> Acceleration:
    """An acceleration."""
    return Acceleration.of(_said(rng, "m/s²", 1, 8))


def share(rng: Draw) -> Share:
    """A share."""
    return Share.of(f"{rng.choice((10, 20, 25, 30, 40, 50, 60, 75, 80, 100))} %")


SAID: dict[str, Callable[[Draw], Amount]] = {
    "speed": speed,
    "acceleration": acceleration,
    "distance": lambda rng: length(rng, 20.0),
    "time": duration,
    "offset": lambda rng: Length.of(f"{rng.choice((0.3, 0.5, 0.8, 1))} m"),
    "edge": lambda rng: Length.of(f"{rng.choice((0, 0.2, 0.5))} m"),
    "overlap": share,
    "clearance": lambda rng: Length.of(f"{rng.choice((0.5, 0.8, 1, 1.5))} m"),
}


def _said(rng: Draw, unit: str, least: float, most: float, *, relative: bool = False) -> str:
    most = max(least + 1, most / 1.6 if unit == "mph" else most)
    low = rng.randint(int(least), int(most))
    if low > 20 and rng.random() < 0.7:
        low = 5 * (low // 5)
    form = rng.random()
    if form < 0.1:
        return f"{low} to {low + rng.choice((1, 2, 5, 10))} {unit}"
    if form < 0.2:
        return f"{rng.choice(('at most', 'at least'))} {low} {unit}"
    if relative and form < 0.27:
        return f"{rng.choice((5, 10, 15, 20, 30))} {unit} {rng.choice(('more', 'less'))} than the ego"
    return f"{low} {unit}"


class Adding:
    """Facts added to a situation by chance, each only where no fault comes of it.

    Attributes:
        situation: As it is so far.
    """

    def __init__(self, rng: Draw, situation: Situation, much: float) -> None:
        self._rng, self.situation, self._much = rng, situation, much

    def tried(self, likely: float, change: Callable[[Situation], Situation]) -> None:
        """Add something with a probability, if the situation then has no fault."""
        if self._rng.random() < likely * self._much:
            made = change(self.situation)
            if not any(faults_of(made)):
                self.situation = made

    def all(self) -> Situation:
        """Something of everything."""
        self.ego()
        self.road()
        for i in range(len(self.situation.others)):
            self.somebody(i)
        self.hidden()
        self.contact()
        self.around()
        return self.situation

    def ego(self) -> None:
        """What the ego is, where it goes and how fast, and what it does."""
        rng = self._rng
        kinds = [kind for kind in UserKind if kind.may_be_ego]
        acts = [act for act in Act if act.row.ego]
        self.tried(0.6, lambda s: replace(s, ego=replace(s.ego, route=rng.choice(tuple(EgoRoute)))))
        self.tried(0.4, lambda s: replace(s, ego=replace(s.ego, speed=speed(rng))))
        self.tried(0.12, lambda s: replace(s, ego=replace(s.ego, kind=rng.choice(kinds))))
        for _ in range(2):
            deed = Deed(act=rng.choice(acts))
            self.tried(0.12, lambda s, deed=deed: replace(s, ego=replace(s.ego, does=(*s.ego.does, deed))))
        for i in range(len(self.situation.ego.does)):
            self._deed("ego", i)

    def road(self) -> None:
        """What road it is, and what it has."""
        rng = self._rng
        drawn: Sequence[tuple[float, str, Callable[[], Any]]] = (
            (0.4, "kind", lambda: rng.choice(tuple(RoadKind))),
            (0.2, "setting", lambda: rng.choice(tuple(Setting))),
            (0.2, "control", lambda: rng.choice(tuple(RightOfWay))),
            (0.12, "lanes", lambda: rng.choice((1, 2, 2, 3, 3, 4))),
            (0.1, "two_way", lambda: rng.random() < 0.7),
            (0.1, "speed_limit", lambda: Speed.of(f"{rng.choice((30, 50, 60, 70, 80, 100))} km/h")),
            (0.3, "has", lambda: (rng.choice(tuple(Feature)),)),
        )
        for likely, name, make in drawn:
            said = make()
            self.tried(likely, lambda s, name=name, said=said: replace(s, road=replace(s.road, **{name: said})))
        lit = {"control": RightOfWay.SIGNAL, "ego_light": rng.choice(tuple(EgoLight))}
        self.tried(0.12, lambda s: replace(s, road=replace(s.road, **lit)))
        if self.situation.road.lanes:
            lane = rng.randint(1, self.situation.road.lanes)
            self.tried(0.4, lambda s: replace(s, road=replace(s.road, ego_lane=lane)))

    def somebody(self, i: int) -> None:
        """How many, how far, how fast, how they face, and how they do what they do."""
        rng = self._rng
        self.tried(0.1, lambda s: _with(s, i, count=rng.choice((0, 2, 2, 3, 4))))
        starts: Sequence[tuple[float, str, Callable[[], Any]]] = (
            (0.2, "side", lambda: rng.choice(tuple(Side))),
            (0.25, "distance", lambda: length(rng)),
            (0.2, "speed", lambda: self._number(i, "speed")),
            (0.08, "facing", lambda: rng.choice(tuple(Facing))),
            (0.05, "lateral", lambda: _lateral(rng)),
        )
        for likely, name, make in starts:
            said = make()
            self.tried(likely, lambda s, name=name, said=said: _started(s, i, **{name: said}))
        for k in range(len(self.situation.others[i].does)):
            self._deed(i, k)

    def _deed(self, who: int | str, k: int) -> None:
        rng = self._rng
        deed = self._deeds(who)[k]
        said: list[tuple[float, str, Any]] = [
            (0.25, "manner", rng.choice(tuple(Manner))),
            (0.15, "to", rng.choice(tuple(Side)) if deed.act.row.sided else None),
            (0.1, "breaks", rng.choice(tuple(Breach)) if self._at_junction(who) else None),
            (0.05, "lateral", _lateral(rng) if deed.act.row.placed else None),
            (0.15, "when", self._when()),
            (0.1, "whom", rng.choice(self.situation.others).id if deed.act.row.whom else None),
            *((0.3, name, self._number(who, name)) for name in AMOUNTS if name in deed.act.row.takes),
        ]
        for likely, name, value in said:
            if value is not None:
                self.tried(likely, lambda s, name=name, value=value: _doing(s, who, k, **{name: value}))

    def _at_junction(self, who: int | str) -> bool:
        return isinstance(who, int) and self.situation.others[who].starts.where in (Where.ARM, Where.ONCOMING)

    def _number(self, who: int | str, name: str) -> Amount:
        """A number that the body can do, if it is a speed."""
        if name != "speed" or isinstance(who, str):
            return SAID[name](self._rng)
        most = 3.6 * SHARE * self.situation.others[who].kind.row.body.row.limits.top_speed
        return speed(self._rng, max(5.0, min(110.0, most)))

    def _deeds(self, who: int | str) -> tuple[Deed, ...]:
        return self.situation.ego.does if isinstance(who, str) else self.situation.others[who].does

    def _when(self) -> When:
        rng = self._rng
        deeds = [f"{name}.{deed.act}" for name, does in self.situation.everybody() for deed in does]
        delay = duration(rng) if rng.random() < 0.3 else None
        near = rng.choice((length(rng, 40.0), duration(rng)))
        made = [When(ego_within=near), When(delay=duration(rng))]
        if deeds:
            made += [When(after=rng.choice(deeds), delay=delay), When(during=rng.choice(deeds), delay=delay)]
        return rng.choice(made)

    def hidden(self) -> None:
        """Somebody who hides the first of the others."""
        rng = self._rng
        if not 1 <= len(self.situation.others) <= 2 or self.situation.others[0].starts.where not in HIDDEN:
            return
        where = rng.choice(HIDERS)
        things = where is Where.ROADSIDE
        kinds = [k for k in UserKind if (k.moves is Moves.LIES and k.row.prop if things else k.moves is Moves.DRIVES)]
        hider = Other(
            id="C",
            kind=rng.choice(kinds),
            role=Role.HIDES,
            starts=Start(where=where, side=rng.choice((*Side, None)) if where.row.sided else None),
            does=(Deed(act=rng.choice((Act.STAND, Act.STAND, Act.STOP))),) if not things else (),
        )
        self.tried(0.3, lambda s: _with(replace(s, others=(*s.others, hider)), 0, hidden_by="C"))

    def contact(self) -> None:
        """How they touch."""
        rng = self._rng
        made = Contact(
            ego=rng.choice((*Part, None, None)),
            other=rng.choice((*Part, None, None, None, None)),
            striker=rng.choice((*Striker, None)),
            happens=rng.random() < 0.8,
            at=share(rng) if rng.random() < 0.1 else None,
        )
        self.tried(0.4, lambda s: replace(s, contact=made))

    def around(self) -> None:
        """Light, weather, the state of the road."""
        rng = self._rng
        for name, words in (("light", Light), ("weather", Weather), ("surface", Surface)):
            said = rng.choice(tuple(words))
            self.tried(0.2, lambda s, name=name, said=said: replace(s, around=replace(s.around, **{name: said})))


def _lateral(rng: Draw) -> Lateral:
    name = rng.choice([name for name in LATERALS if name in SAID])
    return Lateral(side=rng.choice((*Side, None)), **{name: SAID[name](rng)})  # type: ignore[arg-type]


def _with(s: Situation, i: int, **facts: Any) -> Situation:
    return replace(s, others=tuple(replace(o, **facts) if k == i else o for k, o in enumerate(s.others)))


def _started(s: Situation, i: int, **facts: Any) -> Situation:
    return _with(s, i, starts=replace(s.others[i].starts, **facts))


def _doing(s: Situation, who: int | str, k: int, **facts: Any) -> Situation:
    does = s.ego.does if isinstance(who, str) else s.others[who].does
    does = tuple(replace(deed, **facts) if n == k else deed for n, deed in enumerate(does))
    return replace(s, ego=replace(s.ego, does=does)) if isinstance(who, str) else _with(s, who, does=does)


def kinds_of_facts(situation: Situation) -> Iterator[str]:
    """Each fact without names and numbers, as ``others.does.act cut-in``."""
    names = tuple(one.id for one in situation.others)
    for path, value in said_in(situation):
        at = ".".join(step for step in path.split(".") if step not in names and not step.isdigit())
        plain = isinstance(value, Amount | int | float) or at.rpartition(".")[2] in NAMING
        yield at if plain else f"{at} {value}"


def whole(situation: Situation) -> bool:
    """Whether it may be told: somebody is met, and nothing in it is against itself."""
    return bool(situation.adversaries) and not any(faults_of(situation)) and not any(impossible(situation))


def candidate(rng: Draw, even: bool) -> Situation:
    """A situation that may be told."""
    while True:
        base = drawn(rng) if even and rng.random() < 0.6 else drawn_as_said(rng, FRESH)
        others = tuple(replace(one, does=one.does[: rng.choice((1, 2, 2, 3))]) for one in base.others)
        base = replace(base, others=others[: rng.choice((1, 2, 2, 3))])
        made = Adding(rng, base, EVEN_ADDED if even else ADDED).all()
        if whole(made):
            return made


def is_built(situation: Situation) -> bool:
    """Whether there is a program of it."""
    try:
        build(situation)
    except (NotBuilt, MapError):
        return False
    return True


def situations(count: int, seed: int, *, check_built: bool) -> Iterator[Situation]:
    """As many as are asked for, no two alike."""
    rng, drawn_so_far, unbuilt, made = random.Random(seed), Counter[str](), 0, list[Situation]()
    while len(made) < count:
        even = len(made) % 2 == 1
        several = [candidate(rng, even) for _ in range(CANDIDATES if even else 1)]
        one = max(several, key=lambda s: _rareness(drawn_so_far, s))
        if one in made:
            continue
        if check_built and not is_built(one):
            if unbuilt >= UNBUILT * len(made):
                continue
            unbuilt += 1
        made.append(one)
        drawn_so_far.update(set(kinds_of_facts(one)))
        yield one


def _rareness(drawn_so_far: Counter[str], situation: Situation) -> float:
    rare = sorted((1 / (1 + drawn_so_far[fact]) for fact in set(kinds_of_facts(situation))), reverse=True)
    return fmean(rare[:RARE] or (0.0,))


@click.command()
@click.option("--count", default=1800, show_default=True)
@click.option("--seed", default=1, show_default=True)
@click.option("--built", is_flag=True, help="At most a tenth are such as nothing builds yet.")
@click.option("--out", type=click.Path(path_type=Path, dir_okay=False), required=True)
def main(count: int, seed: int, built: bool, out: Path) -> None:
    """Write situations to tell."""
    with out.open("w", encoding="utf-8") as file:
        for i, one in enumerate(situations(count, seed, check_built=built)):
            voice = VOICES[i % len(VOICES)]
            row = {"id": f"tell-{seed}-{i:04}", "situation": to_plain(one), "in_words": told(one), "voice": voice}
            file.write(json.dumps(row, ensure_ascii=False) + "\n")
            file.flush()


if __name__ == "__main__":
    main()
