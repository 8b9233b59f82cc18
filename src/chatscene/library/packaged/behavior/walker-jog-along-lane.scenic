#: description = "The pedestrian jogs off the pavement and runs on along the lane ahead of the ego."
#: adversaries = ["pedestrian"]
#: origin = "own code"
#: [slots]
#: actions = ["fast", "follow"]
#: place = "road"
#: leader = false

param OPT_ADV_SPEED = Range(3.4, 5)  #: [m/s] how fast it runs
param OPT_ADV_DISTANCE = Range(6, 26)  #: [m] how far the ego still has to go when it starts to move
param OPT_ADV_REACH = Range(1, 2.4)  #: [m] how far from the ego's line it turns along the lane

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 3 * abs(offsetFrom(egoRoute, self))
    do MoveAhead(2.5) until abs(offsetFrom(egoRoute, self)) < globalParameters.OPT_ADV_REACH
    # A quarter turn into the ego's direction, from whichever side it comes.
    do MoveAhead(globalParameters.OPT_ADV_SPEED, 1.57 if offsetFrom(egoRoute, self) > 0 else -1.57)
