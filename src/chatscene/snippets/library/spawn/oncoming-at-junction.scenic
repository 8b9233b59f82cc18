#: description = "The adversary comes from the opposite arm of the intersection, toward the ego."
#: rephrasings = [
#:   "Oncoming, on the far side of the junction.",
#:   "It approaches the crossing from the direction the ego faces.",
#:   "The opposing car enters from straight ahead.",
#:   "In the arm across from the ego, facing it.",
#:   "From the opposite direction, heading for the same junction.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle"]
#: requires = ["AdvBehavior", "AdvClass", "advTurn", "oncomingTraffic"]
#: provides = ["AdvAgent", "advEntry", "advTrajectory"]
#: origin = "base scenarios crossing-negotiation, red-light-running, unprotected-left-turn, right-turn; own code"
#: [slots]
#: position = "oncoming"
#: place = "junction"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 3.5
#: high = 18.0
#: unit = "m"
#: meaning = "how far before the intersection it starts"

param OPT_GEO_Y = Range(3.5, 18)

advTrajectory = wayOf(oncomingTraffic, advTurn)
advEntry = advTrajectory.entry
AdvAgent = new AdvClass at pointOn(advTrajectory, advEntry - globalParameters.OPT_GEO_Y),
    facing directionOn(advTrajectory, advEntry - globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
