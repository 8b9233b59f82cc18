#: description = "The car ahead stops in the lane, waits and then turns left off the road."
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: actions = ["stop", "hesitate", "turn-left"]
#: position = "ahead"
#: place = "road"

param OPT_ADV_DISTANCE = Range(5, 28)  #: [m] how far before the start of its manoeuvre the ego is when the adversary acts
param OPT_ADV_AHEAD = Range(26, 36)  #: [m] how far ahead of the ego it drives before it acts, and farther the longer it will stand
param OPT_BRAKE = Range(0.35, 0.7)  #: [1] how hard it brakes
param OPT_STOP_TIME = Range(0.6, 2.5)  #: [s] how long it stands

behavior AdvBehavior():
    do PaceOnPath(advTrajectory, ego, globalParameters.OPT_ADV_AHEAD + 6 * globalParameters.OPT_STOP_TIME, 16, 5) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE and headway(egoRoute, ego, self) > 0.85 * (globalParameters.OPT_ADV_AHEAD + 6 * globalParameters.OPT_STOP_TIME)
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) until self.pose[3] < 0.05
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    do TurnOff(1.4, 3)
    do MoveAhead(3) for 4 seconds
    do Halt()
