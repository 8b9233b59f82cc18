#: description = "The car accelerates out of the side street, turning right into the ego's lane."
#: adversaries = ["car", "motorcycle", "emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: actions = ["accelerate", "turn-right"]
#: side = "right"
#: position = "crossing"
#: maneuver = "straight"

param OPT_ADV_DISTANCE = Range(12, 40)  #: [m] how far the ego still is from where their ways meet when it accelerates
param OPT_THROTTLE = Range(0.4, 0.8)  #: [1] how far the pedal is pressed

advTurn = ("straight", "right-turn")

behavior AdvBehavior():
    do DrivePath(advTrajectory, 9) until distanceLeft(advTrajectory, self, advTrajectory.entry) < 3.5 + brakingDistance(self)
    do BrakeOnPath(advTrajectory) until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE, 0, 7) until abs(offsetFrom(egoRoute, self)) < 6
    do ThrottleOnPath(egoRoute, globalParameters.OPT_THROTTLE, 0, 9)
