"""What adversaries do, in words: phrases per action and class of road user.

Verbs are marked for `inflection`; ``{from}`` is where somebody comes from and may be empty.
"""

from __future__ import annotations

from enum import StrEnum

from chatscene.agent.grammar.inflection import listed
from chatscene.terms.scenario import Action, AdversaryKind

A = Action


class Manner(StrEnum):
    """How a road user moves, as far as verbs are concerned."""

    WALKS = "walks"
    RIDES = "rides"
    DRIVES = "drives"


Table = dict[Manner, tuple[str, ...]]  # phrases per manner; one that is missing speaks like a driver
MANNERS: dict[AdversaryKind, Manner] = {
    AdversaryKind.PEDESTRIAN: Manner.WALKS,
    AdversaryKind.BICYCLE: Manner.RIDES,
    AdversaryKind.MOTORCYCLE: Manner.RIDES,
}


_WALK_CROSS = listed(
    """[cross] the road {from} | [step] out into the road {from} | [walk] across the street {from}
    [walk] out {from} in front of {ego} | [step] onto the road {from} | [cross] in front of {ego} {from}
    [walk] across the road {from} | [jaywalk] across the road {from} | [emerge] {from} and [cross] the road
    [wander] across the street {from} | [come] out {from} and [cross] {egos} path"""
)
_RIDE_CROSS = listed(
    """[cross] the road {from} | [ride] across the road {from} | [ride] out {from} in front of {ego}
    [roll] out into the road {from} | [cross] {egos} path {from} | [ride] across {egos} path {from}
    [come] out {from} and [cross] the road | [emerge] {from} and [ride] across the road"""
)
_DRIVE_CROSS = listed(
    """[drive] across {egos} path {from} | [cross] {egos} path {from} | [drive] across the road {from}
    [cross] in front of {ego} {from} | [roll] across the road {from} | [come] out {from} and [cross] {egos} path"""
)
_STOP = listed(
    """[stop] dead | [come] to a sudden stop | [come] to a halt | [stop] in front of {ego} | [halt] abruptly
    [stop] in {egos} path | [come] to a standstill"""
)
_WALK_STOP = listed(
    """[stop] right in front of {ego} | [freeze] in {egos} path | [stop] dead in the middle of the road
    [halt] in front of {ego} | [come] to a halt in {egos} lane | [stop] in the middle of the lane
    [freeze] in the middle of the road | [stop] short"""
)
_BRAKE = listed(
    """[brake] hard | [slam] on the brakes | [brake] sharply | [brake] abruptly | [hit] the brakes hard
    [jam] on the brakes | [decelerate] hard | [brake] without warning"""
)
_ACCELERATE = listed(
    """[accelerate] hard | [speed] up | [accelerate] sharply | [step] on the gas | [accelerate] | [surge] forward
    [pick] up speed | [open] the throttle | [floor] it"""
)
_SPURT = listed(
    """[accelerate] hard | [speed] up | [accelerate] | [pick] up speed | [surge] forward | [accelerate] sharply"""
)
_SLOW = listed(
    """[crawl] along | [drive] extremely slowly | [creep] along at walking pace | [dawdle] along
    [drive] at a snail's pace | [drive] much too slowly | [inch] along"""
)
_REVERSE = listed(
    """[reverse] towards {ego} | [back] up | [reverse] | [back] up towards {ego} | [roll] backwards
    [start] to reverse | [drive] backwards towards {ego}"""
)
_CUT_IN = listed(
    """[cut] in front of {ego} | [cut] in right before {ego} | [cut] {ego} off | [pull] in directly in front of {ego}
    [squeeze] into {egos} lane | [merge] into {egos} lane | [swing] in front of {ego} | [barge] into {egos} lane"""
)
_CHANGE = listed(
    """[change] lanes | [switch] lanes without signalling | [change] lanes without looking
    [make] a sudden lane change | [switch] lanes | [change] lanes without indicating"""
)
_WEAVE = listed(
    """[weave] from side to side | [zigzag] along | [weave] between lanes | [swing] from side to side
    [weave] about erratically | [snake] along the road | [slalom] along"""
)
_SWERVE = listed(
    """[swerve] towards {ego} | [veer] towards {ego} | [swerve] abruptly | [veer] sharply to one side
    [swerve] into {egos} lane | [lurch] towards {ego} | [veer] off {its} line"""
)
_PACE = listed(
    """[keep] level with {ego} | [keep] pace with {ego} | [drive] parallel to {ego} | [drive] alongside {ego}
    [keep] pace beside {ego} | [stay] level with {ego} and [leave] no gap
    [keep] pace and [refuse] to let {ego} in"""
)
_RUN_LIGHT = listed(
    """[run] the red light | [run] a red light | [ignore] the red light | [jump] the red light
    [drive] through the red light | [disregard] the red light | [shoot] through the red light | [run] the red"""
)
_TURN = listed(
    """[turn] {way} | [make] a {way} turn | [turn] {way} without yielding | [take] a {way} turn
    [turn] {way} without signalling | [turn] to the {way} | [make] a sudden {way} turn"""
)
_ONCOMING = listed(
    """[come] straight at {ego} | [keep] coming towards {ego} | [approach] {ego} head-on | [drive] towards {ego}
    [come] towards {ego} from the opposite direction | [head] straight at {ego}"""
)
_HESITATE = listed(
    """[hesitate] | [hesitate] and then [go] on | [pause] before going on | [waver] | [dither]
    [hesitate] for a moment | [pause] briefly"""
)
_FOLLOW = listed(
    """[drive] on along {its} lane | [keep] going at a steady speed | [carry] on at the same speed
    [continue] at a constant speed | [drive] on without slowing | [keep] going along {its} lane"""
)
_OVERTAKE = listed(
    """[overtake] {ego} | [pass] {ego} from behind | [pull] out and [overtake] {ego} | [shoot] past {ego}
    [go] past {ego} | [overtake] {ego} at the last moment | [drive] past {ego}"""
)
_TAILGATE = listed(
    """[tailgate] {ego} | [drive] bumper to bumper behind {ego} | [follow] {ego} much too closely
    [hang] on {egos} rear bumper | [sit] right on {egos} tail | [follow] {ego} at an unsafe distance
    [close] right up to {egos} rear bumper"""
)
_PULL_OUT = listed(
    """[pull] out {from} in front of {ego} | [pull] out {from} into {egos} lane | [pull] away {from} in front of {ego}
    [pull] out {from} without looking | [move] off {from} into {egos} path | [pull] out {from} without signalling
    [set] off {from} and [enter] {egos} lane"""
)
_WRONG_WAY = listed(
    """[drive] the wrong way in {egos} lane | [drive] towards {ego} on the wrong side of the road
    [drive] against the traffic in {egos} lane | [come] at {ego} against the traffic
    [head] the wrong way down {egos} lane | [travel] the wrong way towards {ego}"""
)
_U_TURN = listed(
    """[make] a U-turn | [do] a U-turn in front of {ego} | [make] a U-turn across {egos} path
    [swing] round in a U-turn | [pull] a U-turn | [attempt] a U-turn | [perform] a U-turn in the road"""
)
_BLOCK = listed(
    """[block] {egos} lane | [stand] still in {egos} way | [obstruct] {egos} lane | [stand] motionless in {egos} lane
    [block] the way | [stand] in {egos} path without moving | [block] {egos} path"""
)
_FAST = listed(
    """[race] along | [drive] much too fast | [go] far too fast | [speed] along | [drive] at breakneck speed
    [come] along at high speed | [tear] along"""
)
_TURN_BACK = listed(
    """[turn] back | [turn] around and [go] back | [turn] round and [run] back | [run] back to the kerb
    [retreat] to the kerb | [jump] back again | [turn] back the way {it} came"""
)
_DIAGONAL = listed(
    """[move] on diagonally | [walk] on at an angle | [go] on at a slant | [walk] off diagonally
    [head] off diagonally across the road | [continue] diagonally"""
)
_BOLT = listed("[break] into a run | [start] to run | [start] sprinting | [speed] up | [begin] to run | [rush] forward")

W, R, D = Manner.WALKS, Manner.RIDES, Manner.DRIVES

# One action
DEEDS: dict[Action, Table] = {
    A.CROSS: {W: _WALK_CROSS, R: _RIDE_CROSS, D: _DRIVE_CROSS},
    A.STOP: {W: _WALK_STOP, D: _STOP},
    A.BRAKE: {W: listed("[stop] abruptly | [pull] up short | [brake] in mid-stride | [slow] down sharply"), D: _BRAKE},
    A.ACCELERATE: {W: _BOLT, R: _SPURT, D: _ACCELERATE},
    A.SLOW: {
        W: listed("[walk] very slowly | [shuffle] along | [amble] along | [dawdle] | [stroll] along | [creep] along"),
        R: listed(
            """[ride] very slowly | [ride] at walking pace | [crawl] along | [dawdle] along | [ride] extremely slowly
            [creep] along | [ride] at a snail's pace"""
        ),
        D: _SLOW,
    },
    A.REVERSE: {
        W: listed("[walk] backwards | [step] backwards | [go] backwards towards {ego} | [move] backwards"),
        R: listed("[roll] backwards | [back] up | [push] backwards towards {ego} | [roll] back towards {ego}"),
        D: _REVERSE,
    },
    A.CUT_IN: {D: _CUT_IN},
    A.CHANGE_LANE: {D: _CHANGE},
    A.WEAVE: {
        W: listed(
            """[stagger] from side to side | [weave] about | [zigzag] along | [stagger] about
            [lurch] from side to side"""
        ),
        D: _WEAVE,
    },
    A.SWERVE: {
        W: listed("[veer] towards {ego} | [lurch] towards {ego} | [swerve] into {egos} path | [veer] into the lane"),
        D: _SWERVE,
    },
    A.PACE: {
        W: listed("[keep] pace with {ego} | [walk] alongside {ego} | [keep] level with {ego} | [run] alongside {ego}"),
        R: listed(
            """[keep] level with {ego} | [keep] pace with {ego} | [ride] parallel to {ego} | [ride] alongside {ego}
            [stay] level with {ego} and [leave] no gap | [ride] along level with {ego}"""
        ),
        D: _PACE,
    },
    A.RUN_LIGHT: {
        R: (*(p for p in _RUN_LIGHT if "drive" not in p), "[ride] through the red light"),
        W: listed(
            """[cross] on red {from} | [ignore] the red light | [disregard] the red light
            [walk] through the red light"""
        ),
        D: _RUN_LIGHT,
    },
    A.TURN_LEFT: {D: tuple(p.replace("{way}", "left") for p in _TURN)},
    A.TURN_RIGHT: {D: tuple(p.replace("{way}", "right") for p in _TURN)},
    A.ONCOMING: {
        W: listed(
            """[come] towards {ego} | [keep] walking towards {ego} | [walk] straight towards {ego}
            [head] towards {ego} | [run] towards {ego} | [approach] {ego} head-on"""
        ),
        R: (*(p for p in _ONCOMING if "drive" not in p), "[ride] towards {ego}", "[ride] straight at {ego}"),
        D: _ONCOMING,
    },
    A.HESITATE: {D: _HESITATE},
    A.DIAGONAL: {W: _DIAGONAL, D: tuple(p.replace("walk", "move") for p in _DIAGONAL)},
    A.TURN_BACK: {W: _TURN_BACK, D: tuple(p.replace("run", "go") for p in _TURN_BACK if "jump" not in p)},
    A.FOLLOW: {
        W: listed("[walk] on | [keep] walking | [carry] on walking | [walk] on along the road"),
        R: listed(
            """[ride] on along {its} lane | [keep] going at a steady speed | [carry] on at the same speed
            [continue] at a constant speed | [ride] on without slowing | [keep] riding along"""
        ),
        D: _FOLLOW,
    },
    A.OVERTAKE: {D: _OVERTAKE},
    A.TAILGATE: {
        R: (*(p for p in _TAILGATE if "drive" not in p), "[ride] right behind {egos} rear bumper"),
        D: _TAILGATE,
    },
    A.PULL_OUT: {D: _PULL_OUT},
    A.WRONG_WAY: {
        R: (*(p.replace("drive", "ride") for p in _WRONG_WAY),),
        W: listed(
            """[walk] against the traffic in {egos} lane | [walk] the wrong way in {egos} lane
            [come] at {ego} against the traffic"""
        ),
        D: _WRONG_WAY,
    },
    A.U_TURN: {D: _U_TURN},
    A.BLOCK: {D: _BLOCK},
    A.FAST: {
        W: listed(
            """[run] flat out | [sprint] along | [run] at full tilt | [tear] along | [race] along
            [run] at top speed"""
        ),
        R: (*(p.replace("drive", "ride") for p in _FAST),),
        D: _FAST,
    },
}

AT_SPEED: Table = {
    W: listed("at a run | at full speed | at a sprint | at full tilt | running flat out | at top speed"),
    D: listed(
        """at high speed | much too fast | far too fast | at full speed | well above the speed limit
        at a reckless speed | at breakneck speed"""
    ),
}
SUDDENLY = listed("suddenly | suddenly | suddenly | abruptly | unexpectedly | all of a sudden")
SUDDEN = frozenset(
    (A.CROSS, A.STOP, A.BRAKE, A.ACCELERATE, A.CUT_IN, A.CHANGE_LANE, A.SWERVE, A.REVERSE, A.TURN_LEFT, A.TURN_RIGHT,
     A.TURN_BACK, A.PULL_OUT, A.U_TURN)
)  # fmt: skip


def phrases(table: Table, manner: Manner) -> tuple[str, ...]:
    """What a table has for a class of road user."""
    return table.get(manner) or table[Manner.DRIVES]
