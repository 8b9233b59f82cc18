"""One road user in a program: where it stands, and its plan, deed after deed, timed to meet the ego."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field

from chatscene.build.alongside import set_pace, set_round
from chatscene.build.asked import FROM_A_STAND, SOME, Asked, Meets, Stand, bolts, goes_slowly, stands_first
from chatscene.build.coming import Coming
from chatscene.build.cutting_in import slows_for_it
from chatscene.build.deeds import OWN
from chatscene.build.facing import said_anyway
from chatscene.build.flank import set_level
from chatscene.build.gaps import set_room
from chatscene.build.heeding import heeds
from chatscene.build.lateral import placed
from chatscene.build.ledger import Ledger
from chatscene.build.naming import name_of
from chatscene.build.numbers import PACES, Numbers, rigid, stronger
from chatscene.build.paces import AT_ONE_SPEED, check_held
from chatscene.build.phases import Phases
from chatscene.build.place import AT_CROSSWALKS, LANE, NEXT_LANE, Found, at_roundabout, lacks_at
from chatscene.build.relations import grip_of, speed_beside
from chatscene.build.revealed import shows_slow
from chatscene.build.starts import start_of
from chatscene.build.timing import Body
from chatscene.situations.phrases import one_seen
from chatscene.terms.actors import LIMITS, PROPS, Limits
from chatscene.terms.actors import Manner as Moves
from chatscene.terms.rolling import rolls
from chatscene.terms.scenario import Maneuver
from chatscene.terms.situation import EGO, SEVERAL, Deed, Other
from chatscene.terms.vocabulary import COMES_OVER, SIDEWAYS, Act, Breach, Role, Where
from chatscene.world.places import ownLane, speedOn

HURRIES = (1.0, 1.5)  # of the speed from which a watcher calls somebody fast
FASTER = (1.2, 1.5)  # of the speed of the traffic: who is fast in it
KEEPS_UP = 0.9  # of the speed of the ego that somebody has who is to pass it
_KEEPS = AT_ONE_SPEED | COMES_OVER  # what is done at one speed
_DRIVES = re.compile(r"(?:DrivePath|FollowTraffic)\([^,]+, ([^,()]+)")
_GOES = re.compile(r"^DrivePath\(([^,]+), ([^,()]+)\)( |$)")
_GOES_ON_IN_OURS = re.compile(rf"^DrivePath\(({re.escape(OWN)}), ([^,()]+)\)($| for )")
_CLOSE_BEHIND = re.compile(r"(PaceOnPath\([^,]+, )ego, -\(")


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
        needs: How long [s] the ego must need at least to where they meet.
        given: How long [s] it needs to there.
        begins: For each of its deeds, how many of its phases come before that in which it is done.
        takes: How much road [m] the ego drives along while it does all that it does; 0 where that does not matter.
        sooner: How much sooner than the ego [s] it is there at least if another, before the ego, is to brake for it.
        soon: When [s] the ego meets somebody else, who may end the scene; None if nobody is known to.
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
    needs: float = field(init=False, default=0.0)
    given: float = field(init=False, default=0.0)
    takes: float = field(init=False, default=0.0)
    sooner: float | None = field(init=False, default=None)
    soon: float | None = field(init=False, default=None)
    begins: tuple[int, ...] = field(init=False, default=())
    _texts: tuple[str, ...] | None = field(init=False, default=None)

    def __post_init__(self) -> None:
        self.numbers = Numbers(self.one.id, self.ledger.situation.row_of(self.one))
        self.deeds = self.one.does
        if bolts(self.one):
            self.deeds = (Deed(act=Act.CROSS),)
            self.ledger.assume(f"{self.one.id} crosses our lane")
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
        self.stand, chosen = placed(asked, start_of(asked))
        if chosen:
            self.ledger.assume(chosen)
        set_pace(self)
        set_round(self)
        set_room(self)
        set_level(self)
        self.named = {}
        at = f"others.{self.one.id}"
        self.ledger.take(f"{at}.kind", f"{at}.count", f"{at}.starts.where", f"{at}.starts.side")
        self.ledger.take(*said_anyway(self.one, self.stand.meets))
        if self.stand.faces:
            self.ledger.take(f"{at}.starts.facing")
        if (lacks := lacks_at(self.found, self.one.starts.where)) is not None:
            does = "crosses" if self.one.starts.where in AT_CROSSWALKS else "starts"
            self.ledger.lack(f"{self.one.id} {does} where the map has no {lacks}")
        told = self.ledger.told
        if told is not None and any(rolls(one) for one in told.others if one.id == self.one.id):
            self.ledger.assume(f"{self.one.id} rolls, so it is built as a ball, which may be smaller")
        elif self.one.kind.row.general:
            built = one_seen(self.one.kind.row.body.row.scenic)
            self.ledger.assume(f"{self.one.id} is built as {built}, since its exact kind is not stated")
        if faster := stronger(self.one.id, self.one.kind, self.numbers.row):
            self.ledger.assume(faster)
        if self.numbers.row.tows:
            self.ledger.assume(rigid(self.one.id, self.numbers.row))
        if self.one.count == SEVERAL:
            self.ledger.assume(f"there are {SOME} of {self.one.id}, since their number is not stated")

    @property
    def ego_speed(self) -> float:
        """What the ego drives at [m/s]."""
        return self.ego.speed

    @property
    def along_speed(self) -> float:
        """How fast [m/s] it goes along with the ego: as that, or as fast as it holds."""
        return min(self.ego_speed, Body(self.limits, self.walks).fastest)

    @property
    def first_speed(self) -> float:
        """How fast [m/s] it goes along at first: as the ego, which may begin where less is allowed, as on a ramp."""
        allowed = speedOn(self.found.route, 0.0, self.ego_speed) if self.ego.keeps_limits else self.ego_speed
        return min(self.along_speed, allowed)

    @property
    def ego_limits(self) -> Limits:
        """What the ego's body can do."""
        return self.ledger.situation.ego.row.limits

    @property
    def said(self) -> tuple[Deed, ...]:
        """Its deeds as they were said."""
        told = self.ledger.told
        return self.deeds if told is None else told.does(self.one.id)

    @property
    def path(self) -> str:
        """Of its facts."""
        return f"others.{self.one.id}"

    @property
    def limits(self) -> Limits:
        """What its body can do."""
        kind = self.one.kind
        return (LIMITS.get(kind.scenic) or PROPS[kind.scenic]) if kind.row.prop else self.numbers.row.limits

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

    @property
    def leads(self) -> bool:
        """Whether it goes before an ego that nothing slows down, at the speed that the ego wants."""
        ahead = self.one.starts.where is Where.AHEAD and self.stand.meets is Meets.ALONG
        free = all(deed.act is Act.FOLLOW and deed.speed is None for deed in self.ledger.situation.ego.does)
        return ahead and free and self.one.kind.row.body.row.motorised

    @property
    def _lane_ends(self) -> bool:
        """Whether the lane in which the ego begins ends on its way straight on, so that it goes on in another."""
        route, straight = self.found.route, self.found.query["maneuver"] == Maneuver.STRAIGHT
        onward = straight or at_roundabout(self.ledger.situation)
        return onward and ownLane(route).length < route.line.length - LANE

    @property
    def nearest(self) -> float:
        """How far ahead of the ego's centre [m] its tail is at least, in the ego's lane."""
        return self._along(0) - self.limits.length / 2

    @property
    def farthest(self) -> float:
        """How far ahead of the ego's centre [m] its nose is at most, in the ego's lane."""
        return self._along(1) + self.limits.length / 2

    def _along(self, end: int) -> float:
        low, high, *_ = (self.first or self).numbers.range_of("Y")
        beyond = self.found.route.eventAt if "eventAt" in self.stand.at else 0.0
        return (low, high)[end] + beyond + self.room

    # Numbers

    def _bind_speed(self) -> None:
        """Let it come as fast as was said of how it begins, or of how it goes on."""
        numbers, deeds = self.numbers, self.deeds
        ego, top = self.ego_speed, self.limits.fastest
        beside = speed_beside(self.ledger.situation, self.one, ego)
        if beside is not None and top > 0.0:
            low, high, *_ = numbers.ranges["FAST"]  # than the traffic is
            numbers.narrow(
                "FAST", *(min(max(*ends), top) for ends in ((low, FASTER[0] * ego), (high, FASTER[1] * ego)))
            )
            body = Body(self.limits, self.walks)
            holds = (min(speed, body.fastest) for speed in beside)
            numbers.narrow("SPEED", *(holds if self.one.kind.row.body.row.motorised else map(body.wish_for, holds)))
        if any(deed.breaks is Breach.RED_LIGHT for deed in deeds):  # who does not slow down for it, but is in a hurry
            fast = self.one.kind.row.body.row.fast
            numbers.narrow("SPEED", *(min(share * fast, top) for share in HURRIES))
        paces = {deed.manner for deed in deeds if deed.manner in PACES}
        if len(paces) == 1 and any(deed.manner in PACES and deed.act in AT_ONE_SPEED for deed in deeds):
            low, high, *_ = numbers.ranges[PACES[paces.pop()]]
            numbers.narrow("SPEED", low, high)
        passes = any(deed.act is Act.OVERTAKE and deed.whom in (None, EGO) for deed in deeds)
        slow = not self.one.kind.row.body.row.motorised
        if passes and slow and self.one.starts.where in NEXT_LANE:  # who is to pass the ego keeps up with it
            numbers.narrow("SPEED", KEEPS_UP * self.along_speed, self.along_speed)
        if (start := self.one.starts.speed) is not None and not stands_first(self.one):
            numbers.bind("SPEED", start, f"{self.path}.starts.speed")
            check_held(self, numbers.range_of("SPEED")[0], f"{self.path}.starts.speed: {start}")
        for k, deed in enumerate(deeds):
            if deed.speed is not None and deed.act in _KEEPS:
                numbers.bind(self.speed_in(k), deed.speed, f"{self.path}.does.{k}.speed")

    @property
    def one_speed(self) -> bool:
        """Whether one speed at most was said of it, which then is its speed all the time."""
        return sum(deed.speed is not None for deed in self.deeds) + (self.one.starts.speed is not None) <= 1

    def is_its_speed(self, k: int) -> bool:
        """Whether the speed that was said of its k-th deed is its speed all the time."""
        return self.one_speed and self.moves_first(k) and not slows_for_it(self, k)

    def speed_in(self, k: int) -> str:
        """The parameter of the speed that it keeps in its k-th deed, by the last until then of which one was said."""
        said = (n for n in range(k, -1, -1) if self.deeds[n].speed is not None and self.deeds[n].act in _KEEPS)
        n = next(said, None)
        return "SPEED" if n is None or self.is_its_speed(n) else f"SPEED_{n}"

    def moves_first(self, k: int) -> bool:
        """Whether a deed is the first in which it goes anywhere."""
        return all(deed.act in FROM_A_STAND for deed in self.deeds[:k])

    def then(self, k: int) -> Act | None:
        """What it does after its k-th deed; None if that is its last."""
        return self.deeds[k + 1].act if k + 1 < len(self.deeds) else None

    def seconds_to_turn(self, speed: float) -> float:
        """How long [s] it takes to come to a stand, if it then turns round: longer where the road holds less."""
        return speed / min(self.limits.brake, self.limits.throttle, grip_of(self.ledger.situation))

    # Its plan

    def phases(self) -> tuple[str, ...]:
        """What it does until its first deed is due, then deed after deed; empty for what only lies or hides."""
        if self._texts is None:
            phases = Phases(self)
            self._texts = phases.texts()
            self.begins = tuple(phases.due_after)
            if self.careful:
                heedless = self._leaves_before_who_stands()
                careful = (_GOES.sub(r"FollowTraffic(\1, \2)\3", text) for text in self._texts[heedless:])
                self._texts = (*self._texts[:heedless], *careful)
            elif self._comes_behind_another:
                self._texts = tuple(_GOES_ON_IN_OURS.sub(r"FollowTraffic(\1, \2)\3", text) for text in self._texts)
            self._texts = heeds(self, self._texts)
            if self.first is not None and self.stand.behind and self.first.stand.behind:
                ahead = rf"\1{name_of(self.first.one.id)}, -("
                self._texts = tuple(_CLOSE_BEHIND.sub(ahead, text) for text in self._texts)
        return tuple(self.filled(text) for text in self._texts)

    def does_instead(self, phases: tuple[str, ...]) -> None:
        """Let it do something else than follows from its deeds: who hides somebody from a lane of its own."""
        self._texts = phases

    @property
    def careful(self) -> bool:
        """Whether it keeps its distance to whoever is before it: who is not met, and who goes behind others."""
        ahead = sum(other.starts.where is Where.AHEAD for other in self.ledger.situation.others)
        queues = self.one.starts.where is Where.AHEAD and ahead > 1
        comes_in = ahead > 0 and any(deed.act is Act.CUT_IN for deed in self.deeds)
        behind_a_load = self.count > 1 and any(deed.act is Act.DROP_LOAD for deed in self.deeds)
        follows = self.one.role is Role.SUPPORTING or queues or comes_in or behind_a_load
        against = self.stand.meets is Meets.TOWARD and self.one.role is Role.SUPPORTING
        return (against or (self.stand.meets is Meets.ALONG and follows)) and not self.walks

    def _leaves_before_who_stands(self) -> int:
        """In how many of its phases it is not careful: it is about to leave the lane of who stands or is slow."""
        others = [one for one in self.ledger.situation.others if one.id != self.one.id]
        before = any(one.starts.where is Where.AHEAD and stands_first(one) for one in others)
        before = before or any(shows_slow(self.one, one) for one in others)
        if not before or self.one.starts.where is not Where.AHEAD:
            return 0
        leaves = (k for k, deed in enumerate(self.deeds) if deed.act in SIDEWAYS)
        return next((self.begins[k] + 1 for k in leaves if k < len(self.begins)), 0)

    @property
    def _comes_behind_another(self) -> bool:
        """Whether it comes into the ego's lane behind somebody else who goes or stands in that."""
        others = (one for one in self.ledger.situation.others if one.id != self.one.id)
        ahead = any(one.starts.where is Where.AHEAD and one.kind.moves is not Moves.WALKS for one in others)
        return ahead and self.stand.meets is Meets.ALONG and not self.walks

    @property
    def met(self) -> float:
        """After how many seconds [s] an ego that nothing holds is where it meets it."""
        return self.ego.time_at(self.meets_at)

    @property
    def meets_at(self) -> float:
        """How far [m] along its way the ego is where it meets it."""
        route, stand = self.found.route, self.stand
        if stand.anywhere:
            return self.numbers.middle("Y")
        if stand.found is not None:
            return stand.found.ego_meets_at
        return route.exitAt if "exitAt" in "".join(stand.lines) else route.eventAt

    # Its text

    def filled(self, text: str) -> str:
        """A text with names and parameters in the place of marks."""
        one = name_of(self.one.id)
        if OWN in text and self._lane_ends:
            text = text.replace(OWN, "{own}")
        first = one if self.count > 1 else "self"
        for mark in ("next", "beside", "ours", "home", "own", "exit", "off"):
            text = text.replace(f"{{{mark}}}", f"{mark}{one}")
        row = name_of(self.first.one.id) if self.first is not None else one
        marks = {"p": f"way{one}", "i": one, "first": first, "row": row, "we": EGO}
        for mark, name in marks.items():
            text = text.replace(f"{{{mark}}}", name)
        if self.first is not None and self._goes_alike(self.first):
            text = re.sub(r"\$SPEED(?![A-Z0-9_])", self.first.numbers.value("SPEED"), text)  # in a row they go alike
        if self.first is not None and "$Y" in text:
            text = text.replace("$Y", f"<{self.first.one.id}>")
            return self.numbers.filled(text).replace(f"<{self.first.one.id}>", self.first.numbers.value("Y"))
        return self.numbers.filled(text)

    def _goes_alike(self, first: Actor) -> bool:
        """Whether it goes as fast as who is first in its row, since nothing else was said and it can."""
        passed = any(deed.act is Act.OVERTAKE and deed.whom == self.one.id for deed in first.deeds)
        can = first.numbers.range_of("SPEED")[1] <= self.limits.top_speed
        return self.stand.rolls and can and not passed and not self.numbers.is_said("SPEED")

    def moving(self, phases: Sequence[str], *, screened: bool = False) -> str:
        """Its speed at first: who goes the ego's way is under way as the ego is."""
        if phases and (self.stand.rolls or (_DRIVES.match(phases[0]) and screened)):
            self.ledger.take(f"{self.path}.starts.speed")
            return self.filled(", with speed $SPEED")
        if not phases or self.stand.meets is not Meets.ALONG or stands_first(self.one) or self.lies:
            return ""
        if self.one.starts.speed is not None or goes_slowly(self.one):
            self.ledger.take(f"{self.path}.starts.speed")
            return self.filled(", with speed $SPEED")
        if own := _DRIVES.match(phases[0]):
            return f", with speed {own[1]}"
        keeps = self.one.kind.row.body.row.motorised or self.deeds[0].act is Act.KEEP_LEVEL
        return f", with speed {self.first_speed:.4g}" if keeps else self.filled(", with speed $SPEED")

    def role(self) -> str:
        """What it is there for, as a program says it."""
        role = {Role.ADVERSARY: "adversary", Role.SUPPORTING: "background", Role.HIDES: "occluder"}[self.one.role]
        return f", with role '{role}'"
