#: description = "The car veers erratically through the intersection."
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: origin = "base scenarios crossing-negotiation, red-light-running, unprotected-left-turn; own code"
#: [slots]
#: actions = ["weave", "swerve"]

param OPT_ADV_DISTANCE = Range(20, 50)  #: [m] how far the ego still is from where their ways meet when it sets off
param OPT_ADV_SPEED = Range(5, 9)  #: [m/s] how fast it drives
param OPT_ADV_AMPLITUDE = Range(2, 2.6)  #: [m] how far it swings to either side
param OPT_ADV_PERIOD = Range(2, 3)  #: [s] how long a full swing takes

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do WeaveOnPath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_AMPLITUDE, globalParameters.OPT_ADV_PERIOD)
