#: description = "The pedestrian runs into the lane and charges along it straight at the ego."
#: adversaries = ["pedestrian"]
#: origin = "own code"
#: [slots]
#: actions = ["wrong-way", "fast"]
#: maneuver = "straight"
#: place = "road"

param OPT_ADV_SPEED = Range(3.5, 6)  #: [m/s] how fast it runs
param OPT_ADV_DISTANCE = Range(32, 50)  #: [m] how far the ego still has to go when it starts to move
param OPT_ADV_REACH = Range(1.5, 2.6)  #: [m] how far from the ego's line it turns into the lane

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 3 * abs(offsetFrom(egoRoute, self))
    do MoveAhead(4.5) until abs(offsetFrom(egoRoute, self)) < 5
    do MoveAhead(2.5) until abs(offsetFrom(egoRoute, self)) < globalParameters.OPT_ADV_REACH
    # A quarter turn against the ego's direction, from whichever side it comes.
    do MoveAhead(globalParameters.OPT_ADV_SPEED, -1.57 if offsetFrom(egoRoute, self) > 0 else 1.57)
