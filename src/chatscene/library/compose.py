"""Behaviors that nobody wrote: where no snippet does just what was said, the acts that were said, one after the other.

Each act has a step: what is done for it by somebody who goes along a line, or who comes from beside the road. What a
composed behavior does before its first act goes by where it starts, and its parameters by the steps that it takes.
Its id says all of this, and the behavior is composed again from the id alone: ``behavior/composed.car.ahead.brake``.
"""

from __future__ import annotations

import itertools
import operator
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

from chatscene.errors import SnippetError
from chatscene.library.act_steps import (
    ACROSS,
    ACROSS_RIDING,
    ADV_TURNS,
    AT_JUNCTION,
    BACKING,
    BACKING_UP_TO_EGO,
    BEFORE_EVENT,
    BRAKES_TO_STAND,
    BRISKLY,
    COMES,
    COMES_UP,
    ON_FOOT,
    PAST,
    PAUSE,
    RANGES,
    RESTS,
    RIDDEN,
    SETS_OFF,
    SETS_OFF_TO_CREEP,
    STARTS,
    STOP,
    WAITS,
    Start,
    Step,
)
from chatscene.library.snippet_file import names_in
from chatscene.terms.actors import AdversaryKind, Manner
from chatscene.terms.acts import Action
from chatscene.terms.plan_text import parse_plan, print_plan
from chatscene.terms.scenario import Component, Position, Side, Slots
from chatscene.terms.snippet import ParameterRange, Snippet

COMPOSED = "behavior/composed."

_THERE, _HELD = "-at-junction", "-of-standing-ego"


@dataclass(frozen=True, slots=True, kw_only=True)
class Asked:
    """What a composed behavior is to do.

    Attributes:
        kind: Who does it.
        position: Where it starts.
        actions: What it does, in order.
        junction: Whether it is at a junction, where that makes another start of the position.
        ego_stands: Whether the ego stands all the time, so that nothing can be due when it comes near.
    """

    kind: AdversaryKind
    position: Position
    actions: tuple[Action, ...]
    junction: bool = False
    ego_stands: bool = False

    @property
    def snippet_id(self) -> str:
        """The id of the behavior."""
        there = _THERE if self.junction and self.position in AT_JUNCTION else ""
        held = _HELD if self.ego_stands else ""
        return COMPOSED + ".".join((self.kind, self.position + there + held, *self.actions))


def _start(asked: Asked) -> Start | None:
    if _walks(asked):
        return ON_FOOT.get(asked.position)
    return (asked.junction and AT_JUNCTION.get(asked.position)) or STARTS.get(asked.position)


def compose(asked: Asked) -> Snippet | None:
    """A behavior that does what is asked for and nothing else; None if there are no steps for that, or not in order."""
    start = _start(asked)
    if start is None or not asked.actions or (_never_moves(asked) and not _stands(asked)):
        return None
    steps = ACROSS_RIDING if start.steps is ACROSS and not _walks(asked) else start.steps
    lasting = {action for action in asked.actions if action.row.all_along}
    acts = [action for action in asked.actions if action not in lasting]
    if acts[:1] and acts[0] in start.given:
        acts = acts[1:]  # it comes from there
    if Action.BLOCK in lasting and Action.STOP not in acts and not _stands(asked):
        acts.append(Action.STOP)
    if not _doable(asked, start, steps, acts, lasting):
        return None
    return _snippet(asked, start, _meanwhile(steps, acts), tuple(_phases(asked, start, steps, acts)))


def _meanwhile(steps: dict[Action, Step], acts: Sequence[Action]) -> float:
    """How long [s] it is, about, from the beginning of the first act to that of the last."""
    halts_first = 2.0 if acts[-1:] == [Action.REVERSE] else 0.0
    return sum(steps[action].takes for action in acts[:-1]) + halts_first


def _doable(
    asked: Asked, start: Start, steps: dict[Action, Step], acts: Sequence[Action], lasting: set[Action]
) -> bool:
    """Whether there are steps for all of it, in this order, and time for it before the ego meets anything."""
    if _stands(asked):
        in_the_way = {Action.BLOCK} if asked.position in _IN_LANE else set[Action]()
        at_its_edge = {Action.NARROW} if asked.position is Position.AHEAD and not _walks(asked) else set[Action]()
        return not acts and lasting <= {Action.STAND} | in_the_way | at_its_edge
    if not set(acts) <= steps.keys() or not lasting <= {*start.given, *_PACES, Action.BLOCK}:
        return False
    return (
        _go_together(asked, start, acts, lasting)
        and _in_order(start, steps, acts)
        and not _too_late(asked, start, steps, acts, lasting)
    )


def _go_together(asked: Asked, start: Start, acts: Sequence[Action], lasting: set[Action]) -> bool:
    """Whether somebody who starts there does all of this, in whatever order."""
    if any(_AGAINST.get(action, frozenset()).intersection(asked.actions) for action in asked.actions):
        return False
    if asked.ego_stands and _WITH_EGO.intersection(acts):
        return False
    behind = asked.position in (Position.BEHIND, Position.BEHIND_BESIDE)
    if Action.BLOCK in lasting and (behind or not (start.in_way or _ENTERS.intersection(acts))):
        return False
    blocks = Action.BLOCK in lasting and acts[:1] == [Action.ACCELERATE]
    if _meets(start) and (blocks or (_AWAY.intersection(acts) and {*asked.actions} - start.given - {acts[0]})):
        return False  # across a junction there is no room for more
    sluggish = asked.kind.row.limits.throttle < _SLUGGISH
    late = (
        sluggish and not asked.ego_stands and (Action.OVERTAKE in acts or (Action.TAILGATE in acts and len(acts) > 1))
    )
    return not (late or (Action.TAILGATE in acts and not asked.kind.row.motorised))


def _in_order(start: Start, steps: dict[Action, Step], acts: Sequence[Action]) -> bool:
    """Whether each act can follow the one before it."""
    if (_on_foot_ahead(start) and len(acts) > 1) or (start.first is not None and acts[:1] != [start.first]):
        return False
    if any(steps[action].after not in (None, before) for before, action in zip((None, *acts), acts, strict=False)):
        return False
    backs = any(one is Action.REVERSE and after not in _AFTER_BACKING for one, after in pairwise(acts))
    return not (backs or _AT_FIRST.intersection(acts[1:]) or any(two in _NEVER for two in pairwise(acts)))


def _too_late(
    asked: Asked, start: Start, steps: dict[Action, Step], acts: Sequence[Action], lasting: set[Action]
) -> bool:
    """Whether something comes when it can no longer be done: who has stood does not overtake."""
    stood = itertools.accumulate((steps[action].halts for action in acts), operator.or_, initial=False)
    if any(steps[action].moving and before for action, before in zip(acts, stood, strict=False)):
        return True
    slow_there = _meets(start) and asked.kind.row.limits.throttle < _SLUGGISH
    hurries = _meets(start) and Action.FAST in lasting  # it sets off there, and is not fast in time
    return hurries or (slow_there and bool(Action.REVERSE in acts or Action.BLOCK in lasting))


def goes_without_saying(asked: Asked) -> frozenset[Action]:
    """What whoever does what is asked for does as well: who reverses has stopped, who stands ahead is in the way."""
    start = _start(asked)
    implied = {one for action in asked.actions for one in _IMPLIED.get(action, ())}
    return frozenset(implied | (start.given if start else frozenset()))


def asked_in(snippet_id: str) -> Asked:
    """What the composed behavior of an id is to do.

    Raises:
        SnippetError: It is no such id.
    """
    try:
        kind, position, *actions = snippet_id.removeprefix(COMPOSED).split(".")
        place, there, held = _parted(position)
        return Asked(
            kind=AdversaryKind(kind),
            position=Position(place),
            actions=tuple(map(Action, actions)),
            junction=there,
            ego_stands=held,
        )
    except ValueError as error:
        raise SnippetError(f"there is no snippet {snippet_id!r}: {error}") from error


def _parted(position: str) -> tuple[str, bool, bool]:
    held = position.endswith(_HELD)
    position = position.removesuffix(_HELD)
    return position.removesuffix(_THERE), position.endswith(_THERE), held


def composed_again(snippet_id: str) -> Snippet:
    """The composed behavior of an id.

    Raises:
        SnippetError: There is none.
    """
    if (made := compose(asked_in(snippet_id))) is None:
        raise SnippetError(f"there is no snippet {snippet_id!r}: no step of a plan does that")
    return made


_LEADS = (Position.AHEAD, Position.BESIDE, Position.AHEAD_BESIDE)  # from there one gets ahead before one acts
_BESIDE_EGO = (Position.BESIDE, Position.AHEAD_BESIDE)
_FROM_OTHER_SIDE = {Action.TURN_LEFT: Side.RIGHT, Action.TURN_RIGHT: Side.LEFT}  # or the turn leads away from the ego
_IN_LANE = (Position.AHEAD, Position.BEYOND)  # who stands there is in the ego's way
_PART_OF_HALTING = (Action.BRAKE, Action.CROSS)  # what need not be done before somebody halts
_IMPLIED = {
    Action.STAND: (Action.BLOCK,),
    Action.BLOCK: (Action.STAND,),
    Action.NARROW: (Action.STAND, Action.BLOCK),
    Action.REVERSE: (Action.STOP,),
    Action.STOP: (Action.BRAKE, Action.BLOCK),
}
_HASTE = {Action.SLOW, Action.FAST}
_AGAINST = {
    Action.BLOCK: frozenset((Action.CHANGE_LANE, Action.SWERVE, Action.WEAVE, Action.REVERSE, Action.SLOW)),
    Action.SLOW: frozenset(
        (Action.FAST, Action.ACCELERATE, Action.PACE, Action.TAILGATE, Action.OVERTAKE, Action.SWERVE, Action.WEAVE)
    ),
    Action.TURN_LEFT: frozenset((Action.CROSS, Action.SLOW)),
    Action.FAST: frozenset(
        (Action.BRAKE, Action.STOP, Action.HESITATE, Action.REVERSE, Action.BLOCK, Action.PACE, Action.TAILGATE)
    ),
}  # what does not go with it
_NEVER = frozenset(
    (
        *itertools.product((Action.HESITATE, Action.ACCELERATE), (Action.REVERSE, Action.OVERTAKE)),
        *itertools.product((Action.CUT_IN, Action.CHANGE_LANE), (Action.OVERTAKE, Action.CUT_IN, Action.CHANGE_LANE)),
    )
)  # one after the other
# What comes first or not at all: it was level, or close, from the beginning on, or swings too long for what is left
_AT_FIRST = frozenset((Action.PACE, Action.TAILGATE, Action.CROSS, Action.WEAVE))
_AFTER_BACKING = (Action.STOP, Action.ACCELERATE)
_FROM_REST = (Action.REVERSE, Action.ACCELERATE)  # what somebody does from where he stands
_ENTERS = frozenset((Action.CUT_IN, Action.PULL_OUT, Action.CROSS))
_AWAY = frozenset((Action.SWERVE, Action.WEAVE))
_WITH_EGO = frozenset((Action.PACE, Action.TAILGATE))  # which nobody does with an ego that stands
_SLUGGISH = 2.5  # [m/s²] at full throttle: of whoever has less, the ego is sooner where they are to be
_PACES = {Action.FOLLOW, Action.SLOW, Action.FAST}  # what lasts is a speed


def _stands(asked: Asked) -> bool:
    """Whether it stands from the beginning on."""
    quiet = all(action.row.all_along for action in asked.actions)
    in_lane = asked.position in _IN_LANE and quiet
    return Action.STAND in asked.actions or (in_lane and not {Action.BLOCK, Action.NARROW}.isdisjoint(asked.actions))


def _never_moves(asked: Asked) -> bool:
    """Whether it can only stand, being a thing or where nobody else has a start."""
    return asked.kind.lies or asked.position is Position.BEYOND


def _meets(start: Start) -> bool:
    """Whether its way and the ego's meet in a junction."""
    return start.opening[:1] == (SETS_OFF,)


def _on_foot_ahead(start: Start) -> bool:
    return start is ON_FOOT[Position.AHEAD]


def _walks(asked: Asked) -> bool:
    return asked.kind.row.manner is Manner.WALKS


def _phases(asked: Asked, start: Start, steps: dict[Action, Step], acts: Sequence[Action]) -> Iterator[str]:
    """What is done, phase by phase."""
    if not acts and _stands(asked):
        on_the_spot = start.steps is ACROSS or _walks(asked) or asked.position in _IN_LANE
        yield "Halt()" if on_the_spot else f"BrakeOnPath({start.path}, 1)"
    elif not acts:
        yield from _on_its_way(asked, start)
    elif _on_foot_ahead(start):
        yield from (*_begins(asked, start), *steps[acts[0]].last)
    else:
        yield from _acting(asked, start, steps, acts)


def _acting(asked: Asked, start: Start, steps: dict[Action, Step], acts: Sequence[Action]) -> Iterator[str]:
    """The phases of acts, with what leads to the first and from each to the next."""
    yield from _opening(asked, start, acts, steps)
    path, across = start.path, start.steps is ACROSS
    stands = asked.ego_stands and len(start.waiting) == 1 and not across
    for before, action, after in zip((None, *acts), acts, (*acts[1:], None), strict=False):
        step, following = steps[action], steps[after] if after else None
        hesitates = action is Action.STOP and after is Action.HESITATE
        if following and following.halts and (action in _PART_OF_HALTING or hesitates):
            continue
        if before is Action.REVERSE and action is Action.STOP:
            yield "Halt()" if after is None else "Halt() for $STOP_TIME seconds"
            continue  # it stands already
        if across and not stands and before in (None, Action.CROSS, Action.BRAKE) and step.halts:
            yield from (RESTS,) if after is None else (BRISKLY, RESTS)
        elif across and before is None and action is not Action.CROSS:
            yield f"{COMES} until abs(offsetFrom(egoRoute, self)) < 2.5"
        elif not across and not stands and action is Action.REVERSE:
            yield from (BRAKES_TO_STAND.format(path=path), "Halt() for 0.5 seconds")
        elif not across and stands and action not in _FROM_REST and (before is not None or _slows(action, step)):
            yield f"DrivePath({path}, $ADV_SPEED) for 2.5 seconds"
        path = step.path or path
        does = step.does if after is Action.CUT_IN else (*step.does, *step.back)
        if after is None:
            does = step.last or (*does, "DrivePath({path}, $ADV_SPEED)")
        yield from (phase.format(path=path) for phase in does)
        stands = step.stands


def _sets_off(asked: Asked) -> str:
    """The phase before somebody comes whose way and the ego's meet in a junction."""
    return WAITS if asked.ego_stands else SETS_OFF


def _slows(action: Action, step: Step) -> bool:
    return step.halts or action is Action.BRAKE


def _on_its_way(asked: Asked, start: Start) -> Iterator[str]:
    """What somebody does of whom no act was said: goes on."""
    if Action.SLOW in asked.actions and _meets(start):
        yield from (WAITS if asked.ego_stands else SETS_OFF_TO_CREEP[0], *SETS_OFF_TO_CREEP[1:])
    elif start.steps is ACROSS or _meets(start):
        yield _begins(asked, start)[0]
    yield COMES if _walks(asked) or start.steps is ACROSS else f"DrivePath({start.path}, $ADV_SPEED)"


def _begins(asked: Asked, start: Start) -> tuple[str, ...]:
    return start.waiting if asked.ego_stands and start.waiting else start.opening


def _opening(asked: Asked, start: Start, acts: Sequence[Action], steps: dict[Action, Step]) -> Iterator[str]:
    """What is done until the first act is due."""
    first = acts[0]
    halts = steps[first].halts or (first is Action.BRAKE and any(steps[action].halts for action in acts[1:2]))
    along = f"DrivePath({start.path}, $ADV_SPEED)"
    if steps[first].long and len(acts) == 1:
        yield f"{along} for 0.5 seconds"
    elif _HASTE.intersection(asked.actions) and start.steps is not ACROSS and start.first is None:
        if _meets(start):
            yield _sets_off(asked)
        yield f"{along} for {4 if Action.FAST in asked.actions else 2} seconds"
    elif {Action.CROSS, Action.ONCOMING, Action.BLOCK}.intersection(asked.actions) and _meets(start) and halts:
        yield from (_sets_off(asked), f"{COMES_UP} brakingDistance(self) / $BRAKE - $REST_DISTANCE")
    elif not asked.ego_stands and asked.position in _LEADS and _meanwhile(steps, acts) and first is not Action.PACE:
        yield f"PaceOnPath({start.path}, ego, $LEAD, 16, $LEAST) until {BEFORE_EVENT}"
    else:
        yield from _begins(asked, start)


def _snippet(asked: Asked, start: Start, meanwhile: float, phases: Sequence[str]) -> Snippet:
    text = "\n".join(phases)
    names = list(dict.fromkeys(re.findall(r"\$([A-Z_]+)", text)))
    ranges = {name: _range(asked, start, meanwhile, name) for name in names if name != "LEAST"}
    for name in sorted(names, key=len, reverse=True):
        text = text.replace(f"${name}", _least(asked) if name == "LEAST" else f"globalParameters.OPT_{name}")
    source = "\n".join(
        (
            *(f"param {p.name} = Range({p.low!r}, {p.high!r})" for p in ranges.values()),
            *_constants(asked, start),
            "behavior AdvBehavior():",
            *(f"    do {phase}" for phase in text.split("\n")),
        )
    )
    source = print_plan(parse_plan(source))
    requires, provides = names_in(source)
    return Snippet(
        id=asked.snippet_id,
        component=Component.BEHAVIOR,
        description=_description(asked),
        rephrasings=(),
        slots=Slots(actions=asked.actions, position=asked.position, side=_side(asked)),
        adversaries=(asked.kind,),
        requires=requires,
        provides=provides,
        parameters=tuple(ranges.values()),
        origin="composed of acts",
        source=source,
    )


def _constants(asked: Asked, start: Start) -> tuple[str, ...]:
    if _stands(asked) and asked.position in _IN_LANE and not _walks(asked):
        aside = ("advAside = 0",) if Action.NARROW in asked.actions else ()
        return ("advStill = 0", *aside)
    turns = [ADV_TURNS[action] for action in asked.actions if action in ADV_TURNS]
    return (f'advTurn = "{turns[0]}"',) if turns and _meets(start) else start.constants


def _side(asked: Asked) -> Side | None:
    """From which side it must come, so that a turn leads across the ego's way."""
    if asked.position in _BESIDE_EGO:
        turn = next((one for one in asked.actions if one in _FROM_OTHER_SIDE), None)
        return None if turn is None else _FROM_OTHER_SIDE[turn]
    return Side.RIGHT if Action.TURN_LEFT in asked.actions and asked.position is Position.CROSSING else None


def _description(asked: Asked) -> str:
    acts = "; then ".join(action.row.meaning for action in asked.actions)
    return f"The {asked.kind.replace('-', ' ')} {acts}."


def _least(asked: Asked) -> str:
    return "4" if asked.kind.row.manner is Manner.RIDES else "5"


def _range(asked: Asked, start: Start, meanwhile: float, name: str) -> ParameterRange:
    if name == "ADV_DISTANCE" and start.at is not None:
        sooner, (low, high, meaning) = start.closing * meanwhile, start.at
        low, high = round(low + sooner, 1), round(high + sooner, 1)
        return ParameterRange(name="OPT_ADV_DISTANCE", low=low, high=high, unit="m", meaning=meaning)
    if name == "ADV_SPEED":
        low, high = _speeds(asked)
        return ParameterRange(name="OPT_ADV_SPEED", low=low, high=high, unit="m/s", meaning="how fast it goes")
    low, high, unit, meaning = RANGES[name]
    if name == "STOP_TIME" and (start.steps is ACROSS or meanwhile):
        low, high = PAUSE
    if name == "BACK_TIME" and asked.ego_stands:
        low, high = BACKING_UP_TO_EGO
    elif name == "BACK_TIME" and meanwhile > STOP.takes:
        low, high = BACKING
    if name == "ADV_AHEAD" and meanwhile and Action.OVERTAKE in asked.actions:
        low, high = PAST
    if name == "ADV_GAP" and meanwhile:
        low = 0.6
    if name == "LEAD":
        low, high = round(low + 4 * meanwhile, 1), round(high + 4 * meanwhile, 1)
    return ParameterRange(name=f"OPT_{name}", low=low, high=high, unit=unit, meaning=meaning)


def _speeds(asked: Asked) -> tuple[float, float]:
    row = asked.kind.row
    if Action.SLOW in asked.actions:
        return round(0.4 * row.slow, 2), round(0.8 * row.slow, 2)
    if Action.FAST in asked.actions:
        return round(1.02 * row.fast, 2), round(1.25 * row.fast, 2)
    if _walks(asked) and asked.position is Position.AHEAD:
        return 0.9, 2.2
    if asked.position is Position.ROADSIDE:
        return _speeds_across(asked)
    if asked.position in (Position.ONCOMING, Position.CROSSING):
        return (4, 7) if row.manner is Manner.RIDES and not row.motorised else (6, 10)
    behind = asked.position is Position.BEHIND and len(asked.actions) > 1  # or it runs into the ego at once
    return (3.5, 6) if not row.motorised else (3.5, 6) if behind else (5, 9)


def _speeds_across(asked: Asked) -> tuple[float, float]:
    if not _walks(asked) and asked.actions == (Action.CROSS,):
        return 1.4, RIDDEN  # nothing follows for which it would be too fast
    return (2.2, 3.2) if Action.TURN_BACK in asked.actions and not _walks(asked) else (1.4, 4)
