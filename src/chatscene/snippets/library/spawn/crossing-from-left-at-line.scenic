#: description = "The adversary stands at the line of the intersection from the left."
#: rephrasings = [
#:   "At the mouth of the left arm, about to enter.",
#:   "it's waiting at the line of the side street on our left",
#:   "left arm, at stop line",
#:   "Vehicle 2 was stopped at the intersection, facing the junction from the left.",
#:   "The target is at rest at the give-way line of the left arm.",
#:   "It stays from the left directly at the border of the crossing.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle", "emergency-vehicle"]
#: requires = ["AdvBehavior", "advTurn", "trafficFromLeft"]
#: provides = ["AdvAgent", "advMeeting", "advTrajectory", "egoMeeting"]
#: origin = "own code"
#: [slots]
#: side = "left"
#: position = "crossing"
#: place = "junction"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 2.7
#: high = 3.4
#: unit = "m"
#: meaning = "how far before the intersection it starts"

param OPT_GEO_Y = Range(2.7, 3.4)

advTrajectory = wayOf(trafficFromLeft, advTurn)
advMeeting = advTrajectory.meets_at
egoMeeting = advTrajectory.ego_meets_at
AdvAgent = new AdvClass at pointOn(advTrajectory, advTrajectory.entry - globalParameters.OPT_GEO_Y),
    facing directionOn(advTrajectory, advTrajectory.entry - globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
