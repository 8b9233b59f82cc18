#: description = "The parked car pulls out into the ego's lane and at once pulls in again at the kerb."
#: rephrasings = [
#:   "He pulls out, drives two car lengths and tucks back into the side.",
#:   "Vehicle 2 left the curb, occupied the lane briefly and returned to the roadside.",
#:   "Parked veh out, then in again further on.",
#:   "The target merges ahead of the VUT and returns to the parking strip.",
#:   "It comes out and goes again to the border, only changes the place.",
#:   "The bus leaves one bay and dives into the next.",
#:   "A van hops out round something and parks up anew.",
#:   "The rider ventures off the roadside and ducks back to it.",
#:   "A parked car nosed out into my lane, thought better of it and tucked itself back in.",
#:   "Unit 2 left the parking lane, entered the travel lane, and immediately returned to the curb.",
#:   "Van out of bay, into lane, back to kerb at once.",
#:   "The parked target moves off into the lane of the test vehicle and forthwith steers back to its parking position further on.",
#:   "The bus goes out from its place and right away again to the side.",
#:   "Parked actor: out, then straight back to the edge, forward motion throughout, net zero.",
#:   "It slid away from the pavement into her path, and as quickly it ducked back to the side as if ashamed.",
#:   "That ambulance is coming off the side, no, he's changed his mind, he's tucked back in by the pavement.",
#:   "parked car came out infront of me then was like nvm and went back to the side",
#:   "A van left its parking place only to dive back to the roadside a few metres further on.",
#:   "You quitted the roadside, entered my client's lane and, all in one movement, resumed the roadside?",
#:   "That parked car came out on the road, then immediately went back to side, simply confusing me.",
#:   "Out of his bay, into my lane, back by the pavement again, what was that, a lap of honour?",
#:   "Brief excursion of parked vehicle into own lane with immediate return to the roadside",
#:   "PARKED CAR FAKES ME OUT - out and straight back in",
#:   "The standing bus bobs out and snuggles back to the side.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advKerb", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["pull-out", "turn-back"]
#: position = "kerb"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 15.0
#: high = 34.0
#: unit = "m"
#: meaning = "how far the ego still has to go to it when it moves off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 3.0
#: high = 5.5
#: unit = "m/s"
#: meaning = "how fast it drives"

param OPT_ADV_DISTANCE = Range(15, 34)
param OPT_ADV_SPEED = Range(3, 5.5)

behavior AdvBehavior():
    do Park() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advKerb, 3) for 0.3 seconds
    do DrivePath(ownLane(egoRoute), globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(ownLane(egoRoute), self)) < 0.9
    do DrivePath(advKerb, globalParameters.OPT_ADV_SPEED)
