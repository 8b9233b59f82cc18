#: description = "The rider ahead slows down almost to walking pace and turns off to the right."
#: adversaries = ["bicycle", "motorcycle"]
#: origin = "own code"
#: [slots]
#: actions = ["slow", "turn-right"]
#: position = "ahead"
#: place = "road"

param OPT_BRAKE = Range(0.6, 1)  #: [1] how hard it brakes
param OPT_ADV_DISTANCE = Range(0, 18)  #: [m] how far before the start of its manoeuvre the ego is when the adversary acts
param OPT_SLOW_SPEED = Range(0.7, 1.4)  #: [m/s] how fast it turns
param OPT_TURN_RADIUS = Range(3, 5)  #: [m] the radius of its turn

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego, 4) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) until self.pose[3] < globalParameters.OPT_SLOW_SPEED
    do TurnOff(-1.5, globalParameters.OPT_SLOW_SPEED, globalParameters.OPT_TURN_RADIUS)
    do MoveAhead(globalParameters.OPT_SLOW_SPEED)
