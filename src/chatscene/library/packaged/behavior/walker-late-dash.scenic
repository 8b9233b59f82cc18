#: description = "The pedestrian walks to the edge of the road, waits there as if to let the ego pass and then sprints across at the last moment."
#: adversaries = ["pedestrian"]
#: origin = "own code"
#: [slots]
#: actions = ["hesitate", "cross", "fast"]

param OPT_ADV_SPEED = Range(1.2, 2.2)  #: [m/s] how fast it walks to the edge
param OPT_ADV_REACH = Range(2.2, 2.8)  #: [m] how far from the ego's line it waits
param OPT_REACT_DISTANCE = Range(6, 15)  #: [m] how far the ego still has to go when it sprints off
param OPT_ADV_SPRINT = Range(4, 7)  #: [m/s] how fast it sprints

behavior AdvBehavior():
    # Briskly as far as the ego's own lane, should there be others before it.
    do MoveAhead(4.5) until abs(offsetFrom(egoRoute, self)) < 5.5
    do MoveAhead(globalParameters.OPT_ADV_SPEED) for 0.6 seconds
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until restsWithin(egoRoute, self, globalParameters.OPT_ADV_REACH) or headway(egoRoute, ego, self) < globalParameters.OPT_REACT_DISTANCE + 8
    do Halt() until self.pose[3] < 0.1
    do Halt() for 0.5 seconds
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_REACT_DISTANCE
    do MoveAhead(globalParameters.OPT_ADV_SPRINT)
