#: description = "The adversary approaches the intersection from the left, still a long way off."
#: rephrasings = [
#:   "Far back on the left arm of the junction.",
#:   "it's still miles away up the road on our left",
#:   "left arm, well before junction entry",
#:   "Vehicle 2 was approaching the intersection from the left, a considerable distance upstream.",
#:   "The target travels on the left arm and starts far from the conflict point.",
#:   "It comes from the left, but is yet far of the crossing.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle", "emergency-vehicle"]
#: requires = ["AdvBehavior", "advTurn", "trafficFromLeft"]
#: provides = ["AdvAgent", "advMeeting", "advTrajectory", "egoMeeting"]
#: origin = "own code"
#: [slots]
#: side = "left"
#: position = "crossing"
#: place = "junction"
#: distance = "far"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 21.0
#: high = 28.0
#: unit = "m"
#: meaning = "how far before the intersection it starts"

param OPT_GEO_Y = Range(21, 28)

advTrajectory = wayOf(trafficFromLeft, advTurn)
advMeeting = advTrajectory.meets_at
egoMeeting = advTrajectory.ego_meets_at
AdvAgent = new AdvClass at pointOn(advTrajectory, advTrajectory.entry - globalParameters.OPT_GEO_Y),
    facing directionOn(advTrajectory, advTrajectory.entry - globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
