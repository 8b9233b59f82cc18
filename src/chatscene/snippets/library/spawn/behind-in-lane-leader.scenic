#: description = "The adversary drives behind the ego, which follows a slow car."
#: rephrasings = [
#:   "The ego is sandwiched: a slow car in front, another vehicle behind.",
#:   "we're stuck behind a slow car with somebody on our tail",
#:   "following veh behind ego, slow lead veh ahead",
#:   "Vehicle 2 was behind Vehicle 1, which was following a slower Vehicle 3.",
#:   "The target travels behind the VUT while a slow vehicle precedes it.",
#:   "Before the ego a slow auto, behind it the adversary.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["AdvBehavior", "egoRoute"]
#: provides = ["AdvAgent", "LeadingAgent", "advTrajectory", "leaderWay"]
#: origin = "own code"
#: [slots]
#: position = "behind"
#: leader = true
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 9.0
#: high = 16.0
#: unit = "m"
#: meaning = "how far behind the ego it starts"
#: [[parameters]]
#: name = "OPT_LEADER_Y"
#: low = 48.0
#: high = 60.0
#: unit = "m"
#: meaning = "how far ahead of the ego the slow vehicle starts"
#: [[parameters]]
#: name = "OPT_LEADER_SPEED"
#: low = 5.0
#: high = 6.5
#: unit = "m/s"
#: meaning = "how fast the slow vehicle drives"

param OPT_GEO_Y = Range(9, 16)
param OPT_LEADER_Y = Range(48, 60)
param OPT_LEADER_SPEED = Range(5, 6.5)

leaderWay = ownWay(egoRoute)
LeadingAgent = new Car at pointOn(leaderWay, globalParameters.OPT_LEADER_Y),
    facing directionOn(leaderWay, globalParameters.OPT_LEADER_Y),
    with behavior DrivePath(leaderWay, globalParameters.OPT_LEADER_SPEED),
    with label "leader"
advTrajectory = extended(egoRoute, 20)
AdvAgent = new AdvClass at pointOn(advTrajectory, 20 - globalParameters.OPT_GEO_Y),
    facing directionOn(advTrajectory, 20 - globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
