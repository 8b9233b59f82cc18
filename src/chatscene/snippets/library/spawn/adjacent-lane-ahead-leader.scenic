#: description = "The adversary is ahead of the ego in the neighbouring lane, and a slow car leads the ego."
#: rephrasings = [
#:   "The car starts further on in the neighbouring lane, and a slow car leads the ego.",
#:   "In the target lane beside, some metres in front, and a slow car leads the ego.",
#:   "It drives before the ego, one lane over beside, and a slow car leads the ego.",
#:   "The other vehicle is on the front, in a parallel lane, and a slow car leads the ego.",
#:   "A few car lengths on, in the lane next to it beside, and a slow car leads the ego.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["AdvBehavior", "adjacentLane", "egoRoute"]
#: provides = ["AdvAgent", "LeadingAgent", "advLane", "advTrajectory"]
#: origin = "base scenario lane-changing; own code"
#: [slots]
#: position = "ahead-beside"
#: leader = true
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 5.5
#: high = 9.0
#: unit = "m"
#: meaning = "how far ahead of the ego it starts"
#: [[parameters]]
#: name = "OPT_LEADER_Y"
#: low = 40.0
#: high = 55.0
#: unit = "m"
#: meaning = "how far ahead of the ego the slow vehicle starts"
#: [[parameters]]
#: name = "OPT_LEADER_SPEED"
#: low = 1.5
#: high = 3.8
#: unit = "m/s"
#: meaning = "how fast the slow vehicle drives"

param OPT_GEO_Y = Range(5.5, 9)
param OPT_LEADER_Y = Range(40, 55)
param OPT_LEADER_SPEED = Range(1.5, 3.8)

advTrajectory = adjacentLane
advLane = advTrajectory
LeadingAgent = new Car at pointOn(ownLane(egoRoute), globalParameters.OPT_LEADER_Y),
    facing directionOn(ownLane(egoRoute), globalParameters.OPT_LEADER_Y),
    with behavior DrivePath(ownLane(egoRoute), globalParameters.OPT_LEADER_SPEED),
    with label "leader"
AdvAgent = new AdvClass at pointOn(advTrajectory, globalParameters.OPT_GEO_Y),
    facing directionOn(advTrajectory, globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
