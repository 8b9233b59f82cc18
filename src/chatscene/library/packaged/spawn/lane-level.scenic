#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: origin = "base scenario lane-changing; own code"
#: [slots]
#: position = "beside"
#: [variants]
#: adjacent-lane-level        = { y = [-3, 4.5], lane = "adjacentLane" }
#: adjacent-lane-level-leader = { y = [-3, 4.5], lane = "adjacentLane", leader = true, leader_y = [32, 44], leader_speed = [1.5, 3.4] }
#: left-lane-level            = { y = [-3, 4.5], lane = "leftLane", side = "left" }
#: left-lane-level-leader     = { y = [-3, 4.5], lane = "leftLane", leader = true, leader_y = [32, 44], leader_speed = [1.5, 3.4], side = "left" }
#: right-lane-level           = { y = [-3, 4.5], lane = "rightLane", side = "right" }
#: right-lane-level-leader    = { y = [-3, 4.5], lane = "rightLane", leader = true, leader_y = [32, 44], leader_speed = [1.5, 3.4], side = "right" }
#: [descriptions]
#: adjacent-lane-level        = "The adversary is level with the ego in the neighbouring lane."
#: adjacent-lane-level-leader = "The adversary is level with the ego in the neighbouring lane, and a slow car leads the ego."
#: left-lane-level            = "The adversary is level with the ego in the lane to the left of the ego."
#: left-lane-level-leader     = "The adversary is level with the ego in the lane to the left of the ego, and a slow car leads the ego."
#: right-lane-level           = "The adversary is level with the ego in the lane to the right of the ego."
#: right-lane-level-leader    = "The adversary is level with the ego in the lane to the right of the ego, and a slow car leads the ego."

param OPT_GEO_Y = Range$y  #: [m] how far ahead of the ego it starts
param OPT_LEADER_Y = Range$leader_y  #: if leader  #: [m] how far ahead of the ego the slow vehicle starts
param OPT_LEADER_SPEED = Range$leader_speed  #: if leader  #: [m/s] how fast the slow vehicle drives

advTrajectory = extended($lane, 20)
advLane = advTrajectory
leaderWay = ownWay(egoRoute)  #: if leader
LeadingAgent = new Car at pointOn(leaderWay, globalParameters.OPT_LEADER_Y),  #: if leader
    facing directionOn(leaderWay, globalParameters.OPT_LEADER_Y),  #: if leader
    with behavior DrivePath(leaderWay, globalParameters.OPT_LEADER_SPEED),  #: if leader
    with label "leader"  #: if leader
AdvAgent = new AdvClass at pointOn(advTrajectory, 20 + globalParameters.OPT_GEO_Y),
    facing directionOn(advTrajectory, 20 + globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
