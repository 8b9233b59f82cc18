"""The conditions of OpenSCENARIO as those of a story (`chatscene.world.story.conditions`)."""

from __future__ import annotations

from typing import Any

from chatscene.imports.cast import Cast, text_or_number, told_number
from chatscene.imports.given import Refused
from chatscene.imports.stranger_xml import Element
from chatscene.imports.written_story import Told
from chatscene.world.story.conditions import RULES

EDGES = frozenset(["none", "rising", "falling", "risingOrFalling"])
_STATES = frozenset(
    (
        "startTransition",
        "endTransition",
        "stopTransition",
        "completeState",
        "runningState",
        "standbyState",
    )
)
DEPTHS = {"act": 2, "maneuverGroup": 3, "maneuver": 4, "event": 5, "action": 6}
"""Types of parts of a storyboard, and how many names are on the path to one, its own and that of its story included."""
_LATEST = 1e5  # [s]
_NEVER: Told = ("never",)
_ALWAYS: Told = ("always",)


class StoryConditions:
    """Reads triggers."""

    def __init__(self, cast: Cast, changing: frozenset[str], variables: dict[str, Any]) -> None:
        self._cast, self._given = cast, cast.given
        self._changing, self._variables = changing, variables

    def trigger(self, one: Element | None, *, stops: bool = False) -> Told | None:
        """A trigger: None for one that says nothing.

        Args:
            one: The element.
            stops: Whether it ends the whole, where a condition that cannot be asked is left out, and a note says so.
        """
        groups = one.all("ConditionGroup") if one is not None else []
        told = [tuple(self._condition(c, stops) for c in group.all("Condition")) for group in groups]
        kept = [group for group in told if group and not any(c[2:] == _NEVER for c in group)]
        if not any(told):
            return None
        return tuple(kept)

    def _condition(self, one: Element, stops: bool) -> Told:
        edge = self._given.text(one, "conditionEdge", "none")
        if edge not in EDGES:
            raise Refused(one, f"the edge {edge[:40]!r} is not known")
        if self._cast.mirrored and edge == "rising":
            edge = "none"  # as ScenarioRunner reads it
        try:
            what = self._what(one)
        except Refused as reason:
            if not stops:
                raise
            self._given.notes.append(f"{reason}; the end of the drive does not wait for it")
            what = _NEVER
        return (edge, self._cast.value(one, "delay", "0"), *what)

    def _what(self, one: Element) -> Told:
        by_value, by_entity = one.find("ByValueCondition"), one.find("ByEntityCondition")
        if by_value is not None and len(by_value.inside) == 1:
            return self._by_value(by_value.inside[0])
        asked = by_entity.find("EntityCondition") if by_entity is not None else None
        if by_entity is None or asked is None or len(asked.inside) != 1:
            raise Refused(one, "it says no condition")
        triggering = by_entity.find("TriggeringEntities")
        names = self._cast.several(triggering.all("EntityRef") if triggering is not None else [])
        whose = tuple(self._cast.names[name] for name in names)
        if not whose:
            self._given.note(by_entity, "none of its entities exists; this never holds")
            return _NEVER
        quantor = self._given.text(triggering, "triggeringEntitiesRule", "any") if triggering is not None else "any"
        kind, *rest = self._by_entity(asked.inside[0])
        return (kind, "all" if quantor == "all" else "any", whose, *rest)

    def _rule(self, one: Element, default: str | None = None) -> str:
        rule = self._given.text(one, "rule", default)
        if rule not in RULES:
            raise Refused(one, f"the rule {rule[:40]!r} is not known")
        return rule

    # By value

    def _by_value(self, one: Element) -> Told:
        match one.tag:
            case "SimulationTimeCondition":
                if self._beyond(one):
                    return _ALWAYS if self._rule(one, "greaterThan") in ("lessThan", "lessOrEqual") else _NEVER
                return ("time", self._rule(one, "greaterThan"), self._cast.value(one, "value"))
            case "ParameterCondition":
                return self._of_parameter(one)
            case "VariableCondition":
                name = self._given.text(one, "variableRef")
                return (
                    "value",
                    self._rule(one),
                    text_or_number(self._given.text(one, "value")),
                    self._asked(one, name),
                )
            case "StoryboardElementStateCondition":
                return self._of_part(one)
            case _:
                raise Refused(one, "this condition is not supported here; write one of time, distance, speed or events")

    def _of_part(self, one: Element) -> Told:
        state, kind = self._given.text(one, "state"), self._given.text(one, "storyboardElementType", "event")
        if state not in _STATES:
            raise Refused(one, f"the state {state[:40]!r} is not known; known are {', '.join(sorted(_STATES))}")
        if kind not in DEPTHS:
            raise Refused(one, f"the type {kind[:40]!r} is not supported; write one of {', '.join(DEPTHS)}")
        path = tuple(self._ref(one).split("::"))
        if (kind, path) not in self._cast.parts:
            self._given.note(one, f"there is no {kind} {'::'.join(path)[:60]!r}; this never holds")
            return _NEVER
        below = path[1:] if len(path) == DEPTHS[kind] else path  # without the name of the story
        return ("element", kind, "::".join(map(self._cast.called.of, below)), state)

    def _ref(self, one: Element) -> str:
        """The part of the story that a condition asks about; a name may be a text in ${…}, which stands as it is."""
        written = one.attributes.get("storyboardElementRef", "")
        return written if written.startswith("${") else self._given.text(one, "storyboardElementRef")

    def _beyond(self, one: Element) -> bool:
        """Whether a time is one that no drive comes to."""
        try:
            return float(one.attributes.get("value", "0")) > _LATEST
        except ValueError:
            return False

    def _asked(self, one: Element, name: str) -> str:
        called = self._cast.called.of(name)
        self._variables.setdefault(called, self._cast.at_first(one, name))
        return called

    def _of_parameter(self, one: Element) -> Told:
        name, rule = self._given.text(one, "parameterRef"), self._rule(one)
        if name not in self._given.values:
            self._given.note(one, f"there is no parameter {name[:40]!r}; this never holds")
            return _NEVER
        told = self._given.text(one, "value")
        if name in self._changing:
            return ("value", rule, text_or_number(told), self._asked(one, name))
        asked = Element(one.tag, {"value": f"${name}", "told": told}, one.line, file=one.file)
        try:
            now, then = self._given.sum(asked, "value"), self._given.sum(asked, "told")
        except Refused:
            holds = {"equalTo": self._given.values[name] == told, "notEqualTo": self._given.values[name] != told}
            return _ALWAYS if holds.get(rule, False) else _NEVER
        if now.number is None or then.number is None:
            return ("number", rule, told_number(now), told_number(then))
        return _ALWAYS if RULES[rule](now.number, then.number) else _NEVER

    # By entity

    def _by_entity(self, one: Element) -> Told:  # noqa: C901, PLR0911, PLR0912
        """What a condition says of each whom it is about."""
        g, cast = self._given, self._cast
        match one.tag:
            case "SpeedCondition":
                self._along(one)
                return ("speed", self._rule(one), cast.value(one, "value"))
            case "AccelerationCondition":
                self._along(one)
                return ("acceleration", self._rule(one), cast.value(one, "value"))
            case "RelativeSpeedCondition":
                axis = g.text(one, "direction", "")
                if axis not in ("", "longitudinal", "lateral"):
                    raise Refused(one, "it asks upward; nobody moves so here")
                return ("faster", self._rule(one), cast.value(one, "value"), cast.who(one), *([axis] if axis else []))
            case "TraveledDistanceCondition":
                return ("travelled", cast.value(one, "value"))
            case "StandStillCondition":
                return ("stands", cast.value(one, "duration", "0"))
            case "EndOfRoadCondition" | "OffroadCondition":
                return ("lost", cast.value(one, "duration", "0"))
            case "CollisionCondition":
                return ("touches", self._touched(one))
            case "AngleCondition":
                frame = g.text(one, "coordinateSystem", "world")
                if g.text(one, "angleType", "heading") != "heading" or frame not in ("world", "road", "lane"):
                    raise Refused(one, "only headings are supported here: on the map, to the road or to the lane")
                angle, near = cast.side * g.number(one, "angle"), g.number(one, "angleTolerance", "0.05")
                return ("turned", angle, near, *([] if frame == "world" else [frame]))
            case "ReachPositionCondition":
                return ("reaches", cast.value(one, "tolerance"), self._place(one))
            case "DistanceCondition":
                return self._between("apart", one, self._place(one))
            case "RelativeDistanceCondition":
                return self._between("apart", one, cast.who(one))
            case "TimeHeadwayCondition":
                return self._between("headway", one, cast.who(one))
            case "TimeToCollisionCondition":
                target = one.find("TimeToCollisionConditionTarget")
                whom = (target.find("EntityRef") or target.find("EntityReference")) if target is not None else None
                if target is None or (whom is None and target.find("Position") is None):
                    raise Refused(one, "it has no target")
                return self._between("collision-in", one, cast.who(whom) if whom is not None else self._place(target))
            case _:
                raise Refused(one, "this condition is not supported here; write one of distance, speed or time")

    def _along(self, one: Element) -> None:
        if self._given.text(one, "direction", "longitudinal") != "longitudinal":
            raise Refused(one, "it asks across or upward; nobody moves so here")

    def _touched(self, one: Element) -> tuple[str, ...]:
        refs, types = one.all("EntityRef"), one.all("ByType")
        names = dict.fromkeys(self._cast.several(refs))
        names |= dict.fromkeys(self._cast.there(n for t in types for n in self._cast.entities.of_type(t, "type")))
        return tuple(self._cast.names[name] for name in (names if refs or types else self._cast.names))

    def _place(self, one: Element) -> Told:
        position = one.find("Position")
        if position is None:
            raise Refused(one, "it names no place")
        return self._cast.place(position)

    def _between(self, kind: str, one: Element, other: Any) -> Told:
        g = self._given
        how = g.text(one, "relativeDistanceType", "euclidianDistance")
        frame = g.text(one, "coordinateSystem", "road" if g.flag(one, "alongRoute") else "entity")
        if "relativeDistanceType" not in one.attributes and (g.flag(one, "alongRoute") or frame != "entity"):
            how = "longitudinal"
        return (
            kind,
            self._rule(one),
            self._cast.value(one, "value"),
            other,
            how if how in ("longitudinal", "lateral") else "",
            "entity" if frame == "entity" else "road",
            g.flag(one, "freespace"),
        )
