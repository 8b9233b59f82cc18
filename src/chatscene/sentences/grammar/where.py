"""How people say where the adversary is: after its noun (POST), or after what it does (FROM).

Written by us, after the way crash reports, test protocols, driving schools and people at the kitchen table speak.
In braces: ``{ego}`` the ego as an object, ``{egos}`` its possessive, ``{its}`` the adversary's, ``{side}`` left
or right.
"""

from __future__ import annotations

from chatscene.situations.inflection import listed
from chatscene.terms.scenario import Distance, Occluder, Position

# By position: with a side, and without
POST: dict[Position, tuple[tuple[str, ...], tuple[str, ...]]] = {
    Position.AHEAD: (
        listed(
            """ahead of {ego} at the {side} edge of the lane | in front of {ego} on the {side} of the lane
            just ahead of {ego} at the {side}-hand edge of the road | in {egos} lane ahead at its {side} edge
            ahead of {ego} on the {side} side of the lane | in front of {ego} at the {side} edge of the road"""
        ),
        listed(
            """ahead of {ego} | directly ahead of {ego} | in front of {ego} in the same lane | ahead in {egos} lane
            right in front of {ego} | just ahead of {ego} in the same lane | in {egos} lane ahead"""
        ),
    ),
    Position.ROADSIDE: (
        listed(
            """standing at the {side} side of the road | on the pavement to {egos} {side} | at the kerb on the {side}
            waiting by the roadside on the {side} | on the sidewalk to the {side} of {ego} | at the {side} roadside
            at the {side}-hand edge of the road | beside the road on the {side} | on the {side}-hand sidewalk"""
        ),
        listed(
            """standing at the side of the road | on the pavement | at the kerb | waiting by the roadside
            at the edge of the road | beside the road | on the sidewalk"""
        ),
    ),
    Position.BESIDE: (
        listed(
            """beside {ego} in the {side} lane | alongside {ego} on the {side} | next to {ego} in the {side} lane
            level with {ego} in the {side} lane | alongside {ego} in the {side}-hand lane
            driving next to {ego} on the {side} | level with {ego} in the lane to the {side}"""
        ),
        listed(
            """beside {ego} | alongside {ego} | level with {ego} in the next lane | driving next to {ego}
            level with {ego} in the adjacent lane | beside {ego} in the neighbouring lane"""
        ),
    ),
    Position.AHEAD_BESIDE: (
        listed(
            """ahead in the {side} lane | slightly ahead of {ego} in the {side} lane | in the {side} lane ahead
            further ahead in the {side}-hand lane | ahead of {ego} in the next lane to the {side}
            ahead of {ego} in the adjacent lane on the {side} | a little way ahead in the {side} lane"""
        ),
        listed(
            """ahead in the next lane | slightly ahead of {ego} in the adjacent lane | in the neighbouring lane ahead
            further ahead in the other lane | a little way ahead in the neighbouring lane
            ahead of {ego} in the next lane"""
        ),
    ),
    Position.BEHIND: (
        (),
        listed(
            """behind {ego} | behind {ego} in the same lane | directly behind {ego} | coming up behind {ego}
            right behind {ego} | approaching from behind | in {egos} lane behind {ego}"""
        ),
    ),
    Position.BEHIND_BESIDE: (
        listed(
            """behind {ego} in the {side} lane | coming up from behind in the {side} lane
            approaching from behind on the {side} | in the {side} lane behind {ego} | behind {ego} on the {side}
            coming from behind in the {side}-hand lane | slightly behind {ego} in the {side} lane"""
        ),
        listed(
            """behind {ego} in the next lane | coming up from behind in the adjacent lane
            a little way behind {ego} in the adjacent lane | approaching from behind in the next lane
            behind {ego} in the neighbouring lane | coming from behind in the other lane"""
        ),
    ),
    Position.ONCOMING: (
        (),
        listed(
            """coming from the opposite direction | coming the other way | approaching from the opposite direction
            coming towards {ego} | heading towards {ego} | approaching {ego} from the opposite direction
            travelling in the opposite direction"""
        ),
    ),
    Position.CROSSING: (
        listed(
            """coming from the {side} | approaching from the {side} | coming from the {side} arm of the intersection
            coming out of the side street on the {side} | approaching from {egos} {side}
            coming from the side road to the {side} | coming from the {side}-hand side street"""
        ),
        listed(
            """coming from the side street | approaching from a side road | coming out of the cross street
            coming from a side street | approaching on the cross street | coming from the side road"""
        ),
    ),
    Position.FAR_CORNER: (
        listed(
            """on the opposite sidewalk on the {side} | at the far corner on the {side}
            on the far side to the {side} | at the far kerb on {egos} {side} | on the opposite side to the {side}
            standing at the {side}-hand far corner"""
        ),
        listed(
            """on the opposite sidewalk | at the far corner | at the far kerb | standing at the far corner
            on the far side of the side street | on the far sidewalk"""
        ),
    ),
    Position.KERB: (
        listed(
            """parked at the kerb on the {side} | standing at the {side}-hand kerb
            parked on the {side} side of the road | parked at the {side} roadside
            stationary at the {side} edge of the road | waiting at the kerb on {egos} {side}"""
        ),
        listed(
            """parked at the kerb | standing at the kerb ahead | parked at the side of the road
            parked at the roadside | stationary at the edge of the road | waiting at the kerb"""
        ),
    ),
    Position.BEYOND: (
        listed(
            """behind the corner on the {side} | behind the junction on the {side} | after the turn on the {side}
            just behind the corner on {egos} {side}"""
        ),
        listed(
            """just behind the corner | right behind the junction | just after the turn | behind the intersection
            directly behind the corner | after the junction"""
        ),
    ),
}
FROM: dict[Position, tuple[tuple[str, ...], tuple[str, ...]]] = {
    Position.ROADSIDE: (
        listed(
            """from the {side} | from the {side} side of the road | from the pavement on the {side}
            from the {side}-hand side | from the sidewalk on {egos} {side} | from {egos} {side}-hand side
            from the {side}-hand kerb | from the roadside on the {side} | from the {side} of {ego}"""
        ),
        listed(
            """from the side of the road | from the pavement | from the sidewalk | from the roadside | from the kerb
            from the edge of the road"""
        ),
    ),
    Position.FAR_CORNER: (
        listed(
            """from the opposite sidewalk on the {side} | from the far corner on the {side}
            from the far side on {egos} {side} | from the opposite side to the {side}
            from the opposite pavement on the {side} | from the {side}-hand far corner"""
        ),
        listed(
            """from the opposite sidewalk | from the far corner | from the far side | from the opposite pavement
            from the far kerb | from the opposite side of the street"""
        ),
    ),
    Position.KERB: (
        listed(
            """from the kerb on the {side} | from {its} parking space on the {side} | from the {side}-hand kerb
            from the {side} side of the road | from the {side} roadside | from the parking lane on the {side}"""
        ),
        listed(
            """from the kerb | from {its} parking space | from the side of the road | from the roadside
            from the parking lane | from a parking spot"""
        ),
    ),
}
SIDE_POST = listed("on the {side} | on {egos} {side} | to the {side} of {ego} | on the {side}-hand side")
SIDE_FROM = listed(
    """from the {side} | from {egos} {side} | from the {side}-hand side | from the {side} of {ego}
    from {egos} {side}-hand side | from the {side} side"""
)
ON_FOOT_ONCOMING = listed(
    """walking towards {ego} along the edge of the road | coming towards {ego} along the roadside
    coming towards {ego} on foot | walking towards {ego} at the side of the lane | approaching {ego} on foot
    coming the other way along the kerb"""
)

OCCLUDERS: dict[Occluder, tuple[str, ...]] = {
    Occluder.BUS_STOP: listed(
        """a bus stop | a bus shelter | a crowded bus stop | the bus shelter | a glazed bus shelter | the bus stop"""
    ),
    Occluder.VENDING_MACHINE: listed(
        """a vending machine | a drinks machine | a drinks vending machine | a big vending machine | a ticket machine
        a snack vending machine"""
    ),
    Occluder.PARKED_CAR: listed(
        """a parked car | a parked van | a row of parked cars | a stationary car | a parked SUV | a double-parked car
        a parked taxi"""
    ),
    Occluder.PARKED_TRUCK: listed(
        """a parked truck | a parked lorry | a stationary truck | a parked delivery truck | a double-parked truck
        a standing lorry"""
    ),
    Occluder.PARKED_BUS: listed(
        """a parked bus | a standing bus | a parked coach | a stationary bus | a bus standing at the kerb
        a parked school bus"""
    ),
    Occluder.KIOSK: listed("a kiosk | a newsstand | a food stall | a newspaper kiosk | a snack kiosk | a market stall"),
    Occluder.CONTAINER: listed(
        """a container | a dumpster | a skip | a rubbish container | a large container | a construction container"""
    ),
    Occluder.HEDGE: listed("a hedge | a tall hedge | a fence | a garden wall | a high hedge | a wall"),
    Occluder.BILLBOARD: listed(
        """a billboard | an advertising column | a large billboard | an advertising board | a roadside billboard
        a poster column"""
    ),
}
HIDDEN_POST = listed(
    """hidden behind {occluder} | hidden from view behind {occluder} | concealed behind {occluder}
    standing out of sight behind {occluder} | hidden by {occluder} | obscured by {occluder} | masked by {occluder}"""
)
HIDDEN_FROM = listed(
    """from behind {occluder} | from behind {occluder} | from behind {occluder} | from the cover of {occluder}"""
)
HIDDEN_SIDE = listed(
    """on the {side} | to {egos} {side} | on {egos} {side} | on the {side}-hand side | to the {side} of {ego}"""
)
HIDDEN_IN = {  # where hidden, if not at the roadside
    Position.KERB: listed("at the kerb | at the edge of the road | by the roadside"),
    Position.FAR_CORNER: listed("at the far corner | on the opposite sidewalk | at the far side of the side street"),
}

DISTANCES: dict[Distance, tuple[str, ...]] = {
    Distance.NEAR: listed(
        """only a few metres away | close by | just ten metres away | very close | only some fifteen metres away
        a few paces away | quite near"""
    ),
    Distance.FAR: listed(
        """far ahead | a long way off | some fifty metres away | well in the distance | still far away
        at a great distance | about forty metres off"""
    ),
}
FAR_BUT_NOT_AHEAD = listed(
    """a long way off | some fifty metres away | still far away | at a great distance | about forty metres off"""
)
