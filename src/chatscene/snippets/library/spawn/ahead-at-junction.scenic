#: description = "The adversary is ahead of the ego in its lane, at the line before the intersection."
#: rephrasings = [
#:   "First in the queue at the junction, in front of the ego.",
#:   "it's stood at the line in our lane, we're coming up behind it",
#:   "lead veh at stop line, same lane",
#:   "Vehicle 2 was stopped at the intersection ahead of Vehicle 1 in the same lane.",
#:   "The target is located at the entry of the junction in the lane of the VUT.",
#:   "It is the first car at the crossing, in the lane of the ego.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle", "emergency-vehicle"]
#: requires = ["AdvBehavior", "egoRoute"]
#: provides = ["AdvAgent", "advTrajectory"]
#: origin = "NHTSA pre-crash typology: lead vehicle stopped"
#: [slots]
#: position = "ahead"
#: place = "junction"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 3.0
#: high = 9.0
#: unit = "m"
#: meaning = "how far before the intersection it starts"

param OPT_GEO_Y = Range(3, 9)

advTrajectory = egoRoute
AdvAgent = new AdvClass at pointOn(advTrajectory, egoRoute.eventAt - globalParameters.OPT_GEO_Y),
    facing directionOn(advTrajectory, egoRoute.eventAt - globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
