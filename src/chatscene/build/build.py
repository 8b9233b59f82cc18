"""A situation to a program: the place, then everybody in it, then what could not be built."""

from __future__ import annotations

import math
import textwrap
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass, replace

from chatscene.build.actor import Actor
from chatscene.build.anchors import anchor_of
from chatscene.build.answering import answering
from chatscene.build.asked import ROOM, SOME, Meets, between, passes_with, stands_first
from chatscene.build.awaiting import in_phases, met_by
from chatscene.build.backing import check_met
from chatscene.build.bays import out_of_bay
from chatscene.build.brushed import parts_brushed
from chatscene.build.coming import speeds_to_try, wanted_by
from chatscene.build.contact import at_a_corner, parts_in_line
from chatscene.build.ego import BuiltEgo, ego_of, ordered
from chatscene.build.finding import find, started, without_one_fact
from chatscene.build.keeping import as_kept, take_kept
from chatscene.build.lane_order import check_hidden, come_before_who_answers, leaves_row, set_in_order
from chatscene.build.laying import roads_for
from chatscene.build.ledger import Ledger, as_written
from chatscene.build.naming import name_of
from chatscene.build.passing import come_after_who_passes, come_by_before_who_crosses, stand_beyond_who_passes
from chatscene.build.place import Found, along_the_road, wrong_way
from chatscene.build.possible import OFF_ROAD, impossible
from chatscene.build.rails import over_rails
from chatscene.build.relations import check_kept_up, check_passed_by_ego
from chatscene.build.restated import restated
from chatscene.build.revealed import revealed
from chatscene.build.roadside import beside_road
from chatscene.build.run_up import run_up
from chatscene.build.screening import from_its_lane
from chatscene.build.standing_before import beyond_another, in_queue, parts_backed_into
from chatscene.build.towards import at_distance, in_one_row, in_rows, passes, room_kept, screens
from chatscene.build.written import ON_FOOT, Written
from chatscene.errors import MapError, NoSuchPlace, NoSuchRoad, NotBuilt, NothingBuilds, RoadTooShort
from chatscene.maps.left_hand import keeps_left
from chatscene.maps.network import resolve_map
from chatscene.situations.faults import dotted
from chatscene.terms.actors import Manner as Moves
from chatscene.terms.amount import Speed
from chatscene.terms.backing import as_it_backs, backs
from chatscene.terms.mirroring import IN_THE_MIRROR, mirrored_situation, mirrored_words
from chatscene.terms.nouns import with_article
from chatscene.terms.rolling import as_it_rolls
from chatscene.terms.scene import ScenicProgram
from chatscene.terms.situation import Other, Situation
from chatscene.terms.surroundings import FOLLOWS
from chatscene.terms.vocabulary import OVER_A_LINE, Act, Role, Where

_SAME = {Where.DRIVEWAY: "roadside", Where.IN_ROUNDABOUT: "roundabout-entry"}
"""Where those stand in one row who are said to be in two places."""
BEYOND = "beyond"  # where who stands in the row of those who are ahead, and yet by itself
NOBODY = "others: nobody meets the ego; give one the role adversary"
"""Why a situation is refused in which nobody does."""
IN_TIME = 0.75  # of the time that somebody needs, the least that the ego leaves it
SLOWEST = 4.0  # [m/s] that an ego wants of which no speed was said


@dataclass(frozen=True, slots=True, kw_only=True)
class Built:
    """A program that was built, and what is otherwise than was said.

    Attributes:
        program: The program.
        map: The map that it was built for.
        assumed: What was not said and had to be something, in words.
        left_out: Facts that it lacks, as ``path: value``.
        lacking: Of all these, what its place lacks.
        bound: The names of its parameters that are numbers that were said, or follow from these.
        unseen: Facts that none of the drives showed that it was rehearsed in, each with what is seen instead.
    """

    program: ScenicProgram
    map: str
    assumed: tuple[str, ...] = ()
    left_out: tuple[str, ...] = ()
    lacking: tuple[str, ...] = ()
    bound: frozenset[str] = frozenset()
    unseen: tuple[str, ...] = ()


def build(situation: Situation, *, name: str = "situation", at_most: float = math.inf) -> Built:
    """The program of a situation.

    Args:
        situation: What is to happen.
        name: What the scenario is called.
        at_most: What an ego wants at most [m/s] of which no speed was said, so that drives show what was said.

    Raises:
        NotBuilt: A fact of it cannot be built, or no map has such a place; the message names the fact.
        MapError: There is no such map.
    """
    if situation.map is not None and keeps_left(resolve_map(situation.map)):
        return _in_the_mirror(situation, name, at_most)
    try:
        return _where_it_can(situation, name, at_most)
    except NotBuilt as error:
        raise type(error)(as_written(str(error), situation)) from error


def _where_it_can(situation: Situation, name: str, at_most: float) -> Built:
    """The program of a situation on a map that has its place, else on a road that is laid to order.

    It is laid where the packaged maps have no such place, or one that lacks more of what was said.
    """
    refused: NotBuilt | None = None
    made: Built | None = None
    try:
        made = _as_fast_as_it_can(situation, name, at_most)
    except NothingBuilds:
        raise
    except NotBuilt as error:
        refused = error
    for laid in () if situation.map is not None else roads_for(situation):
        if made is not None and not made.lacking:
            break
        with suppress(NotBuilt):
            ordered = _as_fast_as_it_can(replace(situation, map=str(laid)), name, at_most)
            if made is None or len(ordered.lacking) < len(made.lacking):
                made = ordered
    if made is None:
        raise refused or NotBuilt(NOBODY)
    return made


def _in_the_mirror(situation: Situation, name: str, at_most: float) -> Built:
    """The program of a situation on a map of left-hand traffic, of which there is the mirror image."""
    seen = situation if situation.evidence.mirrored else mirrored_situation(situation)
    try:
        made = _as_fast_as_it_can(seen, name, at_most)
    except NotBuilt as error:
        raise type(error)(mirrored_words(as_written(str(error), seen))) from error
    title, _, code = made.program.source.partition("\n\n")
    source = "\n\n".join((f"{mirrored_words(title)}\n# {IN_THE_MIRROR}", code))
    parameters = tuple(replace(one, meaning=mirrored_words(one.meaning)) for one in made.program.parameters)
    return replace(
        made,
        program=replace(made.program, source=source, parameters=parameters),
        assumed=tuple(map(mirrored_words, made.assumed)),
        left_out=tuple(map(mirrored_words, made.left_out)),
    )


def _as_fast_as_it_can(situation: Situation, name: str, at_most: float) -> Built:
    """The program of a situation, as `build`, whose refusals name places as they are built."""
    if not situation.adversaries:
        raise NotBuilt(NOBODY)
    cannot: dict[str, str] = {}
    made = restated(situation)
    for one in impossible(made.situation):
        cannot.setdefault(dotted(one.path), one.said)  # the first reason of each fact
    if cannot:
        raise NotBuilt("impossible: " + "; ".join(f"{path}: {why}" for path, why in cannot.items()))
    said = situation
    situation = replace(made.situation, others=tuple(along_the_road(wrong_way(one)) for one in made.situation.others))
    situation = in_queue(as_it_backs(as_it_rolls(out_of_bay(over_rails(situation)))))
    situation, hidden = revealed(situation)
    situation, answers = answering(situation)
    situation = at_a_corner(situation)
    check_met(situation)
    every, refused = speeds_to_try(situation), list[NotBuilt]()
    speeds = tuple(speed for speed in every if speed <= at_most) or every[-1:]
    for speed in speeds:
        try:
            slow = at_most < every[0]
            assumed = [*made.assumed, *hidden, *answers]
            said_so = Ledger(situation, told=said, slow=slow, built=set(made.taken), assumed=assumed)
            program = _built(said_so, speed, name)
        except NotBuilt as error:  # at a speed that was not said; a slower ego may do
            refused.append(error)
            if isinstance(error, NothingBuilds | NoSuchRoad):
                break  # which no speed changes
        else:
            return program
    if helps := _instead(refused[0], situation, speeds[0], name):
        raise type(refused[0])(f"{refused[0]}; {helps}") from refused[0]
    raise refused[0]


def _instead(refused: NotBuilt, situation: Situation, speed: float, name: str) -> str:
    """What could be said in place of what is refused, in words; empty if nothing is known."""
    if isinstance(refused, RoadTooShort):
        return _slow_enough(situation, speed, name)
    if isinstance(refused, NoSuchPlace):
        return without_one_fact(situation, speed)
    return ""


def _slow_enough(situation: Situation, speed: float, name: str) -> str:
    """The fastest of slower egos, by tens of km/h, that leaves others the time for all that they do, in words."""
    for slower in range(10 * math.ceil(0.36 * speed - 1e-9) - 10, 0, -10):
        ego = replace(situation.ego, speed=Speed.of(f"{slower} km/h"))
        with suppress(NotBuilt):
            _built(Ledger(replace(situation, ego=ego)), speed, name)
            return f"say ego.speed: {slower} km/h"
    return "a slower ego does not help; leave out one of the deeds"


def _built(said: Ledger, usual: float, name: str) -> Built:
    """The program of a situation, with an ego that wants a speed [m/s] at most if none was said.

    Raises:
        NotBuilt: A fact of it cannot be built, or no map has such a place.
    """
    situation = as_kept(said.situation, min(usual, wanted_by(said.situation)))
    read = said.anew(situation)
    take_kept(read)
    found = find(read, usual)
    ledger, ego, everybody, body = _cast(read, found, usual)
    road = max(one.takes for one, _ in everybody)
    if road > found.route.line.length and not backs(situation):  # what is done goes on for longer
        read = said.anew(situation)
        take_kept(read)
        found = find(read, usual, road)
        ledger, ego, everybody, body = _cast(read, found, usual)
    slow = ego.coming.speed * min((one.given / one.needs for one, _ in everybody if one.needs > 0.0), default=1.0)
    if slow < ego.coming.speed and situation.ego.speed is None:  # it would be there before the others are done
        ledger, ego, everybody, body = _cast(read, found, max(slow, min(SLOWEST, ego.coming.speed)))
    _check_road(situation, [actor for actor, _ in everybody])
    numbers = sorted((one for actor, _ in everybody for one in actor.numbers.declared(body)), key=lambda one: one.name)
    around = _around(ledger)
    contact = situation.contact
    if contact is not None and (not contact.happens or contact.whom in {one.id for one in situation.adversaries}):
        ledger.take("contact.whom")  # a drive in which the ego touches nobody shows that it does not touch that one
    ledger.take(*parts_in_line(situation), *parts_backed_into(situation), *parts_brushed(situation))
    if contact is not None and not contact.happens:  # drives without a contact are those that are kept
        ledger.take("contact.happens")
    declared = [f"param {one.name} = Range({one.low}, {one.high})" for one in numbers]
    query = ", ".join(f"{key}={value!r}" for key, value in (found.query | ego.query).items())
    about = ", 3.14159" if backs(situation) else ""
    actors = {actor.one.id: actor for actor, _ in everybody}
    orders = ordered((*in_phases(ego.orders, situation, actors), *run_up(ledger, ego.coming.speed, actors)))
    placed = (
        f"at startOf(egoRoute), facing directionOn(egoRoute, 0{about}), with route egoRoute{ego.properties}{orders}"
    )
    cls = situation.ego.body.row.scenic
    source = "\n".join(
        (
            *textwrap.wrap(_title(situation), 100, initial_indent="# ", subsequent_indent="# "),
            "",
            "model chatscene.world.model",
            "param drivesUntil = 'over'",
            *around,
            *declared,
            *ego.params,
            "",
            f"egoRoute = selectRoute({query})",
            f"ego = new {cls} {placed}",
            "",
            body,
        )
    )
    program = ScenicProgram(scenario_id=name, source=source, parameters=tuple(numbers), snippet_ids=())
    said_ones = (
        actor.numbers.called(name) for actor, _ in everybody for name in (*actor.numbers.bound, *actor.numbers.held)
    )
    return Built(
        program=program,
        map=found.map,
        left_out=(left_out := ledger.close()),
        lacking=(*(one for one in left_out if one.startswith("road.")), *ledger.lacking),
        assumed=tuple(ledger.assumed),
        bound=frozenset(said_ones),
    )


def _check_road(situation: Situation, actors: Sequence[Actor]) -> None:
    """Hold that an ego of which a speed was said is not long past where it meets somebody before all is done.

    Raises:
        RoadTooShort: Somebody who goes along with it does several things, for which the road is too short.
    """
    for actor in actors:
        several = sum(not deed.act.row.lasting for deed in actor.deeds) > 1 and actor.stand.meets is Meets.ALONG
        drives = situation.ego.speed is not None and not situation.ego.does
        if drives and several and actor.given < IN_TIME * actor.needs:
            raise RoadTooShort(
                f"others.{actor.one.id}: its deeds take {actor.needs:.0f} s, but an ego at"
                f" {3.6 * actor.ego_speed:.0f} km/h arrives after {actor.given:.0f} s"
            )


def _cast(read: Ledger, found: Found, speed: float) -> tuple[Ledger, BuiltEgo, list[tuple[Actor, Actor | None]], str]:
    """Everybody, with an ego that wants a speed if none was said, and the text of all others; with a ledger of it.

    Raises:
        NotBuilt: A fact cannot be built, or its place lacks what somebody needs there.
    """
    try:
        return _cast_there(read, found, speed)
    except MapError as error:
        raise NotBuilt(f"no map has such a place: {error}") from error


def _cast_there(
    read: Ledger, found: Found, speed: float
) -> tuple[Ledger, BuiltEgo, list[tuple[Actor, Actor | None]], str]:
    ledger = read.anew(read.situation)
    ego = ego_of(ledger, found, speed)
    check_passed_by_ego(ledger.situation, ego.coming.speed)
    check_kept_up(ledger.situation, ego.coming.speed)
    everybody = _everybody(ledger, found, ego)
    for actor, _ in everybody:
        if actor.one.role is Role.ADVERSARY:
            actor.phases()
    soon = min(actor.met for actor, _ in everybody if actor.one.role is Role.ADVERSARY)
    for actor, _ in everybody:
        actor.soon = soon if actor.one.role is Role.SUPPORTING else None
    come_before_who_answers([actor for actor, _ in everybody])
    come_after_who_passes([actor for actor, _ in everybody])
    come_by_before_who_crosses([actor for actor, _ in everybody])
    stand_beyond_who_passes([actor for actor, _ in everybody])
    lines = [line for actor, hidden in everybody for line in (*Written(actor, hidden).code(), "")]
    body = "\n".join((*lines, *beside_road(ledger, [actor for actor, _ in everybody])))
    check_hidden([actor for actor, _ in everybody])
    return ledger, ego, everybody, body


def _everybody(ledger: Ledger, found: Found, ego: BuiltEgo) -> list[tuple[Actor, Actor | None]]:
    """All others, those who hide somebody after whom they hide; with whom each hides."""
    situation = ledger.situation
    built: dict[str, Actor] = {}
    rows: dict[tuple[str, str, bool], tuple[Actor, float]] = {}
    latest: dict[tuple[str, str, bool], tuple[Other, float]] = {}
    ahead: dict[tuple[str, str, bool], float] = {}
    order: list[tuple[Actor, Actor | None]] = []
    others = [at_distance(ledger, one) for one in in_rows(situation)]
    others = [started(one, found.sides) for one in others]
    anchors = {one.id: anchor_of(one, others) for one in others if _hides(situation, one) is None}

    def late(one: Other) -> tuple[bool, bool, bool]:
        """Whether somebody is placed after others: by whom it hides, who begins beside it, who is met."""
        unmet = _on_arm_unmet(situation, one) or _leads_unmet(situation, one)
        return _hides(situation, one) is not None, bool(anchors.get(one.id)), unmet

    for one in sorted(others, key=late):
        hidden = _hides(situation, one)
        stands = stands_first(one) and one.starts.where not in OFF_ROAD
        in_row = next((other for other in others if passes(one, other) and in_one_row(one, other)), one)
        where = in_row.starts.where
        named = BEYOND if beyond_another(situation, one) else _SAME.get(where, str(where))
        place = (named, str(one.starts.side), stands)
        shares = hidden is None and one.starts.distance is None  # else it stands where it was said to
        first, room = rows.get(place, (None, 0.0)) if shares else (None, 0.0)
        apart = one.kind.row.body.row.limits.length + between(one, ego.coming.speed)
        if before := first is not None and _is_by_before(situation, one, first.one, ego):
            ahead[place] = ahead.get(place, 0.0) + (one.count or SOME) * apart
            room = -ahead[place]
        if first is not None and first.stand.meets is Meets.ACROSS and one.kind.moves is not Moves.WALKS:
            room += 0.5 * one.kind.row.body.row.limits.length + ROOM  # beyond who goes over the road there
        if (anchor := anchors.get(one.id)) is not None and anchor[0].id in built:
            first, room = built[anchor[0].id], built[anchor[0].id].room + anchor[1]
            first = first.first or first
        if (
            first is not None
            and anchor is None
            and place in latest
            and (kept := room_kept(latest[place][0], one)) is not None
        ):
            room = latest[place][1] + kept
        if first is not None and before and passes_with(one, first.one):
            ledger.take(f"others.{first.one.id}.hidden_by")
        actor = Actor(ledger, found, one, met_by(one.id, ego.coming, ego.orders), room, first)
        built[one.id] = actor
        if hidden is None and anchors.get(one.id) is None and not before:
            across, more = actor.stand.meets is Meets.ACROSS, actor.count - 1
            abreast = 1.5 if one.hidden_by is not None else 2.5  # from the same gap
            long = abreast + 0.5 * more * ON_FOOT if across else actor.count * apart
            long += leaves_row(actor)
            rows[place], latest[place] = (first or actor, room + long), (one, room + (0.0 if across else more * apart))
        order.append((actor, built[hidden] if hidden is not None else None))
    set_in_order([actor for actor, _ in order])
    return order


def _leads_unmet(situation: Situation, one: Other) -> bool:
    """Whether somebody who is not met goes along ahead, all the time: who is met there is nearer to the ego.

    Of nobody else it was said whether it is before that one.
    """
    goes = one.starts.where is Where.AHEAD and not stands_first(one) and one.role is not Role.ADVERSARY
    leaves = not OVER_A_LINE.isdisjoint(deed.act for deed in one.does)
    others = [other for other in situation.others if other.id != one.id]
    named = any(other.hidden_by == one.id or any(deed.whom == one.id for deed in other.does) for other in others)
    names = any(deed.whom is not None for deed in one.does)
    return goes and not (leaves or named or names)


def _on_arm_unmet(situation: Situation, one: Other) -> bool:
    """Whether somebody who is not met comes through a junction, and may be by before others who come from there."""
    hides = any(passes_with(one, other) for other in situation.others)
    return one.role is not Role.ADVERSARY and (one.starts.where is Where.ARM or hides)


def _is_by_before(situation: Situation, one: Other, met: Other, ego: BuiltEgo) -> bool:
    """Whether somebody who is not met comes through a junction in a row with who is: it is by before that one."""
    seen = met if not passes_with(one, met) else replace(met, hidden_by=None)
    drives = all(_comes_driving(other) for other in (one, seen))
    return _on_arm_unmet(situation, one) and met.role is Role.ADVERSARY and drives and ego.coming.late is not None


def _comes_driving(one: Other) -> bool:
    """Whether somebody comes driving from the first, from no distance that was said."""
    free = one.starts.distance is None and one.hidden_by is None and not stands_first(one)
    when = one.does[0].when if one.does else None
    return free and when is None and all(deed.act.row.lasting for deed in one.does[:-1])


def _hides(situation: Situation, one: Other) -> str | None:
    """The id of whom somebody hides, who only hides or stands, and not by being nearer in the ego's lane."""
    beside = (other for other in situation.others if not (screens(one, other) or passes_with(one, other)))
    hides = (other.id for other in beside if other.hidden_by == one.id)
    hidden = next(hides, None)
    stands = one.role is Role.SUPPORTING and all(deed.act is Act.STAND for deed in one.does)
    in_lane = hidden is not None and from_its_lane(situation, one, situation[hidden])
    return hidden if one.role is Role.HIDES or stands or in_lane else None


def _title(situation: Situation) -> str:
    """What it is about, for a comment."""
    who = "; ".join(f"{name_of(one.id)} is {with_article(one.kind)} {one.starts.where}" for one in situation.others)
    return f"the ego: {situation.ego.route or 'straight'}; {who}"


def _around(ledger: Ledger) -> list[str]:
    around = ledger.situation.around
    ledger.take("around")
    surface = around.surface or (FOLLOWS.get(around.weather) if around.weather else None)
    said = {"light": around.light, "weather": around.weather, "surface": surface}
    named = ", ".join(f"{name} = '{value}'" for name, value in said.items() if value is not None)
    return [f"param {named}"] if named else []
