"""How many false claims about a scene are caught, and how many true ones are called false: the proof of the judge.

    python benchmarks/mutants.py --truths 100 --seed 7
    python benchmarks/mutants.py --truths 100 --seed 7 --each
    python benchmarks/mutants.py --truths 100 --seed 7 --each --truths-only --keep FOLDER

A truth is a situation with the program that is built of it: of replies of language models to texts of others
(`reading/`), of the sentences of the gallery, and drawn of parts that people said together (`as_said.py`), a third
each. Where it says none, some are given a speed of the ego, a light, a contact, or light and weather, and are built
with that. Of such a contact the claim is what the simulator recorded in most drives: with whom, at which side, and who
strikes one that stands; one that comes in the first second is the driver's. Each is driven ten times (`planner`; for
contacts `sac`, which brakes for few) and verified as
a user's own. It is called false if the exit status is 1.

A mutant is the same drives with a claim that is not true of them: a side flipped, a kind changed, the order of two
deeds turned round, a deed left out or added, another light, speed or contact; or the same claim with a program whose
adversary comes eight seconds later. Only what is well formed, possible and says something else counts, of a truth that
is not called false itself: a change of a claim that is not shown anyway proves nothing. It is caught if the exit status
is 1. Of contacts only those count whose truth shows one in most drives, of timings those whose truth has an encounter.

`--truths-only` makes no mutants. `--keep FOLDER` writes each truth that is called false there, as a file to run.
"""

from __future__ import annotations

import random
import re
from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace
from pathlib import Path

import click
import numpy as np
from as_said import drawn_as_said, recorded
from building import drive, simulator
from gallery import SITUATIONS

from chatscene.build.build import Built, build
from chatscene.build.possible import impossible
from chatscene.errors import DoesNotCompile, MapError, NotBuilt, NothingFits
from chatscene.program.contacts import is_of
from chatscene.program.deeds import BRAKES, BRAKING, STANDING, runs
from chatscene.report.filled import read_in
from chatscene.search.rehearsal import rehearsed
from chatscene.settings import RetrievalSettings, VerifySettings
from chatscene.situations.check import faults_of
from chatscene.situations.file import to_yaml
from chatscene.situations.words import told
from chatscene.terms.amount import Speed
from chatscene.terms.episode import Episode
from chatscene.terms.scene import Rejected
from chatscene.terms.seeing import LOST, SHARE_LOST, gain_of
from chatscene.terms.situation import EGO, Around, Contact, Deed, Evidence, Other, Situation
from chatscene.terms.surroundings import Light, Weather
from chatscene.terms.vocabulary import (
    Act,
    EgoLight,
    EgoRoute,
    Part,
    RightOfWay,
    RoadKind,
    Side,
    Striker,
    UserKind,
)
from chatscene.verdict.said import Asked
from chatscene.verdict.verdict import Verdict
from chatscene.verdict.verify import weighed
from chatscene.verdict.watched import Watched, Watching

DRAWS = 10
FILES = ("replies.jsonl", "fresh.jsonl", "fresh-second.jsonl", "fresh-third.jsonl", "fresh-fourth.jsonl")
LATER = 8.0  # [s] by which an adversary comes later that then meets nobody
SOON = 1.0  # [s]: nobody has done anything before
FASTER, SLOWER = 1.7, 0.5
GENERAL = frozenset((Act.GO_ALONG, Act.GO_STRAIGHT, Act.FOLLOW, Act.STAND))
"""What is true of nearly everybody, or where it is not is no other deed."""
ALIKE = (
    frozenset((Act.SLOW_DOWN, Act.BRAKE, Act.STOP, Act.HESITATE, Act.YIELD, Act.PARK, Act.FALL)),
    frozenset((Act.CROSS, Act.ENTER, Act.PULL_OUT, Act.SET_OFF, Act.ACCELERATE, Act.TURN_LEFT, Act.TURN_RIGHT)),
    frozenset((Act.LANE_CHANGE, Act.CUT_IN, Act.CUT_OUT, Act.MERGE, Act.OVERTAKE, Act.SWERVE, Act.DRIFT, Act.WEAVE)),
)
"""What may be seen in the same movement, so that to say the one for the other may be true."""
_HALTS = frozenset((Act.SLOW_DOWN, Act.BRAKE, Act.STOP, Act.HESITATE, Act.FALL))
_STARTS = frozenset((Act.SET_OFF, Act.ACCELERATE))
BRINGS = {
    **dict.fromkeys((Act.LANE_CHANGE, Act.SWERVE, Act.DRIFT), frozenset((Act.ENTER,))),
    Act.PULL_OUT: frozenset((Act.ENTER, Act.MERGE, Act.LANE_CHANGE, Act.DRIFT)),
    Act.MERGE: frozenset((Act.ENTER,)),
    **dict.fromkeys((Act.TURN_LEFT, Act.TURN_RIGHT), frozenset((Act.SLOW_DOWN, Act.BRAKE))),
    Act.YIELD: _HALTS | _STARTS,
    Act.TURN_BACK: _HALTS | _STARTS | {Act.ENTER},  # who goes back had come
    Act.U_TURN: _HALTS | _STARTS | {Act.TURN_BACK},  # who goes the other way goes back
    Act.HESITATE: _HALTS | _STARTS | {Act.CROSS},  # and goes on, from the roadside over the road
    Act.REVERSE: _HALTS | _STARTS | {Act.TURN_BACK, Act.ENTER, Act.PULL_OUT, Act.PARK},  # from or to the edge
    Act.STAND: _STARTS,  # who then goes
    Act.GO_STRAIGHT: frozenset((Act.CROSS,)),  # through a junction, from the side
    Act.ENTER: _HALTS,  # of who stays there
    Act.CUT_IN: frozenset((Act.OVERTAKE, Act.ENTER)),  # of who comes from behind
    Act.OVERTAKE: frozenset((Act.CUT_IN, Act.LANE_CHANGE, Act.MERGE, Act.ACCELERATE, Act.ENTER)),
    Act.STOP: frozenset((Act.SLOW_DOWN, Act.BRAKE)),
    Act.BRAKE: frozenset((Act.SLOW_DOWN,)),
    Act.EXIT: frozenset((Act.LANE_CHANGE, Act.CUT_OUT)),  # out of a lane
}
"""What belongs to a deed, or cannot but be done with it: to say that it is done, or not to say it, is not false."""
ROUND = frozenset((Act.EXIT,))
"""The same of everybody who drives through a roundabout: in the end it leaves that."""
BY_SPEED = frozenset((Act.SLOW_DOWN, Act.BRAKE, Act.ACCELERATE))
"""What is done by speed alone: of whoever loses or gains that anyway, it is not false."""
UNSEEN = frozenset((Act.FALL,))
"""What no track tells: that somebody lies."""
OTHER_PART = {Part.FRONT: Part.REAR, Part.REAR: Part.FRONT, Part.LEFT: Part.RIGHT, Part.RIGHT: Part.LEFT}
_OFFSET = re.compile(r"(param OPT_\w+_OFFSET = Range\()([-.\d]+), ([-.\d]+)\)")


@dataclass(frozen=True, slots=True, kw_only=True)
class Truth:
    """A situation, and the program that is built of it.

    Attributes:
        source: Where the situation is from.
        situation: What is claimed.
        built: The program.
        ego: Who drives.
        struck: Whether the contact is not of the source, and is to be what the drives have.
    """

    source: str
    situation: Situation
    built: Built
    ego: str = "planner"
    struck: bool = False


@dataclass(frozen=True, slots=True, kw_only=True)
class Mutant:
    """A claim that is not true of some drives.

    Attributes:
        kind: What was changed.
        what: How, in words.
        situation: The claim.
        built: Of which program the drives are.
        who: Of whom a deed is said that is not done; empty for other changes.
        act: Which.
    """

    kind: str
    what: str
    situation: Situation
    built: Built
    who: str = ""
    act: Act | None = None


# Truths


def situations(seed: int) -> Iterator[tuple[str, Situation]]:
    """Situations of all three sources by turns, for ever."""
    rng = random.Random(seed)
    replies = list(recorded(FILES))
    rng.shuffle(replies)
    sentences = [one for several in SITUATIONS.values() for one in several]
    rng.shuffle(sentences)
    while True:
        if replies:
            yield "replies", replies.pop()
        if sentences:
            with_words = _read(sentences.pop())
            if with_words is not None:
                yield "gallery", with_words
        drawn = drawn_as_said(rng)
        if not any(True for _ in faults_of(drawn)) and not any(True for _ in impossible(drawn)):
            yield "drawn", drawn


def _read(sentence: str) -> Situation | None:
    try:
        return read_in(sentence, RetrievalSettings()).situation
    except NothingFits:
        return None


def stated(situation: Situation) -> Situation:
    """A situation all of whose facts count, as of whoever wrote it."""
    return replace(situation, evidence=Evidence(), about="", map=None)


def fuller(situation: Situation, rng: random.Random) -> Iterator[tuple[Situation, str]]:
    """It, and with a fact more that mutants can change, each with who is to drive."""
    yield situation, "planner"
    more = rng.choice(("speed", "light", "around", "contact", "contact"))
    stands = any(deed.act is Act.STAND for deed in situation.ego.does)
    if more == "speed" and situation.ego.speed is None and not stands:
        yield replace(situation, ego=replace(situation.ego, speed=Speed.of("36 km/h"))), "planner"
    elif more == "light" and situation.road.ego_light is None:
        light = rng.choice((EgoLight.GREEN, EgoLight.RED))
        road = replace(situation.road, kind=situation.road.kind or RoadKind.JUNCTION, control=RightOfWay.SIGNAL)
        yield replace(situation, road=replace(road, ego_light=light)), "planner"
    elif more == "around":
        around = Around(light=rng.choice(list(Light)), weather=rng.choice(list(Weather)))
        yield replace(situation, around=around), "planner"
    elif more == "contact" and situation.contact is situation.ego.speed is None and _acts_alone(situation):
        yield replace(situation, contact=Contact()), "sac"


def _acts_alone(situation: Situation) -> bool:
    """Whether a contact with one of them leaves nothing undone that others were to do."""
    return sum(any(not deed.act.row.lasting for deed in one.does) for one in situation.others) <= 1


def recorded_contact(situation: Situation, found: Watching) -> Situation | None:
    """The contact of most drives, as the simulator recorded it: with whom, at which side, who strikes one that stands.

    None if most drives have no contact with the same adversary. Nothing of the judge is asked.
    """
    crashes = [one.episode for one in found.drives if one.episode.collision is not None and _comes_later(one.episode)]
    whom = Counter(one.collision.other for one in crashes if one.collision is not None)
    if not whom or whom.most_common(1)[0][1] <= 0.5 * len(found.drives):
        return None
    name = whom.most_common(1)[0][0]
    if name not in {one.id for one in situation.adversaries}:
        return None
    crashes = [one for one in crashes if one.collision is not None and one.collision.other == name]
    sides = {one.collision.side for one in crashes if one.collision is not None}
    stands = {_who_stands(one, name) for one in crashes}
    part = Part(sides.pop()) if len(sides) == 1 else None
    striker = {EGO: Striker.OTHER, name: Striker.EGO}.get(stands.pop()) if len(stands) == 1 else None
    return replace(situation, contact=Contact(whom=name, ego=part, striker=striker))


def _comes_later(episode: Episode) -> bool:
    """Whether a contact comes once anything could have been done: else it is of how the ego is driven."""
    return episode.collision is not None and episode.collision.step * episode.dt >= SOON


def _who_stands(episode: Episode, name: str) -> str:
    """Which of two that touch stood before; empty if neither or both did."""
    assert episode.collision is not None
    before = max(episode.collision.step - 2, 0)
    other = next(track for track in episode.tracks if track.actor == name)
    still = [who for who, one in ((EGO, episode.ego_track), (name, other)) if abs(one.speed[before]) < STANDING]
    return still[0] if len(still) == 1 else ""


def truths(seed: int, count: int) -> Iterator[Truth]:
    """As many as are asked for that can be built."""
    rng = random.Random(f"{seed}/truths")
    made = 0
    for source, found in situations(seed):
        for situation, ego in fuller(stated(found), rng):
            if any(True for _ in faults_of(situation)) or any(True for _ in impossible(situation)):
                continue
            try:
                built = rehearsed(build(situation), situation)
            except NotBuilt:
                continue
            if built.left_out:
                continue
            added = situation.contact == Contact() and stated(found).contact is None
            yield Truth(source=source, situation=situation, built=built, ego=ego, struck=added)
            made += 1
            if made == count:
                return


# Mutants


def _with(situation: Situation, one: Other, made: Other) -> Situation:
    return replace(situation, others=tuple(made if other is one else other for other in situation.others))


def sides(truth: Truth, rng: random.Random) -> Iterator[Mutant]:
    """A side flipped: of a start, or of a deed."""
    del rng
    for one in truth.situation.others:
        if one.starts.side is not None:
            other = Side.LEFT if one.starts.side is Side.RIGHT else Side.RIGHT
            made = replace(one, starts=replace(one.starts, side=other))
            yield _mutant(truth, "side", f"{one.id} starts {other}", _with(truth.situation, one, made))
        for k, deed in enumerate(one.does):
            if deed.to is not None and deed.act in (Act.SWERVE, Act.DRIFT):
                other = Side.LEFT if deed.to is Side.RIGHT else Side.RIGHT
                made = replace(one, does=(*one.does[:k], replace(deed, to=other), *one.does[k + 1 :]))
                yield _mutant(truth, "side", f"{one.id} {deed.act} to the {other}", _with(truth.situation, one, made))


def kinds(truth: Truth, rng: random.Random) -> Iterator[Mutant]:
    """A kind that is another body."""
    for one in truth.situation.others:
        others = [
            kind
            for kind in UserKind
            if kind.scenic != one.kind.scenic and not kind.row.general and all(kind.can(deed.act) for deed in one.does)
        ]
        if others and not one.kind.row.general:
            kind = rng.choice(others)
            made = replace(one, kind=kind)
            yield _mutant(truth, "kind", f"{one.id} is a {kind}", _with(truth.situation, one, made))


def orders(truth: Truth, rng: random.Random) -> Iterator[Mutant]:
    """Two deeds of one that end, the other way round; who stood at first may stand afterwards as well."""
    del rng
    for one in truth.situation.others:
        for k, (first, second) in enumerate(zip(one.does, one.does[1:], strict=False)):
            lasts = any(deed.act.row.lasting for deed in (first, second))
            if lasts or first.act is second.act or first.when or second.when:
                continue
            made = replace(one, does=(*one.does[:k], second, first, *one.does[k + 2 :]))
            what = f"{one.id} {second.act}, then {first.act}"
            yield _mutant(truth, "order", what, _with(truth.situation, one, made))


def left_out(truth: Truth, rng: random.Random) -> Iterator[Mutant]:
    """A deed of several is not said, so that whoever does it does what nobody asked for."""
    for one in truth.situation.others:
        brought = {act for deed in one.does for act in BRINGS.get(deed.act, ())}
        untold = brought | UNSEEN | round_about(truth.situation)
        may_go = [k for k, deed in enumerate(one.does) if not deed.act.row.lasting and deed.act not in untold]
        if len(one.does) < 2 or not may_go:
            continue
        k = rng.choice(may_go)
        made = replace(one, does=one.does[:k] + one.does[k + 1 :])
        what = f"{one.id} does not {one.does[k].act}"
        yield _mutant(truth, "deed left out", what, _with(truth.situation, one, made))


def brought_by(one: Other, situation: Situation) -> frozenset[Act]:
    """All that somebody does, and what belongs to that, or to where it does so."""
    brought = frozenset(act for deed in one.does for act in (deed.act, *BRINGS.get(deed.act, ())))
    return brought | round_about(situation)


def round_about(situation: Situation) -> frozenset[Act]:
    """What everybody does in a roundabout, if the ego drives through one."""
    there = situation.road.kind is RoadKind.ROUNDABOUT or situation.ego.route is EgoRoute.ROUNDABOUT
    return ROUND if there else frozenset()


def added(truth: Truth, rng: random.Random) -> Iterator[Mutant]:
    """A deed that is not done, at the end."""
    for one in truth.situation.others:
        done = brought_by(one, truth.situation)
        alike = {act for several in ALIKE if several & {deed.act for deed in one.does} for act in several}
        free = [act for act in Act if one.kind.can(act) and not act.row.lasting and act not in done | alike]
        rng.shuffle(free)
        for act in free:
            made = replace(one, does=(*one.does, Deed(act=act)))
            mutant = _mutant(truth, "deed added", f"{one.id} {act}", _with(truth.situation, one, made))
            if is_claim(mutant):
                yield replace(mutant, who=one.id, act=act)
                break


def changed(truth: Truth, rng: random.Random) -> Iterator[Mutant]:
    """Another deed in the place of one: none that may be seen in the same movement."""
    for one in truth.situation.others:
        for k, deed in enumerate(one.does):
            alike = next((several for several in ALIKE if deed.act in several), frozenset((deed.act,)))
            done = brought_by(one, truth.situation)
            free = [act for act in Act if one.kind.can(act) and act not in alike | done and act not in GENERAL]
            rng.shuffle(free)
            for act in free:
                made = replace(one, does=(*one.does[:k], Deed(act=act, when=deed.when), *one.does[k + 1 :]))
                what = f"{one.id} {act} in the place of {deed.act}"
                mutant = _mutant(truth, "deed changed", what, _with(truth.situation, one, made))
                if is_claim(mutant):
                    yield replace(mutant, who=one.id, act=act)
                    break


def lights(truth: Truth, rng: random.Random) -> Iterator[Mutant]:
    """Another light of the ego, or another hour or weather."""
    road, around = truth.situation.road, truth.situation.around
    if road.ego_light in (EgoLight.GREEN, EgoLight.RED):
        other = EgoLight.RED if road.ego_light is EgoLight.GREEN else EgoLight.GREEN
        situation = replace(truth.situation, road=replace(road, ego_light=other))
        yield _mutant(truth, "light", f"the ego's is {other}", situation)
    if around.light is not None:
        light = rng.choice([one for one in Light if one is not around.light])
        yield _mutant(truth, "light", f"{light}", replace(truth.situation, around=replace(around, light=light)))


def speeds(truth: Truth, rng: random.Random) -> Iterator[Mutant]:
    """A speed that is much higher or lower."""
    ego = truth.situation.ego
    if ego.speed is not None and not ego.speed.than_ego:
        situation = replace(truth.situation, ego=replace(ego, speed=_other(ego.speed, rng)))
        yield _mutant(truth, "speed", f"the ego at {situation.ego.speed}", situation)
    for one in truth.situation.others:
        for k, deed in enumerate(one.does):
            if deed.speed is None or deed.speed.than_ego:
                continue
            made = replace(one, does=(*one.does[:k], replace(deed, speed=_other(deed.speed, rng)), *one.does[k + 1 :]))
            what = f"{one.id} {deed.act} at {made.does[k].speed}"
            yield _mutant(truth, "speed", what, _with(truth.situation, one, made))


def _other(speed: Speed, rng: random.Random) -> Speed:
    low, high = max(speed.low, 0.0), min(speed.high, 2 * speed.low if speed.low > 0.0 else 10.0)
    share = rng.choice((FASTER, SLOWER))
    return Speed.of(f"{3.6 * share * (high if share > 1.0 else low):.0f} km/h")


def contacts(truth: Truth, rng: random.Random) -> Iterator[Mutant]:
    """Another part, the other striker, or no contact."""
    said = truth.situation.contact
    if said is None or not said.happens:
        return
    others: list[tuple[str, Contact]] = [("there is none", Contact(whom=said.whom, happens=False))]
    if said.striker is not None:
        other = Striker.OTHER if said.striker is Striker.EGO else Striker.EGO
        others.append((f"{other} strikes", replace(said, striker=other)))
    if said.ego is not None and said.ego in OTHER_PART:
        part = OTHER_PART[said.ego]
        others.append((f"at the ego's {part}", replace(said, ego=part)))
    what, contact = rng.choice(others)
    yield _mutant(truth, "contact", what, replace(truth.situation, contact=contact))


def timings(truth: Truth, rng: random.Random) -> Iterator[Mutant]:
    """The same claim, of a program whose adversaries come so late that they meet nobody."""
    del rng
    program = truth.built.program
    source, changed = _OFFSET.subn(
        lambda found: f"{found[1]}{float(found[2]) - LATER:g}, {float(found[3]) - LATER:g})", program.source
    )
    acts = any(deed.act is not Act.STAND for one in truth.situation.adversaries for deed in one.does)
    if changed and acts and truth.situation.contact is None:
        ranges = tuple(
            replace(one, low=one.low - LATER, high=one.high - LATER) if one.name.endswith("_OFFSET") else one
            for one in program.parameters
        )
        late = replace(program, source=source, parameters=ranges)
        mutant = _mutant(truth, "timing", f"{LATER:g} s later", truth.situation)
        yield replace(mutant, built=replace(truth.built, program=late))


MUTATIONS: tuple[Callable[[Truth, random.Random], Iterator[Mutant]], ...] = (
    sides,
    kinds,
    orders,
    left_out,
    added,
    changed,
    lights,
    speeds,
    contacts,
    timings,
)


def _mutant(truth: Truth, kind: str, what: str, situation: Situation) -> Mutant:
    return Mutant(kind=kind, what=what, situation=situation, built=truth.built)


def is_claim(mutant: Mutant) -> bool:
    """Whether a claim is well formed and possible, so that somebody could make it."""
    return not any(True for _ in faults_of(mutant.situation)) and not any(True for _ in impossible(mutant.situation))


# Verdicts


def driven(built: Built, ego: str) -> Watching:
    """The drives of a program; none where its map has no such place."""
    found, rejected = list[Watched](), list[str]()
    for seed in range(DRAWS):
        try:
            route = simulator(built.map).route(built.program, 0)
            episode = drive(built, ego, seed)
        except (MapError, DoesNotCompile) as error:
            rejected.append(str(error))
            continue
        if isinstance(episode, Rejected):
            rejected.append(episode.reason)
        else:
            found.append(Watched(episode=episode, route=route))
    return Watching(kind="program", drives=tuple(found), rejected=tuple(rejected))


def verdict(found: Watching, situation: Situation, least: float) -> Verdict:
    """What is told of some drives."""
    return weighed(found, "it", Asked(situation=situation), VerifySettings(least=least))


def counts(mutant: Mutant, right: Verdict) -> bool:
    """Whether a mutant is false of the drives that it is judged by.

    Of a contact most must have one, of a timing some an encounter. Of a deed by speed alone, whoever is said to do it
    must not do so anyway in most drives, as its speed shows: "it slows down" is true of who cuts in and slows.
    """
    if mutant.act in BY_SPEED:
        done = [does_anyway(mutant, one) for one in right.played]
        return sum(done) <= 0.5 * len(done)
    if mutant.kind == "contact":
        return len(right.crashes) > 0.5 * len(right.draws)
    return mutant.kind != "timing" or bool(right.encounters)


def does_anyway(mutant: Mutant, episode: Episode) -> bool:
    """Whether the speed of somebody alone shows, up to a contact, what a mutant says that is done by speed alone."""
    until = None if episode.collision is None else episode.collision.step + 1
    speeds = [np.abs(one.speed[:until]) for one in episode.tracks if is_of(one.actor, mutant.who)]
    row = mutant.situation[mutant.who].kind.row.body.row
    match mutant.act:
        case Act.SLOW_DOWN:
            peaks = [np.maximum.accumulate(speed) for speed in speeds]
            return any(
                (peak - speed > np.minimum(LOST, SHARE_LOST * peak)).any()
                for speed, peak in zip(speeds, peaks, strict=True)
            )
        case Act.ACCELERATE:
            return any((speed - np.minimum.accumulate(speed) >= gain_of(row)).any() for speed in speeds)
        case _:
            hard = [np.diff(speed) < -BRAKING * episode.dt for speed in speeds]
            return any(end - first >= BRAKES for one in hard for first, end in runs(one))


@dataclass(slots=True)
class Tally:
    """What came of truths and mutants.

    Attributes:
        truths: How many, by where they are from.
        false: How many of them are called false.
        reasons: Facts for which they are, by their paths.
        made: Mutants, by kind.
        caught: How many of them are caught.
        unjudged: Of how many nothing could be judged.
        refused: How many do not compile or cannot be sampled.
        unstruck: To how many a contact was to be added that most drives do not have.
        each: Whether a line tells of each that is not as it should be.
        keep: Where truths that are called false are written; None for nowhere.
    """

    truths: Counter[str] = field(default_factory=Counter[str])
    false: Counter[str] = field(default_factory=Counter[str])
    reasons: Counter[str] = field(default_factory=Counter[str])
    made: Counter[str] = field(default_factory=Counter[str])
    caught: Counter[str] = field(default_factory=Counter[str])
    unjudged: Counter[str] = field(default_factory=Counter[str])
    refused: Counter[str] = field(default_factory=Counter[str])
    unstruck: int = 0
    each: bool = False
    keep: Path | None = None

    def add_truth(self, truth: Truth, right: Verdict) -> None:
        """Count a truth."""
        self.truths[truth.source] += 1
        if right.status != 1:
            return
        self.false[truth.source] += 1
        self.reasons.update({_general(one.path) for one in right.failing})
        if self.keep is not None:
            name = f"{self.truths.total():03d}-{truth.ego}.yaml"
            (self.keep / name).write_text(to_yaml(truth.situation), encoding="utf-8")
        if self.each:
            lines = "; ".join(f"{one.path} {one.shown}/{len(one.judged)} {one.instead}" for one in right.failing)
            click.echo(f"FALSE  {truth.source}: {told(truth.situation)} | {lines}")

    def add_mutant(self, mutant: Mutant, truth: Truth, found: Watching, least: float) -> None:
        """Count a mutant."""
        self.made[mutant.kind] += 1
        if not found.drives:
            self.refused[mutant.kind] += 1
            return
        status = verdict(found, mutant.situation, least).status
        self.caught[mutant.kind] += status == 1
        self.unjudged[mutant.kind] += status == 2
        if status != 1 and self.each:
            click.echo(f"MISSED {mutant.kind}: {mutant.what} | {told(truth.situation)}")

    def lines(self) -> Iterator[str]:
        """What came of them, as tables."""
        total, made = self.truths.total(), self.made.total()
        yield f"truths: {total}; called false: {self.false.total()} ({self.false.total() / total:.1%})"
        yield from (f"  {name}: {count}, called false: {self.false[name]}" for name, count in self.truths.items())
        yield f"  left out, as most drives have no contact with an adversary: {self.unstruck}"
        yield from (f"  called false for {path}: {count}" for path, count in self.reasons.most_common(15))
        if not made:
            return
        yield f"mutants: {made}; caught: {self.caught.total()} ({self.caught.total() / made:.1%})"
        yield "| kind | mutants | caught | share | nothing could be judged | do not compile or sample |"
        yield "|---|---:|---:|---:|---:|---:|"
        for kind, count in self.made.items():
            share = f"{self.caught[kind] / count:.0%}"
            yield f"| {kind} | {count} | {self.caught[kind]} | {share} | {self.unjudged[kind]} | {self.refused[kind]} |"


def mutants(truth: Truth, rng: random.Random) -> Iterator[Mutant]:
    """Those of a truth that are claims somebody could make."""
    for mutation in MUTATIONS:
        yield from (one for one in mutation(truth, rng) if is_claim(one))


@click.command()
@click.option("--truths", "count", default=100, show_default=True)
@click.option("--seed", default=7, show_default=True)
@click.option("--least", default=VerifySettings().least, show_default=True)
@click.option("--each", is_flag=True, help="A line for each that is not as it should be.")
@click.option("--truths-only", is_flag=True, help="Make no mutants.")
@click.option(
    "--keep",
    type=click.Path(path_type=Path, exists=True, file_okay=False),
    default=None,
    help="Where each truth that is called false is written.",
)
def main(count: int, seed: int, least: float, each: bool, truths_only: bool, keep: Path | None) -> None:
    """Make truths and mutants, judge them, and print what came of them by kind."""
    rng = random.Random(f"{seed}/mutants")
    tally = Tally(each=each, keep=keep)
    for truth in truths(seed, count):
        found = driven(truth.built, truth.ego)
        if not found.drives:
            continue
        if truth.struck:
            claimed = recorded_contact(truth.situation, found)
            if claimed is None:
                tally.unstruck += 1
                continue
            truth = replace(truth, situation=claimed)  # noqa: PLW2901
        right = verdict(found, truth.situation, least)
        tally.add_truth(truth, right)
        if truths_only or right.status == 1:  # what is changed of a claim that is false already proves nothing
            continue
        for mutant in mutants(truth, rng):
            if counts(mutant, right):
                drives = found if mutant.built is truth.built else driven(mutant.built, truth.ego)
                tally.add_mutant(mutant, truth, drives, least)
    click.echo("\n".join(tally.lines()))


def _general(path: str) -> str:
    return re.sub(r"\b(?:[A-Z]|\d+)\b", "*", path)


if __name__ == "__main__":
    main()
