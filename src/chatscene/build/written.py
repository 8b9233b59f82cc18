"""Somebody's part of a program: the lines that it names, what it does, where it stands."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass

from chatscene.build.actor import Actor
from chatscene.build.asked import PARKED_APART, Meets, between, is_still
from chatscene.build.deeds import OWN
from chatscene.build.hiding import place_hiding
from chatscene.build.naming import name_of
from chatscene.build.numbers import strong
from chatscene.build.over_lanes import is_lane, lane_line, side_beside
from chatscene.build.parts import parts_of
from chatscene.build.place import LANE, turns_round_from_opposite
from chatscene.build.screening import Screen, from_its_lane, screen_of, stands_at
from chatscene.errors import NotBuilt, NothingBuilds
from chatscene.terms.vocabulary import Facing, Role, Side, UserKind, Where
from chatscene.world.places import lanes_beside

ON_FOOT, BESIDE = 1.3, 0.7  # [m] between the middles of two on foot side by side; between the sides of two
_IN_LANE = re.compile(r"pointOn\(egoRoute, level\{i\}(?:, ([^()]+))?\)")
"""Where somebody on foot is who is in the ego's lane."""
_ABOUT = (0.0, 1.7, -1.2, 2.9)
"""How far to the left of the first [m] others are who are about the road with it: over both lanes, if it has two."""
_KEEPS_PLACE = re.compile(r"(PaceOnPath\([^,]+, ego, )([^,]+)")


@dataclass(frozen=True, slots=True)
class Written:
    """A road user in the text of a program.

    Attributes:
        actor: Who.
        hidden: Whom it hides, beside whom it then stands; None if it hides nobody.
    """

    actor: Actor
    hidden: Actor | None

    def code(self) -> list[str]:
        """Its lines; of who hides somebody, beside whom it hides."""
        one = name_of(self.actor.one.id)
        screen = self._screen()
        phases = self.actor.phases()
        named = self._lines(screen)
        body = "\n".join(phases)
        if self.hidden is not None and screen is None and f"way{one}" in body:
            stands = f"{self.actor.one.id} hides {self.hidden.one.id}, so it only stands there"
            raise NothingBuilds(f"cannot be built yet: {self.actor.path}.does: {stands}")
        if any(f"own{one}" in text for text in (body, *named)):
            named.insert(0, f"own{one} = ownWay(egoRoute)")
        named += self._named(body)
        if phases:
            named += [f"behavior Does{one}():", *(f"    do {text}" for text in phases)]
        rows = [self._in_row(phases, n) for n in range(self.actor.count)]
        for n, texts in enumerate(rows):
            if texts != phases:
                named += [f"behavior Does{one}_{n}():", *(f"    do {text}" for text in texts)]
        cls = (
            "VendingMachine"
            if self.actor.one.role is Role.HIDES and self.actor.one.kind is UserKind.OBJECT
            else self.actor.one.kind.scenic
        )
        lines = list(named)
        for n in range(self.actor.count):
            place, facing = self._placed(screen, n)
            said = f"{one if n == 0 else f'{one}_{n}'} = new {cls} at {place}, facing {facing}"
            said += f", with label '{self.actor.one.id}'" + self.actor.role()
            does = f"Does{one}" if rows[n] == phases else f"Does{one}_{n}"
            said += self.actor.moving(phases, screened=screen is not None) + strong(self.actor.numbers.row)
            lines.append(said + (f", with behavior {does}()" if phases else ""))
        lines += parts_of(self.actor, self._away, self._apart)
        if is_still(self.actor.one):
            self.actor.ledger.take(f"{self.actor.path}.starts.speed")  # it stands
        self.actor.ledger.take(*self.actor.numbers.built())
        return [f"## {self.actor.one.id}: {self._said()}", *lines]

    def _named(self, body: str) -> Iterator[str]:
        """The lines of other ways that the text of what it does speaks of."""
        one = name_of(self.actor.one.id)
        if f"beside{one}" in body:
            yield f"beside{one} = {self._beside()}"
        if f"next{one}" in body:
            yield f"next{one} = {self._next()}"
        if f"ours{one}" in body:
            yield f"ours{one} = against(ownLane(egoRoute))"
        if re.search(rf"\bexit{one}\b", body):
            yield f"exit{one} = offRamp(egoRoute)"
        if f"off{one}" in body:
            yield f'off{one} = wayOff(egoRoute, "{self.actor.named["off"]}")'
        if f"home{one}" in body:
            across = turns_round_from_opposite(self.actor.found, self.actor.one)
            yield f"home{one} = " + (OWN if across else 'neighbourPath(egoRoute, "left")')

    def _screen(self) -> Screen | None:
        """How it hides somebody from a lane of its own; None if it hides nobody so."""
        if self.hidden is None or not from_its_lane(self.actor.ledger.situation, self.actor.one, self.hidden.one):
            return None
        screen = screen_of(self.actor, self.hidden)
        self.actor.does_instead(screen.phases)
        return screen

    def _lines(self, screen: Screen | None) -> list[str]:
        """What is named before, as a program says it."""
        if screen is None and self.hidden is not None:
            return []
        texts = (screen.way,) if screen is not None else (self.actor.stand.way, *self.actor.stand.lines)
        way, *lines = (self.actor.filled(text) for text in texts)
        return [f"way{name_of(self.actor.one.id)} = {way}", *lines]

    def _placed(self, screen: Screen | None, n: int) -> tuple[str, str]:
        """Where the n-th of it stands, and which way it faces."""
        if screen is not None:
            return stands_at(self.actor, screen, n)
        return place_hiding(self.actor, self.hidden, n) if self.hidden is not None else self._place(n)

    def _in_row(self, phases: tuple[str, ...], n: int) -> tuple[str, ...]:
        """The phases of the n-th of it, which keeps its place in the row."""
        if not n or self.actor.stand.meets is not Meets.ALONG:
            return phases
        more = f" {self._away} {n * self._apart:g}"
        return tuple(_KEEPS_PLACE.sub(rf"\1\2{more}", text) for text in phases)

    @property
    def _apart(self) -> float:
        """How far [m] the middles of two in its row are apart."""
        if self.actor.stand.meets in (Meets.ALONG, Meets.TOWARD):
            return (self.actor.limits.length or 1.5) + between(self.actor.one, self.actor.ego_speed)
        return (self.actor.limits.length or 1.5) + PARKED_APART

    @property
    def _abreast(self) -> float:
        """How far [m] the middles of two are apart along the road who are beside it: by how wide they are, seen so."""
        limits, along = self.actor.limits, (Facing.ALONG, Facing.AGAINST)
        return max(ON_FOOT, BESIDE + (limits.length if self.actor.one.starts.facing in along else limits.width))

    def _about(self, n: int) -> tuple[float, float]:
        """Where the n-th of several stands who are about the road on foot: how far on, and how far to the left [m]."""
        limits = self.actor.limits
        return n * (max(limits.length, limits.width) + BESIDE), _ABOUT[n % len(_ABOUT)]

    @property
    def _away(self) -> str:
        """The sign of who is farther from the ego along its way; behind it, of who is beside it and behind others."""
        if self.actor.one.starts.where is Where.BESIDE and self._is_behind_others:
            return "-"
        along = (Meets.ALONG, Meets.KERB) if self.actor.one.starts.where is not Where.ONCOMING else (Meets.ALONG,)
        return "+" if self.actor.stand.meets in along and not self.actor.stand.behind else "-"

    @property
    def _is_behind_others(self) -> bool:
        """Whether somebody else is farther on in the lane beside the ego, in which it is."""
        starts = (one.starts for one in self.actor.ledger.situation.others if one.id != self.actor.one.id)
        sides = (self.actor.one.starts.side, None)
        return any(start.where is Where.AHEAD_BESIDE and start.side in sides for start in starts)

    def _beside(self) -> str:
        """The line beside the ego's lane: that of a lane of its direction if there is one; else where others come."""
        said = self.actor.named.get("side")
        side, line = side_beside(self.actor, Side(said) if said else None)
        if line:
            return line
        if side not in lanes_beside(self.actor.found.route):
            raise NotBuilt(f"no map has such a place: {self.actor.path} needs a lane to the {side} of ours")
        return f"extended({OWN}, 60).offset({'' if side == Side.LEFT else '-'}{LANE})"

    def _next(self) -> str:
        """The line of a lane of the ego's direction that is not next to the ego's.

        Raises:
            NotBuilt: There is none.
        """
        lane = int(self.actor.named["lane"])
        if not is_lane(self.actor.found.route, lane):
            side = Side.LEFT if lane > 0 else Side.RIGHT
            raise NotBuilt(f"no map has such a place: {self.actor.path} needs a second lane to the {side} of ours")
        return lane_line(lane)

    def _place(self, n: int) -> tuple[str, str]:
        """Where the n-th of it stands, and which way it faces."""
        stand, one = self.actor.stand, name_of(self.actor.one.id)
        large = self.actor.limits.length > ON_FOOT
        if n and large and (about := _IN_LANE.fullmatch(stand.point)) is not None:
            far, aside = self._about(n)
            left = f"{about[1]} + {aside:g}" if about[1] else f"{aside:g}"
            point = f"pointOn(egoRoute, level{{i}} + {far:g}, {left})"
            return self.actor.filled(point), self.actor.filled(
                stand.facing.replace("level{i}", f"level{{i}} + {far:g}")
            )
        if stand.point:
            aside = f" + {self._abreast * ((n + 1) // 2) * (-1 if n % 2 else 1):g}" if n else ""
            point, facing = (text.replace("level{i}", f"level{{i}}{aside}") for text in (stand.point, stand.facing))
            return self.actor.filled(point), self.actor.filled(facing)
        at = self.actor.filled(stand.at) + (f" {self._away} {n * self._apart:g}" if n else "")
        turn = f", {stand.turn:g}" if stand.turn else ""
        return f"pointOn(way{one}, {at})", f"directionOn(way{one}, {at}{turn})"

    def _said(self) -> str:
        """What it is and does, for a comment."""
        side = f" {self.actor.one.starts.side}" if self.actor.one.starts.side else ""
        does = ", then ".join(deed.act for deed in self.actor.deeds) or "nothing said"
        return f"{self.actor.one.kind} {self.actor.one.starts.where}{side}: {does}"
