"""What somebody does until its first deed is due, and when that is: so early that all that follow are begun in time."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace

from chatscene.build.alongside import goes_on_beside, goes_round_beside, until_it_comes, until_it_leaves
from chatscene.build.arriving import back_by_deeds
from chatscene.build.aside import goes_round
from chatscene.build.asked import Meets, stands_first, stops_ahead
from chatscene.build.chain import in_terms_of, meeting_of
from chatscene.build.contact import touches
from chatscene.build.cutting_in import comes_before
from chatscene.build.deeds import GO, MOVE
from chatscene.build.gaps import gets_ahead, seconds_to_get_ahead
from chatscene.build.halting import halts_at
from chatscene.build.hurrying import begins_nearer, goes_faster
from chatscene.build.naming import name_of
from chatscene.build.paces import CRAWLS, Pace, keeps_distance, slowest_with_ego
from chatscene.build.place import LANE, at_junction, room_against
from chatscene.build.reacting import ego_slows, goes_until_ego_slows, is_late, late_for_ego, reacts
from chatscene.build.relations import AGAINST, ALONG, grip_of
from chatscene.build.revealed import shows_slow
from chatscene.build.sideways import clears_in
from chatscene.build.starts import FARTHEST
from chatscene.build.timing import Course, Meeting, course
from chatscene.build.towards import done_to
from chatscene.build.under_way import BRAKE, INSIDE, UnderWay
from chatscene.build.waiting import when_of
from chatscene.errors import NotBuilt
from chatscene.maps.crossings import MEETING
from chatscene.terms.amount import Length
from chatscene.terms.scenario import Maneuver, Site
from chatscene.terms.situation import EGO, Other
from chatscene.terms.vocabulary import GOES_ON, HALTS, LOSES, STOPS, Act, Facing, Heads, Role, Where, acts_of

EGO_FIRST = 1.0  # [s] before somebody that the ego is by at most where it still meets it
BEHIND_IT = 3.0  # [m] behind whom it stops somebody stands
LASTS = 3.0  # [s] in which the last of what somebody does is seen
SPARE = 30.0  # [m] of road behind who comes against the ego, for those behind it
_ANYWHERE = (None, Site.MOTORWAY, Site.RURAL)
LETS_BY = 2.5  # [s] before somebody comes by that another brakes to let it by
NEAREST = 4.0  # [m] before a junction: who is nearer is in it
DRIVES = 1.0  # [s]: who drives so long before it brakes is seen to come driving
OPENS_FOR = 1.5  # [s] in which the ego comes to a door, at least, that is opened before it
STANDS = 0.6  # [s]: who stands so long before it sets off is seen to stand
GIVES_WAY = 1.0  # [m/s]: an ego that goes no faster yields
KEEPS_UP = 2.0  # [m/s] that somebody goes at least who goes with an ego that is faster
_GOES_THROUGH = acts_of(Heads.THROUGH, Heads.TURNS, Heads.IN)
LOSES_PATIENCE = 2.0  # [s] longer that it waits behind an ego that stands
SHORT = 25.0  # [m] before the end of a road, or before a junction: nobody is placed farther


@dataclass(slots=True)
class Opening(UnderWay):
    """The beginning of the phases of a road user: what it does until its first deed is due."""

    def texts(self) -> Iterator[str]:
        """What is done until the first deed is due."""
        actor, steps = self.phases.actor, self.phases.steps
        deed, when = actor.deeds[self.first], actor.deeds[self.first].when
        waits = self._waits()
        if actor.stand.rolls:
            self._come_from_afar()
        if near := goes_round(actor, self.first) or halts_at(actor, self.first):
            yield f"{waits} until {near}"
            return
        if when is not None:
            yield from when_of(actor, self.first, when, self._gets_ready(waits))
            self._check_in_time()
            if when.ego_within is not None or when.delay is not None or actor.stand.ego_meets == "egoRoute.eventAt":
                return
        if (beside := self._goes_beside()) is not None:
            yield from beside
            return
        lasting = all(one.lasting for one in steps)
        if (lasting or self._only_waits()) and (actor.stand.meets is Meets.ALONG or self._goes_along()):
            return
        soon = self._begins_soon()
        if not (actor.stand.rolls or soon):
            self._make_room()
            self._roll_up()
        goes = deed.act in acts_of(Heads.ALONG) and soon
        if (deed.time is not None and (goes or deed.act is Act.STAND)) or goes_until_ego_slows(actor, self.first):
            return  # it stands or goes so long, or goes on until then, from the beginning
        yield from self._is_due(waits, soon=soon)

    def _is_due(self, waits: str, *, soon: bool) -> Iterator[str]:
        """It stands if it does so at first, and goes on until its deed is due, if anybody comes for it."""
        both_stand = (
            stands_first(self.phases.actor.one) and self.phases.actor.ego.stands and self.phases.actor.stand.behind
        )
        if stands_first(self.phases.actor.one) and not self._opens_at_once():
            yield f"{waits} for {STANDS + (LOSES_PATIENCE if both_stand else 0.0):g} seconds"
        if not both_stand:
            yield from self._goes_on(waits, soon=soon)
            yield from self._comes_to_meet()

    def _goes_beside(self) -> Iterable[str] | None:
        """What is done by who goes along beside an ego that comes over its way; None of anybody else."""
        actor = self.phases.actor
        if goes_round_beside(actor):
            return (until_it_leaves(actor),)
        if goes_on_beside(actor) and actor.one.role is Role.ADVERSARY and actor.deeds[self.first].when is None:
            return (text.replace("SPEED", self._speed()) for text in until_it_comes(actor))
        return None

    def _gets_ready(self, waits: str) -> str:
        """What it does until its first deed is due: who is to come in before the ego meanwhile is ahead by then."""
        actor = self.phases.actor
        when = actor.deeds[self.first].when
        if when is None or when.during is None or not comes_before(actor, self.first):
            return waits
        gets = gets_ahead(actor, self.first, "{p}", last=len(actor.deeds) == self.first + 1)
        return next((text.partition(" until ")[0] for text in gets), waits)

    def _opens_at_once(self) -> bool:
        """Whether the ego is so near from the first, as was said, that a door is opened then or beside it."""
        actor = self.phases.actor
        far = actor.one.starts.distance
        opens = actor.deeds[-1].act is Act.OPEN_DOOR and actor.stand.meets is Meets.KERB
        return opens and far is not None and far.most < (STANDS + OPENS_FOR) * actor.ego_speed

    def _check_in_time(self) -> None:
        """Hold that who sets out once the ego is so near can still be in its way.

        Raises:
            NotBuilt: It would be there long after the ego.
        """
        actor, when = self.phases.actor, self.phases.actor.deeds[self.first].when
        over = actor.stand.meets in (Meets.THROUGH, Meets.ACROSS) and not actor.stand.rolls
        if when is None or when.ego_within is None or when.of not in (None, actor.one.id) or not over:
            return
        metres = isinstance(when.ego_within, Length)
        near = actor.numbers.range_of(f"NEAR_{self.first}")[1]
        has = near / actor.ego_speed if metres else near
        takes = self._until_there()
        for hurry in (begins_nearer, goes_faster):
            if takes - EGO_FIRST > has and actor.one.role is Role.ADVERSARY:
                hurry(actor)
                takes = self._until_there()
        least = takes - EGO_FIRST
        if least > has and actor.one.role is Role.ADVERSARY:
            say = f"{math.ceil(least * actor.ego_speed)} m" if metres else f"{math.ceil(10 * least) / 10:g} s"
            raise NotBuilt(
                f"impossible: {actor.path}.does.{self.first}.when.ego_within: {when.ego_within}: {actor.one.id} needs"
                f" {takes:.1f} s from its start into our way, and by then we have passed;"
                f" say {say} at least"
            )

    def _until_there(self) -> float:
        """How long [s] it takes from when its first deed is due until its nose is where it meets the ego."""
        actor, nose = self.phases.actor, 0.5 * self.phases.actor.limits.length
        if actor.stand.meets is not Meets.THROUGH or actor.deeds[self.first].act not in _GOES_THROUGH:
            return self._until_met() - nose / self._wish()
        meeting = meeting_of(actor)
        nearer = replace(meeting, metres=max(meeting.metres - nose, 0.0))
        there = course([*self.bodies[0], self._go()], actor.numbers, self.phases.body, Course(), nearer).met
        return there if there > 0.0 else self._until_met() - nose / self._wish()

    def _goes_on(self, waits: str, *, soon: bool) -> Iterator[str]:
        """It goes on, or waits, until its first deed is due, if that is not seen by how near it is to the ego."""
        actor = self.phases.actor
        if before := self._stands_before():
            yield f"{waits} until {self._is_near(name_of(before.id))}"
        elif self._stops_behind_ego():
            go = f"DrivePath({{p}}, ${self._speed()}, 0)"  # as fast as it is, however careful it else is
            yield f"{go} until {self._is_near(EGO)}"
        elif reacts(actor, self.first):
            yield f"{waits} until {ego_slows(actor)}"
            if is_late(actor) and actor.deeds[self.first].act in LOSES:
                yield late_for_ego(actor)
        elif soon:
            yield self._soon(waits)
        elif not actor.stand.rolls or actor.stand.meets is Meets.ALONG:
            if (held := self._held()) is not None:
                yield f"{waits} for {held} seconds"
            far = self._to_ramp()
            yield f"{waits} until {self._due() if far <= 0.0 else self._is_before_ramp(far)}"

    def _is_before_ramp(self, far: float) -> str:
        """When it is so far [m] before the nose of a ramp that it sets out for that once all before is done."""
        actor = self.phases.actor
        gains = sum(seconds_to_get_ahead(actor, k) for k in range(len(actor.deeds))) * actor.ego_speed
        return f"progressOn(egoRoute, self)[0] > egoRoute.eventAt - {far + self.ahead.metres + gains:.3g}"

    def _stands_before(self) -> Other | None:
        """Who stands before it in the ego's lane, if it stops and so stops behind that."""
        actor = self.phases.actor
        stops = actor.deeds[self.first].act in STOPS and stops_ahead(actor.one)
        return self._standing_ahead() if stops and actor.stand.meets is Meets.ALONG else None

    def _standing_ahead(self) -> Other | None:
        others = (one for one in self.phases.actor.ledger.situation.others if one.id != self.phases.actor.one.id)
        return next((one for one in others if one.starts.where is Where.AHEAD and stands_first(one)), None)

    def _stops_behind_ego(self) -> bool:
        """Whether it comes up behind an ego that stands, and stops there."""
        actor = self.phases.actor
        struck = touches(actor.ledger.situation, actor.one)
        behind = actor.one.starts.where is Where.BEHIND and not actor.stand.rolls and actor.ego.stands
        return behind and actor.deeds[self.first].act in STOPS and not (struck and actor.one.role is Role.ADVERSARY)

    def _is_near(self, name: str) -> str:
        """When it is so near to who stands before it that it must brake to stand behind that."""
        actor = self.phases.actor
        hard = min(actor.limits.brake, grip_of(actor.ledger.situation))
        braking = f"self.pose[3] * self.pose[3] / (2 * $BRAKE * {hard:.3g})"
        line = "{p}" if name == EGO else "egoRoute"  # which begins where the ego does
        return f"headway({line}, self, {name}) < {braking} + (self.length + {name}.length) / 2 + {BEHIND_IT:g}"

    def _soon(self, waits: str) -> str:
        """It goes on for a while, as it began."""
        actor = self.phases.actor
        actor.takes = (actor.numbers.range_of("STEADY")[1] + self.ahead.seconds + LASTS) * actor.ego_speed
        return f"{waits} for $STEADY seconds"

    def _comes_to_meet(self) -> Iterator[str]:
        """It goes on until it is so near to the ego, or to the junction, that its first deed is due."""
        actor, steps = self.phases.actor, self.phases.steps
        yields_to = done_to(actor.deeds[self.first]) if actor.deeds[self.first].act is Act.YIELD else EGO
        if actor.stand.meets is Meets.TOWARD and yields_to != EGO:  # until that one is near
            name = name_of(yields_to)
            yield f"{self._go()} until gap(self, {name}) < brakingDistance(self) * 2 + {name}.pose[3] * {LETS_BY:g}"
        elif actor.stand.meets is Meets.TOWARD and not steps[self.first].lasting:
            lead = "(self.pose[3] + ego.pose[3]) * $LEAD_TIME"
            yields = actor.deeds[self.first].act is Act.YIELD  # what follows is done once the ego is by
            yield f"{self._go()} until gap(self, ego) < {lead if yields else self._far(lead)}"
        yield from self._comes_close()

    def _roll_up(self) -> None:
        """Let who stops before a junction, and then goes on, come driving from so far that it does that in time."""
        actor, from_line = self.phases.actor, self._from_line()
        one, ego, numbers, phases = actor.one, actor.ego, actor.numbers, self.phases
        said = one.starts.distance is not None or one.hidden_by is not None or actor.deeds[self.first].when is not None
        if from_line is None or said or stands_first(one) or actor.first is not None or ego.late is None:
            return
        brake = BRAKE.match(self.bodies[0][0])
        assert brake is not None
        room, hard = INSIDE + from_line, 2.0 * actor.limits.brake
        texts = [text for body in self.bodies for text in body]

        def takes() -> float:
            share = numbers.middle(brake[1][1:]) if brake[1].startswith("$") else float(brake[1])
            meeting = Meeting(metres=room + self._wish() ** 2 / (hard * share), beyond=MEETING)
            return course([*texts, self._go()], numbers, phases.body, Course(speed=self._wish()), meeting).met

        _, early, *_ = numbers.range_of("OFFSET")
        actor.needs = takes() + early + DRIVES
        speed = f"${self._speed()}"
        drives = (
            f"{ego.seconds('egoMeet{i}', actor.meets_at)} - ({in_terms_of(numbers, (*texts, speed), takes)}) - $OFFSET"
        )
        back = f"{room:.3g} + {speed} * {speed} / ({hard:g} * {brake[1]}) + {speed} * maximum(0, {drives})"
        actor.stand = replace(actor.stand, at=f"backFrom(meet{{i}}, {back})", rolls=True)

    def _only_waits(self) -> bool:
        """Whether it only goes on until somebody else has done what its first deed that does not last waits for."""
        actor = self.phases.actor
        first = next(k for k, steps in enumerate(self.phases.steps) if not steps.lasting)
        when = actor.deeds[first].when
        waits = (when.after or when.during or "") if when is not None else ""
        return first > self.first and waits.partition(".")[0] not in ("", EGO, actor.one.id)

    def _come_from_afar(self) -> None:
        """Let who comes driving be so far off that it does all before it meets the ego, or as it does."""
        actor = self.phases.actor
        said = actor.one.starts.speed is not None
        changes = any(one.pace in (Pace.GAINS, Pace.LOSES) or (said and one.still) for one in self.phases.steps)
        if actor.stand.meets is Meets.THROUGH and changes:
            back_by_deeds(actor, self.bodies)
        if actor.stand.meets is not Meets.TOWARD:
            return
        first = actor.first or actor
        if first.one.starts.distance is not None or "$Y" not in first.stand.at:
            return
        ahead = self.ahead
        low, high, unit, meaning = first.numbers.range_of("Y")
        soon = actor.numbers.range_of("LEAD_TIME")[1] + actor.numbers.range_of("STEADY")[0]
        needed = ahead.metres + actor.ego_speed * ahead.seconds + (actor.ego_speed + self._wish()) * soon
        needed -= actor.room
        most = max(room_against(actor.found.route) - SPARE, high)
        actor.takes = needed + SPARE
        first.numbers.measure("Y", min(max(low, needed), most), min(max(high, needed), most), unit, meaning)

    def _far(self, lead: str) -> str:
        """How far [m] it and the ego come toward each other until its last deed begins, and a time before they meet."""
        ahead = self.ahead
        return f"{lead} + {ahead.metres:.1f} + ego.pose[3] * {ahead.seconds:.1f}" if ahead.seconds else lead

    def _begins_soon(self) -> bool:
        """Whether nothing says where its first deed is to be: on an open road among those who go along it."""
        actor = self.phases.actor
        situation, stand, query = actor.ledger.situation, actor.stand, actor.found.query
        place = query["maneuver"] != Maneuver.STRAIGHT or at_junction(situation) or query.get("site") not in _ANYWHERE
        others = all(one.starts.where in ALONG | AGAINST and not stands_first(one) for one in situation.others)
        before = stand.meets is Meets.ALONG and not stand.behind and actor.one.starts.where is Where.AHEAD
        waits = any(deed.act not in GOES_ON | (LOSES if before else set()) for deed in situation.ego.does)
        elsewhere = place or waits or stand.rolls or self._shows() is not None
        return stand.meets is Meets.ALONG and not elsewhere and others

    def _make_room(self) -> None:
        """Let it be so far along the ego's route that the ego is not there too soon."""
        actor, stand = self.phases.actor, self.phases.actor.stand
        _, early, *_ = actor.numbers.range_of("OFFSET")
        actor.needs = self._takes() + self._wait()
        route = actor.found.route
        known = stand.found is not None or actor.one.starts.distance is not None
        free = actor.one.starts.distance is None and actor.first is None
        reaches = actor.meets_at if known else route.eventAt
        if free and "$Y" in stand.at:
            self._fit(actor.ego.time_at(reaches) - self._wait())
            actor.needs = self._takes() + self._wait()
        if free and stand.anywhere and not (actor.ego.stands and stand.meets is Meets.ACROSS):
            low, high, unit, meaning = actor.numbers.range_of("Y")
            end = route.route.length if route.route.junction is None else route.eventAt
            if any(self._at_crosswalk(other) for other in actor.ledger.situation.others):
                end = min(end, route.eventAt + SHORT - 2 * NEAREST)  # short of who is at the crosswalk
                low, high = min(low, end - SHORT - NEAREST), min(high, end - SHORT)
            far = min((actor.needs + early) * actor.ego_speed, end - SHORT)
            low, high = max(low, far), max(high, far)
            actor.numbers.measure("Y", low, high, unit, meaning)
            reaches = end - SHORT
        actor.given = actor.ego.time_at(reaches)
        over = free and stand.meets is Meets.ACROSS and actor.one.role is Role.SUPPORTING
        if over and early + actor.needs > actor.given:  # or it would still be in the ego's way
            actor.takes = max(actor.takes, (early + actor.needs) * actor.ego_speed + 2 * SHORT)

    def _at_crosswalk(self, other: Other) -> bool:
        """Whether another stands at the crosswalk, where this one could be."""
        where = self.phases.actor.one.starts.where
        return other.starts.where is Where.CROSSING and where in (Where.ROADSIDE, Where.DRIVEWAY, Where.KERB)

    def _fit(self, seconds: float) -> None:
        """Let it be so near that it is there in the seconds that the ego needs; behind the ego, as far as it gains."""
        actor, stand = self.phases.actor, self.phases.actor.stand
        low, high, unit, meaning = actor.numbers.range_of("Y")
        goes = not stands_first(actor.one)
        if stand.meets is Meets.THROUGH:
            most = self._wish() * seconds - 2 * LANE
            low, high = min(low, max(NEAREST, most - NEAREST)), min(high, max(NEAREST + 1.0, most))
        elif stand.meets is Meets.TOWARD and goes:
            most = actor.found.route.eventAt + self._wish() * max(seconds, 0.0)
            low, high = min(low, most - 2 * NEAREST), min(high, most)
            if actor.found.route.route.junction is not None:  # on the road that the ego comes along
                low, high = min(low, actor.found.route.eventAt - NEAREST), min(high, actor.found.route.eventAt)
        elif stand.behind and goes and actor.deeds[self.first].act is not Act.OVERTAKE:  # which gains only then
            speeds = (self.phases.paces.before[self.first], self.phases.paces.after[self.first])
            fastest = max((speed.high for speed in speeds if speed.name), default=0.0)
            gains = max(0.0, fastest - actor.ego_speed) * actor.found.route.eventAt / actor.ego_speed
            low, high = low + gains, high + gains
            if self._comes_by():  # or it would be by before it has done anything
                most = max(high, FARTHEST)
                comes = self._wish() * (self._wait() + DRIVES)
                low, high = min(max(low, comes), most), min(max(high, comes + NEAREST), most)
        actor.numbers.measure("Y", low, high, unit, meaning)

    def _goes_along(self) -> bool:
        """Whether it is on the road, or faces along it: nothing is timed then by where its way and the ego's meet."""
        one = self.phases.actor.one
        return one.starts.where is Where.AHEAD or one.starts.facing in (Facing.ALONG, Facing.AGAINST)

    def _waits(self) -> str:
        actor = self.phases.actor
        stands = stands_first(actor.one)
        if actor.stand.rolls:
            return MOVE if actor.stand.meets is Meets.ACROSS else GO
        match actor.stand.meets:
            case Meets.ALONG | Meets.KERB if stands or actor.stand.meets is Meets.KERB:
                return "Park()"
            case Meets.ALONG:
                return self._keeps_pace()
            case Meets.ACROSS if actor.stand.left == "0" and not stands:
                return f"MoveAhead(${self._speed()})"  # on foot in the lane
            case _:
                return "Halt()"

    def _keeps_pace(self) -> str:
        """It goes as fast as the ego, or at a speed that the ego has not."""
        actor, fast = self.phases.actor, f"FAST_{self.first}"
        passes = actor.deeds[self.first].act is Act.OVERTAKE and done_to(actor.deeds[self.first]) == EGO
        beside = actor.one.starts.where is Where.BEHIND_BESIDE
        if beside and (actor.ego.stands or (passes and fast in actor.numbers.ranges and self._begins_soon())):
            return GO.replace("$SPEED", f"${fast}" if fast in actor.numbers.ranges else "$SPEED")
        speed = self.phases.paces.before[self.first]
        if speed.name and keeps_distance(self.phases.actor):
            return GO.replace("$SPEED", f"${speed.name}")
        room = self.phases.actor.room
        ahead = f"-$Y - {room:g}" if self.phases.actor.stand.behind else f"$Y + {room:g}"
        if actor.leads and actor.first_speed < actor.along_speed - CRAWLS:  # both gain speed, it before the ego
            return f"PaceOnPath({{p}}, ego, {ahead}, {actor.along_speed:.4g}, {actor.first_speed:.3g})"
        if actor.leads:
            return GO.replace("$SPEED", f"{self.phases.actor.along_speed:.4g}")
        if not keeps_distance(self.phases.actor):
            least = min(KEEPS_UP, 0.8 * self.phases.actor.ego_speed)
            return f"PaceOnPath({{p}}, ego, {ahead}, ${self._speed()}, {least:.3g})"
        slowest = 0.0 if self.phases.follows_until(self.first) else slowest_with_ego(self.phases.actor)
        return f"PaceOnPath({{p}}, ego, {ahead}, 40, {slowest:.3g})"  # behind an ego that is to stop, it stops, too

    def _held(self) -> str | None:
        """How long [s] it waits while the ego is held at first, as that comes so much later; None where it is not.

        It is so long as the ego is held, less what it needs more than the ego does once that is let go.
        """
        stand, held = self.phases.actor.stand, self.phases.actor.ego.held
        waits = self.phases.actor.deeds[self.first].when is not None  # until it has done so, perhaps
        if not held or waits or stand.meets not in (Meets.THROUGH, Meets.TOWARD, Meets.ACROSS):
            return None
        return f"max(0, {held:.3g} - max(0, {self._own()} - secondsTo(egoRoute, ego, {stand.ego_meets})))"

    def _own(self) -> str:
        """How long [s] it needs from when it is due to where it meets the ego."""
        stand = self.phases.actor.stand
        texts = (*(text for body in self.bodies for text in body), self._go(), stand.at, stand.point)
        takes = in_terms_of(self.phases.actor.numbers, texts, self._wait)
        return f"{stand.left} / ${self._speed()} {takes} + $OFFSET"

    def _due(self) -> str:
        """When the first deed is due: when the ego needs so many seconds more than it does to where they meet."""
        stand, wait = self.phases.actor.stand, self._wait()
        match stand.meets:
            case Meets.THROUGH | Meets.TOWARD | Meets.ACROSS:
                due = f"secondsTo(egoRoute, ego, {stand.ego_meets}) < {self._own()}"
                if (
                    stand.meets is Meets.ACROSS and stand.left == "0" and not stands_first(self.phases.actor.one)
                ):  # it goes on, perhaps as fast as the ego
                    return f"{due} or secondsTo(egoRoute, ego, egoRoute.eventAt) < {wait:.2f} + $OFFSET"
                return due + self._or_yields()
            case Meets.KERB:
                comes = self._in_whose_way()
                due = f"secondsTo(egoRoute, {comes}, {stand.ego_meets}) < {wait:.2f} + $OFFSET"
                return due + (self._or_yields() if comes == EGO else "")
            case Meets.ALONG if stands_first(self.phases.actor.one) and not stand.behind:
                there = "secondsTo(egoRoute, ego, progressOn(egoRoute, self)[0])"
                return f"{there} < {wait:.2f} + $OFFSET" + self._or_yields()
            case _ if (shown := self._shows()) is not None:
                clears = clears_in(self.phases.actor, self.first)
                name = name_of(shown.id)
                closing = "self.pose[3]" if stands_first(shown) else f"(self.pose[3] - {name}.pose[3])"
                return f"headway(egoRoute, self, {name}) < {closing} * ({clears:.3g} + $LEAD_TIME) + 5"
            case _:
                return self._due_along(wait)

    def _due_along(self, wait: float) -> str:
        """The same, of who goes along the road; who comes from behind by an ego that stands is timed by its own way."""
        stands = self.phases.actor.ego.stands
        if self._comes_by():
            return f"headway({{p}}, self, ego) < self.pose[3] * ({wait:.3g} + $OFFSET)"
        due = f"secondsTo(egoRoute, ego, egoRoute.eventAt) < {wait:.3g} + $OFFSET"
        return due + (self._or_yields() if stands or self._is_held_by_others() else "")

    def _comes_by(self) -> bool:
        """Whether it comes by an ego that stands all the time, in the lane beside that."""
        actor = self.phases.actor
        return actor.ego.stands and actor.stand.behind and actor.one.starts.where is Where.BEHIND_BESIDE

    def _is_held_by_others(self) -> bool:
        """Whether an ego may be held by others before it is where its first deed is due, who is ahead of it."""
        actor = self.phases.actor
        ahead = actor.one.starts.where in (Where.AHEAD, Where.AHEAD_BESIDE) and not actor.stand.rolls
        return ahead and len(actor.ledger.situation.others) > 1

    def _shows(self) -> Other | None:
        """Who stands or is slow before it in the ego's lane, if it leaves that and so shows who is there."""
        actor = self.phases.actor
        if actor.one.starts.where is not Where.AHEAD or not actor.deeds or actor.deeds[0].act is not Act.CUT_OUT:
            return None
        others = actor.ledger.situation.others
        return self._standing_ahead() or next((other for other in others if shows_slow(actor.one, other)), None)

    def _in_whose_way(self) -> str:
        """Who comes past whoever opens a door: who waits for that on the ego's road, else the ego."""
        actor = self.phases.actor
        if actor.deeds[-1].act is Act.OPEN_DOOR:
            doors = {f"{actor.one.id}.{Act.OPEN_DOOR}", f"{actor.one.id}.{len(actor.deeds) - 1}"}
            for one in actor.ledger.situation.others:
                whens = [deed.when for deed in one.does if deed.when is not None]
                if one.starts.where in (Where.AHEAD, Where.BESIDE) and any(doors & {when.after} for when in whens):
                    return name_of(one.id)
        return EGO

    def _waits_for_a_stop(self) -> bool:
        """Whether it begins once the ego has stopped, which then comes no nearer."""
        actor = self.phases.actor
        when = actor.deeds[self.first].when if self.first < len(actor.deeds) else None
        named = (when.after, when.during) if when is not None else ()
        ego = [name for name in named if name is not None and name.startswith(f"{EGO}.")]
        return any(actor.ledger.situation.deed(name).act in HALTS for name in ego)

    def _or_yields(self) -> str:
        """An ego that stops for who stands in or beside its lane would wait for it as long as it waits for the ego."""
        situation, stand = self.phases.actor.ledger.situation, self.phases.actor.stand
        controlled = situation.road.ego_light is not None or situation.road.control is not None
        waits_for_it = situation.ego.does and not self.phases.actor.ego.stands
        held = stand.meets is Meets.THROUGH or waits_for_it or (controlled and not self.phases.actor.ego.stands)
        held = held or self.phases.actor.ego.held > 0.0
        held = held and not self._waits_for_a_stop()
        return "" if held else f" or ego.pose[3] < {GIVES_WAY:g}"
