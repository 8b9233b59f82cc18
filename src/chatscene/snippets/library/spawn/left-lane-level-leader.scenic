#: description = "The adversary is level with the ego in the lane to the left of the ego, and a slow car leads the ego."
#: rephrasings = [
#:   "The car starts side by side with the ego in the lane to the left of the ego, and a slow car leads the ego.",
#:   "In the target lane on the left, abreast of the ego, and a slow car leads the ego.",
#:   "Door to door with the ego, one lane over on the left, and a slow car leads the ego.",
#:   "The other vehicle is parallel to the ego on the left, and a slow car leads the ego.",
#:   "Right next to it on the left, in the adjoining lane, and a slow car leads the ego.",
#:   "slow lead veh, other veh abreast in the lane on the left",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["AdvBehavior", "egoRoute", "leftLane"]
#: provides = ["AdvAgent", "LeadingAgent", "advLane", "advTrajectory", "leaderWay"]
#: origin = "base scenario lane-changing; own code"
#: [slots]
#: position = "beside"
#: side = "left"
#: leader = true
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = -3.0
#: high = 4.5
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

param OPT_GEO_Y = Range(-3, 4.5)
param OPT_LEADER_Y = Range(32, 44)
param OPT_LEADER_SPEED = Range(1.5, 3.4)

advTrajectory = extended(leftLane, 20)
advLane = advTrajectory
leaderWay = ownWay(egoRoute)
LeadingAgent = new Car at pointOn(leaderWay, globalParameters.OPT_LEADER_Y),
    facing directionOn(leaderWay, globalParameters.OPT_LEADER_Y),
    with behavior DrivePath(leaderWay, globalParameters.OPT_LEADER_SPEED),
    with label "leader"
AdvAgent = new AdvClass at pointOn(advTrajectory, 20 + globalParameters.OPT_GEO_Y),
    facing directionOn(advTrajectory, 20 + globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
