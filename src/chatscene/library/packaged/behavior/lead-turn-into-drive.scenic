#: description = "The car ahead brakes without signalling and turns right off the road into a driveway."
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: origin = "NHTSA pre-crash typology: lead vehicle turning; own code"
#: [slots]
#: actions = ["brake", "turn-right"]
#: position = "ahead"
#: place = "road"

param OPT_ADV_DISTANCE = Range(0, 30)  #: [m] how far before the start of its manoeuvre the ego is when the adversary acts
param OPT_BRAKE = Range(0.6, 1)  #: [1] how hard it brakes
param OPT_ADV_SPEED = Range(1.5, 3)  #: [m/s] how fast it turns off

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) until self.pose[3] < 0.5
    do TurnOff(-1.4, globalParameters.OPT_ADV_SPEED)
    do MoveAhead(globalParameters.OPT_ADV_SPEED) for 4 seconds
    do Halt()
