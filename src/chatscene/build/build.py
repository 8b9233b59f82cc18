"""A situation to a program: the place, then everybody in it, then what could not be built."""

from __future__ import annotations

import textwrap
from dataclasses import dataclass

from chatscene.build.actor import Actor
from chatscene.build.asked import Meets, between, stands_first
from chatscene.build.coming import wanted_by
from chatscene.build.ego import BuiltEgo, ego_of
from chatscene.build.finding import find, started
from chatscene.build.ledger import Ledger
from chatscene.build.naming import name_of
from chatscene.build.place import Found
from chatscene.build.possible import OFF_ROAD, impossible
from chatscene.build.relations import check_passed_by_ego
from chatscene.build.towards import at_distance, in_one_row, in_rows, passes
from chatscene.errors import NotBuilt
from chatscene.situations.faults import dotted
from chatscene.terms.scene import ScenicProgram
from chatscene.terms.situation import Other, Situation
from chatscene.terms.surroundings import FOLLOWS
from chatscene.terms.vocabulary import Act, Role, Where

_SAME = {Where.DRIVEWAY: "roadside", Where.IN_ROUNDABOUT: "roundabout-entry"}
"""Where those stand in one row who are said to be in two places."""
NOBODY = "nobody meets the ego: others: nobody has the role adversary"
"""Why a situation is refused in which nobody does."""
SLOWEST = 4.0  # [m/s] that an ego wants of which no speed was said


@dataclass(frozen=True, slots=True, kw_only=True)
class Built:
    """A program that was built, and what is otherwise than was said.

    Attributes:
        program: The program.
        map: The map that it was built for.
        assumed: What was not said and had to be something, in words.
        left_out: Facts that it lacks, as ``path: value``.
    """

    program: ScenicProgram
    map: str
    assumed: tuple[str, ...] = ()
    left_out: tuple[str, ...] = ()


def build(situation: Situation, *, name: str = "situation") -> Built:
    """The program of a situation.

    Args:
        situation: What is to happen.
        name: What the scenario is called.

    Raises:
        NotBuilt: A fact of it cannot be built, or no map has such a place; the message names the fact.
        MapError: There is no such map.
    """
    if not situation.adversaries:
        raise NotBuilt(NOBODY)
    if cannot := [f"{dotted(one.path)}: {one.said}" for one in impossible(situation)]:
        raise NotBuilt("this cannot be: " + "; ".join(cannot))
    usual = wanted_by(situation)
    ledger, found, ego, everybody, body = _cast(situation, usual, 0.0)
    road = max(one.takes for one, _ in everybody)
    if road > found.route.line.length:  # what is done goes on for longer
        ledger, found, ego, everybody, body = _cast(situation, usual, road)
    slow = min((one.reaches / one.needs for one, _ in everybody if one.needs > 0.0), default=ego.coming.speed)
    if slow < ego.coming.speed and situation.ego.speed is None:  # it would be there before the others are done
        ledger, found, ego, everybody, body = _cast(situation, max(slow, SLOWEST), road)
    numbers = sorted((one for actor, _ in everybody for one in actor.numbers.declared(body)), key=lambda one: one.name)
    around = _around(ledger)
    if (contact := situation.contact) is not None and contact.whom in {one.id for one in situation.adversaries}:
        ledger.take("contact.whom")
    declared = [f"param {one.name} = Range({one.low}, {one.high})" for one in numbers]
    query = ", ".join(f"{key}={value!r}" for key, value in found.query.items())
    source = "\n".join(
        (
            *textwrap.wrap(_title(situation), 100, initial_indent="# ", subsequent_indent="# "),
            "",
            "model chatscene.world.model",
            *around,
            *declared,
            *ego.params,
            "",
            f"egoRoute = selectRoute({query})",
            f"ego = new Car at startOf(egoRoute), facing directionOn(egoRoute, 0), with route egoRoute{ego.properties}",
            "",
            body,
        )
    )
    program = ScenicProgram(scenario_id=name, source=source, parameters=tuple(numbers), snippet_ids=())
    return Built(program=program, map=found.map, left_out=ledger.close(), assumed=tuple(ledger.assumed))


def _cast(
    situation: Situation, speed: float, road: float
) -> tuple[Ledger, Found, BuiltEgo, list[tuple[Actor, Actor | None]], str]:
    """Everybody on so much road if there is as much, with an ego that wants a speed if none was said; their text."""
    ledger = Ledger(situation)
    found = find(ledger, road)
    ego = ego_of(ledger, found, speed)
    check_passed_by_ego(ledger.situation, ego.coming.speed)
    everybody = _everybody(ledger, found, ego)
    for actor, _ in everybody:
        if actor.one.role is Role.ADVERSARY:
            actor.phases()
    soon = min(actor.met for actor, _ in everybody if actor.one.role is Role.ADVERSARY)
    for actor, _ in everybody:
        actor.soon = soon if actor.one.role is Role.SUPPORTING else None
    body = "\n".join(line for actor, hidden in everybody for line in (*actor.code(hidden), ""))
    return ledger, found, ego, everybody, body


def _everybody(ledger: Ledger, found: Found, ego: BuiltEgo) -> list[tuple[Actor, Actor | None]]:
    """All others, those who hide somebody after whom they hide; with whom each hides."""
    situation = ledger.situation
    built: dict[str, Actor] = {}
    rows: dict[tuple[str, str, bool], tuple[Actor, float]] = {}
    order: list[tuple[Actor, Actor | None]] = []
    others = [at_distance(ledger, one) for one in in_rows(situation.others)]
    for one in sorted(others, key=lambda other: _hides(situation, other) is not None):
        hidden = _hides(situation, one)
        stands = stands_first(one) and one.starts.where not in OFF_ROAD
        in_row = next((other for other in others if passes(one, other) and in_one_row(one, other)), one)
        where = in_row.starts.where
        place = (_SAME.get(where, str(where)), str(one.starts.side), stands)
        shares = hidden is None and one.starts.distance is None  # else it stands where it was said to
        first, room = rows.get(place, (None, 0.0)) if shares else (None, 0.0)
        actor = Actor(ledger, found, started(one, found.sides), ego.coming, room, first)
        built[one.id] = actor
        if hidden is None:
            long = (
                2.5
                if actor.stand.meets is Meets.ACROSS
                else actor.count * (actor.limits.length + between(one, ego.coming.speed))
            )
            rows[place] = (first or actor, room + long)
        order.append((actor, built[hidden] if hidden is not None else None))
    return order


def _hides(situation: Situation, one: Other) -> str | None:
    """The id of whom somebody hides, who only hides or stands."""
    hidden = next((other.id for other in situation.others if other.hidden_by == one.id), None)
    stands = one.role is Role.SUPPORTING and all(deed.act is Act.STAND for deed in one.does)
    return hidden if one.role is Role.HIDES or stands else None


def _title(situation: Situation) -> str:
    """What it is about, for a comment."""
    who = "; ".join(f"{name_of(one.id)} is a {one.kind} {one.starts.where}" for one in situation.others)
    return f"the ego: {situation.ego.route or 'straight'}; {who}"


def _around(ledger: Ledger) -> list[str]:
    around = ledger.situation.around
    ledger.take("around")
    surface = around.surface or (FOLLOWS.get(around.weather) if around.weather else None)
    said = {"light": around.light, "weather": around.weather, "surface": surface}
    named = ", ".join(f"{name} = '{value}'" for name, value in said.items() if value is not None)
    return [f"param {named}"] if named else []
