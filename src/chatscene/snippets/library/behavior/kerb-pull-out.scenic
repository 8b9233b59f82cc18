#: description = "The parked car pulls out from the kerb into the ego's lane and drives on."
#: rephrasings = [
#:   "The parked car just pulls out in front of us and carries on.",
#:   "Vehicle 2 left its parking position and entered the travel lane ahead of vehicle 1.",
#:   "Parked veh moves off, joins our lane.",
#:   "The target starts from the parking strip and merges into the path of the VUT.",
#:   "The car which is parked goes out of its place and drives before us.",
#:   "The bus leaves its stop and joins traffic without waiting for us.",
#:   "A van at the side of the road sets off and takes our lane.",
#:   "Without a look over the shoulder the rider starts his motorbike from the roadside and slots in.",
#:   "parked car just came out in front of me and toddled off down the road",
#:   "The truck left the curb, entered the lane ahead of V1, and continued traveling.",
#:   "Bus leaves stop -> our lane, drives on.",
#:   "A target parked at the kerbside moves off into the VUT's lane and continues ahead of it.",
#:   "The taxi is parked, then it goes out in my lane and drives.",
#:   "Parked vehicle joins traffic ahead of SUT and keeps driving, no stop, no drama.",
#:   "The van stirred from its parking place, slipped out before them and took the road.",
#:   "That chap at the side is moving off, he's coming out into your lane and he's away. Did he check his mirror? No.",
#:   "parked car just came out in front and drove off without looking, rude",
#:   "A bus setting off from its stop forced its way into traffic and continued along the route",
#:   "You moved away from the kerb into the lane that my client occupied, and you simply drove on?",
#:   "The van parked at roadside anyhow come out into our lane, then drive off, never check one",
#:   "He's off his parking spot and under my nose and away, not a glance over his shoulder",
#:   "Departure of parked vehicle into own lane with continued travel ahead",
#:   "Parked motorbike joins traffic WITHOUT LOOKING",
#:   "The taxi peeled off the kerb ahead of us and motored on.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advKerb", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "NHTSA pre-crash typology: leaving a parked position; own code"
#: [slots]
#: actions = ["pull-out"]
#: position = "kerb"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 12.0
#: high = 30.0
#: unit = "m"
#: meaning = "how far the ego still has to go to it when it moves off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.0
#: high = 7.5
#: unit = "m/s"
#: meaning = "how fast it drives"

param OPT_ADV_DISTANCE = Range(12, 30)
param OPT_ADV_SPEED = Range(4, 7.5)

behavior AdvBehavior():
    do Park() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advKerb, 3) for 0.3 seconds
    do DrivePath(ownLane(egoRoute), globalParameters.OPT_ADV_SPEED)
