#: description = "The pedestrian dashes across the road at a run."
#: adversaries = ["pedestrian"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: actions = ["cross", "accelerate"]

param OPT_ADV_SPEED = Range(3.5, 7)  #: [m/s] how fast it runs
param OPT_ADV_DISTANCE = Range(6, 18)  #: [m] how far the ego still has to go when it starts to run

behavior AdvBehavior():
    # Earlier where it has farther to go, or on a wide road it would pass behind the ego.
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 8 * max(0, abs(offsetFrom(egoRoute, self)) - 3) / globalParameters.OPT_ADV_SPEED
    do MoveAhead(globalParameters.OPT_ADV_SPEED)
