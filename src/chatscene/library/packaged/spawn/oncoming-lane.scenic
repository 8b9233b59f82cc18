#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle", "emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: position = "oncoming"
#: [variants]
#: oncoming-lane        = { y = [60, 95], origin = "base scenario vehicle-passing; own code" }
#: oncoming-lane-close  = { y = [24, 44] }
#: oncoming-lane-leader = { y = [32, 46], leader = true, leader_y = [64, 76], leader_speed = [1.5, 3.8] }
#: oncoming-in-curve    = { y = [26, 40], place = "curve" }
#: [descriptions]
#: oncoming-lane        = "The adversary comes toward the ego in the oncoming lane."
#: oncoming-lane-close  = "The adversary comes toward the ego in the oncoming lane from some thirty metres ahead."
#: oncoming-lane-leader = "The adversary comes toward the ego in the oncoming lane while a slow car leads the ego."
#: oncoming-in-curve    = "The adversary comes toward the ego in the oncoming lane of the bend."

param OPT_GEO_Y = Range$y  #: [m] how far ahead of the ego it starts
param OPT_LEADER_Y = Range$leader_y  #: if leader  #: [m] how far ahead of the ego the slow vehicle starts
param OPT_LEADER_SPEED = Range$leader_speed  #: if leader  #: [m/s] how fast the slow vehicle drives

leaderWay = ownWay(egoRoute)  #: if leader
LeadingAgent = new Car at pointOn(leaderWay, globalParameters.OPT_LEADER_Y),  #: if leader
    facing directionOn(leaderWay, globalParameters.OPT_LEADER_Y),  #: if leader
    with behavior DrivePath(leaderWay, globalParameters.OPT_LEADER_SPEED),  #: if leader
    with label "leader"  #: if leader
advTrajectory = oppositeLane
AdvAgent = new AdvClass at pointOn(advTrajectory, levelOn(advTrajectory, egoRoute, globalParameters.OPT_GEO_Y)),
    facing directionOn(advTrajectory, levelOn(advTrajectory, egoRoute, globalParameters.OPT_GEO_Y)),
    with behavior AdvBehavior()
