#: description = "The car tears through the intersection at high speed."
#: adversaries = ["car", "motorcycle", "emergency-vehicle"]
#: origin = "NHTSA pre-crash typology: straight crossing paths; own code"
#: [slots]
#: actions = ["fast"]

param OPT_ADV_DISTANCE = Range(25, 60)  #: [m] how far the ego still is from where their ways meet when it sets off
param OPT_ADV_SPEED = Range(12, 16)  #: [m/s] how fast it drives

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(advTrajectory, 1, 0, globalParameters.OPT_ADV_SPEED)
