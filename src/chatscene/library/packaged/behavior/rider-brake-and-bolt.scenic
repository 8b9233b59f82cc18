#: description = "The rider rides out across the lane, brakes in it, puts a foot down and then tears off to the other side."
#: adversaries = ["bicycle", "motorcycle"]
#: origin = "own code"
#: [slots]
#: actions = ["cross", "brake", "hesitate", "accelerate"]

param OPT_ADV_SPEED = Range(2.8, 5)  #: [m/s] how fast it rides out
param OPT_ADV_DISTANCE = Range(22, 38)  #: [m] how far the ego still has to go when the adversary reaches its line
param OPT_STOP_DISTANCE = Range(0.2, 1.25)  #: [m] how far from the ego's line it stops
param OPT_STOP_TIME = Range(0.3, 0.9)  #: [s] how long it stands
param OPT_ADV_SPRINT = Range(5, 9)  #: [m/s] how fast it tears off

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 7 * abs(offsetFrom(egoRoute, self)) / globalParameters.OPT_ADV_SPEED + 2 * globalParameters.OPT_ADV_SPEED
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until restsWithin(egoRoute, self, globalParameters.OPT_STOP_DISTANCE)
    do Halt() until self.pose[3] < 0.1
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    do MoveAhead(globalParameters.OPT_ADV_SPRINT)
