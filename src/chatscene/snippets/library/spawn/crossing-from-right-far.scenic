#: description = "The adversary approaches the intersection from the right, still a long way off."
#: rephrasings = [
#:   "Far back on the right arm of the junction.",
#:   "it's still miles away up the road on our right",
#:   "right arm, well before junction entry",
#:   "Vehicle 2 was approaching the intersection from the right, a considerable distance upstream.",
#:   "The target travels on the right arm and starts far from the conflict point.",
#:   "It comes from the right, but is yet far of the crossing.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle", "emergency-vehicle"]
#: requires = ["AdvBehavior", "advTurn", "trafficFromRight"]
#: provides = ["AdvAgent", "acrossMeeting", "advMeeting", "advTrajectory", "egoMeeting"]
#: origin = "own code"
#: [slots]
#: side = "right"
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

advTrajectory = wayOf(trafficFromRight, advTurn)
advMeeting = advTrajectory.meets_at
egoMeeting = advTrajectory.ego_meets_at
acrossMeeting = egoMeeting  # from here a left turn, too, leads across the ego's way
AdvAgent = new AdvClass at pointOn(advTrajectory, advTrajectory.entry - globalParameters.OPT_GEO_Y),
    facing directionOn(advTrajectory, advTrajectory.entry - globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
