#: description = "The adversary comes toward the ego in the oncoming lane while a slow car leads the ego."
#: rephrasings = [
#:   "A slow vehicle is in front of the ego, and another one approaches on the opposite side.",
#:   "we're crawling behind someone and here comes another one the other way",
#:   "opposing veh, slow lead veh in ego lane",
#:   "Vehicle 2 was approaching in the opposing lane while Vehicle 1 followed a slower Vehicle 3.",
#:   "The target approaches in the opposing lane; the VUT follows a slow vehicle.",
#:   "Before the ego a slow auto and from the opposite lane comes the adversary.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle", "emergency-vehicle"]
#: requires = ["AdvBehavior", "egoRoute", "oppositeLane"]
#: provides = ["AdvAgent", "LeadingAgent", "advTrajectory", "leaderWay"]
#: origin = "own code"
#: [slots]
#: position = "oncoming"
#: leader = true
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 32.0
#: high = 46.0
#: unit = "m"
#: meaning = "how far ahead of the ego it starts"
#: [[parameters]]
#: name = "OPT_LEADER_Y"
#: low = 64.0
#: high = 76.0
#: unit = "m"
#: meaning = "how far ahead of the ego the slow vehicle starts"
#: [[parameters]]
#: name = "OPT_LEADER_SPEED"
#: low = 1.5
#: high = 3.8
#: unit = "m/s"
#: meaning = "how fast the slow vehicle drives"

param OPT_GEO_Y = Range(32, 46)
param OPT_LEADER_Y = Range(64, 76)
param OPT_LEADER_SPEED = Range(1.5, 3.8)

leaderWay = ownWay(egoRoute)
LeadingAgent = new Car at pointOn(leaderWay, globalParameters.OPT_LEADER_Y),
    facing directionOn(leaderWay, globalParameters.OPT_LEADER_Y),
    with behavior DrivePath(leaderWay, globalParameters.OPT_LEADER_SPEED),
    with label "leader"
advTrajectory = oppositeLane
AdvAgent = new AdvClass at pointOn(advTrajectory, levelOn(advTrajectory, egoRoute, globalParameters.OPT_GEO_Y)),
    facing directionOn(advTrajectory, levelOn(advTrajectory, egoRoute, globalParameters.OPT_GEO_Y)),
    with behavior AdvBehavior()
