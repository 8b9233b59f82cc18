#: description = "The pedestrian steps out, suddenly stops, and then walks on diagonally."
#: adversaries = ["pedestrian"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: actions = ["hesitate", "stop", "diagonal"]

param OPT_ADV_SPEED = Range(1.2, 4)  #: [m/s] how fast it goes
param OPT_ADV_DISTANCE = Range(32, 58)  #: [m] how far the ego still has to go when it starts to move
param OPT_ADV_ANGLE = Range(0.45, 1)  #: [rad] how far its slanted way turns from straight across
param OPT_STOP_DISTANCE = Range(1, 3)  #: [m] how far from the ego's line it stops
param OPT_STOP_TIME = Range(0.4, 1.1)  #: [s] how long it stands

behavior AdvBehavior():
    # Earlier where it has farther to go, and briskly where the ego would be gone otherwise.
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 8 * max(0, abs(offsetFrom(egoRoute, self)) - 3) / globalParameters.OPT_ADV_SPEED
    do MoveAhead(5) until abs(offsetFrom(egoRoute, self)) < max(2.5, globalParameters.OPT_ADV_SPEED * headway(egoRoute, ego, self) / 8)
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until restsWithin(egoRoute, self, globalParameters.OPT_STOP_DISTANCE)
    do Halt() until self.pose[3] < 0.1
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    # Slanted along the ego's direction, from whichever side it comes.
    do MoveAhead(globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_ANGLE if offsetFrom(egoRoute, self) > 0 else -globalParameters.OPT_ADV_ANGLE)
