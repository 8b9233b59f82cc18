#: description = "The car goes through the intersection in bursts of throttle and brake."
#: adversaries = ["car", "motorcycle"]
#: origin = "base scenarios crossing-negotiation, red-light-running, unprotected-left-turn; own code"
#: [slots]
#: actions = ["accelerate", "brake"]

param OPT_ADV_DISTANCE = Range(12, 48)  #: [m] how far the ego still is from where their ways meet when it sets off
param OPT_THROTTLE = Range(0.6, 1)  #: [1] how far the pedal is pressed
param OPT_BRAKE = Range(0.4, 1)  #: [1] how hard it brakes
param OPT_ADV_PERIOD = Range(1, 2)  #: [s] how long each phase lasts

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    while True:
        do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE) for globalParameters.OPT_ADV_PERIOD seconds
        do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) for 0.5 * globalParameters.OPT_ADV_PERIOD seconds
