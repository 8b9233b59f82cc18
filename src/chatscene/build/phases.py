"""The phases of one road user: its deeds one after the other, at speeds that are seen to differ, and begun in time."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

from chatscene.build.aim import STOOD, set_offset, set_time_to_meet
from chatscene.build.aside import comes_aside, goes_by, goes_round, grazes, line_aside, sign_of_side
from chatscene.build.asked import Meets, stands_first, stays_after_turning, stops_in_the_way, stops_on_its_way
from chatscene.build.choosing import is_in_ours, steps_of
from chatscene.build.contact import misses, parts_of_door, touches
from chatscene.build.deeds import (
    BARRED,
    BEHIND_ANOTHER,
    GO,
    MOVE,
    RESTS,
    RESTS_THERE,
    ROUND,
    ROUND_ON_FOOT,
    UNDER_WAY,
    Steps,
)
from chatscene.build.facing import OVER
from chatscene.build.gaps import (
    LOSES,
    comes_in,
    gap_is_said,
    gets_ahead,
    goes_before,
    keeps_before,
    keeps_its_speed,
    seconds_to_get_ahead,
    seconds_to_get_by,
)
from chatscene.build.halting import halts_at
from chatscene.build.hooking import AT_ENTRY, hooks_at, slows_to_turn, take_road_to_turn, turns_at_entry
from chatscene.build.lateral import led_aside
from chatscene.build.local import breaks, check_turn
from chatscene.build.numbered import held_at, of_deed, renamed
from chatscene.build.opening import Opening
from chatscene.build.over_lanes import lane_after
from chatscene.build.paces import CRAWLS, Pace, Paces, Speed, paces_of, set_passing_speed
from chatscene.build.place import NEXT_LANE, at_roundabout, leaves_by_ramp
from chatscene.build.reacting import (
    LOCKS,
    SLOWED,
    closes_up,
    ego_slows,
    goes_until_ego_slows,
    late_then,
    swerves_slowed,
)
from chatscene.build.relations import grip_of
from chatscene.build.struck import strikes
from chatscene.build.timing import Body, Course, Meeting, course
from chatscene.build.towards import to_whom
from chatscene.build.waiting import when_of
from chatscene.errors import NotBuilt, NothingBuilds
from chatscene.situations.phrases import one_of
from chatscene.terms.actors import Limits
from chatscene.terms.situation import EGO
from chatscene.terms.vocabulary import (
    ENDS,
    HALTS,
    SIDEWAYS,
    STOPS,
    Act,
    Heads,
    Manner,
    Role,
    Striker,
    Tempo,
    Where,
    acts_of,
)

if TYPE_CHECKING:
    from chatscene.build.actor import Actor

GOES_ON = 1.2  # of its own length that somebody goes who is seen to go on
AS_SAID, LONGEST = 0.86, 12.0  # of a speed that was said; [s] that it is waited for
ON_FOOT, ROUNDS_IN = 1.2, 0.2  # [s] in which somebody on foot turns round at least; longer than it takes to stand
RUN_UP = 15.0  # [m] that somebody beside the road may need to get under way
STAYS = acts_of(Tempo.GAINS, Heads.DRIFTS)  # it goes on so, whatever time that took
OPENS_BEFORE, OPENS_INTO = (-1.1, -0.5), (-1.4, -1.1)  # [s] later than one could stop for it that a door is opened
OPENS_IN_TIME = (-0.6, 1.0)  # [s] sooner than the ego could just stop for it that one is opened beside its lane
OPENS_AHEAD = (0.5, 1.5)  # [s] sooner than usual that one is opened in the lane that the ego comes along
_PACED = BEHIND_ANOTHER.last[0]
OUT_AGAIN = acts_of(Tempo.SETS_OFF, Heads.ROUND, Heads.FROM_EDGE, Heads.OVER, Heads.BEFORE, Heads.IN)
COMES_BY = "headway(egoRoute, self, ego) > -(self.length + ego.length) / 2 - 3 - 0.5 * ego.pose[3] or ego.pose[3] < 0.3"
"""When the ego is about to pass whoever has parked, or waits behind it."""
OUTSIDE = 2.5  # [m] from the ego's line: who is as far is outside its lane


def _on_road(limits: Limits, grip: float) -> Limits:
    """What a body can do where the road holds so much [m/s²]."""
    return replace(limits, brake=min(limits.brake, grip), throttle=min(limits.throttle, grip))


_ALONG = re.compile(r"^MoveAhead\([^,]+\) for")
_FOR = re.compile(r" for \S+ seconds$")
_FOR_TIME = re.compile(r" for \$(?:PACE|GO)_TIME seconds$")


@dataclass(slots=True)
class Phases:
    """The deeds of a road user that are being made into phases.

    Attributes:
        actor: Who.
        steps: For each deed, how it is done.
        paces: How fast it is before and after each.
        body: What its body can do.
        due_after: For each deed, how many phases come before that in which it is done, the last of its own; of who
            passes another, before that in which it is beside it.
    """

    actor: Actor
    steps: list[Steps] = field(init=False)
    paces: Paces = field(init=False)
    body: Body = field(init=False)
    due_after: list[int] = field(init=False, default_factory=list[int])

    def texts(self) -> tuple[str, ...]:
        """What it does until its first deed is due, then deed after deed; empty for what only lies or hides."""
        actor = self.actor
        one, deeds = actor.one, actor.deeds
        for k, deed in enumerate(deeds):
            broken = [f"{actor.path}.does.{k}.breaks"] if breaks(actor, deed) else []
            if actor.stand.slants and deed.manner is Manner.SLANTING and deed.act in OVER:
                actor.ledger.take(f"{actor.path}.does.{k}.manner")
            actor.ledger.take(f"{actor.path}.does.{k}.act", *broken)
            if deed.act is Act.FALL:
                actor.ledger.assume(f"{one.id} stays upright where it falls")
        in_the_way = any(other.hidden_by == one.id for other in actor.ledger.situation.others)
        hides = one.role is Role.HIDES or (in_the_way and one.role is Role.SUPPORTING)
        if actor.lies or (hides and all(deed.act is Act.STAND for deed in deeds)):
            return ("Halt()",) if one.role is Role.ADVERSARY else ()
        self.body = Body(_on_road(actor.limits, grip_of(actor.ledger.situation)), actor.walks)
        self.steps = [led_aside(actor, k, steps_of(actor, k)) for k in range(len(deeds))]
        self.paces = paces_of(actor, self.steps, self.body)
        if not any(deed.time is not None for deed in deeds):  # so far that it is seen to go on
            slowest = min((speed.low for speed in self.paces.after if speed.name and speed.low > 0.0), default=2.0)
            least = max(1.0, GOES_ON * actor.limits.length / slowest)
            actor.numbers.narrow("GO_TIME", least, least + 1.0)
        for k, steps in enumerate(self.steps):
            if steps.binds.get("speed") == "FAST" and deeds[k].act is Act.OVERTAKE:
                set_passing_speed(actor, k)
        self._set_moment()
        return tuple(self._all())

    def _set_moment(self) -> None:
        """When it does what it does first."""
        actor, deeds = self.actor, self.actor.deeds
        if actor.stand.meets in (Meets.THROUGH, Meets.ACROSS) or actor.stand.rolls:
            set_offset(actor)
            set_time_to_meet(actor)
        if deeds and turns_at_entry(actor, 0):
            actor.numbers.narrow("OFFSET", -AT_ENTRY, AT_ENTRY)
        if deeds and deeds[-1].act is Act.OPEN_DOOR and actor.stand.meets is Meets.KERB:
            self._set_door()

    def _set_door(self) -> None:
        """When a door is opened: before the ego comes to it, or too late for that to stop where the two touch."""
        actor, one = self.actor, self.actor.one
        if one.starts.where is Where.AHEAD:
            actor.numbers.narrow("OFFSET", *OPENS_AHEAD)
        elif not touches(actor.ledger.situation, one):
            actor.numbers.narrow("OFFSET", *OPENS_IN_TIME)
        else:
            contact = actor.ledger.situation.contact
            into = contact is not None and contact.striker is Striker.OTHER
            actor.numbers.narrow("OFFSET", *(OPENS_INTO if into else OPENS_BEFORE))
            actor.ledger.take(*parts_of_door(actor.ledger.situation, one))

    # All phases

    def _all(self) -> Iterator[str]:
        actor, meets = self.actor, self.actor.stand.meets
        go = MOVE if meets is Meets.ACROSS else GO
        if into := strikes(actor):
            self.due_after = [0] * len(actor.deeds)
            yield from into
            return
        if not actor.deeds:
            yield from self._careful((self._undirected(go),))
            return
        if all(deed.act is Act.STAND and deed.time is None for deed in actor.deeds):
            yield "Park()" if meets is not Meets.ACROSS else "Halt()"
            return
        first = 1 if actor.deeds[0].act is Act.STAND and actor.deeds[0].time is None else 0
        bodies = list(self._bodies(first, go))
        timed = self._without_way_along(first, bodies)
        near = self._comes_near(first, timed)
        opening = list(Opening(self, first, timed, near).texts())
        if hooks_at(actor) is not None:
            take_road_to_turn(actor)
        yield from opening
        self.due_after = [0] * first
        for body in bodies:
            before = sum(map(len, bodies[: len(self.due_after) - first]))
            passes = actor.deeds[len(self.due_after)].act is Act.OVERTAKE
            done = max((n for n, text in enumerate(body) if passes and "$AHEAD" in text), default=len(body) - 1)
            self.due_after.append(len(opening) + before + done)
            yield from body

    def _without_way_along(self, first: int, bodies: list[list[str]]) -> list[list[str]]:
        """The same for timing: who goes along the road before it turns to cross it gets no nearer by that."""
        over = next((k for k, deed in enumerate(self.actor.deeds) if deed.act in OVER), 0) - first
        if not self.actor.stand.over:
            return bodies
        return [
            [_ALONG.sub("Halt() for", text) for text in body] if k < over else body for k, body in enumerate(bodies)
        ]

    def _undirected(self, go: str) -> str:
        """What somebody does of whom no deed was said: who drives goes on, who is beside the road stands."""
        actor, meets = self.actor, self.actor.stand.meets
        if meets is Meets.ACROSS and actor.one.role is not Role.ADVERSARY:
            return "Halt()"
        if meets is Meets.ACROSS:
            actor.ledger.assume(f"{actor.one.id} crosses our lane")
        return "Park()" if meets is Meets.KERB else go

    def begins(self, bodies: list[list[str]], start: Course, meeting: Meeting | None = None) -> Course:
        """Where somebody is when its last deed is under way, and is to be seen when the ego is there."""
        actor, ahead = self.actor, start
        for body in bodies[:-1]:
            ahead = course(body, actor.numbers, self.body, ahead, meeting)
        gains = [text for text in bodies[-1] if "until self.pose[3] >" in text][:1] or list(_before_turn(bodies[-1]))
        once = actor.stand.meets is Meets.TOWARD or (actor.stand.behind and actor.ego.stands)
        if once and actor.deeds[-1].act is Act.DRIFT:  # it is over as they meet, which they do once
            gains = [text for text in bodies[-1] if _FOR.search(text)]
        begins = course(gains, actor.numbers, self.body, ahead, meeting)
        if actor.deeds[-1].speed is not None and self.steps[-1].pace in (Pace.KEEPS, Pace.GAINS):
            wish = self.paces.after[-1]
            if wish.name:  # until it is nearly as fast as was said
                reaches = f"MoveAhead(${wish.name}) until self.pose[3] > {AS_SAID:g} * ${wish.name}"
                reached = course([reaches], actor.numbers, self.body, begins, meeting)
                begins = replace(begins, seconds=min(reached.seconds, begins.seconds + LONGEST))
        takes = sum(
            seconds_to_get_by(actor, k)
            for k, deed in enumerate(actor.deeds)
            if f"FAST_{k}" in actor.numbers.ranges and deed.act is Act.OVERTAKE
        )
        takes += sum(seconds_to_get_ahead(actor, k) for k in range(len(actor.deeds)))
        if actor.stand.meets is Meets.ACROSS and stops_in_the_way(Meets.ACROSS, actor.deeds):
            takes += actor.numbers.middle("SPEED") / actor.limits.brake + STOOD
        far = takes * max((actor.numbers.middle(name) for name in actor.numbers.ranges if "FAST_" in name), default=0.0)
        return replace(begins, seconds=begins.seconds + takes, metres=begins.metres + far)

    def _comes_near(self, first: int, bodies: list[list[str]]) -> float:
        """How far [m] it goes before it comes into the ego's lane, which it needs more room for."""
        actor = self.actor
        if actor.stand.meets is not Meets.ACROSS:
            return 0.0
        later = [k for k in range(first, len(self.steps)) if self.steps[k].comes_in]
        if not later:
            return 0.0
        before = [text for body in bodies[: later[0] - first] for text in body]
        there = course(before, actor.numbers, self.body)
        near = there.metres
        if "$X" in actor.stand.point and actor.deeds[later[0]].speed is not None:
            there = self._run_up(later[0], there)
        metres = there.metres
        if metres > 0.0:
            if "$X" not in actor.stand.point:
                raise NotBuilt(
                    f"cannot be built yet: {actor.path}.does.{first}.act: {actor.deeds[first].act},"
                    f" {actor.one.starts.where}, before it is in our lane"
                )
            actor.numbers.move("X", metres)
        return near

    def _run_up(self, k: int, here: Course) -> Course:
        """Where it is as fast as was said of how it comes in."""
        gets = self._at(k, f"{MOVE} until {UNDER_WAY}")
        there = course([gets], self.actor.numbers, self.body, here)
        if there.metres - here.metres > RUN_UP:
            most = self._fastest(here)
            at = f"{self.actor.path}.does.{k}.speed: {self.actor.deeds[k].speed}"
            kind = one_of(self.actor.one.kind)
            raise NotBuilt(
                f"{at} is more than {kind} reaches when it sets off beside our lane; say {most} km/h at most"
            )
        if self.actor.deeds[k].act is Act.ENTER:  # and stops in the lane
            return replace(there, metres=there.metres + there.speed**2 / (2.0 * self.actor.limits.brake))
        return there

    def _fastest(self, here: Course) -> int:
        """The most whole km/h that it has, and is seen to hold, within `RUN_UP`."""

        def metres(kmh: int) -> float:
            wish = round(self.body.wish_for(kmh / 3.6), 6)
            held = self.paces.held(Speed(name="", low=wish, high=wish))
            gets = f"{MOVE} until {UNDER_WAY}".replace("{held}", f"{held:g}").replace("$SPEED", f"{wish:g}")
            return course([gets], self.actor.numbers, self.body, here).metres - here.metres

        most = int(3.6 * self.body.reaches(RUN_UP)) + 1
        return next((kmh for kmh in range(most, 1, -1) if metres(kmh) <= RUN_UP), 1)

    def _bodies(self, first: int, go: str) -> Iterator[list[str]]:
        """The phases of each deed."""
        actor = self.actor
        way, meanwhile, still, turned = None, go, self.stands(), False
        for k in range(first, len(actor.deeds)):
            steps, deed = self.steps[k], actor.deeds[k]
            body: list[str] = []
            if k > first and (near := goes_round(actor, k) or halts_at(actor, k) or slows_to_turn(actor, k)):
                body.append(f"{self._at(k, meanwhile)} until {near}")
            elif k > first and deed.when is not None:
                changes = steps.pace in (Pace.GAINS, Pace.LOSES)
                goes_on = _PACED if self.follows_until(k) else self._at(k, meanwhile, before=changes)
                body += when_of(actor, k, deed.when, goes_on)
            if k > first and deed.when is None and deed.act in OUT_AGAIN and actor.deeds[k - 1].act is Act.PARK:
                body.append(f"Halt() until {COMES_BY}")
            if steps.comes_in and turned:
                check_turn(actor, k)
                body += [f"{MOVE} until abs(offsetFrom(egoRoute, self)) > {OUTSIDE}"]
                takes = max(ON_FOOT, actor.seconds_to_turn(actor.numbers.middle("SPEED")) + ROUNDS_IN)
                body += [ROUND_ON_FOOT.replace("{round}", f"{takes:.2g}") if actor.walks else ROUND]
                turned = False
            if stops_on_its_way(actor.stand.meets, actor.deeds, k):
                near = RESTS if actor.stand.meets is Meets.ACROSS else f"{GO} until {actor.stand.left} < {RESTS_THERE}"
                body.append(self._at(k, near, before=True))
            elif self._must_get_going(k, still=still) and not (k == first and actor.stand.meets is Meets.THROUGH):
                if deed.act is not Act.GO_ALONG and goes_before(actor, k) and actor.deeds[k - 1].act in LOSES:
                    body.append(keeps_before(actor, way or "{p}"))
                else:
                    body += self._gets_going(k, first, meanwhile)
            body += self._of(k, steps, way, still=still, last=k == len(actor.deeds) - 1, go=meanwhile)
            way = steps.way or line_aside(actor, k, way) or way
            if actor.stand.meets is not Meets.ACROSS and way:
                meanwhile = GO.replace("{p}", way)
            still = steps.pace is Pace.STANDS
            turned ^= deed.act is Act.TURN_BACK
            yield body

    def follows_until(self, k: int) -> bool:
        """Whether somebody in the ego's lane behind it does something once the ego does: until then it keeps behind."""
        actor, when = self.actor, self.actor.deeds[k].when
        named = (when.after, when.during) if when is not None else ()
        waits = any(name is not None and name.startswith(f"{EGO}.") for name in named)
        left = not SIDEWAYS.isdisjoint(deed.act for deed in actor.deeds[:k])
        behind = actor.stand.meets is Meets.ALONG and actor.one.starts.where is Where.BEHIND and not left
        return waits and behind and not touches(actor.ledger.situation, actor.one)

    def _must_get_going(self, k: int, *, still: bool) -> bool:
        """Whether it must get under way before a deed, from a stand or to a speed that was chosen for it."""
        steps, before = self.steps[k], self.paces.before[k]
        twice = k > 0 and self.actor.deeds[k].act is self.actor.deeds[k - 1].act is Act.BRAKE
        if twice and self.actor.stand.meets is not Meets.ACROSS:
            return True
        backs = k > 0 and self.actor.deeds[k - 1].act is Act.REVERSE and self.actor.deeds[k].act in ENDS
        if still and k > 0 and self.actor.walks and self.actor.deeds[k].act in acts_of(Heads.BACK):  # where it stands
            return False
        if self.goes_on_braking(k) or backs or not steps.going or (steps.pace is Pace.GAINS and before.high <= CRAWLS):
            return False
        return still or (bool(before.name) and steps.pace is not Pace.GAINS)

    def goes_on_braking(self, k: int) -> bool:
        """Whether it comes to a stand by the braking that it has begun."""
        deeds = self.actor.deeds
        across = self.actor.stand.meets is Meets.ACROSS
        stops = deeds[k].act is Act.STOP and k > 0 and deeds[k].when is None and not across
        return stops and deeds[k - 1].act in acts_of(Tempo.BRAKES, Tempo.SLOWS)

    def stands(self) -> bool:
        """Whether it stands before its first deed."""
        meets = self.actor.stand.meets
        waits = meets is Meets.KERB or (meets is Meets.ACROSS and self.actor.stand.left != "0")
        return stands_first(self.actor.one) or (waits and not self.actor.stand.rolls)

    def _gets_going(self, k: int, first: int, go: str) -> Iterator[str]:
        """It gets under way, and if it comes over the road, near to the ego's lane."""
        gets = self._at(k, f"{go} until {UNDER_WAY}", before=True)
        yield gets
        actor, deed = self.actor, self.actor.deeds[k].act
        rolls = actor.stand.rolls and actor.stand.meets is Meets.ACROSS
        if not (rolls or "$X" in actor.stand.point) or k != first or any(one.comes_in for one in self.steps[k:]):
            return
        if not rolls:
            metres = course([gets], actor.numbers, self.body).metres
            if metres > RUN_UP:
                return
            actor.numbers.move("X", metres)
        near = RESTS if deed in ENDS else f"{MOVE} until abs(offsetFrom(egoRoute, self)) < {OUTSIDE}"
        yield self._at(k, near, before=True)

    def _at(self, k: int, text: str, *, before: bool = False) -> str:
        """A phase at the speed that it has before or in a deed."""
        speed = (self.paces.before if before else self.paces.after)[k]
        return held_at(self, renamed(text, "SPEED", speed.name or "SPEED"), speed)

    def _of(self, k: int, steps: Steps, way: str | None, *, still: bool, last: bool, go: str) -> Iterator[str]:
        actor, deed = self.actor, self.actor.deeds[k]
        far = deed.act is Act.GO_ALONG and deed.distance is not None
        ends = last and bool(steps.last) and ((deed.time is None and not far) or deed.act in STAYS)
        phases = steps.last if ends else steps.does
        if actor.stand.meets is Meets.ACROSS and (
            stops_on_its_way(Meets.ACROSS, actor.deeds, k + 1) or stays_after_turning(actor.deeds, k)
        ):
            phases = (RESTS,)  # who is fast is over our lane, if it brakes only once it is in that
        own = steps.way or line_aside(actor, k, way) or way
        if last and not ends:
            phases = (*phases, GO.replace("{p}", own) if own and actor.stand.meets is not Meets.ACROSS else go)
        if deed.act in STOPS | HALTS and actor.then(k) is Act.STAND and deed.time is None:
            phases = phases[:1]  # what comes then says how long
        if (
            deed.act is Act.STAND
            and still
            and deed.time is None
            and not last
            and k
            and actor.deeds[k - 1].time is not None
        ):
            return  # which it does already
        if deed.act in OVER and all(one.act not in OVER for one in actor.deeds[:k]) and actor.stand.over:
            phases = (phases[0].replace(MOVE, f"MoveAhead($SPEED, {actor.stand.over})"), *phases[1:])
        yield from gets_ahead(actor, k, way or "{p}", last=last)
        phases = closes_up(actor, k, self._beside_ego(k, phases, way or "{p}"), last=last)
        for text in self._careful(phases) if last else phases:
            said = to_whom(of_deed(self, k, text, steps), deed)
            said = said.replace("{meets}", actor.stand.ego_meets)
            if k + 1 < len(actor.deeds) and swerves_slowed(actor, k + 1) and deed.time is None:
                actor.numbers.narrow("BRAKE_TIME", *LOCKS)
            if swerves_slowed(actor, k):
                said = re.sub(r", (\$SPEED)(?![A-Z0-9_])", rf", {SLOWED:g} * \1", said)
            if goes_until_ego_slows(actor, k):
                said = _FOR_TIME.sub(f" until {ego_slows(actor)}", said)
            yield said.replace("{aside}", sign_of_side(actor, k)).replace("{p}", way or "{p}")
        yield from (text.replace("{p}", way or "{p}") for text in late_then(actor, k))
        self._take_side(k)

    def _beside_ego(self, k: int, phases: tuple[str, ...], way: str) -> tuple[str, ...]:
        """The phases of a deed by how far before the ego somebody is to be in it."""
        actor, deed = self.actor, self.actor.deeds[k]
        if deed.act in acts_of(Heads.ALONG, Heads.BEHIND) and goes_before(actor, k):
            return (keeps_before(actor, way),)
        if gap_is_said(deed) and deed.speed is None and not keeps_its_speed(actor, k):
            return (comes_in(actor, k), *phases[1:])
        return phases

    def _take_side(self, k: int) -> None:
        """Take to which side and to whom a deed is done, and tell what is not done of it."""
        actor, deed = self.actor, self.actor.deeds[k]
        if deed.act is Act.EXIT and actor.stand.meets is Meets.ALONG:
            self._check_exit(k)
        beside = actor.one.starts.where in NEXT_LANE and deed.act is Act.OVERTAKE
        if beside and deed.to not in (None, actor.one.starts.side):
            raise NothingBuilds(f"cannot be built yet: {actor.path}.does.{k}.to: {deed.to}, from the other side")
        if deed.to is not None and deed.act in acts_of(Heads.OUT, Heads.OVER, Heads.BY):
            into_ours = deed.act is Act.LANE_CHANGE and lane_after(actor.one, actor.deeds, k) == 0
            if not into_ours and actor.named.setdefault("side", str(deed.to)) != str(deed.to):
                raise NothingBuilds(f"cannot be built yet: {actor.path}.does.{k}.to: {deed.to}, after the other side")
            actor.ledger.take(f"{actor.path}.does.{k}.to")
        if deed.whom is not None:
            actor.ledger.take(f"{actor.path}.does.{k}.whom")

    def _check_exit(self, k: int) -> None:
        """Tell how somebody leaves the road that goes along with the ego, where it does not by a ramp.

        Raises:
            NotBuilt: At a junction, which has no ramp.
        """
        situation, one = self.actor.ledger.situation, self.actor.one
        if at_roundabout(situation):
            self.actor.ledger.assume(f"{one.id} takes the ego's exit of the roundabout, or stays in it")
        elif not leaves_by_ramp(situation, one):
            at = f"{self.actor.path}.does.{k}.act"
            raise NothingBuilds(f"cannot be built yet: {at}: {Act.EXIT} at a junction; say {Act.TURN_RIGHT}")

    def _careful(self, phases: tuple[str, ...]) -> tuple[str, ...]:
        """The last phases, of somebody on foot who is not to touch an ego that stands where it is to go on."""
        if grazes(self.actor) and phases[-1].startswith("DrivePath(") and "{home}" not in phases[-1]:
            return comes_aside(self.actor, phases)
        against = self.actor.stand.meets is Meets.TOWARD and self.actor.one.role is Role.SUPPORTING
        if not (misses(self.actor.ledger.situation, self.actor.one) or against):  # who is not met is not struck
            return phases
        drives = phases[-1].startswith(("DrivePath(", "PaceOnPath(")) and "{home}" not in phases[-1]
        if drives and self.actor.stand.meets is Meets.TOWARD and is_in_ours(self.actor, len(self.actor.deeds)):
            return goes_by(self.actor, phases)
        if not self.actor.walks or phases[-1] != MOVE:
            return phases
        return (*phases[:-1], f"{MOVE} until {BARRED}", "Halt()")


def _before_turn(body: list[str]) -> Iterator[str]:
    """What is done before somebody turns off or round: it slows down to what it turns with."""
    turns = next((n for n, text in enumerate(body) if text.startswith(("TurnOff(", "DrivePath({off}"))), 0)
    yield from (text for text in body[:turns] if "until self.pose[3] <" in text)
