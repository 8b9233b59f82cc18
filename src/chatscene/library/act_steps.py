"""How each act is done, and what comes before it: the tables that behaviors are composed from.

Each act has a step: what is done for it by somebody who goes along a line, or who comes from beside the road. What is
done before the first act goes by where somebody starts.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

from chatscene.terms.acts import Action
from chatscene.terms.scenario import Position

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


BRAKES_TO_STAND = f"BrakeOnPath({{path}}, $BRAKE) until {_STAND}"
STOP = Step(
    does=(BRAKES_TO_STAND, "Halt() for $STOP_TIME seconds"),
    last=(BRAKES_TO_STAND, "Halt()"),
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
    Action.STOP: STOP,
    Action.HESITATE: Step(
        does=(*STOP.does, "DrivePath({path}, $ADV_SPEED) for 2 seconds"),
        last=(*STOP.does, "DrivePath({path}, $ADV_SPEED)"),
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


RIDDEN = 7.0  # [m/s], 25 km/h, at which cyclists of test protocols cross at most
COMES = "MoveAhead($ADV_SPEED)"
ACROSS: dict[Action, Step] = {
    Action.CROSS: Step(does=(f"{COMES} until abs(offsetFrom(egoRoute, self)) < 2.5",), last=(COMES,)),
    Action.STOP: Step(
        does=("Halt() until self.pose[3] < 0.1", "Halt() for $STOP_TIME seconds"),
        last=("Halt()",),
        stands=True,
        halts=True,
    ),
    Action.HESITATE: Step(
        does=("Halt() until self.pose[3] < 0.1", "Halt() for $STOP_TIME seconds", f"{COMES} for 1 seconds"),
        last=("Halt() until self.pose[3] < 0.1", "Halt() for $STOP_TIME seconds", COMES),
        halts=True,
    ),
    Action.ACCELERATE: Step(does=("MoveAhead($ADV_SPRINT) for 1 seconds",), last=("MoveAhead($ADV_SPRINT)",)),
    Action.TURN_BACK: Step(
        does=("MoveAhead($ADV_SPEED, 3.14159) for 1.5 seconds",), last=("MoveAhead($ADV_SPEED, 3.14159)",)
    ),
}
"""What somebody does who comes from beside the road on foot."""
_ROUND = "TurnOff(3.1 if offsetFrom(egoRoute, self) > 0 else -3.1, $ADV_SPEED, 2)"
ACROSS_RIDING: dict[Action, Step] = {
    **ACROSS,
    Action.TURN_BACK: Step(does=(_ROUND, f"{COMES} for 1.5 seconds"), last=(_ROUND, COMES)),
}
BRISKLY = "MoveAhead(5) until abs(offsetFrom(egoRoute, self)) < 3"  # or the ego would be there before the next act
RESTS = f"{COMES} until restsWithin(egoRoute, self, $STOP_DISTANCE)"  # how it comes where it is to stand


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
        waiting: The opening where the ego stands, and nobody can wait for it to come; empty for the same.
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
    waiting: tuple[str, ...] = ()


ADV_TURNS = {Action.CROSS: "straight", Action.TURN_LEFT: "left-turn"}
BEFORE_EVENT = "distanceLeft(egoRoute, ego, egoRoute.eventAt) < $ADV_DISTANCE"
_BEFORE = "how far before the start of its manoeuvre the ego is when the adversary acts"
SETS_OFF = (
    "Halt() until distanceLeft(egoRoute, ego, egoMeeting) < "
    "$ADV_DISTANCE + 6 * distanceLeft(advTrajectory, self, advMeeting) / $ADV_SPEED + 0.8 * $ADV_SPEED"
)  # the last, since it sets off from a halt and is later than at full speed
_CREEPS = 12.0  # [m] before where their ways meet, whoever is to be slow there slows down: nobody waits for more
SETS_OFF_TO_CREEP = (
    "Halt() until distanceLeft(egoRoute, ego, egoMeeting) < $ADV_DISTANCE + "
    f"6 * ({_CREEPS:g} / $ADV_SPEED + max(0, distanceLeft(advTrajectory, self, advMeeting) - {_CREEPS:g}) / 8)",
    f"DrivePath(advTrajectory, 8) until distanceLeft(advTrajectory, self, advMeeting) < {_CREEPS:g}",
)
COMES_UP = "DrivePath(advTrajectory, $ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < "
_TO_IT = "how far the ego still has to go when it starts to move"
_TURN = Step(does=(COMES_UP + "-4",), last=("DrivePath(advTrajectory, $ADV_SPEED)",), takes=3.0)
WAITS = "Halt() for $WAIT seconds"
_NEXT_LANE = Start(
    path="advLane",
    opening=(f"KeepStation(advLane, ego) until {BEFORE_EVENT}",),
    steps=_BESIDE,
    at=(-15, 20, _BEFORE),
    closing=8,
    waiting=("BrakeOnPath(advLane, 1) for $WAIT seconds",),
)
STARTS: dict[Position, Start] = {
    Position.AHEAD: Start(
        path="advTrajectory",
        opening=(f"KeepStation(advTrajectory, ego, $LEAST) until {BEFORE_EVENT}",),
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
        waiting=("BrakeOnPath(advTrajectory, 1) for $WAIT seconds",),
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
        waiting=("Park() for $WAIT seconds",),
    ),
    Position.CROSSING: Start(
        path="advTrajectory",
        opening=(SETS_OFF, COMES_UP + "$ACT_DISTANCE"),
        steps={
            **ALONG,
            Action.TURN_LEFT: _TURN,
            Action.CROSS: Step(
                does=(COMES_UP + "-5",),
                last=("DrivePath(advTrajectory, $ADV_SPEED)",),
            ),
        },
        at=(6, 32, "how far the ego still is from where their ways meet when it sets off, at least"),
        given=frozenset((Action.CROSS,)),
        closing=8,
        constants=('advTurn = ("straight", "left-turn", "right-turn")',),
        in_way=True,
        waiting=(WAITS, COMES_UP + "$ACT_DISTANCE"),
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
        waiting=(WAITS,),
    ),
}

ON_FOOT: dict[Position, Start] = {
    Position.ROADSIDE: STARTS[Position.ROADSIDE],
    Position.AHEAD: Start(
        path="egoRoute",
        opening=(f"{COMES} until headway(egoRoute, ego, self) < $ADV_DISTANCE",),
        steps={Action.STOP: ACROSS[Action.STOP], Action.ACCELERATE: ACROSS[Action.ACCELERATE]},
        at=(12, 30, _TO_IT),
        constants=("advAlong = 0",),
        waiting=(f"{COMES} for $WAIT seconds",),
    ),
    Position.BEYOND: STARTS[Position.BEYOND],
}
"""The same for somebody on foot: where else one starts, there are no steps."""


_OFF = "TurnOff(-1.3 if offsetFrom(egoRoute, self) > 0 else 1.3, $TURN_SPEED, 7)"
_ACROSS_EGO = Step(does=(_OFF, "MoveAhead($TURN_SPEED) for 1.5 seconds"), last=(_OFF, "MoveAhead($TURN_SPEED)"))
_NEXT_LANE_AT_JUNCTION = Start(
    path="advLane",
    opening=(f"PaceOnPath(advLane, ego, $LEAD, 16, $LEAST) until {BEFORE_EVENT}",),
    steps={**_BESIDE, Action.TURN_LEFT: _ACROSS_EGO, Action.TURN_RIGHT: _ACROSS_EGO},
    at=(5, 16, _BEFORE),
    closing=8,
    waiting=("BrakeOnPath(advLane, 1) for $WAIT seconds",),
)
AT_JUNCTION: dict[Position, Start] = {
    Position.ONCOMING: replace(
        STARTS[Position.CROSSING],
        steps=_without(STARTS[Position.CROSSING].steps, Action.CROSS),
        given=frozenset((Action.ONCOMING,)),
    ),
    Position.BESIDE: _NEXT_LANE_AT_JUNCTION,
    Position.AHEAD_BESIDE: replace(_NEXT_LANE_AT_JUNCTION, steps=_without(_NEXT_LANE_AT_JUNCTION.steps, Action.PACE)),
}
"""The same at a junction, where it is another."""


RANGES: dict[str, tuple[float, float, str, str]] = {
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
    "TURN_SPEED": (4, 6, "m/s", "how fast it turns across the ego's lane"),
    "WAIT": (0.3, 3, "s", "how long it waits before it moves, or acts"),
    "ACT_DISTANCE": (0, 12, "m", "how far before the place where their ways meet it acts"),
}
"""The parameters of steps but for speed and trigger: range, unit, meaning."""
PAST = 6.5, 10.0  # [m], how far ahead somebody is who has overtaken and then does something else
BACKING_UP_TO_EGO = 3.0, 8.0  # [s], for how long somebody backs up before an ego that stands
BACKING = 1.0, 1.8  # [s], for how long somebody backs up who then does something else
PAUSE = 0.4, 1.2  # [s], how long somebody stands who comes from beside the road: the ego is near
