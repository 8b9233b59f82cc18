"""A scenario of OpenSCENARIO XML as a story that is played event by event."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

from chatscene.imports.cast import Cast, text_or_number
from chatscene.imports.environment import surroundings_of
from chatscene.imports.given import REFERENCE, Given, Refused
from chatscene.imports.names import Names
from chatscene.imports.opening import COMMAND, EGO_DOES, Opening
from chatscene.imports.story_actions import StoryActions
from chatscene.imports.story_conditions import DEPTHS, StoryConditions
from chatscene.imports.stranger_xml import Element
from chatscene.imports.written_story import Line, Member, StoryProgram, Told
from chatscene.situations.phrases import one_seen
from chatscene.terms.actors import BY_CLASS, LIMITS
from chatscene.terms.plan import Expression, Parameter, walk
from chatscene.terms.storyboard import EGO_ROUTE, THING
from chatscene.terms.sums import valued
from chatscene.terms.surroundings import Surroundings
from chatscene.world.story.pace import SHORT, lasts
from chatscene.world.story.places import AWAY

_BACKS = 3.0  # [m/s] at which a body begins backwards at most, and an ego under test with it
_ITS_ROUTE: Told = ("", "way", Line(EGO_ROUTE))  # what the ego's route of Init is to its story
_MOST_TIMES = 1_000  # that a group or an event happens


class StoryReader(Opening):
    """Reads a story; arguments are those of an `Opening`.

    Attributes:
        untold: Why the ego cannot do what the file says, each with its line.
    """

    def __init__(self, root: Element, given: Given, map_path: Path, ego: str | None) -> None:
        super().__init__(root, given, map_path, ego)
        self.untold: list[str] = []
        self._begins = set[str]()
        self._told_first: dict[str, float] = {}  # speeds [m/s], whatever a body begins at
        self._tested = ""

    def program(self) -> StoryProgram | None:
        """The story; None where the ego is not known. What else is refused, is among the refusals."""
        ego = self._attempt(self._entities.ego)
        self._tested = ego or ""
        host = None if ego is None else self._attempt(lambda: self._host(ego))
        if ego is None or host is None:
            return None
        x, y, heading = self._pose_of(host.start)
        ahead = self._entities.body(self._objects[ego])[3]
        first = Member(
            name="ego", kind=host.kind, length=host.length, width=host.width, x=x, y=y, heading=heading, ahead=ahead,
            speed=self._wanted(ego, host.speed), acts=False, bounds=self._entities.bounds(self._objects[ego]),
        )  # fmt: skip
        called = Names({ego: "ego"})
        others, unread = self._others(ego, called)
        cast = Cast(
            given=self._given,
            positions=self._positions,
            ego=ego,
            names={ego: "ego", **{name: called.of(name) for name in (*others, *unread)}},
            entities=self._entities,
            route_of=self._line_of_route,
            mirrored=self._side < 0,
            called=called,
            refs=self._refs(),
            texts=frozenset(self._texts()),
            parts=frozenset(self._parts(self.storyboard, ())),
        )
        variables: dict[str, Any] = {}
        story = _Story(self, cast, variables)
        told_first = {ego: first, **others}
        acts = (
            *self._sets_first(cast),
            *self._at_first(cast, told_first, self._begins_at(ego, host.speed)),
            *story.acts(),
        )
        stop = self._attempt(story.stop)
        fast = {name for name in others if self._told_first.get(name)}
        acting = story.acting | self._begins | fast
        drives = not self.untold and (ego in acting or ego in self._told_first)
        members = [
            replace(first, acts=drives),
            *(self._acting(one, name in acting, name) for name, one in others.items()),
        ]
        surroundings = self._attempt(lambda: surroundings_of(self._actions(), self._given)) or Surroundings()
        if not any(one.acts for one in members[1:]):
            self._given.note(self._root, "only the ego acts; everybody else stands")
        if stop is not None and len(members) == 1:
            self._given.note(self._root, "there is only the ego, so the drive ends as usual, not as the file says")
        read = {part.name for told in (acts, stop) for part in _parameters(told)}
        return StoryProgram(
            members=tuple(members),
            route=self._lines[EGO_ROUTE],
            lines=cast.lines,
            acts=acts,
            stop=stop,
            variables=tuple(sorted(variables.items())),
            parameters=tuple(sorted((r for r in self._given.ranges.values() if r.name in read), key=lambda r: r.name)),
            surroundings=surroundings,
        )

    def _wanted(self, ego: str, speed: float) -> float:
        """The speed that the ego wants: its first, or the first that its events bring it to."""
        if speed:
            return speed
        for target in self._targets(ego):
            value = self._attempt(lambda target=target: self._given.number(target, "value"))
            if value:
                self._given.note(target, f"the ego is to drive {value:g} m/s from the beginning")
                return value
        return speed

    def _targets(self, ego: str) -> Iterator[Element]:
        storyboard = self._root.find("Storyboard")
        for group in storyboard.walk() if storyboard is not None else ():
            refs = [ref for one in group.all("Actors") for ref in one.all("EntityRef")]
            if group.tag == "ManeuverGroup" and any(ref.attributes.get("entityRef") == ego for ref in refs):
                yield from (one for one in group.walk() if one.tag == "AbsoluteTargetSpeed")

    def _refs(self) -> frozenset[str]:
        asked = [one for one in self._root.walk() if one.tag == "StoryboardElementStateCondition"]
        texts = [one.attributes.get("storyboardElementRef", "") for one in asked]
        named = [self._given.values.get(one[1], "") if (one := REFERENCE.fullmatch(text)) else text for text in texts]
        return frozenset(part for text in named for part in text.split("::"))

    def _texts(self) -> Iterator[str]:
        """The parameters and variables that are set to a text."""
        for one in (one for one in self._root.walk() if one.tag in ("ParameterAction", "VariableAction")):
            to, name = one.find("SetAction"), next((v for k, v in one.attributes.items() if k.endswith("Ref")), "")
            if to is not None and isinstance(text_or_number(self._given.text(to, "value")), str):
                yield name

    def _parts(self, one: Element, above: tuple[str, ...]) -> Iterator[tuple[str, tuple[str, ...]]]:
        """The type of each part of the story, with each end of the path of names to it."""
        for below in one.inside:
            kind = below.tag[:1].lower() + below.tag[1:]
            if kind == "story" or (len(above) + 1 == DEPTHS.get(kind)):
                path = (*above, below.attributes.get("name", ""))
                yield from ((kind, path[i:]) for i in range(len(path)))
                yield from self._parts(below, path)

    # Who is where

    def _others(self, ego: str, called: Names) -> tuple[dict[str, Member], list[str]]:
        """Everybody but the ego, and the names of those who are refused.

        Whoever is put beside somebody else comes after that one.
        """
        waiting, left = [name for name in self._objects if name != ego], list[str]()
        found: dict[str, Member] = {}
        refused: dict[str, Refused] = {}
        while waiting:
            left = []
            for name in waiting:
                try:
                    member = self._member(name, called)
                    if member is not None:
                        found[name] = member
                except Refused as reason:
                    refused[name] = reason
                    left.append(name)
            if len(left) == len(waiting):
                self._given.refusals += [str(refused[name]) for name in left]
                break
            waiting = left
        return {name: found[name] for name in self._objects if name in found}, left

    def _acting(self, one: Member, acts: bool, name: str) -> Member:
        """Somebody who does something, or nothing; a thing that does something is of a class that moves."""
        kind = self._entities.moving(self._objects[name]) if acts and one.kind == THING else one.kind
        return replace(one, acts=acts, kind=kind)

    def _member(self, name: str, called: Names) -> Member | None:
        one = self._objects[name]
        kind, length, width, ahead = self._entities.body(one)
        away = 0.0
        if not self._placed_first(name):
            added = self._added_later(name)
            if added is None and self._inits.get(name):
                raise Refused(one, "its first position is not given; add a TeleportAction in Init")
            if added is None:
                self._given.note(one, f"{name[:40]} is never put anywhere, so it is not there")
                return None
            x, y, heading = self._positions.pose(added)
            away = AWAY
        else:
            x, y, heading = self._origin(name, one)
        self._positions.known[name] = (x, y, heading)
        speed = self._first_speed(name, kind)
        return Member(
            name=called.of(name), kind=kind, length=length, width=width,
            x=x + ahead * math.cos(heading) + away, y=y + ahead * math.sin(heading) + away, heading=heading,
            ahead=ahead, speed=speed, acts=False, bounds=self._entities.bounds(one),
        )  # fmt: skip

    def _added_later(self, name: str) -> Element | None:
        for one in self._root.walk():
            if one.tag == "EntityAction" and one.attributes.get("entityRef") == name:
                position = one.find("AddEntityAction", "Position")
                if position is not None:
                    return position
        return None

    def _speed(self, name: str) -> float:
        """How fast somebody is at first [m/s]."""
        return self._first_speed(name, self._entities.body(self._objects[name])[0])

    def _first_speed(self, name: str, kind: str) -> float:
        """How fast somebody is at first [m/s]."""
        for action in self._inits.get(name, []):
            speed = action.find("SpeedAction") if action.tag == "LongitudinalAction" else None
            if speed is None or self._is_gradual(speed):
                continue
            absolute = speed.find("SpeedActionTarget", "AbsoluteTargetSpeed")
            relative = speed.find("SpeedActionTarget", "RelativeTargetSpeed")
            if absolute is not None:
                value = self._given.number(absolute, "value")
            elif relative is not None:
                other = self._speed_told(self._given.text(relative, "entityRef"))
                told = self._given.number(relative, "value")
                value = (
                    other * told
                    if self._given.text(relative, "speedTargetValueType", "delta") == "factor"
                    else other + told
                )
            else:
                raise Refused(speed, "it has no target")
            if not _moves(kind):  # which is moved by the story, not by what it can
                self._told_first[name] = value
                return 0.0
            top = LIMITS[kind].top_speed
            self._told_first[name] = min(max(value, -top), top)
            kept = max(self._told_first[name], -_BACKS)
            if kept != value and (value > 0.0 or name == self._tested):
                self._given.note(action, f"{one_seen(kind)} goes at {kept:g} m/s at most, where it says {value:g} m/s")
            return kept
        return 0.0

    def _speed_told(self, name: str) -> float:
        for action in self._inits.get(name, []):
            target = action.find("SpeedAction", "SpeedActionTarget", "AbsoluteTargetSpeed")
            if target is not None:
                return self._given.number(target, "value")
        return 0.0

    def _sets_first(self, cast: Cast) -> Iterator[Told]:
        """What Init makes of parameters and variables, at once."""
        actions = StoryActions(cast)
        does = [partial(actions.of_world, one) for one in self.setting()]
        told: list[Told] = [("", *found) for one in does if (found := self._attempt(one)) is not None]
        if told:
            yield ("", None, None, (("", 1, (), (("", "", "parallel", 1, None, tuple(told)),)),))

    def _at_first(self, cast: Cast, members: dict[str, Member], speed: float) -> Iterator[Told]:
        """What everybody begins to do at once, beyond having a place and a speed."""
        actions = StoryActions(cast)
        groups: list[Told] = []
        for name, member in members.items():
            told = [found for action in self._inits.get(name, []) for found in self._begun(name, action, cast, actions)]
            if any(one != _ITS_ROUTE for one in told):
                self._begins.add(name)
            begins = speed if name == cast.ego else self._told_first.get(name, member.speed)
            if member.speed != begins:
                told.insert(0, ("", "speed", "step", "time", 0.0, ("to", begins)))
            if told:
                event: Told = ("", "", "parallel", 1, None, tuple(told))
                groups.append(("", 1, (member.name,), (event,)))
        if groups:
            yield ("", None, None, tuple(groups))

    def _begun(self, name: str, action: Element, cast: Cast, actions: StoryActions) -> Iterator[Told]:
        """What somebody is told by an action of Init, beyond a place and a speed."""
        if self._only_speed(action) or (action.tag == "TeleportAction" and self._puts_first(name, action)):
            return
        if self._is_its_route(name, cast, action):
            yield _ITS_ROUTE
            return
        does = partial(actions.of, name, action, at_first=True)
        found = self.of_ego(does) if name == cast.ego else self._attempt(does)
        if found is not None and found != ("nothing",):
            yield ("", *found)

    def _is_its_route(self, name: str, cast: Cast, action: Element) -> bool:
        """Whether an action of Init gives the ego its route, which it has."""
        return name == cast.ego and action.find("FollowTrajectoryAction") is None and action.tag == "RoutingAction"

    def of_ego(self, does: Callable[[], Told]) -> Told | None:
        """What the ego is told; None where that cannot be said, so that it is not driven as written."""
        try:
            return does()
        except Refused as reason:
            self.untold.append(str(reason))
            return None

    def _only_speed(self, action: Element) -> bool:
        """Whether an action of Init is told by a speed at first."""
        speed = action.find("SpeedAction") if action.tag == "LongitudinalAction" else None
        relative = speed.find("SpeedActionTarget", "RelativeTargetSpeed") if speed is not None else None
        return (
            speed is not None
            and not self._is_gradual(speed)
            and (relative is None or not self._given.flag(relative, "continuous"))
        )

    def _is_gradual(self, speed: Element) -> bool:
        """Whether a speed is not there at once."""
        dynamics = speed.find("SpeedActionDynamics")
        return (
            dynamics is not None
            and self._given.text(dynamics, "dynamicsShape", "step") != "step"
            and "value" in dynamics.attributes
            and self._given.sum(dynamics, "value").number != 0
        )

    def _begins_at(self, ego: str, speed: float) -> float:
        """How fast the ego is at first [m/s], of which a speed is told."""
        told = [action.find("SpeedAction") for action in self._inits.get(ego, [])]
        gradual = any(one is not None and self._is_gradual(one) for one in told)
        return 0.0 if gradual else self._told_first.get(ego, speed)

    # What the story reader asks

    def attempt(self, does: Any) -> Any:
        """What something gives; None where it is refused."""
        return self._attempt(does)

    @property
    def storyboard(self) -> Element:
        """What happens."""
        found = self._root.find("Storyboard")
        assert found is not None
        return found

    @property
    def whole(self) -> Element:
        """The file."""
        return self._root


class _Story:
    """Reads acts and the end."""

    def __init__(self, opening: StoryReader, cast: Cast, variables: dict[str, Any]) -> None:
        self._opening, self._cast, self._given = opening, cast, cast.given
        tags = ("ParameterAction", "VariableAction", "ParameterSetAction", "VariableSetAction")
        changing = [one for one in opening.whole.walk() if one.tag in tags]
        names = {value for one in changing for key, value in one.attributes.items() if key.endswith("Ref")}
        for one in (v for part in opening.whole.all("VariableDeclarations") for v in part.inside):
            self._given.values.setdefault(one.attributes.get("name", ""), one.attributes.get("value", ""))
        self._actions = StoryActions(cast)
        self._conditions = StoryConditions(cast, frozenset(names), variables)
        self.acting: set[str] = set()

    def acts(self) -> Iterator[Told]:
        """Every act in which somebody does something."""
        for story in self._opening.storyboard.all("Story"):
            for act in story.all("Act"):
                found = self._opening.attempt(lambda act=act: self._act(act))
                if found is not None and found[3]:
                    yield found

    def stop(self) -> Told | None:
        """When the drive is over."""
        return self._conditions.trigger(self._opening.storyboard.find("StopTrigger"), stops=True)

    def _act(self, act: Element) -> Told:
        start = self._conditions.trigger(act.find("StartTrigger"))
        groups = [self._opening.attempt(lambda one=one: self._group(one)) for one in act.all("ManeuverGroup")]
        if start == ():
            return ("", None, None, ())  # it never begins
        stop = self._conditions.trigger(act.find("StopTrigger"), stops=True)
        return (self._cast.part(act), start, stop, tuple(group for group in groups if group is not None and group[3]))

    def _group(self, group: Element) -> Told:
        actors = group.find("Actors")
        names = self._cast.several(actors.all("EntityRef") if actors is not None else [])
        if actors is not None and self._given.flag(actors, "selectTriggeringEntities"):
            names = tuple(dict.fromkeys((*names, *self._triggering(group))))
        maneuvers = [(one, self._cast.part(one, told=len(group.all("Maneuver")) > 1)) for one in group.all("Maneuver")]
        events = [
            found
            for maneuver, called in maneuvers
            for event in maneuver.all("Event")
            if (found := self._opening.attempt(lambda e=event, m=called: self._event(e, m, names))) is not None
        ]
        return (
            self._cast.part(group),
            self._times(group),
            tuple(self._cast.names[name] for name in names),
            tuple(events),
        )

    def _triggering(self, group: Element) -> tuple[str, ...]:
        """Who triggers the events of a group, in the file, whenever they are triggered."""
        found: list[str] = []
        for asked in (one for one in group.walk() if one.tag == "TriggeringEntities"):
            names = self._cast.several(asked.all("EntityRef"))
            if len(names) > 1 and self._given.text(asked, "triggeringEntitiesRule", "any") == "any":
                raise Refused(asked, "its actors are those of several who trigger it; name them in the group")
            found += names
        return tuple(found)

    def _event(self, event: Element, maneuver: str, names: tuple[str, ...]) -> Told | None:
        start = self._conditions.trigger(event.find("StartTrigger"))
        if start == ():
            return None  # it never begins
        actions: list[Told] = [
            (self._cast.part(action), *self._does(inner, names))
            for action in event.all("Action")
            for inner in action.inside
        ]
        priority = self._given.text(event, "priority", "parallel")
        return (
            maneuver,
            self._cast.part(event),
            priority,
            self._times(event),
            start,
            tuple(actions),
        )

    def _times(self, one: Element) -> int:
        """How often a group or an event may happen."""
        times = self._given.count(one, "maximumExecutionCount", "1")
        return times if 0 < times < _MOST_TIMES else _MOST_TIMES if times else 1

    def _does(self, inner: Element, names: tuple[str, ...]) -> Told:
        if inner.tag == "GlobalAction":
            told = self._actions.of_world(inner)
            if told[0] in ("away", "come"):
                self.acting.update(name for name, called in self._cast.names.items() if called == told[1])
            return told
        if inner.tag == "UserDefinedAction":
            self._given.note(inner, COMMAND)
            return ("nothing",)
        if inner.tag != "PrivateAction" or not inner.inside:
            raise Refused(inner, "it is not an action of a road user")
        return self._done_by(inner, names)

    def _done_by(self, inner: Element, names: tuple[str, ...]) -> Told:
        """What a PrivateAction has somebody do."""
        (kind,) = inner.inside[:1]
        if not names:
            raise Refused(inner, "it has no actors; name them")
        does = partial(self._actions.of, names[0] if len(names) == 1 else None, kind)
        told = self._opening.of_ego(does) if names == (self._cast.ego,) else does()
        if self._cast.ego in names:
            self._given.note(inner, f"{EGO_DOES}; what waits for it, goes on {self._once(told)}")
        if told is None:
            return ("wait", SHORT)
        if told != ("nothing",):
            self.acting.update(names)
        return told

    def _once(self, told: Told | None) -> str:
        """When what the ego is told counts as done, where an ego under test drives (`Player`)."""
        if told is not None and told[0] in ("nothing", "jump"):
            return "at once"
        seconds = lasts(told) if told is not None else None
        if isinstance(seconds, Expression):
            seconds = valued(seconds, self._given.nominal)
        return (
            f"after {SHORT:g} s, since no time is given"
            if seconds is None
            else f"after {abs(seconds):g} s, as the file says"
        )


def _moves(kind: str) -> bool:
    return kind in LIMITS and not BY_CLASS[kind].lies and bool(LIMITS[kind].top_speed)


def _parameters(told: Any) -> Iterator[Parameter]:
    """The parameters in a part of a story."""
    if isinstance(told, tuple):
        for one in told:  # type: ignore[reportUnknownVariableType]
            yield from _parameters(one)
    elif isinstance(told, Expression):
        yield from (part for part in walk(told) if isinstance(part, Parameter))
