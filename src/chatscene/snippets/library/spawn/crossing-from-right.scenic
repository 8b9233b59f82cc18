#: description = "The adversary comes from the right arm of the intersection."
#: rephrasings = [
#:   "On the right front, on the street that crosses the ego's.",
#:   "It approaches the junction from the right side.",
#:   "The crossing car enters from the right.",
#:   "In the cross street, to the right of the ego.",
#:   "Initially at the right, heading for the crossing.",
#:   "Vehicle 2 approached the intersection on the leg to the right.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle", "emergency-vehicle"]
#: requires = ["AdvBehavior", "advTurn", "trafficFromRight"]
#: provides = ["AdvAgent", "acrossMeeting", "advMeeting", "advTrajectory", "egoMeeting"]
#: origin = "base scenarios crossing-negotiation, red-light-running, unprotected-left-turn, right-turn; own code"
#: [slots]
#: side = "right"
#: position = "crossing"
#: place = "junction"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 3.5
#: high = 20.0
#: unit = "m"
#: meaning = "how far before the intersection it starts"

param OPT_GEO_Y = Range(3.5, 20)

advTrajectory = wayOf(trafficFromRight, advTurn)
advMeeting = advTrajectory.meets_at
egoMeeting = advTrajectory.ego_meets_at
acrossMeeting = egoMeeting  # from here a left turn, too, leads across the ego's way
AdvAgent = new AdvClass at pointOn(advTrajectory, advTrajectory.entry - globalParameters.OPT_GEO_Y),
    facing directionOn(advTrajectory, advTrajectory.entry - globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
