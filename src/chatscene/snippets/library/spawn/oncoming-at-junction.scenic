#: description = "The adversary comes from the opposite arm of the intersection, toward the ego."
#: rephrasings = [
#:   "Oncoming, on the far side of the junction.",
#:   "It approaches the crossing from the direction the ego faces.",
#:   "The opposing car enters from straight ahead.",
#:   "In the arm across from the ego, facing it.",
#:   "From the opposite direction, heading for the same junction.",
#:   "it's coming at the junction from straight across",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle", "emergency-vehicle"]
#: requires = ["AdvBehavior", "advTurn", "oncomingTraffic"]
#: provides = ["AdvAgent", "acrossMeeting", "advMeeting", "advTrajectory", "egoMeeting"]
#: origin = "base scenarios crossing-negotiation, red-light-running, unprotected-left-turn, right-turn; own code"
#: [slots]
#: position = "oncoming"
#: place = "junction"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 3.5
#: high = 20.0
#: unit = "m"
#: meaning = "how far before the intersection it starts"

param OPT_GEO_Y = Range(3.5, 20)

advTrajectory = wayOf(oncomingTraffic, advTurn)
advMeeting = advTrajectory.meets_at
egoMeeting = advTrajectory.ego_meets_at
acrossMeeting = egoMeeting  # from here a left turn, too, leads across the ego's way
AdvAgent = new AdvClass at pointOn(advTrajectory, advTrajectory.entry - globalParameters.OPT_GEO_Y),
    facing directionOn(advTrajectory, advTrajectory.entry - globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
