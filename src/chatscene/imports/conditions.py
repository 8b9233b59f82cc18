"""The conditions under which events of OpenSCENARIO begin, as the ends of the phases before them."""

from __future__ import annotations

from collections.abc import Sequence

from chatscene.imports.given import Given, Refused
from chatscene.imports.player import AHEAD, STANDS, Player, State
from chatscene.imports.stranger_xml import Element
from chatscene.terms.plan import (
    After,
    Arithmetic,
    Boolean,
    Call,
    Comparison,
    Expression,
    Kind,
    Name,
    Number,
    Relation,
    Until,
)
from chatscene.terms.storyboard import EGO_ROUTE, START
from chatscene.terms.sums import Sum, sum_of

_RULES: dict[str, Relation] = {
    "lessThan": "<",
    "lessOrEqual": "<=",
    "greaterThan": ">",
    "greaterOrEqual": ">=",
    "equalTo": "==",
    "notEqualTo": "!=",
}


_NOT_AFTER = "it does not wait for the event before; a plan goes through its events one after the other"


class Conditions:
    """Reads the triggers of an actor's events."""

    def __init__(self, player: Player, given: Given, state: State) -> None:
        self._player, self._given, self._state = player, given, state

    def ends(self, event: Element, before: Element | None, first: list[Element]) -> list[After | Until] | None:
        """When an event begins after the one before; None for at once.

        Raises:
            Refused: It does not wait for the one before, or waits for what no plan waits for.
        """
        trigger = event.find("StartTrigger")
        groups = trigger.all("ConditionGroup") if trigger else []
        act = (self._alternative(event, None, first, ()) or []) if first else []
        read = [self._alternative(event, before, group.all("Condition"), act) for group in groups] or [None]
        if before is not None and not groups:
            raise Refused(event, _NOT_AFTER)
        if any(one is None for one in read):
            return act or None
        ends = [one for one in read if one is not None]
        if len(ends) == 1:
            return [*act, *ends[0]]
        terms = [one.condition for end in ends for one in end if isinstance(one, Until)]
        if any(len(end) > 1 for end in ends) or len(terms) < len(ends):
            raise Refused(event, "it begins in one way or another, and one of them takes some time")
        return [*act, Until(Boolean("or", tuple(terms)))]

    def _alternative(  # noqa: C901 - a case for each kind of condition
        self, event: Element, before: Element | None, conditions: list[Element], act: Sequence[After | Until]
    ) -> list[After | Until] | None:
        """When all of some conditions hold that are asked from the end of the event before, or of an act, on."""
        ends: list[After | Until] = []
        terms: list[Expression] = []
        delays: list[Sum] = []
        times: list[Element] = []
        follows = before is None
        for condition in conditions:
            edge = condition.attributes.get("conditionEdge", "none")
            if edge not in ("none", "rising"):
                raise Refused(condition, "it looks for the moment in which something ceases; write what holds then")
            if (delay := self._given.sum(condition, "delay", "0")).number != 0:
                delays.append(delay)
            by_value = condition.find("ByValueCondition")
            asked = by_value.inside[0] if by_value is not None and len(by_value.inside) == 1 else None
            if asked is not None and asked.tag == "SimulationTimeCondition":
                times.append(asked)
            elif asked is not None:
                ends += self._by_value(asked, before)
                follows = True
            else:
                if edge == "rising" and before is not None and self._player.side > 0:
                    raise Refused(
                        condition, "it waits for what begins to hold, from the beginning on; write what holds"
                    )
                terms.append(self._of_somebody(condition))
        ends += self._at_times(times, ends, act, follows=follows)
        if not follows and not ends:
            raise Refused(event, _NOT_AFTER)
        if len(delays) > 1 or (delays and len(terms) + len(ends) > 1):
            raise Refused(event, "several conditions, of which one has a delay; write an event between")
        if terms and any(isinstance(end, Until) for end in ends):
            terms = [*(part for end in ends if isinstance(end, Until) for part in _terms(end.condition)), *terms]
            ends = [end for end in ends if isinstance(end, After)]
        if terms:
            ends.append(Until(terms[0] if len(terms) == 1 else Boolean("and", tuple(terms))))
        ends += [After(delay.expression) for delay in delays]
        return ends or None

    def _of_somebody(self, condition: Element) -> Expression:
        """What must hold of somebody."""
        by_entity = condition.find("ByEntityCondition")
        if by_entity is None:
            raise Refused(condition, "it says no condition")
        triggering, asked = by_entity.find("TriggeringEntities"), by_entity.find("EntityCondition")
        entities = triggering.all("EntityRef") if triggering else []
        if len(entities) != 1 or asked is None or len(asked.inside) != 1:
            raise Refused(by_entity, "it is about several road users; name one in TriggeringEntities")
        return self._by_entity(self._given.text(entities[0], "entityRef"), asked.inside[0])

    def _by_value(self, one: Element, before: Element | None) -> list[After | Until]:
        """How the event before ends, where that is waited for."""
        match one.tag:
            case "VariableCondition":
                phase = max(len(self._state.phases) - 1, 0)
                if one.attributes.get("rule") != "equalTo" or self._given.text(one, "value") != str(phase):
                    raise Refused(one, f"a variable is read where it counts the phases of one actor, here {phase}")
                return []
            case "StoryboardElementStateCondition":
                state = self._given.text(one, "state")
                named = self._named(one, before)
                if state in ("completeState", "endTransition"):
                    way = named.tag == "Action"
                    done = self._state.turned if way and self._state.turned.end is not None else self._state.done
                    return [done.end] if done.end is not None else []
                if state in ("runningState", "startTransition"):
                    return []
                raise Refused(one, f"the state {state!r} is not waited for here; write completeState")
            case _:
                raise Refused(one, "it is not known here; write when by time, distance, speed or the event before")

    def _named(self, one: Element, before: Element | None) -> Element:
        """The event before, or the action in it, that is waited for."""
        kind, name = self._given.text(one, "storyboardElementType", "event"), one.attributes.get("storyboardElementRef")
        name = name if (name or "").startswith("${") else self._given.text(one, "storyboardElementRef")
        parts = [] if before is None else before.all("Action") if kind == "action" else [before]
        last = str(name).split("::")[-1]
        found = [part for part in parts if kind in ("event", "action") and part.attributes.get("name") == last]
        if not found:
            raise Refused(
                one, "it waits for another event than the one before; write the condition by which that begins"
            )
        return found[0]

    def _at_times(
        self, times: list[Element], ends: list[After | Until], act: Sequence[After | Until], *, follows: bool
    ) -> list[After | Until]:
        """How long it is to the last of some times of the clock."""
        found: list[Sum] = []
        for one in times:
            rule = self._given.text(one, "rule", "greaterThan")
            if _RULES.get(rule) not in (">", ">=", "=="):
                raise Refused(one, f"a plan cannot wait for a time by the rule {rule}")
            value = self._given.sum(one, "value")
            for end in (*(phase.end for phase in self._state.phases), *act, *ends):
                if isinstance(end, After):
                    value = value + _sum(end.seconds).times(-1)
                elif end is not None and value.number != 0:
                    raise Refused(
                        one, "a time of the clock after what has no time; write a delay after the event before"
                    )
            if value.number is None or value.number > 0:
                found.append(value)
            elif not follows:
                raise Refused(one, "it comes before the event that stands before it; write events in their order")
        if len(found) > 1 and any(one.number is None for one in found):
            raise Refused(times[0], "several times of the clock, and one varies; write the later one")
        return [After(max(found, key=lambda one: one.number or 0.0).expression)] if found else []

    def _by_entity(self, who: str, one: Element) -> Expression:  # noqa: C901, PLR0911, PLR0912
        g, ego, own = self._given, Name("ego", Kind.ACTOR), Name("self", Kind.ACTOR)
        actor = ego if who == self._player.ego else own if who == self._player.name else None
        if actor is None:
            raise Refused(one, f"it is about {who[:40]!r}; a plan asks about its own actor and the ego")
        route = Name(EGO_ROUTE, Kind.PATH)
        match one.tag:
            case "TraveledDistanceCondition":
                bound = g.sum(one, "value").expression
                if actor is ego:
                    return Comparison(Call("progress", (route, ego)), ((">=", bound),))
                return Comparison(self._travelled(one), ((">=", bound),))
            case "SpeedCondition":
                if one.attributes.get("direction", "longitudinal") != "longitudinal":
                    raise Refused(one, "it asks for a speed across or upward; nobody moves so here")
                return Comparison(Call("speed", (actor,)), ((self._rule(one), g.sum(one, "value").expression),))
            case "StandStillCondition":
                if g.number(one, "duration", "0") > 0.0:
                    raise Refused(one, "it waits for a stand with a duration; write a SpeedCondition and a delay")
                return Comparison(Call("speed", (actor,)), (("<", Number(STANDS)),))
            case "RelativeDistanceCondition":
                if self._other(one) not in (self._player.ego, self._player.name) or self._other(one) == who:
                    raise Refused(one, "it asks for the distance to a third; a plan asks for that to the ego")
                return Comparison(self._apart(one), ((self._rule(one), self._room(one)),))
            case "TimeHeadwayCondition":
                if actor is not ego or self._other(one) != self._player.name or g.flag(one, "freespace"):
                    raise Refused(one, "it asks for another headway than that of the ego to this actor")
                time = Arithmetic("*", g.sum(one, "value").expression, Call("speed", (ego,)))
                return Comparison(Call("headway", (route, ego, own)), ((self._rule(one), time),))
            case "TimeToCollisionCondition":
                return self._soon(actor, one)
            case "DistanceCondition" | "ReachPositionCondition":
                position = one.find("Position")
                if g.flag(one, "freespace"):
                    raise Refused(one, 'it asks for the free space to a place; write freespace="false"')
                if position is None or actor is not ego:
                    raise Refused(one, "it asks how far somebody is from a place; a plan asks that of the ego")
                left = Call("distanceLeft", (route, ego, self._player.ego_at(position).expression))
                far = g.sum(one, "tolerance" if one.tag.startswith("Reach") else "value").expression
                rule = "<" if one.tag.startswith("Reach") else self._rule(one)
                return Comparison(Call("abs", (left,)), ((rule, far),))
            case _:
                raise Refused(
                    one, "it is not known here; write TraveledDistance, RelativeDistance, Speed or StandStill"
                )

    def _soon(self, actor: Name, one: Element) -> Expression:
        """How long the ego needs to a place."""
        position, ego = one.find("TimeToCollisionConditionTarget", "Position"), Name("ego", Kind.ACTOR)
        if one.find("TimeToCollisionConditionTarget", "EntityRef") is not None:
            return self._closing(actor, one)
        if position is None or actor != ego or self._given.flag(one, "freespace"):
            raise Refused(one, "it asks how long another than the ego needs to a place")
        self._given.note(one, "the time is what the ego needs at the speed that it wants")
        place = self._player.ego_at(position).expression
        seconds = Call("secondsTo", (Name(EGO_ROUTE, Kind.PATH), ego, place))
        return Comparison(seconds, ((self._rule(one), self._given.sum(one, "value").expression),))

    def _closing(self, actor: Name, one: Element) -> Expression:
        """How long the ego and this actor need to each other, who come toward each other."""
        ego, own = Name("ego", Kind.ACTOR), Name("self", Kind.ACTOR)
        other = one.find("TimeToCollisionConditionTarget", "EntityRef")
        whom = {ego: self._player.name, own: self._player.ego}[actor]
        if other is None or self._other(other) != whom or self._given.flag(one, "freespace"):
            raise Refused(one, "it asks for another time to a collision than that of this actor with the ego")
        if not self._player.toward:
            raise Refused(one, "a plan has a time to collision only for two that come straight toward each other")
        self._given.note(one, "it is read as the time to collision of two that come straight toward each other")
        speeds = Arithmetic("+", Call("speed", (own,)), Call("speed", (ego,)))
        bound = Arithmetic("*", speeds, self._given.sum(one, "value").expression)
        return Comparison(Call("gap", (own, ego)), ((self._rule(one), bound),))

    def _other(self, one: Element) -> str:
        return self._given.text(one, "entityRef")

    def _rule(self, one: Element) -> Relation:
        rule = self._given.text(one, "rule")
        if rule not in _RULES:
            raise Refused(one, f"the rule {rule[:40]!r} is not known")
        if _RULES[rule] in ("==", "!="):
            raise Refused(
                one, f"the rule {rule} can miss a measured value between two steps; write lessThan or greaterThan"
            )
        return _RULES[rule]

    def _apart(self, one: Element) -> Expression:
        ego, own, route = Name("ego", Kind.ACTOR), Name("self", Kind.ACTOR), Name(EGO_ROUTE, Kind.PATH)
        kind = self._given.text(one, "relativeDistanceType")
        if kind in ("cartesianDistance", "euclidianDistance"):
            return Call("gap", (own, ego))
        if kind == "longitudinal":
            return Call("abs", (Call("headway", (route, ego, own)),))
        return Call("abs", (Call("offsetFrom", (route, own)),))

    def _room(self, one: Element) -> Expression:
        """How far apart centres are; with `freespace`, that and half of both bodies."""
        value = self._given.sum(one, "value").expression
        if not self._given.flag(one, "freespace"):
            return value
        if self._given.text(one, "relativeDistanceType") != "longitudinal":
            raise Refused(one, 'it asks for free space that is not a distance along the road; write freespace="false"')
        lengths = (Call("length", (Name(name, Kind.ACTOR),)) for name in ("ego", "self"))
        return Arithmetic("+", value, Arithmetic("/", Arithmetic("+", *lengths), Number(2)))

    def _travelled(self, one: Element) -> Expression:
        if self._state.way not in (AHEAD, self._player.way, None):
            raise Refused(one, "it asks how far somebody has driven who has left his line")
        self._state.measured = True
        progress = Call("progress", (Name(self._player.measured_on, Kind.PATH), Name("self", Kind.ACTOR)))
        return Arithmetic("-", progress, Name(START, Kind.NUMBER))


def _terms(condition: Expression) -> tuple[Expression, ...]:
    return condition.terms if isinstance(condition, Boolean) and condition.operator == "and" else (condition,)


def _sum(expression: Expression) -> Sum:
    found = sum_of(expression)
    assert found is not None
    return found
