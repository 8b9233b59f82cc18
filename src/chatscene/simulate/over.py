"""When a drive is over: nothing that was said is still to come, and nobody can meet the ego any more.

A program asks for it with `param drivesUntil = 'over'`; decision 0124 says what each number is for.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from chatscene.errors import ProgramError, no_such
from chatscene.simulate.obedience import Obedience
from chatscene.terms.episode import AT_REST, QUIET
from chatscene.terms.order import Order
from chatscene.terms.plan import PRIMITIVES, Phase, Plan, Until
from chatscene.terms.polyline import Polyline
from chatscene.terms.written_plans import WrittenPlan
from chatscene.world.bodies import Body, Vehicle

UNTIL = ("arrival", "over")  # what a program can say that a drive goes on until
LONG = 5.0  # [s] for which they only follow each other, or stand and wait for each other
APART = 3.0  # [s] between two at the speed of the faster
FOLLOWED, STRIDE = 16, 0.5  # for so many times both are followed, so many seconds apart
EVEN_SPEED, EVEN_HEADING = 0.5, 0.1  # [m/s], [rad] by which who goes on evenly differs
AS_FAR = 0.5  # [m] by which two that follow each other come nearer or apart
ROOM = 1.0  # [m] beside the ego's way within which somebody is in it
PASSED = 8.0  # [m] beyond its junction at which who waits for the ego sets off (`WaitFor`)


@dataclass(slots=True)
class Acting:
    """Somebody who acts, and when all that it does is done.

    Attributes:
        last: The phase from which on it does nothing new.
        waits: Of each phase, whether it ends by where somebody is, so that it does not while all stand.
        until: Where the ego is when it no longer waits for it: arc length [m] on the ego's route.
    """

    number: int
    last: int
    waits: tuple[bool, ...]
    until: float = -math.inf


@dataclass(slots=True)
class Over:
    """Watches a drive for its end.

    Attributes:
        bodies: Everybody, the ego first.
        dt: Step [s].
        beyond: Arc length [m] on its route beyond which an ego that drives has its manoeuvre behind it.
        settled: When the last light changes [s].
        wanted: What the ego drives at, if nothing holds it back [m/s].
        since: The step since which nothing happens; -1 while something does.
        even: Of each body, its speed [m/s], heading [rad] and distance from the ego [m] at that step.
    """

    bodies: Sequence[Body]
    line: Polyline
    dt: float
    acting: tuple[Acting, ...]
    beyond: float
    settled: float
    wanted: float
    moved: bool = False
    since: int = -1
    even: list[tuple[float, float, float]] = field(default_factory=list[tuple[float, float, float]])

    def look(self, step: int, along: float, phases: Mapping[int, int], held: Obedience) -> bool:
        """Take in a state; whether the drive is over with it.

        Args:
            step: Its number.
            along: Arc length [m] of the ego on its route.
            phases: How far everybody who acts is in it.
            held: What the ego is held to.
        """
        self.moved = self.moved or abs(self.bodies[0].speed) >= AT_REST
        together: list[int] = []
        lasts = self._lasts(step, along, phases, held, together)
        if not lasts:
            self.since = -1
            return False
        if self.since < 0 or not self._is_even(together):
            self.since, ego = step, self.bodies[0]
            self.even = [(b.speed, b.heading, math.hypot(b.x - ego.x, b.y - ego.y)) for b in self.bodies]
        return (step - self.since) * self.dt >= lasts

    def _is_even(self, together: Sequence[int]) -> bool:
        """Whether everybody but the ego goes on as when it became quiet, and those with the ego come no nearer to it.

        They are as far from it, or draw away from an ego that keeps its speed.
        """
        ego = self.bodies[0]
        steady = abs(ego.speed - self.even[0][0]) <= EVEN_SPEED
        for body, (speed, heading, _) in list(zip(self.bodies, self.even, strict=True))[1:]:
            if abs(body.speed - speed) > EVEN_SPEED or abs(body.heading - heading) > EVEN_HEADING:
                return False
        for i in together:
            body = self.bodies[i]
            away = math.hypot(body.x - ego.x, body.y - ego.y) - self.even[i][2]
            if away < -AS_FAR or (away > AS_FAR and not steady):
                return False
        return True

    def _lasts(self, step: int, along: float, phases: Mapping[int, int], held: Obedience, together: list[int]) -> float:
        """How long [s] it has to remain as it is for the drive to be over; 0 where something is to come.

        Those who are neither parted from the ego nor stand as it does are added to `together`.
        """
        time, rests = step * self.dt, abs(self.bodies[0].speed) < AT_REST
        if (waits := self._waits(along, phases)) is None or (waits and not rests):
            return 0.0
        if any(is_to_come(*one, along, rests=rests) for one in held.since(time)):
            return 0.0
        stays = any(order.at_most == 0.0 for order in held.orders)  # where it stands, by an order that has no end
        if rests and not (self.moved or stays):
            return 0.0
        if along < self.beyond and (not rests or time < self.settled):
            return 0.0
        for i in range(1, len(self.bodies)):
            body = self.bodies[i]
            if rests and abs(body.speed) < AT_REST:
                continue
            if waits:
                return 0.0
            if not self._is_parted(body, along, rests=rests):
                together.append(i)
        return LONG if waits or together else QUIET

    def _waits(self, along: float, phases: Mapping[int, int]) -> bool | None:
        """Whether somebody waits until somebody else is somewhere; None where anything else is still to be done."""
        waits = False
        for one in self.acting:
            phase = phases[one.number]
            if phase < one.last or along < one.until:
                if phase < one.last and not one.waits[phase]:
                    return None
                waits = True
        return waits

    def _is_parted(self, body: Body, along: float, *, rests: bool) -> bool:
        """Whether somebody draws away from the ego, is far from it, and remains so if both go on."""
        ego = self.bodies[0]
        dx, dy = body.x - ego.x, body.y - ego.y
        vx, vy = body.speed * body.cos, body.speed * body.sin
        if isinstance(body, Vehicle) and body.spin is not None:
            vx, vy = body.speed * math.cos(body.course), body.speed * math.sin(body.course)
        if dx * (vx - ego.speed * ego.cos) + dy * (vy - ego.speed * ego.sin) <= 0.0:
            return False
        fast, other = abs(ego.speed), abs(body.speed)
        least = APART * (other if other > fast else fast) + ego.radius + body.radius
        if math.hypot(dx, dy) <= least:
            return False
        if not rests and body.speed <= self.wanted:  # else the ego does not come up to who is ahead of it
            at, beside, _ = self.line.project(body.x, body.y)
            if at > along and abs(beside) < ego.half_width + body.radius + ROOM:
                return False
        for k in range(1, FOLLOWED + 1):
            time = k * STRIDE
            x, y = self.line.point_at(along + fast * time)
            if math.hypot(body.x + vx * time - x, body.y + vy * time - y) <= least:
                return False
        return True


def is_to_come(order: Order, time: float, along: float, *, rests: bool) -> bool:
    """Whether something of an order is still to come.

    Args:
        order: The order.
        time: For how long it counts [s]; -inf of one that waits for somebody.
        along: Arc length [m] of the ego on its route.
        rests: Whether the ego stands, so that it comes to no other place.
    """
    if time < order.since + (0.0 if math.isnan(order.aside) else order.over):
        return True
    return time < order.till < math.inf or (not rests and along < order.place)


def over_of(
    params: Mapping[str, Any], objects: Sequence[Any], plans: Mapping[str, WrittenPlan | str], **known: Any
) -> Over | None:
    """What watches a drive for its end; None where its program does not ask for it, or does what no plan says.

    Raises:
        ProgramError: There is no such end.
    """
    until = params.get("drivesUntil", "arrival")
    if until not in UNTIL:
        raise ProgramError(no_such("drivesUntil", str(until), UNTIL))
    if until != "over" or len(objects) == 1:  # whom nothing is to happen to: it drives to the end of its route
        return None
    acting: list[Acting] = []
    for number, one in enumerate(objects):
        if one.behavior is None:
            continue
        if (plan := plan_of(one.behavior, plans)) is None:
            return None
        held_up = any(phase.primitive == "WaitFor" for phase in plan.phases)
        exit_at = objects[0].route.exitAt if held_up else -math.inf
        waits = tuple(isinstance(phase.end, Until) for phase in plan.phases)
        acting.append(Acting(number, last_of(plan), waits, exit_at + PASSED))
    return Over(acting=tuple(acting), beyond=objects[0].route.exitAt, **known)


def plan_of(behavior: Any, plans: Mapping[str, WrittenPlan | str]) -> Plan | None:
    """What a behavior does, if that is a plan of the program's own or one thing that a plan can do."""
    name = type(behavior).__name__
    written = plans.get(name)
    if isinstance(written, WrittenPlan):
        return written.plan
    return Plan(phases=(Phase(name),)) if written is None and name in PRIMITIVES else None


def last_of(plan: Plan) -> int:
    """The phase from which on a plan does nothing new; one that it never comes to where it begins again."""
    last = plan.phases[-1]
    if plan.loop is not None:
        return len(plan.phases) + 1
    return len(plan.phases) - (last.end is None and not PRIMITIVES[last.primitive].ends)
