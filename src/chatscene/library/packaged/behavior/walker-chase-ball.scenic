#: description = "The pedestrian runs after a ball into the road and follows it along the lane."
#: adversaries = ["pedestrian"]
#: origin = "own code"
#: [slots]
#: actions = ["cross", "fast", "swerve"]

param OPT_ADV_SPEED = Range(3.4, 5.5)  #: [m/s] how fast it runs
param OPT_ADV_DISTANCE = Range(10, 20)  #: [m] how far the ego still has to go when the adversary reaches its line
param OPT_ADV_REACH = Range(0.3, 1.2)  #: [m] how far from the ego's line it turns along the road
param OPT_ADV_ANGLE = Range(1, 1.4)  #: [rad] how far it turns along the road

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 7 * abs(offsetFrom(egoRoute, self)) / globalParameters.OPT_ADV_SPEED
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < globalParameters.OPT_ADV_REACH
    # With the ego's direction, from whichever side it comes.
    do MoveAhead(globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_ANGLE if offsetFrom(egoRoute, self) > 0 else -globalParameters.OPT_ADV_ANGLE)
