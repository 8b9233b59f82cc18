#: description = "A pack rides ahead of the ego in its lane, the adversary first."
#: rephrasings = [
#:   "Several riders together in front of the ego, in the same lane.",
#:   "there's a whole bunch of cyclists ahead of us taking up the lane",
#:   "group of cyclists / motorcyclists, same lane, ahead",
#:   "Three two-wheelers were traveling as a group ahead of Vehicle 1 in lane 1.",
#:   "The target and two companions travel in front of the VUT in its lane.",
#:   "Some motorbikes drive together before the ego in own lane of it.",
#: ]
#: adversaries = ["bicycle", "motorcycle"]
#: requires = ["AdvBehavior", "egoRoute"]
#: provides = ["AdvAgent", "advTrajectory"]
#: origin = "own code"
#: [slots]
#: position = "ahead"
#: group = true
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 12.0
#: high = 24.0
#: unit = "m"
#: meaning = "how far ahead of the ego it starts"

param OPT_GEO_Y = Range(12, 24)

advTrajectory = egoRoute
AdvAgent = new AdvClass at pointOn(advTrajectory, globalParameters.OPT_GEO_Y),
    facing directionOn(advTrajectory, globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
for back, left in ((3.2, 0.8), (4.2, -0.9)):
    new AdvClass at pointOn(advTrajectory, globalParameters.OPT_GEO_Y - back, left),
        facing directionOn(advTrajectory, globalParameters.OPT_GEO_Y - back),
        with behavior AdvBehavior()
