#: description = "The pedestrian starts to cross, hesitates in the lane, and goes on."
#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: actions = ["cross", "hesitate"]

param OPT_ADV_SPEED = Range(1.2, 4)  #: [m/s] how fast it goes
param OPT_ADV_DISTANCE = Range(26, 58)  #: [m] how far the ego still has to go when it starts to move
param OPT_STOP_DISTANCE = Range(0.2, 2)  #: [m] how far from the ego's line it pauses
param OPT_STOP_TIME = Range(0.5, 2)  #: [s] how long it pauses

behavior AdvBehavior():
    # Earlier where it has farther to go, and briskly where the ego would be gone otherwise.
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 8 * max(0, abs(offsetFrom(egoRoute, self)) - 3) / globalParameters.OPT_ADV_SPEED
    do MoveAhead(5) until abs(offsetFrom(egoRoute, self)) < max(2.5, globalParameters.OPT_ADV_SPEED * (headway(egoRoute, ego, self) / 8 - globalParameters.OPT_STOP_TIME - 1))
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until restsWithin(egoRoute, self, globalParameters.OPT_STOP_DISTANCE)
    do Halt() until self.pose[3] < 0.1
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    do MoveAhead(globalParameters.OPT_ADV_SPEED)
