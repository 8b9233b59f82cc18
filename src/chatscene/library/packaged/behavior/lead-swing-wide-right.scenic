#: description = "The truck ahead swings wide to the left and then turns right off the road."
#: adversaries = ["truck", "bus"]
#: origin = "own code"
#: [slots]
#: actions = ["swerve", "turn-right"]
#: position = "ahead"
#: place = "road"

param OPT_ADV_DISTANCE = Range(8, 30)  #: [m] how far before the start of its manoeuvre the ego is when the adversary acts
param OPT_BRAKE = Range(0.4, 0.9)  #: [1] how hard it brakes
param OPT_ADV_SPEED = Range(2, 3.5)  #: [m/s] how fast it turns
param OPT_SWERVE = Range(1.2, 2.2)  #: [m] how far out to the left it swings

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) until self.pose[3] < 1.5
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_SWERVE) until offsetFrom(advTrajectory, self) > 0.8 * globalParameters.OPT_SWERVE
    do TurnOff(-1.4, globalParameters.OPT_ADV_SPEED, 7)
    do MoveAhead(globalParameters.OPT_ADV_SPEED) for 5 seconds
    do Halt()
