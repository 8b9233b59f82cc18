#: description = "The pedestrian steps into the lane and walks along it in front of the ego, turning its back to it."
#: adversaries = ["pedestrian"]
#: origin = "Euro NCAP CPLA; own code"
#: [slots]
#: actions = ["slow", "follow"]
#: place = "road"

param OPT_ADV_SPEED = Range(0.8, 1.4)  #: [m/s] how fast it goes
param OPT_ADV_DISTANCE = Range(8, 32)  #: [m] how far the ego still has to go when it starts to move
param OPT_ADV_REACH = Range(0.2, 1.9)  #: [m] how far from the ego's line it walks

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 3 * abs(offsetFrom(egoRoute, self))
    # Briskly as far as the ego's own lane, should there be others before it.
    do MoveAhead(4.5) until abs(offsetFrom(egoRoute, self)) < 3.5
    do MoveAhead(1.4) until abs(offsetFrom(egoRoute, self)) < globalParameters.OPT_ADV_REACH
    # A quarter turn into the ego's direction, from whichever side it comes.
    do MoveAhead(globalParameters.OPT_ADV_SPEED, 1.57 if offsetFrom(egoRoute, self) > 0 else -1.57)
