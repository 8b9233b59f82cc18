#: description = "The oncoming pedestrian sways along the road toward the ego, now beside the lane, now in it."
#: rephrasings = [
#:   "A drunk comes tottering toward us, into the road and out of it.",
#:   "The intoxicated pedestrian approached Vehicle 1 on an unsteady, weaving path.",
#:   "oncoming ped, swaying, in and out",
#:   "The target approaches the VUT with an oscillating lateral position.",
#:   "A drunken man goes to us, sometimes left, sometimes right.",
#:   "Somebody facing the traffic wavers like a reed in the wind.",
#:   "A reveller heading our way reels between the verge and the tarmac.",
#:   "The walker who meets us cannot hold a straight course.",
#:   "Some drunk was tottering up the road towards me, one moment in the gutter, the next in my lane.",
#:   "An intoxicated pedestrian was observed staggering toward Unit 1, drifting in and out of the traffic lane.",
#:   "Ped facing traffic, staggering, in lane / out of lane / in.",
#:   "The pedestrian target approaches along the road edge, alternately entering and leaving the VUT's lane.",
#:   "Drunk man walks against me, sometimes on the side, sometimes in my lane.",
#:   "Lurching ped walking at us, lateral wander in and out of our lane boundary, never crosses fully.",
#:   "He reeled along to meet her, lurching into her lane, reeling out of it, and lurching back again.",
#:   "We've a caller about a man staggering along towards the traffic, in and out of the lane, can't walk straight.",
#:   "wasted dude stumbling down the road at us half in our lane half out",
#:   "A reveller lurched along the roadside into the face of traffic, straying into the lane and out again.",
#:   "The man coming toward you was unsteady, and he was by turns on the verge and on the carriageway?",
#:   "One drunken fellow was coming opposite, swinging here and there, sometimes inside my lane.",
#:   "Closing time, and here's one rolling up the road at me, in my lane, out my lane, hello ocifer.",
#:   "Unsteady oncoming pedestrian with repeated lane-edge encroachment.",
#:   "DRUNK MAN WALKS AT CAR, CAN'T STAY OFF THE ROAD",
#:   "An oncoming walker teetered over our lane edge and back, over and over.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior", "advFacing"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "weave"]
#: position = "oncoming"
#: place = "road"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.8
#: high = 3.0
#: unit = "m/s"
#: meaning = "how fast it goes"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 34.0
#: high = 48.0
#: unit = "m"
#: meaning = "distance to the ego at which it sets off"
#: [[parameters]]
#: name = "OPT_ADV_ANGLE"
#: low = 0.6
#: high = 1.0
#: unit = "rad"
#: meaning = "how far each leg slants"
#: [[parameters]]
#: name = "OPT_ADV_PERIOD"
#: low = 1.2
#: high = 1.8
#: unit = "s"
#: meaning = "how long a leg takes"

param OPT_ADV_SPEED = Range(1.8, 3)
param OPT_ADV_DISTANCE = Range(34, 48)
param OPT_ADV_ANGLE = Range(0.6, 1)
param OPT_ADV_PERIOD = Range(1.2, 1.8)

# It faces against the ego's direction.
advFacing = 3.14159

behavior AdvBehavior():
    do Halt() until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do MoveAhead(3, 1) until abs(offsetFrom(egoRoute, self)) < 2
    do MoveAhead(globalParameters.OPT_ADV_SPEED, -1 - globalParameters.OPT_ADV_ANGLE) for globalParameters.OPT_ADV_PERIOD seconds
    while True:
        do MoveAhead(globalParameters.OPT_ADV_SPEED, 2 * globalParameters.OPT_ADV_ANGLE) for globalParameters.OPT_ADV_PERIOD seconds
        do MoveAhead(globalParameters.OPT_ADV_SPEED, -2 * globalParameters.OPT_ADV_ANGLE) for globalParameters.OPT_ADV_PERIOD seconds
