"""What is done for each act, by how somebody comes to meet the ego: the tables of steps, a row for each act.

A new act has a row in `ALONG`. The others are made from that, but for the acts that they do in another way:

- `TOWARD` and `BESIDE`, of who comes against the ego and of who is in the next lane;
- `ACROSS`, of who heads over the road, on foot or riding (`ACROSS_RIDING`): the row of an act that only changes speed
  is told in its words, if its phases are nothing but ``DrivePath``, ``ThrottleOnPath``, ``BrakeOnPath`` and ``Halt``.

An act that no table has in a place is refused there by name.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace

from chatscene.build.asked import Meets
from chatscene.build.paces import Pace
from chatscene.terms.vocabulary import Act, Heads, Tempo

BACKS_AT, BACKS_GAIN = 1.5, 2.0  # [m/s], and [m/s²] about with which it gets there: who turns round in three backs so
TURNED_ROUND = 2.9  # [rad] of turning round, after which it drives along the lane it is in
STILL = "self.pose[3] < 0.05"
UNDER_WAY = "self.pose[3] > {held} * $SPEED"
"""It is as fast as it wants to be; ``{held}`` is the share of that speed that its pedals hold."""
OWN = "ownLane(egoRoute)"


def _none() -> dict[str, str]:
    return {}


@dataclass(frozen=True, slots=True, kw_only=True)
class Steps:
    """How an act is done.

    In texts ``$NAME`` is a parameter, whose range is in `chatscene.build.numbers`. What stands in braces is filled in:

    - lines: ``{p}``, which it goes along; ``{beside}``, of the lane beside that; ``{next}``, of one farther off;
      ``{ours}``, the ego's; ``{home}``, of its own side of the road; ``{exit}``, of a ramp;
    - numbers: ``{held}``, the share of a speed that its pedals hold; ``{aside}``, 1 or -1 for the side; ``{meets}``,
      where on the ego's route it meets it; ``{period}`` and ``{weaves}`` of weaving; ``{drift}``, ``{back}`` and
      ``{round}``, for how long it drifts, goes back, turns to the road.

    Attributes:
        does: The phases, where something else follows, or it is said for how long it does this.
        last: The phases where neither is so; empty for the same, and going on then.
        way: The line it goes along from then on; empty for the same.
        binds: For each amount that a deed may have, the parameter it binds.
        lasting: Whether it is what somebody does who only goes on.
        still: Whether it stands then.
        going: Whether it must be under way before.
        pace: What it does to the speed.
        comes_in: Whether it must be outside the ego's lane before.
    """

    does: tuple[str, ...]
    last: tuple[str, ...] = ()
    way: str = ""
    binds: Mapping[str, str] = field(default_factory=_none)
    lasting: bool = False
    still: bool = False
    going: bool = False
    pace: Pace = Pace.KEEPS
    comes_in: bool = False


def _each(acts: Iterable[Act], steps: Steps) -> dict[Act, Steps]:
    return dict.fromkeys(acts, steps)


def _paced(room: str, fastest: str = "25") -> Steps:
    """Goes as far behind somebody, ``ego``, as a parameter has it, and no faster than that [m/s]."""
    pace = f"PaceOnPath({{p}}, ego, -(ego.length + self.length) / 2 - ${room}, {fastest})"
    binds = {"distance": room, "time": "PACE_TIME"}
    return Steps(does=(f"{pace} for $PACE_TIME seconds",), last=(pace,), binds=binds, lasting=True)


SLOW_FOR = 2.0  # [s] that somebody goes on at the speed that it has lost some to
GO = "DrivePath({p}, $SPEED)"
BRAKES = f"BrakeOnPath({{p}}, $BRAKE) until {STILL}"
_EASES = "BrakeOnPath({p}, $EASE) until self.pose[3] < $SLOW"
EASES = 0.6  # of its brakes, of who slows down to turn
_TO_TURN = f"BrakeOnPath({{p}}, {EASES:g}) until self.pose[3] < 1.1 * $SLOW"  # what its body turns at, or it slides on
_BY = "Halt() until progressOn(egoRoute, ego)[0] > {meets} + 6"
_TURNS = (Act.TURN_LEFT, Act.TURN_RIGHT)
_GOES = Steps(
    does=(GO + " for $GO_TIME seconds",),
    last=(GO,),
    binds={"speed": "SPEED", "time": "GO_TIME", "distance": "GO_TIME"},
    lasting=True,
)
_STANDS = Steps(
    does=(f"BrakeOnPath({{p}}, 1) until {STILL}", "BrakeOnPath({p}, 1) for $STOP_TIME seconds"),
    last=("BrakeOnPath({p}, 1)",),
    binds={"time": "STOP_TIME"},
    lasting=True,
    still=True,
    pace=Pace.STANDS,
)
_INTO_OWN = Steps(
    does=(f"DrivePath({OWN}, $SPEED) until abs(offsetFrom({OWN}, self)) < 0.8",), way=OWN, binds={"speed": "SPEED"}
)
SLIDES = Steps(
    does=(f"Slide(0.3 * $SPIN, $SLIDE) until {STILL}", "Halt() for $STOP_TIME seconds"),
    last=(f"Slide(0.3 * $SPIN, $SLIDE) until {STILL}", "Halt()"),
    still=True,
    going=True,
    pace=Pace.STANDS,
)
"""How somebody falls who rides: what has fallen slides on, and turns a little."""
_SPINS = (
    "SwerveOnPath({p}, $SPEED, {aside} * $SWERVE) for 0.8 seconds",
    f"Slide({{aside}} * $SPIN, $SLIDE) until {STILL}",
)
_LEAVES = (
    "DrivePath({p}, $SPEED, {aside} * $OFF) for 1.8 seconds",
    f"BrakeOnPath({{p}}, $BRAKE, {{aside}} * $OFF) until {STILL}",
)


def _to_a_stand(row: tuple[str, ...]) -> Steps:
    """Who comes to a stand by a row of steps, and stays there."""
    stands = (*row, "Halt() for $STOP_TIME seconds")
    return Steps(does=stands, last=(*row, "Halt()"), still=True, going=True, pace=Pace.STANDS)


ALONG: dict[Act, Steps] = {
    **_each((Act.GO_ALONG, Act.GO_STRAIGHT, Act.FOLLOW, Act.EXIT, *_TURNS), _GOES),
    Act.STAND: _STANDS,
    Act.BRAKE: Steps(
        does=("BrakeOnPath({p}, $BRAKE) for $BRAKE_TIME seconds",),
        last=("BrakeOnPath({p}, $BRAKE)",),
        binds={"acceleration": "BRAKE", "time": "BRAKE_TIME"},
        going=True,
        pace=Pace.ENDS,
    ),
    **_each(
        (Act.STOP, Act.FALL),
        Steps(
            does=(BRAKES, "Halt() for $STOP_TIME seconds"),
            last=(BRAKES, "Halt()"),
            binds={"acceleration": "BRAKE", "time": "STOP_TIME"},
            still=True,
            going=True,
            pace=Pace.STANDS,
        ),
    ),
    Act.LOSE_CONTROL: _to_a_stand(_SPINS),
    Act.SLOW_DOWN: Steps(
        does=(_EASES, f"DrivePath({{p}}, $SLOW) for {SLOW_FOR:g} seconds"),
        last=(_EASES, "DrivePath({p}, $SLOW)"),
        binds={"speed": "SLOW"},
        going=True,
        pace=Pace.LOSES,
    ),
    Act.ACCELERATE: Steps(
        does=("ThrottleOnPath({p}, $THROTTLE, 0, $FAST) until self.pose[3] > {held} * $FAST",),
        last=("ThrottleOnPath({p}, $THROTTLE, 0, $FAST)",),
        binds={"acceleration": "THROTTLE", "speed": "FAST"},
        going=True,
        pace=Pace.GAINS,
    ),
    Act.SET_OFF: Steps(does=(GO + " for 3 seconds",), last=(GO,), binds={"speed": "SPEED"}),
    Act.REVERSE: Steps(
        does=(BRAKES, "ReverseStraight($BACK) for $BACK_TIME seconds"),
        last=(BRAKES, "ReverseStraight($BACK) for $BACK_TIME seconds", "Halt()"),
        binds={"speed": "BACK", "time": "BACK_TIME"},
        still=True,
        pace=Pace.STANDS,
    ),
    Act.HESITATE: Steps(
        does=(BRAKES, "Halt() for $STOP_TIME seconds", f"{GO} until {UNDER_WAY}"),
        binds={"time": "STOP_TIME"},
        going=True,
    ),
    **_each(
        (Act.TURN_BACK, Act.U_TURN),
        Steps(
            does=(_TO_TURN, "TurnOff(3, $SLOW, 5)"),
            last=(_TO_TURN, "TurnOff(3, $SLOW, 5)", "MoveAhead($SPEED)"),
            binds={"speed": "SLOW"},
            going=True,
            pace=Pace.ENDS,
        ),
    ),
    Act.WEAVE: Steps(
        does=("WeaveOnPath({p}, $SPEED, $AMPLITUDE, {period}) for {weaves} seconds",),
        last=("WeaveOnPath({p}, $SPEED, $AMPLITUDE, {period})",),
        binds={"speed": "SPEED"},
    ),
    Act.SWERVE: Steps(
        does=("SwerveOnPath({p}, $SPEED, {aside} * $SWERVE) for $SWERVE_TIME seconds",),
        binds={"speed": "SPEED", "time": "SWERVE_TIME", "distance": "SWERVE"},
    ),
    Act.DRIFT: Steps(
        does=tuple(
            f"DrivePath({{p}}, $SPEED, {{aside}} * {k} * $DRIFT) for {{drift}} seconds" for k in (0.3, 0.6, 0.9)
        ),
        last=(
            *(f"DrivePath({{p}}, $SPEED, {{aside}} * {k} * $DRIFT) for {{drift}} seconds" for k in (0.3, 0.6, 0.9)),
            "DrivePath({p}, $SPEED, {aside} * $DRIFT)",
        ),
        binds={"speed": "SPEED", "distance": "DRIFT"},
    ),
    Act.KEEP_LEVEL: Steps(
        does=("PaceOnPath({p}, ego, $LEVEL, 25, 2) for $PACE_TIME seconds",),
        last=("PaceOnPath({p}, ego, $LEVEL, 25, 2)",),
        binds={"time": "PACE_TIME"},
        lasting=True,
    ),
    Act.TAILGATE: _paced("GAP"),
    **_each((Act.CUT_IN, Act.MERGE, Act.ENTER), _INTO_OWN),
    Act.LANE_CHANGE: _INTO_OWN,
    Act.CUT_OUT: Steps(
        does=("DrivePath({beside}, $SPEED) until abs(offsetFrom({beside}, self)) < 0.8",),
        way="{beside}",
        binds={"speed": "SPEED"},
    ),
    Act.OVERTAKE: Steps(
        does=(
            "DrivePath({beside}, $FAST) until headway(egoRoute, ego, self) > (ego.length + self.length) / 2 + $AHEAD",
            f"DrivePath({OWN}, $FAST) until abs(offsetFrom({OWN}, self)) < 1",
            f"BrakeOnPath({OWN}, $EASE) until self.pose[3] < 1.05 * $SPEED",
        ),
        way=OWN,
        binds={"speed": "FAST", "distance": "AHEAD"},
    ),
    Act.PULL_OUT: Steps(
        does=(
            "DrivePath({p}, 3) for 0.3 seconds",
            f"DrivePath({OWN}, $SPEED) until abs(offsetFrom({OWN}, self)) < 1.1",
        ),
        way=OWN,
        binds={"speed": "SPEED"},
    ),
    Act.CROSS: replace(_GOES, lasting=False),
    Act.OPEN_DOOR: Steps(does=("Park() for 3 seconds",), last=("Park()",), still=True, pace=Pace.STANDS),
    Act.DROP_LOAD: Steps(does=(GO + " for 2 seconds",), last=(GO,), going=True),
    Act.PARK: Steps(
        does=("DrivePath({p}, $SLOW, -3) for 3 seconds", BRAKES),
        last=("DrivePath({p}, $SLOW, -3) for 3 seconds", BRAKES, "Halt()"),
        binds={"speed": "SLOW"},
        still=True,
        going=True,
        pace=Pace.STANDS,
    ),
    Act.LEAVE_ROAD: _to_a_stand(_LEAVES),
    Act.YIELD: Steps(does=(BRAKES, _BY), last=(BRAKES, _BY, GO), still=True, going=True, pace=Pace.STANDS),
}
"""Of somebody who goes the ego's way, comes through a junction, or leaves the kerb."""
INTO_NEXT = Steps(
    does=("DrivePath({next}, $SPEED) until abs(offsetFrom({next}, self)) < 0.8",),
    way="{next}",
    binds={"speed": "SPEED"},
)
"""Of somebody who changes to a lane that is not next to the ego's."""
OFF_BY_RAMP = Steps(
    does=("DrivePath({exit}, $SPEED) until abs(offsetFrom({exit}, self)) < 0.8",),
    last=("DrivePath({exit}, $SPEED)",),
    way="{exit}",
    binds={"speed": "SPEED"},
)
"""Of somebody who goes along and leaves the road by a ramp."""
_INTO_OURS = Steps(
    does=("DrivePath({ours}, $SPEED) until abs(offsetFrom(egoRoute, self)) < 1",),
    way="{ours}",
    binds={"speed": "SPEED"},
)


def _turns_off(turn: str) -> Steps:
    """Slows down to what it turns with, turns, and goes on that way."""
    return Steps(does=(_TO_TURN, turn), last=(_TO_TURN, turn, "MoveAhead($SLOW)"), binds={"speed": "SLOW"})


_OFF_LEFT, _OFF_RIGHT = "TurnOff(1.3, $SLOW, 7)", "TurnOff(-1.3, $SLOW, 7)"
TOWARD: dict[Act, Steps] = {
    **ALONG,
    **_each((Act.OVERTAKE, Act.ENTER, Act.LANE_CHANGE, Act.CUT_IN), _INTO_OURS),
    Act.TURN_LEFT: _turns_off(_OFF_LEFT),
    Act.TURN_RIGHT: _turns_off(_OFF_RIGHT),
}
"""Of somebody who comes against the ego."""
OFF = {Act.TURN_LEFT: "TurnOff(1.4, $SLOW, 7)", Act.TURN_RIGHT: "TurnOff(-1.4, $SLOW, 7)"}
"""Of somebody who goes along beside the ego and turns off across its way."""
_ENTRY = {Act.TURN_LEFT: 6.0, Act.TURN_RIGHT: 1.5}
"""How far [m] behind the entry of a junction a turn begins."""


def turning_off(act: Act, *, junction: bool) -> Steps:
    """How somebody before or behind the ego turns off: at the junction, or off the road wherever it is."""
    there = f"DrivePath({{p}}, $SLOW) until progressOn(egoRoute, self)[0] > egoRoute.eventAt + {_ENTRY[act]:g}"
    does = (there, OFF[act])
    return (
        Steps(does=does, last=(*does, "MoveAhead($SLOW)"), binds={"speed": "SLOW"})
        if junction
        else _turns_off(OFF[act])
    )


def must_slow(at: float) -> str:
    """When somebody must slow down to turn so far [m] beyond the event of the ego's way, as a program says it."""
    there = f"egoRoute.eventAt {'-' if at < 0.0 else '+'} {abs(at):.3g}"
    return f"progressOn(egoRoute, self)[0] + brakingDistance(self) / {EASES:g} > {there}"


def by_way_off(at: float, ends: float | None, *, comes: bool) -> Steps:
    """How somebody leaves the ego's road along the way that leads into an arm of its junction, or into a driveway.

    Args:
        at: How far [m] beyond the event of the ego's way that begins to turn.
        ends: How long [m] that way is, at the end of which it halts; None where it leads on.
        comes: Whether it comes driving, and so slows down before.
    """
    slows = (f"DrivePath({{p}}, $SPEED) until {must_slow(at)}", _TO_TURN)
    off = "DrivePath({off}, $SLOW)"
    left = f"distanceLeft({{off}}, self, {ends:.1f}) < brakingDistance(self) + self.length / 2 + 1" if ends else ""
    before, binds = slows if comes else (), {"speed": "SLOW"}
    does, last = (*before, f"{off} for 3 seconds"), (*before, off)
    if ends:
        does = last = (*before, f"{off} until {left}", "Halt()")
    return Steps(does=does, last=last, way="{off}", binds=binds)


def turning_round(radius: float, speed: float, *, first: float = 0.0, back: float = 0.0) -> Steps:
    """How somebody turns round on the road, into the lane of those who come against it.

    Args:
        radius: Of its circle [m].
        speed: At which it turns, if none was said [m/s].
        first: How far it turns before it backs [rad]; 0 if it turns in one go.
        back: How far it then backs [m].
    """
    wish = "$SLOW" if speed <= 0.0 else f"{speed:.3g}"
    slows = f"BrakeOnPath({{p}}, 0.6) until self.pose[3] < 1.1 * {wish}"
    turns = (f"TurnOff({TURNED_ROUND - first:.3g}, {wish}, {radius:.3g})",)
    if first:
        stands = f"Halt() until {STILL}"
        backs = f"ReverseStraight({BACKS_AT:g}) for {back / BACKS_AT + 0.5 * BACKS_AT / BACKS_GAIN:.2g} seconds"
        turns = (f"TurnOff({first:.3g}, {wish}, {radius:.3g})", stands, backs, stands, *turns)
    return Steps(
        does=(slows, *turns, f"DrivePath({{home}}, {wish}) for 2 seconds"),
        last=(slows, *turns, "DrivePath({home}, $SPEED)"),
        way="{home}",
        binds={"speed": "SLOW"},
        pace=Pace.ENDS,
    )


def pulls_out(clear: float) -> Steps:
    """How somebody behind another overtakes it: it comes up to that while it pulls out, and then gets by.

    Args:
        clear: How far aside of its lane [m] it is clear of whom it passes.
    """
    row = ALONG[Act.OVERTAKE]
    near = "-(ego.length + self.length) / 2 - 1"
    out = f"PaceOnPath({{beside}}, ego, {near}, $FAST) until abs(offsetFrom({OWN}, self)) > {clear:.3g}"
    return replace(row, does=(out, *row.does))


def goes_on_beside(steps: Steps) -> Steps:
    """The same of who passes somebody in a lane that is closed: it goes on beside that, and does not come back."""
    passes = steps.does[:2]
    return replace(steps, does=passes, last=(*passes, "DrivePath({beside}, $FAST)"), way="{beside}")


def seen_to_pass(steps: Steps) -> Steps:
    """The same; it comes up first, so that the phase in which it passes begins when it is beside whom it passes."""
    comes = (
        steps.does[0].partition(" until ")[0] + " until headway(egoRoute, ego, self) > -(ego.length + self.length) / 2"
    )
    return replace(steps, does=(comes, *steps.does), last=(comes, *steps.last) if steps.last else ())


TURNED_IN = 1.2  # [s] from when somebody turns the wheel until it is where the ego's side is


def gets_by(*, comes_back: bool) -> Steps:
    """How somebody beside the ego gets by, along its own line; perhaps into the ego's lane then."""
    row = ALONG[Act.OVERTAKE]
    passes = row.does[0].replace("{beside}", "{p}")
    if comes_back:
        return replace(row, does=(passes, *row.does[1:]))
    eases = "BrakeOnPath({p}, $EASE) until self.pose[3] < 1.05 * $SPEED"
    return replace(row, does=(passes,), last=(passes, eases, GO), way="")


def sideswipes(level: float) -> Steps:
    """How somebody who passes the ego comes over into its side: so that it is level with a part of it then.

    Args:
        level: How far [m] ahead of the ego's middle the part is that it touches.
    """
    gains = f"{TURNED_IN:g} * max(0, self.pose[3] - ego.pose[3])"
    passes = f"DrivePath({{p}}, $FAST) until headway(egoRoute, ego, self) > {level:.3g} - {gains}"
    over = f"DrivePath({OWN}, $FAST)"
    return replace(ALONG[Act.OVERTAKE], does=(passes, f"{over} for 3 seconds"), last=(passes, over))


SEEN_OUT = 2.8  # [m] from the middle of the ego's lane, from which on who comes into it is seen to come
NEAR_TO_MEET = 3.0  # [s] before they would meet that the ego is to answer to who comes against it in its lane


def near_to_pass(steps: Steps) -> Steps:
    """How somebody passes another against the ego that answers to that: the last of it begins once the two are near."""
    out, passes, *back = steps.does
    by = passes.partition(" until ")[2]
    near = f"gap(self, {{we}}) < (self.pose[3] + {{we}}.pose[3]) * {NEAR_TO_MEET:g}"  # ``ego`` is whom it passes
    does = (out, f"{passes.partition(' until ')[0]} until {near} or {by}", passes, *back)
    return replace(steps, does=does, last=(*does, *steps.last[len(steps.does) :]) if steps.last else ())


def passes_against(*, comes_back: bool, aside: float = 0.0) -> Steps:
    """How somebody who comes against the ego passes another: out in the ego's lane, by, and back then.

    Args:
        comes_back: Whether it does.
        aside: How far [m] from the middle of the ego's lane, toward its own, it then goes.
    """
    by = "headway(egoRoute, self, ego) > (ego.length + self.length) / 2 + $AHEAD"  # ``ego`` is then whom it passes
    line = f"{{ours}}.offset({-aside:g})" if aside else "{ours}"
    out = f"DrivePath({line}, $FAST) until abs(offsetFrom({{ours}}, self)) < {SEEN_OUT:g}"
    passes = f"DrivePath({line}, $FAST) until {by}"
    binds = {"speed": "FAST", "distance": "AHEAD"}
    if not comes_back:
        return Steps(does=(out, passes), way="{ours}", binds=binds)
    does = (out, passes, "DrivePath({home}, $FAST) until abs(offsetFrom({home}, self)) < 0.8")
    return Steps(does=does, last=(*does, "DrivePath({home}, $FAST)"), way="{home}", binds=binds)


COMES_BACK = Steps(
    does=("DrivePath({home}, $SPEED) until abs(offsetFrom({home}, self)) < 0.8",),
    way="{home}",
    binds={"speed": "SPEED"},
)
"""Of somebody who comes against the ego in its lane, and goes back to the lane that it came from."""


def yielding_to(name: str, *, against: bool = False, through: bool = False) -> Steps:
    """How somebody lets another by: until that came over its line and is off it, or came by from against it.

    Through a junction, who comes onto its line may go on along that: then until it is beyond where the ego comes.
    """
    past = f"headway(egoRoute, self, {name}) > (self.length + {name}.length) / 2"
    if against:
        return Steps(does=(BRAKES, f"Halt() until {past}"), still=True, going=True, pace=Pace.STANDS)
    *on, off = (f"Halt() until abs(offsetFrom({{p}}, {name})) {sign}" for sign in ("< 2.5", "> 3"))
    if through:
        by_before = f" or distanceLeft(way{name}, {name}, meet{name}) < 0"
        on = f"Halt() for {SEEN_TO_STAND:g} seconds", on[0] + by_before
        off = f"{off} or distanceLeft({{p}}, {name}, meet{{i}}) < 0"
    by = (*on, off)
    return Steps(does=(BRAKES, *by), last=(BRAKES, *by, GO), still=True, going=True, pace=Pace.STANDS)


SETS_OFF_BEHIND = Steps(does=(GO + " until self.pose[3] > 1",), last=(GO,), binds={"speed": "SPEED"})
"""Of somebody who sets off behind an ego that stands, and then does something else: it is under way at once."""


def lets_by(name: str) -> Steps:
    """How somebody who heads over the road lets another by: it stands until that is level with it, and past."""
    past = (
        f"Halt() until abs(offsetFrom(way{name}, self)) < 20 and headway(way{name}, self, {name}) > {name}.length / 2"
    )
    return replace(ACROSS[Act.YIELD], does=(_STOOD, past), last=(_STOOD, past, MOVE))


SEEN_TO_STAND = 0.5  # [s]
BEHIND_ANOTHER = _paced("ROOM")
"""Of somebody who follows another: ``ego`` is then whom it follows."""
AS_FAST_BEHIND = replace(_paced("ROOM", "$SPEED"), binds={**BEHIND_ANOTHER.binds, "speed": "SPEED"})
"""The same, no faster than was said."""
DRIFTS_OVER = Steps(
    does=(
        *(f"DrivePath({{p}}, $SPEED, {{aside}} * {k * 1.2:g}) for {{drift}} seconds" for k in (1, 2)),
        *_INTO_OWN.does,
    ),
    way=OWN,
    binds={"speed": "SPEED"},
)
"""Of somebody who drifts out of the next lane all over into the ego's."""
BRAKES_TO = Steps(
    does=("BrakeOnPath({p}, $BRAKE) until self.pose[3] < $SLOW", f"DrivePath({{p}}, $SLOW) for {SLOW_FOR:g} seconds"),
    last=("BrakeOnPath({p}, $BRAKE) until self.pose[3] < $SLOW", "DrivePath({p}, $SLOW)"),
    binds={"acceleration": "BRAKE", "speed": "SLOW"},
    going=True,
    pace=Pace.LOSES,
)
"""Of somebody who brakes to a speed."""
BESIDE: dict[Act, Steps] = {
    **ALONG,
    **{act: Steps(does=(off,), last=(off, "MoveAhead($SLOW)"), binds={"speed": "SLOW"}) for act, off in OFF.items()},
}
"""Of somebody who goes along, but not through a junction."""
MOVE = "MoveAhead($SPEED)"
_STOOD = "Halt() until self.pose[3] < 0.1"
RESTS = MOVE + " until restsWithin(egoRoute, self, 0.5)"
"""Comes so near that it stands in the ego's way if it halts."""
BARRED = (
    "ego.pose[3] < 0.3 and abs(headway(egoRoute, self, ego)) < ego.length / 2 + 0.6"
    " and 1 < abs(offsetFrom(egoRoute, self)) and abs(offsetFrom(egoRoute, self)) < 2"
)
"""The ego stands where somebody on foot is to go on."""
RESTS_THERE = "brakingDistance(self) - 2"
"""How far [m] from where its way comes near the ego's somebody still goes who stands in that if it brakes."""
_OVER = Steps(
    does=(MOVE + " until abs(offsetFrom(egoRoute, self)) < 1",), last=(MOVE,), binds={"speed": "SPEED"}, comes_in=True
)
_AROUND = "TurnOff(3.1 if offsetFrom(egoRoute, self) > 0 else -3.1, $SLOW, 2)"
ROUND, ROUND_ON_FOOT = "TurnOff(3.1, $SLOW, 2)", "MoveAhead($SPEED, 3.14159) for {round} seconds"
"""Turns to the road again."""
_BACK = "MoveAhead($SPEED, 3.14159)"
_IN_ITS_WORDS = (
    (re.compile(r"DrivePath\(\{p\}, (\$\w+)\)"), r"MoveAhead(\1)"),
    (re.compile(r"ThrottleOnPath\(\{p\}, \$THROTTLE, 0, (\$\w+)\)"), r"MoveAhead(\1)"),
    (re.compile(r"BrakeOnPath\(\{p\}, [$\w.]+\)"), "Halt()"),
)
_ITS_PHASE = re.compile(r"(?:MoveAhead|Halt)\((?:(?!\{(?!held\})).)*")


def over_the_road(steps: Steps) -> Steps | None:
    """The row of who goes along the road as somebody does it who heads over that; None if it cannot be told so."""

    def told(text: str) -> str:
        for along, across in _IN_ITS_WORDS:
            text = along.sub(across, text)
        return text

    does, last = tuple(map(told, steps.does)), tuple(map(told, steps.last))
    if steps.way or not all(_ITS_PHASE.fullmatch(text) for text in does + last):
        return None
    read = set(re.findall(r"\$(\w+)", " ".join(does + last)))
    binds = {amount: name for amount, name in steps.binds.items() if name in read}
    return replace(steps, does=does, last=last, binds=binds)


def _as_along() -> dict[Act, Steps]:
    """The acts that only change speed, told in the words of who heads over the road."""
    paces = (act for act in ALONG if act.row.heads is Heads.ANY and act.row.tempo is not Tempo.ANY)
    return {act: steps for act in paces if (steps := over_the_road(ALONG[act])) is not None}


ACROSS: dict[Act, Steps] = {
    **_as_along(),
    **_each((Act.CROSS, Act.GO_STRAIGHT), _OVER),
    Act.SET_OFF: Steps(does=(f"{MOVE} until {UNDER_WAY}",), last=(MOVE,), binds={"speed": "SPEED"}),
    Act.ENTER: Steps(does=_OVER.does, last=(RESTS, "Halt()"), binds={"speed": "SPEED"}, still=True, comes_in=True),
    Act.STAND: Steps(
        does=(_STOOD, "Halt() for $STOP_TIME seconds"),
        last=("Halt()",),
        binds={"time": "STOP_TIME"},
        lasting=True,
        still=True,
        pace=Pace.STANDS,
    ),
    **_each(
        (Act.STOP, Act.BRAKE, Act.FALL),
        Steps(
            does=(_STOOD, "Halt() for $STOP_TIME seconds"),
            last=("Halt()",),
            binds={"time": "STOP_TIME"},
            still=True,
            going=True,
            pace=Pace.STANDS,
        ),
    ),
    Act.HESITATE: Steps(
        does=(_STOOD, "Halt() for $STOP_TIME seconds", f"{MOVE} until {UNDER_WAY}"),
        last=(_STOOD, "Halt() for $STOP_TIME seconds", MOVE),
        binds={"time": "STOP_TIME"},
        going=True,
    ),
    Act.ACCELERATE: Steps(
        does=("MoveAhead($FAST) until self.pose[3] > {held} * $FAST",),
        last=("MoveAhead($FAST)",),
        binds={"speed": "FAST"},
        going=True,
        pace=Pace.GAINS,
    ),
    Act.SLOW_DOWN: Steps(
        does=(f"MoveAhead($SLOW) for {SLOW_FOR:g} seconds",),
        last=("MoveAhead($SLOW)",),
        binds={"speed": "SLOW"},
        going=True,
        pace=Pace.LOSES,
    ),
    Act.YIELD: Steps(does=(_STOOD, _BY), last=(_STOOD, _BY, MOVE), still=True, going=True, pace=Pace.STANDS),
    Act.TURN_BACK: Steps(does=(_BACK + " for {back} seconds",), last=(_BACK,), binds={"speed": "SPEED"}, going=True),
    Act.GO_ALONG: Steps(
        does=(MOVE + " for $GO_TIME seconds",),
        last=(MOVE,),
        binds={"speed": "SPEED", "time": "GO_TIME", "distance": "GO_TIME"},
        lasting=True,
    ),
}
"""Of somebody who heads over the road."""
SHIES = Steps(
    does=tuple(f"MoveAhead($SPEED, {{aside}} * {turn}) for $SWERVE_TIME seconds" for turn in (1.2, -1.2)),
    binds={"speed": "SPEED", "time": "SWERVE_TIME"},
)
"""Of somebody on foot, or an animal, who goes along the road and leaves its line abruptly: aside, and on along it."""
LOSES_SLOWLY = ACROSS[Act.SLOW_DOWN]
_BACK_OVER = "ReverseStraight($SPEED) until "
ACROSS_RIDING = {
    **ACROSS,
    Act.REVERSE: Steps(
        does=(_BACK_OVER + "abs(offsetFrom(egoRoute, self)) < 1",),
        last=(_BACK_OVER + "restsWithin(egoRoute, self, 0.5)", "Halt()"),
        binds={"speed": "SPEED"},
        comes_in=True,
    ),
    Act.TURN_BACK: Steps(
        does=(_AROUND, MOVE + " for {back} seconds"), last=(_AROUND, MOVE), binds={"speed": "SPEED"}, going=True
    ),
}


STEPS_BACK = Steps(
    does=(_STOOD, _BACK + " for {back} seconds"), last=(_STOOD, _BACK), binds={"speed": "SPEED"}, pace=Pace.KEEPS
)
"""Of somebody on foot who goes back to where it came from: it turns round to."""
BACK_OUT = Steps(
    does=(_STOOD, "ReverseStraight($BACK) for $BACK_TIME seconds"),
    last=(_STOOD, "ReverseStraight($BACK) for $BACK_TIME seconds", "Halt()"),
    binds={"speed": "BACK", "time": "BACK_TIME"},
    still=True,
    pace=Pace.STANDS,
)
"""Of somebody on wheels who came into the ego's lane from beside it, and backs out of it again."""


def steps_for(meets: Meets, *, walks: bool, beside: bool) -> Mapping[Act, Steps]:
    """How acts are done by somebody.

    Args:
        meets: How it comes to meet the ego.
        walks: Whether it is on foot.
        beside: Whether it is in the lane beside the ego's.
    """
    match meets:
        case Meets.ACROSS:
            return ACROSS if walks else ACROSS_RIDING
        case Meets.TOWARD:
            return TOWARD
        case Meets.ALONG if beside:
            return BESIDE
        case _:
            return ALONG
