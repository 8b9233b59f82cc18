"""Plays a story: which of its parts go on, and what everybody does meanwhile."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import product
from typing import Any
from weakref import WeakKeyDictionary

from scenic.core.simulators import Action

from chatscene.world.story.conditions import truth_of
from chatscene.world.story.entities import Bounds, Entity
from chatscene.world.story.pace import SHORT, Pace, Steady, Waits, lasts, pace_of
from chatscene.world.story.places import AWAY, Place, place_of
from chatscene.world.story.ways import Way, way_of

_STOPPING = frozenset(("overwrite", "override"))
_FINE = 0.01  # [s] at most between two looks at what is due, where an ego under test drives
_FINEST = 0.001  # [s] the same where everybody is led: who brakes from 30 m/s stands within 0.03 m of its place


@dataclass(slots=True, eq=False)
class Part:
    """A part of a story that begins and ends: an act, a group, a maneuver, an event or an action.

    Attributes:
        kind: Which of these.
        name: As the story calls it.
        above: The part that it belongs to.
        running: Whether it goes on.
        count: How often it has begun.
        began: When it last began, by steps; -1 for never.
        ended: When it last ended.
        stopped: Whether something else ended it then.
        most: How often it may begin.
    """

    kind: str
    name: str
    above: Part | None = None
    running: bool = False
    count: int = 0
    began: int = -1
    ended: int = -1
    stopped: bool = False
    most: int = 1

    @property
    def complete(self) -> bool:
        """Whether it is over and does not begin again."""
        return not self.running and self.count >= self.most

    @property
    def path(self) -> str:
        """Its name, with those of what it belongs to before it."""
        return self.name if self.above is None else f"{self.above.path}::{self.name}"


class Trigger:
    """Groups of conditions, of which one must hold in all its parts."""

    def __init__(self, told: Any, story: Story, *, empty: bool) -> None:
        self._empty = empty if told is None else None
        self._story = story
        self._groups = [[_Condition(one, story) for one in group] for group in told or ()]

    def forgets(self) -> None:
        """Begin anew: nothing was asked before."""
        for condition in (one for group in self._groups for one in group):
            condition.forgets()

    def holds(self) -> bool:
        """Whether it holds now; to be asked once in each step in which it counts."""
        if self._empty is not None:
            return self._empty
        asked = [[one.holds() for one in group] for group in self._groups]
        return any(all(group) for group in asked if group)


class _Condition:
    def __init__(self, told: tuple[Any, ...], story: Story) -> None:
        self._edge, self._delay, *what = told
        self._what, self._story = tuple(what), story
        self.forgets()

    def forgets(self) -> None:
        self._truth = truth_of(self._what, self._story)  # which knows what was measured before
        self._before: bool | None = None
        self._since: list[tuple[float, bool]] = []

    def holds(self) -> bool:
        now = self._truth()
        before, self._before = self._before, now
        rises, falls = before is False and now, before is True and not now
        met = {"rising": rises, "falling": falls, "risingOrFalling": rises or falls}.get(self._edge, now)
        if not self._delay:
            return met
        self._since.append((self._story.time + self._delay, met))
        met = False
        while self._since and self._since[0][0] <= self._story.time + 1e-9:
            met = self._since.pop(0)[1] or met
        return met


@dataclass(slots=True, eq=False)
class _Action(Part):
    told: tuple[Any, ...] = ()
    modes: list[Pace | Way] = field(default_factory=list["Pace | Way"])


@dataclass(slots=True, eq=False)
class _Event(Part):
    priority: str = "parallel"
    start: Any = None
    actions: list[_Action] = field(default_factory=list[_Action])
    actors: tuple[str, ...] = ()
    maneuver: Part | None = None


@dataclass(slots=True, eq=False)
class _Act(Part):
    start: Any = None
    stop: Any = None
    events: list[_Event] = field(default_factory=list[_Event])
    groups: list[Part] = field(default_factory=list[Part])
    maneuvers: list[Part] = field(default_factory=list[Part])


class Story:
    """A story over the bodies of one drive.

    Args:
        simulation: The drive.
        names: What its objects are called, in their order, and how far their centres lie before their origins [m].
        acts: What it has happen.
        stop: When it is over.
        variables: What its variables are at first.

    Attributes:
        time: [s] since the beginning.
        variables: What its variables are now.
        over: Whether its end has come.
    """

    def __init__(self, simulation: Any, names: Any, acts: Any, stop: Any, variables: Any) -> None:
        self._simulation = simulation
        self.time, self._step, self._tick, self.over = 0.0, -1, -1, False
        self.variables: dict[str, Any] = dict(variables)
        network = simulation.scene.workspace.network
        ego, *others = simulation.objects
        led = ego.behavior is not None
        self._fine = _FINEST if led else _FINE
        self._entities: dict[str, Entity] = {}
        for (name, ahead, *bounds), agent in zip(names, (ego, *others), strict=True):
            one = Entity(agent, name, ahead, network, led=led or agent is not ego, bounds=Bounds(*bounds))
            self._entities[name] = one
        self._movers = {name: Mover(one, self) for name, one in self._entities.items()}
        self._parts: list[Part] = []
        self._acts = [self._act(act) for act in acts]
        self._stop = Trigger(stop, self, empty=False)

    # What conditions ask

    def entity(self, name: str) -> Entity:
        """Somebody by name."""
        return self._entities[name]

    def place(self, told: tuple[Any, ...]) -> Place:
        """A place."""
        return place_of(told, self.entity)

    def is_in(self, kind: str, name: str, state: str) -> bool:
        """Whether a part of the story is in a state, or came into it in this step or the one before."""
        found = [p for p in self._parts if p.kind == kind and f"::{p.path}".endswith(f"::{name}")]
        match state:
            case "runningState":
                return any(one.running for one in found)
            case "completeState":
                return any(one.complete for one in found)
            case "standbyState":
                return any(not one.running and not one.complete for one in found)
            case "startTransition":
                return any(0 <= self._tick - one.began <= 1 and one.count for one in found)
            case "endTransition" | "stopTransition":
                just = [p for p in found if 0 <= self._tick - p.ended <= 1 and p.ended >= 0]
                return any(one.stopped is (state == "stopTransition") for one in just)
            case _:
                raise ValueError(f"a part of a story has no state {state!r}")

    # What is told

    def _act(self, told: Any) -> _Act:
        name, start, stop, groups = told
        act = self._known(_Act("act", name))
        act.start, act.stop = Trigger(start, self, empty=True), Trigger(stop, self, empty=False)
        for called, most, actors, events in groups:
            group = self._known(Part("maneuverGroup", called, act, most=max(int(most), 1)))
            act.groups.append(group)
            maneuvers: dict[str, Part] = {}
            for maneuver, event, priority, count, begins, actions in events:
                if maneuver not in maneuvers:
                    maneuvers[maneuver] = self._known(Part("maneuver", maneuver, group))
                    act.maneuvers.append(maneuvers[maneuver])
                one = self._known(_Event("event", event, maneuvers[maneuver], most=int(count)))
                one.priority, one.actors, one.maneuver = priority, actors, maneuvers[maneuver]
                one.start = Trigger(begins, self, empty=True)
                one.actions = [self._known(_Action("action", a[0], one, most=1, told=tuple(a[1:]))) for a in actions]
                act.events.append(one)
        return act

    def _known(self, part: Any) -> Any:
        self._parts.append(part)
        return part

    # What goes on

    def advance(self) -> None:
        """Let what is due begin and end, and everybody move who is led: all that happens in a step of the drive."""
        step = self._simulation.currentTime
        if step == self._step:
            return
        dt = self._simulation.timestep
        for one in self._entities.values():
            if not one.led:
                one.sees()
                if step:
                    one.passes(dt)
        self._step, parts = step, max(math.ceil(dt / self._fine - 1e-9), 1)
        for part in range(parts):
            self.time, self._tick = (step + part / parts) * dt, self._tick + 1
            for act in self._acts:
                self._run(act)
            self.over = self.over or self._stop.holds()
            for mover in self._movers.values():
                mover.moves(dt / parts)
        for one in self._entities.values():
            if one.led:
                one.agent.lead(*one.pose)

    def _run(self, act: _Act) -> None:
        if act.complete:
            return
        if not act.running:
            if not act.start.holds():
                return
            self._begin(act)
            for below in (*act.groups, *act.maneuvers):
                self._begin(below)
        if act.stop.holds():
            for event in act.events:
                self._halt(event)
                event.count = event.most
            self._end_all(act, stopped=True)
            return
        for event in act.events:
            self._follow(event, act)
        for group in act.groups:
            self._again(group, act)
        if all(event.complete for event in act.events):
            self._end_all(act)

    def _follow(self, event: _Event, act: _Act) -> None:
        """Let an event begin, or end once its actions are done."""
        if event.running:
            for action in event.actions:
                if action.running and all(_over(mode) for mode in action.modes):
                    self._end(action)
            if not any(action.running for action in event.actions):
                self._end(event)
        elif not event.complete and event.start.holds():
            self._start(event, act)
        maneuver = event.maneuver
        whole = [one for one in act.events if one.maneuver is maneuver]
        if maneuver is not None and maneuver.running and all(one.complete for one in whole):
            self._end(maneuver)

    def _again(self, group: Part, act: _Act) -> None:
        """End a group whose events are over, and let it begin anew if it may."""
        own = [one for one in act.events if one.maneuver is not None and one.maneuver.above is group]
        if not (group.running and own and all(one.complete for one in own)):
            return
        self._end(group)
        if group.count < group.most:
            self._begin(group)
            for maneuver in (one for one in act.maneuvers if one.above is group):
                self._begin(maneuver)
            for event in own:
                event.count = 0
                event.start.forgets()

    def _start(self, event: _Event, act: _Act) -> None:
        """Let an event begin whose trigger holds, and what it overwrites end."""
        others = [one for one in act.events if one.maneuver is event.maneuver and one.running]
        if event.priority == "skip" and others:
            return
        if event.priority in _STOPPING:
            for one in others:
                self._halt(one)
        self._begin(event)
        for action in event.actions:
            self._begin(action)
            action.count = 1
            action.modes = list(self._done(action.told, event.actors))
            if not action.modes:
                self._end(action)

    def _done(self, told: tuple[Any, ...], actors: tuple[str, ...]) -> Iterator[Pace | Way]:
        """Do something, and give what of it takes time."""
        match told:
            case ("set", name, value):
                self.variables[name] = value
            case ("add" | "multiply" as how, name, value):
                before = float(self.variables.get(name, 0.0))
                self.variables[name] = before + value if how == "add" else before * value
            case ("nothing",):
                pass
            case ("away", whom):
                self._movers[whom].leave()
            case ("come", whom, place):
                self._movers[whom].jump(*self.place(place).pose())
            case ("jump", place):
                for name in actors:
                    self._movers[name].jump(*self.place(place).pose())
            case ("wait", seconds):
                yield Waits(self, seconds)
            case _:
                for name in actors:
                    yield self._movers[name].told(told)

    def _begin(self, part: Part) -> None:
        part.running, part.began = True, self._tick
        part.count += 1

    def _end(self, part: Part, *, stopped: bool = False) -> None:
        part.running, part.ended, part.stopped = False, self._tick, stopped

    def _end_all(self, act: _Act, *, stopped: bool = False) -> None:
        for part in (*act.groups, *act.maneuvers, act):
            if part.running:
                self._end(part, stopped=stopped)

    def _halt(self, event: _Event) -> None:
        if event.running:
            for action in (one for one in event.actions if one.running):
                self._end(action, stopped=True)
                for name, mode in product(event.actors, action.modes):
                    self._movers[name].stops(mode)
            self._end(event, stopped=True)


def _over(mode: Pace | Way) -> bool:
    return mode.passes() if isinstance(mode, Waits) else mode.done


class Mover:
    """Moves one of a story, by what it was told last about its speed and about its way.

    Whatever is told in the place of something ends that, so that nobody waits for it any longer. Who is driven by
    something else does nothing that is told, and it takes as long as is told.
    """

    def __init__(self, who: Entity, story: Story) -> None:
        self._who, self._story = who, story
        self._pace: Pace = Steady(who.speed)
        self._way = Way(who, who.line)

    def told(self, what: tuple[Any, ...]) -> Pace | Way:
        """Begin to do something.

        Raises:
            ValueError: Nobody in a story does that.
        """
        if not self._who.led:
            seconds = lasts(what)
            return Waits(self._story, SHORT if seconds is None else abs(seconds))
        pace = pace_of(what, self._who, self._story)
        if pace is not None:
            if self._way.timed:  # what tells speeds with its line, is over with either
                self._way.done = True
                self._way = self._way.untimed()
            self._paces(pace)
            return pace
        way = way_of(what, self._who, self._story)
        if way is None:
            raise ValueError(f"a story has nothing that is done as {what[0]!r}")
        self._goes(way)
        return way

    def _paces(self, pace: Pace) -> None:
        self._pace.done = True
        self._pace = pace
        self._who.speed = pace.speed(0.0)

    def _goes(self, way: Way) -> None:
        if way.timed or self._way.timed:
            self._paces(Steady(self._who.speed))
        self._way.done = True
        self._way, self._who.line = way, way.line

    def stops(self, mode: Pace | Way) -> None:
        """Leave off what goes on: keep the speed, and the distance from the line, as they are now."""
        if mode.done:
            return
        if mode is self._pace:
            self._paces(Steady(self._who.speed))
        elif mode is self._way and self._way.ends:
            self._along_its_lane()
        elif mode is self._way:
            self._goes(self._way.steady())

    def _along_its_lane(self) -> None:
        self._who.line = self._who.own_line()
        self._goes(Way(self._who, self._who.line))

    def jump(self, x: float, y: float, heading: float) -> None:
        """Be somewhere else at once, and go on along the lane there."""
        if self._who.led:
            self._who.put(x, y, heading, self._who.speed)
            self._along_its_lane()

    def leave(self) -> None:
        """Be gone: far from everything, standing."""
        if not self._who.led:
            return
        x, y, heading = self._who.origin
        self._paces(Steady(0.0))
        self._who.put(x + AWAY, y + AWAY, heading, 0.0)
        self._along_its_lane()

    def moves(self, dt: float) -> None:
        """Be moved for a time [s], if the story leads it."""
        who = self._who
        if not who.led:
            return
        before, table = who.speed, self._way.speed()
        speed = self._pace.speed(dt) if table is None else table
        gone, way = (before + speed) / 2.0 * dt, self._way
        way.at += self._pace.jump  # which is along the line, whatever somebody does beside it
        self._pace.jump = 0.0
        who.put(*way.goes(gone, dt), speed)
        if way.ends and way.done:
            self._along_its_lane()
            if way.over > 0.0 and not way.timed:
                who.put(*self._way.goes(way.over, dt), speed)
        elif way.over > 0.0 and not way.ends:
            self._goes_on(way)
        who.passes(dt)

    def _goes_on(self, way: Way) -> None:
        """Go on by the lanes to which a line leads that is over; where there are none, somebody stands at its end."""
        who = self._who
        line = who.onward_line(way.line)
        if line is None:
            self._paces(Steady(0.0))
            who.put(*way.goes(-way.over, 0.0), 0.0)
        else:
            way.goes_on_along(line)
            who.line = way.line


_stories: WeakKeyDictionary[Any, Story] = WeakKeyDictionary()


def storyOf(simulation: Any, names: Any, acts: Any, stop: Any, variables: Any) -> Story:  # noqa: N802 - Scenic's naming
    """The story of a drive, which begins with it; the same for all who play it."""
    if simulation not in _stories:
        _stories[simulation] = Story(simulation, names, acts, stop, variables)
    return _stories[simulation]


class StoryAction(Action):
    """Let the story of the drive go on by a step."""

    def applyTo(self, agent: Any, simulation: Any) -> None:  # noqa: N802, ARG002 - Scenic's name
        """Move everybody whom it leads."""
        _stories[simulation].advance()
