#: description = "The parked car pulls out and drives straight across the road to the other side."
#: rephrasings = [
#:   "The parked car cuts straight over the whole street in front of us.",
#:   "Vehicle 2 departed the curb and traversed the roadway toward the opposite side.",
#:   "Parked veh crosses carriageway to far side.",
#:   "The target starts from the roadside and crosses the VUT's path transversely.",
#:   "It goes from the parking to the other side, directly across.",
#:   "A van sets off from the side and heads into the yard opposite.",
#:   "The motorbike scoots from its parking spot right over to the far pavement.",
#:   "The lorry at the roadside lumbers over both lanes to a gate across the way.",
#:   "a parked motor shot off his spot and went clean over the road to the far side in front of me",
#:   "V2 left its parking space at the curb and drove directly across both lanes to the opposite side of the street.",
#:   "Van parked RHS: moves off, straight over rd to other side.",
#:   "A parked target leaves the kerbside and traverses the full carriageway to the opposite edge, crossing the VUT's path.",
#:   "The car stands on the side, then it starts and goes across the whole street to the other side.",
#:   "Parked actor leaves its bay and cuts over the full road width, doesn't join our lane, just passes over it.",
#:   "The motorbike had been propped at the roadside; now it set off and made a beeline for the shops over the way, right before them.",
#:   "That police car's leaving the kerb, and he isn't joining the traffic, he's heading for the far side of the road, right across you.",
#:   "parked car just went all the way across the street right in front of us to the other side",
#:   "A van that had been standing at the roadside bolted over the entire width of the High Street before startled traffic",
#:   "You left the kerb and did not stay in the lane but carried on clean over to the opposite pavement?",
#:   "The parked scooter started and went this side to that side fully, cutting our way",
#:   "Parked up nice as pie, then he's off to the kebab shop opposite, straight over my bonnet",
#:   "Full-width transverse crossing by vehicle departing from parked position",
#:   "Parked pickup drives STRAIGHT ACROSS the street in front of me",
#:   "The police car sliced from its bay to the far kerb.",
#: ]
#: adversaries = ["car", "truck", "motorcycle", "emergency-vehicle"]
#: requires = ["advKerb", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["cross", "pull-out", "turn-left"]
#: side = "right"
#: position = "kerb"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 8.0
#: high = 24.0
#: unit = "m"
#: meaning = "how far the ego still has to go to it when it moves off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 2.5
#: high = 4.5
#: unit = "m/s"
#: meaning = "how fast it crosses"

param OPT_ADV_DISTANCE = Range(8, 24)
param OPT_ADV_SPEED = Range(2.5, 4.5)

behavior AdvBehavior():
    do Park() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advKerb, 3) for 0.3 seconds
    do TurnOff(1.2, globalParameters.OPT_ADV_SPEED)
    do MoveAhead(globalParameters.OPT_ADV_SPEED) for 5 seconds
    do Halt()
