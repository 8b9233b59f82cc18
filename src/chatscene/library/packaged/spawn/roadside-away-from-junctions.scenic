#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: origin = "own code"
#: [slots]
#: position = "roadside"
#: place = "road"
#: [variants]
#: roadside-left-far     = { side = "left", distance = "far", y = [42, 62], x = [0.6, 3] }
#: roadside-right-far    = { side = "right", distance = "far", y = [42, 62], x = [0.6, 3] }
#: roadside-left-leader  = { side = "left", y = [28, 40], x = [0.6, 3], leader = true, leader_y = [50, 62], leader_speed = [1.5, 3.8] }
#: roadside-right-leader = { side = "right", y = [18, 30], x = [0.6, 3], leader = true, leader_y = [40, 55], leader_speed = [1.5, 3.8] }
#: [descriptions]
#: roadside-left-far     = "The adversary stands at the left side of the road, far ahead of the ego."
#: roadside-right-far    = "The adversary stands at the right side of the road, far ahead of the ego."
#: roadside-left-leader  = "The adversary stands at the left side of the road while a slow car leads the ego."
#: roadside-right-leader = "The adversary stands at the right side of the road while a slow car leads the ego."

param OPT_GEO_Y = Range$y  #: [m] how far along the ego's route it starts
param OPT_GEO_X = Range$x  #: [m] how far outside the lanes it starts
param OPT_LEADER_Y = Range$leader_y  #: if leader  #: [m] how far ahead of the ego the slow vehicle starts
param OPT_LEADER_SPEED = Range$leader_speed  #: if leader  #: [m/s] how fast the slow vehicle drives

leaderWay = ownWay(egoRoute)  #: if leader
LeadingAgent = new Car at pointOn(leaderWay, globalParameters.OPT_LEADER_Y),  #: if leader
    facing directionOn(leaderWay, globalParameters.OPT_LEADER_Y),  #: if leader
    with behavior DrivePath(leaderWay, globalParameters.OPT_LEADER_SPEED),  #: if leader
    with label "leader"  #: if leader
AdvAgent = new AdvClass at besideRoad(egoRoute, globalParameters.OPT_GEO_Y, "$side", globalParameters.OPT_GEO_X),
    facing crossingDirection(egoRoute, globalParameters.OPT_GEO_Y, "$side"),
    with behavior AdvBehavior()
