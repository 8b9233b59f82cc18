#: description = "The adversary is ahead of the ego in the lane to the left of the ego, and a slow car leads the ego."
#: rephrasings = [
#:   "The car starts further on in the lane to the left of the ego, and a slow car leads the ego.",
#:   "In the target lane on the left, some metres in front, and a slow car leads the ego.",
#:   "It drives before the ego, one lane over on the left, and a slow car leads the ego.",
#:   "The other vehicle is on the left front, in a parallel lane, and a slow car leads the ego.",
#:   "A few car lengths on, in the lane next to it on the left, and a slow car leads the ego.",
#:   "we're stuck behind a slow one, and somebody is a bit further on in the lane on the left",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["AdvBehavior", "egoRoute", "leftLane"]
#: provides = ["AdvAgent", "LeadingAgent", "advLane", "advTrajectory", "leaderWay"]
#: origin = "base scenario lane-changing; own code"
#: [slots]
#: position = "ahead-beside"
#: side = "left"
#: leader = true
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 5.5
#: high = 9.0
#: unit = "m"
#: meaning = "how far ahead of the ego it starts"
#: [[parameters]]
#: name = "OPT_LEADER_Y"
#: low = 32.0
#: high = 44.0
#: unit = "m"
#: meaning = "how far ahead of the ego the slow vehicle starts"
#: [[parameters]]
#: name = "OPT_LEADER_SPEED"
#: low = 1.5
#: high = 3.4
#: unit = "m/s"
#: meaning = "how fast the slow vehicle drives"

param OPT_GEO_Y = Range(5.5, 9)
param OPT_LEADER_Y = Range(32, 44)
param OPT_LEADER_SPEED = Range(1.5, 3.4)

advTrajectory = leftLane
advLane = advTrajectory
leaderWay = ownWay(egoRoute)
LeadingAgent = new Car at pointOn(leaderWay, globalParameters.OPT_LEADER_Y),
    facing directionOn(leaderWay, globalParameters.OPT_LEADER_Y),
    with behavior DrivePath(leaderWay, globalParameters.OPT_LEADER_SPEED),
    with label "leader"
AdvAgent = new AdvClass at pointOn(advTrajectory, globalParameters.OPT_GEO_Y),
    facing directionOn(advTrajectory, globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
