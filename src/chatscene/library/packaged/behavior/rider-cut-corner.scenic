#: description = "The rider turns left and cuts the corner, riding over the wrong side of the road it leaves."
#: adversaries = ["bicycle", "motorcycle"]
#: origin = "own code"
#: [slots]
#: actions = ["turn-left", "follow"]
#: maneuver = "straight"

param OPT_ADV_DISTANCE = Range(-2, 24)  #: [m] how far the ego still is from where their ways meet when it sets off
param OPT_ADV_SPEED = Range(4, 7.5)  #: [m/s] how fast it rides
param OPT_SWERVE = Range(1, 2.2)  #: [m] how far it cuts to the inside

advTurn = "left-turn"

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, acrossMeeting) < globalParameters.OPT_ADV_DISTANCE + 7.5 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_SWERVE)
