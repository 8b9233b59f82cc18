#: description = "The adversary stands at the line of the intersection from the opposite direction."
#: rephrasings = [
#:   "At the mouth of the opposite arm, about to enter.",
#:   "it's waiting at the line across from us",
#:   "opposite arm, at stop line",
#:   "Vehicle 2 was stopped at the intersection, facing the junction from the opposite direction.",
#:   "The target is at rest at the give-way line of the opposite arm.",
#:   "It stays from the opposite direction directly at the border of the crossing.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle", "emergency-vehicle"]
#: requires = ["AdvBehavior", "advTurn", "oncomingTraffic"]
#: provides = ["AdvAgent", "acrossMeeting", "advMeeting", "advTrajectory", "egoMeeting"]
#: origin = "own code"
#: [slots]
#: position = "oncoming"
#: place = "junction"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 2.7
#: high = 3.4
#: unit = "m"
#: meaning = "how far before the intersection it starts"

param OPT_GEO_Y = Range(2.7, 3.4)

advTrajectory = wayOf(oncomingTraffic, advTurn)
advMeeting = advTrajectory.meets_at
egoMeeting = advTrajectory.ego_meets_at
acrossMeeting = egoMeeting  # from here a left turn, too, leads across the ego's way
AdvAgent = new AdvClass at pointOn(advTrajectory, advTrajectory.entry - globalParameters.OPT_GEO_Y),
    facing directionOn(advTrajectory, advTrajectory.entry - globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
