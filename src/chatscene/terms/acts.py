"""What road users do: the one table of acts. A new act is a row here, and its test on tracks in `program/deeds.py`."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from enum import StrEnum


@dataclass(frozen=True, slots=True, kw_only=True)
class Deed:
    """What holds of an act, whoever does it and whenever.

    Attributes:
        meaning: What is seen of somebody who does it.
        brings: Acts that come along without a word: whoever cuts in changes lanes.
        opposite: The act that nobody means who says this one; empty for none.
        turn: The side to which it turns: 1 for left, -1 for right.
        all_along: Whether it lasts: said before or after something else, it comes neither before nor after it.
        hasty: Whether it only says how a thing is done, which need not be said.
        directed: Whether it says which way somebody goes.
        named: Regular expression of what in a snippet's id says that it is done; empty for nothing.
    """

    meaning: str
    brings: tuple[str, ...] = ()
    opposite: str = ""
    turn: int = 0
    all_along: bool = False
    hasty: bool = False
    directed: bool = False
    named: str = ""


class Action(StrEnum):
    """One thing the adversary does; each has a test on the simulated tracks."""

    _value_: str
    row: Deed

    def __new__(cls, value: str, row: Deed) -> Action:
        """A member of a name, with its row."""
        action = str.__new__(cls, value)
        action._value_, action.row = value, row
        return action

    CROSS = (
        "cross",
        Deed(
            meaning="moves across the ego's path from one side",
            brings=("fast",),
            named="^cross",
            directed=True,
        ),
    )
    STOP = (
        "stop",
        Deed(
            meaning="was moving, then stands still",
            brings=("brake",),
        ),
    )
    BRAKE = (
        "brake",
        Deed(
            meaning="loses speed hard",
            opposite="accelerate",
        ),
    )
    ACCELERATE = (
        "accelerate",
        Deed(
            meaning="gains speed",
            opposite="brake",
            hasty=True,
        ),
    )
    SLOW = (
        "slow",
        Deed(
            meaning="drives or walks much slower than traffic",
            all_along=True,
        ),
    )
    REVERSE = (
        "reverse",
        Deed(
            meaning="moves backwards",
        ),
    )
    CUT_IN = (
        "cut-in",
        Deed(
            meaning="enters the ego's lane from beside",
            brings=("change-lane",),
        ),
    )
    CHANGE_LANE = (
        "change-lane",
        Deed(
            meaning="leaves its lane for a neighbouring one",
        ),
    )
    WEAVE = (
        "weave",
        Deed(
            meaning="swings from side to side",
        ),
    )
    SWERVE = (
        "swerve",
        Deed(
            meaning="leaves its line once, abruptly",
        ),
    )
    PACE = (
        "pace",
        Deed(
            meaning="keeps level with the ego",
        ),
    )
    RUN_LIGHT = (
        "run-light",
        Deed(
            meaning="enters a junction on red",
        ),
    )
    TURN_LEFT = (
        "turn-left",
        Deed(
            meaning="turns to its own left",
            brings=("cross",),
            opposite="turn-right",
            turn=1,
            named="turn-left",
            directed=True,
        ),
    )
    TURN_RIGHT = (
        "turn-right",
        Deed(
            meaning="turns to its own right",
            brings=("cross",),
            opposite="turn-left",
            turn=-1,
            named="turn-right|right-turn",
            directed=True,
        ),
    )
    ONCOMING = (
        "oncoming",
        Deed(
            meaning="approaches against the ego's direction",
            all_along=True,
            directed=True,
        ),
    )
    HESITATE = (
        "hesitate",
        Deed(
            meaning="starts, pauses, goes on",
            brings=("stop",),
        ),
    )
    DIAGONAL = (
        "diagonal",
        Deed(
            meaning="crosses at a slant",
            brings=("cross",),
            all_along=True,
        ),
    )
    TURN_BACK = (
        "turn-back",
        Deed(
            meaning="crosses, then goes back where it came from",
            brings=("stop",),
        ),
    )
    FOLLOW = (
        "follow",
        Deed(
            meaning="drives on along its lane",
            all_along=True,
        ),
    )
    OVERTAKE = (
        "overtake",
        Deed(
            meaning="passes the ego from behind",
            named="overtake",
        ),
    )
    TAILGATE = (
        "tailgate",
        Deed(
            meaning="drives close behind the ego",
        ),
    )
    PULL_OUT = (
        "pull-out",
        Deed(
            meaning="leaves a standing place beside the road for the ego's lane",
            brings=(
                "cross",
                "cut-in",
                "change-lane",
            ),
        ),
    )
    WRONG_WAY = (
        "wrong-way",
        Deed(
            meaning="drives against traffic in the ego's own lane",
            all_along=True,
            named="wrong-way",
            directed=True,
        ),
    )
    U_TURN = (
        "u-turn",
        Deed(
            meaning="turns round to where it came from",
            brings=(
                "cross",
                "turn-left",
                "turn-right",
                "oncoming",
            ),
            named="u-turn",
            directed=True,
        ),
    )
    BLOCK = (
        "block",
        Deed(
            meaning="stands still in the ego's way",
            all_along=True,
        ),
    )
    STAND = (
        "stand",
        Deed(
            meaning="stands still all the time",
            all_along=True,
        ),
    )
    NARROW = (
        "narrow",
        Deed(
            meaning="stands at an edge of the ego's lane and leaves a part of it free",
            all_along=True,
        ),
    )
    FAST = (
        "fast",
        Deed(
            meaning="drives or runs much faster than usual",
            all_along=True,
            hasty=True,
        ),
    )

    @property
    def opposite(self) -> Action | None:
        """The act that nobody means who says this one."""
        return Action(self.row.opposite) if self.row.opposite else None


BRINGS = {action: frozenset(map(Action, action.row.brings)) for action in Action}
TURNS = {action: action.row.turn for action in Action if action.row.turn}


def reordered(does: Iterable[Action], said: Iterable[Action]) -> bool:
    """Whether acts come in another order than they were said in; what lasts has no place in it, a pause is a stop."""
    one, other = (
        list(
            dict.fromkeys(
                Action.STOP if action is Action.HESITATE else action for action in acts if not action.row.all_along
            )
        )
        for acts in (does, said)
    )
    return [action for action in one if action in other] != [action for action in other if action in one]
