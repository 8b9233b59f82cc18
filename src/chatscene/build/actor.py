"""One road user in a program: where it stands, and its plan, deed after deed, timed to meet the ego."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

from chatscene.build.aim import aimed
from chatscene.build.deeds import ALONG, GO, MOVE, Steps, steps_for
from chatscene.build.ledger import Ledger
from chatscene.build.numbers import FIRM, Numbers
from chatscene.build.place import NEXT_LANE, Found, at_junction
from chatscene.build.starts import Asked, Meets, Stand, stands_first, start_of
from chatscene.build.timing import Coming
from chatscene.errors import NotBuilt
from chatscene.terms.actors import LIMITS, AdversaryKind, Limits
from chatscene.terms.actors import Manner as Moves
from chatscene.terms.situation import EGO, SEVERAL, Deed, Other, When
from chatscene.terms.vocabulary import Act, Breach, EgoLight, Facing, Manner, Role, Side, UserKind, Where

LEAST = 0.64  # of the ego's speed that whoever keeps its distance goes on at: else both slow down for each other
YIELDS = (1.2, 2.5)  # [s] before the ego that somebody is at a junction who lets it by
SOME = 3  # of a group whose size was not said
_STEP = 0.1  # [s], in which setting off is computed
NEAR_LANE = 2.5  # [m] from the ego's line: so near it is seen that somebody means to cross
_ON_ITS_WAY = frozenset((Act.SLOW_DOWN, Act.HESITATE, Act.ACCELERATE, Act.TURN_BACK, Act.U_TURN))
_PACES: dict[Manner | None, str] = {Manner.SLOW: "SLOW", Manner.FAST: "FAST"}
_AT_ONE_SPEED = frozenset((Act.GO_ALONG, Act.GO_STRAIGHT, Act.TURN_LEFT, Act.TURN_RIGHT, Act.CROSS, Act.ENTER))
_GOING_ON = (Act.GO_ALONG, Act.FOLLOW)
_QUIET = frozenset((Act.STAND, Act.STOP))
_SEEN = {
    Act.STOP: "{who}.pose[3] < 0.1",
    Act.STAND: "{who}.pose[3] < 0.1",
    Act.BRAKE: "{who}.pose[3] < 3",
    Act.SET_OFF: "{who}.pose[3] > 0.5",
}
"""Deeds of somebody else that a plan can wait for, by what is seen of them."""


@dataclass(slots=True)
class Actor:
    """A road user that is being built.

    Attributes:
        ledger: What was said, and what became of it.
        found: Where it happens.
        one: Who.
        ego: How the ego gets on.
        room: How far [m] beyond the first of its place it stands.
        first: In whose row it stands, whose place it shares; None if it is the first.
    """

    ledger: Ledger
    found: Found
    one: Other
    ego: Coming
    room: float = 0.0
    first: Actor | None = None
    numbers: Numbers = field(init=False)
    stand: Stand = field(init=False)
    deeds: tuple[Deed, ...] = field(init=False)
    named: dict[str, str] = field(init=False)

    def __post_init__(self) -> None:
        row = self.one.kind.row.body.row
        self.numbers = Numbers(self.one.id, row)
        self.deeds = self.one.does
        self._bind_speed()
        asked = Asked(
            situation=self.ledger.situation,
            found=self.found,
            one=self.one,
            numbers=self.numbers,
            ego=self.ego,
            room=self.room,
            first=self.first.stand if self.first is not None else None,
        )
        self.stand = start_of(asked)
        self.named = {}
        at = f"others.{self.one.id}"
        self.ledger.take(f"{at}.kind", f"{at}.count", f"{at}.starts.where", f"{at}.starts.side")
        if self.stand.faces:
            self.ledger.take(f"{at}.starts.facing")
        if self.one.kind.row.stands_in:
            self.ledger.assume(f"{self.one.id} is a {row.scenic.lower()}, since nothing is built as a {self.one.kind}")
        if self.one.count == SEVERAL:
            self.ledger.assume(f"of {self.one.id} there are {SOME}, since their number was not said")
        if (self.stand.meets in (Meets.THROUGH, Meets.ACROSS) or self.stand.rolls) and not self.lies:
            self._between()

    @property
    def ego_speed(self) -> float:
        """What the ego drives at [m/s]."""
        return self.ego.speed

    @property
    def path(self) -> str:
        """Of its facts."""
        return f"others.{self.one.id}"

    @property
    def limits(self) -> Limits:
        """What its body can do."""
        return LIMITS[self.one.kind.row.body.row.scenic]

    @property
    def walks(self) -> bool:
        """Whether it is on foot."""
        return self.one.kind.moves is Moves.WALKS

    @property
    def lies(self) -> bool:
        """Whether it is a thing."""
        return self.one.kind.moves is Moves.LIES

    @property
    def count(self) -> int:
        """How many there are."""
        return self.one.count or SOME

    # Numbers

    def _bind_speed(self) -> None:
        numbers = self.numbers
        if (paces := {deed.manner for deed in self.deeds if deed.manner in _PACES}) and len(paces) == 1:
            low, high, *_ = numbers.ranges[_PACES[paces.pop()]]
            numbers.narrow("SPEED", low, high)
        start = self.one.starts.speed
        if start is not None and not stands_first(self.one):
            numbers.bind("SPEED", start, self.ego_speed)
        for k, deed in enumerate(self.deeds):  # it comes as fast as it was said to go on
            if deed.speed is not None and self._one_speed() and deed.act in _AT_ONE_SPEED:
                numbers.bind("SPEED", deed.speed, self.ego_speed, f"{self.path}.does.{k}.speed")
        if any(deed.act is Act.SLOW_DOWN for deed in self.deeds):  # to what is seen to be slower than before
            before, *_ = numbers.ranges["SPEED"]
            numbers.narrow("SLOW", 0.3 * before, 0.6 * before)

    def _between(self) -> None:
        """Let it be where the ways meet from when it would touch the ego's tail to when it would just have gone by.

        Whoever comes later strikes the other.
        """
        ego = AdversaryKind.CAR.row.limits
        late = -0.5 * (ego.length + self.limits.length) / self.ego_speed
        early = (ego.width + self.limits.length) / self.numbers.middle("SPEED")
        if self.deeds and self.deeds[0].act is Act.YIELD:  # who waits for the ego is there well before it
            late, early = YIELDS
        low, high, *taken = aimed(self.ledger.situation.contact, self.one, late, early)
        self.ledger.take(*taken)
        self.numbers.narrow("OFFSET", low, high)

    def _of_deed(self, k: int, text: str, steps: Steps) -> str:
        """A phase of a deed, with the numbers that were said of that deed and of no other."""
        deed = self.deeds[k]
        at = f"{self.path}.does.{k}"
        for amount, name in steps.binds.items():
            if (said := getattr(deed, amount)) is not None:
                own = name if name == "SPEED" and self._one_speed() else f"{name}_{k}"
                self.numbers.bind(own, said, self.ego_speed, f"{at}.{amount}")
                text = _renamed(text, name, own)
        if deed.manner is not None and deed.manner in FIRM and deed.acceleration is None and "$BRAKE" in text:
            self.numbers.narrow(f"BRAKE_{k}", FIRM[deed.manner], 1.0)
            text = _renamed(text, "BRAKE", f"BRAKE_{k}")
            self.ledger.take(f"{at}.manner")
        if deed.manner in _PACES and deed.speed is None and "$SPEED" in text:
            if len({one.manner for one in self.deeds if one.manner in _PACES}) > 1:
                low, high, *_ = self.numbers.ranges[_PACES[deed.manner]]
                self.numbers.narrow(f"SPEED_{k}", low, high)
                text = _renamed(text, "SPEED", f"SPEED_{k}")
            self.ledger.take(f"{at}.manner")
        return text

    def _one_speed(self) -> bool:
        """Whether one speed at most was said of it, which then is its speed all the time."""
        return sum(deed.speed is not None for deed in self.deeds) + (self.one.starts.speed is not None) <= 1

    # Its plan

    def phases(self) -> tuple[str, ...]:
        """What it does until its first deed is due, then deed after deed; empty for what only lies or hides."""
        for k, deed in enumerate(self.deeds):
            self.ledger.take(
                f"{self.path}.does.{k}.act", *([f"{self.path}.does.{k}.breaks"] if self._breaks(deed) else [])
            )
        hides = any(other.hidden_by == self.one.id for other in self.ledger.situation.others)
        stands = all(deed.act is Act.STAND for deed in self.deeds)
        if (
            self.lies
            or (self.one.role is Role.HIDES and stands)
            or (self.one.role is Role.SUPPORTING and hides and stands)
        ):
            return ("Halt()",) if self.one.role is Role.ADVERSARY else ()
        phases = tuple(self._phases())  # all of them first: a later one may bind a number that an earlier one reads
        return tuple(self.filled(text) for text in phases)

    def _breaks(self, deed: Deed) -> bool:
        """Whether the rule that is broken is there, and is broken by what is done."""
        moves = self.stand.meets in (Meets.THROUGH, Meets.ACROSS) and deed.act not in _QUIET | {Act.HESITATE}
        control = self.found.query.get("control")
        match deed.breaks:
            case Breach.RED_LIGHT:
                with_us = self.one.starts.where in (Where.ONCOMING, Where.EXIT_CROSSING)
                red = (self.ledger.situation.road.ego_light in (EgoLight.RED, EgoLight.TURNS_RED)) == with_us
                return moves and control == "signal" and (red or with_us)
            case Breach.STOP_SIGN:
                return moves and control == "stop-sign"
            case _:
                return moves

    def _steps(self, deed: Deed) -> Steps:
        table = steps_for(self.stand.meets, walks=self.walks, beside=self.one.starts.where in NEXT_LANE)
        if deed.act is Act.LANE_CHANGE and self.stand.meets is Meets.ALONG:
            if self.one.starts.where not in NEXT_LANE:
                table = {**table, Act.LANE_CHANGE: ALONG[Act.CUT_OUT]}
            elif deed.to is not None and deed.to == self.one.starts.side:
                raise NotBuilt(
                    f"nothing builds yet: {self.path}: lane-change to the {deed.to}, away from the ego's lane"
                )
        if (
            self.stand.behind
            and self.one.starts.where is Where.BEHIND
            and deed.act in _GOING_ON
            and not (self.stand.rolls or self._contact())
        ):
            table = {**table, deed.act: ALONG[Act.TAILGATE]}  # or it would run into the ego
        if deed.act not in table:
            raise NotBuilt(f"nothing builds yet: {deed.act} of somebody who is {self.one.starts.where}")
        return table[deed.act]

    def _phases(self) -> Iterator[str]:
        go = MOVE if self.stand.meets is Meets.ACROSS else GO
        if not self.deeds:
            yield "Park()" if self.stand.meets is Meets.KERB else go
            return
        steps = [self._steps(deed) for deed in self.deeds]
        lasting = all(one.lasting for one in steps)
        first = 0
        if self.deeds[0].act is Act.STAND and len(self.deeds) > 1 and self.deeds[0].time is None:
            first = 1  # it stands until what comes then is due
        if all(deed.act is Act.STAND for deed in self.deeds):
            yield from self._of(0, steps[0], None, last=True)
            return
        yield from self._opening(first, steps[first], lasting)
        way, meanwhile = None, go
        for k in range(first, len(self.deeds)):
            last = k == len(self.deeds) - 1
            if k > first and (when := self.deeds[k].when) is not None:
                yield from self._when(k, when, meanwhile)
            yield from self._of(k, steps[k], way, last=last, go=meanwhile)
            way = steps[k].way or way
            if self.stand.meets is not Meets.ACROSS and way:
                meanwhile = GO.replace("{p}", way)

    def _of(self, k: int, steps: Steps, way: str | None, *, last: bool, go: str = "") -> Iterator[str]:
        ends = last and bool(steps.last) and self.deeds[k].time is None
        phases = steps.last if ends else steps.does
        if last and not ends and go:
            own = steps.way or way
            phases = (*phases, GO.replace("{p}", own) if own and self.stand.meets is not Meets.ACROSS else go)
        deed = self.deeds[k]
        if deed.act is Act.CUT_IN and not last:  # or the ego would run into it before it does the next thing
            ahead = "(ego.length + self.length) / 2 + $AHEAD"
            pace = f"PaceOnPath({way or '{p}'}, ego, {ahead} + 2, 40)"
            yield f"{pace} until headway(egoRoute, ego, self) > {ahead}"
        for text in phases:
            said = self._of_deed(k, text, steps)
            said = said.replace("{meets}", self.stand.ego_meets)
            yield said.replace("{aside}", self._aside(deed, k)).replace("{p}", way or "{p}")
        if deed.to is not None and deed.act in (Act.CUT_OUT, Act.LANE_CHANGE, Act.OVERTAKE):
            if self.named.setdefault("side", str(deed.to)) != str(deed.to):
                raise NotBuilt(f"nothing builds yet: {self.path}.does.{k}.to: {deed.to}, after the other side")
            self.ledger.take(f"{self.path}.does.{k}.to")
        if deed.whom == EGO:
            self.ledger.take(f"{self.path}.does.{k}.whom")

    def _aside(self, deed: Deed, k: int) -> str:
        """To which side of its line it goes: 1 for left; where that was not said, toward the ego's way."""
        if deed.to is not None:
            self.ledger.take(f"{self.path}.does.{k}.to")
            sign = 1 if deed.to is Side.LEFT else -1
            return str(-sign if self.stand.meets is Meets.TOWARD else sign)
        toward = "(-1 if offsetFrom(egoRoute, self) > 0 else 1)"
        return "(1 if offsetFrom(egoRoute, self) > 0 else -1)" if self.stand.meets is Meets.TOWARD else toward

    def _contact(self) -> bool:
        contact = self.ledger.situation.contact
        return contact is not None and contact.happens

    # When it is due

    def _opening(self, first: int, steps: Steps, lasting: bool) -> Iterator[str]:
        """What is done until the first deed is due."""
        deed, when = self.deeds[first], self.deeds[first].when
        if when is not None:
            yield from self._when(first, when, self._waits())
            if when.ego_within is not None or self.stand.ego_meets == "egoRoute.eventAt":
                return
        if lasting and (self.stand.meets is Meets.ALONG or self._goes_along()):
            return
        if not self.stand.rolls or self.stand.meets is Meets.ALONG:
            yield f"{self._waits()} until {self._due()}"
        go = GO if self.stand.meets is not Meets.ACROSS else MOVE
        if self.stand.meets is Meets.ACROSS and deed.act in _ON_ITS_WAY and self.stand.left != "0":
            yield f"{MOVE} until abs(offsetFrom(egoRoute, self)) < {NEAR_LANE}"  # it comes first, and does it then
        if self.stand.meets is Meets.TOWARD and not steps.lasting:  # it comes first, and does it when the ego is near
            yield f"{go} until gap(self, ego) < (self.pose[3] + ego.pose[3]) * $LEAD_TIME"
        if self.stand.meets is Meets.THROUGH and not steps.lasting and deed.act is not Act.SET_OFF:
            yield f"{go} until {self.stand.left} < brakingDistance(self) + 3"

    def _goes_along(self) -> bool:
        """Whether it is on the road, or faces along it: nothing is timed then by where its way and the ego's meet."""
        facing = self.one.starts.facing
        return self.one.starts.where is Where.AHEAD or facing in (Facing.ALONG, Facing.AGAINST)

    def _waits(self) -> str:
        stands = stands_first(self.one)
        match self.stand.meets:
            case Meets.ACROSS if self.stand.rolls or (self.one.starts.where is Where.AHEAD and not stands):
                return MOVE
            case _ if self.stand.rolls:
                return GO
            case Meets.ALONG | Meets.KERB if stands or self.stand.meets is Meets.KERB:
                return "Park()"
            case Meets.ALONG:
                ahead = "-$Y" if self.stand.behind else "$Y"
                if self.one.kind.row.body.row.manner is Moves.RIDES and not self.one.kind.row.body.row.motorised:
                    return f"PaceOnPath({{p}}, ego, {ahead}, $SPEED, 2)"
                return f"PaceOnPath({{p}}, ego, {ahead}, 40, {LEAST * self.ego_speed:.3g})"
            case _:
                return "Halt()"

    def _due(self) -> str:
        """When the first deed is due: when the ego needs so many seconds more than it does to where they meet."""
        stand = self.stand
        match stand.meets:
            case Meets.THROUGH | Meets.TOWARD | Meets.ACROSS:
                own = f"{stand.left} / $SPEED + {self._lost():.2f}"
                return f"secondsTo(egoRoute, ego, {stand.ego_meets}) < {own} + $OFFSET"
            case Meets.KERB:
                return f"secondsTo(egoRoute, ego, {stand.ego_meets}) < 2.2 + $OFFSET"
            case Meets.ALONG if stands_first(self.one) and not stand.behind:
                return "secondsTo(egoRoute, ego, progressOn(egoRoute, self)[0]) < 3.6 + $OFFSET"
            case _ if (shown := self._shows()) is not None:
                return f"headway(egoRoute, self, {name_of(shown.id)}) < self.pose[3] * (1 + $LEAD_TIME) + 5"
            case _:
                ahead = 2.0 if at_junction(self.ledger.situation) else 1.0
                return f"secondsTo(egoRoute, ego, egoRoute.eventAt) < {ahead:g} + $OFFSET"

    def _shows(self) -> Other | None:
        """Who stands before it in the ego's lane, if it leaves that and so shows who stands there."""
        if self.one.starts.where is not Where.AHEAD or not self.deeds or self.deeds[0].act is not Act.CUT_OUT:
            return None
        others = (one for one in self.ledger.situation.others if one.id != self.one.id)
        return next((one for one in others if one.starts.where is Where.AHEAD and stands_first(one)), None)

    def _lost(self) -> float:
        """How much later [s] than at its speed from the first it is there after a halt, by its own pedals."""
        wish, metres = self.numbers.middle("SPEED"), 4.0 if self.walks else 25.0
        limits, speed, at, time = self.limits, 0.0, 0.0, 0.0
        while at < metres and time < 60.0:
            if self.walks:
                speed = min(wish, speed + limits.throttle * _STEP)
            else:
                pedal = min(1.0, 0.06 + 0.5 * (wish - speed)) if wish - speed >= -0.1 else 0.0
                gain = pedal * limits.throttle * (1 - speed / limits.top_speed)
                speed += _STEP * (gain - (limits.drag if speed > 0 else 0.0))
            at, time = at + _STEP * speed, time + _STEP
        return max(0.0, time - metres / wish)

    def _when(self, k: int, when: When, meanwhile: str) -> Iterator[str]:
        at = f"{self.path}.does.{k}.when"
        for name, reference in (("after", when.after), ("during", when.during)):
            if reference is None:
                continue
            if condition := self._seen(k, name, reference):
                yield f"{meanwhile} until {condition}"
            self.ledger.take(f"{at}.{name}")
        if when.ego_within is not None:
            low, high = when.ego_within.low, when.ego_within.high
            unit = when.ego_within.QUANTITY
            near = f"NEAR_{k}"
            least = low if low > 0 else high
            most = high if high < float("inf") else least
            of = "s" if unit == "duration" else "m"
            self.numbers.measure(
                near, max(least, 0.0), most, of, "how near the ego is when it acts", f"{at}.ego_within"
            )
            there = (
                "secondsTo(egoRoute, ego, progressOn(egoRoute, self)[0])" if unit == "duration" else "gap(self, ego)"
            )
            yield f"{meanwhile} until {there} < ${near}"

    def _seen(self, k: int, name: str, reference: str) -> str:
        """What shows that a deed of somebody is done, or goes on; empty for a deed of its own before this one."""
        who, _, _ = reference.partition(".")
        deed = self.ledger.situation.deed(reference)
        if who == self.one.id:
            if name == "after" and any(deed is earlier for earlier in self.deeds[:k]):
                return ""  # its own deeds come one after the other
            raise NotBuilt(f"nothing builds yet: {self.path}.does.{k}.when.{name}: {reference}, of its own")
        if who == EGO and name == "during" and deed.act.row.lasting and len(self.ledger.situation.ego.does) == 1:
            return ""  # what the ego does all the time
        if deed.act not in _SEEN:
            raise NotBuilt(f"nothing builds yet: {self.path}.does.{k}.when.{name}: {reference}, which is {deed.act}")
        seen = _SEEN[deed.act].format(who=who if who == EGO else name_of(who))
        return f"{seen} and progressOn(egoRoute, ego)[0] > 4" if who == EGO and deed.act in _QUIET else seen

    # Its text

    def filled(self, text: str) -> str:
        """A text with names and parameters in the place of marks."""
        one = name_of(self.one.id)
        first = one if self.count > 1 else "self"
        text = text.replace("{beside}", f"beside{one}").replace("{ours}", f"ours{one}")
        row = name_of(self.first.one.id) if self.first is not None else one
        text = text.replace("{p}", f"way{one}").replace("{i}", one).replace("{first}", first).replace("{row}", row)
        if self.first is not None and self.stand.rolls and not self.numbers.is_said("SPEED"):
            text = re.sub(r"\$SPEED(?![A-Z0-9_])", self.first.numbers.value("SPEED"), text)  # in a row they go alike
        if self.first is not None:
            text = text.replace("$Y", f"<{self.first.one.id}>")
            return self.numbers.filled(text).replace(f"<{self.first.one.id}>", self.first.numbers.value("Y"))
        return self.numbers.filled(text)

    def code(self, hidden: Actor | None) -> list[str]:
        """Its part of the program; of who hides somebody, beside whom it hides."""
        one, stand, row = name_of(self.one.id), self.stand, self.one.kind.row.body.row
        phases = self.phases()
        named: list[str] = []
        if hidden is None:
            named = [self.filled(text) for text in (f"way{one} = {stand.way}", *stand.lines)]
        body = "\n".join(phases)
        if f"beside{one}" in body:
            side = self.named.get("side", str(Side.LEFT))
            named.append(f'beside{one} = extended(neighbourPath(egoRoute, "{side}"), 60)')
        if f"ours{one}" in body:
            named.append(f"ours{one} = against(ownLane(egoRoute))")
        if phases:
            named += [f"behavior Does{one}():", *(f"    do {text}" for text in phases)]
        cls = "VendingMachine" if self.one.role is Role.HIDES and self.one.kind is UserKind.OBJECT else row.scenic
        lines = list(named)
        for n in range(self.count):
            place, facing = self._hides(hidden) if hidden is not None else self._place(n)
            said = f"{one if n == 0 else f'{one}_{n}'} = new {cls} at {place}, facing {facing}"
            said += f", with label '{self.one.id}'" + self._role()
            lines.append(said + self._moving(phases) + (f", with behavior Does{one}()" if phases else ""))
        if self.one.starts.speed is not None and self.one.starts.speed.high <= 0.0:
            self.ledger.take(f"{self.path}.starts.speed")  # it stands
        self.ledger.take(*self.numbers.built())
        return [f"## {self.one.id}: {self.said()}", *lines]

    def _moving(self, phases: Sequence[str]) -> str:
        """Its speed at first: who goes the ego's way is under way as the ego is."""
        if phases and self.stand.rolls:
            self.ledger.take(f"{self.path}.starts.speed")
            return self.filled(", with speed $SPEED")
        if not phases or self.stand.meets is not Meets.ALONG or stands_first(self.one) or self.lies:
            return ""
        own = (
            self.one.starts.speed is not None
            or phases[0].startswith("DrivePath")
            or not self.one.kind.row.body.row.motorised
        )
        if self.one.starts.speed is not None:
            self.ledger.take(f"{self.path}.starts.speed")
        return self.filled(", with speed $SPEED") if own else f", with speed {self.ego_speed:g}"

    def _role(self) -> str:
        role = {Role.ADVERSARY: "adversary", Role.SUPPORTING: "background", Role.HIDES: "occluder"}[self.one.role]
        return f", with role '{role}'"

    def _place(self, n: int) -> tuple[str, str]:
        """Where the n-th of it stands, and which way it faces."""
        stand, one = self.stand, name_of(self.one.id)
        length = self.limits.length if self.limits.length else 1.5
        if stand.point:
            aside = f" + {1.3 * ((n + 1) // 2) * (-1 if n % 2 else 1):g}" if n else ""
            point, facing = (text.replace("level{i}", f"level{{i}}{aside}") for text in (stand.point, stand.facing))
            return self.filled(point), self.filled(facing)
        sign = "+" if stand.meets is Meets.ALONG and not stand.behind else "-"  # away from the ego
        at = self.filled(stand.at) + (f" {sign} {n * (length + 2.5):g}" if n else "")
        aside = f", {stand.aside:g}" if stand.aside else ""
        return f"pointOn(way{one}, {at}{aside})", f"directionOn(way{one}, {at})"

    def _hides(self, hidden: Actor) -> tuple[str, str]:
        """Where it stands between the ego and whom it hides."""
        if hidden.stand.meets is not Meets.ACROSS or "level" not in hidden.stand.point:
            raise NotBuilt(f"nothing builds yet: {self.one.id}, which hides somebody who is {hidden.one.starts.where}")
        if self.count > 1 or self.one.starts.side not in (None, hidden.one.starts.side):
            raise NotBuilt(f"nothing builds yet: {self.path}, which hides {hidden.one.id} alone and from its side")
        self.ledger.take(f"{hidden.path}.hidden_by")
        back = 2.6 + 0.5 * (self.limits.length or 1.2)
        one = name_of(hidden.one.id)
        side = str(hidden.one.starts.side)
        at = f"level{one} - {back:g}"
        return f'besideRoad(egoRoute, {at}, "{side}", 1.2)', f"directionOn(egoRoute, {at})"

    def said(self) -> str:
        """What it is and does, for a comment."""
        side = f" {self.one.starts.side}" if self.one.starts.side else ""
        does = ", then ".join(deed.act for deed in self.deeds) or "nothing said"
        return f"{self.one.kind} {self.one.starts.where}{side}: {does}"


def _renamed(text: str, name: str, own: str) -> str:
    """A text that reads another parameter in the place of one."""
    return re.sub(rf"\${name}(?![A-Z0-9_])", f"${own}", text)


def name_of(one: str) -> str:
    """What somebody of an id is called in a program."""
    plain = one.replace("-", "_")
    return plain if len(plain) == 1 and plain.isupper() else f"The_{plain}"  # no word of Scenic or of the world
