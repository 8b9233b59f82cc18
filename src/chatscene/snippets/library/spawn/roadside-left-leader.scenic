#: description = "The adversary stands at the left side of the road while a slow car leads the ego."
#: rephrasings = [
#:   "On the left pavement; the ego follows slow traffic.",
#:   "we're behind a slow car and there's somebody on the left",
#:   "ped left road edge, slow lead veh in ego lane",
#:   "The non-motorist was at the left edge of the roadway; Vehicle 1 was following a slower Vehicle 3.",
#:   "The target is on the offside pavement while a slow vehicle precedes the VUT.",
#:   "On left side stays somebody, before the ego goes a slow auto.",
#: ]
#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: requires = ["AdvBehavior", "egoRoute"]
#: provides = ["AdvAgent", "LeadingAgent", "leaderWay"]
#: origin = "own code"
#: [slots]
#: side = "left"
#: position = "roadside"
#: leader = true
#: place = "road"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 28.0
#: high = 40.0
#: unit = "m"
#: meaning = "how far along the ego's route it starts"
#: [[parameters]]
#: name = "OPT_GEO_X"
#: low = 0.6
#: high = 3.0
#: unit = "m"
#: meaning = "how far outside the lanes it starts"
#: [[parameters]]
#: name = "OPT_LEADER_Y"
#: low = 50.0
#: high = 62.0
#: unit = "m"
#: meaning = "how far ahead of the ego the slow vehicle starts"
#: [[parameters]]
#: name = "OPT_LEADER_SPEED"
#: low = 1.5
#: high = 3.8
#: unit = "m/s"
#: meaning = "how fast the slow vehicle drives"

param OPT_GEO_Y = Range(28, 40)
param OPT_GEO_X = Range(0.6, 3)
param OPT_LEADER_Y = Range(50, 62)
param OPT_LEADER_SPEED = Range(1.5, 3.8)

leaderWay = ownWay(egoRoute)
LeadingAgent = new Car at pointOn(leaderWay, globalParameters.OPT_LEADER_Y),
    facing directionOn(leaderWay, globalParameters.OPT_LEADER_Y),
    with behavior DrivePath(leaderWay, globalParameters.OPT_LEADER_SPEED),
    with label "leader"
AdvAgent = new AdvClass at besideRoad(egoRoute, globalParameters.OPT_GEO_Y, "left", globalParameters.OPT_GEO_X),
    facing crossingDirection(egoRoute, globalParameters.OPT_GEO_Y, "left"),
    with behavior AdvBehavior()
