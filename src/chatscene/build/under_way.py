"""Somebody from when its first deed is due: how fast it comes to where it meets the ego, how far and how long."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from chatscene.build.asked import Meets, stands_first
from chatscene.build.chain import meeting_of
from chatscene.build.contact import touches
from chatscene.build.deeds import GO
from chatscene.build.gaps import passes_where_it_goes_over
from chatscene.build.hooking import AT_ENTRY, hooks_at, road_to_turn, turns_at_entry
from chatscene.build.over_lanes import lane_after
from chatscene.build.paces import CRAWLS, Pace
from chatscene.build.place import LANE, NEXT_LANE, at_junction, leaves_by_ramp
from chatscene.build.timing import Course, course
from chatscene.terms.vocabulary import INTO_OURS, Act, Tempo, acts_of

if TYPE_CHECKING:
    from chatscene.build.phases import Phases

SOONER = 0.8  # [s] than the ego somebody comes over from a stand that is not to be struck
BEGUN = 0.8  # [s]: what is done so long before the ego is there is seen to begin
LATEST = 12.0  # [s] that somebody goes with the ego before it does anything
OVER_LANE = 3.0  # [s] in which somebody at speed is in the next lane
RAMP_LANE = -1  # the lane that leads to a ramp, counted from the ego's to the left
INSIDE = 3.0  # [m] before where the ways meet: who does something there does it in the ego's sight
IS_OPEN = 1.5  # [s] before the ego is there that somebody begins to open a door
BRAKE = re.compile(r"BrakeOnPath\([^,]+, ([$\w.]+)\)")


@dataclass(slots=True)
class UnderWay:
    """A road user from when its first deed is due to where it meets the ego.

    Attributes:
        phases: Of whom.
        first: The number of the first deed that is not to stand from the beginning.
        bodies: The phases of that deed and of all that follow.
        near: How far [m] it goes before it comes into the ego's lane by a deed.
    """

    phases: Phases
    first: int
    bodies: list[list[str]]
    near: float

    @property
    def ahead(self) -> Course:
        """Where it is when its last deed begins, since the first did: computed anew, as ranges change meanwhile."""
        actor = self.phases.actor
        drives = actor.stand.meets in (Meets.ALONG, Meets.TOWARD) and not self.phases.stands()
        return self.phases.begins(self.bodies, Course(speed=actor.numbers.middle("SPEED") if drives else 0.0))

    def _comes_close(self) -> Iterator[str]:
        """The phase in which it comes so close through a junction that it does the first deed in time."""
        actor, deed, steps = self.phases.actor, self.phases.actor.deeds[self.first], self.phases.steps[self.first]
        if actor.stand.meets is not Meets.THROUGH or steps.lasting or deed.act is Act.SET_OFF:
            return
        brakes = BRAKE.match(self.bodies[0][0])
        room = INSIDE + (self._from_line() or 0.0)
        if not brakes:
            under_way = Course(speed=self._wish())
            room += self.phases.begins(self.bodies, under_way).metres
        stops = f"brakingDistance(self){f' / {brakes[1]}' if brakes else ''}"
        yield f"{self._go()} until {actor.stand.left} < {stops} + {room:.3g}"

    def _from_line(self) -> float | None:
        """How far [m] it has from before a junction to where the ways meet, if it stops there and then goes on."""
        actor, found = self.phases.actor, self.phases.actor.stand.found
        stops = bool(self.bodies[0]) and BRAKE.match(self.bodies[0][0]) is not None
        if found is None or not stops or (len(self.bodies) == 1 and actor.deeds[self.first].act is not Act.YIELD):
            return None
        return found.meets_at - found.entry + 0.5 * actor.limits.length

    def _go(self) -> str:
        return GO.replace("$SPEED", f"${self._speed()}")

    def _speed(self) -> str:
        """The parameter of the speed at which it comes to where it meets the ego."""
        paces = self.phases.paces
        comes = [k for k, steps in enumerate(self.phases.steps) if steps.comes_in and k > self.first]
        if self.near > 0.0 and comes:
            return paces.after[comes[0]].name or "SPEED"
        keeps = self.phases.steps[self.first].pace is Pace.KEEPS
        gains = self.phases.steps[self.first].pace is Pace.GAINS and paces.before[self.first].high <= CRAWLS
        speed = (paces.after if keeps or gains else paces.before)[self.first]
        return speed.name or "SPEED"

    def _takes(self) -> float:
        """How long [s] it takes about to where it meets the ego, at its speed."""
        heads = self.phases.actor.stand.meets in (Meets.THROUGH, Meets.TOWARD, Meets.ACROSS)
        return self._to_meet() / self._wish() if heads else 0.0

    def _wish(self) -> float:
        return self.phases.actor.numbers.middle(self._speed())

    def _wait(self) -> float:
        """How much longer [s] it takes: by gaining speed, and by all that it does before its last deed.

        Who is not met does it before the ego meets another, who may end the scene.
        """
        actor = self.phases.actor
        return self._alone() + (0.0 if actor.soon is None else max(0.0, actor.met - actor.soon))

    def _until_met(self) -> float:
        """How long [s] it takes from when its first deed is due to where it meets the ego, or to its last deed."""
        phases, meeting = self.phases, meeting_of(self.phases.actor)
        close = course(self._comes_close(), phases.actor.numbers, phases.body, Course(), meeting)
        bodies = [text for body in self.bodies for text in body]
        met = course([*bodies, self._go()], phases.actor.numbers, phases.body, close, meeting).met
        begins = phases.begins(self.bodies, close, meeting).seconds
        over = met > 0.0 and met < begins + BEGUN and phases.actor.stand.meets is Meets.ACROSS
        if over and len(self.bodies) > 1 and not phases.steps[-1].comes_in:
            begins += BEGUN  # what it does on its way over
        return max(met, begins)

    def _alone(self) -> float:
        """The same, of who is met."""
        actor, stand = self.phases.actor, self.phases.actor.stand
        if stand.meets in (Meets.THROUGH, Meets.ACROSS) and stand.left != "0":
            return self._until_met() - self._takes()
        more = self.ahead.seconds
        match stand.meets:
            case Meets.THROUGH | Meets.TOWARD | Meets.ACROSS:
                lost = max(0.0, self.phases.body.covers(self._to_meet(), self._wish()) - self._takes())
                comes = 0.0 if any(one.comes_in for one in self.phases.steps) else self._takes() + lost
                late = more - self.near / self._wish() - comes
                return lost + (late if self.near > 0.0 else max(0.0, late))
            case Meets.KERB if actor.deeds[-1].act is Act.OPEN_DOOR:
                return IS_OPEN
            case Meets.KERB:  # it is in the lane once it has gone its own length and the width of a lane
                return self.phases.body.covers(actor.limits.length + LANE, self._wish()) + more
            case Meets.ALONG if stands_first(actor.one) and not stand.behind:
                gains = actor.deeds[-1].act in acts_of(Tempo.GAINS)  # the ego closes in on it while it is slow yet
                return self._from_a_stand() + (0.0 if gains else more)
            case _:
                return self._going_along(more)

    def _going_along(self, more: float) -> float:
        """The same, of who goes along with the ego, by how much longer [s] it takes until its last deed begins."""
        actor = self.phases.actor
        if hooks_at(actor) is not None:  # the ego is so far from there when it begins to pass
            return road_to_turn(actor) / actor.ego_speed
        # of a slow ego, which is long in coming, long before it is there
        soon = max(0.0, actor.ego.time_at(actor.found.route.eventAt) - LATEST)
        before = 2.0 if at_junction(actor.ledger.situation) else 1.0
        if turns_at_entry(actor, self.first):
            before = AT_ENTRY
        if passes_where_it_goes_over(actor):
            before = -(actor.ego.late or 0.0)
        return before + more + soon + self._to_ramp() / actor.ego_speed

    def _to_ramp(self) -> float:
        """How far [m] before the nose of a ramp somebody sets out for that who leaves by it; 0 of others."""
        actor = self.phases.actor
        if not leaves_by_ramp(actor.ledger.situation, actor.one):
            return 0.0
        k = next(k for k, deed in enumerate(actor.deeds) if deed.act is Act.EXIT)
        lanes, speed = abs(lane_after(actor.one, actor.deeds, k - 1) - RAMP_LANE), self.phases.paces.before[k]
        return lanes * OVER_LANE * (actor.numbers.middle(speed.name) if speed.name else actor.along_speed)

    def _from_a_stand(self) -> float:
        """How long [s] before the ego somebody sets off that stood in its lane, or comes over into that."""
        actor = self.phases.actor
        if actor.one.starts.where not in NEXT_LANE or actor.deeds[self.first].act not in INTO_OURS:
            return 3.6
        over = self.phases.body.covers(0.5 * actor.limits.length + LANE, self._wish())
        return over + (0.0 if touches(actor.ledger.situation, actor.one) else SOONER)

    def _to_meet(self) -> float:
        """How far [m] it has about to where it meets the ego."""
        return meeting_of(self.phases.actor).metres
