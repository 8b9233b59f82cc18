"""What adversaries do, in words that hang on something else they do or on where they do it."""

from __future__ import annotations

from chatscene.sentences.grammar.deeds import Table
from chatscene.situations.inflection import listed
from chatscene.terms.actors import Manner
from chatscene.terms.acts import Action

A = Action
W, R, D = Manner.WALKS, Manner.RIDES, Manner.DRIVES

_HESITATE_MIDWAY = listed(
    """[hesitate] in the middle of the road | [hesitate] halfway across | [pause] midway and then [go] on
    [dither] in the middle of the lane | [hesitate] in {egos} lane | [waver] halfway across
    [pause] in {egos} lane before going on"""
)
_FOLLOW_THROUGH = listed(
    """[drive] straight through the intersection | [keep] going straight through the intersection
    [drive] straight through in front of {ego} | [carry] straight on through the intersection
    [continue] straight through the intersection | [go] straight on across {egos} path"""
)
_WALK_DASH = listed(
    """[run] across the road {from} | [dash] across the street {from} | [run] out {from} in front of {ego}
    [sprint] across the road {from} | [dart] out {from} into the road | [rush] out {from} into the road
    [bolt] across the road {from} | [run] into the road {from} | [dart] across {egos} path {from}"""
)
_RIDE_DASH = listed(
    """[shoot] across the road {from} | [dart] out {from} in front of {ego} | [dash] across the road {from}
    [rush] out {from} into the road | [shoot] out {from} in front of {ego}
    [race] across {egos} path {from} and [speed] up"""
)
_FEINT = listed(
    """[pretend] to cross {from} but [brake] at the edge of the road
    [seem] to cross {from} but [stop] short at the kerb | [pretend] to cross {from} and [stop] hard at the kerb
    [pretend] to cross {from} but [stop] at the last moment"""
)

# Two actions that one phrase says, whatever their order
TOGETHER: dict[frozenset[Action], Table] = {
    frozenset((A.CROSS, A.ACCELERATE)): {W: _WALK_DASH, D: _RIDE_DASH},
    frozenset((A.CROSS, A.FAST)): {W: _WALK_DASH, D: _RIDE_DASH},
    frozenset((A.CROSS, A.SLOW)): {
        W: listed(
            """[cross] the road very slowly {from} | [shuffle] across the road {from}
            [amble] across the street {from} | [walk] slowly across the road {from}
            [creep] across the road {from} | [dawdle] across the street {from}"""
        ),
        R: listed(
            """[cross] the road very slowly {from} | [ride] slowly across the road {from}
            [creep] across the road {from} | [crawl] across {egos} path {from}
            [ride] across at walking pace {from} | [roll] slowly across the road {from}"""
        ),
        D: listed(
            """[crawl] across {egos} path {from} | [creep] across the road {from}
            [drive] slowly across {egos} path {from} | [roll] slowly across the road {from}
            [inch] across the road {from}"""
        ),
    },
    frozenset((A.CROSS, A.DIAGONAL)): {
        W: listed(
            """[cross] the road diagonally {from} | [walk] diagonally across the road {from}
            [cut] diagonally across the road {from} | [cross] the street at an angle {from}
            [walk] across the street at a slant {from} | [step] out {from} and [cross] diagonally"""
        ),
        D: listed(
            """[cross] the road diagonally {from} | [ride] diagonally across the road {from}
            [cut] diagonally across the road {from} | [cross] the street at an angle {from}
            [ride] out {from} and [cross] diagonally"""
        ),
    },
    frozenset((A.CROSS, A.WEAVE)): {
        W: listed(
            """[zigzag] across the road {from} | [stagger] across the road {from} | [weave] across the street {from}
            [stagger] from side to side across the road {from} | [cross] the road in a zigzag {from}
            [cross] {from} in a zigzag"""
        ),
        D: listed(
            """[zigzag] across the road {from} | [weave] across the road {from} | [cross] the road in a zigzag {from}"""
        ),
    },
    frozenset((A.CUT_IN, A.CHANGE_LANE)): {
        D: listed(
            """[change] lanes and [cut] in front of {ego} | [merge] into {egos} original lane
            [change] lanes and [cut] {ego} off | [pull] in front of {ego} with a sudden lane change
            [move] over into {egos} original lane and [cut] {ego} off | [cut] into {egos} original lane
            [change] lanes right in front of {ego} and [cut] {ego} off"""
        ),
    },
    frozenset((A.ACCELERATE, A.FAST)): {
        W: listed(
            """[start] to run at full tilt | [break] into a sprint | [begin] to run as fast as {it} can
            [start] running flat out | [rush] forward at full speed | [start] to sprint at top speed"""
        ),
        D: listed(
            """[accelerate] to a reckless speed | [speed] up far beyond the limit | [accelerate] to breakneck speed
            [surge] forward at high speed | [accelerate] hard and [race] along | [speed] up to a dangerous speed"""
        ),
    },
    frozenset((A.FOLLOW, A.FAST)): {
        W: listed(
            """[run] on along the road | [keep] running along the lane | [run] along the road at full speed
            [carry] on running | [sprint] on along the road | [run] along the lane at full tilt"""
        ),
        R: listed(
            """[ride] on much too fast | [race] on along {its} lane | [keep] going at breakneck speed | [speed] on
            [ride] on at high speed | [tear] on along the road"""
        ),
        D: listed(
            """[drive] on much too fast | [race] on along {its} lane | [keep] going at breakneck speed | [speed] on
            [drive] on at high speed | [drive] on well above the speed limit"""
        ),
    },
    frozenset((A.CROSS, A.TURN_LEFT)): {
        D: listed(
            """[turn] left right across {egos} path | [turn] left and [cross] right in front of {ego}
            [cross] {egos} path to turn left | [make] a left turn right across {egos} path
            [cross] in front of {ego} and [turn] left | [make] a sudden left turn across {egos} path"""
        ),
    },
    frozenset((A.CROSS, A.U_TURN)): {
        D: listed(
            """[make] a U-turn right across {egos} path | [do] a U-turn and [cross] {egos} path
            [swing] round in a U-turn right across {egos} path
            [make] a U-turn and [cross] right in front of {ego} | [pull] a U-turn across {egos} lane
            [cross] {egos} path in a U-turn"""
        ),
    },
    frozenset((A.SLOW, A.STOP)): {
        D: listed(
            """[slow] to a crawl and [stop] | [creep] to a stop | [roll] to a slow stop | [crawl] to a halt
            [slow] to walking pace and [come] to a halt | [go] slower and slower and [stop]"""
        ),
    },
    frozenset((A.STOP, A.BLOCK)): {
        D: listed(
            """[stop] and [block] {egos} lane | [come] to a halt and [block] the way
            [stop] dead, blocking {egos} path | [halt] in {egos} lane and [block] it
            [stop] in {egos} way and [stay] there, blocking the lane"""
        ),
    },
}
FEINT: Table = {
    W: (
        *(p for p in _FEINT if "[brake]" not in p),
        "[pretend] to cross {from} but [stop] abruptly at the edge of the road",
    ),
    D: _FEINT,
}
ATTEMPT: Table = {  # to turn back from, before a crossing
    D: listed(
        """[start] to cross and [turn] back | [set] out to cross and [turn] back | [begin] to cross but [turn] back
        [start] across but [turn] back again | [come] out a little way and [turn] back
        [start] to cross but [go] back again"""
    )
}
HALF_OUT: Table = {  # how somebody who stands at the kerb comes to stop in the way
    D: listed(
        """[nose] halfway out and [stop] | [roll] halfway into the lane and [stop]
        [edge] out and [stop] half in the lane | [roll] out a little way and [stop]
        [creep] halfway into {egos} lane and [stop] | [edge] out and [halt] abruptly"""
    )
}
THROUGH: dict[Action, Table] = {  # a junction
    A.FOLLOW: {R: tuple(p.replace("drive", "ride") for p in _FOLLOW_THROUGH), D: _FOLLOW_THROUGH}
}
_GO_ON: Table = {
    W: listed("[walk] on | [carry] on walking | [go] on | [continue] on {its} way"),
    D: listed(
        """[drive] on | [carry] on | [continue] on {its} way | [keep] going | [go] on | [carry] on along {its} lane"""
    ),
    R: listed(
        """[ride] on | [carry] on | [continue] on {its} way | [keep] going | [go] on | [carry] on along {its} lane"""
    ),
}
# The second action, after the first was done
AFTER: dict[tuple[Action, Action], Table] = {
    **{(action, A.FOLLOW): _GO_ON for action in Action},
    (A.SLOW, A.FOLLOW): {
        D: listed(
            """[keep] rolling | [keep] going without stopping | [roll] on | [go] on without stopping | [keep] moving
            [carry] on without stopping"""
        )
    },
    (A.CROSS, A.HESITATE): {D: _HESITATE_MIDWAY},
    (A.CUT_IN, A.TURN_BACK): {
        D: listed(
            """[swing] back again | [go] back where {it} came from | [turn] back at once into {its} own lane
            [move] straight back | [go] back into {its} own lane | [turn] back again into {its} own lane"""
        )
    },
    (A.STOP, A.HESITATE): {
        D: listed(
            """[wait] for a moment | [hesitate] | [hesitate] for a moment | [pause] briefly | [wait] a moment
            [pause] for a moment"""
        )
    },
}
