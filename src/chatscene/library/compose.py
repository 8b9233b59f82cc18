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
from itertools import pairwise

from chatscene.errors import SnippetError
from chatscene.library.plan import parse_plan, print_plan
from chatscene.library.snippet_file import names_in
from chatscene.terms.actors import AdversaryKind, Manner
from chatscene.terms.acts import Action
from chatscene.terms.scenario import Component, Position, Side, Slots
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
        takes: How long [s] it is, about, until the next act begins.
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
    takes: float = 2.5


_BRAKES_TO_STAND = f"BrakeOnPath({{path}}, $BRAKE) until {_STAND}"
_STOP = Step(
    does=(_BRAKES_TO_STAND, "Halt() for $STOP_TIME seconds"),
    last=(_BRAKES_TO_STAND, "Halt()"),
    stands=True,
    halts=True,
    takes=4.0,
)
ALONG: dict[Action, Step] = {
    Action.BRAKE: Step(
        does=("BrakeOnPath({path}, $BRAKE) for $BRAKE_TIME seconds",),
        last=("BrakeOnPath({path}, $BRAKE)",),
        takes=1.0,
    ),
    Action.STOP: _STOP,
    Action.HESITATE: Step(
        does=(*_STOP.does, "DrivePath({path}, $ADV_SPEED) for 2 seconds"),
        last=(*_STOP.does, "DrivePath({path}, $ADV_SPEED)"),
        halts=True,
        takes=5.0,
    ),
    Action.REVERSE: Step(
        does=("ReverseStraight($BACK_SPEED) for $BACK_TIME seconds",),
        last=("ReverseStraight($BACK_SPEED) for $BACK_TIME seconds", "Halt()"),
        stands=True,
        halts=True,
        takes=6.0,
    ),
    Action.ACCELERATE: Step(
        does=("ThrottleOnPath({path}, $THROTTLE) for 1.8 seconds",), last=("ThrottleOnPath({path}, $THROTTLE)",)
    ),
    Action.WEAVE: Step(
        does=("WeaveOnPath({path}, $ADV_SPEED, $AMPLITUDE, 3) for 4.5 seconds",),
        last=("WeaveOnPath({path}, $ADV_SPEED, $AMPLITUDE, 3)",),
        long=True,
        takes=4.5,
    ),
    Action.SWERVE: Step(
        does=("SwerveOnPath({path}, $ADV_SPEED, $SWERVE) for $SWERVE_TIME seconds",),
        takes=1.3,
    ),
}
"""What somebody does who goes along a line."""

_OVERTAKE = "$OVERTAKING) until headway(egoRoute, ego, self) > $ADV_AHEAD"
_TOWARD_EGO = "-$SWERVE if offsetFrom(egoRoute, self) > 0 else $SWERVE"
_BESIDE: dict[Action, Step] = {
    **ALONG,
    Action.CUT_IN: Step(does=(f"DrivePath({_OWN}, $ADV_SPEED) until abs(offsetFrom({_OWN}, self)) < 1",), path=_OWN),
    Action.CHANGE_LANE: Step(
        does=(f"DrivePath({_OWN}, $ADV_SPEED) until abs(offsetFrom({_OWN}, self)) < 0.6",), path=_OWN
    ),
    Action.PACE: Step(
        does=("PaceOnPath({path}, ego, $ADV_AHEAD, 16, 2.5) for $PACE_TIME seconds",),
        last=("PaceOnPath({path}, ego, $ADV_AHEAD, 16, 2.5)",),
        moving=True,
        takes=4.0,
    ),
    Action.SWERVE: Step(
        does=(f"SwerveOnPath({{path}}, $ADV_SPEED, {_TOWARD_EGO}) for $SWERVE_TIME seconds",), takes=1.3
    ),
}


def _without(steps: dict[Action, Step], one: Action) -> dict[Action, Step]:
    return {action: step for action, step in steps.items() if action is not one}


_RIDDEN = 7.0  # [m/s], 25 km/h, at which cyclists of test protocols cross at most
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


_INTO_LANE = f"DrivePath({_OWN}, $ADV_SPEED) until abs(offsetFrom({_OWN}, self)) < 1"


@dataclass(frozen=True, slots=True, kw_only=True)
class Start:
    """What is done before the first act, by where one starts.

    Attributes:
        path: The line that one goes along.
        opening: The phases that end when the first act is due.
        steps: How acts are done from there.
        at: Range [m] and meaning of the parameter that says when it is due; None if it is due after a time.
        given: Acts that the place alone shows.
        closing: How much nearer [m/s] the ego comes while acts are done; by so much sooner the first is due where
            others follow, so that all begin before the ego meets anything.
        first: The act without which there is no other; None if there is none.
        constants: What the plan tells its partners.
        in_way: Whether who stops there is in the ego's way.
    """

    path: str
    opening: tuple[str, ...]
    steps: dict[Action, Step]
    at: tuple[float, float, str] | None = None
    given: frozenset[Action] = frozenset()
    closing: float = 0.0
    first: Action | None = None
    constants: tuple[str, ...] = ()
    in_way: bool = False


_ADV_TURNS = {Action.CROSS: "straight", Action.TURN_LEFT: "left-turn"}
_BEFORE_EVENT = "distanceLeft(egoRoute, ego, egoRoute.eventAt) < $ADV_DISTANCE"
_BEFORE = "how far before the start of its manoeuvre the ego is when the adversary acts"
_SETS_OFF = (
    "Halt() until distanceLeft(egoRoute, ego, egoMeeting) < "
    "$ADV_DISTANCE + 6 * distanceLeft(advTrajectory, self, advMeeting) / $ADV_SPEED + 0.8 * $ADV_SPEED"
)  # the last, since it sets off from a halt and is later than at full speed
_CREEPS = 12.0  # [m] before where their ways meet, whoever is to be slow there slows down: nobody waits for more
_SETS_OFF_TO_CREEP = (
    "Halt() until distanceLeft(egoRoute, ego, egoMeeting) < $ADV_DISTANCE + "
    f"6 * ({_CREEPS:g} / $ADV_SPEED + max(0, distanceLeft(advTrajectory, self, advMeeting) - {_CREEPS:g}) / 8)",
    f"DrivePath(advTrajectory, 8) until distanceLeft(advTrajectory, self, advMeeting) < {_CREEPS:g}",
)
_COMES_UP = "DrivePath(advTrajectory, $ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < "
_TO_IT = "how far the ego still has to go when it starts to move"
_TURN = Step(does=(_COMES_UP + "-4",), last=("DrivePath(advTrajectory, $ADV_SPEED)",), takes=3.0)
_NEXT_LANE = Start(
    path="advLane",
    opening=(f"KeepStation(advLane, ego) until {_BEFORE_EVENT}",),
    steps=_BESIDE,
    at=(-15, 20, _BEFORE),
    closing=8,
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
        closing=2,
        in_way=True,
    ),
    Position.AHEAD_BESIDE: replace(_NEXT_LANE, steps=_without(_BESIDE, Action.PACE)),  # it is not level
    Position.BESIDE: replace(_NEXT_LANE, at=(-25, 5, _BEFORE)),
    Position.BEHIND_BESIDE: Start(
        path="advLane",
        opening=("KeepStation(advLane, ego) for 1 seconds",),
        steps={
            **_without(_BESIDE, Action.PACE),
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
                    "PaceOnPath({path}, ego, -(ego.length + self.length) / 2 - $ADV_GAP, 15) for $TAIL_TIME seconds",
                ),
                last=("PaceOnPath({path}, ego, -(ego.length + self.length) / 2 - $ADV_GAP, 15)",),
                moving=True,
                long=True,
            ),
            Action.OVERTAKE: Step(
                does=(f"DrivePath(extended(adjacentLane, 20), {_OVERTAKE}",),
                back=(_INTO_LANE,),
                path=_OWN,
                moving=True,
            ),
            Action.CUT_IN: Step(does=(_INTO_LANE,), path=_OWN, after=Action.OVERTAKE),
        },
    ),
    Position.ONCOMING: Start(
        path="advTrajectory",
        opening=("DrivePath(advTrajectory, $ADV_SPEED) until self.pose[3] > 4 and gap(self, ego) < $ADV_DISTANCE",),
        steps=_without(ALONG, Action.WEAVE),  # it would be past before it has swung twice
        at=(20, 50, "distance to the ego at which it acts"),
        given=frozenset((Action.ONCOMING,)),
        closing=6,
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
        closing=6,
        first=Action.PULL_OUT,
    ),
    Position.CROSSING: Start(
        path="advTrajectory",
        opening=(_SETS_OFF, _COMES_UP + "$ACT_DISTANCE"),
        steps={
            **ALONG,
            Action.TURN_LEFT: _TURN,
            Action.CROSS: Step(
                does=(_COMES_UP + "-5",),
                last=("DrivePath(advTrajectory, $ADV_SPEED)",),
            ),
        },
        at=(6, 32, "how far the ego still is from where their ways meet when it sets off, at least"),
        given=frozenset((Action.CROSS,)),
        closing=8,
        constants=('advTurn = ("straight", "left-turn", "right-turn")',),
        in_way=True,
    ),
    Position.BEYOND: Start(path="egoRoute", opening=(), steps={}),
    Position.ROADSIDE: Start(
        path="egoRoute",
        opening=(
            "Halt() until headway(egoRoute, ego, self) < "
            "$ADV_DISTANCE + 8 * max(0, abs(offsetFrom(egoRoute, self)) - 3) / $ADV_SPEED",
        ),
        steps=ACROSS,
        at=(15, 45, _TO_IT),
        closing=7,
        in_way=True,
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
    Position.BEYOND: STARTS[Position.BEYOND],
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
    "LEAD": (9, 20, "m", "how far ahead of the ego it drives before it acts"),
    "THROTTLE": (0.5, 1, "1", "how far the pedal is pressed"),
    "BACK_SPEED": (1, 3.5, "m/s", "how fast it backs up"),
    "BACK_TIME": (1.5, 3, "s", "for how long it backs up"),
    "AMPLITUDE": (0.7, 1.2, "m", "how far it swings to either side"),
    "SWERVE": (1.5, 2.5, "m", "how far it swerves"),
    "SWERVE_TIME": (1, 1.6, "s", "for how long it swerves"),
    "PACE_TIME": (2, 3.5, "s", "for how long it keeps so"),
    "TAIL_TIME": (5, 7, "s", "for how long it keeps so"),
    "ADV_AHEAD": (0.5, 5, "m", "how far ahead of the ego it is then"),
    "ADV_GAP": (-0.4, 2.5, "m", "how much room it means to leave; below 0 it will touch"),
    "OVERTAKING": (11.5, 15, "m/s", "how fast it overtakes at most"),
    "ADV_SPRINT": (4, 6.5, "m/s", "how fast it goes then"),
    "ACT_DISTANCE": (0, 12, "m", "how far before the place where their ways meet it acts"),
}
"""The parameters of steps but for speed and trigger: range, unit, meaning."""
_PAST = 6.5, 10.0  # [m], how far ahead somebody is who has overtaken and then does something else
_BACKING = 1.0, 1.8  # [s], for how long somebody backs up who then does something else
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
    if start is None or not asked.actions or (_never_moves(asked) and not _stands(asked)):
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
    return _snippet(asked, start, _meanwhile(steps, acts), tuple(_phases(asked, start, steps, acts)))


def _meanwhile(steps: dict[Action, Step], acts: Sequence[Action]) -> float:
    """How long [s] it is, about, from the beginning of the first act to that of the last."""
    halts_first = 2.0 if acts[-1:] == [Action.REVERSE] else 0.0
    return sum(steps[action].takes for action in acts[:-1]) + halts_first


def _doable(
    asked: Asked, start: Start, steps: dict[Action, Step], acts: Sequence[Action], lasting: set[Action]
) -> bool:
    """Whether there are steps for all of it, in this order, and time for it before the ego meets anything."""
    if _stands(asked):
        in_the_way = {Action.BLOCK} if asked.position in _IN_LANE else set[Action]()
        at_its_edge = {Action.NARROW} if asked.position is Position.AHEAD and not _walks(asked) else set[Action]()
        return not acts and lasting <= {Action.STAND} | in_the_way | at_its_edge
    if not set(acts) <= steps.keys() or not lasting <= {*start.given, *_PACES, Action.BLOCK}:
        return False
    return (
        _go_together(asked, start, acts, lasting)
        and _in_order(start, steps, acts)
        and not _too_late(asked, start, steps, acts, lasting)
    )


def _go_together(asked: Asked, start: Start, acts: Sequence[Action], lasting: set[Action]) -> bool:
    """Whether somebody who starts there does all of this, in whatever order."""
    if any(_AGAINST.get(action, frozenset()).intersection(asked.actions) for action in asked.actions):
        return False
    behind = asked.position in (Position.BEHIND, Position.BEHIND_BESIDE)
    if Action.BLOCK in lasting and (behind or not (start.in_way or _ENTERS.intersection(acts))):
        return False
    blocks = Action.BLOCK in lasting and acts[:1] == [Action.ACCELERATE]
    if _meets(asked, start) and (blocks or (_AWAY.intersection(acts) and {*asked.actions} - start.given - {acts[0]})):
        return False  # across a junction there is no room for more
    sluggish = asked.kind.row.limits.throttle < _SLUGGISH
    late = sluggish and (Action.OVERTAKE in acts or (Action.TAILGATE in acts and len(acts) > 1))
    return not (late or (Action.TAILGATE in acts and not asked.kind.row.motorised))


def _in_order(start: Start, steps: dict[Action, Step], acts: Sequence[Action]) -> bool:
    """Whether each act can follow the one before it."""
    if (_on_foot_ahead(start) and len(acts) > 1) or (start.first is not None and acts[:1] != [start.first]):
        return False
    if any(steps[action].after not in (None, before) for before, action in zip((None, *acts), acts, strict=False)):
        return False
    backs = any(one is Action.REVERSE and after not in _AFTER_BACKING for one, after in pairwise(acts))
    return not (backs or _AT_FIRST.intersection(acts[1:]) or any(two in _NEVER for two in pairwise(acts)))


def _too_late(
    asked: Asked, start: Start, steps: dict[Action, Step], acts: Sequence[Action], lasting: set[Action]
) -> bool:
    """Whether something comes when it can no longer be done: who has stood does not overtake."""
    stood = itertools.accumulate((steps[action].halts for action in acts), operator.or_, initial=False)
    if any(steps[action].moving and before for action, before in zip(acts, stood, strict=False)):
        return True
    slow_there = _meets(asked, start) and asked.kind.row.limits.throttle < _SLUGGISH
    hurries = _meets(asked, start) and Action.FAST in lasting  # it sets off there, and is not fast in time
    return hurries or (slow_there and bool(Action.REVERSE in acts or Action.BLOCK in lasting))


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


_LEADS = (Position.AHEAD, Position.BESIDE, Position.AHEAD_BESIDE)  # from there one gets ahead before one acts
_IN_LANE = (Position.AHEAD, Position.BEYOND)  # who stands there is in the ego's way
_PART_OF_HALTING = (Action.BRAKE, Action.CROSS)  # what need not be done before somebody halts
_IMPLIED = {
    Action.STAND: (Action.BLOCK,),
    Action.BLOCK: (Action.STAND,),
    Action.NARROW: (Action.STAND, Action.BLOCK),
    Action.REVERSE: (Action.STOP,),
    Action.STOP: (Action.BRAKE, Action.BLOCK),
}
_HASTE = {Action.SLOW, Action.FAST}
_AGAINST = {
    Action.BLOCK: frozenset((Action.CHANGE_LANE, Action.SWERVE, Action.WEAVE, Action.REVERSE, Action.SLOW)),
    Action.SLOW: frozenset(
        (Action.FAST, Action.ACCELERATE, Action.PACE, Action.TAILGATE, Action.OVERTAKE, Action.SWERVE, Action.WEAVE)
    ),
    Action.TURN_LEFT: frozenset((Action.CROSS, Action.SLOW)),
    Action.FAST: frozenset(
        (Action.BRAKE, Action.STOP, Action.HESITATE, Action.REVERSE, Action.BLOCK, Action.PACE, Action.TAILGATE)
    ),
}  # what does not go with it
_NEVER = frozenset(
    (
        *itertools.product((Action.HESITATE, Action.ACCELERATE), (Action.REVERSE, Action.OVERTAKE)),
        *itertools.product((Action.CUT_IN, Action.CHANGE_LANE), (Action.OVERTAKE, Action.CUT_IN, Action.CHANGE_LANE)),
    )
)  # one after the other
# What comes first or not at all: it was level, or close, from the beginning on, or swings too long for what is left
_AT_FIRST = frozenset((Action.PACE, Action.TAILGATE, Action.CROSS, Action.WEAVE))
_AFTER_BACKING = (Action.STOP, Action.ACCELERATE)
_ENTERS = frozenset((Action.CUT_IN, Action.PULL_OUT, Action.CROSS))
_AWAY = frozenset((Action.SWERVE, Action.WEAVE))
_SLUGGISH = 2.5  # [m/s²] at full throttle: of whoever has less, the ego is sooner where they are to be
_PACES = {Action.FOLLOW, Action.SLOW, Action.FAST}  # what lasts is a speed


def _stands(asked: Asked) -> bool:
    """Whether it stands from the beginning on."""
    quiet = all(action.row.all_along for action in asked.actions)
    in_lane = asked.position in _IN_LANE and quiet
    return Action.STAND in asked.actions or (in_lane and not {Action.BLOCK, Action.NARROW}.isdisjoint(asked.actions))


def _never_moves(asked: Asked) -> bool:
    """Whether it can only stand, being a thing or where nobody else has a start."""
    return asked.kind.lies or asked.position is Position.BEYOND


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
        on_the_spot = start.steps is ACROSS or _walks(asked) or asked.position in _IN_LANE
        yield "Halt()" if on_the_spot else f"BrakeOnPath({start.path}, 1)"
    elif not acts:
        yield from _on_its_way(asked, start)
    elif _on_foot_ahead(start):
        yield from (*start.opening, *steps[acts[0]].last)
    else:
        yield from _acting(asked, start, steps, acts)


def _acting(asked: Asked, start: Start, steps: dict[Action, Step], acts: Sequence[Action]) -> Iterator[str]:
    """The phases of acts, with what leads to the first and from each to the next."""
    yield from _opening(asked, start, acts, steps)
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
    if Action.SLOW in asked.actions and _meets(asked, start):
        yield from _SETS_OFF_TO_CREEP
    elif start.steps is ACROSS or _meets(asked, start):
        yield start.opening[0]
    yield _COMES if _walks(asked) or start.steps is ACROSS else f"DrivePath({start.path}, $ADV_SPEED)"


def _opening(asked: Asked, start: Start, acts: Sequence[Action], steps: dict[Action, Step]) -> Iterator[str]:
    """What is done until the first act is due."""
    first = acts[0]
    halts = steps[first].halts or (first is Action.BRAKE and any(steps[action].halts for action in acts[1:2]))
    along = f"DrivePath({start.path}, $ADV_SPEED)"
    if steps[first].long and len(acts) == 1:
        yield f"{along} for 0.5 seconds"
    elif _HASTE.intersection(asked.actions) and start.steps is not ACROSS and start.first is None:
        if _meets(asked, start):
            yield _SETS_OFF
        yield f"{along} for {4 if Action.FAST in asked.actions else 2} seconds"
    elif {Action.CROSS, Action.ONCOMING, Action.BLOCK}.intersection(asked.actions) and _meets(asked, start) and halts:
        yield from (_SETS_OFF, f"{_COMES_UP} brakingDistance(self) / $BRAKE - $REST_DISTANCE")
    elif asked.position in _LEADS and _meanwhile(steps, acts) and first is not Action.PACE:
        yield f"PaceOnPath({start.path}, ego, $LEAD, 16, $LEAST) until {_BEFORE_EVENT}"
    else:
        yield from start.opening


def _snippet(asked: Asked, start: Start, meanwhile: float, phases: Sequence[str]) -> Snippet:
    text = "\n".join(phases)
    names = list(dict.fromkeys(re.findall(r"\$([A-Z_]+)", text)))
    ranges = {name: _range(asked, start, meanwhile, name) for name in names if name != "LEAST"}
    for name in sorted(names, key=len, reverse=True):
        text = text.replace(f"${name}", _least(asked) if name == "LEAST" else f"globalParameters.OPT_{name}")
    source = "\n".join(
        (
            *(f"param {p.name} = Range({p.low!r}, {p.high!r})" for p in ranges.values()),
            *_constants(asked, start),
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
        slots=Slots(actions=asked.actions, position=asked.position, side=_side(asked)),
        adversaries=(asked.kind,),
        requires=requires,
        provides=provides,
        parameters=tuple(ranges.values()),
        origin="composed of acts",
        source=source,
    )


def _constants(asked: Asked, start: Start) -> tuple[str, ...]:
    if _stands(asked) and asked.position in _IN_LANE and not _walks(asked):
        aside = ("advAside = 0",) if Action.NARROW in asked.actions else ()
        return ("advStill = 0", *aside)
    turns = [_ADV_TURNS[action] for action in asked.actions if action in _ADV_TURNS]
    return (f'advTurn = "{turns[0]}"',) if turns and _meets(asked, start) else start.constants


def _side(asked: Asked) -> Side | None:
    """From which side it must come, so that a turn leads across the ego's way."""
    return Side.RIGHT if Action.TURN_LEFT in asked.actions and asked.position is Position.CROSSING else None


def _description(asked: Asked) -> str:
    acts = "; then ".join(action.row.meaning for action in asked.actions)
    return f"The {asked.kind.replace('-', ' ')} {acts}."


def _least(asked: Asked) -> str:
    return "4" if asked.kind.row.manner is Manner.RIDES else "5"


def _range(asked: Asked, start: Start, meanwhile: float, name: str) -> ParameterRange:
    if name == "ADV_DISTANCE" and start.at is not None:
        sooner, (low, high, meaning) = start.closing * meanwhile, start.at
        low, high = round(low + sooner, 1), round(high + sooner, 1)
        return ParameterRange(name="OPT_ADV_DISTANCE", low=low, high=high, unit="m", meaning=meaning)
    if name == "ADV_SPEED":
        low, high = _speeds(asked)
        return ParameterRange(name="OPT_ADV_SPEED", low=low, high=high, unit="m/s", meaning="how fast it goes")
    low, high, unit, meaning = _RANGES[name]
    if name == "STOP_TIME" and (start.steps is ACROSS or meanwhile):
        low, high = _PAUSE
    if name == "BACK_TIME" and meanwhile > _STOP.takes:
        low, high = _BACKING
    if name == "ADV_AHEAD" and meanwhile and Action.OVERTAKE in asked.actions:
        low, high = _PAST
    if name == "ADV_GAP" and meanwhile:
        low = 0.6
    if name == "LEAD":
        low, high = round(low + 4 * meanwhile, 1), round(high + 4 * meanwhile, 1)
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
        return _speeds_across(asked)
    if asked.position in (Position.ONCOMING, Position.CROSSING):
        return (4, 7) if row.manner is Manner.RIDES and not row.motorised else (6, 10)
    behind = asked.position is Position.BEHIND and len(asked.actions) > 1  # or it runs into the ego at once
    return (3.5, 6) if not row.motorised else (3.5, 6) if behind else (5, 9)


def _speeds_across(asked: Asked) -> tuple[float, float]:
    if not _walks(asked) and asked.actions == (Action.CROSS,):
        return 1.4, _RIDDEN  # nothing follows for which it would be too fast
    return (2.2, 3.2) if Action.TURN_BACK in asked.actions and not _walks(asked) else (1.4, 4)
