#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: origin = "base scenario lane-changing; own code"
#: [slots]
#: position = "ahead-beside"
#: [variants]
#: adjacent-lane-ahead        = { y = [6, 22], lane = "adjacentLane" }
#: adjacent-lane-ahead-leader = { y = [5.5, 9], lane = "adjacentLane", leader = true, leader_y = [32, 44], leader_speed = [1.5, 3.4] }
#: left-lane-ahead            = { y = [6, 22], lane = "leftLane", side = "left" }
#: left-lane-ahead-blocker    = { y = [5.5, 14], lane = "leftLane", side = "left", maneuver = "bypass", blocker = true, blocker_y = [-3, 3], origin = "own code" }
#: left-lane-ahead-far        = { y = [36, 50], lane = "leftLane", side = "left", maneuver = "straight", place = "road", distance = "far", origin = "own code" }
#: left-lane-ahead-leader     = { y = [5.5, 9], lane = "leftLane", leader = true, leader_y = [32, 44], leader_speed = [1.5, 3.4], side = "left" }
#: left-lane-ahead-near       = { y = [4.6, 8], lane = "leftLane", side = "left", distance = "near", adversaries = ["car", "motorcycle", "emergency-vehicle"], origin = "own code" }
#: right-lane-ahead           = { y = [6, 22], lane = "rightLane", side = "right" }
#: right-lane-ahead-far       = { y = [36, 50], lane = "rightLane", side = "right", maneuver = "straight", place = "road", distance = "far", origin = "own code" }
#: right-lane-ahead-leader    = { y = [5.5, 9], lane = "rightLane", leader = true, leader_y = [32, 44], leader_speed = [1.5, 3.4], side = "right" }
#: right-lane-ahead-near      = { y = [4.6, 8], lane = "rightLane", side = "right", distance = "near", adversaries = ["car", "motorcycle", "emergency-vehicle"], origin = "own code" }
#: [descriptions]
#: adjacent-lane-ahead        = "The adversary is ahead of the ego in the neighbouring lane."
#: adjacent-lane-ahead-leader = "The adversary is ahead of the ego in the neighbouring lane, and a slow car leads the ego."
#: left-lane-ahead            = "The adversary is ahead of the ego in the lane to the left of the ego."
#: left-lane-ahead-blocker    = "A parked car blocks the ego's lane and the adversary is ahead of the ego in the lane to its left."
#: left-lane-ahead-far        = "The adversary is far ahead of the ego in the lane to its left."
#: left-lane-ahead-leader     = "The adversary is ahead of the ego in the lane to the left of the ego, and a slow car leads the ego."
#: left-lane-ahead-near       = "The adversary is just ahead of the ego in the lane to its left, hardly a car's length away."
#: right-lane-ahead           = "The adversary is ahead of the ego in the lane to the right of the ego."
#: right-lane-ahead-far       = "The adversary is far ahead of the ego in the lane to its right."
#: right-lane-ahead-leader    = "The adversary is ahead of the ego in the lane to the right of the ego, and a slow car leads the ego."
#: right-lane-ahead-near      = "The adversary is just ahead of the ego in the lane to its right, hardly a car's length away."

param OPT_BLOCKER_Y = Range$blocker_y  #: if blocker  #: [m] how far along the middle of the bypass the parked vehicle stands
param OPT_GEO_Y = Range$y  #: [m] how far ahead of the ego it starts
param OPT_LEADER_Y = Range$leader_y  #: if leader  #: [m] how far ahead of the ego the slow vehicle starts
param OPT_LEADER_SPEED = Range$leader_speed  #: if leader  #: [m/s] how fast the slow vehicle drives

new Car at pointOn(blockedLane, egoRoute.eventAt + globalParameters.OPT_BLOCKER_Y),  #: if blocker
    facing directionOn(blockedLane, egoRoute.eventAt + globalParameters.OPT_BLOCKER_Y),  #: if blocker
    with label "blocker"  #: if blocker
advTrajectory = $lane
advLane = advTrajectory
leaderWay = ownWay(egoRoute)  #: if leader
LeadingAgent = new Car at pointOn(leaderWay, globalParameters.OPT_LEADER_Y),  #: if leader
    facing directionOn(leaderWay, globalParameters.OPT_LEADER_Y),  #: if leader
    with behavior DrivePath(leaderWay, globalParameters.OPT_LEADER_SPEED),  #: if leader
    with label "leader"  #: if leader
AdvAgent = new AdvClass at pointOn(advTrajectory, globalParameters.OPT_GEO_Y),
    facing directionOn(advTrajectory, globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
