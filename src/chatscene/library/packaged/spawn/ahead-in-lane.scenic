#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle", "emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: position = "ahead"
#: [variants]
#: ahead-in-lane        = { y = [9, 22], way = "egoRoute" }
#: ahead-in-lane-far    = { y = [38, 56], way = "egoRoute", maneuver = "straight", place = "road", distance = "far" }
#: ahead-in-lane-group  = { y = [12, 24], way = "egoRoute", group = true, adversaries = ["bicycle", "motorcycle"] }
#: ahead-in-lane-leader = { y = [9, 15], way = "egoRoute", leader = true, leader_y = [56, 68], leader_speed = [5.5, 6.8] }
#: ahead-in-lane-near   = { y = [7.5, 12], way = "egoRoute", distance = "near", adversaries = ["car", "truck", "motorcycle", "bicycle", "emergency-vehicle"] }
#: ahead-left-edge      = { y = [10, 24], way = "egoRoute.line.offset(1.2)", side = "left", adversaries = ["motorcycle", "bicycle"] }
#: ahead-right-edge     = { y = [12, 30], way = "egoRoute.line.offset(-1.2)", side = "right", adversaries = ["bicycle", "motorcycle"], origin = "Euro NCAP CBLA: a cyclist ahead, off centre" }
#: [descriptions]
#: ahead-in-lane        = "The adversary drives ahead of the ego in the same lane."
#: ahead-in-lane-far    = "The adversary is far ahead of the ego in the same lane."
#: ahead-in-lane-group  = "A pack rides ahead of the ego in its lane, the adversary first."
#: ahead-in-lane-leader = "The adversary drives between the ego and a slow car that leads both."
#: ahead-in-lane-near   = "The adversary is close ahead of the ego in the same lane."
#: ahead-left-edge      = "The adversary rides ahead of the ego at the left edge of the same lane."
#: ahead-right-edge     = "The adversary rides ahead of the ego at the right edge of the same lane."

param OPT_GEO_Y = Range$y  #: [m] how far ahead of the ego it starts
param OPT_LEADER_Y = Range$leader_y  #: if leader  #: [m] how far ahead of the ego the slow vehicle starts
param OPT_LEADER_SPEED = Range$leader_speed  #: if leader  #: [m/s] how fast the slow vehicle drives

leaderWay = ownWay(egoRoute)  #: if leader
LeadingAgent = new Car at pointOn(leaderWay, globalParameters.OPT_LEADER_Y),  #: if leader
    facing directionOn(leaderWay, globalParameters.OPT_LEADER_Y),  #: if leader
    with behavior DrivePath(leaderWay, globalParameters.OPT_LEADER_SPEED),  #: if leader
    with label "leader"  #: if leader
advTrajectory = $way
AdvAgent = new AdvClass at pointOn(advTrajectory, globalParameters.OPT_GEO_Y),
    facing directionOn(advTrajectory, globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
for back, left in ((3.2, 0.8), (4.2, -0.9)):  #: if group
    new AdvClass at pointOn(advTrajectory, globalParameters.OPT_GEO_Y - back, left),  #: if group
        facing directionOn(advTrajectory, globalParameters.OPT_GEO_Y - back),  #: if group
        with behavior AdvBehavior()  #: if group
