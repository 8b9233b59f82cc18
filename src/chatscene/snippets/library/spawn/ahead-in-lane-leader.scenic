#: description = "The adversary drives between the ego and a slow car that leads both."
#: rephrasings = [
#:   "A slow car is in front of the vehicle in front of the ego.",
#:   "the one ahead of us is itself stuck behind some slowpoke",
#:   "lead veh + slow veh ahead of it, same lane",
#:   "Vehicle 2 was between Vehicle 1 and a slower Vehicle 3 in the same lane.",
#:   "The target follows a slow leading vehicle and precedes the VUT.",
#:   "Before the ego goes the adversary, and before that again a slow auto.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle", "emergency-vehicle"]
#: requires = ["AdvBehavior", "egoRoute"]
#: provides = ["AdvAgent", "LeadingAgent", "advTrajectory", "leaderWay"]
#: origin = "own code"
#: [slots]
#: position = "ahead"
#: leader = true
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 9.0
#: high = 15.0
#: unit = "m"
#: meaning = "how far ahead of the ego it starts"
#: [[parameters]]
#: name = "OPT_LEADER_Y"
#: low = 56.0
#: high = 68.0
#: unit = "m"
#: meaning = "how far ahead of the ego the slow vehicle starts"
#: [[parameters]]
#: name = "OPT_LEADER_SPEED"
#: low = 5.5
#: high = 6.8
#: unit = "m/s"
#: meaning = "how fast the slow vehicle drives"

param OPT_GEO_Y = Range(9, 15)
param OPT_LEADER_Y = Range(56, 68)
param OPT_LEADER_SPEED = Range(5.5, 6.8)

leaderWay = ownWay(egoRoute)
LeadingAgent = new Car at pointOn(leaderWay, globalParameters.OPT_LEADER_Y),
    facing directionOn(leaderWay, globalParameters.OPT_LEADER_Y),
    with behavior DrivePath(leaderWay, globalParameters.OPT_LEADER_SPEED),
    with label "leader"
advTrajectory = egoRoute
AdvAgent = new AdvClass at pointOn(advTrajectory, globalParameters.OPT_GEO_Y),
    facing directionOn(advTrajectory, globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
