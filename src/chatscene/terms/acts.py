"""What road users do: the one table of acts. A new act is a row here, and its test on tracks in `program/deeds.py`.

Words and phrases are our own, collected from crash reports, driving schools and the way people talk.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from enum import StrEnum


@dataclass(frozen=True, slots=True, kw_only=True)
class Deed:
    """What holds of an act, whoever does it and whenever.

    Attributes:
        meaning: What is seen of somebody who does it.
        words: Regular expression of the words that name it, in lower case; empty for what is only read where every
            word of a text is.
        drives: Phrases for somebody who drives, parted by `|` or lines. Verbs are marked for
            `chatscene.situations.inflection`; ``{from}`` is where somebody comes from and may be empty.
        rides: The same for somebody on two wheels; empty for who speaks like a driver.
        walks: The same for somebody on foot; empty for who speaks like a driver.
        brings: Acts that come along without a word: whoever cuts in changes lanes.
        opposite: The act that nobody means who says this one; empty for none.
        turn: The side to which it turns: 1 for left, -1 for right.
        all_along: Whether it lasts: said before or after something else, it comes neither before nor after it.
        stands: Whether who does it, and nothing else, stands.
        sudden: Whether it may be called sudden.
        hasty: Whether it only says how a thing is done, which need not be said.
        directed: Whether it says which way somebody goes.
        named: Regular expression of what in a snippet's id says that it is done; empty for nothing.
    """

    meaning: str
    drives: str
    words: str = ""
    rides: str = ""
    walks: str = ""
    brings: tuple[str, ...] = ()
    opposite: str = ""
    turn: int = 0
    all_along: bool = False
    stands: bool = False
    sudden: bool = False
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
            words=(
                r"cross(?:es|ed|ing)?|jaywalk\w*|(?:step|walk|run|ran|dash|dart|sprint|rush|bolt|jump|leap|hop|"
                r"wander|stroll|shuffl|stumbl|rid|pedal|roll|cycl|charg|burst|shoot)\w* (?:out|across|into|onto|in|"
                r"off|over|from)|cut(?:s|ting)? across|emerg\w*|appear\w*|pop\w* (?:out|up)|com(?:es|ing) out|"
                "enters? the (?:road|street|lane)|across (?:the|our) (?:road|street|path|way|lane)"
            ),
            walks="""
                [cross] the road {from} | [step] out into the road {from} | [walk] across the street {from}
                [walk] out {from} in front of {ego} | [step] onto the road {from} | [cross] in front of {ego} {from}
                [walk] across the road {from} | [jaywalk] across the road {from} | [emerge] {from} and [cross] the road
                [wander] across the street {from} | [come] out {from} and [cross] {egos} path
            """,
            rides="""
                [cross] the road {from} | [ride] across the road {from} | [ride] out {from} in front of {ego}
                [roll] out into the road {from} | [cross] {egos} path {from} | [ride] across {egos} path {from}
                [come] out {from} and [cross] the road | [emerge] {from} and [ride] across the road
            """,
            drives="""
                [drive] across {egos} path {from} | [cross] {egos} path {from} | [drive] across the road {from}
                [cross] in front of {ego} {from} | [roll] across the road {from}
                [come] out {from} and [cross] {egos} path
            """,
            brings=("fast",),
            sudden=True,
            directed=True,
            named="^cross",
        ),
    )
    STOP = (
        "stop",
        Deed(
            meaning="was moving, then stands still",
            words=(
                r"stop(?:s|ped|ping)?|halt\w*|fr(?:eez|oze)\w*|stands? still|standstill|dismount\w*|stall\w*|"
                "stays? put|blocks? (?:the|our|its) path|blocking (?:the|our|its) path|motionless"
            ),
            walks="""
                [stop] right in front of {ego} | [freeze] in {egos} path | [stop] dead in the middle of the road
                [halt] in front of {ego} | [come] to a halt in {egos} lane | [stop] in the middle of the lane
                [freeze] in the middle of the road | [stop] short
            """,
            drives="""
                [stop] dead | [come] to a sudden stop | [come] to a halt | [stop] in front of {ego} | [halt] abruptly
                [stop] in {egos} path | [come] to a standstill
            """,
            brings=("brake",),
            sudden=True,
        ),
    )
    BRAKE = (
        "brake",
        Deed(
            meaning="loses speed hard",
            words=(
                r"brak(?:es?|ing|ed)|slam\w* (?:on )?(?:the |its |his |her )?brakes?|brake(?:-| )check\w*|"
                r"decelerat\w*|emergency stop|stops? (?:short|hard)|brakes? hard|pretends? to"
            ),
            walks="[stop] abruptly | [pull] up short | [brake] in mid-stride | [slow] down sharply",
            drives="""
                [brake] hard | [slam] on the brakes | [brake] sharply | [brake] abruptly | [hit] the brakes hard
                [jam] on the brakes | [decelerate] hard | [brake] without warning
            """,
            opposite="accelerate",
            sudden=True,
        ),
    )
    ACCELERATE = (
        "accelerate",
        Deed(
            meaning="gains speed",
            words=(
                r"accelerat\w*|speed(?:s|ing)? up|speeds|throttle|guns (?:it|the engine)|floor(?:s|ed|ing) it|"
                r"pick\w* up speed|step\w* on (?:the )?(?:gas|it)|(?:start|begin|began)\w* (?:to run|running)|"
                r"put\w* (?:his|her|its|their|the) foot down|shoots forward|surg\w*|sprint\w*|dash\w*|dart\w*|"
                r"rush\w*|bolt\w*|hurr\w*|picks up speed|steps on the gas"
            ),
            walks="""
                [break] into a run | [start] to run | [start] sprinting | [speed] up | [begin] to run | [rush] forward
            """,
            rides="""
                [accelerate] hard | [speed] up | [accelerate] | [pick] up speed | [surge] forward | [accelerate] sharply
            """,
            drives="""
                [accelerate] hard | [speed] up | [accelerate] sharply | [step] on the gas | [accelerate]
                [surge] forward | [pick] up speed | [open] the throttle | [floor] it
            """,
            opposite="brake",
            sudden=True,
            hasty=True,
        ),
    )
    SLOW = (
        "slow",
        Deed(
            meaning="drives or walks much slower than traffic",
            words=(
                r"slow(?:s|ing|ly)?(?: down)?|crawl\w*|creep\w*|inch(?:es|ing)|dawdl\w*|snail\w*|limp\w*|shuffl\w*|"
                r"ambl\w*|stroll\w*|at (?:a )?(?:walking|snail's) (?:pace|speed)|extremely slow\w*|wander\w*"
            ),
            walks="[walk] very slowly | [shuffle] along | [amble] along | [dawdle] | [stroll] along | [creep] along",
            rides="""
                [ride] very slowly | [ride] at walking pace | [crawl] along | [dawdle] along | [ride] extremely slowly
                [creep] along | [ride] at a snail's pace
            """,
            drives="""
                [crawl] along | [drive] extremely slowly | [creep] along at walking pace | [dawdle] along
                [drive] at a snail's pace | [drive] much too slowly | [inch] along
            """,
            all_along=True,
        ),
    )
    REVERSE = (
        "reverse",
        Deed(
            meaning="moves backwards",
            words=r"revers\w*|back(?:s|ing)? (?:up|out)|backwards?|rolls? back",
            walks="[walk] backwards | [step] backwards | [go] backwards towards {ego} | [move] backwards",
            rides="[roll] backwards | [back] up | [push] backwards towards {ego} | [roll] back towards {ego}",
            drives="""
                [reverse] towards {ego} | [back] up | [reverse] | [back] up towards {ego} | [roll] backwards
                [start] to reverse | [drive] backwards towards {ego}
            """,
            sudden=True,
        ),
    )
    CUT_IN = (
        "cut-in",
        Deed(
            meaning="enters the ego's lane from beside",
            words=(
                r"cut(?:s|ting)? (?:\w+ ){1,4}off|barg\w* in(?:to)?|mov\w* over (?:in(?:to)?|on|to)|pull\w* (?:in|"
                r"over|across) (?:right |directly |just )*(?:in front|ahead|into)|forc\w* (?:its|his|her|"
                r"their) way in|cut(?:s|ting)?(?: us| the ego(?: vehicle)?| me)? (?:in|off|up|across)|merg\w*|"
                r"squeez\w*(?: in)?|(?:pull|swing|dart|drift|mov)(?:s|es|ing)? (?:in |out )?(?:right |directly |"
                r"suddenly )?(?:in front|before|ahead)|barg\w* in|(?:in|on)to (?:our|the ego's?|"
                "my) (?:original )?lane|turns? into (?:our|the ego's?|my|the ego vehicle's) (?:path|lane|way)"
            ),
            drives="""
                [cut] in front of {ego} | [cut] in right before {ego} | [cut] {ego} off
                [pull] in directly in front of {ego} | [squeeze] into {egos} lane | [merge] into {egos} lane
                [swing] in front of {ego} | [barge] into {egos} lane
            """,
            brings=("change-lane",),
            sudden=True,
        ),
    )
    CHANGE_LANE = (
        "change-lane",
        Deed(
            meaning="leaves its lane for a neighbouring one",
            words=r"original lane|chang\w* lanes?|lane change",
            drives="""
                [change] lanes | [switch] lanes without signalling | [change] lanes without looking
                [make] a sudden lane change | [switch] lanes | [change] lanes without indicating
            """,
            sudden=True,
        ),
    )
    WEAVE = (
        "weave",
        Deed(
            meaning="swings from side to side",
            words=(r"weav\w*|zig-?zag\w*|erratic(?:ally)?|snak\w*|side to side|stagger\w*|slalom\w*|between lanes"),
            walks="""
                [stagger] from side to side | [weave] about | [zigzag] along | [stagger] about
                [lurch] from side to side
            """,
            drives="""
                [weave] from side to side | [zigzag] along | [weave] between lanes | [swing] from side to side
                [weave] about erratically | [snake] along the road | [slalom] along
            """,
        ),
    )
    SWERVE = (
        "swerve",
        Deed(
            meaning="leaves its line once, abruptly",
            words=r"swerv\w*|veer\w*|drifts?|lurch\w*|jink\w*",
            walks="[veer] towards {ego} | [lurch] towards {ego} | [swerve] into {egos} path | [veer] into the lane",
            drives="""
                [swerve] towards {ego} | [veer] towards {ego} | [swerve] abruptly | [veer] sharply to one side
                [swerve] into {egos} lane | [lurch] towards {ego} | [veer] off {its} line
            """,
            sudden=True,
        ),
    )
    PACE = (
        "pace",
        Deed(
            meaning="keeps level with the ego",
            words=(
                r"parallel|alongside|(?:keep\w*|kept) (?:pace|level|up with)|match\w* (?:our|the ego's|my) (?:speed|"
                r"pace)|keep\w* pace|side by side|matches our speed|level with|stays beside|keeps? level"
            ),
            walks="[keep] pace with {ego} | [walk] alongside {ego} | [keep] level with {ego} | [run] alongside {ego}",
            rides="""
                [keep] level with {ego} | [keep] pace with {ego} | [ride] parallel to {ego} | [ride] alongside {ego}
                [stay] level with {ego} and [leave] no gap | [ride] along level with {ego}
            """,
            drives="""
                [keep] level with {ego} | [keep] pace with {ego} | [drive] parallel to {ego} | [drive] alongside {ego}
                [keep] pace beside {ego} | [stay] level with {ego} and [leave] no gap
                [keep] pace and [refuse] to let {ego} in
            """,
        ),
    )
    RUN_LIGHT = (
        "run-light",
        Deed(
            meaning="enters a junction on red",
            words=(
                r"r[ua]n(?:s|ning)? (?:through )?(?:a|the|its|his|her|their) (?:red|stop ?light|light|signal)\w*|"
                "red(?:-| )light (?:runner|running)|(?:jump|ignor|blow|shoot|skip|disregard|violat|disobey|barrel|"
                r"sail)\w* (?:past |through )?(?:a|the|its|their) (?:red|light|traffic light|signal)s?|through (?:a|"
                "the) red|on red"
            ),
            walks="""
                [cross] on red {from} | [ignore] the red light | [disregard] the red light
                [walk] through the red light
            """,
            rides="""
                [run] the red light | [run] a red light | [ignore] the red light | [jump] the red light
                [disregard] the red light | [shoot] through the red light | [run] the red | [ride] through the red light
            """,
            drives="""
                [run] the red light | [run] a red light | [ignore] the red light | [jump] the red light
                [drive] through the red light | [disregard] the red light | [shoot] through the red light
                [run] the red
            """,
        ),
    )
    TURN_LEFT = (
        "turn-left",
        Deed(
            meaning="turns to its own left",
            words=(
                r"turn\w* (?:off )?(?:to )?(?:the )?left|(?:go|goes|going|went|head|heads|heading|bear\w*|"
                r"want\w* (?:to )?go) (?:to )?(?:the )?left(?! (?:lane|side|right))|(?:the )?ego left(?= (?:off|"
                r"onto|into|at|from|out))|(?:mak|tak|hang)\w* an? (?:sharp )?left|"
                r"(?:unprotected )?left(?:-hand)?(?: |-)turn\w*|unprotected left"
            ),
            drives="""
                [turn] left | [make] a left turn | [turn] left without yielding | [take] a left turn
                [turn] left without signalling | [turn] to the left | [make] a sudden left turn
            """,
            brings=("cross",),
            opposite="turn-right",
            sudden=True,
            turn=1,
            directed=True,
            named="turn-left",
        ),
    )
    TURN_RIGHT = (
        "turn-right",
        Deed(
            meaning="turns to its own right",
            words=(
                r"turn\w* (?:off )?(?:to )?(?:the )?right(?! (?:in front|behind|ahead|before|across|away|after))|"
                r"(?:go|goes|going|went|head|heads|heading|bear\w*|"
                r"want\w* (?:to )?go) (?:to )?(?:the )?right(?! (?:lane|side|left|in|behind|up|through|on|past|"
                "across|away|ahead))|(?:the )?ego right(?= (?:off|onto|into|at|from|out))|(?:mak|tak|"
                r"hang)\w* an? (?:sharp )?right|right(?:-hand)?(?: |-)turn\w*"
            ),
            drives="""
                [turn] right | [make] a right turn | [turn] right without yielding | [take] a right turn
                [turn] right without signalling | [turn] to the right | [make] a sudden right turn
            """,
            brings=("cross",),
            opposite="turn-left",
            sudden=True,
            turn=-1,
            directed=True,
            named="turn-right|right-turn",
        ),
    )
    ONCOMING = (
        "oncoming",
        Deed(
            meaning="approaches against the ego's direction",
            words="oncoming|opposite direction|head(?:-| )on|opposing",
            walks="""
                [come] towards {ego} | [keep] walking towards {ego} | [walk] straight towards {ego}
                [head] towards {ego} | [run] towards {ego} | [approach] {ego} head-on
            """,
            rides="""
                [come] straight at {ego} | [keep] coming towards {ego} | [approach] {ego} head-on
                [come] towards {ego} from the opposite direction | [head] straight at {ego} | [ride] towards {ego}
                [ride] straight at {ego}
            """,
            drives="""
                [come] straight at {ego} | [keep] coming towards {ego} | [approach] {ego} head-on
                [drive] towards {ego} | [come] towards {ego} from the opposite direction | [head] straight at {ego}
            """,
            all_along=True,
            directed=True,
        ),
    )
    HESITATE = (
        "hesitate",
        Deed(
            meaning="starts, pauses, goes on",
            words=(
                r"hesitat\w*|dither\w*|paus(?:es?|ed|ing)|stop(?:-| )and(?:-| )go|fits and starts|again and again|"
                r"waver\w*|undecided|(?:waits|waited|waiting) (?:for )?a moment"
            ),
            drives="""
                [hesitate] | [hesitate] and then [go] on | [pause] before going on | [waver] | [dither]
                [hesitate] for a moment | [pause] briefly
            """,
            brings=("stop",),
        ),
    )
    DIAGONAL = (
        "diagonal",
        Deed(
            meaning="crosses at a slant",
            words=r"diagonal(?:ly)?|at an angle|slant\w*|obliquely",
            walks="""
                [move] on diagonally | [walk] on at an angle | [go] on at a slant | [walk] off diagonally
                [head] off diagonally across the road | [continue] diagonally
            """,
            drives="""
                [move] on diagonally | [move] on at an angle | [go] on at a slant | [move] off diagonally
                [head] off diagonally across the road | [continue] diagonally
            """,
            brings=("cross",),
            all_along=True,
        ),
    )
    TURN_BACK = (
        "turn-back",
        Deed(
            meaning="crosses, then goes back where it came from",
            words=(
                r"(?:turn|go|run|walk|jump|step|dart)(?:s|es|ing)? back|turns? around|chang\w* (?:his|her|its|"
                "their) mind|retreats?"
            ),
            walks="""
                [turn] back | [turn] around and [go] back | [turn] round and [run] back | [run] back to the kerb
                [retreat] to the kerb | [jump] back again | [turn] back the way {it} came
            """,
            drives="""
                [turn] back | [turn] around and [go] back | [turn] round and [go] back | [go] back to the kerb
                [retreat] to the kerb | [turn] back the way {it} came
            """,
            brings=("stop",),
            sudden=True,
        ),
    )
    FOLLOW = (
        "follow",
        Deed(
            meaning="drives on along its lane",
            words=(
                r"(?:driv|rid|keep|go|carr|travel)\w* (?:on|along|going|straight on)|continu\w*|tailgat\w*|"
                "follow(?:s|ing) (?:us|the ego|its lane)|"
                "(?:driv|drove|crash|run|ran|slam|plough|plow|bump|smash)[a-z]* "
                r"(?:straight |right |hard )?into (?:us|the ego|our (?:car|rear|back|tail|boot))|rear-?end\w*|"
                "(?:hits?|strikes?|struck|collides? with|bumps?) (?:us|the ego|our (?:car|rear|back)) from behind"
            ),
            walks="[walk] on | [keep] walking | [carry] on walking | [walk] on along the road",
            rides="""
                [ride] on along {its} lane | [keep] going at a steady speed | [carry] on at the same speed
                [continue] at a constant speed | [ride] on without slowing | [keep] riding along
            """,
            drives="""
                [drive] on along {its} lane | [keep] going at a steady speed | [carry] on at the same speed
                [continue] at a constant speed | [drive] on without slowing | [keep] going along {its} lane
            """,
            all_along=True,
        ),
    )
    OVERTAKE = (
        "overtake",
        Deed(
            meaning="passes the ego from behind",
            words=(
                r"overt[ao]+k\w*|(?:shot|flew|raced|sped|stormed|tore|roared|blew|goes|went|gets|got|comes|came|"
                "swept|sweeps|rushes|rushed) (?:right |straight )?past|pass(?:es|ing)? (?:us|the ego(?: vehicle)?|"
                "me|the vut|the av)|(?:shoot|fly|flies|race|speed|storm|thunder|roar|blast|zoom|tear)s? past|"
                r"goes past|gets past|undertak\w*"
            ),
            drives="""
                [overtake] {ego} | [pass] {ego} from behind | [pull] out and [overtake] {ego} | [shoot] past {ego}
                [go] past {ego} | [overtake] {ego} at the last moment | [drive] past {ego}
            """,
            named="overtake",
        ),
    )
    TAILGATE = (
        "tailgate",
        Deed(
            meaning="drives close behind the ego",
            words=(
                "(?:at|keeping) an? (?:un)?(?:safe|close) (?:following )?distance behind|"
                r"unsafe (?:following )?distance|clos\w* (?:right )?up (?:to|on|behind) (?:our|the ego's|my)|"
                r"on (?:our|the ego's|my) tail|(?:our|the ego's|my) rear bumper|follow\w* (?:us|the ego|"
                r"me) (?:\w+ ){0,2}too close\w*|tailgat\w*|bumper to bumper|(?:on|to) (?:our|the ego's?|"
                r"my) (?:rear )?(?:bumper|tail)|follow\w* (?:far |much )?too close\w*|(?:sits|hangs|sticks|glued|"
                r"driv\w*|follow\w*|keeps|stays) (?:very |right |dangerously |too )?(?:close|"
                r"on our tail)(?:ly)? (?:behind|to our|on|to the rear)|breath\w* down (?:our|my) neck"
            ),
            rides="""
                [tailgate] {ego} | [follow] {ego} much too closely | [hang] on {egos} rear bumper
                [sit] right on {egos} tail | [follow] {ego} at an unsafe distance
                [close] right up to {egos} rear bumper | [ride] right behind {egos} rear bumper
            """,
            drives="""
                [tailgate] {ego} | [drive] bumper to bumper behind {ego} | [follow] {ego} much too closely
                [hang] on {egos} rear bumper | [sit] right on {egos} tail | [follow] {ego} at an unsafe distance
                [close] right up to {egos} rear bumper
            """,
        ),
    )
    PULL_OUT = (
        "pull-out",
        Deed(
            meaning="leaves a standing place beside the road for the ego's lane",
            words=(
                "(?:pull|mov|driv|set|swing|edg|nos|com|roll|start|lurch|creep|shoot|launch|manoeuvr|"
                r"maneuver)\w* (?:out|off|away|forward)(?: of| from)? (?:of )?(?:the |a |its |his |her )?(?:kerb|"
                "curb|kerbside|parking|parked|roadside|bay|bus bay|lay-?by|shoulder|row|bus stop|stop|edge|verge|"
                r"side(?! (?:road|street)))|(?:leav|quit|exit)\w* (?:the |a |its |his |her )?(?:kerb|curb|parking|"
                r"bay|lay-?by|parked position|bus stop|roadside)|unpark\w*|(?:set|sets|setting|mov\w*|pull\w*|"
                r"driv\w*|drove|start\w*|swing\w*|swung) (?:off|out|away)(?: from [^,.;]*?)? (?:and (?:enter|"
                r"join)\w*|into|in) (?:our|my|the|the ego's) (?:path|lane|way|road|traffic)|(?:set|sets|setting|"
                r"moves|moved|pulls|pulled|drives|drove|starts|started) off(?: and enter\w*| from)|pull(?:s|ed|"
                "ing)? (?:away|out)(?: in front of| without| into| suddenly|$)"
            ),
            drives="""
                [pull] out {from} in front of {ego} | [pull] out {from} into {egos} lane
                [pull] away {from} in front of {ego} | [pull] out {from} without looking
                [move] off {from} into {egos} path | [pull] out {from} without signalling
                [set] off {from} and [enter] {egos} lane
            """,
            brings=(
                "cross",
                "cut-in",
                "change-lane",
            ),
            sudden=True,
        ),
    )
    WRONG_WAY = (
        "wrong-way",
        Deed(
            meaning="drives against traffic in the ego's own lane",
            words=(
                "wrong(?:-| )way|against (?:the )?(?:traffic|flow|direction)|on the wrong side|"
                "wrong side of the road|in our lane (?:towards?|against|facing)|ghost driver|contraflow|"
                "in the wrong direction|wrong direction"
            ),
            walks="""
                [walk] against the traffic in {egos} lane | [walk] the wrong way in {egos} lane
                [come] at {ego} against the traffic
            """,
            rides="""
                [ride] the wrong way in {egos} lane | [ride] towards {ego} on the wrong side of the road
                [ride] against the traffic in {egos} lane | [come] at {ego} against the traffic
                [head] the wrong way down {egos} lane | [travel] the wrong way towards {ego}
            """,
            drives="""
                [drive] the wrong way in {egos} lane | [drive] towards {ego} on the wrong side of the road
                [drive] against the traffic in {egos} lane | [come] at {ego} against the traffic
                [head] the wrong way down {egos} lane | [travel] the wrong way towards {ego}
            """,
            all_along=True,
            directed=True,
            named="wrong-way",
        ),
    )
    U_TURN = (
        "u-turn",
        Deed(
            meaning="turns round to where it came from",
            words=(
                "u(?:-| )turns?|turns? (?:right )?(?:a)?round in the road|one-eighty|does a 180|"
                "180(?: degree)? turn|turns? back on itself"
            ),
            drives="""
                [make] a U-turn | [do] a U-turn in front of {ego} | [make] a U-turn across {egos} path
                [swing] round in a U-turn | [pull] a U-turn | [attempt] a U-turn | [perform] a U-turn in the road
            """,
            brings=(
                "cross",
                "turn-left",
                "turn-right",
                "oncoming",
            ),
            sudden=True,
            directed=True,
            named="u-turn",
        ),
    )
    BLOCK = (
        "block",
        Deed(
            meaning="stands still in the ego's way",
            words=(
                "block(?:s|ing|ed)? (?:the|our|its|my|both|all)? ?(?:own )?(?:road|lane|path|way|junction|"
                r"intersection|carriageway|street|box|whole|lanes)?|obstruct\w*|in (?:our|the ego's?|my) way|"
                "stand(?:s|ing)? in (?:our|the|my)"
            ),
            drives="""
                [block] {egos} lane | [stand] still in {egos} way | [obstruct] {egos} lane
                [stand] motionless in {egos} lane | [block] the way | [stand] in {egos} path without moving
                [block] {egos} path
            """,
            all_along=True,
            stands=True,
        ),
    )
    STAND = (
        "stand",
        Deed(
            meaning="stands still all the time",
            walks="[stand] still | [wait] | [stand] there | [stay] where {it} is",
            drives="[stand] still | [stand] there motionless | [stand] still with {its} hazard lights on",
            all_along=True,
            stands=True,
        ),
    )
    NARROW = (
        "narrow",
        Deed(
            meaning="stands at an edge of the ego's lane and leaves a part of it free",
            drives="""
                [block] a part of {egos} lane | [stand] half in {egos} lane | [stand] partly in {egos} lane
                [stick] out into {egos} lane | [jut] out into {egos} lane | [take] up a part of {egos} lane
            """,
            all_along=True,
            stands=True,
        ),
    )
    FAST = (
        "fast",
        Deed(
            meaning="drives or runs much faster than usual",
            words=(
                "at (?:breakneck|high|top) speed|breakneck|race[sd]? along|flat out|at full (?:tilt|throttle|pelt)|"
                "speeding|at (?:high|full|great|top|excessive) speed|(?:very |too |so )fast|rac(?:es|ing)|"
                "over the speed limit|flat out|high-speed|excessive speed|tear(?:s|ing) (?:along|through|down)|"
                r"hurtl\w*|bomb(?:s|ing) (?:along|down|through)|(?:speeds|sped)(?= through\b)"
            ),
            walks="""
                [run] flat out | [sprint] along | [run] at full tilt | [tear] along | [race] along | [run] at top speed
            """,
            rides="""
                [race] along | [ride] much too fast | [go] far too fast | [speed] along | [ride] at breakneck speed
                [come] along at high speed | [tear] along
            """,
            drives="""
                [race] along | [drive] much too fast | [go] far too fast | [speed] along | [drive] at breakneck speed
                [come] along at high speed | [tear] along
            """,
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
