#: description = "The pedestrian runs across, stumbles and falls in the ego's lane."
#: adversaries = ["pedestrian"]
#: origin = "own code"
#: [slots]
#: actions = ["cross", "brake", "stop"]

param OPT_ADV_SPEED = Range(2.8, 4)  #: [m/s] how fast it runs
param OPT_ADV_DISTANCE = Range(12, 30)  #: [m] how far the ego still has to go when the adversary reaches its line
param OPT_ADV_REACH = Range(1.6, 2.3)  #: [m] how far from the ego's line it trips
param OPT_ADV_ANGLE = Range(1.1, 1.4)  #: [rad] how far it reels aside

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 7 * abs(offsetFrom(egoRoute, self)) / globalParameters.OPT_ADV_SPEED
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < globalParameters.OPT_ADV_REACH
    # It reels along the ego's direction, from whichever side it comes.
    do MoveAhead(globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_ANGLE if offsetFrom(egoRoute, self) > 0 else -globalParameters.OPT_ADV_ANGLE) for 0.5 seconds
    do Halt()
