#: description = "The rider comes into the ego's lane, makes a U-turn in it and rides back to the side it came from."
#: adversaries = ["bicycle", "motorcycle"]
#: origin = "own code"
#: [slots]
#: actions = ["cross", "u-turn", "turn-back"]

param OPT_ADV_SPEED = Range(2.2, 3.2)  #: [m/s] how fast it rides
param OPT_ADV_DISTANCE = Range(16, 30)  #: [m] how far the ego still has to go when the adversary reaches its line
param OPT_ADV_REACH = Range(1.8, 3)  #: [m] how far from the ego's line it begins to turn
param OPT_TURN_RADIUS = Range(1.6, 2.4)  #: [m] the radius of its turn

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 7 * abs(offsetFrom(egoRoute, self)) / globalParameters.OPT_ADV_SPEED
    # Briskly as far as the ego's own lane, should there be others before it.
    do MoveAhead(4) until abs(offsetFrom(egoRoute, self)) < globalParameters.OPT_ADV_REACH + 2
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < globalParameters.OPT_ADV_REACH
    # Round to the left or right, so that it first goes with the ego's direction.
    do TurnOff(3.1 if offsetFrom(egoRoute, self) > 0 else -3.1, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_TURN_RADIUS)
    do MoveAhead(globalParameters.OPT_ADV_SPEED)
