#: description = "The truck ahead swings wide to the left and then turns right off the road."
#: adversaries = ["truck", "bus"]
#: origin = "own code"
#: [slots]
#: actions = ["swerve", "turn-right"]
#: position = "ahead"
#: place = "road"

param OPT_ADV_DISTANCE = Range(25, 50)  #: [m] how far before the start of its manoeuvre the ego is when the adversary acts
param OPT_ADV_AHEAD = Range(20, 28)  #: [m] how far ahead of the ego it drives before it acts
param OPT_BRAKE = Range(0.6, 0.9)  #: [1] how hard it brakes
param OPT_ADV_SPEED = Range(3, 4.5)  #: [m/s] how fast it turns
param OPT_SWERVE = Range(1.2, 2.2)  #: [m] how far out to the left it swings

behavior AdvBehavior():
    do PaceOnPath(advTrajectory, ego, globalParameters.OPT_ADV_AHEAD, 16, 5) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE and headway(egoRoute, ego, self) > 0.85 * globalParameters.OPT_ADV_AHEAD
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) until self.pose[3] < 2.5
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_SWERVE) until offsetFrom(advTrajectory, self) > 0.8 * globalParameters.OPT_SWERVE
    do TurnOff(-1.4, globalParameters.OPT_ADV_SPEED, 7)
    do MoveAhead(globalParameters.OPT_ADV_SPEED) for 5 seconds
    do Halt()
