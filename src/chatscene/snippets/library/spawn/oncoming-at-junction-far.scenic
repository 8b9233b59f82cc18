#: description = "The adversary approaches the intersection from the opposite direction, still a long way off."
#: rephrasings = [
#:   "Far back on the opposite arm of the junction.",
#:   "it's still miles away up the road opposite",
#:   "opposite arm, well before junction entry",
#:   "Vehicle 2 was approaching the intersection from the opposite direction, a considerable distance upstream.",
#:   "The target travels on the opposite arm and starts far from the conflict point.",
#:   "It comes from the opposite direction, but is yet far of the crossing.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle", "emergency-vehicle"]
#: requires = ["AdvBehavior", "advTurn", "oncomingTraffic"]
#: provides = ["AdvAgent", "acrossMeeting", "advMeeting", "advTrajectory", "egoMeeting"]
#: origin = "own code"
#: [slots]
#: position = "oncoming"
#: place = "junction"
#: distance = "far"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 21.0
#: high = 28.0
#: unit = "m"
#: meaning = "how far before the intersection it starts"

param OPT_GEO_Y = Range(21, 28)

advTrajectory = wayOf(oncomingTraffic, advTurn)
advMeeting = advTrajectory.meets_at
egoMeeting = advTrajectory.ego_meets_at
acrossMeeting = egoMeeting  # from here a left turn, too, leads across the ego's way
AdvAgent = new AdvClass at pointOn(advTrajectory, advTrajectory.entry - globalParameters.OPT_GEO_Y),
    facing directionOn(advTrajectory, advTrajectory.entry - globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
