#: description = "The pedestrian stands in the lane until the ego is close, then runs back to the side it came from."
#: adversaries = ["pedestrian"]
#: origin = "own code"
#: [slots]
#: actions = ["cross", "block", "turn-back", "accelerate"]

param OPT_ADV_SPEED = Range(2.6, 4)  #: [m/s] how fast it walks out
param OPT_ADV_DISTANCE = Range(28, 44)  #: [m] how far the ego still has to go when the adversary reaches its line
param OPT_STOP_DISTANCE = Range(0, 1.2)  #: [m] how far from the ego's line it comes to rest
param OPT_REACT_DISTANCE = Range(7, 11)  #: [m] how near the ego is when it flees
param OPT_ADV_SPRINT = Range(3.5, 6.5)  #: [m/s] how fast it runs back

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 7 * abs(offsetFrom(egoRoute, self)) / globalParameters.OPT_ADV_SPEED
    # Briskly as far as the ego's own lane, should there be others before it.
    do MoveAhead(6) until abs(offsetFrom(egoRoute, self)) < 3.8
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until restsWithin(egoRoute, self, globalParameters.OPT_STOP_DISTANCE)
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_REACT_DISTANCE
    do MoveAhead(globalParameters.OPT_ADV_SPRINT, 3.14159) until abs(offsetFrom(egoRoute, self)) > 5
    do Halt()
