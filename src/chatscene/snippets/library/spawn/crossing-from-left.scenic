#: description = "The adversary comes from the left arm of the intersection."
#: rephrasings = [
#:   "On the left front, on the street that crosses the ego's.",
#:   "It approaches the junction from the left side.",
#:   "The crossing car enters from the left.",
#:   "In the cross street, to the left of the ego.",
#:   "Initially at the left, heading for the crossing.",
#:   "Vehicle 2 approached the intersection on the leg to the left.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle", "emergency-vehicle"]
#: requires = ["AdvBehavior", "advTurn", "trafficFromLeft"]
#: provides = ["AdvAgent", "advMeeting", "advTrajectory", "egoMeeting"]
#: origin = "base scenarios crossing-negotiation, red-light-running, unprotected-left-turn, right-turn; own code"
#: [slots]
#: side = "left"
#: position = "crossing"
#: place = "junction"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 3.5
#: high = 20.0
#: unit = "m"
#: meaning = "how far before the intersection it starts"

param OPT_GEO_Y = Range(3.5, 20)

advTrajectory = wayOf(trafficFromLeft, advTurn)
advMeeting = advTrajectory.meets_at
egoMeeting = advTrajectory.ego_meets_at
AdvAgent = new AdvClass at pointOn(advTrajectory, advTrajectory.entry - globalParameters.OPT_GEO_Y),
    facing directionOn(advTrajectory, advTrajectory.entry - globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
