#: description = "The pedestrian staggers across the road in a zigzag."
#: rephrasings = [
#:   "A person reels over the carriageway from one slant to the other.",
#:   "The drunk pedestrian sways to and fro while crossing.",
#:   "Someone crosses the street in a wavering line, veering each second.",
#:   "The walker zigzags through the lane ahead of the ego.",
#:   "The pedestrian's course over the road swings erratically left and right.",
#:   "Some drunk comes lurching over the road, left, right, left.",
#:   "The intoxicated pedestrian followed an erratic path across the roadway.",
#:   "ped crosses zigzag, unpredictable",
#:   "this fella was tottering over the road all over the place, one way then the other, three sheets to the wind",
#:   "The pedestrian stumbled over the street in an erratic, zigzagging manner.",
#:   "Ped X-ing, zigzag track, unsteady.",
#:   "The pedestrian target crosses at normal walking speed on a zigzag path with alternating heading.",
#:   "The man goes over the street not straight, but always here and there, like a lightning.",
#:   "Crosser with polyline path: heading flips left/right at each leg; normal walking velocity.",
#:   "She tacked over the road like a sailing boat, stumbling off to one hand and then to the other.",
#:   "Walker coming over, and he can't keep a straight line, he's lurching off left, off right, you can't tell where he'll be next.",
#:   "drunk guy crossing like a pinball left right left right",
#:   "A partygoer tacked over the street like a dinghy in a squall",
#:   "He did not cross in a line at all, but first this way and then that?",
#:   "One man crossing the road zigzag zigzag, cannot tell which side he will go",
#:   "He's had a few, coming over the road in a string of Zs",
#:   "Erratic zigzag crossing path of pedestrian",
#:   "Pedestrian ZIGZAGS across the road, where is he going??",
#:   "The walker tacked and lurched across.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: actions = ["cross", "weave"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.5
#: high = 4.0
#: unit = "m/s"
#: meaning = "how fast it goes"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 14.0
#: high = 42.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts to move"
#: [[parameters]]
#: name = "OPT_ADV_ANGLE"
#: low = 0.6
#: high = 1.0
#: unit = "rad"
#: meaning = "how far each leg slants"

param OPT_ADV_SPEED = Range(1.5, 4)
param OPT_ADV_DISTANCE = Range(14, 42)
param OPT_ADV_ANGLE = Range(0.6, 1)

behavior AdvBehavior():
    # Earlier where it has farther to go, and briskly where the ego would be gone otherwise.
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 8 * max(0, abs(offsetFrom(egoRoute, self)) - 3) / globalParameters.OPT_ADV_SPEED
    do MoveAhead(5) until abs(offsetFrom(egoRoute, self)) < max(2.5, globalParameters.OPT_ADV_SPEED * headway(egoRoute, ego, self) / 12)
    do MoveAhead(globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_ANGLE) for 0.6 seconds
    while True:
        do MoveAhead(globalParameters.OPT_ADV_SPEED, -2 * globalParameters.OPT_ADV_ANGLE) for 1.2 seconds
        do MoveAhead(globalParameters.OPT_ADV_SPEED, 2 * globalParameters.OPT_ADV_ANGLE) for 1.2 seconds
