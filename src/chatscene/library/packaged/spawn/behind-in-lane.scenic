#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: position = "behind"
#: [variants]
#: behind-in-lane        = { y = [8, 18], back = 20, adversaries = ["car", "truck", "bus", "motorcycle", "bicycle", "emergency-vehicle"] }
#: behind-in-lane-far    = { y = [35.2, 39], back = 40, place = "road", distance = "far" }
#: behind-in-lane-leader = { y = [9, 16], back = 20, leader = true, leader_y = [48, 60], leader_speed = [5, 6.5] }
#: behind-in-lane-near   = { y = [6.8, 8.5], back = 10, distance = "near", adversaries = ["car", "truck", "motorcycle", "bicycle", "emergency-vehicle"] }
#: [descriptions]
#: behind-in-lane        = "The adversary drives behind the ego in the same lane."
#: behind-in-lane-far    = "The adversary is far behind the ego in the same lane."
#: behind-in-lane-leader = "The adversary drives behind the ego, which follows a slow car."
#: behind-in-lane-near   = "The adversary is close behind the ego in the same lane."

param OPT_GEO_Y = Range$y  #: [m] how far behind the ego it starts
param OPT_LEADER_Y = Range$leader_y  #: if leader  #: [m] how far ahead of the ego the slow vehicle starts
param OPT_LEADER_SPEED = Range$leader_speed  #: if leader  #: [m/s] how fast the slow vehicle drives

leaderWay = ownWay(egoRoute)  #: if leader
LeadingAgent = new Car at pointOn(leaderWay, globalParameters.OPT_LEADER_Y),  #: if leader
    facing directionOn(leaderWay, globalParameters.OPT_LEADER_Y),  #: if leader
    with behavior DrivePath(leaderWay, globalParameters.OPT_LEADER_SPEED),  #: if leader
    with label "leader"  #: if leader
advTrajectory = extended(egoRoute, $back)
AdvAgent = new AdvClass at pointOn(advTrajectory, $back - globalParameters.OPT_GEO_Y),
    facing directionOn(advTrajectory, $back - globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
