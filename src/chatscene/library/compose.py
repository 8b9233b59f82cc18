"""Behaviors that nobody wrote: where no snippet does just what was said, the acts that were said, one after the other.

Each act has a step: what is done for it by somebody who goes along a line, or who comes from beside the road. What a
composed behavior does before its first act goes by where it starts, and its parameters by the steps that it takes.
Its id says all of this, and the behavior is composed again from the id alone: ``behavior/composed.car.ahead.brake``.
"""

from __future__ import annotations

import itertools
import operator
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from chatscene.errors import SnippetError
from chatscene.library.plan import parse_plan, print_plan
from chatscene.library.snippet_file import names_in
from chatscene.terms.actors import AdversaryKind, Manner
from chatscene.terms.acts import Action
from chatscene.terms.scenario import Component, Position, Slots
from chatscene.terms.snippet import ParameterRange, Snippet

COMPOSED = "behavior/composed."

_THERE = "-at-junction"
_STAND = "self.pose[3] < 0.05"
_OWN = "ownLane(egoRoute)"


@dataclass(frozen=True, slots=True, kw_only=True)
class Step:
    """How an act is done.

    Attributes:
        does: Phases, as Scenic writes them behind `do`; ``{path}`` is the line that one goes along, ``$NAME`` the
            parameter ``OPT_NAME``.
        last: The same where nothing is done afterwards; empty for a step that is followed by going on.
        back: What follows where cutting in was not said: it goes back to its lane all the same.
        path: The line one goes along from there on; empty for the same as before.
        stands: Whether one stands then.
        halts: Whether one comes to stand for it, so that braking before it is a part of it.
        moving: Whether it can only be done by somebody who has not stood.
        long: Whether it takes so long that it must begin at once.
        after: What must be done right before it; None for nothing.
    """

    does: tuple[str, ...]
    last: tuple[str, ...] = ()
    back: tuple[str, ...] = ()
    path: str = ""
    stands: bool = False
    halts: bool = False
    moving: bool = False
    long: bool = False
    after: Action | None = None


_BRAKES_TO_STAND = f"BrakeOnPath({{path}}, $BRAKE) until {_STAND}"
_STOP = Step(
    does=(_BRAKES_TO_STAND, "Halt() for $STOP_TIME seconds"),
    last=(_BRAKES_TO_STAND, "Halt()"),
    stands=True,
    halts=True,
)
ALONG: dict[Action, Step] = {
    Action.BRAKE: Step(
        does=("BrakeOnPath({path}, $BRAKE) for $BRAKE_TIME seconds",), last=("BrakeOnPath({path}, $BRAKE)",)
    ),
    Action.STOP: _STOP,
    Action.HESITATE: Step(
        does=(*_STOP.does, "DrivePath({path}, $ADV_SPEED) for 2 seconds"),
        last=(*_STOP.does, "DrivePath({path}, $ADV_SPEED)"),
        halts=True,
    ),
    Action.REVERSE: Step(
        does=("ReverseStraight($BACK_SPEED) for $BACK_TIME seconds",),
        last=("ReverseStraight($BACK_SPEED) for $BACK_TIME seconds", "Halt()"),
        stands=True,
        halts=True,
    ),
    Action.ACCELERATE: Step(
        does=("ThrottleOnPath({path}, $THROTTLE) for 2.5 seconds",), last=("ThrottleOnPath({path}, $THROTTLE)",)
    ),
    Action.WEAVE: Step(
        does=("WeaveOnPath({path}, $ADV_SPEED, $AMPLITUDE, 3) for 4.5 seconds",),
        last=("WeaveOnPath({path}, $ADV_SPEED, $AMPLITUDE, 3)",),
        long=True,
    ),
}
"""What somebody does who goes along a line."""

_OVERTAKE = "$OVERTAKING) until headway(egoRoute, ego, self) > $ADV_AHEAD"
_TOWARD_EGO = "-$SWERVE if offsetFrom(egoRoute, self) > 0 else $SWERVE"
_BESIDE: dict[Action, Step] = {
    **ALONG,
    Action.CUT_IN: Step(does=(f"DrivePath({_OWN}, $ADV_SPEED) until abs(offsetFrom({_OWN}, self)) < 1",), path=_OWN),
    Action.PACE: Step(
        does=("PaceOnPath({path}, ego, $ADV_AHEAD, 16, 2.5) for $PACE_TIME seconds",),
        last=("PaceOnPath({path}, ego, $ADV_AHEAD, 16, 2.5)",),
        moving=True,
    ),
    Action.SWERVE: Step(does=(f"SwerveOnPath({{path}}, $ADV_SPEED, {_TOWARD_EGO}) for $SWERVE_TIME seconds",)),
}


def _without(steps: dict[Action, Step], one: Action) -> dict[Action, Step]:
    return {action: step for action, step in steps.items() if action is not one}


_COMES = "MoveAhead($ADV_SPEED)"
ACROSS: dict[Action, Step] = {
    Action.CROSS: Step(does=(f"{_COMES} until abs(offsetFrom(egoRoute, self)) < 2.5",), last=(_COMES,)),
    Action.STOP: Step(
        does=("Halt() until self.pose[3] < 0.1", "Halt() for $STOP_TIME seconds"),
        last=("Halt()",),
        stands=True,
        halts=True,
    ),
    Action.HESITATE: Step(
        does=("Halt() until self.pose[3] < 0.1", "Halt() for $STOP_TIME seconds", f"{_COMES} for 1 seconds"),
        last=("Halt() until self.pose[3] < 0.1", "Halt() for $STOP_TIME seconds", _COMES),
        halts=True,
    ),
    Action.ACCELERATE: Step(does=("MoveAhead($ADV_SPRINT) for 1 seconds",), last=("MoveAhead($ADV_SPRINT)",)),
    Action.TURN_BACK: Step(
        does=("MoveAhead($ADV_SPEED, 3.14159) for 1.5 seconds",), last=("MoveAhead($ADV_SPEED, 3.14159)",)
    ),
}
"""What somebody does who comes from beside the road on foot."""
_ROUND = "TurnOff(3.1 if offsetFrom(egoRoute, self) > 0 else -3.1, $ADV_SPEED, 2)"
_ACROSS_RIDING: dict[Action, Step] = {
    **ACROSS,
    Action.TURN_BACK: Step(does=(_ROUND, f"{_COMES} for 1.5 seconds"), last=(_ROUND, _COMES)),
}
_BRISKLY = "MoveAhead(5) until abs(offsetFrom(egoRoute, self)) < 3"  # or the ego would be there before the next act
_RESTS = f"{_COMES} until restsWithin(egoRoute, self, $STOP_DISTANCE)"  # how it comes where it is to stand


_INTO_LANE = "DrivePath(egoRoute, $ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < 1"


@dataclass(frozen=True, slots=True, kw_only=True)
class Start:
    """What is done before the first act, by where one starts.

    Attributes:
        path: The line that one goes along.
        opening: The phases that end when the first act is due.
        steps: How acts are done from there.
        at: Range [m] and meaning of the parameter that says when it is due; None if it is due after a time.
        given: Acts that the place alone shows.
        sooner: How much sooner [m] it is due for each further act, so that all begin before the ego meets anything.
        first: The act without which there is no other; None if there is none.
        constants: What the plan tells its partners.
    """

    path: str
    opening: tuple[str, ...]
    steps: dict[Action, Step]
    at: tuple[float, float, str] | None = None
    given: frozenset[Action] = frozenset()
    sooner: float = 0.0
    first: Action | None = None
    constants: tuple[str, ...] = ()


_BEFORE_EVENT = "distanceLeft(egoRoute, ego, egoRoute.eventAt) < $ADV_DISTANCE"
_BEFORE = "how far before the start of its manoeuvre the ego is when the adversary acts"
_SETS_OFF = "Halt() until distanceLeft(egoRoute, ego, egoMeeting) < $ADV_DISTANCE"
_COMES_UP = "DrivePath(advTrajectory, $ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < "
_TO_IT = "how far the ego still has to go when it starts to move"
_NEXT_LANE = Start(
    path="advLane",
    opening=(f"KeepStation(advLane, ego) until {_BEFORE_EVENT}",),
    steps=_BESIDE,
    at=(-15, 20, _BEFORE),
    sooner=14,
)
STARTS: dict[Position, Start] = {
    Position.AHEAD: Start(
        path="advTrajectory",
        opening=(f"KeepStation(advTrajectory, ego, $LEAST) until {_BEFORE_EVENT}",),
        steps={
            **ALONG,
            Action.CHANGE_LANE: Step(
                does=("DrivePath(adjacentLane, $ADV_SPEED) until abs(offsetFrom(adjacentLane, self)) < 0.5",),
                path="adjacentLane",
            ),
        },
        at=(-15, 20, _BEFORE),
        sooner=14,
    ),
    Position.AHEAD_BESIDE: _NEXT_LANE,
    Position.BESIDE: replace(_NEXT_LANE, at=(-25, 5, _BEFORE)),
    Position.BEHIND_BESIDE: Start(
        path="advLane",
        opening=("KeepStation(advLane, ego) for 1 seconds",),
        steps={
            **_without(_BESIDE, Action.PACE),  # it is not level
            Action.OVERTAKE: Step(does=(f"DrivePath({{path}}, {_OVERTAKE}",), moving=True),
        },
    ),
    Position.BEHIND: Start(
        path="advTrajectory",
        opening=("KeepStation(advTrajectory, ego) for 1 seconds",),
        steps={
            **ALONG,
            Action.TAILGATE: Step(
                does=(
                    "PaceOnPath({path}, ego, -(ego.length + self.length) / 2 - $ADV_GAP, 12) for $TAIL_TIME seconds",
                ),
                last=("PaceOnPath({path}, ego, -(ego.length + self.length) / 2 - $ADV_GAP, 12)",),
                moving=True,
                long=True,
            ),
            Action.OVERTAKE: Step(
                does=(f"DrivePath(extended(adjacentLane, 20), {_OVERTAKE}",),
                back=(_INTO_LANE,),
                path="egoRoute",
                moving=True,
            ),
            Action.CUT_IN: Step(does=(_INTO_LANE,), path="egoRoute", after=Action.OVERTAKE),
        },
    ),
    Position.ONCOMING: Start(
        path="advTrajectory",
        opening=("DrivePath(advTrajectory, $ADV_SPEED) until self.pose[3] > 4 and gap(self, ego) < $ADV_DISTANCE",),
        steps={
            **_without(ALONG, Action.WEAVE),  # it would be past before it has swung twice
            Action.SWERVE: Step(does=("SwerveOnPath({path}, $ADV_SPEED, $SWERVE) for $SWERVE_TIME seconds",)),
        },
        at=(20, 50, "distance to the ego at which it acts"),
        given=frozenset((Action.ONCOMING,)),
        sooner=18,
    ),
    Position.KERB: Start(
        path="advKerb",
        opening=("Park() until headway(egoRoute, ego, self) < $ADV_DISTANCE",),
        steps={
            **ALONG,
            Action.PULL_OUT: Step(
                does=(
                    "DrivePath(advKerb, 3) for 0.3 seconds",
                    f"DrivePath({_OWN}, $ADV_SPEED) until abs(offsetFrom({_OWN}, self)) < 1.1",
                ),
                path=_OWN,
            ),
        },
        at=(16, 36, "how far the ego still has to go to it when it moves off"),
        sooner=8,
        first=Action.PULL_OUT,
    ),
    Position.CROSSING: Start(
        path="advTrajectory",
        opening=(_SETS_OFF, _COMES_UP + "$ACT_DISTANCE"),
        steps={
            **ALONG,
            Action.CROSS: Step(
                does=(_COMES_UP + "-5",),
                last=("DrivePath(advTrajectory, $ADV_SPEED)",),
            ),
        },
        at=(12, 48, "how far the ego still is from where their ways meet when it sets off"),
        given=frozenset((Action.CROSS,)),
        sooner=12,
        constants=('advTurn = ("straight", "left-turn", "right-turn")',),
    ),
    Position.ROADSIDE: Start(
        path="egoRoute",
        opening=(
            "Halt() until headway(egoRoute, ego, self) < "
            "$ADV_DISTANCE + 8 * max(0, abs(offsetFrom(egoRoute, self)) - 3) / $ADV_SPEED",
        ),
        steps=ACROSS,
        at=(15, 45, _TO_IT),
        sooner=14,
    ),
}

ON_FOOT: dict[Position, Start] = {
    Position.ROADSIDE: STARTS[Position.ROADSIDE],
    Position.AHEAD: Start(
        path="egoRoute",
        opening=(f"{_COMES} until headway(egoRoute, ego, self) < $ADV_DISTANCE",),
        steps={Action.STOP: ACROSS[Action.STOP], Action.ACCELERATE: ACROSS[Action.ACCELERATE]},
        at=(12, 30, _TO_IT),
        constants=("advAlong = 0",),
    ),
}
"""The same for somebody on foot: where else one starts, there are no steps."""


AT_JUNCTION: dict[Position, Start] = {
    Position.ONCOMING: replace(
        STARTS[Position.CROSSING],
        steps=_without(STARTS[Position.CROSSING].steps, Action.CROSS),
        given=frozenset((Action.ONCOMING,)),
    ),
}
"""The same at a junction, where it is another."""


def _start(asked: Asked) -> Start | None:
    if _walks(asked):
        return ON_FOOT.get(asked.position)
    return (asked.junction and AT_JUNCTION.get(asked.position)) or STARTS.get(asked.position)


_RANGES: dict[str, tuple[float, float, str, str]] = {
    "BRAKE": (0.3, 1, "1", "how hard it brakes"),
    "BRAKE_TIME": (0.6, 1.1, "s", "for how long it brakes"),
    "STOP_TIME": (0.8, 2.5, "s", "how long it stands"),
    "STOP_DISTANCE": (0, 1, "m", "how far from the ego's line it comes to rest"),
    "REST_DISTANCE": (-1, 2, "m", "how far beyond where their ways meet it comes to rest"),
    "THROTTLE": (0.5, 1, "1", "how far the pedal is pressed"),
    "BACK_SPEED": (1, 3.5, "m/s", "how fast it backs up"),
    "BACK_TIME": (1.5, 4, "s", "for how long it backs up"),
    "AMPLITUDE": (0.7, 1.2, "m", "how far it swings to either side"),
    "SWERVE": (1.5, 2.5, "m", "how far it swerves"),
    "SWERVE_TIME": (1, 1.6, "s", "for how long it swerves"),
    "PACE_TIME": (2, 3.5, "s", "for how long it keeps so"),
    "TAIL_TIME": (4, 6, "s", "for how long it keeps so"),
    "ADV_AHEAD": (0.5, 5, "m", "how far ahead of the ego it is then"),
    "ADV_GAP": (-0.4, 2.5, "m", "how much room it means to leave; below 0 it will touch"),
    "OVERTAKING": (11.5, 15, "m/s", "how fast it overtakes at most"),
    "ADV_SPRINT": (4, 6.5, "m/s", "how fast it goes then"),
    "ACT_DISTANCE": (0, 12, "m", "how far before the place where their ways meet it acts"),
}
"""The parameters of steps but for speed and trigger: range, unit, meaning."""
_PAUSE = 0.4, 1.2  # [s], how long somebody stands who comes from beside the road: the ego is near


@dataclass(frozen=True, slots=True, kw_only=True)
class Asked:
    """What a composed behavior is to do.

    Attributes:
        kind: Who does it.
        position: Where it starts.
        actions: What it does, in order.
        junction: Whether it is at a junction, where that makes another start of the position.
    """

    kind: AdversaryKind
    position: Position
    actions: tuple[Action, ...]
    junction: bool = False

    @property
    def snippet_id(self) -> str:
        """The id of the behavior."""
        there = _THERE if self.junction and self.position in AT_JUNCTION else ""
        return COMPOSED + ".".join((self.kind, self.position + there, *self.actions))


def compose(asked: Asked) -> Snippet | None:
    """A behavior that does what is asked for and nothing else; None if there are no steps for that, or not in order."""
    start = _start(asked)
    if start is None or not asked.actions:
        return None
    steps = _ACROSS_RIDING if start.steps is ACROSS and not _walks(asked) else start.steps
    lasting = {action for action in asked.actions if action.row.all_along}
    acts = [action for action in asked.actions if action not in lasting]
    if acts[:1] and acts[0] in start.given:
        acts = acts[1:]  # it comes from there
    if Action.BLOCK in lasting and Action.STOP not in acts and not _stands(asked):
        acts.append(Action.STOP)
    if not _doable(asked, start, steps, acts, lasting):
        return None
    return _snippet(asked, start, len(acts), tuple(_phases(asked, start, steps, acts)))


def _doable(
    asked: Asked, start: Start, steps: dict[Action, Step], acts: Sequence[Action], lasting: set[Action]
) -> bool:
    """Whether there are steps for all of it, in this order."""
    if _stands(asked):
        return not acts and lasting <= {Action.STAND, Action.BLOCK}
    if not set(acts) <= steps.keys() or not lasting <= {*start.given, *_PACES, Action.BLOCK}:
        return False
    if (_on_foot_ahead(start) and len(acts) > 1) or (start.first is not None and acts[:1] != [start.first]):
        return False
    if any(steps[action].after not in (None, before) for before, action in zip((None, *acts), acts, strict=False)):
        return False
    stood = itertools.accumulate((steps[action].halts for action in acts), operator.or_, initial=False)
    return not any(steps[action].moving and before for action, before in zip(acts, stood, strict=False))


def goes_without_saying(asked: Asked) -> frozenset[Action]:
    """What whoever does what is asked for does as well: who reverses has stopped, who stands ahead is in the way."""
    start = _start(asked)
    implied = {one for action in asked.actions for one in _IMPLIED.get(action, ())}
    return frozenset(implied | (start.given if start else frozenset()))


def asked_in(snippet_id: str) -> Asked:
    """What the composed behavior of an id is to do.

    Raises:
        SnippetError: It is no such id.
    """
    try:
        kind, position, *actions = snippet_id.removeprefix(COMPOSED).split(".")
        return Asked(
            kind=AdversaryKind(kind),
            position=Position(position.removesuffix(_THERE)),
            actions=tuple(map(Action, actions)),
            junction=position.endswith(_THERE),
        )
    except ValueError as error:
        raise SnippetError(f"there is no snippet {snippet_id!r}: {error}") from error


def composed_again(snippet_id: str) -> Snippet:
    """The composed behavior of an id.

    Raises:
        SnippetError: There is none.
    """
    if (made := compose(asked_in(snippet_id))) is None:
        raise SnippetError(f"there is no snippet {snippet_id!r}: no step of a plan does that")
    return made


_PART_OF_HALTING = (Action.BRAKE, Action.CROSS)  # what need not be done before somebody halts
_IMPLIED = {
    Action.STAND: (Action.BLOCK,),
    Action.BLOCK: (Action.STAND,),
    Action.REVERSE: (Action.STOP,),
    Action.STOP: (Action.BRAKE, Action.BLOCK),
}
_PACES = {Action.FOLLOW, Action.SLOW, Action.FAST}  # what lasts is a speed


def _stands(asked: Asked) -> bool:
    """Whether it stands from the beginning on."""
    quiet = all(action.row.all_along for action in asked.actions)
    ahead = asked.position is Position.AHEAD and quiet
    return Action.STAND in asked.actions or (ahead and Action.BLOCK in asked.actions)


def _meets(asked: Asked, start: Start) -> bool:
    """Whether its way and the ego's meet in a junction."""
    return asked.position is Position.CROSSING or start is AT_JUNCTION.get(asked.position)


def _on_foot_ahead(start: Start) -> bool:
    return start is ON_FOOT[Position.AHEAD]


def _walks(asked: Asked) -> bool:
    return asked.kind.row.manner is Manner.WALKS


def _phases(asked: Asked, start: Start, steps: dict[Action, Step], acts: Sequence[Action]) -> Iterator[str]:
    """What is done, phase by phase."""
    if not acts and _stands(asked):
        yield "Halt()" if start.steps is ACROSS or _walks(asked) else f"BrakeOnPath({start.path}, 1)"
    elif not acts:
        yield from _on_its_way(asked, start)
    elif _on_foot_ahead(start):
        yield from (*start.opening, *steps[acts[0]].last)
    else:
        yield from _acting(asked, start, steps, acts)


def _acting(asked: Asked, start: Start, steps: dict[Action, Step], acts: Sequence[Action]) -> Iterator[str]:
    """The phases of acts, with what leads to the first and from each to the next."""
    yield from _opening(asked, start, acts[0], steps)
    path, stands, across = start.path, False, start.steps is ACROSS
    for before, action, after in zip((None, *acts), acts, (*acts[1:], None), strict=False):
        step, following = steps[action], steps[after] if after else None
        hesitates = action is Action.STOP and after is Action.HESITATE
        if following and following.halts and (action in _PART_OF_HALTING or hesitates):
            continue
        if before is Action.REVERSE and action is Action.STOP:
            yield "Halt()" if after is None else "Halt() for $STOP_TIME seconds"
            continue  # it stands already
        if across and not stands and before in (None, Action.CROSS, Action.BRAKE) and step.halts:
            yield from (_RESTS,) if after is None else (_BRISKLY, _RESTS)
        elif across and before is None and action is not Action.CROSS:
            yield f"{_COMES} until abs(offsetFrom(egoRoute, self)) < 2.5"
        elif not across and not stands and action is Action.REVERSE:
            yield from (_BRAKES_TO_STAND.format(path=path), "Halt() for 0.5 seconds")
        elif not across and stands and action not in (Action.REVERSE, Action.ACCELERATE):
            yield f"DrivePath({path}, $ADV_SPEED) for 2.5 seconds"
        path = step.path or path
        does = step.does if after is Action.CUT_IN else (*step.does, *step.back)
        if after is None:
            does = step.last or (*does, "DrivePath({path}, $ADV_SPEED)")
        yield from (phase.format(path=path) for phase in does)
        stands = step.stands


def _on_its_way(asked: Asked, start: Start) -> Iterator[str]:
    """What somebody does of whom no act was said: goes on."""
    if start.steps is ACROSS or _meets(asked, start):
        yield start.opening[0]
    yield _COMES if _walks(asked) or start.steps is ACROSS else f"DrivePath({start.path}, $ADV_SPEED)"


def _opening(asked: Asked, start: Start, first: Action, steps: dict[Action, Step]) -> Iterator[str]:
    """What is done until the first act is due."""
    along = f"DrivePath({start.path}, $ADV_SPEED)"
    if steps[first].long:
        yield f"{along} for 0.5 seconds"
    elif asked.position is Position.AHEAD and _PACES.intersection(asked.actions):
        yield f"{along} until headway(egoRoute, ego, self) < $ADV_DISTANCE"
    elif {Action.CROSS, Action.ONCOMING}.intersection(asked.actions) and _meets(asked, start) and steps[first].halts:
        yield from (_SETS_OFF, f"{_COMES_UP} brakingDistance(self) / $BRAKE - $REST_DISTANCE")
    else:
        yield from start.opening


def _snippet(asked: Asked, start: Start, acts: int, phases: Sequence[str]) -> Snippet:
    text = "\n".join(phases)
    names = list(dict.fromkeys(re.findall(r"\$([A-Z_]+)", text)))
    ranges = {name: _range(asked, start, acts, name) for name in names if name != "LEAST"}
    for name in sorted(names, key=len, reverse=True):
        text = text.replace(f"${name}", _least(asked) if name == "LEAST" else f"globalParameters.OPT_{name}")
    source = "\n".join(
        (
            *(f"param {p.name} = Range({p.low!r}, {p.high!r})" for p in ranges.values()),
            *start.constants,
            "behavior AdvBehavior():",
            *(f"    do {phase}" for phase in text.split("\n")),
        )
    )
    source = print_plan(parse_plan(source))
    requires, provides = names_in(source)
    return Snippet(
        id=asked.snippet_id,
        component=Component.BEHAVIOR,
        description=_description(asked),
        rephrasings=(),
        slots=Slots(actions=asked.actions, position=asked.position),
        adversaries=(asked.kind,),
        requires=requires,
        provides=provides,
        parameters=tuple(ranges.values()),
        origin="composed of acts",
        source=source,
    )


def _description(asked: Asked) -> str:
    acts = "; then ".join(action.row.meaning for action in asked.actions)
    return f"The {asked.kind.replace('-', ' ')} {acts}."


def _least(asked: Asked) -> str:
    return "4" if asked.kind.row.manner is Manner.RIDES else "5"


def _range(asked: Asked, start: Start, acts: int, name: str) -> ParameterRange:
    if name == "ADV_DISTANCE" and start.at is not None:
        sooner, (low, high, meaning) = start.sooner * max(acts - 1, 0), start.at
        low, high = low + sooner, high + sooner
        return ParameterRange(name="OPT_ADV_DISTANCE", low=low, high=high, unit="m", meaning=meaning)
    if name == "ADV_SPEED":
        low, high = _speeds(asked)
        return ParameterRange(name="OPT_ADV_SPEED", low=low, high=high, unit="m/s", meaning="how fast it goes")
    low, high, unit, meaning = _RANGES[name]
    if name == "STOP_TIME" and start.steps is ACROSS:
        low, high = _PAUSE
    return ParameterRange(name=f"OPT_{name}", low=low, high=high, unit=unit, meaning=meaning)


def _speeds(asked: Asked) -> tuple[float, float]:
    row = asked.kind.row
    if Action.SLOW in asked.actions:
        return round(0.4 * row.slow, 2), round(0.8 * row.slow, 2)
    if Action.FAST in asked.actions:
        return round(1.02 * row.fast, 2), round(1.25 * row.fast, 2)
    if _walks(asked) and asked.position is Position.AHEAD:
        return 0.9, 2.2
    if asked.position is Position.ROADSIDE:
        return (2.2, 3.2) if Action.TURN_BACK in asked.actions and not _walks(asked) else (1.4, 4)
    if asked.position in (Position.ONCOMING, Position.CROSSING):
        return (4, 7) if row.manner is Manner.RIDES and not row.motorised else (6, 10)
    return (3.5, 6) if not row.motorised else (5, 9)
