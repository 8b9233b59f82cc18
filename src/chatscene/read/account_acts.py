"""Where a party of an account starts, and what it does there.

Where it starts follows from the most telling word; what goes without saying of one who starts there is left out.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from chatscene.read.account_rules import FLANK, REAR
from chatscene.read.parse import IN_THE_WAY
from chatscene.read.phrases import Where
from chatscene.read.telling import Contact, Party
from chatscene.terms.actors import Manner
from chatscene.terms.acts import TURNS as TURNING
from chatscene.terms.acts import Action
from chatscene.terms.conclusions import JUNCTIONS, TURNS
from chatscene.terms.scenario import Maneuver, Position, Side

QUIET = frozenset((Action.STAND, Action.FOLLOW, Action.SLOW, Action.FAST))
"""Acts that only say that somebody is there."""
_FELT_FROM_AHEAD = frozenset((Action.BRAKE, Action.STOP, Action.SLOW, Action.WEAVE, Action.HESITATE))
_BESIDE = (Position.BESIDE, Position.AHEAD_BESIDE)


# Where it starts


@dataclass(frozen=True, slots=True)
class _Start:
    """What tells where somebody starts.

    Attributes:
        party: Who it is.
        rear: Whether it touches the ego from behind.
        junction: Whether it is at a junction.
        turns: Whether the ego turns.
        hooked: Whether the ego turns right, across whoever rides on along the kerb.
    """

    party: Party
    rear: bool
    junction: bool
    turns: bool
    hooked: bool

    def does(self, *actions: Action) -> bool:
        """Whether it does any of these."""
        return not set(actions).isdisjoint(self.party.acts)

    def is_at(self, *where: Where) -> bool:
        """Whether it is said to be at any of these."""
        return not self.party.where.isdisjoint(where)

    @property
    def walks(self) -> bool:
        """Whether it goes on foot."""
        return self.party.kind.row.manner is Manner.WALKS

    @property
    def rides(self) -> bool:
        """Whether it rides a bicycle or the like."""
        return self.party.kind.row.manner is Manner.RIDES

    @property
    def is_turning(self) -> bool:
        """Whether it turns at a junction."""
        return self.does(*TURNING)

    @property
    def is_lateral(self) -> bool:
        """Whether it is in another lane than the ego, or comes from one."""
        return self.does(Action.CUT_IN, Action.CHANGE_LANE, Action.PACE) or self.is_at(Where.NEXT_LANE, Where.BESIDE)


def position_of(party: Party, contact: Contact | None, facts: dict[str, Any]) -> Position | None:
    """Where somebody starts, from the most telling word to the least."""
    part = contact.part if contact is not None and not contact.ego_hits else ""
    start = _Start(
        party=party,
        rear=REAR.search(part) is not None and FLANK.search(part) is None,
        junction=facts.get("place") in JUNCTIONS,
        turns=facts.get("maneuver") in TURNS,
        hooked=facts.get("maneuver") is Maneuver.RIGHT_TURN and party.side is Side.RIGHT,
    )
    found = (question(start) for question in _QUESTIONS)
    return next((position for position in found if position is not None), None)


def _lying(start: _Start) -> Position | None:
    return Position.AHEAD if start.party.kind.lies and not start.is_at(Where.EDGE) else None


def _against_the_ego(start: _Start) -> Position | None:
    opposite = (start.is_at(Where.OPPOSITE) or start.does(Action.ONCOMING)) and not start.does(Action.OVERTAKE)
    return Position.ONCOMING if opposite or start.does(Action.WRONG_WAY) else None


def _out_of_a_space(start: _Start) -> Position | None:
    if start.does(Action.PULL_OUT) and not start.walks:
        return Position.KERB
    if start.does(Action.REVERSE, Action.U_TURN) and start.is_at(Where.EDGE):
        return Position.KERB
    if not start.does(Action.REVERSE):
        return None
    return Position.BEHIND if start.is_at(Where.BEHIND) else Position.AHEAD


def _from_an_arm(start: _Start) -> Position | None:
    if not start.is_at(Where.ARM):
        return None
    return Position.ROADSIDE if start.walks else Position.CROSSING


def _beside_the_road(start: _Start) -> Position | None:
    crosses = start.does(Action.CROSS)
    if not start.walks and not (start.rides and crosses):
        return None
    if start.turns and crosses:
        return Position.FAR_CORNER
    if not crosses and start.is_at(Where.AHEAD) and not start.is_at(Where.EDGE, Where.FROM_SIDE):
        return None
    if not crosses and not start.is_at(Where.EDGE, Where.FROM_SIDE) and start.party.side is None:
        return None
    on_road = start.rides and start.junction and not start.is_at(Where.EDGE)
    return Position.CROSSING if on_road else Position.ROADSIDE


def _behind(start: _Start) -> Position | None:
    if start.does(Action.TAILGATE):
        return Position.BEHIND
    if start.is_at(Where.BEHIND):
        aside = start.is_lateral or start.party.side is not None
        return Position.BEHIND_BESIDE if aside else Position.BEHIND
    return Position.BEHIND_BESIDE if start.does(Action.OVERTAKE) else None


def _against_the_lights(start: _Start) -> Position | None:
    return Position.CROSSING if start.does(Action.RUN_LIGHT) else None


def _in_another_lane(start: _Start) -> Position | None:
    if not start.is_lateral:
        return None
    if start.is_at(Where.AHEAD):
        return Position.AHEAD if start.does(Action.CHANGE_LANE) else Position.AHEAD_BESIDE
    return Position.BESIDE


def _beside_at_the_kerb(start: _Start) -> Position | None:
    goes_on = QUIET.issuperset(start.party.acts) and not start.is_at(Where.FROM_SIDE, Where.EDGE, Where.AHEAD)
    return Position.BESIDE if start.hooked and start.rides and goes_on and not start.rear else None


def _across(start: _Start) -> Position | None:
    sided = start.party.side is not None
    wayward = start.party.wayward and start.junction and not start.rear
    if start.junction and sided and start.is_at(Where.FROM_SIDE) and not start.is_lateral:
        return Position.CROSSING
    if start.does(Action.CROSS) or wayward:
        return Position.CROSSING if sided or not start.is_turning else None
    return Position.CROSSING if start.is_turning and sided and start.junction else None


def _in_the_lane(start: _Start) -> Position | None:
    if start.is_turning:
        return None  # it may come from anywhere
    if start.rear:
        return Position.BEHIND
    if start.does(Action.STAND, Action.NARROW, Action.BLOCK):
        at_edge = start.is_at(Where.EDGE) and not start.is_at(Where.OWN_LANE)
        return Position.KERB if at_edge else Position.AHEAD
    if not start.is_at(Where.AHEAD, Where.OWN_LANE):
        return Position.AHEAD if _is_felt_from_ahead(start) else None
    return Position.AHEAD_BESIDE if start.party.side is not None and not start.rides else Position.AHEAD


def _is_felt_from_ahead(start: _Start) -> bool:
    """Whether somebody does what only matters to who drives behind: brakes, stops, weaves, crawls."""
    acts = start.party.acts
    sided = start.party.side is not None or start.is_at(Where.FROM_SIDE, Where.EDGE)
    return not start.walks and not sided and bool(acts) and _FELT_FROM_AHEAD.issuperset(acts)


_QUESTIONS: tuple[Callable[[_Start], Position | None], ...] = (
    _lying,
    _against_the_ego,
    _out_of_a_space,
    _from_an_arm,
    _beside_the_road,
    _behind,
    _against_the_lights,
    _in_another_lane,
    _beside_at_the_kerb,
    _across,
    _in_the_lane,
)


# What it does


def acts_of(party: Party, position: Position | None, *, touched: bool) -> list[Action]:
    """The acts in order, without those that go without saying."""
    acts = list(party.acts)
    if touched and position is not Position.AHEAD:
        quick = Action.FAST in acts and position is Position.BEHIND_BESIDE
        acts = acts if quick else _without(acts, Action.SLOW, Action.FAST)
    for change in _CHANGES:
        acts = change(acts, party, position)
    return list(dict.fromkeys(acts))


def _without(acts: list[Action], *actions: Action) -> list[Action]:
    return [one for one in acts if one not in actions]


def _from_there(acts: list[Action], party: Party, position: Position | None) -> list[Action]:
    """Acts as they are from where somebody starts: who comes towards the ego does not cut in."""
    if position in _BESIDE:
        return _without(acts, Action.CROSS)
    if position is Position.CROSSING:
        return _without(acts, Action.CUT_IN)
    if position is not Position.ONCOMING:
        return acts
    if Where.OWN_LANE in party.where and set(acts) <= {Action.FOLLOW, Action.ONCOMING}:
        return [Action.WRONG_WAY]
    acts = [Action.SWERVE if one is Action.CUT_IN else one for one in acts]
    return _without(acts, Action.CROSS, Action.FOLLOW, Action.ONCOMING) or [Action.ONCOMING]


def _not_askew(acts: list[Action], party: Party, _position: Position | None) -> list[Action]:
    """Cars go diagonally only if they do nothing else: "stopped diagonally"."""
    if party.kind.row.manner is Manner.DRIVES and len(acts) > 1:
        return _without(acts, Action.DIAGONAL)
    return acts


def _crossing(acts: list[Action], _party: Party, position: Position | None) -> list[Action]:
    """Who comes from the side crosses, unless something says otherwise."""
    if position is Position.CROSSING and set(acts) <= {Action.FOLLOW, Action.FAST, Action.STAND}:
        return [Action.CROSS, *acts]
    if position is Position.CROSSING and Action.HESITATE in acts and Action.CROSS not in acts:
        return [Action.CROSS, *_without(acts, Action.SLOW)]
    walks_on = position in (Position.ROADSIDE, Position.FAR_CORNER) and Action.CROSS not in acts
    if walks_on and Action.HESITATE in acts:
        return [Action.CROSS, *acts]
    if position in (Position.ROADSIDE, Position.FAR_CORNER) and set(acts) <= {Action.FOLLOW, Action.FAST}:
        return [Action.CROSS]
    return acts


def _not_crossing(acts: list[Action], _party: Party, position: Position | None) -> list[Action]:
    if position is Position.KERB:
        acts = _without(acts, Action.CUT_IN, Action.CROSS)
    return _without(acts, Action.CROSS) if {Action.OVERTAKE, Action.RUN_LIGHT} & set(acts) else acts


def _stopping(acts: list[Action], _party: Party, _position: Position | None) -> list[Action]:
    """Who crosses, and then stands, stops; who stops, and then goes on, hesitates."""
    if Action.STOP in acts and Action.FOLLOW in acts[acts.index(Action.STOP) :]:
        acts = [Action.HESITATE if one is Action.STOP else one for one in _without(acts, Action.FOLLOW)]
    if Action.CROSS in acts and Action.STAND in acts[acts.index(Action.CROSS) :]:
        return [Action.STOP if one is Action.STAND else one for one in acts]
    return acts


def _one_for_two(acts: list[Action], _party: Party, _position: Position | None) -> list[Action]:
    """One act where another is a part of it: who brakes is in the way by that."""
    if IN_THE_WAY & set(acts):
        acts = _without(acts, Action.BLOCK)
    if Action.CUT_IN in acts:
        acts = _without(acts, Action.CHANGE_LANE, Action.SWERVE)
    return _without(acts, Action.CUT_IN, Action.CROSS, Action.SWERVE) if TURNING.keys() & set(acts) else acts


def _turning_back(acts: list[Action], party: Party, _position: Position | None) -> list[Action]:
    """Who turns back on foot was crossing."""
    crossed = Action.TURN_BACK in acts and Action.CROSS not in acts and party.kind.is_vulnerable
    return [Action.CROSS, *acts] if crossed else acts


def _telling_acts(acts: list[Action], _party: Party, position: Position | None) -> list[Action]:
    """Acts without those that only say that somebody is there, if there are others."""
    if set(acts) - QUIET:
        acts = _without(acts, Action.STAND, Action.FOLLOW)
        slow = acts[-1] is Action.SLOW or Action.WRONG_WAY in acts
        return _without(acts, Action.SLOW) if slow else acts
    if Action.FAST in acts:
        acts = _without(acts, Action.FOLLOW)
    if Action.STAND in acts and len(acts) > 1:
        acts = _without(acts, Action.STAND if position is Position.BEHIND else Action.FOLLOW)
    return acts or ([Action.FOLLOW] if position is Position.BEHIND else [])


_CHANGES: tuple[Callable[[list[Action], Party, Position | None], list[Action]], ...] = (
    _from_there,
    _not_askew,
    _crossing,
    _not_crossing,
    _stopping,
    _one_for_two,
    _turning_back,
    _telling_acts,
)
