"""How people name roads and junctions, and what the ego does there.

Written by us, after the way crash reports, test protocols, driving schools and people at the kitchen table speak.
In braces: ``{own}`` the ego's own possessive, ``{place}`` and ``{road}`` noun phrases, ``{side}`` left or right.
"""

from __future__ import annotations

from chatscene.situations.inflection import listed
from chatscene.terms.scenario import Control, Maneuver, Place

JUNCTION_NOUNS: dict[Place, tuple[str, ...]] = {
    Place.FOUR_WAY: listed(
        """four-way intersection | crossroads | four-way junction | four-arm intersection | 4-way intersection
        four-legged intersection | four-way crossing | four-way crossroads"""
    ),
    Place.THREE_WAY: listed(
        """T-junction | three-way intersection | three-way junction | T-intersection | three-arm junction
        3-way intersection | three-legged intersection"""
    ),
    Place.JUNCTION: listed(
        """intersection | junction | intersection | road junction | street intersection | urban intersection
        city junction"""
    ),
}
CONTROL_BEFORE: dict[Control, tuple[str, ...]] = {
    Control.SIGNAL: listed("signalised | signalized | signal-controlled | light-controlled | traffic-light-controlled"),
    Control.STOP_SIGN: listed("all-way-stop | stop-controlled | stop-sign-controlled | stop-regulated"),
    Control.NONE: listed("unsignalised | uncontrolled | unsignalized | unregulated | signal-free"),
}
CONTROL_AFTER: dict[Control, tuple[str, ...]] = {
    Control.SIGNAL: listed(
        """with traffic lights | with traffic signals | controlled by traffic lights | that has traffic lights
        regulated by signals | with a set of traffic lights"""
    ),
    Control.STOP_SIGN: listed(
        """with stop signs | controlled by stop signs | with a stop sign | where stop signs are posted
        regulated by stop signs | governed by a stop sign"""
    ),
    Control.NONE: listed(
        """without traffic lights | with no traffic lights | that has no traffic lights | without signals
        without any traffic lights | with neither lights nor signs"""
    ),
}
ROAD_NOUNS = listed("road | street | road | street | city street | main road | carriageway | through road")
CURVE_NOUNS: dict[Place, tuple[str, ...]] = {
    Place.CURVE: listed("bend | curve | bend in the road | curve in the road | curved stretch of road | sweeping bend"),
    Place.LEFT_CURVE: listed(
        """left-hand bend | left-hand curve | bend to the left | curve to the left | left bend | left curve
        road that bends to the left"""
    ),
    Place.RIGHT_CURVE: listed(
        """right-hand bend | right-hand curve | bend to the right | curve to the right | right bend | right curve
        road that bends to the right"""
    ),
}
# Keys are the lanes of the ego's direction, and whether one of the other direction lies beside them
LANES: dict[tuple[int | None, bool | None], tuple[str, ...]] = {
    (1, True): listed(
        """a {road} with one lane each way | a {road} with a single lane in each direction
        a two-way {road} with one lane per direction | an ordinary two-way {road} with one lane per direction
        a narrow {road} with one lane in each direction | a two-way {road} with a single lane each way"""
    ),
    (1, False): listed(
        """a single-lane one-way {road} | a one-way {road} with just one lane | a one-way {road} with a single lane
        a narrow one-way {road} with one lane | a one-way {road} one lane wide
        a {road} with one lane and no oncoming traffic"""
    ),
    (1, None): listed(
        """a {road} with a single lane in {egos} direction | a {road} with just one lane in {egos} direction
        a {road} where {egos} direction has one lane | a single-lane {road}
        a {road} with one lane going {egos} way | a one-lane {road}"""
    ),
    (None, True): listed(
        """a two-way {road} | a {road} with two-way traffic | an undivided {road} with oncoming traffic
        a {road} with an oncoming lane | an undivided {road} | a {road} with traffic in both directions"""
    ),
    (None, False): listed(
        """a one-way {road} | a {road} with one-way traffic | a divided {road}
        a one-way {road} without oncoming traffic | a {road} with no oncoming lane | a one-directional {road}"""
    ),
}
MANY_LANES: dict[bool | None, tuple[str, ...]] = {
    True: listed(
        """a two-way {road} with {n} lanes each way | a {road} with {n} lanes in each direction
        a wide two-way {road} with {n} lanes per direction | an undivided {road} with {n} lanes each way
        a two-way {road} with {n} lanes per direction | a busy {road} with {n} lanes in either direction"""
    ),
    False: listed(
        """a {n}-lane one-way {road} | a one-way {road} with {n} lanes | a one-way {road} that has {n} lanes
        a divided {road} with {n} lanes in {egos} direction | a one-way {n}-lane {road}
        a one-way {road} that is {n} lanes wide | a {n}-lane one-way {road}"""
    ),
    None: listed(
        """a {road} with {n} lanes in {egos} direction | a {road} with {n} lanes going {egos} way
        a {road} that has {n} lanes in {egos} direction | a {road} with {n} lanes for {egos} direction
        a wide {road} with {n} lanes in {egos} direction | a {road} where {egos} direction has {n} lanes"""
    ),
}
NUMBERS = {2: "two", 3: "three", 4: "four", 5: "five"}

# What the ego does

EGO_STRAIGHT: dict[str, tuple[str, ...]] = {
    "junction": listed(
        """[go] straight through {place} | [drive] straight through {place} | [drive] straight across {place}
        [proceed] straight through {place} | [go] straight on at {place} | [continue] straight over {place}
        [head] straight through {place} | [pass] straight through {place} | [go] straight ahead at {place}"""
    ),
    "road": listed(
        """[drive] straight along {place} | [travel] straight down {place} | [drive] straight on along {place}
        [go] straight along {place} | [head] straight down {place} | [proceed] straight along {place}
        [cruise] straight along {place} | [continue] straight along {place}"""
    ),
    "curve": listed(
        """[drive] around {place} | [follow] {place} | [go] round {place} | [drive] through {place} | [take] {place}
        [negotiate] {place} | [travel] around {place}"""
    ),
    "": listed(
        """[go] straight on | [drive] straight ahead | [drive] straight on | [proceed] straight ahead
        [continue] straight on | [head] straight on"""
    ),
}
EGO_TURN = listed(
    """[turn] {side} | [turn] {side} | [make] a {side} turn | [take] a {side} turn | [turn] to the {side}
    [make] a {side}-hand turn | [carry] out a {side} turn | [perform] a {side} turn"""
)
EGO_TURN_COLLOQUIAL = listed("[take] a {side} | [hang] a {side} | [make] a {side}")
EGO_UNPROTECTED = listed(
    """[make] an unprotected left turn | [take] an unprotected left turn | [perform] an unprotected left turn"""
)
EGO_LANE_CHANGE = listed(
    """[change] to the {side} lane | [move] over to the {side} lane | [change] lanes to the {side}
    [switch] to the {side} lane | [make] a lane change to the {side} | [change] into the {side} lane
    [merge] into the {side} lane | [shift] to the {side} lane | [perform] a lane change to the {side}"""
)
EGO_BYPASS = listed(
    """[go] around {blocker} in {own} lane | [bypass] {blocker} blocking {own} lane
    [use] the opposite lane to get around {blocker} in {own} lane | [pull] out around {blocker} in {own} lane
    [drive] around {blocker} that is blocking {own} lane | [steer] around {blocker} in {own} lane
    [bypass] {blocker} by using the oncoming lane | [get] around {blocker} through the opposite lane
    [swing] out around {blocker} blocking {own} lane"""
)
EGO_NEARS: dict[str, tuple[str, ...]] = {
    "junction": listed(
        """[approach] {place} | [enter] {place} | [arrive] at {place} | [come] to {place} | [reach] {place}"""
    ),
    "road": listed("[drive] along {place} | [travel] down {place} | [drive] down {place} | [use] {place}"),
    "curve": EGO_STRAIGHT["curve"],
}
EGO_BYPASS_ONE_WAY = listed(
    """[go] around {blocker} in {own} lane | [bypass] {blocker} blocking {own} lane
    [pull] out around {blocker} in {own} lane | [drive] around {blocker} that is blocking {own} lane
    [steer] around {blocker} in {own} lane | [use] the next lane to get around {blocker} in {own} lane
    [swing] out around {blocker} blocking {own} lane"""
)
BLOCKERS = listed(
    """a parked car | a parked van | a parked truck | a broken-down van | a double-parked car | a stationary vehicle
    a parked vehicle | an abandoned car | a disabled vehicle | a parked lorry | an illegally parked car"""
)
BLOCKED = listed(
    """with {blocker} in {own} lane | with {blocker} blocking {own} lane | towards {blocker} in {own} lane
    where {blocker} is blocking {own} lane | with {blocker} obstructing {own} lane | up to {blocker} in {own} lane"""
)
LEADERS = listed(
    """a slow car | a slow-moving lorry | a slow truck | a slow-moving van | a slow lead vehicle | a slower car
    a slow-moving vehicle | a slow bus | a slow leading car | a slow-moving truck | a slower van"""
)
LED = listed(
    """behind {leader} | , following {leader}, | , stuck behind {leader}, | , held up by {leader},
    , with {leader} in front, | , with {leader} ahead, | , slowed down by {leader},"""
)
OVERTAKING = listed(
    """to overtake {leader} | to get past {leader} | to pass {leader} | in order to overtake {leader}
    because of {leader} ahead | in order to pass {leader}"""
)
MANEUVER_SIDE = {
    Maneuver.LEFT_TURN: "left", Maneuver.RIGHT_TURN: "right",
    Maneuver.LANE_CHANGE_LEFT: "left", Maneuver.LANE_CHANGE_RIGHT: "right",
}  # fmt: skip
